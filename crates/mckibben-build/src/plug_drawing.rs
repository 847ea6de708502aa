//! The drawings of the plugs: a sheet for each, with its section, its end and its measures.

use crate::{
    Plan,
    frame::{self, FRAME_MM, Title, largest},
    plug::Plug,
    text::mm,
    view::View,
};
use mckibben_report::{
    Anchor, DrawingSheet,
    Pen::{Axis, Outline},
};

/// Room for section and end beside each other, and for their height, in mm.
const ROOM_MM: (f64, f64) = (185.0, 80.0);
const NOTES_MM: f64 = 2.3;

/// The sheet of a plug.
pub fn on_paper(plan: &Plan, what: &str, plug: &Plug, number: usize) -> DrawingSheet {
    let wide = plug.widest_mm();
    let scale = largest(|s| s * (plug.length_mm + wide) <= ROOM_MM.0 && s * wide <= ROOM_MM.1);
    let title = Title {
        what,
        material: plug.material.name,
        mass_g: plug.mass_g(),
        number: (number, 3),
        scale,
    };
    let mut sheet = frame::sheet(plan, &title);
    let [left, _, right, top] = FRAME_MM;
    let y = 0.5 * (top + 60.0);
    let mut view = View {
        sheet: &mut sheet,
        origin: [left + 40.0, y],
        scale,
    };
    section(plan, plug, &mut view);
    let mut end = View {
        sheet: &mut sheet,
        origin: [right - 14.0 - 0.5 * scale * wide, y],
        scale,
    };
    from_the_stem(plan, plug, &mut end);
    for (i, note) in notes(plan, plug).iter().enumerate() {
        let at = [left + 6.0, 52.0 - 4.8 * i as f64];
        sheet.text(at, NOTES_MM, Anchor::Start, note);
    }
    sheet
}

fn section(plan: &Plan, plug: &Plug, v: &mut View<'_>) {
    let stem = &plug.stem;
    let bare = |mm: f64| plan.shown.bare(mm);
    v.plug(plug, stem.datum_mm, 1.0, true);
    let beyond = 4.0 / v.scale;
    v.line(Axis, &[[-beyond, 0.0], [plug.length_mm + beyond, 0.0]]);
    let (half, radius) = (0.5 * plug.widest_mm(), 0.5 * stem.diameter_mm);
    let above = v.scale * half + 6.0;
    v.across(
        (0.0, stem.length_mm),
        (radius, half),
        above,
        &bare(stem.length_mm),
    );
    v.across(
        (0.0, plug.eye_mm),
        (radius, 0.0),
        above + 7.0,
        &bare(plug.eye_mm),
    );
    v.across(
        (0.0, plug.length_mm),
        (radius, half),
        above + 14.0,
        &bare(plug.length_mm),
    );
    if let Some(port) = plug.port {
        v.across(
            (0.0, port.height_mm),
            (-radius, 0.0),
            -above,
            &bare(port.height_mm),
        );
    }
    let [diameter, tolerance] =
        [stem.diameter_mm, plug.tolerance_mm()].map(|mm| plan.shown.exact(mm));
    let fit = format!("⌀{diameter} ±{tolerance}");
    v.beside((-radius, radius), 0.0, -9.0, &fit);
    for (i, band) in stem.bands_mm.iter().enumerate() {
        let row = -above - 7.0 * (i + 1) as f64;
        let text = format!("seat {}", bare(band[1] - band[0]));
        v.across((band[0], band[1]), (-radius, -radius), row, &text);
    }
    if let Some([diameter, from]) = stem.shoulder_mm {
        let row = -above - 7.0 * (stem.bands_mm.len() + 1) as f64;
        let text = format!("shoulder ⌀{} from {}", bare(diameter), bare(from));
        v.across((from, stem.length_mm), (-0.5 * diameter, -half), row, &text);
    }
}

/// The plug as seen from its stem.
fn from_the_stem(plan: &Plan, plug: &Plug, v: &mut View<'_>) {
    let half = 0.5 * plug.side_mm;
    v.outline(
        Outline,
        &[[-half, -half], [half, -half], [half, half], [-half, half]],
    );
    v.circle(Outline, plug.stem.widest_mm());
    if let Some(port) = plug.port {
        v.circle(Outline, port.passage_mm);
    }
    let reach = half + 2.5 / v.scale;
    v.line(Axis, &[[-reach, 0.0], [reach, 0.0]]);
    v.line(Axis, &[[0.0, -reach], [0.0, reach]]);
    let text = format!("□{}", plan.shown.bare(plug.side_mm));
    let row = 0.5 * v.scale * plug.widest_mm() + 6.0;
    v.across((-half, half), (half, half), row, &text);
    if let Some(collar) = plug.collar_mm {
        v.circle(Outline, collar);
        let text = format!("⌀{}", plan.shown.bare(collar));
        v.across((-0.5 * collar, 0.5 * collar), (0.0, 0.0), row + 7.0, &text);
    }
}

fn notes(plan: &Plan, plug: &Plug) -> Vec<String> {
    let stem = &plug.stem;
    let bare = |mm: f64| plan.shown.bare(mm);
    let port = plug.port.map(|port| {
        let (thread, deep) = (port.fitting, bare(port.thread_mm));
        format!(
            "{thread}: drill {} to {}, thread {deep} deep; passage {}",
            mm(port.hole_mm),
            bare(port.depth_mm),
            bare(port.passage_mm)
        )
    });
    let made = if plug.is_printed() {
        [
            "Print solid, standing on the end of the head",
            "Seal the surface of the stem with epoxy resin",
            "What is not dimensioned: by the STL file",
        ]
    } else {
        [
            "Turned, head milled; stem Ra 1.6, all else Ra 3.2",
            "Corner of the stem R 0.8; edges broken 0.2",
            "What is not dimensioned: by the STEP file",
        ]
    };
    [
        Some(format!(
            "Bolt M{}, {}: hole {} (ISO 273 medium), across the head",
            mm(plug.bolt.mm),
            plug.bolt.class,
            mm(plug.hole_mm)
        )),
        port,
        Some(format!(
            "Stem: {} and an interference of {}",
            plan.shown.exact(stem.bore_mm()),
            plan.shown.exact(stem.interference_mm)
        )),
        plug.collar_mm
            .map(|_| format!("Collar {} thick", bare(plug.foot_mm - stem.length_mm))),
        stem.shoulder_mm
            .map(|_| "Shoulder with ribs every 3, 0.4 deep, sides 45°".into()),
    ]
    .into_iter()
    .flatten()
    .chain(made.map(String::from))
    .collect()
}
