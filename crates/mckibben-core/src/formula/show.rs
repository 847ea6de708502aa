//! A formula for readers: its equation in words and in LaTeX.

use super::{Body, Formula, terms::name};

/// Digits of a coefficient for readers; the file has all of them.
fn digits(v: f64) -> String {
    let text = format!("{v:.5e}");
    let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
    match power {
        "0" => mantissa.to_owned(),
        _ => format!("{mantissa} \\cdot 10^{{{power}}}"),
    }
}

impl Formula {
    /// The equation in one line.
    pub fn equation(&self) -> String {
        match &self.body {
            Body::Paper(_) => "F = (m_a P + q_a) e^2 + (m_b P + q_b) e + (m_c P + q_c); m_a = A1 \
                s^2 + A2 s + A3, q_a = A4 s^2 + A5 s + A6; \
                A_k = A_k1 D0^2 + A_k2 D0 + A_k3, B_k likewise, C_k = C_k1 D0 + C_k2 (F in N, P in \
                MPa, s and D0 in mm, e = contraction)"
                .into(),
            Body::Global(t) => format!(
                "F = D0^2 sum(value x^a p^b e^c d^d), x = (s/D0)/{}, p = P/{} MPa, e = \
                 contraction/{}, d = D0/{} mm (F in N, D0 in mm, values in MPa)",
                t.scales.wall_ratio,
                t.scales.pressure_mpa,
                t.scales.contraction,
                t.scales.outer_diameter_mm
            ),
        }
    }

    /// The equation with its numbers as LaTeX: a display of its own, with amsmath.
    pub fn to_latex(&self) -> String {
        let mut lines = vec![];
        match &self.body {
            Body::Paper(c) => {
                lines.push(
                    "F &= (m_a P + q_a)\\,\\varepsilon^2 + (m_b P + q_b)\\,\\varepsilon + (m_c P + q_c)"
                        .to_owned(),
                );
                for (letter, block) in [("a", &c.a), ("b", &c.b), ("c", &c.c)] {
                    for (symbol, rows) in [("m", &block[..3]), ("q", &block[3..])] {
                        let starts = [&format!("{symbol}_{letter} &= "), NEXT, NEXT];
                        for ((row, s), start) in rows.iter().zip([" s^2", " s", ""]).zip(starts) {
                            let inner = row
                                .iter()
                                .zip([" D_0^2", " D_0", ""])
                                .filter(|(v, _)| **v != 0.0);
                            let inner = sum(inner.map(|(v, d)| (*v, d.to_owned())));
                            lines.push(format!("{start}({inner}){s}"));
                        }
                    }
                }
            }
            Body::Global(t) => {
                let s = &t.scales;
                lines.push(format!(
                    "x &= \\frac{{s/D_0}}{{{}}},\\quad p = \\frac{{P}}{{{}\\,\\mathrm{{MPa}}}},\\quad e \
                     = \\frac{{\\varepsilon}}{{{}}},\\quad d = \\frac{{D_0}}{{{}\\,\\mathrm{{mm}}}}",
                    s.wall_ratio, s.pressure_mpa, s.contraction, s.outer_diameter_mm
                ));
                let power = |n: u8| format!("^{{{n}}}");
                let product = |powers| match name(powers, &["x", "p", "e", "d"], power).as_str() {
                    "1" => String::new(),
                    text => format!("\\,{text}"),
                };
                for (i, three) in t.terms.chunks(3).enumerate() {
                    let line = sum(three.iter().map(|t| (t.value, product(t.powers))));
                    let start = match i {
                        0 => "\\frac{F}{D_0^2} &= ",
                        _ if line.starts_with('-') => "&\\quad ",
                        _ => NEXT,
                    };
                    lines.push(format!("{start}{line}"));
                }
            }
        }
        display(lines)
    }
}

/// The start of a line that goes on with a sum.
const NEXT: &str = "&\\quad + ";

/// The lines of an equation as a display of LaTeX.
pub fn display(lines: Vec<String>) -> String {
    let lines = lines.join("\\\\\n");
    format!("\\begin{{align*}}\n{lines}\n\\end{{align*}}\n")
}

fn sum(parts: impl Iterator<Item = (f64, String)>) -> String {
    let mut out = String::new();
    for (i, (value, factor)) in parts.enumerate() {
        let sign = match (i, value < 0.0) {
            (0, true) => "-",
            (0, false) => "",
            (_, true) => " - ",
            (_, false) => " + ",
        };
        out.push_str(&format!("{sign}{}{factor}", digits(value.abs())));
    }
    if out.is_empty() { "0".into() } else { out }
}
