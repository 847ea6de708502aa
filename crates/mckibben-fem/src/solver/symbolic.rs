//! Places of the entries of a Cholesky factor: columns with the same rows below them, side by side,
//! are one supernode.
//!
//! Unknowns are eliminated in the order in which they are numbered. Column j of L has the rows of
//! A's column and those of its children in the elimination tree (Liu 1990 \[liu1990\]),
//!
//! ```text
//! struct(L·j) = struct(A·j) ∪ ⋃ struct(L·c) \ {j} over the children c,   parent(c) = min {i > c : l_ic ≠ 0}
//! ```
//!
//! so that the tree comes out of the same walk. Column j goes on with the supernode of column j − 1
//! where it is the parent of that one alone and brings no other row: a fundamental supernode, whose
//! rows are kept once (Davis 2006 \[davis2006b\]). A supernode and the parent right behind it are
//! merged where few of the entries that result are zeros (Ashcraft & Grimes 1989 \[ashcraft1989\]):
//! wide supernodes are quick, and a child's rows lie within the parent's columns and rows.

use super::kernel::{Matrix, Pivots};
use std::ops::Range;

/// Which share of zeros merged supernodes of at most so many columns may have.
const ZEROS: [(usize, f64); 4] = [(4, 1.0), (16, 0.8), (48, 0.1), (usize::MAX, 0.05)];

/// Numbers that a factor may have: 16 GB.
const MOST: u64 = i32::MAX as u64;

const NONE: u32 = u32::MAX;

/// The two forms of a factorisation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Form {
    /// L Lᵀ.
    Positive,
    /// L D Lᵀ.
    Indefinite,
}

impl Form {
    /// The pivots on the diagonal of a matrix, where there are any.
    pub fn pivots(self, matrix: Matrix<'_>) -> Pivots<'_> {
        (self == Self::Indefinite).then_some(Matrix {
            stride: matrix.stride + 1,
            ..matrix
        })
    }
}

/// The lower half of a symmetric matrix by columns: places of its entries.
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

    /// Places of the entries of a column.
    pub fn column(&self, column: usize) -> Range<usize> {
        self.columns[column] as usize..self.columns[column + 1] as usize
    }

    /// Place of entry (`row`, `column`) of the lower half.
    pub fn position(&self, row: u32, column: u32) -> Option<u32> {
        let all = self.column(column as usize);
        Some((all.start + self.rows[all.clone()].binary_search(&row).ok()?) as u32)
    }
}

/// The supernodes of a pattern. Each is a matrix by columns: the rows of its columns, then those
/// below.
#[derive(Debug)]
pub struct Symbolic {
    /// First column of each supernode, and the number of all columns.
    begin: Vec<u32>,
    /// Where the rows below each begin and the last ones end.
    first_row: Vec<usize>,
    rows: Vec<u32>,
    /// Where the numbers of each begin and the last ones end.
    first_value: Vec<usize>,
    /// Where the earlier supernodes with rows in each begin and the last ones end.
    first_update: Vec<usize>,
    updates: Vec<u32>,
}

impl Symbolic {
    /// The supernodes of a pattern; `None` where there is no memory for them or their numbers.
    pub fn from_pattern(pattern: &Pattern) -> Option<Self> {
        let mut all = Self::fundamental(pattern)?;
        all.merge();
        all.place_values()?;
        all.find_updates();
        Some(all)
    }

    /// Number of supernodes.
    pub fn count(&self) -> usize {
        self.begin.len() - 1
    }

    /// Columns of a supernode.
    pub fn columns(&self, supernode: usize) -> Range<usize> {
        self.begin[supernode] as usize..self.begin[supernode + 1] as usize
    }

    /// Rows below its columns, in rising order.
    pub fn below(&self, supernode: usize) -> &[u32] {
        &self.rows[self.first_row[supernode]..self.first_row[supernode + 1]]
    }

    /// Rows of its matrix.
    pub fn height(&self, supernode: usize) -> usize {
        self.columns(supernode).len() + self.below(supernode).len()
    }

    /// Its numbers among those of the factor.
    pub fn values(&self, supernode: usize) -> Range<usize> {
        self.first_value[supernode]..self.first_value[supernode + 1]
    }

    /// Earlier supernodes with rows in its columns, in rising order.
    pub fn updates(&self, supernode: usize) -> &[u32] {
        &self.updates[self.first_update[supernode]..self.first_update[supernode + 1]]
    }

    /// Numbers of the factor, zeros that pad it included.
    pub fn entries(&self) -> usize {
        self.first_value.last().copied().unwrap_or(0)
    }

    /// The supernodes of a pattern whose columns have the same rows below; none where its numbers
    /// are too many.
    pub fn fundamental(pattern: &Pattern) -> Option<Self> {
        let n = pattern.dimension();
        let mut begin = vec![];
        let mut first_row = vec![0];
        let mut rows = vec![];
        // The last supernode with a row; the children of each column: the last one, and the one
        // before each supernode.
        let mut last_in = vec![NONE; n];
        let mut child = vec![NONE; n];
        let mut sibling = vec![];
        // Rows of the supernode that may go on, and how many of them have become its columns.
        let (mut open, mut passed): (Vec<u32>, usize) = (vec![], 0);
        for j in 0..n {
            let below = pattern.rows[pattern.column(j)]
                .iter()
                .copied()
                .filter(|r| *r as usize > j);
            if let Some(last) = begin.len().checked_sub(1) {
                let parent = open.get(passed).copied();
                let only = parent == Some(j as u32) && child[j] == NONE;
                if only && below.clone().all(|r| last_in[r as usize] == last as u32) {
                    passed += 1;
                    continue;
                }
                rows.try_reserve(open.len() - passed).ok()?;
                rows.extend_from_slice(&open[passed..]);
                first_row.push(rows.len());
                sibling.push(parent.map_or(NONE, |p| {
                    std::mem::replace(&mut child[p as usize], last as u32)
                }));
            }
            let this = begin.len() as u32;
            begin.push(j as u32);
            open = below.collect();
            passed = 0;
            open.iter().for_each(|r| last_in[*r as usize] = this);
            let mut next = child[j];
            while next != NONE {
                let c = next as usize;
                for &r in &rows[first_row[c] + 1..first_row[c + 1]] {
                    if last_in[r as usize] != this {
                        last_in[r as usize] = this;
                        open.push(r);
                    }
                }
                next = sibling[c];
            }
            open.sort_unstable();
        }
        if n > 0 {
            rows.extend_from_slice(&open[passed..]);
            first_row.push(rows.len());
        }
        begin.push(n as u32);
        Some(Self {
            begin,
            first_row,
            rows,
            first_value: vec![],
            first_update: vec![],
            updates: vec![],
        })
    }

    /// Merges supernodes with the parents right behind them.
    fn merge(&mut self) {
        // Number of those that remain; first column, rows and zeros of the last one.
        let mut kept = 0_usize;
        let mut start = 0;
        let mut zeros = 0.0;
        for i in 0..self.count() {
            let columns = self.columns(i);
            let rows = self.first_row[i]..self.first_row[i + 1];
            let together = match kept.checked_sub(1) {
                Some(last) if self.below(last).first() == Some(&self.begin[i]) => {
                    let width = columns.end - start;
                    let new = columns.len() + rows.len() - self.below(last).len();
                    let sum = zeros + new as f64 * (columns.start - start) as f64;
                    let entries = width as f64 * (0.5 * (width + 1) as f64 + rows.len() as f64);
                    let few =
                        |(most, share): &(usize, f64)| *most >= width && share * entries >= sum;
                    (new == 0 || ZEROS.iter().any(few)).then_some(sum)
                }
                _ => None,
            };
            match together {
                Some(sum) => (kept, zeros) = (kept - 1, sum),
                None => (start, zeros) = (columns.start, 0.0),
            }
            let place = self.first_row[kept];
            self.begin[kept] = start as u32;
            self.first_row[kept + 1] = place + rows.len();
            self.rows.copy_within(rows, place);
            kept += 1;
        }
        self.begin[kept] = self.begin[self.begin.len() - 1];
        self.begin.truncate(kept + 1);
        self.first_row.truncate(kept + 1);
        self.rows.truncate(self.first_row[kept]);
        self.rows.shrink_to_fit();
    }

    fn place_values(&mut self) -> Option<()> {
        let mut sum = 0;
        self.first_value.push(0);
        for i in 0..self.count() {
            sum += self.columns(i).len() as u64 * self.height(i) as u64;
            self.first_value
                .push(usize::try_from(sum).ok().filter(|_| sum <= MOST)?);
        }
        Some(())
    }

    fn find_updates(&mut self) {
        let count = self.count();
        let mut owner = vec![0_u32; self.begin[count] as usize];
        for i in 0..count {
            owner[self.columns(i)].fill(i as u32);
        }
        let owner = &owner;
        let this = &*self;
        let targets = |i: usize| {
            let mut before = NONE;
            this.below(i)
                .iter()
                .map(|r| owner[*r as usize])
                .filter(move |o| std::mem::replace(&mut before, *o) != *o)
        };
        let mut first = vec![0; count + 1];
        (0..count)
            .flat_map(targets)
            .for_each(|t| first[t as usize + 1] += 1);
        for i in 0..count {
            first[i + 1] += first[i];
        }
        let mut next = first.clone();
        let mut from = vec![0_u32; first[count]];
        for i in 0..count {
            for t in targets(i) {
                from[next[t as usize]] = i as u32;
                next[t as usize] += 1;
            }
        }
        self.first_update = first;
        self.updates = from;
    }
}
