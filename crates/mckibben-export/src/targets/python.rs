//! Python: one file of functions for numbers and arrays of NumPy, JAX and PyTorch.

use super::values;
use crate::{
    Artefact, ExportTarget, ExportedJoint, ExportedMuscle, File, Result,
    template::{number, render},
};
use mckibben_core::joined;

pub const TARGET: ExportTarget = ExportTarget {
    name: "python",
    about: "one Python file, the same for NumPy, JAX (jit, vmap, grad) and PyTorch",
    needs: "NumPy, or the library of the arrays that it is given",
    loses: "nothing of the form",
    make,
    joint,
};

const ROUND: [&str; 2] = ["(", ")"];

fn make(muscle: &ExportedMuscle) -> Result<Artefact> {
    Ok(Artefact {
        files: vec![module(muscle)],
    })
}

/// The joint, and a module of each of its muscles beside it.
fn joint(joint: &ExportedJoint) -> Result<Artefact> {
    let modules = Vec::from_iter(joint.muscles.iter().map(ExportedMuscle::identifier));
    let mut values = joint.values(ROUND, number);
    values.extend([
        (
            "imports",
            joined(modules.iter().map(|name| format!("import {name}")), "\n"),
        ),
        ("modules", modules.join(", ")),
    ]);
    let text = render(
        include_str!("../../templates/joint.py"),
        &joint.facts(),
        &values,
    );
    Ok(Artefact {
        files: std::iter::once(File::text(
            joint.identifier() + ".py",
            "torque, stiffness and pressures of the joint",
            text,
        ))
        .chain(joint.muscles.iter().map(module))
        .collect(),
    })
}

fn module(muscle: &ExportedMuscle) -> File {
    let text = render(
        include_str!("../../templates/muscle.py"),
        &muscle.facts(),
        &values(muscle, ROUND, number),
    );
    File::text(
        muscle.identifier() + ".py",
        "the functions of a muscle",
        text,
    )
}
