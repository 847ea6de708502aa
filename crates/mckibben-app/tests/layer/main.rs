//! What every front end relies on: names, schemas, the default model, words.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::too_many_lines
)]

mod annotate;
mod answers;
mod braid;
mod check;
mod colours;
mod contract;
mod design;
mod ended;
mod ends;
mod expected;
mod figures;
mod file_schema;
mod given;
mod identified;
mod liquid;
mod many;
mod measured;
mod measures;
mod messages;
mod muscle_fields;
mod named_model;
mod page;
mod paper;
mod parts;
mod points;
mod security;
mod sizes;
mod slack;
mod truth;
mod uncertainty;
mod units;
mod words;
mod written;

use mckibben_app::{DesignRequest, ForceRequest, Problem, ProblemKind, ask, design, force};
use mckibben_core::progress::{Progress, Silent};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

fn reply(command: &str, request: Value) -> Value {
    serde_json::from_str(&ask(command, &request.to_string(), &Silent).unwrap()).unwrap()
}

fn refusal(command: &str, request: Value) -> Problem {
    ask(command, &request.to_string(), &Silent).unwrap_err()
}

#[test]
fn a_request_in_json_is_the_request_in_rust() {
    let request = ForceRequest {
        pressure_mpa: Some(0.2.into()),
        contraction: Some(0.1.into()),
        ..Default::default()
    };
    let answer = force(&request).unwrap();
    let text = ask("force", &serde_json::to_string(&request).unwrap(), &Silent).unwrap();
    assert_eq!(text, serde_json::to_string(&answer).unwrap());
    assert_eq!(answer.point.model, "fe");
}

/// Progress that panics, on a thread that works, stands for a fault of the program.
#[test]
fn a_panic_is_a_problem_that_asks_for_a_report() {
    struct Faulty;
    impl Progress for Faulty {
        fn report(&self, done: usize, _: usize) {
            assert!(done < 2, "two are too many");
        }
    }
    let wanted = r#"{"force_n": 300, "contraction": 0.1, "model": "thick-wall"}"#;
    let problem = ask("design", wanted, &Faulty).unwrap_err();
    assert_eq!(serde_json::to_value(problem.kind).unwrap(), "internal");
    let said = &problem.message;
    assert!(said.contains(": two are too many"), "{said}");
    assert!(problem.hint.contains("report"), "{}", problem.hint);
    // The next request is answered.
    assert!(ask("design", wanted, &Silent).is_ok());
}

#[test]
fn words_of_the_contract_are_fields() {
    let point = reply(
        "force",
        json!({ "muscle": { "outer_diameter_mm": 40, "wall_mm": 2, "length_mm": 285, "angle_deg": 28, "rubber": "dragon-skin-30:mooney-rivlin", "stiffness": 600 }, "pressure_mpa": 0.2, "contraction": 0.1, "model": "thick-wall", "two_sided": true }),
    );
    assert_eq!(point["model"], "thick-wall");
    assert_eq!(point["muscle"]["braid"], "600 N/mm");
    for (word, name) in [
        ("inextensible", "inextensible"),
        ("antonelli2018", "antonelli2018"),
        ("paper", "antonelli2018"),
    ] {
        let point = reply(
            "force",
            json!({ "pressure_mpa": 0.2, "muscle": { "stiffness": word }, "model": "thick-wall" }),
        );
        assert_eq!(point["muscle"]["braid"], name);
    }
    let curve = reply(
        "curve",
        json!({ "test": "isobaric", "pressures_mpa": [0.2], "contractions": [0, 0.1] }),
    );
    assert_eq!(curve["points"].as_array().unwrap().len(), 2);
    let file = "[tube]\nouter_diameter = \"50 mm\"\nwall_thickness = \"1 mm\"\n";
    let shown = reply(
        "check",
        json!({ "only_data": true, "muscle": { "file": { "name": "mine.toml", "text": file }, "wall_mm": 2 } }),
    );
    assert_eq!(
        (&shown["outer_diameter_mm"], &shown["wall_mm"]),
        (&json!(50.0), &json!(2.0))
    );
}

#[test]
fn a_named_sleeve_gives_angle_and_stiffness_of_the_tube_that_it_is_on() {
    let name = "flexo-overexpanded-0.38in";
    let braid = json!({ "only_data": true, "muscle": { "outer_diameter_mm": 12, "wall_mm": 1, "braid": name } });
    let shown = reply("check", braid.clone());
    let sleeve = reply("parts-show", json!({ "name": name }))["sleeve"].take();
    let points = sleeve["points"].as_array().unwrap();
    let point = points
        .iter()
        .find(|point| point["outer_diameter_mm"] == 12.0)
        .unwrap();
    for key in ["angle_deg", "stiffness_n_per_mm"] {
        let (a, b) = (shown[key].as_f64().unwrap(), point[key].as_f64().unwrap());
        assert!((a / b - 1.0).abs() < 1e-12, "{key}: {a} {b}");
    }
    let mut thin = braid;
    thin["muscle"]["strand_diameter_mm"] = 0.25.into();
    let thin = reply("check", thin);
    assert!(
        thin["braid"]
            .as_str()
            .unwrap()
            .starts_with("flexo-overexpanded-0.38in, 232 strands, ")
    );
    assert_eq!(sleeve["strands_stated"], false);
    // Another tube over a file's sleeve.
    let file = "[tube]\nouter_diameter = 12\nwall_thickness = 1\n[braid]\nname \
        = \"nfl-19\"\nstiffness = 300\n";
    let text = file.replace("= 12", "= 20");
    let wider = reply(
        "check",
        json!({ "only_data": true, "muscle": { "file": { "name": "m.toml", "text": text }, "outer_diameter_mm": 25 } }),
    );
    assert!(
        (wider["angle_deg"].as_f64().unwrap() - 41.04).abs() < 0.01,
        "{wider}"
    );
    // What its seller does not state is an estimate, and marked as one.
    let estimated = reply(
        "check",
        json!({ "only_data": true, "muscle": { "outer_diameter_mm": 20, "braid": "nfl-19" } }),
    );
    assert_eq!(estimated["stiffness_factor"], 3.0);
}

/// An identity: fields say what a muscle file says, and what stands over a file completes it.
#[test]
fn fields_of_strands_ends_and_friction_are_those_of_a_muscle_file() {
    let text = "[braid]\nstrands = 96\nstrand_area = \"0.05 mm2\"\nstrand_modulus = \"8.5 \
        GPa\"\nstrand_strength = \"40 N\"\nthickness = \"0.4 mm\"\ndiameter = \"31 mm\"\ncrimp \
        = \"1 %\"\ncrimp_stiffness = 0.2\n[terminals]\ninsertion = \"15 \
        mm\"\n[friction]\ncoefficient = 40\nexponent = 0.7\nlever = \"2 mm\"\n";
    let fields = json!({ "muscle": { "strands": 96, "strand_area_mm2": 0.05, "strand_modulus_mpa": 8500, "strand_strength_n": 40, "braid_thickness_mm": 0.4, "braid_diameter_mm": 31, "crimp": 0.01, "crimp_stiffness": 0.2, "insertion_mm": 15, "friction_coefficient": 40, "friction_exponent": 0.7, "friction_lever_mm": 2 }, "muscle_file": true, "only_data": true });
    let file = |text: &str| json!({ "muscle": { "file": { "name": "m.toml", "text": text } }, "muscle_file": true, "only_data": true });
    let shown = |request: &Value| reply("check", request.clone());
    let (mine, theirs) = (shown(&fields), shown(&file(text)));
    assert_eq!(mine, theirs);
    for (field, value) in fields["muscle"]
        .as_object()
        .unwrap()
        .iter()
        .filter(|f| f.1.is_number())
    {
        assert_eq!(mine[field].as_f64(), value.as_f64(), "{field}");
    }
    let over = |field: &str, value: f64| {
        let mut request = file(text);
        request["muscle"][field] = json!(value);
        shown(&request)
    };
    // One of a pair suffices over a file that states the other.
    for (field, value, was, now) in [
        ("friction_exponent", 0.8, "exponent = 0.7", "exponent = 0.8"),
        (
            "crimp_stiffness",
            0.3,
            "crimp_stiffness = 0.2",
            "crimp_stiffness = 0.3",
        ),
        ("strands", 72.0, "strands = 96", "strands = 72"),
        ("strand_modulus_mpa", 3000.0, "\"8.5 GPa\"", "\"3 GPa\""),
    ] {
        assert_eq!(
            over(field, value),
            shown(&file(&text.replace(was, now))),
            "{field}"
        );
    }
}

/// The paper's braid beyond its diameters: said by every command that answers with warnings, once a
/// point.
#[test]
fn the_papers_braid_on_a_small_tube_is_a_warning_everywhere() {
    let small = json!({ "muscle": { "outer_diameter_mm": 20, "wall_mm": 1.5 }, "pressure_mpa": 0.2, "contraction": 0.1, "model": "thick-wall" });
    let said = |answer: &Value| {
        let warnings = answer["warnings"]
            .as_array()
            .unwrap()
            .iter()
            .map(|w| w["message"].as_str().unwrap());
        warnings
            .filter(|w| w.contains("30\u{a0}mm to 50\u{a0}mm"))
            .count()
    };
    assert_eq!(said(&reply("force", small.clone())), 1);
    let mut named = small.clone();
    named["muscle"]["stiffness"] = json!("inextensible");
    assert_eq!(said(&reply("force", named)), 0);
    assert_eq!(
        said(&reply(
            "check",
            json!({ "only_data": true, "muscle": { "outer_diameter_mm": 60 } })
        )),
        1
    );
    assert_eq!(
        said(&reply(
            "check",
            json!({ "only_data": true, "muscle": { "outer_diameter_mm": 50 } })
        )),
        0
    );
    let curve = reply(
        "curve",
        json!({ "muscle": { "outer_diameter_mm": 20, "wall_mm": 1.5 }, "test": "isobaric", "pressures_mpa": [0.2], "contractions": [0, 0.1], "model": "thick-wall" }),
    );
    assert!(
        curve["points"]
            .as_array()
            .unwrap()
            .iter()
            .all(|p| said(p) == 1)
    );
}

/// Wants the work to end at once.
struct Impatient;

impl Progress for Impatient {
    fn cancelled(&self) -> bool {
        true
    }
}

#[test]
fn long_work_can_be_cancelled() {
    let wanted = DesignRequest {
        force_n: Some(300.0.into()),
        contraction: Some(0.1.into()),
        max_pressure_mpa: Some(0.25.into()),
        ..Default::default()
    };
    assert_eq!(
        design(&wanted, &Impatient).unwrap_err().kind,
        ProblemKind::Cancelled
    );
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn sources(folder: &Path, out: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, out);
        } else if path.extension().is_some_and(|e| e == "rs") {
            out.push(path);
        }
    }
}

/// Sentences of the libraries hold in every front end: flags are words of the command line alone.
#[test]
fn no_sentence_of_a_library_speaks_of_flags() {
    for library in [
        "io", "fem", "fit", "design", "motion", "campaign", "app", "report",
    ]
    .map(|name| format!("mckibben-{name}"))
    .into_iter()
    .chain(["mckibben".into()])
    {
        let mut list = vec![];
        sources(&root().join("crates").join(library).join("src"), &mut list);
        for path in list {
            let text = std::fs::read_to_string(&path).unwrap();
            for (i, line) in text
                .lines()
                .enumerate()
                .filter(|l| !l.1.trim_start().starts_with("//"))
            {
                let flag = line.match_indices("--").any(|(at, _)| {
                    line[..at].ends_with([' ', '`', '"', '('])
                        && line[at + 2..].starts_with(|c: char| c.is_ascii_lowercase())
                });
                assert!(!flag, "{}:{}: {}", path.display(), i + 1, line.trim());
            }
        }
    }
}
