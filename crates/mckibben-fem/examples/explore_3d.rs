//! Work in progress.
use mckibben::model::ForceModel;
use mckibben::muscle::*;
use mckibben_fem::axisymmetric::*;
use mckibben_fem::three_dimensional::*;

fn main() {
    for (d, s, l, a) in [
        (30.0, 3.0, 285.0, 28.0),
        (30.0, 1.0, 285.0, 28.0),
        (30.0, 5.0, 285.0, 28.0),
        (40.0, 3.0, 285.0, 28.0),
        (50.0, 1.0, 285.0, 28.0),
        (50.0, 5.0, 285.0, 28.0),
        (14.0, 0.5, 300.0, 20.0),
        (14.0, 0.5, 300.0, 35.0),
        (20.0, 2.0, 80.0, 25.0),
    ] {
        let muscle = Muscle::prototype();
        let mut tube = muscle.tube().clone();
        (tube.outer_diameter_mm, tube.wall_mm, tube.length_mm) = (d, s, l);
        let muscle =
            muscle.with_tube(tube).unwrap().with_braid(Braid { angle_deg: a, ..Braid::paper() }).unwrap();
        let axis = Axisymmetric::new(&muscle).unwrap();
        for text in [None, Some("1x7:quadratic")] {
            let spec = text.map_or(BrickSpec::default(), |t| BrickSpec::parse(t).unwrap());
            let t = std::time::Instant::now();
            let model = ThreeDimensional::with_mesh(&muscle, &spec).unwrap();
            print!(
                "D {d} s {s} L {l} {a} {:?} last {:.1} | ",
                model.mesh().elements(),
                model.mesh().last_angle_rad().to_degrees()
            );
            let blocked = axis.force_n(0.25, 0.0).unwrap();
            for (p, e) in [(0.25, 0.0), (0.25, 0.1), (0.25, 0.2), (0.1, 0.1), (0.05, 0.05), (0.05, 0.2)] {
                match (model.response(p, e), axis.response(p, e)) {
                    (Ok(a), Ok(b)) => print!(
                        "{:+.3}% {:+.2}% |",
                        100.0 * (a.force_n - b.force_n) / blocked,
                        100.0 * (a.volume_mm3.unwrap() / b.volume_mm3.unwrap() - 1.0)
                    ),
                    (a, b) => print!("{a:?} {:?}", b.map(|b| b.force_n)),
                }
            }
            println!("{:?} {:?}", t.elapsed(), model.effort().iterations);
        }
    }
}
