//! The straight line of least squares.

/// y = mean_y + slope (x − mean_x).
pub(crate) struct Line {
    pub mean_x: f64,
    pub mean_y: f64,
    /// Not a number where all x are the same.
    pub slope: f64,
}

impl Line {
    /// The line through points x, y.
    pub fn through(points: &[(f64, f64)]) -> Self {
        let n = points.len() as f64;
        let mean_x = points.iter().map(|p| p.0).sum::<f64>() / n;
        let mean_y = points.iter().map(|p| p.1).sum::<f64>() / n;
        let together = points.iter().map(|p| (p.0 - mean_x) * (p.1 - mean_y));
        let square = points.iter().map(|p| (p.0 - mean_x).powi(2));
        Self {
            mean_x,
            mean_y,
            slope: together.sum::<f64>() / square.sum::<f64>(),
        }
    }

    pub fn at(&self, x: f64) -> f64 {
        self.mean_y + self.slope * (x - self.mean_x)
    }
}
