//! The size of a request before it is read.

use mckibben_app::{JsonSize, ProblemKind};

#[test]
fn what_stands_in_texts_is_not_counted() {
    let size = JsonSize::of(r#"{"a": "[[[\"{{{,,,", "b": [1, 2, {}]}"#).unwrap();
    // The object, a, b's list, its three elements and at most one for each container.
    assert!((6..=7).contains(&size.values) && size.containers == 3, "{size:?}");
}

#[test]
fn deep_and_many_values_are_refused() {
    let nested = |n: usize| "[".repeat(n) + &"]".repeat(n);
    assert!(JsonSize::of(&nested(16)).is_ok());
    assert_eq!(JsonSize::of(&nested(17)).unwrap_err().kind, ProblemKind::Usage);
    assert!(JsonSize::of(&"[1,".repeat(10)).is_ok());
    let many = |n: usize| format!("[{}1]", "1,".repeat(n));
    assert!(JsonSize::of(&many(400_000)).is_ok());
    assert_eq!(JsonSize::of(&many(500_000)).unwrap_err().kind, ProblemKind::Budget);
}
