//! What a drive moves: a muscle with its load, or a joint.

use crate::{Model, Problem, ProblemKind, Result};
use mckibben_core::{joint::Joint, model::ForceModel, muscle::Friction};
use mckibben_motion::{Actuated, Commanded, Drive, DriveFile, SingleMuscle};
use std::sync::Arc;

/// What a drive moves, with its models.
pub struct Moved {
    pub choice: Model,
    pub joint: Option<Joint>,
    pub models: Vec<Arc<dyn ForceModel>>,
}

impl Moved {
    /// L0 of the first muscle in mm.
    pub fn length_mm(&self) -> f64 {
        self.models.first().map_or(0.0, |m| m.muscle().length_mm())
    }

    /// The muscle with its load, where no joint is moved.
    fn single(&self, file: &DriveFile) -> Result<Option<SingleMuscle>> {
        Ok(match (&self.joint, self.models.first()) {
            (None, Some(model)) if file.held.is_some() => Some(SingleMuscle::held(&**model)),
            (None, Some(model)) => {
                Some(SingleMuscle {
                    damping_n_s_per_m: file.damping_n_s_per_m,
                    stops_mm: file.stops_mm,
                    ..SingleMuscle::new(&**model, file.load.clone().ok_or_else(|| {
                    Problem::new(
                        ProblemKind::File,
                        "the drive has no [load], so that nothing moves",
                        "such as mass = \"10 kg\" in [load], or held = \"0 %\" for a muscle with \
                         fixed ends",
                    )
                })?)
                })
            }
            _ => None,
        })
    }

    /// The drive of a file.
    pub fn drive(&self, file: &DriveFile) -> Result<Drive> {
        let muscles = self.models.iter().enumerate().map(|(i, model)| Actuated {
            initial_pressure_mpa: file.start_mpa.get(i).copied(),
            fluid: file.fluid.clone(),
            friction: friction(file, model.muscle().friction()),
            rubber: file.rubber.clone(),
            ..Actuated::new(Arc::clone(model), file.actuator)
        });
        let muscles = muscles.collect();
        let target = self.target(file);
        let until_s = file.until_s;
        let single = self.single(file)?;
        let length_mm = single.as_ref().map_or(1.0, |single| single.length_mm);
        let initial_coordinate = file.held.or(file.start).map(|start| start * length_mm);
        let drive = match (single, &self.joint) {
            (Some(single), _) => Drive::new(single, muscles, target, until_s),
            (None, Some(joint)) => Drive::new(joint.clone(), muscles, target, until_s),
            (None, None) => return Err(Problem::missing("muscle", "what the drive moves")),
        };
        Ok(Drive {
            supply: file.supply,
            output_step_s: file.output_step_s,
            initial_coordinate,
            external: file.external.clone(),
            ..drive
        })
    }

    /// The commands of a file. A joint with one muscle takes one.
    pub fn target(&self, file: &DriveFile) -> Commanded {
        let mut target = file.target.clone();
        if let (Commanded::Pressure(list) | Commanded::Opening(list) | Commanded::Volume(list), 1) =
            (&mut target, self.models.len())
        {
            list.truncate(1);
        }
        target
    }
}

/// β where a drive states C of a muscle without friction (Tondu 2012 \[tondu2012\], 20°).
const EXPONENT: f64 = 0.57;

/// The friction of a muscle, with what the drive states of it.
fn friction(file: &DriveFile, own: Option<&Friction>) -> Option<Friction> {
    let friction = *own.or(file
        .friction_coefficient
        .map(|c| Friction::power_law(c, EXPONENT))
        .as_ref())?;
    Some(Friction {
        coefficient: file.friction_coefficient.unwrap_or(friction.coefficient),
        presliding_mm: file.presliding_mm.or(friction.presliding_mm),
        ..friction
    })
}
