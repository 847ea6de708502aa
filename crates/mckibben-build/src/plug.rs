//! The plugs: a stem with grooves for clamps, a collar, and a fitting for the air or an eye for a
//! bolt.

use crate::{
    Mesh,
    mesh::{FACETS, Ring},
};
use mckibben_core::muscle::Terminals;
use std::{
    f64::consts::{PI, TAU},
    fmt,
    str::FromStr,
};
use thiserror::Error;

/// A stem is so much wider than the bore, as a share of it, at least and at most in mm. A choice:
/// sellers of barbs say only that a barb is "a little larger" than the bore.
const INTERFERENCE: (f64, f64, f64) = (0.05, 0.2, 1.5);
/// A groove is so much wider than a cable tie, in mm: room for the sleeve.
const GROOVE_ROOM_MM: f64 = 1.0;
/// Depth of a groove as a share of the stem, at most in mm. A choice.
const GROOVE_DEPTH: (f64, f64) = (0.06, 1.5);
/// Least length between grooves and at both ends of the stem, in mm.
const LAND_MM: f64 = 2.0;
/// Thickness of the collar in mm, and how far it is wider than the sleeve. A choice.
const COLLAR_MM: (f64, f64) = (3.0, 1.5);
/// Bearing pressure that the eye of a printed plug may carry, in MPa. A choice, about a third of
/// what solid PETG yields at.
const BEARING_MPA: f64 = 15.0;
/// Bolts and their holes (ISO 273, medium), in mm.
const BOLTS_MM: [(f64, f64); 9] = [
    (3.0, 3.4),
    (4.0, 4.5),
    (5.0, 5.5),
    (6.0, 6.6),
    (8.0, 9.0),
    (10.0, 11.0),
    (12.0, 13.5),
    (16.0, 17.5),
    (20.0, 22.0),
];

/// Tension in MPa that a printed plug is taken to bear across its layers, from one to the next: a
/// choice.
pub const PRINTED_MPA: f64 = 10.0;

/// The stem of both plugs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stem {
    /// Diameter in mm: the bore and the interference.
    pub diameter_mm: f64,
    /// How much wider it is than the bore, in mm.
    pub interference_mm: f64,
    /// Length in the tube in mm.
    pub length_mm: f64,
    pub grooves: usize,
    /// Width of a groove in mm.
    pub groove_width_mm: f64,
    /// Depth of a groove in mm.
    pub groove_depth_mm: f64,
    /// Diameter of the collar in mm.
    pub collar_diameter_mm: f64,
    /// Thickness of the collar in mm.
    pub collar_mm: f64,
}

impl Stem {
    /// The stem for a bore, under a sleeve of an outer diameter, for ties of a width; the collar
    /// has room for a foot.
    pub(crate) fn new(
        ends: &Terminals,
        bore_mm: f64,
        outer_mm: f64,
        tie_mm: f64,
        foot_mm: f64,
    ) -> Self {
        let length_mm = ends.insertion_mm(bore_mm);
        let (share, least, most) = INTERFERENCE;
        let usual_mm = bore_mm + (share * bore_mm).clamp(least.min(0.2 * bore_mm), most);
        let diameter_mm = ends.plug_diameter_mm.unwrap_or(usual_mm);
        let groove_width_mm = tie_mm + GROOVE_ROOM_MM;
        let fits = |n: f64| length_mm >= n * groove_width_mm + (n + 1.0) * LAND_MM;
        Self {
            diameter_mm,
            interference_mm: diameter_mm - bore_mm,
            length_mm,
            // Builders: two narrow ties hold where a wide one leaked.
            grooves: [2, 1]
                .into_iter()
                .find(|n| fits(f64::from(*n)))
                .unwrap_or(0) as usize,
            groove_width_mm,
            groove_depth_mm: (GROOVE_DEPTH.0 * diameter_mm).min(GROOVE_DEPTH.1),
            collar_diameter_mm: (outer_mm + 2.0 * COLLAR_MM.1).max(foot_mm + 1.0),
            collar_mm: COLLAR_MM.0,
        }
    }

    /// Bore of the tube that it is for, in mm.
    pub(crate) fn bore_mm(&self) -> f64 {
        self.diameter_mm - self.interference_mm
    }

    /// How exact its diameter must be, in mm: a quarter of the interference, to which the tolerance
    /// of lengths would be as large.
    pub fn tolerance_mm(&self) -> f64 {
        (0.25 * self.interference_mm.abs()).max(0.05)
    }

    /// Distance of the inner end of each groove from the inner end of the stem, in mm.
    pub fn groove_starts_mm(&self) -> Vec<f64> {
        let lands = self.grooves as f64 + 1.0;
        let land = (self.length_mm - self.grooves as f64 * self.groove_width_mm) / lands;
        (0..self.grooves)
            .map(|i| land + i as f64 * (land + self.groove_width_mm))
            .collect()
    }

    /// Length of the bevel of the inner end in mm, and the radius there.
    pub(crate) fn bevel_mm(&self) -> (f64, f64) {
        let bevel = (0.1 * self.length_mm)
            .min(0.2 * self.diameter_mm)
            .min(0.5 * LAND_MM);
        (bevel, 0.5 * self.diameter_mm - 0.5 * bevel)
    }

    /// Radii and heights from the inner end to the outer edge of the collar.
    pub fn profile(&self) -> Vec<[f64; 2]> {
        let radius = 0.5 * self.diameter_mm;
        let depth = self.groove_depth_mm;
        let width = self.groove_width_mm;
        let (bevel, tip) = self.bevel_mm();
        let mut out = vec![[tip, 0.0], [radius, bevel]];
        for start in self.groove_starts_mm() {
            let end = start + width;
            out.extend([
                [radius, start],
                [radius - depth, start + depth],
                [radius - depth, end - depth],
                [radius, end],
            ]);
        }
        let collar = 0.5 * self.collar_diameter_mm;
        out.extend([
            [radius, self.length_mm],
            [collar, self.length_mm],
            [collar, self.top_mm()],
        ]);
        out
    }

    /// Height of the collar's outer face above the inner end, in mm.
    pub fn top_mm(&self) -> f64 {
        self.length_mm + self.collar_mm
    }
}

/// The plug with the air passage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AirPlug {
    pub stem: Stem,
    /// The connection of the hose.
    pub fitting: Fitting,
    /// Diameter of the passage in mm.
    pub passage_mm: f64,
}

impl AirPlug {
    pub(crate) fn new(stem: Stem, fitting: Fitting) -> Self {
        let root = stem.diameter_mm - 2.0 * stem.groove_depth_mm;
        let hole = match fitting {
            Fitting::Barb { bore_mm } => 0.55 * bore_mm,
            _ => fitting.thread_mm().map_or(4.0, |t| 0.8 * t.0),
        };
        // Two thirds of the stem are its wall.
        Self {
            stem,
            fitting,
            passage_mm: (root / 3.0).min(4.0).min(hole),
        }
    }

    /// Whether printed layers bear a load in N of its end.
    pub(crate) fn is_printed(&self, load_n: f64) -> bool {
        self.stress_mpa(load_n) <= PRINTED_MPA
    }

    /// Tension in MPa in the thinnest section of the stem, around the passage, at a load in N.
    pub(crate) fn stress_mpa(&self, load_n: f64) -> f64 {
        let depth_mm = if self.stem.grooves > 0 {
            self.stem.groove_depth_mm
        } else {
            0.0
        };
        let root_mm = self.stem.diameter_mm - 2.0 * depth_mm;
        4.0 * load_n / (PI * (root_mm * root_mm - self.passage_mm * self.passage_mm))
    }

    /// Radii and heights above the edge of the collar: outside up, and down to the passage.
    pub(crate) fn head(&self) -> Vec<[f64; 2]> {
        let top = self.stem.top_mm();
        let hole = 0.5 * self.passage_mm;
        match (self.fitting, self.fitting.thread_mm()) {
            (_, Some((drill, depth, boss))) => {
                let end = top + depth;
                let cone = (0.5 * drill - hole).min(self.stem.collar_mm);
                vec![
                    [0.5 * boss, top],
                    [0.5 * boss, end],
                    [0.5 * drill, end],
                    [0.5 * drill, top],
                    [hole, top - cone],
                ]
            }
            (Fitting::Barb { bore_mm }, _) => {
                // One sharp barb with a cylinder behind it holds better than several.
                let neck = 0.5 * bore_mm;
                let edge = 0.6 * bore_mm;
                let tip = 0.45 * bore_mm;
                let start = top + 1.5 * bore_mm;
                let end = top + 2.5 * bore_mm;
                vec![
                    [neck, top],
                    [neck, start],
                    [edge, start],
                    [tip, end],
                    [hole, end],
                ]
            }
            // Threads are above.
            _ => vec![],
        }
    }

    /// Whole length in mm.
    pub fn length_mm(&self) -> f64 {
        self.head()
            .iter()
            .map(|p| p[1])
            .fold(self.stem.top_mm(), f64::max)
    }

    /// The whole section, closed.
    pub fn profile(&self) -> Vec<[f64; 2]> {
        let mut out = self.stem.profile();
        out.extend(self.head());
        out.push([0.5 * self.passage_mm, 0.0]);
        out.push(out[0]);
        // A boss may be exactly as wide as the collar.
        out.dedup();
        out
    }

    pub fn mesh(&self) -> Mesh {
        let mut mesh = Mesh::default();
        let mut profile = self.profile();
        profile.pop();
        if let Some((first, last)) = mesh.bands(&profile) {
            mesh.band(&last, &first);
        }
        mesh
    }
}

/// The closed plug with an eye for a bolt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EyePlug {
    pub stem: Stem,
    /// The bolt in mm: 6 is M6.
    pub bolt_mm: f64,
    /// Hole of the eye in mm.
    pub hole_mm: f64,
    /// Thickness of the eye in mm.
    pub thickness_mm: f64,
    /// Width of the eye in mm.
    pub width_mm: f64,
    /// Distance of the hole's centre from the collar in mm.
    pub centre_mm: f64,
}

/// Hole of a bolt, thickness and width of its eye, distance of its centre, in mm.
fn eye_mm(bolt_mm: f64) -> (f64, f64, f64, f64) {
    let hole = BOLTS_MM
        .iter()
        .find(|b| b.0 == bolt_mm)
        .map_or(1.1 * bolt_mm, |b| b.1);
    (hole, bolt_mm.max(4.0), 2.5 * hole, 1.5 * hole)
}

/// The bolt in mm that a pull in N needs at [`BEARING_MPA`] in an eye as thick as the bolt: d =
/// √(F/p), the next standard one.
pub fn bolt_mm(pull_n: f64) -> f64 {
    let least = (pull_n.max(0.0) / BEARING_MPA).sqrt();
    BOLTS_MM
        .iter()
        .map(|b| b.0)
        .find(|d| *d >= least)
        .unwrap_or((least / 4.0).ceil() * 4.0)
}

/// Diameter in mm that an eye for a bolt needs on the collar.
pub fn foot_mm(bolt_mm: f64) -> f64 {
    let (_, thickness, width, _) = eye_mm(bolt_mm);
    width.hypot(thickness)
}

impl EyePlug {
    pub(crate) fn new(stem: Stem, bolt_mm: f64) -> Self {
        let (hole_mm, thickness_mm, width_mm, centre_mm) = eye_mm(bolt_mm);
        Self {
            stem,
            bolt_mm,
            hole_mm,
            thickness_mm,
            width_mm,
            centre_mm,
        }
    }

    /// Whole length in mm.
    pub fn length_mm(&self) -> f64 {
        self.stem.top_mm() + self.centre_mm + 0.5 * self.width_mm
    }

    /// Outline of the eye from its foot, and its hole, both about the hole's centre and
    /// counter-clockwise.
    pub(crate) fn eye(&self) -> (Vec<[f64; 2]>, Vec<[f64; 2]>) {
        let w = 0.5 * self.width_mm;
        let h = self.centre_mm;
        let arc = |i: usize| PI * i as f64 / (FACETS / 2) as f64;
        let mut outline = vec![[-w, 0.0], [w, 0.0]];
        outline.extend((0..=FACETS / 2).map(|i| [w * arc(i).cos(), h + w * arc(i).sin()]));
        let turn = |i: usize| TAU * i as f64 / FACETS as f64;
        let hole = 0.5 * self.hole_mm;
        let around = (0..FACETS).map(|i| [hole * turn(i).cos(), h + hole * turn(i).sin()]);
        (outline, around.collect())
    }

    pub fn mesh(&self) -> Mesh {
        let mut mesh = Mesh::default();
        let top = self.stem.top_mm();
        let t = 0.5 * self.thickness_mm;
        let Some((first, last)) = mesh.bands(&self.stem.profile()) else {
            return mesh;
        };
        let end = mesh.corner([0.0, 0.0, 0.0]);
        for i in 0..first.len() {
            mesh.triangles
                .push([end, first[(i + 1) % first.len()], first[i]]);
        }
        let (outline, hole) = self.eye();
        let mut side = |points: &[[f64; 2]], y: f64| -> Ring {
            points
                .iter()
                .map(|[x, z]| mesh.corner([*x, y, top + z]))
                .collect()
        };
        let front = side(&outline, -t);
        let back = side(&outline, t);
        let front_hole = side(&hole, -t);
        let back_hole = side(&hole, t);
        let centre = self.centre_mm + top;
        mesh.face(&front, &front_hole, |[x, _, z]| [x, z], [0.0, centre]);
        let turned = |ring: &[usize]| ring.iter().rev().copied().collect::<Ring>();
        mesh.face(
            &turned(&back),
            &turned(&back_hole),
            |[x, _, z]| [-x, z],
            [0.0, centre],
        );
        for i in 1..front.len() {
            let j = (i + 1) % front.len();
            mesh.triangles
                .extend([[front[i], back[i], front[j]], [front[j], back[i], back[j]]]);
        }
        // The wall of the hole.
        mesh.band(&front_hole, &back_hole);
        let foot = [front[0], front[1], back[1], back[0]];
        mesh.face(&last, &foot, |[x, y, _]| [x, y], [0.0, 0.0]);
        mesh
    }
}

/// The connection of the hose. A push-in fitting is screwed into one of the threads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fitting {
    /// M5 × 0.8.
    M5,
    /// G1/8 (ISO 228-1).
    G18,
    /// G1/4 (ISO 228-1).
    G14,
    /// A barb for a hose of this bore, in mm.
    Barb {
        /// Bore of the hose in mm.
        bore_mm: f64,
    },
}

/// A word that names no fitting.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error(
    "\"{0}\" is not a fitting; expected m5, g1/8 or g1/4 (a thread), or barb:4 (a barb for a hose \
     with a bore of 4 mm, from 1 to 25)"
)]
pub struct UnknownFitting(String);

impl Fitting {
    /// Hoses for which a barb can be made, in mm.
    const HOSES_MM: (f64, f64) = (1.0, 25.0);
    /// Below this outer diameter of the tube in mm the thread M5 is chosen, above it G1/8. A
    /// choice: the boss is then about as wide as the muscle.
    const SMALL_MM: f64 = 15.0;

    /// The default for a tube of an outer diameter.
    pub(crate) fn usual(outer_diameter_mm: f64) -> Self {
        if outer_diameter_mm < Self::SMALL_MM {
            Self::M5
        } else {
            Self::G18
        }
    }

    /// Diameter of the hole for the tap (ISO 2306), depth of the thread, diameter of the boss
    /// around it, in mm; none for a barb. Depth and boss are choices: about as long as the threads
    /// of fittings on sale, and a wall of 0.35 to 0.7 of the thread.
    pub(crate) fn thread_mm(self) -> Option<(f64, f64, f64)> {
        THREADS
            .iter()
            .find(|thread| thread.0 == self)
            .map(|thread| thread.2)
    }
}

/// The threads: name, and drill, depth and boss in mm.
const THREADS: [(Fitting, &str, (f64, f64, f64)); 3] = [
    (Fitting::M5, "M5", (4.2, 6.0, 12.0)),
    (Fitting::G18, "G1/8", (8.8, 9.0, 18.0)),
    (Fitting::G14, "G1/4", (11.8, 12.0, 23.0)),
];

impl fmt::Display for Fitting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self, THREADS.iter().find(|thread| thread.0 == *self)) {
            (Self::Barb { bore_mm }, _) => write!(f, "barb for a hose with a bore of {bore_mm} mm"),
            (_, thread) => f.write_str(thread.map_or("", |thread| thread.1)),
        }
    }
}

impl FromStr for Fitting {
    type Err = UnknownFitting;

    fn from_str(text: &str) -> Result<Self, UnknownFitting> {
        let word: String = text.chars().take(40).collect();
        let plain = word.trim().to_lowercase();
        if let Some(thread) = THREADS
            .iter()
            .find(|thread| thread.1.eq_ignore_ascii_case(&plain))
        {
            return Ok(thread.0);
        }
        let bore = plain
            .strip_prefix("barb:")
            .map(|bore| bore.trim_end_matches("mm").trim().parse());
        match bore {
            Some(Ok(bore_mm)) if (Self::HOSES_MM.0..=Self::HOSES_MM.1).contains(&bore_mm) => {
                Ok(Self::Barb { bore_mm })
            }
            _ => Err(UnknownFitting(word)),
        }
    }
}
