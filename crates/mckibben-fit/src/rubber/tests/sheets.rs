//! Specimens that are stretched along two axes, and tests that are held out.

use super::{reading::read, *};

/// All states of a square of stretches, two stresses each; every third one as a difference of true
/// stresses.
fn sheets(law: &Law) -> Vec<TensionPoint> {
    let mut out = vec![];
    for i in 0..6 {
        for k in 0..6 {
            let a = 0.8 + 0.4 * f64::from(i);
            let b = 0.8 + 0.4 * f64::from(k);
            let stress = |p: TensionPoint| TensionPoint {
                nominal_stress_mpa: p.stress_mpa(law),
                ..p
            };
            if (i + k) % 3 == 0 {
                out.push(stress(TensionPoint::from_difference(a, b, 0.0)));
            } else {
                out.extend(
                    [
                        TensionPoint::general(a, b, 0.0),
                        TensionPoint::general(b, a, 0.0),
                    ]
                    .map(stress),
                );
            }
        }
    }
    out
}

/// R. S. Rivlin (1948): σ1 = 2 (λ1² − λ3²)(C1 + λ2² C2), and σ1 − σ2 = 2 (λ1² − λ2²)(C1 + λ3² C2).
#[test]
fn stresses_of_a_sheet_are_rivlins() {
    let c1 = 0.1;
    let c2 = 0.02;
    let l1 = 2.0_f64;
    let l2 = 1.5_f64;
    let law = Law::MooneyRivlin(MooneyRivlin {
        c10_mpa: c1,
        c01_mpa: c2,
    });
    let l3 = 1.0 / (l1 * l2);
    let true_1 = 2.0 * (l1 * l1 - l3 * l3) * (c1 + l2 * l2 * c2);
    let difference = 2.0 * (l1 * l1 - l2 * l2) * (c1 + l3 * l3 * c2);
    assert!((TensionPoint::general(l1, l2, 0.0).stress_mpa(&law) * l1 - true_1).abs() < 1e-14);
    let point = TensionPoint::from_difference(l1, l2, difference);
    assert!((point.stress_mpa(&law) - point.nominal_stress_mpa).abs() < 1e-14);
    let other = TensionPoint::from_difference(l2, l1, -difference);
    assert!((other.stress_mpa(&law) - other.nominal_stress_mpa).abs() < 1e-14);
}

/// A mode of one stretch is a sheet with its second stretch, for every law.
#[test]
fn the_three_modes_are_states_of_a_sheet() {
    for law in Law::examples() {
        for mode in Mode::OF_ONE_STRETCH {
            for stretch in [0.7, 1.3, 2.4] {
                let one = TensionPoint::new(mode, stretch, 0.0);
                let sheet = TensionPoint::general(stretch, one.across, 0.0);
                let a = one.stress_mpa(&law);
                let b = sheet.stress_mpa(&law);
                assert!(
                    (a - b).abs() < 1e-13 * (1.0 + a.abs()),
                    "{} {mode} {stretch}",
                    law.name()
                );
            }
        }
    }
}

#[test]
fn every_law_comes_back_from_its_sheets() {
    for (form, law) in laws() {
        for measure in [Measure::Absolute, Measure::Relative] {
            let settings = FitSettings {
                measure,
                ..only(form)
            };
            let fit = fit_tension(&sheets(&law), &settings).unwrap();
            for (a, b) in fit.laws[0].law.values().iter().zip(law.values()) {
                assert!(
                    (a - b).abs() < 1e-4 * b.abs(),
                    "{measure:?}: {:?}",
                    fit.laws[0].law
                );
            }
            assert_eq!(fit.laws[0].modes[0].mode, Mode::General);
        }
    }
}

#[test]
fn a_row_is_a_point_for_each_of_its_stresses() {
    let text = "mode,stretch_1,stretch_2,nominal_stress_1_mpa,nominal_stress_2_mpa,true_stress_difference_mpa\n\
                ,1.5,1.2,0.3,0.2,\ngeneral,1.5,2.0,,,-0.4\nuniaxial,2,,0.4,,\nplanar,2,1.0,0.5,0.3,\net,2,2.01,0.6,,\n";
    let points = read(text).unwrap();
    let expected = [
        TensionPoint::general(1.5, 1.2, 0.3),
        TensionPoint::general(1.2, 1.5, 0.2),
        TensionPoint::from_difference(1.5, 2.0, -0.4),
        TensionPoint::new(Mode::Uniaxial, 2.0, 0.4),
        TensionPoint::new(Mode::Planar, 2.0, 0.5),
        TensionPoint::general(1.0, 2.0, 0.3),
        TensionPoint::new(Mode::Equibiaxial, 2.0, 0.6),
    ];
    assert_eq!(points, expected);
    // A true stress is over the stretch along it; λ1 and λ2 are as good as words.
    let cauchy = read("λ1,λ2,true_stress_1_mpa,true_stress_2_mpa\n1.5,1.2,0.45,0.24\n").unwrap();
    for (p, q) in cauchy.iter().zip(&expected[..2]) {
        assert!(
            (p.nominal_stress_mpa - q.nominal_stress_mpa).abs() < 1e-15 && p.across == q.across
        );
    }
}

/// A law that is right in what it was fitted to is right in what was held out; measured stresses
/// 1.25 times as large there are followed with 1/1.25 − 1 = −20 %, whatever the mode.
#[test]
fn held_out_tests_say_by_which_factor_a_law_misses_them() {
    let law = Law::Yeoh(Yeoh {
        c10_mpa: 0.18,
        c20_mpa: -0.001,
        c30_mpa: 4e-5,
    });
    let uniaxial = points(&law, &[Mode::Uniaxial], (1.0, 2.5), 20, |_| 0.0);
    let stiffer = |p: &TensionPoint| TensionPoint {
        nominal_stress_mpa: 1.25 * p.nominal_stress_mpa,
        ..*p
    };
    let others = points(
        &law,
        &[Mode::Planar, Mode::Equibiaxial],
        (1.0, 2.5),
        20,
        |_| 0.0,
    );
    let sheets = sheets(&law);
    let others: Vec<TensionPoint> = others.iter().chain(&sheets).map(stiffer).collect();
    let settings = FitSettings {
        fit_modes: vec![Mode::Uniaxial],
        ..only(named("yeoh"))
    };
    let fit = fit_tension(&[&uniaxial[..], &others].concat(), &settings).unwrap();
    assert_eq!(
        (fit.points.len(), fit.held_out.len(), fit.left_out),
        (20, others.len(), 0)
    );
    let errors = &fit.laws[0].held_out;
    let modes: Vec<Option<Mode>> = errors.iter().map(|e| e.mode).collect();
    assert_eq!(
        modes,
        [
            Some(Mode::Planar),
            Some(Mode::Equibiaxial),
            Some(Mode::General),
            None
        ]
    );
    for e in errors {
        assert!(
            (e.stiffer + 0.2).abs() < 1e-6 && (e.errors.relative - 0.2).abs() < 1e-6,
            "{e:?}"
        );
    }
    // Equibiaxial tension beyond 1.29 is no state of a muscle: none of its stretches is an axial
    // one.
    assert!(errors[3].errors.points < others.len());
    assert!(!TensionPoint::new(Mode::Equibiaxial, 1.3, 0.0).is_of_a_muscle(3.0));
    assert!(TensionPoint::new(Mode::Planar, 2.9, 0.0).is_of_a_muscle(3.0));
}

/// The shipped sets are read as their README counts them.
#[test]
fn the_shipped_biaxial_sets_are_read() {
    for (name, counts) in [
        ("kawabata_1981", [19, 19, 17, 0]),
        ("jones_1975", [33, 0, 0, 167]),
        ("james_1975", [13, 0, 0, 152]),
        ("kawamura_2001", [17, 0, 10, 54]),
        ("meunier_2008", [17, 19, 14, 0]),
        ("kawamura_2001_compression", [16, 0, 0, 0]),
        ("meunier_2008_compression", [16, 0, 0, 0]),
    ] {
        let points = shipped(&format!("rubber_biaxial/{name}.csv"));
        let count = |mode: Mode| points.iter().filter(|p| p.mode == mode).count();
        assert_eq!(Mode::ALL.map(count), counts, "{name}");
    }
}
