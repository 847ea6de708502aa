//! Why the program's mesh is what it is: errors in % of the blocked force over the paper's range, against
//! meshes of 3 × 48 elements. `cargo study mesh_study`.

use mckibben_fem::axisymmetric::study::mesh_study;
use std::process::ExitCode;

fn main() -> ExitCode {
    let meshes = [
        (1, 4, 2.0),
        (1, 5, 2.0),
        (1, 6, 1.0),
        (1, 6, 1.5),
        (1, 6, 2.0),
        (1, 6, 2.5),
        (1, 8, 2.0),
        (1, 8, 3.0),
        (1, 16, 2.0),
        (2, 8, 2.0),
        (2, 12, 2.5),
    ];
    match mesh_study(&meshes) {
        Err(e) => {
            eprintln!("{e}");
            ExitCode::FAILURE
        }
        Ok(rows) => {
            println!("through along grading   largest error (% of the blocked force)   at D0 s P ε");
            for r in rows {
                println!(
                    "{:>7} {:>5} {:>7}   {:>38.4}   {:?}",
                    r.mesh.0,
                    r.mesh.1,
                    r.mesh.2,
                    100.0 * r.largest_error,
                    r.at
                );
            }
            ExitCode::SUCCESS
        }
    }
}
