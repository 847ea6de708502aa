//! A motion with everything in it as JSON, for `checks/motion.py`, which integrates the same
//! equations independently.

use mckibben_core::{
    load::Load,
    model::Ideal,
    muscle::{Braid, Friction, Muscle, Terminals, Tube},
    progress::Silent,
};
use mckibben_motion::*;
use std::io::Write;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let friction = Friction::power_law(15.0, 0.7);
    let tube = Tube {
        outer_diameter_mm: 20.0,
        wall_mm: 1.5,
        length_mm: 220.0,
        ..Tube::prototype()
    };
    let muscle = Muscle::new(
        tube,
        Braid {
            angle_deg: 24.0,
            ..Braid::paper()
        },
        Terminals::default(),
        Some(friction),
    )?;
    let model = Ideal::between_ends(&muscle);
    let load = SingleMuscle {
        damping_n_s_per_m: 150.0,
        ..SingleMuscle::new(&model, Load::parse("mass:5kg+spring:2N/mm@10N", &|_| None)?)
    };
    let (kind, hose) = (
        ValveKind::Proportional {
            time_constant_s: 0.005,
            gain_per_mpa: 20.0,
        },
        Some(Hose::new(4.0, 500.0)?),
    );
    let valve = Valve {
        kind,
        supply: Orifice::new(0.5, 0.3)?,
        exhaust: Orifice::new(0.6, 0.25)?,
        hose,
    };
    let mut actuated = Actuated::new(model.clone(), Actuator::Valve(valve));
    actuated.fluid = Fluid::Air(Air {
        heat: Heat::Conductance(0.2),
        dead_volume_mm3: 10e3,
        ..Air::default()
    });
    actuated.friction = Some(friction);
    let command = Command::Steps(vec![(0.0, 0.1), (0.1, 0.3), (0.6, 0.15)]);
    let mut drive = Drive::new(
        load.clone(),
        vec![actuated],
        Commanded::Pressure(vec![command]),
        1.0,
    );
    drive.output_step_s = 0.01;
    drive.tolerance = 1e-11;
    let motion = run(&drive, &Silent)?;
    writeln!(std::io::stdout(), "{}", serde_json::to_string(&motion)?)?;
    Ok(())
}
