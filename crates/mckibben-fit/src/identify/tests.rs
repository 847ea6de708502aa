use super::*;
use crate::least_squares::Loss;
use crate::measured::MeasuredPoint;
use mckibben::model::{ForceModel, ModelError, ThickWall, Workspace};
use mckibben::muscle::{Braid, BraidStiffness, Direction, Friction, Muscle, Rubber, Terminals, Tube};
use mckibben::progress::{Progress, Silent};
use mckibben::rubber::{Law, MooneyRivlin, NeoHookean, Yeoh};

/// Numbers as good as normal ones: the sum of twelve from a linear congruential generator.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        let mut one = || {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1u64 << 53) as f64
        };
        (0..12).map(|_| one()).sum::<f64>() - 6.0
    }
}

fn thick(m: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
    Ok(Box::new(ThickWall::new(m)))
}

fn muscle(law: Law, stiffness: BraidStiffness) -> Muscle {
    let tube = Tube::new(20.0, 1.5, 200.0, Rubber::of(law));
    let braid = Braid { angle_deg: 25.0, stiffness, ..Braid::paper() };
    Muscle::new(tube, braid, Terminals::default(), None).unwrap()
}

fn soft() -> Muscle {
    muscle(Law::NeoHookean(NeoHookean { mu_mpa: 0.3 }), BraidStiffness::NewtonPerMm(400.0))
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

/// What a bench would read of a muscle, both branches where it has friction; the contraction it reads is that of the muscle
/// less `offset`.
fn bench(m: &Muscle, offset: f64) -> Vec<DataPoint> {
    let model = ThickWall::new(m);
    let branches: &[Direction] = match m.friction() {
        None => &[Direction::Mean],
        Some(_) => &[Direction::Contraction, Direction::Elongation],
    };
    let mut out = vec![];
    for (pressure_mpa, contraction) in PLACES {
        for &branch in branches {
            let half = m.friction().map_or(0.0, |f| f.coefficient * pressure_mpa.powf(f.exponent));
            let signed = branch.sign() * half;
            let force_n =
                model.force_n(&mut Workspace::new(), pressure_mpa, contraction + offset).unwrap() + signed;
            let at = MeasuredPoint { pressure_mpa, contraction, force_n, branch };
            out.push(DataPoint { line: out.len() as u64 + 2, ..DataPoint::of(at) });
        }
    }
    out
}

fn noisy(points: &[DataPoint], deviation: f64, seed: u64) -> Vec<DataPoint> {
    let mut noise = Noise(seed);
    let mut out = points.to_vec();
    out.iter_mut().for_each(|p| p.at.force_n += deviation * noise.next());
    out
}

fn free(m: &Muscle, names: &[&str]) -> Vec<Parameter> {
    names.iter().map(|n| Parameter::parse(n, m).unwrap()).collect()
}

fn found(
    m: &Muscle,
    names: &[&str],
    points: &[DataPoint],
    loss: Loss,
) -> Result<Identification, IdentifyError> {
    let free = free(m, names);
    identify(&Request { muscle: m, free: &free, fixed: &[], points, loss, two_sided: false }, thick)
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
    let (free, points) = (free(&m, &["mu"]), bench(&m, 0.0));
    let request = Request {
        muscle: &m,
        free: &free,
        fixed: &[],
        points: &points,
        loss: Loss::Squares,
        two_sided: false,
    };
    assert_eq!(identify_with(&request, thick, &Gone).unwrap_err(), IdentifyError::Cancelled);
}

fn values(m: &Muscle, names: &[&str], points: &[DataPoint]) -> Vec<f64> {
    let found = found(m, names, points, Loss::Squares).unwrap();
    assert!(found.parameters.iter().all(|p| p.identifiable), "{:#?}", found.parameters);
    found.parameters.iter().map(|p| p.value).collect()
}

#[test]
fn known_constants_come_back_from_exact_points() {
    let yeoh = Law::Yeoh(Yeoh { c10_mpa: 0.15, c20_mpa: 0.01, c30_mpa: 0.0 });
    let rubbing = Friction::power_law(25.0, 0.7);
    let with = |m: &Muscle| {
        let (tube, braid) = (m.tube().clone(), m.braid().clone());
        Muscle::new(tube, braid, m.terminals().clone(), Some(rubbing)).unwrap()
    };
    type Case<'a> = (Muscle, f64, Vec<(&'a str, f64)>);
    let cases: Vec<Case<'_>> = vec![
        (soft(), 0.0, vec![("mu=0.5", 0.3)]),
        (soft(), 0.0, vec![("mu=0.2", 0.3), ("braid.stiffness=900", 400.0)]),
        (soft(), 0.0, vec![("mu=0.2", 0.3), ("braid.angle=23", 25.0), ("tube.outer_diameter=21", 20.0)]),
        (soft(), 0.0, vec![("tube.wall_thickness=1.0", 1.5), ("braid.stiffness=300", 400.0)]),
        (soft(), 0.02, vec![("mu=0.5", 0.3), ("contraction_offset", 0.02)]),
        (muscle(yeoh.clone(), BraidStiffness::Inextensible), 0.0, vec![("modulus=1.5", 1.0)]),
        (muscle(yeoh, BraidStiffness::Inextensible), 0.0, vec![("c10=0.3", 0.15), ("c20=0", 0.01)]),
        (with(&soft()), 0.0, vec![("mu=0.5", 0.3), ("friction.c=10", 25.0), ("friction.beta=1", 0.7)]),
    ];
    for (m, offset, wanted) in cases {
        let names: Vec<&str> = wanted.iter().map(|w| w.0).collect();
        for (value, (name, truth)) in values(&m, &names, &bench(&m, offset)).iter().zip(&wanted) {
            assert!((value - truth).abs() < 1e-6 * (1.0 + truth.abs()), "{name}: {value}, not {truth}");
        }
    }
}

#[test]
fn an_end_factor_comes_back() {
    let mut m = soft();
    let terminals =
        Terminals { end_factor: Some(mckibben::muscle::EndFactor::Constant(1.15)), ..Terminals::default() };
    m = m.with_terminals(terminals).unwrap();
    let v = values(&m, &["end-factor=1.0", "mu=0.4"], &bench(&m, 0.0));
    assert!((v[0] - 1.15).abs() < 1e-6 && (v[1] - 0.3).abs() < 1e-6, "{v:?}");
}

/// The same muscle read three ways gives the same constants.
#[test]
fn isotonic_and_pressure_readings_tell_the_same() {
    let m = soft();
    for quantity in [Quantity::Contraction, Quantity::Pressure] {
        let mut points = bench(&m, 0.0);
        points.iter_mut().step_by(2).for_each(|p| p.measured = quantity);
        let v = values(&m, &["mu=0.45", "braid.stiffness=700"], &points);
        assert!((v[0] - 0.3).abs() < 1e-6 && (v[1] - 400.0).abs() < 1e-3, "{quantity:?}: {v:?}");
    }
}

#[test]
fn muscles_of_several_diameters_tell_how_the_stiffness_grows() {
    let m = soft();
    let mut points = vec![];
    for d in [15.0, 20.0, 30.0] {
        let braid = BraidStiffness::NewtonPerMm(400.0 * (d / 20.0f64).powf(0.8));
        let wide = m.with_section(d, 1.5).unwrap();
        let wide = wide.with_braid(Braid { stiffness: braid, ..wide.braid().clone() }).unwrap();
        let section = Section { outer_diameter_mm: Some(d), ..Section::default() };
        points.extend(bench(&wide, 0.0).into_iter().map(|p| DataPoint { section, ..p }));
    }
    let v = values(&m, &["mu=0.4", "braid.stiffness=500", "braid.stiffness_exponent=0"], &points);
    assert!((v[1] - 400.0).abs() < 1e-3 && (v[2] - 0.8).abs() < 1e-6, "{v:?}");
}

/// 95 % intervals hold the truth in 95 % of 300 trials: 285, ± 3 standard deviations of a binomial count are ± 11.3.
#[test]
fn error_bars_cover_the_truth_at_their_rate() {
    let m = soft();
    let exact = bench(&m, 0.0);
    let mut hits = [0; 2];
    for trial in 0..300 {
        let f =
            found(&m, &["mu", "braid.stiffness"], &noisy(&exact, 4.0, 77 + trial), Loss::Squares).unwrap();
        for (i, truth) in [0.3, 400.0].iter().enumerate() {
            hits[i] += usize::from((f.parameters[i].value - truth).abs() <= f.parameters[i].half_width);
        }
    }
    assert!(hits.iter().all(|h| (274..=296).contains(h)), "{hits:?}");
}

/// Where the errors are stated, points count by them: a muscle read ten times worse at half of its points tells its
/// modulus better than one whose points all count the same.
#[test]
fn stated_errors_weigh_the_points() {
    let m = soft();
    let exact = bench(&m, 0.0);
    let (mut plain, mut weighed) = (0.0, 0.0);
    for trial in 0..60 {
        let mut noise = Noise(9000 + trial);
        let mut points = exact.clone();
        for (i, p) in points.iter_mut().enumerate() {
            let error = if i % 2 == 0 { 1.0 } else { 10.0 };
            p.at.force_n += error * noise.next();
            p.error = Some(error);
        }
        let off = |points: &[DataPoint]| {
            let f = found(&m, &["mu"], points, Loss::Squares).unwrap();
            (f.parameters[0].value - 0.3).powi(2)
        };
        weighed += off(&points);
        points.iter_mut().for_each(|p| p.error = None);
        plain += off(&points);
    }
    // Variances: 1/Σ(g²/σ²) against Σ g²σ²/(Σ g²)², with equal slopes g some 25 to 1.
    assert!(plain > 8.0 * weighed, "{plain} {weighed}");
    let mut points = exact;
    points[3].error = Some(1.0);
    let error = found(&m, &["mu"], &points, Loss::Squares).unwrap_err().to_string();
    assert!(error.contains("1 of 15 points state their error") && error.contains("line 2"), "{error}");
}

#[test]
fn what_the_data_cannot_tell_is_flagged() {
    // C01 and C10 act alike where the contraction is held.
    let m =
        muscle(Law::MooneyRivlin(MooneyRivlin { c10_mpa: 0.1, c01_mpa: 0.05 }), BraidStiffness::Inextensible);
    let isometric: Vec<DataPoint> =
        noisy(&bench(&m, 0.0), 6.0, 5).into_iter().filter(|p| p.at.contraction == 0.1).collect();
    let f = found(&m, &["c10", "c01"], &isometric, Loss::Squares).unwrap();
    assert!(!f.parameters[1].identifiable, "{:#?}", f.parameters);
    assert!(f.notes.iter().any(|n| n.contains("tube.material.c01 is not identifiable")), "{:?}", f.notes);
    // k of strands that do not stretch.
    let stiff = soft();
    let rigid = muscle(Law::NeoHookean(NeoHookean { mu_mpa: 0.3 }), BraidStiffness::Inextensible);
    let f = found(&stiff, &["mu", "braid.stiffness"], &noisy(&bench(&rigid, 0.0), 4.0, 5), Loss::Squares)
        .unwrap();
    assert!(!f.parameters[1].identifiable && f.parameters[0].identifiable, "{:#?}", f.parameters);
    assert!(f.notes.iter().any(|n| n.contains("inextensible strands")), "{:?}", f.notes);
    // One constant under two names.
    let f =
        found(&stiff, &["mu=0.4", "modulus"], &noisy(&bench(&stiff, 0.0), 4.0, 5), Loss::Squares).unwrap();
    assert!(f.parameters.iter().all(|p| !p.identifiable), "{:#?}", f.parameters);
    // What the model does not use.
    let f =
        found(&stiff, &["mu", "friction.c=5"], &noisy(&bench(&stiff, 0.0), 4.0, 5), Loss::Squares).unwrap();
    assert!(!f.parameters[1].matters && f.parameters[0].identifiable, "{:#?}", f.parameters);
    assert!(
        f.notes.iter().any(|n| n.contains("friction.coefficient: it has no effect on any point")),
        "{:?}",
        f.notes
    );
}

#[test]
fn the_default_does_not_free_an_unidentifiable_stiffness() {
    let rigid = muscle(Law::NeoHookean(NeoHookean { mu_mpa: 0.3 }), BraidStiffness::Inextensible);
    let points = noisy(&bench(&rigid, 0.0), 4.0, 5);
    let m = soft();
    let stiff =
        m.with_braid(Braid { stiffness: BraidStiffness::NewtonPerMm(1e5), ..m.braid().clone() }).unwrap();
    let request = Request {
        muscle: &stiff,
        free: &[],
        fixed: &[],
        points: &points,
        loss: Loss::Squares,
        two_sided: false,
    };
    let f = identify_default(&request, thick, &Silent).unwrap();
    assert_eq!(f.parameters.len(), 1);
    assert!((f.parameters[0].value - 0.3).abs() < 0.05, "{:#?}", f.parameters);
    assert!(f.notes.iter().any(|n| n.contains("was not changed")), "{:?}", f.notes);
}

#[test]
fn outliers_are_named_and_a_robust_loss_is_not_moved_by_them() {
    let m = soft();
    let mut points = noisy(&bench(&m, 0.0), 1.0, 11);
    points[4].at.force_n += 120.0;
    let squares = found(&m, &["mu"], &points, Loss::Squares).unwrap();
    let huber = found(&m, &["mu"], &points, Loss::Huber).unwrap();
    assert!((squares.parameters[0].value - 0.3).abs() > 3.0 * (huber.parameters[0].value - 0.3).abs());
    assert!(squares.points[4].outlier && squares.points.iter().filter(|p| p.outlier).count() == 1);
    let note = squares.notes.iter().find(|n| n.contains("robust deviations")).unwrap();
    assert!(note.contains("line 6 lies") && note.contains("robust loss"), "{note}");
}

#[test]
fn data_that_cannot_be_right_get_a_sentence() {
    let m = soft();
    let message = |change: &dyn Fn(&mut DataPoint)| {
        let mut points = bench(&m, 0.0);
        points.iter_mut().for_each(change);
        found(&m, &["mu"], &points, Loss::Squares).unwrap_err().to_string()
    };
    assert!(message(&|p| p.at.force_n *= 1000.0).contains("is force_n in mN"));
    assert!(message(&|p| p.at.force_n /= 1000.0).contains("is force_n in kN"));
    assert!(message(&|p| p.at.force_n /= 9.81).contains("kgf"));
    assert!(message(&|p| p.at.pressure_mpa *= 10.0).contains("name the column pressure_bar"));
    assert!(message(&|p| p.at.pressure_mpa *= 1000.0).contains("name the column pressure_kpa"));
    assert!(message(&|p| p.at.pressure_mpa /= 10.0).contains("the highest pressure is 0.0400 MPa"));
    // A diameter that may be wrong is no reason to refuse.
    let mut points = bench(&m, 0.0);
    points.iter_mut().for_each(|p| p.at.force_n *= 4.0);
    let f = found(&m, &["mu", "tube.outer_diameter"], &points, Loss::Squares).unwrap();
    assert!(f.notes.iter().any(|n| n.contains("really the radius")), "{:?}", f.notes);
}

#[test]
fn too_few_slack_and_contradicting_points_get_a_sentence() {
    let m = soft();
    let points = bench(&m, 0.0);
    let few = found(&m, &["mu", "braid.stiffness"], &points[..2], Loss::Squares).unwrap_err().to_string();
    assert!(few.contains("2 points that pull do not determine 2 parameters: at least 3"), "{few}");
    let mut some = points[..4].to_vec();
    some[2].at.force_n = 0.0;
    some[3].at.force_n = -1.0;
    let slack = found(&m, &["mu", "braid.stiffness"], &some, Loss::Squares).unwrap_err().to_string();
    assert!(slack.contains("(2 more points without a measured force were left out)"), "{slack}");
    let mut twice = points.clone();
    twice.push(DataPoint { line: 17, ..twice[8] });
    twice[15].at.force_n *= 0.7;
    let f = found(&m, &["mu"], &twice, Loss::Squares).unwrap();
    let note = f.notes.iter().find(|n| n.contains("contradict")).unwrap();
    assert!(note.contains("lines 10, 17") && note.contains("column `branch`"), "{note}");
    let one = found(&m, &["mu"], &points[7..12], Loss::Squares).unwrap();
    assert!(one.notes.iter().any(|n| n.contains("the same pressure")), "{:?}", one.notes);
    assert!(one.notes.iter().all(|n| !n.contains("pattern")), "{:?}", one.notes);
}

#[test]
fn a_model_that_misses_in_a_pattern_is_told() {
    // Points of a muscle at 25°, an ideal angle of 22° held: smooth residuals.
    let m = soft();
    let wrong = m.with_braid(Braid { angle_deg: 22.0, ..m.braid().clone() }).unwrap();
    let mut points = vec![];
    let model = ThickWall::new(&m);
    for pressure_mpa in [0.2, 0.3, 0.4] {
        for i in 0..12 {
            let contraction = f64::from(i) * 0.015;
            let force_n = model.force_n(&mut Workspace::new(), pressure_mpa, contraction).unwrap();
            let at = MeasuredPoint { pressure_mpa, contraction, force_n, branch: Direction::Mean };
            points.push(DataPoint::of(at));
        }
    }
    let f = found(&wrong, &["mu"], &points, Loss::Squares).unwrap();
    assert!(f.notes.iter().any(|n| n.contains("follow a pattern")), "{:?}", f.notes);
    let f = found(&m, &["mu"], &noisy(&points, 3.0, 4), Loss::Squares).unwrap();
    assert!(f.notes.iter().all(|n| !n.contains("follow a pattern")), "{:?}", f.notes);
}

#[test]
fn starts_bounds_and_doubles_are_checked() {
    let m = muscle(Law::NeoHookean(NeoHookean { mu_mpa: 0.3 }), BraidStiffness::Inextensible);
    let points = bench(&m, 0.0);
    let error = |names: &[&str]| found(&m, names, &points, Loss::Squares).unwrap_err();
    assert_eq!(error(&[]), IdentifyError::NothingFree);
    assert!(matches!(error(&["mu", "mu=2"]), IdentifyError::Twice { .. }));
    assert!(error(&["braid.stiffness"]).to_string().contains("write braid.stiffness=START"));
    let outside = Parameter { bounds: Some((0.5, 1.0)), ..free(&m, &["mu"])[0] };
    let request = Request {
        muscle: &m,
        free: &[outside],
        fixed: &[],
        points: &points,
        loss: Loss::Squares,
        two_sided: false,
    };
    assert!(matches!(identify(&request, thick).unwrap_err(), IdentifyError::OutOfBounds { .. }));
    // A bound that holds the truth away is reported.
    let f = found(&m, &["mu=0.4:0.35:1"], &points, Loss::Squares).unwrap();
    assert!(f.parameters[0].at_bound && !f.parameters[0].identifiable, "{:#?}", f.parameters);
    assert!(f.notes.iter().any(|n| n.contains("is at its bound")), "{:?}", f.notes);
}

#[test]
fn tables_with_all_columns_are_read() {
    let text = "pressure_bar,contraction_percent,force_n,branch,measured,contraction_error,weight,outer_diameter_mm\n\
                2,10,150,elongation,contraction,0.002,2,14\n3,5,250,,,,,\n";
    let points = read_data(text.as_bytes()).unwrap();
    let first = &points[0];
    assert_eq!((first.at.pressure_mpa, first.at.contraction, first.at.force_n), (0.2, 0.1, 150.0));
    assert_eq!((first.measured, first.error, first.weight), (Quantity::Contraction, Some(0.002), 2.0));
    assert_eq!((first.section.outer_diameter_mm, first.line), (Some(14.0), 2));
    assert_eq!((points[1].measured, points[1].error, points[1].weight), (Quantity::Force, None, 1.0));
    let error = |row: &str| {
        let text = format!("pressure_mpa,contraction,force_n,measured,weight,force_error_n\n{row}\n");
        read_data(text.as_bytes()).unwrap_err().to_string()
    };
    assert!(error("0.1,0,3,length,,").contains("neither \"force\""));
    assert!(error("0.1,0,3,,-1,").contains("column weight: -1"));
    assert!(error("0.1,0,3,,,0").contains("not a valid standard error"));
}

/// Ends that give way by δ shift a muscle by δ/L0: several lengths tell δ, the modulus and an error of the length's zero apart.
#[test]
fn muscles_of_several_lengths_tell_how_far_their_ends_give_way() {
    let (m, seating) = (soft(), 1.6);
    let of_length = |length_mm: f64| {
        let own = bench(&m, seating / length_mm).into_iter();
        own.map(move |p| {
            let section = crate::measured::Section { length_mm: Some(length_mm), ..p.section };
            DataPoint { section, ..p }
        })
    };
    let points: Vec<DataPoint> = [150.0, 250.0, 400.0].into_iter().flat_map(of_length).collect();
    let free = free(&m, &["mu=0.5", "terminals.seating", "contraction_offset"]);
    let request = Request {
        muscle: &m,
        free: &free,
        fixed: &[],
        points: &points,
        loss: Loss::Squares,
        two_sided: false,
    };
    let found = identify(&request, |m: &Muscle| mckibben::model::ModelKind::ThickWall.build(m)).unwrap();
    for (p, truth) in found.parameters.iter().zip([0.3, seating, 0.0]) {
        assert!(p.identifiable && (p.value - truth).abs() < 1e-6, "{p:#?}");
    }
    let determined = |points: &[DataPoint]| {
        let one = Request { points, ..request };
        let found = identify(&one, |m: &Muscle| mckibben::model::ModelKind::ThickWall.build(m)).unwrap();
        found.notes.iter().any(|note| note.contains("all points are from muscles of one length"))
    };
    assert!(determined(&noisy(&points[..PLACES.len()], 0.5, 3)) && !determined(&points));
}

/// Ends that slip under F + π Ri² P and hold 4 mm each: points are made from the muscle between its ends, whose contraction is chosen, so that
/// the whole's follows without a search. Slip, grip and modulus come back.
#[test]
fn muscles_of_several_lengths_tell_slip_and_grip() {
    let (m, slip, grip) = (soft(), 2e-3, 4.0);
    let model = ThickWall::new(&m);
    let bore = std::f64::consts::PI * m.tube().inner_radius_mm().powi(2);
    let mut points = vec![];
    for length_mm in [150.0, 250.0, 400.0] {
        for (pressure_mpa, x) in PLACES {
            let force_n = model.force_n(&mut Workspace::new(), pressure_mpa, x).unwrap();
            let way = slip * (force_n + bore * pressure_mpa);
            let contraction = (x * (length_mm - 2.0 * grip) - way) / length_mm;
            let at = MeasuredPoint { pressure_mpa, contraction, force_n, branch: Direction::Mean };
            let section = crate::measured::Section { length_mm: Some(length_mm), ..Default::default() };
            points.push(DataPoint { section, ..DataPoint::of(at) });
        }
    }
    let free = free(&m, &["mu=0.5", "terminals.slip", "grip"]);
    let request = Request {
        muscle: &m,
        free: &free,
        fixed: &[],
        points: &points,
        loss: Loss::Squares,
        two_sided: true,
    };
    let found = identify(&request, |m: &Muscle| mckibben::model::ModelKind::ThickWall.build(m)).unwrap();
    for (p, (truth, scale)) in found.parameters.iter().zip([(0.3, 0.3), (slip, slip), (grip, grip)]) {
        assert!(p.identifiable && (p.value - truth).abs() < 1e-5 * scale, "{p:#?}");
    }
}

/// Points of a Gent muscle, rounded to 0.1 N: the law that made them is preferred, its constants come back, and the errors of neighbours are
/// independent with it alone.
#[test]
fn of_all_laws_the_points_prefer_the_one_that_made_them() {
    use mckibben::rubber::Gent;
    let m = soft();
    let law = |law: Law| {
        let tube = m.tube().clone();
        m.with_tube(Tube { rubber: Rubber::of(law), ..tube }).unwrap()
    };
    let truth = law(Law::Gent(Gent { mu_mpa: 0.35, jm: 6.0 }));
    let model = ThickWall::new(&truth);
    let mut points = vec![];
    for pressure_mpa in [0.1, 0.2, 0.3, 0.4] {
        for i in 0..12 {
            let contraction = 0.02 * f64::from(i);
            let force_n = model.force_n(&mut Workspace::new(), pressure_mpa, contraction).unwrap();
            let force_n = 0.1 * (10.0 * force_n).round();
            let branch = Direction::Mean;
            points.push(DataPoint::of(MeasuredPoint { pressure_mpa, contraction, force_n, branch }));
        }
    }
    let free = [Parameter::free(Target::Modulus)];
    let (muscle, loss) = (&m, Loss::Squares);
    let request = Request { muscle, free: &free, fixed: &[], points: &points, loss, two_sided: false };
    let build = |m: &Muscle| Ok(Box::new(ThickWall::new(m)) as Box<dyn ForceModel>);
    let trials = try_laws(&request, build, &mckibben::progress::Silent).unwrap();
    assert_eq!(trials.len(), Law::KINDS.iter().filter(|k| !k.is_sum).count());
    let best = &trials[0];
    assert_eq!(best.law, "gent");
    let found = best.found.as_ref().unwrap();
    assert!((found.parameters[0].value - 0.35).abs() < found.parameters[0].half_width);
    assert!((found.parameters[1].value - 6.0).abs() < found.parameters[1].half_width);
    let plain = trials.iter().find(|t| t.law == "neo-hookean").unwrap();
    assert!(
        best.neighbours.abs() < 0.4 && plain.neighbours > 0.8,
        "{} {}",
        best.neighbours,
        plain.neighbours
    );
    assert!(plain.aicc - best.aicc > 100.0);
}

fn points_of(rows: &[(f64, f64, f64)]) -> Vec<DataPoint> {
    let one = |(i, &(pressure_bar, contraction, force_n)): (usize, &(f64, f64, f64))| {
        let pressure_mpa = 0.1 * pressure_bar;
        let at = MeasuredPoint { pressure_mpa, contraction, force_n, branch: Direction::Mean };
        DataPoint { line: i as u64 + 2, ..DataPoint::of(at) }
    };
    rows.iter().enumerate().map(one).collect()
}

/// Tables of a bench as people sent them: forces, contractions or single points with the wrong sign.
#[test]
fn flipped_signs_are_named_and_no_modulus_comes_out() {
    let m = soft();
    let error = |rows: &[(f64, f64, f64)]| found(&m, &["mu"], &points_of(rows), Loss::Squares).unwrap_err();
    let rises =
        [(1., 0., 247.), (1., 0.05, 300.), (2., 0., 483.), (2., 0.05, 500.), (3., 0., 700.), (3., 0.1, 900.)];
    let said = error(&rises).to_string();
    assert!(matches!(error(&rises), IdentifyError::Flipped(_)));
    assert!(said.contains("sign of the contraction flipped, or") && said.contains("lines 2, 3"), "{said}");
    let right =
        [(1., 0., 247.), (1., 0.05, 150.), (2., 0., 483.), (2., 0.05, 300.), (3., 0., 724.), (3., 0.1, 300.)];
    let negative = right.map(|(p, e, f)| (p, e, -f));
    let said = error(&negative).to_string();
    assert!(said.contains("6 of the 6 points") && said.contains("sign of the force flipped?"), "{said}");
    let shortened = right.map(|(p, e, f)| (p, -e, f));
    let said = error(&shortened).to_string();
    assert!(said.contains("sign of the contraction flipped? None"), "{said}");
    // One of them alone is left to the user, with its line.
    let exact = bench(&m, 0.0);
    assert!(found(&m, &["mu"], &exact, Loss::Squares).unwrap().notes.iter().all(|n| !n.contains("flipped")));
    let mut one = exact.clone();
    one[8].at.force_n *= -1.0;
    let notes = found(&m, &["mu"], &one, Loss::Squares).unwrap().notes;
    assert!(notes.iter().any(|n| n.contains("line 10") && n.contains("flipped there?")), "{notes:?}");
    let mut one = exact;
    one[8].at.contraction *= -1.0;
    let notes = found(&m, &["mu"], &one, Loss::Squares).unwrap().notes;
    assert!(notes.iter().any(|n| n.contains("the contraction is below zero (line 10)")), "{notes:?}");
}

/// A loop without a column of branches falls as a whole, whatever its neighbours do.
#[test]
fn a_loop_without_branches_is_no_flipped_sign() {
    let m = soft().with_friction(Some(Friction::power_law(60.0, 0.6))).unwrap();
    let mut points = bench(&m, 0.0);
    points.iter_mut().for_each(|p| p.at.branch = Direction::Mean);
    let f = found(&soft(), &["mu"], &points, Loss::Squares).unwrap();
    assert!(f.notes.iter().all(|n| !n.contains("flipped") && !n.contains("rises")), "{:?}", f.notes);
}

#[test]
fn a_modulus_that_falls_to_zero_is_no_result() {
    let m = soft();
    let mut points = bench(&m, 0.0);
    points.iter_mut().for_each(|p| p.at.force_n *= 1.8);
    let error = found(&m, &["mu"], &points, Loss::Squares).unwrap_err();
    assert!(matches!(error, IdentifyError::NoRubber { .. }), "{error}");
    assert!(error.to_string().contains("tube.material.mu falls towards zero"), "{error}");
}

/// D0 20 mm: 6 mm are known of no muscle. 9 mm come back from the points, and are no finding.
#[test]
fn ends_that_give_way_by_too_much_are_not_determined() {
    let seating = 9.0;
    let m = soft();
    let points: Vec<DataPoint> = [150.0, 250.0, 400.0]
        .into_iter()
        .flat_map(|length_mm| {
            bench(&m, seating / length_mm).into_iter().map(move |p| DataPoint {
                section: crate::measured::Section { length_mm: Some(length_mm), ..p.section },
                ..p
            })
        })
        .collect();
    let free = free(&m, &["mu=0.5", "terminals.seating"]);
    let request = Request {
        muscle: &m,
        free: &free,
        fixed: &[],
        points: &points,
        loss: Loss::Squares,
        two_sided: true,
    };
    let f = identify(&request, |m: &Muscle| mckibben::model::ModelKind::ThickWall.build(m)).unwrap();
    let seating_found = &f.parameters[1];
    assert!((seating_found.value - seating).abs() < 1e-5, "{seating_found:#?}");
    assert!(seating_found.implausible && !seating_found.identifiable && !f.parameters[0].implausible);
    assert!(f.notes.iter().any(|n| n.contains("0.3 of the outer diameter")), "{:?}", f.notes);
    // No point is of the muscle itself (200 mm): nothing is said of its bench.
    assert_eq!(f.bench, None);
}

/// A constant on its bound has the bound's value, not what the search left of it.
#[test]
fn a_constant_on_its_bound_is_the_bound() {
    let m = soft();
    let free = free(&m, &["mu", "grip"]);
    let points = bench(&m, 0.0);
    let request = Request {
        muscle: &m,
        free: &free,
        fixed: &[],
        points: &points,
        loss: Loss::Squares,
        two_sided: false,
    };
    let f = identify(&request, |m: &Muscle| mckibben::model::ModelKind::ThickWall.build(m)).unwrap();
    assert!(f.parameters[1].at_bound && f.parameters[1].value == 0.0, "{:#?}", f.parameters);
    assert!(f.notes.iter().any(|n| n.contains("terminals.grip is at its bound, 0 mm")), "{:?}", f.notes);
}

/// Benches with a known noise, some with both branches: the ± that they leave holds further points of the same bench at its rate.
#[test]
fn the_uncertainty_of_a_bench_holds_points_that_were_held_out() {
    use mckibben::uncertainty::uncertainty;
    let plain = soft();
    let rubbing = plain.with_friction(Some(Friction::power_law(60.0, 0.6))).unwrap();
    for (m, names) in
        [(&plain, &["mu", "braid.stiffness"][..]), (&rubbing, &["mu", "friction.c", "friction.beta"][..])]
    {
        let truth = bench(m, 0.0);
        let (mut held, mut all, mut widest) = (0, 0, 0.0_f64);
        for seed in 0..60 {
            let f = found(m, names, &noisy(&truth, 4.0, 1 + 7 * seed), Loss::Squares).unwrap();
            let own = f.muscle.clone().with_bench(f.bench.clone().unwrap());
            let (model, w) = (ThickWall::new(&own), &mut Workspace::new());
            for (i, p) in noisy(&truth, 4.0, 1000 + 13 * seed).iter().enumerate() {
                // Between the points that were fitted, inside of their range.
                let e = p.at.contraction + if i % 2 == 0 && p.at.contraction < 0.15 { 0.02 } else { 0.0 };
                let noise = p.at.force_n - truth[i].at.force_n;
                let measured =
                    mckibben::analysis::force_on(&ThickWall::new(m), w, p.at.pressure_mpa, e, p.at.branch)
                        .unwrap()
                        + noise;
                let found =
                    mckibben::analysis::force_on(&model, w, p.at.pressure_mpa, e, p.at.branch).unwrap();
                let parts = uncertainty(&model, w, (p.at.pressure_mpa, e), found, p.at.branch).unwrap();
                assert!(
                    parts.fit.is_some() && parts.measured.is_none() && parts.friction.is_none(),
                    "{parts:?}"
                );
                held += usize::from((measured - found).abs() <= parts.total());
                all += 1;
                widest = widest.max(parts.total());
            }
        }
        let share = f64::from(held as u32) / f64::from(all as u32);
        assert!((0.93..0.985).contains(&share) && widest < 25.0, "{share} of {all}, {widest}");
    }
}

/// `[identified]` is read as it was written; with another diameter it says nothing.
#[test]
fn the_bench_stands_in_the_muscle_file() {
    use mckibben::muscle::file::{parse_muscle, to_toml};
    let m = soft();
    let f = found(&m, &["mu", "braid.stiffness"], &noisy(&bench(&m, 0.0), 4.0, 3), Loss::Squares).unwrap();
    let own = f.muscle.clone().with_bench(f.bench.unwrap());
    let b = own.bench().unwrap().clone();
    assert_eq!((b.points, b.pressure_mpa, b.contraction), (15, (0.1, 0.4), (0.0, 0.2)));
    assert_eq!((b.model.as_str(), &b.branches[..]), ("thick-wall", &[Direction::Mean][..]));
    let text = to_toml(&own);
    let read = parse_muscle(&text).unwrap();
    assert_eq!(read, own);
    assert_eq!(read.bench(), Some(&b));
    let wider =
        parse_muscle(&text.replace("outer_diameter = \"20 mm\"", "outer_diameter = \"21 mm\"")).unwrap();
    assert_eq!(wider.bench(), None);
    assert!(!to_toml(&wider).contains("[identified]"));
    let wrong = |from: &str, to: &str| {
        assert!(text.contains(from), "{text}");
        parse_muscle(&text.replacen(from, to, 1)).unwrap_err().to_string()
    };
    assert!(wrong("points = 15", "points = -1").contains("identified.points"));
    assert!(wrong("branches = [\"mean\"]", "branches = [\"up\"]").contains("identified.branches"));
    assert!(wrong("pressure = [", "pressure = [\"9 MPa\", ").contains("identified.pressure"));
    assert!(wrong("scatter = \"", "scatter = \"-").contains("identified.scatter"));
    assert!(wrong("fit = [[", "fit = [[-1, ").contains("identified.fit"));
    assert!(wrong("parameters = [", "parameters = [\"more\", ").contains("identified.covariance"));
    assert!(wrong("points = 15", "").contains("identified.points is missing"));
    assert!(wrong("[identified]", "[identified]\nnonsense = 1").contains("unknown key"));
}
