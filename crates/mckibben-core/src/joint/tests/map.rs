//! Maps of what a joint reaches.

use super::*;

#[test]
fn a_map_holds_the_rests_that_are_found_one_by_one() {
    for joint in [antagonists(), elbow()] {
        let models = models(&joint, ModelKind::Universal);
        let model = bound(&joint, &models);
        let w = &mut [Workspace::new(), Workspace::new()][..];
        let map = model.map(0.25, 7, &Silent).unwrap();
        assert_eq!((map.points.len(), map.grid_mpa.len()), (49, 7));
        let mut compared = 0;
        for point in map.points.iter().flatten() {
            let rests = model.rests(w, &point.pressures_mpa, 0.0).unwrap();
            // Where the last muscle goes slack the joint rests at the edge of what is loose.
            let ends = |r: &Rest| match *r {
                Rest::Loose { from_deg, to_deg } => vec![from_deg, to_deg],
                _ => vec![r.angle_deg()],
            };
            let near = rests
                .iter()
                .filter(|r| r.is_stable())
                .flat_map(ends)
                .map(|deg| (deg - point.angle_deg).abs());
            assert!(
                near.fold(f64::INFINITY, f64::min) < 1e-7,
                "{point:?} {rests:?}"
            );
            if !point.at_limit {
                let there = model
                    .point_at(w, &point.pressures_mpa, point.angle_deg, Turning::Mean)
                    .unwrap();
                assert!((there.stiffness_nm_per_rad - point.stiffness_nm_per_rad).abs() < 1e-6);
                compared += 1;
            }
        }
        assert!(compared > 15, "{compared}");
        assert!(!map.border.is_empty());
        assert!(map.torques.iter().all(|t| t.1 <= t.2));
    }
}

/// Soft strands have no equilibrium at high pressures: the map has the rests at the others, in
/// balance with the spring, and the reasons.
#[test]
fn a_map_goes_on_beside_pressures_without_a_state() {
    let braid = Braid {
        stiffness: BraidStiffness::NewtonPerMm(10.0),
        ..Braid::paper()
    };
    let one = muscle(Path::Pulley { radius_mm: 25.0 }, 0.12);
    let soft = JointMuscle {
        muscle: one.muscle.with_braid(braid).unwrap(),
        ..one
    };
    let spring = JointSpring::Torsion {
        rate_nm_per_rad: 15.0,
        preload_nm: 0.0,
    };
    let joint = Joint::new(vec![soft], Some(spring), Link::default(), (-20.0, 20.0)).unwrap();
    let models = models(&joint, ModelKind::ThickWall);
    let model = bound(&joint, &models);
    let map = model.map(0.6, 4, &Silent).unwrap();
    assert!(
        !map.gaps.is_empty() && map.gaps.len() + map.points.iter().flatten().count() == 4,
        "{map:?}"
    );
    let is_first = |reason: &str| reason.contains("muscle 1: ");
    assert!(map.gaps.iter().all(|gap| is_first(&gap.reason)), "{map:?}");
    for point in map.points.iter().flatten() {
        let w = &mut [Workspace::new()][..];
        let here = model
            .point_at(w, &point.pressures_mpa, point.angle_deg, Turning::Mean)
            .unwrap();
        assert!(here.torque_nm.abs() < 1e-5, "{point:?} {here:?}");
    }
}

/// The box of `universal` ends at a pressure, at no contraction and at walls that the prototype
/// does not have.
#[test]
fn a_map_outside_of_a_models_range_is_refused_or_said() {
    let within = antagonists();
    let mut muscles = within.muscles().to_vec();
    muscles[1].contraction_at_neutral = 0.02;
    let stretched = Joint::new(muscles.clone(), None, Link::default(), (-60.0, 60.0)).unwrap();
    muscles = within.muscles().to_vec();
    muscles[0].muscle = muscles[0].muscle.with_section(30.0, 9.0).unwrap();
    let thick = Joint::new(muscles, None, Link::default(), (-60.0, 60.0)).unwrap();
    for (joint, supply, said) in [
        (&within, 20.0, "pressure 20\u{a0}MPa"),
        (&stretched, 0.25, "contraction"),
        (&thick, 0.25, "wall_ratio 0.3"),
    ] {
        let models = models(joint, ModelKind::Universal);
        let strict = BoundJoint::new(joint.clone(), models.clone(), false).unwrap();
        let error = strict.map(supply, 3, &Silent).unwrap_err().to_string();
        assert!(
            error.contains("outside the range") && error.contains(said),
            "{error}"
        );
        let open = BoundJoint::new(joint.clone(), models, true).unwrap();
        assert!(
            open.outside(supply)
                .unwrap()
                .iter()
                .any(|s| s.contains(said))
        );
    }
    let models = models(&within, ModelKind::Universal);
    let strict = BoundJoint::new(within, models, false).unwrap();
    assert!(strict.outside(0.25).unwrap().is_empty() && strict.map(0.25, 3, &Silent).is_ok());
}
