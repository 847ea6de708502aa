//! The drawing: the muscle at rest, half in section; the same at the working pressure; a
//! cross-section; parts and title block on A4.

use crate::{
    Plan,
    ends::Press,
    frame::{self, FRAME_MM, Title, largest, ratio},
    text::{percent, trimmed},
    view::View,
};
use mckibben_report::{
    Anchor::{Middle, Start},
    DrawingSheet,
    Pen::{Axis, Outline, Thin},
};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Upper end of the lower part, in mm.
const LOWER_MM: f64 = 78.0;
/// Room for the views of the muscle: its length, and both diameters together.
const ROOM_MM: (f64, f64) = (245.0, 60.0);
/// Room for the cross-section.
const SECTION_MM: f64 = 38.0;

/// Measures that both views need, in mm.
pub struct MuscleBody<'a> {
    pub plan: &'a Plan,
    /// Half of the free length.
    pub half: f64,
    /// The same to the end of the clamped length.
    pub end: f64,
    /// Radius over the clamped sleeve, the free one, and clamps or collar.
    pub clamped: f64,
    pub sleeve: f64,
    pub widest: f64,
    /// From the ends of the free length to the ends of the plugs.
    left: f64,
    right: f64,
}

impl<'a> MuscleBody<'a> {
    pub fn new(plan: &'a Plan) -> Self {
        let half = 0.5 * plan.muscle.length_mm();
        let clamped = 0.5 * plan.clamped_diameter_mm;
        Self {
            plan,
            half,
            end: half + plan.muscle.insertion_mm(),
            clamped,
            sleeve: 0.5 * plan.over_sleeve_mm,
            widest: (clamped + 1.5).max(0.5 * plan.air_plug.widest_mm()),
            left: plan.air_plug.length_mm - plan.air_plug.stem.datum_mm,
            right: plan.eye_plug.length_mm - plan.eye_plug.stem.datum_mm,
        }
    }

    fn scale(&self) -> f64 {
        let bulged = self
            .plan
            .operating
            .bulged_diameter_mm
            .max(2.0 * self.widest);
        let length = 2.0 * self.half + self.left + self.right;
        let height = 2.0 * self.widest + bulged;
        largest(|s| s * length <= ROOM_MM.0 && s * height <= ROOM_MM.1)
    }
}

/// The drawing on paper; the cross-section is enlarged as far as there is room.
pub fn on_paper(plan: &Plan) -> DrawingSheet {
    let body = MuscleBody::new(plan);
    let scale = body.scale();
    let section_scale = largest(|s| s * plan.over_sleeve_mm <= SECTION_MM);
    let title = Title {
        what: "McKibben muscle",
        material: "see bom.csv",
        mass_g: plan.mass_g(),
        number: (1, 3),
        scale,
    };
    let mut sheet = frame::sheet(plan, &title);
    let [left, bottom, right, top] = FRAME_MM;
    // The ends of both plugs have the same distance from the frame.
    let x = 0.5 * (left + right) + 0.5 * scale * (body.left - body.right);
    let bulged = (0.5 * plan.operating.bulged_diameter_mm).max(body.widest);
    // Above the first view, between both, below the second; the rest is shared.
    let used = 22.0 + 22.0 + 12.0 + 2.0 * scale * (body.widest + bulged);
    let spare = ((top - LOWER_MM - used) / 3.0).max(0.0);
    let mut y = top - 22.0 - spare - scale * body.widest;
    at_rest(
        &body,
        &mut View {
            sheet: &mut sheet,
            origin: [x, y],
            scale,
        },
    );
    y -= scale * (body.widest + bulged) + 22.0 + spare;
    under_pressure(
        &body,
        &mut View {
            sheet: &mut sheet,
            origin: [x, y],
            scale,
        },
    );
    let reach = 0.5 * section_scale * plan.over_sleeve_mm;
    let centre = [left + 12.0 + reach, bottom + 8.0 + reach];
    cross_section(
        plan,
        &mut View {
            sheet: &mut sheet,
            origin: centre,
            scale: section_scale,
        },
    );
    data(plan, &mut sheet);
    sheet
}

/// The muscle at rest: above the axis in section, below it from outside.
fn at_rest(body: &MuscleBody<'_>, v: &mut View<'_>) {
    let MuscleBody {
        plan, half, end, ..
    } = *body;
    let outer = body.clamped;
    let ro = 0.5 * plan.muscle.outer_diameter_mm();
    let ri = 0.5 * plan.muscle.inner_diameter_mm();
    axis(v, half + body.left, half + body.right);
    v.cut((-half, half), (ri, ro), true);
    v.cut((-half, half), (ro, body.sleeve), false);
    for side in [-1.0, 1.0] {
        on_plug(body, v, side);
    }
    v.plug(&plan.air_plug, -half, -1.0, false);
    v.plug(&plan.eye_plug, half, 1.0, false);
    clamps(body, v, true);
    // From outside.
    v.line(Outline, &[[-half, -body.sleeve], [half, -body.sleeve]]);
    for side in [-1.0, 1.0] {
        v.line(
            Outline,
            &[
                [side * half, -body.sleeve],
                [side * half, -outer],
                [side * end, -outer],
            ],
        );
    }
    strands(body, v);
    clamps(body, v, false);
    measures_at_rest(body, v, ro);
    label(v, body.widest, 15.5, "At rest, without pressure");
}

/// Dimensions, the plane of the section, and the numbers of the parts.
fn measures_at_rest(body: &MuscleBody<'_>, v: &mut View<'_>, ro: f64) {
    let MuscleBody {
        plan,
        half,
        end,
        clamped: outer,
        ..
    } = *body;
    let row = v.scale * body.widest + 5.0;
    let bare = |mm: f64| plan.shown.bare(mm);
    v.across(
        (-half, half),
        (ro, ro),
        row,
        &format!("L₀ {}", bare(2.0 * half)),
    );
    let clamped = bare(end - half);
    v.across((-end, -half), (outer, ro), row, &clamped);
    v.across((half, end), (ro, outer), row, &clamped);
    let faces = bare(plan.faces_mm(0.0));
    v.across(
        (-end, end),
        (outer, outer),
        row + 7.0,
        &format!("between the heads {faces}"),
    );
    // The plane of the section.
    let plane = 0.5 * half;
    for sign in [-1.0, 1.0] {
        let edge = sign * body.sleeve;
        let [x, y] = v.on_sheet(plane, edge);
        v.sheet
            .line(Outline, [[x, y + sign * 0.8], [x, y + sign * 3.8]]);
        v.sheet
            .text([x - 2.6, y + sign * 2.6 - 1.2], 3.0, Middle, "A");
    }
}

/// Tube and sleeve on a plug, in section.
pub fn on_plug(body: &MuscleBody<'_>, v: &mut View<'_>, side: f64) {
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
pub fn clamps(body: &MuscleBody<'_>, v: &mut View<'_>, above: bool) {
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
    label(v, widest.max(body.widest), 3.0, &text);
}

fn label(v: &mut View<'_>, radius: f64, above: f64, text: &str) {
    let x = FRAME_MM[0] + 6.0;
    let y = v.origin[1] + v.scale * radius + above;
    v.sheet.text([x, y], 3.0, Start, text);
}

/// The section A–A.
fn cross_section(plan: &Plan, v: &mut View<'_>) {
    let d0 = plan.muscle.outer_diameter_mm();
    let bore = plan.muscle.inner_diameter_mm();
    let over = plan.over_sleeve_mm;
    for diameter in [bore, d0, over] {
        v.circle(Outline, diameter);
    }
    let ring = |d: f64| -> Vec<[f64; 2]> {
        (0..72)
            .map(|i| TAU * f64::from(i) / 72.0)
            .map(|a| [0.5 * d * a.cos(), 0.5 * d * a.sin()])
            .collect()
    };
    v.hatch(&[ring(d0), ring(bore)], true);
    v.circle(Thin, 0.5 * (d0 + over));
    let reach = 0.5 * over + 2.5 / v.scale;
    v.line(Axis, &[[-reach, 0.0], [reach, 0.0]]);
    v.line(Axis, &[[0.0, -reach], [0.0, reach]]);
    let column = v.scale * 0.5 * over;
    for (i, d) in [bore, d0, over].into_iter().enumerate() {
        v.beside(
            (-0.5 * d, 0.5 * d),
            0.0,
            column + 8.0 + 7.0 * i as f64,
            &format!("⌀{}", plan.shown.bare(d)),
        );
    }
    let [x, y] = v.on_sheet(0.0, 0.5 * over);
    let text = format!("A–A  ({})", ratio(v.scale));
    v.sheet.text([x, y + 4.5], 3.0, Middle, text);
}

/// The data of the muscle, in words.
fn data(plan: &Plan, sheet: &mut DrawingSheet) {
    let muscle = &plan.muscle;
    let operating = &plan.operating;
    let safety = &plan.safety;
    let x = 104.0;
    let mut y = LOWER_MM - 6.0;
    let strands = plan
        .cut
        .sleeve
        .strands
        .map_or_else(|| "not stated".into(), |n| n.to_string());
    let pressure = |p: f64| plan.shown.short_pressure(p);
    let known = |value: Option<f64>| value.map_or_else(|| "not known".into(), pressure);
    let limits = &operating.limits;
    let least = match limits.nominal_burst_pressure_mpa {
        Some(_) => "at least",
        None => "pressure",
    };
    let pressed = match plan.ends.press {
        Some(Press::Ferrule(f)) => {
            let [outer, wall, long, pressed] =
                [f.outer_mm, f.wall_mm, f.length_mm, f.pressed_mm].map(|mm| plan.shown.bare(mm));
            format!("Ferrule {outer} × {wall} × {long}, then ⌀{pressed}")
        }
        _ => format!("Ends {}", plan.ends.made.name()),
    };
    let burst = format!("Burst {least} {}", known(limits.burst_pressure_mpa));
    let rows = [
        format!("Braid angle θ₀ {}°", trimmed(muscle.braid().angle_deg, 1)),
        format!("Strands {strands}{}", plan.estimate()),
        format!("Tube to cut {}", plan.shown.length(plan.cut.tube_mm)),
        format!("Working pressure {}", pressure(safety.pressure_mpa)),
        format!(
            "Blocked force {}",
            plan.shown.force(operating.blocked_force_n)
        ),
        format!("Free contraction {}", percent(operating.free_contraction)),
        burst,
        format!("Allowed pressure {}", known(limits.allowed_pressure_mpa)),
        "without the ends: prove them".into(),
        format!("Proof test {}, water", pressure(safety.proof_pressure_mpa)),
        pressed,
        format!("Numbers by model {}", operating.model),
    ];
    for row in rows {
        sheet.text([x, y], 2.3, Start, row);
        y -= 4.8;
    }
}
