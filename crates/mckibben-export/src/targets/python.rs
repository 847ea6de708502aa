//! Python: one file of functions for numbers and arrays of NumPy, JAX and PyTorch.

use super::common;
use crate::{
    Artefact, ExportTarget, ExportedJoint, ExportedMuscle, File, Result,
    template::{list, lists, number, render},
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

fn make(muscle: &ExportedMuscle) -> Result<Artefact> {
    Ok(Artefact {
        files: vec![module(muscle)],
        notes: vec![],
    })
}

/// The joint, and a module of each of its muscles beside it.
fn joint(joint: &ExportedJoint) -> Result<Artefact> {
    let modules: Vec<String> = joint
        .muscles
        .iter()
        .map(ExportedMuscle::identifier)
        .collect();
    let mut values = joint.values(["(", ")"], number);
    values.push((
        "imports",
        joined(modules.iter().map(|name| format!("import {name}")), "\n"),
    ));
    values.push(("modules", modules.join(", ")));
    let text = render(
        include_str!("../../templates/joint.py"),
        &joint.facts(),
        &values,
    );
    let own = File::text(
        joint.identifier() + ".py",
        "torque, stiffness and pressures of the joint",
        text,
    );
    Ok(Artefact {
        files: std::iter::once(own)
            .chain(joint.muscles.iter().map(module))
            .collect(),
        notes: vec![],
    })
}

fn module(muscle: &ExportedMuscle) -> File {
    let f = &muscle.form;
    let round = ["(", ")"];
    let mut values = common(muscle);
    values.extend([
        ("py_nodes", list(&f.contractions, round, number)),
        ("py_a", lists(&f.a, round, number)),
        ("py_b", lists(&f.b, round, number)),
        ("py_v", list(&f.v, round, number)),
        ("py_friction", list(&f.friction_n, round, number)),
    ]);
    let file = render(
        include_str!("../../templates/muscle.py"),
        &muscle.facts(),
        &values,
    );
    File::text(
        muscle.identifier() + ".py",
        "the functions of a muscle",
        file,
    )
}
