//! The stem of a plug: what lies in the tube.

use crate::ends::{BOLT_BAND_MM, Ends, FERRULE_ROOM_MM, Press};
use mckibben_core::muscle::EndsMade;
use std::f64::consts::FRAC_PI_8;

/// A stem is so much wider than the bore, as a share of it, at least and at most in mm. A choice:
/// sellers of barbs say only that a barb is "a little larger" than the bore.
const INTERFERENCE: (f64, f64, f64) = (0.05, 0.2, 1.5);
/// Length in mm of the nose in front of the first tie or barb, where the free length ends.
const NOSE_MM: f64 = 2.0;
/// A seat is so much wider than its tie or band, in mm: room for the sleeve.
const ROOM_MM: f64 = 1.0;
/// Depth of a groove as a share of the stem, at most in mm. A choice.
const GROOVE: (f64, f64) = (0.06, 1.5);
/// Height of a barb likewise, and at least.
const BARB: (f64, f64, f64) = (0.05, 0.8, 0.2);
/// Ribs of a shoulder in mm: pitch and depth.
pub const RIB_MM: (f64, f64) = (3.0, 0.4);
/// No rib lies nearer to the head, in mm.
pub const RIBS_END_MM: f64 = 2.0;
/// Radius in mm of the corner at the head: a notch breaks printed layers.
const FILLET_MM: f64 = 0.8;
const FILLET_POINTS: usize = 5;

/// The stem of both plugs; heights count from its inner end.
#[derive(Debug, Clone, PartialEq)]
pub struct Stem {
    /// Diameter in mm: the bore and the interference.
    pub diameter_mm: f64,
    /// How much wider it is than the bore, in mm.
    pub interference_mm: f64,
    /// Height in mm at which the free length ends: the inner edge of the first tie or clamp.
    pub datum_mm: f64,
    /// Height of the head in mm.
    pub length_mm: f64,
    /// Ties or bands: from and to, in mm.
    pub bands_mm: Vec<[f64; 2]>,
    /// The shoulder beyond the tube on which the sleeve alone is pressed: diameter, and height from
    /// which on, in mm.
    pub shoulder_mm: Option<[f64; 2]>,
    /// What presses the sleeve on it: from and to, in mm.
    pub pressed_mm: Vec<[f64; 2]>,
    /// Radii and heights from the inner end to the head.
    pub profile: Vec<[f64; 2]>,
}

impl Stem {
    /// The usual diameter of a stem in a bore, in mm.
    pub(crate) fn usual_mm(bore_mm: f64) -> f64 {
        let (share, least, most) = INTERFERENCE;
        bore_mm + (share * bore_mm).clamp(least.min(0.2 * bore_mm), most)
    }

    /// The stem of a diameter for a tube of a bore and a wall, of which a length lies on it, in mm.
    pub(crate) fn new(
        ends: &Ends,
        diameter_mm: f64,
        [bore_mm, wall_mm]: [f64; 2],
        insertion_mm: f64,
    ) -> Self {
        let mut stem = Self {
            diameter_mm,
            interference_mm: diameter_mm - bore_mm,
            datum_mm: NOSE_MM,
            length_mm: NOSE_MM + insertion_mm,
            bands_mm: vec![],
            shoulder_mm: None,
            pressed_mm: vec![],
            profile: vec![],
        };
        match ends.made {
            EndsMade::Tied => stem.grooved(ends),
            EndsMade::Clamped => stem.barbed(ends),
            EndsMade::Crimped => {
                stem.barbed(ends);
                stem.ribbed(ends, wall_mm);
            }
        }
        stem.fillet();
        stem
    }

    /// Bore of the tube that it is for, in mm.
    pub(crate) fn bore_mm(&self) -> f64 {
        self.diameter_mm - self.interference_mm
    }

    /// The least diameter in mm between the nose and the head.
    pub fn root_mm(&self) -> f64 {
        let behind = self.profile.iter().filter(|p| p[1] >= self.datum_mm);
        2.0 * behind.map(|p| p[0]).fold(0.5 * self.diameter_mm, f64::min)
    }

    /// The largest diameter in mm.
    pub(crate) fn widest_mm(&self) -> f64 {
        2.0 * self.profile.iter().map(|p| p[0]).fold(0.0, f64::max)
    }

    /// Length of tube on it in mm, from the datum on.
    pub fn tube_mm(&self) -> f64 {
        self.shoulder_mm.map_or(self.length_mm, |s| s[1]) - self.datum_mm
    }

    /// Corners of its profile for a lathe: radii and heights, with the first of its ribs alone, and
    /// without the fillet at the head.
    pub(crate) fn corners(&self) -> Vec<[f64; 2]> {
        let ribs = self.shoulder_mm.map_or(f64::INFINITY, |s| s[1] + RIB_MM.0);
        let plain = self.profile.len() - FILLET_POINTS;
        let mut out = self.profile[..plain].to_vec();
        out.retain(|corner| corner[1] < ribs);
        out.extend(out.last().map(|last| [last[0], self.length_mm]));
        out
    }

    fn grooved(&mut self, ends: &Ends) {
        let radius = 0.5 * self.diameter_mm;
        let depth = (GROOVE.0 * self.diameter_mm).min(GROOVE.1);
        let width = ends.band_mm + ROOM_MM;
        let bevel = (0.5 * NOSE_MM).min(0.2 * self.diameter_mm);
        self.profile = vec![[radius - 0.5 * bevel, 0.0], [radius, bevel]];
        let pitch = (self.length_mm - self.datum_mm) / ends.at_each_end as f64;
        for i in 0..ends.at_each_end {
            let start = self.datum_mm + i as f64 * pitch;
            let end = start + width;
            self.profile.extend([
                [radius, start],
                [radius - depth, start + depth],
                [radius - depth, end - depth],
                [radius, end],
            ]);
            let from = start + 0.5 * ROOM_MM;
            self.bands_mm.push([from, from + ends.band_mm]);
        }
    }

    /// Barbs, each with the seat of a clamp behind it.
    fn barbed(&mut self, ends: &Ends) {
        let radius = 0.5 * self.diameter_mm;
        let height = (BARB.0 * self.diameter_mm).min(BARB.1).max(BARB.2);
        self.profile = vec![[radius - 0.5, 0.0]];
        let mut peak = self.datum_mm;
        for i in 0..ends.at_each_end {
            // A seat is a cylinder up to the next barb.
            let seat = (i > 0).then_some([radius, peak - NOSE_MM]);
            self.profile.extend(seat);
            self.profile
                .extend([[radius + height, peak], [radius, peak + height]]);
            let from = peak + height + 0.5 * ROOM_MM;
            self.bands_mm.push([from, from + ends.band_mm]);
            peak = from + ends.band_mm + NOSE_MM;
        }
    }

    /// A shoulder as wide as the tube, with ribs.
    fn ribbed(&mut self, ends: &Ends, wall_mm: f64) {
        let end = self
            .bands_mm
            .last()
            .map_or(self.datum_mm, |band| band[1] + 1.0);
        let radius = 0.5 * self.diameter_mm + wall_mm;
        let (pitch, depth) = RIB_MM;
        self.profile
            .extend([[0.5 * self.diameter_mm, end], [radius, end]]);
        let count = ((self.length_mm - end - RIBS_END_MM) / pitch)
            .floor()
            .max(0.0) as usize;
        for i in 0..count {
            let z = end + 1.0 + i as f64 * pitch;
            self.profile.extend([
                [radius, z],
                [radius - depth, z + depth],
                [radius - depth, z + 3.0 * depth],
                [radius, z + 4.0 * depth],
            ]);
        }
        self.shoulder_mm = Some([2.0 * radius, end]);
        self.pressed_mm = match ends.press {
            Some(Press::Ferrule(ferrule)) => {
                let from = end + FERRULE_ROOM_MM[0];
                vec![[from, from + ferrule.length_mm]]
            }
            Some(Press::BoltClamps(count)) => {
                let room = (self.length_mm - end) / count as f64;
                let from = |i: usize| end + (i as f64 + 0.5) * room - 0.5 * BOLT_BAND_MM;
                let bands = (0..count).map(from);
                bands.map(|from| [from, from + BOLT_BAND_MM]).collect()
            }
            None => vec![],
        };
    }

    /// The corner at the head.
    fn fillet(&mut self) {
        let Some(&[radius, below]) = self.profile.last() else {
            return;
        };
        let r = FILLET_MM.min(0.5 * (self.length_mm - below)).max(0.0);
        for i in 0..FILLET_POINTS {
            let (sin, cos) = (FRAC_PI_8 * i as f64).sin_cos();
            self.profile
                .push([radius + r * (1.0 - cos), self.length_mm - r * (1.0 - sin)]);
        }
    }
}
