//! Muscles from a table of one's own, in place of `[sampling]` and `[vary]`: a line each.

use super::axis::{Axis, CONSTANT, RUBBER, variables};
use mckibben_core::{
    muscle::Measure,
    units::{Dimension, Values, parse_quantity},
};
use mckibben_io::table::{Sheet, TableError};

/// What a table says: axes, and the values of each, muscle by muscle.
pub struct OwnSamples {
    pub axes: Vec<Axis>,
    pub values: Vec<Vec<f64>>,
    pub muscles: u64,
}

/// Reads a table whose headings are keys of `[vary]`, with their unit in brackets, or columns of a
/// campaign's table: `tube.outer_diameter [in]`, `wall_mm`, `c10_mpa`, `tube.rubber`.
///
/// # Errors
/// [`TableError`] with the column that is not known, or the line of a field that is no number.
pub fn read(text: &str) -> Result<OwnSamples, TableError> {
    let rows = Sheet::split(text)?.rows;
    let (heading, rows) = match &rows[..] {
        [heading, rows @ ..] if !rows.is_empty() => (heading, rows),
        _ => return Err(TableError::empty()),
    };
    let (mut axes, mut all): (Vec<Axis>, Vec<Vec<f64>>) = (vec![], vec![]);
    for (i, heading) in heading.fields().enumerate() {
        let (name, unit) = heading.split_once('[').unwrap_or((heading, ""));
        let (name, unit) = (name.trim(), unit.trim_end_matches(']'));
        let (key, dimension) = known(name).ok_or_else(|| unknown(heading))?;
        if axes.iter().any(|axis| axis.key == key) {
            return Err(TableError::Refused(format!("{key} stands twice")));
        }
        let fields = rows.iter().map(|row| (row.line, row.field(i)));
        if key == RUBBER {
            let mut names: Vec<String> = vec![];
            let number = |(_, name): (u64, &str)| {
                let known = names.iter().position(|known| known == name);
                known.unwrap_or_else(|| {
                    names.push(name.to_owned());
                    names.len() - 1
                }) as f64
            };
            all.push(fields.map(number).collect());
            axes.push(Axis::of_rubbers(names));
            continue;
        }
        let number = |(line, field): (u64, &str)| {
            let is_bare = field.parse::<f64>().is_ok();
            let with_unit = format!("{field} {}", if is_bare { unit } else { "" });
            parse_quantity(with_unit.trim(), dimension)
                .map_err(|e| TableError::Refused(format!("line {line}, column {heading}: {e}")))
        };
        let values = fields.map(number).collect::<Result<Vec<f64>, _>>()?;
        let mut levels = values.clone();
        levels.sort_by(f64::total_cmp);
        levels.dedup();
        axes.push(Axis {
            key,
            values: Values::List(levels),
            log: false,
            names: vec![],
        });
        all.push(values);
    }
    Ok(OwnSamples {
        axes,
        values: all,
        muscles: rows.len() as u64,
    })
}

/// The key that a name means, and what it measures.
fn known(name: &str) -> Option<(String, Dimension)> {
    if name == RUBBER {
        return Some((RUBBER.into(), Dimension::Ratio));
    }
    let is_named = |key: &str| {
        let field = Measure::of_key(key).and_then(|measure| measure.field);
        key == name
            || field == Some(name)
            || key.strip_prefix(CONSTANT) == Some(name.trim_end_matches("_mpa"))
            || (key, name) == ("braid.stiffness", "braid_stiffness_n_per_mm")
    };
    let variable = variables().into_iter().find(|v| is_named(&v.key))?;
    Some((variable.key, variable.dimension))
}

fn unknown(heading: &str) -> TableError {
    TableError::Refused(format!(
        "column {heading:.60}: no measure of a muscle; expected a key of [vary] with its unit, such \
         as \"tube.outer_diameter [mm]\", or a column of a campaign's table"
    ))
}
