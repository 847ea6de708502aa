//! What programs rely on: keys, units, exit codes, files.

use crate::common::{assert_finite, command, folder, json, mckibben, number, ran, root, run_in};
use serde_json::Value;

/// Every one of these keys holds a number.
fn numbers(value: &Value, keys: &[&str]) {
    for key in keys {
        number(value, key);
    }
}

/// Keys that hold a number carry their unit, or mean a ratio or a count.
fn assert_units(value: &Value) {
    const PLAIN: &[&str] = &[
        "contraction",
        "contraction_uncertainty",
        "free_contraction",
        "max_ideal_contraction",
        "max_stretch",
        "fitted_to_stretch",
        "reach",
        "reach_up_to",
        "planar_difference",
        "delta_aicc",
        "max_strain",
        "margin",
        "burst_margin",
        "points",
        "unanswered",
        "looked_at",
        "excluded_by_burst",
        "excluded_by_burst_alone",
        "load_factor",
        "rows",
        "left_out",
        "heading_line",
        "units_line",
        "fitting",
        "turns",
        "strands",
        "stiffness_factor",
        "filaments",
        "largest_contraction",
        "r_squared",
        "up_to_strain",
        "fitted_end_factor",
        "fitted_modulus_factor",
        "fixed",
        "jm",
        "middle_stretch",
        "reach",
        "misses_by",
        "min_burst_margin",
        "max_strand_strain",
    ];
    const UNITS: &[&str] =
        &["_n", "_mpa", "_mm", "_mm3", "_deg", "_n_per_mm", "_n_per_mpa", "_j", "_g", "_normal_litres"];
    match value {
        Value::Array(list) => list.iter().for_each(assert_units),
        Value::Object(map) => {
            for (key, inner) in map {
                let named = PLAIN.contains(&key.as_str()) || UNITS.iter().any(|u| key.ends_with(u));
                assert!(!inner.is_number() || named, "{key} does not say its unit");
                if !["constants_mpa", "uncertainty_parts_n"].contains(&key.as_str()) {
                    assert_units(inner);
                }
            }
        }
        _ => {}
    }
}

fn close(a: f64, b: f64, relative: f64) {
    assert!((a - b).abs() <= relative * b.abs().max(1e-9), "{a} is not {b}");
}

#[test]
fn one_value_and_its_inverses() {
    for model in ["paper", "thick-wall", "ideal", "chou-hannaford", "force-balance", "klute-hannaford"] {
        let force = json(&format!("force -D 40 -s 2 -p 0.2 -e 0.1 --model {model}"));
        numbers(&force, &["pressure_mpa", "contraction", "force_n"]);
        assert_eq!(force["model"], model);
        assert_eq!(force["slack"], false);
        assert_eq!(force["warnings"], serde_json::json!([]));
        assert_units(&force);
        let f = number(&force, "force_n");
        let pressure = json(&format!("pressure -D 40 -s 2 -F {f} -e 0.1 --model {model}"));
        close(number(&pressure, "pressure_mpa"), 0.2, 1e-6);
        close(number(&pressure, "force_n"), f, 1e-9);
        let contraction = json(&format!("contraction -D 40 -s 2 -F {f} -p 0.2 --model {model}"));
        close(number(&contraction, "contraction"), 0.1, 1e-6);
    }
    let thick = json("force -D 40 -s 2 -p 0.2 -e 0.1 --model thick-wall");
    numbers(&thick, &["volume_mm3", "stiffness_n_per_mm", "max_stretch", "bulged_diameter_mm"]);
    numbers(&thick, &["uncertainty_n", "start_pressure_mpa"]);
}

#[test]
fn the_stiffness_is_the_slope_over_the_length() {
    let at = |e: f64| json(&format!("force -D 40 -s 2 -p 0.2 -e {e} --model thick-wall"));
    let (low, high) = (number(&at(0.0999), "force_n"), number(&at(0.1001), "force_n"));
    close(number(&at(0.1), "stiffness_n_per_mm"), (low - high) / (0.0002 * 285.0), 1e-4);
}

#[test]
fn bare_numbers_and_units_mean_the_same() {
    let bare = mckibben("force -D 40 -s 2 -L 285 --angle 28 -p 0.2 -e 0.1 --format json").ok();
    let units = mckibben("force -D 4cm -s 2mm -L 0.285m --angle 28deg -p 2bar -e 10% --format json").ok();
    assert_eq!(bare, units);
}

#[test]
fn slack_is_no_error() {
    let slack = mckibben("force -p 0.01 -e 0.15 --format json").ok().json();
    assert_eq!(slack["slack"], true);
    assert_eq!(number(&slack, "force_n"), 0.0);
    assert!(number(&slack, "start_pressure_mpa") > 0.01);
    // Where it hangs: an identity with the inverse for no pull.
    let free = json("contraction -p 0.01 -F 0");
    assert!((number(&slack, "volume_mm3") / number(&free, "volume_mm3") - 1.0).abs() < 1e-9);
    let pushes = json("force -p 0.01 -e 0.15 --two-sided");
    assert_eq!(pushes["slack"], false);
    assert!(number(&pushes, "force_n") < 0.0);
    // Just above and below the pressure at which it starts to pull.
    let start = number(&slack, "start_pressure_mpa");
    assert_eq!(json(&format!("force -p {} -e 0.15", start * 1.001))["slack"], false);
    assert_eq!(json(&format!("force -p {} -e 0.15", start * 0.999))["slack"], true);
    // An inverse that asks for a push needs --two-sided too.
    let push = json("contraction -p 0.2 -F -10 --model thick-wall --two-sided");
    assert_eq!(number(&push, "force_n"), -10.0);
}

#[test]
fn no_answer_comes_with_the_nearest() {
    let pressure = mckibben("pressure -F 9999 -e 0.1 --model paper --format json");
    assert_eq!(pressure.code, 1);
    assert_eq!(pressure.error()["kind"], "no_answer");
    numbers(&pressure.error()["nearest"], &["force_n", "pressure_mpa"]);
    close(number(&pressure.error()["nearest"], "pressure_mpa"), 0.25, 1e-9);
    let contraction = mckibben("contraction -F 9999 -p 0.2 --format json");
    assert_eq!(contraction.code, 1);
    numbers(&contraction.error()["nearest"], &["force_n", "contraction"]);
    // The nearest that is promised is reachable.
    let nearest = number(&contraction.error()["nearest"], "force_n");
    json(&format!("contraction -F {} -p 0.2", 0.9999 * nearest));
}

#[test]
fn extrapolation_answers_with_a_warning() {
    assert_eq!(mckibben("force -p 0.3 --model paper").code, 2);
    let answer = json("force -p 0.3 --model paper --extrapolate");
    numbers(&answer, &["force_n"]);
    let warnings = answer["warnings"].as_array().unwrap();
    assert!(warnings.iter().any(|w| w.as_str().unwrap().contains("0.25")), "{warnings:?}");
    let text = mckibben("force -p 0.3 --model paper --extrapolate").ok();
    assert!(text.err.starts_with("warning: extrapolated"), "{}", text.err);
}

#[test]
fn units_change_what_people_see_and_nothing_else() {
    for line in ["force -p 0.2 -e 0.1", "curve isobaric -p 0.1,0.2", "design -F 300 -e 10% -p 0.25"] {
        let plain = mckibben(line).ok();
        let bar = mckibben(&format!("{line} --units bar")).ok();
        assert_ne!(plain.out, bar.out, "{line}");
        assert!(bar.text().contains("bar"), "{line}");
        for format in ["json", "csv"] {
            let of = |more| mckibben(&format!("{line} --format {format}{more}")).ok();
            assert_eq!(of(""), of(" --units psi"), "{line} {format}");
            assert_eq!(of(""), of(" --units kpa"), "{line} {format}");
        }
    }
    // The unit that was typed is the one that is shown.
    assert!(mckibben("force -p 2bar").ok().text().contains("2 bar"));
}

const CURVES: [&str; 3] = [
    "curve isobaric -D 40 -s 2 -p 0.1..0.2:0.05 -e 0..0.15:0.05",
    "curve isometric -D 40 -s 2 -p 0.1..0.2:0.05 -e 0..0.15:0.05",
    "curve isotonic -D 40 -s 2 -p 0.2..0.25:0.05 -F 550,600",
];

#[test]
fn curves_are_points_with_the_keys_of_one_value() {
    for line in CURVES {
        let curve = json(line);
        assert_eq!(curve["model"], "fe");
        assert_eq!(curve["test"], line.split(' ').nth(1).unwrap());
        numbers(&curve["muscle"], &["outer_diameter_mm", "wall_mm", "length_mm", "angle_deg"]);
        assert_units(&curve);
        for point in curve["points"].as_array().unwrap() {
            assert_eq!(point["status"], "ok");
            numbers(point, &["pressure_mpa", "contraction", "force_n"]);
            assert!(point["slack"].is_boolean());
            let (p, e) = (number(point, "pressure_mpa"), number(point, "contraction"));
            let one = json(&format!("force -D 40 -s 2 -p {p} -e {e}"));
            close(number(&one, "force_n"), number(point, "force_n"), 1e-6);
        }
    }
}

#[test]
fn csv_columns_are_the_json_keys() {
    for line in CURVES {
        let csv = mckibben(&format!("{line} --format csv")).ok();
        let points = json(line)["points"].as_array().unwrap().clone();
        let mut reader = csv::Reader::from_reader(csv.text().as_bytes());
        let columns: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
        let mut count = 0;
        for (record, point) in reader.records().zip(&points) {
            let record = record.unwrap();
            for (key, field) in columns.iter().zip(record.iter()) {
                match &point[key] {
                    Value::Null => assert_eq!(field, "", "{key}"),
                    Value::String(s) => assert_eq!(field, s, "{key}"),
                    Value::Number(n) => close(field.parse().unwrap(), n.as_f64().unwrap(), 1e-15),
                    other => assert_eq!(field, other.to_string(), "{key}"),
                }
            }
            count += 1;
        }
        assert_eq!(count, points.len());
        let keys = |p: &Value| p.as_object().unwrap().keys().cloned().collect::<Vec<_>>();
        assert!(
            points
                .iter()
                .flat_map(keys)
                .all(|k| ["warnings", "uncertainty_parts_n"].contains(&k.as_str()) || columns.contains(&k))
        );
    }
}

#[test]
fn a_curve_is_data_for_compare() {
    let dir = folder();
    let file = dir.path().join("curve.csv");
    let file = file.to_str().unwrap();
    mckibben(&format!("{} --format csv -o {file}", CURVES[0])).ok();
    let same = json(&format!("compare -D 40 -s 2 --models fe,ideal --data {file}"));
    assert_eq!(same["reference"], "measured");
    assert!(number(&same["models"][0], "rms_n") < 1e-6);
    assert!(number(&same["models"][1], "rms_n") > 1.0);
    // Points without answer are left out.
    mckibben(&format!("curve isobaric -p 0.2,0.3 --model paper --format csv -o {file} --overwrite")).ok();
    let some = json(&format!("compare --models paper --data {file}"));
    assert_eq!(some["points"], 21);
}

#[test]
fn points_without_answer_say_why() {
    let curve = json("curve isobaric -p 0.2,0.3 -e 0,0.1 --model paper");
    let points = curve["points"].as_array().unwrap();
    let status: Vec<&str> = points.iter().map(|p| p["status"].as_str().unwrap()).collect();
    assert_eq!(status, ["ok", "ok", "out_of_range", "out_of_range"]);
    for point in &points[2..] {
        assert!(point["cause"].as_str().unwrap().contains("0.25"));
        assert!(point.get("force_n").is_none());
        assert_eq!(number(point, "pressure_mpa"), 0.3);
    }
    let all = mckibben("curve isobaric -p 0.3 --model paper --format json");
    assert_eq!(all.code, 2);
    assert!(all.json()["points"].as_array().unwrap().iter().all(|p| p["status"] == "out_of_range"));
    let none = mckibben("curve isotonic -F 99999 -p 0.1,0.2 --format json");
    assert_eq!(none.code, 1);
    assert!(none.json()["points"].as_array().unwrap().iter().all(|p| p["status"] == "no_answer"));
    let text = mckibben("curve isotonic -F 99999 -p 0.1,0.2");
    assert_eq!((text.code, text.out.len()), (1, 0));
}

const SPEC: &str = "design --force 300N --contraction 10% --max-pressure 2.5bar";

#[test]
fn designs_are_sorted_and_complete() {
    for (objective, key, sign) in [
        ("diameter", "outer_diameter_mm", 1.0),
        ("pressure", "pressure_mpa", 1.0),
        ("air", "air_normal_litres", 1.0),
        ("margin", "margin", -1.0),
    ] {
        let found = json(&format!("{SPEC} --objective {objective} --top 8"));
        let list = found["candidates"].as_array().unwrap();
        assert_eq!(list.len(), 8);
        let by: Vec<f64> = list.iter().map(|c| sign * number(c, key)).collect();
        assert!(by.windows(2).all(|w| w[0] <= w[1] + 1e-9), "{objective}: {by:?}");
        assert_units(&found);
        for c in list {
            numbers(c, &["outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "pressure_mpa"]);
            numbers(c, &["blocked_force_n", "free_contraction", "margin"]);
            assert!(number(c, "pressure_mpa") <= 0.25 + 1e-12);
            for point in c["points"].as_array().unwrap() {
                numbers(point, &["force_n", "contraction", "pressure_mpa", "force_at_max_pressure_n"]);
                assert!(number(point, "force_at_max_pressure_n") >= 300.0 - 1e-6);
            }
        }
        for r in found["rejected"].as_array().unwrap() {
            numbers(r, &["outer_diameter_mm", "wall_mm", "angle_deg"]);
            assert!(!r["reason"].as_str().unwrap().is_empty());
        }
        assert!(found.get("closest").is_none());
    }
}

#[test]
fn a_design_that_fails_names_the_closest() {
    let found = mckibben("design --force 5000N --contraction 15% --max-pressure 2.5bar --format json");
    assert_eq!(found.code, 1);
    let found = found.json();
    assert_eq!(found["candidates"], serde_json::json!([]));
    let closest = &found["closest"];
    numbers(closest, &["outer_diameter_mm", "wall_mm", "angle_deg", "length_mm"]);
    assert!(closest["reason"].as_str().unwrap().contains("5000 N required"));
    assert!(closest["relaxations"].as_array().unwrap().iter().all(|r| r["relax"].is_string()));
    let text = mckibben("design --force 5000N --contraction 15% --max-pressure 2.5bar");
    assert_eq!(text.code, 1);
    assert!(text.text().contains("Nothing fits"));
}

#[test]
fn what_a_failed_design_promises_holds() {
    let found =
        mckibben("design --force 1300N --contraction 15% --max-pressure 2.5bar --model paper --format json");
    assert_eq!(found.code, 1);
    let relaxations = found.json()["closest"]["relaxations"].clone();
    let list = relaxations.as_array().unwrap();
    for r in list {
        let (mut f, mut e, mut p, mut more) = (1300.0, 0.15, 0.25, "--model paper".to_owned());
        match r["relax"].as_str().unwrap() {
            "force" => f = number(&r["points"][0], "force_n").floor(),
            "contraction" => e = (1e4 * number(&r["points"][0], "contraction")).floor() / 1e4,
            "max_pressure" => {
                p = (1e4 * number(r, "pressure_mpa")).ceil() / 1e4;
                assert_eq!(r["extrapolated"], true);
                more.push_str(" --extrapolate");
            }
            "outer_diameter" => {
                let d = (100.0 * number(r, "outer_diameter_mm")).ceil() / 100.0;
                let s = number(&found.json()["closest"], "wall_mm");
                more = format!("--model {} -D {d} -s {s}", r["model"].as_str().unwrap());
            }
            other => panic!("{other} was not limited"),
        }
        mckibben(&format!("design --force {f}N --contraction {e} --max-pressure {p} {more}")).ok();
    }
    assert!(list.len() >= 3, "{relaxations}");
}

#[test]
fn the_winner_is_a_muscle_file() {
    let dir = folder();
    for (more, model) in
        [(" -s 2", "fe"), (" --model thick-wall --rubber rtv615 -D 20..40:5 -s 1,2", "thick-wall")]
    {
        let file = dir.path().join(format!("{model}.toml"));
        let file = file.to_str().unwrap();
        let found = json(&format!("{SPEC}{more} -o {file}"));
        let winner = &found["candidates"][0];
        let shown = json(&format!("check {file}"));
        for key in ["outer_diameter_mm", "wall_mm", "length_mm", "angle_deg"] {
            assert_eq!(number(winner, key), number(&shown, key), "{key}");
        }
        let p = number(winner, "pressure_mpa");
        let force = json(&format!("force --muscle {file} -p {p} -e 10% --model {model}"));
        close(number(&force, "force_n"), 300.0, 1e-5);
    }
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 2, "no temporary files");
}

#[test]
fn stroke_sets_what_is_open() {
    let length = json("design -F 300 --stroke 40mm -e 10% -p 2.5bar --model thick-wall -D 40 -s 2");
    close(number(&length["candidates"][0], "length_mm"), 400.0, 1e-9);
    let contraction = json("design -F 300 --stroke 28.5mm -L 285 -p 2.5bar --continuous");
    close(number(&contraction["candidates"][0]["points"][0], "contraction"), 0.1, 1e-9);
}

#[test]
fn tolerances_stand_around_the_wanted_pull() {
    let found = json(&format!("{SPEC} --tolerance wall=0.1mm,diameter=0.2mm,pressure=0.1bar"));
    let t = &found["tolerance"][0];
    assert!(number(t, "low_n") < 300.0 && number(t, "high_n") > 300.0);
    assert!(number(t, "likely_n") < 0.5 * (number(t, "high_n") - number(t, "low_n")) + 1e-9);
}

#[test]
fn comparisons_carry_their_errors() {
    for line in [
        "compare --models ideal,paper,thick-wall -p 1,2bar",
        "compare --models ideal,thick-wall --data data/tondu2012/static_force_20deg.csv --muscle examples/tondu2012.toml",
    ] {
        let found = json(line);
        assert_units(&found);
        for row in found["models"].as_array().unwrap() {
            assert!(row["model"].is_string());
            numbers(row, &["rms_n", "max_n", "mean_n", "points", "unanswered"]);
            assert!(number(row, "max_n") >= number(row, "rms_n"));
            assert!(number(row, "rms_n") >= number(row, "mean_n").abs() - 1e-9);
        }
    }
    let first = json("compare --models ideal,paper -p 1,2bar");
    assert_eq!(first["reference"], "ideal");
    assert_eq!(number(&first["models"][0], "rms_n"), 0.0);
}

#[test]
fn muscles_rubbers_and_models() {
    let muscle = json("check examples/prototype.toml");
    numbers(&muscle, &["outer_diameter_mm", "wall_mm", "length_mm", "angle_deg"]);
    numbers(&muscle, &["shear_modulus_mpa", "stiffness_n_per_mm"]);
    numbers(&muscle["derived"], &["inner_diameter_mm", "strand_length_mm", "turns", "volume_mm3"]);
    numbers(&muscle["build_sheet"], &["tube_cut_mm", "braid_cut_mm", "plug_diameter_mm"]);
    assert_units(&muscle);
    // The prototype is what holds where nothing is said.
    assert_eq!(muscle, json("check"));
    let list = json("parts list rubbers");
    let rubbers = list["rubbers"].as_array().unwrap();
    assert!(rubbers.len() > 10);
    for rubber in rubbers {
        let name = rubber["name"].as_str().unwrap();
        let one = json(&format!("parts show {name}"))["rubber"].take();
        assert_eq!(one["name"], name);
        assert!(!one["source"].as_str().unwrap().is_empty());
        let fits = one["fits"].as_array().unwrap();
        assert_eq!(fits.iter().filter(|f| f["taken"] == true).count(), 1, "{name}");
        assert!(fits.iter().all(|f| f["shear_modulus_mpa"].as_f64().is_some_and(|mu| mu > 0.0)), "{name}");
        json(&format!("check --rubber {name}"));
    }
    let list = json("parts list sleeves");
    for braid in list["sleeves"].as_array().unwrap() {
        let name = braid["name"].as_str().unwrap();
        let one = json(&format!("parts show {name}"))["sleeve"].take();
        assert_eq!(one["name"], name);
        assert_units(&one);
        assert!(!one["source"].as_str().unwrap().is_empty() && !one["terms"].as_str().unwrap().is_empty());
        let points = one["points"].as_array().unwrap();
        assert!(points.len() >= 5, "{name}: {points:?}");
        numbers(&points[0], &["outer_diameter_mm", "angle_deg", "largest_contraction"]);
        let diameter = points[0]["outer_diameter_mm"].as_f64().unwrap();
        let wall = diameter / 10.0;
        json(&format!("check -D {diameter} -s {wall} --braid {name} --stiffness inextensible"));
    }
    let models = json("parts list models");
    for model in models["models"].as_array().unwrap() {
        assert!(!model["description"].as_str().unwrap().is_empty());
        let name = model["name"].as_str().unwrap();
        let result = mckibben(&format!(
            "force -p 0.1 -e 5% --model {name} --extrapolate --end-factor 1.2 --cone-factor 0.4 --strand-length 323 --turns 1.5"
        ));
        assert!(result.code <= 1, "{name}: {}", result.err);
    }
}

#[test]
fn nothing_is_printed_that_is_no_number() {
    for line in CURVES.iter().copied().chain([
        SPEC,
        "curve isobaric -p 0..0.25:0.05 -e -0.1..0.5:0.02 --model ideal --extrapolate",
        "curve isobaric -p 0..2:0.5 -e -0.1..0.9:0.1 --model thick-wall --extrapolate --two-sided",
        "curve isobaric -p 0..2:0.5 -e -0.5..0.9:0.1 --model paper --extrapolate --two-sided",
        "curve isotonic -F 0,20 -p 0..1:0.1 --model chou-hannaford",
        "curve --study thickness --model thick-wall",
        "compare --models ideal,thick-wall,klute-hannaford",
        "parts list",
        "parts show s-muscle-20",
        "check",
    ]) {
        for format in ["text", "json", "csv"] {
            let result = mckibben(&format!("{line} --format {format}"));
            assert_eq!(result.code, 0, "{line}: {}", result.err);
            assert_finite(result.text());
        }
        let value = json(line);
        for point in value["points"].as_array().into_iter().flatten() {
            let nulls = point.as_object().unwrap().values().filter(|v| v.is_null()).count();
            assert_eq!(nulls, 0, "{line}: {point}");
        }
        for candidate in value["candidates"].as_array().into_iter().flatten() {
            numbers(candidate, &["margin", "blocked_force_n", "work_j", "pressure_mpa"]);
        }
    }
}

#[test]
fn the_same_question_has_the_same_bytes() {
    for line in [
        SPEC,
        "design -F 200 -e 12% -p 3bar --model thick-wall -D 20..40:5 -s 1..3:0.5 --rubber rtv615,dragon-skin-30",
        "curve isobaric -p 0..0.25:0.05",
        "compare --models ideal,thick-wall --muscle examples/tondu2012.toml --data data/tondu2012/static_force_20deg.csv --fit modulus,end-factor",
    ] {
        let with = |threads: &str| {
            let mut command = command(&root());
            let command = command.args(line.split(' ')).args(["--format", "json"]);
            ran(command.env("RAYON_NUM_THREADS", threads).output().unwrap()).ok()
        };
        let one = with("1");
        assert_eq!(one, with("1"), "{line}");
        assert_eq!(one, with("4"), "{line}");
    }
}

#[test]
fn figures_are_whole_and_alone() {
    for line in [
        "curve isobaric",
        "curve --study thickness",
        "compare --models ideal,paper",
        "design -F 300 -e 10% -p 2.5bar",
    ] {
        let dir = folder();
        for name in ["f.svg", "f.png", "f.html"] {
            let plot = ["--plot", name];
            let args: Vec<&str> = line.split(' ').chain(plot).collect();
            run_in(dir.path(), &args).ok();
            let bytes = std::fs::read(dir.path().join(name)).unwrap();
            match name {
                "f.png" => {
                    assert!(bytes.starts_with(b"\x89PNG\r\n\x1a\n") && bytes.ends_with(b"IEND\xaeB`\x82"))
                }
                "f.svg" => {
                    let text = std::str::from_utf8(&bytes).unwrap();
                    balanced(text);
                    assert_finite(text);
                }
                _ => {
                    let text = std::str::from_utf8(&bytes).unwrap();
                    assert!(text.to_lowercase().starts_with("<!doctype html>") && text.contains("<svg"));
                    assert!(!text.contains("src=\"http") && !text.contains("href=\"http"), "opens offline");
                }
            }
        }
        let mut names: Vec<_> =
            std::fs::read_dir(dir.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
        names.sort();
        assert_eq!(names, ["f.html", "f.png", "f.svg"], "{line}");
    }
}

/// An SVG whose elements are all closed in their order.
fn balanced(text: &str) {
    let start = text.find("<svg").expect("an svg element");
    assert!(start == 0 || text.starts_with("<?xml"), "starts with {}", &text[..20]);
    let mut open: Vec<&str> = vec![];
    let mut rest = &text[start..];
    while let Some(i) = rest.find('<') {
        let end = i + rest[i..].find('>').expect("an end of the tag");
        let tag = &rest[i + 1..end];
        rest = &rest[end + 1..];
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name.trim()));
        } else if !tag.ends_with('/') && !tag.starts_with(['!', '?']) {
            open.push(tag.split_whitespace().next().unwrap());
        }
    }
    assert!(open.is_empty(), "{open:?} left open");
}

#[test]
fn a_result_goes_to_a_file_whole() {
    let dir = folder();
    let file = dir.path().join("out.json");
    let path = file.to_str().unwrap();
    let direct = mckibben("models --format json").ok();
    let saved = mckibben(&format!("models --format json -o {path}")).ok();
    assert!(saved.out.is_empty());
    assert_eq!(std::fs::read(&file).unwrap(), direct.out);
    // What fails leaves an older file as it was.
    assert_eq!(mckibben(&format!("force -p 0.3 --model paper -o {path}")).code, 2);
    assert_eq!(std::fs::read(&file).unwrap(), direct.out);
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1);
}

#[test]
fn fe_answers_unless_another_model_is_named() {
    for more in ["", " -D 60", " -D 25 --rubber rtv615", " --angle 25", " -p 0.3"] {
        for line in ["force -p 0.2", "curve isobaric -p 0.2 -e 0.1"] {
            let line = if more.contains("-p") { line.replace(" -p 0.2", "") } else { line.into() };
            assert_eq!(json(&format!("{line}{more}"))["model"], "fe", "{line}{more}");
        }
    }
    assert_eq!(json("pressure -F 100 -e 0.1")["model"], "fe");
    assert_eq!(json("contraction -F 100 -p 0.2")["model"], "fe");
    assert_eq!(json("check -p 0.2")["characteristics"]["model"], "fe");
    assert_eq!(json("compare")["reference"], "fe");
    assert_eq!(json("curve --study thickness")["model"], "fe");
}

#[test]
fn finite_elements_settle_every_candidate() {
    let found = json("design -F 300 -e 10% -p 2.5bar -D 30,35 -s 0.5,2");
    let candidates = found["candidates"].as_array().unwrap();
    assert!(candidates.len() > 2 && candidates.iter().all(|c| c["model"] == "fe"), "{found}");
    assert_eq!((found["model"].as_str(), found["searched_with"].as_str()), (Some("fe"), Some("universal")));
    assert!(found.get("verification").is_none());
    let other = json("design -F 300 -e 10% -p 2.5bar -s 2 --model ideal");
    assert_eq!(other["verification"]["holds"], false, "{other}");
}

#[test]
fn friction_parts_the_branches() {
    let at = |motion| {
        let line =
            format!("force --muscle examples/tondu2012.toml --model ideal -p 3bar -e 5% --motion {motion}");
        number(&json(&line), "force_n")
    };
    let half = 0.5 * (at("elongation") - at("contraction"));
    close(half, 37.6, 0.05);
    close(0.5 * (at("elongation") + at("contraction")), at("mean"), 1e-9);
}

/// The ending of a file says its format.
#[test]
fn a_file_is_written_in_the_format_of_its_ending() {
    let dir = folder();
    let path = dir.path().join("x.csv");
    let line = "curve isobaric --model ideal -p 0.1,0.2 -e 0,0.1";
    mckibben(&format!("{line} -o {}", path.to_str().unwrap()));
    let written = std::fs::read_to_string(&path).unwrap();
    assert_eq!(written, mckibben(&format!("{line} --format csv")).text());
    let path = dir.path().join("x.json");
    mckibben(&format!("{line} -o {}", path.to_str().unwrap()));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), mckibben(&format!("{line} --format json")).text());
}
