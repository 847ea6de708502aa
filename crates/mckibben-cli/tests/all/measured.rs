//! `validate --measured`: validation reports of measured muscles and rubbers.

use crate::common::{folder, json, mckibben, root};
use serde_json::Value;

/// The pattern's points are computed with a shear modulus of 0.4 MPa, 900 N/mm and noise of 4 N: `examples/measured/bench`.
#[test]
fn a_folder_is_a_case_without_code() {
    let plot = folder();
    let figure = plot.path().join("measured.svg");
    let line = format!("validate --measured examples/measured --plot {}", figure.display());
    let answer = json(&line);
    let fits = answer["cases"][0]["fits"].as_array().unwrap();
    let modulus = &fits[1]["parameters"][0];
    let (value, half_width) = (&modulus["value"], &modulus["half_width_95"]);
    assert!((value.as_f64().unwrap() - 0.4).abs() < half_width.as_f64().unwrap(), "{modulus}");
    let results = answer["results"].as_array().unwrap();
    let of = |fit: &str| -> Vec<&Value> { results.iter().filter(|r| r["fit"] == fit).collect() };
    let nothing = of("nothing");
    assert_eq!((nothing[0]["blind"].as_bool(), &nothing[0]["fitted_to"]), (Some(true), &"nothing".into()));
    let fitted = of("modulus, stiffness");
    assert!((3.0..4.5).contains(&fitted[0]["rms_n"].as_f64().unwrap()), "{}", fitted[0]);
    let split = of("Gent, up to 2 bar");
    assert_eq!(split.len(), 2);
    assert_eq!((split[0]["blind"].as_bool(), split[1]["blind"].as_bool()), (Some(false), Some(true)));
    assert_eq!(split[1]["of"], "0.3 MPa");
    assert!(std::fs::read_to_string(figure).unwrap().contains("Bench muscle"));
    let text = mckibben("validate --measured examples/measured").ok();
    for word in ["Bench muscle", "a pattern for cases", "unknown", "blind", "within ±"] {
        assert!(text.text().contains(word), "{word}\n{}", text.text());
    }
}

#[test]
fn what_is_no_case_is_told() {
    let said = |line: &str| {
        let result = mckibben(line);
        assert_eq!(result.code, 2, "{line}");
        result.err
    };
    assert!(said("validate --measured --only tundo2012").contains("there are dmsp-10-250, dmsp-10-hose"));
    assert!(said("validate --measured no-such-folder").contains("no-such-folder"));
    assert!(said("validate --measured docs").contains("contains a case.toml"));
    assert!(said("validate --plot a.svg").contains("--measured"));
    let dir = folder();
    let case = dir.path().join("mine");
    std::fs::create_dir(&case).unwrap();
    for file in ["case.toml", "muscle.toml", "points.csv"] {
        std::fs::copy(root().join("examples/measured/bench").join(file), case.join(file)).unwrap();
    }
    let text = std::fs::read_to_string(case.join("case.toml")).unwrap();
    std::fs::write(case.join("case.toml"), text.replace("unknown =", "unknwon =")).unwrap();
    let message = said(&format!("validate --measured {}", dir.path().display()));
    assert!(message.contains("mine/case.toml: `unknwon` is not known"), "{message}");
}

/// The validation report of a rubber agrees with `rubber` of the same points, mode by mode, and over time branch by branch.
#[test]
fn a_rubber_leaves_what_rubber_fit_says() {
    let number = |v: &Value| v.as_f64().unwrap();
    let answer = json("validate --measured --only rubber-treloar,rubber-hnbr50");
    assert!(
        answer["cases"].as_array().unwrap().is_empty() && answer["results"].as_array().unwrap().is_empty()
    );
    let stresses = answer["stresses"].as_array().unwrap();
    let of = |fit: &str| -> Vec<&Value> { stresses.iter().filter(|s| s["fit"] == fit).collect() };
    let fitted = json("rubber data/treloar/tension.csv --law yeoh --up-to 3");
    let modes = fitted["laws"][0]["modes"].as_array().unwrap();
    for mode in modes {
        let ours = of("yeoh, all modes").into_iter().find(|s| s["of"] == mode["mode"]).unwrap();
        assert_eq!((&ours["points"], &ours["rms_mpa"]), (&mode["points"], &mode["rms_mpa"]));
        assert_eq!(ours["blind"], false);
    }
    let one_axis = json("rubber data/treloar/tension.csv --law yeoh --up-to 3 --fit-mode uniaxial");
    let planar = one_axis["laws"][0]["held_out"].as_array().unwrap().iter().find(|h| h["mode"] == "planar");
    let ours = of("yeoh, one axis").into_iter().find(|s| s["of"] == "planar").unwrap();
    assert_eq!((ours["blind"].as_bool(), &ours["rms_mpa"]), (Some(true), &planar.unwrap()["rms_mpa"]));
    let relaxing = of("yeoh, relaxing");
    let squares: f64 = relaxing.iter().map(|s| number(&s["points"]) * number(&s["rms_mpa"]).powi(2)).sum();
    let points: f64 = relaxing.iter().map(|s| number(&s["points"])).sum();
    let over_time = json("rubber data/hnbr50/stepwise_relaxation.csv --law yeoh --relaxation 3");
    let expected = number(&over_time["relaxation"]["rms_mpa"]);
    assert!(((squares / points).sqrt() / expected - 1.0).abs() < 1e-9, "{squares} {points} {expected}");
    let branches: Vec<&str> = relaxing.iter().map(|s| s["of"].as_str().unwrap()).collect();
    assert_eq!(branches, ["loading", "unloading", "held"]);
    let text = mckibben("validate --measured --only rubber-treloar").ok();
    assert!(text.text().contains("natural rubber, Treloar") && !text.text().contains("fe against"));
}

/// Another model has its own ±; the single branches of a hysteresis loop lie on either side of their means.
#[test]
fn a_validation_report_is_of_the_model_that_was_asked_for() {
    let answer = json("validate --measured --only tondu2012 --model thick-wall");
    assert_eq!(answer["model"], "thick-wall");
    let results = answer["results"].as_array().unwrap();
    let first = &results[0];
    // docs/validation.md: 20.6 N against all points that pull or not.
    assert!((first["rms_n"].as_f64().unwrap() - 20.6).abs() < 1.0, "{first}");
    let bias = |i: usize| first["by_branch"][i]["bias_n"].as_f64().unwrap();
    assert_eq!(
        (&first["by_branch"][0]["branch"], &first["by_branch"][1]["branch"]),
        (&"contraction".into(), &"elongation".into())
    );
    assert!(
        bias(0) < first["bias_n"].as_f64().unwrap() && first["bias_n"].as_f64().unwrap() < bias(1),
        "{first}"
    );
    let both = results.iter().find(|r| r["fit"] == "Gent, friction; both branches").unwrap();
    // With the friction in it, neither branch is off.
    let bias = |i: usize| both["by_branch"][i]["bias_n"].as_f64().unwrap().abs();
    assert!(bias(0) < 5.0 && bias(1) < 5.0, "{both}");
}
