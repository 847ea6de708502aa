//! `validate --measured`: dossiers of measured muscles.

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
    for word in ["Bench muscle", "a pattern for cases", "unknown", "blind", "held"] {
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
    assert!(said("validate --measured docs").contains("holds a case.toml"));
    assert!(said("validate --plot a.svg").contains("--measured"));
    let dir = folder();
    let case = dir.path().join("mine");
    std::fs::create_dir(&case).unwrap();
    for file in ["case.toml", "muscle.toml", "points.csv"] {
        std::fs::copy(root().join("examples/measured/bench").join(file), case.join(file)).unwrap();
    }
    let text = std::fs::read_to_string(case.join("case.toml")).unwrap();
    std::fs::write(case.join("case.toml"), text.replace("unknown =", "unknwon =")).unwrap();
    let told = said(&format!("validate --measured {}", dir.path().display()));
    assert!(told.contains("mine/case.toml: `unknwon` is not known"), "{told}");
}
