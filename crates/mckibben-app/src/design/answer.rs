//! What a design answers with.

use super::{cycle::CycleAnswer, remedies::RelaxationAnswer};
use crate::{
    MuscleSummary, PressureLimits, TextFile, UncertaintyWords, percent,
    words::{braid_name, rubber_name},
};
use mckibben_core::{
    analysis::Burst,
    by_number::SortByNumber,
    extremes::peak,
    liquid::Liquid,
    muscle::{Braid, BraidStiffness, Job, JobPoint, file::to_toml},
    units::Positive,
    warning::Warning,
};
use mckibben_design::{
    BraidChoice, Bundle, Candidate, ChoiceKind, Demand, Limit, Outcome, Rejected, Spec,
    tubes::rubbers,
};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::Serialize;
use serde_with_macros::skip_serializing_none;

/// Ranked muscles, and the reasons why others fail.
#[skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct DesignAnswer {
    /// The decision in sentences: what to take with its chance, which pressure to set, what it pulls,
    /// what to measure, what limits it; where nothing fits the best chance there is.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub decision: Vec<String>,
    /// The model that all numbers come from.
    pub model: String,
    /// The model that computed most muscles of the search.
    pub searched_with: String,
    /// Pressure of the supply, MPa.
    pub max_pressure_mpa: f64,
    /// What the muscle must do.
    pub wanted: Demand,
    /// Search space and limits.
    pub searched: SearchedAnswer,
    /// The liquid in the place of air, where there is one.
    pub liquid: Option<Liquid>,
    /// The load that is lifted, as it was written.
    pub load: Option<String>,
    /// Assumptions for values that were not given, in sentences.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub assumptions: Vec<String>,
    /// Number of muscles examined.
    pub looked_at: usize,
    /// How many of them fit.
    pub fitting: usize,
    /// The best muscles, best first.
    pub candidates: Vec<CandidateAnswer>,
    /// The ± of the best muscle in words, at the point where it is largest.
    pub uncertainty_words: Option<UncertaintyWords>,
    /// Near misses, or the muscles that come closest.
    pub rejected: Vec<RejectedAnswer>,
    /// Warnings about the best muscle; if nothing fits, whether burst was checked.
    pub warnings: Vec<Warning>,
    /// The first beside what has another chance, make or number, and muscles as sold; where nothing
    /// fits what has the best chance.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub choices: Vec<ChoiceAnswer>,
    /// With `cycle_hz`: the air and the valve of the best muscle.
    pub cycle: Option<CycleAnswer>,
    /// If nothing fits: the muscle that comes closest.
    pub closest: Option<ClosestAnswer>,
    /// Of a bundle: what its muscles do together, by the best muscle.
    pub bundle: Option<Bundle>,
    /// The figure, where one is wanted and something fits.
    pub figure: Option<Figure>,
    /// The candidates as muscle files, in their order.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub muscle_files: Vec<TextFile>,
}

/// Search space and limits.
#[skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct SearchedAnswer {
    /// The rubber, or how many.
    pub rubber: String,
    /// The braid or sleeve, or how many; its stiffness may differ from muscle to muscle.
    pub braid: String,
    /// Length L0 of all muscles, mm, where it is not searched.
    pub length_mm: Option<f64>,
    /// Safety factor of strands and clamps: the pressure at which they fail over the allowed
    /// pressure, where there is one.
    pub min_burst_margin: Option<f64>,
    /// Safety factor of the tube.
    pub min_tube_margin: Option<f64>,
    /// Whether it was checked: the strength of the strands is known.
    pub burst_checked: bool,
    /// Largest strain of the strands, where there is one.
    pub max_strand_strain: Option<f64>,
    /// The chance that is required; none where the model's own pull decides.
    pub certainty: Option<f64>,
}

/// A muscle that fits.
#[derive(Debug, Serialize, JsonSchema)]
pub struct CandidateAnswer {
    /// The muscle.
    #[serde(flatten)]
    pub muscle: MuscleSummary,
    /// What the search found of it.
    #[serde(flatten)]
    pub candidate: Candidate,
    /// Largest outer diameter over the points, mm.
    pub bulged_diameter_mm: Option<f64>,
    /// Stiffness k of one strand family, N/mm; none of strands that keep their length.
    pub family_stiffness_n_per_mm: Option<f64>,
    /// Stiffness ∂F/∂L at the first point, N/mm.
    pub stiffness_n_per_mm: Option<f64>,
    /// Largest air per stroke over the points, normal litres; none with a liquid.
    pub air_normal_litres: Option<f64>,
    /// Largest liquid volume over the points that is pushed in from rest, measured at atmospheric
    /// pressure, mm³.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub liquid_volume_mm3: Option<f64>,
    /// Largest tension of one strand, N.
    pub strand_tension_n: Option<f64>,
    /// Largest tension of all strands together, N.
    pub braid_tension_n: Option<f64>,
    /// Largest stretch of the rubber.
    pub max_stretch: Option<f64>,
    /// The pressures that the muscle bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
    /// Largest 95 % half-width of the pull, N.
    pub uncertainty_n: Option<f64>,
    /// Of a joint: its pulley, and how the muscle is put on it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint: Option<CandidateJoint>,
}

/// The joint around a candidate.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct CandidateJoint {
    /// Radius of the pulley, mm.
    pub radius_mm: f64,
    /// Contraction of both muscles at the neutral angle.
    pub contraction_at_neutral: f64,
    /// Largest angle to either side, degrees.
    pub largest_angle_deg: f64,
}

/// One of the choices of the decision.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ChoiceAnswer {
    /// What it is.
    pub kind: ChoiceKind,
    /// The chance in words, with how many there are side by side.
    pub name: String,
    /// Tube and sleeve, or the product.
    pub parts: String,
    /// Diameter of the circle around all of them, mm.
    pub envelope_mm: f64,
    /// The muscle.
    #[serde(flatten)]
    pub candidate: CandidateAnswer,
}

/// A muscle that does not fit.
#[derive(Debug, Serialize, JsonSchema)]
pub struct RejectedAnswer {
    /// The muscle.
    #[serde(flatten)]
    pub muscle: MuscleSummary,
    /// What the search found of it.
    #[serde(flatten)]
    pub rejected: Rejected,
    /// The limit that it misses by most, in a sentence.
    pub reason: String,
    /// That limit.
    pub limit: Limit,
}

/// The muscle that comes closest, and what would make it fit.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ClosestAnswer {
    /// The muscle and the bound it misses.
    #[serde(flatten)]
    pub rejected: RejectedAnswer,
    /// Changes with which a muscle of the search fits, the smallest of each kind; those that ask
    /// for least first.
    pub relaxations: Vec<RelaxationAnswer>,
}

fn joint_of(c: &Candidate, spec: &Spec) -> Option<CandidateJoint> {
    let joint = spec.wanted.joint()?;
    Some(CandidateJoint {
        radius_mm: c.radius_mm,
        contraction_at_neutral: joint.contraction_at_neutral(c.radius_mm, c.muscle.length_mm()),
        largest_angle_deg: joint.largest_angle_deg,
    })
}

/// The muscle of a candidate, which knows its job.
pub fn muscle_file(place: usize, candidate: &Candidate, spec: &Spec) -> TextFile {
    let name = match place {
        0 => "winner.toml".to_owned(),
        _ => format!("candidate-{}.toml", place + 1),
    };
    let mut points = candidate.points.clone();
    points.sort_by_number(|a| -a.response.pressure_mpa);
    let points = points.iter().map(|q| JobPoint {
        force: q.required_n.into(),
        contraction: q.response.contraction.into(),
    });
    let mut muscle = candidate.muscle.clone();
    let joint = joint_of(candidate, spec);
    if let Some(pressure) = Positive::new(candidate.pressure_mpa.into()) {
        muscle = muscle.with_job(Job {
            pressure,
            highest: candidate
                .pressure_high_mpa
                .and_then(|mpa| Positive::new(mpa.into())),
            supply: Positive::new(spec.max_pressure_mpa.into()),
            branch: Some(spec.options().direction),
            liquid: spec.liquid.as_ref().map(|l| l.liquid.name.to_owned()),
            count: Some(candidate.count).filter(|count| *count > 1),
            pulley: joint.and_then(|joint| Positive::new(joint.radius_mm.into())),
            contraction_at_neutral: joint.map(|joint| joint.contraction_at_neutral.into()),
            points: points.collect(),
        });
    }
    TextFile {
        name,
        text: to_toml(&muscle),
    }
}

impl SearchedAnswer {
    /// What a search held fixed and what it varied.
    pub fn new(spec: &Spec) -> Self {
        let has_strength = |braid: &Braid| braid.strands.is_some_and(|s| s.strength_n.is_some());
        Self {
            rubber: rubber_of(spec),
            braid: braid_of(spec),
            length_mm: spec.length_mm.is_none().then(|| spec.base.length_mm()),
            min_burst_margin: spec.limits.burst_margin.filter(|m| *m > 0.0),
            min_tube_margin: Some(spec.limits.safety().tube).filter(|m| *m > 0.0),
            burst_checked: match &spec.braid {
                BraidChoice::Sleeves(list) => list.iter().all(has_strength),
                _ => has_strength(spec.base.braid()),
            },
            max_strand_strain: spec.limits.strand_strain,
            certainty: spec.certainty,
        }
    }
}

/// The rubber that is searched with.
fn rubber_of(spec: &Spec) -> String {
    let names = spec.rubbers.iter().filter_map(|r| r.name.as_deref());
    match (spec.tubes.len(), &Vec::from_iter(names)[..]) {
        (0, []) => format!("rubber {}", rubber_name(&spec.base)),
        (0, [one]) => format!("rubber {one}"),
        (0, several) => format!("{} rubbers", several.len()),
        (n, _) => {
            let tubes = if n == 1 { "tube" } else { "tubes" };
            format!("{n} {tubes} of {}", rubbers(&spec.tubes).join(", "))
        }
    }
}

/// The braid that is searched with.
fn braid_of(spec: &Spec) -> String {
    let base = &spec.base;
    match (&spec.braid, base.braid().stiffness, base.braid().strands) {
        (BraidChoice::Sleeves(list), ..) => match &list[..] {
            [Braid { sleeve: None, .. }] => "sleeve of the muscle file".into(),
            [
                Braid {
                    sleeve: Some(s), ..
                },
            ] => format!("sleeve {}", s.name),
            _ => format!("{} sleeves", list.len()),
        },
        (_, BraidStiffness::OfStrands, Some(strands)) => {
            format!("braid of {} strands", strands.count)
        }
        _ => format!("braid {}", braid_name(base)),
    }
}

impl CandidateAnswer {
    /// A candidate with the numbers of its joint, ends and limits.
    pub fn new(c: &Candidate, spec: &Spec) -> Self {
        Self {
            joint: joint_of(c, spec),
            muscle: (&c.muscle).into(),
            candidate: c.clone(),
            bulged_diameter_mm: c.bulged_diameter_mm(),
            family_stiffness_n_per_mm: c.muscle.family_stiffness_n_per_mm(),
            stiffness_n_per_mm: c.points.first().and_then(|q| q.response.stiffness_n_per_mm),
            air_normal_litres: c.largest(|q| q.air_normal_litres),
            liquid_volume_mm3: c.largest(|q| q.liquid_volume_mm3),
            strand_tension_n: c.largest(|q| q.response.strand_tension_n),
            braid_tension_n: c.largest(|q| q.response.braid_tension_n),
            max_stretch: c.largest(|q| q.response.max_stretch),
            limits: (&c.burst).into(),
            uncertainty_n: c.largest(|q| q.uncertainty_n),
        }
    }
}

impl From<&Rejected> for RejectedAnswer {
    fn from(r: &Rejected) -> Self {
        Self {
            muscle: (&r.muscle).into(),
            rejected: r.clone(),
            reason: r.check.describe(&super::plain),
            limit: r.check.limit,
        }
    }
}

/// What is said of a burst where nothing fits: that it was not checked, of strands whose strength
/// is not stated.
pub fn not_checked(outcome: &Outcome, max_pressure_mpa: f64) -> Vec<Warning> {
    let closest = outcome.rejected.first();
    closest
        .and_then(|closest| Burst::missing(&closest.muscle))
        .map(|why| Burst::unknown(why).warnings(max_pressure_mpa))
        .unwrap_or_default()
}

/// What the user should know of the best muscle: of its burst pressure, of its muscle, of its
/// operating points, and of its bundle.
pub fn warnings(c: &Candidate, bundle: Option<&Bundle>, spec: &Spec) -> Vec<Warning> {
    let mut all = crate::warnings::of_responses(&c.muscle, c.points.iter().map(|q| &q.response));
    all.extend(super::assumed::thin_wall(&c.muscle).map(Warning::from));
    Warning::put_first(&mut all, c.burst.warnings(c.highest_pressure_mpa));
    // Where no pitch is given they touch just where they are required to pull.
    let touch = bundle.and_then(|bundle| bundle.touch_contraction);
    let largest = peak(c.points.iter().map(|q| q.response.contraction));
    if let Some(touch) = touch.filter(|touch| *touch < largest - 1e-6)
        && spec.pitch_mm.is_some()
    {
        let [touch, largest] = [touch, largest].map(percent);
        all.push(Warning::from(format!(
            "neighbours of the bundle touch from a contraction of {touch} at the maximum pressure, \
             and {largest} is required: beyond that they press on each other, which is not computed"
        )));
    }
    all.extend(Warning::not_measured(&c.muscle, c.highest_pressure_mpa));
    all
}
