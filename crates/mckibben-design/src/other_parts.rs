//! Where nothing fits: other parts with which a muscle does.

use crate::{
    BraidChoice, Build, Candidate, Closest, Demand, Models, Open, Relaxation, Spec, design_with,
    fits, tubes::cast_of,
};
use mckibben_core::{
    analysis::bisect,
    muscle::{Braid, BraidStiffness, Muscle},
    progress::Progress,
    sleeve::library,
    units::tidy,
};

/// An overexpanded sleeve expands to so many times its least diameter.
const EXPANDS: f64 = 4.0;
/// Least diameters in mm, and the ratio of one to the next.
const SIZES: (f64, f64) = (2.0, 80.0);
const RATIO: f64 = 1.15;
/// Rubbers of which tubes are cast by hand, where another one is looked for.
const CAST: [&str; 2] = ["ecoflex-00-50", "dragon-skin-10-medium"];
/// Factors on the stiffness of strands that are looked at, and halvings between 1 and the first
/// that does.
const STIFFER: [f64; 4] = [1.5, 2.5, 5.0, 10.0];
const HALVINGS: usize = 6;

/// A sleeve of another size, a tube of another rubber, stiffer strands. Not of a joint, whose
/// search takes longer.
pub fn other_parts(
    spec: &Spec,
    open: Open,
    models: Models<'_>,
    closest: &Closest,
    progress: &dyn Progress,
) -> Vec<Relaxation> {
    if spec.has_paper_braid() {
        let stiffer = stiffer(spec, models.decides(), &closest.rejected.muscle);
        return stiffer.into_iter().collect();
    }
    if spec.tubes.is_empty() || matches!(spec.wanted, Demand::Joint(_)) {
        return vec![];
    }
    let best = |other: Spec| -> Option<Candidate> {
        let found = design_with(&Spec { top: 1, ..other }, models, progress).ok()?;
        found.candidates.into_iter().next()
    };
    let sleeve = || {
        let best = best(Spec {
            braid: BraidChoice::Sleeves(sleeves_of_all_sizes()),
            ..spec.clone()
        })?;
        Some(Relaxation::Sleeve {
            sleeve: best.muscle.braid().sleeve.as_ref()?.name.clone(),
            tube: best.tube,
        })
    };
    let rubber = || {
        let cast = CAST.into_iter().filter_map(|name| cast_of(name).ok());
        let best = best(Spec {
            tubes: cast.flatten().collect(),
            ..spec.clone()
        })?;
        Some(Relaxation::Rubber {
            rubber: best.muscle.tube().rubber.name.clone()?,
            tube: best.tube?,
        })
    };
    let other_sleeve = open.sleeves.then(sleeve).flatten();
    let other_rubber = open.rubbers.then(rubber).flatten();
    other_sleeve.into_iter().chain(other_rubber).collect()
}

/// Sleeves of the most common strands, in steps of [`RATIO`].
fn sleeves_of_all_sizes() -> Vec<Braid> {
    let sizes =
        std::iter::successors(Some(SIZES.0), |d| Some(d * RATIO)).take_while(|d| *d <= SIZES.1);
    let sized = |least_mm: f64| {
        let least_mm = (10.0 * least_mm).round() / 10.0;
        let sleeve = library::between("pet", least_mm, EXPANDS * least_mm).ok()?;
        sleeve.on(least_mm).ok()
    };
    sizes.filter_map(sized).collect()
}

/// How stiff the strands of the paper's braid have to be.
fn stiffer(spec: &Spec, decide: &Build<'_>, muscle: &Muscle) -> Option<Relaxation> {
    let paper = muscle.family_stiffness_n_per_mm()?;
    let does = |factor: f64| {
        let braid = Braid {
            stiffness: BraidStiffness::NewtonPerMm(factor * paper),
            ..muscle.braid().clone()
        };
        muscle
            .with_braid(braid)
            .is_ok_and(|stiff| fits(spec, decide, &stiff))
    };
    let high = STIFFER.into_iter().find(|&factor| does(factor))?;
    let (_, high) = bisect(1.0, high, HALVINGS, |factor| !does(factor));
    Some(Relaxation::Stiffness {
        family_stiffness_n_per_mm: tidy(1.005 * high * paper, 3),
    })
}
