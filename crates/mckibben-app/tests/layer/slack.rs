//! Muscles that do not pull: slack ones, and those whose strands break; muscles without a text.

use crate::reply;
use mckibben_app::{ProblemKind, ask};
use mckibben_core::{
    progress::Silent,
    random::{Random, rounds},
};
use serde_json::{Value, json};

const OWNED: &str = "[tube]\nouter_diameter = \"12 mm\"\nwall_thickness = \"2 mm\"\nlength = \"220 \
    mm\"\nrubber = \"latex\"\n\
    [braid]\nangle = \"28 deg\"\nstrands = 144\nstrand_diameter = \"0.25 mm\"\nstrand_modulus \
    = \"8.5 GPa\"\nstrand_strength = \"20 N\"\n\
    strands_per_carrier = 3\n";

fn owned() -> Value {
    json!({"name": "owned.toml", "text": OWNED})
}

/// A muscle that hangs slack has one volume and diameter, in both commands, and no slopes.
#[test]
fn a_slack_muscle_of_simulate_is_that_of_force() {
    let test = json!({ "test": "isometric", "muscle": { "file": owned() }, "pressures_mpa": [0.1], "contractions": [0.1, 0.2] });
    let simulated = reply("simulate", test);
    for point in simulated["points"].as_array().unwrap() {
        let question = json!({ "muscle": { "file": owned() }, "pressure_mpa": 0.1, "contraction": point["contraction"] });
        let force = reply("force", question);
        assert_eq!(
            (&point["slack"], &force["slack"]),
            (&json!(true), &json!(true))
        );
        for key in [
            "force_n",
            "volume_mm3",
            "bulged_diameter_mm",
            "free_contraction",
        ] {
            let (a, b) = (point[key].as_f64().unwrap(), force[key].as_f64().unwrap());
            assert!((a - b).abs() <= 1e-6 * b.abs(), "{key}: {a} {b}");
        }
        assert!(point["stiffness_n_per_mm"].is_null() && force["stiffness_n_per_mm"].is_null());
    }
}

/// One muscle, one pull: a point of `curve` and of `simulate` is that of `force`, of muscles that
/// were drawn, that hang slack, that extend, without pressure and with.
#[test]
fn one_muscle_has_one_pull_in_every_command() {
    let mut random = Random(50);
    for _ in 0..rounds(8) {
        let outer = random.between(8.0, 40.0);
        let extends = random.unit() < 0.3;
        let (angle, contractions) = if extends {
            (random.between(57.0, 72.0), [-0.1, -0.04, 0.0])
        } else {
            (random.between(18.0, 40.0), [0.0, 0.06, 0.25])
        };
        let text = format!(
            "[tube]\nouter_diameter = {outer}\nwall_thickness = {}\nlength = {}\nprestretch = \
             {}\nrubber = \"latex\"\n\
             [braid]\nangle = {angle}\nstiffness = {}\n",
            outer * random.between(0.05, 0.2),
            outer * random.between(5.0, 15.0),
            random.one_of(&[1.0, 1.1]),
            random.between(300.0, 2000.0),
        );
        let muscle = json!({"name": "random.toml", "text": text});
        let pressures = [0.0, 0.02, 0.2];
        let test = json!({ "test": "isobaric", "muscle": { "file": muscle }, "pressures_mpa": pressures, "contractions": contractions });
        for command in ["curve", "simulate"] {
            let answer = reply(command, test.clone());
            let points = answer["points"].as_array().unwrap();
            assert_eq!(points.len(), 9, "{command} {text}");
            for point in points {
                let question = json!({ "muscle": { "file": muscle }, "pressure_mpa": point["pressure_mpa"], "contraction": point["contraction"] });
                let Ok(force) = ask("force", &question.to_string(), &Silent) else {
                    assert_ne!(point["status"], "ok", "{command} {question}");
                    continue;
                };
                let force: Value = serde_json::from_str(&force).unwrap();
                assert_eq!(point["slack"], force["slack"], "{command} {question}");
                for key in ["force_n", "volume_mm3", "bulged_diameter_mm"] {
                    let (a, b) = (point[key].as_f64().unwrap(), force[key].as_f64().unwrap());
                    assert!(
                        (a - b).abs() <= 1e-5 * b.abs().max(1.0),
                        "{command} {key}: {a} {b} {question}"
                    );
                }
            }
        }
    }
}

/// 84 N at a strength of 20 N: no pull and no ±.
#[test]
fn a_muscle_whose_strands_break_neither_pulls_nor_has_an_uncertainty() {
    let force = reply(
        "force",
        json!({ "muscle": { "file": owned() }, "pressure_mpa": 0.3, "contraction": -0.3, "two_sided": true }),
    );
    assert_eq!(force["force_n"], 0.0);
    assert!(force["strand_tension_n"].as_f64().unwrap() > 20.0 && force["uncertainty_n"].is_null());
    let simulated = reply(
        "simulate",
        json!({ "test": "isometric", "muscle": { "file": owned() }, "pressures_mpa": [0.3], "contractions": [-0.25, 0.0] }),
    );
    assert_eq!(simulated["points"][0]["force_n"], 0.0);
    let grid = json!({ "muscle": { "file": owned() }, "models": ["fe"], "pressures_mpa": [0.3], "contractions": [-0.2, 0.0] });
    assert_eq!(reply("compare", grid)["models"][0]["max_n"], 0.0);
    // Nor is its pull the answer of an inverse, or the nearest one.
    for (command, question) in [
        (
            "contraction",
            json!({ "muscle": { "file": owned() }, "force_n": 4000.0, "pressure_mpa": 0.3 }),
        ),
        (
            "contraction",
            json!({ "muscle": { "file": owned() }, "force_n": 9e4, "pressure_mpa": 0.3 }),
        ),
        (
            "pressure",
            json!({ "muscle": { "file": owned() }, "force_n": 9000.0, "contraction": -0.2 }),
        ),
    ] {
        let error = ask(command, &question.to_string(), &Silent).unwrap_err();
        assert_eq!(error.kind, ProblemKind::NoAnswer, "{command}: {error}");
        assert!(error.nearest.is_none(), "{command}");
    }
}

/// Plugs that are wider than the bore: an answer at each pressure, and one that rises with it.
#[test]
fn a_tube_on_wide_plugs_has_an_answer_without_pull_too() {
    for plug_mm in [36.0, 45.0, 50.0] {
        let text = format!(
            "[tube]\nouter_diameter = 30\nwall_thickness = 1.5\nlength = 200\n[tube.material]\nlaw \
             = \"neo-hookean\"\nmu = 0.3\n\
             [braid]\nangle = 25\nstiffness = 600\n[terminals]\nplug_diameter = {plug_mm}\n"
        );
        let mut before = 0.0;
        for pressure_mpa in [0.0001, 0.001, 0.005, 0.01, 0.02, 0.05] {
            let muscle = json!({"name": "wide.toml", "text": text});
            let force = reply(
                "force",
                json!({ "muscle": { "file": muscle }, "pressure_mpa": pressure_mpa }),
            );
            let pull = force["force_n"].as_f64().unwrap();
            assert!(pull >= before, "{plug_mm} mm, {pressure_mpa} MPa: {pull} N");
            before = pull;
        }
        assert!(before > 200.0);
    }
}

/// A name alone is that of the library; one without a text that is no name of it must not be the
/// default muscle.
#[test]
fn a_muscle_has_a_text_or_is_of_the_library() {
    let of = |muscle: Value| json!({ "muscle": { "file": muscle }, "pressure_mpa": 0.3 });
    let alone = reply("force", of(json!("lib:dmsp-20-300")));
    let empty = json!({"name": "lib:dmsp-20-300", "text": ""});
    assert_eq!(alone["force_n"], reply("force", of(empty))["force_n"]);
    let unknown = of(json!({"name": "dmsp-20-300", "text": ""})).to_string();
    assert_eq!(
        ask("force", &unknown, &Silent).unwrap_err().kind,
        ProblemKind::File
    );
    let comments =
        of(json!({"name": "mine.toml", "text": "# my muscle\n\n  # of latex\n"})).to_string();
    assert_eq!(
        ask("force", &comments, &Silent).unwrap_err().kind,
        ProblemKind::File
    );
}

/// Two muscles of one kind, one on each side: P′ of the first at an angle is that of the second at
/// the opposite one, and that of `force` at its contraction.
#[test]
fn the_pressure_at_which_a_muscle_of_a_joint_starts_to_pull_is_that_of_force() {
    let file = |name: &str| {
        let path = crate::root().join("examples").join(name);
        json!({ "name": name, "text": std::fs::read_to_string(path).unwrap() })
    };
    let muscle = file("forearm-muscle.toml");
    let angles: Vec<f64> = (-4..=4).map(|i| 15.0 * f64::from(i)).collect();
    let request = json!({ "joint": file("forearm.toml"), "muscles": [muscle, muscle], "model": "thick-wall",
        "pressures_mpa": [[0.4, 0.0]], "angles_deg": angles });
    let points = reply("joint", request)["points"].take();
    let number = |i: usize, key: &str| points[i][key].as_f64().unwrap();
    for i in 0..angles.len() {
        let start = number(i, "start_pressure_1_mpa");
        let opposite = number(angles.len() - 1 - i, "start_pressure_2_mpa");
        assert_eq!(start, opposite, "{}", angles[i]);
        let contraction = number(i, "contraction_1");
        let question = json!({ "muscle": { "file": muscle }, "model": "thick-wall",
            "pressure_mpa": 0.4, "contraction": contraction });
        let alone = reply("force", question)["start_pressure_mpa"]
            .as_f64()
            .unwrap();
        assert!(
            (start - alone).abs() < 1e-9,
            "{contraction}: {start} {alone}"
        );
    }
}

/// The arm of 25 mm on either side, and the weight of 1.2 kg at 150 mm, which hangs at the neutral
/// angle; and each pull is that of `force`.
#[test]
fn a_joint_carries_the_pulls_of_its_muscles_on_their_arms() {
    let file = |name: &str| {
        let path = crate::root().join("examples").join(name);
        json!({ "name": name, "text": std::fs::read_to_string(path).unwrap() })
    };
    let muscle = file("biceps.toml");
    let pressures = [0.2, 0.1];
    let request = json!({ "joint": file("elbow.toml"), "muscles": [muscle, muscle], "model": "thick-wall",
        "pressures_mpa": [pressures], "angles_deg": [-20.0, 10.0, 40.0] });
    let points = reply("joint", request)["points"].take();
    for point in points.as_array().unwrap() {
        let number = |key: &str| point[key].as_f64().unwrap();
        let weight = 1.2 * 9.80665 * 0.15 * number("angle_deg").to_radians().sin();
        let torque = 0.025 * (number("force_1_n") - number("force_2_n")) - weight;
        assert!((number("torque_nm") - torque).abs() < 1e-9, "{point}");
        for (i, (arm, pressure_mpa)) in [25.0, -25.0].into_iter().zip(pressures).enumerate() {
            let of = |key: &str| &point[key.replace('#', &(i + 1).to_string())];
            let question = json!({ "muscle": { "file": muscle }, "model": "thick-wall",
                "pressure_mpa": pressure_mpa, "contraction": of("contraction_#") });
            let alone = reply("force", question);
            let [ours, theirs] = [of("force_#_n"), &alone["force_n"]].map(|n| n.as_f64().unwrap());
            assert!((ours - theirs).abs() < 1e-6, "{i} {point}: {theirs}");
            assert_eq!(of("slack_#"), &alone["slack"], "{i} {point}");
            assert!(
                (of("arm_#_mm").as_f64().unwrap() - arm).abs() < 1e-12,
                "{i} {point}"
            );
        }
    }
}
