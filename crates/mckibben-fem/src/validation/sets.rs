//! The measured muscles that the project has: what is known of each, and what has to be identified.

use mckibben::identify::Target;
use mckibben::measured::{DataPoint, read_data};
use mckibben::muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube};
use mckibben::rubber::{Law, NeoHookean};

/// A measured muscle.
#[derive(Debug, Clone, Copy)]
pub struct MeasuredSet {
    /// Which muscle.
    pub name: &'static str,
    /// Who measured it.
    pub source: &'static str,
    /// D0, s, L0 in mm and θ0 in degrees, as far as they are stated; L0 of a row goes before.
    measures: [f64; 4],
    /// Shear modulus in MPa with which the search begins: the rubber of none is stated.
    mu_mpa: f64,
    /// What is identified from its own points.
    pub free: &'static [Target],
    /// The rms error over the blocked force that passes: what finite elements leave of it, rounded up. A regression.
    pub rms_of_blocked: f64,
    table: &'static str,
}

/// Every measured muscle.
pub const SETS: [MeasuredSet; 4] = [
    MeasuredSet {
        name: "hand-made, 20°",
        source: "Tondu 2012 [tondu2012], Fig. 3",
        measures: [14.0, 0.49, 300.0, 20.0],
        mu_mpa: 0.5,
        free: &[Target::Modulus],
        rms_of_blocked: 0.02,
        table: include_str!("../../data/tondu2012/static_force_20deg.csv"),
    },
    MeasuredSet {
        name: "DMSP-20-300",
        source: "Martens & Boblan 2017 [martens2017]",
        measures: [23.0, 1.5, 300.0, 24.0],
        mu_mpa: 0.8,
        free: &[Target::Modulus, Target::Angle],
        rms_of_blocked: 0.015,
        table: include_str!("../../data/martens_boblan_2017/DMSP-20-300.csv"),
    },
    MeasuredSet {
        name: "DMSP-10-250",
        source: "Martens & Boblan 2017 [martens2017]",
        measures: [13.0, 1.25, 250.0, 24.0],
        mu_mpa: 0.8,
        free: &[Target::Modulus, Target::Angle],
        rms_of_blocked: 0.03,
        table: include_str!("../../data/martens_boblan_2017/DMSP-10-250.csv"),
    },
    MeasuredSet {
        name: "DMSP-10 hose, 233, 281 and 382 mm",
        source: "Bolen et al. 2026 [bolen2026]",
        measures: [13.6, 1.8, 281.0, 28.6],
        mu_mpa: 1.5,
        free: &[Target::Modulus, Target::Angle],
        rms_of_blocked: 0.045,
        table: include_str!("../../data/festo_dmsp10/force_map.csv"),
    },
];

impl MeasuredSet {
    /// The muscle as far as it is stated, neo-Hookean, with strands that do not stretch.
    pub fn muscle(&self) -> Option<Muscle> {
        let [outer_diameter_mm, wall_mm, length_mm, angle_deg] = self.measures;
        let rubber = Rubber::of(Law::NeoHookean(NeoHookean { mu_mpa: self.mu_mpa }));
        let tube = Tube { outer_diameter_mm, wall_mm, length_mm, rubber };
        let braid = Braid { angle_deg, stiffness: BraidStiffness::Inextensible, ..Braid::paper() };
        Muscle::new(tube, braid, Terminals::default(), None).ok()
    }

    /// Its points that pull.
    pub fn points(&self) -> Vec<DataPoint> {
        let points = read_data(self.table.as_bytes()).unwrap_or_default();
        points.into_iter().filter(|p| p.at.force_n > 0.0).collect()
    }
}
