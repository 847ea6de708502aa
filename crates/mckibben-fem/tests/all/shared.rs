//! One model shared by two threads, each with its workspace, answers as one thread does, bit by
//! bit.

use mckibben_core::{
    model::{ForceModel, ModelKind, Workspace},
    muscle::{Braid, EndFactor, MeasuredStrand, Muscle, Terminals},
};
use mckibben_fem::{
    axisymmetric::Axisymmetric,
    three_dimensional::{BrickSpec, ThreeDimensional},
};
use std::sync::Arc;

/// A muscle that states what any of the models needs.
fn muscle() -> Muscle {
    let m = Muscle::prototype();
    let measured = MeasuredStrand {
        strand_length_mm: m.strand_length_mm(),
        turns: m.turns(),
    };
    let braid = Braid {
        measured: Some(measured),
        ..Braid::paper()
    };
    let end_factor = Some(EndFactor::Constant(1.1));
    let terminals = Terminals {
        end_factor,
        ..Terminals::default()
    };
    m.with_braid(braid)
        .unwrap()
        .with_terminals(terminals)
        .unwrap()
}

/// Bits of everything a model says about a walk through pressures and contractions; `Err` in words.
fn answers(
    model: &dyn ForceModel,
    questions: &[(f64, f64)],
) -> Vec<Result<Vec<Option<u64>>, String>> {
    let workspace = &mut Workspace::new();
    let one = |&(p, e): &(f64, f64)| {
        let r = model.response(workspace, p, e).map_err(|e| e.to_string())?;
        let force = model.force_n(workspace, p, e).map_err(|e| e.to_string())?;
        let all = [
            Some(force),
            Some(r.force_n),
            r.volume_mm3,
            r.stiffness_n_per_mm,
            r.force_per_pressure_mm2,
            r.braid_tension_n,
            r.bulged_diameter_mm,
            r.max_stretch,
        ];
        Ok(all.map(|v| v.map(f64::to_bits)).to_vec())
    };
    questions.iter().map(one).collect()
}

#[test]
fn threads_share_a_model_of_every_kind() {
    let m = muscle();
    let mut models: Vec<Arc<dyn ForceModel>> = ModelKind::ALL
        .into_iter()
        .map(|kind| Arc::from(kind.build(&m).unwrap()))
        .collect();
    models.push(Arc::new(Axisymmetric::between_ends(&m).unwrap()));
    let coarse = BrickSpec::parse("1x6").unwrap();
    models.push(Arc::new(
        ThreeDimensional::between_ends_with(&Muscle::prototype(), &coarse).unwrap(),
    ));
    for model in models {
        let count = if model.info().name == "fe3d" { 3 } else { 40 };
        let up: Vec<(f64, f64)> = (0..count)
            .map(|i| f64::from(i) / f64::from(count))
            .map(|t| (0.05 + 0.2 * t, 0.3 * t * (1.0 - t)))
            .collect();
        let down: Vec<(f64, f64)> = up.iter().rev().copied().collect();
        let alone = [answers(model.as_ref(), &up), answers(model.as_ref(), &down)];
        assert!(alone[0].iter().any(Result::is_ok), "{}", model.info().name);
        let threads = [up, down].map(|questions| {
            let model = Arc::clone(&model);
            std::thread::spawn(move || answers(model.as_ref(), &questions))
        });
        let together = threads.map(|t| t.join().unwrap());
        assert_eq!(alone, together, "{}", model.info().name);
    }
}

/// A workspace that served another model, or questions from elsewhere, changes no answer beyond the
/// tolerance of the solver.
#[test]
fn what_a_workspace_held_before_does_not_matter() {
    let (a, b) = (
        Axisymmetric::between_ends(&muscle()).unwrap(),
        Axisymmetric::between_ends(&Muscle::prototype()).unwrap(),
    );
    let used = &mut Workspace::new();
    let fresh = |model: &Axisymmetric| model.force_n(&mut Workspace::new(), 0.2, 0.1).unwrap();
    for model in [&a, &b, &a] {
        let first = model.force_n(used, 0.2, 0.1).unwrap();
        assert_eq!(first.to_bits(), fresh(model).to_bits());
    }
    for (p, e) in [(0.25, 0.0), (0.05, 0.2)] {
        a.force_n(used, p, e).unwrap();
        assert!((a.force_n(used, 0.2, 0.1).unwrap() - fresh(&a)).abs() < 1e-6);
    }
    assert!(a.known(used).is_some_and(|c| c.effort.iterations > 0) && b.known(used).is_none());
}
