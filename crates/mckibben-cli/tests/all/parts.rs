//! Parts that one can buy or cast: the catalogue, designs of them, and the ± of what is estimated.

use crate::common::{folder, mckibben, root, run_in};
use serde_json::Value;
use std::path::Path;

fn json(dir: &Path, line: &str) -> Value {
    let words: Vec<&str> = line.split_whitespace().chain(["--format", "json"]).collect();
    run_in(dir, &words).json()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

/// Across borders: the muscle file of a design answers `force` with the digits of the table, ± included.
#[test]
fn a_design_is_of_parts_and_its_muscle_file_has_its_digits() {
    let dir = folder();
    let found = json(dir.path(), "design -F 700N -e 15% -p 2.5bar -o winner.toml");
    let best = &found["candidates"][0];
    let tube = json(dir.path(), &format!("parts show {}", best["tube"].as_str().unwrap()))["tube"].clone();
    assert_eq!(tube["outer_diameter_mm"], best["outer_diameter_mm"]);
    assert_eq!(tube["rubber"], best["rubber"]);
    let sleeve = best["sleeve"].as_str().unwrap();
    let shown = json(dir.path(), &format!("parts show {sleeve}"))["sleeve"].take();
    assert!(number(&shown["stiffness_factor"]) >= 1.0 && shown["missing"] == serde_json::json!([]));
    let answer = json(dir.path(), "force winner.toml -p 2.5bar -e 15%");
    assert_eq!(answer["force_n"], best["points"][0]["force_at_max_pressure_n"]);
    assert_eq!(answer["burst_pressure_mpa"], best["burst_pressure_mpa"]);
    assert_eq!(answer["muscle"]["sleeve"], best["sleeve"]);
    assert!(number(&answer["uncertainty_parts_n"]["braid"]) > 0.0);
    // The supply is allowed: half of the pressure at which the tube fails, a quarter of that at which strands do.
    assert!(number(&best["allowed_pressure_mpa"]) >= 0.25);
    assert_eq!(answer["allowed_pressure_mpa"], best["allowed_pressure_mpa"]);
    assert_eq!(best["burst_by"], "mesh");
    assert_eq!(found["searched"]["burst_checked"], true);
}

/// By its own ±: the lower end of the pull meets the requirement, and a larger share asks for more.
#[test]
fn a_guaranteed_design_meets_the_requirement_with_the_lower_end_of_its_uncertainty() {
    let dir = folder();
    let line = "design -F 300N -e 12% -p 2.5bar --model universal --verify none";
    let plain = json(dir.path(), line);
    for (share, widths) in [("", 1.0), ("=99%", 2.575_829 / 1.959_964)] {
        let found = json(dir.path(), &format!("{line} --guaranteed{share} -o sure.toml --overwrite"));
        let best = &found["candidates"][0];
        assert!(number(&best["outer_diameter_mm"]) >= number(&plain["candidates"][0]["outer_diameter_mm"]));
        let answer = json(dir.path(), "force sure.toml -p 2.5bar -e 12% --model universal");
        let lower = number(&answer["force_n"]) - widths * number(&answer["uncertainty_n"]);
        assert!(lower >= 300.0 * (1.0 - 1e-9), "{share}: {lower}");
    }
    let shown = run_in(dir.path(), &format!("{line} --guaranteed").split_whitespace().collect::<Vec<_>>());
    let text = shown.text();
    assert!(text.contains("guaranteed: the lower end of the ± (95 %) meets it"), "{text}");
    let wrong =
        run_in(dir.path(), &format!("{line} --guaranteed=120%").split_whitespace().collect::<Vec<_>>());
    assert!(wrong.err.contains("usually 0.95"), "{}", wrong.err);
}

/// What names of the same rubber or muscle give is the same: a file, the paper's muscle, free measures.
#[test]
fn rubbers_come_from_names_hardness_data_sheets_and_files() {
    let dir = folder();
    let text = run_in(dir.path(), &["check", "--rubber", "dragon-skin-30", "-o", "x.json"]);
    assert!(text.err.is_empty(), "{}", text.err);
    std::fs::write(dir.path().join("mine.toml"), "[tube]\nrubber = \"dragon-skin-30\"\n").unwrap();
    let of = |rubber: &str| json(dir.path(), &format!("force -p 2bar -e 10% --rubber {rubber}"));
    assert_eq!(of("mine.toml")["force_n"], of("dragon-skin-30")["force_n"]);
    // μ = 0.1025 exp(0.0552·30)/3 = 0.17896 MPa and 0.6/1.75 = 0.34286 MPa by hand.
    for (rubber, mu) in [("shore:30A", 0.178_96), ("s100:0.6MPa", 0.342_86), ("latex", 0.37)] {
        let shown = json(dir.path(), &format!("check --rubber {rubber}"));
        assert!((number(&shown["shear_modulus_mpa"]) / mu - 1.0).abs() < 2e-4, "{rubber}");
        assert!(number(&of(rubber)["uncertainty_parts_n"]["rubber"]) > 0.0, "{rubber}");
    }
    let hard = run_in(dir.path(), &["force", "-p", "2bar", "--rubber", "shore:60A"]);
    assert!(hard.err.contains("10 A to 40 A"), "{}", hard.err);
}

#[test]
fn the_papers_muscle_and_free_measures_are_one_flag_away() {
    let free = json(&root(), "design -F 700N -e 15% -p 2.5bar --continuous --model universal --verify none");
    let paper =
        json(&root(), "design -F 700N -e 15% -p 2.5bar --muscle paper --model universal --verify none");
    assert_eq!(free["candidates"][0]["outer_diameter_mm"], paper["candidates"][0]["outer_diameter_mm"]);
    assert_eq!(free["candidates"][0]["rubber"], "paper");
    assert!(free["candidates"][0]["tube"].is_null());
}

#[test]
fn parts_are_listed_and_own_tubes_take_their_place() {
    let dir = folder();
    let all = json(dir.path(), "parts list");
    assert!(all["tubes"].as_array().unwrap().len() > 100 && all["sleeves"].as_array().unwrap().len() >= 10);
    assert!(json(dir.path(), "parts list rubbers")["tubes"].as_array().unwrap().is_empty());
    let own = "[[tube]]\nname = \"mine\"\ninner = 22\nouter = 26\nrubber = \"shore:30A\"\n";
    std::fs::write(dir.path().join("own.toml"), own).unwrap();
    let found =
        json(dir.path(), "design -F 200N -e 10% -p 2bar --parts own.toml --model universal --verify none");
    assert_eq!(found["candidates"][0]["tube"], "mine");
    let unknown = mckibben("parts show latex-1/4x3/8");
    assert!(unknown.err.contains("did you mean latex-1/4x3/8in?"), "{}", unknown.err);
    let unknown = mckibben("design -F 200N -e 10% -p 2bar --tube latex-1/4x3/8");
    assert!(unknown.err.contains("did you mean latex-1/4x3/8in?"), "{}", unknown.err);
    // A tube of a rubber that the list leaves out, by name; the assumption names its rubber, the paper's as well.
    let cast =
        mckibben("design -F 60N -e 15% -p 4bar --tube cast-8x12-rtv615 --model universal --verify none");
    assert!(cast.text().contains("1 tube of rtv615"), "{}", cast.text());
    let paper = mckibben("design -F 700N -e 15% -p 2.5bar --rubber paper --model universal --verify none");
    assert!(paper.text().contains("cast of paper with walls of at least 1 mm"), "{}", paper.text());
    // Free sizes leave no room for a tube as sold.
    let both = mckibben("design -F 60N -e 15% -p 4bar --tube latex-1/4x3/8in -D 10mm");
    assert!(both.err.contains("--tube has no effect: --outer-diameter asks for free sizes"), "{}", both.err);
}

/// A regression: the tables of pages are the answers to the commands above them.
#[test]
fn the_tables_of_pages_are_what_their_commands_print() {
    for (page, command) in [
        ("README.md", "design --force 700N --contraction 15% --max-pressure 2.5bar"),
        (
            "docs/models.md",
            "design -F 50N -e 15% --max-pressure 2.5bar --length 200 --liquid water --max-liquid 20mL",
        ),
    ] {
        let text = std::fs::read_to_string(root().join(page)).unwrap();
        let below = text.split(&format!("mckibben {command}\n")).nth(1).unwrap();
        let printed = below.split("```text\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
        let answer = mckibben(command).ok();
        let lines: Vec<&str> = printed.lines().filter(|l| !l.is_empty()).collect();
        assert!(lines.len() >= 8);
        for line in lines {
            assert!(answer.text().lines().any(|l| l == line), "{line}\n{}", answer.text());
        }
    }
}
