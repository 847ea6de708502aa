//! Muscles that lie on their pulleys: virtual work, friction by hand, and what cannot be built.

use super::*;
use crate::joint::{Joint, JointModel, JointPoint, Link, Turning, parse_joint};
use crate::model::{ModelKind, Strands, ThickWall, Workspace};
use crate::muscle::Muscle;

fn on_its_pulley(radius_mm: f64, friction: f64) -> JointMuscle {
    let muscle = Muscle::prototype();
    let outer_radius_mm = muscle.tube().outer_radius_mm();
    let wrap = Wrap { radius_mm, outer_radius_mm, angle_deg: 70.0, friction, strands: None };
    JointMuscle { muscle, path: Path::Wrap(wrap), contraction_at_neutral: 0.08 }
}

fn joint(friction: f64) -> Joint {
    let muscles = [60.0, -60.0].map(|r| on_its_pulley(r, friction));
    Joint::new(muscles.to_vec(), None, Link::default(), (-30.0, 30.0)).unwrap()
}

fn models(joint: &Joint, kind: ModelKind) -> Vec<Box<dyn ForceModel>> {
    joint.muscles().iter().map(|m| m.model(kind.build(&m.muscle).unwrap())).collect()
}

fn asked<T>(joint: &Joint, kind: ModelKind, ask: impl FnOnce(&JointModel<'_>, &mut [Workspace]) -> T) -> T {
    let models = models(joint, kind);
    let model = JointModel::new(joint, models.iter().map(|m| &**m).collect(), true).unwrap();
    ask(&model, &mut [Workspace::new(), Workspace::new()])
}

fn at(joint: &Joint, kind: ModelKind, pressures: [f64; 2], deg: f64, turning: Turning) -> JointPoint {
    asked(joint, kind, |model, w| model.at(w, &pressures, deg, turning).unwrap())
}

/// τ against −dΠ/dφ of both muscles' potentials, and −dτ/dφ against differences, on every branch of the friction.
#[test]
fn the_torque_is_virtual_work() {
    let h = 0.01_f64;
    let joint = joint(0.0);
    let (pressures, deg) = ([0.2, 0.12], 8.0);
    let potential = |deg: f64| {
        let of = |i: usize| {
            let m = &joint.muscles()[i];
            let Path::Wrap(wrap) = m.path else { panic!() };
            let on = OnPulley {
                radius_mm: 60.0,
                angle_rad: 70f64.to_radians(),
                straight_mm: m.straight_mm(&wrap),
            };
            let x = wrap.arm_mm() * f64::to_radians(deg);
            let bent = crate::model::BentMuscle::new(&m.muscle);
            let limit = |strands| bent.on_pulley(strands, &on, pressures[i], x).unwrap().potential_n_mm;
            0.5e-3 * (limit(Strands::Sliding) + limit(Strands::Fixed))
        };
        of(0) + of(1)
    };
    let torque = -(potential(deg + h) - potential(deg - h)) / (2.0 * h.to_radians());
    let found = at(&joint, ModelKind::ThickWall, pressures, deg, Turning::Mean);
    assert!((found.torque_nm / torque - 1.0).abs() < 1e-6, "{} {torque}", found.torque_nm);
    let rubbing = self::joint(0.3);
    for kind in [ModelKind::ThickWall, ModelKind::Universal] {
        for turning in [Turning::Mean, Turning::Plus, Turning::Minus] {
            let torque = |deg: f64| at(&rubbing, kind, pressures, deg, turning).torque_nm;
            let slope = -(torque(deg + h) - torque(deg - h)) / (2.0 * h.to_radians());
            let found = at(&rubbing, kind, pressures, deg, turning).stiffness_nm_per_rad;
            assert!((found / slope - 1.0).abs() < 1e-5, "{kind} {turning:?} {found} {slope}");
        }
    }
}

/// Between both branches there is no friction; that of each is a row of [`verification`](crate::model::verification).
#[test]
fn the_mean_of_both_branches_has_no_friction_on_the_pulley() {
    let m = on_its_pulley(60.0, 0.3);
    let model = m.model(Box::new(ThickWall::new(&m.muscle)));
    let bend = model.extensions().bend.unwrap();
    assert_eq!(bend.friction_factor(0.08, crate::muscle::Direction::Mean).0, 1.0);
}

#[test]
fn a_wrap_that_cannot_be_built_is_refused() {
    let with = |m: JointMuscle, range| Joint::new(vec![m], None, Link::default(), range);
    let leaves = with(on_its_pulley(60.0, 0.0), (-60.0, 80.0)).unwrap_err();
    assert!(matches!(leaves, JointError::LeavesPulley { unwound_deg: 80.0, .. }), "{leaves}");
    assert!(with(on_its_pulley(-60.0, 0.0), (-60.0, 80.0)).is_ok());
    let all = with(on_its_pulley(300.0, 0.0), (-10.0, 10.0)).unwrap_err();
    assert!(matches!(all, JointError::AllOnPulley { .. }), "{all}");
    assert!(with(on_its_pulley(60.0, -0.1), (-10.0, 10.0)).is_err());
    let joint = joint(0.0);
    let straight = ThickWall::new(&Muscle::prototype());
    let error = JointModel::new(&joint, vec![&straight, &straight], true).err().unwrap();
    assert_eq!(error, JointError::NotBent { muscle: 1 });
}

#[test]
fn files_say_how_a_muscle_lies_on_its_pulley() {
    let head = "[joint]\nradius = '60 mm'\nrange = '-30..30 deg'\n[muscle_1]\nfile = 'a.toml'\n";
    let file = parse_joint(&format!("{head}wrap_angle = '70 deg'\nwrap_friction = 0.2\n")).unwrap();
    let joint = file.with(vec![Muscle::prototype()]).unwrap();
    let Path::Wrap(wrap) = joint.muscles()[0].path else { panic!() };
    assert_eq!((wrap.arm_mm(), wrap.friction, wrap.strands), (75.0, 0.2, None));
    for (text, said) in [
        ("wrap_friction = 0.2\n", "wrap_angle"),
        ("wrap_angle = '70 deg'\nwrap_strands = 'loose'\n", "sliding"),
        ("wrap_angle = '70 deg'\nwrap_friction = -1\n", "below zero"),
        ("wrap_angle = '70 deg'\norigin = ['1 mm', '2 mm']\ninsertion = ['3 mm', '4 mm']\n", "pulley"),
    ] {
        let error = parse_joint(&format!("{head}{text}")).unwrap_err().to_string();
        assert!(error.contains(said), "{text}: {error}");
    }
}
