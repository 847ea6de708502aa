//! Where nothing fits: what to change, in sentences.

use super::assumed;
use super::request::DesignRequest;
use crate::{Units, number};
use mckibben::analysis::bisect;
use mckibben::muscle::{Braid, BraidStiffness, Muscle};
use mckibben::progress::Progress;
use mckibben::sleeve::library;
use mckibben_design::tubes::cast_of;
use mckibben_design::{
    BraidChoice, Build, Closest, Demand, Models, Relaxation, Spec, design_with, fits,
};
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
    /// Of a specification, where a stroke may set the contraction, in the numbers of its request:
    /// of all muscles together, and of the circle around them.
    pub(super) fn new(change: Relaxation, spec: &Spec, request: &DesignRequest) -> Self {
        let mut text = change.describe(spec, &|kind, value| Units::default().show(kind, value));
        let stroke = (request.stroke_mm, request.contraction);
        if let (Relaxation::Contraction { share, .. }, (Some(_), None)) = (&change, stroke) {
            let mm = (spec.base.length_mm() / share).ceil();
            text += &format!("; or keep the stroke with a length of {mm}\u{a0}mm");
        }
        if let Demand::Joint(joint) = &spec.wanted {
            text += &format!(
                ", with a pulley of radius {}\u{a0}mm (`radius_mm`)",
                number(joint.radius_mm, 5)
            );
        }
        Self { change, text }
    }
}

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

/// Other parts with which a muscle fits: a sleeve of another size, a tube of another rubber,
/// stiffer strands. Not of a joint, whose search takes longer.
pub(super) fn of_parts(
    request: &DesignRequest,
    spec: &Spec,
    models: Models<'_>,
    closest: &Closest,
    progress: &dyn Progress,
) -> Vec<Relaxation> {
    if assumed::is_paper(spec) {
        return stiffer(spec, models.decides(), &closest.rejected.muscle)
            .into_iter()
            .collect();
    }
    if spec.tubes.is_empty() || matches!(spec.wanted, Demand::Joint(_)) {
        return vec![];
    }
    let search = |other: Spec| {
        design_with(&Spec { top: 1, ..other }, models, progress)
            .ok()?
            .candidates
            .into_iter()
            .next()
    };
    let sizes =
        std::iter::successors(Some(SIZES.0), |d| Some(d * RATIO)).take_while(|d| *d <= SIZES.1);
    let sized = |least_mm: f64| {
        let least_mm = (10.0 * least_mm).round() / 10.0;
        library::between("pet", least_mm, EXPANDS * least_mm)
            .ok()?
            .on(least_mm)
            .ok()
    };
    let sleeve = || {
        let best = search(Spec {
            braid: BraidChoice::Sleeves(sizes.filter_map(sized).collect()),
            ..spec.clone()
        })?;
        let sleeve = best.muscle.braid().sleeve.as_ref()?.name.clone();
        Some(Relaxation::Sleeve {
            sleeve,
            tube: best.tube,
        })
    };
    let rubber = || {
        let cast = CAST
            .into_iter()
            .filter_map(|name| cast_of(name).ok())
            .flatten()
            .collect();
        let best = search(Spec {
            tubes: cast,
            ..spec.clone()
        })?;
        Some(Relaxation::Rubber {
            rubber: best.muscle.tube().rubber.name.clone()?,
            tube: best.tube?,
        })
    };
    let free_sleeve = request.braids.is_empty().then(sleeve).flatten();
    let free_rubber =
        (request.tubes.is_empty() && request.rubbers.is_empty() && request.parts.is_none())
            .then(rubber)
            .flatten();
    free_sleeve.into_iter().chain(free_rubber).collect()
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
        family_stiffness_n_per_mm: number(1.005 * high * paper, 3).parse().ok()?,
    })
}
