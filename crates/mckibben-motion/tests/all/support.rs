//! What several tests need.

use mckibben_core::{
    joint::{Joint, JointMuscle, Link, Path},
    load::Load,
    model::ForceModel,
    muscle::Muscle,
};
use mckibben_motion::*;

/// Runs, or says why not.
pub fn ran(drive: &Drive) -> Motion {
    run(drive, &mckibben_core::progress::Silent).unwrap()
}

pub fn close(a: f64, b: f64, relative: f64) {
    assert!(
        (a / b - 1.0).abs() <= relative,
        "{a} against {b}: {:.3e}",
        a / b - 1.0
    );
}

/// The last value of a list.
pub fn last(list: &[f64]) -> f64 {
    *list.last().unwrap()
}

/// The muscle of the design note: D0 20, s 1.5, L0 220, 24°, C10 0.1 MPa, k 900 N/mm.
pub fn note_muscle() -> Muscle {
    use mckibben_core::{
        muscle::{Braid, BraidStiffness, Rubber, Terminals, Tube},
        rubber::{Law, MooneyRivlin},
    };
    let rubber = Rubber::new(Law::MooneyRivlin(MooneyRivlin {
        c10_mpa: 0.1,
        c01_mpa: 0.0,
    }));
    let tube = Tube::new(20.0, 1.5, 220.0, rubber);
    let stiffness = BraidStiffness::NewtonPerMm(900.0);
    let braid = Braid {
        angle_deg: 24.0,
        stiffness,
        ..Braid::paper()
    };
    Muscle::new(tube, braid, Terminals::default(), None).unwrap()
}

/// Two muscles of the note over a pulley, against each other.
pub fn elbow(damping_nm_s_per_rad: f64) -> Joint {
    let muscle = |radius_mm: f64| JointMuscle {
        muscle: note_muscle(),
        path: Path::Pulley { radius_mm },
        contraction_at_neutral: 0.1,
    };
    let link = Link {
        inertia_kg_m2: Some(0.02),
        damping_nm_s_per_rad,
        ..Link::default()
    };
    Joint::new(vec![muscle(20.0), muscle(-20.0)], None, link, (-60.0, 60.0)).unwrap()
}

/// A hanging mass with a damper, between stops.
pub fn damped(
    model: &dyn ForceModel,
    mass_kg: f64,
    damping_n_s_per_m: f64,
    stops_mm: (f64, f64),
) -> SingleMuscle {
    SingleMuscle {
        stops_mm,
        damping_n_s_per_m,
        ..SingleMuscle::hanging(model, mass_kg)
    }
}

/// A hanging mass with a spring.
pub fn sprung(mass_kg: f64, rate_n_per_mm: f64) -> Load {
    Load::Sum(vec![
        Load::Mass {
            mass_kg,
            level: false,
        },
        Load::Spring {
            rate_n_per_mm,
            preload_n: 0.0,
        },
    ])
}

/// A proportional valve of 0.5 L/(s bar).
pub fn valve() -> Actuator {
    Actuator::Valve(Valve::new(Orifice::new(0.5, 0.3).unwrap()))
}

pub fn regulator(time_constant_s: f64) -> Actuator {
    Actuator::Regulator { time_constant_s }
}

pub fn steps(points: &[(f64, f64)]) -> Commanded {
    Commanded::Pressure(vec![Command::Steps(points.to_vec())])
}
