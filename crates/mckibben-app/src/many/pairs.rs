//! Pairs of numbers, wherever they lie.

use crate::problem::{Problem, ProblemKind};

/// Writes out pairs from a place on, so many as the two lists are long.
type Read<'a> = dyn Fn(usize, &mut [f64], &mut [f64]) + Sync + 'a;

/// Pairs of numbers that a model is asked for.
pub enum Pairs<'a> {
    /// Two lists of one length.
    Lists([&'a [f64]; 2]),
    /// So many pairs that a function writes out, from a place on, so many as the two lists that it gets are long: of arrays that
    /// are spread over a grid, so that the grid never is in memory.
    Read(usize, &'a Read<'a>),
}

impl std::fmt::Debug for Pairs<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Pairs({:?})", self.count())
    }
}

impl Pairs<'_> {
    pub fn count(&self) -> Result<usize, Problem> {
        match self {
            Self::Lists([a, b]) if a.len() != b.len() => {
                let message = format!(
                    "the two lists must have the same length; they have {} and {} numbers",
                    a.len(),
                    b.len()
                );
                Err(Problem::new(ProblemKind::Usage, message, ""))
            }
            Self::Lists([a, _]) => Ok(a.len()),
            Self::Read(count, _) => Ok(*count),
        }
    }

    /// Some of the pairs as two lists: as they lie, or written into `room`, which is used again for the next.
    pub(super) fn block<'b>(
        &'b self,
        from: usize,
        count: usize,
        room: &'b mut [Vec<f64>; 2],
    ) -> [&'b [f64]; 2] {
        match self {
            Self::Lists(lists) => lists.map(|l| l.get(from..from + count).unwrap_or_default()),
            Self::Read(_, read) => {
                let [a, b] = room;
                a.resize(count, 0.0);
                b.resize(count, 0.0);
                read(from, a, b);
                [a, b]
            }
        }
    }
}
