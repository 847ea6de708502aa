//! To JSON; keys carry their unit.

use super::read::{FORMAT, POWERS};
use super::{Body, ErrorSummary, Formula, FormulaErrors, Made, MadeBraid, Provenance, paper_terms};
use serde_json::{Map, Value, json};

impl Formula {
    /// The formula as its file holds it, with a newline at the end. Reading it back gives the same formula to the bit.
    pub fn to_json(&self) -> String {
        format!("{:#}\n", self.to_value())
    }

    /// The formula as a JSON value.
    pub fn to_value(&self) -> Value {
        let mut map = Map::new();
        let mut put = |key: &str, value: Value| map.insert(key.to_owned(), value);
        put("format", json!(FORMAT));
        put("name", json!(self.name));
        put("kind", json!(self.kind()));
        put("equation", json!(self.equation()));
        match &self.body {
            Body::Paper(c) => {
                let one = |(name, unit, value)| json!({ "name": name, "unit": unit, "value": value });
                put("terms", paper_terms(c).into_iter().map(one).collect());
            }
            Body::Global(t) => {
                let s = &t.scales;
                put(
                    "scales",
                    json!({
                        "wall_ratio": s.wall_ratio, "pressure_mpa": s.pressure_mpa,
                        "contraction": s.contraction, "outer_diameter_mm": s.outer_diameter_mm,
                    }),
                );
                let one = |t: &super::Term| {
                    let powers = POWERS.iter().zip(t.powers).filter(|p| p.1 > 0);
                    let powers: Map<String, Value> =
                        powers.map(|(key, n)| ((*key).to_owned(), json!(n))).collect();
                    json!({ "name": t.name(), "powers": powers, "unit": "MPa", "value": t.value })
                };
                put("terms", t.terms.iter().map(one).collect());
            }
        }
        put("made_for", made(&self.made_for));
        let r = &self.range;
        put(
            "range",
            json!({
                "outer_diameter_mm": [r.outer_diameter_mm.0, r.outer_diameter_mm.1],
                "wall_mm": [r.wall_mm.0, r.wall_mm.1],
                "pressure_mpa": [r.pressure_mpa.0, r.pressure_mpa.1],
                "contraction": [r.contraction.0, r.contraction.1],
            }),
        );
        put("errors", errors(&self.errors));
        put("provenance", provenance(&self.provenance));
        Value::Object(map)
    }
}

fn made(m: &Made) -> Value {
    let braid = match m.braid {
        MadeBraid::Paper => json!({ "stiffness": "paper" }),
        MadeBraid::Inextensible => json!({ "stiffness": "inextensible" }),
        MadeBraid::Stiffness(k) => json!({ "stiffness_n_per_mm": k }),
        MadeBraid::TimesDiameter(k) => json!({ "stiffness_times_diameter_n": k }),
    };
    let constants: Map<String, Value> = m.constants.iter().map(|(k, v)| (k.clone(), json!(v))).collect();
    json!({
        "length_mm": m.length_mm,
        "angle_deg": m.angle_deg,
        "rubber": {
            "name": m.rubber, "law": m.law, "constants": constants, "bulk_modulus_mpa": m.bulk_modulus_mpa,
        },
        "braid": braid,
    })
}

/// Keys and values of a summary.
pub(super) fn summary(e: &ErrorSummary) -> Map<String, Value> {
    [
        ("points", json!(e.points)),
        ("rms_of_blocked", json!(e.rms)),
        ("p95_of_blocked", json!(e.p95)),
        ("max_of_blocked", json!(e.max)),
        ("max_n", json!(e.max_n)),
        ("max_of_isobar", json!(e.max_12)),
    ]
    .into_iter()
    .map(|(k, v)| (k.to_owned(), v))
    .collect()
}

fn errors(e: &FormulaErrors) -> Value {
    let joined = |first: Vec<(&str, Value)>, e: &ErrorSummary| {
        let mut map: Map<String, Value> = first.into_iter().map(|(k, v)| (k.to_owned(), v)).collect();
        map.extend(summary(e));
        Value::Object(map)
    };
    let regions: Vec<Value> = e
        .regions
        .iter()
        .map(|r| joined(vec![("quantity", json!(r.quantity)), ("value", json!(r.value))], &r.errors))
        .collect();
    let held_out = e
        .held_out
        .as_ref()
        .map(|h| joined(vec![("outer_diameters_mm", json!(h.outer_diameters_mm))], &h.errors));
    json!({ "against": e.against, "fit": summary(&e.fit), "held_out": held_out, "regions": regions })
}

pub(super) fn provenance(p: &Provenance) -> Value {
    json!({
        "program": "mckibben",
        "version": p.version,
        "method": p.method,
        "points": p.points,
        "data_hash": p.data_hash,
        "table": p.table,
        "plan_hash": p.plan_hash,
        "seed": p.seed,
    })
}
