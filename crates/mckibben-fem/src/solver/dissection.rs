//! Geometric nested dissection of a structured grid (George 1973 \[george1973\]).
//!
//! A box of grid lines is cut by one line across its longer side; the two halves come first, the line last. Only the two
//! longer directions of a tube's wall are cut: what lies through the wall stays together.

/// Grid lines around and along, and how far apart lines are that separate (1 for linear, 2 for quadratic elements).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
        self.cut((0, self.around), (0, self.along), &mut out);
        out
    }

    fn cut(&self, j: (usize, usize), k: (usize, usize), out: &mut Vec<(usize, usize)>) {
        let (nj, nk) = (j.1 - j.0, k.1 - k.0);
        let line = |(low, high): (usize, usize)| {
            let middle = (low + (high - low) / 2) / self.stride * self.stride;
            (middle > low && middle + 1 < high).then_some(middle)
        };
        let leaf = LEAF * self.stride;
        if nj.max(nk) > leaf {
            let first_along = nk >= nj;
            for along in [first_along, !first_along] {
                if let Some(m) = line(if along { k } else { j }) {
                    if along {
                        self.cut(j, (k.0, m), out);
                        self.cut(j, (m + 1, k.1), out);
                        out.extend((j.0..j.1).map(|a| (a, m)));
                    } else {
                        self.cut((j.0, m), k, out);
                        self.cut((m + 1, j.1), k, out);
                        out.extend((k.0..k.1).map(|b| (m, b)));
                    }
                    return;
                }
            }
        }
        for b in k.0..k.1 {
            out.extend((j.0..j.1).map(|a| (a, b)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_comes_once() {
        for (around, along, stride) in [(1, 1, 1), (13, 39, 1), (25, 78, 2), (2, 100, 1), (3, 7, 2)] {
            let mut all = Sheet { around, along, stride }.order();
            assert_eq!(all.len(), around * along);
            all.sort_unstable();
            all.dedup();
            assert_eq!(all.len(), around * along);
        }
    }
}
