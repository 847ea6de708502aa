//! A change of a specification: what it does, and how it is said.

use crate::{Demand, Lift, OperatingPoint, Spec, bundle::envelope_ratio, limits::check::Show};
use mckibben_core::{
    joined,
    units::{Dimension, Values, rounded, tidy},
};
use serde::Serialize;

/// A change of the specification with which a muscle fits.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(tag = "relax", rename_all = "snake_case")]
pub enum Relaxation {
    /// Supply this pressure.
    MaxPressure {
        /// MPa.
        pressure_mpa: f64,
        /// Outside of the model's range.
        extrapolated: bool,
    },
    /// Accept these pulls.
    Force {
        /// The share of what is wanted: of the pulls, of the load, or of the torques.
        share: f64,
        /// The operating points as they could be.
        points: Vec<OperatingPoint>,
    },
    /// Accept these contractions.
    Contraction {
        /// The share of what is wanted: of the contractions, or of the stroke.
        share: f64,
        /// The operating points as they could be.
        points: Vec<OperatingPoint>,
    },
    /// Take a wider tube with the same wall.
    OuterDiameter {
        /// mm.
        outer_diameter_mm: f64,
    },
    /// Allow this diameter when bulged.
    MaxBulgedDiameter { bulged_diameter_mm: f64 },
    /// Allow this stretch of the rubber.
    MaxStretch { max_stretch: f64 },
    /// Allow this strain of the strands.
    MaxStrandStrain {
        /// Largest strain at the maximum pressure.
        strand_strain: f64,
    },
    /// Accept this burst margin.
    MinBurstMargin {
        /// Burst pressure over maximum pressure.
        burst_margin: f64,
    },
    /// Guide the muscle on its way, so that it cannot buckle.
    Guided {},
    /// Provide this liquid volume.
    MaxLiquidVolume {
        /// mm³.
        liquid_volume_mm3: f64,
    },
    /// Take another sleeve.
    Sleeve {
        /// Its name.
        sleeve: String,
        /// The tube that goes with it.
        tube: Option<String>,
    },
    /// Cast a tube of another rubber.
    Rubber {
        /// Its name.
        rubber: String,
        /// The tube, by name.
        tube: String,
    },
    /// Take strands that are stiffer.
    Stiffness {
        /// Stiffness k of one strand family, N/mm.
        family_stiffness_n_per_mm: f64,
    },
    /// All of these together.
    Together {
        /// Each of them.
        changes: Vec<Relaxation>,
    },
}

impl Relaxation {
    /// Changes a specification.
    pub fn apply(&self, spec: &mut Spec) {
        let limits = &mut spec.limits;
        match self {
            Self::MaxPressure { pressure_mpa, .. } => {
                (spec.max_pressure_mpa, spec.extrapolate) = (*pressure_mpa, true);
            }
            Self::Force { share, .. } => spec.wanted = spec.wanted.times(*share),
            Self::Contraction { share, .. } => spec.wanted = spec.wanted.shorter(*share),
            Self::OuterDiameter { outer_diameter_mm } => {
                spec.outer_diameter_mm = Values::List(vec![*outer_diameter_mm]);
            }
            Self::MaxBulgedDiameter { bulged_diameter_mm } => {
                limits.bulged_diameter_mm = Some(*bulged_diameter_mm);
                limits.envelope_mm = None;
            }
            Self::MaxStretch { max_stretch } => limits.stretch = Some(*max_stretch),
            Self::MaxStrandStrain { strand_strain } => limits.strand_strain = Some(*strand_strain),
            Self::MinBurstMargin { burst_margin } => limits.burst_margin = Some(*burst_margin),
            Self::Guided {} => limits.buckling = false,
            Self::MaxLiquidVolume { liquid_volume_mm3 } => {
                limits.liquid_volume_mm3 = Some(*liquid_volume_mm3)
            }
            Self::Together { changes } => changes.iter().for_each(|change| change.apply(spec)),
            // Other parts, with which a muscle was found.
            Self::Sleeve { .. } | Self::Rubber { .. } | Self::Stiffness { .. } => {}
        }
    }

    /// The sentence, with pressures, forces and lengths written by `show`. `spec` is the one that
    /// it changes.
    pub fn describe(&self, spec: &Spec, show: Show<'_>) -> String {
        match self {
            Self::MaxPressure {
                pressure_mpa,
                extrapolated,
            } => {
                let far = if *extrapolated {
                    " (extrapolated: outside of the model's range)"
                } else {
                    ""
                };
                format!(
                    "raise the supply to {}{far}",
                    show(Dimension::Pressure, *pressure_mpa)
                )
            }
            Self::Force { points, share } => less_pull(spec, points, *share, show),
            Self::Contraction { points, share } => match spec.wanted {
                Demand::Load {
                    way: Lift::Stroke(stroke_mm),
                    ..
                } => format!(
                    "reduce the stroke to {}",
                    show(Dimension::Length, share * stroke_mm)
                ),
                _ => format!("reduce the contraction: {}", listed(spec, points, show)),
            },
            Self::OuterDiameter { outer_diameter_mm } => {
                format!(
                    "take an outer diameter of {}",
                    show(Dimension::Length, *outer_diameter_mm)
                )
            }
            Self::MaxBulgedDiameter { bulged_diameter_mm } => {
                let envelope = spec.limits.envelope_mm.map_or_else(String::new, |_| {
                    let mm = envelope_ratio(spec.count) * bulged_diameter_mm;
                    let mm = rounded(mm, 4, f64::ceil);
                    format!(" (an envelope of {})", show(Dimension::Length, mm))
                });
                format!(
                    "allow a bulged diameter of {}{envelope}",
                    show(Dimension::Length, *bulged_diameter_mm)
                )
            }
            Self::MaxStretch { max_stretch } => format!("allow a stretch of {max_stretch}"),
            Self::MaxStrandStrain { strand_strain } => {
                format!("allow a strand strain of {}", percent(*strand_strain))
            }
            Self::MinBurstMargin { burst_margin } => {
                format!("reduce the safety factor to {burst_margin}")
            }
            Self::Guided {} => "guide the muscle, so that it cannot buckle (`guided`)".into(),
            Self::MaxLiquidVolume { liquid_volume_mm3 } => {
                format!(
                    "provide {} mL of liquid for each muscle",
                    tidy(1e-3 * liquid_volume_mm3, 3)
                )
            }
            Self::Sleeve { sleeve, tube } => {
                let tube = tube
                    .as_ref()
                    .map_or_else(String::new, |tube| format!(" with the tube {tube}"));
                format!("take another sleeve, {sleeve} (polyester that expands so far){tube}")
            }
            Self::Rubber { tube, .. } => format!("cast the tube of another rubber: {tube}"),
            Self::Stiffness {
                family_stiffness_n_per_mm: k,
            } => {
                format!(
                    "take a stiffer sleeve: {} N/mm of one strand family (`braids`, `stiffness`, or a \
                     muscle file with strands)",
                    tidy(*k, 3)
                )
            }
            Self::Together { changes } => {
                let all = changes.iter().map(|change| change.describe(spec, show));
                joined(all, ", and together with that ")
            }
        }
    }
}

/// A smaller share of the pulls, the load or the torques.
fn less_pull(spec: &Spec, points: &[OperatingPoint], share: f64, show: Show<'_>) -> String {
    match &spec.wanted {
        Demand::Points(_) => format!("reduce the pull to {}", listed(spec, points, show)),
        Demand::Load { .. } => format!("reduce the load to {} of it", percent(share)),
        Demand::Joint(joint) => {
            let torques = joint.torques.iter().map(|t| {
                format!(
                    "{} N m at ±{}°",
                    tidy(f64::from(spec.count) * share * t.torque_nm, 5),
                    tidy(t.angle_deg, 4)
                )
            });
            format!("reduce the torque to {}", joined(torques, " and "))
        }
    }
}

/// Operating points with the pull of all muscles together.
fn listed(spec: &Spec, points: &[OperatingPoint], show: Show<'_>) -> String {
    let points = points.iter().map(|q| {
        let force = show(Dimension::Force, f64::from(spec.count) * q.force_n);
        format!("{force} at {}", percent(q.contraction))
    });
    joined(points, " and ")
}

/// A change, and how much it asks: the logarithm of its number over that of the specification.
pub type Change = (f64, Relaxation);

/// A change is larger by this share than it has to be, so that it holds with three digits and the
/// last bit of an inverse.
pub const EASED: f64 = 1e-5;

/// A number with three digits, not below or not above it.
pub fn three_digits(value: f64, up: bool) -> f64 {
    if up {
        rounded(value * (1.0 + EASED), 3, f64::ceil)
    } else {
        rounded(value * (1.0 - EASED), 3, f64::floor)
    }
}

fn percent(ratio: f64) -> String {
    format!("{} %", tidy(100.0 * ratio, 4))
}
