//! The library of muscles: folders of measured muscles ([`case`](super::case)) that also hold the
//! muscle that was identified from their points.
//!
//! `identified.toml` is the muscle file that one fit of `case.toml` (`library_fit`, else the first)
//! gives by finite elements, with the bench that states its ±. The tests make it again, and compare
//! the constants of both. A constant agrees where it differs by at most 10⁻⁴ of its value, or by a
//! thousandth of its ±: a constant that the points hardly determine may differ by more between
//! machines, and the pull does not change with it.

use super::{
    built_in::{IDENTIFIED, muscles, text_of, with_file},
    case::{CaseError, CaseFit, MuscleCase},
    residual::{ForceErrors, Residual, residuals},
};
use crate::{identify::Build, measured::DataPoint};
use mckibben_core::{catalogue, muscle::Muscle};
use serde::Serialize;

/// The prefix of the name of a muscle of the library in place of a muscle file: `lib:dmsp-20-300`.
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
    let name = catalogue::named("muscle of the library", &names, |name| (name, &[]), name)?;
    Ok(text_of(name, IDENTIFIED).unwrap_or_default())
}

/// The muscles of the library that are built in, each with its identified muscle.
pub fn library() -> Result<Vec<(&'static MuscleCase, &'static Muscle)>, &'static CaseError> {
    Ok(muscles()?
        .into_iter()
        .filter_map(|case| Some((case, case.identified.as_deref()?)))
        .collect())
}

impl MuscleCase {
    /// The fit that identifies the muscle of the library.
    pub fn fit_of_library(&self) -> Option<&CaseFit> {
        self.fits.get(self.library_fit)
    }
}

/// Errors of finite elements of a muscle at its measured points.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct LibraryAgreement {
    /// Points, those of other lengths of the same hose among them.
    pub points: usize,
    /// Root mean square of measured − computed, N.
    pub rms_n: f64,
    /// The same as a share of the largest blocked force of the points.
    pub rms_of_blocked: f64,
    /// Largest difference, N.
    pub largest_n: f64,
    /// Points on the bench of this muscle, of its length.
    pub bench_points: usize,
    /// Share of these within the ± of the bench; null without a bench.
    pub held: Option<f64>,
}

/// Compares a muscle with the points that the library's fit of a folder is made to.
pub fn agreement(case: &MuscleCase, muscle: &Muscle, build: &Build<'_>) -> LibraryAgreement {
    let points = case
        .fit_of_library()
        .map(|fit| case.points_of(fit))
        .unwrap_or_default();
    let digest = muscle.digest();
    let is_of_muscle = |p: &DataPoint| p.section.apply(muscle).is_ok_and(|m| m.digest() == digest);
    let (on_bench, others): (Vec<_>, Vec<_>) = points.iter().partition(|p| is_of_muscle(p));
    let [on_bench, others] = [on_bench, others].map(|points| residuals(build, muscle, points, 0.0));
    let bench = muscle.bench().filter(|_| !on_bench.is_empty());
    let covers = |r: &&Residual| r.covered() == Some(true);
    let held = bench.map(|_| on_bench.iter().filter(covers).count() as f64 / on_bench.len() as f64);
    let ForceErrors {
        points,
        rms_n,
        rms_of_blocked,
        largest_n,
        ..
    } = ForceErrors::new(on_bench.iter().chain(&others));
    LibraryAgreement {
        points,
        rms_n,
        rms_of_blocked,
        largest_n,
        bench_points: bench.map_or(0, |_| on_bench.len()),
        held,
    }
}

#[cfg(test)]
mod tests {
    use super::{super::elements, *};
    use crate::identify::{
        Identification, IdentificationRequest, Identified, Target, identify, identify_default,
    };
    use mckibben_core::{muscle::file::parse_muscle, rubber::RubberLaw};

    /// Identifies the muscle of a folder again; its muscle has the bench that states its ±.
    fn refit(case: &MuscleCase) -> (Muscle, Identification) {
        let fit = case.fit_of_library().unwrap();
        let points = case.points_of(fit);
        let request = IdentificationRequest::new(&fit.muscle, &fit.free, &points, &elements);
        let identify = if fit.free.is_empty() {
            identify_default
        } else {
            identify
        };
        let identification = identify(&request).unwrap();
        (identification.with_bench(), identification)
    }

    /// Whether a constant of the muscle that is kept is that of the refit. A factor on all moduli
    /// is compared as the modulus that it gives.
    fn agrees(refit: &Identified, identified: &Muscle, kept: &Muscle) -> bool {
        let modulus = |m: &Muscle| m.tube().rubber.law.shear_modulus_mpa();
        let value = match refit.target {
            Some(Target::Modulus) => Some(refit.value * modulus(kept) / modulus(identified)),
            target => target.and_then(|target| target.value(kept)),
        };
        let half = if refit.half_width.is_finite() {
            refit.half_width
        } else {
            0.0
        };
        value.is_some_and(|value| {
            (value - refit.value).abs() <= (1e-4 * refit.value.abs()).max(1e-3 * half)
        })
    }

    /// A regression: the kept muscles are those of this program, and nobody else has identified
    /// them. That ± covers 90 % of the points or more is by its construction.
    #[test]
    fn the_kept_muscle_is_the_one_that_its_points_give() {
        for name in ["dmsp-10-250", "dmsp-20-300", "quadsegrity"] {
            let (case, kept) = library()
                .unwrap()
                .into_iter()
                .find(|m| m.0.facts.name == name)
                .unwrap();
            let (muscle, identification) = refit(case);
            let stated = |constant: &&Identified| constant.target.is_some();
            for constant in identification.parameters.iter().filter(stated) {
                assert!(
                    agrees(constant, &identification.muscle, kept),
                    "{name}: {constant:#?}"
                );
            }
            let (ours, theirs) = (
                agreement(case, &muscle, &elements),
                agreement(case, kept, &elements),
            );
            // The fit lets the muscle push where it is slack, the agreement does not.
            let pulls = identification
                .points
                .iter()
                .map(|p| (p.residual_n, p.point.at.force_n));
            let residuals =
                pulls.map(|(residual, measured)| (residual + measured).max(0.0) - measured);
            let rms_n =
                (residuals.map(|r| r * r).sum::<f64>() / identification.points.len() as f64).sqrt();
            assert!(
                (ours.rms_n / rms_n - 1.0).abs() < 1e-6,
                "{name}: {ours:?} {rms_n}"
            );
            assert!(
                (ours.rms_n / theirs.rms_n - 1.0).abs() < 1e-4,
                "{name}: {ours:?} {theirs:?}"
            );
            assert!(theirs.held.unwrap() >= 0.9, "{name}: {theirs:?}");
        }
    }

    #[test]
    fn every_muscle_has_the_bench_of_its_source_and_terms() {
        let all = library().unwrap();
        assert_eq!(
            all.iter()
                .map(|m| m.0.facts.name.clone())
                .collect::<Vec<_>>(),
            names()
        );
        assert!(all.len() >= 5);
        for (case, muscle) in all {
            let bench = muscle.bench().unwrap();
            assert!(!case.facts.terms.is_empty() && bench.points > 5);
            assert_eq!(
                muscle.laboratory(),
                Some(case.facts.source.as_str()),
                "{}",
                case.facts.name
            );
        }
    }

    #[test]
    fn names_are_found_and_the_nearest_is_said() {
        assert_eq!(named("lib:dmsp-20-300"), Some("dmsp-20-300"));
        assert_eq!(named("LIB: x"), Some("x"));
        assert_eq!(["lib", "é", "library.toml"].map(named), [None; 3]);
        assert!(
            parse_muscle(&file("DMSP_20 300").unwrap())
                .unwrap()
                .bench()
                .is_some()
        );
        let error = file("dmsp-20-30").unwrap_err();
        assert!(error.ends_with("(did you mean dmsp-20-300?)"), "{error}");
        assert!(
            file("zzzzzzzzzz")
                .unwrap_err()
                .contains("known: dmsp-10-250, ")
        );
    }
}
