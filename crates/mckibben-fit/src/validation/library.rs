//! The library of muscles: folders of measured muscles ([`case`](super::case)) that also hold the muscle that was identified from their points.
//!
//! `identified.toml` is the muscle file that one fit of `case.toml` (`library_fit`, else the first) gives by finite elements, with the bench
//! that states its ±. The tests make it again, and compare the constants of both. A constant agrees where it differs by at most 10⁻⁴ of its value, or
//! by a thousandth of its ±: a constant that the points hardly determine may differ by more between machines, and the pull does not change with it.

use super::case::{CaseError, CaseFit, IDENTIFIED, MuscleCase, muscles, text_of, with_file};
use super::held_out::points_of;
use super::residual::{Left, Residual, residuals};
use crate::identify::Build;
use crate::measured::DataPoint;
use mckibben::catalogue;
use mckibben::muscle::Muscle;
use serde::Serialize;

/// What stands before the name of a muscle of the library, where a muscle file may stand: `lib:dmsp-20-300`.
pub const PREFIX: &str = "lib:";

/// The names of the muscles that are built in.
pub fn names() -> Vec<String> {
    with_file(IDENTIFIED)
}

/// The name of a muscle of the library, where a word that may be the path of a file is one.
pub fn named(word: &str) -> Option<&str> {
    let (head, name) = word.trim().split_at_checked(PREFIX.len())?;
    head.eq_ignore_ascii_case(PREFIX).then_some(name.trim())
}

/// The muscle file of a muscle that is built in; else that there is none of this name.
pub fn file(name: &str) -> Result<String, String> {
    let names = names();
    let found = catalogue::named("muscle of the library", &names, |name| (name, &[]), name)?;
    Ok(text_of(found, IDENTIFIED).unwrap_or_default())
}

/// The muscles of the library that are built in, each with its identified muscle.
pub fn library() -> Result<Vec<(&'static MuscleCase, &'static Muscle)>, &'static CaseError> {
    Ok(muscles()?.into_iter().filter_map(|case| Some((case, case.identified.as_deref()?))).collect())
}

impl MuscleCase {
    /// The fit that identifies the muscle of the library.
    pub fn fit_of_library(&self) -> Option<&CaseFit> {
        self.fits.get(self.library_fit)
    }
}

/// What finite elements of a muscle leave of its measured points.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "LibraryAgreement")]
pub struct Agreement {
    /// Points, those of other lengths of the same hose among them.
    pub points: usize,
    /// Root mean square of measured − computed, N.
    pub rms_n: f64,
    /// The same over the largest blocked force of the points.
    pub rms_of_blocked: f64,
    /// Largest difference, N.
    pub largest_n: f64,
    /// Points on the bench of this muscle, of its own length.
    pub bench_points: usize,
    /// Share of these within the ± of the bench; null without a bench.
    pub held: Option<f64>,
}

/// Holds a muscle against the points that the library's fit of a folder is made to.
pub fn agreement(case: &MuscleCase, muscle: &Muscle, build: &Build<'_>) -> Agreement {
    let points = case.fit_of_library().map(|fit| points_of(case, fit)).unwrap_or_default();
    let digest = muscle.digest();
    let is_own = |p: &&DataPoint| p.section.apply(muscle).is_ok_and(|m| m.digest() == digest);
    let (own, others): (Vec<&DataPoint>, Vec<&DataPoint>) = points.iter().partition(is_own);
    let own = residuals(build, muscle, &own, 0.0);
    let others = residuals(build, muscle, &others, 0.0);
    let bench = muscle.bench().filter(|_| !own.is_empty());
    let held = bench.map(|bench| {
        let holds = |r: &&Residual| r.left_n.abs() <= bench.half_width_n(r.pressure_mpa, r.contraction);
        own.iter().filter(holds).count() as f64 / own.len() as f64
    });
    let Left { points, rms_n, rms_of_blocked, largest_n, .. } = Left::of(own.iter().chain(&others));
    let bench_points = bench.map_or(0, |_| own.len());
    Agreement { points, rms_n, rms_of_blocked, largest_n, bench_points, held }
}

#[cfg(test)]
mod tests {
    use super::super::elements;
    use super::*;
    use crate::identify::{Identification, Identified, Request, Target, identify, own_value};
    use mckibben::muscle::file::parse_muscle;
    use mckibben::rubber::RubberLaw;

    /// Identifies the muscle of a folder again; its muscle has the bench that states its ±.
    fn refit(case: &MuscleCase) -> (Muscle, Identification) {
        let fit = case.fit_of_library().unwrap();
        let points = points_of(case, fit);
        let request = Request::new(&fit.muscle, &fit.free, &points, &elements);
        let found = identify(&request).unwrap();
        (found.with_bench(), found)
    }

    /// Whether a constant of the muscle that is kept is that of the refit. A factor on all moduli is compared as the modulus that it gives.
    fn agrees(refit: &Identified, (found, kept): (&Muscle, &Muscle)) -> bool {
        let modulus = |m: &Muscle| m.tube().rubber.law.shear_modulus_mpa();
        let own = match refit.target {
            Target::Modulus => Some(refit.value * modulus(kept) / modulus(found)),
            target => own_value(kept, target),
        };
        let half = if refit.half_width.is_finite() { refit.half_width } else { 0.0 };
        own.is_some_and(|own| (own - refit.value).abs() <= (1e-4 * refit.value.abs()).max(1e-3 * half))
    }

    /// A regression: the kept muscles are those of this program, and nobody else has identified them. That ± holds 90 % of the points or more
    /// is by its construction.
    #[test]
    fn the_kept_muscle_is_the_one_that_its_points_give() {
        for name in ["dmsp-10-250", "dmsp-20-300", "quadsegrity"] {
            let (case, kept) = library().unwrap().into_iter().find(|m| m.0.facts.name == name).unwrap();
            let (muscle, found) = refit(case);
            for constant in &found.parameters {
                assert!(agrees(constant, (&found.muscle, kept)), "{name}: {constant:#?}");
            }
            let (ours, theirs) = (agreement(case, &muscle, &elements), agreement(case, kept, &elements));
            // The fit lets the muscle push where it is slack, the agreement does not.
            let left = found.points.iter().map(|p| {
                let measured_n = p.point.at.force_n;
                (p.residual_n + measured_n).max(0.0) - measured_n
            });
            let rms_n = (left.map(|r| r * r).sum::<f64>() / found.points.len() as f64).sqrt();
            assert!((ours.rms_n / rms_n - 1.0).abs() < 1e-6, "{name}: {ours:?} {rms_n}");
            assert!((ours.rms_n / theirs.rms_n - 1.0).abs() < 1e-4, "{name}: {ours:?} {theirs:?}");
            assert!(theirs.held.unwrap() >= 0.9, "{name}: {theirs:?}");
        }
    }

    #[test]
    fn every_muscle_has_a_bench_that_is_its_own_and_terms() {
        let all = library().unwrap();
        assert_eq!(all.iter().map(|m| m.0.facts.name.clone()).collect::<Vec<_>>(), names());
        assert!(all.len() >= 5);
        for (case, muscle) in all {
            let bench = muscle.bench().unwrap();
            assert!(!case.facts.terms.is_empty() && bench.points > 5);
            assert_eq!(muscle.laboratory(), Some(case.facts.source.as_str()), "{}", case.facts.name);
        }
    }

    #[test]
    fn names_are_found_and_the_nearest_is_said() {
        assert_eq!(named("lib:dmsp-20-300"), Some("dmsp-20-300"));
        assert_eq!(
            (named("LIB: x"), named("lib"), named("é"), named("library.toml")),
            (Some("x"), None, None, None)
        );
        assert!(parse_muscle(&file("DMSP_20 300").unwrap()).unwrap().bench().is_some());
        let error = file("dmsp-20-30").unwrap_err();
        assert!(error.ends_with("(did you mean dmsp-20-300?)"), "{error}");
        assert!(file("zzzzzzzzzz").unwrap_err().contains("known: dmsp-10-250, "));
    }
}
