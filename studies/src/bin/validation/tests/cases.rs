//! Folders that are read, and that `identify --save-measured` wrote.

use super::{ALL, at, muscle, muscles};
use crate::{
    case::{self, BUILT_IN, Case, CaseFit, Files, MuscleCase, Points},
    with_texts,
};
use mckibben_core::muscle::file::to_toml;
use mckibben_fit::{
    identify::Target,
    library::write::{SavedMuscle, measured_files},
    measured::DataPoint,
};

#[test]
fn every_folder_has_points_and_fits() {
    let folders = std::fs::read_dir(at(BUILT_IN)).unwrap().count();
    assert_eq!(ALL.len(), folders);
    for case in ALL.iter() {
        let enough = match case {
            Case::Muscle(case) => case.points.len() > 5 && !case.fits.is_empty(),
            Case::Rubber(case) => {
                let points = match &case.points {
                    Points::Tests(list) => list.len(),
                    Points::History(list) => list.len(),
                };
                points > 30 && !case.fits.is_empty()
            }
        };
        assert!(enough, "{}", case.name());
    }
}

/// Those of the examples, which are cases of users.
#[test]
fn a_folder_of_cases_and_one_case_are_read() {
    for folder in [
        "examples/measured",
        "examples/library",
        "examples/library/bench",
    ] {
        let cases = case::read(&at(folder)).unwrap();
        assert_eq!(
            cases.iter().map(Case::name).collect::<Vec<_>>(),
            ["bench"],
            "{folder}"
        );
    }
    let none = case::read(&at("plans")).unwrap_err().to_string();
    assert!(none.contains("contains a case.toml"), "{none}");
    let none = case::read(&at("no-such-folder")).unwrap_err().to_string();
    assert!(none.contains("no-such-folder"), "{none}");
}

#[test]
fn a_fit_may_change_the_muscle_and_keeps_the_rest() {
    let case = muscle("tondu2012");
    let (plain, gent) = (&case.fits[0].muscle, &case.fits[1].muscle);
    assert_eq!(gent.tube().rubber.law.name(), "gent");
    assert_eq!(
        gent.tube().outer_diameter_mm,
        plain.tube().outer_diameter_mm
    );
    assert_eq!(gent.braid(), plain.braid());
}

#[test]
fn what_is_wrong_is_named() {
    let files = Files::of(&at(BUILT_IN).join("tondu2012")).unwrap();
    let said = |from: &str, to: &str| {
        let case = files.case.replace(from, to);
        assert!(case != files.case, "{from}");
        let files = Files {
            case,
            ..files.clone()
        };
        files.read().unwrap_err().to_string()
    };
    for (from, to, part) in [
        (
            "terms =",
            "term =",
            "unknown field `term`, expected one of `title`",
        ),
        ("\"jm\"", "\"jmm\"", "fit \"Gent\""),
        (
            "free = [\"mu\"]",
            "free = 3",
            "invalid type: integer `3`, expected a sequence",
        ),
        (
            "\"pressure_mpa\"",
            "\"colour\"",
            "unknown variant `colour`, expected one of `length_mm`",
        ),
        (", from = 0.1, to = 0.3", "", "`split` needs `fit_on`"),
        ("law = \"gent\"", "law = \"gant\"", "tondu2012/fit \"Gent\""),
        (
            "_fit = \"Gent, friction",
            "_fit = \"Gont, friction",
            "`library_fit` must be the name of a fit",
        ),
        ("title", "[", "case.toml: TOML parse error at line 1"),
    ] {
        let said = said(from, to);
        assert!(said.contains(part), "{said}");
    }
}

fn saved_and_read(case: &MuscleCase) -> (MuscleCase, usize) {
    let fit = &case.fits[case.library_fit];
    let identified = case.identified.as_ref().map(to_toml).unwrap_or_default();
    let targets: Vec<Target> = fit.free.iter().map(|p| p.target).collect();
    let files = measured_files(&SavedMuscle {
        muscle: &fit.muscle,
        points: &case.points,
        origin: "a, table\n.csv",
        free: &targets,
        fixed: &[],
        both_branches: fit.both_branches,
        identified: &identified,
    });
    let text = |name: &str| {
        let file = files.iter().find(|file| file.0 == name);
        file.map(|file| file.1.clone()).unwrap_or_default()
    };
    let folder = Files {
        name: case.name.clone(),
        case: text("case.toml"),
        muscle: text("muscle.toml"),
        points: text("points.csv"),
        identified: text("identified.toml"),
    };
    let Case::Muscle(read) = folder.read().unwrap() else {
        panic!("{folder:?}")
    };
    (*read, files.len())
}

/// An identity: points, muscle, fit and identified muscle come back as they were.
#[test]
fn every_muscle_that_is_saved_is_read_as_it_was() {
    for case in muscles() {
        let name = &case.name;
        let (read, files) = saved_and_read(case);
        let without_line = |points: &[DataPoint]| -> Vec<DataPoint> {
            points.iter().map(|p| DataPoint { line: 0, ..*p }).collect()
        };
        assert_eq!(
            without_line(&read.points),
            without_line(&case.points),
            "{name}"
        );
        let (fit, was) = (&read.fits[0], &case.fits[case.library_fit]);
        assert_eq!(fit.muscle, was.muscle, "{name}");
        let names = |fit: &CaseFit| Vec::from_iter(fit.free.iter().map(|p| p.target));
        assert_eq!(names(fit), names(was), "{name}");
        assert_eq!(fit.both_branches, was.both_branches, "{name}");
        assert_eq!(read.identified, case.identified, "{name}");
        assert_eq!(files, 5);
    }
}

/// Without `free` nothing is refused, though `identified.toml` is there.
#[test]
fn a_muscle_whose_constants_were_all_free_is_read_as_it_was() {
    let mut case = muscle("tondu2012").clone();
    let fit = case.library_fit;
    case.fits[fit].free.clear();
    let (read, _) = saved_and_read(&case);
    assert!(read.fits[0].free.is_empty() && case.identified.is_some());
    assert_eq!(read.identified, case.identified);
    assert!(read.facts.source.starts_with("TO FILL IN"));
}

#[test]
fn a_text_stands_between_its_marks() {
    let page = "a\n<!-- study one -->\nold\n<!-- end -->\nb\n";
    let made = with_texts(page, &[("one", "new\n".into()), ("two", "no".into())]).unwrap();
    assert_eq!(made, "a\n<!-- study one -->\n\nnew\n\n<!-- end -->\nb\n");
    let again = with_texts(&made, &[("one", "new\n".into())]).unwrap();
    assert_eq!(again, made);
    assert!(with_texts("<!-- study one -->\n", &[("one", "".into())]).is_err());
}
