//! C99: generic functions and the numbers of a muscle. A compiler for a microcontroller needs
//! nothing else.

use super::values;
use crate::{
    Artefact, ExportTarget, ExportedJoint, ExportedMuscle, File, Result,
    template::{number, render},
};
use mckibben_core::joined;

pub const TARGET: ExportTarget = ExportTarget {
    name: "c",
    about: "C99 header and source, double or float, for controllers and simulators",
    needs: "a C99 compiler; of its library sqrt, of a joint sin and cos too",
    loses: "nothing of the form",
    make,
    joint,
};

/// Name, what it is, and template of a file.
pub type Source = (&'static str, &'static str, &'static str);

/// The functions, and the numbers of a muscle.
pub const SOURCES: [Source; 3] = [
    (
        "mckibben.h",
        "the functions, the same for all muscles and joints",
        include_str!("../../templates/mckibben.h"),
    ),
    (
        "mckibben.c",
        "their source",
        include_str!("../../templates/mckibben.c"),
    ),
    (
        "@{id}.h",
        "the numbers of the muscle",
        include_str!("../../templates/muscle.h"),
    ),
];

const EXAMPLES: [Source; 2] = [
    (
        "@{id}_example.c",
        "an example that compiles as its first line says",
        include_str!("../../templates/example.c"),
    ),
    (
        "@{id}_loop.ino",
        "a sketch for Arduino: a closed loop that holds a pull",
        include_str!("../../templates/pressure_loop.ino"),
    ),
];

const JOINT: [Source; 2] = [
    (
        "@{id}.h",
        "the numbers of the joint",
        include_str!("../../templates/joint.h"),
    ),
    (
        "@{id}_example.c",
        "an example that compiles as its first line says",
        include_str!("../../templates/joint_example.c"),
    ),
];

fn real(value: f64) -> String {
    format!("MCKIBBEN_R({})", number(value))
}

fn make(muscle: &ExportedMuscle) -> Result<Artefact> {
    Ok(Artefact {
        files: [files(muscle, &SOURCES), files(muscle, &EXAMPLES)].concat(),
    })
}

/// Its own files, and those of its muscles.
fn joint(joint: &ExportedJoint) -> Result<Artefact> {
    let names = Vec::from_iter(joint.muscles.iter().map(ExportedMuscle::identifier));
    let include = |name: &String| format!("#include \"{name}.h\"");
    let mut values = joint.values(["{", "}"], real);
    values.extend([
        ("includes", joined(names.iter().map(include), "\n")),
        (
            "addresses",
            joined(names.iter().map(|name| format!("&{name}")), ", "),
        ),
    ]);
    let own = rendered(&JOINT, &joint.facts(), &values);
    let muscles = joint
        .muscles
        .iter()
        .flat_map(|muscle| files(muscle, &SOURCES));
    Ok(Artefact {
        files: own.into_iter().chain(muscles).collect(),
    })
}

/// The files of a muscle.
pub fn files(muscle: &ExportedMuscle, sources: &[Source]) -> Vec<File> {
    rendered(sources, &muscle.facts(), &values(muscle, ["{", "}"], real))
}

fn rendered(sources: &[Source], facts: &[String], values: &[(&str, String)]) -> Vec<File> {
    let one = |(name, about, template): &Source| {
        File::text(
            render(name, &[], values).trim_end(),
            about,
            render(template, facts, values),
        )
    };
    sources.iter().map(one).collect()
}
