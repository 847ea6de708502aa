//! Muscles that were measured, and the library of those that were identified from their points.
//!
//! `identified.toml` of a folder is the muscle file that one fit of its `case.toml` (`library_fit`,
//! else the first) gives by finite elements, with the bench that states its ±. The study
//! `validation` makes it again, and its tests compare the constants of both.

mod folder;
#[cfg(test)]
mod measured_range;
pub mod residual;
pub mod write;

use crate::{identify::Build, measured::DataPoint};
pub use folder::{Facts, MeasuredMuscle, measured};
use folder::{IDENTIFIED, text_of, with_file};
use mckibben_core::{catalogue, muscle::Muscle};
use residual::{ForceErrors, Residual, residuals};
use serde::Serialize;

/// The prefix of the name of a muscle of the library in place of a muscle file: `lib:dmsp-20-300`.
pub const PREFIX: &str = "lib:";

/// The names of the muscles of the library.
pub fn names() -> Vec<String> {
    with_file(IDENTIFIED)
}

/// The name of a muscle of the library, where a word that may be the path of a file is one.
pub fn named(word: &str) -> Option<&str> {
    let (head, name) = word.trim().split_at_checked(PREFIX.len())?;
    head.eq_ignore_ascii_case(PREFIX).then_some(name.trim())
}

/// The muscle file of a muscle of the library; else that there is none of this name.
pub fn file(name: &str) -> Result<&'static str, String> {
    let names = names();
    let name = catalogue::named("muscle of the library", &names, |name| (name, &[]), name)?;
    Ok(text_of(name, IDENTIFIED).unwrap_or_default())
}

/// The muscles of the library, each with its identified muscle.
pub fn library() -> Vec<(&'static MeasuredMuscle, &'static Muscle)> {
    measured()
        .iter()
        .filter_map(|of| Some((of, of.identified.as_ref()?)))
        .collect()
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

/// Compares a muscle with the points that the fit of a measured one was made to.
pub fn agreement(of: &MeasuredMuscle, muscle: &Muscle, build: &Build<'_>) -> LibraryAgreement {
    let points = of.points_of_fit();
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
    use super::*;
    use mckibben_core::muscle::file::parse_muscle;

    #[test]
    fn every_muscle_has_the_bench_of_its_source_and_terms() {
        let all = library();
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
            parse_muscle(file("DMSP_20 300").unwrap())
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
