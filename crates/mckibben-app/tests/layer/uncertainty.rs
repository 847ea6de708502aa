//! The breakdown of a ± in words.

use mckibben_app::{breakdown, units::Units};
use mckibben_core::built::UncertaintyParts;

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
    assert_eq!(
        breakdown(&parts, &u.force),
        "± 170 N (95 %): friction 160, model against tests 50, mesh 1"
    );
    assert_eq!(
        breakdown(&UncertaintyParts::default(), &u.force),
        "± 0 N (95 %)"
    );
}
