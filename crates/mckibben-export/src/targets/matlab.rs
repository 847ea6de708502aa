//! MATLAB, Simulink and GNU Octave: tables in a MAT-file, functions, and a script for lookup blocks.

use super::common::common;
use super::entry::TargetEntry;
use super::mat_file::{Variable, mat_file};
use super::tables::tables;
use crate::error::ExportError;
use crate::muscle::ExportedMuscle;
use crate::template::{list, number, render};
use crate::{Artefact, File};

pub(super) const ENTRY: TargetEntry = TargetEntry {
    name: "matlab",
    about: "tables in a MAT-file, functions, and a script that fills Simulink's lookup blocks",
    needs: "MATLAB or GNU Octave; Simulink for the blocks",
    loses: "nothing of the form in the functions; linear interpolation of the tables adds about 0.5 % of the blocked force at worst",
    make,
};

fn make(muscle: &ExportedMuscle) -> Result<Artefact, ExportError> {
    let (f, t, facts) = (&muscle.form, tables(muscle), muscle.facts());
    let said = facts.join(" ");
    let lengths: Vec<f64> = t.contractions.iter().map(|e| (1.0 - e) * f.length_m).collect();
    // Lengths rise, as interpolation needs; a matrix has pressures along its rows.
    let rising: Vec<f64> = lengths.iter().rev().copied().collect();
    let by_length = |value: &dyn Fn(usize, usize) -> f64, rows: usize| {
        let columns = (0..rising.len()).rev();
        Variable::Matrix(rows, columns.flat_map(|k| (0..rows).map(move |r| value(r, k))).collect())
    };
    let across = t.pressures.len();
    let file = mat_file(
        &format!("{} {}, hash {}", crate::MARK, muscle.version, muscle.hash),
        &[
            ("about", Variable::Text(&said)),
            ("rest_length_m", Variable::Matrix(1, vec![f.length_m])),
            ("pressure_pa", Variable::Matrix(1, t.pressures.clone())),
            ("length_m", Variable::Matrix(1, rising.clone())),
            ("force_n", by_length(&|r, k| t.points[r][k].force_n, across)),
            ("volume_m3", by_length(&|r, k| t.points[r][k].volume_m3, across)),
            ("stiffness_n_per_m", by_length(&|r, k| t.points[r][k].stiffness_n_per_m, across)),
            ("status", by_length(&|r, k| f64::from(t.points[r][k].status), across)),
            ("pull_n", Variable::Matrix(1, t.pulls.clone())),
            ("pressure_of_pull_pa", by_length(&|r, k| t.inverse[r][k].0, t.pulls.len())),
            ("status_of_pull", by_length(&|r, k| f64::from(t.inverse[r][k].1), t.pulls.len())),
        ],
    );
    let matrix = |rows: Vec<String>| format!("[{}]", rows.join("; "));
    let row = |values: &[f64]| list(values, ["", ""], number);
    let mut values = common(muscle);
    values.extend([
        ("m_nodes", matrix(vec![row(&f.contractions)])),
        ("m_a", matrix(f.a.iter().map(|a| row(a)).collect())),
        ("m_b", matrix(f.b.iter().map(|b| row(b)).collect())),
        ("m_v", matrix(vec![row(&f.v)])),
        ("m_friction", matrix(vec![row(&f.friction_n)])),
    ]);
    let m = |name, about, template| File::text(name, about, render(template, &facts, &values));
    let files = vec![
        File::bytes("muscle.mat", "the tables", file),
        m(
            "mckibben_force.m",
            "pull, its slopes, volume and status",
            include_str!("../../templates/mckibben_force.m"),
        ),
        m(
            "mckibben_pressure.m",
            "pressure by pull and length",
            include_str!("../../templates/mckibben_pressure.m"),
        ),
        m(
            "mckibben_pressure_on.m",
            "the same on a branch of the hysteresis",
            include_str!("../../templates/mckibben_pressure_on.m"),
        ),
        m(
            "mckibben_coefficients.m",
            "what both need",
            include_str!("../../templates/mckibben_coefficients.m"),
        ),
        m(
            "lookup_blocks.m",
            "fills lookup blocks of Simulink",
            include_str!("../../templates/lookup_blocks.m"),
        ),
    ];
    Ok(Artefact { files, notes: vec![] })
}
