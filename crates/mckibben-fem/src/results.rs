//! What an equilibrium tells, whichever elements found it.

use crate::{Result, solver::body::Body};
use mckibben_core::{by_number::SortByNumber, extremes::peak, model::Response, muscle::Muscle};
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::PI;

/// A place along the muscle, from the middle (z = 0) to the terminal.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "ProfileRow")]
pub struct ProfilePoint {
    /// Z at rest, mm.
    pub rest_z_mm: f64,
    /// z of the outer surface, mm.
    pub outer_z_mm: f64,
    /// r of the outer surface, mm.
    pub outer_r_mm: f64,
    /// z of the inner surface, mm.
    pub inner_z_mm: f64,
    /// r of the inner surface, mm.
    pub inner_r_mm: f64,
}

/// The strands at a place along the muscle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "StrandRow")]
pub struct StrandState {
    /// Z at rest, mm.
    #[serde(rename = "rest_z_mm")]
    pub rest_mm: f64,
    /// Stretch λf of a strand.
    pub stretch: f64,
    /// Angle to the axis now, degrees: tanθ = tanθ0 λθ/λm.
    pub angle_deg: f64,
    /// Tension of a family per width at rest, N/mm.
    pub tension_n_per_mm: f64,
    /// Tension of one strand, N, where their number is known.
    #[serde(rename = "strand_tension_n")]
    pub tension_n: Option<f64>,
}

/// A principal stretch and where it is.
#[derive(Debug, Clone)]
pub struct StretchAt {
    /// The stretch.
    pub value: f64,
    /// R and Z at rest in mm.
    pub rest_mm: [f64; 2],
}

/// Share of the rubber's volume that is stretched further than what is called the largest stretch.
const BEYOND: f64 = 0.01;

/// Of stretches with the volume of rubber that has each, the one below which 99 % of the volume
/// lies: at the bonded corner the largest of all grows without bound as the mesh gets finer.
pub(crate) fn largest_of_most(mut list: Vec<(StretchAt, f64)>) -> StretchAt {
    list.sort_by_number(|a| -a.0.value);
    let beyond = BEYOND * list.iter().map(|s| s.1).sum::<f64>();
    let mut sum = 0.0;
    let mut last: Option<(f64, StretchAt)> = None;
    for (at, volume) in list {
        // A sample represents its volume, half of which is stretched further.
        let share = sum + 0.5 * volume;
        sum += volume;
        if share >= beyond {
            let Some((before, larger)) = last else {
                return at;
            };
            let t = (beyond - before) / (share - before);
            return StretchAt {
                value: larger.value + t * (at.value - larger.value),
                ..at
            };
        }
        last = Some((share, at));
    }
    last.map_or(
        StretchAt {
            value: 1.0,
            rest_mm: [0.0; 2],
        },
        |(_, at)| at,
    )
}

/// A node of a deformed body, for pictures and files: places have `N` components, its stress `M`.
#[derive(Debug, Clone, Copy)]
pub struct FieldNode<const N: usize, const M: usize> {
    /// Place at rest in mm.
    pub rest_mm: [f64; N],
    /// Place now in mm.
    pub now_mm: [f64; N],
    /// Stretches: λθ of a line that ran around the muscle at rest, λm of one that ran along it, the
    /// largest principal one.
    pub stretches: [f64; 3],
    /// Cauchy stress in MPa, with the pressure in the rubber.
    pub stress_mpa: [f64; M],
}

/// Nodes whose stretches and stress are means over the elements that meet there.
pub(crate) struct NodeMeans<const N: usize, const M: usize>(Vec<(FieldNode<N, M>, f64)>);

impl<const N: usize, const M: usize> NodeMeans<N, M> {
    pub fn new(count: usize) -> Self {
        Self(vec![
            (
                FieldNode {
                    rest_mm: [0.0; N],
                    now_mm: [0.0; N],
                    stretches: [0.0; 3],
                    stress_mpa: [0.0; M]
                },
                0.0
            );
            count
        ])
    }

    /// Adds what an element gives at a node.
    pub fn add(&mut self, node: usize, at: &FieldNode<N, M>) {
        let (sum, count) = &mut self.0[node];
        sum.rest_mm = at.rest_mm;
        sum.now_mm = at.now_mm;
        *count += 1.0;
        let values = at.stretches.iter().chain(&at.stress_mpa);
        sum.stretches
            .iter_mut()
            .chain(&mut sum.stress_mpa)
            .zip(values)
            .for_each(|(sum, x)| *sum += x);
    }

    /// The nodes.
    pub fn means(self) -> Vec<FieldNode<N, M>> {
        let mean = |(mut node, count): (FieldNode<N, M>, f64)| {
            node.stretches
                .iter_mut()
                .chain(&mut node.stress_mpa)
                .for_each(|x| *x /= count);
            node
        };
        self.0.into_iter().map(mean).collect()
    }
}

/// Energies of the whole muscle.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub struct Energies {
    /// Elastic energy of the rubber in N·mm (mJ).
    pub rubber_n_mm: f64,
    /// Elastic energy of the strands in N·mm (mJ).
    pub braid_n_mm: f64,
    /// Energy of the ends that slip, ½ c N², in N·mm (mJ); c the slip, N the load of a clamp.
    pub ends_n_mm: f64,
    /// P (V − V0) in N·mm (mJ): the work the pressure source can give at this pressure.
    pub pressure_n_mm: f64,
}

/// Everything an equilibrium tells.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Solution {
    /// What every model tells.
    pub response: Response,
    /// Places of the nodes, from the middle to the terminal.
    pub profile: Vec<ProfilePoint>,
    /// The strands along the muscle.
    pub strands: Vec<StrandState>,
    /// The principal stretch below which 99 % of the rubber lies by volume.
    pub max_stretch: StretchAt,
    /// Energies of the whole muscle.
    pub energies: Energies,
    /// Directions in which the equilibrium is unstable with the terminals held; 0 for a stable one.
    pub unstable_directions: usize,
    /// Smallest volume ratio of the rubber at an integration point.
    pub smallest_j: f64,
    /// ∂F/∂(constants and measures) at fixed P and ε.
    pub sensitivities: Vec<Sensitivity>,
}

/// ∂F of one constant or measure.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "SensitivityRow")]
pub struct Sensitivity {
    /// Key as in the muscle file: `tube.material.c10`, `tube.outer_diameter`, `braid.stiffness`, …
    pub name: String,
    /// Its value.
    pub value: f64,
    /// Its unit.
    pub unit: &'static str,
    /// ∂F in N per that unit, all others (k among them) held.
    pub force_n_per_unit: f64,
}

/// A body that is a muscle: what its present equilibrium tells.
pub trait MuscleBody: Body {
    /// Factorises the tangent; dF/dw for a displacement of one terminal in N/mm, ∂F/∂P in mm² and
    /// ∂V/∂P in mm³/MPa of the whole muscle.
    fn derivatives(&mut self) -> Result<[f64; 3]>;

    /// Volume of the cavity at rest of the whole muscle, in mm³.
    fn rest_volume_mm3(&self, muscle: &Muscle) -> f64;

    /// Places of the nodes, from the middle to the terminal.
    fn profile(&self) -> Vec<ProfilePoint>;

    /// The strands from the middle to the terminal.
    fn strands(&self, muscle: &Muscle) -> Vec<StrandState>;

    /// Largest outer radius in mm.
    fn bulge_mm(&self) -> f64;

    /// The stretch below which 99 % of the rubber lies.
    fn largest_stretch(&self) -> StretchAt;

    /// The largest stretch in the middle plane of the muscle.
    fn middle_stretch(&self) -> f64;

    /// ∂F/∂(constants and measures) with the tangent that [`MuscleBody::response`] has factorised;
    /// none where it does not know them.
    ///
    /// # Errors
    /// [`FemError`](crate::FemError) where a neighbouring muscle cannot be assembled.
    fn sensitivities(&mut self, _muscle: &Muscle) -> Result<Vec<Sensitivity>> {
        Ok(vec![])
    }

    /// What every model answers; factorises the tangent.
    fn response(&mut self, muscle: &Muscle) -> Result<Response> {
        let [stiffness, force_per_pressure, volume_per_pressure] = self.derivatives()?;
        let state = self.state();
        let totals = self.totals();
        let largest = peak(self.strands(muscle).iter().map(|s| s.tension_n_per_mm));
        let cos = muscle.braid().angle_rad().cos();
        let count = muscle.braid().strands.map(|s| s.count);
        let all = 2.0 * PI * (2.0 * muscle.strand_lay().radius_mm) * cos * largest;
        Ok(Response {
            // Zeros without a sign.
            pressure_mpa: state.pressure + 0.0,
            contraction: 0.0 - state.terminal / self.half_length(),
            force_n: totals.pull,
            volume_mm3: Some(Self::COPIES * totals.volume),
            volume_per_pressure_mm3_per_mpa: Some(volume_per_pressure),
            volume_per_contraction_mm3: Some(muscle.length_mm() * force_per_pressure),
            stiffness_n_per_mm: Some(0.5 * stiffness),
            force_per_pressure_mm2: Some(force_per_pressure),
            braid_tension_n: Some(all),
            strand_tension_n: count.map(|n| all / f64::from(n)),
            bulged_diameter_mm: Some(2.0 * self.bulge_mm()),
            middle_stretch: Some(self.middle_stretch()),
            max_stretch: Some(self.largest_stretch().value),
        })
    }

    /// Everything; factorises the tangent.
    fn solution(&mut self, muscle: &Muscle) -> Result<Solution> {
        let response = self.response(muscle)?;
        let sensitivities = self.sensitivities(muscle)?;
        let pressure = self.state().pressure;
        let totals = self.totals();
        Ok(Solution {
            profile: self.profile(),
            strands: self.strands(muscle),
            max_stretch: self.largest_stretch(),
            energies: Energies {
                rubber_n_mm: Self::COPIES * totals.rubber,
                braid_n_mm: Self::COPIES * totals.braid,
                ends_n_mm: 0.0,
                pressure_n_mm: pressure
                    * (Self::COPIES * totals.volume - self.rest_volume_mm3(muscle)),
            },
            unstable_directions: self.unstable_directions(),
            smallest_j: totals.smallest_j,
            sensitivities,
            response,
        })
    }
}
