use mckibben::model::ForceModel;
use mckibben::muscle::*;
use mckibben::rubber::*;
use mckibben_fem::axisymmetric::*;
fn main() {
    let mut seed = 12345u64;
    let mut u = || {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        (seed >> 11) as f64 / (1u64 << 53) as f64
    };
    let (mut ok, mut err, mut worst, mut bad) = (0, 0, 0.0f64, 0);
    let mut reasons = std::collections::BTreeMap::new();
    for i in 0..6000 {
        let d0 = 10f64.powf(-1.0 + 4.0 * u());
        let mu = 10f64.powf(-4.0 + 6.0 * u());
        let law = match i % 5 {
            0 => Law::MooneyRivlin(MooneyRivlin { c10_mpa: mu, c01_mpa: mu * (u() - 0.6) }),
            1 => Law::NeoHookean(NeoHookean { mu_mpa: mu }),
            2 => Law::Yeoh(Yeoh { c10_mpa: mu, c20_mpa: mu * (u() - 0.5), c30_mpa: mu * (u() - 0.5) }),
            3 => Law::Gent(Gent { mu_mpa: mu, jm: 10f64.powf(-1.0 + 3.0 * u()) }),
            _ => Law::Ogden(Ogden { terms: vec![(mu, 8.0 * u() - 2.0), (mu * 0.1, -3.0 * u() - 0.1)] }),
        };
        let bulk =
            if u() < 0.5 { Bulk::Incompressible } else { Bulk::Modulus(mu * 10f64.powf(-1.0 + 6.0 * u())) };
        let tube = Tube {
            outer_diameter_mm: d0,
            wall_mm: d0 * 10f64.powf(-3.0 + 2.69 * u()),
            length_mm: d0 * 10f64.powf(-0.5 + 3.0 * u()),
            rubber: Rubber { name: None, law, bulk, fitted_to_stretch: None },
        };
        let st = if u() < 0.3 {
            BraidStiffness::Inextensible
        } else {
            BraidStiffness::NewtonPerMm(10f64.powf(-4.0 + 12.0 * u()))
        };
        let braid =
            Braid { angle_deg: 0.5 + 54.0 * u(), stiffness: st, compression: u() < 0.3, ..Braid::paper() };
        let Ok(m) = Muscle::new(tube, braid, Terminals::default(), None) else { continue };
        let (p, e) =
            (mu * 10f64.powf(-3.0 + 6.0 * u()) * if u() < 0.15 { -1.0 } else { 1.0 }, -0.5 + 1.44 * u());
        let Ok(fe) = Axisymmetric::new(&m) else {
            println!("mesh {m:?}");
            continue;
        };
        let t = std::time::Instant::now();
        let r = fe.response(p, e);
        let dt = t.elapsed().as_secs_f64();
        if dt > worst {
            worst = dt;
            println!("{i}: {:.2} ms {:?} {:?}", dt * 1e3, fe.effort(), r.as_ref().map(|r| r.force_n));
        }
        match r {
            Ok(r) => {
                ok += 1;
                if !(r.force_n.is_finite()
                    && r.volume_mm3.unwrap().is_finite()
                    && r.stiffness_n_per_mm.unwrap().is_finite()
                    && r.max_stretch.unwrap().is_finite()
                    && r.force_per_pressure_mm2.unwrap().is_finite())
                {
                    bad += 1;
                    println!("{r:?}");
                }
            }
            Err(x) => {
                err += 1;
                *reasons
                    .entry(x.to_string().split_whitespace().take(3).collect::<Vec<_>>().join(" "))
                    .or_insert(0) += 1;
            }
        }
        let _ = fe.isometric(e, &[p, 0.5 * p, 0.0]);
        let _ = fe.isotonic(p * d0 * d0, &[p, 0.7 * p]);
        let _ = fe.starting_pressure_mpa(e.abs());
    }
    println!("ok {ok} err {err} bad {bad} worst {:.2} ms {reasons:?}", worst * 1e3);
}
