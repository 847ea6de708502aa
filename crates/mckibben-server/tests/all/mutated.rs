//! Files and requests as nobody means them: an answer or a problem with its reason, in good time, and never the program's own fault.
//!
//! A few by default; `MCKIBBEN_ROUNDS` says how many (24,000 of each take half an hour).

use mckibben::cancel::Cancel;
use mckibben::progress::Silent;
use mckibben_app::{COMMANDS, ProblemKind, ask_value, schema};
use serde_json::{Map, Value, json};
use std::path::Path;
use std::time::{Duration, Instant};

/// After half a second the caller of each leaves; a second for its end, and as much again on busy machines.
const PATIENCE: Duration = Duration::from_millis(2500);

/// Steele, Lea & Flood's SplitMix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() % n.max(1) as u64) as usize
    }

    fn one<'a, T>(&mut self, list: &'a [T]) -> &'a T {
        &list[self.below(list.len())]
    }
}

fn rounds(usual: usize) -> usize {
    std::env::var("MCKIBBEN_ROUNDS").map_or(usual, |text| text.parse().unwrap())
}

fn answered(command: &str, request: &Value) {
    let from = Instant::now();
    let cancel = Cancel::default();
    let leaves = cancel.clone();
    std::thread::spawn(move || {
        std::thread::sleep(Duration::from_millis(500));
        leaves.cancel();
    });
    let _entered = cancel.enter();
    let answer = ask_value(command, request.clone(), &Silent);
    let took = from.elapsed();
    if let Err(problem) = answer {
        assert_ne!(problem.kind, ProblemKind::Internal, "{command}: {problem}\n{request}");
    }
    assert!(took < PATIENCE, "{command}: {took:?}\n{request}");
}

const TOKENS: [&str; 28] = [
    "1e308",
    "-1e308",
    "1e-320",
    "nan",
    "inf",
    "-1",
    "0",
    "-0",
    "99999999999999999999",
    "1e200 mm",
    "0x10",
    "½",
    "\u{0}",
    "\u{feff}",
    "é",
    "\"",
    "'",
    "[",
    "]",
    "{",
    "}",
    "=",
    ",",
    "..",
    ":",
    "\n",
    "#",
    "1e99999",
];

/// A text with one to four changes.
fn mutated(text: &str, random: &mut Random) -> String {
    let mut chars: Vec<char> = text.chars().collect();
    for _ in 0..=random.below(4) {
        let (at, length) = (random.below(chars.len() + 1), 1 + random.below(12));
        let end = (at + length).min(chars.len());
        let digits: Vec<usize> = (0..chars.len()).filter(|i| chars[*i].is_ascii_digit()).collect();
        match random.below(7) {
            0 => drop(chars.drain(at..end)),
            1 => chars.splice(at..at, random.one(&TOKENS).chars()).for_each(drop),
            2 => chars.splice(at..end, random.one(&TOKENS).chars()).for_each(drop),
            3 => {
                let again: Vec<char> = chars[at..end].to_vec();
                chars.splice(at..at, again).for_each(drop);
            }
            4 => chars.truncate(at.max(1)),
            // Numbers are what files are made of.
            _ if !digits.is_empty() => {
                let place = *random.one(&digits);
                chars.splice(place..=place, random.one(&TOKENS).chars()).for_each(drop);
            }
            _ => {}
        }
    }
    chars.into_iter().collect()
}

fn example(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// A kind of file: its text, and the request that has it.
type Kind = (&'static str, String, fn(Value) -> Value);

fn kinds() -> Vec<Kind> {
    let formula = mckibben_app::ask_value("formula-show", json!({ "name": "universal" }), &Silent).unwrap();
    let tension = "mode,stretch,stress_mpa\nuniaxial,1.1,0.1\nuniaxial,1.5,0.3\nuniaxial,2,0.5\nuniaxial,3,0.9\nbiaxial,1.2,0.3\n";
    let history = "time_s,stretch,stress_mpa\n0,1,0\n1,1.5,0.4\n2,2,0.7\n3,1.5,0.3\n4,1,0\n5,1.5,0.35\n6,2,0.65\n7,2.2,0.8\n";
    let plan = "name = \"p\"\n[sampling]\nmethod = \"factorial\"\n[vary]\ntube.outer_diameter = \"30,40 mm\"\n\
                [test]\ncontractions = \"0,10%\"\npressures = \"0.1,0.2 MPa\"\n";
    let load = "shortening_mm,force_n\n0,100\n20,150\n50,180\n100,220\n";
    let paper: String =
        example("data/campaign/paper.csv").lines().take(400).map(|line| line.to_owned() + "\n").collect();
    fn named(name: &str, text: Value) -> Value {
        json!({ "name": name, "text": text })
    }
    vec![
        (
            "force",
            example("examples/prototype.toml"),
            |t| json!({ "muscle": named("m.toml", t), "pressure_mpa": 0.2, "contraction": 0.1, "model": "thick-wall" }),
        ),
        ("muscle-show", example("examples/festo-dmsp-20.toml"), |t| json!({ "muscle": named("m.toml", t) })),
        ("joint", example("examples/elbow.toml"), |t| {
            let muscle = named("biceps.toml", example("examples/biceps.toml").into());
            json!({ "joint": named("j.toml", t), "muscles": [muscle, muscle], "model": "ideal", "pressures_mpa": [0.2, 0.1] })
        }),
        (
            "motion",
            example("examples/drive.toml"),
            |t| json!({ "drive": named("d.toml", t), "muscle": named("prototype.toml", example("examples/prototype.toml").into()), "model": "ideal" }),
        ),
        ("plan", plan.into(), |t| json!({ "plan": named("p.toml", t) })),
        ("formula-show", formula.to_string(), |t| json!({ "file": named("f.json", t) })),
        (
            "force",
            formula.to_string(),
            |t| json!({ "formulas": [named("f.json", t)], "model": "f.json", "pressure_mpa": 0.2, "contraction": 0.1 }),
        ),
        (
            "compare",
            example("examples/bench.csv"),
            |t| json!({ "models": ["ideal", "thick-wall"], "data": named("b.csv", t) }),
        ),
        (
            "identify",
            example("examples/bench.csv"),
            |t| json!({ "data": [named("b.csv", t)], "model": "thick-wall", "free": ["braid.stiffness"] }),
        ),
        ("fit", paper, |t| json!({ "table": named("t.csv", t), "method": "global", "terms": 4 })),
        (
            "life",
            "stretch,cycles\n1.2,1e7\n2,1e5\n3,1e4\n".into(),
            |t| json!({ "model": "thick-wall", "pressures_mpa": [0.1, 0.2], "contractions": [0, 0.1], "life_curve": named("l.csv", t), "scatter": 3 }),
        ),
        ("rubber-fit", tension.into(), |t| json!({ "data": named("t.csv", t), "laws": ["yeoh"] })),
        (
            "rubber-fit",
            history.into(),
            |t| json!({ "data": named("h.csv", t), "laws": ["neo-hookean"], "softening": true }),
        ),
        (
            "curve",
            load.into(),
            |t| json!({ "test": "isobaric", "model": "ideal", "pressures_mpa": [0.2], "load": "table:l.csv", "load_tables": [named("l.csv", t)] }),
        ),
    ]
}

#[test]
fn files_that_were_changed_anywhere_give_an_answer_or_a_reason() {
    let kinds = kinds();
    let mut random = Random(1);
    for i in 0..rounds(130) {
        let (command, text, request) = &kinds[i % kinds.len()];
        answered(command, &request(mutated(text, &mut random).into()));
    }
}

/// A value that a field may hold, or nearly.
fn value(schema: &Value, defs: &Value, random: &mut Random, depth: usize) -> Value {
    const NUMBERS: [f64; 14] =
        [0.0, -0.0, 1.0, -1.0, 0.1, 0.25, 30.0, 300.0, 28.0, 1e308, -1e308, 1e-320, 1e9, 4.5e15];
    if random.below(12) == 0 {
        let odd = [
            json!(null),
            json!("x"),
            json!(-1),
            json!(1e300),
            json!([]),
            json!({}),
            json!(true),
            json!([[1]]),
        ];
        return random.one(&odd).clone();
    }
    if let Some(reference) = schema["$ref"].as_str() {
        let name = reference.rsplit('/').next().unwrap_or_default();
        return if depth > 4 { Value::Null } else { value(&defs[name], defs, random, depth + 1) };
    }
    for choices in ["anyOf", "oneOf"] {
        if let Some(list) = schema[choices].as_array() {
            return value(random.one(list), defs, random, depth + 1);
        }
    }
    if let Some(list) = schema["enum"].as_array() {
        return random.one(list).clone();
    }
    if !schema["const"].is_null() {
        return schema["const"].clone();
    }
    let kind = match &schema["type"] {
        Value::Array(list) => random.one(list).clone(),
        one => one.clone(),
    };
    match kind.as_str().unwrap_or_default() {
        "number" => json!(random.one(&NUMBERS)),
        "integer" => json!(random.one(&[0_i64, 1, 2, 3, 7, 20, 1000, -1, i64::MAX])),
        "boolean" => json!(random.below(2) == 0),
        "array" => (0..random.below(4)).map(|_| value(&schema["items"], defs, random, depth + 1)).collect(),
        "object" => {
            let fields = schema["properties"].as_object().into_iter().flatten();
            fields.map(|(name, schema)| (name.clone(), value(schema, defs, random, depth + 1))).collect()
        }
        "string" => {
            let words = [
                "",
                "ideal",
                "thick-wall",
                "fe",
                "paper",
                "universal",
                "dragon-skin-30",
                "mass:5kg",
                "spring:5N/mm",
                "bar",
                "0.2 MPa",
                "1x4",
                "é",
                "\u{0}",
                "table:x.csv",
            ];
            json!(random.one(&words))
        }
        _ => Value::Null,
    }
}

#[test]
fn requests_made_up_from_the_schemas_give_an_answer_or_a_reason() {
    let folder = tempfile::tempdir().unwrap();
    let missing = folder.path().join("nothing");
    let schemas: Vec<(&str, Value)> =
        COMMANDS.iter().map(|c| (c.name, schema(c.name).unwrap()["request"].take())).collect();
    let mut random = Random(2);
    for i in 0..rounds(160) {
        let (command, schema) = &schemas[i % schemas.len()];
        let defs = &schema["$defs"];
        let mut request = Map::new();
        for (name, field) in schema["properties"].as_object().into_iter().flatten() {
            // Most fields are left out, as people do.
            if random.below(4) == 0 || ["pressure_mpa", "contraction"].contains(&name.as_str()) {
                request.insert(name.clone(), value(field, defs, &mut random, 0));
            }
        }
        // What touches the disk touches nothing here.
        for path in ["campaign", "output", "folders"] {
            if let Some(path) = request.get_mut(path) {
                *path = if path.is_array() { json!([missing]) } else { json!(missing.join("no/such")) };
            }
        }
        answered(command, &Value::Object(request));
    }
}
