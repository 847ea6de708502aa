//! Sketches for the steps: panels with the number of their step, an end in section, the mould, and
//! the frame of the proof test.

use crate::{
    Plan,
    build_sheet::FACES_MM,
    drawing::{MuscleBody, clamps, on_plug},
    mould::{self, Mould},
    view::View,
};
use mckibben_report::{
    Anchor::Start,
    DrawingSheet,
    Pen::{Axis, Outline, Thin},
};

const PAPER_MM: (f64, f64) = (170.0, 62.0);
const NOTE_MM: f64 = 2.3;
/// Free length in mm on paper that the sketch of an end shows.
const FREE_MM: f64 = 40.0;

/// Panels in a row, and their height in mm.
const COLUMNS: usize = 3;
const PANEL_MM: f64 = 27.0;
/// Height of head, tube and stem in a panel, in mm.
const HEAD_MM: f64 = 9.0;
const TUBE_MM: f64 = 6.0;
const STEM_MM: f64 = 3.6;
/// Inner end of the left head and of the right one in a panel, in mm.
const HEADS_MM: [f64; 2] = [9.0, 38.0];

fn sheet(what: &str) -> DrawingSheet {
    DrawingSheet::new(what.into(), PAPER_MM.0, PAPER_MM.1)
}

/// A sketch that is not to scale, of one step.
struct StepPanel<'a> {
    sheet: &'a mut DrawingSheet,
    /// Its left end and its middle in mm.
    at: [f64; 2],
}

impl StepPanel<'_> {
    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.at[0] + x, self.at[1] + y]
    }

    fn text(&mut self, at: [f64; 2], text: &str) {
        let at = self.place(at);
        self.sheet.text(at, NOTE_MM, Start, text);
    }

    /// A rectangle about the middle of the panel.
    fn bar(&mut self, x: [f64; 2], height: f64) {
        self.rectangle(x, [-0.5 * height, 0.5 * height]);
    }

    fn rectangle(&mut self, x: [f64; 2], y: [f64; 2]) {
        let [x, y] = [0, 1].map(|k| [x, y][k].map(|v| self.at[k] + v));
        self.sheet.rectangle(Outline, x, y);
    }

    /// A sleeve, on the tube.
    fn sleeve(&mut self, x: [f64; 2]) {
        let half = 0.5 * TUBE_MM + 0.6;
        self.bar(x, 2.0 * half);
        let count = ((x[1] - x[0]) / 3.0) as usize;
        let step = (x[1] - x[0]) / count.max(1) as f64;
        for i in 0..count {
            let ends = [x[0] + i as f64 * step, x[0] + (i + 1) as f64 * step];
            for sign in [-1.0, 1.0] {
                let line = [[ends[0], -sign * half], [ends[1], sign * half]];
                let line = line.map(|p| self.place(p));
                self.sheet.line(Thin, line);
            }
        }
    }

    /// A plug whose head ends at x, with its stem to one side.
    fn plug(&mut self, x: f64, side: f64) {
        self.bar([x - 8.0 * side, x], HEAD_MM);
        self.bar([x, x + 8.0 * side], STEM_MM);
    }

    /// So many ties or clamps from x on, to one side.
    fn clamps(&mut self, count: usize, x: f64, side: f64) {
        for i in 0..count {
            let middle = x + side * (2.0 + 3.0 * i as f64);
            self.bar([middle - 1.0, middle + 1.0], 8.5);
        }
    }

    fn arrow(&mut self, from: [f64; 2], to: [f64; 2]) {
        let [a, b] = [from, to].map(|p| self.place(p));
        let length = (b[0] - a[0]).hypot(b[1] - a[1]).max(1e-9);
        let [x, y] = [0, 1].map(|k| (b[k] - a[k]) / length);
        let foot = [b[0] - 2.5 * x, b[1] - 2.5 * y];
        let side = |sign: f64| [foot[0] - 0.7 * sign * y, foot[1] + 0.7 * sign * x];
        self.sheet.line(Thin, [a, foot]);
        self.sheet.fill([b, side(1.0), side(-1.0)]);
    }
}

/// What draws a panel.
type Draw<'a> = &'a dyn Fn(&mut StepPanel<'_>);

/// Panels side by side, each with the number of its step.
fn panels(what: &str, all: &[(usize, Draw<'_>)]) -> DrawingSheet {
    let rows = all.len().div_ceil(COLUMNS);
    let wide = PAPER_MM.0 / COLUMNS as f64;
    let mut sheet = DrawingSheet::new(what.into(), PAPER_MM.0, PANEL_MM * rows as f64);
    for (i, (step, draw)) in all.iter().enumerate() {
        let row = (rows - 1 - i / COLUMNS) as f64;
        let at = [(i % COLUMNS) as f64 * wide + 2.0, (row + 0.5) * PANEL_MM];
        let number = [at[0] + 1.0, at[1] + 8.0];
        sheet.text(number, 3.2, Start, step.to_string());
        draw(&mut StepPanel {
            sheet: &mut sheet,
            at,
        });
    }
    sheet
}

/// The steps of the assembly but for the end that is closed.
pub fn assembly(plan: &Plan) -> DrawingSheet {
    let [left, right] = HEADS_MM;
    let length = |mm: f64| plan.shown.length(mm);
    let cut = &plan.cut;
    let sleeve_mm = cut.sleeve.relaxed_mm.unwrap_or(cut.sleeve.mounted_mm);
    let (tube, sleeve) = (length(cut.tube_mm), length(sleeve_mm.round()));
    let on_plug = length(plan.air_plug.stem.tube_mm());
    let faces = length(plan.faces_mm(0.0));
    let turn = crate::build_sheet::turn(plan);
    let stem = &plan.air_plug.stem;
    let bands = stem.bands_mm.len() + stem.pressed_mm.len();
    panels(
        "Assembly",
        &[
            (1, &|p| {
                p.rectangle([7.0, 36.0], [2.0, 2.0 + TUBE_MM]);
                p.text([38.0, 4.0], &tube);
                p.at[1] -= 7.0;
                p.sleeve([7.0, 36.0]);
                p.at[1] += 7.0;
                p.text([38.0, -8.0], &sleeve);
            }),
            (2, &|p| {
                p.plug(left, 1.0);
                p.bar([left, right], TUBE_MM);
                p.arrow([2.0, -8.0], [left + 2.0, -8.0]);
                p.text(
                    [left + 4.0, -9.0],
                    &format!("{on_plug} of tube on the plug"),
                );
            }),
            (3, &|p| {
                p.plug(left, 1.0);
                p.bar([left, right + 6.0], TUBE_MM);
                p.sleeve([left + 14.0, right]);
                p.clamps(2 * bands, left + 16.0, 1.0);
                p.arrow([right, -8.0], [left + 10.0, -8.0]);
            }),
            (5, &|p| {
                p.plug(left, 1.0);
                p.sleeve([left, right]);
                p.clamps(bands, left, 1.0);
                p.plug(right + 9.0, -1.0);
                p.arrow([right + 9.0, -8.0], [right, -8.0]);
            }),
            (6, &|p| {
                p.plug(left, 1.0);
                p.plug(right, -1.0);
                p.sleeve([left, right]);
                let mut v = View {
                    origin: p.at,
                    scale: 1.0,
                    sheet: p.sheet,
                };
                v.across((left, right), (3.6, 3.6), 8.0, &faces);
                let turn = length(turn.1.round());
                v.across((left + 4.0, right - 4.0), (-3.6, -3.6), -9.0, &turn);
            }),
            (7, &|p| {
                p.plug(left, 1.0);
                p.plug(right, -1.0);
                p.sleeve([left, right]);
                p.clamps(bands, left, 1.0);
                p.clamps(bands, right, -1.0);
                let marks = 1.5 + 3.0 * bands as f64;
                for x in [left + marks, right - marks] {
                    p.arrow([x, -10.0], [x, -4.0]);
                }
                p.text([left + 9.0, -10.5], "marks");
            }),
        ],
    )
}

/// The mould, with the steps at it; diameters are not to scale.
pub fn casting(plan: &Plan) -> DrawingSheet {
    let mould = Mould::new(&plan.cut);
    let mut sheet = sheet("Mould, lying");
    let origin = [28.0, 29.0];
    let scale = 100.0 / mould.pipe_mm;
    let [pipe, vents, hole, spigot] = [
        mould.pipe_mm,
        mould.vents_mm,
        mould::HOLE_MM,
        mould::SPIGOT_MM,
    ]
    .map(|mm| scale * mm);
    let (rod, bore, outer) = (7.0, 11.0, 13.0);
    let mut panel = StepPanel {
        sheet: &mut sheet,
        at: origin,
    };
    panel.bar([-10.0, pipe + 10.0], 2.0 * rod);
    for sign in [-1.0, 1.0] {
        let y = |a: f64, b: f64| [sign * a, sign * b];
        panel.rectangle([0.0, pipe], y(bore, outer));
        for (end, out) in [(0.0, -1.0), (pipe, 1.0)] {
            panel.rectangle([end, end + 2.0 * out], y(rod, outer + 2.0));
            panel.rectangle([end, end - spigot * out], y(rod, bore));
        }
        panel.arrow([vents, sign * bore], [vents, sign * (outer + 5.0)]);
    }
    panel.arrow([hole, -outer - 7.0], [hole, -bore]);
    panel.text([hole + 2.0, -outer - 5.0], "4: syringe, below");
    panel.text([vents - 18.0, -outer - 5.0], "4: vents");
    let mut v = View {
        sheet: &mut sheet,
        origin,
        scale: 1.0,
    };
    for (end, row, mm) in [
        (vents, outer + 7.0, mould.vents_mm),
        (pipe, outer + 14.0, mould.pipe_mm),
    ] {
        v.across((0.0, end), (outer, outer), row, &plan.shown.bare(mm));
    }
    let [rod, bore] = [mould.rod_mm, mould.bore_mm].map(|mm| plan.shown.bare(mm));
    let note = format!("rod ⌀{rod}, pipe ⌀{bore} inside; rubber from the lower cap to the vents");
    sheet.text([4.0, 2.0], NOTE_MM, Start, note);
    sheet
}

/// The muscle as it is filled, and its leak test.
pub fn tests(plan: &Plan) -> DrawingSheet {
    let muscle = |p: &mut StepPanel<'_>, y: [f64; 2]| {
        p.rectangle([22.0, 28.0], y);
        for [from, to] in [[y[0] - 4.0, y[0]], [y[1], y[1] + 4.0]] {
            p.rectangle([20.5, 29.5], [from, to]);
        }
    };
    panels(
        "Filling and leak test",
        &[
            (1, &|p| {
                muscle(p, [-8.0, 6.0]);
                if plan.liquid {
                    p.arrow([12.0, -10.0], [20.0, -10.0]);
                    p.arrow([29.5, 8.0], [36.0, 8.0]);
                    p.text([37.0, 7.0], "bleed screw");
                    p.text([2.0, -9.0], "water");
                } else {
                    p.rectangle([35.0, 48.0], [6.5, 9.5]);
                    p.arrow([35.0, 8.0], [29.5, 8.0]);
                    p.text([30.5, 2.0], "water by syringe");
                }
            }),
            (5, &|p| {
                if plan.liquid {
                    muscle(p, [-6.0, 6.0]);
                    p.text([31.0, -9.0], "dry paper");
                } else {
                    p.rectangle([2.0, 50.0], [-10.0, 4.0]);
                    p.bar([10.0, 42.0], TUBE_MM);
                    p.text([31.0, 6.0], "under water");
                }
            }),
        ],
    )
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
        sheet.line(Outline, [[left - 9.0, rod], [right + 9.0, rod]]);
    }
    let mut panel = StepPanel {
        sheet: &mut sheet,
        at: [0.0, y],
    };
    panel.bar([left, right], 8.0);
    for (head, out) in [(left, -1.0), (right, 1.0)] {
        panel.bar([head, head + 17.0 * out], 10.0);
        // A slotted bar; the bolt bears on its outer face.
        for cheek in [[-22.0, -5.0], [5.0, 22.0]] {
            panel.rectangle([head + 3.0 * out, head + 9.0 * out], cheek);
        }
    }
    for bolt in [left - 11.2, right + 11.2] {
        sheet.circle(Outline, [bolt, y], 2.2);
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
    sheet.text([4.0, 4.0], NOTE_MM, Start, note);
    sheet
}
