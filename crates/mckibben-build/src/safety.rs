//! Pressures of the tests, what each end carries in use and in the proof test, and the energy of the
//! air.
//!
//! A muscle pulls hardest while it lengthens, at its longest, at the pressure that its relief valve
//! lets through. So the proof test raises the pressure with the length held at L0, and then stretches
//! the muscle by [`STRETCH`](mckibben_core::analysis::STRETCH), by the nuts of the frame: on the branch of lengthening too.

use mckibben_core::{
    analysis::{ATMOSPHERE_MPA, PressureLimits, RELIEF, burst::ends::clamp_load_n},
    built::{Built, Left},
    muscle::{Direction, Muscle},
    units::rounded,
};

/// Results of a model for the muscle.
#[derive(Debug, Clone, PartialEq)]
pub struct Operating {
    /// Name of the model.
    pub model: String,
    /// Working pressure in MPa.
    pub pressure_mpa: f64,
    /// The highest that its job sets, MPa.
    pub highest_mpa: f64,
    /// Blocked force there in N, on the branch of its job.
    pub blocked_force_n: f64,
    /// The branch of its job.
    pub branch: Direction,
    /// Contraction without a load at the working pressure.
    pub free_contraction: f64,
    /// Largest outer diameter in mm of the muscle that contracts freely.
    pub bulged_diameter_mm: f64,
    /// Cavity in mm³ there.
    pub volume_mm3: f64,
    /// Its largest pull in the stated use, while it lengthens: at the relief pressure, at the longest
    /// length of its job, else at L0.
    pub in_use: PullAt,
    /// Its pull at the relief pressure, stretched.
    pub stretched: PullAt,
    /// The same at the pressure of the proof test.
    pub proof: PullAt,
    /// The pressures that the muscle bears.
    pub limits: PressureLimits,
    /// The pressure in MPa that stretches its strands to their limit.
    pub strained_mpa: Option<f64>,
    /// What it is for, or half of its free contraction: pulls at contractions.
    pub pulls: Vec<PullAt>,
    /// Free contractions at the pressures of the test sheet: pressure in MPa, contraction.
    pub free_contractions: Vec<(f64, f64)>,
    /// What to measure, where its pull has a ±.
    pub to_measure: Option<ToMeasure>,
}

/// A pull of the muscle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PullAt {
    /// Gauge pressure.
    pub pressure_mpa: f64,
    /// Share of the rest length.
    pub contraction: f64,
    /// What is required of it in N, where it was designed for this.
    pub required_n: Option<f64>,
    /// By the model.
    pub force_n: f64,
    /// Of a muscle that is built.
    pub built: Option<Built>,
}

impl PullAt {
    /// What it pulls as built in N: the least, the median and the most; by the model where no more
    /// is known.
    pub fn range_n(&self) -> [f64; 3] {
        self.built.map_or([self.force_n; 3], |b| {
            [b.predicted_low_n, b.predicted_n, b.predicted_high_n]
        })
    }
}

/// What each end carries: the pull, and the pressure on the bore.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, schemars::JsonSchema)]
pub struct EndLoads {
    /// Largest load of an end in the stated use, N: while the muscle lengthens, at the relief
    /// pressure, at the longest length of its job, else at L0.
    pub end_load_n: f64,
    /// Load of an end in the proof test, N: stretched by 2 % of L0.
    pub proof_end_load_n: f64,
    /// Lower end of its 95 % interval, N.
    pub proof_end_load_low_n: f64,
    /// Upper end of its 95 % interval, N: bolts, plugs and ferrules are chosen by it.
    pub proof_end_load_high_n: f64,
    /// Load in the proof test over that in use.
    pub proof_to_use: f64,
    /// Load in the proof test over that at the relief pressure, stretched by 2 % of L0.
    pub proof_to_stretched: f64,
}

impl EndLoads {
    /// The load in the proof test in N, and the most that it may be as built.
    pub(crate) fn proof_n(&self) -> [f64; 2] {
        [self.proof_end_load_n, self.proof_end_load_high_n]
    }

    /// The pressure in MPa to work at, below the relief valve, where the proof loads the ends with so
    /// many times what use does.
    pub fn proved_mpa(&self, operating: &Operating, times: f64) -> f64 {
        let relief_mpa = operating.in_use.pressure_mpa * self.proof_to_use / times;
        rounded(relief_mpa / RELIEF, 2, f64::floor)
    }

    /// What each end of a muscle carries.
    pub fn new(muscle: &Muscle, operating: &Operating) -> Self {
        let loads = |at: &PullAt| {
            at.range_n()
                .map(|n| clamp_load_n(muscle, n.max(0.0), at.pressure_mpa))
        };
        let [low, proof, high] = loads(&operating.proof);
        let [_, in_use, _] = loads(&operating.in_use);
        let [_, stretched, _] = loads(&operating.stretched);
        Self {
            end_load_n: in_use,
            proof_end_load_n: proof,
            proof_end_load_low_n: low,
            proof_end_load_high_n: high,
            proof_to_use: proof / in_use,
            proof_to_stretched: proof / stretched,
        }
    }
}

/// Measurements that leave less of the ± of a pull at the working pressure.
#[derive(Debug, Clone, PartialEq)]
pub struct ToMeasure {
    /// Where the muscle pulls.
    pub contraction: f64,
    /// Half of the 95 % interval of the pull in N, before.
    pub uncertainty_n: f64,
    /// What each leaves of it, the best first.
    pub left: Vec<Left>,
}

/// Pressures of the tests, and the energy of their air.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, schemars::JsonSchema)]
pub struct Safety {
    /// Working pressure, MPa.
    pub pressure_mpa: f64,
    /// Pressure of the proof test with water, MPa: twice the working pressure, at most three
    /// quarters of the burst pressure and what stretches the strands to their limit.
    pub proof_pressure_mpa: f64,
    /// Pressure of the leak test, MPa.
    pub leak_pressure_mpa: f64,
    /// Energy of the air at the working pressure, J, at most: p V ln(p/p₀); none of a liquid.
    pub air_energy_j: Option<f64>,
    /// Energy that rubber and strands store at most at the working pressure, J: P times what the
    /// cavity grows.
    pub wall_energy_j: f64,
}

impl Operating {
    /// Energy in J of air that fills it at the working pressure.
    pub(crate) fn air_energy_j(&self) -> f64 {
        energy_j(self.pressure_mpa, self.volume_mm3)
    }
}

impl Safety {
    /// The tests of a muscle.
    pub(crate) fn new(operating: &Operating, rest_mm3: f64, liquid: bool) -> Self {
        Self {
            pressure_mpa: operating.pressure_mpa,
            proof_pressure_mpa: operating.proof.pressure_mpa,
            leak_pressure_mpa: operating.pressure_mpa,
            air_energy_j: (!liquid).then(|| operating.air_energy_j()),
            wall_energy_j: 1e-3
                * operating.pressure_mpa
                * (operating.volume_mm3 - rest_mm3).max(0.0),
        }
    }
}

/// The pressure of a relief valve in MPa to three digits: above the one that is set, and not above
/// the highest that the muscle may have.
pub fn relief_mpa(pressure_mpa: f64, highest_mpa: f64) -> f64 {
    let relief = highest_mpa.min(RELIEF * pressure_mpa);
    rounded(relief * (1.0 + 1e-9), 3, f64::floor).max(pressure_mpa.min(highest_mpa))
}

/// Energy in J of air at a gauge pressure: E = p V ln(p/p₀), p absolute. It is the work of an
/// isothermal expansion to the atmosphere, an upper bound of the work of the air.
pub fn energy_j(gauge_mpa: f64, volume_mm3: f64) -> f64 {
    let absolute = gauge_mpa.max(0.0) + ATMOSPHERE_MPA;
    1e-3 * absolute * volume_mm3 * (absolute / ATMOSPHERE_MPA).ln()
}
