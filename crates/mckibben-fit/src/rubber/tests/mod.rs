use super::*;
use crate::least_squares::Noise;
use mckibben_core::{
    cancel::{Cancel, Cancelled},
    rubber::{Gent, Law, MooneyRivlin, NeoHookean, Ogden, RubberLaw, Yeoh},
};

mod literature;
mod reading;
mod sheets;

/// Points of a law in the given modes, stretches from `low` to `high`, each stress changed by
/// `error`.
fn points(
    law: &Law,
    modes: &[Mode],
    (low, high): (f64, f64),
    count: usize,
    mut error: impl FnMut(f64) -> f64,
) -> Vec<TensionPoint> {
    let mut out = vec![];
    for &mode in modes {
        for i in 0..count {
            let stretch = low + (high - low) * i as f64 / (count - 1) as f64;
            let exact = mode.nominal_stress_mpa(law, stretch).unwrap();
            out.push(TensionPoint::new(mode, stretch, exact + error(exact)));
        }
    }
    out
}

fn named(name: &str) -> Form {
    Form::parse(name)[0]
}

fn only(form: Form) -> FitSettings {
    FitSettings {
        forms: vec![form],
        up_to_stretch: None,
        ..FitSettings::default()
    }
}

/// neo-Hookean and Mooney–Rivlin, fitted up to a stretch.
fn one_or_two_constants(stretch: f64) -> FitSettings {
    FitSettings {
        up_to_stretch: Some(stretch),
        forms: vec![named("neo-hookean"), named("mooney-rivlin")],
        ..FitSettings::default()
    }
}

fn shipped(name: &str) -> Vec<TensionPoint> {
    let path = format!("{}/../../data/{name}", env!("CARGO_MANIFEST_DIR"));
    read_tension(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// Rivlin's closed forms as columns, the two normal equations by Cramer's rule, and s² (AᵀA)⁻¹.
#[test]
fn mooney_rivlin_is_the_solution_of_its_normal_equations() {
    let law = Law::MooneyRivlin(MooneyRivlin {
        c10_mpa: 0.15,
        c01_mpa: 0.03,
    });
    let mut noise = Noise(3);
    let data = points(&law, &Mode::OF_ONE_STRETCH, (1.0, 3.0), 12, |_| {
        0.01 * noise.next()
    });
    let mut n = [[0.0; 2]; 2];
    let mut d = [0.0; 2];
    let row = |p: &TensionPoint| {
        let l = p.stretch;
        match p.mode {
            Mode::Uniaxial => [2.0 * (l - l.powi(-2)), 2.0 * (l - l.powi(-2)) / l],
            Mode::Planar => [2.0 * (l - l.powi(-3)); 2],
            Mode::Equibiaxial => [2.0 * (l - l.powi(-5)), 2.0 * (l - l.powi(-5)) * l * l],
            Mode::General => unreachable!(),
        }
    };
    for p in &data {
        let a = row(p);
        for i in 0..2 {
            d[i] += a[i] * p.nominal_stress_mpa;
            for k in 0..2 {
                n[i][k] += a[i] * a[k];
            }
        }
    }
    let det = n[0][0] * n[1][1] - n[0][1] * n[1][0];
    let c = [
        (d[0] * n[1][1] - d[1] * n[0][1]) / det,
        (d[1] * n[0][0] - d[0] * n[1][0]) / det,
    ];
    let left: f64 = data
        .iter()
        .map(|p| (row(p)[0] * c[0] + row(p)[1] * c[1] - p.nominal_stress_mpa).powi(2))
        .sum();
    let s = (left / (data.len() - 2) as f64).sqrt();
    let errors = [s * (n[1][1] / det).sqrt(), s * (n[0][0] / det).sqrt()];
    let fit = fit_tension(&data, &only(named("mooney-rivlin"))).unwrap();
    for (i, p) in fit.laws[0].parameters.iter().enumerate() {
        assert!((p.value / c[i] - 1.0).abs() < 1e-9, "{p:?} {c:?}");
        assert!(
            (p.standard_error.unwrap() / errors[i] - 1.0).abs() < 1e-6,
            "{p:?} {errors:?}"
        );
        assert!(p.identifiable);
    }
    assert!((fit.laws[0].quality.rms_mpa - (left / data.len() as f64).sqrt()).abs() < 1e-12);
}

/// Laws whose constants one mode tells.
fn laws() -> [(Form, Law); 6] {
    [
        (
            named("neo-hookean"),
            Law::NeoHookean(NeoHookean { mu_mpa: 0.3 }),
        ),
        (
            named("mooney-rivlin"),
            Law::MooneyRivlin(MooneyRivlin {
                c10_mpa: 0.12,
                c01_mpa: 0.02,
            }),
        ),
        (
            named("yeoh"),
            Law::Yeoh(Yeoh {
                c10_mpa: 0.18,
                c20_mpa: -0.001,
                c30_mpa: 4e-5,
            }),
        ),
        (
            named("gent"),
            Law::Gent(Gent {
                mu_mpa: 0.27,
                jm: 40.0,
            }),
        ),
        (
            named("ogden-1"),
            Law::Ogden(Ogden {
                terms: vec![(0.2, 2.6)],
            }),
        ),
        (
            named("ogden-2"),
            Law::Ogden(Ogden {
                terms: vec![(0.4, 1.4), (0.003, 5.2)],
            }),
        ),
    ]
}

/// The points of a law give its constants back, in each mode alone and in all.
#[test]
fn every_law_comes_back_from_its_points_in_every_mode() {
    let sets: [&[Mode]; 4] = [
        &[Mode::Uniaxial],
        &[Mode::Planar],
        &[Mode::Equibiaxial],
        &Mode::OF_ONE_STRETCH,
    ];
    for (form, law) in laws() {
        for modes in sets {
            let data = points(&law, modes, (0.8, 4.5), 30, |_| 0.0);
            let fit = fit_tension(&data, &only(form)).unwrap();
            // In planar tension I1 = I2: only the sum of C10 and C01 is identifiable.
            if form == named("mooney-rivlin") && modes == [Mode::Planar] {
                let fitted = &fit.laws[0];
                assert!((fitted.law.shear_modulus_mpa() - law.shear_modulus_mpa()).abs() < 1e-8);
                assert!(
                    fitted
                        .parameters
                        .iter()
                        .all(|p| !p.identifiable && p.standard_error.is_none())
                );
                continue;
            }
            let got = fit.laws[0].law.values();
            for (a, b) in got.iter().zip(law.values()) {
                assert!(
                    (a - b).abs() < 1e-4 * b.abs(),
                    "{form:?} {modes:?}: {got:?}"
                );
            }
            assert!(
                fit.laws[0].quality.r_squared > 1.0 - 1e-9,
                "{form:?} {modes:?}"
            );
        }
    }
}

/// Three terms have more constants than even exact points tell one by one; the stresses come back.
#[test]
fn ogdens_1972_law_comes_back_as_stresses() {
    let law = Law::Ogden(Ogden {
        terms: vec![(0.6178, 1.3), (0.001177, 5.0), (-0.009807, -2.0)],
    });
    let data = points(&law, &Mode::OF_ONE_STRETCH, (1.05, 4.5), 30, |_| 0.0);
    let fit = fit_tension(&data, &only(named("ogden-3"))).unwrap();
    assert!(fit.laws[0].quality.relative_rms < 1e-4, "{:?}", fit.laws[0]);
}

/// Of many noisy repeats 95 % hold the true constant in their 95 % interval: 800 intervals,
/// binomial standard deviation 0.77 %, three of which are allowed.
#[test]
fn intervals_hold_the_true_constants_as_often_as_they_say() {
    let law = Law::MooneyRivlin(MooneyRivlin {
        c10_mpa: 0.12,
        c01_mpa: 0.02,
    });
    let mut held = 0;
    let mut all = 0;
    let mut noise = Noise(11);
    for _ in 0..400 {
        let data = points(&law, &Mode::OF_ONE_STRETCH, (1.1, 3.0), 6, |_| {
            0.02 * noise.next()
        });
        let fit = fit_tension(&data, &only(named("mooney-rivlin"))).unwrap();
        for (p, truth) in fit.laws[0].parameters.iter().zip([0.12, 0.02]) {
            let half = crate::least_squares::t95(16) * p.standard_error.unwrap();
            held += usize::from((p.value - truth).abs() < half);
            all += 1;
        }
    }
    let share = f64::from(held as u32) / f64::from(all);
    assert!((share - 0.95).abs() < 3.0 * 0.0077, "{share}");
}

/// One axis, stiffening late: the free C01 is negative; held, it is 0 and the law is the
/// neo-Hookean one.
#[test]
fn a_negative_c01_is_warned_of_and_the_neighbour_offered() {
    let fit = fit_tension(
        &shipped("silicones/dragon_skin_30.csv"),
        &one_or_two_constants(3.0),
    )
    .unwrap();
    let mooney = |constrained: bool| {
        fit.laws
            .iter()
            .find(|l| l.form == named("mooney-rivlin") && l.constrained == constrained)
            .unwrap()
    };
    let neo = fit
        .laws
        .iter()
        .find(|l| l.form == named("neo-hookean"))
        .unwrap();
    let free = mooney(false);
    let held = mooney(true);
    assert!(free.parameters[1].value < 0.0 && !free.quality.stable);
    assert!(fit.warnings.iter().any(|w| w.contains("a negative C01")));
    assert!(
        fit.warnings
            .iter()
            .any(|w| w.starts_with("uniaxial tests alone"))
    );
    assert!(held.quality.stable && held.parameters[1].value.abs() < 1e-12);
    assert_eq!(held.parameters[1].standard_error, Some(0.0));
    assert!(!held.parameters[1].identifiable);
    assert!((2.0 * held.parameters[0].value / neo.parameters[0].value - 1.0).abs() < 1e-9);
    assert!(held.quality.r_squared < free.quality.r_squared);
    assert_eq!(held.quality.free_r_squared, Some(free.quality.r_squared));
    assert!((held.quality.r_squared - neo.quality.r_squared).abs() < 1e-9);
}

/// The stable neighbour is stable, worse than the free fit, and at the edge: a law a little nearer
/// to the free one is not stable any more (the set is convex, so that the straight way between the
/// two leaves it once).
#[test]
fn the_stable_yeoh_lies_on_the_edge_of_stability() {
    let softens = Law::Yeoh(Yeoh {
        c10_mpa: 0.2,
        c20_mpa: -0.03,
        c30_mpa: 0.001,
    });
    let mut noise = Noise(5);
    let data = points(&softens, &[Mode::Uniaxial], (1.0, 2.6), 40, |_| {
        0.001 * noise.next()
    });
    let fit = fit_tension(&data, &only(named("yeoh"))).unwrap();
    let free = &fit.laws[0];
    let held = &fit.laws[1];
    assert!(!free.quality.stable && !free.constrained && held.constrained && held.quality.stable);
    assert!(held.quality.rms_mpa > free.quality.rms_mpa);
    let towards = |t: f64| {
        let a = held.law.values();
        let b = free.law.values();
        held.law.with_constants(|i, _| a[i] + t * (b[i] - a[i]))
    };
    let hoop = FitSettings::default().hoop_stretch;
    assert_eq!(
        mckibben_core::rubber::muscle_unstable_from(&towards(0.0), hoop),
        None
    );
    assert_ne!(
        mckibben_core::rubber::muscle_unstable_from(&towards(0.05), hoop),
        None
    );
    let alone = fit_tension(
        &data,
        &FitSettings {
            stable: true,
            ..only(named("yeoh"))
        },
    )
    .unwrap();
    assert_eq!(alone.laws, vec![held.clone()]);
}

/// Gent's chains lock inside of a muscle's stretches; held, they do so behind them.
#[test]
fn a_gent_law_that_locks_too_early_is_held_behind_the_muscle() {
    let law = Law::Gent(Gent {
        mu_mpa: 0.2,
        jm: 4.0,
    });
    let data = points(&law, &[Mode::Uniaxial], (1.0, 2.3), 20, |_| 0.0);
    let fit = fit_tension(&data, &only(named("gent"))).unwrap();
    let free = &fit.laws[0];
    let held = &fit.laws[1];
    assert!((free.parameters[1].value - 4.0).abs() < 1e-3);
    assert!(!free.quality.stable && held.quality.stable);
    assert!(fit.warnings.iter().any(|w| w.contains("locks at I1")));
}

#[test]
fn data_without_stiffening_do_not_tell_gents_limit() {
    let law = Law::NeoHookean(NeoHookean { mu_mpa: 0.2 });
    let mut noise = Noise(7);
    let data = points(&law, &[Mode::Uniaxial], (1.0, 2.0), 20, |_| {
        0.002 * noise.next()
    });
    let fit = fit_tension(&data, &only(named("gent"))).unwrap();
    assert!(!fit.laws[0].parameters[1].identifiable, "{:?}", fit.laws[0]);
    let text = fit
        .warnings
        .iter()
        .map(ToString::to_string)
        .collect::<Vec<_>>()
        .join("\n");
    assert!(
        text.contains("do not determine jm") && text.contains("end at a stretch of 2.00"),
        "{text}"
    );
}

/// A balanced fit is that of points repeated until every mode has as many.
#[test]
fn balance_is_repetition() {
    let law = Law::MooneyRivlin(MooneyRivlin {
        c10_mpa: 0.15,
        c01_mpa: 0.01,
    });
    let mut noise = Noise(9);
    let many = points(&law, &[Mode::Uniaxial], (1.1, 3.0), 24, |_| {
        0.01 * noise.next()
    });
    let few = points(&law, &[Mode::Equibiaxial], (1.1, 2.0), 8, |_| {
        0.01 * noise.next()
    });
    let both = [&many[..], &few[..]].concat();
    let repeated = [&many[..], &few[..], &few[..], &few[..]].concat();
    let balanced = FitSettings {
        balance: true,
        ..only(named("mooney-rivlin"))
    };
    let weighted = FitSettings {
        mode_weights: vec![(Mode::Equibiaxial, 3.0)],
        ..only(named("mooney-rivlin"))
    };
    let law_of =
        |data: &[TensionPoint], s: &FitSettings| fit_tension(data, s).unwrap().laws[0].law.values();
    let reference = law_of(&repeated, &only(named("mooney-rivlin")));
    for constants in [law_of(&both, &balanced), law_of(&both, &weighted)] {
        for (a, b) in constants.iter().zip(&reference) {
            assert!((a / b - 1.0).abs() < 1e-9, "{constants:?} {reference:?}");
        }
    }
}

#[test]
fn fits_that_make_no_sense_are_refused() {
    let law = Law::NeoHookean(NeoHookean { mu_mpa: 0.2 });
    let data = points(&law, &[Mode::Uniaxial], (1.0, 2.0), 3, |_| 0.0);
    use TensionFitError::{NoBetter, Refused, TooFew};
    let error = |data: &[TensionPoint], s: &FitSettings| fit_tension(data, s).unwrap_err();
    let few = error(&data, &only(named("yeoh")));
    assert!(
        matches!(&few, TooFew { points: 3, law, fewest: 6 } if law == "yeoh"),
        "{few}"
    );
    // All that 3 points determine.
    assert_eq!(
        fit_tension(&data, &FitSettings::default())
            .unwrap()
            .laws
            .len(),
        1
    );
    let none = error(&[], &FitSettings::default());
    assert!(matches!(none, TooFew { points: 0, .. }), "{none}");
    let pushed: Vec<_> = data
        .iter()
        .map(|p| TensionPoint {
            nominal_stress_mpa: -p.nominal_stress_mpa,
            ..*p
        })
        .collect();
    let defaults = FitSettings::default;
    let settings = [
        FitSettings {
            up_to_stretch: Some(0.5),
            ..defaults()
        },
        FitSettings {
            hoop_stretch: f64::NAN,
            ..defaults()
        },
        FitSettings {
            mode_weights: vec![(Mode::Uniaxial, -1.0)],
            ..defaults()
        },
    ];
    let bad = settings.iter().map(|settings| error(&data, settings));
    for error in bad.chain([error(&pushed, &defaults())]) {
        assert!(matches!(error, Refused(_)), "{error}");
    }
    // One term made these points: a second one has nothing to do.
    let one = Law::Ogden(Ogden {
        terms: vec![(0.2, 2.6)],
    });
    let exact = points(&one, &Mode::OF_ONE_STRETCH, (1.0, 3.0), 9, |_| 0.0);
    let error = error(&exact, &only(named("ogden-2")));
    assert!(matches!(error, NoBetter(_)), "{error}");
    // All stretches the same: one number for three constants.
    let same = vec![data[2]; 12];
    let fit = fit_tension(&same, &FitSettings::default()).unwrap();
    for law in &fit.laws {
        let mut numbers = law
            .parameters
            .iter()
            .map(|p| p.value)
            .chain([law.quality.aicc]);
        assert!(numbers.all(f64::is_finite), "{law:?}");
    }
}

#[test]
fn a_modulus_that_no_rubber_has_is_warned_of() {
    let law = Law::NeoHookean(NeoHookean { mu_mpa: 300.0 });
    let data = points(&law, &[Mode::Uniaxial], (1.0, 2.0), 9, |_| 0.0);
    let fit = fit_tension(&data, &FitSettings::default()).unwrap();
    assert!(
        fit.warnings[0].to_string().contains("in kPa or psi"),
        "{:?}",
        fit.warnings
    );
}

/// A cancelled fit is no answer, and does not go on.
#[test]
fn a_fit_ends_when_its_caller_does() {
    let law = Law::Yeoh(Yeoh {
        c10_mpa: 0.1,
        c20_mpa: 0.01,
        c30_mpa: 0.001,
    });
    let data = points(&law, &[Mode::Uniaxial], (1.0, 3.0), 2000, |_| 0.0);
    let cancel = Cancel::default();
    cancel.cancel();
    let _entered = cancel.enter();
    let error = fit_tension_with(&data, &FitSettings::default(), &Silent).unwrap_err();
    assert_eq!(error, TensionFitError::Cancelled(Cancelled));
}
