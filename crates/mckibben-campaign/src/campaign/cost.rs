//! What a plan will cost, before it is begun.

use super::plan::Plan;
use mckibben::size::TooLarge;
use mckibben_fem::FemError;
use mckibben_fem::elements::Elements;
use mckibben_fem::three_dimensional::BrickMesh;
use serde::Serialize;

/// Bytes of an answer in a compressed table: 6.8 to 7.1 were measured.
const BYTES_OF_AN_ANSWER: f64 = 7.0;
/// Answers of a point, without the tension of one strand and the sensitivities.
const ANSWERS: usize = 7;
/// Bytes of what varies, which a muscle has once.
const BYTES_OF_AN_INPUT: f64 = 8.0;
/// Bytes of an empty table: its columns' descriptions; the plan comes on top.
const BYTES_OF_A_FILE: f64 = 4000.0;

/// Muscles of a plan whose meshes are looked at.
const LOOKED_AT: u64 = 64;
/// Elements along a muscle up to which a point takes the usual number of steps.
const USUAL_ALONG: f64 = 12.0;

/// A hundred points of 600 bricks.
fn bricks_per_second(through: u64, sheet: u64) -> u64 {
    60_000 / (through * through * sheet).max(60)
}

/// About what a plan costs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Cost {
    /// Points, one row each.
    pub points: u64,
    /// Size of the table in bytes.
    pub bytes: f64,
    pub seconds: f64,
}

impl Cost {
    /// What is begun only on request: a table of 10 GB, a day.
    pub const LARGE: (f64, f64) = (10e9, 86_400.0);

    /// Whether it is begun only on request.
    pub fn is_large(&self) -> bool {
        self.bytes > Self::LARGE.0 || self.seconds > Self::LARGE.1
    }
}

impl Plan {
    /// Points that one thread solves in a good second with the usual mesh; between curves that pull and walls that fold there is a factor
    /// of ten. The size of the parts follows from it: it depends on the plan alone.
    pub(super) fn points_per_second(&self) -> u64 {
        match self.testing().elements {
            Elements::Axisymmetric(mesh) => {
                self.sections_per_second(mesh.through.unwrap_or(1) as u64, mesh.along.unwrap_or(6) as u64)
            }
            Elements::ThreeDimensional(spec) => bricks_per_second(
                spec.through.unwrap_or(1) as u64,
                (spec.around.unwrap_or(14) * spec.along.unwrap_or(45)) as u64,
            ),
        }
    }

    /// Time grows with the elements along and with the square of those through the wall.
    fn sections_per_second(&self, through: u64, along: u64) -> u64 {
        let most = if self.testing().sensitivities { 512 } else { 4096 };
        6 * most / (through * through * along).max(6)
    }

    /// The same with the mesh that a muscle of the plan gets; none where it gets none.
    fn points_per_second_of(&self, number: u64) -> Option<f64> {
        let muscle = self.inputs(number).muscle().ok()?;
        let (tube, half) = (muscle.tube(), 0.5 * muscle.length_mm());
        Some(match self.testing().elements {
            Elements::Axisymmetric(mesh) => {
                let (through, along, _) = mesh.resolve(tube.outer_radius_mm(), tube.wall_mm, half).ok()?;
                let plain = self.sections_per_second(through as u64, along as u64) as f64;
                // The slimmer a muscle, the more steps a point takes: some eighty times as many at a thousand elements.
                plain / (along as f64 / USUAL_ALONG).max(1.0)
            }
            Elements::ThreeDimensional(spec) => {
                let (inner, outer) = (tube.inner_radius_mm(), tube.outer_radius_mm());
                let angle = muscle.braid().angle_rad();
                let [through, around, along, bonded] =
                    BrickMesh::count(inner, outer, half, angle, &spec).ok()?;
                bricks_per_second(through as u64, (around * (along + bonded)) as u64) as f64
            }
        })
    }

    /// Refuses meshes that do not fit into memory, of some of the muscles.
    pub fn admit(&self) -> Result<(), TooLarge> {
        for number in self.some() {
            let Ok(muscle) = self.inputs(number).muscle() else { continue };
            // What is no mesh is a row without an answer.
            if let Err(FemError::Large(large)) = self.testing().elements.admit(&muscle) {
                return Err(large);
            }
        }
        Ok(())
    }

    /// Numbers of some muscles, evenly over the plan.
    fn some(&self) -> impl Iterator<Item = u64> {
        let all = self.muscles();
        let count = all.min(LOOKED_AT);
        (0..count).map(move |i| i * (all / count.max(1)))
    }

    /// About what so many of its muscles cost on a number of threads.
    pub fn cost(&self, muscles: u64, threads: usize) -> Cost {
        let points = muscles.saturating_mul(self.points_per_muscle() as u64);
        let strands = usize::from(self.base().braid().strands.is_some());
        let answers = (ANSWERS + strands + self.sensitivities().len()) as f64;
        let rates: Vec<f64> = self.some().filter_map(|number| self.points_per_second_of(number)).collect();
        let seconds: f64 = rates.iter().map(|rate| 1.0 / rate.max(1e-3)).sum();
        let rate = threads.max(1) as f64
            * if rates.is_empty() { f64::INFINITY } else { rates.len() as f64 / seconds };
        Cost {
            points,
            bytes: points as f64 * BYTES_OF_AN_ANSWER * answers
                + muscles as f64 * BYTES_OF_AN_INPUT * self.axes().len() as f64
                + BYTES_OF_A_FILE
                + self.text().len() as f64,
            seconds: points as f64 / rate,
        }
    }
}
