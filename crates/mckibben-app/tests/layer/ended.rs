//! Every command ends where its caller leaves.

use mckibben_app::{COMMANDS, ProblemKind, ask_value};
use mckibben_core::{cancel::Cancel, progress::Silent, threads::Threads};
use serde_json::{Value, json};
use std::{fmt::Write, path::Path, time::Duration};

fn text_file(name: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../examples")
        .join(name);
    json!({ "name": name, "text": std::fs::read_to_string(path).unwrap() })
}

fn table(name: &str, head: &str, rows: usize, row: impl Fn(f64) -> String) -> Value {
    let mut text = format!("{head}\n");
    for i in 0..rows {
        writeln!(text, "{}", row(i as f64 / rows as f64)).unwrap();
    }
    json!({ "name": name, "text": text })
}

fn steps(from: f64, to: f64, count: usize) -> Vec<f64> {
    (0..count)
        .map(|i| from + (to - from) * i as f64 / count as f64)
        .collect()
}

/// The name of tables of eight megabytes.
const LONG: &str = "long.csv";

/// A request of each command that takes much longer than these tests give it; none where every
/// answer takes a moment.
fn dear(command: &str, folder: &Path) -> Vec<Value> {
    let (pressures, contractions) = (steps(0.05, 0.25, 100), steps(0.0, 0.15, 190));
    let points = |n| -> Vec<Value> {
        steps(0.01, 0.1, n)
            .iter()
            .map(|e| json!({ "force_n": 300.0 - e, "contraction": e }))
            .collect()
    };
    let torques = |n| -> Vec<Value> {
        steps(0.0, 40.0, n)
            .iter()
            .map(|a| json!({ "torque_nm": 5.0, "angle_deg": a }))
            .collect()
    };
    let plan = json!({ "name": "plan.toml", "text": "[sampling]\nmethod = \"sobol\"\nsamples = 64\n\
        [vary]\ntube.outer_diameter = \"20..60 mm\"\n[test]\ncontractions \
        = \"0..15:1%\"\npressures = \"0.05..2.5:0.2bar\"\n" });
    let bench = table("bench.csv", "pressure_bar,contraction,force_n", 5000, |t| {
        format!(
            "{},{},{}",
            1.0 + 1.5 * t,
            0.15 * (37.0 * t).fract(),
            600.0 * t + 50.0
        )
    });
    // Eight megabytes of different rows, as long as a request may be.
    let rows = 200_000;
    let long = || {
        table(LONG, "pressure_mpa,contraction,force_n,branch", rows, |t| {
            let (p, e) = (0.05 + 0.2 * (0.618 * rows as f64 * t).fract(), 0.15 * t);
            let branch = ["contraction", "elongation"][(rows as f64 * t).round() as usize % 2];
            format!(
                "{p:.9},{e:.9},{:.4},{branch}",
                700.0 * p * (9.0 * (1.0 - e).powi(2) - 5.0)
            )
        })
    };
    let slim = json!({ "model": { "name": "fe", "mesh": "2x1024" }, "muscle": { "length_mm": 30000 }, "pressure_mpa": 0.2, "contraction": 0.1, "force_n": 300 });
    match command {
        "design" => vec![
            json!({ "points": points(19_000), "model": "thick-wall", "max_pressure_mpa": 0.5 }),
            json!({ "torques": torques(19_000), "model": "thick-wall", "max_pressure_mpa": 0.5 }),
            json!({ "points": points(3), "angle_deg": { "low": 20, "high": 35 }, "length_mm": { "low": 200, "high": 400 },
                    "model": "fe", "max_pressure_mpa": 0.5 }),
        ],
        "shape" => vec![
            json!({ "muscle": { "length_mm": 30000 }, "mesh": "2x1024", "pressure_mpa": 0.2, "force_n": 300 }),
        ],
        "pressure" | "contraction" | "force" => {
            let taken: &[&str] = match command {
                "pressure" => &["force_n", "contraction"],
                "contraction" => &["force_n", "pressure_mpa"],
                _ => &["pressure_mpa", "contraction"],
            };
            let is = |(key, _): &(&String, &Value)| {
                ["model", "muscle"].contains(&key.as_str()) || taken.contains(&key.as_str())
            };
            vec![
                slim.as_object()
                    .unwrap()
                    .iter()
                    .filter(is)
                    .map(|(k, v)| (k.clone(), v.clone()))
                    .collect(),
            ]
        }
        "fill" => vec![
            json!({ "model": { "name": "fe", "mesh": "2x1024" }, "muscle": { "length_mm": 30000 }, "volume_mm3": 6e6, "load": "mass:5kg" }),
        ],
        "curve" => vec![
            json!({ "test": "isobaric", "model": "fe", "pressures_mpa": pressures, "contractions": contractions }),
            json!({ "test": "isotonic", "model": "thick-wall", "pressures_mpa": pressures, "forces_n": steps(10.0, 300.0, 190), "muscle": { "file": text_file("held.toml") } }),
        ],
        "joint" => {
            let muscle = text_file("biceps.toml");
            vec![
                json!({ "joint": text_file("elbow.toml"), "muscles": [muscle, muscle], "model": "fe", "map": 60,
                         "max_pressure_mpa": 0.3 }),
            ]
        }
        "motion" => vec![json!({ "step": { "valve": "1 L/(s bar)", "load": "mass:1kg", "pressure_mpa": 0.2, "until_s": 500 }, "muscle": text_file("prototype.toml"), "model": "fe" })],
        "study" => vec![json!({ "model": { "name": "fe", "mesh": "4x512" } })],
        "simulate" => vec![
            json!({ "test": "isometric", "model": "fe3d", "pressures_mpa": steps(0.01, 0.2, 3000), "contractions": [0.1] }),
        ],
        "compare" => vec![
            json!({ "models": ["fe", "thick-wall"], "pressures_mpa": pressures, "contractions": contractions }),
            json!({ "models": ["thick-wall"], "data": [long()], "muscle": { "file": text_file("bench.toml") } }),
        ],
        "identify" => [("fe", bench), ("thick-wall", long())]
            .map(|(model, data)| {
                json!({ "muscle": { "file": text_file("bench.toml") }, "data": [data], "model": model, "free": ["tube.material.mu", "braid.stiffness"] })
            })
            .into(),
        "fit" => {
            let row = |t: f64| {
                let (d, s, p) = (
                    30.0 + 5.0 * (4.99 * t).floor(),
                    1.0 + (24.95 * t).floor() % 5.0,
                    0.01 + 0.01 * ((624.0 * t).floor() % 25.0),
                );
                let e = 0.2 * ((19_000.0 * t).round() % 31.0) / 31.0;
                format!("{d},{s},285,28,{p},{e},{},ok", p * d * d * (1.0 - 4.0 * e))
            };
            let head = "outer_diameter_mm,wall_mm,length_mm,angle_deg,pressure_mpa,contraction,force_n,status";
            let long = table(LONG, head, 120_000, row);
            vec![
                json!({ "table": table("points.csv", head, 19_000, row), "method": "global" }),
                json!({ "table": long, "method": "global" }),
                json!({ "table": long, "method": "paper" }),
            ]
        }
        "plan" | "campaign-forecast" => vec![json!({ "plan": plan })],
        "campaign" => vec![json!({ "plan": plan, "output": folder.join("c.parquet") })],
        "build" => vec![json!({ "muscle": { "length_mm": 30000 }, "report": true })],
        "rubber" => {
            let row = |t: f64| {
                let l = 1.0 + 4.0 * t;
                format!(
                    "{l},{}",
                    0.4 * (l - 1.0 / (l * l)) + 0.01 * (900.0 * t).sin() + 0.002 * l.powi(4)
                )
            };
            let over_time = |t: f64| {
                format!(
                    "{},{},{}",
                    100.0 * t,
                    1.0 + (20.0 * t).sin().abs(),
                    0.4 * (20.0 * t).sin().abs()
                )
            };
            let data = table("tension.csv", "stretch,stress_mpa", 19_000, row);
            let history = table(
                "history.csv",
                "time_s,stretch,stress_mpa",
                19_000,
                over_time,
            );
            let long = table(LONG, "stretch,stress_mpa", 200_000, |t| {
                format!("{},   {:.12}", 1.0 + 4.0 * t, t)
            });
            vec![
                json!({ "data": [data] }),
                json!({ "data": [long] }),
                json!({ "data": [history], "laws": ["yeoh"], "relaxation": 6 }),
                json!({ "data": [history], "laws": ["yeoh"], "softening": true }),
            ]
        }
        "export" => {
            vec![json!({ "muscle": { "length_mm": 30000 }, "target": "c", "model": { "name": "fe", "mesh": "8x400" } })]
        }
        "export-joint" => {
            let joint = "[joint]\nradius = '25 mm'\n[muscle_1]\nfile = \
                'long.toml'\n[spring]\nangular_rate = '9 N m/rad'\n";
            let muscle = json!({ "name": "long.toml", "text": "[tube]\nlength = '30 m'\n" });
            let joint = json!({ "name": "arm.toml", "text": joint });
            vec![json!({ "joint": joint, "muscles": [muscle], "target": "c", "model": { "mesh": "8x400" } })]
        }
        "export-list" | "check" | "check-formula" | "campaign-show" | "campaign-merge"
        | "measures" | "parts-list" | "parts-show" | "quantities" | "units" => {
            vec![]
        }
        other => panic!("say what a dear request of {other} is, or that there is none"),
    }
}

/// What a command ended with, on separate threads: other tests occupy those of the process for
/// seconds.
fn ended(command: &str, request: Value, cancel: &Cancel) -> Result<Value, (ProblemKind, String)> {
    let threads = Threads::new(Threads::shared().count()).unwrap();
    let _entered = cancel.enter();
    let answer = threads.within(|| ask_value(command, request, &Silent));
    answer.map_err(|p| (p.kind, p.message))
}

/// Asks for something whose caller leaves after a while; after half of that where it was done
/// before, again and again. Work that does not notice that its caller has left ends with an answer.
fn leave(command: &str, request: &Value, stays: Duration) {
    let cancel = Cancel::default();
    let leaves = cancel.clone();
    let leaving = std::thread::spawn(move || {
        std::thread::sleep(stays);
        leaves.cancel();
    });
    let answer = ended(command, request.clone(), &cancel);
    let was_there = cancel.check().is_ok();
    leaving.join().unwrap();
    match answer {
        Ok(_) if was_there && stays > Duration::from_millis(1) => {
            leave(command, request, stays / 2);
        }
        Ok(_) => panic!("{command} does not notice that its caller has left"),
        Err((kind, message)) => assert_eq!(kind, ProblemKind::Cancelled, "{command}: {message}"),
    }
}

#[test]
fn a_caller_that_leaves_ends_every_command() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    // Not where the last run of this test, maybe of another version, left the campaign.
    let _ = std::fs::remove_file(folder.join("c.parquet"));
    let _ = std::fs::remove_dir_all(folder.join("c.parquet.parts"));
    for command in COMMANDS.iter().map(|c| c.name) {
        for request in dear(command, folder) {
            leave(command, &request, Duration::from_millis(300));
            // A long table is read for a while, and then worked on.
            if request.to_string().contains(LONG) {
                leave(command, &request, Duration::from_secs(2));
            }
        }
    }
}

#[test]
fn what_is_cancelled_already_gives_no_answer() {
    for command in COMMANDS.iter().map(|c| c.name) {
        let cancel = Cancel::default();
        cancel.cancel();
        let answer = ended(command, json!({}), &cancel);
        assert_eq!(
            answer.map(|_| ()).expect_err(command).0,
            ProblemKind::Cancelled,
            "{command}"
        );
    }
}
