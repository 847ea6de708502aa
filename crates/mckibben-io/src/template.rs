//! Texts with places for values: `@{key}`.

/// A template with its values. A line with `@{facts}` is repeated for each of the facts, with the
/// text in front of it; one that begins with `@{key?}` remains only where the key has a value.
pub fn render(template: &str, facts: &[String], values: &[(&str, String)]) -> String {
    let mut out = String::with_capacity(2 * template.len());
    for line in template.lines() {
        if let Some((before, after)) = line.split_once("@{facts}") {
            for fact in facts {
                out += &format!("{before}{fact}{after}\n");
            }
            continue;
        }
        let condition = line
            .strip_prefix("@{")
            .and_then(|rest| rest.split_once("?}"));
        if condition.is_some_and(|(key, _)| values.iter().all(|(known, _)| *known != key)) {
            continue;
        }
        let mut line = condition.map_or(line, |(_, rest)| rest).to_owned();
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
