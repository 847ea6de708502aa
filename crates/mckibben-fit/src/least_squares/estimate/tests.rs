use super::*;
use crate::least_squares::Noise;

const FREE: [Unknown; 2] = [Unknown {
    start: 0.0,
    low: f64::NEG_INFINITY,
    high: f64::INFINITY,
    scale: 1.0,
}; 2];

fn line(points: usize, noise: f64, seed: u64) -> Vec<(f64, f64)> {
    let mut n = Noise(seed);
    (0..points)
        .map(|i| i as f64 / 10.0)
        .map(|t| (t, 2.0 + 3.0 * t + noise * n.next()))
        .collect()
}

fn of_line(data: &[(f64, f64)]) -> impl Fn(&[f64]) -> Option<Vec<f64>> + '_ {
    |x| Some(data.iter().map(|&(t, y)| x[0] + x[1] * t - y).collect())
}

/// A straight line has its standard errors in closed form: s² = Σr²/(n−2), var b = s²/Σ(t−t̄)², var
/// a = s²(1/n + t̄²/Σ(t−t̄)²).
#[test]
fn standard_errors_of_a_straight_line_are_the_textbook_ones() {
    let data = line(21, 0.1, 7);
    let e = estimate(&of_line(&data), &FREE, &[1.0; 21]).unwrap();
    let n = 21.0;
    let mean = data.iter().map(|p| p.0).sum::<f64>() / n;
    let spread = data.iter().map(|p| (p.0 - mean).powi(2)).sum::<f64>();
    let s2 = e.residuals.iter().map(|r| r * r).sum::<f64>() / (n - 2.0);
    assert!((e.standard_errors[1] - (s2 / spread).sqrt()).abs() < 1e-8);
    assert!((e.standard_errors[0] - (s2 * (1.0 / n + mean * mean / spread)).sqrt()).abs() < 1e-8);
}

/// 95 % intervals hold the truth in 95 % of 400 trials; ± 3 standard deviations of a binomial count
/// are ± 13.
#[test]
fn intervals_cover_the_truth_at_their_rate() {
    let mut hits = [0; 2];
    for trial in 0..400 {
        let data = line(8, 0.5, 1000 + trial);
        let e = estimate(&of_line(&data), &FREE, &[1.0; 8]).unwrap();
        for (i, truth) in [2.0, 3.0].iter().enumerate() {
            hits[i] += usize::from((e.x[i] - truth).abs() <= e.half_widths[i]);
        }
    }
    assert!(hits.iter().all(|h| (367..=393).contains(h)), "{hits:?}");
}

#[test]
fn bounds_hold_and_are_told() {
    let data = line(12, 0.01, 5);
    let unknowns = [
        Unknown {
            start: 1.0,
            low: 0.0,
            high: 1.5,
            scale: 1.0,
        },
        Unknown::above(1.0, 0.0, 1.0),
    ];
    let e = estimate(&of_line(&data), &unknowns, &[1.0; 12]).unwrap();
    assert!(e.x[0] <= 1.5 && e.at_bound[0], "{e:?}");
    assert!(!e.at_bound[1] && e.x[1] > 3.0);
    // All of them on bounds.
    let unknowns = [
        Unknown {
            start: 1.0,
            low: 0.0,
            high: 1.5,
            scale: 1.0,
        },
        Unknown {
            start: 1.0,
            low: 0.0,
            high: 2.0,
            scale: 1.0,
        },
    ];
    let e = estimate(&of_line(&data), &unknowns, &[1.0; 12]).unwrap();
    assert!(
        e.at_bound == [true, true] && e.standard_errors == [0.0, 0.0],
        "{e:?}"
    );
}

#[test]
fn unknowns_that_act_together_are_unidentifiable() {
    let data = line(12, 0.01, 5);
    let twice = |x: &[f64]| {
        Some(
            data.iter()
                .map(|&(t, y)| 2.0 + (x[0] + x[1]) * t - y)
                .collect(),
        )
    };
    let unknowns = [Unknown::free(1.0, 1.0), Unknown::free(1.0, 1.0)];
    let e = estimate(&twice, &unknowns, &[1.0; 12]).unwrap();
    assert!(
        e.standard_errors
            .iter()
            .chain(&e.half_widths)
            .all(|s| *s > 1.0),
        "{e:?}"
    );
    assert!((e.x[0] + e.x[1] - 3.0).abs() < 0.01);
}

#[test]
fn too_few_points_and_a_failing_model_are_errors() {
    let data = line(2, 0.0, 1);
    let few = estimate(&of_line(&data), &FREE, &[1.0; 2]);
    assert_eq!(
        few,
        Err(EstimateError::TooFew {
            points: 2,
            unknowns: 2
        })
    );
    let none = |_: &[f64]| -> Option<Vec<f64>> { None };
    assert_eq!(estimate(&none, &FREE, &[1.0; 5]), Err(EstimateError::Start));
}

/// Steps past the edge of the model are taken back.
#[test]
fn a_model_that_ends_somewhere_is_followed_up_to_there() {
    let data = line(12, 0.0, 5);
    let edge = |x: &[f64]| {
        (x[0] > 1.9).then(|| {
            data.iter()
                .map(|&(t, y)| x[0].ln() + x[1] * t - y)
                .collect()
        })
    };
    let unknowns = [Unknown::free(40.0, 1.0), Unknown::free(0.0, 1.0)];
    let e = estimate(&edge, &unknowns, &[1.0; 12]).unwrap();
    assert!(
        (e.x[0] - 2f64.exp()).abs() < 1e-5 && (e.x[1] - 3.0).abs() < 1e-6,
        "{:?}",
        e.x
    );
}

/// Rosenbrock (1960) \[rosenbrock1960\]: minimum 0 at (1, 1). The third point is met by any
/// unknowns.
#[test]
fn rosenbrocks_valley_is_followed_to_its_end() {
    let valley = |x: &[f64]| Some(vec![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0], 0.0]);
    let result = estimate(&valley, &FREE, &[1.0; 3]).unwrap();
    assert!(
        (result.x[0] - 1.0).abs() < 1e-7 && (result.x[1] - 1.0).abs() < 1e-7,
        "{result:?}"
    );
    assert!(result.residuals.iter().map(|r| r * r).sum::<f64>() < 1e-14);
}

/// The minimum, 1 by hand, lies where the model has no answer: the edge of the answers is no
/// minimum.
#[test]
fn a_minimum_without_an_answer_is_not_replaced_by_the_last_point_with_one() {
    let no_answer_below_2 =
        |x: &[f64]| (x[0] > 2.0).then(|| vec![x[0] - 0.9, x[0] - 1.1, x[0] - 1.0]);
    let result = estimate(&no_answer_below_2, &[Unknown::free(7.0, 1.0)], &[1.0; 3]);
    assert!(
        matches!(result, Err(EstimateError::NoMinimum { .. })),
        "{result:?}"
    );
}
