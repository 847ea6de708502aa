//! A model that is asked by name answers for itself, and a formula carries its muscle.

use crate::{refusal, reply};
use mckibben_app::{CampaignRequest, TextFile, campaign};
use mckibben_core::progress::Silent;
use serde_json::{Value, json};

fn winner(model: Value, request: Value) -> Value {
    let mut request = request;
    request["model"] = model;
    reply("design", request)["candidates"][0].clone()
}

/// 700 N at 15 % and 2.5 bar by formula (11), solved for D0 by another program (issue 69). In an
/// interval of 0.2 mm the search takes the next 0.05 mm.
#[test]
fn formula_11_gives_the_diameters_of_an_independent_solution() {
    let of_wall = [
        (1.0, 37.64),
        (1.5, 38.38),
        (2.0, 39.20),
        (3.0, 41.07),
        (3.5, 42.15),
        (5.0, 46.22),
    ];
    for (wall_mm, diameter_mm) in of_wall {
        let request = json!({ "force_n": 700, "contraction": 0.15, "max_pressure_mpa": 0.25,
            "wall_mm": wall_mm, "objective": "diameter",
            "outer_diameter_mm": { "low": diameter_mm - 0.1, "high": diameter_mm + 0.1 } });
        let best = winner(json!("paper"), request);
        let found_mm = best["outer_diameter_mm"].as_f64().unwrap();
        assert!(
            (-0.015..0.055).contains(&(found_mm - diameter_mm)),
            "{wall_mm}: {found_mm}"
        );
        // Its pull is that of `force` of the same muscle and model.
        let point = &best["points"][0];
        let asked = json!({ "model": "paper", "pressure_mpa": best["pressure_mpa"],
            "contraction": 0.15, "muscle": { "outer_diameter_mm": found_mm, "wall_mm": wall_mm } });
        let force_n = reply("force", asked)["force_n"].as_f64().unwrap();
        assert!((force_n - 700.0).abs() < 1e-3, "{force_n}");
        assert_eq!(point["friction_n"], 0.0);
        // A muscle that is built shortens against its friction.
        assert!(point["predicted_n"].as_f64().unwrap() < 0.9 * force_n);
    }
}

/// On a branch a model that is named meets the requirement with its friction, as `force` has it.
#[test]
fn the_branch_that_is_asked_is_that_of_force() {
    for (direction, sign) in [("contraction", -1.0), ("elongation", 1.0)] {
        let request = json!({ "force_n": 700, "contraction": 0.15, "max_pressure_mpa": 0.25,
            "wall_mm": 1, "direction": direction });
        let best = winner(json!("paper"), request);
        let mut asked = json!({ "model": "paper", "pressure_mpa": best["pressure_mpa"],
            "contraction": 0.15, "direction": direction,
            "muscle": { "outer_diameter_mm": best["outer_diameter_mm"], "wall_mm": 1 } });
        let on_branch_n = reply("force", asked.clone())["force_n"].as_f64().unwrap();
        assert!((on_branch_n - 700.0).abs() < 1e-3, "{on_branch_n}");
        asked["direction"] = json!("mean");
        let mean_n = reply("force", asked)["force_n"].as_f64().unwrap();
        let friction_n = best["points"][0]["friction_n"].as_f64().unwrap();
        assert!(
            (on_branch_n - mean_n - friction_n).abs() < 1e-3,
            "{friction_n}"
        );
        assert!(sign * friction_n > 50.0, "{friction_n}");
    }
}

/// The method of the paper for another muscle: plan → `fit` → `design` with nothing repeated. Finite
/// elements of the winner are within the formula's own largest error.
#[test]
fn a_formula_of_another_make_designs_without_repeating_it() {
    let folder = std::env::temp_dir().join(format!("mckibben-make-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let table = folder.join("own.parquet");
    let text = "[tube]\nlength = \"200 mm\"\nrubber = \"dragon-skin-30\"\n[braid]\nangle = \"24 deg\"\n\
        stiffness = \"paper\"\n[sampling]\nmethod = \"factorial\"\n[vary]\n\
        tube.outer_diameter = \"20..35:5 mm\"\ntube.wall_thickness = \"1..3:1 mm\"\n[test]\n\
        contractions = \"0..0.20:0.05\"\npressures = \"0..2.5:0.5 bar\"\n";
    let plan = Some(TextFile {
        name: "plan.toml".into(),
        text: text.into(),
    });
    let output = Some(table.clone());
    let request = CampaignRequest {
        plan,
        output,
        ..Default::default()
    };
    campaign(&request, &Silent).unwrap();
    for method in ["paper", "global"] {
        let formula = reply("fit", json!({ "campaign": table, "method": method }));
        let made = &formula["made_for"];
        assert_eq!(made["rubber"]["name"], "dragon-skin-30");
        let model = json!({ "name": { "name": "own.json", "text": formula.to_string() } });
        let best = winner(
            model.clone(),
            json!({ "force_n": 300, "contraction": 0.15 }),
        );
        assert_eq!([&best["length_mm"], &best["angle_deg"]], [200.0, 24.0]);
        let measures = json!({ "outer_diameter_mm": best["outer_diameter_mm"],
            "wall_mm": best["wall_mm"], "length_mm": 200, "angle_deg": 24, "rubber": { "name": "r",
            "text": material(made) } });
        let at = |pressure: &Value, contraction: f64, model: Value| {
            let asked = json!({ "model": model, "pressure_mpa": pressure,
                "contraction": contraction, "muscle": measures });
            reply("force", asked)["force_n"].as_f64().unwrap()
        };
        let elements_n = at(&best["pressure_mpa"], 0.15, json!("fe"));
        let blocked_n = at(&json!(0.25), 0.0, json!("fe"));
        let largest = formula["errors"]["fit"]["max_of_blocked"].as_f64().unwrap();
        let error = (elements_n - 300.0).abs() / blocked_n;
        assert!(error < largest, "{method}: {error} of {largest}");
        // Its name alone is the formula's rubber too; another one is named with its field.
        let named = |rubber: &str| {
            json!({ "model": model, "pressure_mpa": 0.2, "contraction": 0.1,
                "muscle": { "rubber": rubber } })
        };
        reply("force", named("dragon-skin-30"));
        let other = refusal("force", named("ecoflex-00-30")).message;
        assert!(other.contains("(`rubber`)"), "{other}");
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

/// A muscle file with the rubber of a formula.
fn material(made: &Value) -> String {
    let constants = made["rubber"]["constants"].as_object().unwrap();
    let lines = constants
        .iter()
        .map(|(name, value)| format!("{} = \"{value} MPa\"\n", name.trim_end_matches("_mpa")));
    let law = made["rubber"]["law"].as_str().unwrap();
    format!(
        "[tube.material]\nlaw = \"{law}\"\n{}",
        lines.collect::<String>()
    )
}

/// A muscle whose friction is not known pulls as the model says, built or not: nothing stands beside
/// it, and one that extends does not shorten.
#[test]
fn where_no_friction_is_known_a_built_muscle_is_that_of_the_model() {
    let request = json!({ "force_n": -60, "contraction": -0.1, "max_pressure_mpa": 0.3,
        "length_mm": 150 });
    let answer = reply("design", request);
    let mut lines = answer["decision"].as_array().unwrap().iter();
    let is_pull = |line: &&Value| line.as_str().unwrap().starts_with("Pulls ");
    let pulls = lines.find(is_pull).unwrap().as_str().unwrap();
    assert!(pulls.starts_with("Pulls "), "{pulls}");
    assert!(!pulls.contains("shortens"), "{pulls}");
    let point = &answer["candidates"][0]["points"][0];
    let [built, wanted] = ["predicted_n", "required_n"].map(|key| point[key].as_f64().unwrap());
    assert!((built / wanted - 1.0).abs() < 1e-6, "{point}");
}

/// Row 3 of the issue: of a braid by its strands k falls with 1/D0, and the formula of such a table
/// was refused on its own muscles. It brings its strands; finite elements of its muscle agree.
#[test]
fn a_formula_of_counted_strands_brings_its_muscle() {
    let folder = std::env::temp_dir().join(format!("mckibben-strands-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let table = folder.join("strands.parquet");
    let braid = "angle = \"24 deg\"\nstrands = 96\nstrand_area = \"0.05 mm2\"\n\
        strand_modulus = \"8 GPa\"\n";
    let text = format!(
        "[tube]\nlength = \"200 mm\"\n[braid]\n{braid}[vary]\n\
         tube.outer_diameter = \"20..35:5 mm\"\ntube.wall_thickness = \"1..3:1 mm\"\n[test]\n\
         contractions = \"0..0.20:0.05\"\npressures = \"0..2.5:0.5 bar\"\n"
    );
    let request = CampaignRequest {
        plan: Some(TextFile {
            name: "plan.toml".into(),
            text,
        }),
        output: Some(table.clone()),
        ..Default::default()
    };
    campaign(&request, &Silent).unwrap();
    let formula = reply("fit", json!({ "campaign": table }));
    assert_eq!(formula["kind"], "global");
    assert_eq!(formula["made_for"]["strands"]["count"], 96);
    let model = json!({ "name": { "name": "strands.json", "text": formula.to_string() } });
    let largest = formula["errors"]["fit"]["max_of_blocked"].as_f64().unwrap();
    for d in [20.0, 27.5, 35.0] {
        let at = |model: &Value, contraction: f64, muscle: Value| {
            let asked = json!({ "model": model, "pressure_mpa": 0.25, "contraction": contraction,
                "muscle": muscle });
            reply("force", asked)["force_n"].as_f64().unwrap()
        };
        let file = format!(
            "[tube]\nouter_diameter = {d}\nwall_thickness = 2\nlength = 200\n[braid]\n{braid}"
        );
        let own = || json!({ "file": { "name": "m.toml", "text": file } });
        let fe = json!({ "name": "fe" });
        let (blocked_n, fe_n) = (at(&fe, 0.0, own()), at(&fe, 0.1, own()));
        // By the flags alone, and by a file that states the strands.
        let flags = json!({ "outer_diameter_mm": d, "wall_mm": 2 });
        for muscle in [flags, own()] {
            let error = (at(&model, 0.1, muscle) - fe_n).abs() / blocked_n;
            assert!(error < 2.0 * largest + 0.002, "{d}: {error} of {largest}");
        }
    }
    let best = winner(
        model.clone(),
        json!({ "force_n": 300, "contraction": 0.15 }),
    );
    assert_eq!([&best["length_mm"], &best["angle_deg"]], [200.0, 24.0]);
    reply("export", json!({ "target": "c", "model": model }));
    std::fs::remove_dir_all(&folder).unwrap();
}
