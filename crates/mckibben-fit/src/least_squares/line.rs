//! The straight line of least squares.

use super::Errors;

/// y = mean_y + slope (x − mean_x).
pub struct Line {
    /// Mean of all x.
    pub mean_x: f64,
    /// Mean of all y.
    pub mean_y: f64,
    /// Not a number where all x are the same.
    pub slope: f64,
}

impl Line {
    /// The line through points x, y.
    pub fn through(points: &[(f64, f64)]) -> Self {
        let mean_x = Errors::new(points.iter().map(|p| p.0)).mean;
        let mean_y = Errors::new(points.iter().map(|p| p.1)).mean;
        let mut together = 0.0;
        let mut square = 0.0;
        for (x, y) in points {
            together += (x - mean_x) * (y - mean_y);
            square += (x - mean_x).powi(2);
        }
        Self {
            mean_x,
            mean_y,
            slope: together / square,
        }
    }

    /// y on the line.
    pub fn at(&self, x: f64) -> f64 {
        self.mean_y + self.slope * (x - self.mean_x)
    }
}
