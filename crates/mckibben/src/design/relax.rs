//! Where nothing fits: which limit to relax, and by how much.

use super::candidate::screen;
use super::reason::Reason;
use super::spec::{Build, OperatingPoint, Spec};
use crate::analysis::{contraction_at, pressure_at};
use crate::model::ThickWall;
use crate::muscle::Muscle;

/// A way to make the closest muscle fit.
#[derive(Debug, Clone, PartialEq)]
pub enum Relaxation {
    /// Supply this pressure.
    Pressure {
        /// Pressure in MPa.
        pressure_mpa: f64,
        /// The model had to be asked outside of its range.
        extrapolated: bool,
    },
    /// Accept this pull at the point.
    Force {
        /// The point that was wanted.
        point: OperatingPoint,
        /// Pull in N that the closest muscle has there.
        available_n: f64,
    },
    /// Accept this contraction at the pull.
    Contraction {
        /// The point that was wanted.
        point: OperatingPoint,
        /// The contraction that the closest muscle reaches with that pull.
        contraction: f64,
    },
    /// Take a tube of this diameter (with the same wall).
    OuterDiameter {
        /// Outer diameter in mm.
        outer_diameter_mm: f64,
        /// The model that says so.
        model: String,
    },
    /// Allow this diameter when bulged.
    BulgedDiameter {
        /// Diameter in mm.
        diameter_mm: f64,
    },
    /// Allow this stretch of the rubber.
    Stretch {
        /// Largest principal stretch.
        stretch: f64,
    },
    /// Accept this burst margin.
    BurstMargin {
        /// Burst pressure over maximum pressure.
        margin: f64,
    },
}

/// What would make `muscle` fit, one limit at a time.
pub(super) fn relaxations(spec: &Spec, build: &Build<'_>, muscle: &Muscle) -> Vec<Relaxation> {
    let mut out = vec![];
    let Ok(model) = build(muscle) else { return out };
    let model = model.as_ref();
    let short: Vec<(OperatingPoint, f64)> = spec
        .points
        .iter()
        .filter_map(|&p| Some((p, model.force_n(spec.max_pressure_mpa, p.contraction).ok()?)))
        .filter(|(p, f)| *f < p.force_n)
        .collect();
    if !short.is_empty() {
        let needed: Option<Vec<f64>> =
            short.iter().map(|(p, _)| pressure_at(model, p.force_n, p.contraction, true).ok()).collect();
        if let Some(needed) = needed {
            let pressure_mpa = needed.into_iter().fold(0.0, f64::max);
            let extrapolated = pressure_mpa > model.range().pressure_mpa.1;
            out.push(Relaxation::Pressure { pressure_mpa, extrapolated });
        }
        for &(point, available_n) in &short {
            if available_n > 0.0 {
                out.push(Relaxation::Force { point, available_n });
            }
            if let Ok(contraction) =
                contraction_at(model, point.force_n, spec.max_pressure_mpa, spec.extrapolate)
            {
                out.push(Relaxation::Contraction { point, contraction });
            }
        }
        out.extend(wider(spec, build, muscle));
    }
    if let Err(reason) = screen(spec, build, muscle) {
        match reason {
            Reason::Bulge { diameter_mm, .. } => out.push(Relaxation::BulgedDiameter { diameter_mm }),
            Reason::Stretch { stretch, .. } => out.push(Relaxation::Stretch { stretch }),
            Reason::Burst { margin, .. } => out.push(Relaxation::BurstMargin { margin }),
            _ => {}
        }
    }
    out
}

/// The smallest diameter beyond the bound that fits, by the design's model or, outside of its range, by thick-wall.
fn wider(spec: &Spec, build: &Build<'_>, muscle: &Muscle) -> Option<Relaxation> {
    let thick: &Build<'_> = &|m| Ok(Box::new(ThickWall::new(m)));
    let (_, high) = spec.outer_diameter_mm.bounds();
    for build in [build, thick] {
        let fits = |d0: f64| {
            let muscle = muscle.with_section(d0, muscle.wall_mm()).ok()?;
            screen(spec, build, &muscle).ok()
        };
        let (mut low, mut found) = (high, None);
        for i in 1..=40 {
            let d0 = high * (1.0 + 0.05 * f64::from(i));
            if fits(d0).is_some() {
                found = Some(d0);
                break;
            }
            low = d0;
        }
        if let Some(mut top) = found {
            for _ in 0..30 {
                let mid = 0.5 * (low + top);
                if fits(mid).is_some() { top = mid } else { low = mid }
            }
            let model = build(muscle).map_or_else(|_| String::new(), |m| m.name().to_owned());
            return Some(Relaxation::OuterDiameter {
                outer_diameter_mm: (top * 100.0).ceil() / 100.0,
                model,
            });
        }
    }
    None
}
