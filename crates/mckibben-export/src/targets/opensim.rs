//! OpenSim: a model with two of its forces on one path, with x = L/L0 and the pressure P.
//!
//! ```text
//! McKibbenActuator:          P (3 L² − thread²)/(4π turns²)      the control is the pressure
//! ExpressionBasedPathForce:  m0 + m1 x + m2 x² + m3 x³           what does not depend on the pressure
//! ```
//!
//! (OpenSim 4.6, McKibbenActuator.cpp.) Thread and turns are those with which the sum is nearest to
//! the model, not those of the braid.

use super::fit;
use crate::{
    Artefact, ExportError, ExportTarget, ExportedMuscle, File, Result,
    muscle::LIMIT,
    template::{number, render},
};
use mckibben_core::extremes::peak;
use std::f64::consts::PI;

pub const TARGET: ExportTarget = ExportTarget {
    name: "opensim",
    about: "an OpenSim model: a McKibbenActuator beside a force by an expression, without plugin",
    needs: "OpenSim 4.6 or later",
    loses: "the form: pull is linear in the pressure, from the length at rest to the free \
        contraction; a slack muscle can push; no volume",
    make,
    joint: None,
};

fn make(muscle: &ExportedMuscle) -> Result<Artefact> {
    let form = &muscle.form;
    let blocked_n = muscle.blocked_force_n;
    let refused = || {
        ExportError::Host(
            "the pull of this muscle is not of the form that OpenSim's actuator has; \
            the targets c and python have all of it"
                .into(),
        )
    };
    let (k, error) = fit(
        muscle,
        |q, x| [q, q * x * x, 1.0, x, x * x, x * x * x],
        false,
    )
    .ok_or_else(refused)?;
    let (_, alone) = fit(muscle, |q, x| [q, q * x * x], false).ok_or_else(refused)?;
    let per_pa = blocked_n / form.supply_pa;
    let length = form.length_m;
    // P (3 L² − thread²)/(4π turns²) needs a parabola that opens upwards and is negative at L = 0.
    if !(k[1] > 0.0 && k[0] < 0.0 && error.worst <= LIMIT) {
        return Err(refused());
    }
    let turns = (3.0 * length * length / (4.0 * PI * k[1] * per_pa)).sqrt();
    let thread = length * (-3.0 * k[0] / k[1]).sqrt();
    let at = |q: f64, x: f64| q * (k[0] + k[1] * x * x) + k[2] + (k[3] + (k[4] + k[5] * x) * x) * x;
    let slack = muscle
        .held_out
        .iter()
        .filter(|p| p.contraction >= 0.0 && p.pull.is_none_or(|pull| pull <= 0.0));
    let pushed = peak(slack.map(|p| -at(p.q, 1.0 - p.contraction)));
    let reach = format!(
        "Pull of both forces against the model, from the length at rest to the free contraction: \
         {error}, of the blocked force; of the McKibbenActuator alone, at its best: {alone}."
    );
    let push = format!(
        "Where the muscle is slack both forces can push, there by up to {:.2} % of the blocked \
         force.",
        100.0 * pushed
    );
    let mut facts = muscle.facts();
    facts.extend([reach.clone(), push.clone()]);
    let mass_kg = 0.4 * blocked_n / 9.81;
    // Numbers with a sign and an exponent are bracketed: the expression has no spaces.
    let term =
        |c: f64, power: i32| format!("({})*s^{power}", number(c * blocked_n / length.powi(power)));
    let values = [
        ("id", muscle.identifier()),
        ("turns", number(turns)),
        ("thread", number(thread)),
        ("cord", number(muscle.cord_m)),
        (
            "expression",
            format!(
                "({})+{}+{}+{}",
                number(k[2] * blocked_n),
                term(k[3], 1),
                term(k[4], 2),
                term(k[5], 3)
            ),
        ),
        ("supply", number(form.supply_pa)),
        ("pressure", number(0.7 * form.supply_pa)),
        ("length", number(muscle.cord_m + 0.95 * length)),
        ("mass", number(mass_kg)),
        (
            "damping",
            number((6.0 * blocked_n / length * mass_kg).sqrt()),
        ),
    ];
    let scene = render(include_str!("../../templates/muscle.osim"), &facts, &values);
    let name = muscle.identifier() + ".osim";
    Ok(Artefact {
        files: vec![File::text(name, "a mass that hangs from the muscle", scene)],
        notes: vec![reach, push],
    })
}
