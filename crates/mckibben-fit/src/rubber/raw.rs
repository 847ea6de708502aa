//! Constants as a solver gives them.

/// Constants as a solver gives them.
pub(super) struct Raw {
    pub constants: Vec<f64>,
    pub standard_errors: Vec<f64>,
    pub at_bound: Vec<bool>,
    /// A change of each constant that moves the stress at the end of the data by the modulus; 0 where it may not be zero.
    pub scales: Vec<f64>,
    pub freedom: usize,
}
