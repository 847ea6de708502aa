//! Rubber at another temperature than that of its constants.

use mckibben_core::{
    model::{ModelKind, Workspace},
    muscle::{Braid, BraidStiffness, Muscle, Rubber, Tube, measures::TEMPERATURE},
    rubber::{Law, MooneyRivlin, Yeoh, over_time::OgdenRoxburgh},
};

/// (80 + 273.15)/(23 + 273.15), by hand.
const FACTOR: f64 = 353.15 / 296.15;

fn muscle(law: &Law, moduli: f64, stiffness: f64) -> Muscle {
    let softening = Some(OgdenRoxburgh {
        r: 2.0,
        m_mpa: moduli * 0.05,
        beta: 0.1,
    });
    let tube = Tube {
        rubber: Rubber {
            softening,
            ..Rubber::new(law.scaled(moduli))
        },
        ..Tube::prototype()
    };
    let braid = Braid {
        stiffness: BraidStiffness::NewtonPerMm(300.0 * stiffness),
        ..Braid::paper()
    };
    Muscle::prototype()
        .with_tube(tube)
        .and_then(|m| m.with_braid(braid))
        .unwrap()
}

fn laws() -> [Law; 2] {
    [
        Law::MooneyRivlin(MooneyRivlin {
            c10_mpa: 0.12,
            c01_mpa: 0.02,
        }),
        Law::Yeoh(Yeoh {
            c10_mpa: 0.15,
            c20_mpa: -0.002,
            c30_mpa: 0.001,
        }),
    ]
}

/// Identity of every model: a muscle at a temperature is the one with moduli in proportion to the
/// absolute temperature; at 23 °C it is the muscle itself, bit by bit.
#[test]
fn warm_rubber_has_moduli_in_proportion_to_the_absolute_temperature() {
    let mut count = 0;
    for law in laws() {
        let cold = muscle(&law, 1.0, 1.0);
        let warm = cold.with(&TEMPERATURE, 80.0).unwrap();
        let stiffer = muscle(&law, FACTOR, 1.0);
        assert!((warm.rubber().softening.unwrap().m_mpa / (FACTOR * 0.05) - 1.0).abs() < 1e-14);
        let same = cold.with(&TEMPERATURE, Rubber::OF_CONSTANTS_DEGC).unwrap();
        for kind in ModelKind::ALL {
            let pull = |m: &Muscle, p: f64| {
                kind.build(m)
                    .ok()?
                    .force_n(&mut Workspace::new(), p, 0.06)
                    .ok()
            };
            let (Some(warm), Some(wanted)) = (pull(&warm, 0.2), pull(&stiffer, 0.2)) else {
                continue;
            };
            assert!(
                (warm / wanted - 1.0).abs() < 1e-12,
                "{}: {warm} {wanted}",
                kind.name()
            );
            assert_eq!(pull(&same, 0.2), pull(&cold, 0.2), "{}", kind.name());
            count += 1;
        }
    }
    assert_eq!(count, 12);
}

/// Identity, by dimensions: F(k P, k µ, k times the strands' stiffness) = k F.
#[test]
fn pressure_and_all_stiffnesses_in_proportion_give_a_pull_in_proportion() {
    for law in laws() {
        let (plain, scaled) = (muscle(&law, 1.0, 1.0), muscle(&law, 1.0, FACTOR));
        let warm = scaled.with(&TEMPERATURE, 80.0).unwrap();
        for kind in [ModelKind::ThickWall, ModelKind::Universal] {
            for e in [0.0, 0.05, 0.15] {
                let pull = |m: &Muscle, p: f64| {
                    kind.build(m)
                        .unwrap()
                        .force_n(&mut Workspace::new(), p, e)
                        .unwrap()
                };
                let (once, more) = (pull(&plain, 0.2), pull(&warm, FACTOR * 0.2));
                assert!(
                    (more / (FACTOR * once) - 1.0).abs() < 1e-9,
                    "{}: {more} {once}",
                    kind.name()
                );
            }
        }
    }
}

/// What was identified holds for the muscle as it was: one at another temperature is another
/// muscle. The constants that it states stay.
#[test]
fn a_temperature_makes_another_muscle_with_a_warning() {
    let cold = Muscle::prototype();
    let warm = cold.with(&TEMPERATURE, 60.0).unwrap();
    assert_ne!(warm.digest(), cold.digest());
    assert_eq!(warm.tube().rubber, cold.tube().rubber);
    assert!(
        warm.warnings().iter().any(|w| w.contains("times 1.125")),
        "{:?}",
        warm.warnings()
    );
    assert!(cold.warnings().iter().all(|w| !w.contains("temperature")));
    for degc in [-30.0, 130.0] {
        let error = cold.with(&TEMPERATURE, degc).unwrap_err().to_string();
        assert!(
            error.contains("tube.temperature") && error.contains("120"),
            "{error}"
        );
    }
}
