//! Work in progress.
use mckibben::model::ForceModel;
use mckibben::muscle::*;
use mckibben_fem::three_dimensional::*;
use std::time::Instant;

fn main() {
    for (d, s) in [(30.0, 3.0), (50.0, 1.0)] {
        let muscle = Muscle::prototype().with_section(d, s).unwrap();
        println!("D {d} s {s}");
        for (brick, ring, through, around) in [
            (Brick::Linear, Ring::OnCircle, 1, 12),
            (Brick::Linear, Ring::EqualArea, 1, 8),
            (Brick::Linear, Ring::EqualArea, 1, 12),
            (Brick::Linear, Ring::EqualArea, 2, 12),
            (Brick::Linear, Ring::EqualArea, 1, 16),
            (Brick::Linear, Ring::EqualArea, 1, 24),
            (Brick::Quadratic, Ring::OnCircle, 1, 4),
            (Brick::Quadratic, Ring::OnCircle, 1, 6),
            (Brick::Quadratic, Ring::EqualArea, 1, 6),
            (Brick::Quadratic, Ring::OnCircle, 1, 8),
            (Brick::Quadratic, Ring::OnCircle, 1, 12),
        ] {
            let spec = BrickSpec {
                brick,
                ring,
                through: Some(through),
                around: Some(around),
                along: None,
                keep: Match::Angle,
            };
            let model = ThreeDimensional::with_mesh(&muscle, &spec).unwrap();
            let t = Instant::now();
            let first = model.force_n(0.25, 0.1);
            let dt = t.elapsed();
            let e0 = model.effort();
            print!("{brick:?} {ring:?} {:?} first {dt:?} its {} | ", model.mesh().elements(), e0.iterations);
            let _ = first;
            for (p, e) in [(0.25, 0.0), (0.25, 0.1), (0.25, 0.2), (0.1, 0.1), (0.05, 0.05), (0.05, 0.2)] {
                let axis = model.engine(|x| x.axisymmetric().unwrap().response(p, e));
                match (model.response(p, e), axis) {
                    (Ok(a), Ok(b)) => print!(
                        "{:.1}: {:+.2}% {:+.3}% |",
                        b.force_n,
                        100.0 * (a.force_n / b.force_n - 1.0),
                        100.0 * (a.volume_mm3.unwrap() / b.volume_mm3.unwrap() - 1.0)
                    ),
                    (a, b) => print!("{a:?} {:?}", b.map(|b| b.force_n)),
                }
            }
            println!(" its {} fac {}", model.effort().iterations, model.effort().factorisations);
        }
    }
}
