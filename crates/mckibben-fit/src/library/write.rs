//! What was measured → the files of its folder, which the study `validation` reads.

use super::folder::IDENTIFIED;
use crate::{
    identify::Target,
    measured::{DataPoint, table},
};
use mckibben_core::{
    clean::line,
    muscle::{Muscle, file::to_toml},
};
use mckibben_io::template::render;

/// A muscle that was measured and identified.
#[derive(Debug)]
pub struct SavedMuscle<'a> {
    /// With which the search begins.
    pub muscle: &'a Muscle,
    /// All points.
    pub points: &'a [DataPoint],
    /// Where they come from.
    pub origin: &'a str,
    /// What was free; all constants where nothing is named.
    pub free: &'a [Target],
    /// What was held at a value.
    pub fixed: &'a [String],
    /// Whether the single branches were fitted, in place of their means.
    pub both_branches: bool,
    /// The identified muscle as a muscle file.
    pub identified: &'a str,
}

/// The files of its folder by name, with blanks for what its owner alone can state.
pub fn measured_files(saved: &SavedMuscle<'_>) -> Vec<(&'static str, String)> {
    let free: Vec<String> = saved.free.iter().map(|t| t.name(saved.muscle)).collect();
    let origin = line(saved.origin);
    let points = format!("# From {origin}.\n{}", table(saved.points));
    let mut values = vec![
        ("free", format!("{free:?}")),
        ("points", saved.points.len().to_string()),
        ("origin", origin),
    ];
    let fixed = line(&saved.fixed.join(", "));
    for (key, holds, text) in [
        ("nothing", free.is_empty(), String::new()),
        ("both", saved.both_branches, String::new()),
        ("identified", true, String::new()),
        ("fixed", !fixed.is_empty(), fixed),
    ] {
        values.extend(holds.then_some((key, text)));
    }
    let made = |template| render(template, &[], &values);
    vec![
        ("README.md", made(include_str!("../../templates/README.md"))),
        ("case.toml", made(include_str!("../../templates/case.toml"))),
        ("muscle.toml", to_toml(saved.muscle)),
        ("points.csv", points),
        (IDENTIFIED, saved.identified.into()),
    ]
}
