//! Geometric nested dissection of a structured grid (George 1973 \[george1973\]).
//!
//! A box of grid lines is cut by one line across its longer side; the two halves come first, the
//! line last. Only the two longer directions of a tube's wall are cut: what lies through the wall
//! stays together.

use std::ops::Range;

/// Grid lines around and along, and how far apart lines are that separate (1 for linear, 2 for
/// quadratic elements).
#[derive(Debug)]
pub struct Sheet {
    /// Lines around.
    pub around: usize,
    /// Lines along.
    pub along: usize,
    /// Every how many lines one separates.
    pub stride: usize,
}

/// Boxes with no more lines than this each way are not cut.
const LEAF: usize = 3;

impl Sheet {
    /// The order of elimination of the sheet's points (around, along).
    pub fn order(&self) -> Vec<(usize, usize)> {
        let mut out = Vec::with_capacity(self.around * self.along);
        self.cut_box((0..self.around, 0..self.along), &mut out);
        out
    }

    fn cut_box(&self, (mut j, mut k): (Range<usize>, Range<usize>), out: &mut Vec<(usize, usize)>) {
        let line = |lines: &Range<usize>| {
            let middle = (lines.start + lines.len() / 2) / self.stride * self.stride;
            (middle > lines.start && middle + 1 < lines.end).then_some(middle)
        };
        if j.len().max(k.len()) > LEAF * self.stride {
            let across = |j: &Range<usize>| line(j).map(|m| (m, false));
            let along = |k: &Range<usize>| line(k).map(|m| (m, true));
            let longer = k.len() >= j.len();
            let cut = if longer {
                along(&k).or_else(|| across(&j))
            } else {
                across(&j).or_else(|| along(&k))
            };
            if let Some((m, along)) = cut {
                let all = if along { &mut k } else { &mut j };
                let halves = [all.start..m, m + 1..all.end];
                *all = m..m + 1;
                for half in halves {
                    self.cut_box(
                        if along {
                            (j.clone(), half)
                        } else {
                            (half, k.clone())
                        },
                        out,
                    );
                }
            }
        }
        for b in k {
            out.extend(j.clone().map(|a| (a, b)));
        }
    }
}
