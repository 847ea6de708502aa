//! `export`: the folder, what it replaces, its errors.

use crate::common::{folder, json, mckibben, number, run};
use std::fs;

const MUSCLE: &str = "export examples/prototype.toml --model thick-wall --as";

/// The pull of the form at the blocked point is that of the model within the error that the answer states.
#[test]
fn the_answer_states_the_error_of_its_form() {
    let answer = json(&format!("{MUSCLE} python"));
    let exact = number(&json("force examples/prototype.toml --model thick-wall -p 0.25"), "force_n");
    let form = &answer["form"];
    // At the supply the functions of the pressure are 1, 1, 1, (1 - 0.15)² and (1 - 0.45)².
    let rest = form["contractions"].as_array().unwrap().iter().position(|e| e.as_f64() == Some(0.0)).unwrap();
    let functions = [1.0, 1.0, 1.0, 0.7225, 0.3025];
    let blocked: f64 =
        functions.iter().enumerate().map(|(i, f)| f * form["a"][i][rest].as_f64().unwrap()).sum();
    let worst = number(&answer, "force_worst_ratio");
    assert!((blocked - exact).abs() <= worst * exact, "{blocked} {exact} {worst}");
    assert_eq!(number(&answer, "supply_pressure_mpa"), 0.25);
    assert_eq!(answer["name"], "prototype");
    assert!(worst <= 0.01, "{worst}");
}

#[test]
fn a_folder_is_written_again_and_what_is_not_ours_stays() {
    let place = folder();
    let path = place.path().to_str().unwrap().to_owned();
    let words: Vec<&str> = MUSCLE.split(' ').chain(["c", "-o", &path]).collect();
    let printed = run(&words).ok();
    assert!(printed.text().contains("files are in"), "{}", printed.text());
    for name in ["mckibben.h", "mckibben.c", "muscle.h", "example.c"] {
        assert!(place.path().join(name).is_file(), "{name}");
    }
    run(&words).ok();
    fs::write(place.path().join("mckibben.c"), "int mine;\n").unwrap();
    fs::remove_file(place.path().join("mckibben.h")).unwrap();
    let refused = run(&words);
    assert_eq!(refused.code, 2);
    assert!(refused.err.contains("mckibben.c is not a file that `export` wrote"), "{}", refused.err);
    assert_eq!(fs::read_to_string(place.path().join("mckibben.c")).unwrap(), "int mine;\n");
    assert!(!place.path().join("mckibben.h").exists(), "nothing is half written");
}

#[test]
fn an_error_says_what_to_do() {
    let unknown = mckibben(&format!("{MUSCLE} simscape"));
    assert_eq!(unknown.code, 2);
    assert!(unknown.err.contains("c, python, csv, matlab, mjcf, fmu, opensim, xlsx"), "{}", unknown.err);
    let none = mckibben("export examples/prototype.toml");
    assert_eq!(none.code, 2);
    let weak = mckibben(&format!("{MUSCLE} c --contraction-low 10%"));
    assert_eq!(weak.code, 2);
    assert!(weak.err.contains("no box"), "{}", weak.err);
    let listed = json("export --list");
    assert_eq!(listed["targets"].as_array().unwrap().len(), 8);
}
