//! What a design took where nobody said anything, and what of it keeps muscles from fitting.

use super::request::DesignRequest;
use crate::words::number;
use mckibben::muscle::{Braid, BraidStiffness, Muscle};
use mckibben_design::tubes::{LEAST_CAST_WALL_MM, rubbers};
use mckibben_design::{BraidChoice, Spec};

/// Pressure of a supply in MPa where none is given: that of a usual workshop.
pub(super) const SUPPLY_MPA: f64 = 0.6;

/// What would state the length, where it is an assumption.
pub(super) fn length_by(request: &DesignRequest) -> Option<&'static str> {
    let by = match (request.stroke_mm, request.contraction) {
        (Some(_), Some(_)) => return None,
        (Some(_), None) => "`length_mm`",
        (None, _) => "`length_mm` or `stroke_mm`",
    };
    (request.length_mm.is_none() && request.muscle.is_none()).then_some(by)
}

/// What was assumed, in sentences.
pub(super) fn assumptions(request: &DesignRequest, spec: &Spec) -> Vec<String> {
    let mut out = vec![];
    if request.max_pressure_mpa.is_none() {
        out.push(format!(
            "the supply gives {SUPPLY_MPA}\u{a0}MPa, because no pressure is given \
             (`max_pressure_mpa`)"
        ));
    }
    if length_by(request).is_some() {
        let length_mm = number(spec.base.length_mm(), 5);
        let named = "(`length_mm`, or a muscle file)";
        out.push(format!(
            "the length L0 is {length_mm}\u{a0}mm, because none is given {named}"
        ));
    }
    if !spec.tubes.is_empty() {
        let estimated = |braid: &Braid| braid.stiffness_factor > 1.0;
        if matches!(&spec.braid, BraidChoice::Sleeves(list) if list.iter().any(estimated)) {
            out.push(
                "diameter, stiffness and strength of strands that the seller does not publish \
                are estimated (the catalogue of parts marks them); the ± includes these estimates \
                and what no data sheet states"
                    .into(),
            );
        }
        let cast = rubbers(spec.tubes.iter().filter(|tube| tube.is_cast)).join(", ");
        if !cast.is_empty() {
            let least = format!("walls of at least {LEAST_CAST_WALL_MM}\u{a0}mm");
            out.push(format!("tubes are sold, or cast of {cast} with {least}"));
        }
        return out;
    }
    if request.rubbers.is_empty() && request.muscle.is_none() {
        let named = "(`rubbers`, or a muscle file)";
        out.push(format!(
            "the rubber is that of the paper, because none is named {named}"
        ));
    }
    if is_paper(spec) && request.muscle.is_none() && request.stiffness.is_none() {
        let named = "(`braids`, `stiffness`, or a muscle file)";
        out.push(format!(
            "the braid is that of the paper, because none is named {named}"
        ));
    }
    out
}

/// Whether the braid is the paper's, whose stiffness follows from the diameter.
pub(super) fn is_paper(spec: &Spec) -> bool {
    !matches!(spec.braid, BraidChoice::Sleeves(_))
        && spec.base.braid().stiffness == BraidStiffness::Paper
}

/// A wall that nobody makes.
pub(super) fn thin_wall(muscle: &Muscle) -> Option<String> {
    /// Tubes and hoses of rubber have walls of at least half a millimetre, and of a fiftieth of
    /// their diameter.
    const LEAST: (f64, f64) = (0.5, 0.02);
    let (wall, diameter) = (muscle.wall_mm(), muscle.outer_diameter_mm());
    let least = LEAST.0.max(LEAST.1 * diameter);
    (wall < least * (1.0 - 1e-9)).then(|| {
        let [wall, diameter, least] =
            [wall, diameter, (10.0 * least).ceil() / 10.0].map(|mm| number(mm, 3));
        let made = format!(
            "tubes of this diameter have walls of {least}\u{a0}mm or more; limit the walls \
             (`wall_mm`)"
        );
        format!(
            "a wall of {wall}\u{a0}mm on a tube of {diameter}\u{a0}mm is rarely available: \
            {made}"
        )
    })
}
