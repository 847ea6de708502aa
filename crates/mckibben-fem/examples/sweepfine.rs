//! Random muscles: `cargo run --release -p mckibben-fem --example sweep -- 2000 1`.

use mckibben::model::ForceModel;
use mckibben::rubber::RubberLaw;
use mckibben_fem::axisymmetric::{Axisymmetric, MeshSpec, sweep::sweep};

fn main() {
    let mut arguments = std::env::args().skip(1).filter_map(|a| a.parse::<u64>().ok());
    let n = arguments.next().unwrap_or(200) as usize;
    let result = sweep(n, arguments.next().unwrap_or(1));
    for (i, row) in result.rows.iter().enumerate() {
        if let Ok(f) = row.answer {
            let m = &row.case.muscle;
            let e = row.endless_n.unwrap_or(f64::NAN);
            let fine =
                Axisymmetric::with_mesh(m, &MeshSpec { along: Some(32), through: Some(2), grading: None })
                    .unwrap();
            let blocked = fine.force_n(row.case.pressure_mpa, 0.0).unwrap_or(f64::NAN);
            let x = fine.force_n(row.case.pressure_mpa, row.case.contraction).unwrap_or(f64::NAN);
            println!(
                "OK {i} {} {} stable {} F {f:.3} fine {x:.3} err% {:.4} endless {e:.3} its {} L/D {:.1} s/D {:.3} th {:.1} P/mu {:.2} e {:.3} k {:?} blocked {blocked:.2} {}",
                row.required,
                f <= e * 1.02 + 1.0,
                row.stable,
                100.0 * (f - x) / blocked,
                row.iterations,
                m.length_mm() / m.outer_diameter_mm(),
                m.wall_mm() / m.outer_diameter_mm(),
                m.braid().angle_deg,
                row.case.pressure_mpa / m.tube().rubber.law.shear_modulus_mpa(),
                row.case.contraction,
                m.family_stiffness_n_per_mm(),
                m.tube().rubber.law.name()
            );
            continue;
        }
        let Err(reason) = &row.answer else { continue };
        if row.required {
            let m = &row.case.muscle;
            println!(
                "{i}: D0 {:.2} s {:.2} L0 {:.1} θ0 {:.1} k {:?} {:?} P {:.3} ε {:.3} endless {:.1} N: {reason} ({} iterations)",
                m.outer_diameter_mm(),
                m.wall_mm(),
                m.length_mm(),
                m.braid().angle_deg,
                m.family_stiffness_n_per_mm(),
                m.tube().rubber.law,
                row.case.pressure_mpa,
                row.case.contraction,
                row.endless_n.unwrap_or(f64::NAN),
                row.iterations
            );
        }
    }
    println!("must have an answer: {:?} (answered, asked); others: {:?}", result.required(), result.others());
    println!(
        "most iterations {}, median time {:.1} µs, longest {:.1} µs",
        result.most_iterations(),
        1e6 * result.median_seconds(),
        1e6 * result.longest_seconds()
    );
}
