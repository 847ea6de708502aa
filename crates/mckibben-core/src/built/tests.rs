use super::{learnt::*, *};
use crate::{
    model::{
        Accuracy, ForceModel, Ideal, ModelInfo, ModelKind, Reference, Response, ThickWall,
        Workspace,
    },
    muscle::{Bench, Braid, BraidStiffness, Constants, Friction, Rubber, Tube},
    rubber::{Law, NeoHookean},
};
use std::f64::consts::PI;

/// Rigid strands around a thin wall of rubber without stiffness.
fn ideal_muscle() -> Muscle {
    let m = Muscle::prototype();
    let tube = Tube {
        rubber: Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa: 1e-9 })),
        wall_mm: 1e-3,
        ..m.tube().clone()
    };
    let braid = Braid {
        stiffness: BraidStiffness::Inextensible,
        ..m.braid().clone()
    };
    m.with_tube(tube).unwrap().with_braid(braid).unwrap()
}

/// Constants by name, all others 0.
fn constants(of: &[(Constant, f64)]) -> Constants {
    let mut x = [0.0; Constant::ALL.len()];
    of.iter().for_each(|(c, v)| x[*c as usize] = *v);
    x
}

fn diagonal(deviation: &Constants) -> Vec<Constants> {
    let prior = Prior {
        centre: *deviation,
        deviation: *deviation,
    };
    prior.covariance()
}

/// The ideal model as if its error were known to be none.
struct Exact(Ideal, ModelInfo);

impl ForceModel for Exact {
    fn info(&self) -> &ModelInfo {
        &self.1
    }

    fn response(&self, w: &mut Workspace, p: f64, e: f64) -> Result<Response> {
        self.0.response(w, p, e)
    }
}

/// By hand, of an ideal muscle: a F(P − P0, ε + d D0/L0) − η T cosθ, T cosθ = F + π r² (P − P0).
#[test]
fn the_median_is_that_of_the_closed_form() {
    let m = ideal_muscle();
    let (p, e) = (0.3, 0.1);
    let x = constants(&[
        (Constant::PullFactor, 0.05),
        (Constant::Seating, 0.1),
        (Constant::TakeUp, 0.02),
        (Constant::Friction, 0.08),
    ]);
    let predictor = Predictor::about(&m, x, diagonal(&[0.0; 8])).unwrap();
    let ideal = Ideal::between_ends(&m);
    let info = ModelInfo {
        accuracy: Accuracy::share(0.0, Reference::Equations),
        ..ideal.info().clone()
    };
    let model = Exact(ideal, info);
    let w = &mut Workspace::new();
    let mut evaluation = Evaluation::new(&model, w, Direction::Mean);
    let force_n = evaluation.force_n(p, e).unwrap();
    let (built, _) = evaluation.predicted_by(&predictor, p, e, force_n).unwrap();
    let moved = e + 0.1 * 30.0 / 285.0;
    let cos = (1.0 - moved) * 28f64.to_radians().cos();
    let r = 15.0 * (1.0 - cos * cos).sqrt() / 28f64.to_radians().sin();
    let d90 = 30.0 / 28f64.to_radians().sin();
    let pull = PI / 4.0 * d90 * d90 * 0.28 * (3.0 * cos * cos - 1.0);
    let h = 0.08 * (pull + PI * r * r * 0.28);
    let expected = 0.05f64.exp() * pull - h;
    assert!(
        (built.predicted_n / expected - 1.0).abs() < 1e-4,
        "{built:?} {expected}"
    );
    assert_eq!(built.predicted_direction, Direction::Contraction);
    let shift = built.predicted_shift_n;
    let sum = shift.friction + shift.take_up + shift.ends + shift.factor;
    assert!((force_n + sum - built.predicted_n).abs() < 1e-9 * force_n);
}

/// The slopes are those of differences of the pull, constant by constant.
#[test]
fn slopes_are_those_of_differences() {
    let m = Muscle::prototype();
    let x = constants(&[
        (Constant::Seating, 0.06),
        (Constant::Compliance, 0.04),
        (Constant::TakeUp, 0.02),
        (Constant::Friction, 0.08),
    ]);
    // Narrow, so that the sides are differences.
    let covariance = diagonal(&[1e-4; 8]);
    let (p, e) = (0.25, 0.12);
    let of = |x: &Constants| Predictor::about(&m, *x, covariance.clone()).unwrap();
    // Of the mean of both branches: the slopes leave out what the constants make of the friction.
    let pull = |x: &Constants| {
        let factor = x[Constant::PullFactor as usize].exp();
        factor * of(x).at(p, e, 0.0).unwrap().force_n
    };
    let here = of(&x).at(p, e, -1.0).unwrap();
    let slopes = here.slopes;
    assert_eq!(slopes[Constant::Friction as usize], -here.strands_n);
    for constant in Constant::ALL.into_iter().take(7) {
        let i = constant as usize;
        let step = |by: f64| {
            let mut moved = x;
            moved[i] += by;
            pull(&moved)
        };
        let slope = (step(1e-4) - step(-1e-4)) / 2e-4;
        let off = (slopes[i] - slope).abs();
        assert!(
            off < 1e-4 * slope.abs(),
            "{constant:?}: {} {slope}",
            slopes[i]
        );
    }
}

/// One point, by hand: G = k/(k + σn²), and what is left k − k²/(k + σn²).
#[test]
fn one_point_moves_the_pull_towards_it() {
    let place = Place {
        pressure_mpa: 0.3,
        contraction: 0.1,
        blocked_n: 1000.0,
    };
    let learnt = Learnt::new(&[(place, 50.0, [0.0; 8])], &[], 0.3).unwrap();
    let (k, n) = ((DISCREPANCY * 1000.0).powi(2), (NOISE * 1000.0).powi(2));
    let (own_n, _, left) = learnt.at(&place, [0.0; 8]);
    assert!((own_n - 50.0 * k / (k + n)).abs() < 1e-9);
    assert!((left - (k - k * k / (k + n))).abs() < 1e-9);
    // Far away it tells nothing.
    let far = Place {
        contraction: 0.3,
        ..place
    };
    let (own_n, _, left) = learnt.at(&far, [0.0; 8]);
    assert!(own_n.abs() < 1e-6 && (left - k).abs() < 1e-6 * k);
}

/// L Lᵀ is the matrix; L⁻¹ b solves.
#[test]
fn cholesky_of_a_matrix_of_three() {
    let a = vec![
        vec![4.0, 2.0, 0.6],
        vec![2.0, 5.0, 1.0],
        vec![0.6, 1.0, 3.0],
    ];
    let l = cholesky(&a).unwrap();
    for i in 0..3 {
        for k in 0..=i {
            let sum: f64 = (0..=k).map(|j| l[i][j] * l[k][j]).sum();
            assert!((sum - a[i][k]).abs() < 1e-12);
        }
    }
    let x = forward(&l, [1.0, 2.0, 3.0]);
    for (i, b) in [1.0, 2.0, 3.0].into_iter().enumerate() {
        let sum: f64 = (0..=i).map(|j| l[i][j] * x[j]).sum();
        assert!((sum - b).abs() < 1e-12);
    }
    assert_eq!(cholesky(&[vec![1.0, 2.0], vec![2.0, 1.0]]), None);
}

/// The ± is the root of the squares of its parts, and the interval lies about the median.
#[test]
fn parts_add_as_squares() {
    let parts = UncertaintyParts {
        formula: Some(3.0),
        friction: Some(4.0),
        ..Default::default()
    };
    assert_eq!(parts.total(), 5.0);
    let names: Vec<_> = parts.named().map(|p| p.0).collect();
    assert_eq!(names, ["formula", "friction"]);
    let m = Muscle::prototype();
    let model = ThickWall::between_ends(&m);
    let w = &mut Workspace::new();
    let answer = Evaluation::new(&model, w, Direction::Mean)
        .answer(0.25, 0.1)
        .unwrap();
    let (built, parts) = (answer.built.unwrap(), answer.uncertainty_parts_n.unwrap());
    assert!((built.half_n() - parts.total()).abs() < 1e-9);
    assert!((built.predicted_high_n - built.predicted_n - parts.total()).abs() < 1e-9);
    assert!(built.predicted_n < answer.response.force_n);
}

/// h = 74·P^0.5 = 37 N at 0.25 MPa by hand: taken off while it shortens, 1.96 · 0.41 h of the ±.
#[test]
fn stated_friction_is_that_of_its_law() {
    let m = Muscle::prototype()
        .with_friction(Some(Friction::power_law(74.0, 0.5)))
        .unwrap();
    let model = ThickWall::between_ends(&m);
    for direction in Direction::ALL {
        let w = &mut Workspace::new();
        let answer = Evaluation::new(&model, w, direction)
            .answer(0.25, 0.1)
            .unwrap();
        let sign = working_direction(&m, direction).sign();
        let shift = answer.built.unwrap().predicted_shift_n;
        assert!((shift.friction - sign * 37.0).abs() < 1e-9, "{shift:?}");
        let part = answer.uncertainty_parts_n.unwrap().friction.unwrap();
        assert!((part - 1.96 * 0.41 * 37.0).abs() < 1e-9, "{part}");
    }
}

/// Nobody has held a model without a wall against measured muscles: it has no ± and no median.
#[test]
fn a_model_whose_error_nobody_has_measured_has_no_uncertainty() {
    let m = Muscle::prototype();
    for kind in [
        ModelKind::Ideal,
        ModelKind::ChouHannaford,
        ModelKind::ForceBalance,
    ] {
        let model = kind.build(&m).unwrap();
        let answer = Evaluation::new(&*model, &mut Workspace::new(), Direction::Mean)
            .answer(0.25, 0.1)
            .unwrap();
        assert!(answer.built.is_none() && answer.uncertainty_n.is_none());
    }
    let of_thick = ThickWall::between_ends(&m);
    let answer = Evaluation::new(&of_thick, &mut Workspace::new(), Direction::Mean)
        .answer(0.25, 0.1)
        .unwrap();
    assert!(answer.uncertainty_n.unwrap() > 0.0);
}

/// The ends of a sought contraction and pressure are where an end of the interval of the pull is
/// the wanted one, and the median where it is the median.
#[test]
fn identity_what_is_sought_of_a_built_muscle_is_where_its_pull_is_the_wanted_one() {
    let m = Muscle::prototype();
    let model = ThickWall::between_ends(&m);
    let w = &mut Workspace::new();
    let two_sided = Options {
        two_sided: true,
        ..Options::default()
    };
    let mut evaluation = Evaluation::new(&model, w, two_sided);
    let (force_n, p, e) = (150.0, 0.25, 0.15);
    let by_pressure = evaluation.pressure(force_n, e).unwrap();
    let by_contraction = evaluation.contraction(force_n, p).unwrap();
    let mut built = |p: f64, e: f64| evaluation.point(p, e).unwrap().built.unwrap();
    let near = |n: f64| assert!((n / force_n - 1.0).abs() < 1e-5, "{n}");
    near(built(by_pressure.predicted_mpa.unwrap(), e).predicted_n);
    near(built(by_pressure.predicted_low_mpa.unwrap(), e).predicted_high_n);
    near(built(by_pressure.predicted_high_mpa.unwrap(), e).predicted_low_n);
    near(built(p, by_contraction.predicted.unwrap()).predicted_n);
    near(built(p, by_contraction.predicted_low.unwrap()).predicted_low_n);
    near(built(p, by_contraction.predicted_high.unwrap()).predicted_high_n);
    assert!(by_pressure.predicted_mpa.unwrap() > by_pressure.response.pressure_mpa);
}

/// A hung load at the state itself: V′ = V − V²/(V + σm²) + σ1² by hand, V the variance without the
/// noise of one point.
#[test]
fn a_load_that_is_hung_leaves_what_its_noise_does() {
    let m = Muscle::prototype();
    let predictor = Predictor::of(&m, Experience::built_in()).unwrap();
    let (p, e, sign) = (0.25, 0.1, -1.0);
    let at = predictor.at(p, e, sign).unwrap();
    let by_constants: f64 = (0..8)
        .map(|i| at.slopes[i].powi(2) * predictor.covariance[i][i])
        .sum();
    let v = by_constants + (DISCREPANCY * at.place.blocked_n).powi(2);
    let noise = (NOISE * at.place.blocked_n).powi(2);
    let left = v - v * v / (v + noise) + (SINGLE * at.place.blocked_n).powi(2);
    let all = predictor.measurements(p, e, sign);
    let hung = all
        .iter()
        .find(|left| left.measurement == Measurement::HungLoad)
        .unwrap();
    assert!((hung.uncertainty_n / (1.96 * left.sqrt()) - 1.0).abs() < 1e-9);
    // No measurement makes it wider, and the best is first.
    let before = 1.96 * (v + (SINGLE * at.place.blocked_n).powi(2)).sqrt();
    assert!(
        all.windows(2)
            .all(|two| two[0].uncertainty_n <= two[1].uncertainty_n)
    );
    assert!(
        all.iter()
            .all(|left| left.uncertainty_n <= before * (1.0 + 1e-9))
    );
}

/// The numbers that are built in are read, and each deviation is above zero.
#[test]
fn the_experience_that_is_built_in_is_read() {
    let experience = Experience::built_in();
    let prior = Prior::of(&Muscle::prototype(), experience);
    assert!(prior.deviation.iter().all(|d| *d > 0.0), "{prior:?}");
}

/// An identity: of two specimens x1 = m + e1 and x2 = m + e2, whose difference has the deviation d and
/// each of which has the prior x0 ± σ, one is measured with a noise v that leaves x ± c of it. What
/// that tells of the other is the conditional normal distribution of x2 by the reading y.
#[test]
fn identity_another_specimen_has_the_conditional_distribution_of_the_prior() {
    let (muscle, experience) = (Muscle::prototype(), Experience::built_in());
    let prior = Prior::unstated(&muscle, experience);
    let left = prior.deviation.map(|sigma| 0.4 * sigma);
    let found: Constants = std::array::from_fn(|i| prior.centre[i] + 0.7 * prior.deviation[i]);
    let bench = Bench {
        laboratory: Some("another".to_owned()),
        model: "thick-wall".to_owned(),
        lengths_mm: vec![],
        points: 0,
        branches: vec![],
        pressure_mpa: (0.1, 0.3),
        contraction: (0.0, 0.2),
        pull_factor: found[Constant::PullFactor as usize].exp(),
        friction_share: found[Constant::Friction as usize],
        constants: Constant::ALL.to_vec(),
        shift: found.to_vec(),
        variance_factor: None,
        covariance: diagonal(&left).iter().map(|row| row.to_vec()).collect(),
        own_points: vec![],
        own_noise: vec![],
        of: String::new(),
    };
    let predictor = Predictor::of(&muscle.clone().with_bench(bench), experience).unwrap();
    for constant in Constant::ALL {
        let i = constant as usize;
        let (sigma2, c2) = (prior.deviation[i].powi(2), left[i].powi(2));
        // d ≥ σ √2 would say that specimens differ by more than muscles do: then nothing is known.
        let beyond = match constant {
            Constant::PullFactor => measured::beyond_measured(&muscle),
            _ => 0.0,
        };
        let common = (sigma2 - 0.5 * experience.specimen[i].powi(2)).max(0.0);
        let noise = 1.0 / (1.0 / c2 - 1.0 / sigma2);
        let reading = noise * (found[i] / c2 - prior.centre[i] / sigma2);
        let gain = common / (sigma2 + noise);
        let mean = prior.centre[i] + gain * (reading - prior.centre[i]);
        // The size lies beyond that of the muscles of the prior.
        let variance = sigma2 - gain * common + beyond.powi(2);
        // Of constants that the muscle states, the centre is the difference to what it states.
        let stated = match constant {
            Constant::PullFactor | Constant::Friction => 0.0,
            _ => found[i],
        };
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs().max(1e-3);
        assert!(close(predictor.centre[i] + stated, mean), "{constant:?}");
        assert!(close(predictor.covariance[i][i], variance), "{constant:?}");
    }
}
