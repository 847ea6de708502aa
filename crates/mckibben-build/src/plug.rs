//! A plug: its stem in the tube, and a square head with a hole for a bolt across it and, where it
//! has one, the thread of a fitting in one of its flats, so that both ends carry the load.

use crate::{
    body::{Circle, FACETS, Face, Loop, X, Y, Z, met, minus, revolved},
    fitting::Fitting,
    frame::Bar,
    mesh::Mesh,
    sold::sold,
    stem::Stem,
};
use std::f64::consts::{PI, SQRT_2};

/// Bolts and their holes (ISO 273, medium), in mm.
pub const BOLTS_MM: [(f64, f64); 15] = [
    (3.0, 3.4),
    (4.0, 4.5),
    (5.0, 5.5),
    (6.0, 6.6),
    (8.0, 9.0),
    (10.0, 11.0),
    (12.0, 13.5),
    (16.0, 17.5),
    (20.0, 22.0),
    (24.0, 26.0),
    (30.0, 33.0),
    (36.0, 39.0),
    (42.0, 45.0),
    (48.0, 52.0),
    (64.0, 70.0),
];
/// Square bars as they are sold (EN 754-4), in mm.
const BARS_MM: [u16; 18] = [
    8, 10, 12, 15, 20, 25, 30, 35, 40, 45, 50, 60, 70, 80, 90, 100, 120, 160,
];
/// What saw and lathe take of a bar in mm (a choice).
const SAW_MM: f64 = 5.0;
/// Round bars as they are sold (EN 754-3), in mm.
const ROUNDS_MM: [u16; 25] = [
    8, 10, 12, 14, 16, 18, 20, 22, 25, 28, 30, 32, 35, 40, 45, 50, 55, 60, 65, 70, 80, 90, 100,
    120, 150,
];
/// Lengths of bolts as they are sold (ISO 888) in mm, up to ten times their diameter (ISO 4014).
const BOLT_LENGTHS_MM: [u16; 18] = [
    16, 20, 25, 30, 35, 40, 45, 50, 55, 60, 70, 80, 90, 100, 120, 140, 160, 200,
];
const LONGEST_BOLT: f64 = 10.0;
/// Classes of bolts with their yield strength in MPa (ISO 898-1; the harder ones are sold as socket
/// screws, ISO 4762), and how far the stress in the proof test stays below it (a choice).
pub const CLASSES: [(&str, f64); 2] = [("8.8", 640.0), ("12.9", 1100.0)];
pub const BOLT_FACTOR: f64 = 1.1;
/// The least root of a coarse thread over its diameter: that of M4 (ISO 724). A bolt may have its
/// thread anywhere in the head.
pub const ROOT: f64 = 0.785;
/// Yield in shear over that in tension (von Mises; Budynas & Nisbett 2011 \[budynas2011\], section
/// 5-5).
const SHEAR: f64 = 0.577;
/// Least wall in mm.
const WALL_MM: f64 = 1.0;
/// Thickness of the collar of a turned plug, and how far it is wider than what is clamped, in mm;
/// one behind a ferrule is narrower than that, so that the dies have room.
const COLLAR_MM: (f64, f64) = (5.0, 1.5);
const COLLAR_BEHIND_MM: f64 = 0.2;

/// What a plug is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// As a shop orders it.
    pub name: &'static str,
    /// What it yields or breaks at, MPa: its stress in the proof test is at most a half of it (a
    /// choice, for notches and creep).
    pub strength_mpa: f64,
    /// g/mm³.
    pub density: f64,
}

/// Printed PETG, pulled across its layers. Printed upright and solid it bore less than 1/2.43 of
/// the tension that it bore along them (Amza et al. 2021 \[amza2021\]), of 47 to 52 MPa.
pub const PETG: Material = Material {
    name: "PETG, printed solid",
    strength_mpa: 20.0,
    density: 1.27e-3,
};
/// Aluminium EN AW-6082 T6 as a bar (EN 755-2).
pub const ALUMINIUM: Material = Material {
    name: "aluminium EN AW-6082 T6",
    strength_mpa: 250.0,
    density: 2.7e-3,
};
const MATERIAL_FACTOR: f64 = 2.0;

/// A bolt through a head.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bolt {
    /// 6 is M6.
    pub mm: f64,
    /// Property class, such as 8.8.
    pub class: &'static str,
    /// Yield strength of the class in MPa.
    pub yields_mpa: f64,
    /// What holds it in the proof test.
    pub bar: Bar,
}

/// A stress at a load, beside what it may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stress {
    /// The loaded part and how it is loaded.
    pub what: &'static str,
    /// At the load of the proof test.
    pub mpa: f64,
    /// What the part yields at, and how far the stress stays below it.
    pub yields_mpa: f64,
    /// Yield strength over stress.
    pub factor: f64,
}

impl Stress {
    pub(crate) fn steel(what: &'static str, mpa: f64, yields_mpa: f64) -> Self {
        Self {
            what,
            mpa,
            yields_mpa,
            factor: BOLT_FACTOR,
        }
    }

    pub(crate) fn is_borne(&self) -> bool {
        self.factor * self.mpa <= self.yields_mpa
    }
}

/// The thread of a fitting in a flat of the head.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Port {
    /// What is screwed into it.
    pub fitting: Fitting,
    /// Height of its axis above the inner end of the stem, in mm.
    pub height_mm: f64,
    /// Hole for the tap, and how deep it is from the flat, in mm.
    pub hole_mm: f64,
    /// Depth of that hole from the flat, in mm.
    pub depth_mm: f64,
    /// Length of the thread in mm.
    pub thread_mm: f64,
    /// Diameter of the passage along the axis, in mm.
    pub passage_mm: f64,
}

/// A plug.
#[derive(Debug, Clone, PartialEq)]
pub struct Plug {
    /// The part inside of the tube.
    pub stem: Stem,
    /// Of stem and head.
    pub material: Material,
    /// Side of the square head in mm.
    pub side_mm: f64,
    /// Diameter of a collar below the head in mm, where the head is narrower than the stem.
    pub collar_mm: Option<f64>,
    /// Height of the head in mm, and of its end.
    pub foot_mm: f64,
    /// Over all, in mm.
    pub length_mm: f64,
    /// The bolt, its hole, and the height of its axis above the inner end, in mm.
    pub bolt: Bolt,
    /// Diameter of the hole for the bolt in mm.
    pub hole_mm: f64,
    /// Height of the axis of that hole above the inner end, in mm.
    pub eye_mm: f64,
    /// Of the plug with the passage alone.
    pub port: Option<Port>,
}

/// Hole of a bolt in mm.
pub fn hole_mm(bolt_mm: f64) -> f64 {
    let known = BOLTS_MM.iter().find(|b| b.0 == bolt_mm);
    known.map_or(1.1 * bolt_mm, |b| b.1)
}

impl Plug {
    /// The plug of a material for a load in N in the proof test, on a muscle of an outer diameter over
    /// its sleeve, with a given bolt or the one that the load needs, of the first class that bears it.
    pub(crate) fn new(
        stem: (&Stem, Material),
        (outer_mm, load_n): (f64, f64),
        fitting: Option<Fitting>,
        bolt_mm: Option<f64>,
    ) -> Self {
        let with = |bolt| Self::with_bolt(stem, outer_mm, fitting, bolt);
        let bears = |plug: &Self| {
            plug.bears(load_n) && plug.bolt_length_mm() <= LONGEST_BOLT * plug.bolt.mm
        };
        let largest_mm = bolt_mm.unwrap_or(BOLTS_MM[BOLTS_MM.len() - 1].0);
        let sizes = BOLTS_MM.iter().map(|b| b.0);
        let sizes = sizes.filter(|_| bolt_mm.is_none()).chain([largest_mm]);
        let bolt = |mm, (class, yields_mpa)| Bolt {
            mm,
            class,
            yields_mpa,
            bar: Bar::new(mm, outer_mm, load_n),
        };
        let mut all = sizes.flat_map(|mm| CLASSES.map(|class| with(bolt(mm, class))));
        all.find(bears)
            .unwrap_or_else(|| with(bolt(largest_mm, CLASSES[1])))
    }

    /// The same with a bolt.
    pub(crate) fn with_bolt(
        (stem, material): (&Stem, Material),
        outer_mm: f64,
        fitting: Option<Fitting>,
        bolt: Bolt,
    ) -> Self {
        let hole_mm = hole_mm(bolt.mm);
        let flat_mm = fitting.map_or(0.0, |f| f.thread.sizes_mm[2]);
        let needed_mm = (flat_mm + 1.0).max(2.2 * hole_mm);
        let (widest_mm, margin_mm) = match stem.shoulder_mm {
            Some(_) => (stem.widest_mm(), COLLAR_BEHIND_MM),
            None => (stem.widest_mm().max(outer_mm), COLLAR_MM.1),
        };
        let bar = sold(&BARS_MM, |mm| mm >= needed_mm);
        let collar_mm = widest_mm + 2.0 * margin_mm;
        let turned = bar.filter(|bar| material != PETG && SQRT_2 * bar <= collar_mm);
        // The end of a printed head is its foot on the printer, so that nothing overhangs.
        let wide_mm = needed_mm.max(widest_mm + 2.0).ceil();
        let wide_bar = sold(&BARS_MM, |mm| mm >= wide_mm && material != PETG);
        let side_mm = turned.or(wide_bar).unwrap_or(wide_mm);
        let collar_mm = turned.map(|_| collar_mm);
        let foot_mm = stem.length_mm + collar_mm.map_or(0.0, |_| COLLAR_MM.0);
        let port = fitting.map(|fitting| Port::new(fitting, stem, foot_mm, side_mm));
        let above_mm = port.map_or(foot_mm, |p| p.height_mm + 0.5 * p.hole_mm);
        let beside_mm = above_mm + 0.5 * hole_mm + 3.0_f64.max(0.5 * hole_mm);
        // The bar that holds the bolt has room beside a collar.
        let eye_mm = beside_mm.max(foot_mm + 0.5 * bolt.bar.width_mm + 1.0);
        Self {
            stem: stem.clone(),
            material,
            side_mm,
            collar_mm,
            foot_mm,
            length_mm: (eye_mm + 1.5 * hole_mm).ceil(),
            bolt,
            hole_mm,
            eye_mm,
            port,
        }
    }

    /// Whether stem, head and bolt bear a load in N.
    pub(crate) fn bears(&self, load_n: f64) -> bool {
        self.stresses(load_n).iter().all(Stress::is_borne)
    }

    /// The stresses at a load in N. The bolt is a pin in a clevis whose cheeks are as thick as it is,
    /// with the load spread evenly over head and cheeks: M = F (t + 2 g)/8, the shear 4/3 F/2A (Budynas
    /// & Nisbett 2011 \[budynas2011\], sections 3-10 and 3-11).
    pub fn stresses(&self, load_n: f64) -> Vec<Stress> {
        let (side, bolt, hole) = (self.side_mm, self.bolt.mm, self.hole_mm);
        let root = ROOT * bolt;
        let moment = load_n * (side + 2.0 * bolt) / 8.0;
        let strength_mpa = self.material.strength_mpa;
        let own = |what, area: f64, yields_mpa| Stress {
            factor: MATERIAL_FACTOR,
            ..Stress::steel(what, load_n / area, yields_mpa)
        };
        let circle = |d: f64| 0.25 * PI * d * d;
        let (passage, port) = self
            .port
            .map_or((0.0, 0.0), |p| (p.passage_mm, p.hole_mm * p.depth_mm));
        let edge = self.length_mm - self.eye_mm - 0.5 * hole;
        vec![
            self.bolt.bar.stress(bolt, load_n),
            Stress::steel(
                "bolt, bending",
                32.0 * moment / (PI * root.powi(3)),
                self.bolt.yields_mpa,
            ),
            Stress::steel(
                "bolt, shear",
                4.0 / 3.0 * load_n / (2.0 * circle(root)),
                SHEAR * self.bolt.yields_mpa,
            ),
            own("bolt on its hole", bolt * side, strength_mpa),
            own("head beside the bolt", side * (side - hole), strength_mpa),
            own("head beside the port", side * side - port, strength_mpa),
            own(
                "head behind the bolt, shear",
                2.0 * side * edge,
                SHEAR * strength_mpa,
            ),
            own(
                "stem",
                circle(self.stem.root_mm()) - circle(passage),
                strength_mpa,
            ),
        ]
    }

    /// The largest diameter or side in mm.
    pub(crate) fn widest_mm(&self) -> f64 {
        let collar_mm = self.collar_mm.unwrap_or(0.0);
        self.stem.widest_mm().max(self.side_mm).max(collar_mm)
    }

    /// How exact the stem must be, in mm: what a printer holds, or a lathe with ease.
    pub fn tolerance_mm(&self) -> f64 {
        if self.is_printed() { 0.15 } else { 0.05 }
    }

    /// Whether it is printed, else turned and milled.
    pub fn is_printed(&self) -> bool {
        self.material == PETG
    }

    /// What it is made from.
    pub(crate) fn stock(&self) -> String {
        let name = self.material.name;
        match self.collar_mm {
            _ if self.is_printed() => name.into(),
            Some(collar) => {
                let round_mm = sold(&ROUNDS_MM, |mm| mm > collar);
                format!("{name}, round bar {} mm", round_mm.unwrap_or(collar.ceil()))
            }
            None => format!("{name}, square bar {} mm", self.side_mm),
        }
    }

    /// The same with the length of bar for it, with what saw and lathe take.
    pub(crate) fn bought(&self) -> String {
        let stock = self.stock();
        match self.is_printed() {
            true => stock,
            false => format!("{stock}, {} mm of it", self.length_mm + SAW_MM),
        }
    }

    /// Length in mm of its bolt as sold: through the head, two cheeks as thick as the bolt, and the
    /// nut.
    pub(crate) fn bolt_length_mm(&self) -> f64 {
        let least_mm = self.side_mm + 3.3 * self.bolt.mm + 1.0;
        let length_mm = sold(&BOLT_LENGTHS_MM, |mm| mm >= least_mm);
        length_mm.unwrap_or((least_mm / 20.0).ceil() * 20.0)
    }

    /// Density times volume.
    pub fn mass_g(&self) -> f64 {
        self.material.density * self.volume_mm3()
    }

    /// Volume in mm³: frusta of the turned part π/3 (a² + a b + b²) h, and the head without its holes.
    /// A passage of radius p ends on the wall of the thread's hole, radius r, which is
    /// r (1 − p²/(8 r²)) below its axis in the mean, to the fourth order of p/r.
    pub fn volume_mm3(&self) -> f64 {
        let square = |x: f64| x * x;
        let frustum = |ends: &[[f64; 2]]| {
            let [[a, low], [b, high]] = [ends[0], ends[1]];
            PI / 3.0 * (a * a + a * b + b * b) * (high - low)
        };
        let turned: f64 = self.turned().windows(2).map(frustum).sum();
        let head = square(self.side_mm) * (self.length_mm - self.foot_mm);
        // The roof of a printed hole is a corner of 90° above its circle.
        let roof = if self.is_printed() {
            1.0 - 0.25 * PI
        } else {
            0.0
        };
        let eye = (PI + roof) * square(0.5 * self.hole_mm) * self.side_mm;
        let port = self.port.map_or(0.0, |port| {
            let (r, p) = (0.5 * port.hole_mm, 0.5 * port.passage_mm);
            let passage_mm = port.height_mm - r * (1.0 - square(p / r) / 8.0);
            PI * (square(r) * port.depth_mm + square(p) * passage_mm)
        });
        turned + head - eye - port
    }

    /// The hole of the bolt at a distance from the axis. A printed one has a roof towards the stem, which
    /// is up on the printer.
    fn eye(&self, x: f64) -> Circle {
        Circle {
            has_roof: self.is_printed(),
            ..Circle::about(X, [x, 0.0, self.eye_mm], 0.5 * self.hole_mm)
        }
    }

    /// Radii and heights from the inner end to the head.
    pub(crate) fn turned(&self) -> Vec<[f64; 2]> {
        let mut out = self.stem.profile.clone();
        if let Some(collar_mm) = self.collar_mm {
            let radius = 0.5 * collar_mm;
            out.extend([[radius, self.stem.length_mm], [radius, self.foot_mm]]);
        }
        out
    }

    /// The section through axis and port: the outline, and what is hollow in it.
    pub fn section(&self) -> (Vec<[f64; 2]>, Vec<Vec<[f64; 2]>>) {
        let half = 0.5 * self.side_mm;
        let mut side: Vec<[f64; 2]> = self.turned().iter().map(|[r, z]| [*z, *r]).collect();
        side.extend([[self.foot_mm, half], [self.length_mm, half]]);
        let mirrored = side.iter().rev().map(|[x, y]| [*x, -y]);
        let outline = side.iter().copied().chain(mirrored).collect();
        let mut eye = self.eye(0.0).points();
        // As seen along it, from the end of the head on.
        eye.rotate_left(FACETS / 4 + 1);
        let eye = eye.into_iter().rev().map(|[_, y, z]| [z, y]);
        let port = self.port.map(|port| {
            let (p, r, h) = (0.5 * port.passage_mm, 0.5 * port.hole_mm, port.height_mm);
            let floor = half - port.depth_mm;
            vec![
                [0.0, p],
                [h - r, p],
                [h - r, half],
                [h + r, half],
                [h + r, floor],
                [h - r, floor],
                [h - r, -p],
                [0.0, -p],
            ]
        });
        (outline, [eye.collect()].into_iter().chain(port).collect())
    }

    /// Its faces, with the inner end of the stem at z = 0.
    pub(crate) fn body(&self) -> Vec<Face> {
        let half = 0.5 * self.side_mm;
        let square = |z: f64| {
            [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]]
                .map(|[x, y]| [half * x, half * y, z])
        };
        let [low, high] = [self.foot_mm, self.length_mm].map(square);
        let flat = |k: usize| {
            let next = (k + 1) % 4;
            Loop::Corners([low[k], low[next], high[next], high[k]])
        };
        let mut profile = self.turned();
        profile.dedup_by(|a, b| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-6);
        let level = |[r, z]: [f64; 2]| Loop::Circle(Circle::about(Z, [0.0, 0.0, z], r));
        let mut faces = revolved(&profile);
        let [tip, root] = [profile[0], profile[profile.len() - 1]].map(level);
        // Under the head, or the top of the collar around it.
        let (down, below) = match self.collar_mm {
            Some(_) => (Z, [root, Loop::Corners(low)]),
            None => (minus(Z), [Loop::Corners(low), root]),
        };
        let mut nose = vec![tip];
        let mut front = vec![flat(0)];
        if let Some(port) = self.port {
            let (r, p, height) = (0.5 * port.hole_mm, 0.5 * port.passage_mm, port.height_mm);
            let [mouth, floor] =
                [half, half - port.depth_mm].map(|y| Circle::about(Y, [0.0, y, height], r));
            let entry = Circle::about(Z, [0.0; 3], p);
            let met = Loop::Smooth(met([r, p], height));
            let mut wall = Face::round(mouth, floor);
            wall.lines.push(met.clone());
            front.push(Loop::Circle(mouth));
            nose.push(Loop::Circle(entry));
            let mut passage = Face::round(Circle::about(Z, [0.0, 0.0, height], p), entry);
            passage.lines[0] = met;
            faces.extend([wall, passage, Face::flat(Y, [Loop::Circle(floor)])]);
        }
        let [left, right] = [-half, half].map(|x| self.eye(x));
        faces.extend([
            Face::flat(minus(Z), nose),
            Face::flat(down, below),
            Face::flat(Z, [Loop::Corners(high)]),
            Face::flat(Y, front),
            Face::flat(minus(X), [flat(1), Loop::Circle(left)]),
            Face::flat(minus(Y), [flat(2)]),
            Face::flat(X, [flat(3), Loop::Circle(right)]),
            Face::round(right, left),
        ]);
        faces
    }

    /// Its surface as triangles, for STL.
    pub fn mesh(&self) -> Mesh {
        Mesh::of(&self.body())
    }

    /// The surface as it stands on the printer: on the end of its head.
    pub fn printed(&self) -> Mesh {
        let mut mesh = self.mesh();
        for [_, y, z] in &mut mesh.corners {
            (*y, *z) = (-*y, self.length_mm - *z);
        }
        mesh
    }
}

impl Port {
    fn new(fitting: Fitting, stem: &Stem, foot_mm: f64, side_mm: f64) -> Self {
        let [hole_mm, thread_mm, flat_mm] = fitting.thread.sizes_mm;
        let root_mm = stem.root_mm();
        // Two thirds of the stem are its wall.
        let passage_mm = (root_mm / 3.0).min(4.0).min(0.8 * hole_mm);
        // A drill.
        let passage_mm = (10.0 * passage_mm).floor() / 10.0;
        Self {
            fitting,
            height_mm: foot_mm + 0.5 * flat_mm.max(hole_mm + 4.0),
            hole_mm,
            depth_mm: (0.5 * (side_mm + passage_mm) + WALL_MM).max(thread_mm + 1.0),
            thread_mm,
            passage_mm,
        }
    }
}
