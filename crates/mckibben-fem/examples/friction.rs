//! Contact of the strands and the pivoting friction that follows, of a muscle file.

use mckibben::model::Workspace;
use mckibben::muscle::file::read_muscle;
use mckibben_fem::axisymmetric::Axisymmetric;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let m = read_muscle(std::env::args().nth(1).ok_or("which muscle file?")?)?;
    let fe = Axisymmetric::new(&m)?;
    let w = &mut Workspace::new();
    for p in [0.1, 0.2, 0.3, 0.4, 0.5] {
        for i in 0..=30 {
            let e = 0.01 * f64::from(i);
            match fe.contact(w, p, e) {
                Ok(c) => println!("{p},{e},{},{}", c.pivoting_n_per_mm, c.places[0].pressure_mpa),
                Err(x) => eprintln!("{p} {e} {x}"),
            }
        }
    }
    Ok(())
}
