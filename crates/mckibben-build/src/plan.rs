//! All numbers of a build.

use crate::cut::Cut;
use crate::fitting::Fitting;
use crate::material::{self, BuildPart};
use crate::plug::{self, AirPlug, EyePlug, Stem};
use crate::safety::Safety;
use crate::test_sheet::{self, TestPoint};
use mckibben::analysis::FailureMode;
use mckibben::analysis::burst::ends::clamp_load_n;
use mckibben::muscle::Muscle;
use std::f64::consts::PI;
use thiserror::Error;

/// What a model found of the muscle.
#[derive(Debug, Clone, PartialEq)]
pub struct Operating {
    /// The model.
    pub model: String,
    /// Working pressure in MPa.
    pub pressure_mpa: f64,
    /// Blocked force there in N.
    pub blocked_force_n: f64,
    /// Free contraction there.
    pub free_contraction: f64,
    /// Largest outer diameter in mm of the muscle that contracts freely.
    pub bulged_diameter_mm: f64,
    /// Cavity in mm³ there.
    pub volume_mm3: f64,
    /// Its outer contour from the middle (z = 0) to a clamp: z and radius in mm.
    pub contour_mm: Vec<[f64; 2]>,
    /// Burst pressure in MPa, where it is known, and how the muscle fails there.
    pub burst: Option<(f64, FailureMode)>,
    /// Largest allowed pressure in MPa, where it is known.
    pub allowed_mpa: Option<f64>,
    /// Free contractions at the pressures of the test sheet: pressure in MPa, contraction.
    pub free_contractions: Vec<(f64, f64)>,
}

/// What the builder may choose.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Wishes {
    /// What the hose is connected to.
    pub fitting: Option<Fitting>,
    /// Bolt of the eye in mm.
    pub bolt_mm: Option<f64>,
    /// Diameter in mm of the sleeve as it comes off the roll.
    pub sleeve_diameter_mm: Option<f64>,
}

/// What holds tube and sleeve on a plug.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Clamps {
    /// Cable ties.
    Ties {
        /// Width in mm.
        width_mm: f64,
        /// At each end.
        at_each_end: usize,
    },
    /// Ties would not hold.
    Crimped,
}

impl Clamps {
    /// How many in all.
    pub(crate) fn amount(&self) -> String {
        match self {
            Self::Ties { at_each_end, .. } => (2 * at_each_end).to_string(),
            Self::Crimped => "2".into(),
        }
    }
}

/// Widths of ties in mm and their least loop strength in N (QB/T 4494-2013), and the stem in mm up to which one is chosen (a choice: a narrow tie bends to
/// a small circle more evenly).
const TIES: [(f64, f64, f64); 4] =
    [(2.5, 80.0, 6.0), (3.6, 130.0, 15.0), (4.8, 180.0, 40.0), (7.6, 450.0, f64::INFINITY)];
/// A tie that is tightened by hand has this share of its strength (a choice).
const TIGHTENED: f64 = 1.0 / 3.0;
/// Friction of a sleeve on a tube under a tie (an estimate).
const FRICTION: f64 = 0.3;

/// What cannot be built.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum BuildError {
    /// There is nothing to clamp.
    #[error(
        "a length of {length_mm} mm on each plug holds no clamp; state `insertion_mm` of at least {least_mm} mm ([terminals] of the muscle file)"
    )]
    Insertion {
        /// Length on a plug in mm.
        length_mm: f64,
        /// Least length in mm.
        least_mm: f64,
    },
    /// A bolt that no eye can have.
    #[error("a bolt of {bolt_mm} mm does not fit; give a diameter from 2 to 64 mm")]
    Bolt {
        /// Diameter in mm.
        bolt_mm: f64,
    },
    /// No diameter of a sleeve.
    #[error(
        "a sleeve of {diameter_mm} mm cannot be pulled over this tube: its strands allow diameters up to {most_mm:.1} mm"
    )]
    Sleeve {
        /// Relaxed diameter in mm.
        diameter_mm: f64,
        /// Largest diameter in mm.
        most_mm: f64,
    },
}

/// All numbers of a build.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// The muscle.
    pub muscle: Muscle,
    /// What a model found of it.
    pub operating: Operating,
    /// What is cut.
    pub cut: Cut,
    /// Diameter over the sleeve in mm: two strands cross on each side.
    pub over_sleeve_mm: f64,
    /// Diameter over tube and sleeve on a plug in mm: what a clamp closes on.
    pub clamped_diameter_mm: f64,
    /// Inner diameter in mm of a crimped ferrule: the wall is pressed to three quarters of its thickness (a choice).
    pub crimp_diameter_mm: f64,
    /// What an end must hold in N: the blocked force and the pressure on the bore.
    pub end_load_n: f64,
    /// What one tie holds in N, by estimate.
    pub tie_holds_n: f64,
    /// What holds the ends.
    pub clamps: Clamps,
    /// The plug with the air passage.
    pub air_plug: AirPlug,
    /// The plug with the eye.
    pub eye_plug: EyePlug,
    /// Pressures of the tests.
    pub safety: Safety,
    /// The bill of materials.
    pub parts: Vec<BuildPart>,
    /// The points of the first test.
    pub test: Vec<TestPoint>,
}

impl Plan {
    /// Least length in mm on a plug.
    const LEAST_INSERTION_MM: f64 = 3.0;

    /// The plan of a muscle.
    ///
    /// # Errors
    /// [`BuildError`].
    pub fn new(muscle: Muscle, operating: Operating, wishes: &Wishes) -> Result<Self, BuildError> {
        let (length_mm, least_mm) = (muscle.terminals().insertion_mm(), Self::LEAST_INSERTION_MM);
        if length_mm < least_mm {
            return Err(BuildError::Insertion { length_mm, least_mm });
        }
        if let Some(bolt_mm) = wishes.bolt_mm.filter(|b| !(2.0..=64.0).contains(b)) {
            return Err(BuildError::Bolt { bolt_mm });
        }
        let cut = Cut::of(&muscle, wishes.sleeve_diameter_mm);
        if let Some(diameter_mm) =
            wishes.sleeve_diameter_mm.filter(|_| cut.sleeve.relaxed_diameter_mm != wishes.sleeve_diameter_mm)
        {
            return Err(BuildError::Sleeve { diameter_mm, most_mm: muscle.strand_length_per_turn_mm() / PI });
        }
        let strand_mm = cut.sleeve.strand_area_mm2.map(|area| (4.0 * area / PI).sqrt());
        let sleeve_mm = if muscle.braid().thickness_mm > 0.0 {
            muscle.braid().thickness_mm
        } else {
            2.0 * strand_mm.unwrap_or(0.25)
        };
        let over_sleeve_mm = muscle.outer_diameter_mm() + 2.0 * sleeve_mm;
        let bore_mm = cut.tube_outer_diameter_mm - 2.0 * cut.tube_wall_mm;
        let end_load_n = clamp_load_n(&muscle, operating.blocked_force_n.max(0.0), operating.pressure_mpa);
        let bolt_mm = wishes.bolt_mm.unwrap_or_else(|| plug::bolt_mm(end_load_n));
        let (width_mm, strength_n, _) =
            TIES.into_iter().find(|tie| bore_mm <= tie.2).unwrap_or(TIES[TIES.len() - 1]);
        let stem = Stem::new(bore_mm, length_mm, over_sleeve_mm, width_mm, plug::foot_mm(bolt_mm));
        let tie_holds_n = 2.0 * PI * FRICTION * TIGHTENED * strength_n;
        // One in each groove.
        let clamps = match stem.grooves {
            n @ 1.. if n as f64 * tie_holds_n >= end_load_n => Clamps::Ties { width_mm, at_each_end: n },
            _ => Clamps::Crimped,
        };
        let fitting = wishes.fitting.unwrap_or_else(|| Fitting::usual(muscle.outer_diameter_mm()));
        let safety = Safety::new(operating.pressure_mpa, operating.burst.map(|b| b.0), operating.volume_mm3);
        let test = test_sheet::points(&operating);
        let mut plan = Self {
            clamped_diameter_mm: stem.diameter_mm + 2.0 * (cut.tube_wall_mm + sleeve_mm),
            crimp_diameter_mm: stem.diameter_mm + 2.0 * (0.75 * cut.tube_wall_mm + sleeve_mm),
            over_sleeve_mm,
            cut,
            end_load_n,
            tie_holds_n,
            clamps,
            air_plug: AirPlug::new(stem, fitting),
            eye_plug: EyePlug::new(stem, bolt_mm),
            safety,
            parts: vec![],
            test,
            muscle,
            operating,
        };
        plan.parts = material::bill(&plan);
        Ok(plan)
    }

    /// Mass in g of the parts whose mass is known.
    pub fn mass_g(&self) -> f64 {
        self.parts.iter().filter_map(|p| p.mass_g).sum()
    }

    /// Pressures in MPa from which the test sheet takes its own: shares of the working pressure, to 0.01 MPa where that leaves all of them.
    pub fn test_pressures_mpa(working_mpa: f64) -> [f64; 5] {
        let step = if working_mpa >= 0.1 { 0.01 } else { working_mpa / 100.0 };
        [0.3, 0.5, 0.7, 0.85, 1.0].map(|share| match share {
            1.0 => working_mpa,
            share => (share * working_mpa / step).round() * step,
        })
    }

    /// What should be said beside the plan, in sentences.
    pub fn warnings(&self) -> Vec<String> {
        let mut out = vec![];
        let bore_mm = self.air_plug.stem.diameter_mm - self.air_plug.stem.interference_mm;
        if bore_mm < 4.0 {
            out.push(format!(
                "a plug for a bore of {} mm is too thin for most printers; a turned plug, or a needle with a knot of thread, takes its place",
                crate::text::mm(bore_mm)
            ));
        }
        if self.clamps == Clamps::Crimped {
            out.push(format!(
                "each end must hold about {} N, more than cable ties do by estimate: crimp a ferrule, or clamp with a hose clamp",
                crate::text::significant(self.end_load_n, 2)
            ));
        }
        out
    }
}
