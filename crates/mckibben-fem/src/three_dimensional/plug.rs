//! The terminal as a body: a plug that fills the end of the tube, with a rounded nose towards the
//! cavity.
//!
//! The plug's side meets the inner surface from z = L0/2 on, over the insertion; tube and plug are
//! bonded there, so that L0 stays the length between the terminals. Its nose is in the cavity: a
//! quarter of a circle of radius ρ from (Ri, L0/2) to (Ri − ρ, L0/2 − ρ), then a plane to the axis.
//! The tube's outer face stays free over the insertion, the far end of tube and braid is held.
//!
//! The grid carries the tube's on to the axis: columns m from the axis (0) to the inner surface,
//! around as the tube, rows along as the tube's rows of the insertion. Bricks at the axis are
//! wedges (two edges in one).

use crate::{FemError, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;

/// What a plug is made of.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(rename = "TerminalMaterial")]
pub enum PlugMaterial {
    /// Rigid.
    #[default]
    Rigid,
    /// Aluminium: E 70 GPa, ν 0.33.
    Aluminium,
}

/// Young's modulus of aluminium in MPa.
pub const ALUMINIUM_MPA: f64 = 70_000.0;
/// Its Poisson's ratio.
pub const ALUMINIUM_POISSON: f64 = 0.33;
/// Radius of the nose over the inner radius, where none is given.
const NOSE: f64 = 0.25;
/// Shortest insertion of an elastic plug over the inner radius.
const SHORTEST: f64 = 1e-3;

impl PlugMaterial {
    /// Shear and bulk modulus in MPa; `None` where it is rigid.
    pub fn moduli_mpa(self) -> Option<(f64, f64)> {
        match self {
            Self::Rigid => None,
            Self::Aluminium => Some((
                ALUMINIUM_MPA / (2.0 * (1.0 + ALUMINIUM_POISSON)),
                ALUMINIUM_MPA / (3.0 * (1.0 - 2.0 * ALUMINIUM_POISSON)),
            )),
        }
    }
}

/// A terminal with a plug inside of the tube, which is meshed.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "Terminal")]
pub struct Plug {
    /// What the plug is made of.
    pub material: PlugMaterial,
    /// How far the plug reaches into the tube, mm; the muscle's `[terminals] insertion` where it is
    /// not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub insertion_mm: Option<f64>,
    /// Radius of its nose, mm; a quarter of the inner radius where it is not given, 0 for a sharp
    /// edge.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nose_mm: Option<f64>,
}

/// A plug divided into bricks: places of its nodes among those of the mesh.
#[derive(Debug, Clone)]
pub struct PlugGrid {
    /// What it is made of.
    pub material: PlugMaterial,
    /// Length of the bond in mm.
    pub insertion_mm: f64,
    /// Radius of the nose in mm.
    pub nose_mm: f64,
    /// Row of the tube's nodes at which the bond begins.
    pub first_row: usize,
    /// Nodes from the axis to the inner surface: (r, how far the face is before the beginning of
    /// the bond), in mm.
    pub profile: Vec<(f64, f64)>,
    /// Number of its first node.
    pub base: usize,
}

impl Plug {
    /// Insertion and nose in mm for an inner surface of radius `inner` and half length `half`.
    pub(super) fn measures(&self, inner: f64, half: f64) -> Result<(f64, f64)> {
        let insertion = self.insertion_mm.unwrap_or(0.0);
        let least = if self.material == PlugMaterial::Rigid {
            0.0
        } else {
            SHORTEST * inner
        };
        FemError::check_mesh(
            "the terminal's insertion in mm",
            insertion,
            least,
            100.0 * inner,
        )?;
        let nose = self.nose_mm.unwrap_or((NOSE * inner).min(0.5 * half));
        FemError::check_mesh(
            "the radius of the terminal's nose in mm",
            nose,
            0.0,
            inner.min(0.9 * half),
        )?;
        Ok((insertion, nose))
    }
}

/// (r, how far before the bond) from the axis to the inner surface, with intervals of `order` and
/// as many columns as suit `around` bricks.
pub fn profile(inner: f64, nose: f64, around: usize, order: usize) -> Vec<(f64, f64)> {
    let columns = (around / 4).clamp(2, 16);
    let flat = inner - nose;
    let round = columns * order;
    let mut out = vec![];
    // Thinner than rounding is no column.
    if flat > 1e-9 * inner {
        out.extend(
            (0..columns * order).map(|m| (flat * m as f64 / (columns * order) as f64, nose)),
        );
    }
    if nose > 0.0 {
        let arc = (0..round).map(|m| FRAC_PI_2 * m as f64 / round as f64);
        out.extend(arc.map(|t| ((flat + nose * t.sin()).max(0.0), nose * t.cos())));
    }
    if let Some(first) = out.first_mut() {
        first.0 = 0.0;
    }
    out.push((inner, 0.0));
    out
}

impl PlugGrid {
    /// Intervals from the axis to the inner surface.
    pub fn columns(&self) -> usize {
        self.profile.len() - 1
    }
}
