//! Demands: pulls at contractions.

use mckibben_core::{load::Load, units::Values};
use mckibben_design::{Demand, JointDemand, OperatingPoint, SpecError, TorqueWanted};

/// F = τ/r and ε = r (φm + φ)/L0 by hand: 8 N m at 45° on 25 mm, 60° to either side, 250 mm.
#[test]
fn a_joint_asks_for_pulls_at_contractions() {
    let joint = JointDemand {
        torques: vec![
            TorqueWanted {
                torque_nm: 8.0,
                angle_deg: 45.0,
            },
            TorqueWanted {
                torque_nm: 3.0,
                angle_deg: -60.0,
            },
        ],
        largest_angle_deg: 60.0,
        radii_mm: Values::List(vec![25.0]),
        beside: false,
    };
    let demand = Demand::Joint(joint);
    let points = demand.points(250.0, 25.0);
    assert!((points[0].force_n - 320.0).abs() < 1e-12 && (points[1].force_n - 120.0).abs() < 1e-12);
    assert!((points[0].contraction - 25.0 * 105f64.to_radians() / 250.0).abs() < 1e-15);
    assert!(points[1].contraction.abs() < 1e-15);
    assert!(demand.check(250.0).is_ok());
}

#[test]
fn a_load_that_falls_is_looked_at_all_along_the_way() {
    let lifted = |load| {
        let demand = Demand::Stroke {
            load,
            stroke_mm: 40.0,
        };
        demand.points(285.0, 0.0)
    };
    let spring = Load::Spring {
        rate_n_per_mm: 5.0,
        preload_n: 50.0,
    };
    let points = lifted(spring);
    assert_eq!(
        points,
        [OperatingPoint {
            force_n: 250.0,
            contraction: 40.0 / 285.0
        }]
    );
    let falling = Load::Spring {
        rate_n_per_mm: -2.0,
        preload_n: 100.0,
    };
    let points = lifted(falling);
    let forces: Vec<f64> = points.iter().map(|q| q.force_n).collect();
    assert_eq!(forces, [100.0, 80.0, 60.0, 40.0, 20.0]);
}

/// By hand: a seventh of 700 N, of 7 kg, and of 14 N m.
#[test]
fn a_share_of_a_demand_is_that_share_of_its_pulls() {
    let seventh = |demand: Demand| demand.scaled(1.0 / 7.0, 1.0).points(250.0, 20.0)[0].force_n;
    let points = vec![OperatingPoint {
        force_n: 700.0,
        contraction: 0.1,
    }];
    assert!((seventh(Demand::Points { points }) - 100.0).abs() < 1e-12);
    let load = Load::Mass {
        mass_kg: 7.0,
        level: false,
    };
    assert!(
        (seventh(Demand::Stroke {
            load,
            stroke_mm: 20.0
        }) - 9.80665)
            .abs()
            < 1e-9
    );
    let torques = vec![TorqueWanted {
        torque_nm: 14.0,
        angle_deg: 30.0,
    }];
    let joint = JointDemand {
        torques,
        largest_angle_deg: 30.0,
        radii_mm: Values::List(vec![20.0]),
        beside: false,
    };
    assert!((seventh(Demand::Joint(joint)) - 100.0).abs() < 1e-12);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let joint = |torque, angle, most, radius| {
        let torques = vec![TorqueWanted {
            torque_nm: torque,
            angle_deg: angle,
        }];
        Demand::Joint(JointDemand {
            torques,
            largest_angle_deg: most,
            radii_mm: Values::List(vec![radius]),
            beside: false,
        })
        .check(250.0)
    };
    assert!(matches!(
        joint(8.0, 70.0, 60.0, 25.0),
        Err(SpecError::Refused(..))
    ));
    assert!(matches!(
        joint(0.0, 10.0, 60.0, 25.0),
        Err(SpecError::Refused(..))
    ));
    assert!(matches!(
        joint(8.0, 45.0, 60.0, 0.0),
        Err(SpecError::Refused(..))
    ));
    // More than the muscle's length.
    assert!(matches!(
        joint(8.0, 60.0, 60.0, 250.0),
        Err(SpecError::Refused(..))
    ));
    let level = Load::Mass {
        mass_kg: 3.0,
        level: true,
    };
    let nothing = Demand::Stroke {
        load: level,
        stroke_mm: 10.0,
    };
    assert_eq!(
        nothing.check(285.0),
        Err(SpecError::Refused(
            "force_n",
            "no operating point: give \
        `force_n` and `contraction`, or `points`, each a pull at a contraction, or a load that \
        pulls"
                .into()
        ))
    );
}
