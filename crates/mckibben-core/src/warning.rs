//! What the user should know of an answer.

use crate::{
    analysis::{Allowed, BUCKLING, FailureMode, NoBurst, PROVED, SAFETY},
    model::{Response, ThickWall},
    muscle::{Muscle, Rubber},
    units::{rounded, short_numbers, tidy},
};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};
use std::fmt;

/// Strand strain at which the validated range of all models ends.
pub const VALIDATED_STRAND_STRAIN: f64 = 0.06;

/// What a warning is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WarningKind {
    /// Something about the muscle, the model or the question, whatever the answer.
    General,
    /// The pressure reaches or exceeds the muscle's burst pressure
    /// ([`burst`](crate::analysis::burst())).
    Burst,
    /// The burst pressure is not known.
    BurstNotChecked,
    /// The pressure exceeds the allowed one.
    AboveAllowed,
    /// A strand carries more than its strength here.
    StrandsBreak,
    /// A strand carries more than the allowed share of its strength.
    StrandTension,
    /// The strands stretch beyond the validated range of the models.
    StrandStrain,
    /// A slack muscle at a contraction that its braid does not reach.
    BeyondBraid,
    /// The muscle pulls less when its pressure rises.
    FallsWithPressure,
    /// The muscle pushes more than a column of its wall bears.
    Buckles,
    /// The rubber is stretched further than its law has data.
    RubberStretch,
    /// What is sought has no ±.
    Flat,
    /// The muscle or its pressure lies outside of the measured ones, on which the ± is founded.
    NotMeasured,
    /// The points of a bench hardly belong to its muscle.
    BenchMismatch,
    /// The answer lies outside of the range of its model.
    Extrapolated,
}

/// What the user should know of an answer.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "AnswerWarning")]
pub struct Warning {
    /// What it is about.
    pub kind: WarningKind,
    /// How grave it is among those of its kind.
    #[serde(skip)]
    gravity: f64,
    /// The sentence.
    message: String,
}

impl Warning {
    pub(crate) fn new(kind: WarningKind, gravity: f64, message: String) -> Self {
        Self {
            kind,
            gravity,
            message,
        }
    }

    /// A sentence of a kind, with the numbers that it states in their shortest form.
    pub fn of(kind: WarningKind, sentence: impl Into<String>) -> Self {
        let sentence = sentence.into();
        Self::new(kind, 0.0, short_numbers(&sentence).into_owned())
    }

    /// Whether it holds for the muscle at each of its points.
    pub fn is_of_muscle(&self) -> bool {
        use WarningKind::{BurstNotChecked, NotMeasured};
        matches!(self.kind, BurstNotChecked | NotMeasured)
    }

    /// Whether it is about the burst of the muscle, and so comes first.
    pub fn is_of_burst(&self) -> bool {
        use WarningKind::{AboveAllowed, Burst, BurstNotChecked};
        matches!(self.kind, Burst | BurstNotChecked | AboveAllowed)
    }

    /// Of a pressure in MPa at which a muscle fails that bursts at `burst_mpa`.
    pub fn of_burst(pressure_mpa: f64, burst_mpa: f64, by: FailureMode) -> Self {
        Self::new(
            WarningKind::Burst,
            pressure_mpa / burst_mpa,
            format!(
                "BURST: {pressure_mpa:.3}\u{a0}MPa exceeds the burst pressure of this muscle, \
             {burst_mpa:.3}\u{a0}MPa, at which {by}"
            ),
        )
    }

    /// Of a pressure in MPa above the allowed one, which keeps its distance from a failure; from
    /// none where the fittings are rated for it.
    pub fn above_allowed(pressure_mpa: f64, most: Allowed) -> Self {
        let allowed = rounded(most.mpa, 4, f64::floor);
        let factor = if most.factor == 1.0 {
            String::new()
        } else {
            format!(" (safety factor {})", tidy(most.factor, 4))
        };
        let reason = format!(
            "the allowed pressure is {allowed}\u{a0}MPa, since {} at {:.3}\u{a0}MPa{factor}",
            most.by,
            most.failure_mpa()
        );
        Self::new(
            WarningKind::AboveAllowed,
            pressure_mpa / most.mpa,
            format!("ABOVE THE ALLOWED PRESSURE: {pressure_mpa:.3}\u{a0}MPa; {reason}"),
        )
    }

    /// That a burst pressure is not known.
    pub fn burst_not_checked(why: NoBurst) -> Self {
        Self::new(
            WarningKind::BurstNotChecked,
            0.0,
            format!("BURST NOT CHECKED: {why}"),
        )
    }

    /// Of a slack muscle at a contraction that its braid does not reach.
    pub(crate) fn beyond_braid(contraction: f64, largest: f64) -> Self {
        Self::new(
            WarningKind::BeyondBraid,
            contraction,
            format!(
                "a contraction of {:.1} % is beyond the end of this braid: it contracts by {:.1} % at \
             most (its angle is 54.7° there)",
                100.0 * contraction,
                100.0 * largest
            ),
        )
    }

    /// Of a pull that hardly changes with what is sought.
    pub(crate) fn flat(sought: &str, half_n: f64) -> Self {
        Self::new(
            WarningKind::Flat,
            half_n,
            format!(
                "the {sought} has no ±: here the pull changes so little with it that the ± of the \
             pull, {half_n:.1}\u{a0}N, does not bound it"
            ),
        )
    }

    /// Of a stretch beyond the data that a rubber's constants were fitted to.
    pub fn of_stretch(rubber: &Rubber, stretch: f64) -> Option<Self> {
        let limit = rubber.fitted_to_stretch.filter(|limit| stretch > *limit)?;
        let rubber = rubber.name.as_deref().unwrap_or("this rubber");
        Some(Self::new(
            WarningKind::RubberStretch,
            stretch / limit,
            format!(
                "the rubber is stretched to {stretch:.2}; the constants of {rubber} were fitted up to \
             {limit:.2}"
            ),
        ))
    }

    /// Of each kind the gravest, of sentences each once, in the order in which they came.
    pub fn gravest<'a>(all: impl IntoIterator<Item = &'a Warning>) -> Vec<Warning> {
        let mut out: Vec<Warning> = vec![];
        for warning in all {
            let same = |w: &&mut Warning| match warning.kind {
                WarningKind::General | WarningKind::BurstNotChecked => *w == warning,
                kind => w.kind == kind,
            };
            match out.iter_mut().find(same) {
                None => out.push(warning.clone()),
                Some(known) if warning.gravity > known.gravity => *known = warning.clone(),
                Some(_) => {}
            }
        }
        out
    }

    /// Puts warnings before all others, and takes out what they include.
    pub fn put_first(all: &mut Vec<Self>, first: impl IntoIterator<Item = Self>) {
        let first = Self::gravest(&first.into_iter().collect::<Vec<_>>());
        for warning in &first {
            let included = match warning.kind {
                WarningKind::Burst => WarningKind::StrandsBreak,
                WarningKind::AboveAllowed => WarningKind::StrandTension,
                _ => continue,
            };
            all.retain(|w| w.kind != included);
        }
        all.splice(..0, first);
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl From<String> for Warning {
    fn from(sentence: String) -> Self {
        Self::of(WarningKind::General, sentence)
    }
}

/// As data an error is its sentence.
pub fn sentence<E: fmt::Display, S: Serializer>(
    error: &Option<E>,
    out: S,
) -> Result<S::Ok, S::Error> {
    error
        .as_ref()
        .map(|error| short_numbers(&error.to_string()).into_owned())
        .serialize(out)
}

/// The strength of one strand in N, where it is known.
pub fn strand_strength_n(muscle: &Muscle) -> Option<f64> {
    muscle.braid().strands?.strength_n
}

/// Tension and strength of one strand in N, where the strands break: such a muscle does not pull.
pub fn overloaded(muscle: &Muscle, response: &Response) -> Option<(f64, f64)> {
    response
        .strand_tension_n
        .zip(strand_strength_n(muscle))
        .filter(|(tension, strength)| tension > strength)
}

/// Tension over strength of a strand, and the share that is allowed: as for the pressure at which
/// strands break.
fn strand_load(muscle: &Muscle, response: &Response) -> Option<(f64, f64)> {
    let share = response.strand_tension_n? / strand_strength_n(muscle)?;
    let least = 1.0 / muscle.braid().strands?.load_factor();
    let most = if least < 1.0 { least / PROVED } else { 1.0 };
    Some((share, most.min(1.0 / SAFETY)))
}

/// What the user should know of what a model says of a muscle at a point.
pub fn of_response(muscle: &Muscle, response: &Response) -> Vec<Warning> {
    use WarningKind::{Buckles, FallsWithPressure, StrandStrain, StrandTension, StrandsBreak};
    let mut out = vec![];
    let mut warn = |kind, gravity, sentence| out.push(Warning::new(kind, gravity, sentence));
    if let Some((tension_n, strength_n)) = overloaded(muscle, response) {
        let sentence = format!(
            "the strands break: at {:.3}\u{a0}MPa one of them carries {tension_n:.1}\u{a0}N, and \
             its strength is {strength_n}\u{a0}N; what is broken does not pull",
            response.pressure_mpa
        );
        warn(StrandsBreak, tension_n / strength_n, sentence);
    } else if let Some((share, most)) = strand_load(muscle, response)
        && share > most
    {
        let sentence = format!(
            "the strands carry {:.0} % of their strength: {:.0} % is allowed; lower the load or \
             the pressure",
            100.0 * share,
            100.0 * most
        );
        warn(StrandTension, share, sentence);
    }
    if let Some(strain) = response
        .braid_tension_n
        .and_then(|t| muscle.strand_strain(t))
        && strain > VALIDATED_STRAND_STRAIN
    {
        warn(
            StrandStrain,
            strain,
            format!(
                "the strands stretch by {:.1} %: the validated range ends at {:.0} %",
                100.0 * strain,
                100.0 * VALIDATED_STRAND_STRAIN
            ),
        );
    }
    if let Some(slope) = response.force_per_pressure_mm2
        && slope < 0.0
        && response.force_n > 0.0
        && response.contraction >= 0.0
        && !muscle.is_extensile()
    {
        warn(
            FallsWithPressure,
            -slope,
            format!(
                "the pull falls when the pressure rises ({slope:.0}\u{a0}N/MPa): here the muscle \
             widens instead of pulling"
            ),
        );
    }
    if let Some(bears_n) = buckling_load_n(muscle, response)
        && response.force_n < -bears_n / BUCKLING
    {
        let push_n = -response.force_n;
        let what = if push_n > bears_n {
            "buckles"
        } else {
            "may buckle"
        };
        warn(
            Buckles,
            push_n / bears_n,
            format!(
                "the muscle {what} between two joints: it pushes with {push_n:.1}\u{a0}N, its wall alone \
             bears {bears_n:.1}\u{a0}N, and {:.1}\u{a0}N are allowed; guide it in a tube, or make \
             it shorter",
                bears_n / BUCKLING
            ),
        );
    }
    let rubber = &muscle.tube().rubber;
    out.extend(
        response
            .rubber_stretch()
            .and_then(|stretch| Warning::of_stretch(rubber, stretch)),
    );
    out
}

/// The push in N at which a muscle that extends buckles between two joints, by its wall alone;
/// `None` of a muscle that contracts, and where the infinitely long muscle has no answer.
pub fn buckling_load_n(muscle: &Muscle, response: &Response) -> Option<f64> {
    muscle
        .is_extensile()
        .then(|| ThickWall::between_ends(muscle))?
        .buckling_n(response.pressure_mpa, response.contraction)
        .ok()
        .filter(|n| n.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        model::{ForceModel, Workspace},
        muscle::{Braid, BraidStiffness, Strands},
        rubber::RubberLaw,
    };

    #[test]
    fn of_each_kind_the_gravest_is_kept_and_sentences_once() {
        let said = |s: &str| Warning::from(s.to_owned());
        let strain =
            |strain: f64| Warning::new(WarningKind::StrandStrain, strain, strain.to_string());
        let all = [
            said("a"),
            strain(0.07),
            said("b"),
            strain(0.1),
            said("a"),
            strain(0.08),
        ];
        assert_eq!(Warning::gravest(&all), [said("a"), strain(0.1), said("b")]);
    }

    /// By hand: a quarter of the strength is allowed, and of strands whose number and strength are
    /// known within factors of 2 and 3 a share exp(−√(ln²2 + ln²3))/1.5 = 0.182.
    #[test]
    fn a_tension_above_the_allowed_one_is_told_of() {
        let loaded = |share: f64, factors: (f64, f64)| {
            let strands = Strands {
                count_factor: factors.0,
                strength_factor: factors.1,
                ..Strands::new(64, None, Some(50.0))
            };
            let braid = Braid {
                strands: Some(strands),
                ..Braid::paper()
            };
            let muscle = Muscle::prototype().with_braid(braid).unwrap();
            let response = Response {
                strand_tension_n: Some(50.0 * share),
                ..Response::default()
            };
            let warnings = of_response(&muscle, &response);
            warnings.iter().map(|w| w.kind).collect::<Vec<_>>()
        };
        let stated = (1.0, 1.0);
        assert_eq!(loaded(0.97, stated), [WarningKind::StrandTension]);
        assert_eq!(loaded(1.01, stated), [WarningKind::StrandsBreak]);
        assert_eq!(loaded(0.249, stated), []);
        assert_eq!(loaded(0.183, (2.0, 3.0)), [WarningKind::StrandTension]);
        assert_eq!(loaded(0.181, (2.0, 3.0)), []);
    }

    #[test]
    fn soft_and_weak_strands_are_told_of() {
        let strands = Strands::new(64, Some((0.05, 60.0)), Some(0.4));
        let braid = Braid {
            stiffness: BraidStiffness::OfStrands,
            strands: Some(strands),
            ..Braid::paper()
        };
        let muscle = Muscle::prototype().with_braid(braid).unwrap();
        let model = ThickWall::between_ends(&muscle);
        let response = model.response(&mut Workspace::new(), 0.05, 0.0).unwrap();
        let warnings = of_response(&muscle, &response);
        assert!(warnings[0].message.contains("0.4\u{a0}N"), "{warnings:?}");
        let kinds: Vec<WarningKind> = warnings.iter().map(|w| w.kind).collect();
        assert_eq!(
            kinds[..2],
            [WarningKind::StrandsBreak, WarningKind::StrandStrain]
        );
        // And nothing of a muscle that is well.
        let model = ThickWall::between_ends(&Muscle::prototype());
        let response = model.response(&mut Workspace::new(), 0.2, 0.1).unwrap();
        assert_eq!(of_response(model.muscle(), &response), []);
    }

    /// A push is warned of from a fourth of Euler's load on, as a pressure from a fourth of the
    /// burst pressure on: at rest without pressure π² E I/L² with E I = 3 μ π (Ro⁴ − Ri⁴)/4.
    #[test]
    fn closed_form_a_push_has_the_factor_of_every_failure() {
        let prototype = Muscle::prototype();
        let braid = Braid {
            angle_deg: 60.0,
            ..prototype.braid().clone()
        };
        let muscle = prototype.with_braid(braid).unwrap();
        let (tube, mu_mpa) = (muscle.tube(), muscle.tube().rubber.law.shear_modulus_mpa());
        let (ro, ri) = (
            tube.outer_radius_mm(),
            tube.outer_radius_mm() - tube.wall_mm,
        );
        let length_mm = muscle.length_mm();
        let load_n = std::f64::consts::PI.powi(3) * 3.0 * mu_mpa * (ro.powi(4) - ri.powi(4))
            / 4.0
            / (length_mm * length_mm);
        for (share, word) in [
            (0.49, None),
            (0.51, Some("may")),
            (1.01, Some("muscle buckles")),
        ] {
            let response = Response {
                force_n: -share * load_n,
                ..Response::default()
            };
            let said = of_response(&muscle, &response);
            let said = said.iter().find(|w| w.kind == WarningKind::Buckles);
            assert_eq!(said.is_some(), word.is_some(), "{share} {said:?}");
            if let Some((said, word)) = said.zip(word) {
                assert!(said.to_string().contains(word), "{said}");
            }
        }
    }
}
