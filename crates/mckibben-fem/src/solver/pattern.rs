//! Where the entries of a sparse symmetric matrix stand.

/// The lower half of a symmetric matrix by columns: where entries stand.
#[derive(Debug, Clone)]
pub struct Pattern {
    /// First entry of each column, and the number of all.
    pub columns: Vec<u32>,
    /// Row of each entry, rising in each column; the first one is the diagonal.
    pub rows: Vec<u32>,
}

impl Pattern {
    /// Number of unknowns.
    pub fn dimension(&self) -> usize {
        self.columns.len().saturating_sub(1)
    }

    /// Entries of the lower half.
    pub fn entries(&self) -> usize {
        self.rows.len()
    }

    /// Where entry (`row`, `column`) of the lower half stands.
    pub fn position(&self, row: u32, column: u32) -> Option<u32> {
        let start = *self.columns.get(column as usize)?;
        let end = *self.columns.get(column as usize + 1)?;
        let all = self.rows.get(start as usize..end as usize)?;
        all.binary_search(&row).ok().map(|i| start + i as u32)
    }
}
