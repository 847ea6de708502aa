//! `export`: the folder, what it replaces, its errors.

use crate::common::{folder, json, mckibben, number, root, run};
use std::fs;
use std::path::Path;

const MUSCLE: &str = "export examples/prototype.toml --model thick-wall --as";

/// The words of `export --list`.
fn targets() -> Vec<String> {
    let listed = json("export --list");
    let words = listed["targets"].as_array().unwrap().iter();
    words.map(|target| target["name"].as_str().unwrap().to_owned()).collect()
}

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
fn a_folder_is_written() {
    let place = folder();
    let path = place.path().to_str().unwrap().to_owned();
    let words: Vec<&str> = MUSCLE.split(' ').chain(["c", "-o", &path]).collect();
    let printed = run(&words).ok();
    assert!(printed.text().contains("files are in"), "{}", printed.text());
    for name in ["mckibben.h", "mckibben.c", "muscle.h", "example.c"] {
        assert!(place.path().join(name).is_file(), "{name}");
    }
}

#[test]
fn an_error_says_what_to_do() {
    let unknown = mckibben(&format!("{MUSCLE} simscape"));
    assert_eq!(unknown.code, 2);
    assert!(unknown.err.contains(&targets().join(", ")), "{}", unknown.err);
    let none = mckibben("export examples/prototype.toml");
    assert_eq!(none.code, 2);
    let weak = mckibben(&format!("{MUSCLE} c --contraction-low 10%"));
    assert_eq!(weak.code, 2);
    assert!(weak.err.contains("no box"), "{}", weak.err);
}

/// A folder in a file cannot be made, and an existing file stays: for every target, nothing is written.
#[test]
fn what_cannot_be_written_whole_is_not_begun() {
    for target in targets() {
        let place = folder();
        let (file, inside) = (place.path().join("file"), place.path().join("folder"));
        fs::write(&file, "mine").unwrap();
        fs::create_dir(&inside).unwrap();
        let words = |path: &Path| -> Vec<String> {
            MUSCLE.split(' ').chain([&*target, "-o", path.to_str().unwrap()]).map(String::from).collect()
        };
        let refused = run(&words(&file.join("folder")));
        assert_ne!(refused.code, 0, "{target}");
        assert!(refused.err.contains("cannot write"), "{target}: {}", refused.err);
        let answer = json(&format!("{MUSCLE} {target}"));
        let last = answer["files"].as_array().unwrap().last().unwrap()["name"].as_str().unwrap().to_owned();
        fs::write(inside.join(&last), "mine").unwrap();
        let refused = run(&words(&inside));
        assert_eq!(refused.code, 2, "{target}");
        assert!(refused.err.contains(&last), "{target}: {}", refused.err);
        let left: Vec<_> = fs::read_dir(&inside).unwrap().map(|f| f.unwrap().file_name()).collect();
        assert_eq!(left, [&*last], "{target}");
        assert_eq!(fs::read(inside.join(&last)).unwrap(), b"mine", "{target}");
        assert_eq!(fs::read(&file).unwrap(), b"mine", "{target}");
    }
}

#[test]
fn the_table_of_the_docs_has_the_targets_of_the_list() {
    let text = fs::read_to_string(root().join("docs/exports.md")).unwrap();
    let rows = text.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next());
    let mut rows: Vec<&str> = rows.filter(|word| !word.starts_with('-')).collect();
    let mut listed = targets();
    rows.sort_unstable();
    listed.sort_unstable();
    assert_eq!(rows, listed);
}
