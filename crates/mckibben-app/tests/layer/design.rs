//! What a design tells people to set.

use super::reply;
use serde_json::{Value, json};

/// The pressure behind words of the decision, in MPa.
fn behind(line: &str, words: &str) -> f64 {
    let (_, rest) = line.split_once(words).unwrap_or_else(|| panic!("{line}"));
    let number = rest.split('\u{a0}').next().unwrap();
    number.parse().unwrap_or_else(|_| panic!("{line}"))
}

/// Bounds that follow from valves: a relief valve needs a tenth to close again, a regulator holds
/// its pressure within 5 %.
#[test]
fn what_is_set_has_room_for_the_valves_and_what_is_estimated_is_tested_first() {
    let jobs = [
        json!({"force_n": 700, "contraction": 0.15, "max_pressure_mpa": 0.25}),
        json!({"force_n": 400, "stroke_mm": 40, "max_pressure_mpa": 0.6}),
        json!({"force_n": 30, "contraction": 0.15, "max_pressure_mpa": 0.3, "length_mm": 120}),
        json!({
            "torques": [{"torque_nm": 10, "angle_deg": 60}, {"torque_nm": 5, "angle_deg": 90}],
            "max_pressure_mpa": 0.5,
            "length_mm": 260
        }),
    ];
    for job in jobs {
        let answer = reply("design", job.clone());
        let best = &answer["candidates"][0];
        let lines = answer["decision"].as_array().unwrap().iter();
        let lines: Vec<&str> = lines.map(|line| line.as_str().unwrap()).collect();
        let set = lines.iter().find(|line| line.starts_with("Set ")).unwrap();
        let (set_mpa, relief_mpa) = (behind(set, "Set "), behind(set, "relief valve at "));
        let allowed_mpa = best["allowed_pressure_mpa"].as_f64().unwrap();
        let supply_mpa = job["max_pressure_mpa"].as_f64().unwrap();
        let printed = 1.0 + 1e-3;
        assert!(
            set_mpa <= allowed_mpa / 1.1 * printed,
            "{set}: {allowed_mpa}"
        );
        assert!(set_mpa <= 0.95 * supply_mpa * printed, "{set}");
        assert!(
            relief_mpa <= allowed_mpa && relief_mpa >= 1.09 * set_mpa,
            "{set}"
        );
        // Whose strands are an estimate, it has a range, and its test stays below the least.
        let least = &best["least_burst_pressure_mpa"];
        assert_ne!(*least, Value::Null, "{best}");
        let proof_mpa = behind(set, "test with water at ");
        assert!(
            proof_mpa < least.as_f64().unwrap() && proof_mpa > 1.2 * set_mpa,
            "{set}"
        );
        // A radius that is searched has room for both muscles, and 4 mm for clamps and cords.
        if job["torques"].is_array() {
            let mm = |key: &str| best[key].as_f64().unwrap();
            let radius_mm = best["joint"]["radius_mm"].as_f64().unwrap();
            let both_mm = 0.5 * (mm("bulged_diameter_mm") + mm("outer_diameter_mm"));
            assert!(
                2.0 * radius_mm >= both_mm + 4.0 - 1e-9,
                "{radius_mm} {both_mm}"
            );
            assert!(!lines[0].contains("no room"), "{}", lines[0]);
        }
    }
}

/// What is sure is so many muscles: of 7 that are taken, 28 of the same were called sure without
/// their number.
#[test]
fn what_is_sure_is_said_with_its_number_of_muscles() {
    for (force_n, contraction, mpa, extra) in [
        (800.0, 0.2, 0.4, json!({})),
        (1500.0, 0.12, 0.6, json!({})),
        (300.0, 0.15, 0.25, json!({"count": 4})),
        (60.0, 0.12, 0.4, json!({})),
    ] {
        let mut job =
            json!({"force_n": force_n, "contraction": contraction, "max_pressure_mpa": mpa});
        job.as_object_mut()
            .unwrap()
            .extend(extra.as_object().unwrap().clone());
        let answer = reply("design", job);
        let mut lines = answer["decision"].as_array().unwrap().iter();
        let line = lines.find_map(|line| line.as_str().filter(|line| line.starts_with("Sure")));
        let line = line.unwrap();
        let candidates = answer["candidates"].as_array().unwrap();
        let taken = answer["bundle"]["muscles"].as_u64().unwrap_or(1);
        let itself = candidates[0]["sure_pressure_mpa"].is_number();
        let other = candidates
            .iter()
            .any(|c| c["sure_pressure_mpa"].is_number());
        let count = match &answer["to_be_sure"]["count"] {
            Value::Number(count) if !other => count.as_u64().unwrap(),
            _ => taken,
        };
        assert_eq!(line.contains("% at "), itself, "{line}");
        let named = format!("{count} muscles");
        assert!(
            itself || count == 1 || line.contains(&named),
            "{line} {count}"
        );
    }
}

/// Of a bundle: with so many muscles as were chosen the next multiple was called sure, 28 of them.
#[test]
fn identity_as_many_muscles_are_sure_as_a_guarantee_asks_for() {
    let job = json!({"force_n": 800, "contraction": 0.2, "max_pressure_mpa": 0.4});
    let mut guaranteed = job.clone();
    guaranteed["guaranteed"] = json!(0.95);
    let (sure, bundle) = (reply("design", job), reply("design", guaranteed));
    assert_eq!(sure["to_be_sure"]["count"], bundle["bundle"]["muscles"]);
    let chosen = &bundle["candidates"][0];
    assert_eq!(
        sure["to_be_sure"]["outer_diameter_mm"],
        chosen["outer_diameter_mm"]
    );
}

/// The folder of a build says what `force` says of the muscle file: on the branch of its job, which
/// is named. It was that of a shortening muscle, whatever the job was.
#[test]
fn identity_a_build_pulls_what_force_says_on_the_branch_of_its_job() {
    let text = include_str!("../../../../examples/prototype.toml");
    for (branch, way) in [("contraction", "shortening"), ("elongation", "lengthening")] {
        let job = "points = [{ force = '300 N', contraction = 0.15 }]";
        let text = format!("{text}\n[job]\npressure = '2 bar'\nbranch = '{branch}'\n{job}\n");
        let file = json!({"name": "m.toml", "text": text});
        let pull = reply("force", json!({"muscle": {"file": file}}));
        let built = reply("build", json!({"muscle": {"file": file}}));
        let steps = built["files"][0]["text"].as_str().unwrap();
        let line = steps.lines().find(|line| line.starts_with("At ")).unwrap();
        let said: f64 = line
            .split(" pulls ")
            .nth(1)
            .unwrap()
            .split(' ')
            .next()
            .unwrap()
            .parse()
            .unwrap();
        let predicted_n = pull["predicted_n"].as_f64().unwrap();
        assert!((said - predicted_n).abs() <= 0.5, "{line} {predicted_n}");
        assert!(line.contains(&format!("as built) while {way}")), "{line}");
    }
}

/// Of parts a specification in Rust has the answer of the command: one muscle, one of several, and
/// none that fits.
#[test]
fn identity_a_specification_of_parts_in_rust_is_that_of_the_command() {
    use mckibben::{decide, design::Spec};
    for (force_n, contraction, mpa, length_mm) in [
        (30.0, 0.12, 0.4, 200.0),
        (3000.0, 0.1, 0.6, 285.0),
        (30.0, 0.3, 0.05, 200.0),
    ] {
        let answer = reply(
            "design",
            json!({"force_n": force_n, "contraction": contraction, "max_pressure_mpa": mpa,
                   "length_mm": length_mm}),
        );
        let spec = Spec::pull(force_n, contraction, mpa).length_mm(length_mm);
        let found = decide(&spec.of_parts().unwrap()).unwrap();
        let numbers = found.outcome.candidates.iter().map(|one| {
            let sizes = [one.muscle.outer_diameter_mm(), one.muscle.wall_mm()];
            json!([found.spec.count, sizes[0], sizes[1], one.pressure_mpa])
        });
        let numbers: Vec<Value> = numbers.collect();
        let keys = ["count", "outer_diameter_mm", "wall_mm", "pressure_mpa"];
        let of_command = answer["candidates"].as_array().unwrap().iter();
        let of_command: Vec<Value> = of_command
            .map(|one| keys.iter().map(|key| one[key].clone()).collect())
            .collect();
        assert_eq!(numbers, of_command);
        let changes = answer["closest"]["relaxations"]
            .as_array()
            .map_or(0, Vec::len);
        assert_eq!(found.relaxations.len(), changes);
    }
}
