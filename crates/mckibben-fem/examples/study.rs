use mckibben::muscle::*;
use mckibben_fem::axisymmetric::{discrete::*, equilibrium::*, mesh::*};
use mckibben_fem::solver::newton::{self, NewtonOptions};
fn force(m: &Muscle, div: (usize, usize, f64), e: f64, p: f64) -> f64 {
    let t = m.tube();
    let mesh = Mesh::tube(t.inner_radius_mm(), t.outer_radius_mm(), 0.5 * t.length_mm, div);
    let mut b = Body::new(Discrete::new(mesh, Make::of(m)).unwrap());
    let o = NewtonOptions::default();
    let mut f = 0.0;
    let sin = m.braid().angle_rad().sin();
    b.state.q.fill(0.25 * t.outer_radius_mm() / (2.0 * sin * sin));
    for (p, e) in [(0.25, 0.0), (0.25, 0.5 * e), (0.25, e), (p, e)] {
        b.state.pressure = p;
        b.control = Control::Length(-e * 0.5 * t.length_mm);
        if let Err(s) = newton::solve(&mut b, &o, |_| ()) {
            println!("   {s} at {p} {e}");
            return f64::NAN;
        }
        f = b.totals.pull;
    }
    f
}
fn main() {
    let divs: Vec<(usize, usize, f64)> = vec![
        (1, 4, 2.0),
        (1, 5, 2.0),
        (1, 6, 2.0),
        (1, 6, 2.5),
        (1, 8, 1.5),
        (1, 8, 2.0),
        (1, 8, 2.5),
        (1, 8, 3.0),
        (1, 16, 2.5),
        (2, 12, 2.5),
    ];
    let mut worst = vec![0.0f64; divs.len()];
    for d0 in [30.0, 40.0, 50.0] {
        for s in [1.0, 3.0, 5.0] {
            let m = Muscle::prototype().with_section(d0, s).unwrap();
            let fine = (if s > 2.0 { 3 } else { 2 }, 48, 3.0);
            let blocked = force(&m, fine, 0.0, 0.25);
            for (e, p) in [(0.0, 0.25), (0.1, 0.25), (0.2, 0.25), (0.1, 0.1), (0.2, 0.15), (0.1, 0.02)] {
                let exact = force(&m, fine, e, p);
                print!("{d0} {s} {e} {p}: {exact:9.3} ");
                for (i, &d) in divs.iter().enumerate() {
                    let err = 100.0 * (force(&m, d, e, p) - exact) / blocked;
                    worst[i] = worst[i].max(err.abs());
                    print!("{err:8.4}");
                }
                println!();
            }
        }
    }
    println!("{divs:?}\n{worst:.4?}");
}
