//! `--method universal`: the end deficit of [`mckibben_core::model::Universal`] from a campaign of
//! muscles of every make.
//!
//! Each point where the finite elements pull gives the δ of their pull: F∞(λ) = F_FE gives λ, then
//! δ = ½L0 (1 − λ − ε). The form without its terms has a δ (that of the membrane, or none); the
//! terms are linear in their coefficients, so that
//!
//!   Σ w² (dF/dδ · (δ − δ_form − Σ c · column)/F_blocked)² → min
//!
//! is one linear problem in the stated errors. dF/dδ is that of the model, at fixed ε. w = 1, and
//! 0.3 below P = 0.1 μ where muscles hardly pull. Errors are those of the finished model, which
//! solves for λ itself; and of models fitted to four fifths of the muscles on the last fifth.

mod held_out;
mod points;

use super::{
    error::{FitError, Result},
    least_squares::least_squares,
};
use crate::hash;
pub use held_out::{HeldOutRow, held_out, held_out_samples, rubber_laws};
use mckibben_core::{
    extremes::ends,
    formula::{
        Deficit, Form, Provenance, UniversalErrors, UniversalFormula, UniversalRange,
        UniversalSummary, UniversalTerm,
    },
    model::{EndPoint, ForceModel, Universal},
    progress::Progress,
    rubber::RubberLaw,
    threads,
};
use nalgebra::DMatrix;
pub use points::{PullPoint, Sample, samples, shares, summary};
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
const FOLDS: u64 = 5;

#[derive(Debug, Clone)]
pub struct UniversalRequest<'a> {
    pub samples: &'a [Sample],
    pub form: Form,
    /// Name of the formula.
    pub name: String,
    /// Name of the table, hash of the campaign's plan and its seed.
    pub from: Provenance,
}

/// One row of the linear problem, its right side last, and the number of its muscle.
type Equation = (u64, Vec<f64>);

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
    let steps = FOLDS as usize + 2;
    let step = |done: usize| {
        progress.report(done, steps);
        progress.check()
    };
    let products = products(request.form);
    let method = match request.form {
        Form::Membrane => "membrane ends with a fitted correction for the wall",
        Form::Bulge => "a fitted polynomial for the ends",
    };
    let empty = UniversalFormula {
        name: request.name.clone(),
        deficit: Deficit {
            form: request.form,
            terms: vec![],
        },
        range: range(samples),
        errors: UniversalErrors {
            against: "forces of axisymmetric finite elements where they pull, P/mu from 0.02, as \
                shares of the muscle's blocked force at the same pressure"
                .into(),
            fit: UniversalSummary::default(),
            left_out: UniversalSummary::default(),
        },
        provenance: Provenance {
            method: format!("universal ({method}; {} terms)", products.len()),
            data_hash: hash::numbers(numbers(samples)),
            ..request.from.clone()
        },
    };
    step(0)?;
    let folds = reduced(samples, &empty, &products, progress)?;
    step(1)?;
    let formula_of = |terms: Vec<UniversalTerm>| {
        let deficit = Deficit {
            form: request.form,
            terms,
        };
        Arc::new(UniversalFormula {
            deficit,
            ..empty.clone()
        })
    };
    let all: Vec<&Reduced> = folds.iter().collect();
    let formula = formula_of(solve(&products, &all)?);
    let errors = |formula: &Arc<UniversalFormula>, chosen: &(dyn Fn(u64) -> bool + Sync)| {
        let build = |s: &Sample| -> Option<Box<dyn ForceModel>> {
            chosen(s.number).then(|| {
                Box::new(Universal::new(formula.clone(), &s.muscle)) as Box<dyn ForceModel>
            })
        };
        shares(samples, build, |s, p| inside(s, p, &empty.range, 0.0))
    };
    let fit = summary(&errors(&formula, &|_| true));
    FitError::refuse_absurd(fit.rms)?;
    let mut left_out = vec![];
    for fold in 0..FOLDS {
        step(2 + fold as usize)?;
        let mut kept = all.clone();
        kept.remove(fold as usize);
        let of_others = formula_of(solve(&products, &kept)?);
        left_out.extend(errors(&of_others, &|number| number % FOLDS == fold));
    }
    let mut done = Arc::unwrap_or_clone(formula);
    done.errors.fit = fit;
    done.errors.left_out = summary(&left_out);
    done.provenance.points = folds.iter().map(|fold| fold.1).sum();
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

/// The box, cut to what the muscles fill.
fn range(samples: &[Sample]) -> UniversalRange {
    let cut = |(low, high): (f64, f64), value: &dyn Fn(&Sample) -> f64| {
        let (least, most) = ends(samples.iter().map(value));
        (
            low.max(least),
            if high.is_finite() {
                high.min(most)
            } else {
                high
            },
        )
    };
    UniversalRange {
        wall_ratio: cut(RANGE.wall_ratio, &|s| {
            s.muscle.wall_mm() / s.muscle.outer_diameter_mm()
        }),
        length_ratio: cut(RANGE.length_ratio, &|s| {
            s.muscle.length_mm() / s.muscle.outer_diameter_mm()
        }),
        angle_deg: cut(RANGE.angle_deg, &|s| s.muscle.braid().angle_deg),
        ..RANGE
    }
}

fn equations(samples: &[Sample], empty: &UniversalFormula, products: &[[u8; 5]]) -> Vec<Equation> {
    let formula = Arc::new(empty.clone());
    let equations = |s: &Sample| {
        let model = Universal::new(formula.clone(), &s.muscle);
        let mu = s.muscle.tube().rubber.law.shear_modulus_mpa();
        let equation = |p: &PullPoint| {
            let pressure = p.pressure_mpa;
            let e = p.contraction;
            let force = p.force_n;
            let EndPoint {
                deficit_mm,
                start_mm,
                columns_mm,
                force_by_deficit_n_per_mm,
            } = model.end_point(pressure, e, force, products)?;
            // A root on another branch of the infinitely long muscle is none.
            if deficit_mm.abs() > 0.5 * s.muscle.outer_diameter_mm() {
                return None;
            }
            let low = pressure < LOW_PRESSURE.0 * mu;
            let weight =
                force_by_deficit_n_per_mm / p.blocked_n * if low { LOW_PRESSURE.1 } else { 1.0 };
            let right = deficit_mm - start_mm;
            let row = columns_mm.into_iter().chain([right]);
            let row: Vec<f64> = row.map(|c| weight * c).collect();
            row.iter().all(|v| v.is_finite()).then_some((s.number, row))
        };
        let chosen = s
            .points
            .iter()
            .filter(|p| inside(s, p, &empty.range, MARGIN));
        chosen.filter_map(equation).collect::<Vec<_>>()
    };
    threads::map(samples, equations)
        .into_iter()
        .flatten()
        .collect()
}

/// Muscles whose equations are made at once.
const AT_ONCE: usize = 256;

/// Equations, row after row, and how many they stand for.
type Reduced = (Vec<f64>, usize);

/// R of their QR: as many equations as there are unknowns have the least squares of all.
fn reduce(rows: &[f64], width: usize) -> Vec<f64> {
    let all = DMatrix::from_row_slice(rows.len() / width, width, rows);
    all.qr().r().transpose().as_slice().to_vec()
}

/// The equations of every fifth muscle.
fn reduced(
    samples: &[Sample],
    empty: &UniversalFormula,
    products: &[[u8; 5]],
    progress: &dyn Progress,
) -> Result<Vec<Reduced>> {
    let mut folds = vec![Reduced::default(); FOLDS as usize];
    let width = products.len() + 1;
    for some in samples.chunks(AT_ONCE) {
        progress.check()?;
        for (muscle, row) in equations(some, empty, products) {
            let (rows, count) = &mut folds[(muscle % FOLDS) as usize];
            rows.extend(row);
            *count += 1;
        }
        for (rows, _) in folds.iter_mut().filter(|f| f.0.len() > width * width) {
            *rows = reduce(rows, width);
        }
    }
    Ok(folds)
}

/// Least squares by Householder's QR; coefficients are rounded to nine digits.
fn solve(products: &[[u8; 5]], equations: &[&Reduced]) -> Result<Vec<UniversalTerm>> {
    let columns = products.len();
    if equations.iter().map(|e| e.1).sum::<usize>() < 2 * columns {
        return Err(FitError::empty(
            " inside of the box of the method universal, or too few of them",
        ));
    }
    let rows: Vec<f64> = equations.iter().flat_map(|e| &e.0).copied().collect();
    let all = DMatrix::from_row_slice(rows.len() / (columns + 1), columns + 1, &rows);
    let right = all.column(columns).into_owned();
    let x = least_squares(all.remove_column(columns), right)
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

/// S, A, B, M, L: chosen one by one on a campaign with muscles left out (forward selection among
/// the products up to the third degree), then kept.
const BULGE: [[u8; 5]; 16] = [
    [0, 0, 0, 0, 0],
    [0, 0, 0, 1, 0],
    [0, 0, 0, 0, 3],
    [0, 1, 0, 2, 0],
    [0, 1, 0, 0, 0],
    [0, 1, 0, 1, 0],
    [0, 0, 0, 3, 0],
    [0, 0, 0, 2, 0],
    [0, 0, 1, 0, 2],
    [0, 0, 0, 0, 1],
    [0, 1, 1, 0, 1],
    [0, 0, 0, 2, 1],
    [0, 0, 1, 0, 1],
    [0, 0, 2, 0, 1],
    [0, 0, 1, 2, 0],
    [0, 0, 3, 0, 0],
];

/// All products of a form: for `membrane` the 21 of degree two and less.
pub fn products(form: Form) -> Vec<[u8; 5]> {
    match form {
        Form::Bulge => BULGE.to_vec(),
        Form::Membrane => {
            let unit = |i: usize| [0, 1, 2, 3, 4].map(|k| u8::from(k == i));
            let pair =
                |i: usize, j: usize| [0, 1, 2, 3, 4].map(|k| u8::from(k == i) + u8::from(k == j));
            let pairs = (0..5).flat_map(|i| (i..5).map(move |j| pair(i, j)));
            [[0; 5]]
                .into_iter()
                .chain((0..5).map(unit))
                .chain(pairs)
                .collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mckibben_core::random::Random;

    /// Row C8 of the trials: equations are reduced while they come. Of ten thousand without noise
    /// the coefficients come back, with noise those of least squares: their residual is orthogonal
    /// to every column.
    #[test]
    fn reduced_equations_have_the_least_squares_of_all() {
        let products = products(Form::Bulge);
        let mut random = Random(8);
        for noise in [0.0, 0.1] {
            let mut rows = vec![];
            let width = products.len() + 1;
            let truth = |column: usize| 1.0 + column as f64 / 7.0;
            let mut all = vec![];
            for muscle in 0..10_000 {
                let left: Vec<f64> = products.iter().map(|_| random.between(-1.0, 1.0)).collect();
                let exact: f64 = left.iter().enumerate().map(|(i, v)| v * truth(i)).sum();
                let right = exact + noise * random.between(-1.0, 1.0);
                rows.extend(left.iter().copied().chain([right]));
                if muscle % 1000 == 0 {
                    rows = reduce(&rows, width);
                }
                all.push((left, right));
            }
            assert!(rows.len() < 1100 * width);
            let x: Vec<f64> = solve(&products, &[&(rows, 10_000)])
                .unwrap()
                .iter()
                .map(|term| term.value)
                .collect();
            for column in 0..x.len() {
                if noise == 0.0 {
                    assert!((x[column] - truth(column)).abs() < 1e-7);
                }
                let along: f64 = all
                    .iter()
                    .map(|(left, right)| {
                        let fitted: f64 = left.iter().zip(&x).map(|(a, b)| a * b).sum();
                        (right - fitted) * left[column]
                    })
                    .sum();
                // Coefficients are rounded to nine digits.
                assert!(along.abs() < 1e-4, "{along}");
            }
        }
    }
}
