//! MuJoCo: a scene in MJCF with native actuators, and the form itself as a plugin around the C target, with its scene.
//!
//! MuJoCo has no actuator F(P, L). Two of its actuators on one tendon make one, with x = L/L0 and the pressure P as the control of both:
//!
//! ```text
//! muscle: − (k2 P + m2) x²        gaintype and biastype "muscle" on their first quarters, which are parabolas
//! affine: − (k0 + k1 x) P − (m0 + m1 x)
//! ```
//!
//! The gain of a muscle is −force · 2 L² for 0 ≤ L ≤ 1/2 with `lmin` 0, and L = length/span with `range` 0 1 and `lengthrange` 0 span; where k2
//! is negative it is −force (1 − (L − 1)²/2) for 1 ≤ L ≤ 2 with `lmax` 3, whose constant the affine actuator takes back. Its bias
//! is −force · fpmax (L − 1)²/2 for 1 ≤ L ≤ 2 with `lmax` 3, and L − 1 = length/span with `range` 1 2. (MuJoCo, "Computation",
//! section "Muscle actuators"; engine_util_misc.c.) A limit of the force of all actuators at the tendon makes it slack.

use super::c::{rendered, sources};
use super::fit;
use crate::muscle::LIMIT;
use crate::template::{number, render};
use crate::{Artefact, ExportError, ExportedMuscle, File, HostError, Result, Target};

pub(super) const TARGET: Target = Target {
    name: "mjcf",
    about: "a MuJoCo scene of native actuators on a tendon, without plugin or callback; beside it the form itself as a plugin in C, with its scene",
    needs: "MuJoCo 3.3.1 or later; for the plugin its headers (the Python package has them) and a C compiler",
    loses: "without the plugin friction and the form: pull is linear in the pressure and of second degree in the length, from the length at rest to the free contraction; no volume",
    make,
};

/// Lengths up to this share of that at rest lie on the parabola of the gain.
const REACH: f64 = 1.25;
/// Largest share of the pull beyond the blocked force at the supply.
const STRONGEST: f64 = 3.0;

/// k0, k1, k2, m0, m1, m2 over the blocked force, and their error; the tendon's limit makes the muscle slack. MuJoCo has no m2 below zero: without it then.
fn fitted(muscle: &ExportedMuscle) -> Option<([f64; 6], HostError)> {
    let all = fit(muscle, |q, x| [q, q * x, q * x * x, 1.0, x, x * x], true)?;
    if all.0[5] > 0.0 {
        return Some(all);
    }
    let ([k0, k1, k2, m0, m1], error) = fit(muscle, |q, x| [q, q * x, q * x * x, 1.0, x], true)?;
    Some(([k0, k1, k2, m0, m1, f64::MIN_POSITIVE], error))
}

/// Of dF/dL where both pull, over the blocked force over the stroke at the supply.
fn stiffness_error(muscle: &ExportedMuscle, k: &[f64; 6]) -> HostError {
    let (form, blocked_n) = (&muscle.form, muscle.blocked_force_n);
    let errors: Vec<f64> = muscle
        .held_out
        .iter()
        .filter(|p| p.contraction >= 0.0 && p.pull.is_some_and(|pull| pull > 0.0))
        .filter_map(|p| {
            let (q, x) = (p.q, 1.0 - p.contraction);
            let pulls = (k[0] + (k[1] + k[2] * x) * x) * q + k[3] + (k[4] + k[5] * x) * x > 0.0;
            let slope = (k[1] + 2.0 * k[2] * x) * q + k[4] + 2.0 * k[5] * x;
            let stiffness = form.at(q * form.supply_pa, p.contraction).stiffness_n_per_m;
            pulls.then_some((slope - stiffness * form.length_m / blocked_n) * form.contraction_high)
        })
        .collect();
    HostError::from_errors(&errors)
}

fn make(muscle: &ExportedMuscle) -> Result<Artefact> {
    let (f, blocked_n) = (&muscle.form, muscle.blocked_force_n);
    let refused = || {
        ExportError::Host("the pull of this muscle is not of the form that MuJoCo's actuators have; the targets c and python have all of it".into())
    };
    let (k, error) = fitted(muscle).filter(|(_, error)| error.worst <= LIMIT).ok_or_else(refused)?;
    let (length, per_pa) = (f.length_m, blocked_n / f.supply_pa);
    let (span, cord) = (2.0 * REACH * length, muscle.cord_m / length);
    let per_square = (span / length).powi(2);
    // A parabola that opens upwards lies on the first quarter, one that opens downwards on the third, which begins at 1.
    let (gain_range, gain_ends, gain_square, offset) = if k[2] >= 0.0 {
        ("0 1", "0 1.6", (0.5 * k[2] * per_pa * per_square).max(f64::MIN_POSITIVE), 0.0)
    } else {
        let square = -2.0 * k[2] * per_pa * per_square;
        ("1 2", "0.5 3", square, square)
    };
    let reach = format!(
        "Pull of the actuators against the model, from the length at rest to the free contraction: {error}, of the blocked force."
    );
    let slope = stiffness_error(muscle, &k);
    let slope = format!(
        "Stiffness of the actuators against the form, there: {:.1} % rms, {:.1} % worst, of the mean stiffness at the supply of {:.0} N/m.",
        100.0 * slope.rms,
        100.0 * slope.worst,
        blocked_n / (f.contraction_high * f.length_m)
    );
    let mut facts = muscle.facts();
    facts.extend([reach.clone(), slope.clone()]);
    let values = [
        ("id", muscle.identifier()),
        ("supply", number(f.supply_pa)),
        ("cord", number(muscle.cord_m)),
        ("end", number(muscle.cord_m + span)),
        ("gain_square", number(gain_square)),
        ("gain_range", gain_range.into()),
        ("gain_ends", gain_ends.into()),
        // MuJoCo requires more than zero.
        ("bias_square", number((2.0 * k[5] * blocked_n * per_square).max(f64::MIN_POSITIVE))),
        ("gain_0", number(offset - k[0] * per_pa + k[1] * per_pa * cord)),
        ("gain_1", number(-k[1] * per_pa / length)),
        ("bias_0", number((k[4] * cord - k[3]) * blocked_n)),
        ("bias_1", number(-k[4] * blocked_n / length)),
    ];
    let half = number(0.5 * f.supply_pa);
    let places = [
        ("also", String::new()),
        (
            "extension",
            "  <!-- The limit of the tendon's force makes the muscle slack where it would push. -->".into(),
        ),
        (
            "limit",
            format!(" actuatorfrclimited=\"true\" actuatorfrcrange=\"{} 0\"", number(-STRONGEST * blocked_n)),
        ),
        ("actuators", render(include_str!("../../templates/muscle_native.xml"), &[], &values)),
        ("half", format!("{half} {half}")),
    ];
    let notes = vec![
        reach,
        slope,
        "both actuators of a muscle take the same control: its gauge pressure in Pa".into(),
    ];
    let about = "a mass that hangs from the muscle, with native actuators";
    let mut files = vec![File::text(muscle.identifier() + ".xml", about, scene(muscle, &facts, &places))];
    files.extend(plugin(muscle));
    Ok(Artefact { files, notes })
}

/// The form itself with one control for a muscle, and a scene that uses it.
fn plugin(muscle: &ExportedMuscle) -> Vec<File> {
    let (id, supply) = (muscle.identifier(), number(muscle.form.supply_pa));
    let actuator = include_str!("../../templates/muscle_plugin.xml");
    let places = [
        ("also", " and <extension>".to_owned()),
        ("extension", format!("  <extension><plugin plugin=\"mckibben.{id}\"/></extension>")),
        ("limit", String::new()),
        ("actuators", render(actuator, &[], &[("id", id.clone()), ("supply", supply)])),
        ("half", number(0.5 * muscle.form.supply_pa)),
    ];
    let mut files = vec![
        File::text(
            id.clone() + "_plugin.c",
            "the plugin; its first lines have the commands to compile and load it",
            rendered(include_str!("../../templates/muscle_plugin.c"), muscle),
        ),
        File::text(
            id + "_plugin.xml",
            "the same mass by the plugin",
            scene(muscle, &muscle.facts(), &places),
        ),
    ];
    let air = rendered(include_str!("../../templates/air.c"), muscle);
    files.push(File::text("mckibben_air.h", "a valve and the air, the same for all muscles", air));
    files.extend(sources(muscle));
    files
}

/// A place in a template, and its text.
type Place = (&'static str, String);

/// A scene in which a mass hangs from the muscle, with the actuators of a target.
fn scene(muscle: &ExportedMuscle, facts: &[String], places: &[Place]) -> String {
    let (length, blocked_n) = (muscle.form.length_m, muscle.blocked_force_n);
    let (mass_kg, stiffness) = (0.4 * blocked_n / 9.81, 6.0 * blocked_n / length);
    let common = [
        ("id", muscle.identifier()),
        ("below", number(-length - muscle.cord_m)),
        ("mass", number(mass_kg)),
        ("damping", number(0.5 * 2.0 * (stiffness * mass_kg).sqrt())),
    ];
    render(include_str!("../../templates/muscle.xml"), facts, &[&common[..], places].concat())
}
