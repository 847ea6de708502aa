//! C99: generic functions and the numbers of a muscle. A compiler for a microcontroller needs
//! nothing else.

use super::common;
use crate::{
    Artefact, ExportTarget, ExportedJoint, ExportedMuscle, File, Result,
    template::{list, lists, number, render},
};
use mckibben_core::joined;

pub const TARGET: ExportTarget = ExportTarget {
    name: "c",
    about: "C99 header and source, double or float, for controllers and simulators",
    needs: "a C99 compiler; of its library only sqrt, of a joint sin and cos too",
    loses: "nothing of the form",
    make,
    joint,
};

/// Name, what it is, and template of a file.
pub type Source = (&'static str, &'static str, &'static str);

/// The functions, and the numbers of a muscle.
pub const SOURCES: [Source; 4] = [
    (
        "mckibben.h",
        "the functions, the same for all muscles",
        include_str!("../../templates/mckibben.h"),
    ),
    (
        "mckibben.c",
        "their source",
        include_str!("../../templates/mckibben.c"),
    ),
    (
        "mckibben_memory.h",
        "friction with memory",
        include_str!("../../templates/mckibben_memory.h"),
    ),
    (
        "@{id}.h",
        "the numbers of the muscle",
        include_str!("../../templates/muscle.h"),
    ),
];

const EXAMPLES: [Source; 4] = [
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
    (
        "@{id}_observer.c",
        "an example: length and pull from pressure and air flow by a Kalman filter",
        include_str!("../../templates/observer.c"),
    ),
    (
        "mckibben_branch.h",
        "the inverse on a branch of the hysteresis",
        include_str!("../../templates/mckibben_branch.h"),
    ),
];

/// The functions of joints.
pub const MCKIBBEN_JOINT: Source = (
    "mckibben_joint.h",
    "the functions of joints",
    include_str!("../../templates/mckibben_joint.h"),
);

const JOINT: [Source; 3] = [
    (
        "@{id}.h",
        "the numbers of the joint",
        include_str!("../../templates/joint.h"),
    ),
    MCKIBBEN_JOINT,
    (
        "@{id}_example.c",
        "an example that compiles as its first line says",
        include_str!("../../templates/joint_example.c"),
    ),
];

fn make(muscle: &ExportedMuscle) -> Result<Artefact> {
    Ok(Artefact {
        files: files(muscle, &[&SOURCES[..], &EXAMPLES].concat()),
        notes: vec![],
    })
}

/// The files of its muscles, and its own.
fn joint(joint: &ExportedJoint) -> Result<Artefact> {
    let names: Vec<String> = joint
        .muscles
        .iter()
        .map(ExportedMuscle::identifier)
        .collect();
    let each = |one: fn(&String) -> String, between: &str| joined(names.iter().map(one), between);
    let mut values = joint.values(["{", "}"], |v| format!("MCKIBBEN_R({})", number(v)));
    values.push((
        "includes",
        each(|name| format!("#include \"{name}.h\""), "\n"),
    ));
    values.push(("addresses", each(|name| format!("&{name}"), ", ")));
    let own = JOINT.map(|(name, about, template)| {
        let text = render(template, &joint.facts(), &values);
        File::text(render(name, &[], &values).trim_end(), about, text)
    });
    let muscles = joint
        .muscles
        .iter()
        .flat_map(|muscle| files(muscle, &SOURCES));
    Ok(Artefact {
        files: own.into_iter().chain(muscles).collect(),
        notes: vec![],
    })
}

pub fn files(muscle: &ExportedMuscle, sources: &[Source]) -> Vec<File> {
    sources
        .iter()
        .map(|(name, about, template)| {
            File::text(
                rendered(name, muscle).trim_end(),
                about,
                rendered(template, muscle),
            )
        })
        .collect()
}

pub fn rendered(template: &str, muscle: &ExportedMuscle) -> String {
    let f = &muscle.form;
    let id = muscle.identifier();
    let braces = ["{", "}"];
    let one = |v: f64| format!("MCKIBBEN_R({})", number(v));
    let mut values = common(muscle);
    values.extend([
        ("ID", id.to_ascii_uppercase()),
        ("id", id),
        ("wanted", number(0.3 * muscle.blocked_force_n)),
        ("count", f.contractions.len().to_string()),
        ("c_nodes", list(&f.contractions, braces, one)),
        ("c_a", lists(&f.a, braces, one)),
        ("c_b", lists(&f.b, braces, one)),
        ("c_v", list(&f.v, braces, one)),
        (
            "c_friction",
            list(
                &[&f.friction_n[..], &[f.presliding_m]].concat(),
                braces,
                one,
            ),
        ),
    ]);
    render(template, &muscle.facts(), &values)
}
