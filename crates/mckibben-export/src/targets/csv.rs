//! CSV: tables of F(P, L) and P(F, L).

use super::entry::TargetEntry;
use super::tables::tables;
use crate::error::ExportError;
use crate::muscle::ExportedMuscle;
use crate::{Artefact, File};
use std::fmt::Write as _;

pub(super) const ENTRY: TargetEntry = TargetEntry {
    name: "csv",
    about: "tables of F(P, L), with volume and stiffness, and of P(F, L), without holes",
    needs: "any program that reads CSV with comments (#)",
    loses: "what lies between the points: linear interpolation adds about 0.5 % of the blocked force at worst",
    make,
};

fn make(muscle: &ExportedMuscle) -> Result<Artefact, ExportError> {
    let t = tables(muscle);
    let facts: String = muscle.facts().iter().map(|fact| format!("# {fact}\n")).collect();
    let length_m = muscle.form.length_m;
    let mut force =
        facts.clone() + "pressure_pa,contraction,length_m,force_n,volume_m3,stiffness_n_per_m,status\n";
    for (p, row) in t.pressures.iter().zip(&t.points) {
        for (e, point) in t.contractions.iter().zip(row) {
            let (length, force_n, volume) = ((1.0 - e) * length_m, point.force_n, point.volume_m3);
            let (stiffness, status) = (point.stiffness_n_per_m, point.status);
            // Writing to a string cannot fail.
            let _ = writeln!(force, "{p},{e},{length},{force_n},{volume:e},{stiffness},{status}");
        }
    }
    let mut pressure = facts + "force_n,contraction,length_m,pressure_pa,status\n";
    for (pull, row) in t.pulls.iter().zip(&t.inverse) {
        for (e, (p, status)) in t.contractions.iter().zip(row) {
            let _ = writeln!(pressure, "{pull},{e},{},{p},{status}", (1.0 - e) * length_m);
        }
    }
    let files = vec![
        File::text("force.csv", "pull, volume and stiffness by pressure and length", force),
        File::text("pressure.csv", "pressure by pull and length", pressure),
    ];
    let notes = vec!["status is 0, or a sum: 1 slack, 2 pressure outside, 4 contraction outside, 8 no pressure in the box gives this pull (the row has the nearest)".into()];
    Ok(Artefact { files, notes })
}
