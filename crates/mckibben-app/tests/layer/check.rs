//! What `check` finds.

use super::reply;
use mckibben_app::{CheckAnswer, CheckRequest, FindingKind, MuscleFields, check, units::Units};
use mckibben_core::{built::Measurement, muscle::measures::LENGTH};
use serde_json::{Value, json};

fn checked(request: CheckRequest) -> CheckAnswer {
    check(&request).unwrap()
}

/// Each measurement says what it leaves, the best first, and all are narrower than the ± before.
#[test]
fn what_to_measure_is_told_with_what_it_leaves() {
    let answer = checked(CheckRequest::default());
    let values = answer.characteristics.unwrap();
    let before = values.blocked_force_uncertainty_n.unwrap();
    let left: Vec<f64> = answer.findings.iter().filter_map(|f| f.left_n).collect();
    assert_eq!(left.len(), Measurement::ALL.len());
    assert!(left.windows(2).all(|two| two[0] <= two[1]), "{left:?}");
    assert!(left.iter().all(|n| *n <= before), "{left:?} {before}");
}

#[test]
fn each_kind_of_finding_is_found_on_a_muscle_that_has_it() {
    let answer = checked(CheckRequest::default());
    let values = answer.characteristics.as_ref().unwrap();
    assert_eq!((values.model.as_str(), values.pressure_mpa), ("fe", 0.25));
    let texts = |answer: &CheckAnswer, kind| answer.sentences(kind, &Units::default()).join("\n");
    assert!(texts(&answer, FindingKind::Unknown).contains("`pull_off`"));
    // The prototype has 30 mm; the widest measured muscle is the DMSP-20.
    assert!(texts(&answer, FindingKind::Outside).contains("30 mm"));
    assert!(texts(&answer, FindingKind::Measure).contains("(about 5"));
    let short = checked(CheckRequest {
        question: MuscleFields::from([(&LENGTH, 100.0)]).into(),
        ..CheckRequest::default()
    });
    assert!(texts(&short, FindingKind::Implausible).contains("3.33 "));
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
