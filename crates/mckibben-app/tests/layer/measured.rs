//! Tables of benches, whatever program wrote them, and what is identified from them.

use crate::{
    given::{assert_close, file, muscle, number, parameter, table, text_of, with},
    reply,
};
use mckibben_app::{IdentifyRequest, MuscleFields, TextFile, identify};
use mckibben_core::progress::Silent;
use serde_json::{Value, json};

/// μ 0.4 MPa and k 900 N/mm made the points; the noise of 4 N is ours: t(8) √(1 + …) times as much
/// on the bench, the general ± elsewhere.
#[test]
fn the_bench_example_finds_what_made_its_points_and_its_file_has_the_uncertainty_of_the_bench() {
    let bench = muscle("examples/bench.toml");
    let identified = reply(
        "identify",
        json!({ "muscle": bench, "data": [table("examples/bench.csv")] }),
    );
    // The points are those of a muscle with these constants, and no ends that give way.
    for (name, truth) in [("tube.material.mu", 0.4), ("braid.stiffness", 900.0)] {
        let p = parameter(&identified, name);
        let is_inside = (number(p, "value") - truth).abs() <= number(p, "half_width_95");
        assert!(is_inside, "{p}");
    }
    assert!((2.0..20.0).contains(&number(&identified, "rms_n")));
    let found = json!({ "file": file("found.toml", identified["muscle_file"].as_str().unwrap()) });
    let half = |muscle: &Value| {
        let at = json!({ "muscle": muscle, "pressure_mpa": 0.3, "contraction": 0.08 });
        number(&reply("force", at), "uncertainty_n")
    };
    // Its own points tell more than those of all other muscles, and less of another diameter.
    let (own, start) = (half(&found), half(&bench));
    assert!(own < 0.5 * start, "{own} {start}");
    let wider = with(found, json!({ "outer_diameter_mm": 21 }));
    assert!(half(&wider) > 1.5 * own);
}

/// The points of `tests/bench` are one muscle's with a shear modulus of 0.25 MPa and without
/// friction, computed by finite elements, in the spellings of seventeen benches. Where the muscle
/// states that modulus, the prior and exact points agree on it. Forces are rounded to 0.01 N; what
/// conversions round adds less than 0.001 N. With g the slopes and s² = 1/(gᵀR⁻¹g + 1/σ²), rounding
/// moves μ by s² gᵀR⁻¹δF. By Cauchy and Schwarz that is at most s (δFᵀR⁻¹δF)^½, and R ≥ (0.02 F0)²
/// with F0 at least the largest pull: s √12 · 0.006 N/(0.02 F0).
#[test]
fn every_bench_gives_the_modulus_that_made_its_points() {
    const BENCH: &str = "crates/mckibben-cli/tests/bench";
    let text = text_of(&format!("{BENCH}/muscle.toml"));
    assert_eq!(text.matches("0.4 MPa").count(), 1, "{text}");
    let muscle = json!({ "file": file("muscle.toml", &text.replace("0.4 MPa", "0.25 MPa")) });
    for row in text_of("crates/mckibben-cli/tests/rows/benches.tsv").lines() {
        let cells: Vec<&str> = row.split('\t').collect();
        let mut request = json!({ "muscle": muscle, "data": [table(&format!("{BENCH}/{}", cells[0]))], "free": ["mu"], "fix": ["friction.c=0", "friction.beta=1"] });
        if let Some(columns) = cells[1].strip_prefix("--columns ") {
            let choices = columns
                .split(',')
                .filter_map(|choice| choice.split_once('='));
            request["columns"] = choices.collect();
        }
        let identified = reply("identify", request);
        let points = identified["points"].as_array().unwrap();
        let pulls = points.iter().map(|p| number(p, "force_n"));
        let rounding = 0.006 * 12_f64.sqrt() / (0.02 * pulls.fold(0.0, f64::max));
        let found = &identified["parameters"][0];
        let tolerance = number(found, "standard_error") * rounding;
        let mu = number(found, "value");
        assert!(
            tolerance < 3e-4 && (mu - 0.25).abs() <= tolerance,
            "{row}: {mu} {tolerance}"
        );
        let understood = &identified["understood"][0];
        assert_eq!(understood["rows"], 12, "{row}");
        let word = |c: &Value, key: &str| c[key].as_str().unwrap().to_owned();
        let columns = understood["columns"].as_array().unwrap().iter();
        let columns: Vec<String> = columns
            .map(|c| format!("{} [{}]", word(c, "quantity"), word(c, "unit")))
            .collect();
        assert_eq!(columns, cells[2..], "{row}");
    }
}

fn built() -> Value {
    let muscle = json!({ "rubber": "latex", "braid": "flexo-overexpanded-0.38in", "outer_diameter_mm": "0.375in", "wall_mm": "0.0625in", "length_mm": 200 });
    reply("build", json!({ "muscle": muscle, "pressure_mpa": 0.2 }))
}

/// A file of the folder of `build`.
fn built_file(built: &Value, name: &str) -> String {
    let files = built["files"].as_array().unwrap();
    let file = files.iter().find(|f| f["name"] == name).unwrap();
    file["text"].as_str().unwrap().to_owned()
}

/// An identity: what the sheet lists is what a pull says at half of the free contraction.
#[test]
fn the_test_sheet_lists_what_a_pull_says_to_measure() {
    let built = built();
    let muscle = json!({ "file": file("muscle.toml", &built_file(&built, "muscle.toml")) });
    let half = 0.5 * number(&built, "free_contraction");
    let at = json!({ "muscle": muscle, "pressure_mpa": 0.2, "contraction": half });
    let pull = reply("force", at);
    let said = pull["uncertainty_words"]["bench"].as_str().unwrap();
    let text = built_file(&built, "test.csv");
    let listed: Vec<&str> = text.lines().filter(|l| l.starts_with("# - ")).collect();
    assert!(said.split("; ").count() == 3 && listed.len() >= 3, "{text}");
    for (said, listed) in said.split("; ").zip(&listed) {
        let (said, listed) = (
            said.replace('\u{a0}', " "),
            listed[4..].replace('\u{a0}', " "),
        );
        assert!(listed.starts_with(&said), "{said}: {listed}");
    }
}

/// The sheet with the forces of a model in it is read as it is, and the muscle of the folder comes
/// back: an identity.
#[test]
fn the_test_sheet_is_read_back_by_identify() {
    let built = built();
    let muscle = json!({ "file": file("muscle.toml", &built_file(&built, "muscle.toml")) });
    let pull_n = |pressure_mpa: f64, contraction: f64| {
        let at = json!({ "muscle": muscle, "pressure_mpa": pressure_mpa, "contraction": contraction, "model": "thick-wall" });
        number(&reply("force", at), "force_n")
    };
    let text = built_file(&built, "test.csv");
    let is_row = |line: &&str| line.ends_with(|c: char| c.is_ascii_digit()) && line.contains(",,");
    let points: Vec<&str> = text.lines().filter(is_row).collect();
    // A load that is hung at 10 %.
    let hung = format!("0.2,0.1,{},contraction,pressure", pull_n(0.2, 0.1));
    let mut filled = text.replacen(",,,contraction,pressure", &hung, 1);
    assert_ne!(filled, text);
    for line in &points {
        let [p, e, _, branch, _, distance, ..] = line.split(',').collect::<Vec<_>>()[..] else {
            panic!("{line}")
        };
        let (pressure_mpa, contraction) = (p.parse().unwrap(), e.parse::<f64>().unwrap());
        // Between the heads: each plug has a band of 9 mm, 3 mm about it, and a shoulder of 16 mm.
        let there_mm = 200.0 * (1.0 - contraction) + 56.0;
        let written_mm: f64 = distance.parse().unwrap();
        assert!((there_mm - written_mm).abs() < 0.051, "{line}");
        let force_n = pull_n(pressure_mpa, contraction);
        // The muscle pulls at every point of the test.
        assert!(force_n > 0.0, "{line}");
        let row = format!("{p},{e},{force_n},{branch},force,{distance},,,");
        filled = filled.replace(line, &row);
    }
    assert!(points.len() >= 12 && filled.contains("contraction") && filled.contains("elongation"));
    assert!(points.len() >= built["test"].as_array().unwrap().len());
    // The pulls of the model have no friction.
    let request = json!({ "muscle": muscle, "data": [file("test.csv", &filled)], "model": "thick-wall", "free": ["modulus"], "fix": ["friction.c=0", "friction.beta=1"] });
    let answer = reply("identify", request);
    assert_eq!(answer["points"].as_array().unwrap().len(), points.len() + 1);
    let modulus = &answer["parameters"][0];
    assert_close(number(modulus, "value"), number(modulus, "start"), 1e-6);
}

/// The readings of `examples/hour.csv` were computed of the muscle below: the interval after them
/// holds its pull while it shortens, and is less than a quarter of that before.
#[test]
fn ten_readings_give_the_muscle_of_which_they_were_computed() {
    let given = text_of("examples/first.toml");
    let truth = given
        .replace(
            "rubber = \"dragon-skin-30\"",
            "[tube.material]\nlaw = \"yeoh\"\nc10 = 0.080712\nc20 = 0.009441\nc30 = -0.00050931",
        )
        .replace(
            "[job]",
            "take_up = 0.015\n[friction]\nlever = 2\n[terminals]\nseating = 0.5\n[job]",
        );
    let muscle = |text: &str| json!({ "file": file("muscle.toml", text) });
    let request = json!({ "muscle": muscle(&given), "data": [table("examples/hour.csv")], "set": ["measured=contraction"] });
    let found = reply("identify", request);
    let found = found["muscle_file"].as_str().unwrap();
    let pull = |text: &str, more: Value| {
        let at = json!({ "muscle": muscle(text), "pressure_mpa": 0.11, "contraction": 0.075 });
        reply("force", with(at, more))
    };
    let truth = pull(&truth, json!({ "direction": "contraction" }));
    let truth_n = number(&truth, "force_n");
    let (before, after) = (pull(&given, json!({})), pull(found, json!({})));
    let ends = ["predicted_low_n", "predicted_high_n"].map(|key| number(&after, key));
    assert!(ends[0] < truth_n && truth_n < ends[1], "{truth_n} {ends:?}");
    let [before, after] = [&before, &after].map(|answer| number(answer, "uncertainty_n"));
    assert!(after < 0.25 * before, "{before} {after}");
}

/// The files of a measured muscle, with their blanks. (Tests of the study `validation` read such
/// files as they were.)
#[test]
fn a_measured_muscle_is_saved_as_a_folder() {
    const CASE: &str = "crates/mckibben-fit/data/measured/dmsp-20-300";
    let mut request = IdentifyRequest {
        muscle: MuscleFields::from_file(TextFile {
            name: "muscle.toml".into(),
            text: text_of(&format!("{CASE}/muscle.toml")),
        }),
        free: vec!["mu".into(), "braid.angle".into()],
        ..IdentifyRequest::default()
    };
    request.model.name = Some("thick-wall".into());
    let points = crate::root().join(CASE).join("points.csv");
    request.tables.data = vec![TextFile::table(&points).unwrap()];
    let answer = identify(&request, &Silent).unwrap();
    let files = request.measured_files(&answer).unwrap();
    let mut names: Vec<String> = files.into_iter().map(|file| file.0.to_string()).collect();
    names.sort();
    assert_eq!(
        names,
        [
            "README.md",
            "case.toml",
            "identified.toml",
            "muscle.toml",
            "points.csv"
        ]
    );
    // Rows in time order are none.
    request.branches = serde_json::from_value(json!("history")).unwrap();
    let answer = identify(&request, &Silent);
    let refused = answer.and_then(|answer| request.measured_files(&answer));
    assert!(refused.is_err());
}

/// B. Tondu (2012), Fig. 3: the ideal model is off by 92–95 N.
#[test]
fn the_20_degree_muscle_is_compared_and_identified() {
    let muscle = muscle("examples/tondu2012.toml");
    let data = table("data/tondu2012/static_force_20deg.csv");
    let compared = reply(
        "compare",
        json!({ "models": ["ideal", "thick-wall"], "muscle": muscle, "data": [data] }),
    );
    let ideal = &compared["models"][0];
    assert!((number(ideal, "rms_n") - 95.2).abs() < 0.5, "{ideal}");
    // Its loops' half-widths alone give C 71.5 and β 0.560 (examples/tondu2012.toml).
    let identified = reply("identify", json!({ "muscle": muscle, "data": [data] }));
    for (name, alone) in [("friction.coefficient", 71.46), ("friction.exponent", 0.56)] {
        let p = parameter(&identified, name);
        let is_inside = (number(p, "value") - alone).abs() <= number(p, "half_width_95");
        assert!(is_inside, "{p}");
    }
}

/// The friction of the example is the fit of the measured half-widths that its comment states.
#[test]
fn the_friction_of_the_example_is_the_fit_of_its_half_widths() {
    let points = [
        (0.1, 19.6),
        (0.2, 29.1),
        (0.3, 37.6),
        (0.4, 41.0),
        (0.5, 49.2),
    ];
    let logs: Vec<(f64, f64)> = points
        .iter()
        .map(|&(p, f): &(f64, f64)| (p.ln(), f.ln()))
        .collect();
    let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / 5.0;
    let (x, y) = (mean(|q| q.0), mean(|q| q.1));
    let slope = logs.iter().map(|q| (q.0 - x) * (q.1 - y)).sum::<f64>()
        / logs.iter().map(|q| (q.0 - x).powi(2)).sum::<f64>();
    let text = text_of("examples/tondu2012.toml");
    assert!(
        text.contains(&format!("\nexponent = {slope:.3}\n")),
        "β {slope}"
    );
    assert!(
        text.contains(&format!("\ncoefficient = {:.2}\n", (y - slope * x).exp())),
        "C {}",
        (y - slope * x).exp()
    );
}
