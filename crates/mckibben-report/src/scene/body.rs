//! What is seen: faces, threads, the eye.

use crate::Axis;
use serde::{Deserialize, Serialize};

/// Four corners in space, counter-clockwise seen from outside; seen from inside the face is not drawn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Face {
    /// Corners (x, y, z), any unit of length; z runs from left to right in the picture, x upwards.
    pub corners: [[f64; 3]; 4],
    /// What is shown at the corners; plain grey where `None`.
    pub values: Option<[f64; 4]>,
}

/// A line in space, drawn where no face hides it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Thread {
    /// Its points, as those of [`Face::corners`].
    pub points: Vec<[f64; 3]>,
    /// Direction out of the body at each point, of any length; parts that look away from the eye are hidden by the body
    /// they lie on.
    pub outward: Vec<[f64; 3]>,
    /// Width on paper in mm.
    pub width_mm: f64,
}

/// From where a body is seen.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct View {
    /// Turn about the upward axis in degrees; 0 looks along −y, positive shows more of the right end.
    pub azimuth_deg: f64,
    /// Height of the eye above the horizontal in degrees.
    pub elevation_deg: f64,
}

impl Default for View {
    fn default() -> Self {
        Self { azimuth_deg: 25.0, elevation_deg: 20.0 }
    }
}

/// A picture of a body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Scene {
    /// Title above the picture.
    pub title: String,
    pub caption: String,
    /// Surface of the body.
    pub faces: Vec<Face>,
    pub threads: Vec<Thread>,
    /// Name, unit and range of the values; without a range their own extent is taken.
    pub values: Axis,
    /// Name of the unit of length for the scale bar.
    pub length_unit: String,
    pub view: View,
    /// Width of the paper in mm; the height follows from the body.
    pub width_mm: f64,
}
