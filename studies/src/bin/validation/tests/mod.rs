//! Tests of the study, on the cases that the program carries.

mod by_elements;
mod cases;
mod chosen;
mod fits;
mod interval;
mod promised;

use crate::case::{self, BUILT_IN, Case, MuscleCase, RubberCase};
use std::{path::PathBuf, sync::LazyLock};

/// A file or folder of the repository.
fn at(path: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("..")
        .join(path)
}

static ALL: LazyLock<Vec<Case>> = LazyLock::new(|| case::read(&at(BUILT_IN)).unwrap());

fn muscles() -> Vec<&'static MuscleCase> {
    crate::muscles(&ALL)
}

fn muscle(name: &str) -> &'static MuscleCase {
    muscles()
        .into_iter()
        .find(|case| case.name == name)
        .unwrap()
}

fn rubbers() -> impl Iterator<Item = &'static RubberCase> {
    ALL.iter().filter_map(|case| match case {
        Case::Rubber(case) => Some(&**case),
        Case::Muscle(_) => None,
    })
}
