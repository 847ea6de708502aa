//! The breakdown of a ± in words.

use mckibben_app::{bench, breakdown, units::Units};
use mckibben_core::uncertainty::{FrictionKnown, UncertaintyParts};

/// √(159² + 50² + 1²) = 166.7, by hand.
#[test]
fn the_breakdown_names_the_parts_by_size() {
    let parts = UncertaintyParts {
        friction: Some(159.0),
        measured: Some(50.0),
        mesh: Some(0.96),
        formula: Some(0.02),
        ..UncertaintyParts::default()
    };
    let u = Units::default();
    let unknown = "± 170 N (95 %): friction unknown 160, model against tests 50, mesh 1";
    assert_eq!(breakdown(&parts, &u.force), unknown);
    let stated = UncertaintyParts {
        friction_known: FrictionKnown::Stated,
        ..parts
    };
    assert!(breakdown(&stated, &u.force).contains(": friction 160,"));
    assert_eq!(
        breakdown(&UncertaintyParts::default(), &u.force),
        "± 0 N (95 %)"
    );
}

#[test]
fn the_bench_is_in_the_units_of_the_reader() {
    let text = |p: f64, units: &str| bench(31.4, p, &units.parse().unwrap()).unwrap();
    assert_eq!(
        text(0.3, "bar"),
        "10 points on both branches at 1\u{a0}bar and 3\u{a0}bar would reduce the ± to about \
         31\u{a0}N"
    );
    assert_eq!(
        text(0.25, "MPa"),
        "10 points on both branches at 0.1\u{a0}MPa and 0.25\u{a0}MPa would reduce the ± to about \
         31\u{a0}N"
    );
    assert_eq!(bench(31.4, 0.0, &Units::default()), None);
}
