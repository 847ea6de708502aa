//! The drawing of the plugs: both in section, with their measures.

use crate::{
    Fitting, Plan, Stem,
    frame::{self, FRAME_MM, largest},
    text::mm,
    view::{SMALL_MM, View, diameter},
};
use mckibben_report::{Anchor, Pen, Sheet};

/// Room for both plugs side by side, and for the higher one, in mm.
const ROOM_MM: (f64, f64) = (165.0, 70.0);

/// The drawing on paper; all bodies have one scale.
pub fn on_paper(plan: &Plan) -> Sheet {
    let air = &plan.air_plug;
    let eye = &plan.eye_plug;
    let head = air
        .head()
        .iter()
        .map(|p| 2.0 * p[0])
        .fold(air.stem.collar_diameter_mm, f64::max);
    let scale =
        largest(|s| s * (air.length_mm() + eye.length_mm()) <= ROOM_MM.0 && s * head <= ROOM_MM.1);
    let mut sheet = frame::sheet(plan, "Plugs of the muscle", 2, scale);
    let [left, _, right, top] = FRAME_MM;
    let widths = [scale * air.length_mm(), scale * eye.length_mm()];
    let y = 0.5 * (top + 66.0) - 4.0;
    let gap = (right - left - widths[0] - widths[1]) / 3.0;
    let places = [left + gap, left + 2.0 * gap + widths[0]];

    let plugs = ["3  air plug", "4  eye plug"]
        .into_iter()
        .zip([air_plug, eye_plug]);
    for (x, (name, draw)) in places.into_iter().zip(plugs) {
        let mut view = View {
            sheet: &mut sheet,
            origin: [x, y],
            scale,
        };
        let about = draw(plan, &mut view);
        names(&mut view, head, &[name, &about]);
    }
    let stem = &air.stem;
    let notes = [
        format!(
            "Stem: bore {} and {}",
            mm(stem.bore_mm()),
            mm(stem.interference_mm)
        ),
        format!(
            "Grooves {} wide, {} deep, sides at 45°",
            mm(stem.groove_width_mm),
            mm(stem.groove_depth_mm)
        ),
        if plan.is_printed() {
            "Print solid; seal the surface"
        } else {
            "Turn from metal"
        }
        .into(),
    ];
    for (i, note) in notes.iter().enumerate() {
        sheet.text(
            [left + 6.0, 34.0 - 5.2 * i as f64],
            SMALL_MM,
            Anchor::Start,
            note,
        );
    }
    sheet
}

/// Draws the air plug, and says what it has.
fn air_plug(plan: &Plan, v: &mut View<'_>) -> String {
    let air = &plan.air_plug;
    for sign in [-1.0, 1.0] {
        let section = across(air.profile(), sign);
        v.outline(Pen::Outline, &section);
        v.hatch(&[section], sign > 0.0);
    }
    // Edges that one sees behind the section.
    let mut behind = vec![0.0, air.length_mm()];
    behind.extend(air.head().iter().skip(2).map(|p| p[1]));
    for x in behind {
        let inner = if x == 0.0 {
            0.5 * air.passage_mm
        } else {
            hole_at(plan, x)
        };
        v.line(Pen::Outline, &[[x, -inner], [x, inner]]);
    }
    stem(v, &air.stem, air.length_mm());
    let passage = diameter(air.passage_mm);
    match (air.fitting, air.fitting.thread_mm()) {
        (thread, Some((drill, depth, boss))) => {
            format!(
                "{thread}: hole {}, {} deep; boss {}; passage {passage}",
                diameter(drill),
                mm(depth),
                diameter(boss),
            )
        }
        (Fitting::Barb { bore_mm }, _) => {
            format!(
                "barb {} for a hose with a bore of {}; passage {passage}",
                diameter(1.2 * bore_mm),
                mm(bore_mm),
            )
        }
        // Threads are above.
        _ => String::new(),
    }
}

/// Draws the eye plug, and says what it has.
fn eye_plug(plan: &Plan, v: &mut View<'_>) -> String {
    let eye = &plan.eye_plug;
    let top = eye.stem.top_mm();
    let mut all = across(eye.stem.profile(), 1.0);
    all.extend(across(eye.stem.profile(), -1.0).into_iter().rev());
    v.outline(Pen::Outline, &all);
    v.hatch(&[all], true);
    v.eye(eye, top, 0.7);
    stem(v, &eye.stem, eye.length_mm());
    let half = 0.5 * eye.stem.collar_diameter_mm;
    v.across(
        (top, top + eye.centre_mm),
        (-half, -0.5 * eye.width_mm),
        -(v.scale * half + 6.0),
        &mm(eye.centre_mm),
    );
    format!(
        "eye for M{}: hole {}, {} wide, {} thick",
        mm(eye.bolt_mm),
        diameter(eye.hole_mm),
        mm(eye.width_mm),
        mm(eye.thickness_mm)
    )
}

/// A profile of radius and height on one side of the horizontal axis of the sheet.
fn across(profile: Vec<[f64; 2]>, sign: f64) -> Vec<[f64; 2]> {
    profile.into_iter().map(|[r, z]| [z, sign * r]).collect()
}

/// Radius of the hole of the air plug at the edges of its section, in mm.
fn hole_at(plan: &Plan, x: f64) -> f64 {
    let air = &plan.air_plug;
    let inner = air
        .head()
        .into_iter()
        .skip(2)
        .filter(|p| p[1] == x)
        .map(|p| p[0]);
    match air.fitting.thread_mm() {
        Some(_) => inner.fold(0.5 * air.passage_mm, f64::max),
        None => 0.5 * air.passage_mm,
    }
}

/// The axis of a plug, and the measures of its stem.
fn stem(v: &mut View<'_>, stem: &Stem, length_mm: f64) {
    let half = 0.5 * stem.diameter_mm;
    let collar = 0.5 * stem.collar_diameter_mm;
    let beyond = 4.0 / v.scale;
    v.line(Pen::Axis, &[[-beyond, 0.0], [length_mm + beyond, 0.0]]);
    let above = v.scale * collar + 6.0;
    v.across(
        (0.0, stem.length_mm),
        (half, collar),
        above,
        &mm(stem.length_mm),
    );
    v.across(
        (stem.length_mm, stem.top_mm()),
        (collar, collar),
        above,
        &mm(stem.collar_mm),
    );
    v.across((0.0, length_mm), (half, 0.0), above + 7.0, &mm(length_mm));
    let fit = format!(
        "{} ±{}",
        diameter(stem.diameter_mm),
        mm(stem.tolerance_mm())
    );
    v.beside((-half, half), stem.bevel_mm().0, -9.0, &fit);
    for (i, start) in stem.groove_starts_mm().into_iter().enumerate() {
        v.across(
            (0.0, start),
            (-half, -half),
            -above - 6.0 * i as f64,
            &mm(start),
        );
    }
    v.beside(
        (-collar, collar),
        stem.length_mm,
        -17.0,
        &diameter(stem.collar_diameter_mm),
    );
}

/// The names of a view, below it.
fn names(v: &mut View<'_>, height_mm: f64, lines: &[&str]) {
    let y = v.origin[1] - 0.5 * v.scale * height_mm - 24.0;
    for (i, line) in lines.iter().enumerate() {
        v.sheet.text(
            [v.origin[0], y - 5.0 * i as f64],
            3.0 - 0.5 * i as f64,
            Anchor::Start,
            *line,
        );
    }
}
