//! What follows from a muscle's measures.

use super::{Muscle, StrandLay};
use std::f64::consts::PI;

/// What a workshop needs to build the muscle.
#[derive(Debug, Clone, PartialEq)]
pub struct BuildSheet {
    /// Length of tube to cut, before it is stretched: L0/λp and what is clamped on both plugs, in
    /// mm.
    pub tube_cut_mm: f64,
    /// Length of sleeve to cut, at the angle θ0, in mm (the same: it lies on the tube).
    pub braid_cut_mm: f64,
    /// Diameter of the plugs: the tube's bore, in mm.
    pub plug_diameter_mm: f64,
    /// Length of one strand over the whole cut, in mm.
    pub strand_cut_mm: f64,
    /// Number of strands, where it is known.
    pub strands: Option<u32>,
    /// Volume of rubber in the cut tube, in mm³.
    pub rubber_volume_mm3: f64,
}

impl Muscle {
    /// Outer diameter at rest D0 in mm.
    pub fn outer_diameter_mm(&self) -> f64 {
        self.tube().outer_diameter_mm
    }

    /// Wall at rest s in mm.
    pub fn wall_mm(&self) -> f64 {
        self.tube().wall_mm
    }

    /// Length at rest L0 in mm.
    pub fn length_mm(&self) -> f64 {
        self.tube().length_mm
    }

    /// Inner diameter at rest D0 − 2s in mm.
    pub fn inner_diameter_mm(&self) -> f64 {
        2.0 * self.tube().inner_radius_mm()
    }

    /// Length of one strand between the terminals B = L0/cosθ0 in mm.
    pub fn strand_length_mm(&self) -> f64 {
        self.length_mm() / self.braid().angle_rad().cos()
    }

    /// How the strands lie on the tube.
    #[doc(hidden)]
    pub fn strand_lay(&self) -> StrandLay {
        self.braid().lay(self.tube())
    }

    /// Turns of one strand N = L0 tanθ0/(2π Rs), Rs of [`StrandLay`].
    pub fn turns(&self) -> f64 {
        self.length_mm() * self.braid().angle_rad().tan()
            / (PI * (2.0 * self.strand_lay().radius_mm))
    }

    /// Length of strand per turn 2π Rs/sinθ0 in mm: a property of the sleeve, whatever it is pulled
    /// over.
    pub fn strand_length_per_turn_mm(&self) -> f64 {
        PI * (2.0 * self.strand_lay().radius_mm) / self.braid().angle_rad().sin()
    }

    /// Largest contraction of the ideal muscle, 1 − 1/(√3 cosθ0).
    pub fn max_ideal_contraction(&self) -> f64 {
        1.0 - 1.0 / (3f64.sqrt() * self.braid().angle_rad().cos())
    }

    /// Cavity at rest π Ri² L0 in mm³.
    pub fn rest_volume_mm3(&self) -> f64 {
        PI * self.tube().inner_radius_mm().powi(2) * self.length_mm()
    }

    /// k of one strand family in N/mm; `None` for inextensible strands.
    pub fn family_stiffness_n_per_mm(&self) -> Option<f64> {
        self.braid().family_stiffness_n_per_mm(self.tube())
    }

    /// Outer diameter in mm of the braid at a contraction if strands do not stretch:
    /// D0 √(1 − λ² cos²θ0)/sinθ0, λ = 1 − ε (the pantograph, the paper's (2)).
    pub fn pantograph_diameter_mm(&self, contraction: f64) -> f64 {
        let (sin, cos) = self.braid().angle_rad().sin_cos();
        let c = (1.0 - contraction) * cos;
        self.outer_diameter_mm() * (1.0 - c * c).max(0.0).sqrt() / sin
    }

    /// Strain of the strands under a tension of all of them together, in N; `None` for inextensible
    /// strands. N·T = 4π Rs cosθ0 k (λf − 1), or with [`Crimp`](super::Crimp) its force in place of
    /// k (λf − 1).
    pub fn strand_strain(&self, braid_tension_n: f64) -> Option<f64> {
        let k = self.family_stiffness_n_per_mm()?;
        let lay = self.strand_lay();
        let force = braid_tension_n / (2.0 * PI * (2.0 * lay.radius_mm) * lay.angle_rad.cos() * k);
        Some(
            self.braid()
                .crimp
                .map_or(force, |crimp| crimp.strain_at(force)),
        )
    }

    /// Length of tube and braid clamped on each plug, in mm.
    pub fn insertion_mm(&self) -> f64 {
        self.terminals().insertion_mm(self.inner_diameter_mm())
    }

    /// What a workshop needs.
    #[doc(hidden)]
    pub fn build_sheet(&self) -> BuildSheet {
        let cut = self.length_mm() + 2.0 * self.insertion_mm();
        let ro = self.tube().outer_radius_mm();
        let ri = self.tube().inner_radius_mm();
        let stretch = self.tube().prestretch;
        // What is clamped has the section of before.
        let tube_cut_mm = self.length_mm() / stretch + 2.0 * self.insertion_mm();
        BuildSheet {
            tube_cut_mm,
            braid_cut_mm: cut,
            plug_diameter_mm: 2.0 * self.parts().plug_radius_mm(),
            strand_cut_mm: cut / self.braid().angle_rad().cos(),
            strands: self.braid().strands.map(|s| s.count),
            rubber_volume_mm3: PI * (ro * ro - ri * ri) * (stretch * tube_cut_mm),
        }
    }
}
