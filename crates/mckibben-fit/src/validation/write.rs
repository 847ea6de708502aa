//! What was measured → the files of its folder, which `validation::read` reads.

use super::{built_in::IDENTIFIED, chosen::Parameter};
use crate::{
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
    pub free: &'a [Parameter],
    /// What was held at a value.
    pub fixed: &'a [String],
    /// Whether the single branches were fitted, in place of their means.
    pub both_branches: bool,
    /// The identified muscle as a muscle file.
    pub identified: &'a str,
}

/// The files of its folder by name, with blanks for what its owner alone can state.
pub fn measured_files(saved: &SavedMuscle<'_>) -> Vec<(&'static str, String)> {
    let free: Vec<String> = saved.free.iter().map(|p| p.word(saved.muscle)).collect();
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
    let mut files = vec![
        ("README.md", made(include_str!("../../templates/README.md"))),
        ("case.toml", made(include_str!("../../templates/case.toml"))),
        ("muscle.toml", to_toml(saved.muscle)),
        ("points.csv", points),
    ];
    files.push((IDENTIFIED, saved.identified.into()));
    files
}

#[cfg(test)]
mod tests {
    use super::{
        super::{
            built_in::muscles,
            case::{MeasuredFolder, Measurement, MuscleCase},
        },
        *,
    };

    fn saved_and_read(case: &MuscleCase) -> (MuscleCase, Vec<(&'static str, String)>) {
        let fit = case.fit_of_library().unwrap();
        let identified = case.identified.as_deref().map(to_toml).unwrap_or_default();
        let files = measured_files(&SavedMuscle {
            muscle: &fit.muscle,
            points: &case.points,
            origin: "a, table\n.csv",
            free: &fit.free,
            fixed: &[],
            both_branches: fit.both_branches,
            identified: &identified,
        });
        let text = |name: &str| {
            let file = files.iter().find(|file| file.0 == name);
            file.map(|file| file.1.clone()).unwrap_or_default()
        };
        let folder = MeasuredFolder {
            name: case.facts.name.clone(),
            case: text("case.toml"),
            muscle: text("muscle.toml"),
            points: text("points.csv"),
            identified: text(IDENTIFIED),
        };
        let Measurement::Muscle(read) = Measurement::read(&folder).unwrap() else {
            panic!("{folder:?}")
        };
        (read, files)
    }

    /// An identity: points, muscle, fit and identified muscle come back as they were.
    #[test]
    fn every_built_in_muscle_that_is_saved_is_read_as_it_was() {
        for case in muscles().unwrap() {
            let name = &case.facts.name;
            let (read, files) = saved_and_read(case);
            let without_line = |points: &[DataPoint]| -> Vec<DataPoint> {
                points.iter().map(|p| DataPoint { line: 0, ..*p }).collect()
            };
            assert_eq!(
                without_line(&read.points),
                without_line(&case.points),
                "{name}"
            );
            let (fit, was) = (&read.fits[0], case.fit_of_library().unwrap());
            assert_eq!(fit.muscle, was.muscle, "{name}");
            assert_eq!(fit.free, was.free, "{name}");
            assert_eq!(fit.both_branches, was.both_branches, "{name}");
            assert_eq!(read.identified, case.identified, "{name}");
            assert_eq!(files.len(), 5);
        }
    }

    /// Without `free` nothing is refused, though `identified.toml` is there.
    #[test]
    fn a_muscle_whose_constants_were_all_free_is_read_as_it_was() {
        let mut case = muscles()
            .unwrap()
            .into_iter()
            .find(|c| c.identified.is_some())
            .unwrap()
            .clone();
        case.fits[case.library_fit].free.clear();
        let (read, _) = saved_and_read(&case);
        assert!(read.fits[0].free.is_empty());
        assert_eq!(read.identified, case.identified);
        assert!(read.facts.source.starts_with("TO FILL IN"));
    }
}
