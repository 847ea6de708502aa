//! Sheets as wide as the text of a page: scales in use, and a sheet for each plug with its section, its
//! end and its measures.

use crate::{
    Plan,
    plug::Plug,
    sold::first,
    stem::{RIB_MM, RIBS_END_MM},
    text::{mm, significant, trimmed},
    view::View,
};
use mckibben_report::{
    Anchor::Start,
    DrawingSheet, Part,
    Pen::{Axis, Outline},
};

/// Width in mm of the text of a page.
pub const WIDTH_MM: f64 = 175.0;
/// Room for section and end beside each other, and for their height, in mm.
const ROOM_MM: [f64; 2] = [142.0, 60.0];
/// Scales in use (ISO 5455).
const SCALES: [f64; 12] = [
    5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001,
];

/// The largest scale at which something fits.
pub fn largest(fits: impl Fn(f64) -> bool) -> f64 {
    first(&SCALES, fits)
}

/// An empty sheet that says below what it shows, and what holds for all its dimensions.
pub fn sheet(plan: &Plan, what: &str, scale: f64, height_mm: f64) -> DrawingSheet {
    let mut sheet = DrawingSheet::new(what.to_owned(), WIDTH_MM, height_mm);
    let given = |name: &str| {
        let field = plan.title_block.iter().find(|(field, _)| field == name);
        field.map_or("", |(_, text)| text)
    };
    let [over, under] = [scale.max(1.0), (1.0 / scale).max(1.0)].map(|n| trimmed(n, 0));
    let words = format!(
        "{what}   {over}:{under}   {}, ISO 2768-m, first angle   {} {}",
        plan.shown.length.name,
        given("document no."),
        given("revision")
    );
    sheet.text([0.0, 1.0], 2.1, Start, words);
    sheet
}

/// The drawing of a plug, and what it does not show.
pub fn plug(plan: &Plan, what: &str, plug: &Plug) -> [Part; 3] {
    let wide = plug.widest_mm();
    let scale = largest(|s| s * (plug.length_mm + wide) <= ROOM_MM[0] && s * wide <= ROOM_MM[1]);
    let mass = significant(plug.mass_g(), 3);
    let title = format!("{what}, {}, {mass} g", plug.stock());
    let height = scale * wide + 46.0;
    let mut view = View {
        sheet: sheet(plan, &title, scale, height),
        origin: [6.0 + 0.5 * scale * wide, 22.0 + 0.5 * scale * wide],
        scale,
    };
    end(plan, plug, &mut view);
    view.origin[0] += 0.5 * scale * wide + 24.0;
    section(plan, plug, &mut view);
    [
        Part::Drawing(view.sheet),
        turned(plan, plug),
        Part::List(notes(plan, plug)),
    ]
}

fn section(plan: &Plan, plug: &Plug, v: &mut View) {
    let stem = &plug.stem;
    v.plug(plug, stem.datum_mm, 1.0);
    let beyond = 4.0 / v.scale;
    v.line(Axis, &[[-beyond, 0.0], [plug.length_mm + beyond, 0.0]]);
    let (half, radius) = (0.5 * plug.widest_mm(), 0.5 * stem.diameter_mm);
    let side = 0.5 * plug.side_mm;
    let row = v.scale * half + 6.0;
    let port = plug.port.map(|port| (port.height_mm, half));
    let collar = plug.collar_mm.map(|_| (plug.foot_mm, half));
    let below = collar.into_iter().chain(port).collect();
    let above = vec![
        (stem.length_mm, half),
        (plug.eye_mm, 0.0),
        (plug.length_mm, side),
    ];
    for (up, measures) in [(1.0, above), (-1.0, below)] {
        for (i, (mm, to)) in measures.into_iter().enumerate() {
            let row = up * (row + 7.0 * i as f64);
            let text = plan.shown.bare(mm);
            v.across((0.0, mm), (up * radius, up * to), row, &text);
        }
    }
    let [diameter, tolerance] =
        [stem.diameter_mm, plug.tolerance_mm()].map(|mm| plan.shown.exact(mm));
    let fit = format!("⌀{diameter} ±{tolerance}");
    v.beside((-radius, radius), 0.0, -9.0, &fit);
}

/// Diameters of the stem along it, up to the first rib of a shoulder and the corner at the head.
fn turned(plan: &Plan, plug: &Plug) -> Part {
    let exact = |mm: f64| plan.shown.exact(mm);
    let corners = plug.stem.corners();
    let row = |name: &str, k: usize, times: f64| {
        let cells = corners.iter().map(|corner| exact(times * corner[k]));
        [name.to_owned()].into_iter().chain(cells).collect()
    };
    Part::table(&[], vec![row("from its end", 1, 1.0), row("⌀", 0, 2.0)])
}

/// The plug as seen from its head.
fn end(plan: &Plan, plug: &Plug, v: &mut View) {
    let half = 0.5 * plug.side_mm;
    v.rectangle([-half, half], [-half, half]);
    let reach = 0.5 * plug.widest_mm() + 2.5 / v.scale;
    v.line(Axis, &[[-reach, 0.0], [reach, 0.0]]);
    v.line(Axis, &[[0.0, -reach], [0.0, reach]]);
    let text = format!("□{}", plan.shown.bare(plug.side_mm));
    let row = 0.5 * v.scale * plug.widest_mm() + 6.0;
    v.across((-half, half), (half, half), row, &text);
    if let Some(collar) = plug.collar_mm {
        v.sheet.circle(Outline, v.origin, 0.5 * collar * v.scale);
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
        "what is not dimensioned: by the STL file"
    } else {
        "turned, head milled; stem Ra 1.6, all else Ra 3.2; stem and passage concentric to 0.1; corner \
         at the head R 0.8 at most; edges broken 0.2"
    };
    let [bore, wider] = [stem.bore_mm(), stem.interference_mm].map(|mm| plan.shown.exact(mm));
    let hole = format!(
        "hole {} for the bolt M{} (ISO 273 medium), across the head",
        mm(plug.hole_mm),
        mm(plug.bolt.mm),
    );
    let ribs = stem.shoulder_mm.map(|_| {
        let [pitch, end] = [RIB_MM.0, RIBS_END_MM].map(bare);
        format!("ribs like the first one every {pitch}, up to {end} from the head")
    });
    [
        Some(format!(
            "stem {wider} wider than the bore of the tube, {bore}"
        )),
        ribs,
        Some(hole),
        port,
        Some(made.into()),
    ]
    .into_iter()
    .flatten()
    .collect()
}
