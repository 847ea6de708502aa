use mckibben::model::ForceModel;
use mckibben::muscle::*;
use mckibben_fem::axisymmetric::*;
use std::time::Instant;

fn main() {
    let pressures: Vec<f64> = (0..=25).map(|i| 0.01 * i as f64).collect();
    for (d0, s) in [(30.0, 3.0), (30.0, 1.0), (50.0, 1.0), (50.0, 5.0), (30.0, 5.0)] {
        let m = Muscle::prototype().with_section(d0, s).unwrap();
        for e in [0.0, 0.05, 0.1, 0.15, 0.2] {
            let mut times = vec![];
            let mut last = String::new();
            for _ in 0..9 {
                let fe = Axisymmetric::new(&m).unwrap();
                let t = Instant::now();
                let c = fe.isometric(e, &pressures);
                times.push(t.elapsed().as_secs_f64() * 1e6);
                let bad = c.iter().filter(|p| p.is_err()).count();
                let slack = c.iter().flatten().filter(|p| p.slack()).count();
                last = format!(
                    "{:?} bad {bad} slack {slack} its {:?} F {:.3}",
                    fe.effort(),
                    c.iter().flatten().map(|p| p.iterations).collect::<Vec<_>>(),
                    c[25].as_ref().unwrap().force_n
                );
            }
            times.sort_by(|a, b| a.total_cmp(b));
            println!("D{d0} s{s} e{e} {:.0} us  {last}", times[4]);
        }
        let fe = Axisymmetric::new(&m).unwrap();
        let r = fe.solve(0.2, 0.1).unwrap();
        println!("{:?}\n{:?}", r.response, r.max_stretch);
        for x in &r.sensitivities {
            println!("  {x:?}");
        }
        println!("free {:?} P' {:?}", fe.free_contraction(0.25), fe.starting_pressure_mpa(0.1));
        let t = Instant::now();
        let mut n = 0;
        for i in 0..100 {
            fe.force_n(0.2 + 0.0003 * i as f64, 0.1 + 0.0002 * i as f64).unwrap();
            n += 1;
        }
        println!("warm {:?}", t.elapsed() / n);
        println!(
            "isotonic {:?}",
            fe.isotonic(80.0, &pressures)
                .iter()
                .map(|p| p.as_ref().map(|p| (p.contraction * 1e4).round() / 1e4).unwrap_or(f64::NAN))
                .collect::<Vec<_>>()
        );
        println!(
            "isobaric {:?}",
            fe.isobaric(0.25, &[0.0, 0.05, 0.1, 0.15, 0.2])
                .iter()
                .map(|p| p.as_ref().map(|p| (p.force_n * 1e2).round() / 1e2).unwrap_or(f64::NAN))
                .collect::<Vec<_>>()
        );
    }
}
