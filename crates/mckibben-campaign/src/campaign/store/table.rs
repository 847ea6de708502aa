//! Rows as columns in memory.

use super::layout::{Kind, Layout};
use crate::Row;
use parquet::data_type::ByteArray;
use std::sync::Arc;

/// A column.
#[derive(Debug, Clone)]
pub(crate) enum Column {
    Int64(Vec<i64>),
    Int32(Vec<i32>),
    Double(Vec<f64>),
    Optional(Vec<Option<f64>>),
    Text(Vec<ByteArray>),
}

impl Column {
    pub(crate) fn new(kind: Kind) -> Self {
        match kind {
            Kind::Int64 => Self::Int64(vec![]),
            Kind::Int32 => Self::Int32(vec![]),
            Kind::Double => Self::Double(vec![]),
            Kind::Optional => Self::Optional(vec![]),
            Kind::Text => Self::Text(vec![]),
        }
    }

    fn extend(&mut self, other: &Column, from: usize, to: usize) {
        match (self, other) {
            (Self::Int64(a), Self::Int64(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Int32(a), Self::Int32(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Double(a), Self::Double(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Optional(a), Self::Optional(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Text(a), Self::Text(b)) => a.extend_from_slice(&b[from..to]),
            _ => {}
        }
    }

    fn number(&self, i: usize) -> Option<f64> {
        match self {
            Self::Int64(v) => v.get(i).map(|x| *x as f64),
            Self::Int32(v) => v.get(i).map(|x| f64::from(*x)),
            Self::Double(v) => v.get(i).copied(),
            Self::Optional(v) => v.get(i).copied().flatten(),
            Self::Text(_) => None,
        }
    }

    fn text(&self, i: usize) -> &str {
        match self {
            Self::Text(v) => v.get(i).and_then(|t| t.as_utf8().ok()).unwrap_or(""),
            _ => "",
        }
    }
}

/// A value on its way into a column.
enum Cell<'a> {
    Number(Option<f64>),
    Text(&'a str),
}

/// Some rows of a campaign.
#[derive(Debug, Clone)]
pub(crate) struct Table {
    pub(crate) layout: Arc<Layout>,
    pub(crate) columns: Vec<Column>,
    pub(crate) rows: usize,
}

impl Table {
    pub(crate) fn new(layout: &Arc<Layout>) -> Self {
        let columns = layout.columns().into_iter().map(|c| Column::new(c.1)).collect();
        Self { layout: layout.clone(), columns, rows: 0 }
    }

    /// Adds a row; constants and sensitivities stand in the order of the layout, or are looked up.
    pub(crate) fn push(&mut self, row: &Row) {
        let find = |list: &[(String, f64)], at: usize, key: &str| match list.get(at) {
            Some((k, v)) if k == key => Some(*v),
            _ => list.iter().find(|c| c.0 == key).map(|c| c.1),
        };
        let layout = self.layout.clone();
        let number = |v: f64| Cell::Number(Some(v));
        let mut cells = vec![
            number(row.muscle as f64),
            number(row.outer_diameter_mm),
            number(row.wall_mm),
            number(row.length_mm),
            number(row.angle_deg),
            Cell::Text(&row.law),
        ];
        let constants = layout.constants.iter().enumerate();
        cells.extend(constants.map(|(i, k)| Cell::Number(find(&row.constants, i, k))));
        cells.extend(
            [
                row.stiffness_of_braid_n_per_mm,
                Some(row.pressure_mpa),
                Some(row.contraction),
                row.force_n,
                row.volume_mm3,
                row.stiffness_n_per_mm,
                row.force_per_pressure_n_per_mpa,
            ]
            .map(Cell::Number),
        );
        let sensitivities = layout.sensitivities.iter().enumerate();
        cells.extend(sensitivities.map(|(i, k)| Cell::Number(find(&row.sensitivities, i, k))));
        cells.extend([Cell::Text(&row.status), Cell::Text(&row.cause), number(f64::from(row.iterations))]);
        for (column, cell) in self.columns.iter_mut().zip(cells) {
            match (column, cell) {
                (Column::Int64(v), Cell::Number(x)) => v.push(x.unwrap_or(0.0) as i64),
                (Column::Int32(v), Cell::Number(x)) => v.push(x.unwrap_or(0.0) as i32),
                (Column::Double(v), Cell::Number(x)) => v.push(x.unwrap_or(0.0)),
                (Column::Optional(v), Cell::Number(x)) => v.push(x),
                (Column::Text(v), Cell::Text(t)) => v.push(ByteArray::from(t)),
                _ => {}
            }
        }
        self.rows += 1;
    }

    /// Adds rows `from..to` of another table of the same layout.
    pub(crate) fn extend(&mut self, other: &Table, from: usize, to: usize) {
        for (column, more) in self.columns.iter_mut().zip(&other.columns) {
            column.extend(more, from, to);
        }
        self.rows += to - from;
    }

    /// Row `i`.
    pub(crate) fn row(&self, i: usize) -> Row {
        let (c, s) = (self.layout.constants.len(), self.layout.sensitivities.len());
        let option = |at: usize| self.columns.get(at).and_then(|x| x.number(i));
        let number = |at: usize| option(at).unwrap_or(0.0);
        let text = |at: usize| self.columns.get(at).map_or("", |x| x.text(i)).to_owned();
        // Where the columns behind the constants, and those behind the sensitivities, begin.
        let (middle, tail) = (6 + c, 13 + c + s);
        let constants = self.layout.constants.iter().enumerate();
        let sensitivities = self.layout.sensitivities.iter().enumerate();
        Row {
            muscle: number(0) as u64,
            outer_diameter_mm: number(1),
            wall_mm: number(2),
            length_mm: number(3),
            angle_deg: number(4),
            law: text(5),
            constants: constants.map(|(k, name)| (name.clone(), number(6 + k))).collect(),
            stiffness_of_braid_n_per_mm: option(middle),
            pressure_mpa: number(middle + 1),
            contraction: number(middle + 2),
            force_n: option(middle + 3),
            volume_mm3: option(middle + 4),
            stiffness_n_per_mm: option(middle + 5),
            force_per_pressure_n_per_mpa: option(middle + 6),
            sensitivities: sensitivities
                .filter_map(|(k, key)| Some((key.clone(), option(middle + 7 + k)?)))
                .collect(),
            status: text(tail),
            cause: text(tail + 1),
            iterations: number(tail + 2) as u32,
        }
    }
}
