//! Section 3.3.1 of the paper on a, b and c: whether they rise or fall with P and with s.
//!
//!   D0 35–50: a rises with P and with s; below 35 "opposite". b falls with P and with s. c rises with P and falls with s.

use mckibben_campaign::fit::{
    PaperMethod,
    data::{Grid, same},
    paper_method,
    paper_method::is_left_out,
};
use mckibben_core::muscle::Muscle;
use std::cmp::Ordering;

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
        let curves = || {
            method
                .curves
                .iter()
                .filter(|c| same(c.outer_diameter_mm, d))
        };
        for (k, coefficient) in ["a", "b", "c"].into_iter().enumerate() {
            for with in ["P", "s"] {
                let mut values = vec![];
                for c in curves() {
                    let (s, p) = (c.wall_mm, c.pressure_mpa);
                    let at = if with == "P" { [s, p] } else { [p, s] };
                    values.push((at, c.abc.coefficients[k]));
                }
                values.sort_by(|a, b| a.0.partial_cmp(&b.0).unwrap_or(Ordering::Equal));
                let rises = coefficient == "a" && d >= 35.0 || (coefficient, with) == ("c", "P");
                let pairs = values
                    .windows(2)
                    .filter(|pair| same(pair[0].0[0], pair[1].0[0]));
                let holds = |pair: &&[([f64; 2], f64)]| (pair[1].1 > pair[0].1) == rises;
                out.push(Sign {
                    outer_diameter_mm: d,
                    coefficient,
                    with,
                    rises,
                    holding: pairs.clone().filter(holds).count(),
                    pairs: pairs.count(),
                });
            }
        }
    }
    out
}

/// Pairs of neighbouring curves with the stated sign, of all (section 3.3.1 of docs/paper.md).
#[test]
fn the_stated_signs_hold_as_often_as_the_book_says() {
    let mut points = Grid::PAPER.points(&Muscle::prototype());
    points.retain(|p| !is_left_out(p));
    let found = signs(&paper_method(&points).unwrap());
    let count = |d: f64, coefficient: &str, with: &str| {
        let is_it = |s: &&Sign| {
            same(s.outer_diameter_mm, d) && (s.coefficient, s.with) == (coefficient, with)
        };
        let sign = found.iter().find(is_it).unwrap();
        (sign.holding, sign.pairs)
    };
    let a_with_p = [30.0, 40.0, 45.0, 50.0].map(|d| count(d, "a", "P"));
    assert_eq!(a_with_p, [(7, 18), (17, 20), (19, 20), (20, 20)]);
    assert_eq!(count(30.0, "a", "s").0, 0);
    for sign in found.iter().filter(|s| s.coefficient != "a") {
        assert!(sign.holds(), "{sign:?}");
    }
}
