//! A technical drawing as DXF (Release 12, which every CAD program reads), one layer for each kind of line.

use super::{Anchor, Item, Pen, Sheet};
use std::fmt::Write as _;

impl Pen {
    /// Name of its layer, its colour in the palette of CAD programs, its line type.
    fn layer(self) -> (&'static str, u8, &'static str) {
        match self {
            Self::Outline => ("OUTLINE", 7, "CONTINUOUS"),
            Self::Thin => ("THIN", 8, "CONTINUOUS"),
            Self::Axis => ("AXIS", 1, "CENTER"),
        }
    }
}

/// The layer of texts.
const TEXTS: &str = "TEXT";

impl Sheet {
    /// The drawing as DXF with all lengths times `factor`: the reciprocal of the drawing's scale gives a body its true size in mm. The first
    /// line is `comment`.
    pub fn to_dxf(&self, factor: f64, comment: &str) -> String {
        let mut out = Codes(String::new());
        out.add(999, ascii(comment));
        out.add(0, "SECTION").add(2, "HEADER").add(9, "$ACADVER").add(1, "AC1009");
        out.add(9, "$EXTMIN").place(10, [0.0, 0.0], factor);
        out.add(9, "$EXTMAX").place(10, [self.width_mm, self.height_mm], factor);
        out.add(9, "$LTSCALE").number(40, factor).add(0, "ENDSEC");
        out.add(0, "SECTION").add(2, "TABLES").add(0, "TABLE").add(2, "LTYPE").add(70, "2");
        out.line_type("CONTINUOUS", "solid", &[]);
        out.line_type("CENTER", "long and short dashes", Pen::Axis.dashes_mm());
        out.add(0, "ENDTAB").add(0, "TABLE").add(2, "LAYER").add(70, "4");
        for (name, colour, line) in Pen::ALL.map(Pen::layer).into_iter().chain([(TEXTS, 7, "CONTINUOUS")]) {
            out.add(0, "LAYER").add(2, name).add(70, "0").add(62, colour.to_string()).add(6, line);
        }
        out.add(0, "ENDTAB").add(0, "ENDSEC").add(0, "SECTION").add(2, "ENTITIES");
        self.items.iter().for_each(|item| out.item(item, factor));
        out.add(0, "ENDSEC").add(0, "EOF");
        out.0
    }
}

/// Pairs of a group code and a value, a line each.
struct Codes(String);

impl Codes {
    fn add(&mut self, code: u16, value: impl AsRef<str>) -> &mut Self {
        // Writing into a string does not fail.
        let _ = writeln!(self.0, "{code:>3}\n{}", value.as_ref());
        self
    }

    fn number(&mut self, code: u16, value: f64) -> &mut Self {
        // A place that is no number is refused where the sheet is drawn as SVG.
        let value = if value.is_finite() { value } else { 0.0 };
        self.add(code, format!("{value:.6}"))
    }

    fn place(&mut self, code: u16, [x, y]: [f64; 2], factor: f64) -> &mut Self {
        self.number(code, x * factor).number(code + 10, y * factor)
    }

    fn line_type(&mut self, name: &str, about: &str, dashes: &[f64]) {
        self.add(0, "LTYPE").add(2, name).add(70, "0").add(3, about).add(72, "65");
        self.add(73, dashes.len().to_string()).number(40, dashes.iter().sum());
        // Dashes are above zero, gaps below.
        for (i, length) in dashes.iter().enumerate() {
            self.number(49, if i % 2 == 0 { *length } else { -length });
        }
    }

    fn item(&mut self, item: &Item, factor: f64) {
        match item {
            Item::Line { points, pen } => {
                for pair in points.windows(2) {
                    self.add(0, "LINE").add(8, pen.layer().0);
                    self.place(10, pair[0], factor).place(11, pair[1], factor);
                }
            }
            Item::Fill { points } => {
                // A fan of triangles, whose last corner counts twice.
                for i in 1..points.len().saturating_sub(1) {
                    self.add(0, "SOLID").add(8, Pen::Thin.layer().0);
                    for (code, corner) in [(10, 0), (11, i), (12, i + 1), (13, i + 1)] {
                        self.place(code, points[corner], factor);
                    }
                }
            }
            Item::Circle { centre, radius_mm, pen } => {
                self.add(0, "CIRCLE").add(8, pen.layer().0);
                self.place(10, *centre, factor).number(40, radius_mm * factor);
            }
            Item::Text { at, height_mm, text, anchor, upright } => {
                self.add(0, "TEXT").add(8, TEXTS).place(10, *at, factor);
                self.number(40, height_mm * factor).add(1, ascii(text));
                self.number(50, if *upright { 90.0 } else { 0.0 });
                let side = match anchor {
                    Anchor::Start => return,
                    Anchor::Middle => "1",
                    Anchor::End => "2",
                };
                self.add(72, side).place(11, *at, factor);
            }
        }
    }
}

/// A text of a line in the characters of Release 12.
fn ascii(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '°' => out.push_str("%%d"),
            '⌀' | 'Ø' => out.push_str("%%c"),
            '±' => out.push_str("%%p"),
            '−' | '–' => out.push('-'),
            '×' => out.push('x'),
            '₀' => out.push('0'),
            'θ' => out.push_str("theta"),
            c if c.is_control() => out.push(' '),
            c if c.is_ascii() => out.push(c),
            // Writing into a string does not fail.
            c => drop(write!(out, "\\U+{:04X}", u32::from(c))),
        }
    }
    out
}
