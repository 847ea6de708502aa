//! What a muscle that is built pulls where it becomes slack: over the free contraction, median and
//! interval are those of one muscle.

use mckibben_core::{
    analysis::{Evaluation, Options},
    built::{Built, Experience, Prior},
    model::{ModelKind, Workspace},
    muscle::{
        Braid, BraidStiffness, Constant, Constants, Direction, Muscle, Rubber, Terminals, Tube,
        file::parse_muscle,
    },
    random::{Random, rounds},
    rubber::{Law, NeoHookean, Yeoh},
};
use mckibben_fem::axisymmetric::Axisymmetric;

/// A muscle of the sizes that people build.
fn random(index: u64) -> Muscle {
    let mut r = Random(50_000 + index);
    r.unit();
    let outer_mm = r.log(8.0, 40.0);
    let wall_mm = outer_mm * r.between(0.05, 0.17);
    let mu_mpa = r.log(0.08, 0.6);
    let law = if index.is_multiple_of(2) {
        Law::NeoHookean(NeoHookean { mu_mpa })
    } else {
        let c10_mpa = 0.5 * mu_mpa;
        Law::from(Yeoh {
            c10_mpa,
            c20_mpa: -0.02 * c10_mpa,
            c30_mpa: 0.002 * c10_mpa,
        })
    };
    let tube = Tube::new(
        outer_mm,
        wall_mm,
        outer_mm * r.between(6.0, 20.0),
        Rubber::new(law),
    );
    let braid = Braid {
        angle_deg: r.between(15.0, 34.0),
        stiffness: BraidStiffness::NewtonPerMm(outer_mm * r.log(8.0, 60.0)),
        ..Braid::paper()
    };
    Muscle::new(tube, braid, Terminals::default(), None).unwrap()
}

fn built(model: &Axisymmetric, w: &mut Workspace, p: f64, e: f64) -> Option<Built> {
    let options = Options {
        extrapolate: true,
        ..Options::from(Direction::Contraction)
    };
    let answer = Evaluation::new(model, w, options).point(p, e).unwrap();
    answer.built
}

/// Pulls of muscles whose constants are drawn from the prior, by the equations of
/// [`mckibben_core::built`]; their strands are slack where they are.
fn draws(m: &Muscle, p: f64, e: f64, n: usize) -> Vec<f64> {
    let prior = Prior::of(m, Experience::built_in());
    let mut r = Random(7);
    let mut normal = || (0..12).map(|_| r.unit()).sum::<f64>() - 6.0;
    let mut one = || {
        let x: Constants = std::array::from_fn(|i| prior.centre[i] + prior.deviation[i] * normal());
        let drawn = m.with_constants(&x).unwrap();
        let w = &mut Workspace::new();
        let model = ModelKind::ThickWall.build(&drawn).unwrap();
        let Ok(pull) = model.response(w, p, e) else {
            return 0.0;
        };
        let strands = pull.braid_tension_n.unwrap_or(0.0);
        (x[Constant::PullFactor as usize].exp() * pull.force_n
            - x[Constant::Friction as usize].max(0.0) * strands)
            .max(0.0)
    };
    (0..n).map(|_| one()).collect()
}

/// The numbers of a muscle over contractions and rising pressures: none of them jumps.
fn is_continuous(of: impl Fn(f64) -> f64, from: f64, to: f64, scale_n: f64) -> bool {
    let (mut low, mut high) = ((from, of(from)), (to, of(to)));
    let whole = (low.1 - high.1).abs();
    if whole < 0.1 * scale_n {
        return true;
    }
    for _ in 0..10 {
        let middle = 0.5 * (low.0 + high.0);
        let middle = (middle, of(middle));
        if (low.1 - middle.1).abs() > (middle.1 - high.1).abs() {
            high = middle;
        } else {
            low = middle;
        }
    }
    (low.1 - high.1).abs() <= (0.1 * whole).max(0.002 * scale_n)
}

/// Random muscles over pressures and contractions beyond the free one, by finite elements: the median
/// falls with contraction and rises with pressure, taking up slack never adds to it, and the interval
/// holds it, does not jump, and reaches above zero wherever a twentieth of the muscles that the prior
/// draws pull.
#[test]
fn identity_over_the_free_contraction_median_and_interval_are_those_of_one_muscle() {
    const STEPS: u32 = 12;
    for index in 0..rounds(5) as u64 {
        let m = random(index);
        let model = Axisymmetric::between_ends(&m).unwrap();
        let w = &mut Workspace::new();
        let mut below: Vec<f64> = vec![];
        for p in [0.03, 0.1, 0.25, 0.4] {
            let place = |i: u32| m.max_ideal_contraction() * f64::from(i) / f64::from(STEPS);
            let of = |e: f64| built(&model, &mut Workspace::new(), p, e).unwrap();
            if built(&model, w, p, 0.0).is_none() {
                continue;
            }
            let blocked_n = of(0.0).mean_n;
            let list: Vec<Built> = (0..STEPS).map(|i| of(place(i))).collect();
            for (i, b) in list.iter().enumerate() {
                let what = format!("{index} {p} {i} {b:?}");
                assert!(b.predicted_shift_n.take_up <= 0.0, "{what}");
                assert!(b.predicted_low_n <= b.predicted_n, "{what}");
                assert!(b.predicted_n <= b.predicted_high_n, "{what}");
                let e = place(i as u32);
                let pulling = draws(&m, p, e, 200).iter().filter(|n| **n > 0.0).count();
                assert!(pulling < 10 || b.predicted_high_n > 0.0, "{pulling} {what}");
            }
            for (i, two) in list.windows(2).enumerate() {
                let what = format!("{index} {p} {i} {two:?}");
                assert!(two[1].predicted_n <= two[0].predicted_n + 1e-9, "{what}");
                let (from, to) = (place(i as u32), place(i as u32 + 1));
                assert!(
                    is_continuous(|e| of(e).predicted_high_n, from, to, blocked_n)
                        && is_continuous(|e| of(e).predicted_low_n, from, to, blocked_n),
                    "{what}"
                );
            }
            let medians: Vec<f64> = list.iter().map(|b| b.predicted_n).collect();
            let rises = below.iter().zip(&medians).all(|(low, high)| low <= high);
            assert!(rises, "{index} {p} {below:?} {medians:?}");
            below = medians;
        }
    }
}

/// A free contraction has an interval about its median, wherever the muscle has a median at all.
#[test]
fn identity_a_free_contraction_has_an_interval() {
    // A thin one of bought silicone tube: measured 18.5 % at 0.3 MPa (Hoshiramu_robot, commit
    // 1664f5db), which lies inside.
    let thin = "[tube]\nouter_diameter = '4 mm'\nwall_thickness = '0.75 mm'\nlength = '168 mm'\n\
        rubber = 'silicone-hose'\n[braid]\nname = 's-muscle-40'\n";
    let thin = std::iter::once(parse_muscle(thin).unwrap());
    for (index, m) in thin.chain((0..rounds(20) as u64).map(random)).enumerate() {
        let model = Axisymmetric::between_ends(&m).unwrap();
        let w = &mut Workspace::new();
        for p in [0.02, 0.05, 0.1, 0.15, 0.3, 0.4] {
            let options = Options {
                extrapolate: true,
                ..Options::from(Direction::Contraction)
            };
            let mut evaluation = Evaluation::new(&model, w, options);
            let free = evaluation.contraction(0.0, p).unwrap();
            if free.built.is_none() {
                continue;
            }
            let [low, median, high] = [free.predicted_low, free.predicted, free.predicted_high]
                .map(|place| place.unwrap_or_else(|| panic!("{index} {p} {free:?}")));
            assert!(low < median && median < high, "{index} {p} {free:?}");
            assert!(median < free.response.contraction, "{index} {p} {free:?}");
            let measured = 0.185;
            assert!(index > 0 || p != 0.3 || (low < measured && measured < high));
        }
    }
}
