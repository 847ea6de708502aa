//! Doubts that a fit states about its fit.

use super::*;
use mckibben_core::muscle::{
    file::{parse_muscle, to_toml},
    measures::{ANGLE, OUTER_DIAMETER},
};

/// Strands that do not stretch in the points stay where the prior is, and that is said; the modulus
/// comes back within its interval.
#[test]
fn what_the_points_do_not_tell_stays_with_the_prior() {
    let rigid = muscle(
        Law::NeoHookean(NeoHookean { mu_mpa: 0.3 }),
        BraidStiffness::Inextensible,
    );
    let points = noisy(&bench(&rigid, 0.0), 4.0, 5);
    let m = soft();
    let stiff = muscle(
        m.tube().rubber.law.clone(),
        BraidStiffness::NewtonPerMm(1e5),
    );
    let request = IdentificationRequest::new(&stiff, &[], &points, &thick);
    let fit = identify(&request).unwrap();
    let of = |name: &str| fit.parameters.iter().find(|p| p.name == name).unwrap();
    let (mu, k) = (of("tube.material.mu"), of("braid.stiffness"));
    assert!((mu.value - 0.3).abs() <= mu.half_width, "{mu:#?}");
    assert!(
        !k.identifiable && (k.value / 1e5 - 1.0).abs() < 0.1,
        "{k:#?}"
    );
    assert!(k.standard_error > 0.7 * k.prior_standard_deviation.unwrap());
}

/// A constant that is fixed is not sought, and one that would leave its bounds is held on one: the
/// others are then those with the constant fixed there.
#[test]
fn identity_a_constant_on_its_bound_is_one_that_is_fixed_there() {
    let points = noisy(&bench(&soft(), 0.0), 4.0, 5);
    let m = soft();
    let angle = Target::Measure(&ANGLE);
    let free = IdentificationRequest::new(&m, &[], &points, &thick);
    let sought = identify(&free).unwrap();
    let held_deg = sought.parameter(angle).unwrap().value + 1.0;
    let bounded = identify(&IdentificationRequest {
        bounds: &[(angle, (held_deg, held_deg + 3.0))],
        ..free
    })
    .unwrap();
    let fixed = identify(&IdentificationRequest {
        fixed: &[(angle, held_deg)],
        ..free
    })
    .unwrap();
    let on_bound = bounded.parameter(angle).unwrap();
    assert!(on_bound.at_bound && (on_bound.value - held_deg).abs() < 1e-12);
    assert!(fixed.parameter(angle).is_none());
    assert!((fixed.muscle.braid().angle_deg - held_deg).abs() < 1e-12);
    for p in &fixed.parameters {
        let other = bounded
            .parameters
            .iter()
            .find(|q| q.name == p.name)
            .unwrap();
        let apart = (p.value - other.value).abs();
        assert!(
            apart < 2e-3 * p.prior_standard_deviation.unwrap(),
            "{p:?} {other:?}"
        );
    }
    // Bounds beyond what any muscle has hold too.
    let far = identify(&IdentificationRequest {
        bounds: &[(angle, (34.0, 36.0))],
        ..free
    });
    let far_deg = far.unwrap().parameter(angle).unwrap().value;
    assert!((34.0..=36.0).contains(&far_deg), "{far_deg}");
    let none = Target::Measure(&OUTER_DIAMETER);
    let refused = identify(&IdentificationRequest {
        bounds: &[(none, (10.0, 20.0))],
        ..free
    });
    assert!(
        matches!(refused, Err(IdentifyError::Refused(_))),
        "{refused:?}"
    );
}

#[test]
fn outliers_are_named() {
    let m = soft();
    let mut points = noisy(&bench(&m, 0.0), 1.0, 11);
    points[4].at.force_n += 120.0;
    let fit = identified(&m, &["mu"], &points).unwrap();
    assert!(fit.points[4].outlier && fit.points.iter().filter(|p| p.outlier).count() == 1);
    assert!(
        says(&fit, "line 6 lies more than 5 robust deviations"),
        "{:?}",
        fit.notes
    );
}

#[test]
fn data_that_cannot_be_right_get_a_sentence() {
    let m = soft();
    let changes: [fn(&mut DataPoint); 6] = [
        |p| p.at.force_n *= 1000.0,
        |p| p.at.force_n /= 1000.0,
        |p| p.at.force_n /= 9.81,
        |p| p.at.pressure_mpa *= 10.0,
        |p| p.at.pressure_mpa *= 1000.0,
        |p| p.at.pressure_mpa /= 10.0,
    ];
    for change in changes {
        let mut points = bench(&m, 0.0);
        points.iter_mut().for_each(change);
        let refused = identified(&m, &["mu"], &points);
        assert!(
            matches!(refused, Err(IdentifyError::Implausible(_))),
            "{refused:?}"
        );
    }
    // An angle that may be wrong is no reason to refuse.
    let mut points = bench(&m, 0.0);
    points.iter_mut().for_each(|p| p.at.force_n *= 4.0);
    let fit = identified(&m, &["mu", "braid.angle"], &points).unwrap();
    assert!(says(&fit, "really the radius"), "{:?}", fit.notes);
}

#[test]
fn too_few_slack_and_contradicting_points_get_a_sentence() {
    let m = soft();
    let points = bench(&m, 0.0);
    // One point is welcome; of none that pulls nothing is known.
    identified(&m, &["mu", "braid.stiffness"], &points[..1]).unwrap();
    let mut some = points[..2].to_vec();
    some[0].at.force_n = 0.0;
    some[1].at.force_n = -1.0;
    let slack = identified(&m, &["mu"], &some).unwrap_err();
    let IdentifyError::Flipped(_) = slack else {
        panic!("{slack}")
    };
    some[1].at.force_n = 0.0;
    let slack = identified(&m, &["mu"], &some).unwrap_err();
    let two = IdentifyError::Data(DataError::NoPull { slack: 2 });
    assert_eq!(slack, two);
    let mut slack = points.clone();
    slack[2].at.force_n = 0.0;
    let fit = identified(&m, &["mu"], &slack).unwrap();
    assert!(
        says(&fit, "1 points without a pull were left out"),
        "{:?}",
        fit.notes
    );
    let mut twice = points.clone();
    twice.push(DataPoint {
        line: 17,
        ..twice[8]
    });
    twice[15].at.force_n *= 0.7;
    let fit = identified(&m, &["mu"], &twice).unwrap();
    let note = fit.notes.iter().find(|n| n.contains("contradict")).unwrap();
    assert!(
        note.contains("lines 10, 17") && note.contains("column `branch`"),
        "{note}"
    );
    let one = identified(&m, &["mu"], &points[7..12]).unwrap();
    assert!(
        one.notes.iter().any(|n| n.contains("the same pressure")),
        "{:?}",
        one.notes
    );
    assert!(
        one.notes.iter().all(|n| !n.contains("pattern")),
        "{:?}",
        one.notes
    );
}

#[test]
fn a_model_that_misses_in_a_pattern_is_told() {
    // Points of a muscle at 25°, an ideal angle of 22° held: smooth residuals.
    let m = soft();
    let wrong = m
        .with_braid(Braid {
            angle_deg: 22.0,
            ..m.braid().clone()
        })
        .unwrap();
    let points = curves(&m, &[0.2, 0.3, 0.4], 0.015);
    let fit = identified(&wrong, &["mu"], &points).unwrap();
    assert!(says(&fit, "follow a pattern"), "{:?}", fit.notes);
    let fit = identified(&m, &["mu"], &noisy(&points, 3.0, 4)).unwrap();
    assert!(!says(&fit, "follow a pattern"), "{:?}", fit.notes);
}

#[test]
fn names_bounds_and_doubles_are_checked() {
    let m = soft();
    let points = bench(&m, 0.0);
    let refused = |request: IdentificationRequest<'_>| {
        let error = identify(&request).unwrap_err();
        let IdentifyError::Refused(message) = error else {
            panic!("{error}")
        };
        message
    };
    let of = |free| IdentificationRequest::new(&m, free, &points, &thick);
    let twice = free(&m, &["mu", "mu"]);
    assert!(refused(of(&twice)).contains("tube.material.mu is named twice"));
    let mu = free(&m, &["mu"]);
    let fixed = [(mu[0], 0.4)];
    let both = IdentificationRequest {
        fixed: &fixed,
        ..of(&mu)
    };
    assert!(refused(both).contains("named twice"));
    let wall = free(&m, &["tube.wall_thickness"]);
    let message = refused(of(&wall));
    // Only what can be free is named.
    let known = "tube.material.mu, braid.angle, braid.stiffness, force_offset, friction.";
    let what =
        "tube.wall_thickness is stated, not identified: measure it and give its value (`fix`)";
    assert!(
        message.starts_with(what) && message.contains(known),
        "{message}"
    );
    for measured in [
        "braid.thickness",
        "braid.crimp",
        "terminals.grip",
        "tube.length",
    ] {
        assert!(!message.contains(measured), "{message}");
        let measured_free = free(&m, &[measured]);
        let request = IdentificationRequest::new(&m, &measured_free, &points, &thick);
        let message = refused(request);
        assert!(
            message.starts_with(&format!("{measured} is stated")),
            "{message}"
        );
    }
    let unknown = free_target("mo", &m).unwrap_err().to_string();
    assert!(
        unknown.contains(known) && !unknown.contains("tube.wall_thickness"),
        "{unknown}"
    );
    assert_eq!(free_target("mu", &m).unwrap(), mu[0]);
    let angle = [(Target::Measure(&ANGLE), (20.0, 30.0))];
    let not_free = IdentificationRequest {
        bounds: &angle,
        ..of(&mu)
    };
    assert!(refused(not_free).contains("braid.angle has bounds and is not free"));
    // A zero of the load cell is no value of the muscle.
    let zero = [(Target::ForceOffset, 3.0)];
    let fixed_zero = IdentificationRequest {
        fixed: &zero,
        ..of(&mu)
    };
    assert!(refused(fixed_zero).contains("subtract"));
    // A bound that holds the truth away: the constant is the bound.
    let bounds = [(mu[0], (0.35, 1.0))];
    let fit = identify(&IdentificationRequest {
        bounds: &bounds,
        ..of(&mu)
    })
    .unwrap();
    let [p] = &fit.parameters[..] else { panic!() };
    assert!(p.at_bound && (p.value - 0.35).abs() < 1e-12, "{p:#?}");
}

fn points_of(rows: &[(f64, f64, f64)]) -> Vec<DataPoint> {
    let points = rows.iter().zip(2..);
    points
        .map(|(&(bar, e, force), line)| DataPoint {
            line,
            ..pull(0.1 * bar, e, force)
        })
        .collect()
}

/// Tables of a bench as people sent them: forces, contractions or single points with the wrong
/// sign.
#[test]
fn flipped_signs_are_named_and_no_modulus_comes_out() {
    let m = soft();
    let error = |rows: &[(f64, f64, f64)]| identified(&m, &["mu"], &points_of(rows)).unwrap_err();
    let rises = [
        (1., 0., 247.),
        (1., 0.05, 300.),
        (2., 0., 483.),
        (2., 0.05, 500.),
        (3., 0., 700.),
        (3., 0.1, 900.),
    ];
    let is_flipped = |error: IdentifyError| matches!(error, IdentifyError::Flipped(_));
    assert!(is_flipped(error(&rises)));
    let right = [
        (1., 0., 247.),
        (1., 0.05, 150.),
        (2., 0., 483.),
        (2., 0.05, 300.),
        (3., 0., 724.),
        (3., 0.1, 300.),
    ];
    let negative = right.map(|(p, e, f)| (p, e, -f));
    assert!(is_flipped(error(&negative)));
    let shortened = right.map(|(p, e, f)| (p, -e, f));
    assert!(is_flipped(error(&shortened)));
    // One of them alone is left to the user, with its line.
    let exact = bench(&m, 0.0);
    assert!(
        identified(&m, &["mu"], &exact)
            .unwrap()
            .notes
            .iter()
            .all(|n| !n.contains("flipped"))
    );
    let mut one = exact.clone();
    one[8].at.force_n *= -1.0;
    let notes = identified(&m, &["mu"], &one).unwrap().notes;
    assert!(
        notes
            .iter()
            .any(|n| n.contains("line 10") && n.contains("flipped there?")),
        "{notes:?}"
    );
    let mut one = exact;
    one[8].at.contraction *= -1.0;
    let notes = identified(&m, &["mu"], &one).unwrap().notes;
    assert!(
        notes
            .iter()
            .any(|n| n.contains("the contraction is below zero (line 10)")),
        "{notes:?}"
    );
}

/// A loop without a column of branches falls as a whole, whatever its neighbours do.
#[test]
fn a_loop_without_branches_is_no_flipped_sign() {
    let m = soft()
        .with_friction(Some(Friction::power_law(60.0, 0.6)))
        .unwrap();
    let mut points = bench(&m, 0.0);
    points.iter_mut().for_each(|p| p.at.branch = None);
    let fit = identified(&soft(), &["mu"], &points).unwrap();
    assert!(
        fit.notes
            .iter()
            .all(|n| !n.contains("flipped") && !n.contains("rises")),
        "{:?}",
        fit.notes
    );
}

/// Benches with a known noise, some with both branches: their ± covers further points of the same
/// bench at its rate.
#[test]
fn the_uncertainty_of_a_bench_holds_points_that_were_held_out() {
    use mckibben_core::analysis::Evaluation;
    let plain = soft();
    let rubbing = plain
        .with_friction(Some(Friction::power_law(60.0, 0.6)))
        .unwrap();
    for (m, names) in [
        (&plain, &["mu", "braid.stiffness"][..]),
        (&rubbing, &["mu", "friction.c", "friction.beta"][..]),
    ] {
        let truth = bench(m, 0.0);
        let mut held = 0;
        let mut all = 0;
        let mut widest = 0.0_f64;
        for seed in 0..60 {
            let fit = identified(m, names, &noisy(&truth, 4.0, 1 + 7 * seed)).unwrap();
            let muscle = fit.with_bench();
            let model = ThickWall::between_ends(&muscle);
            let w = &mut Workspace::new();
            for (i, p) in noisy(&truth, 4.0, 1000 + 13 * seed).iter().enumerate() {
                // Between the points that were fitted, inside of their range.
                let e = p.at.contraction
                    + if i % 2 == 0 && p.at.contraction < 0.15 {
                        0.02
                    } else {
                        0.0
                    };
                let noise = p.at.force_n - truth[i].at.force_n;
                let pressure = p.at.pressure_mpa;
                let branch = p.at.direction();
                let exact =
                    Evaluation::new(&ThickWall::between_ends(m), w, branch).force_n(pressure, e);
                let measured = exact.unwrap() + noise;
                let mut model = Evaluation::new(&model, w, branch);
                let computed = model.force_n(pressure, e).unwrap();
                let (built, parts) = model.predicted(pressure, e, computed).unwrap();
                assert!(parts.fit.is_some() && parts.rubber.is_none(), "{parts:?}");
                // The mean of the branches has no friction.
                let friction_n = if branch.is_mean() {
                    built.predicted_shift_n.friction
                } else {
                    0.0
                };
                let off = measured - (built.predicted_n - friction_n);
                held += usize::from(off.abs() <= built.half_n());
                all += 1;
                widest = widest.max(built.half_n());
            }
        }
        let share = f64::from(held as u32) / f64::from(all as u32);
        assert!(share >= 0.95 && widest < 80.0, "{share} of {all}, {widest}");
    }
}

fn with_bench() -> Muscle {
    let m = soft();
    identified(
        &m,
        &["mu", "braid.stiffness"],
        &noisy(&bench(&m, 0.0), 4.0, 3),
    )
    .unwrap()
    .with_bench()
}

/// `[identified]` is read as it was written; with another diameter it says nothing.
#[test]
fn the_bench_stands_in_the_muscle_file() {
    let muscle = with_bench();
    let b = muscle.bench().unwrap().clone();
    assert_eq!(
        (b.points, b.pressure_mpa, b.contraction),
        (15, (0.1, 0.4), (0.0, 0.2))
    );
    assert_eq!(
        (b.model.as_str(), &b.branches[..]),
        ("thick-wall", &[Direction::Mean][..])
    );
    let text = to_toml(&muscle);
    let read = parse_muscle(&text).unwrap();
    assert_eq!((&read, read.bench()), (&muscle, Some(&b)));
    let wider =
        parse_muscle(&text.replace("diameter = \"20 mm\"", "diameter = \"21 mm\"")).unwrap();
    assert_eq!(wider.bench(), None);
    assert!(!to_toml(&wider).contains("[identified]"));
    for (from, to, key) in [
        ("points = 15", "points = -1", "identified.points"),
        (
            "branches = [\"mean\"]",
            "branches = [\"up\"]",
            "identified.branches",
        ),
        (
            "pressure = [",
            "pressure = [\"9 MPa\", ",
            "identified.pressure",
        ),
        (
            "pull_factor = ",
            "pull_factor = -",
            "identified.pull_factor",
        ),
        (
            "constants = [",
            "constants = [\"angle\", ",
            "identified.constants",
        ),
        (
            "own_points = [[",
            "own_points = [[-1, 0, 0, 0], [",
            "own_points",
        ),
        ("points = 15", "", "identified.points"),
        ("[identified]", "[identified]\nnonsense = 1", "nonsense"),
    ] {
        assert!(text.contains(from), "{text}");
        let wrong = parse_muscle(&text.replacen(from, to, 1)).unwrap_err();
        assert!(wrong.to_string().contains(key), "{key}: {wrong}");
    }
    // c₁₁ c₂₂ < c₁₂²: no covariance.
    let (one, rest) = text
        .split_once("covariance = [[")
        .and_then(|t| t.1.split_once(','))
        .unwrap();
    let smaller = format!(
        "covariance = [[{:e},{rest}",
        1e-3 * one.parse::<f64>().unwrap()
    );
    let not_one = format!("{}{smaller}", text.split_once("covariance = [[").unwrap().0);
    let wrong = parse_muscle(&not_one).unwrap_err();
    assert!(wrong.to_string().contains("covariance"), "{wrong}");
}

/// Whatever digit is changed by hand, the branch or the model: the ± is that of a muscle without
/// test data, and that is said.
#[test]
fn a_bench_that_was_edited_says_nothing() {
    let text = to_toml(&with_bench());
    let (muscle, table) = text.split_once("[identified]").unwrap();
    let mut edited: Vec<String> = vec![];
    let mut before = ' ';
    for (at, c) in table.char_indices() {
        let line = table[..at].rsplit('\n').next().unwrap();
        let here = &table[at + c.len_utf8()..];
        let first = c.is_ascii_digit() && !before.is_ascii_alphanumeric() && !".-".contains(before);
        if first && !line.contains('#') {
            let others = ['1', '4'].into_iter().filter(|digit| *digit != c);
            edited.extend(others.map(|digit| format!("{}{digit}{here}", &table[..at])));
        }
        before = c;
    }
    assert!(edited.len() > 40, "{}", edited.len());
    edited.push(table.replacen("[\"mean\"]", "[]", 1));
    edited.push(table.replacen("thick-wall", "fe", 1));
    for table in edited {
        let Ok(read) = parse_muscle(&format!("{muscle}[identified]{table}")) else {
            continue;
        };
        assert_eq!(read.bench(), None, "{table}");
        let warnings = read.warnings();
        assert!(
            warnings
                .iter()
                .any(|w| w.contains("one of them was changed")),
            "{warnings:?}"
        );
    }
}

/// A muscle whose pulls were counted negative, of which none is below 0.3 of the ideal one.
#[test]
fn pulls_that_are_all_negative_are_named() {
    let m = soft();
    let mut points = bench(&m, 0.0);
    points.iter_mut().for_each(|p| p.at.force_n *= -0.1);
    let error = identified(&m, &["mu"], &points).unwrap_err();
    assert!(
        matches!(&error, IdentifyError::Flipped(said) if said.contains("lines 2, 3, 4")),
        "{error}"
    );
    assert_eq!(doubts(&m, &points).unwrap_err(), error);
    points.iter_mut().for_each(|p| p.at.force_n = 0.0);
    assert!(
        doubts(&m, &points)
            .unwrap()
            .iter()
            .all(|n| !n.contains("sign"))
    );
    // One far below zero makes a little below zero a question of the sign too.
    let mut points = bench(&m, 0.0);
    points
        .iter_mut()
        .zip([-0.1, -1.0, -0.1])
        .for_each(|(p, factor)| p.at.force_n *= factor);
    assert!(
        doubts(&m, &points).unwrap()[0].contains("(lines 2, 3, 4)"),
        "{:?}",
        doubts(&m, &points)
    );
}

/// A wall of 0.1 mm with 25 MPa pulls as one of 1.5 mm with 1.7 MPa would: no rubber is so stiff,
/// and the wall was measured wrong.
#[test]
fn a_modulus_of_no_rubber_is_named() {
    let thin = |mu_mpa: f64| {
        soft()
            .with_tube(Tube {
                wall_mm: 0.1,
                rubber: Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa })),
                ..soft().tube().clone()
            })
            .unwrap()
    };
    let said = |mu_mpa: f64| {
        let fit = identified(&thin(mu_mpa), &["mu"], &bench(&thin(mu_mpa), 0.0)).unwrap();
        assert!(
            (fit.parameters[0].value / mu_mpa - 1.0).abs() < 1e-3,
            "{:#?}",
            fit.parameters
        );
        fit.notes
            .iter()
            .any(|n| n.contains("rubbers lie between 0.005 and 20 MPa"))
    };
    assert_eq!((said(25.0), said(2.0)), (true, false));
}
