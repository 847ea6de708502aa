//! What a meshed terminal changes: pull and cavity of the prototype against the plane lid, in %.
//!
//! `cargo study terminal_3d [mesh] [part of a case's name]`

use mckibben::model::{ForceModel, Workspace};
use mckibben::muscle::Muscle;
use mckibben_fem::simulation::Discretised;
use mckibben_fem::three_dimensional::{BrickSpec, Plug, PlugMaterial, ThreeDimensional};
use std::error::Error;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let muscle = Muscle::prototype();
    let plug = |material, insertion: f64, nose: f64| {
        Some(Plug { material, insertion_mm: Some(insertion), nose_mm: Some(nose) })
    };
    let (rigid, aluminium) = (PlugMaterial::Rigid, PlugMaterial::Aluminium);
    let cases = [
        ("plane lid (default)", None),
        ("rigid, no insertion, sharp", plug(rigid, 0.0, 0.0)),
        ("rigid, no insertion, nose 3", plug(rigid, 0.0, 3.0)),
        ("rigid, 10 mm, sharp", plug(rigid, 10.0, 0.0)),
        ("rigid, 10 mm, nose 3", plug(rigid, 10.0, 3.0)),
        ("rigid, 20 mm, nose 3", plug(rigid, 20.0, 3.0)),
        ("aluminium, 10 mm, sharp", plug(aluminium, 10.0, 0.0)),
        ("aluminium, 10 mm, nose 3", plug(aluminium, 10.0, 3.0)),
    ];
    for mesh in std::env::args().nth(1).map_or_else(|| vec![String::new()], |m| vec![m]) {
        let spec = BrickSpec::parse(&mesh).unwrap_or_default();
        let mut reference: Vec<(f64, f64)> = vec![];
        let only = std::env::args().nth(2).unwrap_or_default();
        for (name, plug) in cases.into_iter().filter(|c| c.1.is_none() || c.0.contains(&only)) {
            let start = Instant::now();
            let model = ThreeDimensional::with_mesh(&muscle, &BrickSpec { plug, ..spec })?;
            let w = &mut Workspace::new();
            print!("{name:<28}");
            let mut found = vec![];
            for (e, p) in [(0.0, 0.05), (0.0, 0.25), (0.1, 0.05), (0.1, 0.25), (0.2, 0.05), (0.2, 0.25)] {
                match model.response(w, p, e) {
                    Ok(r) => found.push((r.force_n, r.volume_mm3.unwrap_or(f64::NAN))),
                    Err(error) => {
                        println!("{error}");
                        found.push((f64::NAN, f64::NAN));
                    }
                }
            }
            if reference.is_empty() {
                reference = found.clone();
                found.iter().for_each(|(f, v)| print!(" {f:10.3} {v:9.0}"));
            } else {
                for ((f, v), (f0, v0)) in found.iter().zip(&reference) {
                    print!(" {:+9.4}% {:+7.3}%", 100.0 * (f / f0 - 1.0), 100.0 * (v / v0 - 1.0));
                }
            }
            let (unknowns, unstable) = (model.discretisation().free, model.continuation(w)?.unstable().len());
            println!("  {unknowns} unknowns, {unstable} unstable, {:.2} s", start.elapsed().as_secs_f64());
        }
    }
    Ok(())
}
