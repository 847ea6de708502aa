//! Answers about what has a name, and about designs; the keys of answers.

use super::reply;
use serde_json::{Value, json};

fn number(value: &Value, key: &str) -> f64 {
    value[key]
        .as_f64()
        .unwrap_or_else(|| panic!("{key} of {value}"))
}

/// Keys of an answer that its schema does not have.
fn unknown(answer: &Value, schema: &Value, defs: &Value, out: &mut Vec<String>) {
    let schema = match schema["$ref"]
        .as_str()
        .and_then(|path| path.rsplit('/').next())
    {
        Some(name) => &defs[name],
        None => schema,
    };
    let Some(fields) = schema["properties"].as_object() else {
        return;
    };
    for (key, value) in answer.as_object().into_iter().flatten() {
        match fields.get(key) {
            Some(of) => unknown(value, of, defs, out),
            None => out.push(key.clone()),
        }
    }
}

#[test]
fn keys_of_answers_are_those_of_their_schemas() {
    for (command, request) in [
        ("force", json!({ "pressure_mpa": 0.2, "contraction": 0.1 })),
        (
            "curve",
            json!({ "test": "isobaric", "pressures_mpa": [0.2], "contractions": [0.1], "model": "ideal" }),
        ),
        ("check", json!({ "only_data": true })),
        ("compare", json!({ "models": ["ideal", "paper"] })),
        ("parts-show", json!({ "name": "nfl-19" })),
    ] {
        let (answer, schema) = (
            reply(command, request),
            mckibben_app::schema(command).unwrap()["answer"].take(),
        );
        let mut out = vec![];
        unknown(&answer, &schema, &schema["$defs"], &mut out);
        assert!(
            out.is_empty() && schema["properties"].is_object(),
            "{command}: {out:?}"
        );
    }
}

#[test]
fn every_part_that_is_listed_is_shown_and_makes_a_muscle() {
    let all = reply("parts-list", json!({}));
    let list = |kind: &str| all[kind].as_array().unwrap().iter();
    assert!(list("tubes").len() > 100 && list("sleeves").len() >= 10 && list("rubbers").len() > 10);
    for rubber in list("rubbers") {
        let one = reply("parts-show", json!({ "name": rubber["name"] }))["rubber"].take();
        assert!(one["name"] == rubber["name"] && !one["source"].as_str().unwrap().is_empty());
        assert_eq!(
            one["fits"]
                .as_array()
                .unwrap()
                .iter()
                .filter(|f| f["by_reach"] == true)
                .count()
                .min(1),
            1,
            "{one}"
        );
        reply(
            "check",
            json!({ "only_data": true, "muscle": { "rubber": rubber["name"] } }),
        );
    }
    for sleeve in list("sleeves") {
        let one = reply("parts-show", json!({ "name": sleeve["name"] }))["sleeve"].take();
        assert!(
            !one["source"].as_str().unwrap().is_empty()
                && !one["terms"].as_str().unwrap().is_empty()
        );
        let points = one["points"].as_array().unwrap();
        assert!(points.len() >= 5, "{one}");
        let diameter = number(&points[0], "outer_diameter_mm");
        let muscle = json!({ "only_data": true, "muscle": { "braid": sleeve["name"], "outer_diameter_mm": diameter, "wall_mm": 0.1 * diameter, "stiffness": "inextensible" } });
        reply("check", muscle);
    }
    for muscle in list("muscles") {
        assert!(
            muscle["name"].as_str().unwrap().starts_with("lib:")
                && !muscle["terms"].as_str().unwrap().is_empty()
        );
        // Another specimen: the table of families says 15 % of the largest pull.
        let share = number(muscle, "uncertainty_n") / number(muscle, "blocked_force_n");
        assert!((0.1..0.45).contains(&share), "{muscle}");
    }
    for model in list("models").filter(|model| model["name"] != "fe3d") {
        assert!(!model["description"].as_str().unwrap().is_empty());
        let mut request = json!({ "model": model["name"], "pressure_mpa": 0.1, "contraction": 0.05, "extrapolate": true });
        for (key, value) in [
            ("end_factor", 1.2),
            ("strand_length_mm", 323.0),
            ("turns", 1.5),
        ] {
            request["muscle"][key] = value.into();
        }
        reply("force", request);
    }
}

const WANTED: &str =
    r#"{ "force_n": 300, "contraction": 0.1, "max_pressure_mpa": 0.25, "model": "thick-wall" }"#;

fn designed(more: Value) -> Value {
    let mut request: Value = serde_json::from_str(WANTED).unwrap();
    request
        .as_object_mut()
        .unwrap()
        .extend(more.as_object().unwrap().clone());
    request
        .as_object_mut()
        .unwrap()
        .retain(|_, value| !value.is_null());
    reply("design", request)
}

#[test]
fn designs_are_sorted_by_their_objective() {
    for (objective, key, sign) in [
        ("diameter", "outer_diameter_mm", 1.0),
        ("pressure", "pressure_mpa", 1.0),
        ("air", "air_normal_litres", 1.0),
        ("chance", "chance", -1.0),
    ] {
        let design = designed(json!({ "objective": objective, "top": 8 }));
        let list = design["candidates"].as_array().unwrap();
        // What is cast counts half as large again.
        let cast = list
            .iter()
            .filter(|c| c["is_cast"] == json!(true) && c["count"] == 1);
        let by: Vec<f64> = cast.map(|c| sign * number(c, key)).collect();
        assert!(
            list.len() == 8 && by.len() > 2 && by.windows(2).all(|w| w[0] <= w[1] + 1e-9),
            "{objective}: {by:?}"
        );
        let weakest = |c: &Value| number(&c["points"][0], "force_at_max_pressure_n");
        assert!(
            list.iter()
                .all(|c| number(c, "pressure_mpa") <= 0.25 + 1e-12
                    && weakest(c) >= 300.0 / number(c, "count") - 1e-6)
        );
    }
}

#[test]
fn a_stroke_sets_what_is_open_and_a_load_is_its_pull() {
    let tube = json!({ "outer_diameter_mm": 40, "wall_mm": 2, "stroke_mm": 40 });
    assert!((number(&designed(tube)["candidates"][0], "length_mm") - 400.0).abs() < 1e-6);
    let stroke =
        json!({ "contraction": null, "stroke_mm": 28.5, "length_mm": 285, "continuous": true });
    let design = designed(stroke);
    assert!((number(&design["candidates"][0]["points"][0], "contraction") - 0.1).abs() < 1e-9);
    let stroke = |key: &str, value: Value| {
        designed(
            json!({ "contraction": null, "force_n": null, key: value, "stroke_mm": 40, "length_mm": 285 }),
        )
    };
    let (load, pull) = (
        stroke("load", "spring:4N/mm@40N".into()),
        stroke("force_n", 200.into()),
    );
    assert_eq!(load["candidates"], pull["candidates"]);
}

/// By hand: 7 circles have ρ = 3; what is required of one is a seventh.
#[test]
fn a_bundle_shares_the_requirement() {
    let tube = json!({ "outer_diameter_mm": { "low": 5, "high": 30 }, "wall_mm": 1, "force_n": 100, "count": 1 });
    let mut all = tube.clone();
    all["force_n"] = 700.into();
    all["count"] = 7.into();
    let (one, seven) = (designed(tube), designed(all.clone()));
    let (a, b, bundle) = (
        &one["candidates"][0],
        &seven["candidates"][0],
        &seven["bundle"],
    );
    assert!((number(a, "outer_diameter_mm") / number(b, "outer_diameter_mm") - 1.0).abs() < 1e-9);
    assert!((number(bundle, "envelope_mm") / number(b, "width_mm") - 3.0).abs() < 1e-12);
    all["max_envelope_mm"] = 60.into();
    let slim = designed(all);
    assert!(
        slim["bundle"].is_null() || number(&slim["bundle"], "envelope_mm") <= 60.0 + 1e-9,
        "{slim}"
    );
}

/// Half of the interval, and at its ends `force` says that an end of its own interval is the wanted
/// pull; with a load, the pull that it takes there.
#[test]
fn an_inverse_has_the_uncertainty_of_what_it_computes() {
    let p = reply(
        "pressure",
        json!({ "force_n": 500, "contraction": 0.1, "model": "thick-wall" }),
    );
    let half = 0.5 * (number(&p, "predicted_high_mpa") - number(&p, "predicted_low_mpa"));
    assert!((number(&p, "pressure_uncertainty_mpa") / half - 1.0).abs() < 1e-9);
    for (at, key) in [
        ("predicted_mpa", "predicted_n"),
        ("predicted_low_mpa", "predicted_high_n"),
        ("predicted_high_mpa", "predicted_low_n"),
    ] {
        let there = json!({ "pressure_mpa": p[at], "contraction": 0.1, "model": "thick-wall" });
        assert!(
            (number(&reply("force", there), key) / 500.0 - 1.0).abs() < 1e-5,
            "{at}"
        );
    }
    let load = json!({ "load": "spring:12N/mm@50N", "pressure_mpa": 0.25, "model": "thick-wall" });
    let l = reply("contraction", load);
    let there =
        json!({ "pressure_mpa": 0.25, "contraction": l["predicted"], "model": "thick-wall" });
    let load_n = 50.0 + 12.0 * 285.0 * number(&l, "predicted");
    assert!((number(&reply("force", there), "predicted_n") / load_n - 1.0).abs() < 1e-5);
    for key in ["pressure_uncertainty_mpa", "contraction_uncertainty"] {
        let force = reply(
            "force",
            json!({ "pressure_mpa": 0.25, "contraction": 0.1, "model": "thick-wall" }),
        );
        assert!(force.get(key).is_none(), "{key}");
    }
}

/// By hand from the pulls of `force`; a point without an answer is counted and in no error.
#[test]
fn errors_of_a_comparison_are_those_of_its_points() {
    let (pressures, contractions) = ([0.1, 0.2, 0.3], [0.0, 0.1]);
    let models = ["ideal", "paper", "thick-wall"];
    let compared = reply(
        "compare",
        json!({ "models": models, "pressures_mpa": pressures, "contractions": contractions }),
    );
    assert_eq!(compared["reference"], "ideal");
    let pulls = |model: &str| -> Vec<Option<f64>> {
        let points = pressures.iter().flat_map(|p| contractions.map(|e| (p, e)));
        let pull = |(p, e)| {
            let request =
                json!({ "pressure_mpa": p, "contraction": e, "model": model }).to_string();
            let answer =
                mckibben_app::ask("force", &request, &mckibben_core::progress::Silent).ok()?;
            serde_json::from_str::<Value>(&answer).unwrap()["force_n"].as_f64()
        };
        points.map(pull).collect()
    };
    let reference = pulls("ideal");
    for (row, model) in compared["models"].as_array().unwrap().iter().zip(models) {
        let both = pulls(model).into_iter().zip(&reference);
        let off: Vec<f64> = both.filter_map(|(a, b)| Some(a? - (*b)?)).collect();
        let n = off.len() as f64;
        for (key, by_hand) in [
            ("points", n),
            ("unanswered", 6.0 - n),
            ("rms_n", (off.iter().map(|d| d * d).sum::<f64>() / n).sqrt()),
            ("max_n", off.iter().map(|d| d.abs()).fold(0.0, f64::max)),
            ("mean_n", off.iter().sum::<f64>() / n),
        ] {
            let found = row[key].as_f64().unwrap_or_default();
            assert!(
                (found - by_hand).abs() < 1e-6,
                "{model} {key}: {found} {by_hand}"
            );
        }
    }
    // Above 0.25 MPa the formula has no answer.
    assert_eq!(compared["models"][1]["unanswered"], 2);
}
