//! Rust: one file without `std` and other crates, for firmware.

use super::values;
use crate::{
    Artefact, ExportTarget, ExportedJoint, ExportedMuscle, File, Result,
    form::Node,
    template::{list, lists, number, render},
};
use mckibben_core::joined;

pub const TARGET: ExportTarget = ExportTarget {
    name: "rust",
    about: "one Rust file without std, f32 or f64, for firmware",
    needs: "Rust from 1.84; no crate and no heap",
    loses: "nothing of the form",
    make,
    joint,
};

/// Templates: the first lines, the functions of muscles and of joints, the numbers of each, and a test of a muscle.
const HEAD: &str = include_str!("../../templates/rust_head.txt");
const FUNCTIONS: &str = include_str!("../../templates/mckibben.rs");
const MUSCLE: &str = include_str!("../../templates/muscle.rs");
const MUSCLE_TEST: &str = include_str!("../../templates/muscle_test.rs");
const JOINT_FUNCTIONS: &str = include_str!("../../templates/mckibben_joint.rs");
const JOINT: &str = include_str!("../../templates/joint.rs");

const SQUARE: [&str; 2] = ["[", "]"];
/// Shares of the supply and of the way from rest to the upper end of the contractions at which a
/// file tests itself; the first gives the scales.
const TESTED: [(f64, f64); 5] = [(1.0, 0.0), (0.3, 0.0), (0.5, 0.1), (0.8, 0.4), (0.9, 0.2)];

/// One file: these templates.
fn artefact(
    id: String,
    (templates, facts): (&[&str], &[String]),
    values: &[(&'static str, String)],
) -> Result<Artefact> {
    let text = render(&templates.concat(), facts, values);
    Ok(Artefact {
        files: vec![File::text(id + ".rs", "functions and numbers", text)],
    })
}

fn make(muscle: &ExportedMuscle) -> Result<Artefact> {
    artefact(
        muscle.identifier(),
        (&[HEAD, FUNCTIONS, MUSCLE, MUSCLE_TEST], &muscle.facts()),
        &places(muscle),
    )
}

/// The joint, and the numbers of its muscles.
fn joint(joint: &ExportedJoint) -> Result<Artefact> {
    let mut values = joint.values(SQUARE, number);
    let name = |muscle: &ExportedMuscle| format!("&{}", muscle.identifier().to_ascii_uppercase());
    values.push(("muscles", joined(joint.muscles.iter().map(name), ", ")));
    let own = |muscle: &ExportedMuscle| render(MUSCLE, &[], &places(muscle));
    let muscles: String = joint.muscles.iter().map(own).collect();
    artefact(
        joint.identifier(),
        (
            &[HEAD, FUNCTIONS, JOINT_FUNCTIONS, &muscles, JOINT],
            &joint.facts(),
        ),
        &values,
    )
}

fn places(muscle: &ExportedMuscle) -> Vec<(&'static str, String)> {
    let form = &muscle.form;
    let node = |node: &Node| {
        format!(
            "        Node {{ contraction: {}, value_n: {}, slope_n: {} }},",
            number(node.contraction),
            list(&node.value_n, SQUARE, number),
            list(&node.slope_n, SQUARE, number)
        )
    };
    let tested = TESTED.map(|(q, share)| {
        let pressure_pa = q * form.supply_pa;
        let contraction = share * form.contraction_high;
        let length_m = muscle.cord_m + (1.0 - contraction) * form.length_m;
        let point = form.point_at(pressure_pa, contraction);
        vec![
            pressure_pa,
            length_m,
            point.force_n,
            point.stiffness_n_per_m,
            point.force_per_pressure_m2,
            point.volume_m3,
        ]
    });
    // Slopes jump where the muscle becomes slack.
    let pulls = |row: &Vec<f64>| row[2] > 0.01 * muscle.blocked_force_n;
    let tested = Vec::from_iter(tested.into_iter().filter(pulls));
    let mut values = values(muscle, SQUARE, number);
    values.extend([
        ("low", number(form.contraction_low)),
        ("high", number(form.contraction_high)),
        ("lines", joined(form.nodes().iter().map(node), "\n")),
        ("tested", tested.len().to_string()),
        ("points", lists(&tested, SQUARE, number)),
    ]);
    values
}
