//! What is unusual, unknown or uncertain of a muscle, and what to measure first.

use super::{Characteristics, CheckAnswer};
use crate::{Problem, Units, number, percent};
use mckibben::analysis::{Burst, FailurePressure};
use mckibben::warning::{Warning, is_of_burst};
use mckibben::{muscle::Muscle, uncertainty::UncertaintyParts};
use mckibben_fit::validation::case::{MuscleCase, muscles};
use schemars::JsonSchema;
use serde::Serialize;

/// Something that was found.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MuscleFinding {
    /// Its kind.
    pub kind: FindingKind,
    /// In a sentence.
    pub text: String,
    /// 95 % half-width of the blocked force that a measurement leaves at least, N: the ± without the part that it replaces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub left_n: Option<f64>,
}

/// A kind of finding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FindingKind {
    /// The muscle is unusual, or is asked for more than it bears.
    Implausible,
    /// A number that is not stated.
    Unknown,
    /// A number outside of the muscles that the models were compared with.
    Outside,
    /// A measurement that reduces the ±.
    Measure,
}

/// Ends take a large part of a muscle that is shorter than so many diameters.
const SHORT: f64 = 5.0;
/// Walls over bores of tubes that people cast (the catalogue of parts).
const WALLS: (f64, f64) = (0.04, 1.0 / 3.0);
/// A ± above this share of the blocked force is more than a design can do with.
const WIDE: f64 = 0.3;
/// A muscle that contracts less than this even without wall and load hardly moves.
const LITTLE: f64 = 0.1;

/// What was found of a muscle beyond its warnings.
pub(super) fn of(
    muscle: &Muscle,
    burst: &Burst,
    values: &Characteristics,
    parts: Option<UncertaintyParts>,
) -> Result<Vec<MuscleFinding>, Problem> {
    let mut findings = implausible(muscle, values);
    findings.extend(unknown(burst));
    let outside = outside(muscle, values.pressure_mpa)?;
    findings.extend(outside.into_iter().map(|text| MuscleFinding::new(FindingKind::Outside, text)));
    findings.extend(parts.iter().flat_map(|parts| measure(parts, values)));
    Ok(findings)
}

impl MuscleFinding {
    fn new(kind: FindingKind, text: impl Into<String>) -> Self {
        Self { kind, text: text.into(), left_n: None }
    }
}

fn implausible(muscle: &Muscle, values: &Characteristics) -> Vec<MuscleFinding> {
    let (pull, half) = (values.blocked_force_n, values.blocked_force_uncertainty_n);
    let (slender, wall) =
        (muscle.length_mm() / muscle.tube().outer_diameter_mm, muscle.wall_mm() / muscle.inner_diameter_mm());
    let mut found: Vec<String> = vec![];
    if pull <= 0.0 {
        found.push("the muscle does not pull at this pressure and its rest length: the pressure is too low for its wall, or its angle is above 54.7°".into());
    }
    if muscle.max_ideal_contraction() < LITTLE {
        let (angle, most) = (number(muscle.braid().angle_deg, 4), percent(muscle.max_ideal_contraction()));
        found.push(format!(
            "with an angle of {angle}° even the ideal muscle contracts by no more than {most}"
        ));
    }
    if slender < SHORT {
        found.push(format!(
            "the length is {} outer diameters; below {SHORT} the ends take a large part of stroke and pull",
            number(slender, 3)
        ));
    }
    if wall < WALLS.0 || wall > WALLS.1 {
        let (low, high) = (percent(WALLS.0), percent(WALLS.1));
        found.push(format!(
            "the wall is {} of the bore; tubes on sale and cast ones have {low} to {high}",
            percent(wall)
        ));
    }
    if let Some(share) = half.map(|half| half / pull).filter(|share| pull > 0.0 && *share > WIDE) {
        found.push(format!(
            "the ± is {} of the blocked force: measure before you rely on the pull",
            percent((100.0 * share).round() / 100.0)
        ));
    }
    found.into_iter().map(|text| MuscleFinding::new(FindingKind::Implausible, text)).collect()
}

/// Failures whose pressure cannot be computed, with what is missing.
fn unknown(burst: &Burst) -> Vec<MuscleFinding> {
    let mut found: Vec<String> = vec![];
    for (mode, pressure) in burst.modes() {
        if let FailurePressure::Unknown(why) = pressure {
            found.push(format!("the pressure at which {mode}: {why}"));
        }
    }
    if burst.rated_mpa.is_none() {
        found.push("the pressure for which plugs and fittings are rated; give `rated_pressure` in [terminals] of the muscle file".into());
    }
    found.into_iter().map(|text| MuscleFinding::new(FindingKind::Unknown, text)).collect()
}

/// A size: its name, its unit, and how it is taken of a muscle.
type Sized<'a> = (&'static str, &'static str, &'a dyn Fn(&Muscle) -> f64);

/// The same as one warning, of a muscle that is chosen or built.
pub(crate) fn not_measured(muscle: &Muscle, pressure_mpa: f64) -> Result<Option<Warning>, Problem> {
    let outside = outside(muscle, pressure_mpa)?.join("; ");
    let said = format!("outside of the muscles that were measured, on which the ± is founded: {outside}");
    Ok((!outside.is_empty()).then(|| Warning::from(said)))
}

/// Where the muscle lies outside of the measured ones, on which the ± is founded.
fn outside(muscle: &Muscle, pressure_mpa: f64) -> Result<Vec<String>, Problem> {
    // The measured muscles are no part of the reduced engine.
    if !cfg!(feature = "whole") {
        return Ok(vec![]);
    }
    let cases = muscles().map_err(Problem::from)?;
    let measured: Vec<Muscle> = cases.iter().flat_map(|case| built(case)).collect();
    let among = |of: &dyn Fn(&Muscle) -> f64| {
        let all = measured.iter().map(of);
        all.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), v| (low.min(v), high.max(v)))
    };
    let highest_mpa =
        cases.iter().flat_map(|case| &case.points).map(|p| p.at.pressure_mpa).fold(0.0, f64::max);
    let measures: [Sized<'_>; 4] = [
        ("the outer diameter", " mm", &|m| m.tube().outer_diameter_mm),
        ("the wall over the outer diameter", "", &|m| m.wall_mm() / m.tube().outer_diameter_mm),
        ("the length over the outer diameter", "", &|m| m.length_mm() / m.tube().outer_diameter_mm),
        ("the braid angle", "°", &|m| m.braid().angle_deg),
    ];
    let mut found = vec![];
    for (name, unit, of) in measures {
        let (own, (low, high)) = (of(muscle), among(of));
        // A last digit is no difference.
        if own < low * (1.0 - 1e-9) || own > high * (1.0 + 1e-9) {
            let shown = [own, low, high].map(|v| number(v, 3));
            found
                .push(format!("{name} is {}{unit} (measured: {} to {}{unit})", shown[0], shown[1], shown[2]));
        }
    }
    if pressure_mpa > highest_mpa {
        let (own, most) = (number(pressure_mpa, 3), number(highest_mpa, 3));
        found.push(format!("the pressure is {own} MPa (measured: up to {most} MPa)"));
    }
    Ok(found)
}

/// The muscles of a case, one for each size that its points state.
fn built(case: &MuscleCase) -> Vec<Muscle> {
    let Some(fit) = case.fits.first() else { return vec![] };
    let mut all: Vec<Muscle> = vec![];
    for point in &case.points {
        if let Ok(muscle) = point.section.apply(&fit.muscle)
            && !all.contains(&muscle)
        {
            all.push(muscle);
        }
    }
    all
}

/// Parts of a ± that a measurement replaces: the name of the part, and what to do.
const MEASURABLE: [(&str, &str); 5] = [
    (
        "friction unknown",
        "pulls while the muscle shortens and while it lengthens (`identify` finds the friction, and the rubber beside it)",
    ),
    ("rubber", "a tension test of the rubber (`rubber`), or pulls at several pressures (`identify`)"),
    (
        "stiffness of the braid",
        "number, diameter and modulus of the strands, or the blocked force at a high pressure (`identify`)",
    ),
    ("another specimen", "the pull of your own muscle at some pressures (`identify`)"),
    ("formula", "nothing: the model `fe` does without this part"),
];

fn measure(parts: &UncertaintyParts, values: &Characteristics) -> Vec<MuscleFinding> {
    let total = parts.total();
    let mut named: Vec<(&str, f64)> = parts.named().collect();
    named.sort_by(|a, b| b.1.total_cmp(&a.1));
    let each = named.into_iter().filter_map(|(name, part)| {
        let (_, how) = MEASURABLE.iter().find(|known| known.0 == name)?;
        let left = (total * total - part * part).max(0.0).sqrt();
        // A part that changes nothing that is shown.
        (left < 0.98 * total).then(|| MuscleFinding {
            kind: FindingKind::Measure,
            text: format!("{name}: {how}"),
            left_n: Some(left),
        })
    });
    let words = &values.uncertainty_words;
    let whole = words.bench_uncertainty_n.map(|left| MuscleFinding {
        kind: FindingKind::Measure,
        text: words.bench.clone().unwrap_or_default(),
        left_n: Some(left),
    });
    whole.into_iter().chain(each).collect()
}

impl CheckAnswer {
    /// The findings of a kind, in sentences with units; warnings are of the implausible, but for those of the burst pressure.
    pub fn said(&self, kind: FindingKind, u: &Units) -> Vec<String> {
        let words = self.characteristics.as_ref().map(|c| &c.uncertainty_words);
        let warnings = self.warnings.iter().filter(|w| kind == FindingKind::Implausible && !is_of_burst(w));
        let of_kind = self.findings.iter().filter(|finding| finding.kind == kind);
        let sentences = of_kind.map(|finding| match finding.left_n {
            Some(left) if Some(left) == words.and_then(|w| w.bench_uncertainty_n) => {
                words.and_then(|w| w.bench_in(u)).unwrap_or_default()
            }
            Some(left) => {
                format!(
                    "{}; no less than ± {} {} would be left",
                    finding.text,
                    u.force.half_width(left),
                    u.force.name
                )
            }
            None => finding.text.clone(),
        });
        warnings.cloned().chain(sentences).collect()
    }
}
