//! A muscle in Rust is the whole muscle, as every other front end has it.
#![cfg(all(feature = "fem", feature = "fit"))]

use mckibben::{
    fem::axisymmetric::Axisymmetric,
    fit::validation::library::file,
    model::{ForceModel, Workspace},
    prelude::*,
};

/// The hose of the library, which gives way at its ends: 407.3 N on the command line.
#[test]
fn the_ends_of_a_muscle_are_part_of_it() {
    let hose: Muscle = file("dmsp-10-hose").unwrap().parse().unwrap();
    let whole = Model::FE.of(&hose).unwrap().force_n(0.592, 0.0).unwrap();
    assert!((whole - 407.29777642855).abs() < 1e-6, "{whole}");
    let between = Axisymmetric::between_ends(&hose).unwrap();
    let between = between.force_n(&mut Workspace::new(), 0.592, 0.0).unwrap();
    assert!(between > 1.5 * whole, "{between}");
}

#[test]
fn a_point_is_the_same_alone_in_a_list_and_in_an_answer() {
    let muscle = Muscle::prototype();
    let points = [(0.05, 0.0), (0.25, 0.1), (0.25, 0.3), (0.1, 0.2)];
    for model in [Model::FE, Model::UNIVERSAL] {
        let m = model.of(&muscle).unwrap();
        for (pull, (p, e)) in m.forces_n(&points).into_iter().zip(points) {
            let pull = pull.unwrap();
            assert_eq!(m.clone().force_n(p, e).unwrap(), pull, "{p} {e}");
            let answered = m.clone().answer(p, e).unwrap().response.force_n;
            assert!((answered - pull).abs() <= 1e-9 * pull.max(1.0), "{p} {e}");
        }
    }
}

#[test]
fn a_muscle_is_written_and_read_as_text() {
    let muscle = Muscle::prototype().with_length(200.0).unwrap();
    assert_eq!(muscle.to_string().parse::<Muscle>().unwrap(), muscle);
    let typo = "[tube]\nouter_diametr = 30".parse::<Muscle>().unwrap_err();
    assert!(typo.to_string().contains("outer_diameter"), "{typo}");
}

/// What one thread owns another one takes.
#[test]
fn models_and_joints_are_sent_to_other_threads() {
    fn sent<T: Send + 'static>(_: &T) {}
    let muscle = Model::FE.of(&Muscle::prototype()).unwrap();
    sent(&muscle);
    sent(&JointModel::antagonists(&muscle, 25.0, 0.1, (-60.0, 60.0)).unwrap());
}
