//! The sheets: A4 with a frame and a title block, and the scales in use.

use crate::{
    Plan,
    text::{mm, significant, trimmed},
};
use mckibben_report::{Anchor, Pen, Sheet};

/// A4 across, and the frame on it (ISO 5457): left, bottom, right, top.
const PAPER_MM: (f64, f64) = (297.0, 210.0);
pub const FRAME_MM: [f64; 4] = [20.0, 10.0, 287.0, 200.0];
/// Left edge and top of the title block.
pub const TITLE_MM: (f64, f64) = (157.0, 40.0);
/// Scales in use (ISO 5455).
const SCALES: [f64; 12] = [
    5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001,
];

/// The largest scale at which something fits.
pub fn largest(fits: impl Fn(f64) -> bool) -> f64 {
    SCALES
        .into_iter()
        .find(|s| fits(*s))
        .unwrap_or(SCALES[SCALES.len() - 1])
}

/// `1:2`, `5:1`.
pub fn ratio(scale: f64) -> String {
    if scale >= 1.0 {
        format!("{}:1", trimmed(scale, 0))
    } else {
        format!("1:{}", trimmed(1.0 / scale, 0))
    }
}

/// An empty sheet of the two of a build, with frame and title block.
pub fn sheet(plan: &Plan, what: &str, number: u32, scale: f64) -> Sheet {
    let size = format!(
        "⌀{} × {} mm",
        mm(plan.muscle.outer_diameter_mm()),
        mm(plan.muscle.length_mm())
    );
    let mut sheet = Sheet::new(format!("{what} {size}"), PAPER_MM.0, PAPER_MM.1);
    let [left, bottom, right, top] = FRAME_MM;
    sheet.outline(
        Pen::Outline,
        [[left, bottom], [right, bottom], [right, top], [left, top]],
    );
    let (left, top) = TITLE_MM;
    sheet.outline(
        Pen::Outline,
        [[left, bottom], [right, bottom], [right, top], [left, top]],
    );
    let rows = [bottom + 8.0, bottom + 16.0];
    rows.iter()
        .for_each(|y| sheet.line(Pen::Thin, [[left, *y], [right, *y]]));
    let columns = [left + 30.0, left + 70.0, left + 105.0];
    columns
        .iter()
        .for_each(|x| sheet.line(Pen::Thin, [[*x, bottom], [*x, rows[1]]]));
    sheet.text([left + 3.0, top - 6.5], 4.0, Anchor::Start, what);
    sheet.text([left + 3.0, top - 12.0], 3.0, Anchor::Start, size);
    let version = concat!("mckibben ", env!("CARGO_PKG_VERSION"));
    let mass = format!("{} g", significant(plan.mass_g(), 3));
    let cells = [
        (left, rows[0], "scale", ratio(scale)),
        (columns[0], rows[0], "lengths", "mm, ±0.5".into()),
        (columns[1], rows[0], "mass (known parts)", mass),
        (columns[2], rows[0], "sheet", format!("{number}/2")),
        (left, bottom, "format", "A4".into()),
        (columns[0], bottom, "drawn by", version.into()),
        (columns[1], bottom, "checked", String::new()),
        (columns[2], bottom, "date", String::new()),
    ];
    for (x, y, head, text) in cells {
        sheet.text([x + 1.0, y + 5.6], 1.6, Anchor::Start, head);
        sheet.text([x + 1.5, y + 1.5], 2.5, Anchor::Start, text);
    }
    sheet
}
