//! The muscle and its parts: tube, braid, terminals, and what is derived from them.
//!
//! All values are checked once, in [`Muscle::new`]; a [`Muscle`] is therefore always valid.

mod bench;
mod braid;
mod constant;
mod crimp;
mod derived;
mod direction;
mod ends;
mod error;
pub mod file;
mod friction;
mod job;
mod kind;
mod lay;
pub mod measures;
mod presliding;
mod reach;
mod relations;
mod rubber;
mod sleeve;
mod stated;
mod terminals;
mod tube;

pub use crate::{
    rubber::{Bulk, Conditioned, Rubber},
    sleeve::NEUTRAL_ANGLE_DEG,
};
pub use bench::{Bench, OwnPoint};
pub use braid::{Braid, BraidStiffness, MeasuredStrand, SLEEVE_ANGLE_TOLERANCE_DEG, Strands};
pub use constant::{Constant, Constants};
pub use crimp::Crimp;
pub use direction::Direction;
pub use ends::{EndState, Ends};
pub use error::MuscleError;
pub use friction::Friction;
pub use job::{Job, JobPoint};
pub use kind::{LARGEST_ANGLE_DEG, MuscleKind};
pub use lay::StrandLay;
pub use measures::{Measure, Parts};
pub use presliding::Presliding;
pub use reach::largest_stretch;
pub use stated::Stated;
pub use terminals::{EndFactor, EndsMade, Terminals};
pub use tube::Tube;

use crate::{
    joined,
    rubber::{RubberLaw, library},
};
use std::sync::Arc;

/// A muscle whose parts have been checked against each other.
#[must_use]
#[derive(Debug, Clone, PartialEq)]
pub struct Muscle {
    parts: Parts,
    /// The bench that its constants come from; it may be that of another muscle.
    bench: Option<Arc<Bench>>,
    /// What it was designed for.
    job: Option<Arc<Job>>,
    /// The rubber at the temperature of the tube, where that is stated.
    warm: Option<Arc<Rubber>>,
}

impl Muscle {
    /// Puts a muscle together. A rubber of the library has the law for the stretches that this
    /// muscle reaches ([`library`]), whichever it came with.
    ///
    /// # Errors
    /// [`MuscleError`] names the part, its value and what it must be: lengths above zero, wall
    /// below the radius, 0 < θ0 ≤ 75°, a rubber and a braid with stiffness.
    pub fn new(
        tube: Tube,
        braid: Braid,
        terminals: Terminals,
        friction: Option<Friction>,
    ) -> Result<Self, MuscleError> {
        Self::from_parts(Parts {
            tube,
            braid,
            terminals,
            friction,
        })
    }

    /// The same of parts in one.
    #[doc(hidden)]
    pub fn from_parts(mut parts: Parts) -> Result<Self, MuscleError> {
        parts.check_together()?;
        let reach = parts.reach();
        parts.tube.rubber = library::following(parts.tube.rubber, reach);
        let warm = parts
            .tube
            .temperature_degc
            .map(|_| Arc::new(parts.tube.rubber_at_temperature().into_owned()));
        Ok(Self {
            parts,
            bench: None,
            job: None,
            warm,
        })
    }

    /// The paper's prototype: D0 30, s 3, L0 285 mm, θ0 28°, rubber and braid `antonelli2018`.
    pub fn prototype() -> Self {
        let parts = Parts {
            tube: Tube::prototype(),
            braid: Braid::paper(),
            terminals: Terminals::default(),
            friction: None,
        };
        Self {
            parts,
            bench: None,
            job: None,
            warm: None,
        }
    }

    /// The rubber that models compute with: that of the tube, at its temperature where one is
    /// stated.
    pub fn rubber(&self) -> &Rubber {
        self.warm.as_deref().unwrap_or(&self.parts.tube.rubber)
    }

    /// The tube; the constants of its rubber are those that were stated.
    pub fn tube(&self) -> &Tube {
        &self.parts.tube
    }

    /// The braid.
    pub fn braid(&self) -> &Braid {
        &self.parts.braid
    }

    /// The terminals.
    pub fn terminals(&self) -> &Terminals {
        &self.parts.terminals
    }

    /// Braid friction, where it is known.
    pub fn friction(&self) -> Option<&Friction> {
        self.parts.friction.as_ref()
    }

    /// The bench that its constants were identified from, at this or another of its lengths; `None`
    /// also where the muscle or the bench was changed since.
    #[doc(hidden)]
    pub fn bench(&self) -> Option<&Bench> {
        self.bench_of_lengths().filter(|bench| {
            bench.lengths_mm.is_empty() || bench.lengths_mm.contains(&self.length_mm())
        })
    }

    /// Who measured the muscle that its constants come from, where that is somebody else than the
    /// user; also where the muscle was changed since.
    pub fn laboratory(&self) -> Option<&str> {
        self.bench.as_deref()?.laboratory.as_deref()
    }

    /// The same muscle with what a bench says of it.
    #[doc(hidden)]
    pub fn with_bench(mut self, bench: Bench) -> Self {
        self.bench = Some(Arc::new(bench));
        self
    }

    /// The same muscle with the bench and the job of another one, which it may have been made from.
    pub fn with_bench_of(mut self, other: &Self) -> Self {
        self.bench.clone_from(&other.bench);
        self.job.clone_from(&other.job);
        self
    }

    /// What the user should know of this muscle, in sentences, whatever the question.
    pub fn warnings(&self) -> Vec<String> {
        let said = self
            .parts
            .braid
            .warning(&self.parts.tube)
            .into_iter()
            .chain(self.measured_strand_warning());
        said.chain(self.bench_warning())
            .chain(self.extensile_warning())
            .chain(self.temperature_warning())
            .chain(self.modulus_warning())
            .collect()
    }

    /// A muscle that extends.
    fn extensile_warning(&self) -> Option<String> {
        self.is_extensile().then(|| {
            "this muscle extends: its pushes and extensions are below zero; no measured muscle of \
             this kind is known here, and the ± is that of muscles that contract"
                .to_owned()
        })
    }

    /// Rubber at another temperature than that of its constants.
    fn temperature_warning(&self) -> Option<String> {
        let degc = self.parts.tube.temperature_degc?;
        let of_constants = Rubber::OF_CONSTANTS_DEGC;
        (degc != of_constants).then(|| {
            let mu = |rubber: &Rubber| rubber.law.shear_modulus_mpa();
            let factor = mu(self.rubber()) / mu(&self.parts.tube.rubber);
            format!(
                "the rubber at {degc} °C has the moduli of {of_constants} °C times {factor:.3}, in \
                 proportion to the absolute temperature: an approximation for rubber without \
                 filler; strands and ends stay as they are, and no measured muscle at another \
                 temperature is known"
            )
        })
    }

    /// A modulus that no rubber of a muscle has.
    fn modulus_warning(&self) -> Option<String> {
        /// That of a rubber of about 95 Shore A, in MPa.
        const HARDEST_MPA: f64 = 20.0;
        /// That of a very soft gel.
        const SOFTEST_MPA: f64 = 1e-3;
        let mu_mpa = self.parts.tube.rubber.law.shear_modulus_mpa();
        let wrong = if mu_mpa > HARDEST_MPA {
            format!("even hard rubber has less than {HARDEST_MPA} MPa; is its unit kPa?")
        } else if mu_mpa < SOFTEST_MPA {
            format!("even the softest has more than {SOFTEST_MPA} MPa; is its unit MPa?")
        } else {
            return None;
        };
        Some(format!(
            "the shear modulus of the rubber is {mu_mpa} MPa, and {wrong}"
        ))
    }

    /// A bench that saw another muscle.
    fn bench_warning(&self) -> Option<String> {
        if let Some(bench) = self.bench_of_lengths().filter(|_| self.bench().is_none()) {
            let measured = joined(bench.lengths_mm.iter().map(f64::to_string), ", ");
            return Some(format!(
                "[identified] is valid for the lengths that were measured ({measured}\u{a0}mm), and \
                 this muscle has another one: the ± includes that another length differs; identify \
                 it again"
            ));
        }
        (self.bench.is_some() && self.bench().is_none()).then(|| {
            "[identified] is valid for the muscle and the table as `identify` wrote them, and one \
             of them was changed: the ± includes that another specimen differs; identify it again"
                .to_owned()
        })
    }

    /// A strand that was measured, and contradicts the angle by more than its rounded ends.
    fn measured_strand_warning(&self) -> Option<String> {
        const SHARE: f64 = 0.05;
        let measured = self.parts.braid.measured?;
        let length = self.strand_length_mm();
        let turns = self.turns();
        let off = |a: f64, b: f64| (a / b - 1.0).abs() > SHARE;
        (off(measured.strand_length_mm, length) || off(measured.turns, turns)).then(|| {
            format!(
                "a strand of {}\u{a0}mm with {} turns contradicts the angle of {}°, by which it \
                 would have {length:.1}\u{a0}mm and {turns:.2} turns; only belforte uses the \
                 strand, all else the angle",
                measured.strand_length_mm, measured.turns, self.parts.braid.angle_deg
            )
        })
    }

    /// The same muscle with another tube. A braid cut from a named sleeve has the sleeve's angle on
    /// another diameter.
    ///
    /// # Errors
    /// As [`Muscle::new`], and where the sleeve does not fit the tube.
    pub fn with_tube(&self, tube: Tube) -> Result<Self, MuscleError> {
        self.with_parts(Parts {
            braid: self.braid_on(tube.outer_diameter_mm)?,
            tube,
            ..self.parts.clone()
        })
    }

    /// The muscle of other parts, with the bench of this one.
    fn with_parts(&self, parts: Parts) -> Result<Self, MuscleError> {
        Ok(Self::from_parts(parts)?.with_bench_of(self))
    }

    /// The braid of this muscle on a tube of a diameter: its own on its own, that of its named
    /// sleeve on another.
    ///
    /// # Errors
    /// [`MuscleError`] where the sleeve does not fit the tube.
    pub fn braid_on(&self, outer_diameter_mm: f64) -> Result<Braid, MuscleError> {
        let braid = self.parts.braid.clone();
        // An angle that was stated for this diameter stays.
        let same = outer_diameter_mm == self.parts.tube.outer_diameter_mm;
        if same {
            Ok(braid)
        } else {
            braid.on_diameter(outer_diameter_mm)
        }
    }

    /// The same muscle with another diameter and wall.
    pub fn with_section(&self, outer_diameter_mm: f64, wall_mm: f64) -> Result<Self, MuscleError> {
        self.with_tube(Tube {
            outer_diameter_mm,
            wall_mm,
            ..self.parts.tube.clone()
        })
    }

    /// The same muscle with another length between its terminals.
    pub fn with_length(&self, length_mm: f64) -> Result<Self, MuscleError> {
        self.with_tube(Tube {
            length_mm,
            ..self.parts.tube.clone()
        })
    }

    /// The same muscle of another rubber.
    pub fn with_rubber(&self, rubber: Rubber) -> Result<Self, MuscleError> {
        self.with_tube(Tube {
            rubber,
            ..self.parts.tube.clone()
        })
    }

    /// The same muscle with another braid.
    pub fn with_braid(&self, braid: Braid) -> Result<Self, MuscleError> {
        self.with_parts(Parts {
            braid,
            ..self.parts.clone()
        })
    }

    /// The same muscle with other terminals.
    pub fn with_terminals(&self, terminals: Terminals) -> Result<Self, MuscleError> {
        self.with_parts(Parts {
            terminals,
            ..self.parts.clone()
        })
    }

    /// The same muscle with another friction of its braid.
    pub fn with_friction(&self, friction: Option<Friction>) -> Result<Self, MuscleError> {
        self.with_parts(Parts {
            friction,
            ..self.parts.clone()
        })
    }
}
