//! What `check` finds.

use mckibben_app::{CheckAnswer, CheckRequest, FindingKind, MuscleFields, check, units::Units};
use mckibben_core::muscle::measures::LENGTH;

fn checked(request: CheckRequest) -> CheckAnswer {
    check(&request).unwrap()
}

/// √(total² − friction²), by hand from the parts of the same muscle.
#[test]
fn a_measured_friction_takes_its_square_out_of_the_half_width() {
    let answer = checked(CheckRequest::default());
    let friction = answer
        .findings
        .iter()
        .find(|f| f.text.starts_with("friction unknown"))
        .unwrap();
    let values = answer.characteristics.unwrap();
    let total = values.blocked_force_uncertainty_n.unwrap();
    // 12 % of the blocked force where a muscle does not state its friction (docs/models.md).
    let part = 0.12 * values.blocked_force_n;
    assert!((friction.left_n.unwrap() - (total * total - part * part).sqrt()).abs() < 1e-6 * total);
}

#[test]
fn each_kind_of_finding_is_found_on_a_muscle_that_has_it() {
    let answer = checked(CheckRequest::default());
    let values = answer.characteristics.as_ref().unwrap();
    assert_eq!((values.model.as_str(), values.pressure_mpa), ("fe", 0.25));
    let texts = |answer: &CheckAnswer, kind| answer.sentences(kind, &Units::default()).join("\n");
    assert!(texts(&answer, FindingKind::Unknown).contains("`pull_off`"));
    // The prototype has 30 mm; the widest measured muscle is the DMSP-20.
    assert!(texts(&answer, FindingKind::Outside).contains("the outer diameter is 30 mm"));
    assert!(texts(&answer, FindingKind::Measure).contains("would reduce the ± to about"));
    let short = checked(CheckRequest {
        question: MuscleFields::from([(&LENGTH, 100.0)]).into(),
        ..CheckRequest::default()
    });
    assert!(texts(&short, FindingKind::Implausible).contains("3.33 outer diameters"));
}
