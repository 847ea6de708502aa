//! Sketches for the steps: an end in section, and the frame of the proof test.

use crate::{
    Plan,
    build_sheet::FACES_MM,
    drawing::{MuscleBody, clamps, on_plug},
    view::View,
};
use mckibben_core::analysis::STRETCH;
use mckibben_report::{
    Anchor::Start,
    DrawingSheet,
    Pen::{Axis, Outline},
};

const PAPER_MM: (f64, f64) = (170.0, 62.0);
const NOTE_MM: f64 = 2.3;
/// Free length in mm on paper that the sketch of an end shows.
const FREE_MM: f64 = 40.0;

fn sheet(what: &str) -> DrawingSheet {
    DrawingSheet::new(what.into(), PAPER_MM.0, PAPER_MM.1)
}

/// An end: plug, tube, sleeve and clamps, and where the free length begins.
pub fn end(plan: &Plan) -> DrawingSheet {
    let body = MuscleBody::new(plan);
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
        Axis,
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
    sheet.text([4.0, 3.0], NOTE_MM, Start, note);
    sheet
}

/// The muscle in the frame that holds its length, with the air plug above.
pub fn frame(plan: &Plan) -> DrawingSheet {
    let mut sheet = sheet("Proof test with the length held");
    let (left, right, y) = (40.0, 130.0, 32.0);
    for rod in [14.0, 50.0] {
        sheet.line(Outline, [[left - 16.0, rod], [right + 16.0, rod]]);
    }
    sheet.rectangle(Outline, [left, right], [y - 4.0, y + 4.0]);
    for (head, out) in [(left, -1.0), (right, 1.0)] {
        let x = |from: f64, to: f64| [head + from * out, head + to * out];
        sheet.rectangle(Outline, x(0.0, 17.0), [y - 5.0, y + 5.0]);
        // A slotted bar; the bolt bears on its outer face, a nut on each rod does too.
        for cheek in [[-22.0, -5.0], [5.0, 22.0]] {
            sheet.rectangle(Outline, x(3.0, 9.0), cheek.map(|c| y + c));
        }
        for rod in [-18.0, 18.0] {
            sheet.rectangle(Outline, x(9.0, 12.0), [y + rod - 2.5, y + rod + 2.5]);
        }
        sheet.circle(Outline, [head + 11.2 * out, y], 2.2);
    }
    let mut v = View {
        sheet: &mut sheet,
        origin: [left, y],
        scale: 1.0,
    };
    let [held, stretched] = [0.0, -STRETCH].map(|e| plan.shown.bare(plan.faces_mm(e)));
    let faces = format!("{held} held, then {stretched}");
    v.across((0.0, right - left), (4.0, 4.0), 10.0, &faces);
    let note = format!(
        "the bolts bear on the outer faces, the nuts stretch the muscle under pressure; {} at most",
        plan.shown.force(plan.loads.proof_end_load_high_n)
    );
    sheet.text([4.0, 4.0], NOTE_MM, Start, note);
    sheet
}
