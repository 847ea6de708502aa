//! Why a model has no answer.

use super::RangeViolation;
use crate::{
    analysis::FailureMode, cancel::Cancelled, joined, status::Status, units::trimmed as short,
};
use thiserror::Error;

fn list(violations: &[RangeViolation], make: &[String]) -> String {
    joined(
        violations
            .iter()
            .map(ToString::to_string)
            .chain(make.iter().cloned()),
        "; ",
    )
}

/// What a model answers, or why it has no answer.
pub type Result<T, E = ModelError> = std::result::Result<T, E>;

/// Why a model has no answer at a pressure and contraction.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ModelError {
    /// The question lies outside of what the model was made for.
    #[error("outside the range of the {model} model: {}", list(.violations, .make))]
    OutOfRange {
        /// The model's name.
        model: String,
        /// The numbers that are outside.
        violations: Vec<RangeViolation>,
        /// Parts of the muscle that differ.
        make: Vec<String>,
    },
    /// The model needs something that the muscle does not state.
    #[error("the {model} model needs {missing}")]
    Missing {
        /// The model's name.
        model: &'static str,
        /// What it needs and how to give it.
        missing: &'static str,
        /// Its key in the muscle file; empty where no key gives it.
        key: &'static str,
    },
    /// No geometry exists at this contraction.
    #[error(
        "at a contraction of {contraction} the muscle has no shape: it must lie above {lowest:.6} \
         (strands straight) and below {highest:.6}"
    )]
    Geometry {
        /// The requested contraction.
        contraction: f64,
        /// The contraction at which the strands are straight.
        lowest: f64,
        /// The upper end.
        highest: f64,
    },
    /// Strands so soft, or a pressure so high, that no equilibrium exists.
    #[error(
        "no equilibrium at {pressure_mpa}\u{a0}MPa and contraction {contraction}: the strands \
         would stretch past {strand_stretch:.2} times their length; lower the pressure or take a \
         stiffer braid"
    )]
    Overstretched {
        /// Pressure in MPa.
        pressure_mpa: f64,
        /// Contraction ratio.
        contraction: f64,
        /// The strand stretch up to which was searched.
        strand_stretch: f64,
    },
    /// The rubber law has no finite stress at this stretch.
    #[error(
        "the rubber locks at contraction {contraction}: its {law} law has no finite stress at a \
         hoop stretch of {hoop_stretch:.3}"
    )]
    Locked {
        /// Contraction ratio.
        contraction: f64,
        /// Hoop stretch at the bore.
        hoop_stretch: f64,
        /// The law's name.
        law: &'static str,
    },
    /// There is no equilibrium, for a reason that is said.
    #[error("{0}")]
    NoEquilibrium(String),
    /// An iteration did not converge.
    #[error(
        "no equilibrium found at {pressure_mpa}\u{a0}MPa and contraction {contraction}; try a \
         nearby point, or another model"
    )]
    NotConverged {
        /// Pressure in MPa.
        pressure_mpa: f64,
        /// Contraction ratio.
        contraction: f64,
    },
    /// A path of equilibria ended before the requested one.
    #[error("{reason}")]
    Stopped {
        /// How: not converged, collapsed, or on another branch.
        #[doc(hidden)]
        status: Status,
        /// The reason in words, with the last equilibrium of the path.
        reason: String,
    },
    /// The caller wanted the work to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// Finite elements that cannot be made, and why.
    #[error("the muscle cannot be divided into elements: {0}")]
    Elements(String),
    /// A model, by its name, without a volume.
    #[error(
        "the model {0} has no volume of the cavity: take fe or thick-wall for measured volumes"
    )]
    NoVolume(String),
    /// A formula that is not finite here.
    #[error(
        "the {model} formula has no value at {pressure_mpa}\u{a0}MPa and contraction {contraction}"
    )]
    NotFinite {
        /// The model's name.
        model: String,
        /// Pressure in MPa.
        pressure_mpa: f64,
        /// Contraction ratio.
        contraction: f64,
    },
    /// The muscle has burst at this pressure ([`burst`](crate::analysis::burst())).
    #[error(
        "{}\u{a0}MPa is not below the burst pressure of this muscle, {}\u{a0}MPa, at which {by}",
        short(*.pressure_mpa, 4), short(*.burst_mpa, 4)
    )]
    Burst {
        /// Pressure in MPa.
        pressure_mpa: f64,
        /// The least burst pressure in MPa.
        burst_mpa: f64,
        /// What fails.
        by: FailureMode,
    },
}

impl ModelError {
    /// That the formula of a model is not finite at a pressure and contraction.
    pub fn not_finite(model: &str, pressure_mpa: f64, contraction: f64) -> Self {
        Self::NotFinite {
            model: model.into(),
            pressure_mpa,
            contraction,
        }
    }

    /// That an iteration did not converge at a pressure and contraction.
    pub fn not_converged(pressure_mpa: f64, contraction: f64) -> Self {
        Self::NotConverged {
            pressure_mpa,
            contraction,
        }
    }

    /// A pull that a model computed, where it is a number.
    pub(crate) fn finite(
        force_n: f64,
        model: &str,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<f64> {
        if force_n.is_finite() {
            Ok(force_n)
        } else {
            Err(Self::not_finite(model, pressure_mpa, contraction))
        }
    }

    /// Whether it is about this pressure and contraction: other points may have an answer.
    pub fn is_of_point(&self) -> bool {
        matches!(
            self,
            Self::Geometry { .. }
                | Self::Overstretched { .. }
                | Self::Locked { .. }
                | Self::NoEquilibrium(_)
                | Self::NotConverged { .. }
                | Self::Stopped { .. }
                | Self::NotFinite { .. }
        )
    }
}
