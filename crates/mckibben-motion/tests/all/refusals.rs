//! What is refused, and how it is said.

use crate::support::{note_muscle, regulator, steps, valve};
use crate::verification::Vessel;
use mckibben_core::{
    cancel::Cancel,
    load::Load,
    model::{ForceModel, ModelKind},
    progress::Silent,
};
use mckibben_motion::*;
use std::sync::Arc;

#[test]
fn commands_with_times_that_go_back_or_no_numbers_are_refused() {
    let back = Command::table(vec![(0.0, 1.0), (1.0, 2.0), (0.5, 1.0)]).unwrap_err();
    assert_eq!(
        back.to_string(),
        "the command's times must increase: 0.5 s follows 1 s (point 3)"
    );
    for points in [vec![(0.0, f64::NAN)], vec![]] {
        assert!(matches!(
            Command::table(points),
            Err(MotionError::Refused(_))
        ));
    }
}

#[test]
fn what_cannot_be_is_said_with_its_values() {
    let model: Arc<dyn ForceModel> = ModelKind::ThickWall.build(&note_muscle()).unwrap().into();
    let load = SingleMuscle {
        stops_mm: (0.0, 90.0),
        ..SingleMuscle::hanging(&*model, 5.0)
    };
    let drive = |target, actuator| {
        Drive::new(
            load.clone(),
            vec![Actuated::new(model.clone(), actuator)],
            target,
            0.5,
        )
    };
    let refused = |drive: &Drive| run(drive, &Silent).unwrap_err();

    let error = refused(&drive(steps(&[(0.0, 0.0), (0.1, 0.8)]), valve()));
    assert!(
        error
            .to_string()
            .contains("is 0.8\u{a0}MPa, above the supply pressure of 0.6\u{a0}MPa;"),
        "{error}"
    );
    let error = refused(&drive(
        Commanded::Opening(vec![Command::Constant(1.0)]),
        regulator(0.1),
    ));
    assert!(
        error.to_string().contains("muscle 1 has a regulator"),
        "{error}"
    );
    assert!(matches!(
        refused(&drive(steps(&[(0.0, 0.0)]), regulator(0.0))),
        MotionError::Refused(_)
    ));
    assert!(matches!(
        Orifice::new(0.0, 0.3),
        Err(MotionError::Refused(_))
    ));
    assert!(matches!(
        Orifice::new(0.5, 1.0),
        Err(MotionError::Refused(_))
    ));

    // 60 kg are more than 0.1 MPa can lift.
    let heavy = SingleMuscle {
        stops_mm: (0.0, 90.0),
        ..SingleMuscle::hanging(&*model, 60.0)
    };
    let drive = Drive {
        mechanism: Arc::new(heavy),
        ..drive(steps(&[(0.0, 0.0), (0.1, 0.1)]), valve())
    };
    let error = refused(&drive);
    let MotionError::NeverLifted(OnStop {
        net, pressure_mpa, ..
    }) = error
    else {
        panic!("{error}")
    };
    assert!(net < -100.0 && (pressure_mpa - 0.1).abs() < 1e-3);

    let mut none = Vessel::default();
    none.volume_mm3 = None;
    let drive = Drive {
        muscles: vec![Actuated::new(none.clone(), valve())],
        ..drive
    };
    assert!(
        matches!(refused(&drive), MotionError::Refused(_)),
        "{}",
        refused(&drive)
    );
}

#[test]
fn a_run_ends_where_it_is_cancelled_too_long_or_too_slow() {
    let model: Arc<dyn ForceModel> = ModelKind::ThickWall.build(&note_muscle()).unwrap().into();
    let load = SingleMuscle {
        stops_mm: (0.0, 90.0),
        ..SingleMuscle::hanging(&*model, 5.0)
    };
    let target = steps(&[(0.0, 0.0), (0.1, 0.2)]);
    let mut drive = Drive::new(
        load.clone(),
        vec![Actuated::new(model.clone(), valve())],
        target,
        0.5,
    );
    let cancel = Cancel::default();
    cancel.cancel();
    {
        let _entered = cancel.enter();
        assert!(matches!(
            run(&drive, &Silent),
            Err(MotionError::Cancelled(_))
        ));
    }
    let many = Drive {
        output_step_s: 1e-12,
        ..drive.clone()
    };
    assert!(matches!(run(&many, &Silent), Err(MotionError::Large(_))));
    drive.most_steps = 20;
    let error = run(&drive, &Silent).unwrap_err();
    assert!(error.to_string().contains(" after 21 steps"), "{error}");
}

#[test]
fn a_model_without_answer_ends_the_run_with_time_and_state() {
    // Thrown against nothing: an unlimited pull stretches the muscle past where its strands are
    // straight.
    let model = mckibben_core::model::Ideal::between_ends(&note_muscle());
    let load = SingleMuscle {
        added_mass_kg: 5.0,
        ..SingleMuscle::new(&model, Load::Force { force_n: 1e5 })
    };
    let mut drive = Drive::new(
        load.clone(),
        vec![Actuated::new(model.clone(), regulator(0.1))],
        steps(&[(0.0, 0.3)]),
        0.5,
    );
    drive.initial_coordinate = Some(0.0);
    let error = run(&drive, &Silent).unwrap_err();
    let MotionError::Model {
        time_s,
        contraction,
        muscle: 1,
        ..
    } = error
    else {
        panic!("{error}")
    };
    assert!(time_s > 0.0 && time_s < 0.1 && contraction < 0.0, "{error}");
}
