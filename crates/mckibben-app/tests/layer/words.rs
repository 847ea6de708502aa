//! Numbers in text: digits, columns.

use mckibben_app::words::{aligned, half_width, within};

#[test]
fn digits_that_the_uncertainty_hides_are_not_shown() {
    for (value, uncertainty, shown) in [
        (375.9, 96.2, "376 ± 96"),
        (326.31, 118.0, "330 ± 120"),
        (0.127_04, 0.03, "0.127 ± 0.030"),
        (0.012_346, 0.000_4, "0.01235 ± 0.00040"),
        (-0.2, 118.0, "0 ± 120"),
    ] {
        assert_eq!(
            format!(
                "{} ± {}",
                within(value, uncertainty),
                half_width(uncertainty)
            ),
            shown
        );
    }
}

#[test]
fn columns_are_aligned_and_no_longer_than_needed() {
    let list = |v: &[f64]| aligned(&v.iter().copied().map(Some).collect::<Vec<_>>(), 4);
    assert_eq!(list(&[38.61, 44.5]), ["38.61", "44.50"]);
    assert_eq!(list(&[0.5, 1.0, 2.0]), ["0.5", "1.0", "2.0"]);
    assert_eq!(list(&[28.0, 30.0]), ["28", "30"]);
    assert_eq!(list(&[921.72, 10.107, -0.001]), ["921.7", "10.1", "0.0"]);
    assert_eq!(
        aligned(&[None, Some(2.0), Some(f64::NAN)], 3),
        ["–", "2", "–"]
    );
}
