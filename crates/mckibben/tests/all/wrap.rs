//! Muscles that lie on their pulleys: maps, rests and pressures.

use mckibben::joint::{
    Joint, JointModel, JointMuscle, JointPoint, JointSpring, JointTarget, Link, Path, Rest, Turning, Wrap,
};
use mckibben::model::{ForceModel, ModelKind, Workspace};
use mckibben::muscle::Muscle;
use mckibben::progress::Silent;

fn on_its_pulley(radius_mm: f64, contraction_at_neutral: f64, friction: f64) -> JointMuscle {
    let muscle = Muscle::prototype();
    let outer_radius_mm = muscle.tube().outer_radius_mm();
    let wrap = Wrap { radius_mm, outer_radius_mm, angle_deg: 70.0, friction, strands: None };
    JointMuscle { muscle, path: Path::Wrap(wrap), contraction_at_neutral }
}

fn asked<T>(joint: &Joint, kind: ModelKind, ask: impl FnOnce(&JointModel<'_>, &mut [Workspace]) -> T) -> T {
    let models: Vec<Box<dyn ForceModel>> =
        joint.muscles().iter().map(|m| m.model(kind.build(&m.muscle).unwrap())).collect();
    let model = JointModel::new(joint, models.iter().map(|m| &**m).collect(), true).unwrap();
    ask(&model, &mut [Workspace::new(), Workspace::new()])
}

fn at(joint: &Joint, pressures: [f64; 2]) -> JointPoint {
    asked(joint, ModelKind::Universal, |model, w| model.at(w, &pressures, 8.0, Turning::Mean).unwrap())
}

/// Without its bend a joint is that of ropes on pulleys of R + Ro; with it the pull is lower, and the pressures found for its torque give it again.
#[test]
fn maps_rests_and_pressures_work_on_a_wrap() {
    let joint = |muscles: [JointMuscle; 2]| {
        Joint::new(muscles.to_vec(), None, Link::default(), (-30.0, 30.0)).unwrap()
    };
    let ropes =
        joint([75.0, -75.0].map(|radius_mm| JointMuscle {
            path: Path::Pulley { radius_mm },
            ..on_its_pulley(60.0, 0.08, 0.0)
        }));
    let joint = joint([60.0, -60.0].map(|r| on_its_pulley(r, 0.08, 0.2)));
    let pressures = [0.2, 0.12];
    let (found, rope) = (at(&joint, pressures), at(&ropes, pressures));
    for (bent, straight) in found.muscles.iter().zip(&rope.muscles) {
        let bend = bent.bend.unwrap();
        let lost = straight.answer.response.force_n - bent.answer.response.force_n;
        assert!((lost - bend.pull_lost_n).abs() < 1e-9 && lost > 0.0, "{lost} {bend:?}");
        assert!(bend.axis_mm > 60.0 && bend.flattening > 0.0 && straight.bend.is_none(), "{bend:?}");
        let parts = bent.answer.uncertainty_parts_n.unwrap();
        assert_eq!(parts.bend, Some(bend.pull_lost_uncertainty_n));
    }
    asked(&joint, ModelKind::Universal, |model, w| {
        let wanted = JointTarget {
            angle_deg: 8.0,
            torque_nm: found.torque_nm,
            stiffness_nm_per_rad: Some(found.stiffness_nm_per_rad),
        };
        let back = model.pressures(w, wanted, 0.3).unwrap();
        for (p, known) in back.pressures_mpa.iter().zip(pressures) {
            assert!((p - known).abs() < 1e-6, "{back:?}");
        }
        let rests = model.rests(w, &[0.2, 0.2], 0.0).unwrap();
        assert!(matches!(rests[..], [Rest::Balance { angle_deg, .. }] if angle_deg.abs() < 1e-9));
        let map = model.map(0.25, 5, &Silent).unwrap();
        assert_eq!(map.points.len(), 25);
        assert!(map.points.iter().flatten().count() > 15 && map.gaps.is_empty());
    });
}

/// On a pulley that is narrower than the muscle a pressure presses it flat: the map has the rests at the others, in balance with the spring, and the reasons.
#[test]
fn a_map_goes_on_beside_pressures_that_press_a_muscle_flat() {
    let rate_nm_per_rad = 15.0;
    let spring = JointSpring::Torsion { rate_nm_per_rad, preload_nm: 0.0 };
    let muscles = vec![on_its_pulley(25.0, 0.12, 0.0)];
    let joint = Joint::new(muscles, Some(spring), Link::default(), (-20.0, 20.0)).unwrap();
    asked(&joint, ModelKind::ThickWall, |model, w| {
        let map = model.map(0.3, 4, &Silent).unwrap();
        assert_eq!(map.gaps.len(), 2);
        assert!(
            map.gaps.iter().all(|gap| gap.reason.starts_with("muscle 1: no equilibrium")),
            "{:?}",
            map.gaps
        );
        let found: Vec<_> = map.points.iter().flatten().collect();
        assert_eq!(found.len(), 2);
        for point in found {
            let here = model.at(&mut w[..1], &point.pressures_mpa, point.angle_deg, Turning::Mean).unwrap();
            assert!(here.torque_nm.abs() < 1e-5, "{point:?} {here:?}");
        }
    });
}
