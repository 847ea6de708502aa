//! Sketches for the steps: an end in section, and the frame of the proof test.

use crate::{
    Plan,
    build_sheet::FACES_MM,
    drawing::{Body, clamps, on_plug},
    view::View,
};
use mckibben_report::{Anchor, FigureError, Pen, Sheet};

const PAPER_MM: (f64, f64) = (170.0, 62.0);
const NOTE_MM: f64 = 2.3;
/// Free length in mm on paper that the sketch of an end shows.
const FREE_MM: f64 = 40.0;

fn sheet(what: &str) -> Sheet {
    Sheet::new(what.into(), PAPER_MM.0, PAPER_MM.1)
}

/// An end: plug, tube, sleeve and clamps, and where the free length begins.
pub fn end(plan: &Plan) -> Result<String, FigureError> {
    let body = Body::new(plan);
    let plug = &plan.eye_plug;
    let length_mm = plug.length_mm - plug.stem.datum_mm;
    let scale = (110.0 / length_mm).min(18.0 / body.widest);
    let mut sheet = sheet("An end in section");
    let mut v = View {
        sheet: &mut sheet,
        origin: [FREE_MM + 4.0 - scale * body.half, 26.0],
        scale,
    };
    let [ri, ro] = [
        plan.muscle.inner_diameter_mm(),
        plan.muscle.outer_diameter_mm(),
    ]
    .map(|d| 0.5 * d);
    let x = (body.half - FREE_MM / scale, body.half);
    v.cut(x, (ri, ro), true);
    v.cut(x, (ro, body.sleeve), false);
    on_plug(&body, &mut v, 1.0);
    v.plug(plug, body.half, 1.0, false);
    clamps(&body, &mut v, true);
    v.line(
        Pen::Axis,
        &[[x.0, 0.0], [body.half + length_mm + 4.0 / scale, 0.0]],
    );
    let row = scale * body.widest + 5.0;
    let bare = |mm: f64| plan.shown.bare(mm);
    let on_plug_mm = bare(plan.muscle.insertion_mm());
    let clamped = body.clamped;
    v.across((body.half, body.end), (clamped, clamped), row, &on_plug_mm);
    let faces = format!(
        "to the other head: {} ± {}",
        bare(plan.faces_mm(0.0)),
        plan.shown.tolerance(FACES_MM)
    );
    v.across((x.0, body.end), (clamped, clamped), row + 7.0, &faces);
    let note = "L₀ ends at the barb or the first groove, within 1 mm of the first tie or clamp";
    sheet.text([4.0, 3.0], NOTE_MM, Anchor::Start, note);
    sheet.to_svg()
}

/// The muscle in the frame that holds its length, with the air plug above.
pub fn frame(plan: &Plan) -> Result<String, FigureError> {
    let mut sheet = sheet("Proof test with the length held");
    let (left, right, y) = (40.0, 130.0, 32.0);
    for rod in [14.0, 50.0] {
        sheet.line(Pen::Outline, [[left - 9.0, rod], [right + 9.0, rod]]);
    }
    let mut rectangle = |x: [f64; 2], y: [f64; 2]| {
        let corners = [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
        sheet.outline(Pen::Outline, corners);
    };
    rectangle([left, right], [y - 4.0, y + 4.0]);
    for (head, out) in [(left, -1.0), (right, 1.0)] {
        rectangle([head, head + 17.0 * out], [y - 5.0, y + 5.0]);
        // A slotted bar; the bolt bears on its outer face.
        for cheek in [[y - 22.0, y - 5.0], [y + 5.0, y + 22.0]] {
            rectangle([head + 3.0 * out, head + 9.0 * out], cheek);
        }
    }
    for bolt in [left - 11.2, right + 11.2] {
        sheet.circle(Pen::Outline, [bolt, y], 2.2);
    }
    let mut v = View {
        sheet: &mut sheet,
        origin: [left, y],
        scale: 1.0,
    };
    let faces = format!("{} held", plan.shown.bare(plan.faces_mm(0.0)));
    v.across((0.0, right - left), (4.0, 4.0), 10.0, &faces);
    let bears = plan.shown.force(2.0 * plan.proof_load_n);
    let note = format!(
        "steel frame for {bears}; the bolts bear on its outer faces; {} at the proof pressure",
        plan.shown.force(plan.proof_load_n)
    );
    sheet.text([4.0, 4.0], NOTE_MM, Anchor::Start, note);
    sheet.to_svg()
}
