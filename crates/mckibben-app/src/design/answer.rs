//! What a design answers with.

use super::request::{Searching, TorqueWanted, Wanted};
use crate::burst::{put_first, said_of};
use crate::muscle::MuscleSummary;
use crate::units::Units;
use crate::words::{number, percent};
use mckibben::analysis::{Burst, NoBurst};
use mckibben::design::{
    BraidChoice, Candidate, CandidatePoint, Closest, Demand, Limit, OperatingPoint, Outcome, Rejected,
    Relaxation, Spec, Spread, Sure,
};
use mckibben::model::Response;
use mckibben::warning::Warning;
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::Serialize;

/// Ranked muscles, and why others fail.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct DesignAnswer {
    /// The model that all numbers come from.
    pub model: String,
    /// The model that looked at most muscles.
    pub searched_with: String,
    /// Pressure of the supply, MPa.
    pub max_pressure_mpa: f64,
    /// The load that is lifted, as it was written.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub load: Option<String>,
    /// What was assumed where nothing was said, in sentences.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub assumptions: Vec<String>,
    /// Muscles that were looked at.
    pub looked_at: usize,
    /// How many of them fit.
    pub fitting: usize,
    /// How many of those that were looked at burst too early for the margin that is asked for; of strands whose strength is not stated
    /// nobody can say.
    pub excluded_by_burst: usize,
    /// How many of these meet every other limit.
    pub excluded_by_burst_alone: usize,
    /// The best, best first.
    pub candidates: Vec<CandidateAnswer>,
    /// Muscles that just miss, or come closest.
    pub rejected: Vec<RejectedAnswer>,
    /// Where another model was named: the winner by finite elements.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub verification: Option<Verified>,
    /// What the user should know of the winner; where nothing fits, whether burst was checked.
    #[schemars(with = "Vec<String>")]
    pub warnings: Vec<Warning>,
    /// Spread of the winner's pull under the tolerances, point by point.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub tolerance: Vec<SpreadAnswer>,
    /// Where the winner has less to spare than its ±: what to ask for to be sure of what is wanted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub to_be_sure: Option<SureAnswer>,
    /// Where nothing fits: the muscle that comes closest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub closest: Option<ClosestAnswer>,
    /// The figure, where it was asked for and something fits.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub figure: Option<Figure>,
    /// The specification as it was searched.
    #[serde(skip)]
    pub spec: Spec,
    /// What came out, muscles and all.
    #[serde(skip)]
    pub outcome: Outcome,
}

/// A muscle that fits.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CandidateAnswer {
    /// The muscle.
    #[serde(flatten)]
    pub muscle: MuscleSummary,
    /// Largest pressure any point needs, MPa.
    pub pressure_mpa: f64,
    /// Least margin over the points: pull at the maximum pressure over the pull wanted, minus 1.
    pub margin: f64,
    /// Blocked force at the maximum pressure, N.
    pub blocked_force_n: f64,
    /// Free contraction at the maximum pressure.
    pub free_contraction: Option<f64>,
    /// Largest outer diameter over the points, mm.
    pub bulged_diameter_mm: Option<f64>,
    /// Stiffness ∂F/∂L at the first point, N/mm.
    pub stiffness_n_per_mm: Option<f64>,
    /// Largest air per stroke over the points, normal litres.
    pub air_normal_litres: Option<f64>,
    /// Work from ε = 0 to the largest contraction wanted at the maximum pressure, J.
    pub work_j: Option<f64>,
    /// Largest tension of one strand, N.
    pub strand_tension_n: Option<f64>,
    /// Largest tension of all strands together, N.
    pub braid_tension_n: Option<f64>,
    /// Largest stretch of the rubber.
    pub max_stretch: Option<f64>,
    /// Burst pressure, MPa, where the strands' strength is known.
    pub burst_pressure_mpa: Option<f64>,
    /// Largest 95 % half-width of the pull, N.
    pub uncertainty_n: Option<f64>,
    /// The operating points, in the order of the specification.
    pub points: Vec<DesignPoint>,
    /// Quantities that the model does not give and the thick-wall model gave instead.
    pub from_thick_wall: Vec<String>,
    /// Of a joint: its pulley, and how the muscle is put on it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint: Option<CandidateJoint>,
    /// The model that all its numbers come from.
    pub model: String,
    /// The limit that keeps it from being better, where less than 1 % of it is left.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub binds: Option<Limit>,
}

/// The joint around a candidate.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct CandidateJoint {
    /// Radius of the pulley, mm.
    pub radius_mm: f64,
    /// Contraction of both muscles at the neutral angle.
    pub contraction_at_neutral: f64,
    /// Largest angle to either side, degrees.
    pub largest_angle_deg: f64,
}

/// A candidate at one operating point.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct DesignPoint {
    /// What the muscle is like there, at the pressure it takes.
    #[serde(flatten)]
    pub response: Response,
    /// Pull at the maximum pressure, N.
    pub force_at_max_pressure_n: f64,
    /// That pull over the pull wanted, minus 1.
    pub margin: f64,
    /// Air from rest to this point, normal litres.
    pub air_normal_litres: Option<f64>,
    /// 95 % half-width of the pull, N.
    pub uncertainty_n: Option<f64>,
}

/// What to ask for so that the lower end of the ± of the muscle that answers it is what is wanted.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SureAnswer {
    /// Pulls at contractions; of a load those that it takes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub points: Vec<Wanted>,
    /// Torques at angles, of a joint.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub torques: Vec<TorqueWanted>,
    /// Of a load on muscles whose length is searched: how many times as heavy a load to ask for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub load_factor: Option<f64>,
    /// Outer diameter D0 of the muscle that answers, mm.
    pub outer_diameter_mm: f64,
    /// Its largest 95 % half-width, N.
    pub uncertainty_n: Option<f64>,
}

/// A muscle that does not fit.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct RejectedAnswer {
    /// Outer diameter D0, mm.
    pub outer_diameter_mm: f64,
    /// Wall s, mm.
    pub wall_mm: f64,
    /// Length L0, mm.
    pub length_mm: f64,
    /// Braid angle θ0, degrees.
    pub angle_deg: f64,
    /// Name of the rubber, where it has one.
    pub rubber: Option<String>,
    /// The limit that it misses by most, in a sentence.
    pub reason: String,
    /// That limit; none where the model has no answer.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<Limit>,
    /// By which share of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub misses_by: Option<f64>,
}

/// The muscle that comes closest, and what would make it fit.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ClosestAnswer {
    /// The muscle and the bound it misses.
    #[serde(flatten)]
    pub rejected: RejectedAnswer,
    /// Limits that could give, each alone.
    pub relaxations: Vec<RelaxationAnswer>,
    /// Contractions that no braid of the search reaches, and the angle that would; a stiffer sleeve that would do.
    pub hint: Option<String>,
}

/// A limit to relax, and by how much.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "relax", rename_all = "snake_case")]
pub enum RelaxationAnswer {
    /// Supply this pressure.
    MaxPressure {
        /// MPa.
        pressure_mpa: f64,
        /// The model had to be asked outside of its range.
        extrapolated: bool,
    },
    /// Accept these pulls.
    Force {
        /// The points that fall short, as they could be.
        points: Vec<Wanted>,
    },
    /// Accept these contractions.
    Contraction {
        /// The points that fall short, as they could be.
        points: Vec<Wanted>,
    },
    /// Take a wider tube with the same wall.
    OuterDiameter {
        /// mm.
        outer_diameter_mm: f64,
        /// The model that says so.
        model: String,
        /// The model of the search, to which that model was scaled because it lies outside of its range.
        scaled_to: Option<String>,
    },
    /// Allow this diameter when bulged.
    MaxBulgedDiameter {
        /// mm.
        bulged_diameter_mm: f64,
    },
    /// Allow this stretch of the rubber.
    MaxStretch {
        /// Largest principal stretch.
        max_stretch: f64,
    },
    /// Allow this strain of the strands.
    MaxStrandStrain {
        /// Largest strain at the maximum pressure.
        strand_strain: f64,
    },
    /// Accept this burst margin.
    MinBurstMargin {
        /// Burst pressure over maximum pressure.
        burst_margin: f64,
    },
}

/// A winner computed again.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Verified {
    /// By which model.
    pub model: String,
    /// Whether the specification, limits and all, holds by it.
    pub holds: bool,
    /// The operating points.
    pub points: Vec<VerifiedPoint>,
}

/// The winner at one operating point by finite elements.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct VerifiedPoint {
    /// Pull wanted, N.
    pub force_n: f64,
    /// At this contraction.
    pub contraction: f64,
    /// Pressure it takes, MPa, where there is one.
    pub pressure_mpa: Option<f64>,
    /// Pull at the maximum pressure, N.
    pub force_at_max_pressure_n: Option<f64>,
    /// Why there is none.
    pub cause: Option<String>,
}

/// The pull at one operating point under tolerances.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SpreadAnswer {
    /// Pull wanted, N.
    pub force_n: f64,
    /// At this contraction.
    pub contraction: f64,
    /// And this pressure, MPa.
    pub pressure_mpa: f64,
    /// Least pull over all corners, N.
    pub low_n: f64,
    /// Largest pull over all corners, N.
    pub high_n: f64,
    /// What to expect where the tolerances are independent, ± N.
    pub likely_n: f64,
}

impl DesignAnswer {
    pub(super) fn new(
        spec: Spec,
        model: &Searching,
        outcome: Outcome,
        spreads: &[Spread],
        verification: Option<Verified>,
        figure: Option<Figure>,
    ) -> Self {
        Self {
            model: model.name().into(),
            searched_with: model.searches().into(),
            max_pressure_mpa: spec.max_pressure_mpa,
            load: None,
            assumptions: vec![],
            looked_at: outcome.looked_at.0,
            fitting: outcome.looked_at.1,
            excluded_by_burst: outcome.too_weak.0,
            excluded_by_burst_alone: outcome.too_weak.1,
            candidates: outcome.candidates.iter().map(|c| CandidateAnswer::new(c, &spec)).collect(),
            rejected: outcome.rejected.iter().map(RejectedAnswer::from).collect(),
            verification,
            warnings: outcome
                .candidates
                .first()
                .map(|c| warnings(c, spec.max_pressure_mpa))
                .unwrap_or_else(|| not_checked(&outcome, spec.max_pressure_mpa))
                .into_iter()
                .chain(model.seal_warning().map(Warning::from))
                .collect(),
            tolerance: spreads.iter().map(SpreadAnswer::from).collect(),
            to_be_sure: None,
            closest: outcome.closest.as_ref().map(|c| ClosestAnswer::new(c, &spec)),
            figure,
            spec,
            outcome,
        }
    }
}

impl CandidateAnswer {
    fn new(c: &Candidate, spec: &Spec) -> Self {
        Self {
            joint: match &spec.wanted {
                Demand::Joint(joint) => Some(CandidateJoint {
                    radius_mm: joint.radius_mm,
                    contraction_at_neutral: joint.contraction_at_neutral(c.muscle.length_mm()),
                    largest_angle_deg: joint.largest_angle_deg,
                }),
                _ => None,
            },
            muscle: (&c.muscle).into(),
            pressure_mpa: c.pressure_mpa,
            margin: c.margin,
            blocked_force_n: c.blocked_force_n,
            free_contraction: c.free_contraction,
            bulged_diameter_mm: c.bulged_diameter_mm(),
            stiffness_n_per_mm: c.points.first().and_then(|q| q.response.stiffness_n_per_mm),
            air_normal_litres: c.air_normal_litres(),
            work_j: c.work_j,
            strand_tension_n: c.largest(|q| q.response.strand_tension_n),
            braid_tension_n: c.largest(|q| q.response.braid_tension_n),
            max_stretch: c.largest(|q| q.response.max_stretch),
            burst_pressure_mpa: c.burst_pressure_mpa,
            uncertainty_n: c.largest(|q| q.uncertainty_n),
            points: c.points.iter().map(DesignPoint::from).collect(),
            from_thick_wall: c.from_thick_wall.iter().map(|&name| name.into()).collect(),
            model: c.model.clone(),
            binds: c.binds,
        }
    }
}

impl From<&Sure> for SureAnswer {
    fn from(sure: &Sure) -> Self {
        let muscle = &sure.candidate.muscle;
        let torque = |&(torque_nm, angle_deg): &(f64, f64)| TorqueWanted { torque_nm, angle_deg };
        let (points, torques) = match &sure.demand {
            Demand::Joint(joint) => (vec![], joint.torques.iter().map(torque).collect()),
            other => (other.points(muscle.length_mm()).iter().map(|&q| q.into()).collect(), vec![]),
        };
        let uncertainty_n = sure.candidate.largest(|q| q.uncertainty_n);
        let load_factor = sure.load_factor;
        Self { points, torques, load_factor, outer_diameter_mm: muscle.outer_diameter_mm(), uncertainty_n }
    }
}

impl From<&CandidatePoint> for DesignPoint {
    fn from(q: &CandidatePoint) -> Self {
        Self {
            // The pressure of the response is the one it takes, its pull the one that is wanted.
            response: Response { pressure_mpa: q.pressure_mpa, force_n: q.wanted.force_n, ..q.response },
            force_at_max_pressure_n: q.available_n,
            margin: q.margin,
            air_normal_litres: q.air_normal_litres,
            uncertainty_n: q.uncertainty_n,
        }
    }
}

impl From<&Rejected> for RejectedAnswer {
    fn from(r: &Rejected) -> Self {
        Self {
            outer_diameter_mm: r.outer_diameter_mm,
            wall_mm: r.wall_mm,
            length_mm: r.length_mm,
            angle_deg: r.angle_deg,
            rubber: r.rubber.clone(),
            reason: r.reason.describe(|kind, v| Units::default().show(kind, v)),
            limit: r.reason.limit(),
            misses_by: r.reason.misses_by(),
        }
    }
}

impl From<OperatingPoint> for Wanted {
    fn from(q: OperatingPoint) -> Self {
        Self { force_n: q.force_n, contraction: q.contraction }
    }
}

impl From<&Relaxation> for RelaxationAnswer {
    fn from(relaxation: &Relaxation) -> Self {
        let wanted = |points: &[OperatingPoint]| points.iter().map(|&q| q.into()).collect();
        match relaxation {
            &Relaxation::Pressure { pressure_mpa, extrapolated } => {
                Self::MaxPressure { pressure_mpa, extrapolated }
            }
            Relaxation::Force(points) => Self::Force { points: wanted(points) },
            Relaxation::Contraction(points) => Self::Contraction { points: wanted(points) },
            Relaxation::OuterDiameter { outer_diameter_mm, model, scaled_to } => Self::OuterDiameter {
                outer_diameter_mm: *outer_diameter_mm,
                model: model.clone(),
                scaled_to: scaled_to.clone(),
            },
            &Relaxation::BulgedDiameter { diameter_mm } => {
                Self::MaxBulgedDiameter { bulged_diameter_mm: diameter_mm }
            }
            &Relaxation::Stretch { stretch } => Self::MaxStretch { max_stretch: stretch },
            &Relaxation::StrandStrain { strain } => Self::MaxStrandStrain { strand_strain: strain },
            &Relaxation::BurstMargin { margin } => Self::MinBurstMargin { burst_margin: margin },
        }
    }
}

impl From<&Spread> for SpreadAnswer {
    fn from(s: &Spread) -> Self {
        Self {
            force_n: s.wanted.force_n,
            contraction: s.wanted.contraction,
            pressure_mpa: s.pressure_mpa,
            low_n: s.low_n,
            high_n: s.high_n,
            likely_n: s.likely_n,
        }
    }
}

impl ClosestAnswer {
    fn new(closest: &Closest, spec: &Spec) -> Self {
        Self {
            rejected: (&closest.rejected).into(),
            relaxations: closest.relaxations.iter().map(RelaxationAnswer::from).collect(),
            hint: out_of_reach(spec),
        }
    }
}

/// What is said of a burst where nothing fits: that it was not checked, of strands whose strength is not stated.
fn not_checked(outcome: &Outcome, max_pressure_mpa: f64) -> Vec<Warning> {
    let missing = outcome.closest.as_ref().and_then(|closest| Burst::missing(&closest.muscle));
    missing.and_then(|why| said_of(&Burst::Unknown(why), max_pressure_mpa, 0.0)).into_iter().collect()
}

/// What the user should know of a candidate: of its burst pressure, of its muscle, and of its operating points.
fn warnings(c: &Candidate, max_pressure_mpa: f64) -> Vec<Warning> {
    let mut all = crate::warnings::of_responses(&c.muscle, c.points.iter().map(|q| &q.response));
    let found = c.burst.unwrap_or(Burst::Unknown(NoBurst::NoAnswer { up_to_mpa: 0.0 }));
    all.extend(super::assumed::thin_wall(&c.muscle).map(Warning::from));
    put_first(&mut all, said_of(&found, max_pressure_mpa, 0.0));
    all
}

/// Contractions that no braid of the search reaches, and the angle that would.
fn out_of_reach(spec: &Spec) -> Option<String> {
    let BraidChoice::Angle(angles) = &spec.braid else { return None };
    let smallest = angles.bounds().0;
    let most = |angle: f64| 1.0 - 1.0 / (3f64.sqrt() * angle.to_radians().cos());
    let points = spec.wanted.points(spec.length_mm.as_ref().map_or(spec.base.length_mm(), |l| l.bounds().1));
    let wanted = points.iter().map(|q| q.contraction).fold(0.0, f64::max);
    if wanted < most(smallest) {
        return None;
    }
    let cos = 1.0 / (3f64.sqrt() * (1.0 - wanted));
    let reach = if cos < 1.0 {
        format!("{} needs one well below {}°", percent(wanted), number(cos.acos().to_degrees().floor(), 3))
    } else {
        format!("no braid reaches {} (the limit is 42.3 %)", percent(wanted))
    };
    let at = number(smallest, 4);
    Some(format!(
        "A braid at {at}° contracts by {} at most; {reach}.",
        percent((most(smallest) * 1e3).floor() / 1e3)
    ))
}
