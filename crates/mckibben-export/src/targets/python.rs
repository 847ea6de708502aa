//! Python: one file of functions for numbers and arrays of NumPy, JAX and PyTorch.

use super::common;
use crate::template::{list, lists, number, render};
use crate::{Artefact, ExportedMuscle, File, Result, Target};

pub(super) const TARGET: Target = Target {
    name: "python",
    about: "one Python file, the same for NumPy, JAX (jit, vmap, grad) and PyTorch",
    needs: "NumPy, or the library of the arrays that it is given",
    loses: "nothing of the form",
    make,
};

fn make(muscle: &ExportedMuscle) -> Result<Artefact> {
    let (f, round) = (&muscle.form, ["(", ")"]);
    let mut values = common(muscle);
    values.extend([
        ("py_nodes", list(&f.contractions, round, number)),
        ("py_a", lists(&f.a, round, number)),
        ("py_b", lists(&f.b, round, number)),
        ("py_v", list(&f.v, round, number)),
        ("py_friction", list(&f.friction_n, round, number)),
    ]);
    let file = render(include_str!("../../templates/muscle.py"), &muscle.facts(), &values);
    Ok(Artefact {
        files: vec![File::text(muscle.identifier() + ".py", "the functions", file)],
        notes: vec![],
    })
}
