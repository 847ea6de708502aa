//! Muscle → text that [`parse_muscle`](super::parse_muscle) reads back as the same muscle.

use super::{
    keys::{Keys, description, join, properties},
    material::of_constant,
    read::MuscleFile,
    text::{Text, percent, quantity, text},
};
use crate::{
    joined,
    muscle::{
        Braid, BraidStiffness, Conditioned, Measure, Muscle, Rubber,
        measures::{STRANDS_FACTOR, STRENGTH_FACTOR, of_section},
    },
    rubber::library,
    sleeve::{self, Sleeve, SleeveShape},
};
use mckibben_units::saved;
use serde_json::{Value, json};
use std::sync::LazyLock;

/// What the keys of a file are.
static KEYS: LazyLock<Value> = LazyLock::new(|| Keys::of::<MuscleFile>().0);

/// The text of a muscle file. Reading it gives the same muscle to fifteen digits, save that a
/// cross-section of strands which the braid's stiffness does not use becomes a comment.
pub fn to_toml(muscle: &Muscle) -> String {
    let mut out = Text::default();
    out.line(concat!(
        "# McKibben muscle, written by mckibben ",
        env!("CARGO_PKG_VERSION"),
        "."
    ));
    out.line("# A number without unit is in mm, MPa, N, N/mm, mm2 or degrees.");
    // Editors complete and check the file with what
    // `mckibben schema --file muscle -o muscle.schema.json` writes beside it.
    out.line("#:schema muscle.schema.json");
    let ends = muscle.terminals();
    let file = json!({
        "tube": tube(muscle),
        "braid": braid(muscle),
        "terminals": with_measures(json!({ "made": ends.made }), muscle, "terminals"),
        "friction": with_measures(json!({}), muscle, "friction"),
        "model": { "tondu-lopez": { "end_factor": ends.end_factor } },
        "job": muscle.job(),
        "identified": muscle.bench(),
    });
    let mut keys = KEYS.clone();
    let law = muscle.tube().rubber.law.kind();
    // A letter may be another constant in another law.
    let of_material = keys.pointer_mut("/properties/tube/properties/material/anyOf/0/properties");
    if let Some(of_material) = of_material {
        for constant in law.constants {
            of_material[constant.name] = of_constant(law, constant);
        }
    }
    out.table("", &file, &keys);
    out.0
}

impl Text {
    /// The entries of a table, and the tables in it; tables further inside are written on a line.
    fn table(&mut self, path: &str, table: &Value, keys: &Value) {
        let is_table =
            |path: &str, value: &Value| value.is_object() && path.matches('.').count() < 2;
        let mut begins = !path.is_empty();
        let entries = table.as_object().into_iter().flatten();
        for (key, value) in entries.filter(|entry| !entry.1.is_null()) {
            let dotted = join(path, key);
            let schema = properties(keys)
                .and_then(|all| all.get(key))
                .unwrap_or(&Value::Null);
            if is_table(&dotted, value) {
                self.table(&dotted, value, schema);
                continue;
            }
            if std::mem::take(&mut begins) {
                self.line(&format!("\n[{path}]"));
            }
            self.key(key, &written(value, schema), &comment(schema));
        }
    }
}

/// A value with its unit.
fn written(value: &Value, schema: &Value) -> String {
    match value {
        Value::String(word) => text(word),
        Value::Array(list) => {
            let one = |(i, value): (usize, &Value)| {
                let items = &schema["items"];
                written(value, items.get(i).unwrap_or(items))
            };
            format!("[{}]", joined(list.iter().enumerate().map(one), ", "))
        }
        Value::Object(table) => {
            let keys = properties(schema);
            let one = |(key, value): (&String, &Value)| {
                format!(
                    "{key} = {}",
                    written(
                        value,
                        keys.and_then(|keys| keys.get(key)).unwrap_or(&Value::Null)
                    )
                )
            };
            format!("{{ {} }}", joined(table.iter().map(one), ", "))
        }
        Value::Number(x) => match (unit(schema), x.as_f64()) {
            (Some(unit), Some(x)) => text(&quantity(x, unit)),
            (None, Some(float)) if x.is_f64() => format!("{:?}", saved(float)),
            _ => x.to_string(),
        },
        other => other.to_string(),
    }
}

/// The unit of the numbers that may have one.
fn unit(schema: &Value) -> Option<&str> {
    let mut choices = schema["anyOf"].as_array().into_iter().flatten();
    match schema.get("x-quantity") {
        Some(_) => schema["x-unit"].as_str(),
        None => choices.find_map(unit),
    }
}

/// The sentence about a key, unless it has another one or none.
fn comment(schema: &Value) -> String {
    let own = schema["x-comment"].as_str().map(str::to_owned);
    own.or(description(schema)).unwrap_or_default()
}

/// A table with the measures that are stated and have no rules of their own.
fn with_measures(mut table: Value, muscle: &Muscle, section: &str) -> Value {
    for m in of_section(section).filter(|m| !m.has_rules) {
        table[m.name()] = json!(muscle.measure(m));
    }
    table
}

fn tube(muscle: &Muscle) -> Value {
    let mut tube = with_measures(json!({}), muscle, "tube");
    let rubber = &muscle.tube().rubber;
    let is_named =
        |name: &&str| library::find_for(name, muscle.reach()).is_ok_and(|r| r == *rubber);
    if let Some(name) = rubber.name.as_deref().filter(is_named) {
        tube["rubber"] = name.into();
        return tube;
    }
    let mut material = json!(Rubber {
        fitted_to_stretch: rubber.fitted_to_stretch.filter(|stretch| *stretch > 0.0),
        ..rubber.clone()
    });
    if let Some(strain) = rubber.elongation_at_break {
        material["elongation_at_break"] = percent(strain).into();
    }
    if let Some(Conditioned::Strain { strain }) = rubber.conditioned {
        material["conditioned"] = percent(strain).into();
    }
    tube["material"] = material;
    tube
}

fn braid(muscle: &Muscle) -> Value {
    let braid = muscle.braid();
    let outer_diameter_mm = muscle.outer_diameter_mm();
    let sleeve = named_sleeve(braid, outer_diameter_mm);
    let own = sleeve
        .as_ref()
        .filter(|s| library_sleeve(&s.shape).is_none())
        .map(Sleeve::diameters);
    let on_tube = braid.clone().on_diameter(outer_diameter_mm);
    let is_usual = sleeve.is_some() && on_tube.map(|b| b.angle_deg) == Ok(braid.angle_deg);
    let stiffness = Some(braid.stiffness).filter(|k| *k != BraidStiffness::OfStrands);
    // What the sleeve says by itself need not be written.
    let known = sleeve.as_ref().and_then(|sleeve| match stiffness {
        Some(_) => sleeve.strands_beside_stiffness(),
        None => sleeve.of_strands().ok(),
    });
    let strands = braid.strands.filter(|s| known != Some(*s));
    let follows = match &sleeve {
        Some(sleeve) if stiffness.is_none() && braid.strands == known => sleeve.stiffness_factor(),
        _ => 1.0,
    };
    let of_sleeve = sleeve.as_ref().and_then(|s| s.strands_per_carrier);
    let factor = |m: &Measure| strands.and_then(|_| muscle.measure(m));
    let table = json!({
        "name": sleeve.as_ref().map(Sleeve::name),
        "least_diameter": own.map(|d| d.0),
        "largest_diameter": own.map(|d| d.1),
        "angle": (!is_usual).then_some(braid.angle_deg),
        "stiffness": stiffness,
        "strands": strands.map(|s| s.count),
        "strand_area": strands.and_then(|s| s.area_mm2),
        "strand_modulus": strands.and_then(|s| s.modulus_mpa).filter(|_| stiffness.is_none()),
        "strand_strength": strands.and_then(|s| s.strength_n),
        "strands_factor": factor(&STRANDS_FACTOR),
        "strand_strength_factor": factor(&STRENGTH_FACTOR),
        "stiffness_factor": Some(braid.stiffness_factor).filter(|factor| *factor != follows),
        "strands_per_carrier": braid.strands_per_carrier.filter(|b| Some(*b) != of_sleeve),
    });
    let mut table = with_measures(table, muscle, "braid");
    table["compression"] = json!(braid.compression.then_some(true));
    table["in_rubber"] = json!(braid.in_rubber.then_some(true));
    table
}

/// The sleeve of the library that has this shape.
fn library_sleeve(shape: &SleeveShape) -> Option<Sleeve> {
    Some(sleeve::library::find(&shape.name).ok()?).filter(|s| s.shape == *shape)
}

/// The sleeve that the braid was cut from, where its name and angle may be written together in a
/// file.
fn named_sleeve(braid: &Braid, outer_diameter_mm: f64) -> Option<Sleeve> {
    let shape = braid.sleeve.as_ref()?;
    let own = || {
        let sleeve = sleeve::library::between("pet", shape.least_mm, shape.largest_mm).ok()?;
        let is_unknown = sleeve::library::find(&shape.name).is_err();
        Some(sleeve.named(Some(&shape.name))).filter(|s| is_unknown && s.shape == *shape)
    };
    let sleeve = library_sleeve(shape).or_else(own)?;
    braid
        .clone()
        .with_stated_angle(braid.angle_deg, outer_diameter_mm)
        .is_ok()
        .then_some(sleeve)
}
