//! Fits that others published.

use super::*;

fn constants(fit: &TensionFit, form: Form) -> Vec<f64> {
    let fitted = fit
        .laws
        .iter()
        .find(|l| l.form == form && !l.constrained)
        .unwrap();
    fitted.law.values()
}

/// X. Li, Y. Wei (2015), relative least squares of Treloar's three tests: neo-Hookean C10 0.1863;
/// Yeoh 0.1789, −0.001219, 3.678e-5, in MPa. Ours are 0.17885, −0.0012190, 3.6773e-5: one unit of
/// the last digit printed is allowed.
#[test]
fn treloars_rubber_gives_the_published_neo_hookean_and_yeoh() {
    let relative = FitSettings {
        measure: Measure::Relative,
        up_to_stretch: None,
        ..FitSettings::default()
    };
    let fit = fit_tension(&shipped("treloar/tension.csv"), &relative).unwrap();
    assert!((0.5 * constants(&fit, named("neo-hookean"))[0] - 0.1863).abs() < 5e-5);
    let yeoh = constants(&fit, named("yeoh"));
    assert!((yeoh[0] - 0.1789).abs() < 1e-4, "{yeoh:?}");
    assert!((yeoh[1] + 0.001219).abs() < 1e-6, "{yeoh:?}");
    assert!((yeoh[2] - 3.678e-5).abs() < 1e-8, "{yeoh:?}");
    // As data/treloar/README.md says, the published Mooney–Rivlin pair does not come out.
    let mooney = constants(&fit, named("mooney-rivlin"));
    assert!(
        (mooney[0] - 0.1788).abs() < 5e-5 && (mooney[1] - 0.0037).abs() < 5e-5,
        "{mooney:?}"
    );
}

/// R. W. Ogden (1972) fitted three terms to the same tests by eye: least squares must not do worse,
/// in either measure.
#[test]
fn three_terms_follow_treloars_rubber_at_least_as_well_as_those_of_ogden() {
    let data = shipped("treloar/tension.csv");
    let published = Law::Ogden(Ogden {
        terms: vec![(0.6178, 1.3), (0.001177, 5.0), (-0.009807, -2.0)],
    });
    for measure in [Measure::Absolute, Measure::Relative] {
        let settings = FitSettings {
            measure,
            ..only(named("ogden-3"))
        };
        let fit = fit_tension(&data, &settings).unwrap();
        let problem = Problem::new(data.clone(), measure, false, &[]);
        let ours = problem.squares(&fit.laws[0].law).unwrap();
        let his = problem.squares(&published).unwrap();
        assert!(
            ours <= his,
            "{measure:?}: {ours} against {his}, {:?}",
            fit.laws[0].law
        );
    }
}

/// L. Marechal et al. (2021), constants fitted up to 50, 100 and 200 % to the full curves. The
/// shipped ones are thinned, which moves the neo-Hookean constant by up to 1.3 %
/// (data/silicones/README.md); the Mooney–Rivlin constants stay within the 95 % intervals of the
/// thinned fit.
#[test]
fn silicones_give_the_published_constants() {
    let table = format!(
        "{}/../../data/silicones/uniaxial_fits.csv",
        env!("CARGO_MANIFEST_DIR")
    );
    let rows: Vec<_> = csv::Reader::from_path(table)
        .unwrap()
        .records()
        .map(|r| r.unwrap())
        .collect();
    let mut compared = 0;
    for (file, name) in [
        ("dragon_skin_30", "Dragon Skin 30"),
        ("ecoflex_00-50", "Ecoflex 00-50"),
        ("mold_star_20t", "Mold Star 20T"),
        ("rtv615", "RTV615"),
        ("soloplast_150318", "SOLOPLAST 150318"),
    ] {
        let data = shipped(&format!("silicones/{file}.csv"));
        for row in rows.iter().filter(|r| &r[0] == name) {
            let number = |i: usize| row[i].parse::<f64>().unwrap();
            let fit = fit_tension(&data, &one_or_two_constants(1.0 + number(1))).unwrap();
            let neo = 500.0 * constants(&fit, named("neo-hookean"))[0];
            assert!(
                (neo / number(7) - 1.0).abs() < 0.0135,
                "{name} to {}: {neo} kPa",
                number(1)
            );
            compared += 1;
            // Ecoflex up to 50 % has three points left, too few for two constants.
            let Some(mooney) = fit
                .laws
                .iter()
                .find(|l| l.form == named("mooney-rivlin") && !l.constrained)
            else {
                assert_eq!(
                    (name, number(1), fit.points.len()),
                    ("Ecoflex 00-50", 0.5, 3)
                );
                continue;
            };
            for (p, kpa) in mooney.parameters.iter().zip([number(3), number(4)]) {
                let half =
                    crate::least_squares::t95(fit.points.len() - 2) * p.standard_error.unwrap();
                let off = (p.value - 1e-3 * kpa).abs();
                assert!(
                    off < half,
                    "{name} to {}: {p:?} against {kpa} kPa",
                    number(1)
                );
            }
        }
    }
    assert_eq!(compared, 15);
}

/// Dragon Skin 10, pulled until it broke at 11.4: fitted by the stretches of a muscle, its modulus is
/// the 0.0432 MPa of the library's `dragon-skin-10-medium`, which fits another test of this rubber;
/// of all points it is 0.0919 MPa, 2.1 times too stiff.
#[test]
fn a_test_to_rupture_gives_the_modulus_of_a_muscle() {
    const STRAIN_AND_STRESS: [(f64, f64); 16] = [
        (0.045, 0.0020),
        (0.25, 0.0264),
        (0.5, 0.0530),
        (0.75, 0.0823),
        (1.0, 0.1130),
        (1.5, 0.1906),
        (2.0, 0.2728),
        (3.0, 0.4448),
        (4.0, 0.6325),
        (5.0, 0.8254),
        (6.0, 1.0173),
        (7.0, 1.2080),
        (8.0, 1.4004),
        (9.0, 1.5955),
        (10.0, 1.7668),
        (10.409, 1.8438),
    ];
    let points = STRAIN_AND_STRESS
        .map(|(strain, stress_mpa)| TensionPoint::new(Mode::Uniaxial, 1.0 + strain, stress_mpa));
    let modulus_mpa = |settings: &FitSettings| {
        let fit = fit_tension(&points, settings).unwrap();
        let law = &fit.laws[fit.recommended.unwrap()];
        assert!(law.quality.largest_relative > law.quality.relative_rms);
        (law.quality.shear_modulus_mpa, fit.beyond.len())
    };
    let (of_a_muscle, beyond) = modulus_mpa(&FitSettings::default());
    assert!((of_a_muscle / 0.0432 - 1.0).abs() < 0.01, "{of_a_muscle}");
    assert_eq!(beyond, 9);
    let all = modulus_mpa(&FitSettings {
        up_to_stretch: None,
        ..FitSettings::default()
    });
    assert!(all.0 > 2.0 * of_a_muscle && all.1 == 0, "{all:?}");
}
