//! A design as people read it.

use super::{CandidateJoint, ClosestAnswer, DesignAnswer, RejectedAnswer};
use crate::{
    Units, number,
    print::{Csv, Page, Rows, Show},
};
use mckibben_core::{units::rounded, warning::Warning};

/// Columns of the choices.
const CHOICES: [&str; 6] = [
    "name",
    "envelope_mm",
    "length_mm",
    "pressure_mpa",
    "parts",
    "liquid_volume_mm3",
];
/// Columns of the candidates.
const CANDIDATES: [&str; 11] = [
    "count",
    "chance",
    "width_mm",
    "outer_diameter_mm",
    "wall_mm",
    "length_mm",
    "angle_deg",
    "pressure_mpa",
    "highest_pressure_mpa",
    "mass_g",
    "sleeve",
];
/// Columns of muscles that do not fit.
const NEAR: [&str; 6] = [
    "count",
    "outer_diameter_mm",
    "wall_mm",
    "sleeve",
    "misses_by",
    "reason",
];
/// Fields that a page of everything has in other places.
const APART: [&str; 6] = [
    "decision",
    "choices",
    "assumptions",
    "rejected",
    "closest",
    "muscle_files",
];

impl Show for DesignAnswer {
    fn warnings(&self) -> Vec<Warning> {
        self.warnings.clone()
    }

    fn page(&self, u: &Units) -> Page {
        self.page_with(u, false, None)
    }

    fn csv(&self) -> Csv {
        Csv::rows(&self.candidates)
    }
}

impl DesignAnswer {
    /// The decision, the candidates, what is assumed; with `is_full` everything that is known.
    /// `winner` is the name of the file of the best muscle.
    pub fn page_with(&self, u: &Units, is_full: bool, winner: Option<&str>) -> Page {
        let mut page = Page::default();
        let decision = self.decision.iter().fold(Rows::default(), |rows, line| {
            let line = u.sentence(line);
            let (verb, rest) = line.split_once(' ').unwrap_or_default();
            rows.text(verb, rest)
        });
        page.rows(decision);
        page.list("", &self.choices, u, &CHOICES);
        match &self.closest {
            Some(closest) => closest.onto(&mut page, u),
            None if self.candidates.is_empty() => page.line("Nothing fits."),
            None => self.found_onto(&mut page, u, winner),
        }
        if is_full {
            page.line("");
            page.and(Page::of(self, u, &APART));
        }
        page.line("");
        page.lines(
            self.assumptions
                .iter()
                .map(|text| format!("Assumed: {}.", u.sentence(text))),
        );
        let near = &self.rejected[usize::from(self.closest.is_some())..];
        if self.closest.is_some() {
            page.list("Next closest", near, u, &NEAR);
        } else if is_full {
            page.list("Near misses", near, u, &NEAR);
        }
        page
    }

    /// The candidates with their ±, their bundle and their joint.
    fn found_onto(&self, page: &mut Page, u: &Units, winner: Option<&str>) {
        page.list("", &self.candidates, u, &CANDIDATES);
        if let Some(bundle) = &self.bundle {
            page.paragraph("Bundle of the first muscle");
            page.and(Page::of(bundle, u, &[]));
        }
        if let Some(first) = self.candidates.first()
            && let Some(joint) = first.joint
        {
            page.paragraph(joint.text(first.candidate.count, winner, u));
        }
    }
}

impl CandidateJoint {
    /// Contraction of both at the neutral angle in percent: not below the length at rest at the
    /// largest angle.
    fn neutral(&self) -> String {
        number(
            rounded(100.0 * self.contraction_at_neutral, 5, f64::ceil),
            5,
        )
    }

    /// The joint file of two muscles whose file it lies beside.
    pub fn file(&self, muscle_file: &str) -> String {
        let radius_mm = number(self.radius_mm, 5);
        let angle = number(self.largest_angle_deg, 4);
        let neutral = self.neutral();
        let name = muscle_file.replace('\\', "\\\\").replace('"', "\\\"");
        let muscle = |i: u8| {
            format!("\n[muscle_{i}]\nfile = \"{name}\"\ncontraction_at_neutral = \"{neutral}%\"\n")
        };
        format!(
            "[joint]\nradius = \"{radius_mm} mm\"\nrange = \"-{angle}..{angle} deg\"\n{}{}",
            muscle(1),
            muscle(2)
        )
    }

    /// The pulley between the muscles, and the joint file that goes with them. A joint file names
    /// its muscles relative to itself: it goes beside them.
    fn text(&self, count: u32, winner: Option<&str>, u: &Units) -> String {
        let share = match count {
            1 => String::new(),
            _ => format!(" (its torque is that of one of {count})"),
        };
        let radius = u.length.show(self.radius_mm);
        let neutral = self.neutral();
        let place = match winner {
            Some(_) => "beside the muscle file",
            None => "with the muscle in winner.toml (-o winner.toml)",
        };
        format!(
            "The first muscle on a pulley of radius {radius}, both muscles contracted by {neutral} % \
             at the neutral angle. As a joint file{share}, {place}:\n\n{}",
            self.file(winner.unwrap_or("winner.toml")).trim_end()
        )
    }
}

impl RejectedAnswer {
    /// The muscle with the limit that it misses.
    fn line(&self, u: &Units) -> String {
        let muscle = &self.muscle;
        let sleeve = muscle.sleeve.as_ref().map(|name| format!(" in {name}"));
        format!(
            "D0 {}, s {}{}: {}",
            u.length.to(muscle.outer_diameter_mm, 4),
            u.length.to(muscle.wall_mm, 3),
            sleeve.unwrap_or_default(),
            u.sentence(&self.reason)
        )
    }
}

impl ClosestAnswer {
    /// The muscle that comes closest, and what would make it fit.
    fn onto(&self, page: &mut Page, u: &Units) {
        page.line(format!("Nothing fits. Closest: {}", self.rejected.line(u)));
        page.line(match self.relaxations.len() {
            0 => "No change of what is required or limited makes a muscle of this search fit.",
            1 => "A muscle fits with this change:",
            _ => "A muscle fits with any of these changes, the smallest first:",
        });
        page.lines(
            self.relaxations
                .iter()
                .map(|change| format!("  - {}", u.sentence(&change.text))),
        );
    }
}
