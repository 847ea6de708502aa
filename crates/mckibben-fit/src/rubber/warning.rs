//! What to mind about tests and laws.

use super::fitted::{FittedLaw, Parameter};
use super::point::Mode;
use super::problem::Problem;
use super::runs::Sorted;
use mckibben::rubber::RubberLaw;
use serde::{Serialize, Serializer};
use std::fmt;

/// Stretch that the wall of a strongly contracted muscle reaches (a 20° braid: 2.4).
const MUSCLE_STRETCH: f64 = 2.3;
/// Shear moduli of rubbers, from soft gels to hard rubber, in MPa.
pub(crate) const MODULI: (f64, f64) = (0.005, 20.0);
/// Tests of rubber stretch it by more, and by less: else the strains are in another unit than that of the heading.
const STRETCHES: (f64, f64) = (1.01, 12.0);

#[derive(Debug, Clone, PartialEq)]
pub enum TensionWarning {
    /// Points behind a rupture were left out.
    Rupture { mode: Mode, points: usize },
    /// The specimen was unloaded.
    Loops { unloadings: usize },
    /// The modulus is not that of a rubber.
    Modulus { modulus_mpa: f64, fitted_to_stretch: f64 },
    /// Points that pull where the specimen is pressed, or the other way round.
    Signs { points: usize },
    /// One-axis tests alone.
    OneAxis,
    /// The tests end below the stretches of a muscle.
    Short {
        /// Largest principal stretch of the tests.
        fitted_to_stretch: f64,
        muscle_stretch: f64,
    },
    /// A law that is unstable in a muscle.
    Unstable { law: String, hoop_stretch: f64 },
    /// A law whose chains lock within a muscle's stretches.
    Locks {
        law: String,
        /// Hoop stretch at which it locks.
        hoop_stretch: f64,
        /// I1 − 3 there.
        i1_minus_3: f64,
    },
    /// Mooney–Rivlin with C01 < 0.
    NegativeC01 { c01_mpa: f64 },
    /// Constants that are no rubber at rest.
    NoStiffness {
        law: String,
        /// Its shear modulus in MPa.
        modulus_mpa: f64,
    },
    /// Constants that the data do not tell.
    NotTold { law: String, names: Vec<String> },
}

impl fmt::Display for TensionWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rupture { mode, points } => {
                write!(f, "{mode}: the specimen failed; {points} points after the largest stress are left out")
            }
            Self::Loops { unloadings } => write!(
                f,
                "the specimen was unloaded {unloadings} times; the laws go through the middle of loading and unloading. The first loading is stiffer than later ones (Mullins): for a muscle that was run in, use one late loading alone, up to its largest stretch"
            ),
            Self::Modulus { modulus_mpa, fitted_to_stretch } => {
                let strain = format!("{:.2} %", 100.0 * (fitted_to_stretch - 1.0));
                let unit = match *modulus_mpa > MODULI.1 {
                    true if *fitted_to_stretch < STRETCHES.0 => {
                        format!("the strains end at {strain}: are they ratios under a heading for percent?")
                    }
                    true => "are the stresses in kPa or psi under another heading, or the forces over too small an area?".into(),
                    false if *fitted_to_stretch > STRETCHES.1 => {
                        format!("the strains end at {strain}: are they in percent under a heading for ratios?")
                    }
                    false => "are the stresses in MPa under a heading for kPa or psi, or the forces over too large an area, or is it a foam or gel?".into(),
                };
                write!(
                    f,
                    "the shear modulus is {modulus_mpa:.3} MPa, and rubbers lie between {} and {} MPa: {unit}",
                    MODULI.0, MODULI.1
                )
            }
            Self::Signs { points } => write!(
                f,
                "{points} points have tension where the specimen is compressed, or the reverse; check the zero of force and of length"
            ),
            Self::OneAxis => f.write_str(
                "uniaxial tests alone: the wall of a muscle is stretched in two axes, where laws that agree in one axis differ; a planar or equibiaxial test distinguishes them",
            ),
            Self::Short { fitted_to_stretch, muscle_stretch } => write!(
                f,
                "the tests end at a stretch of {fitted_to_stretch:.2}; the wall of a strongly contracted muscle reaches {muscle_stretch} to 3"
            ),
            Self::Unstable { law, hoop_stretch } => {
                write!(f, "{law}: unstable in the two-axis stretch of a muscle from a hoop stretch of {hoop_stretch:.2} on")
            }
            Self::Locks { law, hoop_stretch, i1_minus_3 } => write!(
                f,
                "{law}: locks at I1 − 3 = {i1_minus_3:.2}, which a muscle reaches at a hoop stretch of {hoop_stretch:.2}"
            ),
            Self::NegativeC01 { c01_mpa } => write!(
                f,
                "mooney-rivlin: C01 is {c01_mpa:.4} MPa; a negative C01 comes from uniaxial tests and is wrong in two axes. Take the fit with C01 ≥ 0 (`stable`), neo-hookean or yeoh"
            ),
            Self::NoStiffness { law, modulus_mpa } => {
                write!(f, "{law}: the shear modulus at rest is {modulus_mpa:.3} MPa: no rubber")
            }
            Self::NotTold { law, names } => {
                write!(f, "{law}: the data do not determine {}; other values fit equally well", names.join(", "))
            }
        }
    }
}

/// As data it is its message.
impl Serialize for TensionWarning {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

pub(super) fn of_runs(sorted: &Sorted) -> Vec<TensionWarning> {
    let ruptures = sorted.after_rupture.iter();
    let mut out: Vec<_> = ruptures.map(|&(mode, points)| TensionWarning::Rupture { mode, points }).collect();
    if sorted.unloadings > 0 {
        out.push(TensionWarning::Loops { unloadings: sorted.unloadings });
    }
    out
}

pub(super) fn of_points(problem: &Problem, fitted_to_stretch: f64, hoop: f64) -> Vec<TensionWarning> {
    let mut out = vec![];
    let modulus_mpa = problem.modulus_mpa;
    if !(MODULI.0..=MODULI.1).contains(&modulus_mpa) {
        out.push(TensionWarning::Modulus { modulus_mpa, fitted_to_stretch });
    }
    let wrong = problem.points.iter();
    let wrong = wrong.filter(|p| p.mode != Mode::General && p.nominal_stress_mpa * (p.stretch - 1.0) < 0.0);
    let wrong = wrong.count();
    if wrong > 0 {
        out.push(TensionWarning::Signs { points: wrong });
    }
    if problem.points.iter().all(|p| p.mode == Mode::Uniaxial) {
        out.push(TensionWarning::OneAxis);
    }
    let muscle_stretch = MUSCLE_STRETCH.min(hoop);
    if fitted_to_stretch < muscle_stretch {
        out.push(TensionWarning::Short { fitted_to_stretch, muscle_stretch });
    }
    out
}

pub(super) fn of_law(fitted: &FittedLaw, hoop: f64) -> Vec<TensionWarning> {
    let mut out = vec![];
    let law = if fitted.constrained {
        format!("{}, constrained to be stable", fitted.form.name())
    } else {
        fitted.form.name()
    };
    if fitted.law.clone().validated().is_err() {
        let modulus_mpa = fitted.law.shear_modulus_mpa();
        out.push(TensionWarning::NoStiffness { law: law.clone(), modulus_mpa });
    } else if let Some(hoop_stretch) = fitted.quality.unstable_from_hoop_stretch {
        out.push(match fitted.law.locks_at() {
            Some(i1_minus_3) => TensionWarning::Locks { law: fitted.form.name(), hoop_stretch, i1_minus_3 },
            None => TensionWarning::Unstable { law: law.clone(), hoop_stretch: hoop_stretch.min(hoop) },
        });
    }
    out.extend(fitted.law.negative_c01_mpa().map(|c01_mpa| TensionWarning::NegativeC01 { c01_mpa }));
    // The bound of a law held stable is no want of data.
    let on_purpose = |p: &Parameter| fitted.constrained && p.standard_error == Some(0.0);
    let names: Vec<String> = fitted
        .parameters
        .iter()
        .filter(|p| !p.identifiable && !on_purpose(p))
        .map(|p| p.name.clone())
        .collect();
    if !names.is_empty() {
        out.push(TensionWarning::NotTold { law, names });
    }
    out
}
