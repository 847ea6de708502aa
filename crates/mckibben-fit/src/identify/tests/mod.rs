mod doubts;
mod history;

use super::*;
use crate::{
    least_squares::{Loss, Noise},
    measured::MeasuredPoint,
};
use mckibben_core::{
    cancel::Cancelled,
    model::{ForceModel, ModelError, ThickWall, Workspace},
    muscle::{
        Braid, BraidStiffness, Direction, Friction, Muscle, Rubber, Terminals, Tube,
        measures::{END_FACTOR, PRESTRETCH},
    },
    progress::Progress,
    rubber::{Law, MooneyRivlin, NeoHookean, Yeoh},
};

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

fn free(m: &Muscle, names: &[&str]) -> Vec<Parameter> {
    names
        .iter()
        .map(|n| Parameter::parse(n, m).unwrap())
        .collect()
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

fn values(m: &Muscle, names: &[&str], points: &[DataPoint]) -> Vec<f64> {
    let fit = identified(m, names, points).unwrap();
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
            soft(),
            0.02,
            vec![("mu=0.5", 0.3), ("contraction_offset", 0.02)],
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
            vec![("end-factor=1.0", 1.15), ("mu=0.4", 0.3)],
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

/// Volumes alone, read with hose and fittings, give the angle of a braid and what they hold.
#[test]
fn volumes_without_pulls_give_the_angle_and_the_dead_volume() {
    let m = soft();
    let volume = |p: &DataPoint| {
        let at = &p.at;
        let dead_mm3 = 5000.0;
        let inside = ThickWall::between_ends(&m).response(
            &mut Workspace::new(),
            at.pressure_mpa,
            at.contraction,
        );
        DataPoint {
            measured: Quantity::Volume,
            volume_mm3: Some(inside.unwrap().volume_mm3.unwrap() + dead_mm3),
            at: MeasuredPoint {
                force_n: 0.0,
                ..*at
            },
            ..*p
        }
    };
    let points: Vec<DataPoint> = bench(&m, 0.0).iter().map(volume).collect();
    let v = values(&m, &["braid.angle=29", "dead_volume"], &points);
    assert!(
        (v[0] - 25.0).abs() < 1e-6 && (v[1] - 5000.0).abs() < 1e-2,
        "{v:?}"
    );
}

#[test]
fn muscles_of_several_diameters_tell_how_the_stiffness_grows() {
    let m = soft();
    let mut points = vec![];
    for d in [15.0, 20.0, 30.0] {
        let braid = BraidStiffness::NewtonPerMm(400.0 * (d / 20.0f64).powf(0.8));
        let wide = m.with_section(d, 1.5).unwrap();
        let wide = wide
            .with_braid(Braid {
                stiffness: braid,
                ..wide.braid().clone()
            })
            .unwrap();
        let section = Section {
            outer_diameter_mm: Some(d),
            ..Section::default()
        };
        points.extend(
            bench(&wide, 0.0)
                .into_iter()
                .map(|p| DataPoint { section, ..p }),
        );
    }
    let v = values(
        &m,
        &[
            "mu=0.4",
            "braid.stiffness=500",
            "braid.stiffness_exponent=0",
        ],
        &points,
    );
    assert!(
        (v[1] - 400.0).abs() < 1e-3 && (v[2] - 0.8).abs() < 1e-6,
        "{v:?}"
    );
}

/// 95 % intervals hold the truth in 95 % of 300 trials: 285, ± 3 standard deviations of a binomial
/// count are ± 11.3.
#[test]
fn error_bars_cover_the_truth_at_their_rate() {
    let m = soft();
    let exact = bench(&m, 0.0);
    let mut hits = [0; 2];
    for trial in 0..300 {
        let fit = identified(
            &m,
            &["mu", "braid.stiffness"],
            &noisy(&exact, 4.0, 77 + trial),
        )
        .unwrap();
        for (i, truth) in [0.3, 400.0].iter().enumerate() {
            hits[i] += usize::from(
                (fit.parameters[i].value - truth).abs() <= fit.parameters[i].half_width,
            );
        }
    }
    assert!(hits.iter().all(|h| (274..=296).contains(h)), "{hits:?}");
}

/// Where the errors are stated, points count by them: a muscle read ten times worse at half of its
/// points tells its modulus better than one whose points all count the same.
#[test]
fn stated_errors_weigh_the_points() {
    let m = soft();
    let exact = bench(&m, 0.0);
    let mut plain = 0.0;
    let mut weighed = 0.0;
    for trial in 0..60 {
        let mut noise = Noise(9000 + trial);
        let mut points = exact.clone();
        for (i, p) in points.iter_mut().enumerate() {
            let error = if i % 2 == 0 { 1.0 } else { 10.0 };
            p.at.force_n += error * noise.next();
            p.error = Some(error);
        }
        let off = |points: &[DataPoint]| {
            let fit = identified(&m, &["mu"], points).unwrap();
            (fit.parameters[0].value - 0.3).powi(2)
        };
        weighed += off(&points);
        points.iter_mut().for_each(|p| p.error = None);
        plain += off(&points);
    }
    // Variances: 1/Σ(g²/σ²) against Σ g²σ²/(Σ g²)², with equal slopes g some 25 to 1.
    assert!(plain > 8.0 * weighed, "{plain} {weighed}");
    let mut points = exact;
    points[3].error = Some(1.0);
    let error = identified(&m, &["mu"], &points).unwrap_err().to_string();
    assert!(
        error.contains("1 of 15 points state their error") && error.contains("line 2"),
        "{error}"
    );
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

/// Ends that give way by δ shift a muscle by δ/L0: several lengths tell δ, the modulus and an error
/// of the length's zero apart.
#[test]
fn muscles_of_several_lengths_tell_how_far_their_ends_give_way() {
    let m = soft();
    let seating = 1.6;
    let points = of_lengths(&m, seating);
    let free = free(&m, &["mu=0.5", "terminals.seating", "contraction_offset"]);
    let request = IdentificationRequest::new(&m, &free, &points, &with_ends);
    let fit = identify(&request).unwrap();
    for (p, truth) in fit.parameters.iter().zip([0.3, seating, 0.0]) {
        assert!(p.identifiable && (p.value - truth).abs() < 1e-6, "{p:#?}");
    }
    let determined = |points: &[DataPoint]| {
        says(
            &identify(&IdentificationRequest { points, ..request }).unwrap(),
            "all points are from muscles of one length",
        )
    };
    assert!(determined(&noisy(&points[..PLACES.len()], 0.5, 3)) && !determined(&points));
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
                ..pull(pressure_mpa, contraction, force_n)
            });
        }
    }
    let free = free(&m, &["mu=0.5", "terminals.slip", "grip"]);
    let request = IdentificationRequest {
        two_sided: true,
        ..IdentificationRequest::new(&m, &free, &points, &with_ends)
    };
    let fit = identify(&request).unwrap();
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

/// Points of a Gent muscle, rounded to 0.1 N: the law that made them is preferred, its constants
/// come back, and the errors of neighbours are independent with it alone.
#[test]
fn of_all_laws_the_points_prefer_the_one_that_made_them() {
    use mckibben_core::rubber::Gent;
    let m = soft();
    let truth = muscle(
        Law::Gent(Gent {
            mu_mpa: 0.35,
            jm: 6.0,
        }),
        m.braid().stiffness,
    );
    let mut points = curves(&truth, &[0.1, 0.2, 0.3, 0.4], 0.02);
    points
        .iter_mut()
        .for_each(|p| p.at.force_n = 0.1 * (10.0 * p.at.force_n).round());
    let free = [Parameter::free(Target::Modulus)];
    let trials = try_laws(&IdentificationRequest::new(&m, &free, &points, &thick)).unwrap();
    assert_eq!(
        trials.len(),
        Law::KINDS.iter().filter(|k| !k.is_sum).count()
    );
    let best = &trials[0];
    assert_eq!(best.law, "gent");
    let fit = best.result.as_ref().unwrap();
    assert!((fit.parameters[0].value - 0.35).abs() < fit.parameters[0].half_width);
    assert!((fit.parameters[1].value - 6.0).abs() < fit.parameters[1].half_width);
    let plain = trials.iter().find(|t| t.law == "neo-hookean").unwrap();
    let neighbours = [best.neighbours, plain.neighbours];
    assert!(
        neighbours[0].abs() < 0.4 && neighbours[1] > 0.8,
        "{neighbours:?}"
    );
    assert!(plain.aicc - best.aicc > 100.0);
}
