//! The plan of a campaign: a muscle file with three more tables.

use super::muscle;
use super::parts::{boolean, needing, root, table, text, values, word};
use mckibben::muscle::measures::{SECTIONS, of_section};
use mckibben::rubber::Law;
use mckibben_fem::elements::Elements;
use serde_json::{Map, Value, json};

pub(super) fn schema() -> Value {
    let whole = |about: &str| json!({ "type": "integer", "minimum": 0, "description": about });
    let sampling = [
        ("method", word("How muscles are taken from the ranges", ["factorial", "latin-hypercube", "sobol"])),
        ("samples", whole("Number of muscles; not of a factorial plan")),
        ("seed", whole("Seed of the random numbers; not of a factorial plan")),
    ];
    let test = [
        ("contractions", values("Contractions")),
        ("of_ideal", boolean("Whether contractions are shares of the largest of the ideal muscle")),
        ("pressures", values("Pressures")),
        ("model", word("Finite elements", Elements::ENTRIES.map(|entry| entry.name))),
        ("mesh", text("Another mesh than the default")),
        ("sensitivities", boolean("Whether each row has derivatives of the pull; of fe alone")),
    ];
    let more = [
        ("sampling", table("How the muscles are sampled", sampling)),
        ("vary", vary()),
        ("test", needing(table("The points of each muscle", test), &["contractions", "pressures"])),
    ];
    let mut file = root(muscle::tables().into_iter().chain(more));
    file["required"] = json!(["test"]);
    file
}

/// Ratios and factors that vary beside the measures.
const OTHERS: [(&str, &str, &str); 3] = [
    ("tube", "wall_ratio", "Wall over outer diameter"),
    ("tube", "length_ratio", "Length over outer diameter"),
    ("braid", "stiffness_per_diameter", "Stiffness of a strand family over the outer diameter"),
];

fn vary() -> Value {
    let sections = SECTIONS.map(|section| {
        let others = OTHERS.iter().filter(|other| other.0 == section);
        let mut keys: Map<String, Value> = of_section(section)
            .map(|measure| (measure.name().to_owned(), values(measure.about())))
            .chain(others.map(|(_, key, about)| ((*key).to_owned(), values(about))))
            .collect();
        if section == "tube" {
            let constants = Law::KINDS.iter().filter(|kind| !kind.is_sum).flat_map(|kind| kind.constants);
            let constants = constants.map(|constant| (constant.name.to_owned(), values(constant.doc)));
            let scale = ("scale".to_owned(), values("Factor of all moduli of the law"));
            keys.insert("material".into(), table("Constants of the law", constants.chain([scale])));
        }
        (section, table("What of it varies", keys))
    });
    table("What varies", sections)
}
