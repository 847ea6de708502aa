//! How the strands of a muscle press and turn, over pressure and contraction: CSV of what friction between them grows with.
//!
//! `cargo study friction -- examples/tondu2012.toml`

use mckibben::model::Workspace;
use mckibben::muscle::file::read_muscle;
use mckibben_fem::axisymmetric::Axisymmetric;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("name a muscle file")?;
    let (fe, w) = (Axisymmetric::new(&read_muscle(path)?)?, &mut Workspace::new());
    println!("pressure_mpa,contraction,pivoting_n_per_mm,contact_pressure_mpa");
    for p in [0.1, 0.2, 0.3, 0.4, 0.5] {
        for i in 0..=30 {
            let e = 0.01 * f64::from(i);
            match fe.contact(w, p, e) {
                Ok(c) => println!("{p},{e},{},{}", c.pivoting_n_per_mm, c.places[0].pressure_mpa),
                Err(error) => eprintln!("{p} MPa, {e}: {error}"),
            }
        }
    }
    Ok(())
}
