//! The sheets: A4 with a frame and a title block, and the scales in use.

use crate::{
    Plan,
    text::{significant, trimmed},
};
use mckibben_report::{
    Anchor::Start,
    DrawingSheet,
    Pen::{Axis, Outline, Thin},
};

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

/// What a sheet shows.
pub struct Title<'a> {
    pub what: &'a str,
    pub material: &'a str,
    pub mass_g: f64,
    /// Number of the sheet, and of all.
    pub number: (usize, usize),
    pub scale: f64,
}

/// An empty sheet with frame and title block.
pub fn sheet(plan: &Plan, title: &Title<'_>) -> DrawingSheet {
    let size = format!(
        "⌀{} × {} {}",
        plan.shown.bare(plan.muscle.outer_diameter_mm()),
        plan.shown.bare(plan.muscle.length_mm()),
        plan.shown.length.name
    );
    let mut sheet = DrawingSheet::new(format!("{} {size}", title.what), PAPER_MM.0, PAPER_MM.1);
    let [left, bottom, right, top] = FRAME_MM;
    sheet.rectangle(Outline, [left, right], [bottom, top]);
    let (left, top) = TITLE_MM;
    sheet.rectangle(Outline, [left, right], [bottom, top]);
    let rows = [bottom, bottom + 8.0, bottom + 16.0];
    let columns = [left, left + 30.0, left + 76.0, left + 104.0];
    for y in &rows[1..] {
        sheet.line(Thin, [[left, *y], [right, *y]]);
    }
    for x in &columns[1..] {
        sheet.line(Thin, [[*x, bottom], [*x, rows[2]]]);
    }
    let given = |name: &str| {
        let field = plan.title_block.iter().find(|(field, _)| field == name);
        field.map_or("", |(_, text)| text)
    };
    let name = match given("muscle") {
        "" => String::new(),
        name => format!(": {name}"),
    };
    sheet.text(
        [left + 3.0, top - 6.0],
        3.5,
        Start,
        format!("{}{name}", title.what),
    );
    sheet.text([left + 3.0, top - 12.0], 2.5, Start, size);
    projection(&mut sheet, [right - 18.0, top - 7.0]);
    let unit = plan.shown.length.name;
    let cells = [
        ("scale", ratio(title.scale)),
        ("material", title.material.into()),
        ("mass", format!("{} g", significant(title.mass_g, 3))),
        ("sheet", format!("{}/{}", title.number.0, title.number.1)),
        (
            "document, revision",
            format!("{} {}", given("document no."), given("revision")),
        ),
        ("tolerances", format!("{unit}, ISO 2768-m")),
        (
            "drawn by",
            concat!("mckibben ", env!("CARGO_PKG_VERSION")).into(),
        ),
        ("date", given("date").into()),
    ];
    for (i, (head, text)) in cells.into_iter().enumerate() {
        let (x, y) = (columns[i % 4], rows[1 - i / 4]);
        sheet.text([x + 1.0, y + 5.4], 1.8, Start, head);
        sheet.text([x + 1.5, y + 1.5], 2.2, Start, text);
    }
    sheet
}

/// The symbol of the first-angle projection (ISO 5456-2).
fn projection(sheet: &mut DrawingSheet, [x, y]: [f64; 2]) {
    let cone = [[0.0, -1.25], [6.0, -2.5], [6.0, 2.5], [0.0, 1.25]];
    sheet.outline(Thin, cone.map(|[a, b]| [x + a, y + b]));
    for radius in [1.25, 2.5] {
        sheet.circle(Thin, [x + 12.0, y], radius);
    }
    sheet.line(Axis, [[x - 1.5, y], [x + 15.5, y]]);
}
