//! What the templates of all languages have in common.

use crate::muscle::ExportedMuscle;
use crate::template::number;

/// The values that templates of all languages have places for.
pub(super) fn common(muscle: &ExportedMuscle) -> Vec<(&'static str, String)> {
    let form = &muscle.form;
    vec![
        ("name", crate::muscle::plain(&muscle.name)),
        ("version", muscle.version.into()),
        ("length", number(form.length_m)),
        ("supply", number(form.supply_pa)),
    ]
}
