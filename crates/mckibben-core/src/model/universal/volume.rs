//! The volume of the cavity.

use super::{Universal, dual::Dual, search::SearchPoint};
use std::f64::consts::PI;

impl Universal {
    /// Volume of the cavity in mm³ with its derivatives in (ε, P): that of a uniform tube, and what
    /// the ends of a middle, as membranes, take from it.
    pub(super) fn volume(&self, place: &SearchPoint) -> Option<Dual> {
        let tube = self.info.muscle.tube();
        let section = tube.outer_radius_mm().powi(2) - tube.inner_radius_mm().powi(2);
        let ends = place.ends.volume_mm3;
        let l = Dual::new(place.l, [1.0, 0.0]);
        let r = Dual::new(place.state.r, place.state.r_by);
        // The ends of a muscle that pushes are those of the contraction at which it ceases to pull.
        let ends = match place.ends_by_pressure() {
            Some(l_p) => Dual::new(ends.v, [0.0, ends.by[1] + ends.by[0] * l_p]),
            None => ends,
        };
        let volume = (r.squared() * l - Dual::constant(section)) * (PI * self.length) + ends * 2.0;
        let [by_l, by_p] = volume.by;
        let volume = Dual::new(
            volume.v,
            [-by_l / place.slope, by_p + by_l * place.by_pressure],
        );
        (volume.is_finite() && volume.v > 0.0).then_some(volume)
    }
}
