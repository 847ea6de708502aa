//! What a muscle works against: a pull over its shortening, and where both are in balance.
//!
//! A load is a line F(x), x = ε L0 the shortening of the muscle from its length at rest. An
//! equilibrium at a pressure is a contraction with F_muscle(P, ε) = F(ε L0); it is stable where a
//! small step takes the load up faster than the muscle, dF/dx + K > 0 with K = ∂F_muscle/∂L.

mod cycle;
mod equilibrium;
mod fill;
mod lever;
mod parse;
mod table;

pub use cycle::{Cycle, cycle};
pub use equilibrium::{Balance, LoadError};
pub use fill::{Fill, FillError, FillState, Filling};
pub use lever::Lever;
pub use table::LoadTable;

use crate::refused::Refused;

/// Standard gravity in m/s² (CGPM 1901).
pub const GRAVITY_M_PER_S2: f64 = 9.806_65;

/// That a load is invalid.
fn refused(message: String) -> Refused {
    Refused::new(["load"], message)
}

/// A pull in N over the shortening x of the muscle in mm.
///
/// | kind | F(x) | text |
/// |---|---|---|
/// | force | F0 | `300 N` or `force:300N` |
/// | mass that hangs | M g | `20 kg` or `mass:20kg` |
/// | mass on a level track | 0; it counts in motion only | `20 kg@level` |
/// | spring with preload | max(0, F0 + c x) | `12 N/mm@50N` or `spring:12N/mm@50N` |
/// | mass on a lever ([`Lever`]) | M g (a/r) cos(φ0 + x/r) | `lever:5kg@300mm/40mm/-30deg` |
/// | table ([`LoadTable`]) | straight between its points | `table:load.csv` |
/// | several at once | their sum | `mass:5kg+spring:2N/mm` |
///
/// All pull: a spring ends at no force and does not push.
#[derive(Debug, Clone, PartialEq)]
pub enum Load {
    /// A force that stays the same.
    Force {
        /// F0 in N.
        force_n: f64,
    },
    /// A mass.
    Mass {
        /// M in kg.
        mass_kg: f64,
        /// Whether it slides on a level track instead of hanging.
        level: bool,
    },
    /// A spring that is stretched as the muscle shortens.
    Spring {
        /// c in N/mm.
        rate_n_per_mm: f64,
        /// F0 in N, at x = 0.
        preload_n: f64,
    },
    /// A mass on a lever.
    Lever(Lever),
    /// Points of a measured or wanted line.
    Table(LoadTable),
    /// The sum of several.
    Sum(Vec<Load>),
}

impl Load {
    /// F in N at a shortening in mm.
    pub fn force_n(&self, shortening_mm: f64) -> f64 {
        let x = shortening_mm;
        match self {
            Self::Force { force_n } => *force_n,
            Self::Mass { level: true, .. } => 0.0,
            Self::Mass {
                mass_kg,
                level: false,
            } => mass_kg * GRAVITY_M_PER_S2,
            Self::Spring {
                rate_n_per_mm,
                preload_n,
            } => (preload_n + rate_n_per_mm * x).max(0.0),
            Self::Lever(lever) => lever.force_n(x),
            Self::Table(table) => table.force_n(x),
            Self::Sum(loads) => loads.iter().map(|l| l.force_n(x)).sum(),
        }
    }

    /// The same load, so many times as heavy.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        match self {
            Self::Force { force_n } => Self::Force {
                force_n: factor * force_n,
            },
            Self::Mass { mass_kg, level } => Self::Mass {
                mass_kg: factor * mass_kg,
                level: *level,
            },
            Self::Spring {
                rate_n_per_mm,
                preload_n,
            } => Self::Spring {
                rate_n_per_mm: factor * rate_n_per_mm,
                preload_n: factor * preload_n,
            },
            Self::Lever(lever) => Self::Lever(lever.times(factor)),
            Self::Table(table) => Self::Table(table.times(factor)),
            Self::Sum(loads) => Self::Sum(loads.iter().map(|load| load.times(factor)).collect()),
        }
    }

    /// dF/dx in N/mm.
    pub fn slope_n_per_mm(&self, shortening_mm: f64) -> f64 {
        let x = shortening_mm;
        match self {
            Self::Spring {
                rate_n_per_mm: c,
                preload_n: f,
            } if f + c * x > 0.0 => *c,
            Self::Force { .. } | Self::Mass { .. } | Self::Spring { .. } => 0.0,
            Self::Lever(lever) => lever.slope_n_per_mm(x),
            Self::Table(table) => table.slope_n_per_mm(x),
            Self::Sum(loads) => loads.iter().map(|l| l.slope_n_per_mm(x)).sum(),
        }
    }

    /// The work ∫ F dx in J (1 J = 1000 N mm) from the length at rest to a shortening in mm.
    pub fn energy_j(&self, shortening_mm: f64) -> f64 {
        let x = shortening_mm;
        let n_mm = match self {
            Self::Force { force_n } => force_n * x,
            Self::Mass { .. } => self.force_n(0.0) * x,
            Self::Spring {
                rate_n_per_mm: c,
                preload_n: f,
            } => {
                // Of the part in which it pulls.
                let energy = |x: f64| 0.5 * (f + c * x).max(0.0).powi(2) / c;
                if *c > 0.0 {
                    energy(x) - energy(0.0)
                } else {
                    f.max(0.0) * x
                }
            }
            Self::Lever(lever) => lever.energy_n_mm(x),
            Self::Table(table) => table.energy_n_mm(x),
            Self::Sum(loads) => return loads.iter().map(|l| l.energy_j(x)).sum(),
        };
        1e-3 * n_mm
    }

    /// The mass in kg that moves with the muscle's end (a lever's as the muscle feels it, M
    /// (a/r)²); 0 where there is none.
    pub fn moving_mass_kg(&self) -> f64 {
        match self {
            Self::Mass { mass_kg, .. } => *mass_kg,
            Self::Lever(lever) => lever.felt_mass_kg(),
            Self::Sum(loads) => loads.iter().map(Self::moving_mass_kg).sum(),
            Self::Force { .. } | Self::Spring { .. } | Self::Table(_) => 0.0,
        }
    }

    /// Shortenings in mm for which it is known.
    pub fn reach_mm(&self) -> (f64, f64) {
        match self {
            Self::Table(table) => table.reach_mm(),
            Self::Sum(loads) => loads
                .iter()
                .map(Self::reach_mm)
                .fold((f64::NEG_INFINITY, f64::INFINITY), |(low, high), (l, h)| {
                    (low.max(l), high.min(h))
                }),
            _ => (f64::NEG_INFINITY, f64::INFINITY),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn every_kind() -> Vec<Load> {
        let table =
            LoadTable::new(vec![(-30.0, 5.0), (0.0, 40.0), (20.0, 30.0), (60.0, 90.0)]).unwrap();
        let all = vec![
            Load::Force { force_n: 300.0 },
            Load::Mass {
                mass_kg: 20.0,
                level: false,
            },
            Load::Spring {
                rate_n_per_mm: 12.0,
                preload_n: 50.0,
            },
            Load::Lever(Lever::new(5.0, 300.0, 40.0, -30.0).unwrap()),
            Load::Table(table),
        ];
        let sum = Load::Sum(all.clone());
        all.into_iter().chain([sum]).collect()
    }

    #[test]
    fn the_slope_is_that_of_the_pull_and_the_pull_that_of_the_work() {
        for load in every_kind() {
            for x in [-12.3, -1.0, 0.7, 13.0, 41.0] {
                let h = 1e-4;
                let slope = (load.force_n(x + h) - load.force_n(x - h)) / (2.0 * h);
                assert!(
                    (slope - load.slope_n_per_mm(x)).abs() < 1e-6,
                    "{load:?} {x}"
                );
                let pull = 1e3 * (load.energy_j(x + h) - load.energy_j(x - h)) / (2.0 * h);
                assert!(
                    (pull - load.force_n(x)).abs() < 1e-5,
                    "{load:?} {x}: {pull}"
                );
            }
            assert_eq!(load.energy_j(0.0), 0.0);
        }
    }

    #[test]
    fn a_load_that_is_heavier_pulls_so_many_times_as_much_everywhere() {
        for load in every_kind() {
            for x in [-12.3, 0.0, 13.0, 41.0] {
                let (once, more) = (load.force_n(x), load.times(1.3).force_n(x));
                assert!(
                    (more - 1.3 * once).abs() < 1e-12 * more.abs().max(1.0),
                    "{load:?} {x}"
                );
            }
        }
    }

    #[test]
    fn a_spring_does_not_push() {
        let spring = Load::Spring {
            rate_n_per_mm: 10.0,
            preload_n: 50.0,
        };
        assert_eq!((spring.force_n(-4.0), spring.force_n(-6.0)), (10.0, 0.0));
        // ½·10·5² N mm between x = −5, where it ends, and 0.
        assert!((spring.energy_j(-8.0) + 0.125).abs() < 1e-12);
    }
}
