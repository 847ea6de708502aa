//! `--method universal`: the end deficit of [`mckibben_core::model::Universal`] from a campaign of
//! muscles of every make.
//!
//! Each point where the finite elements pull gives the δ of their pull: F∞(λ) = F_FE gives λ, then
//! δ = ½L0 (1 − λ − ε). The formula without its terms has the δ of the membrane; the terms are
//! linear in their coefficients, so that
//!
//!   Σ w² (dF/dδ · (δ − δ_membrane − Σ c · column)/F_blocked)² → min
//!
//! is one linear problem in the stated errors. dF/dδ is that of the model, at fixed ε. w = 1, and
//! 0.3 below P = 0.1 μ where muscles hardly pull. Errors are those of the finished model, which
//! solves for λ itself; and of models fitted to four fifths of the muscles on the last fifth.

mod points;

use super::{
    error::{FitError, Result},
    least_squares::Triangle,
    make::VARIED,
};
use crate::hash;
use mckibben_core::{
    extremes::{ends, peak},
    formula::{
        Provenance, UniversalErrors, UniversalFormula, UniversalRange, UniversalSummary,
        UniversalTerm,
    },
    model::{ForceModel, Universal},
    muscle::Muscle,
    progress::Progress,
    rubber::RubberLaw,
    threads,
};
pub use points::{PullPoint, Sample, Samples, shares, summary};
use std::sync::Arc;

/// The box of the campaign; it is cut to the muscles of the table.
pub const RANGE: UniversalRange = UniversalRange {
    wall_ratio: (0.02, 0.17),
    length_ratio: (5.0, f64::INFINITY),
    angle_deg: (18.0, 37.0),
    pressure_per_modulus: (0.0, 5.0),
    strand_strain: 0.06,
    contraction_of_ideal: (0.0, 1.0),
    c01_share: (0.0, 0.3),
};
/// Below this P/μ a point is not used: blocked forces vanish there, and with them the measure of
/// errors.
const LEAST_PRESSURE: f64 = 0.02;
/// Below this it counts less.
const LOW_PRESSURE: (f64, f64) = (0.1, 0.3);
/// Muscles up to this share outside of the box are used for the fit, so that its edges are inside
/// of the data.
const MARGIN: f64 = 0.12;
const FOLDS: usize = 5;

fn fold_of(muscle: u64) -> usize {
    (muscle % FOLDS as u64) as usize
}

/// Samples of many makes for one formula.
#[derive(Debug, Clone)]
pub struct UniversalRequest<'a> {
    /// Each muscle with its points.
    pub samples: &'a [Sample],
    /// Name of the formula.
    pub name: String,
    /// Name of the table, hash of the campaign's plan and its seed.
    pub from: Provenance,
}

/// Fits a formula.
///
/// # Errors
/// [`FitError`] where the table has no point that pulls inside of the box, or too few, and where
/// the caller wanted it to end.
pub fn universal(
    request: &UniversalRequest<'_>,
    progress: &dyn Progress,
) -> Result<UniversalFormula> {
    let samples = request.samples;
    let steps = FOLDS + 2;
    let step = |done: usize| {
        progress.report(done, steps);
        progress.check()
    };
    let products = products();
    check_makes(samples)?;
    let empty = UniversalFormula {
        name: request.name.clone(),
        terms: vec![],
        range: range(samples),
        errors: UniversalErrors {
            against: "forces of axisymmetric finite elements where they pull, P/mu from 0.02, as \
                shares of the muscle's blocked force at the same pressure"
                .into(),
            fit: UniversalSummary::default(),
            left_out: UniversalSummary::default(),
        },
        provenance: Provenance {
            method: format!(
                "universal (membrane ends with a fitted correction for the wall; {} terms)",
                products.len()
            ),
            data_hash: hash::numbers(numbers(samples)),
            ..request.from.clone()
        },
    };
    step(0)?;
    let folds = folds(samples, &empty, &products);
    step(1)?;
    let all = Triangle::without(&folds, None);
    let formula_of = |terms: Vec<UniversalTerm>| {
        Arc::new(UniversalFormula {
            terms,
            ..empty.clone()
        })
    };
    let formula = formula_of(solve(&products, &all)?);
    let errors = |formula: &Arc<UniversalFormula>, chosen: &(dyn Fn(u64) -> bool + Sync)| {
        let build = |s: &Sample| -> Option<Box<dyn ForceModel>> {
            chosen(s.number).then(|| {
                Box::new(Universal::between_ends(formula.clone(), &s.muscle)) as Box<dyn ForceModel>
            })
        };
        shares(samples, build, |s, p| inside(s, p, &empty.range, 0.0))
    };
    let fit = summary(&errors(&formula, &|_| true));
    FitError::refuse_absurd(fit.rms)?;
    let mut left_out = vec![];
    for fold in 0..FOLDS {
        step(2 + fold)?;
        let of_others = formula_of(solve(&products, &Triangle::without(&folds, Some(fold)))?);
        left_out.extend(errors(&of_others, &|number| fold_of(number) == fold));
    }
    let mut done = Arc::unwrap_or_clone(formula);
    done.errors.fit = fit;
    done.errors.left_out = summary(&left_out);
    done.provenance.points = all.rows;
    progress.report(steps, steps);
    Ok(done)
}

/// Whether a point lies in a box, or within a margin around it.
fn inside(s: &Sample, p: &PullPoint, range: &UniversalRange, margin: f64) -> bool {
    let m = &s.muscle;
    let within =
        |v: f64, (low, high): (f64, f64)| v >= low * (1.0 - margin) && v <= high * (1.0 + margin);
    let mu = m.tube().rubber.law.shear_modulus_mpa();
    within(m.wall_mm() / m.outer_diameter_mm(), range.wall_ratio)
        && within(m.length_mm() / m.outer_diameter_mm(), range.length_ratio)
        && within(m.braid().angle_deg, range.angle_deg)
        && p.pressure_mpa >= LEAST_PRESSURE * mu
        && p.pressure_mpa <= range.highest_pressure_mpa(m) * (1.0 + margin)
}

/// Refuses muscles of one angle, share of the wall or rubber, whose effect then is not known.
fn check_makes(samples: &[Sample]) -> Result<()> {
    let varies = |value: fn(&Muscle) -> f64| {
        let (least, most) = ends(samples.iter().map(|s| value(&s.muscle)));
        most > least * (1.0 + 1e-6)
    };
    let varied = [
        varies(|m| m.braid().angle_deg),
        varies(|m| m.wall_mm() / m.outer_diameter_mm()),
        varies(|m| m.tube().rubber.law.shear_modulus_mpa()),
    ];
    match VARIED.iter().zip(varied).find(|(_, varied)| !varied) {
        Some((quantity, _)) => Err(FitError::of_one(quantity)),
        None => Ok(()),
    }
}

/// The box, cut to what the muscles fill.
fn range(samples: &[Sample]) -> UniversalRange {
    let cut = |(low, high): (f64, f64), value: fn(&Muscle) -> f64| {
        let (least, most) = ends(samples.iter().map(|s| value(&s.muscle)));
        (low.max(least), high.min(most))
    };
    let length_ratio = cut(RANGE.length_ratio, |m| {
        m.length_mm() / m.outer_diameter_mm()
    });
    // Contractions of a table have ten digits.
    let up_to = |high: f64, value: fn(&Sample) -> f64| {
        let most = peak(samples.iter().map(value));
        if most > high * (1.0 - 1e-8) {
            high
        } else {
            most
        }
    };
    let per_modulus = |s: &Sample| s.reached.0 / s.muscle.tube().rubber.law.shear_modulus_mpa();
    let strain = |s: &Sample| s.reached.0 * UniversalRange::strain_per_mpa(&s.muscle);
    let of_ideal = |s: &Sample| s.reached.1 / s.muscle.max_ideal_contraction();
    let c01_share = |s: &Sample| UniversalRange::c01_share_of(&s.muscle);
    UniversalRange {
        pressure_per_modulus: (0.0, up_to(RANGE.pressure_per_modulus.1, per_modulus)),
        strand_strain: up_to(RANGE.strand_strain, strain).max(f64::MIN_POSITIVE),
        contraction_of_ideal: (0.0, up_to(RANGE.contraction_of_ideal.1, of_ideal)),
        c01_share: (0.0, up_to(RANGE.c01_share.1, c01_share)),
        wall_ratio: cut(RANGE.wall_ratio, |m| m.wall_mm() / m.outer_diameter_mm()),
        // A longer muscle has the same ends.
        length_ratio: (length_ratio.0, RANGE.length_ratio.1),
        angle_deg: cut(RANGE.angle_deg, |m| m.braid().angle_deg),
    }
}

/// The problem of the muscles of each fold.
fn folds(samples: &[Sample], empty: &UniversalFormula, products: &[[u8; 5]]) -> Vec<Triangle> {
    let formula = Arc::new(empty.clone());
    let rows = |s: &Sample| -> Vec<Vec<f64>> {
        let model = Universal::between_ends(formula.clone(), &s.muscle);
        let mu = s.muscle.tube().rubber.law.shear_modulus_mpa();
        let row = |p: &PullPoint| {
            let pressure = p.pressure_mpa;
            let end = model.end_point(pressure, p.contraction, p.force_n, products)?;
            // A root on another branch of the infinitely long muscle is none.
            if end.deficit_mm.abs() > 0.5 * s.muscle.outer_diameter_mm() {
                return None;
            }
            let low = pressure < LOW_PRESSURE.0 * mu;
            let weight = end.force_by_deficit_n_per_mm / p.blocked_n
                * if low { LOW_PRESSURE.1 } else { 1.0 };
            let right = end.deficit_mm - end.start_mm;
            let row: Vec<f64> = end
                .columns_mm
                .into_iter()
                .chain([right])
                .map(|c| weight * c)
                .collect();
            row.iter().all(|v| v.is_finite()).then_some(row)
        };
        s.points
            .iter()
            .filter(|p| inside(s, p, &empty.range, MARGIN))
            .filter_map(row)
            .collect()
    };
    let all: Vec<usize> = (0..FOLDS).collect();
    threads::map(&all, |fold| {
        let of_fold = samples.iter().filter(|s| fold_of(s.number) == *fold);
        Triangle::of_rows(products.len(), of_fold.flat_map(rows))
    })
}

/// Least squares by Householder's QR; coefficients are rounded to nine digits.
fn solve(products: &[[u8; 5]], problem: &Triangle) -> Result<Vec<UniversalTerm>> {
    if problem.rows < 2 * products.len() {
        return Err(FitError::empty(
            " inside of the box of the method universal, or too few of them",
        ));
    }
    let x = problem
        .solve()
        .ok_or_else(|| FitError::singular("the universal formula"))?;
    let rounded = |v: f64| format!("{v:.8e}").parse().unwrap_or(v);
    let term = |(&powers, &v): (&[u8; 5], &f64)| UniversalTerm {
        powers,
        value: rounded(v),
    };
    Ok(products.iter().zip(x.iter()).map(term).collect())
}

/// All numbers of the muscles and their points, in their order.
fn numbers(samples: &[Sample]) -> impl Iterator<Item = f64> {
    samples.iter().flat_map(|s| {
        let m = &s.muscle;
        let measures = [
            m.outer_diameter_mm(),
            m.wall_mm(),
            m.length_mm(),
            m.braid().angle_deg,
        ];
        let points = s
            .points
            .iter()
            .flat_map(|p| [p.pressure_mpa, p.contraction, p.force_n, p.blocked_n]);
        measures.into_iter().chain(points)
    })
}

/// All products of S, A, N, M and E: the 21 of degree two and less.
pub fn products() -> Vec<[u8; 5]> {
    let unit = |i: usize| [0, 1, 2, 3, 4].map(|k| u8::from(k == i));
    let pair = |i: usize, j: usize| [0, 1, 2, 3, 4].map(|k| u8::from(k == i) + u8::from(k == j));
    let pairs = (0..5).flat_map(|i| (i..5).map(move |j| pair(i, j)));
    [[0; 5]]
        .into_iter()
        .chain((0..5).map(unit))
        .chain(pairs)
        .collect()
}
