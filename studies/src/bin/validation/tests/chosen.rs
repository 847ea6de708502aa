//! Chosen constants by least squares: known ones come back, and their ± is right.

use crate::chosen::{ChosenFit, Parameter};
use mckibben_core::{
    model::{ForceModel, ModelError, ThickWall, Workspace},
    muscle::{
        Braid, BraidStiffness, Direction, Friction, Muscle, Rubber, Terminals, Tube,
        measures::{END_FACTOR, PRESTRETCH},
    },
    rubber::{Law, MooneyRivlin, NeoHookean, Yeoh},
};
use mckibben_fit::{
    identify::{Found, Target::Law as OfLaw},
    measured::{DataPoint, MeasuredPoint, Quantity, Section},
};

/// Numbers as good as normal ones: the sum of twelve from a linear congruential generator.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        let mut one = || {
            self.0 = self
                .0
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1u64 << 53) as f64
        };
        (0..12).map(|_| one()).sum::<f64>() - 6.0
    }
}

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

fn noisy(points: &[DataPoint], deviation: f64, seed: u64) -> Vec<DataPoint> {
    let mut noise = Noise(seed);
    let mut out = points.to_vec();
    out.iter_mut()
        .for_each(|p| p.at.force_n += deviation * noise.next());
    out
}

fn identified(m: &Muscle, names: &[&str], points: &[DataPoint]) -> Found {
    let free: Vec<Parameter> = names
        .iter()
        .map(|n| Parameter::parse(n, m).unwrap())
        .collect();
    ChosenFit::new(m, &free, points, &thick).found().unwrap()
}

fn values(m: &Muscle, names: &[&str], points: &[DataPoint]) -> Vec<f64> {
    let fit = identified(m, names, points);
    assert!(
        fit.parameters.iter().all(|p| p.identifiable),
        "{:#?}",
        fit.parameters
    );
    fit.parameters.iter().map(|p| p.value).collect()
}

#[test]
fn known_constants_come_back_from_exact_points() {
    let yeoh = Law::Yeoh(Yeoh {
        c10_mpa: 0.15,
        c20_mpa: 0.01,
        c30_mpa: 0.0,
    });
    let rubbing = soft()
        .with_friction(Some(Friction::power_law(25.0, 0.7)))
        .unwrap();
    let with = |measure, value| soft().with(measure, value).unwrap();
    type Case<'a> = (Muscle, f64, Vec<(&'a str, f64)>);
    let cases: Vec<Case<'_>> = vec![
        (soft(), 0.0, vec![("mu=0.5", 0.3)]),
        (
            soft(),
            0.0,
            vec![("mu=0.2", 0.3), ("braid.stiffness=900", 400.0)],
        ),
        (
            soft(),
            0.0,
            vec![
                ("mu=0.2", 0.3),
                ("braid.angle=23", 25.0),
                ("tube.outer_diameter=21", 20.0),
            ],
        ),
        (
            soft(),
            0.0,
            vec![
                ("tube.wall_thickness=1.0", 1.5),
                ("braid.stiffness=300", 400.0),
            ],
        ),
        (
            muscle(yeoh.clone(), BraidStiffness::Inextensible),
            0.0,
            vec![("modulus=1.5", 1.0)],
        ),
        (
            muscle(yeoh, BraidStiffness::Inextensible),
            0.0,
            vec![("c10=0.3", 0.15), ("c20=0", 0.01)],
        ),
        (
            rubbing,
            0.0,
            vec![
                ("mu=0.5", 0.3),
                ("friction.c=10", 25.0),
                ("friction.beta=1", 0.7),
            ],
        ),
        (
            with(&END_FACTOR, 1.15),
            0.0,
            vec![("end_factor=1.0", 1.15), ("mu=0.4", 0.3)],
        ),
        (
            with(&PRESTRETCH, 1.15),
            0.0,
            vec![("tube.prestretch=1.0", 1.15)],
        ),
    ];
    for (m, offset, wanted) in cases {
        let names: Vec<&str> = wanted.iter().map(|w| w.0).collect();
        for (value, (name, truth)) in values(&m, &names, &bench(&m, offset)).iter().zip(&wanted) {
            assert!(
                (value - truth).abs() < 1e-6 * (1.0 + truth.abs()),
                "{name}: {value}, not {truth}"
            );
        }
    }
}

/// The same muscle read three ways gives the same constants.
#[test]
fn isotonic_and_pressure_readings_tell_the_same() {
    let m = soft();
    for quantity in [Quantity::Contraction, Quantity::Pressure] {
        let mut points = bench(&m, 0.0);
        points
            .iter_mut()
            .step_by(2)
            .for_each(|p| p.measured = quantity);
        let v = values(&m, &["mu=0.45", "braid.stiffness=700"], &points);
        assert!(
            (v[0] - 0.3).abs() < 1e-6 && (v[1] - 400.0).abs() < 1e-3,
            "{quantity:?}: {v:?}"
        );
    }
}

/// 95 % intervals hold the truth in 95 % of 300 trials: 285, ± 3 standard deviations of a binomial
/// count are ± 11.3.
#[test]
fn error_bars_cover_the_truth_at_their_rate() {
    let m = soft();
    let exact = bench(&m, 0.0);
    let mut hits = [0; 2];
    for trial in 0..300 {
        let points = noisy(&exact, 4.0, 77 + trial);
        let fit = identified(&m, &["mu", "braid.stiffness"], &points);
        for (i, truth) in [0.3, 400.0].iter().enumerate() {
            hits[i] += usize::from(
                (fit.parameters[i].value - truth).abs() <= fit.parameters[i].half_width,
            );
        }
    }
    assert!(hits.iter().all(|h| (274..=296).contains(h)), "{hits:?}");
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

/// Ends that give way by δ shift a muscle by δ/L0: several lengths tell δ and the modulus apart.
#[test]
fn muscles_of_several_lengths_tell_how_far_their_ends_give_way() {
    let m = soft();
    let seating = 1.6;
    let points = of_lengths(&m, seating);
    let free = ["mu=0.5", "terminals.seating"].map(|n| Parameter::parse(n, &m).unwrap());
    let fit = ChosenFit::new(&m, &free, &points, &with_ends)
        .found()
        .unwrap();
    for (p, truth) in fit.parameters.iter().zip([0.3, seating]) {
        assert!(p.identifiable && (p.value - truth).abs() < 1e-6, "{p:#?}");
    }
}

/// Ends that slip under F + π Ri² P and hold 4 mm each: points are made from the muscle between its
/// ends, whose contraction is chosen, so that the whole's follows without a search. Slip, grip and
/// modulus come back.
#[test]
fn muscles_of_several_lengths_tell_slip_and_grip() {
    let m = soft();
    let slip = 2e-3;
    let grip = 4.0;
    let model = ThickWall::between_ends(&m);
    let bore = std::f64::consts::PI * m.tube().inner_radius_mm().powi(2);
    let mut points = vec![];
    for length_mm in [150.0, 250.0, 400.0] {
        for (pressure_mpa, x) in PLACES {
            let force_n = model
                .force_n(&mut Workspace::new(), pressure_mpa, x)
                .unwrap();
            let way = slip * (force_n + bore * pressure_mpa);
            let contraction = (x * (length_mm - 2.0 * grip) - way) / length_mm;
            let section = Section {
                length_mm: Some(length_mm),
                ..Default::default()
            };
            points.push(DataPoint {
                section,
                ..DataPoint::new(MeasuredPoint {
                    pressure_mpa,
                    contraction,
                    force_n,
                    branch: Some(Direction::Mean),
                })
            });
        }
    }
    let free = ["mu=0.5", "terminals.slip", "grip"].map(|n| Parameter::parse(n, &m).unwrap());
    let chosen = ChosenFit {
        two_sided: true,
        ..ChosenFit::new(&m, &free, &points, &with_ends)
    };
    let fit = chosen.found().unwrap();
    for (p, (truth, scale)) in fit
        .parameters
        .iter()
        .zip([(0.3, 0.3), (slip, slip), (grip, grip)])
    {
        assert!(
            p.identifiable && (p.value - truth).abs() < 1e-5 * scale,
            "{p:#?}"
        );
    }
}

#[test]
fn what_the_data_cannot_tell_is_flagged() {
    // C01 and C10 act alike where the contraction is held.
    let m = muscle(
        Law::MooneyRivlin(MooneyRivlin {
            c10_mpa: 0.1,
            c01_mpa: 0.05,
        }),
        BraidStiffness::Inextensible,
    );
    let isometric: Vec<DataPoint> = noisy(&bench(&m, 0.0), 6.0, 5)
        .into_iter()
        .filter(|p| p.at.contraction == 0.1)
        .collect();
    let fit = identified(&m, &["c10", "c01"], &isometric);
    assert!(!fit.parameters[1].identifiable, "{:#?}", fit.parameters);
    // One constant under two names, and what the model does not use.
    let m = soft();
    let points = noisy(&bench(&m, 0.0), 4.0, 5);
    let fit = identified(&m, &["mu=0.4", "modulus"], &points);
    assert!(
        fit.parameters.iter().all(|p| !p.identifiable),
        "{:#?}",
        fit.parameters
    );
    let fit = identified(&m, &["mu", "friction.c=5"], &points);
    let [mu, friction] = &fit.parameters[..] else {
        panic!()
    };
    assert!(mu.identifiable && !friction.matters, "{friction:#?}");
    // A bound that holds the truth away, and one that is the best value.
    let fit = identified(&m, &["mu=0.4:0.35:1"], &bench(&m, 0.0));
    assert!(fit.parameters[0].at_bound && !fit.parameters[0].identifiable);
}

/// A Gent muscle and points of a neo-Hookean one: the limit ends at its bound.
#[test]
fn chains_that_never_lock_have_a_limit_at_the_bound() {
    let gent = Law::named("gent", &[0.3, 10.0]).unwrap();
    let m = muscle(gent, BraidStiffness::NewtonPerMm(400.0));
    let fit = identified(&m, &["mu", "jm"], &bench(&soft(), 0.0));
    let limit = &fit.parameters[1];
    assert!(
        (100.0..=1000.0).contains(&limit.value) && !limit.identifiable,
        "{limit:#?}"
    );
}

#[test]
fn names_starts_and_bounds_are_read() {
    let m = Muscle::prototype();
    let p = Parameter::parse("tube.material.c10=0.2MPa:50kPa:1MPa", &m).unwrap();
    assert_eq!(
        p,
        Parameter {
            target: OfLaw(0),
            start: Some(0.2),
            bounds: Some((0.05, 1.0))
        }
    );
    assert_eq!(
        Parameter::parse("c01", &m).unwrap(),
        Parameter::free(OfLaw(1))
    );
    assert_eq!(
        Parameter::parse("friction.beta = 0.6", &m).unwrap().start,
        Some(0.6)
    );
    let message = |text: &str| Parameter::parse(text, &m).unwrap_err().to_string();
    assert!(message("braid.stifness").contains("did you mean braid.stiffness?"));
    assert!(message("c10=1:2:3").contains("must lie between"));
    assert!(message("c10=1:2").contains("name=start:low:high"));
    assert!(message("c10=3mm").contains("tube.material.c10"));
}
