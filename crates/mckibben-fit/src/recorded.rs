//! Constants of a motion from quantities that were recorded over time.
//!
//! Least squares of the residuals of all quantities,
//!
//!   r = (y(t; θ) − y)/s,   s the rms of a quantity's residuals in the fit before, at first its scatter
//!
//! Residuals of neighbouring rows are alike where the model errs. With ρ their correlation n rows
//! are worth n (1 − ρ)/(1 + ρ) independent ones, so that the ± is larger by √((1 + ρ)/(1 − ρ)), as
//! of a first-order autoregression (Bayley & Hammersley 1946 \[bayley1946\]).

use crate::least_squares::{Errors, Estimate, EstimateError, Unknown, estimate};

/// Share of a quantity's scatter below which its residuals are rounding.
const ROUNDING: f64 = 1e-6;
/// Largest correlation of neighbouring rows.
const MOST_ALIKE: f64 = 0.9999;

/// Constants above zero, from `residuals`: model less record of each quantity, a list each.
///
/// `scatter` is the root mean square of each quantity about its mean.
///
/// # Errors
/// The error of the residuals at the start; [`EstimateError`] where there is no minimum.
pub fn fit_recorded<E: From<EstimateError>>(
    starts: &[f64],
    scatter: &[f64],
    residuals: impl Fn(&[f64]) -> Result<Vec<Vec<f64>>, E>,
) -> Result<Estimate, E> {
    let weights = vec![1.0; residuals(starts)?.iter().map(Vec::len).sum()];
    let fit = |from: &[f64], scales: &[f64]| {
        let unknowns = from
            .iter()
            .zip(starts)
            .map(|(x, start)| Unknown::above(*x, 0.0, *start));
        let scaled = |x: &[f64]| Some(divided(residuals(x).ok()?, scales).concat());
        let unknowns = Vec::from_iter(unknowns);
        Ok::<_, E>(estimate(&scaled, &unknowns, &weights)?)
    };
    let scales = |lists: &[Vec<f64>]| -> Vec<f64> {
        let scale = |(list, scatter): (&Vec<f64>, &f64)| {
            Errors::new(list.iter().copied())
                .rms
                .max(ROUNDING * scatter)
        };
        lists.iter().zip(scatter).map(scale).collect()
    };
    let first = fit(starts, scatter)?;
    let mut found = fit(&first.x, &scales(&residuals(&first.x)?))?;
    let lists = residuals(&found.x)?;
    let scales = scales(&lists);
    let wider = widening(&divided(lists, &scales));
    for half in [&mut found.standard_errors, &mut found.half_widths] {
        half.iter_mut().for_each(|half| *half *= wider);
    }
    Ok(found)
}

fn divided(lists: Vec<Vec<f64>>, scales: &[f64]) -> Vec<Vec<f64>> {
    let one = |(list, scale): (Vec<f64>, &f64)| list.into_iter().map(|r| r / scale).collect();
    lists.into_iter().zip(scales).map(one).collect()
}

/// By how much the ± is larger because neighbouring rows are alike.
fn widening(lists: &[Vec<f64>]) -> f64 {
    let products: f64 = lists
        .iter()
        .flat_map(|list| list.windows(2))
        .map(|pair| pair[0] * pair[1])
        .sum();
    let squares: f64 = lists.iter().flatten().map(|r| r * r).sum();
    let alike = (products / squares).clamp(0.0, MOST_ALIKE);
    ((1.0 + alike) / (1.0 - alike)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand, of the mean 1.5 of four rows: Σr² = 1, s² = 1/3, σ = √(1/12); in the order 1, 1, 2,
    /// 2 the products of neighbours add up to 1/4, so that σ is √(1.25/0.75) times that; in the
    /// order 1, 2, 1, 2 they are not alike.
    #[test]
    fn a_mean_of_rows_that_are_alike_is_known_less_well() {
        let independent = (1.0_f64 / 12.0).sqrt();
        for (rows, error) in [
            ([1.0, 1.0, 2.0, 2.0], independent * (1.25_f64 / 0.75).sqrt()),
            ([1.0, 2.0, 1.0, 2.0], independent),
        ] {
            let residuals = |x: &[f64]| Ok::<_, EstimateError>(vec![rows.map(|y| x[0] - y).into()]);
            let found = fit_recorded(&[1.0], &[0.5], residuals).unwrap();
            assert!((found.x[0] - 1.5).abs() < 1e-9, "{found:?}");
            assert!((found.standard_errors[0] - error).abs() < 1e-9, "{found:?}");
        }
    }
}
