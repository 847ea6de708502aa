use mckibben::muscle::*;
use mckibben::rubber::*;
use mckibben_fem::axisymmetric::{discrete::*, equilibrium::*, mesh::*, path::*};
use std::time::Instant;

fn main() {
    let n: usize = std::env::args().nth(1).map(|s| s.parse().unwrap()).unwrap_or(6);
    for inext in [false, true] {
    for (d0, s, c01) in [(30.0, 3.0, 0.03), (30.0, 1.0, 0.0), (50.0, 1.0, 0.0), (50.0, 5.0, 0.0), (30.0, 5.0, 0.0)] {
        for e in [0.0, 0.05, 0.1, 0.2] {
            let mut tube = Tube { outer_diameter_mm: d0, wall_mm: s, ..Tube::prototype() };
            tube.rubber = Rubber::of(Law::MooneyRivlin(MooneyRivlin { c10_mpa: 0.12, c01_mpa: c01 }));
            let mut braid = Braid::paper();
            if inext { braid.stiffness = BraidStiffness::Inextensible; }
            let m = Muscle::new(tube, braid, Terminals::default(), None).unwrap();
            let half = 0.5 * m.length_mm();
            let mesh = Mesh::tube(m.tube().inner_radius_mm(), m.tube().outer_radius_mm(), half, (1, n, 2.0));
            let mut b = Walker::new(Discrete::new(mesh, Make::of(&m)).unwrap());
            let t = Instant::now();
            let r = b.walk(0.25, -e * half);
            println!("D{d0} s{s} e{e} direct {:?} {:?} F {:.4} {:?} unst {}", r.err().map(|x| x.0), b.effort, b.body.totals.pull, t.elapsed(), b.body.unstable_directions());
            let mut worst = 0; let mut eff = Effort0::default();
            b.effort = Default::default();
            let t = Instant::now();
            for i in (0..25).rev() {
                let before = b.effort;
                let r = b.walk(0.01 * i as f64, -e * half);
                if let Err(r) = r { println!("   {i} {:?}", r); break; }
                worst = worst.max(b.effort.iterations - before.iterations);
                eff.n += 1;
            }
            println!("   sweep down {:?} n {} worst {worst} F {:.4} {:?}", b.effort, eff.n, b.body.totals.pull, t.elapsed());
        }
    } }
}
#[derive(Default)]
struct Effort0 { n: usize }
