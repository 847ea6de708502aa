//! What wears in a muscle: stretch and energy of the rubber, the wall between strands, tension, contact and turning of the strands.
//!
//! There is no law for the cycles that a muscle lasts. These are the quantities that govern its life; [`measured`] has lives that somebody
//! measured, [`LifeCurve`] the life of a rubber that a user measured. All follow from a model's [`Response`] and the muscle:
//!
//! | quantity | from |
//! |---|---|
//! | θ in the middle | sinθ = sinθ0 rb/(Rs λf), rb radius of the strands at the largest diameter, λf their stretch by their tension |
//! | λz in the middle | λf cosθ/cosθ0; 1 − ε where the strands are slack |
//! | energy density in the middle | w(λθ, λz), the larger of bore and outer surface |
//! | wall between strands | the cap of [`burst::mesh`](super::burst::mesh), on top of the stretch in the middle |
//! | contact pressure in the middle | pc = N T sin²θ/(2π rb² cosθ) |
//!
//! with N T the tension of all strands, Rs and θ0 radius and angle of the sleeve as made. pc is that of
//! [`Contact`](crate::model::Contact) for a long muscle. Of a muscle that extends, whose largest diameter is at its ends, λz is 1 − ε.

mod curve;
pub mod measured;
mod turning;

pub use curve::{LifeCurve, LifeCurveError, LifeLevel};
pub use turning::{Turning, turning};

use super::burst::mesh::bulge;
use crate::model::{Response, Wall};
use crate::muscle::Muscle;
use serde::Serialize;
use std::f64::consts::PI;

/// What wears, at one pressure and contraction. What the model or the muscle does not give is `None`.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Wear {
    /// The largest principal stretch in the middle of the muscle.
    pub middle_stretch: Option<f64>,
    /// The principal stretch below which 99 % of the rubber lies by volume, in the whole muscle.
    pub max_stretch: Option<f64>,
    /// Clear distance of neighbouring strands in the middle, mm.
    pub clear_distance_mm: Option<f64>,
    /// Largest stretch of the wall where it bulges between strands in the middle: that of the cap times that of the middle.
    pub between_strands_stretch: Option<f64>,
    /// Largest strain energy per volume of rubber in the middle, MPa (mJ/mm³).
    pub energy_density_mpa: Option<f64>,
    /// Tension of all strands together, N.
    pub braid_tension_n: Option<f64>,
    /// Tension of one strand, N.
    pub strand_tension_n: Option<f64>,
    /// Pressure of the strands on the tube in the middle, MPa.
    pub contact_pressure_mpa: Option<f64>,
    /// Angle of the strands to the axis in the middle, degrees.
    pub angle_deg: Option<f64>,
}

impl Wear {
    /// The largest stretch of the rubber anywhere; `None` where the wall bulges between the strands without end.
    pub fn largest_stretch(&self) -> Option<f64> {
        if self.clear_distance_mm.is_some() && self.between_strands_stretch.is_none() {
            return None;
        }
        let all = [self.middle_stretch, self.max_stretch, self.between_strands_stretch];
        all.into_iter().flatten().reduce(f64::max)
    }

    /// How far each quantity is apart in two states.
    pub fn range(&self, other: &Self) -> Self {
        let apart = |of: fn(&Self) -> Option<f64>| Some((of(self)? - of(other)?).abs());
        Self {
            middle_stretch: apart(|w| w.middle_stretch),
            max_stretch: apart(|w| w.max_stretch),
            clear_distance_mm: apart(|w| w.clear_distance_mm),
            between_strands_stretch: apart(|w| w.between_strands_stretch),
            energy_density_mpa: apart(|w| w.energy_density_mpa),
            braid_tension_n: apart(|w| w.braid_tension_n),
            strand_tension_n: apart(|w| w.strand_tension_n),
            contact_pressure_mpa: apart(|w| w.contact_pressure_mpa),
            angle_deg: apart(|w| w.angle_deg),
        }
    }
}

/// What wears in a muscle where a model gives a response.
pub fn wear(muscle: &Muscle, response: &Response) -> Wear {
    let middle = Middle::of(muscle, response);
    let wall = Wall::new(muscle.tube());
    let law = &muscle.rubber().law;
    let cap = middle.and_then(|m| {
        bulge(muscle, m.angle_rad, m.strand_stretch, response.pressure_mpa).zip(response.middle_stretch)
    });
    Wear {
        middle_stretch: response.middle_stretch,
        max_stretch: response.max_stretch,
        clear_distance_mm: cap.map(|(cap, _)| cap.clear_distance_mm),
        between_strands_stretch: cap.and_then(|(cap, middle)| Some(cap.stretch? * middle)),
        energy_density_mpa: middle
            .and_then(|m| wall.largest_energy_density_mpa(law, m.axial_stretch, m.outer_radius_mm)),
        braid_tension_n: response.braid_tension_n,
        strand_tension_n: response.strand_tension_n,
        contact_pressure_mpa: middle.and_then(|m| m.contact_pressure_mpa(response.braid_tension_n?)),
        angle_deg: middle.map(|m| m.angle_rad.to_degrees()),
    }
}

/// The middle of a muscle.
#[derive(Clone, Copy)]
struct Middle {
    angle_rad: f64,
    strand_stretch: f64,
    axial_stretch: f64,
    outer_radius_mm: f64,
    /// rb
    braid_radius_mm: f64,
}

impl Middle {
    fn of(muscle: &Muscle, response: &Response) -> Option<Self> {
        let lay = muscle.strand_lay();
        let (sin0, cos0) = lay.angle_rad.sin_cos();
        let tension = response.braid_tension_n.unwrap_or(0.0);
        let strand_stretch = 1.0 + muscle.strand_strain(tension).unwrap_or(0.0);
        let shortened = 1.0 - response.contraction;
        let (outer_radius_mm, axial_stretch) = if muscle.is_extensile() {
            let sin = (1.0 - (shortened * cos0 / strand_stretch).powi(2)).max(0.0).sqrt();
            (lay.outer_radius_mm(strand_stretch * sin / sin0), shortened)
        } else {
            let outer = 0.5 * response.bulged_diameter_mm?;
            let sin = lay.hoop_stretch(outer) * sin0 / strand_stretch;
            let taut = strand_stretch * (1.0 - sin * sin).max(0.0).sqrt() / cos0;
            (outer, if tension == 0.0 { shortened } else { taut })
        };
        let hoop = lay.hoop_stretch(outer_radius_mm);
        let angle_rad = (sin0 * hoop).atan2(cos0 * axial_stretch);
        let braid_radius_mm = hoop * lay.radius_mm;
        (axial_stretch > 0.0).then_some(Self {
            angle_rad,
            strand_stretch,
            axial_stretch,
            outer_radius_mm,
            braid_radius_mm,
        })
    }

    /// pc in MPa at a tension of all strands in N.
    fn contact_pressure_mpa(&self, braid_tension_n: f64) -> Option<f64> {
        let (sin, cos) = self.angle_rad.sin_cos();
        let pressure = braid_tension_n * sin * sin / (2.0 * PI * self.braid_radius_mm.powi(2) * cos);
        pressure.is_finite().then_some(pressure)
    }
}
