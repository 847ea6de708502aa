mod doubts;
mod history;

use super::*;
use crate::{least_squares::Noise, measured::MeasuredPoint};
use mckibben_core::{
    built::{
        Experience, HALF_95, Predictor, Prior,
        learnt::{NOISE, Place, kernel},
    },
    cancel::Cancelled,
    model::{ForceModel, ModelError, ThickWall, Workspace},
    muscle::{
        Braid, BraidStiffness, Constant, Direction, Friction, Muscle, Rubber, Terminals, Tube,
        measures::{FRICTION_COEFFICIENT, FRICTION_EXPONENT},
    },
    progress::Progress,
    rubber::{Law, NeoHookean},
};
use nalgebra::DMatrix;

fn thick(m: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
    Ok(Box::new(ThickWall::between_ends(m)))
}

fn with_ends(m: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
    mckibben_core::model::ModelKind::ThickWall.build(m)
}

fn muscle(law: Law, stiffness: BraidStiffness) -> Muscle {
    let tube = Tube::new(20.0, 1.5, 200.0, Rubber::new(law));
    let braid = Braid {
        angle_deg: 25.0,
        stiffness,
        ..Braid::paper()
    };
    Muscle::new(tube, braid, Terminals::default(), None).unwrap()
}

fn soft() -> Muscle {
    muscle(
        Law::NeoHookean(NeoHookean { mu_mpa: 0.3 }),
        BraidStiffness::NewtonPerMm(400.0),
    )
}

const PLACES: [(f64, f64); 15] = [
    (0.1, 0.0),
    (0.1, 0.05),
    (0.1, 0.1),
    (0.2, 0.0),
    (0.2, 0.05),
    (0.2, 0.1),
    (0.2, 0.15),
    (0.3, 0.0),
    (0.3, 0.05),
    (0.3, 0.1),
    (0.3, 0.15),
    (0.3, 0.2),
    (0.4, 0.1),
    (0.4, 0.15),
    (0.4, 0.2),
];

/// A pull of the mean of the branches.
fn pull(pressure_mpa: f64, contraction: f64, force_n: f64) -> DataPoint {
    DataPoint::new(MeasuredPoint {
        pressure_mpa,
        contraction,
        force_n,
        branch: Some(Direction::Mean),
    })
}

/// What a bench would read of a muscle, both branches where it has friction; the contraction it
/// reads is that of the muscle less `offset`.
fn bench(m: &Muscle, offset: f64) -> Vec<DataPoint> {
    let model = ThickWall::between_ends(m);
    let branches: &[Direction] = match m.friction() {
        None => &[Direction::Mean],
        Some(_) => &[Direction::Contraction, Direction::Elongation],
    };
    let mut out = vec![];
    for (pressure_mpa, contraction) in PLACES {
        for &branch in branches {
            let half = m
                .friction()
                .map_or(0.0, |f| f.coefficient * pressure_mpa.powf(f.exponent));
            let signed = branch.sign() * half;
            let force_n = model
                .force_n(&mut Workspace::new(), pressure_mpa, contraction + offset)
                .unwrap()
                + signed;
            let at = MeasuredPoint {
                pressure_mpa,
                contraction,
                force_n,
                branch: Some(branch),
            };
            out.push(DataPoint {
                line: out.len() as u64 + 2,
                ..DataPoint::new(at)
            });
        }
    }
    out
}

/// Pulls at twelve contractions of each pressure.
fn curves(m: &Muscle, pressures: &[f64], step: f64) -> Vec<DataPoint> {
    let model = ThickWall::between_ends(m);
    let mut out = vec![];
    for &pressure_mpa in pressures {
        for contraction in (0..12).map(|i| step * f64::from(i)) {
            let force_n = model
                .force_n(&mut Workspace::new(), pressure_mpa, contraction)
                .unwrap();
            out.push(pull(pressure_mpa, contraction, force_n));
        }
    }
    out
}

fn noisy(points: &[DataPoint], deviation: f64, seed: u64) -> Vec<DataPoint> {
    let mut noise = Noise(seed);
    let mut out = points.to_vec();
    out.iter_mut()
        .for_each(|p| p.at.force_n += deviation * noise.next());
    out
}

fn free(m: &Muscle, names: &[&str]) -> Vec<Target> {
    names.iter().map(|n| Target::parse(n, m).unwrap()).collect()
}

/// Whether a note of a fit has this part.
fn says(fit: &Identification, part: &str) -> bool {
    fit.notes.iter().any(|note| note.contains(part))
}

fn identified(
    m: &Muscle,
    names: &[&str],
    points: &[DataPoint],
) -> Result<Identification, IdentifyError> {
    identify(&IdentificationRequest::new(
        m,
        &free(m, names),
        points,
        &thick,
    ))
}

#[test]
fn whoever_no_longer_wants_the_answer_gets_none() {
    struct Gone;
    impl Progress for Gone {
        fn cancelled(&self) -> bool {
            true
        }
    }
    let m = soft();
    let free = free(&m, &["mu"]);
    let points = bench(&m, 0.0);
    let request = IdentificationRequest {
        progress: &Gone,
        ..IdentificationRequest::new(&m, &free, &points, &thick)
    };
    assert_eq!(
        identify(&request).unwrap_err(),
        IdentifyError::Cancelled(Cancelled)
    );
}

/// Softer than [`soft`].
fn softer() -> Muscle {
    muscle(
        Law::NeoHookean(NeoHookean { mu_mpa: 0.25 }),
        BraidStiffness::NewtonPerMm(400.0),
    )
}

/// What the posterior weighs of a muscle whose modulus alone is free, κ its logarithm: pulls less
/// those of the model, the slopes of the interval by κ ([`mckibben_core::built`]), and R as its
/// formula stands in [`posterior`](super::posterior).
fn weighed(base: &Muscle, points: &[DataPoint], kappa: f64) -> [DMatrix<f64>; 3] {
    let w = &mut Workspace::new();
    let mut pull_n = |kappa: f64, p: &DataPoint| {
        let changed = with_values(base, &[(Target::Modulus, kappa.exp())]).unwrap();
        let model = ThickWall::between_ends(&changed);
        model
            .force_n(w, p.at.pressure_mpa, p.at.contraction)
            .unwrap()
    };
    let n = points.len();
    let off = points.iter().map(|p| p.at.force_n - pull_n(kappa, p));
    let off = DMatrix::from_iterator(n, 1, off.collect::<Vec<_>>());
    let mut x = [0.0; Constant::ALL.len()];
    x[Constant::Modulus as usize] = kappa;
    let prior = Prior::of(base, Experience::built_in());
    let predictor = Predictor::about(base, x, prior.covariance()).unwrap();
    let at = |p: &DataPoint| predictor.at(p.at.pressure_mpa, p.at.contraction, 0.0);
    let known: Vec<_> = points.iter().map(|p| at(p).unwrap()).collect();
    let slopes = known.iter().map(|at| at.slopes[Constant::Modulus as usize]);
    let slopes = DMatrix::from_iterator(n, 1, slopes);
    let places: Vec<Place> = known.iter().map(|at| at.place).collect();
    let highest = |of: fn(&Place) -> f64| places.iter().map(of).fold(0.0, f64::max);
    let (highest_mpa, blocked_n) = (highest(|p| p.pressure_mpa), highest(|p| p.blocked_n));
    let covariance = DMatrix::from_fn(n, n, |i, k| {
        let noise_n = if i == k { NOISE * blocked_n } else { 0.0 };
        kernel(&places[i], &places[k], highest_mpa) + noise_n * noise_n
    });
    [off, slopes, covariance]
}

/// By the normal equation of one unknown: with κ = ln(μ/μ0), σ its deviation before and g the slopes,
/// gᵀR⁻¹(y − f(κ)) = κ/σ², by halving; its variance is 1/(gᵀR⁻¹g + 1/σ²). The search ends where a
/// step is below 1e-6 σ. Nothing else moves.
#[test]
fn one_constant_that_is_named_is_that_of_its_normal_equation() {
    let base = softer();
    let points = noisy(&bench(&soft(), 0.0), 4.0, 7);
    let sigma = Prior::of(&base, Experience::built_in()).deviation[Constant::Modulus as usize];
    let solved = |kappa: f64| {
        let [off, slopes, covariance] = weighed(&base, &points, kappa);
        let weighted = covariance.lu().solve(&slopes).unwrap();
        let told = (weighted.transpose() * off)[(0, 0)];
        let known = (weighted.transpose() * slopes)[(0, 0)];
        (
            told - kappa / (sigma * sigma),
            known + 1.0 / (sigma * sigma),
        )
    };
    let (mut low, mut high) = (-1.0, 1.0);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if solved(middle).0 > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let deviation = 1.0 / solved(low).1.sqrt();
    let fit = identified(&base, &["mu"], &points).unwrap();
    let [mu] = &fit.parameters[..] else {
        panic!("{:#?}", fit.parameters)
    };
    let kappa = (mu.value / 0.25).ln();
    assert!((kappa - low).abs() < 1e-5 * sigma, "{kappa} {low}");
    let expected = HALF_95 * mu.value * deviation;
    assert!(
        (mu.half_width / expected - 1.0).abs() < 1e-4,
        "{mu:#?} {expected}"
    );
    assert!(
        mu.identifiable && (mu.value - 0.3).abs() < mu.half_width,
        "{mu:#?}"
    );
    let stated = with_values(&base, &[(Target::Law(0), mu.value)]).unwrap();
    assert_eq!(fit.muscle, stated);
}

/// By the normal equations of two unknowns, κ = ln(μ/μ0) and the zero z of the load cell, whose prior
/// has the largest pull as its deviation: with G = [g 1] and M = GᵀR⁻¹G + diag(1/σ², 1/s²), the step
/// M⁻¹ [GᵀR⁻¹(y − f − z) − (κ/σ², z/s²)] from what was found is none. The search ends where a step of
/// κ is below 1e-6 σ, and z follows κ by M₁₂/M₂₂.
#[test]
fn a_zero_of_the_load_cell_is_that_of_the_normal_equations() {
    let base = softer();
    let mut points = noisy(&bench(&soft(), 0.0), 4.0, 7);
    points.iter_mut().for_each(|p| p.at.force_n += 12.0);
    let fit = identified(&base, &["mu", "force_offset"], &points).unwrap();
    let [mu, zero] = &fit.parameters[..] else {
        panic!("{:#?}", fit.parameters)
    };
    assert_eq!((zero.name.as_str(), zero.unit), ("force_offset", "N"));
    let sigma = Prior::of(&base, Experience::built_in()).deviation[Constant::Modulus as usize];
    let largest_n = points.iter().map(|p| p.at.force_n).fold(0.0, f64::max);
    let (kappa, before) = ((mu.value / 0.25).ln(), [sigma, largest_n]);
    let [off, slopes, covariance] = weighed(&base, &points, kappa);
    let columns = DMatrix::from_fn(points.len(), 2, |i, k| if k == 0 { slopes[i] } else { 1.0 });
    let weighted = covariance.lu().solve(&columns).unwrap();
    let off = off.add_scalar(-zero.value);
    let mut m = weighted.transpose() * &columns;
    let mut right = weighted.transpose() * off;
    for (i, value) in [kappa, zero.value].into_iter().enumerate() {
        m[(i, i)] += before[i].powi(-2);
        right[i] -= value / before[i].powi(2);
    }
    let inverse = m.clone().try_inverse().unwrap();
    let step = &inverse * right;
    assert!(step[0].abs() < 1e-5 * sigma, "{step}");
    let follows = (m[(0, 1)] / m[(1, 1)]).abs();
    assert!(step[1].abs() < 1e-5 * sigma * follows, "{step}");
    let expected = HALF_95 * inverse[(1, 1)].sqrt();
    assert!(
        (zero.half_width / expected - 1.0).abs() < 1e-4,
        "{zero:#?} {expected}"
    );
    assert!((zero.value - 12.0).abs() < zero.half_width, "{zero:#?}");
    assert!(!says(&fit, "load cell"), "{:?}", fit.notes);
    // What is left is that of the pulls without the zero, and none is sought that is not named.
    assert!(fit.rms_n < 8.0, "{}", fit.rms_n);
    let all = identify(&IdentificationRequest::new(&base, &[], &points, &thick)).unwrap();
    assert_eq!(all.parameter(Target::ForceOffset).map(|p| p.value), None);
}

/// The one modulus of a law that is not zero means the modulus, by its value too; of two none does.
#[test]
fn the_only_modulus_of_a_law_is_its_modulus() {
    let mooney = |c10, c01| {
        let law = Law::named("mooney-rivlin", &[c10, c01]).unwrap();
        muscle(law, BraidStiffness::NewtonPerMm(400.0))
    };
    let gent = Law::named("gent", &[0.25, 20.0]).unwrap();
    for (base, name) in [
        (mooney(0.125, 0.0), "c10"),
        (muscle(gent, BraidStiffness::NewtonPerMm(400.0)), "mu"),
    ] {
        let points = bench(&base, 0.0);
        let fit = identified(&base, &[name], &points).unwrap();
        let [p] = &fit.parameters[..] else {
            panic!("{:#?}", fit.parameters)
        };
        assert!(
            p.name.ends_with("modulus") && (p.value - 1.0).abs() < 1e-6,
            "{p:#?}"
        );
        // A bound of 1.25 times its value holds the truth away.
        let free = free(&base, &[name]);
        let value = free[0].value(&base).unwrap();
        let bounds = [(free[0], (1.25 * value, 4.0 * value))];
        let request = IdentificationRequest::new(&base, &free, &points, &thick);
        let bounded = identify(&IdentificationRequest {
            bounds: &bounds,
            ..request
        });
        let p = &bounded.unwrap().parameters[0];
        assert!(p.at_bound && (p.value - 1.25).abs() < 1e-12, "{p:#?}");
    }
    let two = mooney(0.1, 0.05);
    let refused = identified(&two, &["c10"], &bench(&two, 0.0)).unwrap_err();
    assert!(
        refused.to_string().contains("is stated, not identified"),
        "{refused}"
    );
}

/// Where the muscle has its constants the points say nothing else: the prior and they agree. A name
/// is any of those of a constant.
#[test]
fn constants_that_are_right_stay_where_they_are() {
    let m = soft();
    for names in [
        &["mu"][..],
        &["modulus"],
        &["mu", "braid.stiffness", "braid.angle"],
    ] {
        let fit = identified(&m, names, &bench(&m, 0.0)).unwrap();
        assert_eq!(fit.parameters.len(), names.len());
        for (p, truth) in fit.parameters.iter().zip([0.3, 25.0, 400.0]) {
            let truth = if p.name == "braid.stiffness" {
                400.0
            } else {
                truth
            };
            assert!((p.value / truth - 1.0).abs() < 1e-6, "{p:#?}");
        }
        assert!(fit.rms_n < 1e-3, "{}", fit.rms_n);
    }
}

/// With the other constants as they are, exact loops give the law of the friction back.
#[test]
fn the_law_of_the_friction_comes_back_from_exact_points() {
    let rubbing = soft()
        .with_friction(Some(Friction::power_law(25.0, 0.7)))
        .unwrap();
    let names = ["friction.c", "friction.beta"];
    let fit = identified(&soft(), &names, &bench(&rubbing, 0.0)).unwrap();
    for (measure, truth) in [(&FRICTION_COEFFICIENT, 25.0), (&FRICTION_EXPONENT, 0.7)] {
        let p = fit.parameter(Target::Measure(measure)).unwrap();
        assert!(
            p.identifiable && (p.value - truth).abs() < 1e-6 * (1.0 + truth),
            "{p:#?}"
        );
    }
    // Both that were fixed stay.
    let fixed = [(Target::Measure(&FRICTION_COEFFICIENT), 20.0)];
    let points = bench(&rubbing, 0.0);
    let m = soft();
    let fit = identify(&IdentificationRequest {
        fixed: &fixed,
        ..IdentificationRequest::new(&m, &[], &points, &thick)
    })
    .unwrap();
    assert_eq!(fit.muscle.friction().unwrap().coefficient, 20.0);
    assert!(fit.parameter(fixed[0].0).is_none());
}

/// By hand: half the difference of both branches at one state is C P^β, whatever else was measured.
/// The means are off here by up to 20 %, and so are pulls of one branch alone. Of one pair C is known
/// as half the difference of two readings of 2 %.
#[test]
fn pairs_of_branches_at_one_state_tell_the_friction() {
    let rubbing = soft()
        .with_friction(Some(Friction::power_law(25.0, 0.7)))
        .unwrap();
    let mut points = bench(&rubbing, 0.0);
    for (i, pair) in points.chunks_mut(2).enumerate() {
        let off = 0.2 * (i as f64).sin() * pair[0].at.force_n;
        pair.iter_mut().for_each(|p| p.at.force_n += off);
    }
    let alone = points.clone().into_iter().step_by(2).map(|mut p| {
        p.at.contraction += 0.02;
        p.at.force_n *= 0.8;
        p
    });
    points.extend(alone);
    let names = ["friction.c", "friction.beta"];
    let fit = identified(&soft(), &names, &points).unwrap();
    for (p, truth) in fit.parameters.iter().zip([25.0, 0.7]) {
        assert!(
            p.identifiable && (p.value / truth - 1.0).abs() < 1e-6,
            "{p:#?}"
        );
    }
    let one: Vec<DataPoint> = [&points[4..6], &points[30..]].concat();
    let fit = identified(&soft(), &["friction.c"], &one).unwrap();
    let p = fit
        .parameter(Target::Measure(&FRICTION_COEFFICIENT))
        .unwrap();
    let at = |i: usize| one[i].at;
    let law = at(0)
        .pressure_mpa
        .powf(fit.muscle.friction().unwrap().exponent);
    let half_n = 0.5 * (at(1).force_n - at(0).force_n);
    assert!((p.value * law / half_n - 1.0).abs() < 1e-9, "{p:#?}");
    let noise_n = 0.02 * at(1).force_n / 2.0_f64.sqrt();
    assert!(
        p.identifiable && (p.half_width * law / (1.96 * noise_n) - 1.0).abs() < 1e-9,
        "{p:#?}"
    );
}

/// The same muscle read three ways gives the same constants: what was read counts as the pull there.
#[test]
fn isotonic_and_pressure_readings_tell_the_same() {
    let names = ["mu", "braid.stiffness"];
    let found = |points: &[DataPoint]| -> Vec<f64> {
        let fit = identified(&softer(), &names, points).unwrap();
        fit.parameters.iter().map(|p| p.value).collect()
    };
    let mut points = noisy(&bench(&soft(), 0.0), 1.0, 7);
    let pulls = found(&points);
    for quantity in [Quantity::Contraction, Quantity::Pressure] {
        points
            .iter_mut()
            .step_by(2)
            .for_each(|p| p.measured = quantity);
        assert_eq!(found(&points), pulls, "{quantity:?}");
    }
}

/// Exact loops of which half was read as contractions: the law of the friction comes back.
#[test]
fn contractions_under_a_load_tell_the_friction() {
    let rubbing = soft()
        .with_friction(Some(Friction::power_law(25.0, 0.7)))
        .unwrap();
    let mut points = bench(&rubbing, 0.0);
    for (i, p) in points.iter_mut().enumerate() {
        p.measured = [Quantity::Force, Quantity::Contraction, Quantity::Pressure][i % 3];
    }
    let fit = identified(&soft(), &["friction.c", "friction.beta"], &points).unwrap();
    for (p, truth) in fit.parameters.iter().zip([25.0, 0.7]) {
        assert!(
            p.identifiable && (p.value - truth).abs() < 1e-5 * (1.0 + truth),
            "{p:#?}"
        );
    }
}

/// Volumes tell no pull.
#[test]
fn volumes_alone_are_refused() {
    let m = soft();
    let mut points = bench(&m, 0.0);
    for p in &mut points {
        p.measured = Quantity::Volume;
        p.volume_mm3 = Some(1e4);
    }
    let said = identified(&m, &["braid.angle"], &points).unwrap_err();
    assert_eq!(said, DataError::NoPull { slack: 0 }.into());
}

/// What a bench would read of muscles of three lengths whose ends give way by so much, in mm.
fn of_lengths(m: &Muscle, seating_mm: f64) -> Vec<DataPoint> {
    let of_length = |length_mm: f64| {
        let section = Section {
            length_mm: Some(length_mm),
            ..Section::default()
        };
        bench(m, seating_mm / length_mm)
            .into_iter()
            .map(move |p| DataPoint { section, ..p })
    };
    [150.0, 250.0, 400.0]
        .into_iter()
        .flat_map(of_length)
        .collect()
}

/// Points of several lengths; of one length it is said what cannot be distinguished. No point is of
/// the muscle itself (200 mm): nothing is said of its bench.
#[test]
fn muscles_of_several_lengths_tell_how_far_their_ends_give_way() {
    let m = soft();
    let points = of_lengths(&m, 1.6);
    let free = free(&m, &["mu", "terminals.seating"]);
    let request = IdentificationRequest::new(&m, &free, &points, &with_ends);
    let fit = identify(&request).unwrap();
    for (p, truth) in fit.parameters.iter().zip([1.6, 0.3]) {
        assert!((p.value - truth).abs() < p.half_width, "{p:#?}");
    }
    assert_eq!(fit.bench, None);
    let determined = |points: &[DataPoint]| {
        says(
            &identify(&IdentificationRequest { points, ..request }).unwrap(),
            "all points are from muscles of one length",
        )
    };
    assert!(determined(&noisy(&points[..PLACES.len()], 0.5, 3)) && !determined(&points));
}
