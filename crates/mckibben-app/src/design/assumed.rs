//! Assumed values: what a design uses where the request states nothing, and which of these values
//! keep muscles from fitting.

use super::request::DesignRequest;
use crate::{Model, Units, words::number};
use mckibben_core::{
    by_number::ByNumber,
    muscle::{Braid, BraidStiffness, Muscle},
    units::{Dimension, tidy},
};
use mckibben_design::{
    BraidChoice, Candidate, Demand, Outcome, Spec,
    tubes::{LEAST_CAST_WALL_MM, rubbers},
};

/// Pressure of a supply in MPa where none is given: that of a usual workshop.
pub const SUPPLY_MPA: f64 = 0.6;

/// What of a specification the request states.
pub struct Stated {
    supply: bool,
    rubber: bool,
    braid: bool,
    /// What would state the length, where it is not stated.
    pub length_by: Option<&'static str>,
    /// Whether a stroke sets the contraction.
    pub stroke_sets_contraction: bool,
}

impl Stated {
    pub fn new(request: &DesignRequest, model: &Model) -> Self {
        let stroke = request.stroke_mm.is_some();
        let contraction = request.contraction.is_some();
        let has_file = request.file().is_some() || matches!(model, Model::Formula(_));
        let is_assumed = request.length_mm.is_none() && !has_file && !stroke;
        Self {
            supply: request.max_pressure_mpa.is_some(),
            rubber: !request.rubbers.is_empty() || has_file,
            braid: request.stiffness.is_some() || has_file,
            length_by: is_assumed.then_some("`length_mm` or `stroke_mm`"),
            stroke_sets_contraction: stroke && !contraction && !request.length_is_searched(),
        }
    }

    /// What was assumed, in sentences.
    pub fn assumptions(&self, spec: &Spec, found: &Outcome) -> Vec<String> {
        let mut out = vec![];
        if let Some(first) = found.candidates.first().filter(|c| c.count > spec.count) {
            out.push(format!(
                "{} equal muscles share what is required: one alone is larger by half, or does not \
                 do it (`count`)",
                first.count
            ));
        }
        if !self.supply {
            let supply_mpa = spec.max_pressure_mpa;
            let range = if supply_mpa < SUPPLY_MPA {
                " and the formula holds up to that"
            } else {
                ""
            };
            out.push(format!(
                "the supply gives {supply_mpa}\u{a0}MPa, because no pressure is given{range} \
                 (`max_pressure_mpa`)"
            ));
        }
        if self.length_by.is_some() {
            let length_mm = number(spec.base.length_mm(), 5);
            let named = "(`length_mm`, or a muscle file)";
            out.push(format!(
                "the length L0 is {length_mm}\u{a0}mm, because none is given {named}"
            ));
        }
        if let (Demand::Load { .. }, Some(lengths)) = (&spec.wanted, &spec.length_mm) {
            let (low_mm, high_mm) = lengths.bounds();
            let [low, high] =
                [low_mm, high_mm].map(|mm| Units::default().show(Dimension::Length, tidy(mm, 3)));
            out.push(format!(
                "the length is searched from {low} to {high} (`length_mm`; `objective` for the \
                 shortest)"
            ));
        }
        out.extend(found.candidates.first().and_then(friction));
        if !spec.tubes.is_empty() {
            let estimated = |braid: &Braid| braid.stiffness_factor > 1.0;
            if matches!(&spec.braid, BraidChoice::Sleeves(list) if list.iter().any(estimated)) {
                out.push(
                    "diameter, stiffness and strength of strands that the seller does not \
                    publish are estimated (the catalogue of parts marks them); the ± includes \
                    these estimates and what no data sheet states"
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
        if !self.rubber {
            let named = "(`rubbers`, or a muscle file)";
            out.push(format!(
                "the rubber is that of the paper, because none is named {named}"
            ));
        }
        let is_paper = spec.base.braid().stiffness == BraidStiffness::Paper;
        if is_paper && !matches!(spec.braid, BraidChoice::Sleeves(_)) && !self.braid {
            let named = "(`braids`, `stiffness`, or a muscle file)";
            out.push(format!(
                "the braid is that of the paper, because none is named {named}"
            ));
        }
        out
    }
}

/// What friction takes off the pull of a model, where it is estimated.
fn friction(winner: &Candidate) -> Option<String> {
    let point = winner
        .points
        .iter()
        .filter(|q| q.friction_n != 0.0)
        .max_by_number(|a| a.friction_n.abs())?;
    let estimated = winner.muscle.friction().is_none();
    let moves = if point.friction_n < 0.0 {
        "shortens: friction takes"
    } else {
        "lengthens: friction adds"
    };
    let friction = Units::default().show(Dimension::Force, tidy(point.friction_n.abs(), 3));
    estimated.then(|| format!("the muscle {moves} {friction}, an estimate (`direction`)"))
}

/// A wall that nobody makes.
pub fn thin_wall(muscle: &Muscle) -> Option<String> {
    /// Tubes and hoses of rubber have walls of at least half a millimetre, and of a fiftieth of
    /// their diameter.
    const LEAST: (f64, f64) = (0.5, 0.02);
    let wall = muscle.wall_mm();
    let diameter = muscle.outer_diameter_mm();
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
