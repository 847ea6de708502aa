//! What the prior of a modulus covers of a rubber that is known from one axis.

use mckibben_core::{
    built::{Experience, HALF_95},
    model::{ForceModel, ThickWall, Workspace},
    muscle::{Braid, Muscle, Rubber, Tube},
    rubber::Law,
};
use mckibben_fit::rubber::{FitSettings, Mode, fit_tension, read_tension};

/// Six rubbers measured in several modes: the law recommended from their uniaxial test, against the
/// one from all tests. The pull with the latter lies within what the prior of the modulus makes of
/// the former;
/// pressures of 1 to 4 bar, contractions up to 25 %, two muscles.
#[test]
fn the_share_for_one_axis_holds_every_pull_of_six_rubbers_measured_in_several() {
    let w = &mut Workspace::new();
    for file in [
        "treloar/tension",
        "rubber_biaxial/kawabata_1981",
        "rubber_biaxial/jones_1975",
        "rubber_biaxial/james_1975",
        "rubber_biaxial/kawamura_2001",
        "rubber_biaxial/meunier_2008",
    ] {
        let path = format!("{}/../../data/{file}.csv", env!("CARGO_MANIFEST_DIR"));
        let points = read_tension(&std::fs::read_to_string(path).unwrap()).unwrap();
        let law = |fit_modes: Vec<Mode>| -> Law {
            let settings = FitSettings {
                fit_modes,
                ..FitSettings::default()
            };
            let fit = fit_tension(&points, &settings).unwrap();
            fit.laws[fit.recommended.unwrap()].law.clone()
        };
        let (one, all) = (law(vec![Mode::Uniaxial]), law(vec![]));
        let mut shares: Vec<f64> = vec![];
        for (wall, angle) in [(3.0, 28.0), (1.5, 22.0)] {
            let muscle = |law: &Law| {
                let rubber = Rubber::new(law.clone());
                let tube = Tube {
                    rubber,
                    wall_mm: wall,
                    ..Muscle::prototype().tube().clone()
                };
                let muscle = Muscle::prototype().with_tube(tube).unwrap();
                let braid = Braid {
                    angle_deg: angle,
                    ..muscle.braid().clone()
                };
                muscle.with_braid(braid).unwrap()
            };
            let laws = [one.clone(), all.clone(), one.scaled(1.01)].map(|l| muscle(&l));
            for i in 1..=4 {
                for k in 0..=5 {
                    let (p, e) = (0.1 * f64::from(i), 0.05 * f64::from(k));
                    let mut pull = |m: &Muscle| ThickWall::between_ends(m).force_n(w, p, e).ok();
                    let [Some(a), Some(b), Some(c)] =
                        [pull(&laws[0]), pull(&laws[1]), pull(&laws[2])]
                    else {
                        continue;
                    };
                    shares.push(0.01 * (b - a) / (c - a));
                }
            }
        }
        // What the prior says of the modulus of a measured rubber, as a share of it.
        let half = HALF_95 * Experience::built_in().modulus.deviation;
        let within = shares.iter().filter(|s| s.abs() <= half).count() as f64 / shares.len() as f64;
        shares.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        let at = |q: f64| shares[(q * (shares.len() - 1) as f64) as usize].abs();
        assert!(
            within == 1.0,
            "{file}, {} against {}: {within}, {}",
            one.name(),
            all.name(),
            at(1.0)
        );
    }
}
