//! What the program's own three-dimensional mesh errs by: pull against the axisymmetric limit over the blocked force, on random muscles
//! and questions. `cargo study mesh_error_3d 2000`

use mckibben::model::{ForceModel, Workspace};
use mckibben::muscle::Muscle;
use mckibben_fem::axisymmetric::Axisymmetric;
use mckibben_fem::three_dimensional::ThreeDimensional;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let count: usize = std::env::args().nth(1).map_or(Ok(500), |n| n.parse())?;
    let mut seed = 11u64;
    let mut random = |low: f64, high: f64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (seed >> 11) as f64 / (1u64 << 53) as f64
    };
    let (mut taut, mut slack, mut failed) = (vec![], vec![], 0);
    for _ in 0..count {
        let d = random(14.0, 50.0);
        let s = random(0.5, 5.0_f64.min(0.2 * d));
        let (length_mm, angle_deg) = (random(80.0, 300.0), random(20.0, 35.0));
        let (p, e) = (random(0.05, 0.25), random(0.0, 0.2));
        let mut tube = Muscle::prototype().tube().clone();
        (tube.outer_diameter_mm, tube.wall_mm, tube.length_mm) = (d, s, length_mm);
        let mut braid = Muscle::prototype().braid().clone();
        braid.angle_deg = angle_deg;
        let muscle = Muscle::prototype().with_tube(tube)?.with_braid(braid)?;
        let (solid, section) = (ThreeDimensional::new(&muscle)?, Axisymmetric::new(&muscle)?);
        let w = &mut Workspace::new();
        let (Ok(a), Ok(b), Ok(blocked)) = (
            solid.force_n(&mut Workspace::new(), p, e),
            section.force_n(w, p, e),
            section.force_n(w, p, 0.0),
        ) else {
            failed += 1;
            continue;
        };
        let row = (
            (a - b).abs() / blocked,
            format!(
                "D0 {d:.1} s {s:.2} L0 {length_mm:.0} θ0 {angle_deg:.1} P {p:.3} ε {e:.3}: {a:.3} {b:.3} of {blocked:.1} N"
            ),
        );
        if b > 0.0 { taut.push(row) } else { slack.push(row) }
    }
    let all = [taut.clone(), slack.clone()].concat();
    for (name, mut rows) in [("all", all), ("pulling", taut), ("pushing", slack)] {
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        let at =
            |share: f64| rows.get(((rows.len() as f64 * share) as usize).min(rows.len().saturating_sub(1)));
        println!("{name}: {} questions", rows.len());
        for share in [0.5, 0.95, 0.99, 1.0] {
            if let Some((error, what)) = at(share) {
                println!("  {:>4.0} %: {:.4} % of the blocked force   {what}", 100.0 * share, 100.0 * error);
            }
        }
    }
    println!("{failed} without an answer");
    Ok(())
}
