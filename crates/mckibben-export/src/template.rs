//! Numbers and lists in the texts of the hosts.

pub use mckibben_io::template::render;

/// A number that reads back to the last bit, in any of the hosts' languages.
pub fn number(value: f64) -> String {
    format!("{value:e}")
}

/// A list between brackets, each number by `one`.
pub fn list(values: &[f64], [open, close]: [&str; 2], one: impl Fn(f64) -> String) -> String {
    let texts: Vec<String> = values.iter().map(|v| one(*v)).collect();
    format!("{open}{}{close}", texts.join(", "))
}

/// Rows of lists, one a line.
pub fn lists(
    values: &[Vec<f64>],
    brackets: [&str; 2],
    one: impl Fn(f64) -> String + Copy,
) -> String {
    let rows: Vec<String> = values.iter().map(|row| list(row, brackets, one)).collect();
    format!("{}{}{}", brackets[0], rows.join(",\n     "), brackets[1])
}
