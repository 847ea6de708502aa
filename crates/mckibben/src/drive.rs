//! A simulation of one muscle in a control loop, in a few words.

use crate::{Load, MuscleModel};
use mckibben_motion::{
    Actuated, Actuator, Command, Commanded, Drive, MotionError, Simulation, SingleMuscle,
};
use std::ops::RangeInclusive;

/// One muscle on a regulator, with a load: begun by [`MuscleModel::drive`]. A valve, a joint or a
/// liquid stands in a [`Drive`].
#[derive(Clone)]
pub struct DriveBuilder {
    load: SingleMuscle,
    muscle: Actuated,
    step_s: f64,
}

impl MuscleModel {
    /// This muscle over time, with its friction; held at its ends, on a regulator of 50 ms, in steps
    /// of 1 ms, as long as nothing else is said.
    ///
    /// ```
    /// use mckibben::prelude::*;
    ///
    /// let model = Model::UNIVERSAL.of(&Muscle::prototype())?;
    /// let drive = model.drive().hanging_kg(10.0).damping_n_s_per_m(500.0).stops_mm(0.0..=80.0);
    /// let mut simulation = drive.regulator(0.02).step_s(1e-3).build()?;
    /// for _ in 0..1000 {
    ///     simulation.step(&[0.2])?;
    /// }
    /// // At rest it bears the weight.
    /// assert!((simulation.force_n(0) - 98.07).abs() < 0.1, "{}", simulation.force_n(0));
    /// assert!(simulation.contraction(0) > 0.1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn drive(&self) -> DriveBuilder {
        let model = self.shared();
        let regulator = Actuator::Regulator {
            time_constant_s: 0.05,
        };
        DriveBuilder {
            load: SingleMuscle::held(&*model),
            muscle: Actuated {
                friction: self.muscle().friction().copied(),
                ..Actuated::new(model, regulator)
            },
            step_s: 1e-3,
        }
    }
}

impl DriveBuilder {
    /// A mass hangs from it.
    #[must_use]
    pub fn hanging_kg(mut self, mass_kg: f64) -> Self {
        self.load.load = Load::Mass {
            mass_kg,
            level: false,
        };
        self.load.added_mass_kg = 0.0;
        self
    }

    /// A damper beside the load.
    #[must_use]
    pub fn damping_n_s_per_m(mut self, damping_n_s_per_m: f64) -> Self {
        self.load.damping_n_s_per_m = damping_n_s_per_m;
        self
    }

    /// Its shortening lies between stops.
    #[must_use]
    pub fn stops_mm(mut self, stops_mm: RangeInclusive<f64>) -> Self {
        self.load.stops_mm = stops_mm.into_inner();
        self
    }

    /// The time constant of its regulator.
    #[must_use]
    pub fn regulator(mut self, time_constant_s: f64) -> Self {
        self.muscle.actuator = Actuator::Regulator { time_constant_s };
        self
    }

    /// The length of a step.
    #[must_use]
    pub fn step_s(mut self, step_s: f64) -> Self {
        self.step_s = step_s;
        self
    }

    /// At rest without pressure; its commands are pressures in MPa.
    ///
    /// # Errors
    /// [`MotionError`] of numbers that are no drive.
    pub fn build(self) -> Result<Simulation, MotionError> {
        let target = Commanded::Pressure(vec![Command::Constant(0.0)]);
        Simulation::new(&Drive {
            output_step_s: self.step_s,
            ..Drive::new(self.load, vec![self.muscle], target, 1.0)
        })
    }
}
