//! Drives of all kinds, drawn from a fixed seed.

use crate::support::{note_muscle, regulator, sprung, steps};
use mckibben_core::{
    model::{ForceModel, ModelKind},
    muscle::Friction,
    progress::Silent,
};
use mckibben_motion::*;
use std::sync::Arc;

/// Numbers in 0 … 1, always the same.
struct Draw(u64);

impl Draw {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / (1u64 << 31) as f64
    }

    fn power(&mut self, low: f64, high: f64) -> f64 {
        10f64.powf(low + (high - low) * self.next())
    }

    fn actuator(&mut self) -> Actuator {
        if self.next() < 0.2 {
            return regulator(0.001 + 0.1 * self.next());
        }
        let hysteresis_mpa = 0.002 + 0.01 * self.next();
        let kind = match (4.0 * self.next()) as u32 {
            0 => ValveKind::OnOff {
                hysteresis_mpa,
                closed_centre: false,
            },
            1 => ValveKind::OnOff {
                hysteresis_mpa,
                closed_centre: true,
            },
            2 => ValveKind::DEFAULT,
            _ => ValveKind::Proportional {
                time_constant_s: 0.01,
                gain_per_mpa: 100.0,
            },
        };
        let orifice = Orifice::new(self.power(-1.5, 0.5), 0.45 * self.next()).unwrap();
        let hose = Hose::new(2.0 + 4.0 * self.next(), 1.0 + 1000.0 * self.next()).unwrap();
        let hose = (self.next() < 0.5).then_some(hose);
        Actuator::Valve(Valve {
            kind,
            hose,
            ..Valve::new(orifice)
        })
    }

    fn target(&mut self, regulated: bool) -> Commanded {
        let sine = |frequency_hz| Command::Sine {
            mean: 0.25,
            amplitude: 0.2,
            frequency_hz,
            phase_rad: 0.0,
        };
        match (4.0 * self.next()) as u32 {
            0 => steps(&[
                (0.0, 0.0),
                (0.05, 0.1 + 0.4 * self.next()),
                (0.5, 0.3 * self.next()),
            ]),
            1 => Commanded::Pressure(vec![sine(1.0 + 5.0 * self.next())]),
            2 if !regulated => {
                let opened = vec![(0.0, -1.0), (0.05, 1.0), (0.3, 0.0), (0.6, -1.0)];
                Commanded::Opening(vec![Command::Steps(opened)])
            }
            _ => {
                let output = if regulated {
                    PidOutput::Pressure { bias_mpa: 0.0 }
                } else {
                    PidOutput::Opening
                };
                let pid = Pid {
                    proportional: if regulated { 1.0 } else { 10.0 },
                    integral_per_s: 3.0,
                    derivative_s: 0.02 * self.next(),
                    filter_s: 0.01,
                    tracking_s: 0.1,
                    output,
                };
                Commanded::Position {
                    command: Command::Steps(vec![(0.0, 0.05), (0.1, 0.2 * self.next())]),
                    pid,
                }
            }
        }
    }
}

#[test]
fn identity_random_drives_come_to_their_end_with_their_air_and_energy() {
    let model: Arc<dyn ForceModel> = ModelKind::ThickWall.build(&note_muscle()).unwrap().into();
    let draw = &mut Draw(12345);
    for _ in 0..100 {
        let load = SingleMuscle {
            stops_mm: (
                if draw.next() < 0.7 { 0.0 } else { -1e3 },
                if draw.next() < 0.5 { 40.0 } else { 1e3 },
            ),
            damping_n_s_per_m: if draw.next() < 0.3 {
                0.0
            } else {
                draw.power(1.0, 3.0)
            },
            ..SingleMuscle::new(&*model, sprung(draw.power(-1.0, 1.3), 3.0 * draw.next()))
        };
        let actuator = draw.actuator();
        let target = draw.target(matches!(actuator, Actuator::Regulator { .. }));
        let mut muscle = Actuated::new(model.clone(), actuator);
        let dead_volume_mm3 = 20e3 * draw.next();
        let heat = match (4.0 * draw.next()) as u32 {
            0 => Heat::Adiabatic,
            1 => Heat::Transfer(100.0 * draw.next()),
            2 => Heat::Polytropic(1.2),
            _ => Heat::Isothermal,
        };
        muscle.fluid = Fluid::Air(Air {
            heat,
            dead_volume_mm3,
            ..Air::default()
        });
        let (coefficient, presliding_mm) = (40.0 * draw.next(), Some(0.05 + draw.next()));
        let lever_mm = if coefficient > 20.0 { 0.5 } else { 0.0 };
        let level = Friction {
            presliding_mm,
            lever_mm,
            ..Friction::power_law(coefficient, 0.7)
        };
        muscle.friction = (draw.next() < 0.5).then_some(level);
        if draw.next() < 0.4 {
            muscle.rubber = Prony(vec![Branch {
                share: 0.4 * draw.next(),
                time_constant_s: draw.power(-2.0, 0.0),
            }]);
        }
        let said = format!(
            "{actuator:?} {target:?} {load:?} {:?} {:?}",
            muscle.fluid, muscle.friction
        );
        let motion = match run(
            &Drive::new(load.clone(), vec![muscle], target, 1.0),
            &Silent,
        ) {
            Ok(motion) => motion,
            Err(MotionError::NeverLifted(_)) => continue,
            Err(error) => panic!("{error}: {said}"),
        };
        let e = motion.energies;
        let scale = 1.0 + e.enthalpy_in_j.abs() + e.work_j;
        let air = e.enthalpy_in_j - e.enthalpy_out_j + e.heat_j - e.internal_j - e.gas_work_j;
        let pulled = e.static_work_j + e.viscoelastic_j - e.friction_j;
        let used = e.load_j + e.kinetic_j + e.damper_j + e.impacts_j;
        assert!(motion.mass_defect < 1e-12, "{} {said}", motion.mass_defect);
        // At the default tolerance of 1e-6.
        assert!(
            air.abs() < 1e-4 * scale && (pulled - used).abs() < 1e-4 * scale,
            "{e:?} {said}"
        );
        assert!(
            motion
                .series
                .coordinate
                .iter()
                .chain(&motion.series.muscles[0].force_n)
                .all(|v| v.is_finite())
        );
    }
}
