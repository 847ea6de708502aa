//! An answer as a page of lines, rows and tables.

use super::{Column, Rows, Table};

/// A part of a page.
#[derive(Debug)]
pub enum Block {
    /// One line or several.
    Text(String),
    /// Labels with their values.
    Rows(Rows),
    /// Columns of equal length.
    Table(Vec<Column>),
}

/// What people read of an answer, from top to bottom.
#[derive(Debug, Default)]
pub struct Page {
    /// From top to bottom.
    pub blocks: Vec<Block>,
}

impl Page {
    /// Adds a line of text.
    pub fn line(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Text(text.into()));
    }

    /// Adds lines of text.
    pub fn lines(&mut self, list: impl IntoIterator<Item = String>) {
        list.into_iter().for_each(|text| self.line(text));
    }

    /// A line behind an empty one, unless nothing is before it.
    pub fn paragraph(&mut self, text: impl Into<String>) {
        self.gap();
        self.line(text);
    }

    /// An empty line, unless nothing is before it.
    pub fn gap(&mut self) {
        if !self.blocks.is_empty() {
            self.line("");
        }
    }

    /// Adds labels with their values; nothing where there are none.
    pub fn rows(&mut self, rows: Rows) {
        if !rows.is_empty() {
            self.blocks.push(Block::Rows(rows));
        }
    }

    /// A table; nothing where it has no lines.
    pub fn table<T>(&mut self, table: Table<'_, T>) {
        if !table.is_empty() {
            self.blocks.push(Block::Table(table.columns));
        }
    }

    /// A table with its heading; nothing where it has no lines.
    pub fn table_under<T>(&mut self, heading: &str, table: Table<'_, T>) {
        if !table.is_empty() {
            self.paragraph(heading);
            self.table(table);
        }
    }

    /// Adds another page below.
    pub fn and(&mut self, other: Self) {
        self.blocks.extend(other.blocks);
    }
}

impl From<Rows> for Page {
    fn from(rows: Rows) -> Self {
        Self {
            blocks: vec![Block::Rows(rows)],
        }
    }
}
