//! How much larger the next step may be.

/// Of what a step may miss of its prediction, the share that the next one aims at.
const AIM: f64 = 0.5;
/// By what factor a step may be larger than the one before.
const GROWTH: f64 = 4.0;

/// By what factor the next step is larger where the last one `missed` its prediction: that grows with the square of a step.
pub(super) fn growth_of_step(missed: f64, reach: f64) -> f64 {
    (AIM * reach / missed).sqrt().clamp(1.0, GROWTH)
}
