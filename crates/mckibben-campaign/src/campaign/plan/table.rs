//! Muscles from a table of one's own, in place of `[sampling]` and `[vary]`: a line each.

use super::axis::{Axis, CONSTANT, RUBBER, variables};
use mckibben_core::{
    muscle::Measure,
    rubber::Law,
    units::{Dimension, Values},
};
use mckibben_io::table::{FreeTable, TableError};

/// What a table says: axes, and the values of each, muscle by muscle.
pub struct OwnSamples {
    pub axes: Vec<Axis>,
    pub values: Vec<Vec<f64>>,
    pub muscles: u64,
}

/// A column that was recognised.
struct Named {
    key: String,
    /// What its heading begins with.
    name: String,
    dimension: Dimension,
}

/// Reads a table whose headings are keys of `[vary]` or columns of a campaign's table, with their
/// units: `tube.outer_diameter [mm]`, `wall_mm`, `c10_mpa`, `tube.rubber`.
///
/// # Errors
/// [`TableError`] with the column that is not known, or the field that is no number.
pub fn read(text: &str) -> Result<OwnSamples, TableError> {
    let table = FreeTable::read(text)?;
    let known = known();
    let (mut axes, mut all): (Vec<Axis>, Vec<Vec<f64>>) = (vec![], vec![]);
    for (column, heading) in table.headings.iter().enumerate() {
        let named = known
            .iter()
            .find(|n| FreeTable::is_named(heading, &n.name, n.dimension))
            .ok_or_else(|| unknown(heading))?;
        if axes.iter().any(|axis| axis.key == named.key) {
            return Err(TableError::Refused(format!("{} stands twice", named.key)));
        }
        if named.key == RUBBER {
            let mut names: Vec<String> = vec![];
            let number = |name: &str| match names.iter().position(|n| n == name) {
                Some(number) => number as f64,
                None => {
                    names.push(name.to_owned());
                    (names.len() - 1) as f64
                }
            };
            all.push(table.texts(column).map(number).collect());
            axes.push(Axis::of_rubbers(names));
            continue;
        }
        let values = table.numbers(column, &named.name, named.dimension)?;
        let mut levels = values.clone();
        levels.sort_by(f64::total_cmp);
        levels.dedup();
        axes.push(Axis {
            key: named.key.clone(),
            values: Values::List(levels),
            log: false,
            names: vec![],
        });
        all.push(values);
    }
    Ok(OwnSamples {
        axes,
        values: all,
        muscles: table.len() as u64,
    })
}

/// Every name that a heading may begin with.
fn known() -> Vec<Named> {
    let mut out = vec![];
    for variable in variables() {
        let columns = column_names(&variable.key);
        let names = columns.into_iter().chain([variable.key.clone()]);
        out.extend(names.map(|name| Named {
            key: variable.key.clone(),
            name,
            dimension: variable.dimension,
        }));
    }
    out.extend([RUBBER, "rubber"].map(|name| Named {
        key: RUBBER.into(),
        name: name.into(),
        dimension: Dimension::Ratio,
    }));
    out
}

/// The columns that a campaign's table has of a key.
fn column_names(key: &str) -> Vec<String> {
    if key == "braid.stiffness" {
        return vec!["braid_stiffness_n_per_mm".into()];
    }
    if let Some(name) = key.strip_prefix(CONSTANT) {
        let constants = Law::KINDS.iter().flat_map(|kind| kind.constants);
        let of_name = constants.filter(|c| c.name == name);
        let column = |modulus: bool| format!("{name}{}", if modulus { "_mpa" } else { "" });
        return of_name.map(|c| column(c.is_modulus())).take(1).collect();
    }
    let field = Measure::of_key(key).and_then(|measure| measure.field);
    field.map(str::to_owned).into_iter().collect()
}

fn unknown(heading: &str) -> TableError {
    TableError::Refused(format!(
        "column {heading:.60}: no measure of a muscle; expected a key of [vary] with its unit, such \
         as \"tube.outer_diameter [mm]\" or \"tube.rubber\", or a column of a campaign's table, such \
         as outer_diameter_mm"
    ))
}
