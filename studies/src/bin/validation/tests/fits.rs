//! The fits of muscles and rubbers, and what they predict.

use super::{muscle, rubbers};
use crate::{
    bounds::{hand_made, with_constants},
    case::MuscleCase,
    chosen::ChosenFit,
    elements,
    pulses::predict,
    report::{Fitted, Group, report},
    rubber,
};
use mckibben_core::{
    model::{ForceModel, ModelError, ThickWall},
    muscle::{
        Braid, BraidStiffness, Direction, Muscle, Rubber, Terminals, Tube, measures::END_FACTOR,
    },
    rubber::{Law, NeoHookean, RubberLaw},
};
use mckibben_fit::{
    identify::{Found, Identified, Target},
    library::{
        agreement, library,
        residual::{ForceErrors, Residual},
    },
    measured::{MeasuredPoint, mean_of_branches},
};

/// Independent figures for the same data: ideal 92–95 N rms, thick-wall with two fitted constants
/// about 6 N and an end factor of 1.11, an axisymmetric prototype with one fitted modulus 15.5 N of
/// 1 090 N.
#[test]
fn the_documented_errors_come_out() {
    let case = muscle("tondu2012");
    let rows = hand_made(case, &elements).unwrap();
    assert!(rows.iter().all(|r| r.holds()), "{rows:#?}");
    let rms: Vec<f64> = rows.iter().map(|r| r.computed).collect();
    assert!(
        (92.0..95.5).contains(&rms[0]) && (5.0..7.0).contains(&rms[2]),
        "{rms:?}"
    );
    assert!((14.0..20.0).contains(&rms[3]), "{rms:?}");
    assert!(
        (rows[0].reference - 1090.0).abs() < 1.0,
        "{}",
        rows[0].reference
    );
    let points: Vec<MeasuredPoint> = case.points.iter().map(|p| p.at).collect();
    let free = [Target::Modulus, Target::Measure(&END_FACTOR)];
    let muscle = with_constants(
        &case.fits[0].muscle,
        &|m| Ok(Box::new(ThickWall::between_ends(m))),
        &free,
        &mean_of_branches(&points),
    )
    .unwrap();
    assert!(
        (muscle.measure(&END_FACTOR).unwrap() - 1.11).abs() < 0.01,
        "{:?}",
        muscle.terminals()
    );
}

/// Constants from 1 to 3 bar predict 4 and 5 bar; a law that stiffens at large stretch does so better
/// on the hand-made muscle, whose rubber is not stated. A regression: nobody else has derived it.
#[test]
fn points_that_were_not_fitted_are_blind() {
    let mut case = muscle("tondu2012").clone();
    case.fits.retain(|fit| fit.split.is_some());
    let fits = report(&[&case], &elements).unwrap();
    let [plain, gent] = &fits[..] else {
        panic!("{}", fits.len())
    };
    for r in [plain, gent] {
        assert_eq!(r.to, "0.1, 0.2, 0.3 MPa");
        assert_eq!((r.groups[0].blind, r.groups[1].blind), (false, true));
        assert_eq!(r.groups[1].of, "0.4, 0.5 MPa");
        let all: usize = r.groups.iter().map(|g| g.means.points).sum();
        assert_eq!(all, 189);
    }
    let blind = |r: &Fitted<'_>| r.groups[1].means.rms_n;
    assert!(
        blind(gent) < blind(plain),
        "{} {}",
        blind(gent),
        blind(plain)
    );
}

/// By hand: of each branch the mean, the rms and the share within the ± of 3 N; means of the
/// branches are a list of their own.
#[test]
fn errors_of_a_branch_are_those_of_its_points() {
    use Direction::{Contraction, Elongation, Mean};
    let point = |branch, difference_n, half_width_n: Option<f64>| Residual {
        contraction: 0.1,
        difference_n,
        branch,
        pressure_mpa: 0.2,
        blocked_n: 100.0,
        of_built_n: half_width_n.map(|half| (difference_n, half)),
    };
    let points = [
        point(Contraction, -1.0, Some(3.0)),
        point(Mean, 0.5, Some(3.0)),
        point(Elongation, 2.0, Some(3.0)),
        point(Contraction, -7.0, Some(3.0)),
        point(Elongation, 2.0, Some(3.0)),
        point(Elongation, 2.0, None),
    ];
    let group = Group::new("all".into(), true, &points);
    let of = |errors: &ForceErrors| (errors.points, errors.bias_n, errors.rms_n, errors.held);
    assert_eq!(of(&group.means), (1, 0.5, 0.5, Some(1.0)));
    let branches = group.branches.iter().map(|b| (b.0, of(&b.1)));
    assert_eq!(
        branches.collect::<Vec<_>>(),
        [
            (Contraction, (2, -4.0, 5.0, Some(0.5))),
            (Elongation, (3, 2.0, 2.0, Some(1.0))),
        ]
    );
    // A branch that was not measured has no row.
    let rising = Group::new("some".into(), true, &points[..1]);
    assert_eq!(rising.branches.len(), 1);
}

/// Every fit of every rubber has an answer; a fit to some modes predicts the others.
#[test]
fn every_rubber_is_fitted() {
    for case in rubbers() {
        let results = rubber::report(case).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(results.len(), case.fits.len());
        for (result, fit) in results.iter().zip(&case.fits) {
            let name = format!("{} {}", case.name, fit.name);
            let fitted = result.groups.iter().filter(|g| !g.blind);
            assert!(fitted.map(|g| g.errors.points).max() > Some(5), "{name}");
            let blind = result.groups.iter().any(|g| g.blind);
            assert!(fit.modes.is_empty() || blind, "{name}");
        }
    }
}

/// An independent calculation on the same table (`thick-wall` by another program): 1 % at rest,
/// a dead volume of 44 to 56 mL, and at ε 0.044 a bias of +7.7, +2.7, +0.3 and −2.0 % for
/// braids of 25, 28.6, 31 and 34°.
#[test]
fn the_bias_by_angle_is_that_of_an_independent_calculation() {
    let build = |m: &Muscle| -> Result<Box<dyn ForceModel>, ModelError> {
        Ok(Box::new(ThickWall::between_ends(m)))
    };
    for (angle_deg, bias) in [(25.0, 0.077), (28.6, 0.027), (31.0, 0.003), (34.0, -0.020)] {
        let rubber = Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa: 1.5 }));
        let braid = Braid {
            angle_deg,
            stiffness: BraidStiffness::Inextensible,
            ..Braid::paper()
        };
        let muscle = Muscle::new(
            Tube::new(13.6, 1.8, 281.0, rubber),
            braid,
            Terminals::default(),
            None,
        )
        .unwrap();
        let predicted = predict(&build, &muscle).unwrap();
        assert!(
            (predicted.bias() - bias).abs() < 0.006,
            "{angle_deg}: {:.4}",
            predicted.bias()
        );
        assert!(
            predicted.rms_at_rest < 0.015,
            "{angle_deg}: {:.4}",
            predicted.rms_at_rest
        );
        let dead_ml = 1e-3 * predicted.dead_volume_mm3;
        assert!((40.0..60.0).contains(&dead_ml), "{angle_deg}: {dead_ml} mL");
    }
}

/// Identifies the muscle of a folder again; its muscle has the bench that states its ±.
fn refit(case: &MuscleCase) -> (Muscle, Found) {
    let fit = &case.fits[case.library_fit];
    let points = case.points_of(fit);
    let chosen = ChosenFit::new(&fit.muscle, &fit.free, &points, &elements);
    let found = chosen.found().unwrap();
    (chosen.with_bench(&found), found)
}

/// Whether a constant of the muscle that is kept is that of the refit. A factor on all moduli
/// is compared as the modulus that it gives.
fn agrees(refit: &Identified, identified: &Muscle, kept: &Muscle) -> bool {
    let modulus = |m: &Muscle| m.tube().rubber.law.shear_modulus_mpa();
    let value = match refit.target {
        Some(Target::Modulus) => Some(refit.value * modulus(kept) / modulus(identified)),
        target => target.and_then(|target| target.value(kept)),
    };
    let half = if refit.half_width.is_finite() {
        refit.half_width
    } else {
        0.0
    };
    value.is_some_and(|value| {
        (value - refit.value).abs() <= (1e-4 * refit.value.abs()).max(1e-3 * half)
    })
}

/// A regression: the kept muscles are those of this program, and nobody else has identified
/// them. That ± covers 90 % of the points or more is by its construction.
#[test]
fn the_kept_muscle_is_the_one_that_its_points_give() {
    for name in ["dmsp-10-250", "dmsp-20-300", "quadsegrity"] {
        let (of, kept) = library()
            .into_iter()
            .find(|m| m.0.facts.name == name)
            .unwrap();
        let (muscle, identification) = refit(super::muscle(name));
        let stated = |constant: &&Identified| constant.target.is_some();
        for constant in identification.parameters.iter().filter(stated) {
            assert!(
                agrees(constant, &identification.muscle, kept),
                "{name}: {constant:#?}"
            );
        }
        let (ours, theirs) = (
            agreement(of, &muscle, &elements),
            agreement(of, kept, &elements),
        );
        // The fit lets the muscle push where it is slack, the agreement does not.
        let pulls = identification
            .left
            .iter()
            .map(|(point, residual_n)| (*residual_n, point.at.force_n));
        let residuals = pulls.map(|(residual, measured)| (residual + measured).max(0.0) - measured);
        let rms_n =
            (residuals.map(|r| r * r).sum::<f64>() / identification.left.len() as f64).sqrt();
        assert!(
            (ours.rms_n / rms_n - 1.0).abs() < 1e-6,
            "{name}: {ours:?} {rms_n}"
        );
        assert!(
            (ours.rms_n / theirs.rms_n - 1.0).abs() < 1e-4,
            "{name}: {ours:?} {theirs:?}"
        );
        assert!(theirs.held.unwrap() >= 0.9, "{name}: {theirs:?}");
    }
}
