//! Colours of models in figures.

use mckibben_app::{Model, model_colour};

/// Colours of lines in a figure; the next number is the grey of measured points.
const COLOURS: usize = 6;

#[test]
fn a_model_has_one_colour_whatever_it_is_compared_with_and_none_that_of_points() {
    let mut formulas = vec![];
    assert_eq!(
        ["fe", "universal", "fe3d"].map(|name| model_colour(name, &mut formulas)),
        [0, 1, 4]
    );
    let listed = Model::all()
        .into_iter()
        .map(|entry| entry.name)
        .chain(["mine", "other", "mine"]);
    let mut all: Vec<usize> = listed
        .map(|name| model_colour(name, &mut formulas))
        .collect();
    assert_eq!(all.pop(), all.get(all.len() - 2).copied());
    all.sort_unstable();
    let count = all.len();
    all.dedup();
    assert!(all.len() == count && all.iter().all(|n| n % (COLOURS + 1) != COLOURS));
}
