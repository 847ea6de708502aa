//! What a design took where nobody said anything, and what of it keeps muscles from fitting.

use super::request::DesignRequest;
use crate::words::{number, percent};
use mckibben::muscle::{Braid, BraidStiffness, Muscle};
use mckibben_design::tubes::{LEAST_CAST_WALL_MM, rubbers};
use mckibben_design::{BraidChoice, Build, Closest, Reason, Relaxation, Spec, fits};

/// What was assumed, in sentences.
pub(super) fn assumptions(request: &DesignRequest, spec: &Spec) -> Vec<String> {
    let mut out = vec![];
    if !spec.tubes.is_empty() {
        let estimated = |braid: &Braid| braid.stiffness_factor > 1.0;
        if matches!(&spec.braid, BraidChoice::Sleeves(list) if list.iter().any(estimated)) {
            out.push("diameter, stiffness and strength of strands that no seller states are estimates (the catalogue of parts marks them); the ± carries that of the stiffness".into());
        }
        let cast = rubbers(spec.tubes.iter().filter(|tube| tube.is_cast)).join(", ");
        if !cast.is_empty() {
            out.push(format!(
                "tubes are sold, or cast of {cast} with walls of at least {LEAST_CAST_WALL_MM} mm"
            ));
        }
        return out;
    }
    if request.rubbers.is_empty() && request.muscle.is_none() {
        out.push(
            "the rubber is that of the paper, because none is named (`rubbers`, or a muscle file)".into(),
        );
    }
    if is_paper(spec) && request.muscle.is_none() && request.stiffness.is_none() {
        let named = "(`braids`, `stiffness`, or a muscle file)";
        out.push(format!("the braid is that of the paper, because none is named {named}"));
    }
    out
}

/// Whether the braid is the paper's, whose stiffness follows from the diameter.
fn is_paper(spec: &Spec) -> bool {
    !matches!(spec.braid, BraidChoice::Sleeves(_)) && spec.base.braid().stiffness == BraidStiffness::Paper
}

/// Where the strands of the paper's braid stretch too far: that a stiffer sleeve would do, and how stiff it has to be, where that is
/// what the closest muscle lacks.
pub(super) fn stiffer_sleeve(spec: &Spec, build: &Build<'_>, closest: &Closest) -> Option<String> {
    /// Factors on the stiffness that are tried.
    const FACTORS: [f64; 6] = [1.25, 1.5, 2.0, 3.0, 5.0, 10.0];
    if !is_paper(spec) {
        return None;
    }
    let muscle = &closest.muscle;
    let own = muscle.family_stiffness_n_per_mm()?;
    let fitting = FACTORS.into_iter().map(|factor| factor * own).find(|&k| {
        let mut braid = muscle.braid().clone();
        braid.stiffness = BraidStiffness::NewtonPerMm(k);
        muscle.with_braid(braid).is_ok_and(|stiff| fits(spec, build, &stiff))
    });
    let strained = matches!(closest.rejected.reason, Reason::StrandStrain { .. })
        || closest.relaxations.iter().any(|r| matches!(r, Relaxation::MaxStrandStrain { .. }));
    let limit = percent(spec.limits.strand_strain?);
    let first = format!(
        "The braid is that of the paper. Its stiffness of one strand family is {} N/mm here; its strands may stretch by {limit}, the validated range.",
        number(own, 3)
    );
    let name = "a sleeve (`braids`), a `stiffness`, or a muscle file with strands";
    match fitting {
        Some(k) => Some(format!(
            "{first} Use a stiffer sleeve: with {} N/mm this muscle fits. Give {name}.",
            number(k, 3)
        )),
        None if strained => {
            Some(format!("{first} The strands of a stiffer sleeve stretch less. Give {name}."))
        }
        None => None,
    }
}

/// A wall that nobody makes.
pub(super) fn thin_wall(muscle: &Muscle) -> Option<String> {
    /// Tubes and hoses of rubber have walls of at least half a millimetre, and of a fiftieth of their diameter.
    const LEAST: (f64, f64) = (0.5, 0.02);
    let (wall, diameter) = (muscle.wall_mm(), muscle.outer_diameter_mm());
    let least = LEAST.0.max(LEAST.1 * diameter);
    (wall < least * (1.0 - 1e-9)).then(|| {
        format!(
            "a wall of {} mm on a tube of {} mm is rarely available: tubes of this diameter have walls of {} mm or more; limit the walls (`wall_mm`)",
            number(wall, 3),
            number(diameter, 3),
            number((10.0 * least).ceil() / 10.0, 3)
        )
    })
}
