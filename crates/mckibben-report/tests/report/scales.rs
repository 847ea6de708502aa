//! Axes: their ranges, ticks and numbers.

use mckibben_report::{
    Axis, Panel, Series, extents,
    ticks::{Scale, extent, power_text, scale, typographic},
};
use proptest::prelude::*;

fn auto(low: f64, high: f64, wanted: usize) -> Scale {
    scale(&Axis::new("q [1]"), Some((low, high)), wanted).unwrap()
}

/// The leading digit of a step: 1, 2 or 5.
fn digit(ticks: &[f64]) -> f64 {
    let step = (ticks[ticks.len() - 1] - ticks[0]) / (ticks.len() - 1) as f64;
    let shown = format!("{step:.4e}");
    shown.split('e').next().unwrap().parse().unwrap()
}

proptest! {
    #[test]
    fn ticks_cover_the_data_rise_and_step_by_1_2_5(
        start in -1e6..1e6_f64, log_span in -5.0..8.0_f64, wanted in 1_usize..10,
    ) {
        let (low, high) = (start, start + 10f64.powf(log_span));
        let s = auto(low, high, wanted);
        prop_assert!(s.low <= low && s.high >= high);
        let slack = 1e-9 * (s.high - s.low) + 1e-12 * start.abs();
        prop_assert!((s.ticks[0] - s.low).abs() <= slack);
        prop_assert!((s.ticks[s.ticks.len() - 1] - s.high).abs() <= slack);
        prop_assert!(s.ticks.windows(2).all(|p| p[0] < p[1]));
        prop_assert!([1.0, 2.0, 5.0].iter().any(|d| (digit(&s.ticks) - d).abs() < 2e-3), "{:?}", s);
        prop_assert_eq!(s.ticks.len(), s.labels.len());
        prop_assert!(s.ticks.len() <= 3 * wanted + 2);
    }

    #[test]
    fn tick_texts_differ_and_mean_their_tick(
        start in -1e4..1e4_f64, log_span in -3.0..9.0_f64, wanted in 2_usize..9,
    ) {
        let s = auto(start, start + 10f64.powf(log_span), wanted);
        for (tick, label) in s.ticks.iter().zip(&s.labels) {
            let read: f64 = label.replace('\u{2212}', "-").parse().unwrap();
            let meant = read * 10f64.powi(s.exponent);
            prop_assert!((meant - tick).abs() <= 1e-6 * (s.high - s.low), "{label} for {tick}");
        }
        prop_assert!(s.labels.windows(2).all(|p| p[0] != p[1]));
    }

    #[test]
    fn a_fixed_range_stays_and_holds_its_ticks(
        low in -1e5..1e5_f64, span in 1e-3..1e6_f64, wanted in 1_usize..10,
    ) {
        let s = scale(&Axis::new("").range(low, low + span), None, wanted).unwrap();
        prop_assert_eq!((s.low, s.high), (low, low + span));
        let slack = 1e-6 * span;
        prop_assert!(s.ticks.iter().all(|t| *t >= low - slack && *t <= low + span + slack));
    }

    #[test]
    fn no_range_panics(low in proptest::num::f64::ANY, high in proptest::num::f64::ANY) {
        let _ = scale(&Axis::new("").range(low, high), None, 5);
        let free = extent([low, high].into_iter()).and_then(|data| scale(&Axis::new(""), Some(data), 5).ok());
        if let Some(s) = free {
            prop_assert!(s.low < s.high && (s.high - s.low).is_finite());
            prop_assert!(!s.ticks.is_empty());
        }
    }
}

#[test]
fn ticks_carry_no_rounding_dust() {
    let s = auto(0.0, 0.35, 7);
    assert_eq!(s.ticks, [0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35]);
    assert_eq!(s.labels[3], "0.15");
}

#[test]
fn equal_values_get_a_range_around_them() {
    for v in [5.0, -3e-7, 1e12, 0.0, 1e-300] {
        let s = auto(v, v, 5);
        assert!(s.low <= v && v <= s.high && s.low < s.high, "{v}: {s:?}");
        assert!(s.ticks.len() >= 2);
    }
}

#[test]
fn large_and_small_numbers_share_a_power() {
    let s = auto(0.0, 3.2e6, 5);
    assert_eq!(s.exponent, 6);
    assert_eq!(s.labels[0], "0.0");
    assert_eq!(power_text(s.exponent), "×10⁶");
    assert_eq!(power_text(-3), "×10⁻³");
}

#[test]
fn minus_is_a_sign_of_its_own_and_zero_has_none() {
    assert_eq!(typographic("-0.00"), "0.00");
    assert_eq!(typographic("-2"), "\u{2212}2");
}

/// The frame cuts a band that is wider than its line: half of the line's height lies above and
/// below.
#[test]
fn a_band_wider_than_its_line_does_not_fill_the_axis() {
    let line = Series::line("pull", vec![(0.0, 10.0), (1.0, 0.0)]);
    let panel = |half: f64| {
        let band = Series::band(&[(0.0, 10.0 - half, 10.0 + half), (1.0, -half, half)]);
        Panel::new(Axis::new("x"), Axis::new("y"))
            .series(line.clone())
            .series(band)
    };
    assert_eq!(extents(&panel(1.0)).1, Some((-1.0, 11.0)));
    assert_eq!(extents(&panel(1000.0)).1, Some((-5.0, 15.0)));
}
