//! What wears in a muscle: numbers by hand, and identities with the models.

use mckibben::analysis::burst::mesh::{CAP, bulge};
use mckibben::analysis::life::measured::lives;
use mckibben::analysis::life::{Wear, turning, wear};
use mckibben::model::{ForceModel, ModelKind, ThickWall, Workspace};
use mckibben::muscle::{Braid, BraidStiffness, Friction, Muscle, Rubber, Strands, Terminals, Tube};
use mckibben::rubber::{Law, NeoHookean};

/// D0 20 mm, s 2 mm, 25°, neo-Hookean rubber of 0.5 MPa.
fn muscle(braid: Braid, friction: Option<Friction>) -> Muscle {
    let tube = Tube::new(20.0, 2.0, 200.0, Rubber::of(Law::NeoHookean(NeoHookean { mu_mpa: 0.5 })));
    Muscle::new(tube, Braid { angle_deg: 25.0, ..braid }, Terminals::default(), friction).unwrap()
}

fn rigid() -> Braid {
    Braid { stiffness: BraidStiffness::Inextensible, strands: None, ..Braid::paper() }
}

/// 96 strands of 0.25 mm, four on a carrier.
fn woven() -> Braid {
    let area = std::f64::consts::PI * 0.25 * 0.25 / 4.0;
    let strands = Some(Strands { count: 96, section: Some((area, 8500.0)), strength_n: None });
    Braid { stiffness: BraidStiffness::OfStrands, strands, strands_per_carrier: Some(4.0), ..Braid::paper() }
}

fn of(m: &Muscle, p: f64, e: f64) -> Wear {
    wear(m, &ThickWall::new(m).response(&mut Workspace::new(), p, e).unwrap())
}

fn close(found: Option<f64>, expected: f64, share: f64) {
    let found = found.unwrap();
    assert!((found / expected - 1.0).abs() < share, "{found} {expected}");
}

/// Strands that keep their length, shortened by 15 %: ro = Ro √((1 − λ² cos²θ0)/sin²θ0) = 15.08707 mm, ri² = ro² − (Ro² − Ri²)/λ, λθ = ri/Ri =
/// 1.701409, w = μ/2 (λ² + λθ² + 1/(λλθ)² − 3).
#[test]
fn the_energy_of_a_neo_hookean_wall_by_hand() {
    let w = of(&muscle(rigid(), None), 0.3, 0.15);
    close(w.energy_density_mpa, 0.273_855_563_185, 1e-9);
    close(w.middle_stretch, 1.701_409_385_625_6, 1e-9);
    // sinθ = sinθ0 ro/Ro
    close(w.angle_deg, (1.508_707_230_101_8 * 25_f64.to_radians().sin()).asin().to_degrees(), 1e-9);
}

/// φ = 60°: λ = √(2/(1 + cosφ)) = 1.154701 at P = 2 μ (t/a) sinφ (1 − λ⁻⁶); g = 3.745417 mm and t = 2 mm at 25°, 5.100590 mm and 1.471316 mm at 40°.
#[test]
fn the_cap_between_strands_by_hand() {
    let m = muscle(woven(), None);
    for (angle, g, p) in [
        (25.0, 3.745_416_476_075_94, 0.534_702_551_516_97),
        (40.0, 5.100_589_827_247_94, 0.288_847_011_160_6),
    ] {
        let found = bulge(&m, f64::to_radians(angle), 1.0, p).unwrap();
        assert!((found.clear_distance_mm / g - 1.0).abs() < 1e-12, "{found:?}");
        close(found.stretch, 1.154_700_538_379_25, 1e-9);
        // λ⁻⁶ of a flat wall is 1; beyond the maximum of the cap there is no stretch.
        assert_eq!(bulge(&m, f64::to_radians(angle), 1.0, 0.0).unwrap().stretch, Some(1.0));
        let most = p * CAP / (2.0 * 0.5 * 3_f64.sqrt() * 0.578_125);
        assert!(bulge(&m, f64::to_radians(angle), 1.0, 0.999 * most).unwrap().stretch.unwrap() > 1.5);
        assert_eq!(bulge(&m, f64::to_radians(angle), 1.0, 1.001 * most).unwrap().stretch, None);
    }
    assert!(bulge(&muscle(rigid(), None), 0.5, 1.0, 0.1).is_none());
}

/// Identities with the thick-wall model: the tension is the response's, and N T sin²θ/(2π rb² cosθ) its contact pressure.
#[test]
fn tension_and_contact_pressure_are_those_of_the_model() {
    let m = muscle(rigid(), None);
    let model = ThickWall::new(&m);
    for (p, e) in [(0.2, 0.0), (0.3, 0.1), (0.5, 0.2)] {
        let w = of(&m, p, e);
        close(w.contact_pressure_mpa, model.contact_pressure_mpa(p, e).unwrap(), 1e-12);
    }
    let m = muscle(woven(), None);
    let r = ThickWall::new(&m).response(&mut Workspace::new(), 0.3, 0.1).unwrap();
    let w = wear(&m, &r);
    assert_eq!((w.strand_tension_n, w.braid_tension_n), (r.strand_tension_n, r.braid_tension_n));
    // 1 − λz is the contraction: the strands' own strain is in it.
    let outer = 0.5 * r.bulged_diameter_mm.unwrap();
    let tan = 25_f64.to_radians().tan() * (outer / 10.0) / 0.9;
    close(w.angle_deg, tan.atan().to_degrees(), 1e-9);
}

/// S/(μw) = 2 ∫ G dL with G = (4π/3) pc r cotθ of strands that do not stretch, by 2000 trapezia; with μw the work in J.
#[test]
fn the_work_of_friction_is_the_integral_of_contact_and_turning() {
    let m = muscle(rigid(), Some(Friction { lever_mm: 0.2, ..Friction::power_law(0.0, 1.0) }));
    let model = ThickWall::new(&m);
    let ((p0, e0), (p1, e1)) = ((0.25, 0.06), (0.4, 0.18));
    let g = |t: f64| {
        let (p, e) = (p0 + t * (p1 - p0), e0 + t * (e1 - e0));
        let cos = (1.0 - e) * 25_f64.to_radians().cos();
        let sin = (1.0 - cos * cos).sqrt();
        let r = 10.0 * sin / 25_f64.to_radians().sin();
        4.0 / 3.0 * std::f64::consts::PI * model.contact_pressure_mpa(p, e).unwrap() * r * cos / sin
    };
    let n = 2000;
    let mean = (0..=n)
        .map(|i| g(f64::from(i) / f64::from(n)) * if i == 0 || i == n { 0.5 } else { 1.0 })
        .sum::<f64>()
        / f64::from(n);
    let expected = 2.0 * mean * 200.0 * (e1 - e0);
    let found = turning(&model, &mut Workspace::new(), (p0, e0), (p1, e1)).unwrap();
    close(Some(found.friction_work_per_lever_n), expected, 1e-4);
    close(found.friction_work_j, 2e-4 * expected, 1e-4);
    close(
        Some(found.friction_work_per_lever_area_mpa),
        expected / (2.0 * std::f64::consts::PI * 10.0 * 200.0),
        1e-4,
    );
    let still = turning(&model, &mut Workspace::new(), (0.0, 0.1), (0.4, 0.1)).unwrap();
    assert_eq!(still.friction_work_per_lever_n, 0.0);
}

/// Where the strands touch nothing is stretched by a bulge, and no model gives a number that is none.
#[test]
fn every_model_gives_finite_quantities_or_none() {
    for braid in [rigid(), woven()] {
        let m = muscle(braid, None);
        for kind in ModelKind::ALL {
            let Ok(model) = kind.build(&m) else { continue };
            for (p, e) in [(0.0, 0.0), (0.1, 0.05), (0.3, 0.2)] {
                let Ok(r) = model.response(&mut Workspace::new(), p, e) else { continue };
                let value = serde_json::to_value(wear(&m, &r)).unwrap();
                let none = r.bulged_diameter_mm.is_none();
                assert!(!none || value["angle_deg"].is_null(), "{kind}");
                assert!(serde_json::to_string(&value).is_ok());
            }
        }
    }
    let rest = of(&muscle(woven(), None), 0.0, 0.0);
    close(rest.largest_stretch(), 1.0, 1e-14);
    assert!(rest.energy_density_mpa.unwrap().abs() < 1e-14);
}

#[test]
fn lives_that_are_stated_are_read_with_their_sources() {
    let all = lives().unwrap();
    assert_eq!(all.len(), 4);
    let hand = all.iter().find(|l| l.at_most_cycles == Some(18_000.0)).unwrap();
    let swaged = all.iter().find(|l| l.at_least_cycles == Some(1.2e8)).unwrap();
    assert!(hand.source.contains("2012") && swaged.source == hand.source && swaged.ends.contains("swaged"));
}
