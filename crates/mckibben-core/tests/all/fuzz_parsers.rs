//! Whatever is typed, no parser panics, none takes long, and what is accepted is finite.

use mckibben_core::{
    muscle::file::parse_muscle,
    rubber::library,
    units::{Dimension, Values, parse_quantity, parse_values},
};
use proptest::prelude::*;

/// Anything, or pieces of quantities in any order.
fn text() -> impl Strategy<Value = String> {
    let piece = prop::sample::select(vec![
        "0", "1", "2.5", "-", "+", ".", "..", ":", ",", " ", "e", "E9", "e-400", "1e999", "mm",
        "bar", "µm", "°", "N/mm²", "%", "nan", "inf", "in", "infinity", "\u{feff}", "٣", "1_000",
        "0x1", "\0",
    ]);
    prop_oneof![
        any::<String>(),
        "\\PC*",
        prop::collection::vec(piece, 0..9).prop_map(|pieces| pieces.concat()),
    ]
}

proptest! {
    #[test]
    fn quantities_are_finite_or_refused(text in text()) {
        for dimension in Dimension::all() {
            match parse_quantity(&text, dimension) {
                Ok(value) => prop_assert!(value.is_finite(), "{text:?}: {value}"),
                Err(error) => prop_assert!(!error.to_string().is_empty()),
            }
        }
    }

    #[test]
    fn ranges_and_lists_are_finite_ordered_or_refused(text in text()) {
        for dimension in Dimension::all() {
            match parse_values(&text, dimension) {
                Ok(Values::Interval(low, high)) => {
                    prop_assert!(low.is_finite() && high.is_finite() && low <= high, "{text:?}");
                }
                Ok(Values::List(list)) => {
                    prop_assert!(!list.is_empty() && list.iter().all(|v| v.is_finite()), "{text:?}");
                }
                Err(error) => prop_assert!(!error.to_string().is_empty()),
            }
        }
    }

    #[test]
    fn a_quantity_written_with_a_space_or_none_is_the_same(value in -1e6..1e6f64) {
        for (unit, dimension) in [("mm", Dimension::Length), ("bar", Dimension::Pressure), ("%", Dimension::Ratio)] {
            let (near, far) = (format!("{value}{unit}"), format!(" {value}  {unit} "));
            prop_assert_eq!(parse_quantity(&near, dimension), parse_quantity(&far, dimension));
            prop_assert!(parse_quantity(&near, dimension).is_ok());
        }
    }

    #[test]
    fn muscle_files_and_rubber_names_are_read_or_refused(text in text()) {
        for text in [format!("[tube]\nlength = \"{text}\""), format!("[braid]\n{text} = 3"), text.clone()] {
            if let Err(error) = parse_muscle(&text) {
                prop_assert!(error.place.is_some(), "{error}");
            }
        }
        if let Err(error) = library::find(&text) {
            prop_assert!(!error.to_string().is_empty());
        }
    }
}

/// Texts as long as a file may be, made to exhaust a stack, or a reader whose time is quadratic.
#[test]
fn hostile_files_are_refused_in_few_words() {
    let n = 1 << 19;
    let hostile = [
        "[".repeat(n),
        format!("a = {}", "[".repeat(n)),
        format!("a = {}", "{a=".repeat(n / 3)),
        format!("{}a = 1", "a.".repeat(n / 2)),
        format!("[{}a]", "a.".repeat(n / 2)),
        format!("tube.{}", "x".repeat(n)),
        format!("[tube]\nlength = \"{}\"", "9".repeat(n)),
        format!("[tube]\nlength = {}", "9".repeat(n)),
        format!("[tube]\nrubber = \"{}\"", "é".repeat(n / 2)),
        format!("[tube]\n{} = 1", "k".repeat(n)),
        (0..n / 10).map(|i| format!("k{i} = 1\n")).collect(),
        (0..n / 10).map(|i| format!("[t{i}]\n")).collect(),
        "[[tube]]\n".repeat(n / 9),
        format!(
            "[tube.material]\nlaw = \"ogden\"\nmu = [{}]\nalpha = [1]",
            "1,".repeat(n / 2)
        ),
    ];
    for text in hostile {
        let error = parse_muscle(&text).unwrap_err();
        let message = error.to_string();
        assert!(message.len() < 2000, "a message of {} bytes", message.len());
    }
}
