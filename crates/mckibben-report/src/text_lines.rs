//! Lines on a grid of character cells: dots, letters and texts set into them.

use crate::curve::Spot;

/// Cells of a line that are looked at for texts.
const LONGEST: usize = 50_000;

/// What the cells of a plot hold. A cell is two dots wide and four dots high.
pub(crate) struct Cells {
    cols: usize,
    rows: usize,
    /// One bit for each series with dots in the cell.
    owners: Vec<u64>,
    taken: Vec<bool>,
}

impl Cells {
    pub fn new(cols: usize, rows: usize) -> Self {
        Self { cols, rows, owners: vec![0; cols * rows], taken: vec![false; cols * rows] }
    }

    /// Column and row of a dot.
    pub fn place(&self, (x, y): Spot) -> (usize, usize) {
        let cell = |v: f64, side: usize, last: usize| (v.round().max(0.0) as usize / side).min(last - 1);
        (cell(x, 2, self.cols), cell(y, 4, self.rows))
    }

    /// Notes a dot of a series.
    pub fn own(&mut self, dot: Spot, series: usize) {
        let (col, row) = self.place(dot);
        self.owners[row * self.cols + col] |= 1 << (series % 64);
    }

    /// Notes that cells carry a character now.
    pub fn take(&mut self, col: usize, row: usize, count: usize) {
        for c in col..(col + count).min(self.cols) {
            self.taken[row * self.cols + c] = true;
        }
    }

    /// Whether cells carry nothing but dots of this series.
    fn free(&self, col: usize, row: usize, count: usize, series: usize) -> bool {
        let own = 1_u64 << (series % 64);
        row < self.rows
            && col + count <= self.cols
            && (col..col + count).all(|c| {
                let i = row * self.cols + c;
                !self.taken[i] && self.owners[i] & !own == 0
            })
    }
}

/// Hands out the dots of a line in steps of half a dot; dashes are in dots.
pub(crate) fn dots(line: &[Spot], dash: &[f64], mut give: impl FnMut(Spot)) {
    let period: f64 = dash.iter().sum();
    let drawn = |way: f64| {
        let mut left = if period > 0.0 { way % period } else { return true };
        for (i, part) in dash.iter().enumerate() {
            if left < *part {
                return i % 2 == 0;
            }
            left -= part;
        }
        true
    };
    if let [only] = line {
        give(*only);
    }
    let mut way = 0.0;
    for pair in line.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let length = (b.0 - a.0).hypot(b.1 - a.1);
        let steps = (2.0 * length).ceil().max(1.0);
        for i in 0..=steps as usize {
            let t = i as f64 / steps;
            if drawn(way + t * length) {
                give((a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1)));
            }
        }
        way += length;
    }
}

/// The cells a line runs through, in its order.
fn path(line: &[Spot], cells: &Cells) -> Vec<(usize, usize)> {
    let mut path = Vec::new();
    dots(line, &[], |dot| {
        let cell = cells.place(dot);
        if path.len() < LONGEST && path.last() != Some(&cell) {
            path.push(cell);
        }
    });
    path
}

/// A place on a line, as near to its end as there is one, where a text covers no other
/// line; takes the cells.
pub(crate) fn set_in(line: &[Spot], series: usize, long: usize, cells: &mut Cells) -> Option<(usize, usize)> {
    let path = path(line, cells);
    // lines above and below make the text ambiguous: first with air there, then without
    for air in [1, 0] {
        for (col, row) in path.iter().rev() {
            // over the line, or just right of it where it is steep
            for start in [col.saturating_sub(long / 2), col + 1] {
                let from = start.saturating_sub(1);
                let count = long + (start - from) + 1;
                let rows = row.saturating_sub(air)..=(row + air).min(cells.rows - 1);
                if rows.clone().all(|r| cells.free(from, r, count, series)) {
                    cells.take(start, *row, long);
                    return Some((start, *row));
                }
            }
        }
    }
    None
}

/// Places for the letters of a line: about one for 20 cells of its way, each line at
/// another phase so that letters of neighbours do not stand on top of each other.
pub(crate) fn letters(
    line: &[Spot],
    series: usize,
    key: usize,
    keys: usize,
    cells: &mut Cells,
) -> Vec<(usize, usize)> {
    let path = path(line, cells);
    let count = (path.len() / 20).clamp(1, 6);
    let phase = (key as f64 + 0.5) / keys.max(1) as f64;
    let mut found = Vec::new();
    for k in 0..count {
        let wanted = ((k as f64 + phase) / count as f64 * path.len() as f64) as usize;
        let reach = (path.len() / count / 2).max(1);
        let nearby = (0..reach).flat_map(|d| [wanted.checked_sub(d), wanted.checked_add(d)]).flatten();
        let clear = nearby
            .clone()
            .filter_map(|i| path.get(i).copied())
            .find(|(col, row)| cells.free(*col, *row, 1, series));
        // on a stretch shared by several lines a letter at least says who is there
        let any = || {
            nearby
                .filter_map(|i| path.get(i).copied())
                .find(|(col, row)| !cells.taken[row * cells.cols + col])
        };
        if let Some((col, row)) = clear.or_else(any) {
            cells.take(col, row, 1);
            found.push((col, row));
        }
    }
    found
}
