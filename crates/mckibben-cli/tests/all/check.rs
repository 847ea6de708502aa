//! `check`, `schema --file`, and the numbers of figures.

use crate::common::{folder, json, mckibben, number, run_in};

#[test]
fn a_check_names_what_to_measure_first() {
    let answer = json("check examples/prototype.toml -p 2bar");
    let kinds: Vec<&str> =
        answer["findings"].as_array().unwrap().iter().map(|f| f["kind"].as_str().unwrap()).collect();
    for kind in ["unknown", "outside", "measure"] {
        assert!(kinds.contains(&kind), "{kinds:?}");
    }
    // An identity: the blocked force and its ± are those of `force`.
    let (values, force) = (&answer["characteristics"], json("force examples/prototype.toml -p 2bar -e 0"));
    assert_eq!(number(values, "blocked_force_n"), number(&force, "force_n"));
    assert_eq!(number(values, "blocked_force_uncertainty_n"), number(&force, "uncertainty_n"));
    let text = mckibben("check examples/prototype.toml -p 2bar").ok();
    assert!(text.text().contains("10 points on both branches at 0.8 bar and 2 bar"), "{}", text.text());
    // A muscle whose friction was measured need not measure it again.
    let tondu = mckibben("check examples/tondu2012.toml -p 3bar").ok();
    assert!(!tondu.text().contains("friction unknown:"), "{}", tondu.text());
}

#[test]
fn the_schema_of_a_file_is_written_and_named() {
    let dir = folder();
    run_in(dir.path(), &["schema", "--file", "muscle", "-o", "muscle.schema.json"]).ok();
    let text = std::fs::read_to_string(dir.path().join("muscle.schema.json")).unwrap();
    let schema: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(schema["properties"]["tube"]["properties"]["outer_diameter"]["exclusiveMinimum"], 0.0);
    let line =
        ["design", "-F", "40N", "-e", "10%", "-p", "2.5bar", "--tube", "latex-1/4x3/8in", "-o", "m.toml"];
    run_in(dir.path(), &line).ok();
    let muscle = std::fs::read_to_string(dir.path().join("m.toml")).unwrap();
    assert_eq!(muscle.lines().nth(2), Some("#:schema muscle.schema.json"));
    assert_eq!(run_in(dir.path(), &["schema", "--file", "mussel"]).code, 2);
    // Of all commands, into a folder that is made for them.
    run_in(dir.path(), &["schema", "-o", "new/schemas"]).ok();
    assert!(dir.path().join("new/schemas/design.json").is_file());
}

#[test]
fn a_figure_has_its_numbers_beside_it() {
    let dir = folder();
    let words =
        "curve isobaric -D 50 -s 1 -p 1bar,2bar -e 0..0.2:0.05 --model paper --plot f.svg --plot-data f.csv";
    let line = |more: &str| {
        let words: Vec<String> = format!("{words} {more}").split_whitespace().map(str::to_owned).collect();
        run_in(dir.path(), &words)
    };
    line("").ok();
    let table = std::fs::read_to_string(dir.path().join("f.csv")).unwrap();
    let answer = json("force -D 50 -s 1 -p 1bar -e 0.1 --model paper");
    let row = table.lines().find(|row| row.contains("line") && row.contains(",0.1,")).unwrap();
    let pull: f64 = row.rsplit(',').next().unwrap().parse().unwrap();
    assert!((pull - number(&answer, "force_n")).abs() < 1e-9, "{row}");
    line("--overwrite").ok();
}
