//! Muscles that push, designed for a push at an extension.

use mckibben_core::{
    analysis::{Evaluation, Options},
    model::{ForceModel, ThickWall, Workspace},
    muscle::Muscle,
    units::Values,
};
use mckibben_design::{
    BraidChoice, Build, Demand, Limit, Limits, OperatingPoint, Relaxation, Spec, SpecError, design,
};

const BUILD: &Build<'_> = &|muscle| Ok(Box::new(ThickWall::between_ends(muscle)));

fn spec(force_n: f64, contraction: f64, limits: Limits) -> Spec {
    let point = OperatingPoint {
        force_n,
        contraction,
    };
    Spec {
        outer_diameter_mm: Values::Interval(8.0, 60.0),
        wall_mm: Values::List(vec![1.0, 2.0]),
        length_mm: Some(Values::List(vec![120.0])),
        braid: BraidChoice::Angle(Values::List(vec![65.0])),
        limits,
        supply_share: 1.0,
        certainty: None,
        built: false,
        ..Spec::new(vec![point], 0.25)
    }
}

fn push_n(muscle: &Muscle) -> f64 {
    -ThickWall::between_ends(muscle)
        .force_n(&mut Workspace::new(), 0.25, -0.1)
        .unwrap()
}

/// The first diameter of the grid that pushes enough; one step less does not.
#[test]
fn the_smallest_diameter_just_pushes_enough_at_the_maximum_pressure() {
    let outcome = design(&spec(-30.0, -0.1, Limits::default()), BUILD).unwrap();
    let best = &outcome.candidates[0];
    let (d0, s) = (best.muscle.outer_diameter_mm(), best.muscle.wall_mm());
    let thinner = best.muscle.with_section(d0 - 1.001, s).unwrap();
    assert!(
        push_n(&best.muscle) >= 30.0 && push_n(&thinner) < 30.0,
        "{d0} {s}"
    );
    assert!(
        (best.margin - (push_n(&best.muscle) / 30.0 - 1.0)).abs() < 1e-9
            && best.pressure_mpa <= 0.25
    );
    assert!(
        best.free_contraction.is_some_and(|e| e < -0.1),
        "{:?}",
        best.free_contraction
    );
    // Against the way and with the push: the work is positive.
    assert!(best.work_j.is_some_and(|work| work > 0.0));
}

/// Between two joints a push is at most half the load of Euler's column; a muscle that is guided may be
/// thinner, and the other is told how.
#[test]
fn a_push_is_below_the_buckling_load_unless_the_muscle_is_guided() {
    let limits = Limits {
        buckling: true,
        ..Limits::default()
    };
    let free = design(&spec(-15.0, -0.1, limits), BUILD).unwrap();
    let guided = design(&spec(-15.0, -0.1, Limits::default()), BUILD).unwrap();
    let d0 = |outcome: &mckibben_design::Outcome| outcome.candidates[0].muscle.outer_diameter_mm();
    assert!(
        d0(&free) >= d0(&guided) + 1.0,
        "{} {}",
        d0(&free),
        d0(&guided)
    );
    for candidate in &free.candidates {
        let q = &candidate.points[0].response;
        let least_n = ThickWall::between_ends(&candidate.muscle)
            .buckling_n(q.pressure_mpa, q.contraction)
            .unwrap();
        assert!(15.0 <= 0.5 * least_n * (1.0 + 1e-9), "{least_n}");
    }
    // Thin tubes alone: the closest would do if it were guided.
    let thin = Spec {
        outer_diameter_mm: Values::List(vec![d0(&guided) + 0.5]),
        ..spec(-15.0, -0.1, limits)
    };
    let outcome = design(&thin, BUILD).unwrap();
    let closest = &outcome.rejected[0];
    assert_eq!(closest.check.limit, Limit::Buckling);
    assert!(closest.misses_by > 0.0);
    let changes = outcome.relaxations;
    assert!(changes.contains(&Relaxation::Guided {}), "{changes:?}");
}

/// A certainty of 97.5 % leaves the half-width of 95 % of two sides, on the side of zero.
#[test]
fn a_push_that_is_certain_leaves_its_half_width() {
    let sure = Spec {
        certainty: Some(0.975),
        ..spec(-30.0, -0.1, Limits::default())
    };
    let outcome = design(&sure, BUILD).unwrap();
    let best = &outcome.candidates[0];
    let (model, workspace) = (ThickWall::between_ends(&best.muscle), &mut Workspace::new());
    let mut model = Evaluation::new(&model, workspace, Options::default());
    let (built, _) = model.predicted(0.25, -0.1, -push_n(&best.muscle)).unwrap();
    assert!(built.predicted_high_n <= -30.0 + 1e-3, "{built:?}");
}

#[test]
fn a_pull_and_a_push_at_once_and_strands_of_the_wrong_angle_are_refused() {
    let mixed = Spec {
        wanted: Demand::Points {
            points: [(-30.0, -0.1), (30.0, 0.1)]
                .map(|(force_n, contraction)| OperatingPoint {
                    force_n,
                    contraction,
                })
                .to_vec(),
        },
        ..spec(-30.0, -0.1, Limits::default())
    };
    assert!(matches!(design(&mixed, BUILD), Err(SpecError::Refused(..))));
    assert!(matches!(
        design(&spec(-30.0, 0.1, Limits::default()), BUILD),
        Err(SpecError::Refused(_, said)) if said.contains("-30\u{a0}N")
    ));
    let steep = Spec {
        braid: BraidChoice::Angle(Values::List(vec![30.0])),
        ..spec(-30.0, -0.1, Limits::default())
    };
    let error = design(&steep, BUILD).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("braid.angle is 30 deg; this muscle contracts"),
        "{error}"
    );
    assert!(
        error.to_string().contains("take an angle above 54.7"),
        "{error}"
    );
}
