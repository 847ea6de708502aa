//! What a design took where nobody said anything, and what of it keeps muscles from fitting.

use super::request::DesignRequest;
use crate::words::{number, percent};
use mckibben::muscle::{Braid, BraidStiffness, Muscle};
use mckibben::progress::Progress;
use mckibben::sleeve::library;
use mckibben_design::tubes::{LEAST_CAST_WALL_MM, rubbers};
use mckibben_design::{Below, BraidChoice, Build, Closest, Demand, Models, Spec, design_with, fits};

/// Pressure of a supply in MPa where none is given: that of a usual workshop.
pub(super) const SUPPLY_MPA: f64 = 0.6;

/// Whether the length is an assumption.
pub(super) fn length_is(request: &DesignRequest) -> bool {
    let says = request.length_mm.is_some() || request.stroke_mm.is_some() && request.contraction.is_some();
    !says && request.muscle.is_none()
}

/// What was assumed, in sentences.
pub(super) fn assumptions(request: &DesignRequest, spec: &Spec) -> Vec<String> {
    let mut out = vec![];
    if request.max_pressure_mpa.is_none() {
        out.push(format!(
            "the supply gives {SUPPLY_MPA} MPa, because no pressure is given (`max_pressure_mpa`)"
        ));
    }
    if length_is(request) {
        let length_mm = number(spec.base.length_mm(), 5);
        let named = "(`length_mm`, or a muscle file)";
        out.push(format!("the length L0 is {length_mm} mm, because none is given {named}"));
    }
    if !spec.tubes.is_empty() {
        let estimated = |braid: &Braid| braid.stiffness_factor > 1.0;
        if matches!(&spec.braid, BraidChoice::Sleeves(list) if list.iter().any(estimated)) {
            out.push("diameter, stiffness and strength of strands that the seller does not publish are estimated (the catalogue of parts marks them); the ± includes the estimate of the stiffness, not what no data sheet states: where muscles were predicted from their dimensions alone, they were off by 20 to 30 %".into());
        }
        let cast = rubbers(spec.tubes.iter().filter(|tube| tube.is_cast)).join(", ");
        if !cast.is_empty() {
            let least = format!("walls of at least {LEAST_CAST_WALL_MM} mm");
            out.push(format!("tubes are sold, or cast of {cast} with {least}"));
        }
        return out;
    }
    if request.rubbers.is_empty() && request.muscle.is_none() {
        let named = "(`rubbers`, or a muscle file)";
        out.push(format!("the rubber is that of the paper, because none is named {named}"));
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
    let strained = closest.rejected.reason.check().and_then(|check| check.by) == Some(Below::Strained);
    let (own, limit) = (number(own, 3), percent(spec.limits.strand_strain?));
    let first = format!(
        "The braid is that of the paper. Its stiffness of one strand family is {own} N/mm here; its strands may stretch by {limit}, the validated range."
    );
    let stiffer = match fitting.map(|k| number(k, 3)) {
        Some(k) => format!("Use a stiffer sleeve: with {k} N/mm this muscle fits."),
        None if strained => "The strands of a stiffer sleeve stretch less.".into(),
        None => return None,
    };
    Some(format!("{first} {stiffer} Give a sleeve (`braids`), a `stiffness`, or a muscle file with strands."))
}

/// An overexpanded sleeve expands to so many times its least diameter.
const EXPANDS: f64 = 4.0;
/// Least diameters in mm, and the ratio of one to the next.
const SIZES: (f64, f64) = (2.0, 80.0);
const RATIO: f64 = 1.15;

/// Which sleeve would make a muscle that fits, in a sentence; none where no size does. Of a joint, whose search takes seconds, nothing is looked for.
pub(super) fn that_fits(spec: &Spec, models: Models<'_>, progress: &dyn Progress) -> Option<String> {
    if spec.tubes.is_empty() || matches!(spec.wanted, Demand::Joint(_)) {
        return None;
    }
    let sizes = std::iter::successors(Some(SIZES.0), |d| Some(d * RATIO)).take_while(|d| *d <= SIZES.1);
    let sized = |least_mm| library::between("pet", least_mm, EXPANDS * least_mm).ok()?.on(least_mm).ok();
    let braid = BraidChoice::Sleeves(sizes.filter_map(sized).collect());
    let wider = Spec { braid, top: 1, ..spec.clone() };
    let found = design_with(&wider, Models { settle: None, ..models }, progress).ok()?;
    let first = found.candidates.first()?;
    let shape = first.muscle.braid().sleeve.as_ref()?;
    let [least, largest] = [shape.least_mm, shape.largest_mm].map(|mm| number(mm, 2));
    let expands = format!("One of polyester that expands from {least} to {largest} mm would");
    Some(format!("No sleeve of the catalogue fits. {expands}, with the tube {}.", first.tube.as_deref()?))
}

/// A wall that nobody makes.
pub(super) fn thin_wall(muscle: &Muscle) -> Option<String> {
    /// Tubes and hoses of rubber have walls of at least half a millimetre, and of a fiftieth of their diameter.
    const LEAST: (f64, f64) = (0.5, 0.02);
    let (wall, diameter) = (muscle.wall_mm(), muscle.outer_diameter_mm());
    let least = LEAST.0.max(LEAST.1 * diameter);
    (wall < least * (1.0 - 1e-9)).then(|| {
        let [wall, diameter, least] = [wall, diameter, (10.0 * least).ceil() / 10.0].map(|mm| number(mm, 3));
        let made =
            format!("tubes of this diameter have walls of {least} mm or more; limit the walls (`wall_mm`)");
        format!("a wall of {wall} mm on a tube of {diameter} mm is rarely available: {made}")
    })
}
