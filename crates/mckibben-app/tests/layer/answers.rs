//! Answers of one command in another: files that one gives and another reads, and the same muscle
//! by several ways.

use crate::{
    given::{
        assert_close, drive_file, example, file, joint_file, last, muscle, number, table, text_of,
        with,
    },
    reply,
};
use mckibben_app::{ForceRequest, MuscleFields, TextFile, force};
use serde_json::{Value, json};

/// The muscle file of the best muscle of a design.
fn winner(design: &Value) -> Value {
    json!({ "file": design["muscle_files"][0] })
}

/// An identity: the muscle file of a design answers every command with the digits of the table, ±
/// included.
#[test]
fn a_design_is_of_parts_and_its_muscle_file_has_its_digits() {
    let wanted = json!({ "force_n": 700, "contraction": 0.15, "max_pressure_mpa": 0.25 });
    let design = reply("design", wanted);
    let best = &design["candidates"][0];
    let tube = reply("parts-show", json!({ "name": best["tube"] }))["tube"].take();
    assert_eq!(
        (&tube["outer_diameter_mm"], &tube["rubber"]),
        (&best["outer_diameter_mm"], &best["rubber"])
    );
    let promised = number(&best["points"][0], "force_at_max_pressure_n");
    let highest_mpa = number(best, "highest_pressure_mpa");
    let limit_mpa = (number(best, "allowed_pressure_mpa") / 1.1).min(0.95 * 0.25);
    let required_n = 700.0 / number(best, "count");
    assert!(promised >= required_n && (highest_mpa - limit_mpa).abs() < 1e-12);
    // Of a muscle that is built, while it shortens.
    let muscle = winner(&design);
    let point = json!({ "muscle": muscle, "pressure_mpa": highest_mpa, "contraction": 0.15 });
    let curve = json!({ "muscle": muscle, "test": "isobaric", "pressures_mpa": [highest_mpa], "contractions": [0.15] });
    let curve = reply("curve", curve);
    for point in [&reply("force", point), &curve["points"][0]] {
        assert_close(number(point, "predicted_n"), promised, 1e-6);
    }
    let point = json!({ "muscle": muscle, "pressure_mpa": 0.25, "contraction": 0.15 });
    let answer = reply("force", point);
    for key in ["burst_pressure_mpa", "allowed_pressure_mpa"] {
        assert_eq!(answer[key], best[key], "{key}");
    }
    assert_eq!(answer["muscle"]["sleeve"], best["sleeve"]);
    assert!(number(&answer["uncertainty_parts_n"], "braid") > 0.0);
}

/// An identity: what is asked of the file of a design without a pressure is asked of its job, and
/// the pull is the one that was required.
#[test]
fn the_file_of_a_design_knows_its_pressure_its_branch_and_its_points() {
    let points = json!([
        { "force_n": 60, "contraction": 0.1 },
        { "force_n": 90, "contraction": 0.03 },
    ]);
    let design = reply(
        "design",
        json!({ "points": points, "max_pressure_mpa": 0.4 }),
    );
    let best = &design["candidates"][0];
    let set_mpa = number(best, "pressure_mpa");
    let muscle = winner(&design);
    let of_job = |command: &str, more: Value| reply(command, with(json!({"muscle": muscle}), more));
    let force = of_job("force", json!({}));
    let needs_mpa = |i: usize| number(&best["points"][i], "pressure_mpa");
    let tightest = if needs_mpa(0) > needs_mpa(1) {
        60.0
    } else {
        90.0
    };
    // The search knows the pressure to a millionth of the highest.
    assert_close(number(&force, "predicted_n"), tightest, 1e-5);
    assert_eq!(force["predicted_direction"], "contraction");
    let contraction = of_job("contraction", json!({ "force_n": tightest }));
    let check = of_job("check", json!({}));
    let built = of_job("build", json!({}));
    for answer in [&force, &contraction, &check["characteristics"], &built] {
        assert_close(number(answer, "pressure_mpa"), set_mpa, 1e-12);
    }
    // Told otherwise, it answers otherwise.
    let mean = of_job("force", json!({ "pressure_mpa": 0.2, "direction": "mean" }));
    assert_eq!(
        (number(&mean, "pressure_mpa"), number(&mean, "contraction")),
        (0.2, 0.0)
    );
    assert!(number(&mean, "force_n") > number(&force, "force_n"));
}

/// An identity: with the valve of `cycle_hz` the motion of the same muscle and mass rises within a
/// quarter of the period, with a smaller one it does not; the air is that of so many strokes.
#[test]
fn the_valve_of_a_cycle_is_the_smallest_that_is_quick_enough() {
    let wanted = json!({ "force_n": 80, "stroke_mm": 5, "max_pressure_mpa": 0.6, "cycle_hz": 4 });
    let design = reply("design", wanted);
    let cycle = &design["cycle"];
    let air = number(&design["candidates"][0], "air_normal_litres");
    assert_close(
        number(cycle, "air_normal_litres_per_min"),
        240.0 * air,
        1e-12,
    );
    let conductance = number(cycle, "sonic_conductance_l_per_s_bar");
    let rise_s = |share: f64| {
        let step = json!({
            "pressure_mpa": design["candidates"][0]["pressure_mpa"],
            "load": format!("mass:{}kg", 80.0 / 9.80665),
            "supply_mpa": 0.6,
            "valve": format!("{} L/(s bar)", share * conductance),
            "until_s": 0.5,
        });
        let moved = json!({ "muscle": design["muscle_files"][0], "step": step });
        number(&reply("motion", moved), "rise_time_s")
    };
    let (with_it, with_less) = (rise_s(1.0), rise_s(0.95));
    assert!(
        with_it <= 0.0625 * 1.001 && with_less > 0.0625,
        "{with_it} {with_less}"
    );
}

/// At the highest pressure all but a tenth, or a hundredth, pull what is required: z of tables.
#[test]
fn a_certain_design_meets_the_requirement_with_its_share_of_the_built_pull() {
    for (share, z) in [(0.9, 1.281_552), (0.99, 2.326_348)] {
        let wanted = json!({ "force_n": 60, "contraction": 0.12, "max_pressure_mpa": 0.25,
            "model": "universal", "certainty": share, "count": 1 });
        let design = reply("design", wanted);
        let most_mpa = number(&design["candidates"][0], "highest_pressure_mpa");
        let point = json!({ "muscle": winner(&design), "pressure_mpa": most_mpa,
            "contraction": 0.12, "model": "universal" });
        let answer = reply("force", point);
        let half_n = number(&answer, "uncertainty_n");
        let lower_n = number(&answer, "predicted_n") - z * half_n / 1.959_964;
        assert!(lower_n >= 60.0 * (1.0 - 1e-3), "{share}: {lower_n}");
    }
}

const HOSE: &str = "crates/mckibben-cli/tests/rows/hose.toml";

/// The identity that defines it: there the tension of the most loaded strand of the blocked muscle
/// is its strength.
#[test]
fn one_burst_pressure_in_every_command_to_the_last_digit() {
    let hose = muscle(HOSE);
    let checked = reply("check", json!({ "muscle": hose, "pressure_mpa": 0.6 }));
    let burst = &checked["characteristics"]["burst_pressure_mpa"];
    let blocked = reply("force", json!({ "muscle": hose, "pressure_mpa": burst }));
    assert_close(number(&blocked, "strand_tension_n"), 40.0, 1e-8);
    let joint = joint_file("crates/mckibben-cli/tests/rows/joint.toml");
    let step = json!({ "load": "mass:5kg", "valve": "festo-mh2", "damping_n_s_per_m": 200, "until_s": 0.3, "pressure_mpa": 0.3 });
    for (command, request) in [
        ("force", json!({ "muscle": hose, "pressure_mpa": 2.2 })),
        (
            "pressure",
            json!({ "muscle": hose, "force_n": 300, "contraction": 0.05 }),
        ),
        (
            "contraction",
            json!({ "muscle": hose, "force_n": 100, "pressure_mpa": 0.3 }),
        ),
        (
            "curve",
            json!({ "muscle": hose, "test": "isobaric", "pressures_mpa": [0.2] }),
        ),
        (
            "simulate",
            json!({ "muscle": hose, "test": "isobaric", "pressures_mpa": [0.2] }),
        ),
        (
            "joint",
            with(
                joint,
                json!({ "pressures_mpa": [[0.3, 0.1]], "angles_deg": [0] }),
            ),
        ),
        ("motion", json!({ "muscle": example(HOSE), "step": step })),
        ("build", json!({ "muscle": hose, "pressure_mpa": 0.3 })),
    ] {
        assert_eq!(
            &reply(command, request)["burst_pressure_mpa"],
            burst,
            "{command}"
        );
    }
}

/// An identity: a name is its muscle file, in a command, in a joint file, and under fields.
#[test]
fn a_name_stands_for_its_muscle_file() {
    let shown = reply("parts-show", json!({ "name": "dmsp-20-300" }));
    let text = shown["muscle"]["muscle_file"]["text"].as_str().unwrap();
    let mine = file("mine.toml", text);
    let at = json!({ "model": "thick-wall", "pressure_mpa": 0.5, "contraction": 0.1 });
    let pull = |muscle: Value| reply("force", with(json!({ "muscle": muscle }), at.clone()));
    let named = |name: &str| json!({ "file": file(name, "") });
    let by_name = pull(named("lib:dmsp-20-300"));
    // A file has fifteen digits of a number.
    let by_file = pull(json!({ "file": mine }));
    for key in ["force_n", "predicted_n", "predicted_low_n", "uncertainty_n"] {
        assert_close(number(&by_file, key), number(&by_name, key), 1e-12);
    }
    assert_eq!(by_name, pull(named("LIB:DMSP_20_300")));
    let joint = text_of("crates/mckibben-cli/tests/rows/libjoint.toml");
    let library = file("lib:dmsp-20-300", "");
    let [a, b] = [
        (joint.clone(), library),
        (joint.replace("lib:dmsp-20-300", "mine.toml"), mine),
    ]
    .map(|(joint, muscle)| {
        let request = json!({ "joint": file("joint.toml", &joint), "muscles": [muscle, muscle], "pressures_mpa": [[0.3, 0.2]], "model": "thick-wall" });
        reply("joint", request)["points"].take()
    });
    assert_close(
        number(&a[0], "torque_nm"),
        number(&b[0], "torque_nm"),
        1e-10,
    );
    let longer = pull(with(named("lib:dmsp-20-300"), json!({ "length_mm": 400 })));
    assert_eq!(number(&longer["muscle"], "length_mm"), 400.0);
    let wanted = json!({ "force_n": 700, "contraction": 0.15, "max_pressure_mpa": 0.25, "model": "universal" });
    let [a, b] = [
        json!({ "continuous": true }),
        json!({ "muscle": file("paper", "") }),
    ]
    .map(|more| {
        reply("design", with(wanted.clone(), more))["candidates"][0]["outer_diameter_mm"].take()
    });
    assert_eq!(a, b);
}

/// Static answers, which know nothing of motion.
#[test]
fn motions_end_where_the_static_answers_have_them() {
    const MUSCLE: &str = "examples/prototype.toml";
    const ROWS: &str = "crates/mckibben-cli/tests/rows";
    let universal = json!({ "model": "universal" });
    let ask = |command: &str, request: Value| reply(command, with(request, universal.clone()));
    let moved = |path: &str| ask("motion", drive_file(path));
    let before = |answer: &Value, key: &str, time_s: f64| -> f64 {
        let times = answer["series"]["time_s"].as_array().unwrap();
        let is_before = |t: &Value| t.as_f64().unwrap() < time_s;
        let i = times.iter().rposition(is_before).unwrap();
        answer["series"][key][i].as_f64().unwrap()
    };
    let loaded = json!({ "muscle": muscle(MUSCLE), "load": "mass:10kg" });
    let held = with(loaded.clone(), json!({ "pressure_mpa": 0.3 }));
    let held = number(&ask("contraction", held), "contraction");
    let drive = moved("examples/drive.toml");
    assert_close(before(&drive, "contraction", 2.0), held, 1e-4);
    let pump = moved("examples/pump-drive.toml");
    assert_close(before(&pump, "contraction", 8.0), held, 1e-3);
    let rest = with(
        joint_file("examples/elbow.toml"),
        json!({ "pressures_mpa": [[0.2, 0.1]] }),
    );
    let rest = ask("joint", rest);
    let turned = last(&moved("examples/elbow-drive.toml"), "angle_deg");
    assert!(
        (turned - number(&rest["points"][0], "angle_deg")).abs() < 0.02,
        "{turned}"
    );
    // What stays in the syringe of 150 mL is beside the dead volume of 10 mL.
    let syringe = moved("examples/syringe-drive.toml");
    let pushed_mm3 = 150e3 * before(&syringe, "opening", 2.0);
    let liquid = json!({ "volume_mm3": pushed_mm3, "gas_share": 0.005, "dead_volume_mm3": 160e3 - pushed_mm3 });
    let filled = ask("fill", with(loaded, liquid));
    for key in ["pressure_mpa", "contraction"] {
        assert_close(before(&syringe, key, 2.0), number(&filled, key), 1e-5);
    }
    // Ends that are held, by a load and by stops that leave no way.
    let held = json!({ "muscle": muscle(MUSCLE), "pressure_mpa": 0.2, "contraction": 0.1 });
    let held = number(&ask("force", held), "force_n");
    let stepped = |step: Value| ask("motion", json!({ "muscle": example(MUSCLE), "step": step }));
    let force = last(
        &stepped(
            json!({ "load": "held:10%", "pressure_mpa": 0.2, "valve": "festo-mh2", "until_s": 1 }),
        ),
        "force_n",
    );
    assert_close(force, held, 1e-4);
    // A drive file beside the muscle file that it names.
    let written = |name: &str, tables: Value| {
        let request = json!({ "drive": example(&format!("{ROWS}/{name}.toml")), "muscle": example(MUSCLE), "tables": tables });
        ask("motion", request)
    };
    assert_close(last(&written("stops", json!([])), "force_n"), force, 1e-6);
    // A file says what fields say, and tables what words say.
    let step = json!({ "load": "mass:10kg", "pressure_mpa": 0.3, "valve": "0.5", "damping_n_s_per_m": 200, "until_s": 1 });
    assert_eq!(
        written("step", json!([]))["series"],
        stepped(step)["series"]
    );
    let tables = json!([
        table(&format!("{ROWS}/load.csv")),
        table(&format!("{ROWS}/command.csv"))
    ]);
    let a = last(&written("spoken", json!([])), "contraction");
    let b = last(&written("tables", tables), "contraction");
    assert!((a - b).abs() < 1e-7 && a > 0.1, "{a} {b}");
}

/// The ± of where a hanging mass comes to rest is that of `contraction` with the same load, by hand
/// from its keys; so are the median and the ends of its interval.
#[test]
fn the_end_of_a_motion_has_the_uncertainty_of_its_equilibrium() {
    const MUSCLE: &str = "examples/prototype.toml";
    let step = json!({ "load": "mass:20kg", "pressure_mpa": 0.2, "valve": "0.5 L/(s bar)", "damping_n_s_per_m": 3000, "until_s": 4 });
    let motion = reply(
        "motion",
        json!({ "muscle": example(MUSCLE), "step": step, "model": "thick-wall" }),
    );
    let still = reply(
        "contraction",
        json!({ "muscle": muscle(MUSCLE), "load": "mass:20kg", "pressure_mpa": 0.2, "model": "thick-wall" }),
    );
    let at = &still["loaded"]["at"][0]["equilibria"][0];
    let half = number(at, "contraction_uncertainty");
    assert_close(number(&motion, "end_contraction_uncertainty"), half, 1e-3);
    for end in ["predicted", "predicted_low", "predicted_high"] {
        let of_motion = number(&motion, &format!("end_contraction_{end}"));
        assert_close(of_motion, number(at, end), 1e-3);
    }
    assert_eq!(motion["at_rest"], true);
}

/// An identity: the torque and the stiffness of a joint at two pressures give back the pressures.
#[test]
fn a_joint_gives_back_its_pressures_and_a_designed_one_is_a_joint_file() {
    let elbow = json!({ "angles_deg": [10], "model": "universal" });
    let elbow = with(joint_file("examples/elbow.toml"), elbow);
    let there = reply(
        "joint",
        with(elbow.clone(), json!({ "pressures_mpa": [[0.2, 0.1]] })),
    )["points"]
        .take();
    let wanted = json!({ "torque_nm": there[0]["torque_nm"], "stiffness_nm_per_rad": there[0]["stiffness_nm_per_rad"] });
    let back = reply("joint", with(elbow, wanted))["points"].take();
    assert_close(number(&back[0], "pressure_1_mpa"), 0.2, 1e-6);
    assert_close(number(&back[0], "pressure_2_mpa"), 0.1, 1e-6);
}

/// The written muscle carries the laws of the answer to the last bit, and `force` answers with it.
#[test]
fn the_muscle_file_of_a_rubber_has_its_constants() {
    const CONSTANTS: [&str; 3] = ["c10", "c20", "c30"];
    let silicone = json!({ "data": [table("data/silicones/dragon_skin_30.csv")], "laws": ["yeoh"], "up_to_stretch": 3 });
    let relaxed = json!({ "data": [table("data/hnbr50/stepwise_relaxation.csv")], "laws": ["yeoh"], "relaxation": 3 });
    for (request, is_relaxed) in [(silicone, false), (relaxed, true)] {
        let identified = reply("rubber", request);
        let text = identified["muscle_file"].as_str().unwrap();
        let written = json!({ "file": file("m.toml", text) });
        let shown = reply("check", json!({ "muscle": written }));
        for (i, name) in CONSTANTS.iter().enumerate() {
            let ours = if is_relaxed {
                let instantaneous = &identified["relaxation"]["instantaneous"];
                number(instantaneous, &format!("{name}_mpa"))
            } else {
                number(&identified["parameters"][i], "value")
            };
            // A file has fifteen digits of a number.
            assert_close(number(&shown["constants_mpa"], name), ours, 1e-14);
        }
        let at = json!({ "muscle": written, "pressure_mpa": 0.2, "contraction": 0.1 });
        assert!(number(&reply("force", at), "force_n") > 0.0 || is_relaxed);
        if is_relaxed {
            let muscle = mckibben_core::muscle::file::parse_muscle(text).unwrap();
            let prony = muscle.tube().rubber.prony.as_ref().unwrap();
            assert_eq!(prony.branches.len(), 3);
        }
    }
    let mine = file("mine.toml", "[tube]\nrubber = \"dragon-skin-30\"\n");
    let [a, b] = [mine, json!("dragon-skin-30")].map(|rubber| {
        let at = json!({ "muscle": { "rubber": rubber }, "pressure_mpa": 0.2, "contraction": 0.1 });
        reply("force", at)["force_n"].take()
    });
    assert_eq!(a, b);
}

/// An identity: the muscle file of a build folder has the name of the one that was given.
#[test]
fn a_build_folder_keeps_the_name_of_its_muscle() {
    const GIVEN: &str = "examples/prototype.toml";
    let built = reply(
        "build",
        json!({ "muscle": muscle(GIVEN), "pressure_mpa": 0.2 }),
    );
    let files = built["files"].as_array().unwrap();
    let built = files.iter().find(|f| f["name"] == "muscle.toml").unwrap();
    let built = built["text"].as_str().unwrap();
    let names: Vec<&str> = built
        .lines()
        .filter(|line| line.starts_with("name"))
        .collect();
    assert_eq!(names, ["name = \"prototype\""], "{built}");
    let pull = |name: &str, text: String| {
        let file = TextFile {
            name: name.into(),
            text,
        };
        let mut request = ForceRequest {
            pressure_mpa: Some(0.2.into()),
            contraction: Some(0.1.into()),
            ..ForceRequest::default()
        };
        request.question.muscle = MuscleFields::from_file(file);
        force(&request).unwrap().point.response.force_n
    };
    assert_eq!(
        pull("muscle.toml", built.to_owned()),
        pull("prototype.toml", text_of(GIVEN))
    );
}

/// By hand: R² = 1 − n rms²/Σ(F − mean F)² with the pulls of (1); of a model against itself 1.
#[test]
fn by_hand_r2_is_what_the_rms_leaves_of_the_spread() {
    let answer = reply(
        "compare",
        json!({ "models": ["ideal", "thick-wall"], "pressures_mpa": [0.1, 0.2], "contractions": [0, 0.1] }),
    );
    let of = |i: usize, key| number(&answer["models"][i], key);
    assert_eq!(of(0, "r_squared"), 1.0);
    let (sin2, cos2) = (
        28f64.to_radians().sin().powi(2),
        28f64.to_radians().cos().powi(2),
    );
    let ideal = |p: f64, e: f64| {
        std::f64::consts::PI * 900.0 * p / (4.0 * sin2) * (3.0 * (1.0 - e).powi(2) * cos2 - 1.0)
    };
    let pulls = [
        ideal(0.1, 0.0),
        ideal(0.1, 0.1),
        ideal(0.2, 0.0),
        ideal(0.2, 0.1),
    ];
    let mean = pulls.iter().sum::<f64>() / 4.0;
    let spread: f64 = pulls.iter().map(|f| (f - mean).powi(2)).sum();
    let expected = 1.0 - 4.0 * of(1, "rms_n").powi(2) / spread;
    assert!((of(1, "r_squared") - expected).abs() < 1e-9, "{expected}");
}

/// What many points say is said of the study once.
#[test]
fn a_study_says_once_that_its_muscles_were_not_measured() {
    let study = reply("study", json!({ "model": "paper" }));
    let warnings = study["warnings"].as_array().unwrap().iter();
    assert_eq!(warnings.filter(|w| w["kind"] == "not_measured").count(), 1);
}
