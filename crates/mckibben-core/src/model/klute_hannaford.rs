//! Klute and Hannaford's muscle: the ideal pressure term and a thin Mooney–Rivlin tube under the
//! braid.
//!
//!   F = F_ideal + (Vb/L0) dw/dλ,   w = C10 (I1 − 3) + C01 (I2 − 3)
//!   λθ² = u = 1 + c (1 − λ²),   I1 = λ² + u + 1/(λ²u),   I2 = λ²u + 1/λ² + 1/u,   c = (L0/(2π r0 N))² = cot²θ0
//!   dI1/dλ = 2λ(1−c) − 2λ(1+c−2cλ²)/(λ²+cλ²(1−λ²))²
//!   dI2/dλ = 2λ(1+c−2cλ²) − 2/λ³ + 2cλ/(1+c(1−λ²))²
//!
//! Vb: volume of the rubber. Source: Klute & Hannaford (2000) \[klute2000\], whose text was not at
//! hand; derived here from the energy (the form printed in Tondu's review of 2012 \[tondu2012\]
//! omits 1/L0). It is the thin-wall limit of the thick-wall model.

use super::{
    ForceModel, Ideal, ModelEntry, ModelError, ModelInfo, Response, Result, Workspace,
    pantograph::Pantograph,
};
use crate::muscle::Muscle;
use std::f64::consts::PI;

pub const ENTRY: ModelEntry = ModelEntry {
    name: "klute-hannaford",
    description: "ideal muscle and a thin Mooney-Rivlin tube",
    source: "Klute & Hannaford 2000 [klute2000], derived from the energy",
};

/// The ideal muscle with a thin rubber tube of one hoop stretch, that of the braid.
///
/// Only for Mooney–Rivlin and neo-Hookean rubber. A thick wall is stretched more at its bore than
/// here.
#[derive(Debug, Clone)]
pub struct KluteHannaford {
    info: ModelInfo,
    ideal: Ideal,
    braid: Pantograph,
    c10: f64,
    c01: f64,
}

/// dw/dλ and d²w/dλ² in MPa, and the largest stretch.
struct Elastic {
    w_l: f64,
    w_ll: f64,
    stretch: f64,
}

impl KluteHannaford {
    /// The model of a muscle.
    ///
    /// # Errors
    /// [`ModelError::Missing`] where the rubber is neither Mooney–Rivlin nor neo-Hookean.
    pub fn between_ends(muscle: &Muscle) -> Result<Self> {
        let law = muscle.rubber().law.as_mooney_rivlin().ok_or(ModelError::Missing {
            model: ENTRY.name,
            missing: "a mooney-rivlin or neo-hookean rubber; for other laws take the thick-wall \
                model",
            key: "tube.material",
        })?;
        Ok(Self {
            info: ModelInfo::of_soft_strands(&ENTRY, muscle, 0.55),
            ideal: Ideal::between_ends(muscle),
            braid: Pantograph::from_muscle(muscle),
            c10: law.c10_mpa,
            c01: law.c01_mpa,
        })
    }

    fn elastic(&self, l: f64) -> Elastic {
        let c = (self.braid.cos / self.braid.sin).powi(2);
        let u = 1.0 + c * (1.0 - l * l);
        // g = λ²u and its derivatives
        let g = l * l * u;
        let g1 = 2.0 * l * (1.0 + c - 2.0 * c * l * l);
        let g2 = 2.0 * (1.0 + c) - 12.0 * c * l * l;
        let i1 = 2.0 * l * (1.0 - c) - g1 / (g * g);
        let i11 = 2.0 * (1.0 - c) - g2 / (g * g) + 2.0 * g1 * g1 / (g * g * g);
        let i2 = g1 - 2.0 / l.powi(3) + 2.0 * c * l / (u * u);
        let i22 = g2 + 6.0 / l.powi(4) + 2.0 * c / (u * u) + 8.0 * c * c * l * l / u.powi(3);
        Elastic {
            w_l: self.c10 * i1 + self.c01 * i2,
            w_ll: self.c10 * i11 + self.c01 * i22,
            stretch: l.max(u.sqrt()).max(1.0 / g.sqrt()),
        }
    }
}

impl ForceModel for KluteHannaford {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn response(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Response> {
        let mut response = self.ideal.response(workspace, pressure_mpa, contraction)?;
        let elastic = self.elastic(1.0 - contraction);
        let rubber = PI * self.braid.section;
        response.force_n += rubber * elastic.w_l;
        response.stiffness_n_per_mm = response
            .stiffness_n_per_mm
            .map(|s| s + rubber * elastic.w_ll / self.braid.length);
        response.max_stretch = Some(elastic.stretch);
        // The rubber takes part of the hoop load; how much, this model does not say.
        (response.braid_tension_n, response.strand_tension_n) = (None, None);
        // A thin wall: the bore, at the rubber's volume less than the outer cylinder.
        response.volume_mm3 = response.volume_mm3.map(|v| v - rubber * self.braid.length);
        Ok(response)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        model::ThickWall,
        muscle::{Braid, BraidStiffness, Rubber, Tube},
        rubber::{Law, MooneyRivlin, Yeoh},
    };

    fn muscle(wall_mm: f64) -> Muscle {
        let rubber = Rubber::new(Law::MooneyRivlin(MooneyRivlin {
            c10_mpa: 0.10,
            c01_mpa: 0.02,
        }));
        let braid = Braid {
            stiffness: BraidStiffness::Inextensible,
            ..Braid::paper()
        };
        Muscle::prototype()
            .with_tube(Tube {
                wall_mm,
                rubber,
                ..Tube::prototype()
            })
            .and_then(|m| m.with_braid(braid))
            .unwrap()
    }

    /// The rubber's share tends to that of the thick wall in proportion to s.
    #[test]
    fn it_is_the_thin_wall_limit_of_the_thick_wall() {
        for e in [0.05, 0.15, 0.3] {
            let errors = [1e-2, 1e-3].map(|s| {
                let m = muscle(s);
                let (thin, thick) = (
                    KluteHannaford::between_ends(&m).unwrap(),
                    ThickWall::between_ends(&m),
                );
                let ideal = Ideal::between_ends(&m)
                    .force_n(&mut Workspace::new(), 0.3, e)
                    .unwrap();
                let exact = thick.force_n(&mut Workspace::new(), 0.3, e).unwrap() - ideal;
                let rubber = thin.force_n(&mut Workspace::new(), 0.3, e).unwrap() - ideal;
                (rubber - exact) / exact
            });
            assert!(errors[1].abs() < 2e-3, "ε {e}: {errors:?}");
            assert!(
                (errors[0] / errors[1] - 10.0).abs() < 0.2,
                "ε {e}: {errors:?}"
            );
        }
    }

    #[test]
    fn its_stiffness_is_that_of_finite_differences_with_both_constants() {
        let model = KluteHannaford::between_ends(&muscle(2.0)).unwrap();
        let h = 1e-6;
        for e in [0.0, 0.1, 0.3] {
            let f = |e: f64| model.force_n(&mut Workspace::new(), 0.2, e).unwrap();
            let expected = -(f(e + h) - f(e - h)) / (2.0 * h * 285.0);
            let k = model
                .response(&mut Workspace::new(), 0.2, e)
                .unwrap()
                .stiffness_n_per_mm
                .unwrap();
            assert!((k / expected - 1.0).abs() < 1e-7, "ε {e}: {k} {expected}");
        }
    }

    #[test]
    fn other_laws_are_sent_to_the_thick_wall() {
        let law = Law::Yeoh(Yeoh {
            c10_mpa: 0.1,
            c20_mpa: 0.01,
            c30_mpa: 0.0,
        });
        let tube = Tube {
            rubber: Rubber::new(law),
            ..Tube::prototype()
        };
        let m = Muscle::prototype().with_tube(tube).unwrap();
        assert!(matches!(
            KluteHannaford::between_ends(&m),
            Err(ModelError::Missing { .. })
        ));
    }
}
