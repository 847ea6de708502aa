//! The drawing: the muscle at rest, half in section, and at the working pressure.

use crate::{
    Plan,
    plug::Plug,
    sheets::{self, WIDTH_MM, largest},
    text::{percent, trimmed},
    view::View,
};
use mckibben_report::{
    Anchor::Start,
    DrawingSheet,
    Pen::{Axis, Outline, Thin},
};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Room for the muscle's length, and for both diameters together, in mm on paper.
const ROOM_MM: [f64; 2] = [WIDTH_MM - 12.0, 60.0];

/// Measures that both views need, in mm.
struct MuscleBody<'a> {
    plan: &'a Plan,
    /// Half of the free length.
    half: f64,
    /// The same to the end of the clamped length.
    end: f64,
    /// Radius over the clamped sleeve, the free one, and clamps or collar.
    clamped: f64,
    sleeve: f64,
    widest: f64,
    /// From the ends of the free length to the ends of the plugs.
    left: f64,
    right: f64,
}

/// The drawing as wide as the text of a page.
pub fn on_paper(plan: &Plan) -> DrawingSheet {
    let half = 0.5 * plan.muscle.length_mm();
    let clamped = 0.5 * plan.clamped_diameter_mm;
    let beyond = |plug: &Plug| plug.length_mm - plug.stem.datum_mm;
    let body = &MuscleBody {
        plan,
        half,
        end: half + plan.muscle.insertion_mm(),
        clamped,
        sleeve: 0.5 * plan.over_sleeve_mm,
        widest: (clamped + 1.5).max(0.5 * plan.air_plug.widest_mm()),
        left: beyond(&plan.air_plug),
        right: beyond(&plan.eye_plug),
    };
    let bulged = (0.5 * plan.operating.bulged_diameter_mm).max(body.widest);
    let size = [
        2.0 * half + body.left + body.right,
        2.0 * (body.widest + bulged),
    ];
    let scale = largest(|s| s * size[0] <= ROOM_MM[0] && s * size[1] <= ROOM_MM[1]);
    let [between, height] = [18.0, 56.0].map(|free| free + scale * size[1]);
    let mut sheet = sheets::sheet(plan, &plan.title(), scale, height);
    let x = 0.5 * WIDTH_MM + 0.5 * scale * (body.left - body.right);
    let y = height - 22.0 - scale * body.widest;
    let between = between - scale * (body.widest + bulged);
    let mut view = View {
        sheet: &mut sheet,
        origin: [x, y],
        scale,
    };
    at_rest(body, &mut view);
    view.origin[1] -= between;
    under_pressure(body, &mut view);
    sheet
}

/// The muscle at rest: above the axis in section, below it from outside.
fn at_rest(body: &MuscleBody<'_>, v: &mut View<'_>) {
    let MuscleBody {
        plan, half, end, ..
    } = *body;
    let outer = body.clamped;
    let [ri, ro] = [
        plan.muscle.inner_diameter_mm(),
        plan.muscle.outer_diameter_mm(),
    ];
    axis(v, half + body.left, half + body.right);
    v.cut((-half, half), (0.5 * ri, 0.5 * ro), true);
    v.cut((-half, half), (0.5 * ro, body.sleeve), false);
    for side in [-1.0, 1.0] {
        on_plug(body, v, side);
    }
    v.plug(&plan.air_plug, -half, -1.0, false);
    v.plug(&plan.eye_plug, half, 1.0, false);
    clamps(body, v, true);
    // From outside.
    v.line(Outline, &[[-half, -body.sleeve], [half, -body.sleeve]]);
    for side in [-1.0, 1.0] {
        let edge = [[half, -body.sleeve], [half, -outer], [end, -outer]];
        v.line(Outline, &edge.map(|[x, y]| [side * x, y]));
    }
    strands(body, v);
    clamps(body, v, false);
    let row = v.scale * body.widest + 5.0;
    let bare = |mm: f64| plan.shown.bare(mm);
    let free = format!("L₀ {}", bare(2.0 * half));
    v.across((-half, half), (0.5 * ro, 0.5 * ro), row, &free);
    v.across((half, end), (outer, outer), row, &bare(end - half));
    let faces = format!("between the heads {}", bare(plan.faces_mm(0.0)));
    v.across((-end, end), (outer, outer), row + 7.0, &faces);
    let [bore, tube, over] = [ri, ro, plan.over_sleeve_mm].map(bare);
    let angle = trimmed(plan.muscle.braid().angle_deg, 1);
    let text = format!("At rest: tube ⌀{tube}, bore ⌀{bore}, over the sleeve ⌀{over}, θ₀ {angle}°");
    label(v, row + 14.0, &text);
}

/// Tube and sleeve on a plug, in section.
fn on_plug(body: &MuscleBody<'_>, v: &mut View<'_>, side: f64) {
    let (plan, stem) = (body.plan, &body.plan.air_plug.stem);
    let inner = 0.5 * stem.diameter_mm;
    let wall = plan.cut.tube_wall_mm;
    let along = |to: f64| {
        let (a, b) = (side * body.half, side * to);
        (a.min(b), a.max(b))
    };
    v.cut(
        along(body.half + stem.tube_mm()),
        (inner, inner + wall),
        true,
    );
    v.cut(along(body.end), (inner + wall, body.clamped), false);
}

fn axis(v: &mut View<'_>, left: f64, right: f64) {
    let beyond = 4.0 / v.scale;
    v.line(Axis, &[[-left - beyond, 0.0], [right + beyond, 0.0]]);
}

/// Ties, clamps and ferrules on one side of the axis.
fn clamps(body: &MuscleBody<'_>, v: &mut View<'_>, above: bool) {
    let stem = &body.plan.air_plug.stem;
    let outer = body.clamped;
    let bands = stem.bands_mm.iter().chain(&stem.pressed_mm).copied();
    let bands = bands.map(|[from, to]| (from - stem.datum_mm, to - stem.datum_mm));
    for (from, to) in bands {
        for side in [-1.0, 1.0] {
            let a = side * (body.half + from);
            let b = side * (body.half + to);
            let x = (a.min(b), a.max(b));
            if above {
                v.cut(x, (outer, outer + 1.2), true)
            } else {
                v.outline(
                    Outline,
                    &[
                        [x.0, 0.0],
                        [x.0, -outer - 1.2],
                        [x.1, -outer - 1.2],
                        [x.1, 0.0],
                    ],
                )
            }
        }
    }
}

/// Strands of both families below the axis, not all of them.
fn strands(body: &MuscleBody<'_>, v: &mut View<'_>) {
    let tan = body.plan.muscle.braid().angle_rad().tan();
    let radius = body.sleeve;
    let along = TAU * radius / tan;
    let count = body
        .plan
        .cut
        .sleeve
        .strands
        .map_or(24.0, |n| 0.5 * f64::from(n));
    // Not nearer than 5 mm on paper.
    let count = count.min((v.scale * along / 5.0).floor()).max(1.0);
    let step = along / count;
    let quarter = 0.25 * along;
    let turns = ((2.0 * body.half + quarter) / step).ceil().min(2000.0) as usize;
    for family in [-1.0, 1.0] {
        for i in 0..=turns {
            let start = -body.half - quarter + i as f64 * step;
            let place = |k: usize| {
                let share = k as f64 / 12.0;
                let x = start + share * quarter;
                let turn = if family > 0.0 { share } else { 1.0 - share };
                [x, -radius * (FRAC_PI_2 * turn).sin()]
            };
            let points: Vec<[f64; 2]> = (0..=12)
                .map(place)
                .filter(|p| p[0].abs() <= body.half)
                .collect();
            if points.len() > 1 {
                v.line(Thin, &points);
            }
        }
    }
}

/// The muscle at the working pressure, free to contract.
fn under_pressure(body: &MuscleBody<'_>, v: &mut View<'_>) {
    let plan = body.plan;
    let half = body.half;
    let operating = &plan.operating;
    let stroke = 2.0 * half * operating.free_contraction;
    let thickness = body.sleeve - 0.5 * plan.muscle.outer_diameter_mm();
    axis(v, half + body.left, half + body.right - stroke);
    let middle = -0.5 * stroke;
    for sign in [-1.0, 1.0] {
        let right = operating
            .contour_mm
            .iter()
            .map(|[z, r]| [middle + z.abs(), sign * (r + thickness)]);
        let left = operating
            .contour_mm
            .iter()
            .rev()
            .map(|[z, r]| [middle - z.abs(), sign * (r + thickness)]);
        let outer = sign * body.clamped;
        let end = body.end;
        let all: Vec<[f64; 2]> = [[-end, outer], [-half, outer]]
            .into_iter()
            .chain(left)
            .chain(right)
            .chain([[half - stroke, outer], [end - stroke, outer]])
            .collect();
        v.line(Outline, &all);
    }
    v.head(&plan.air_plug, -half, -1.0, &[-1.0, 1.0]);
    v.head(&plan.eye_plug, half - stroke, 1.0, &[-1.0, 1.0]);
    let widest = 0.5 * operating.bulged_diameter_mm + thickness;
    v.inside(
        middle + 0.35 * half,
        (-widest, widest),
        &format!("⌀{}", plan.shown.bare((2.0 * widest).round())),
    );
    let row = -(v.scale * widest.max(body.widest) + 6.0);
    let clamp = -body.clamped;
    v.across(
        (-half, half - stroke),
        (clamp, clamp),
        row,
        &plan.shown.bare(2.0 * half - stroke),
    );
    v.across(
        (half - stroke, half),
        (clamp, 0.0),
        row,
        &format!("stroke {}", plan.shown.bare(stroke.round())),
    );
    let text = format!(
        "At {} without load: contracted by {}",
        plan.shown.pressure(operating.pressure_mpa),
        percent(operating.free_contraction)
    );
    label(v, v.scale * widest.max(body.widest) + 3.0, &text);
}

/// A text above a view.
fn label(v: &mut View<'_>, above: f64, text: &str) {
    let y = v.origin[1] + above;
    v.sheet.text([0.0, y], 2.5, Start, text);
}
