//! What differences of some points amount to.

/// Figures of error, in the unit of the differences; all 0 of no points.
pub struct Errors {
    /// How many differences.
    pub points: usize,
    /// Sum of their squares.
    pub squares: f64,
    /// Root mean square.
    pub rms: f64,
    /// The largest, without its sign.
    pub largest: f64,
    /// 0 of none.
    pub mean: f64,
}

impl Errors {
    /// Statistics of differences.
    pub fn new(differences: impl IntoIterator<Item = f64>) -> Self {
        let mut points = 0;
        let mut squares = 0.0;
        let mut largest = 0.0_f64;
        let mut sum = 0.0;
        for difference in differences {
            points += 1;
            squares += difference * difference;
            largest = largest.max(difference.abs());
            sum += difference;
        }
        let n = points.max(1) as f64;
        Self {
            points,
            squares,
            rms: (squares / n).sqrt(),
            largest,
            mean: sum / n,
        }
    }
}
