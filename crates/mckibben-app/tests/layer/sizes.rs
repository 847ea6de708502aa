//! Every number of muscle, joint and drive files, far too large, far too small, zero and negative:
//! an answer of finite numbers, or a problem with its reason.

use mckibben_app::{
    ForceRequest, JointRequest, MotionRequest, MuscleFields, Problem, ProblemKind, TextFile,
};
use mckibben_core::progress::Silent;
use serde_json::Value;

const SIZES: [&str; 8] = [
    "1e200", "1e-200", "1e308", "1e25", "1e-25", "0", "-1", "-1e25",
];

const MUSCLE: &str = r#"
[tube]
outer_diameter = "20 mm"
wall_thickness = "1.5 mm"
length = "220 mm"
[tube.material]
law = "yeoh"
c10 = "0.1 MPa"
c20 = "0.004 MPa"
c30 = "0.0001 MPa"
[braid]
angle = "24 deg"
strands = 96
strand_diameter = "0.25 mm"
strand_modulus = "8.5 GPa"
strand_strength = "40 N"
thickness = "0.4 mm"
diameter = "20.5 mm"
[terminals]
insertion = "15 mm"
seating = "0.5 mm"
slip = "0.001 mm/N"
grip = "2 mm"
[friction]
coefficient = 20
exponent = 0.7
"#;

const JOINT: &str = r#"
[joint]
radius = "20 mm"
range = "-45..45 deg"
inertia = "0.02 kg m2"
damping = "0.3 N m s/rad"
[link]
mass = "1.2 kg"
centre = "150 mm"
inclination = "-90 deg"
[muscle_1]
file = "m.toml"
contraction_at_neutral = "8%"
[muscle_2]
file = "m.toml"
contraction_at_neutral = "8%"
"#;

const DRIVE: &str = r#"
muscle = "m.toml"
[supply]
pressure = "6 bar"
temperature = "20 degC"
[valve]
sonic_conductance = "0.5 L/(s bar)"
critical_ratio = 0.3
exhaust_conductance = "0.4 L/(s bar)"
exhaust_critical_ratio = 0.3
lag = "5 ms"
wide_open_at = "0.5 bar"
hose_length = "500 mm"
hose_diameter = "4 mm"
[air]
dead_volume = "10 cm3"
[load]
mass = "5 kg"
damping = "200 N s/m"
[friction]
presliding = "0.5 mm"
[command]
pressure = "2 bar"
until = "0.05 s"
output_step = "0.001 s"
"#;

/// The keys of a text with their sections.
fn keys(text: &str) -> Vec<(String, String)> {
    let mut section = String::new();
    let mut out = vec![];
    for line in text.lines() {
        if let Some(name) = line.strip_prefix('[') {
            section = name.trim_end_matches(']').to_owned();
        } else if let Some((key, _)) = line.split_once(" = ")
            && !["file", "law", "muscle"].contains(&key)
        {
            out.push((section.clone(), key.to_owned()));
        }
    }
    out
}

/// The text with another value at a key, in the unit that stood there.
fn with(text: &str, (section, key): &(String, String), size: &str) -> String {
    let mut at = String::new();
    let lines = text.lines().map(|line| {
        if let Some(name) = line.strip_prefix('[') {
            at = name.trim_end_matches(']').to_owned();
        }
        match line.split_once(" = ") {
            Some((k, old)) if at == *section && k == key => {
                let unit: String = old
                    .trim_matches('"')
                    .split_once(' ')
                    .map_or(String::new(), |u| format!(" {}", u.1));
                let value = if old.contains("..") {
                    format!("{size}..{size}{unit}")
                } else {
                    format!("{size}{unit}")
                };
                if old.starts_with('"') {
                    format!("{k} = \"{value}\"")
                } else {
                    format!("{k} = {value}")
                }
            }
            _ => line.to_owned(),
        }
    });
    lines.collect::<Vec<_>>().join("\n")
}

fn file(name: &str, text: &str) -> TextFile {
    TextFile {
        name: name.into(),
        text: text.into(),
    }
}

fn judged<T: serde::Serialize>(work: &dyn Fn() -> Result<T, Problem>, said: &str) {
    let done = std::panic::catch_unwind(std::panic::AssertUnwindSafe(work));
    match done.unwrap_or_else(|_| panic!("panic: {said}")) {
        Ok(answer) => {
            let numbers = serde_json::to_value(&answer).unwrap();
            // A number that is none is null in JSON; lists have none of those.
            assert!(lists_are_whole(&numbers), "{said}: {numbers}");
        }
        Err(problem) => {
            let message = &problem.message;
            assert!(problem.kind != ProblemKind::Internal, "{said}: {message}");
            let digits = message
                .split(|c: char| !c.is_ascii_digit())
                .map(str::len)
                .max()
                .unwrap_or(0);
            let unsaid = ["NaN", "Some(", "None"].iter().any(|w| message.contains(w));
            assert!(
                digits < 20 && !unsaid && !message.contains(" inf"),
                "{said}: {message}"
            );
        }
    }
}

fn lists_are_whole(value: &Value) -> bool {
    match value {
        Value::Array(list) => list.iter().all(|v| !v.is_null() && lists_are_whole(v)),
        Value::Object(map) => map.values().all(lists_are_whole),
        _ => true,
    }
}

#[test]
fn every_number_of_a_muscle_file_of_any_size_is_an_answer_or_a_problem() {
    for key in keys(MUSCLE) {
        for size in SIZES {
            let text = with(MUSCLE, &key, size);
            let request = |model: &str| ForceRequest {
                question: mckibben_app::QuestionFields {
                    muscle: MuscleFields::from_file(file("m.toml", &text)),
                    model: mckibben_app::ModelFields::named(model),
                    ..Default::default()
                },
                pressure_mpa: Some(0.2.into()),
                contraction: Some(0.05.into()),
                ..ForceRequest::default()
            };
            for model in ["thick-wall", "universal"] {
                judged(
                    &|| mckibben_app::force(&request(model)),
                    &format!("{model}: {key:?} {size}"),
                );
            }
        }
    }
}

#[test]
fn every_number_of_a_joint_file_of_any_size_is_an_answer_or_a_problem() {
    for key in keys(JOINT) {
        for size in SIZES {
            let request = JointRequest {
                joint: mckibben_app::JointFields {
                    joint: Some(file("j.toml", &with(JOINT, &key, size))),
                    muscles: vec![file("m.toml", MUSCLE)],
                },
                model: mckibben_app::ModelFields::named("thick-wall"),
                pressures_mpa: vec![vec![0.2, 0.1].into()],
                angles_deg: Some(vec![0.0].into()),
                ..JointRequest::default()
            };
            judged(
                &|| mckibben_app::joint(&request, &Silent),
                &format!("{key:?} {size}"),
            );
        }
    }
}

#[test]
fn every_number_of_a_drive_file_of_any_size_is_an_answer_or_a_problem() {
    for key in keys(DRIVE) {
        for size in SIZES {
            let request = MotionRequest {
                drive: Some(file("d.toml", &with(DRIVE, &key, size))),
                muscle: Some(file("m.toml", MUSCLE)),
                model: mckibben_app::ModelFields::named("thick-wall"),
                ..MotionRequest::default()
            };
            judged(
                &|| mckibben_app::motion(&request, &Silent),
                &format!("{key:?} {size}"),
            );
        }
    }
}
