//! Clamps of tube and sleeve on a plug.

use std::f64::consts::PI;

/// Ties with their least loop strength (QB/T 4494-2013). The stems are a choice: a narrow tie bends
/// to a small circle more evenly.
const TIES: [Tie; 4] = [
    Tie {
        width_mm: 2.5,
        strength_n: 80.0,
        stem_mm: 6.0,
    },
    Tie {
        width_mm: 3.6,
        strength_n: 130.0,
        stem_mm: 15.0,
    },
    Tie {
        width_mm: 4.8,
        strength_n: 180.0,
        stem_mm: 40.0,
    },
    Tie {
        width_mm: 7.6,
        strength_n: 450.0,
        stem_mm: f64::INFINITY,
    },
];
/// A tie that is tightened by hand has this share of its strength (a choice).
const TIGHTENED: f64 = 1.0 / 3.0;
/// Friction of a sleeve on a tube under a tie (an estimate).
const FRICTION: f64 = 0.3;

#[derive(Clone, Copy)]
pub struct Tie {
    /// Width in mm.
    pub width_mm: f64,
    /// Least loop strength in N.
    strength_n: f64,
    /// Largest diameter of a stem in mm.
    stem_mm: f64,
}

impl Tie {
    /// The tie for a stem of this diameter in mm.
    pub fn around(stem_mm: f64) -> Self {
        TIES.into_iter()
            .find(|tie| stem_mm <= tie.stem_mm)
            .unwrap_or(TIES[TIES.len() - 1])
    }

    /// Its holding force in N by friction, by estimate.
    pub fn holds_n(self) -> f64 {
        2.0 * PI * FRICTION * TIGHTENED * self.strength_n
    }
}

/// The clamps of tube and sleeve on a plug.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Clamps {
    Ties {
        /// Width in mm.
        width_mm: f64,
        at_each_end: usize,
    },
    /// Ties would not hold.
    Crimped,
}

impl Clamps {
    /// One tie in each groove, where that holds the load in N; else a crimp.
    pub(crate) fn for_load(tie: Tie, grooves: usize, load_n: f64) -> Self {
        match grooves {
            n @ 1.. if n as f64 * tie.holds_n() >= load_n => Self::Ties {
                width_mm: tie.width_mm,
                at_each_end: n,
            },
            _ => Self::Crimped,
        }
    }

    pub(crate) fn amount(&self) -> String {
        match self {
            Self::Ties { at_each_end, .. } => (2 * at_each_end).to_string(),
            Self::Crimped => "2".into(),
        }
    }
}
