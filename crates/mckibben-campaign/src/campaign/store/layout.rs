//! Which columns a table has.

use crate::{
    campaign::plan::Plan,
    columns::{COLUMNS, Column, PointRow, Role, Slot},
};
use mckibben_io::parquet::{Column as Values, Packing};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Which columns a table has.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Layout {
    /// Constants of the law: `c10_mpa`.
    pub constants: Vec<String>,
    /// Other measures that vary: `seating_mm`.
    pub measures: Vec<String>,
    /// Keys of the sensitivities: `tube.material.c10`.
    pub sensitivities: Vec<String>,
}

/// One column of a layout.
#[derive(Debug, Clone)]
pub struct Field {
    pub name: String,
    pub column: &'static Column,
    /// Its key in a group.
    pub key: String,
}

impl Field {
    pub fn slot<'a>(&self, row: &'a mut PointRow) -> Slot<'a> {
        (self.column.slot)(row)
    }

    /// An empty column of its kind.
    pub fn kind(&self) -> Values {
        match self.slot(&mut PointRow::default()) {
            Slot::Whole(_) => Values::Int64(vec![]),
            Slot::Count(_) => Values::Int32(vec![]),
            Slot::Number(_) | Slot::Measures(_) => Values::Double(vec![]),
            Slot::Optional(_) | Slot::Constants(_) | Slot::Sensitivities(_) => {
                Values::Optional(vec![])
            }
            Slot::Flag(_) => Values::Flag(vec![]),
            Slot::Text(_) | Slot::Status(_) => Values::Text(vec![]),
        }
    }

    /// Its column in a file: inputs repeat few values, and answers differ.
    pub fn parquet(&self) -> mckibben_io::parquet::Field {
        let packing = if self.column.role == Role::Answer {
            Packing::Distinct
        } else {
            Packing::Repeated
        };
        mckibben_io::parquet::Field {
            name: self.name.clone(),
            kind: self.kind(),
            packing,
        }
    }

    /// Its value in one of the lists of a row.
    pub fn value_in(&self, list: &[(String, f64)]) -> Option<f64> {
        list.iter()
            .find(|(key, _)| *key == self.key)
            .map(|(_, value)| *value)
    }

    /// The number that a row has in it; of groups, the constants alone.
    pub fn number(&self, row: &mut PointRow) -> Option<f64> {
        match self.slot(row) {
            Slot::Number(v) => Some(*v),
            Slot::Optional(v) => *v,
            Slot::Constants(list) | Slot::Measures(list) => self.value_in(list),
            _ => None,
        }
    }
}

impl Layout {
    /// The columns of a plan's table.
    pub fn for_plan(plan: &Plan) -> Self {
        Self {
            constants: plan.constants(),
            measures: plan.measures(),
            sensitivities: plan.sensitivities(),
        }
    }

    pub fn fields(&self) -> Arc<[Field]> {
        let columns = |column: &'static Column| {
            let alone = [column.name.to_owned()];
            let (keys, before) = match (column.slot)(&mut PointRow::default()) {
                Slot::Constants(_) => (&self.constants[..], ""),
                Slot::Measures(_) => (&self.measures[..], ""),
                Slot::Sensitivities(_) => (&self.sensitivities[..], "d_force_d_"),
                _ => (&alone[..], ""),
            };
            let name = |key: &String| format!("{before}{}", key.replace('.', "_"));
            keys.iter()
                .map(|k| Field {
                    name: name(k),
                    column,
                    key: k.clone(),
                })
                .collect::<Vec<_>>()
        };
        COLUMNS.iter().flat_map(columns).collect()
    }
}
