//! Validation in shape: step responses and release speeds of a muscle of which length, diameter,
//! valve and pressure are not stated (data/tondu2012_motion). The limits are regressions: what was
//! found, rounded up.

use crate::support::{damped, ran};
use mckibben_core::{
    analysis::{Evaluation, Options},
    model::{ThickWall, Workspace},
    muscle::{Braid, BraidStiffness, Friction, Muscle, Rubber, Terminals, Tube},
    rubber::{Law, NeoHookean},
};
use mckibben_motion::*;

const STEPS: &str = include_str!("../../../../data/tondu2012_motion/step_response.csv");
const RELEASE: &str = include_str!("../../../../data/tondu2012_motion/quick_release_velocity.csv");

/// The static muscle of the same paper, 14 mm and 20°, of a modulus and length.
fn muscle(outer_diameter_mm: f64, mu_mpa: f64, length_mm: f64) -> Muscle {
    let rubber = Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa }));
    let tube = Tube::new(outer_diameter_mm, 0.49, length_mm, rubber);
    let braid = Braid {
        angle_deg: 20.0,
        stiffness: BraidStiffness::Inextensible,
        ..Braid::paper()
    };
    Muscle::new(tube, braid, Terminals::default(), None).unwrap()
}

/// Half the width of the static muscle's loops, 19.6 N at 1 bar and 49.2 N at 5 bar.
const FRICTION: Friction = Friction {
    coefficient: 73.1,
    exponent: 0.572,
    lever_mm: 0.0,
    presliding_mm: Some(0.5),
};

/// Rows of the rayon muscle: load in kg and the rest.
fn rayon(text: &str) -> Vec<Vec<f64>> {
    let rows = text.lines().filter_map(|line| line.strip_prefix("rayon,"));
    rows.map(|row| row.split(',').map(|v| v.parse().unwrap()).collect())
        .collect()
}

/// Where a curve first reaches a share of its end.
fn reaches(points: &[(f64, f64)], share: f64) -> f64 {
    let wanted = share * points[points.len() - 1].1;
    let i = (1..points.len()).find(|&i| points[i].1 >= wanted).unwrap();
    let ((t0, a), (t1, b)) = (points[i - 1], points[i]);
    t0 + (t1 - t0) * (wanted - a) / (b - a)
}

/// A mass lifted by the muscle, its valve opened to a supply of the step's pressure.
fn lifted(model: &ThickWall, mass_kg: f64, pressure_mpa: f64, conductance: f64) -> Vec<(f64, f64)> {
    let load = damped(model, mass_kg, 300.0, (0.0, 200.0));
    let valve = Actuator::Valve(Valve::new(Orifice::new(conductance, 0.3).unwrap()));
    let opened = Commanded::Opening(vec![Command::Constant(1.0)]);
    let mut muscle = Actuated::new(model.clone(), valve);
    muscle.initial_pressure_mpa = Some(0.0);
    let mut drive = Drive::new(load.clone(), vec![muscle], opened, 2.0);
    drive.initial_coordinate = Some(0.0);
    drive.supply.pressure_mpa = pressure_mpa;
    let motion = ran(&drive);
    motion
        .series
        .time_s
        .iter()
        .copied()
        .zip(motion.series.coordinate)
        .collect()
}

/// Pressure, modulus and length by the ends of the steps, the valve by one time; the other times
/// follow.
#[test]
fn steps_against_loads_have_the_measured_shape() {
    let rows = rayon(STEPS);
    let curve = |load: f64| -> Vec<(f64, f64)> {
        let points = rows.iter().filter(|r| r[0] == load).map(|r| (r[1], r[2]));
        std::iter::once((0.0, 0.0)).chain(points).collect()
    };
    let loads = [2.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0];
    let ends = loads.map(|kg| curve(kg).last().unwrap().1);
    let (pressure, mu, length) = (0.2, 0.15, 250.0);
    let muscle = muscle(14.0, mu, length);
    let model = ThickWall::between_ends(&muscle);
    let mut squares = 0.0;
    for (kg, end) in loads.iter().zip(ends) {
        let options = Options::extrapolating();
        let e = Evaluation::new(&model, &mut Workspace::new(), options)
            .contraction_at(kg * 9.80665, pressure)
            .unwrap();
        squares += (e * length - end).powi(2);
    }
    let rms_mm = (squares / loads.len() as f64).sqrt();
    println!("ends of the steps: rms {rms_mm:.1} mm of {:.1} mm", ends[0]);
    assert!(rms_mm < 4.0, "{rms_mm}");

    let conductance = 0.25;
    let (mut logs, mut n) = (0.0, 0.0);
    println!("load (kg): t25 t50 t75 t90 measured (ms), computed (ms)");
    for kg in loads {
        let (measured, computed) = (curve(kg), lifted(&model, kg, pressure, conductance));
        let times = |points: &[(f64, f64)]| {
            [0.25, 0.5, 0.75, 0.9].map(|share| 1e3 * reaches(points, share))
        };
        let (a, b) = (times(&measured), times(&computed));
        println!("{kg}: {a:.0?} {b:.0?}");
        for (a, b) in a.into_iter().zip(b) {
            logs += (b / a).ln().powi(2);
            n += 1.0;
        }
    }
    let typical = f64::exp((logs / n).sqrt());
    println!("typical ratio of times {typical:.3}");
    assert!(typical < 1.3, "{typical}");
}

/// The largest speed after the release from the length at rest over that of one load; the diameter
/// is fitted, by whole millimetres.
#[test]
fn release_speeds_fall_with_the_load_as_measured() {
    let rows = rayon(RELEASE);
    let muscle = muscle(11.0, 0.5, 300.0);
    let model = ThickWall::between_ends(&muscle);
    let speed = |mass_kg: f64| {
        let load = SingleMuscle::hanging(&model, mass_kg);
        let mut muscle = Actuated::new(
            model.clone(),
            Actuator::Valve(Valve::new(Orifice::new(0.5, 0.3).unwrap())),
        );
        muscle.fluid = Fluid::Air(Air {
            heat: Heat::Adiabatic,
            ..Air::default()
        });
        muscle.initial_pressure_mpa = Some(0.5);
        muscle.friction = Some(FRICTION);
        let mut drive = Drive::new(
            load.clone(),
            vec![muscle],
            Commanded::Opening(vec![Command::Constant(0.0)]),
            0.5,
        );
        drive.initial_coordinate = Some(0.0);
        let motion = ran(&drive);
        motion.series.velocity.iter().copied().fold(0.0, f64::max)
    };
    let computed: Vec<f64> = rows.iter().map(|r| speed(r[1])).collect();
    let middle = 3;
    let mut logs = 0.0;
    println!(
        "load (kg): measured, computed (mm/s), both over those of {} kg",
        rows[middle][1]
    );
    for (row, v) in rows.iter().zip(&computed) {
        let (a, b) = (row[3] / rows[middle][3], v / computed[middle]);
        println!("{}: {} {v:.0}; {a:.3} {b:.3}", row[1], row[3]);
        logs += (b / a).ln().powi(2);
    }
    let typical = f64::exp((logs / rows.len() as f64).sqrt());
    println!("typical ratio {typical:.3}");
    assert!(typical < 1.12, "{typical}");
}
