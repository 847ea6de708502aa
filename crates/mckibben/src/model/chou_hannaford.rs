//! Chou and Hannaford's correction for the wall: it takes room, and its thickness stays.
//!
//!   F = (π D90²/4) P (3cos²θ − 1) + π P [s D90 (2 sinθ − 1/sinθ) − s²],   D90 = D0/sinθ0,  cosθ = (1−ε) cosθ0
//!     = −P dV/dL,   V = π (r − s)² L
//!
//! Source: Chou & Hannaford (1996) \[chou1996\], whose text was not at hand: the formula is taken from Tondu's review (2012) \[tondu2012\] and
//! agrees with the volume above.

use super::pantograph::Pantograph;
use super::{
    Accuracy, Extensions, ForceModel, Inverse, ModelEntry, ModelInfo, Reference, Response, Result, Where,
    Workspace,
};
use crate::muscle::Muscle;
use std::f64::consts::PI;

pub(super) const ENTRY: ModelEntry = ModelEntry {
    name: "chou-hannaford",
    description: "ideal muscle inside of a wall of constant thickness",
    source: "Chou & Hannaford 1996 [chou1996], as given by Tondu 2012 [tondu2012]",
};

/// The ideal muscle whose pressure acts inside of a wall of constant thickness s.
///
/// The rubber carries nothing, though it would: at ε = 0 and strands that do not stretch a real muscle pulls as if the
/// pressure acted on the outer diameter. So this formula pulls too little at small contractions.
#[derive(Debug, Clone)]
pub struct ChouHannaford {
    info: ModelInfo,
    braid: Pantograph,
}

/// F/P, its derivative in λ, and the cavity's cross-section.
struct Pull {
    f: f64,
    f_l: f64,
    bore_area: f64,
    diameter: f64,
}

impl ChouHannaford {
    /// The model of a muscle.
    pub fn new(muscle: &Muscle) -> Self {
        let accuracy = Accuracy::share(0.75, Reference::RandomMuscles(Where::SoftStrands));
        let info = ModelInfo { accuracy, ..ModelInfo::new(&ENTRY, muscle) };
        Self { info, braid: Pantograph::of(muscle) }
    }

    fn pull(&self, contraction: f64) -> Result<Pull> {
        let g = self.braid.at(contraction)?;
        let bore = g.r - self.info.muscle.wall_mm();
        if bore <= 0.0 {
            return Err(self.braid.no_shape(contraction));
        }
        Ok(Pull {
            f: -PI * (bore * bore + 2.0 * bore * g.r1 * g.l),
            f_l: -2.0 * PI * (2.0 * bore * g.r1 + g.r1 * g.r1 * g.l + bore * g.r2 * g.l),
            bore_area: PI * bore * bore,
            diameter: 2.0 * g.r,
        })
    }
}

impl ForceModel for ChouHannaford {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn response(&self, _: &mut Workspace, pressure_mpa: f64, contraction: f64) -> Result<Response> {
        let pull = self.pull(contraction)?;
        let length = self.info.muscle.length_mm();
        Response {
            pressure_mpa,
            contraction,
            force_n: pressure_mpa * pull.f,
            volume_mm3: Some(pull.bore_area * (1.0 - contraction) * length),
            stiffness_n_per_mm: Some(pressure_mpa * pull.f_l / length),
            force_per_pressure_mm2: Some(pull.f),
            bulged_diameter_mm: Some(pull.diameter),
            ..Response::default()
        }
        .finite(ENTRY.name)
    }

    fn extensions(&self) -> Extensions<'_> {
        Extensions { inverse: Some(self), ..Extensions::default() }
    }
}

impl Inverse for ChouHannaford {
    fn pressure_at_pull(&self, _: &mut Workspace, force_n: f64, contraction: f64) -> Option<f64> {
        let pull = self.pull(contraction).ok()?;
        (pull.f > 0.0).then(|| force_n / pull.f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Ideal;

    #[test]
    fn it_is_the_published_formula() {
        let m = Muscle::prototype();
        let model = ChouHannaford::new(&m);
        let (p, s, d90) = (0.2, m.wall_mm(), m.outer_diameter_mm() / m.braid().angle_rad().sin());
        for e in [-0.02, 0.0, 0.1, 0.3] {
            let cos = (1.0 - e) * m.braid().angle_rad().cos();
            let sin = (1.0 - cos * cos).sqrt();
            let published = PI * d90 * d90 / 4.0 * p * (3.0 * cos * cos - 1.0)
                + PI * p * (s * d90 * (2.0 * sin - 1.0 / sin) - s * s);
            let force = model.force_n(&mut Workspace::new(), p, e).unwrap();
            assert!((force - published).abs() < 1e-10 * published.abs().max(1.0), "{force} {published}");
        }
    }

    #[test]
    fn without_a_wall_it_is_the_ideal_formula() {
        let thin = Muscle::prototype().with_section(30.0, 1e-9).unwrap();
        let (a, b) = (ChouHannaford::new(&thin), Ideal::new(&thin));
        for e in [0.0, 0.15, 0.3] {
            assert!(
                (a.force_n(&mut Workspace::new(), 0.2, e).unwrap()
                    - b.force_n(&mut Workspace::new(), 0.2, e).unwrap())
                .abs()
                    < 1e-6
            );
        }
    }
}
