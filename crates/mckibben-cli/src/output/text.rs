//! Text for people: aligned, with units, rounded to what is worth reading.

use crate::flags::PressureUnit;
use comfy_table::{CellAlignment, Table, presets};
use mckibben::muscle::{BraidStiffness, Muscle};
use mckibben::rubber::Law;

/// How people are shown pressures.
#[derive(Debug, Clone, Copy)]
pub struct Pressures(pub PressureUnit);

impl Pressures {
    /// The unit's name.
    pub fn unit(self) -> &'static str {
        self.0.of_one_mpa().0
    }

    /// A pressure in this unit.
    pub fn value(self, mpa: f64) -> f64 {
        mpa * self.0.of_one_mpa().1
    }

    /// `2.5 bar`.
    pub fn show(self, mpa: f64) -> String {
        format!("{} {}", number(self.value(mpa), 4), self.unit())
    }
}

/// A number with so many significant digits, without an exponent where it is short without.
pub fn number(v: f64, digits: usize) -> String {
    if v == 0.0 || !v.is_finite() {
        return if v == 0.0 { "0".into() } else { "–".into() };
    }
    let magnitude = v.abs().log10().floor() as i32;
    if !(-5..15).contains(&magnitude) {
        return format!("{v:.*e}", digits.saturating_sub(1));
    }
    let decimals = (digits as i32 - 1 - magnitude).max(0) as usize;
    let text = format!("{v:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".into() } else { text.into() }
}

/// A number or a dash.
pub fn or_dash<T>(v: Option<T>, show: impl Fn(T) -> String) -> String {
    v.map_or_else(|| "–".into(), show)
}

/// A ratio as a percentage.
pub fn percent(ratio: f64) -> String {
    format!("{} %", number(100.0 * ratio, 4))
}

/// A table without borders: a header, aligned columns (numbers to the right).
pub fn table(header: &[&str], rows: Vec<Vec<String>>) -> String {
    let numeric = |i: usize| {
        let cells = rows.iter().filter_map(|row| row.get(i));
        let number = |c: &String| c.starts_with(|ch: char| ch.is_ascii_digit() || "–-+. ".contains(ch));
        cells.clone().all(|c| c.is_empty() || number(c) || c == "slack" || c == "unknown" || c == "→")
    };
    let numeric: Vec<bool> = (0..header.len()).map(numeric).collect();
    let mut table = Table::new();
    table.load_preset(presets::NOTHING).set_header(header.iter().copied());
    for row in rows {
        table.add_row(row);
    }
    let last = header.len().saturating_sub(1);
    for (i, column) in table.column_iter_mut().enumerate() {
        column.set_cell_alignment(if numeric[i] { CellAlignment::Right } else { CellAlignment::Left });
        column.set_padding((0, if i == last { 0 } else { 2 }));
    }
    let text: Vec<String> = table.lines().map(|l| l.trim_end().to_owned()).collect();
    text.join("\n") + "\n"
}

/// Aligned `name   value` lines.
pub fn pairs(list: &[(&str, String)]) -> String {
    let width = list.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    list.iter().map(|(name, value)| format!("  {name:<width$}   {value}\n")).collect()
}

/// The rubber in one word or formula.
pub fn rubber_name(m: &Muscle) -> String {
    let rubber = &m.tube().rubber;
    rubber.name.clone().unwrap_or_else(|| law_text(&rubber.law))
}

/// A law with its constants.
pub fn law_text(law: &Law) -> String {
    let constants: Vec<String> = law
        .constants()
        .into_iter()
        .map(|c| format!("{} {} {}", c.name, number(c.value, 4), c.constant.unit()).trim_end().to_owned())
        .collect();
    format!("{} ({})", law.name(), constants.join(", "))
}

/// The braid in one word or figure.
pub fn braid_name(m: &Muscle) -> String {
    match m.braid().stiffness {
        BraidStiffness::Paper => "paper".into(),
        BraidStiffness::Inextensible => "inextensible".into(),
        BraidStiffness::NewtonPerMm(k) => format!("{} N/mm", number(k, 4)),
        BraidStiffness::OfStrands => match (m.braid().strands, m.family_stiffness_n_per_mm()) {
            (Some(s), Some(k)) => format!("{} strands, {} N/mm", s.count, number(k, 4)),
            _ => "strands".into(),
        },
    }
}

/// The muscle in one line.
pub fn muscle_line(m: &Muscle) -> String {
    format!(
        "D0 {} mm, s {} mm, L0 {} mm, θ0 {}°, rubber {}, braid {}",
        number(m.outer_diameter_mm(), 5),
        number(m.wall_mm(), 4),
        number(m.length_mm(), 5),
        number(m.braid().angle_deg, 4),
        rubber_name(m),
        braid_name(m)
    )
}

/// `± 41 N`, or that nothing is known.
pub fn plus_minus(uncertainty_n: Option<f64>) -> String {
    uncertainty_n.map_or_else(|| "± unknown".into(), |u| format!("± {} N", number(u, 2)))
}
