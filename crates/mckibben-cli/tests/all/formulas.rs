//! Formulas as a user meets them: fitted, shown, and asked like any other model.

use crate::common::{Ran, assert_finite, folder, number, root, run_in};
use std::path::Path;

fn table() -> String {
    root().join("data/campaign/paper.csv").display().to_string()
}

/// Fits into `name` in a folder.
fn fitted(dir: &Path, method: &str, name: &str) -> serde_json::Value {
    let table = table();
    let args = ["fit", &table, "--method", method, "--hold-out", "35", "-o", name, "--format", "json"];
    run_in(dir, &args).ok().json()
}

fn asked(dir: &Path, line: &str) -> Ran {
    run_in(dir, &line.split_whitespace().collect::<Vec<_>>())
}

#[test]
fn a_fitted_formula_is_a_model_of_every_command() {
    let dir = folder();
    let global = fitted(dir.path(), "global", "g.json");
    assert_eq!(global["kind"], "global");
    assert!(number(&global["errors"]["held_out"], "max_of_blocked") < 0.004);
    let text = std::fs::read_to_string(dir.path().join("g.json")).unwrap();
    assert_eq!(serde_json::from_str::<serde_json::Value>(&text).unwrap(), global);
    let muscle = "-D 35 -s 2";
    let ours =
        asked(dir.path(), &format!("force {muscle} -p 0.2 -e 0.1 --model g.json --format json")).ok().json();
    let fe = asked(dir.path(), &format!("force {muscle} -p 0.2 -e 0.1 --model fe --format json")).ok().json();
    assert_eq!(ours["model"], "global");
    // 0.4 % of the blocked force, which is about 1.3 kN.
    assert!((number(&ours, "force_n") - number(&fe, "force_n")).abs() < 5.0, "{ours} {fe}");
    assert!(number(&ours, "uncertainty_n") > 0.0);
    assert!(ours.get("start_pressure_mpa").is_none(), "P′ lies below its lowest pressure: {ours}");
    std::fs::copy(dir.path().join("g.json"), dir.path().join("plain")).unwrap();
    for line in [
        format!("force {muscle} -p 0.2 --model plain"),
        format!("pressure {muscle} -F 300N -e 0.05 --model g.json"),
        format!("contraction {muscle} -F 300N -p 0.2 --model ./g.json"),
        format!("curve isobaric {muscle} --model g.json"),
        format!("compare {muscle} --models fe,g.json,paper -p 0.1,0.2"),
        format!("check {muscle} -p 0.2 --model g.json"),
        "design --force 700N --contraction 15% --max-pressure 2.5bar --model g.json".into(),
        "check g.json".into(),
        "check g.json --latex".into(),
        "check g.json --format csv".into(),
    ] {
        let text = asked(dir.path(), &line).ok();
        assert_finite(text.text());
    }
    for (line, part) in [
        ("force -D 60 -p 0.2 --model g.json", "outer_diameter 60"),
        ("force -D 40 -p 0.3 --model g.json", "pressure 0.3"),
        ("force -D 40 -p 0.2 --rubber dragon-skin-30 --model g.json", "dragon-skin-30"),
    ] {
        let refused = asked(dir.path(), &format!("{line} --format json"));
        assert_eq!((refused.code, refused.error()["kind"].as_str()), (2, Some("out_of_range")));
        assert!(refused.err.contains(part), "{}", refused.err);
    }
}

#[test]
fn the_papers_method_writes_its_tables_and_figures() {
    let dir = folder();
    let table = table();
    let args = ["fit", &table, "--hold-out", "35", "-o", "f.json", "--tables", "t/x", "--plots", "p"];
    let shown = run_in(dir.path(), &args).ok();
    for part in ["held out: D0 35", "a rises with P", "left out: D0 < 35", "Smallest R²"] {
        assert!(shown.text().contains(part), "{}", shown.text());
    }
    let count = |name: &str| std::fs::read_dir(dir.path().join(name)).unwrap().count();
    assert_eq!((count("t/x"), count("p")), (6, 8));
    let rows =
        |name: &str| std::fs::read_to_string(dir.path().join("t/x").join(name)).unwrap().lines().count();
    assert_eq!((rows("steps_1_2_abc.csv"), rows("steps_6_7_table2.csv")), (101, 19));
    let formula = asked(dir.path(), "check f.json --format json").ok().json();
    assert_eq!(formula["terms"].as_array().unwrap().len(), 48);
    assert!(number(&formula["errors"]["held_out"], "max_of_blocked") < 0.06);
}

/// The same formula comes out of a campaign in Parquet as from nothing but its points in CSV, and says which plan it is from.
#[test]
fn a_campaign_becomes_a_formula() {
    let dir = folder();
    let plan = root().join("plans/paper.toml");
    let ran = asked(dir.path(), &format!("campaign {} -o c.parquet --quiet", plan.display()));
    assert_eq!(ran.code, 0, "{}", ran.err);
    let fit = asked(dir.path(), "fit c.parquet --method paper -o c.json");
    assert_eq!(fit.code, 0, "{}", fit.err);
    fitted(dir.path(), "paper", "f.json");
    let read = |name: &str| -> serde_json::Value {
        serde_json::from_str(&std::fs::read_to_string(dir.path().join(name)).unwrap()).unwrap()
    };
    let (from_campaign, from_csv) = (read("c.json"), read("f.json"));
    assert_eq!(
        from_campaign["provenance"]["plan_hash"].as_str().map(str::len),
        Some(64),
        "{}",
        from_campaign["provenance"]
    );
    let force = |name: &str| {
        let line = format!("force -D 40 -s 2 -p 0.2 -e 0.1 --model {name} --format json");
        asked(dir.path(), &line).ok().json()["force_n"].as_f64().unwrap()
    };
    assert!(
        (force("c.json") / force("f.json") - 1.0).abs() < 1e-5,
        "{} {}",
        force("c.json"),
        force("f.json")
    );
    assert_eq!(from_campaign["kind"], from_csv["kind"]);
}

#[test]
fn wrong_tables_and_formulas_are_named() {
    let dir = folder();
    let good = std::fs::read_to_string(root().join("data/campaign/paper.csv")).unwrap();
    fitted(dir.path(), "paper", "f.json");
    let formula = std::fs::read_to_string(dir.path().join("f.json")).unwrap();
    let put = |name: &str, text: &str| std::fs::write(dir.path().join(name), text).unwrap();
    put("column.csv", &good.replace("wall_mm", "wall"));
    put("number.csv", &good.replacen("205.14", "much", 1));
    put("infinite.csv", &good.replacen("205.14913", "inf", 1));
    put("gone.csv", &good.replace("wall_mm", "thickness of the wall"));
    put("percent.csv", &good.replacen("0.1,0,", "0.1,5,", 1));
    put("kpa.csv", &good.replacen(",0.25,0,", ",250,0,", 1));
    put("twice.csv", &good.replacen("length_mm", "wall_mm", 1));
    put("short.csv", &good.lines().take(40).map(|l| format!("{l}\n")).collect::<String>());
    put("mixed.csv", &good.replacen("30,1,285", "30,1,300", 1));
    put("empty.csv", good.lines().next().unwrap());
    put("cut.json", &formula[..formula.len() / 2]);
    put("key.json", &formula.replace("\"range\"", "\"rage\""));
    put("nan.json", &formula.replacen("\"value\": ", "\"value\": NaN", 1));
    put("term.json", &formula.replace("\"B33\"", "\"B77\""));
    for (line, kind, parts) in [
        ("fit column.csv", "data", ["column.csv", "column wall does not state its unit"]),
        ("fit number.csv", "data", ["line 2, column force_n", "\"much913\" is not a finite number"]),
        ("fit infinite.csv", "data", ["line 2", "inf"]),
        ("fit short.csv", "fit", ["short.csv", "outer_diameter_mm"]),
        ("fit mixed.csv", "fit", ["length_mm", "285 to 300"]),
        ("fit empty.csv", "data", ["empty.csv", "no points"]),
        ("fit gone.csv", "data", ["gone.csv", "line 2: wall_mm is missing"]),
        ("fit percent.csv", "data", ["line 3, column contraction: 5 is no", "0.15 for 15 %"]),
        ("fit kpa.csv", "data", ["column pressure_mpa: 250 is too high", "unit"]),
        ("fit twice.csv", "data", ["wall_mm", "could all be wall"]),
        ("fit none.csv", "file", ["none.csv", "cannot be read"]),
        ("fit .", "file", ["is not a campaign", "no part"]),
        ("check cut.json", "formula", ["cut.json", "is not valid JSON"]),
        ("force -p 0.1 --model cut.json", "formula", ["cut.json", "is not valid JSON"]),
        ("force -p 0.1 --model key.json", "formula", ["key.json", "`range` is missing"]),
        ("force -p 0.1 --model nan.json", "formula", ["nan.json", "is not valid JSON"]),
        ("force -p 0.1 --model term.json", "formula", ["term.json", "B77"]),
        ("force -p 0.1 --model none.json", "formula", ["none.json", "cannot be read"]),
    ] {
        let result = asked(dir.path(), &format!("{line} --format json"));
        assert_eq!(result.code, 2, "{line}: {}", result.err);
        let error = result.error();
        assert_eq!(error["kind"], kind, "{line}: {error}");
        for part in parts {
            assert!(error["message"].as_str().unwrap().contains(part), "{line}: {error}");
        }
    }
    let table = table();
    for extra in [["--hold-out", "36"], ["--method", "cubic"], ["--name", "paper"], ["--name", " "]] {
        assert_eq!(run_in(dir.path(), &[&["fit", &table][..], &extra[..]].concat()).code, 2, "{extra:?}");
    }
    let tables = run_in(dir.path(), &["fit", &table, "--method", "global", "--tables", "t"]);
    assert!(tables.code == 2 && tables.err.contains("--tables"), "{}", tables.err);
}
