//! Festo's fluidic muscles by Sárosi's fits.
//!
//!   F = (aP + b) e^(cκ) + dPκ + eP + f,   P in bar, κ = 100 ε in %, F in N
//!
//! Source: Sárosi (2012) \[sarosi2012\], fits to measured DMSP-10 and DMSP-20-200N. The fits fall
//! in κ and rise in P over the whole box: c < 0, d < 0 and aP + b > 0, and ∂F/∂P stays above zero
//! up to κ = 31 %.

use super::{
    Accuracy, BlockedAt, ForceModel, ModelEntry, ModelInfo, ModelRange, Reference, Response,
    Result, Workspace,
};
use crate::muscle::Muscle;

const BAR_PER_MPA: f64 = 10.0;

const SOURCE: &str = "Sárosi 2012 [sarosi2012], six constants fitted to a measured Festo muscle";

#[derive(Debug, Clone)]
pub struct Fit {
    pub entry: ModelEntry,
    make: &'static str,
    /// a, b, c, d, e, f
    constants: [f64; 6],
    /// Highest pressure the maker allows, in MPa.
    highest_mpa: f64,
    accuracy: Accuracy,
}

pub const DMSP_10: Fit = Fit {
    entry: ModelEntry {
        name: "festo-dmsp-10",
        description: "Festo DMSP-10 by Sarosi's fit; ignores the given muscle",
        source: SOURCE,
    },
    make: "Festo DMSP-10",
    constants: [
        -9.2194029,
        203.7012413,
        -0.34221042,
        -3.2255991,
        109.2038216,
        -208.372034,
    ],
    highest_mpa: 0.8,
    accuracy: Accuracy {
        share_of_blocked: Some(0.25),
        blocked_at: BlockedAt::Pressure(0.6),
        reference: Reference::ForceMap(
            "rms 73 N on the 40 points of the static force map of a DMSP-10-250 (Martens & Boblan \
             2017), another specimen than the fitted one, which pulls less",
        ),
    },
};

pub const DMSP_20_200: Fit = Fit {
    entry: ModelEntry {
        name: "festo-dmsp-20-200",
        description: "Festo DMSP-20-200N by Sarosi's fit; ignores the given muscle",
        source: SOURCE,
    },
    make: "Festo DMSP-20-200N",
    constants: [
        -4.00180705,
        292.4620246,
        -0.32930845,
        -9.33564098,
        294.0538256,
        -280.498151,
    ],
    highest_mpa: 0.6,
    accuracy: Accuracy {
        share_of_blocked: Some(0.11),
        blocked_at: BlockedAt::Pressure(0.6),
        reference: Reference::ForceMap(
            "rms 98 N on 55 points of the static force map of a DMSP-20-300 (Martens & Boblan \
             2017), another and longer specimen than the fitted one",
        ),
    },
};

/// A bought muscle by Sárosi's formula.
///
/// Tube, wall, braid and rubber of the muscle are ignored; its length only turns ∂F/∂ε into a
/// stiffness. Pressures up to what the maker allows (8 bar for size 10, 6 bar for size 20),
/// contractions up to its 25 %; at 0 bar the fits give −5 N and +12 N for the blocked force.
#[derive(Debug, Clone)]
pub struct FestoSarosi {
    info: ModelInfo,
    fit: Fit,
}

impl FestoSarosi {
    /// The DMSP-10 (inner diameter 10 mm) or the DMSP-20-200N (20 mm, length 200 mm).
    pub(super) fn between_ends(fit: Fit, muscle: &Muscle) -> Self {
        let name = fit.entry.name;
        let make = fit.make;
        let info = ModelInfo {
            range: ModelRange {
                pressure_mpa: (0.0, fit.highest_mpa),
                contraction: (0.0, 0.25),
                ..ModelRange::open()
            },
            accuracy: fit.accuracy,
            notes: vec![format!(
                "the preset {name} describes the {make}; tube, wall, braid and rubber of the \
                 muscle are ignored"
            )],
            ..ModelInfo::new(&fit.entry, muscle)
        };
        Self { info, fit }
    }
}

impl ForceModel for FestoSarosi {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn response(&self, _: &mut Workspace, pressure_mpa: f64, contraction: f64) -> Result<Response> {
        let [a, b, c, d, e, f] = self.fit.constants;
        let bar = BAR_PER_MPA * pressure_mpa;
        let k = 100.0 * contraction;
        let exp = (c * k).exp();
        // F at no pressure, and ∂F/∂P per bar.
        let (rest, slope) = (b * exp + f, a * exp + d * k + e);
        // dF/dκ, κ in %
        let by_percent = c * (a * bar + b) * exp + d * bar;
        Response {
            pressure_mpa,
            contraction,
            force_n: slope * bar + rest,
            stiffness_n_per_mm: Some(-100.0 * by_percent / self.info.muscle.length_mm()),
            force_per_pressure_mm2: Some(BAR_PER_MPA * slope),
            ..Response::default()
        }
        .finite(self.fit.entry.name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::ModelError;

    #[test]
    fn blocked_forces_at_6_bar() {
        let m = Muscle::prototype();
        // (6a + b) + 6e + f by hand.
        let ten = FestoSarosi::between_ends(DMSP_10, &m)
            .force_n(&mut Workspace::new(), 0.6, 0.0)
            .unwrap();
        let twenty = FestoSarosi::between_ends(DMSP_20_200, &m)
            .force_n(&mut Workspace::new(), 0.6, 0.0)
            .unwrap();
        assert!((ten - 595.2357192).abs() < 1e-6, "{ten}");
        assert!((twenty - 1752.2759849).abs() < 1e-6, "{twenty}");
    }

    #[test]
    fn in_their_box_they_fall_with_contraction_and_rise_with_pressure() {
        let m = Muscle::prototype();
        for model in [
            FestoSarosi::between_ends(DMSP_10, &m),
            FestoSarosi::between_ends(DMSP_20_200, &m),
        ] {
            for i in 0..=20 {
                for j in 0..=25 {
                    let p = model.info.range.pressure_mpa.1 * f64::from(i) / 20.0;
                    let r = model
                        .response(&mut Workspace::new(), p, 0.01 * f64::from(j))
                        .unwrap();
                    assert!(
                        r.stiffness_n_per_mm.unwrap() > 0.0
                            && r.force_per_pressure_mm2.unwrap() > 0.0
                    );
                }
            }
            assert!(matches!(
                model.force_n(&mut Workspace::new(), 0.1, f64::NAN),
                Err(ModelError::NotFinite { .. })
            ));
        }
    }
}
