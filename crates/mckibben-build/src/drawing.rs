//! The drawing: the muscle at rest, in section.

use crate::{
    Plan,
    ends::Press,
    plug::Plug,
    sheets::{self, WIDTH_MM, largest},
    text::trimmed,
    view::View,
};
use mckibben_report::{Anchor::Start, DrawingSheet, Pen::Axis};

/// Room for the muscle's length and its width, in mm on paper.
const ROOM_MM: [f64; 2] = [WIDTH_MM - 12.0, 60.0];
/// Thickness of a tie or clamp as it is drawn, in mm.
const BAND_MM: f64 = 1.2;
/// Greys of their sections.
const RUBBER: u8 = 0xc4;
const SLEEVE: u8 = 0x90;
const STEEL: u8 = 0x58;

/// The drawing of the muscle, as wide as the text of a page.
pub fn drawing(plan: &Plan) -> DrawingSheet {
    let half = 0.5 * plan.muscle.length_mm();
    let clamped = 0.5 * plan.clamped_diameter_mm;
    let widest = (clamped + BAND_MM).max(0.5 * plan.air_plug.widest_mm());
    let beyond = |plug: &Plug| half + plug.length_mm - plug.stem.datum_mm;
    let [left, right] = [&plan.air_plug, &plan.eye_plug].map(beyond);
    let size = [left + right, 2.0 * widest];
    let scale = largest(|s| s * size[0] <= ROOM_MM[0] && s * size[1] <= ROOM_MM[1]);
    let mut v = View {
        sheet: sheets::sheet(plan, &plan.title(), scale, 38.0 + scale * size[1]),
        origin: [
            0.5 * (WIDTH_MM + scale * (left - right)),
            8.0 + scale * widest,
        ],
        scale,
    };
    let [ri, ro] = [
        plan.muscle.inner_diameter_mm(),
        plan.muscle.outer_diameter_mm(),
    ]
    .map(|d| 0.5 * d);
    v.cut([-half, half], [ri, ro], RUBBER);
    v.cut([-half, half], [ro, 0.5 * plan.over_sleeve_mm], SLEEVE);
    for (plug, side) in [(&plan.air_plug, -1.0), (&plan.eye_plug, 1.0)] {
        let stem = &plug.stem;
        let at = |z: f64| side * (half + z - stem.datum_mm);
        let (from, inner) = (stem.datum_mm, 0.5 * stem.diameter_mm);
        let over = inner + plan.cut.tube_wall_mm;
        v.cut([from, from + stem.tube_mm()].map(at), [inner, over], RUBBER);
        v.cut([from, stem.length_mm].map(at), [over, clamped], SLEEVE);
        for band in stem.bands_mm.iter().chain(&stem.pressed_mm) {
            v.cut(band.map(at), [clamped, clamped + BAND_MM], STEEL);
        }
        v.plug(plug, side * half, side);
    }
    let axis = 4.0 / scale;
    v.line(Axis, &[[-left - axis, 0.0], [right + axis, 0.0]]);
    measures(plan, &mut v, widest);
    v.sheet
}

fn measures(plan: &Plan, v: &mut View, widest: f64) {
    let (muscle, operating) = (&plan.muscle, &plan.operating);
    let half = 0.5 * muscle.length_mm();
    let end = half + muscle.insertion_mm();
    let outer = 0.5 * plan.clamped_diameter_mm;
    let row = v.scale * widest + 5.0;
    let bare = |mm: f64| plan.shown.bare(mm);
    let free = format!("L₀ {}", bare(2.0 * half));
    v.across((-half, half), (outer, outer), row, &free);
    v.across((half, end), (outer, outer), row, &bare(end - half));
    let faces = format!("between the heads {}", bare(plan.faces_mm(0.0)));
    v.across((-end, end), (outer, outer), row + 7.0, &faces);
    let [bore, tube, over] = [
        muscle.inner_diameter_mm(),
        muscle.outer_diameter_mm(),
        plan.over_sleeve_mm,
    ]
    .map(bare);
    let angle = trimmed(muscle.braid().angle_deg, 1);
    let wide = bare(operating.bulged_diameter_mm.round());
    let ferrule = match plan.ends.press {
        Some(Press::Ferrule(f)) => {
            format!("; ferrules pressed to ⌀{}", bare(f.pressed_mm))
        }
        _ => String::new(),
    };
    let texts = [
        format!("Tube ⌀{tube}, bore ⌀{bore}, over the sleeve ⌀{over}, θ₀ {angle}°{ferrule}"),
        format!(
            "At {} without load ⌀{wide}",
            plan.shown.pressure(operating.pressure_mpa)
        ),
    ];
    for (i, text) in texts.into_iter().enumerate() {
        let y = v.origin[1] + row + 18.0 - 4.0 * i as f64;
        v.sheet.text([0.0, y], 2.5, Start, text);
    }
}
