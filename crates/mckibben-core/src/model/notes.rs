//! Notes: which data of a muscle a model does not use, in sentences.

use crate::{
    joined,
    muscle::{Bulk, Muscle},
};

/// Of a model that takes the strands as straight ones on the surface of a tube that fills its
/// sleeve, the tube as mounted without a stretch, and its rubber as on its first inflation.
pub fn of_a_simple_tube(model: &str, muscle: &Muscle) -> Vec<String> {
    strands_on_the_tube(model, muscle)
        .into_iter()
        .chain(first_inflation(model, muscle))
        .collect()
}

fn strands_on_the_tube(model: &str, muscle: &Muscle) -> Option<String> {
    let braid = muscle.braid();
    let keys = [
        ("braid.thickness", braid.thickness_mm > 0.0),
        (
            "braid.diameter",
            braid
                .diameter_mm
                .is_some_and(|d| d > muscle.outer_diameter_mm()),
        ),
        ("braid.crimp", braid.crimp.is_some()),
    ];
    let stated = joined(keys.into_iter().filter(|k| k.1).map(|k| k.0), ", ");
    let strands = (!stated.is_empty())
        .then(|| format!("{model} assumes straight strands on the tube: {stated} not used"));
    let tube = (muscle.tube().prestretch != 1.0).then(|| {
        format!("{model} assumes a tube mounted without stretch: tube.prestretch not used")
    });
    let all = strands.into_iter().chain(tube).chain(plugs(model, muscle));
    let all = joined(all, "; ");
    (!all.is_empty()).then_some(all)
}

/// Of a model whose plugs have the diameter of the bore.
pub fn plugs(model: &str, muscle: &Muscle) -> Option<String> {
    muscle.terminals().plug_diameter_mm.map(|_| {
        format!(
            "{model} assumes plugs with the diameter of the bore: terminals.plug_diameter not used"
        )
    })
}

/// Of a model that takes the rubber as on its first inflation.
pub fn first_inflation(model: &str, muscle: &Muscle) -> Option<String> {
    muscle.tube().rubber.is_conditioned().then(|| {
        format!("{model} assumes rubber on its first inflation: tube.material.conditioned not used")
    })
}

/// Of a model that takes the rubber as incompressible.
pub fn incompressible(model: &str, muscle: &Muscle) -> Option<String> {
    match muscle.tube().rubber.bulk {
        Bulk::Incompressible => None,
        Bulk::Modulus(_) => Some(format!(
            "{model} assumes incompressible rubber; its bulk modulus is not used"
        )),
    }
}
