//! The curve of a rubber of which a table of fits is all that is known.
//!
//! `data/silicones/uniaxial_fits.csv` has for each silicone the Mooney–Rivlin constants of its
//! tension test up to 50, 100 and 200 % strain, the number of their points, and the stress at 100
//! %. One such fit follows the curve of its range within a few per cent, though as a law of rubber
//! it is none: its C01 is negative. So the curve is taken from the fits, range by range, and those
//! that end at or begin from 100 % are brought to the stress there, all at 100 % and nothing at
//! their other end. Of the silicones with a measured curve as well, what this gives is off by at
//! most 1.2 % up to 50 %, 2.2 % up to 100 %, 1.0 % up to 150 % and 4.3 % up to 200 % (RTV615, which
//! breaks at 193 %: 1.2, 4.6, 2.6 and 14 %).

use mckibben_core::rubber::{
    MooneyRivlin, RubberLaw,
    library::{LibraryError, TABLE_OF_FITS, plain},
};
use mckibben_fit::rubber::{Mode, TensionPoint};
use std::io::Read;

/// A row: one range of strain.
struct Range {
    up_to: f64,
    points: usize,
    fit: MooneyRivlin,
    at_100_mpa: f64,
}

impl Range {
    fn stress(&self, stretch: f64) -> f64 {
        self.fit.uniaxial_stress_mpa(stretch)
    }
}

/// The points of one-axis tension that a table of fits stands for, of the rubber with a name of the
/// library. As many as the fits had.
pub fn curve_of_fits(table: impl Read, name: &str) -> Result<Vec<TensionPoint>, LibraryError> {
    let damaged = || LibraryError::damaged(format!("{TABLE_OF_FITS}: {name}"));
    let ranges = ranges(table, name).ok_or_else(damaged)?;
    let (mut from, mut before, mut points) = (0.0, 0, vec![]);
    for range in &ranges {
        let count = range.points.saturating_sub(before).max(1);
        for i in 1..=count {
            let strain = from + (range.up_to - from) * i as f64 / count as f64;
            // 1 at 100 %, 0 at the other end of a range that touches it.
            let share = match range.up_to {
                end if end > 1.0 => (end - strain) / (end - 1.0),
                end if end == 1.0 => (strain - from) / (end - from),
                _ => 0.0,
            };
            let correction = (range.at_100_mpa / range.stress(2.0)).powf(share);
            let stretch = 1.0 + strain;
            points.push(TensionPoint::new(
                Mode::Uniaxial,
                stretch,
                correction * range.stress(stretch),
            ));
        }
        (from, before) = (range.up_to, range.points);
    }
    Ok(points)
}

fn ranges(table: impl Read, name: &str) -> Option<[Range; 3]> {
    let mut reader = csv::Reader::from_reader(table);
    let header = reader.headers().ok()?.clone();
    let column = |name: &str| header.iter().position(|h| h == name);
    let [up_to, points, c10, c01, at_100] = [
        column("eng_strain_max_fitted")?,
        column("n")?,
        column("C10_kPa")?,
        column("C01_kPa")?,
        column("eng_stress_at_100pct_kPa")?,
    ];
    let row = |row: csv::StringRecord| {
        let number = |i: usize| row.get(i)?.parse::<f64>().ok();
        Some(Range {
            up_to: number(up_to)?,
            points: number(points)? as usize,
            fit: MooneyRivlin {
                c10_mpa: number(c10)? / 1000.0,
                c01_mpa: number(c01)? / 1000.0,
            },
            at_100_mpa: number(at_100)? / 1000.0,
        })
    };
    let is_of_rubber = |r: &csv::StringRecord| r.get(0).is_some_and(|title| plain(title) == name);
    let all: Option<Vec<Range>> = reader
        .records()
        .filter_map(Result::ok)
        .filter(is_of_rubber)
        .map(row)
        .collect();
    all?.try_into().ok()
}
