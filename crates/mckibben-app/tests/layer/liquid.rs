//! Muscles that are filled with a liquid: `design` and `fill` on the same way.

use super::{refusal, reply};
use mckibben_app::ProblemKind;
use serde_json::{Value, json};

fn number(value: &Value, key: &str) -> f64 {
    value[key]
        .as_f64()
        .unwrap_or_else(|| panic!("{key} of {value}"))
}

/// The volume of a designed muscle, pushed into it against the pull that was required, brings it to
/// the pressure and the contraction of the design.
#[test]
fn the_liquid_of_a_design_pushed_in_by_fill_gives_back_its_point() {
    for (model, liquid) in [
        ("thick-wall", json!({ "liquid": "water" })),
        (
            "thick-wall",
            json!({ "liquid": "oil", "gas_share": 0.02, "dead_volume_mm3": 5000, "liquid_bulk_modulus_mpa": 900 }),
        ),
        (
            "fe",
            json!({ "liquid": "glycol", "gas_share": 0.01, "dead_volume_mm3": 2000 }),
        ),
    ] {
        let with_liquid = |request: Value| {
            let mut request = request;
            request
                .as_object_mut()
                .unwrap()
                .extend(liquid.as_object().unwrap().clone());
            request
        };
        let wanted = json!({ "force_n": 300, "contraction": 0.1, "max_pressure_mpa": 0.25, "model": model,
            "outer_diameter_mm": 32, "wall_mm": 1.5,
            "muscle": { "name": "smooth.toml", "text": "[friction]\ncoefficient = 1e-9\nexponent = \
                0\n" } });
        let design = reply("design", with_liquid(wanted));
        let best = &design["candidates"][0];
        assert_eq!(
            (&design["liquid"]["name"], &best["air_normal_litres"]),
            (&liquid["liquid"], &Value::Null)
        );
        let filled = reply(
            "fill",
            with_liquid(
                json!({ "muscle": { "file": design["muscle_files"][0] }, "model": model, "load": "force:300N", "volume_mm3": best["liquid_volume_mm3"] }),
            ),
        );
        let point = &best["points"][0];
        for key in ["pressure_mpa", "contraction", "force_n"] {
            let (ours, wanted) = (number(&filled, key), number(point, key));
            assert!(
                (ours / wanted - 1.0).abs() < 1e-6,
                "{model}: {key} {ours} {wanted}"
            );
        }
    }
}

/// N muscles share what there is: the limit of one times N is where a bundle fits, and together
/// they take N times the volume of one.
#[test]
fn a_bundle_shares_the_liquid() {
    let bundle = |force_n: f64, bundle: u32, max: f64| {
        reply(
            "design",
            json!({ "force_n": force_n, "contraction": 0.1, "max_pressure_mpa": 0.25, "model": "thick-wall",
                "outer_diameter_mm": 32, "wall_mm": 1.5, "liquid": "water", "count": bundle,
                "max_liquid_volume_mm3": max }),
        )
    };
    let one = number(&bundle(300.0, 1, 1e9)["candidates"][0], "liquid_volume_mm3");
    let four = bundle(1200.0, 4, 4.0 * one * (1.0 + 1e-6));
    assert!((number(&four["candidates"][0], "liquid_volume_mm3") / one - 1.0).abs() < 1e-6);
    let refused = bundle(1200.0, 4, 4.0 * one * (1.0 - 1e-6));
    assert_eq!(
        (&refused["candidates"], &refused["closest"]["limit"]),
        (&json!([]), &json!("liquid_volume"))
    );
}

#[test]
fn what_belongs_to_a_liquid_is_refused_without_one() {
    let wanted = json!({ "force_n": 300, "contraction": 0.1, "max_pressure_mpa": 0.25 });
    for field in [
        "max_liquid_volume_mm3",
        "gas_share",
        "dead_volume_mm3",
        "liquid_bulk_modulus_mpa",
    ] {
        let mut request = wanted.clone();
        request[field] = json!(0.5);
        let problem = refusal("design", request);
        assert_eq!(problem.kind, ProblemKind::Usage, "{problem:?}");
        let said = &problem.message;
        assert!(
            said.contains(&format!("`{field}`")) && said.contains("`liquid`"),
            "{problem:?}"
        );
    }
    let mut request = wanted;
    request["liquid"] = json!("watr");
    let problem = refusal("design", request);
    assert_eq!(problem.field.as_deref(), Some("liquid"));
}

/// The liquid of a free stroke, pushed into the muscle that is held there, has the pressure of
/// `check`; of the air that is not in it nothing is said, on no page.
#[test]
fn a_muscle_whose_job_names_a_liquid_has_no_air() {
    let text = |job: &str| {
        let tube = "[tube]\nouter_diameter = 32\nwall_thickness = 1.5\nlength = 200\n";
        json!({ "file": { "name": "m.toml", "text": format!("{tube}[job]\npressure = \"2 bar\"\n{job}") } })
    };
    let [wet, dry] = ["liquid = \"water\"", ""].map(text);
    let of = |muscle: &Value| reply("check", json!({ "muscle": muscle, "model": "thick-wall" }));
    let values = &of(&wet)["characteristics"];
    assert_eq!(values["air_normal_litres"], Value::Null);
    let filled = reply(
        "fill",
        json!({ "muscle": wet, "model": "thick-wall", "volume_mm3": values["liquid_volume_mm3"],
            "contraction": values["free_contraction"] }),
    );
    assert!(
        (number(&filled, "pressure_mpa") / 0.2 - 1.0).abs() < 1e-6,
        "{filled}"
    );
    let values = &of(&dry)["characteristics"];
    assert!(number(values, "air_normal_litres") > 0.0 && values["liquid_volume_mm3"].is_null());
    for (muscle, is_dry) in [(&wet, false), (&dry, true)] {
        let build = reply("build", json!({ "muscle": muscle }));
        assert_eq!(build["air_energy_j"].is_number(), is_dry);
        let hung = json!({ "muscle": muscle, "model": "thick-wall", "load": "100 N",
            "test": "isobaric", "pressures_mpa": [0.1, 0.2] });
        let hung = reply("curve", hung);
        assert_eq!(
            hung["loaded"]["cycle"]["air_normal_litres"].is_number(),
            is_dry,
            "{hung}"
        );
    }
}
