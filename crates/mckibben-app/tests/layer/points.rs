//! What points are answered with: numbers, or why there are none.

use crate::{
    given::{assert_close, joint_file, muscle, number, with},
    refusal, reply, root,
};
use mckibben_app::{MotionRequest, ProblemKind, ask};
use mckibben_core::{
    progress::Silent,
    random::{Random, rounds},
};
use serde_json::{Value, json};

#[test]
fn points_without_answer_say_why() {
    let curve = json!({ "test": "isobaric", "pressures_mpa": [0.2, 0.3], "contractions": [0, 0.1], "model": "paper" });
    let curve = reply("curve", curve);
    let points = curve["points"].as_array().unwrap();
    let status: Vec<&str> = points
        .iter()
        .map(|p| p["status"].as_str().unwrap())
        .collect();
    assert_eq!(status, ["ok", "ok", "out_of_range", "out_of_range"]);
    assert!(points[2]["cause"].is_string() && points[2].get("force_n").is_none());
    let problem = refusal(
        "pressure",
        json!({ "force_n": 9999, "contraction": 0.1, "model": "paper" }),
    );
    assert_eq!(problem.kind, ProblemKind::NoAnswer);
    let nearest = problem.nearest.unwrap();
    assert_close(nearest.pressure_mpa.unwrap(), 0.25, 1e-9);
}

#[test]
fn the_example_muscles_are_muscles() {
    let mut count = 0;
    for entry in std::fs::read_dir(root().join("examples")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|e| e != "toml") {
            continue;
        }
        let name = format!("examples/{}", path.file_name().unwrap().display());
        let text = std::fs::read_to_string(&path).unwrap();
        if text.contains("[joint]") {
            let pressures = if text.contains("[muscle_2]") {
                json!([[0.2, 0.1]])
            } else {
                json!([[0.2]])
            };
            let mut request = joint_file(&name);
            request["pressures_mpa"] = pressures;
            request["model"] = "thick-wall".into();
            reply("joint", request);
        } else if text.contains("[command]") {
            let mut request = MotionRequest::default().with_drive(&path).unwrap();
            request.model.name = Some("thick-wall".into());
            reply("motion", serde_json::to_value(request).unwrap());
        } else {
            reply("check", json!({ "muscle": muscle(&name) }));
            let at = json!({ "muscle": muscle(&name), "pressure_mpa": 0.1, "contraction": 0.05 });
            number(&reply("force", at), "force_n");
            count += 1;
        }
    }
    assert!(count >= 2);
}

/// The data of the view that a reader can rotate are not counted.
#[test]
fn a_report_has_a_title_block_and_at_most_300_kb() {
    let request = json!({ "muscle": muscle("examples/bench.toml"), "pressure_mpa": 0.2, "number": "MK-012", "revision": "B", "project": "Arm <2>", "report": true });
    let answer = reply("build", request);
    let files = answer["files"].as_array().unwrap();
    let file = |name: &str| files.iter().find(|file| file["name"] == name).unwrap();
    let html = file("report.html")["text"].as_str().unwrap();
    for field in [
        "document no.</th><td>MK-012</td>",
        "revision</th><td>B</td>",
        "project</th><td>Arm &lt;2&gt;</td>",
        "date</th><td></td>",
        "counter(pages)",
        "class=\"drawing\"",
    ] {
        assert!(html.contains(field), "{field}");
    }
    let begin = html.find("<script type=\"application/json\">").unwrap();
    let view = html[begin..].find("</script>").unwrap();
    assert!(html.len() - view < 300_000, "{}", html.len());
    // `%PDF-` in base64.
    let pdf = file("report.pdf")["base64"].as_str().unwrap();
    assert!(pdf.starts_with("JVBERi"));
}

/// Closed form: at rest the pressure acts at the inner radius of the polygon with the area of the
/// circle, (D0/2 − s) √(φ/sin φ) with φ = π/8, and the pull at the end of half the length and of the
/// 20 mm of tube on the terminal.
#[test]
fn closed_form_the_mesh_of_bricks_is_drawn_with_its_loads() {
    let muscle = json!({ "outer_diameter_mm": 30, "wall_mm": 3, "length_mm": 100 });
    let terminal = json!({ "material": "aluminium", "insertion_mm": 20, "nose_mm": 3 });
    let model = json!({ "name": "fe3d", "mesh": "1x4", "terminal": terminal });
    let request = json!({ "muscle": muscle, "model": model, "test": "isometric", "contractions": [0.05], "pressures_mpa": [0.1], "figure": "MPa" });
    let answer = reply("simulate", request);
    let panels = answer["figure"]["panels"].as_array().unwrap();
    let series = |panel: &Value| panel["series"].as_array().unwrap().clone();
    let all: Vec<Value> = panels.iter().flat_map(series).collect();
    let load = |label: &str| {
        let found = all.iter().find(|series| series["end_label"] == label);
        found.unwrap()["points"].clone()
    };
    let phi = std::f64::consts::PI / 8.0;
    let inner = 12.0 * (phi / phi.sin()).sqrt();
    assert_close(load("P")[1][0].as_f64().unwrap(), 21.0, 1e-3);
    assert_close(load("P")[1][1].as_f64().unwrap(), inner, 1e-4);
    assert_eq!(load("F/4")[0], json!([70.0, 0.0]));
}

/// Whatever the size of the numbers: never a panic, and never a number that is none.
#[test]
fn numbers_of_any_size_give_answers_or_errors() {
    const MODELS: [&str; 6] = [
        "ideal",
        "thick-wall",
        "paper",
        "chou-hannaford",
        "force-balance",
        "tondu-lopez",
    ];
    let mut random = Random(92);
    for round in 0..rounds(200) {
        let mut power = |low, high| 10f64.powf(random.between(low, high));
        let muscle = json!({
            "outer_diameter_mm": power(-3.0, 6.0),
            "wall_mm": power(-4.0, 5.0),
            "length_mm": power(-3.0, 7.0),
            "with": ["terminals.end_factor=1.2"],
        });
        let pressure_mpa = power(-9.0, 6.0);
        let angle_deg = random.between(0.0, 60.0);
        let muscle = with(muscle, json!({ "angle_deg": angle_deg }));
        let contraction = random.between(-1.2, 1.2);
        let mut request = json!({ "muscle": muscle, "pressure_mpa": pressure_mpa, "model": MODELS[round / 2 % MODELS.len()], "extrapolate": true, "two_sided": true });
        let command = ["force", "contraction"][round % 2];
        if command == "force" {
            request["contraction"] = contraction.into();
        } else {
            request["force_n"] = (1000.0 * contraction.abs()).into();
        }
        match ask(command, &request.to_string(), &Silent) {
            Ok(answer) => {
                let answer: Value = serde_json::from_str(&answer).unwrap();
                // What is no number is `null` in JSON.
                assert!(answer["force_n"].is_number(), "{request}: {answer}");
            }
            Err(problem) => {
                let is_said = !problem.message.is_empty() && problem.kind != ProblemKind::Internal;
                assert!(is_said, "{request}: {problem}");
            }
        }
    }
}
