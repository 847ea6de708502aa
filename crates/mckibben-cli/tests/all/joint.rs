//! Loads and joints as a user meets them.

use crate::common::{folder, json, mckibben};

#[test]
fn a_load_and_its_force_have_the_same_contraction() {
    let load = json("contraction -p 0.25 --load mass:20kg");
    let force = json("contraction -p 0.25 -F 196.133N");
    let (a, b) = (load["contraction"].as_f64().unwrap(), force["contraction"].as_f64().unwrap());
    assert!((a - b).abs() < 1e-9, "{a} {b}");
    let at = &load["loaded"]["at"][0]["equilibria"][0];
    assert_eq!(at["stable"], true);
    // √(K/M)/2π with K in N/mm.
    let k = at["held_stiffness_n_per_mm"].as_f64().unwrap();
    let f = (1e3 * k / 20.0).sqrt() / std::f64::consts::TAU;
    assert!((at["natural_frequency_hz"].as_f64().unwrap() / f - 1.0).abs() < 1e-12);
}

#[test]
fn the_stroke_between_two_pressures_is_that_of_its_equilibria() {
    let found =
        json("curve isobaric -p 1bar,2bar,3bar -e 0..0.3:0.1 --load spring:5N/mm@50N --model universal");
    let at = found["loaded"]["at"].as_array().unwrap();
    let x = |i: usize| at[i]["equilibria"][0]["shortening_mm"].as_f64().unwrap();
    let cycle = &found["loaded"]["cycle"];
    assert!((cycle["stroke_mm"].as_f64().unwrap() - (x(2) - x(0))).abs() < 1e-9);
    // ∫ (50 + 5x) dx in J
    let work = |x: f64| 1e-3 * (50.0 * x + 2.5 * x * x);
    assert!((cycle["work_j"].as_f64().unwrap() - (work(x(2)) - work(x(0)))).abs() < 1e-9);
}

#[test]
fn a_table_is_a_load() {
    let dir = folder();
    let path = dir.path().join("load.csv");
    std::fs::write(&path, "Weg [mm];Kraft [N]\n-10;100\n100;100\n").unwrap();
    let table = json(&format!("contraction -p 0.2 --model universal --load table:{} ", path.display()));
    let force = json("contraction -p 0.2 --model universal -F 100N");
    let of = |v: &serde_json::Value| v["contraction"].as_f64().unwrap();
    assert!((of(&table) - of(&force)).abs() < 1e-9);
}

#[test]
fn a_joint_says_torques_rests_and_pressures() {
    let torques = json("joint examples/elbow.toml -p 2bar,1bar --angle 10deg --model universal");
    let point = &torques["points"][0];
    for key in [
        "angle_deg",
        "pressure_1_mpa",
        "pressure_2_mpa",
        "torque_nm",
        "stiffness_nm_per_rad",
        "force_1_n",
        "force_2_n",
        "contraction_1",
        "contraction_2",
    ] {
        assert!(point[key].is_number(), "{key}: {point}");
    }
    assert_eq!((point["slack_1"].as_bool(), point["slack_2"].as_bool()), (Some(false), Some(false)));
    // r (F1 − F2) and the weight of 1.2 kg at 150 mm, which hangs at the neutral angle.
    let n = |key: &str| point[key].as_f64().unwrap();
    let weight = 1.2 * 9.80665 * 0.15 * 10f64.to_radians().sin();
    assert!((n("torque_nm") - (0.025 * (n("force_1_n") - n("force_2_n")) - weight)).abs() < 1e-9);
    // The pressures that were asked come back.
    let back = json(&format!(
        "joint examples/elbow.toml --angle 10deg --torque {} --stiffness {} --model universal",
        n("torque_nm"),
        n("stiffness_nm_per_rad")
    ));
    let back = &back["points"][0];
    assert!((back["pressure_1_mpa"].as_f64().unwrap() - 0.2).abs() < 1e-7, "{back}");
    assert!((back["pressure_2_mpa"].as_f64().unwrap() - 0.1).abs() < 1e-7, "{back}");
    let rest = json("joint examples/elbow.toml -p 2bar,1bar --model universal");
    assert_eq!(rest["points"][0]["rest"], "stable");
    assert!(rest["points"][0]["torque_nm"].as_f64().unwrap().abs() < 1e-9);
}

#[test]
fn what_no_joint_or_load_can_do_is_an_error_with_its_words() {
    let dir = folder();
    let lone = dir.path().join("joint.toml");
    std::fs::write(&lone, "[joint]\nradius = '25 mm'\n[muscle_1]\nfile = 'none.toml'\n").unwrap();
    let lone = lone.display();
    for (line, code, kind, said) in [
        ("contraction -p 0.02 --load mass:40kg".to_owned(), 1, "no_answer", "not lifted"),
        ("contraction -p 0.2 --load mass:2kg -F 3N".into(), 2, "usage", "conflicts with"),
        ("contraction -p 0.2 --load 2kg".into(), 2, "quantity", "is not a valid load"),
        ("contraction -p 0.2 --load table:/nowhere.csv".into(), 2, "file", "nowhere"),
        ("curve isometric --load mass:2kg".into(), 2, "usage", "isobaric"),
        ("joint examples/elbow.toml".into(), 2, "usage", "--pressure"),
        ("joint examples/elbow.toml -p 2bar".into(), 2, "usage", "2 muscles"),
        ("joint examples/elbow.toml -p 2bar,-1bar".into(), 2, "quantity", "gauge pressure"),
        ("joint examples/elbow.toml -p 2bar,1bar --angle 80deg".into(), 2, "out_of_range", "-60..60"),
        (
            "joint examples/elbow.toml --angle 0 --torque 900 --model universal".into(),
            1,
            "no_answer",
            "N m there",
        ),
        (
            "joint examples/elbow.toml --angle 0 --stiffness 1e6 --model universal".into(),
            1,
            "no_answer",
            "N m/rad",
        ),
        ("joint examples/elbow.toml --stiffness 5".into(), 2, "usage", "--angle"),
        ("joint examples/elbow.toml --map 60000 --model universal".into(), 2, "range", "points"),
        (
            "joint examples/elbow.toml --map 5 --max-pressure 40bar --model universal".into(),
            2,
            "out_of_range",
            "pressure 4 MPa",
        ),
        (format!("joint {lone} -p 2bar"), 2, "file", "none.toml"),
        ("joint examples/prototype.toml -p 2bar".into(), 2, "file", "unknown key"),
    ] {
        let ran = mckibben(&format!("{line} --format json"));
        let error = ran.error();
        assert_eq!((ran.code, error["kind"].as_str()), (code, Some(kind)), "{line}: {error}");
        assert!(error["message"].as_str().unwrap().contains(said), "{line}: {error}");
    }
}

#[test]
fn a_design_for_a_load_is_that_for_its_pull() {
    let load = json(
        "design --load spring:4N/mm@40N --stroke 40mm --length 285 -p 2.5bar --model universal --verify none",
    );
    let pull = json("design -F 200N --stroke 40mm --length 285 -p 2.5bar --model universal --verify none");
    assert_eq!(load["candidates"], pull["candidates"]);
    assert_eq!(load["load"], "spring:4N/mm@40N");
}

#[test]
fn a_joint_that_was_designed_holds_its_torque() {
    let dir = folder();
    let file = dir.path().join("winner.toml");
    let line = format!(
        "design --joint 8Nm@45deg,3Nm@60deg -p 6bar --length 250 --max-bulged-diameter 40mm --rubber dragon-skin-30 -o {}",
        file.display()
    );
    let found = json(&line);
    let joint = &found["candidates"][0]["joint"];
    let (radius, neutral) =
        (joint["radius_mm"].as_f64().unwrap(), joint["contraction_at_neutral"].as_f64().unwrap());
    let muscle = format!("file = 'winner.toml'\ncontraction_at_neutral = {neutral}\n");
    let text = format!(
        "[joint]\nradius = '{radius} mm'\nrange = '-60..60 deg'\n[muscle_1]\n{muscle}[muscle_2]\n{muscle}"
    );
    let path = dir.path().join("elbow.toml");
    std::fs::write(&path, text).unwrap();
    for (angle, torque) in [(45, 8.0), (60, 3.0), (-45, -8.0)] {
        let p = if angle > 0 { "6bar,0bar" } else { "0bar,6bar" };
        let there = json(&format!("joint {} -p {p} --angle {angle}deg", path.display()));
        let held = there["points"][0]["torque_nm"].as_f64().unwrap() / torque;
        assert!(held > 0.9999, "{angle}: {held}");
    }
}
