//! The frame of the proof test. At each end two flat bars hold the head between them by its bolt; two
//! rods run between the bars, and their nuts press the bars apart by bridges across each pair.

use crate::{
    Plan,
    plug::{BOLT_FACTOR, BOLTS_MM, CLASSES, Plug, ROOT, Stress, hole_mm},
    sheets::{self, WIDTH_MM, largest},
    sold::{first, sold},
    view::View,
};
use mckibben_core::analysis::STRETCH;
use mckibben_report::DrawingSheet;
use std::f64::consts::PI;

/// Flat bars as they are sold (EN 10058): thicknesses and widths in mm; yield strength of their steel
/// S235JR in MPa (EN 10025-2).
const FLATS_MM: [u16; 12] = [3, 4, 5, 6, 8, 10, 12, 15, 20, 30, 40, 60];
const WIDTHS_MM: [u16; 14] = [10, 12, 15, 20, 25, 30, 35, 40, 50, 60, 70, 80, 100, 150];
const YIELDS_MPA: f64 = 235.0;
/// From the largest diameter of the muscle to the axis of a rod, for fitting and hose, in mm, and how
/// far a rod goes on beyond the bars (choices).
const REACH_MM: f64 = 35.0;
const BEYOND_MM: f64 = 15.0;
/// The load at which a rod buckles over its own (a choice), and its modulus in MPa.
const BUCKLING: f64 = 3.0;
const STEEL_MPA: f64 = 210e3;

/// The bars for a bolt: width and thickness in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bar {
    pub width_mm: f64,
    pub thick_mm: f64,
    /// From the axis of the muscle to that of a rod.
    pub reach_mm: f64,
}

impl Bar {
    /// The narrowest bar, no thicker than the bolt, for a load in N of an end of a muscle.
    pub(crate) fn new(bolt_mm: f64, outer_mm: f64, load_n: f64) -> Self {
        let mut flats = FLATS_MM.into_iter().map(f64::from);
        let thinner = flats.rfind(|mm| *mm <= bolt_mm);
        let bar = |width_mm: u16| Self {
            width_mm: width_mm.into(),
            thick_mm: thinner.unwrap_or(FLATS_MM[0].into()),
            reach_mm: (0.5 * outer_mm + REACH_MM).ceil(),
        };
        bar(first(&WIDTHS_MM, |mm| {
            f64::from(mm) >= 2.0 * hole_mm(bolt_mm) && bar(mm).stress(bolt_mm, load_n).is_borne()
        }))
    }

    /// Each bar carries a half of the load in the middle of both rods: M = F r/4, on a section with the
    /// hole of the bolt, t (h³ − d³)/6h.
    pub fn stress(&self, bolt_mm: f64, load_n: f64) -> Stress {
        let (width, hole) = (self.width_mm, hole_mm(bolt_mm));
        let section = self.thick_mm * (width.powi(3) - hole.powi(3)) / (6.0 * width);
        Stress::steel(
            "bar of the frame, bending",
            0.25 * load_n * self.reach_mm / section,
            YIELDS_MPA,
        )
    }
}

/// The frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    pub bar: Bar,
    pub bar_length_mm: f64,
    /// Bridges: length, width and thickness.
    pub bridge_mm: [f64; 3],
    /// Thread and length of the rods.
    pub rod_mm: f64,
    pub rod_length_mm: f64,
}

/// The rod in mm of class 8.8 that bears a load in N along it, and does not buckle between joints at a
/// distance: P = π² E I/L² (Budynas & Nisbett 2011 \[budynas2011\], section 4-12).
pub fn rod_mm(load_n: f64, length_mm: f64) -> f64 {
    let bears = |(mm, _): (f64, f64)| {
        let root = ROOT * mm;
        let buckles_n = PI.powi(3) * STEEL_MPA * root.powi(4) / (64.0 * length_mm * length_mm);
        let area = 0.25 * PI * root * root;
        BOLT_FACTOR * load_n <= CLASSES[0].1 * area && BUCKLING * load_n <= buckles_n
    };
    first(&BOLTS_MM, bears).0
}

impl Frame {
    /// The frame of a plan.
    pub fn new(plan: &Plan) -> Self {
        let load_n = plan.loads.proof_end_load_high_n;
        let (plug, bar) = (&plan.air_plug, plan.air_plug.bolt.bar);
        let side_mm = plug.side_mm.max(plan.eye_plug.side_mm);
        let between = |plug: &Plug| plug.eye_mm - plug.stem.length_mm;
        let apart_mm = plan.faces_mm(-STRETCH) + between(plug) + between(&plan.eye_plug);
        let rod_mm = rod_mm(0.5 * load_n, apart_mm);
        let width_mm = 2.5 * rod_mm;
        let width_mm = sold(&WIDTHS_MM, |mm| mm >= width_mm).unwrap_or(width_mm);
        let frame = |thick_mm: u16| Self {
            bar,
            bar_length_mm: 2.0 * bar.reach_mm + width_mm,
            bridge_mm: [side_mm + 2.0 * bar.thick_mm, width_mm, thick_mm.into()],
            rod_mm,
            rod_length_mm: (apart_mm + bar.width_mm + 2.0 * BEYOND_MM).ceil(),
        };
        let bears = |thick_mm| frame(thick_mm).stress(load_n).is_borne();
        frame(first(&FLATS_MM, bears))
    }

    /// A bridge carries a half of the load of an end from bar to bar, a length l − t: M = F (l − t)/8.
    pub fn stress(&self, load_n: f64) -> Stress {
        let [length, width, thick] = self.bridge_mm;
        let section = (width - hole_mm(self.rod_mm)) * thick * thick / 6.0;
        let moment = 0.125 * load_n * (length - self.bar.thick_mm);
        Stress::steel("bridge of the frame, bending", moment / section, YIELDS_MPA)
    }

    /// The frame with the muscle in it, with the nearer bars left out.
    pub(crate) fn drawing(&self, plan: &Plan) -> DrawingSheet {
        let half = 0.5 * plan.faces_mm(0.0);
        let Bar {
            width_mm, reach_mm, ..
        } = self.bar;
        let [_, wide_mm, thick_mm] = self.bridge_mm;
        let ends = [(&plan.air_plug, -1.0), (&plan.eye_plug, 1.0)];
        let size = [self.rod_length_mm, self.bar_length_mm];
        let scale = largest(|s| s * size[0] <= WIDTH_MM - 30.0 && s * size[1] <= 70.0);
        let load = plan.shown.force(plan.loads.proof_end_load_high_n);
        let title = format!("Frame for {load}, without the nearer bars");
        let mut v = View {
            sheet: sheets::sheet(plan, &title, scale, scale * size[1] + 24.0),
            origin: [0.5 * WIDTH_MM, 6.0 + 0.5 * scale * size[1]],
            scale,
        };
        let body = 0.5 * plan.clamped_diameter_mm;
        v.rectangle([-half, half], [-body, body]);
        let apart = |plug: &Plug| half + plug.eye_mm - plug.stem.length_mm;
        for (plug, out) in ends {
            v.plug(
                plug,
                out * (half - plug.stem.length_mm + plug.stem.datum_mm),
                out,
            );
            let eye = apart(plug);
            let inner = eye - 0.5 * width_mm;
            let bridge = inner - thick_mm;
            let nut = bridge - 0.8 * self.rod_mm;
            for sign in [-1.0, 1.0] {
                let side = 0.5 * sign * plug.side_mm;
                let about = |half: f64| [sign * reach_mm - half, sign * reach_mm + half];
                let x = |from: f64, to: f64| [out * from, out * to];
                v.rectangle(
                    x(inner, eye + 0.5 * width_mm),
                    [side, 0.5 * sign * self.bar_length_mm],
                );
                v.rectangle(x(bridge, inner), about(0.5 * wide_mm));
                v.rectangle(x(nut, bridge), about(0.9 * self.rod_mm));
            }
        }
        let rod = 0.5 * self.rod_length_mm;
        for y in [-1.0, 1.0].map(|sign| sign * reach_mm) {
            let r = 0.5 * self.rod_mm;
            v.rectangle([-rod, rod], [y - r, y + r]);
        }
        let [held, stretched] = [0.0, -STRETCH].map(|e| plan.shown.bare(plan.faces_mm(e)));
        let faces = format!("{held}, then {stretched}");
        let row = 0.5 * scale * size[1] + 5.0;
        v.across((-half, half), (body, body), row, &faces);
        let between = plan.shown.bare(2.0 * reach_mm);
        v.beside((-reach_mm, reach_mm), rod, scale * rod + 6.0, &between);
        v.sheet
    }
}
