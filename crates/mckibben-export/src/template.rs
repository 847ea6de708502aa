//! Numbers and lists in the texts of the hosts.
use mckibben_core::joined;

pub use mckibben_io::template::render;

/// A number that reads back to the last bit, in any of the hosts' languages.
pub fn number(value: f64) -> String {
    format!("{value:e}")
}

/// A list between brackets, each number by `one`.
pub fn list(values: &[f64], [open, close]: [&str; 2], one: impl Fn(f64) -> String) -> String {
    format!(
        "{open}{}{close}",
        joined(values.iter().map(|v| one(*v)), ", ")
    )
}

/// Rows of lists, one a line.
pub fn lists(
    values: &[Vec<f64>],
    brackets: [&str; 2],
    one: impl Fn(f64) -> String + Copy,
) -> String {
    format!(
        "{}{}{}",
        brackets[0],
        joined(
            values.iter().map(|row| list(row, brackets, one)),
            ",\n     "
        ),
        brackets[1]
    )
}
