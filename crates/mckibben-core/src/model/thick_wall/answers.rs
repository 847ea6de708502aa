//! Results of the thick-wall model, and its own inverses and derivatives.

use super::ThickWall;
use crate::model::{ForceModel, ModelInfo, Response, Result, Workspace};
use std::f64::consts::PI;

impl ForceModel for ThickWall {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn response(&self, _: &mut Workspace, pressure_mpa: f64, contraction: f64) -> Result<Response> {
        let (l, l_eps, l_p) = self.stretch(pressure_mpa, contraction);
        let s = self.state(pressure_mpa, l)?;
        let length = self.info.muscle.length_mm();
        let by_stretch = PI * length * (s.r * s.r + 2.0 * s.r * s.r_by[0] * l);
        let response = Response {
            pressure_mpa,
            contraction,
            force_n: s.force,
            volume_mm3: Some(PI * (s.r * s.r * l - self.wall.section()) * length),
            volume_per_pressure_mm3_per_mpa: Some(
                PI * length * 2.0 * s.r * s.r_by[1] * l + by_stretch * l_p,
            ),
            volume_per_contraction_mm3: Some(by_stretch * l_eps),
            stiffness_n_per_mm: Some(-s.force_l * l_eps / length),
            force_per_pressure_mm2: Some(s.force_p + s.force_l * l_p),
            bulged_diameter_mm: Some(2.0 * s.r),
            middle_stretch: Some(self.wall.largest_stretch(l, s.r)),
            max_stretch: Some(self.wall.largest_stretch(l, s.r)),
            ..Response::default()
        };
        Ok(response.with_braid_tension(s.tension, self.muscle()))
    }

    fn force_n(&self, _: &mut Workspace, pressure_mpa: f64, contraction: f64) -> Result<f64> {
        let (l, _, _) = self.stretch(pressure_mpa, contraction);
        Ok(self.state(pressure_mpa, l)?.force)
    }

    /// In closed form where strands do not stretch, else by Newton's method for the radius. A tube
    /// pushes as hard at a lower pressure, with its strands slack.
    fn contact_n_per_mm(
        &self,
        _: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Option<Result<f64>> {
        Some(self.pivoting(pressure_mpa, contraction))
    }
}
