//! Would a muscle as sold do? Those of the library that have a product, held against the
//! specification.
//!
//! Nobody tries such a muscle before it is bought: it does where its pull less its ± (95 %, or the share that is guaranteed) meets every
//! operating point by finite elements, at the supply's pressure or the highest of its bench where
//! that is lower, and where bulged diameter and liquid volume meet the limits of the specification.
//! Its length is the one that the specification states, since such muscles are cut to length; else
//! that of the bench. Burst, strands and rubber are its seller's matter: they are not checked.

use crate::{Build, Limits, OperatingPoint, Spec, fits};
use mckibben_core::{
    analysis::Evaluation,
    by_number::*,
    model::Workspace,
    muscle::{Muscle, Tube},
};
use serde::Serialize;

/// The ± that a muscle as sold must leave, where nothing is guaranteed.
const GUARANTEED: f64 = 0.95;
/// A specification of more operating points is not held against the library.
const MOST_POINTS: usize = 50;

/// A muscle of the library, as sold, that would do.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "BoughtAnswer")]
pub struct Bought {
    /// Its name, which may stand where a muscle file may: `lib:dmsp-20-300`.
    pub name: String,
    /// The product.
    pub product: String,
    /// Outer diameter D0 at rest, mm.
    pub outer_diameter_mm: f64,
    /// Length L0, mm: that of the specification, or of its bench.
    pub length_mm: f64,
    /// The pressure at which it does: that of the supply, or the highest of its bench, MPa.
    pub pressure_mpa: f64,
    /// The operating point at which it has least to spare.
    pub wanted: OperatingPoint,
    /// Its pull there, N.
    pub force_n: f64,
    /// 95 % half-width of that pull, N.
    pub uncertainty_n: f64,
}

/// A muscle as sold.
#[derive(Debug, Clone)]
pub struct Product<'a> {
    pub name: String,
    /// What its seller calls it.
    pub product: &'a str,
    /// The muscle, with the bench on which it was measured.
    pub muscle: &'a Muscle,
}

/// The muscles as sold that would do, the slimmest first.
///
/// `is_cut` states whether the specification has a length, to which such muscles are cut.
pub fn bought<'a>(
    spec: &Spec,
    is_cut: bool,
    build: &Build<'_>,
    products: impl IntoIterator<Item = Product<'a>>,
) -> Vec<Bought> {
    if spec.wanted.extends() {
        return vec![];
    }
    let meets = |product| meets(spec, is_cut, build, product);
    let mut found: Vec<Bought> = products.into_iter().filter_map(meets).collect();
    found.sort_by_number(|a| a.outer_diameter_mm);
    found
}

/// What a muscle does, where it meets the specification.
fn meets(spec: &Spec, is_cut: bool, build: &Build<'_>, product: Product<'_>) -> Option<Bought> {
    let max_pressure_mpa =
        (spec.supply_share * spec.max_pressure_mpa).min(product.muscle.bench()?.pressure_mpa.1);
    let muscle = of_length(spec, is_cut, product.muscle)?;
    let held = Spec {
        max_pressure_mpa,
        supply_share: 1.0,
        base: muscle.clone(),
        limits: Limits {
            bulged_diameter_mm: spec.limits.bulged_diameter_mm,
            liquid_volume_mm3: spec.limits.liquid_volume_mm3,
            ..Limits::default()
        },
        guaranteed: Some(spec.guaranteed.unwrap_or(GUARANTEED)),
        ..spec.clone()
    };
    let points = held.wanted.points(muscle.length_mm());
    if points.len() > MOST_POINTS || !fits(&held, build, &muscle) {
        return None;
    }
    let model = build(&muscle).ok()?;
    let w = &mut Workspace::new();
    let mut model = Evaluation::new(&*model, w, held.options());
    let mut at = |q: &OperatingPoint| {
        let model_n = model.force_n(max_pressure_mpa, q.contraction).ok()?;
        let (built, _) = model.predicted(max_pressure_mpa, q.contraction, model_n)?;
        Some((*q, built.predicted_n, built.half_n()))
    };
    let all: Vec<(OperatingPoint, f64, f64)> = points.iter().map(&mut at).collect::<Option<_>>()?;
    let spare = |(q, force_n, half): &(OperatingPoint, f64, f64)| (force_n - half) / q.force_n;
    let (wanted, force_n, uncertainty_n) = all.into_iter().min_by_number(spare)?;
    Some(Bought {
        name: product.name,
        product: product.product.to_owned(),
        outer_diameter_mm: muscle.outer_diameter_mm(),
        length_mm: muscle.length_mm(),
        pressure_mpa: max_pressure_mpa,
        wanted,
        force_n,
        uncertainty_n,
    })
}

/// The muscle cut to the length that is stated; `None` where its own lies outside of the lengths
/// that are searched.
fn of_length(spec: &Spec, is_cut: bool, muscle: &Muscle) -> Option<Muscle> {
    if let Some(lengths) = &spec.length_mm {
        let (low, high) = lengths.bounds();
        let is_inside = (low..=high).contains(&muscle.length_mm());
        return is_inside.then(|| muscle.clone());
    }
    if !is_cut || spec.base.length_mm() == muscle.length_mm() {
        return Some(muscle.clone());
    }
    // The ± of its bench is that of its own length: the other one has the general ±.
    let tube = Tube {
        length_mm: spec.base.length_mm(),
        ..muscle.tube().clone()
    };
    muscle.with_tube(tube).ok()
}
