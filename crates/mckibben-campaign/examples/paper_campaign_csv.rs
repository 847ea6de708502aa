//! The paper's campaign and its held-out diameter as CSV: `data/campaign/paper.csv` is what this
//! prints.

use mckibben_campaign::fit::data::{DIAMETERS, Grid, HELD_OUT};
use mckibben_core::muscle::Muscle;

fn main() {
    println!("outer_diameter_mm,wall_mm,length_mm,angle_deg,pressure_mpa,contraction,force_n");
    let diameters = [&DIAMETERS[..], &[HELD_OUT]].concat();
    for p in (Grid {
        diameters: &diameters,
        ..Grid::PAPER
    })
    .points(&Muscle::prototype())
    {
        let (d, s, l, a) = (p.outer_diameter_mm, p.wall_mm, p.length_mm, p.angle_deg);
        println!(
            "{d},{s},{l},{a},{},{},{:.5}",
            p.pressure_mpa, p.contraction, p.force_n
        );
    }
}
