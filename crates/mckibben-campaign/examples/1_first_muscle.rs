//! First muscle: build one, ask several models, search for one that does a job, write its deformed
//! shape for ParaView.
//!
//! `cargo run --release -p mckibben-campaign --example 1_first_muscle`

use mckibben_core::{
    model::{ForceModel, Ideal, ThickWall, Workspace},
    muscle::Muscle,
};
use mckibben_design::{OperatingPoint, Spec, design};
use mckibben_fem::{
    axisymmetric::Axisymmetric,
    output::{Shape, VtuSeries},
};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    blocked_force_of_an_ideal_muscle().map(drop)
}

/// Returns what the ideal formula says of the prototype's blocked force at 0.25 MPa, in N.
fn blocked_force_of_an_ideal_muscle() -> Result<f64, Box<dyn Error>> {
    // A tube of 30 mm with a wall of 3 mm in a braid at 28°, 285 mm between the terminals.
    let muscle = Muscle::prototype();
    let workspace = &mut Workspace::new();

    // One question, three models: how much does it pull at 0.25 MPa, held at its rest length?
    let fe = Axisymmetric::between_ends(&muscle)?;
    let (thick_wall, ideal) = (
        ThickWall::between_ends(&muscle),
        Ideal::between_ends(&muscle),
    );
    let models: [&dyn ForceModel; 3] = [&fe, &thick_wall, &ideal];
    for model in models {
        let pull = model.response(workspace, 0.25, 0.0)?;
        println!(
            "{:<12} {:7.1} N   source: {}",
            model.info().name,
            pull.force_n,
            model.info().source
        );
    }

    // Which muscle pulls 700 N at a contraction of 15 % with 0.25 MPa? The smallest comes first.
    let spec = Spec::new(
        vec![OperatingPoint {
            force_n: 700.0,
            contraction: 0.15,
        }],
        0.25,
    );
    let outcome = design(&spec, &|m| Ok(Box::new(ThickWall::between_ends(m))))?;
    let best = outcome.candidates.first().ok_or("no muscle fits")?;
    println!(
        "D0 {:.1} mm, s {:.2} mm at {:.3} MPa",
        best.muscle.outer_diameter_mm(),
        best.muscle.wall_mm(),
        best.pressure_mpa
    );

    // The thick wall leaves the ends out; finite elements say what they cost, and give the shape
    // for ParaView.
    let folder = std::env::temp_dir().join("mckibben-first-muscle");
    let fe = Axisymmetric::between_ends(&best.muscle)?;
    let pull = fe.response(workspace, 0.25, 0.15)?;
    std::fs::create_dir_all(&folder)?;
    let section = fe.section_at(workspace, 0.25, 0.15)?;
    for file in VtuSeries::new("the best muscle").add(Shape::of_section(&section), &pull)? {
        std::fs::write(folder.join(file.name), file.text)?;
    }
    println!(
        "by finite elements {:.0} N; shape in {}",
        pull.force_n,
        folder.display()
    );
    Ok(ideal.response(workspace, 0.25, 0.0)?.force_n)
}

#[test]
fn the_ideal_pull_is_that_of_the_textbook() {
    // F = π D0² P (3 cos²θ0 − 1)/(4 sin²θ0), by hand: 1073.411 N
    let force_n = blocked_force_of_an_ideal_muscle().unwrap();
    assert!((force_n - 1073.411).abs() < 1e-3, "{force_n}");
}
