//! Texts with places for values: `@{key}`.

/// A template with its values. A line with `@{facts}` is repeated for each of the facts, with what is left of it in front.
pub(crate) fn render(template: &str, facts: &[String], values: &[(&str, String)]) -> String {
    let mut out = String::with_capacity(2 * template.len());
    for line in template.lines() {
        if let Some((before, after)) = line.split_once("@{facts}") {
            for fact in facts {
                out += &format!("{before}{fact}{after}\n");
            }
            continue;
        }
        let mut line = line.to_owned();
        for (key, value) in values {
            let place = format!("@{{{key}}}");
            if line.contains(&place) {
                line = line.replace(&place, value);
            }
        }
        out += &line;
        out.push('\n');
    }
    out
}

/// A number that reads back to the last bit, in any of the hosts' languages.
pub(crate) fn number(value: f64) -> String {
    format!("{value:e}")
}

/// A list between brackets, each number by `one`.
pub(crate) fn list(values: &[f64], [open, close]: [&str; 2], one: impl Fn(f64) -> String) -> String {
    let texts: Vec<String> = values.iter().map(|v| one(*v)).collect();
    format!("{open}{}{close}", texts.join(", "))
}

pub(crate) fn lists(
    values: &[Vec<f64>],
    brackets: [&str; 2],
    between: &str,
    one: impl Fn(f64) -> String + Copy,
) -> String {
    let rows: Vec<String> = values.iter().map(|row| list(row, brackets, one)).collect();
    format!("{}{}{}", brackets[0], rows.join(between), brackets[1])
}
