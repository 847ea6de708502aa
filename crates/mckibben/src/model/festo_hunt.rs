//! Festo's 10 mm muscle by Hunt's fit, which gives the pressure and has to be solved for the force.
//!
//!   P = 254.3 + 1.229 F + 15.6 S + 192 tan(2.0265 (ε/(ε_max − 0.331e-3 F) − 0.4609)),   P in kPa, F in N
//!
//! S = +1 on one branch of the hysteresis loop, −1 on the other; here S = 0, the mean of both.
//! Source: Hunt, Graber-Tilton & Quinn, Modeling length effects of braided pneumatic actuators (ASME IDETC 2017). ε_max
//! belongs to the specimen; the six specimens of that paper are in [`SPECIMENS`].

use super::root::rising_root;
use super::{
    Accuracy, BlockedAt, ForceModel, ModelEntry, ModelError, ModelInfo, ModelRange, Reference, Response,
    Result, Workspace,
};
use crate::muscle::Muscle;
use std::f64::consts::FRAC_PI_2;

pub(super) const ENTRY: ModelEntry = ModelEntry {
    name: "festo-hunt-10",
    description: "Festo 10 mm muscle by Hunt's fit; takes only the muscle's length",
    source: "Hunt, Graber-Tilton & Quinn 2017 [hunt2017], mean of both branches",
};

const P0: f64 = 254.3;
const P_F: f64 = 1.229;
const P_TAN: f64 = 192.0;
const STEEP: f64 = 2.0265;
const SHIFT: f64 = 0.4609;
/// Loss of ε_max per N of load.
const LOSS: f64 = 0.331e-3;
const KPA_PER_MPA: f64 = 1000.0;

/// Length at rest in mm and largest contraction ε_max (at 620 kPa, without load) of Hunt's specimens.
const SPECIMENS: [(f64, f64); 6] =
    [(153.1, 0.1491), (182.8, 0.1618), (189.4, 0.1633), (195.0, 0.1680), (272.7, 0.1692), (280.9, 0.1750)];

/// ε_max for a length at rest in mm: between the specimens on straight lines, beyond them that of the last one.
fn largest_contraction(length_mm: f64) -> f64 {
    let [first, .., last] = SPECIMENS;
    if length_mm <= first.0 {
        return first.1;
    }
    let between = SPECIMENS.windows(2).find_map(|pair| match pair {
        [(x0, y0), (x1, y1)] if length_mm <= *x1 => Some(y0 + (y1 - y0) * (length_mm - x0) / (x1 - x0)),
        _ => None,
    });
    between.unwrap_or(last.1)
}

/// Hunt's 10 mm muscle. Of the given muscle only the length counts.
///
/// Near ε = 0 and a high load the formula is steep beyond reason, for ε_max − 0.331e-3 F goes to zero at
/// F = ε_max/0.331e-3 (450 to 529 N). The range ends at the pressure whose blocked force is nine tenths of that, at most
/// 620 kPa. Lengthened muscles (ε < 0) are outside of the formula. Without pressure it gives a blocked force of 4 N.
#[derive(Debug, Clone)]
pub struct FestoHunt {
    info: ModelInfo,
    e_max: f64,
}

/// P in kPa, ∂P/∂F and ∂P/∂ε of a muscle with the largest contraction `e_max`.
fn pressure(e_max: f64, force: f64, e: f64) -> (f64, f64, f64) {
    let m = e_max - LOSS * force;
    let tan = (STEEP * (e / m - SHIFT)).tan();
    let slope = P_TAN * STEEP * (1.0 + tan * tan);
    (P0 + P_F * force + P_TAN * tan, P_F + slope * e * LOSS / (m * m), slope / m)
}

impl FestoHunt {
    /// The 10 mm muscle of a length, with ε_max from Hunt's specimens.
    pub fn new(muscle: &Muscle) -> Self {
        let e_max = largest_contraction(muscle.length_mm());
        let steep = pressure(e_max, 0.9 * e_max / LOSS, 0.0).0 / KPA_PER_MPA;
        let info = ModelInfo {
            range: ModelRange {
                pressure_mpa: (0.0, steep.min(0.62)),
                contraction: (0.0, e_max),
                ..ModelRange::open()
            },
            accuracy: Accuracy {
                share_of_blocked: Some(0.09),
                blocked_at: BlockedAt::Pressure(0.45),
                reference: Reference::ForceMap(
                    "rms 17 N on the 24 points of the static force map of a DMSP-10-250 (Martens & Boblan 2017) that lie in the box, with the largest contraction taken from the length",
                ),
            },
            notes: vec![format!(
                "the preset festo-hunt-10 describes a Festo muscle of 10 mm with a largest contraction of {e_max:.4}; tube, wall, braid and rubber of the muscle are ignored"
            )],
            ..ModelInfo::new(&ENTRY, muscle)
        };
        Self { info, e_max }
    }

    /// P in kPa, ∂P/∂F and ∂P/∂ε.
    fn pressure(&self, force: f64, e: f64) -> (f64, f64, f64) {
        pressure(self.e_max, force, e)
    }

    /// The force in N.
    fn solve(&self, pressure_mpa: f64, e: f64) -> Result<f64> {
        let kpa = KPA_PER_MPA * pressure_mpa;
        let error = || ModelError::not_finite(ENTRY.name, pressure_mpa, e);
        if !(e >= 0.0 && e.is_finite() && kpa.is_finite()) {
            return Err(error());
        }
        // P rises with F up to where the tangent goes to infinity.
        let highest = (self.e_max - e / (SHIFT + FRAC_PI_2 / STEEP)) / LOSS;
        if e == 0.0 {
            let force = (kpa - self.pressure(0.0, 0.0).0) / P_F;
            return if force < highest { Ok(force) } else { Err(error()) };
        }
        let high = highest - 1e-12 * highest.abs().max(1.0);
        let mut step = 100.0 + kpa.abs();
        let mut low = high - step;
        while self.pressure(low, e).0 > kpa {
            step *= 2.0;
            low -= step;
            if !low.is_finite() {
                return Err(error());
            }
        }
        let guess = ((kpa - P0) / P_F).clamp(low, high);
        rising_root(low, high, guess, 0.0, |f| {
            let (p, p_f, _) = self.pressure(f, e);
            (p - kpa, p_f)
        })
        .ok_or_else(error)
    }
}

impl ForceModel for FestoHunt {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn response(&self, _: &mut Workspace, pressure_mpa: f64, contraction: f64) -> Result<Response> {
        let force_n = self.solve(pressure_mpa, contraction)?;
        let (_, by_force, by_contraction) = self.pressure(force_n, contraction);
        Ok(Response {
            pressure_mpa,
            contraction,
            force_n,
            stiffness_n_per_mm: Some(by_contraction / by_force / self.info.muscle.length_mm()),
            force_per_pressure_mm2: Some(KPA_PER_MPA / by_force),
            ..Response::default()
        })
    }

    fn pressure_at_pull(&self, _: &mut Workspace, force_n: f64, contraction: f64) -> Option<f64> {
        let highest = (self.e_max - contraction / (SHIFT + FRAC_PI_2 / STEEP)) / LOSS;
        (contraction >= 0.0 && force_n < highest).then(|| self.pressure(force_n, contraction).0 / KPA_PER_MPA)
    }

    fn contraction_at_pull(&self, _: &mut Workspace, force_n: f64, pressure_mpa: f64) -> Option<f64> {
        let m = self.e_max - LOSS * force_n;
        let tan = (KPA_PER_MPA * pressure_mpa - P0 - P_F * force_n) / P_TAN;
        let e = m * (tan.atan() / STEEP + SHIFT);
        (m > 0.0 && e >= 0.0).then_some(e)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forces_satisfy_the_published_equation() {
        let model = FestoHunt::new(&Muscle::prototype());
        let (top, e_max) = (model.info.range.pressure_mpa.1, model.info.range.contraction.1);
        for i in 0..=20 {
            for j in 0..=20 {
                let (p, e) = (top * f64::from(i) / 20.0, e_max * f64::from(j) / 20.0);
                let f = model.force_n(&mut Workspace::new(), p, e).unwrap();
                let kpa = 254.3 + 1.229 * f + 192.0 * (2.0265 * (e / (e_max - 0.331e-3 * f) - 0.4609)).tan();
                let (_, p_f, _) = model.pressure(f, e);
                assert!((kpa - 1e3 * p).abs() < 1e-9 * (1.0 + p_f * (1.0 + f.abs())), "P {p}, ε {e}: {kpa}");
            }
        }
    }

    #[test]
    fn without_load_the_largest_contraction_takes_620_kpa() {
        let model = FestoHunt::new(&Muscle::prototype());
        let p = model.pressure_at_pull(&mut Workspace::new(), 0.0, model.e_max).unwrap();
        assert!((p - 0.62).abs() < 0.006, "{p}");
    }

    #[test]
    fn the_largest_contraction_follows_the_length() {
        assert_eq!(largest_contraction(100.0), 0.1491);
        assert_eq!(largest_contraction(400.0), 0.1750);
        assert!((largest_contraction(0.5 * (153.1 + 182.8)) - 0.5 * (0.1491 + 0.1618)).abs() < 1e-12);
        assert!(matches!(
            FestoHunt::new(&Muscle::prototype()).force_n(&mut Workspace::new(), 0.3, -0.1),
            Err(ModelError::NotFinite { .. })
        ));
    }
}
