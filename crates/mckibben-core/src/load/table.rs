//! A load as points.

use super::refused;
use crate::{by_number::SortByNumber, refused::Refused};

/// Points (x in mm, F in N), straight lines between them; known from the first to the last x.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadTable {
    points: Vec<(f64, f64)>,
}

impl LoadTable {
    /// A table of points in any order.
    pub fn new(mut points: Vec<(f64, f64)>) -> Result<Self, Refused> {
        if points.len() < 2 {
            return Err(refused(format!(
                "a table of a load needs two points or more, and there are {}",
                points.len()
            )));
        }
        if let Some(i) = points
            .iter()
            .position(|(x, f)| !(x.is_finite() && f.is_finite()))
        {
            let (shortening_mm, force_n) = points[i];
            return Err(refused(format!(
                "point {point} of the load is {shortening_mm}\u{a0}mm, {force_n}\u{a0}N: both must \
                 be finite numbers",
                point = i + 1
            )));
        }
        points.sort_by_number(|a| a.0);
        match points.windows(2).find(|w| w[0].0 == w[1].0) {
            Some(twice) => Err(refused(format!(
                "the load has two points at a shortening of {}\u{a0}mm",
                twice[0].0
            ))),
            None => Ok(Self { points }),
        }
    }

    pub(super) fn times(&self, factor: f64) -> Self {
        Self {
            points: self.points.iter().map(|(x, f)| (*x, factor * f)).collect(),
        }
    }

    /// The two points around a place; those at the end beyond it.
    fn around(&self, x: f64) -> ((f64, f64), (f64, f64)) {
        let i = self
            .points
            .partition_point(|p| p.0 < x)
            .clamp(1, self.points.len() - 1);
        (self.points[i - 1], self.points[i])
    }

    pub(super) fn force_n(&self, x: f64) -> f64 {
        let ((x0, f0), (x1, f1)) = self.around(x);
        f0 + (f1 - f0) * (x - x0) / (x1 - x0)
    }

    pub(super) fn slope_n_per_mm(&self, x: f64) -> f64 {
        let ((x0, f0), (x1, f1)) = self.around(x);
        (f1 - f0) / (x1 - x0)
    }

    pub(super) fn energy_n_mm(&self, x: f64) -> f64 {
        self.area_to(x) - self.area_to(0.0)
    }

    /// ∫ F dx from the first point.
    fn area_to(&self, x: f64) -> f64 {
        let part = |(x0, f0): (f64, f64), (x1, f1): (f64, f64)| 0.5 * (x1 - x0) * (f0 + f1);
        let whole = self
            .points
            .windows(2)
            .take_while(|w| w[1].0 <= x)
            .map(|w| part(w[0], w[1]));
        let last = self
            .points
            .iter()
            .rev()
            .find(|p| p.0 <= x)
            .or(self.points.first());
        whole.sum::<f64>() + last.map_or(0.0, |p| part(*p, (x, self.force_n(x))))
    }

    pub(super) fn reach_mm(&self) -> (f64, f64) {
        let end = |p: Option<&(f64, f64)>| p.map_or(f64::NAN, |p| p.0);
        (end(self.points.first()), end(self.points.last()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_line_is_refused() {
        let refused = [
            (vec![(0.0, 1.0)], "there are 1"),
            (
                vec![(1.0, 1.0), (0.0, 1.0), (1.0, 2.0)],
                "two points at a shortening of 1\u{a0}mm",
            ),
            (vec![(0.0, f64::NAN), (1.0, 1.0)], "finite"),
        ];
        for (points, said) in refused {
            assert!(
                LoadTable::new(points)
                    .unwrap_err()
                    .to_string()
                    .contains(said)
            );
        }
    }

    #[test]
    fn work_is_the_area_under_the_line() {
        let table = LoadTable::new(vec![(0.0, 0.0), (10.0, 20.0), (20.0, 20.0)]).unwrap();
        // Triangle ½·10·20, rectangle 5·20.
        assert_eq!(
            (table.energy_n_mm(10.0), table.energy_n_mm(15.0)),
            (100.0, 200.0)
        );
    }
}
