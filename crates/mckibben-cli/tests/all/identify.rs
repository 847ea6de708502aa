//! `identify` as a user meets it.

use crate::common::{folder, json, mckibben, number, root};
use serde_json::Value;

fn parameter<'a>(found: &'a Value, name: &str) -> &'a Value {
    let list = found["parameters"].as_array().unwrap();
    list.iter().find(|p| p["name"] == name).unwrap_or_else(|| panic!("{name}: {found}"))
}

fn identifiable(found: &Value, name: &str) -> bool {
    parameter(found, name)["identifiable"].as_bool().unwrap()
}

fn says(found: &Value, fragment: &str) -> bool {
    found["warnings"].as_array().unwrap().iter().any(|w| w.as_str().unwrap().contains(fragment))
}

/// A table in a folder of its own, and the error that it ends with.
fn refused(table: &str, flags: &str) -> (i32, Value) {
    let dir = folder();
    let path = dir.path().join("bench.csv");
    std::fs::write(&path, table).unwrap();
    let ran =
        mckibben(&format!("identify examples/bench.toml --data {} --format json {flags}", path.display()));
    (ran.code, ran.error())
}

const HEAD: &str = "pressure_bar,contraction,force_n\n";
const ROWS: [(f64, f64, f64); 6] = [
    (1.0, 0.0, 242.0),
    (2.0, 0.0, 482.0),
    (3.0, 0.0, 719.0),
    (2.0, 0.08, 250.0),
    (3.0, 0.08, 420.0),
    (3.0, 0.15, 249.0),
];

fn table(change: impl Fn((f64, f64, f64)) -> (f64, f64, f64)) -> String {
    let row = |r: &(f64, f64, f64)| {
        let (p, e, f) = change(*r);
        format!("{p},{e},{f}\n")
    };
    HEAD.to_owned() + &ROWS.iter().map(row).collect::<String>()
}

/// μ 0.4 MPa and k 900 N/mm made the points; the noise of 4 N is ours.
#[test]
fn the_bench_example_finds_what_made_its_points() {
    let dir = folder();
    let out = dir.path().join("found.toml");
    let found = json(&format!("identify examples/bench.toml --data examples/bench.csv -o {}", out.display()));
    for (name, truth, unit) in [("tube.material.mu", 0.4, "MPa"), ("braid.stiffness", 900.0, "N/mm")] {
        let p = parameter(&found, name);
        assert!(identifiable(&found, name) && p["unit"] == unit, "{p}");
        assert!((number(p, "value") - truth).abs() <= number(p, "half_width_95"), "{p}");
        assert!(number(p, "standard_error") > 0.0);
    }
    assert!((2.0..6.0).contains(&number(&found, "rms_n")));
    assert_eq!(found["points"].as_array().unwrap().len(), 10);
    // The file is a muscle with these values.
    let shown = json(&format!("force --muscle {} -p 3bar -e 0 --model fe", out.display()));
    assert!((number(&shown, "force_n") - 718.6).abs() < 10.0, "{shown}");
    let text = std::fs::read_to_string(&out).unwrap();
    assert!(text.starts_with("# Identified from examples/bench.csv with the model fe:"), "{text}");
}

/// What C10 and C01 do apart is too small for 25 points of one thin-walled muscle.
#[test]
fn table_1_does_not_tell_c01() {
    let found = json("identify -D 50 -s 1 --data data/paper/table1.csv --free c10,c01,braid.stiffness");
    assert!(!identifiable(&found, "tube.material.c01") && identifiable(&found, "braid.stiffness"), "{found}");
    assert!(says(&found, "tube.material.c10 and tube.material.c01 move against each other"), "{found}");
    let found = json("identify -D 50 -s 1 --data data/paper/table1.csv --free c10,braid.stiffness");
    assert!(identifiable(&found, "tube.material.c10"), "{found}");
}

/// Fig. 3 of B. Tondu (2012): its loops' half-widths alone give C 71.5 and β 0.560 (examples/tondu2012.toml).
#[test]
fn both_branches_give_the_friction_of_the_loops() {
    let found = json("identify examples/tondu2012.toml --data data/tondu2012/static_force_20deg.csv");
    for (name, alone) in [("friction.coefficient", 71.46), ("friction.exponent", 0.56)] {
        let p = parameter(&found, name);
        assert!((number(p, "value") - alone).abs() <= number(p, "half_width_95"), "{p}");
    }
    assert!(says(&found, "follow a pattern"), "{found}");
    // The thick wall comes to what `compare --fit` says.
    let thick = json(
        "identify examples/tondu2012.toml --data data/tondu2012/static_force_20deg.csv --branches mean \
         --two-sided --model thick-wall --free modulus,end-factor",
    );
    assert!((number(&thick, "rms_n") - 5.95).abs() < 0.1, "{thick}");
    assert!((number(parameter(&thick, "terminals.end_factor"), "value") - 1.118).abs() < 0.003);
}

#[test]
fn a_formula_is_data_too() {
    let found =
        json("identify --formula paper -D 40,50 -s 1..3:1 -p 0.1,0.2 -e 0,10% --free c10,braid.stiffness");
    assert_eq!(found["points"].as_array().unwrap().len(), 24);
    assert!((0.08..0.16).contains(&number(parameter(&found, "tube.material.c10"), "value")), "{found}");
    let csv = mckibben("identify --formula paper -p 0.1,0.2 -e 0,10% --free c10 --format csv").ok();
    let head: Vec<&str> = csv.text().lines().next().unwrap().split(',').collect();
    for column in
        ["outer_diameter_mm", "pressure_mpa", "contraction", "force_n", "model_force_n", "residual_n"]
    {
        assert!(head.contains(&column), "{column}: {head:?}");
    }
    assert_eq!(csv.text().lines().count(), 5);
}

#[test]
fn data_that_cannot_be_right_are_refused_with_the_reason() {
    let cases = [
        (table(|(p, e, f)| (p, e, 1000.0 * f)), "", "is force_n in mN"),
        (table(|(p, e, f)| (p, e, f / 9.81)), "", "kgf"),
        (table(|(p, e, f)| (100.0 * p, e, f)), "", "name the column pressure_bar"),
        (table(|(p, e, f)| (p, 100.0 * e, f)), "", "contraction_percent"),
        (table(|(p, e, _)| (p, e, 0.0)), "", "(6 more points without a measured force were left out)"),
        (format!("{HEAD}1,0,242\n2,0,482\n"), "--free mu,braid.stiffness", "at least 3 are needed"),
        (table(|r| r), "--free mo", "cannot be identified"),
        (table(|r| r), "--free mu,mu", "named twice"),
        (table(|r| r), "--free mu --fix mu=3", "named twice"),
        (table(|r| r), "--free mu=1:2:3", "must lie between"),
        (table(|r| r), "--fix mu", "has no value"),
        (table(|r| r), "--bounds mu=0.1:1", "is not free"),
        (table(|r| r), "--stiffness inextensible --free braid.stiffness", "write braid.stiffness=START"),
        (table(|r| r), "--weights 1,2", "2 numbers for 1 sets"),
        (table(|r| r), "--model festo", "no model"),
    ];
    for (table, flags, fragment) in cases {
        let (code, error) = refused(&table, flags);
        assert_eq!(code, 2, "{flags}: {error}");
        assert!(error["message"].as_str().unwrap().contains(fragment), "{flags} {fragment}: {error}");
    }
    let none = mckibben("identify examples/bench.toml --format json");
    assert!(none.code == 2 && none.error()["hint"].as_str().unwrap().contains("--data"), "{none:?}");
}

#[test]
fn bounds_fixes_and_weights_do_what_they_say() {
    let base = "identify examples/bench.toml --data examples/bench.csv";
    let held = json(&format!("{base} --free mu --fix braid.stiffness=900"));
    assert!((number(parameter(&held, "tube.material.mu"), "value") - 0.4).abs() < 0.02, "{held}");
    let bound = json(&format!("{base} --free mu,braid.stiffness --bounds mu=0.2:0.38"));
    assert!(!identifiable(&bound, "tube.material.mu") && says(&bound, "is at its bound"), "{bound}");
    let twice = json(&format!("{base} --data examples/bench.csv --weights 1,0 --free mu,braid.stiffness"));
    let once = json(&format!("{base} --free mu,braid.stiffness"));
    assert_eq!(
        number(parameter(&twice, "tube.material.mu"), "value"),
        number(parameter(&once, "tube.material.mu"), "value")
    );
}

/// `data/paper` against the tables that the program carries: F = a ε² + b ε + c, and formula (11).
#[test]
fn the_papers_points_are_its_tables() {
    let rows = |path: &str| -> Vec<Vec<f64>> {
        let text = std::fs::read_to_string(root().join(path)).unwrap();
        let lines = text.lines().filter(|l| l.starts_with(|c: char| c.is_ascii_digit()));
        lines.map(|l| l.split(',').map(|v| v.parse().unwrap()).collect()).collect()
    };
    let table = rows("crates/mckibben/data/table1.csv");
    let points = rows("data/paper/table1.csv");
    assert_eq!(points.len(), 25);
    for p in points {
        let abc = table.iter().find(|t| t[0] == p[4]).unwrap();
        assert!(((abc[1] * p[5] + abc[2]) * p[5] + abc[3] - p[6]).abs() < 1e-3, "{p:?}");
    }
    let points = rows("data/paper/formula11.csv");
    assert_eq!(points.len(), 500);
    for p in points.iter().step_by(7) {
        let force =
            json(&format!("force -D {} -s {} -p {} -e {} --model paper --two-sided", p[0], p[1], p[4], p[5]));
        assert!((number(&force, "force_n") - p[6]).abs() < 1e-3, "{p:?}");
    }
}
