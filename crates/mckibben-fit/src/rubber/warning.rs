//! Warnings about tests and laws.

use super::{FittedLaw, Mode, Parameter, TensionPoint, problem::Problem, runs::Sorted};
use mckibben_core::rubber::RubberLaw;

/// Stretch that the wall of a strongly contracted muscle reaches (a 20° braid: 2.4).
const MUSCLE_STRETCH: f64 = 2.3;
/// Shear moduli of rubbers, from soft gels to hard rubber, in MPa.
pub const MODULI: (f64, f64) = (0.005, 20.0);
/// Tests of rubber stretch it by more, and by less: else the strains are in another unit than that
/// of the heading.
const STRETCHES: (f64, f64) = (1.01, 12.0);

pub fn for_runs(sorted: &Sorted) -> Vec<String> {
    let rupture = |(mode, points): &(Mode, usize)| {
        format!(
            "{mode}: the specimen failed; {points} points after the largest stress are left out"
        )
    };
    let mut out: Vec<_> = sorted.after_rupture.iter().map(rupture).collect();
    if sorted.unloadings > 0 {
        let times = sorted.unloadings;
        out.push(format!(
            "the specimen was unloaded {times} times; the laws go through the middle of loading \
             and unloading. The first loading is stiffer than later ones (Mullins): for a muscle \
             that was run in, use one late loading alone, up to its largest stretch"
        ));
    }
    out
}

/// What may be wrong with the units where the modulus is not that of a rubber.
fn units(modulus_mpa: f64, fitted_to_stretch: f64) -> String {
    let strain = format!("{:.2} %", 100.0 * (fitted_to_stretch - 1.0));
    match modulus_mpa > MODULI.1 {
        true if fitted_to_stretch < STRETCHES.0 => {
            format!("the strains end at {strain}: are they ratios under a heading for percent?")
        }
        true => "are the stresses in kPa or psi under another heading, or the forces over too \
            small an area?"
            .into(),
        false if fitted_to_stretch > STRETCHES.1 => {
            format!("the strains end at {strain}: are they in percent under a heading for ratios?")
        }
        false => "are the stresses in MPa under a heading for kPa or psi, or the forces over too \
            large an area, or is it a foam or gel?"
            .into(),
    }
}

pub fn for_points(problem: &Problem, fitted_to_stretch: f64, hoop: f64) -> Vec<String> {
    let mut out = vec![];
    let modulus_mpa = problem.modulus_mpa;
    if !(MODULI.0..=MODULI.1).contains(&modulus_mpa) {
        let ((low, high), units) = (MODULI, units(modulus_mpa, fitted_to_stretch));
        out.push(format!(
            "the shear modulus is {modulus_mpa:.3} MPa, and rubbers lie between {low} and {high} \
             MPa: {units}"
        ));
    }
    let wrong = |p: &&TensionPoint| {
        p.mode != Mode::General && p.nominal_stress_mpa * (p.stretch - 1.0) < 0.0
    };
    let wrong = problem.points.iter().filter(wrong).count();
    if wrong > 0 {
        out.push(format!(
            "{wrong} points have tension where the specimen is compressed, or the reverse; check \
             the zero of force and of length"
        ));
    }
    if problem.points.iter().all(|p| p.mode == Mode::Uniaxial) {
        out.push(
            "uniaxial tests alone: the wall of a muscle is stretched in two axes, where laws \
            that agree in one axis differ; a planar or equibiaxial test distinguishes them"
                .into(),
        );
    }
    let muscle_stretch = MUSCLE_STRETCH.min(hoop);
    if fitted_to_stretch < muscle_stretch {
        out.push(format!(
            "the tests end at a stretch of {fitted_to_stretch:.2}; the wall of a strongly \
             contracted muscle reaches {muscle_stretch} to 3"
        ));
    }
    out
}

pub fn for_law(fitted: &FittedLaw, hoop: f64) -> Vec<String> {
    let mut out = vec![];
    let name = fitted.form.name();
    let law = if fitted.constrained {
        format!("{name}, constrained to be stable")
    } else {
        name.clone()
    };
    if fitted.law.clone().validated().is_err() {
        let modulus_mpa = fitted.law.shear_modulus_mpa();
        out.push(format!(
            "{law}: the shear modulus at rest is {modulus_mpa:.3} MPa: no rubber"
        ));
    } else if let Some(hoop_stretch) = fitted.quality.unstable_from_hoop_stretch {
        out.push(if let Some(i1_minus_3) = fitted.law.locks_at() {
            format!(
                "{name}: locks at I1 − 3 = {i1_minus_3:.2}, which a muscle reaches at a hoop \
             stretch of {hoop_stretch:.2}"
            )
        } else {
            let from = hoop_stretch.min(hoop);
            format!(
                "{law}: unstable in the two-axis stretch of a muscle from a hoop stretch \
                of {from:.2} on"
            )
        });
    }
    out.extend(fitted.law.negative_c01_mpa().map(|c01_mpa| {
        format!(
            "mooney-rivlin: C01 is {c01_mpa:.4} MPa; a negative C01 comes from uniaxial tests and \
             is wrong in two axes. Take the fit with C01 ≥ 0 (`stable`), neo-hookean or yeoh"
        )
    }));
    // A law held stable lies on its bound whatever the data.
    let on_purpose = |p: &Parameter| fitted.constrained && p.standard_error == Some(0.0);
    let names: Vec<&str> = fitted
        .parameters
        .iter()
        .filter(|p| !p.identifiable && !on_purpose(p))
        .map(|p| p.name.as_str())
        .collect();
    if !names.is_empty() {
        let names = names.join(", ");
        out.push(format!(
            "{law}: the data do not determine {names}; other values fit equally well"
        ));
    }
    out
}
