use mckibben::muscle::*;
use mckibben::rubber::*;
use mckibben_fem::axisymmetric::{discrete::*, equilibrium::*, mesh::*};
use mckibben_fem::solver::newton::{self, NewtonOptions};
use std::time::Instant;

fn main() {
    let n: usize = std::env::args().nth(1).map(|s| s.parse().unwrap()).unwrap_or(16);
    let mut tube = Tube::prototype();
    tube.length_mm = 287.83;
    tube.rubber = Rubber::of(Law::MooneyRivlin(MooneyRivlin { c10_mpa: 0.12, c01_mpa: 0.03 }));
    let braid = Braid {
        angle_deg: 28.0,
        stiffness: BraidStiffness::OfStrands,
        strands: Some(Strands { count: 48, section: Some((0.3, 2500.0)), strength_n: None }),
        measured: None,
        compression: false,
    };
    let m = Muscle::new(tube, braid, Terminals::default(), None).unwrap();
    println!("k {:?}", m.family_stiffness_n_per_mm());
    let g: f64 = std::env::args().nth(2).map(|s| s.parse().unwrap()).unwrap_or(2.0);
    let mesh = Mesh::tube(12.0, 15.0, 287.83 / 2.0, (1, n, g));
    let d = Discrete::new(mesh, Make::of(&m)).unwrap();
    let mut b = Body::new(d);
    let o = NewtonOptions::default();
    let t = Instant::now();
    for (p, e) in [(0.25, 0.0), (0.25, 0.10), (0.10, 0.10)] {
        b.state.pressure = p;
        b.control = Control::Length(-e * 287.83 / 2.0);
        let t = Instant::now();
        let r = newton::solve(&mut b, &o, |r| print!("{r:.1e} "));
        println!(
            "\n P {p} e {e}: {r:?} F {:.5} V {:.3} unstable {} {:?}",
            b.totals.pull,
            2.0 * b.totals.volume,
            b.unstable_directions(),
            t.elapsed()
        );
    }
    println!("{:?}", t.elapsed());
}
