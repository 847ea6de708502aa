//! Section 3.3.1 of the paper on a, b and c: whether they rise or fall with P and with s.
//!
//!   D0 35–50: a rises with P and with s; below 35 "opposite". b falls with P and with s. c rises with P and falls with s.

use super::{data::same, paper_method::PaperMethod};

/// One statement for one diameter, against the coefficients of steps 1–2.
#[derive(Debug, Clone, PartialEq)]
pub struct Sign {
    /// D0 in mm.
    pub outer_diameter_mm: f64,
    /// `a`, `b` or `c`.
    pub coefficient: &'static str,
    /// `P` or `s`.
    pub with: &'static str,
    /// The statement of the paper.
    pub rises: bool,
    /// Neighbouring pairs of curves of which it holds.
    pub holding: usize,
    pub pairs: usize,
}

impl Sign {
    /// Whether it holds for every pair.
    pub fn holds(&self) -> bool {
        self.holding == self.pairs
    }
}

/// The six statements for every diameter.
pub fn signs(method: &PaperMethod) -> Vec<Sign> {
    let mut out = vec![];
    for wall in &method.walls {
        let d = wall.outer_diameter_mm;
        let curves: Vec<_> = method
            .curves
            .iter()
            .filter(|c| same(c.outer_diameter_mm, d))
            .filter_map(|c| c.abc.map(|f| (c.wall_mm, c.pressure_mpa, f.coefficients)))
            .collect();
        for (k, coefficient) in ["a", "b", "c"].into_iter().enumerate() {
            for with in ["P", "s"] {
                let rises = coefficient == "a" && d >= 35.0 || (coefficient, with) == ("c", "P");
                let key =
                    |c: &(f64, f64, [f64; 3])| if with == "P" { (c.0, c.1) } else { (c.1, c.0) };
                let mut holding = 0;
                let mut pairs = 0;
                for a in &curves {
                    let (fixed, from) = key(a);
                    let next = curves
                        .iter()
                        .filter(|b| {
                            same(key(b).0, fixed) && key(b).1 > from && !same(key(b).1, from)
                        })
                        .min_by(|x, y| key(x).1.total_cmp(&key(y).1));
                    if let Some(b) = next {
                        pairs += 1;
                        holding += usize::from((b.2[k] > a.2[k]) == rises);
                    }
                }
                out.push(Sign {
                    outer_diameter_mm: d,
                    coefficient,
                    with,
                    rises,
                    holding,
                    pairs,
                });
            }
        }
    }
    out
}
