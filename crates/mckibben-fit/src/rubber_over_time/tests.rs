//! Against closed forms: a bar, a held stretch, a closed cycle, small oscillations; and known
//! constants that come back.

use super::*;
use crate::rubber::Form;
use mckibben_core::rubber::{
    Gent, Law, NeoHookean, Ogden, RubberLaw, Yeoh,
    over_time::{Branch, Held, OgdenRoxburgh, Prony, Softened, erf},
};
use mckibben_io::table::Columns;

const SOFTENING: OgdenRoxburgh = OgdenRoxburgh {
    r: 1.6,
    m_mpa: 0.05,
    beta: 0.15,
};

fn yeoh() -> Law {
    Law::Yeoh(Yeoh {
        c10_mpa: 0.18,
        c20_mpa: -0.002,
        c30_mpa: 1e-4,
    })
}

fn energy(law: &Law, stretch: f64) -> f64 {
    let across = stretch.powf(-0.5);
    law.principal([stretch, across, across]).w
}

fn series() -> Prony {
    let branch = |share, time_constant_s| Branch {
        share,
        time_constant_s,
    };
    Prony {
        branches: vec![branch(0.2, 2.0), branch(0.15, 60.0)],
    }
}

/// R. W. Ogden, D. G. Roxburgh (1999): a bar bears η times the stress of its first loading, η as
/// defined there (β = 0), to rounding; at W_m itself and beyond η = 1, and at rest the modulus is η
/// times as large.
#[test]
fn a_bar_bears_eta_times_the_stress_of_the_first_loading() {
    let law = yeoh();
    let softening = OgdenRoxburgh {
        r: 1.25,
        m_mpa: 0.965,
        beta: 0.0,
    };
    let w_max = energy(&law, 3.0);
    let soft = Softened {
        law: &law,
        softening,
        w_max_mpa: w_max,
    };
    for stretch in [1.1, 1.8, 2.6] {
        let eta = 1.0 - erf((w_max - energy(&law, stretch)) / 0.965) / 1.25;
        assert!(
            (soft.uniaxial_stress_mpa(stretch) / law.uniaxial_stress_mpa(stretch) - eta).abs()
                < 1e-12
        );
    }
    for stretch in [3.0, 3.3] {
        let a = soft.uniaxial_stress_mpa(stretch);
        let b = law.uniaxial_stress_mpa(stretch);
        assert!((a / b - 1.0).abs() < 1e-12);
    }
    let eta = 1.0 - erf(w_max / 0.965) / 1.25;
    assert!((soft.shear_modulus_mpa() - eta * law.shear_modulus_mpa()).abs() < 1e-15);
}

/// The area of a loop in stress and stretch, by Simpson's rule of the bar's answers, is ∫(1 − η)
/// dW0 in closed form, to 1e-8.
#[test]
fn a_closed_cycle_loses_the_integral_of_one_minus_eta() {
    let none = Prony::default();
    for law in [
        yeoh(),
        Law::Gent(Gent {
            mu_mpa: 0.3,
            jm: 40.0,
        }),
    ] {
        let mut bar = Bar::new(&law, Some(SOFTENING), &none);
        let steps = 4000;
        let top = 2.5;
        let way = |i: usize| 1.0 + (top - 1.0) * i as f64 / steps as f64;
        let simpson = |stress: &[f64]| {
            let weight = |i: usize| {
                if i == 0 || i == steps {
                    1.0
                } else {
                    2.0 + 2.0 * (i % 2) as f64
                }
            };
            stress
                .iter()
                .enumerate()
                .map(|(i, s)| weight(i) * s)
                .sum::<f64>()
                * (top - 1.0)
                / steps as f64
                / 3.0
        };
        let up: Vec<f64> = (0..=steps)
            .map(|i| bar.stress_at(i as f64, way(i)))
            .collect();
        let w_max = energy(&law, top);
        let down: Vec<f64> = (0..=steps)
            .map(|i| bar.stress_at((steps + i) as f64, way(steps - i)))
            .collect();
        let again: Vec<f64> = (0..=steps)
            .map(|i| bar.stress_at((2 * steps + i) as f64, way(i)))
            .collect();
        assert!((simpson(&up) - w_max).abs() < 1e-8);
        let lost = simpson(&up) - simpson(&down);
        assert!(
            (lost - (w_max - SOFTENING.energy_mpa(w_max, w_max))).abs() < 1e-8,
            "{lost}"
        );
        assert!(
            (simpson(&again) - simpson(&down)).abs() < 1e-12,
            "reloading goes back along the unloading"
        );
    }
}

/// Held at a stretch that came at once: S = S0 [1 − Σ g (1 − e^(−t/τ))], to rounding, at any
/// stretch and time.
#[test]
fn a_held_bar_relaxes_as_the_series_says() {
    let law = yeoh();
    let prony = series();
    for stretch in [0.7, 1.2, 2.5] {
        let mut bar = Bar::new(&law, None, &prony);
        let at_once = bar.stress_at(0.0, stretch);
        assert!((at_once / law.uniaxial_stress_mpa(stretch) - 1.0).abs() < 1e-13);
        for time in [0.1, 1.0, 30.0, 1e4] {
            let left = 1.0
                - 0.2 * (1.0 - (-time / 2.0_f64).exp())
                - 0.15 * (1.0 - (-time / 60.0_f64).exp());
            assert!(
                (bar.stress_at(time, stretch) / at_once - left).abs() < 1e-13,
                "{stretch} {time}"
            );
            assert!((prony.left_after(time) - left).abs() < 1e-14);
        }
        assert!((bar.stress_at(1e6, stretch) / at_once - 0.65).abs() < 1e-13);
    }
}

/// Small oscillations: work per cycle π E ε² Σ g ωτ/(1 + ω²τ²) (Ferry's loss modulus); half the
/// step, a quarter of the error.
#[test]
fn small_oscillations_lose_the_work_of_the_loss_modulus_with_second_order() {
    let law = Law::NeoHookean(NeoHookean { mu_mpa: 0.3 });
    let prony = series();
    let omega = 0.4_f64;
    let strain = 1e-5;
    let of_branch = |b: &Branch| {
        let x = omega * b.time_constant_s;
        b.share * x / (1.0 + x * x)
    };
    let loss: f64 = prony.branches.iter().map(of_branch).sum();
    let exact = std::f64::consts::PI * 0.9 * strain * strain * loss;
    let error = |steps: usize| {
        let mut bar = Bar::new(&law, None, &prony);
        let dt = std::f64::consts::TAU / omega / steps as f64;
        let mut work = 0.0;
        let mut before = (1.0, bar.stress_at(0.0, 1.0));
        // Long enough for the slowest branch to have forgotten the start.
        let cycles = 100;
        for i in 1..=cycles * steps {
            let stretch = 1.0 + strain * (omega * dt * i as f64).sin();
            let now = (stretch, bar.stress_at(dt * i as f64, stretch));
            if i > (cycles - 1) * steps {
                work += 0.5 * (now.1 + before.1) * (now.0 - before.0);
            }
            before = now;
        }
        (work / exact - 1.0).abs()
    };
    let coarse = error(40);
    let fine = error(80);
    assert!(
        fine < 5e-3 && (coarse / fine / 4.0 - 1.0).abs() < 0.1,
        "{coarse} {fine}"
    );
}

/// Up to 2.5, down, up to 3, down: all from known constants.
fn cycles(law: &Law, softening: Option<OgdenRoxburgh>, prony: &Prony, rate: f64) -> Vec<TimePoint> {
    let mut bar = Bar::new(law, softening, prony);
    let mut out = vec![];
    let mut time_s = 0.0;
    let legs = [
        (1.0, 1.8),
        (1.8, 1.0),
        (1.0, 2.5),
        (2.5, 1.2),
        (1.2, 2.5),
        (2.5, 1.0),
    ];
    for (from, to) in legs {
        for i in 0..40 {
            let stretch = from + (to - from) * f64::from(i) / 40.0;
            out.push(TimePoint {
                time_s,
                stretch,
                nominal_stress_mpa: bar.stress_at(time_s, stretch),
            });
            time_s += f64::abs(to - from) / 40.0 / rate;
        }
    }
    out
}

#[test]
fn known_softening_comes_back_from_its_cycles() {
    let law = yeoh();
    let history = cycles(&law, Some(SOFTENING), &Prony::default(), 0.01);
    let fit = fit_softening(&history, Form::parse("yeoh")[0]).unwrap();
    for (a, b) in fit.first_loading.values().iter().zip(law.values()) {
        assert!((a - b).abs() < 1e-5 * b.abs(), "{fit:?}");
    }
    let r = fit.r;
    let m_mpa = fit.m_mpa;
    let beta = fit.beta;
    assert!(
        (r - 1.6).abs() < 1e-3 && (m_mpa - 0.05).abs() < 1e-3 && (beta - 0.15).abs() < 3e-3,
        "{fit:?}"
    );
    assert!(fit.first_loading_rms_mpa < 1e-9 && fit.later_rms_mpa < 1e-6);
    // A first loading alone has no softening to be seen.
    let first = fit_softening(&history[..30], Form::parse("yeoh")[0]);
    assert!(matches!(first, Err(OverTimeFitError::Refused(_))));
}

#[test]
fn a_known_series_comes_back_from_cycles_and_a_hold() {
    let law = yeoh();
    let prony = series();
    let mut history = cycles(&law, None, &prony, 0.05);
    let mut bar = Bar::new(&law, None, &prony);
    for p in &history {
        bar.stress_at(p.time_s, p.stretch);
    }
    let end = history.last().unwrap().time_s;
    for i in 1..=80 {
        let time_s = end + 5.0 * f64::from(i);
        history.push(TimePoint {
            time_s,
            stretch: 2.0,
            nominal_stress_mpa: bar.stress_at(time_s, 2.0),
        });
    }
    let fit = fit_prony(&history, Form::parse("yeoh")[0], 2).unwrap();
    assert!(fit.rms_mpa < 1e-6 && fit.elastic_rms_mpa > 0.01, "{fit:?}");
    for (a, b) in fit.branches.iter().zip(&prony.branches) {
        assert!((a.share / b.share - 1.0).abs() < 1e-3, "{fit:?}");
        assert!(
            (a.time_constant_s / b.time_constant_s - 1.0).abs() < 1e-3,
            "{fit:?}"
        );
    }
    for (a, b) in fit.instantaneous.values().iter().zip(law.values()) {
        assert!((a - b).abs() < 1e-3 * b.abs(), "{fit:?}");
    }
    let ratio = fit.long_time.shear_modulus_mpa() / fit.instantaneous.shear_modulus_mpa();
    assert!((ratio - fit.prony().long_time()).abs() < 1e-12);
}

/// S. Lee's stepwise relaxation of HNBR50 (12 h): what one to three branches leave, in kPa, as
/// docs/rubber-modes.md prints it. A regression.
#[test]
fn branches_that_follow_hnbr50_leave_what_they_left() {
    let path = format!(
        "{}/../../data/hnbr50/stepwise_relaxation.csv",
        env!("CARGO_MANIFEST_DIR")
    );
    let history =
        read_history(&std::fs::read_to_string(path).unwrap(), &Columns::default()).unwrap();
    assert_eq!(history.len(), 434);
    for (branches, left) in [(1, 72.1), (2, 29.1), (3, 25.1)] {
        let fit = fit_prony(&history, Form::parse("yeoh")[0], branches).unwrap();
        let off = [1e3 * fit.rms_mpa - left, 1e3 * fit.elastic_rms_mpa - 155.5];
        assert!(off.iter().all(|off| off.abs() < 0.1), "{fit:?}");
    }
}

#[test]
fn constants_and_histories_that_make_no_sense_are_refused() {
    let bad = |s: OgdenRoxburgh| s.validated().unwrap_err().to_string();
    assert!(
        bad(OgdenRoxburgh {
            r: 0.8,
            ..SOFTENING
        })
        .contains("1 or above")
    );
    assert!(
        bad(OgdenRoxburgh {
            m_mpa: -0.1,
            ..SOFTENING
        })
        .contains("zero or above")
    );
    assert!(
        bad(OgdenRoxburgh {
            m_mpa: 0.0,
            beta: 0.0,
            ..SOFTENING
        })
        .contains("above zero")
    );
    let prony = |share, time_constant_s| Prony {
        branches: vec![
            Branch {
                share,
                time_constant_s
            };
            2
        ],
    };
    assert!(
        prony(0.6, 1.0)
            .validated()
            .unwrap_err()
            .to_string()
            .contains("below 1")
    );
    assert!(prony(-0.1, 1.0).validated().is_err() && prony(0.1, 0.0).validated().is_err());
    let point = |time_s, stretch| TimePoint {
        time_s,
        stretch,
        nominal_stress_mpa: 0.0,
    };
    let law = Law::Ogden(Ogden {
        terms: vec![(0.2, 2.0)],
    });
    let over = |history: &[TimePoint]| Bar::new(&law, None, &Prony::default()).over(history);
    let back = over(&[point(1.0, 1.0), point(0.5, 1.1)])
        .unwrap_err()
        .to_string();
    assert!(back.contains("times must increase"), "{back}");
    assert!(
        over(&[point(1.0, -1.0)])
            .unwrap_err()
            .to_string()
            .contains("above 0")
    );
    let rest = fit_prony(&[point(0.0, 1.0); 4], Form::parse("yeoh")[0], 1);
    assert!(matches!(rest, Err(OverTimeFitError::Refused(_))));
}

/// What is left of the moduli is left of every stress: energies of all laws are linear in their
/// moduli.
#[test]
fn a_held_law_has_what_is_left_of_every_stress() {
    let prony = series();
    for law in Law::examples() {
        for held in [Held::For(0.0), Held::For(20.0), Held::Long] {
            let left = prony.left(held);
            let later = prony.relaxed_law(&law, held);
            for stretch in [0.7, 1.2, 1.9] {
                let a = later.uniaxial_stress_mpa(stretch);
                let b = left * law.uniaxial_stress_mpa(stretch);
                assert!(
                    (a - b).abs() < 1e-13 * (1.0 + b.abs()),
                    "{} {held:?}",
                    law.name()
                );
            }
        }
    }
    assert!((prony.left(Held::Long) - 0.65).abs() < 1e-15);
}
