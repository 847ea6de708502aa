//! Assumed values: what a design uses where the request states nothing, and which of these values
//! keep muscles from fitting.

use super::{plain, spec::Search};
use crate::{Model, words::number};
use mckibben_core::{
    by_number::ByNumber,
    muscle::{Braid, BraidStiffness, Muscle},
    units::{Dimension, tidy},
};
use mckibben_design::{
    BraidChoice, Candidate, Outcome,
    tubes::{LEAST_CAST_WALL_MM, rubbers},
};

/// Pressure of a supply in MPa where none is given: that of a usual workshop.
pub const SUPPLY_MPA: f64 = 0.6;

impl Search<'_> {
    /// Whether a muscle file or a formula states rubber, braid and length.
    fn has_file(&self) -> bool {
        self.request.file().is_some() || matches!(self.policy.model, Model::Formula(_))
    }

    /// Whether nothing states the length.
    pub fn is_length_assumed(&self) -> bool {
        let stated = self.request.length_mm.is_some() || self.request.stroke_mm.is_some();
        !stated && !self.has_file()
    }

    /// What was assumed, in sentences.
    pub fn assumptions(&self, found: &Outcome) -> Vec<String> {
        let Self { request, spec, .. } = self;
        let mut out = vec![];
        if let Some(first) = found.candidates.first().filter(|c| c.count > spec.count) {
            out.push(format!(
                "{} equal muscles share what is required: one alone is larger by half, or does not \
                 do it (`count`)",
                first.count
            ));
        }
        if request.max_pressure_mpa.is_none() {
            let supply_mpa = spec.max_pressure_mpa;
            let range = match supply_mpa < SUPPLY_MPA {
                true => " and the formula holds up to that",
                false => "",
            };
            out.push(format!(
                "the supply gives {supply_mpa}\u{a0}MPa, because no pressure is given{range} \
                 (`max_pressure_mpa`)"
            ));
        }
        if self.is_length_assumed() {
            let length_mm = number(spec.base.length_mm(), 5);
            out.push(format!(
                "the length L0 is {length_mm}\u{a0}mm, because none is given (`length_mm`, or a \
                 muscle file)"
            ));
        }
        if let (Some(_), Some(lengths)) = (spec.wanted.load(), &spec.length_mm) {
            let (low, high) = lengths.bounds();
            let show = |mm| plain(Dimension::Length, tidy(mm, 3));
            let [low, high] = [low, high].map(show);
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
                out.push(format!(
                    "tubes are sold, or cast of {cast} with walls of at least \
                     {LEAST_CAST_WALL_MM}\u{a0}mm"
                ));
            }
            return out;
        }
        if request.rubbers.is_empty() && !self.has_file() {
            out.push(
                "the rubber is that of the paper, because none is named (`rubbers`, or a muscle \
                 file)"
                    .into(),
            );
        }
        let is_stated = request.stiffness.is_some() || self.has_file();
        let is_paper = spec.base.braid().stiffness == BraidStiffness::Paper;
        if is_paper && !matches!(spec.braid, BraidChoice::Sleeves(_)) && !is_stated {
            out.push(
                "the braid is that of the paper, because none is named (`braids`, `stiffness`, or \
                 a muscle file)"
                    .into(),
            );
        }
        out
    }
}

/// What friction takes off the pull of a model, where it is estimated.
fn friction(winner: &Candidate) -> Option<String> {
    let frictions_n = winner.points.iter().map(|q| q.friction_n);
    let friction_n = frictions_n.max_by_number(|n| n.abs())?;
    if friction_n == 0.0 || winner.muscle.friction().is_some() {
        return None;
    }
    let moves = match friction_n < 0.0 {
        true => "shortens: friction takes",
        false => "lengthens: friction adds",
    };
    let friction = plain(Dimension::Force, tidy(friction_n.abs(), 3));
    Some(format!(
        "the muscle {moves} {friction}, an estimate (`direction`)"
    ))
}

/// A wall that nobody makes.
pub fn thin_wall(muscle: &Muscle) -> Option<String> {
    /// Tubes and hoses of rubber have walls of at least half a millimetre, and of a fiftieth of
    /// their diameter.
    const LEAST: (f64, f64) = (0.5, 0.02);
    let wall = muscle.wall_mm();
    let diameter = muscle.outer_diameter_mm();
    let least = LEAST.0.max(LEAST.1 * diameter);
    if wall >= least * (1.0 - 1e-9) {
        return None;
    }
    let least = (10.0 * least).ceil() / 10.0;
    let [wall, diameter, least] = [wall, diameter, least].map(|mm| number(mm, 3));
    Some(format!(
        "a wall of {wall}\u{a0}mm on a tube of {diameter}\u{a0}mm is rarely available: tubes of this \
         diameter have walls of {least}\u{a0}mm or more; limit the walls (`wall_mm`)"
    ))
}
