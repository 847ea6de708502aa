//! Where nothing fits: what to change, in sentences.

use crate::{Units, number, percent};
use mckibben::units::Dimension;
use mckibben_design::{Demand, Lift, OperatingPoint, Relaxation};
use schemars::JsonSchema;
use serde::Serialize;

/// A change with which a muscle fits.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct RelaxationAnswer {
    /// The change.
    #[serde(flatten)]
    pub change: Relaxation,
    /// The same in a sentence.
    pub text: String,
}

impl RelaxationAnswer {
    pub(super) fn of(change: &Relaxation, wanted: &Demand) -> Self {
        Self { change: change.clone(), text: text(change, wanted) }
    }
}

fn text(change: &Relaxation, wanted: &Demand) -> String {
    let show = |kind, value| Units::default().show(kind, value);
    let points = |points: &[OperatingPoint]| {
        let one = |q: &OperatingPoint| {
            format!("{} at {}", show(Dimension::Force, q.force_n), percent(q.contraction))
        };
        points.iter().map(one).collect::<Vec<_>>().join(" and ")
    };
    match change {
        Relaxation::MaxPressure { pressure_mpa, extrapolated } => {
            let far = if *extrapolated { " (extrapolated: outside of the model's range)" } else { "" };
            format!("raise the supply to {}{far}", show(Dimension::Pressure, *pressure_mpa))
        }
        Relaxation::Force { points: list, share } => match wanted {
            Demand::Points(_) => format!("reduce the pull to {}", points(list)),
            Demand::Load { .. } => format!("reduce the load to {} of it", percent(*share)),
            Demand::Joint(joint) => {
                let torques = joint.torques.iter().map(|t| {
                    format!("{} N m at ±{}°", number(share * t.torque_nm, 3), number(t.angle_deg, 4))
                });
                format!("reduce the torque to {}", torques.collect::<Vec<_>>().join(" and "))
            }
        },
        Relaxation::Contraction { points: list, share } => match wanted {
            Demand::Load { way: Lift::Stroke(stroke_mm), .. } => {
                format!("reduce the stroke to {}", show(Dimension::Length, share * stroke_mm))
            }
            _ => format!("reduce the contraction: {}", points(list)),
        },
        Relaxation::OuterDiameter { outer_diameter_mm } => {
            format!("take an outer diameter of {}", show(Dimension::Length, *outer_diameter_mm))
        }
        Relaxation::MaxBulgedDiameter { bulged_diameter_mm } => {
            format!("allow a bulged diameter of {}", show(Dimension::Length, *bulged_diameter_mm))
        }
        Relaxation::MaxStretch { max_stretch } => format!("allow a stretch of {max_stretch}"),
        Relaxation::MaxStrandStrain { strand_strain } => {
            format!("allow a strand strain of {}", percent(*strand_strain))
        }
        Relaxation::MinBurstMargin { burst_margin } => format!("reduce the safety factor to {burst_margin}"),
        Relaxation::Guided {} => "guide the muscle, so that it cannot buckle (`guided`)".into(),
        Relaxation::MaxLiquidVolume { liquid_volume_mm3 } => {
            format!("provide {} mL of liquid for each muscle", number(1e-3 * liquid_volume_mm3, 3))
        }
        Relaxation::Together { changes } => {
            let all = changes.iter().map(|change| text(change, wanted));
            all.collect::<Vec<_>>().join(", and together with that ")
        }
    }
}
