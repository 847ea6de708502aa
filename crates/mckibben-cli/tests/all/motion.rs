//! Motion as a user meets it.

use crate::common::{folder, json, mckibben, number, root, run_in};

#[test]
fn a_drive_file_becomes_series_of_one_length() {
    let found = json("motion examples/drive.toml --model universal");
    let series = found["series"].as_object().unwrap();
    let count = series["time_s"].as_array().unwrap().len();
    for key in ["pressure_mpa", "contraction", "velocity_mm_per_s", "force_n", "air_mass_g"] {
        assert_eq!(series[key].as_array().unwrap().len(), count, "{key}");
    }
    for key in ["rise_time_s", "settling_time_s", "overshoot", "air_normal_litres"] {
        assert!(number(&found, key) >= 0.0, "{key}");
    }
    // It stands on its stop until it is lifted, where the pull is the weight.
    let lifted = found["events"].as_array().unwrap().iter().find(|e| e["kind"] == "lifted").unwrap();
    let i = series["time_s"].as_array().unwrap().iter().position(|t| t.as_f64() >= lifted["time_s"].as_f64());
    let force = series["force_n"][i.unwrap()].as_f64().unwrap();
    assert!((force / 98.0665 - 1.0).abs() < 0.5, "{force}");
    // It settles where the static model has it under that load.
    let held =
        json("contraction -p 3bar --load mass:10kg --model universal --muscle examples/prototype.toml");
    let at_2_s = series["contraction"][count / 2 - 1].as_f64().unwrap();
    assert!((at_2_s - number(&held, "contraction")).abs() < 1e-5, "{at_2_s} {held}");
}

#[test]
fn a_larger_valve_is_quicker_and_the_smallest_one_is_just_quick_enough() {
    let swept = json("motion examples/drive.toml --model universal --sweep valve.sonic_conductance=0.3,0.6");
    let slow = number(&swept, "rise_time_s");
    let fast = number(&swept["others"][0], "rise_time_s");
    assert!(fast < 0.7 * slow, "{fast} {slow}");
    let sized = json("motion examples/drive.toml --model universal --size valve --rise-time 0.4s");
    assert!((number(&sized, "rise_time_s") / 0.4 - 1.0).abs() < 0.01, "{}", sized["rise_time_s"]);
    assert!(number(&sized, "sonic_conductance_l_per_s_bar") > 0.1);
}

#[test]
fn a_joint_moves_to_its_rest() {
    let found = json("motion examples/elbow-drive.toml --model universal");
    let angles = found["series"]["angle_deg"].as_array().unwrap();
    let rest = json("joint examples/elbow.toml -p 2bar,1bar --model universal");
    let (end, rest) = (angles.last().unwrap().as_f64().unwrap(), number(&rest["points"][0], "angle_deg"));
    assert!((end - rest).abs() < 0.02, "{end} {rest}");
}

/// The static filling with the same volume, and the contraction at the same pressure: other commands, which know nothing of motion.
#[test]
fn liquids_bring_a_muscle_where_the_static_answers_have_it() {
    let before = |found: &serde_json::Value, key: &str, time_s: f64| -> f64 {
        let times = found["series"]["time_s"].as_array().unwrap();
        let i = times.iter().rposition(|t| t.as_f64().unwrap() < time_s).unwrap();
        found["series"][key][i].as_f64().unwrap()
    };
    let syringe = json("motion examples/syringe-drive.toml --model universal");
    let muscle = "--muscle examples/prototype.toml --model universal --load mass:10kg";
    // The piston is within 10⁻⁴ of its 100 mL; what stays in the syringe of 150 mL is beside the dead volume of 10 mL.
    let pushed_ml = 150.0 * before(&syringe, "opening", 2.0);
    let dead_ml = 160.0 - pushed_ml;
    assert!((pushed_ml / 100.0 - 1.0).abs() < 1e-4, "{pushed_ml}");
    let filled = json(&format!("fill {muscle} --volume {pushed_ml}mL --gas 0.5% --dead-volume {dead_ml}mL"));
    for key in ["pressure_mpa", "contraction"] {
        let (ours, theirs) = (before(&syringe, key, 2.0), number(&filled, key));
        assert!((ours / theirs - 1.0).abs() < 1e-5, "{key}: {ours} {theirs}");
    }
    let left = number(&syringe, "liquid_volume_mm3") / 20e3;
    assert!((left - 1.0).abs() < 1e-3 && number(&syringe, "air_normal_litres") == 0.0, "{left}");
    assert!(syringe["series"]["liquid_mass_g"].is_array() && syringe["series"]["air_mass_g"].is_null());
    let pump = json("motion examples/pump-drive.toml --model universal");
    let held = json(&format!("contraction -p 3bar {muscle}"));
    let (ours, theirs) = (before(&pump, "contraction", 8.0), number(&held, "contraction"));
    assert!((ours / theirs - 1.0).abs() < 1e-3, "{ours} {theirs}");
}

#[test]
fn rows_of_csv_are_the_points_of_time() {
    let ran = mckibben("motion examples/drive.toml --model universal --format csv").ok();
    let mut lines = ran.text().lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    for column in ["time_s", "velocity_mm_per_s", "pressure_mpa", "contraction", "angle_deg"] {
        assert!(head.contains(&column), "{column}: {head:?}");
    }
    assert!(lines.count() > 900);
}

#[test]
fn what_does_not_move_is_an_error_with_its_words() {
    let dir = folder();
    let prototype = root().join("examples/prototype.toml");
    let head = format!("muscle = '{}'\n", prototype.display());
    let tail = "[command]\npressure = [['0 s', '0 bar'], ['0.1 s', '2 bar']]\nuntil = '1 s'\n";
    let valve = "[valve]\nsonic_conductance = '0.5 L/(s bar)'\n";
    for (text, code, kind, said) in [
        (format!("{head}{valve}[load]\nmass = '200 kg'\nstops = '0..80 mm'\n{tail}"), 1, "no_answer", "never lifted"),
        (format!("{head}{valve}[load]\nmass = '5 kg'\n[supply]\npressure = '1 bar'\n{tail}"), 2, "file", "supply"),
        (format!("{head}{valve}{tail}"), 2, "file", "[load]"),
        (format!("{head}[load]\nmass = '5 kg'\n{tail}"), 2, "file", "[regulator]"),
        (format!("{head}{valve}[load]\nmass = '5 kg'\n[command]\npressure = [['1 s', '1 bar'], ['0 s', '2 bar']]\nuntil = '1 s'\n"), 2, "file", "must increase"),
        (format!("{head}{valve}[load]\nmass = '5 kg'\n[command]\npressure = '2 bar'\nuntil = '1e9 s'\noutput_step = '1 ms'\n"), 2, "range", "points"),
        ("muscle = 'nowhere.toml'\n[valve]\nname = 'festo-mh2'\n[command]\npressure = '2 bar'\nuntil = '1 s'\n".into(), 2, "file", "nowhere"),
    ] {
        let path = dir.path().join("drive.toml");
        std::fs::write(&path, &text).unwrap();
        let ran = mckibben(&format!("motion {} --model universal --format json", path.display()));
        let error = ran.error();
        assert_eq!((ran.code, error["kind"].as_str()), (code, Some(kind)), "{text}: {error}");
        assert!(error["message"].as_str().unwrap().contains(said), "{text}: {error}");
    }
    let ran = mckibben("motion examples/drive.toml --model paper --format json");
    assert_eq!((ran.code, ran.error()["kind"].as_str()), (2, Some("file")), "{ran:?}");
}

/// A drive beside the prototype's file, with a line of its load and of its command.
fn drive(dir: &std::path::Path, line: &str, command: &str) -> String {
    let muscle = root().join("examples/prototype.toml").display().to_string();
    let text = format!(
        "muscle = '{muscle}'\n[valve]\nsonic_conductance = '0.5 L/(s bar)'\n[load]\nmass = '5 kg'\nline = '{line}'\ndamping = '300 N s/m'\n\
         stops = '0..100 mm'\n[command]\npressure = '{command}'\nuntil = '1 s'\n"
    );
    let path = dir.join("drive.toml");
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

#[test]
fn tables_of_a_drive_are_what_they_hold() {
    let dir = folder();
    std::fs::write(dir.path().join("load.csv"), "Weg [mm];Kraft [N]\n-50;0\n0;0\n200;400\n").unwrap();
    std::fs::write(dir.path().join("command.csv"), "t [ms],p [bar]\n0,0\n500,3\n").unwrap();
    let end = |line: &str, command: &str| {
        let path = drive(dir.path(), line, command);
        let found = json(&format!("motion {path} --model universal"));
        let list = found["series"]["contraction"].as_array().unwrap();
        list.last().unwrap().as_f64().unwrap()
    };
    let spoken = end("spring:2N/mm", "ramp 0..3 bar in 0.5 s");
    let tables = end("table:load.csv", "table:command.csv");
    assert!((spoken - tables).abs() < 1e-7 && spoken > 0.1, "{spoken} {tables}");
}

#[test]
fn tables_that_are_none_are_refused_with_their_place() {
    let dir = folder();
    for (name, text) in [
        ("nan.csv", "t [s],p [bar]\n0,0\n0.5,NaN\n"),
        ("back.csv", "t [s],p [bar]\n0,0\n0.5,1\n0.3,2\n"),
        ("length.csv", "t [s],x [mm]\n0,0\n0.5,1\n"),
    ] {
        std::fs::write(dir.path().join(name), text).unwrap();
    }
    for (command, words) in [
        ("table:none.csv", "none.csv: cannot be read"),
        ("table:nan.csv", "line 3"),
        ("table:back.csv", "must increase"),
        ("table:length.csv", "pressure_mpa"),
    ] {
        let path = drive(dir.path(), "spring:2N/mm", command);
        let ran = mckibben(&format!("motion {path} --model universal"));
        assert!(ran.code == 2 && ran.err.contains(words), "{command}: {}", ran.err);
    }
    let path = drive(dir.path(), "spring:2kg", "3 bar");
    let ran = mckibben(&format!("motion {path} --model universal"));
    assert!(ran.code == 2 && ran.err.contains("drive.toml:6") && ran.err.contains("spring"), "{}", ran.err);
}

#[test]
fn flags_say_what_a_file_says() {
    let file = "muscle = 'prototype.toml'\n[valve]\nsonic_conductance = '0.5 L/(s bar)'\n[load]\nmass = '10 kg'\ndamping = '200 N s/m'\n\
                stops = '0..1e6 mm'\n[command]\npressure = [['0 s', '0 bar'], ['0.05 s', '3 bar']]\nuntil = '1 s'\n";
    let dir = folder();
    std::fs::copy(root().join("examples/prototype.toml"), dir.path().join("prototype.toml")).unwrap();
    let path = dir.path().join("drive.toml");
    std::fs::write(&path, file).unwrap();
    let by_file = json(&format!("motion {} --model universal", path.display()));
    let line = format!(
        "motion --muscle {}/prototype.toml --load mass:10kg -p 3bar --valve 0.5 --damping 200 --until 1s --model universal",
        dir.path().display()
    );
    assert_eq!(by_file["series"], json(&line)["series"]);
    for (flags, words) in [
        ("-p 3bar --valve festo-mh3 --load mass:10kg", "festo-mh2"),
        ("-p 3bar --valve 0 --load mass:10kg", "above zero"),
        ("-p 7bar --valve 0.5 --load mass:10kg", "supply"),
        ("-p 3bar --valve 0.5 --load weight:10kg", "mass:20kg"),
        ("-p 3bar --valve 0.5", "--load"),
    ] {
        let ran = mckibben(&format!("motion --muscle examples/prototype.toml --model universal {flags}"));
        assert!(ran.code == 2 && ran.err.contains(words), "{flags}: {}", ran.err);
    }
}

/// The muscle of a design for 700 N at 15 % and 2.5 bar, thrown up and caught without a damper.
const THROWN: &str =
    "[tube]\nouter_diameter = \"38.61 mm\"\nwall_thickness = \"0.5 mm\"\nlength = \"285 mm\"\n";

#[test]
fn a_load_that_is_thrown_and_caught_by_finite_elements_swings_to_the_end() {
    let dir = folder();
    std::fs::write(dir.path().join("thrown.toml"), THROWN).unwrap();
    let words = ["--load", "mass:10kg", "-p", "2bar", "--valve", "0.5 L/(s bar)", "--until", "3s"];
    let words = ["motion", "--muscle", "thrown.toml"].into_iter().chain(words).chain(["--format", "json"]);
    let found = run_in(dir.path(), &words.collect::<Vec<_>>()).ok().json();
    assert_eq!(*found["series"]["time_s"].as_array().unwrap().last().unwrap(), 3.0);
    // Each slack is followed by a taut, and in between the load flies for some hundredths of a second.
    let events = found["events"].as_array().unwrap();
    let of = |e: &serde_json::Value| e["kind"].as_str().unwrap().to_owned();
    let caught: Vec<_> = events.iter().filter(|e| ["slack", "taut"].contains(&&*of(e))).collect();
    assert!(caught.len() > 10);
    for pair in caught.windows(2) {
        assert!(of(pair[0]) != of(pair[1]));
        assert!(number(pair[1], "time_s") - number(pair[0], "time_s") > 0.01, "{pair:?}");
    }
    // The equilibrium is the static one, and the answer says that it is not reached.
    let held = run_in(
        dir.path(),
        &["contraction", "thrown.toml", "-p", "2bar", "--load", "mass:10kg", "--format", "json"],
    );
    let still = number(&held.ok().json(), "contraction");
    assert!((number(&found, "equilibrium_contraction") - still).abs() < 1e-6, "{still}");
    assert_eq!(found["at_rest"], false);
    let said = found["warnings"].to_string();
    assert!(said.contains("still oscillating") && said.contains("No damping is given"), "{said}");
    let speed = |v: &serde_json::Value| number(v, "largest_velocity_mm_per_s");
    assert!(speed(&found) > 600.0 && speed(&found) < 800.0, "{}", speed(&found));
}

#[test]
fn a_muscle_whose_ends_are_held_fills_and_pulls_as_the_static_model_says() {
    let found = json(
        "motion --muscle examples/prototype.toml --load held:10% -p 2bar --valve festo-mh2 --model universal --until 1s",
    );
    let still = json("force -p 2bar -e 10% --model universal --muscle examples/prototype.toml");
    let force = found["series"]["force_n"].as_array().unwrap().last().unwrap().as_f64().unwrap();
    assert!((force / number(&still, "force_n") - 1.0).abs() < 1e-4, "{force}");
    assert!(number(&found, "fill_time_s") > 0.0 && found["at_rest"].is_null());
    // The same by stops that leave no way.
    let dir = folder();
    let muscle = root().join("examples/prototype.toml").display().to_string();
    let text = format!(
        "muscle = '{muscle}'\n[valve]\nname = 'festo-mh2'\n[load]\nmass = '1 kg'\nstops = '28.5..28.5 mm'\n\
         [command]\npressure = [['0 s', '0 bar'], ['0.05 s', '2 bar']]\nuntil = '1 s'\n"
    );
    std::fs::write(dir.path().join("stops.toml"), text).unwrap();
    let path = dir.path().join("stops.toml").display().to_string();
    let stopped = json(&format!("motion {path} --model universal"));
    let list =
        |v: &serde_json::Value| v["series"]["force_n"].as_array().unwrap().last().unwrap().as_f64().unwrap();
    assert!((list(&stopped) / force - 1.0).abs() < 1e-6, "{}", list(&stopped));
}

#[test]
fn a_rise_time_that_no_valve_meets_is_said_in_words() {
    let ran = mckibben("motion examples/drive.toml --size valve --rise-time 0.001s --model universal");
    assert!(ran.code == 1 && ran.err.contains("with 100 L/(s bar) it is 0.0"), "{}", ran.err);
    let digits = ran.err.split(|c: char| !c.is_ascii_digit() && c != '.').map(str::len).max();
    assert!(!ran.err.contains("Some(") && digits < Some(12), "{}", ran.err);
}
