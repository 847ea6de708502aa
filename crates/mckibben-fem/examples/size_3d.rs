//! The peers' benchmark (work in progress).
use mckibben::muscle::*;
use mckibben::rubber::*;
use mckibben_fem::axisymmetric::equilibrium::Control;
use mckibben_fem::solver::newton::{self, Effort, NewtonOptions};
use mckibben_fem::three_dimensional::*;
use std::time::Instant;

fn main() {
    let arg: Vec<String> = std::env::args().collect();
    let mesh_text = arg.get(1).cloned().unwrap_or("2x12x39".into());
    let k: f64 = arg.get(2).map_or(300.0, |s| s.parse().unwrap());
    let mut muscle = Muscle::prototype();
    let mut tube = muscle.tube().clone();
    tube.rubber = Rubber {
        bulk: if k > 0.0 { Bulk::Modulus(k) } else { Bulk::Incompressible },
        ..Rubber::of(Law::MooneyRivlin(MooneyRivlin { c10_mpa: 0.12, c01_mpa: 0.03 }))
    };
    muscle = muscle.with_tube(tube).unwrap();
    muscle = muscle
        .with_braid(Braid {
            angle_deg: 28.0,
            stiffness: BraidStiffness::OfStrands,
            strands: Some(Strands { count: 48, section: Some((0.3, 2500.0)), strength_n: None }),
            measured: None,
            compression: true,
        })
        .unwrap();
    let brick = if arg.get(3).is_some_and(|s| s == "27") { Brick::Quadratic } else { Brick::Linear };
    let spec = BrickSpec {
        keep: Match::Angle,
        brick,
        ring: Some(Ring::OnCircle),
        ..BrickSpec::parse(&mesh_text).unwrap()
    };
    let mesh = BrickMesh::new(12.0, 15.0, 142.5, 28f64.to_radians(), &spec).unwrap();
    println!("{:?} half {} angle {}", mesh.elements(), mesh.half_length_mm(), mesh.angle_rad().to_degrees());
    let t = Instant::now();
    let d = Discrete::new(Parts::of(&muscle, &mesh)).unwrap();
    println!("free {} entries {} setup {:?} {:?}", d.free, d.pattern.entries(), t.elapsed(), d.width);
    let mut body = Body::new(d).unwrap();
    println!(
        "factor {} flops {:.3e} setup {:?}",
        body.cholesky().factor_entries(),
        body.cholesky().operations(),
        t.elapsed()
    );
    for _ in 0..3 {
        let t = Instant::now();
        body.assemble().unwrap();
        let a = t.elapsed();
        body.evaluate().unwrap();
        let e = t.elapsed() - a;
        body.assemble().unwrap();
        let t = Instant::now();
        body.factorise_assembled().unwrap();
        println!("assemble {a:?} evaluate {e:?} factorise {:?}", t.elapsed());
    }
    let options = NewtonOptions { tolerance: 1e-9, ..NewtonOptions::default() };
    let half = body.discrete.half;
    let conv = std::f64::consts::PI * 144.0 - 4.0 * mesh.cap_mm2();
    let run = |targets: &[(f64, f64)], body: &mut Body| {
        body.state = State::rest(&body.discrete);
        let mut effort = Effort::default();
        let t = Instant::now();
        for &(e, p) in targets {
            body.state.pressure = p;
            body.control = Control::Length(-e * half);
            let mut seen = vec![];
            let r = newton::solve(body, &options, &mut effort, |n| seen.push(n));
            if r.is_err() || (e, p) == *targets.last().unwrap() || p == 0.10 || arg.len() > 4 {
                println!(
                    "e {e:.3} P {p:.3} F {:.4} round {:.4} {r:?} {}",
                    body.totals.pull,
                    body.totals.pull - p * conv,
                    seen.iter().map(|x| format!("{x:.1e} ")).collect::<String>()
                );
            }
        }
        println!("{:?} {effort:?} substitutions {}", t.elapsed(), body.substitutions);
    };
    let up: Vec<(f64, f64)> = (1..=25).map(|i| (0.0, 0.01 * i as f64)).collect();
    run(&up, &mut body);
    let mut low: Vec<(f64, f64)> = (1..=5).map(|i| (0.0, 0.01 * i as f64)).collect();
    low.extend((1..=20).map(|i| (0.005 * i as f64, 0.05)));
    low.extend((6..=25).map(|i| (0.1, 0.01 * i as f64)));
    run(&low, &mut body);
    body.factorise().unwrap();
    println!(
        "dF/dP {} -dV/dL {} stiffness {}",
        body.force_per_pressure(),
        body.volume_per_length(),
        body.terminal_stiffness()
    );
}
