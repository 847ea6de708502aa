//! What `check` finds.

use super::reply;
use mckibben_app::{CheckAnswer, CheckRequest, FindingKind, MuscleFields, check, units::Units};
use mckibben_core::muscle::measures::LENGTH;
use serde_json::{Value, json};

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

/// What is implausible is named by its reason: broken strands pull nothing, and a muscle that
/// extends neither pulls nor contracts.
#[test]
fn a_broken_muscle_and_one_that_extends_are_called_so() {
    let implausible = |request: Value| {
        let answer = reply("check", request);
        let findings = answer["findings"].as_array().unwrap().iter();
        let texts = findings.filter(|f| f["kind"] == "implausible");
        texts
            .map(|f| f["text"].as_str().unwrap().to_owned())
            .collect::<Vec<_>>()
    };
    let weak = json!({"strands": 64, "strand_strength_n": 5});
    let broken = implausible(json!({"muscle": weak, "pressure_mpa": 2}));
    assert!(
        broken
            .iter()
            .any(|text| text.contains("its strands are broken")),
        "{broken:?}"
    );
    assert!(
        !broken.iter().any(|text| text.contains("too low")),
        "{broken:?}"
    );
    let extends = implausible(json!({"muscle": {"angle_deg": 70}, "pressure_mpa": 0.2}));
    let wrong = |text: &String| text.contains("contracts by") || text.contains("does not pull");
    assert!(!extends.iter().any(wrong), "{extends:?}");
}
