//! Where no sleeve of the catalogue fits: the strands, or the size of an expandable sleeve of polyester, that would.

use crate::words::number;
use mckibben::analysis::FailureMode;
use mckibben::muscle::Braid;
use mckibben::progress::Progress;
use mckibben::sleeve::{Helix, SleeveShape, library};
use mckibben_design::{BraidChoice, Closest, Demand, Models, Reason, Relaxation, Spec, design_with};

/// The sleeve whose filaments, material and estimates the others have.
const LIKE: &str = "flexo-overexpanded-0.75in";
/// It expands to so many times its least diameter.
const EXPANDS: f64 = 4.0;
/// Least diameters in mm, and the ratio of one to the next.
const SIZES: (f64, f64) = (2.0, 80.0);
const RATIO: f64 = 1.15;

/// The sleeve of a least diameter on a tube that it just fits.
fn sized(least_mm: f64) -> Option<Braid> {
    let mut sleeve = library::find(LIKE).ok()?;
    let largest_mm = EXPANDS * least_mm;
    let helix = Helix::jammed_at(least_mm, largest_mm)?;
    sleeve.shape = SleeveShape { name: "another".into(), helix, least_mm, largest_mm };
    sleeve.on(least_mm).ok()
}

/// The strength of the strands with which the closest muscle fits, where it misses nothing else.
pub(super) fn stronger_strands(closest: &Closest) -> Option<String> {
    let Reason::Burst { by: FailureMode::Strands, margin, limit } = closest.rejected.reason else {
        return None;
    };
    closest.relaxations.iter().find(|r| matches!(r, Relaxation::MinBurstMargin { .. }))?;
    let strength = closest.muscle.braid().strands?.strength_n?;
    let needed = (100.0 * strength * limit / margin).ceil() / 100.0;
    Some(format!(
        "It fits with strands that bear {} N each; those of this sleeve bear {} N.",
        number(needed, 3),
        number(strength, 3)
    ))
}

/// Which sleeve would make a muscle that fits, in a sentence; none where no size does. Of a joint, whose search takes seconds, nothing is looked for.
pub(super) fn that_fits(spec: &Spec, models: Models<'_>, progress: &dyn Progress) -> Option<String> {
    if spec.tubes.is_empty() || matches!(spec.wanted, Demand::Joint(_)) {
        return None;
    }
    let sizes = std::iter::successors(Some(SIZES.0), |d| Some(d * RATIO)).take_while(|d| *d <= SIZES.1);
    let braid = BraidChoice::Sleeves(sizes.filter_map(sized).collect());
    let wider = Spec { braid, top: 1, ..spec.clone() };
    let found = design_with(&wider, Models { settle: None, ..models }, progress).ok()?;
    let first = found.candidates.first()?;
    let shape = first.muscle.braid().sleeve.as_ref()?;
    Some(format!(
        "No sleeve of the catalogue fits. One of polyester that expands from {} to {} mm would, with the tube {}.",
        number(shape.least_mm, 2),
        number(shape.largest_mm, 2),
        first.tube.as_deref()?
    ))
}
