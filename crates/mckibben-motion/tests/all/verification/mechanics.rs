//! Muscles that move: balances, friction, oscillations, convergence.

use super::{driven, opening, ran, rows::Rows};
use mckibben_core::{
    extremes::ends,
    load::Load,
    model::{ForceModel, Ideal, ModelKind, ThickWall, Workspace},
    muscle::{Friction, Muscle},
};
use mckibben_motion::{
    ATMOSPHERE_MPA, Actuated, Actuator, Air, Branch, Command, Commanded, Drive, Energies, Fluid,
    Heat, Linear, Orifice, Prony, SingleMuscle, Valve, equilibrium,
};
use std::f64::consts::TAU;
use std::sync::Arc;

fn valve() -> Option<Actuator> {
    Some(Actuator::Valve(Valve::new(Orifice::new(0.5, 0.3).ok()?)))
}

fn universal() -> Option<Arc<dyn ForceModel>> {
    let model = ModelKind::Universal.build(&Muscle::prototype()).ok()?;
    Some(model.into())
}

/// Mass, spring, damper, friction, viscoelastic rubber and warm air at once.
pub fn balances(rows: &mut Rows) {
    let model = universal().unwrap();
    let line = Load::parse("mass:5kg+spring:1N/mm", &|_| None).unwrap();
    let load = SingleMuscle {
        damping_n_s_per_m: 200.0,
        stops_mm: (0.0, 60.0),
        ..SingleMuscle::new(&*model, line)
    };
    for (name, heat) in [
        ("isothermal", Heat::Isothermal),
        ("adiabatic", Heat::Adiabatic),
        ("warm", Heat::Transfer(50.0)),
    ] {
        let mut muscle = Actuated::new(model.clone(), valve().unwrap());
        muscle.fluid = Fluid::Air(Air {
            heat,
            dead_volume_mm3: 10e3,
            ..Air::default()
        });
        muscle.friction = Some(Friction::power_law(20.0, 0.7));
        muscle.rubber = Prony(vec![Branch {
            share: 0.2,
            time_constant_s: 0.05,
        }]);
        let steps = Command::Steps(vec![(0.0, 0.0), (0.1, 0.2), (0.8, 0.05)]);
        let motion = ran(&driven(
            &load,
            muscle,
            Commanded::Pressure(vec![steps]),
            (1.5, 1e-9),
        ));
        let share = |value: &dyn Fn(&Energies) -> f64| {
            motion
                .as_ref()
                .map(|m| (value(&m.energies) / m.energies.work_j).abs())
        };
        let air =
            share(&|e| e.enthalpy_in_j - e.enthalpy_out_j + e.heat_j - e.internal_j - e.gas_work_j);
        let work = share(&|e| {
            let pulled = e.static_work_j + e.viscoelastic_j - e.friction_j;
            pulled - e.load_j - e.kinetic_j - e.damper_j - e.impacts_j
        });
        let mut row = |what: &str, ours: Option<f64>, tolerance| {
            let name = format!("drive, {name} air: {what}");
            rows.add(name, 0.0, ours, tolerance);
        };
        let lost = motion.as_ref().map(|m| m.mass_defect);
        row("air that is lost, of that in it", lost, 1e-12);
        row("energy of the air that is lost, of the work", air, 1e-6);
        row("work that is lost, of it", work, 1e-6);
    }
}

/// The frequency of a mass on shut air: closed form, linearised system, and crossings of a motion.
pub fn shut(rows: &mut Rows) {
    let values = |heat: Heat, index: f64| {
        let model = universal()?;
        let load = SingleMuscle::hanging(&*model, 10.0);
        let mut muscle = Actuated::new(model.clone(), valve()?);
        muscle.fluid = Fluid::Air(Air {
            heat,
            dead_volume_mm3: 10e3,
            ..Air::default()
        });
        muscle.initial_pressure_mpa = Some(0.2);
        let drive = driven(&load, muscle, opening(0.0), (1.0, 1e-6));
        let linear = Linear::new(&drive).ok()?;
        Some((
            closed_form(&*model, &drive, index)?,
            linear.oscillation()?.0,
            crossings(&drive, &linear, 10.0),
        ))
    };
    for (name, heat, index) in [
        ("isothermal", Heat::Isothermal, 1.0),
        ("adiabatic", Heat::Adiabatic, 1.4),
    ] {
        let (exact, linear, moving) =
            values(heat, index).map_or((None, None, None), |v| (Some(v.0), Some(v.1), v.2));
        for (what, ours) in [
            ("of the linearised system", linear),
            ("of its motion", moving),
        ] {
            let name = format!("10 kg on shut {name} air: {what} (Hz)");
            rows.add(name, exact, ours, 1e-4);
        }
    }
}

/// (dP/dε)_m = −n p V_ε/(V + n p V_P); K = K_P − (1/L0) ∂F/∂P dP/dε; f = √(K/M)/2π
fn closed_form(model: &dyn ForceModel, drive: &Drive, index: f64) -> Option<f64> {
    let length = model.muscle().length_mm();
    let contraction = equilibrium(drive, &[0.2]).ok()?.coordinate / length;
    let r = model
        .response(&mut Workspace::new(), 0.2, contraction)
        .ok()?;
    let p = 0.2 + ATMOSPHERE_MPA;
    let volume = r.volume_mm3? + 10e3;
    let slope = -index * p * r.volume_per_contraction_mm3?
        / (volume + index * p * r.volume_per_pressure_mm3_per_mpa?);
    let stiffness = r.stiffness_n_per_mm? - r.force_per_pressure_mm2? * slope / length;
    Some((1e3 * stiffness / 10.0).sqrt() / TAU)
}

/// The frequency in Hz by the falling crossings of some periods after a displacement of a hundredth
/// of a mm.
fn crossings(drive: &Drive, linear: &Linear, periods: f64) -> Option<f64> {
    let (f, _) = linear.oscillation()?;
    let mut drive = drive.clone();
    drive.initial_coordinate = Some(linear.coordinate + 0.01);
    drive.tolerance = 1e-9;
    (drive.until_s, drive.output_step_s) = ((periods + 0.5) / f, 0.002 / f);
    let motion = ran(&drive)?;
    let x: Vec<f64> = motion
        .series
        .coordinate
        .iter()
        .map(|x| x - linear.coordinate)
        .collect();
    let falls: Vec<f64> = (1..x.len())
        .filter(|&i| x[i - 1] > 0.0 && x[i] <= 0.0)
        .map(|i| motion.series.time_s[i - 1] + drive.output_step_s * x[i - 1] / (x[i - 1] - x[i]))
        .collect();
    let first = falls.first()?;
    let last = falls.last()?;
    Some((falls.len() - 1) as f64 / (last - first))
}

/// The area of a slow loop against a spring. After each of its two reversals z goes from 1 to −1
/// within 2 x_s, as 2 (1 − x/2x_s)² − 1, which takes 4/3 F_c x_s from it.
pub fn loops(rows: &mut Rows) {
    const LEVEL_N: f64 = 10.0;
    const PRESLIDING_MM: f64 = 0.02;
    let one = |hz: f64| {
        let model = Ideal::between_ends(&Muscle::prototype());
        let spring = SingleMuscle {
            damping_n_s_per_m: 1e3,
            added_mass_kg: 1.0,
            ..SingleMuscle::new(
                &model,
                Load::Spring {
                    rate_n_per_mm: 5.0,
                    preload_n: 0.0,
                },
            )
        };
        let until = |periods: f64| {
            let mut muscle = Actuated::new(
                model.clone(),
                Actuator::Regulator {
                    time_constant_s: 0.02,
                },
            );
            muscle.friction = Some(Friction {
                presliding_mm: Some(PRESLIDING_MM),
                ..Friction::power_law(LEVEL_N, 0.0)
            });
            let sine = Command::Sine {
                mean: 0.15,
                amplitude: 0.08,
                frequency_hz: hz,
                phase_rad: 0.0,
            };
            ran(&driven(
                &spring,
                muscle,
                Commanded::Pressure(vec![sine]),
                (periods / hz, 1e-8),
            ))
        };
        let one = until(1.0)?;
        let two = until(2.0)?;
        let x = &two.series.coordinate[two.series.coordinate.len() / 2..];
        let (least, most) = ends(x.iter().copied());
        let stroke = most - least;
        let area = 1e3 * (two.energies.friction_j - one.energies.friction_j);
        Some((2.0 * LEVEL_N * (stroke - 4.0 / 3.0 * PRESLIDING_MM), area))
    };
    for hz in [0.1, 1.0] {
        let (exact, ours) = one(hz).unzip();
        let name = format!("friction loop of the braid at {hz} Hz (N mm)");
        rows.add(name, exact, ours, 1e-4);
    }
}

/// The error of a step at tolerances.
pub fn convergence(rows: &mut Rows) {
    // Its answers have no error of an iteration that a step could see.
    let model = ThickWall::between_ends(&Muscle::prototype());
    let end = |relative: f64| {
        let load = SingleMuscle {
            stops_mm: (0.0, 90.0),
            damping_n_s_per_m: 50.0,
            ..SingleMuscle::hanging(&model, 10.0)
        };
        let steps = Command::Steps(vec![(0.0, 0.0), (0.05, 0.2)]);
        let muscle = Actuated::new(model.clone(), valve()?);
        let drive = driven(
            &load,
            muscle,
            Commanded::Pressure(vec![steps]),
            (0.5, relative),
        );
        ran(&drive)?.series.coordinate.last().copied()
    };
    let exact = end(1e-12);
    for relative in [1e-6, 1e-8, 1e-10] {
        let error = end(relative).zip(exact).map(|(x, exact)| x / exact - 1.0);
        let name = format!("step of 10 kg, tolerance {relative:.0e}: error");
        rows.add(name, 0.0, error, 10.0 * relative);
    }
}
