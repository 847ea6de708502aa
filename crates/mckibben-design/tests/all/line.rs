//! The search along a line.

use mckibben_design::{
    line::{Found, STEPS, Sample, along, best_of},
    nice_steps,
};

fn line(low: f64, high: f64, limits: &[fn(f64) -> f64]) -> Found {
    along(low, high, false, |x| Sample {
        x,
        excess: limits.iter().map(|f| f(x)).collect(),
        score: [x, 0.0],
    })
}

#[test]
fn a_window_much_narrower_than_the_samples_is_found() {
    // From 17.000 to 17.001.
    let result = line(5.0, 80.0, &[|x| 17.0 / x - 1.0, |x| x / 17.001 - 1.0]);
    let [(low, high)] = result.fitting[..] else {
        panic!("{result:?}")
    };
    assert!(
        (low - 17.0).abs() < 1e-5 && (high - 17.001).abs() < 1e-5,
        "{low} {high}"
    );
}

#[test]
fn a_limit_that_is_met_between_two_samples_alone_is_found() {
    let result = line(5.0, 80.0, &[|x| (x / 31.0 - 1.0).powi(2) - 1e-4]);
    let [(low, high)] = result.fitting[..] else {
        panic!("{result:?}")
    };
    assert!(
        (low - 30.69).abs() < 1e-4 && (high - 31.31).abs() < 1e-4,
        "{low} {high}"
    );
}

#[test]
fn where_nothing_fits_one_limit_alone_is_missed() {
    let result = line(5.0, 80.0, &[|x| 1.0 - x / 20.0, |x| x / 10.0 - 1.0]);
    assert!(result.fitting.is_empty());
    // (1 − x/20) + (x/10 − 1) rises from 10 on.
    let best = result.best.unwrap();
    assert!(
        (best.x - 10.0).abs() < 0.05 && (best.violation() - 0.5).abs() < 5e-3,
        "{best:?}"
    );
}

#[test]
fn where_there_is_no_answer_nothing_fits_and_the_edge_is_found() {
    let result = along(5.0, 80.0, false, |x| Sample {
        x,
        excess: if x < 30.0 { vec![] } else { vec![-1.0] },
        score: [x, 0.0],
    });
    let [(low, high)] = result.fitting[..] else {
        panic!("{result:?}")
    };
    assert!((low - 30.0).abs() < 2e-3 && high == 80.0, "{low}");
}

#[test]
fn the_best_of_an_interval_is_its_minimum() {
    let mut at = |x: f64| Sample {
        x,
        excess: vec![-1.0],
        score: [(x - 6.3).powi(2), 0.0],
    };
    let best = best_of(1.0, 10.0, STEPS, &mut at).unwrap();
    assert!((best.x - 6.3).abs() < 0.02, "{best:?}");
}

#[test]
fn samples_come_at_round_steps_with_both_ends() {
    assert_eq!(
        nice_steps(1.0, 3.0, 12),
        [1.0, 1.25, 1.5, 1.75, 2.0, 2.25, 2.5, 2.75, 3.0]
    );
    assert_eq!(
        nice_steps(0.7, 5.0, 12),
        [0.7, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0]
    );
    assert_eq!(nice_steps(2.0, 2.0, 12), [2.0]);
}
