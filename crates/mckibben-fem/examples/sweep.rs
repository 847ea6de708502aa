//! Random muscles: `cargo run --release -p mckibben-fem --example sweep -- 2000 1`.

use mckibben::progress::Silent;
use mckibben_fem::axisymmetric::sweep::sweep;

fn main() {
    let mut arguments = std::env::args().skip(1).filter_map(|a| a.parse::<u64>().ok());
    let n = arguments.next().unwrap_or(200) as usize;
    let Ok(result) = sweep(n, arguments.next().unwrap_or(1), &Silent) else { return };
    for (i, row) in result.rows.iter().enumerate() {
        let Err(reason) = &row.answer else { continue };
        if row.required {
            let m = &row.case.muscle;
            println!(
                "{i}: D0 {:.2} s {:.2} L0 {:.1} θ0 {:.1} k {:?} {:?} P {:.3} ε {:.3} endless {:.1} N: {reason} ({} factorisations)",
                m.outer_diameter_mm(),
                m.wall_mm(),
                m.length_mm(),
                m.braid().angle_deg,
                m.family_stiffness_n_per_mm(),
                m.tube().rubber.law,
                row.case.pressure_mpa,
                row.case.contraction,
                row.endless_n.unwrap_or(f64::NAN),
                row.factorisations
            );
        }
    }
    println!("must have an answer: {:?} (answered, asked); others: {:?}", result.required(), result.others());
    println!(
        "most factorisations {}, median time {:.1} µs, longest {:.1} µs",
        result.most_factorisations(),
        1e6 * result.median_seconds(),
        1e6 * result.longest_seconds()
    );
}
