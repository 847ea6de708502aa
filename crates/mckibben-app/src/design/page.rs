//! A design as people read it.

mod candidates;

use super::{
    Bundle, CandidateJoint, ClosestAnswer, DemandAnswer, DesignAnswer, RejectedAnswer,
    answer::ChoiceAnswer,
};
use crate::{
    Units, number, percent,
    print::{Csv, Page, Rows, Show, Table},
    units::{NEWTON_METRES, NORMAL_LITRES, PERCENT},
};
use mckibben_core::{joined, units::rounded, warning::Warning};

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
        match &self.closest {
            Some(closest) => closest.onto(&mut page, u),
            None => self.found_onto(&mut page, u, is_full, winner),
        }
        if is_full {
            page.gap();
            self.search_onto(&mut page, u);
        }
        page.line("");
        page.lines(
            self.assumptions
                .iter()
                .map(|text| format!("Assumed: {}.", u.sentence(text))),
        );
        self.bought_onto(&mut page, u);
        let near = self
            .rejected
            .iter()
            .skip(usize::from(self.closest.is_some()));
        let mut near = near
            .map(|r| format!("  {}{}", r.line(u), r.missed_in_all()))
            .peekable();
        let heading = match &self.closest {
            Some(_) => "Next closest",
            None => "Near misses",
        };
        if (is_full || self.closest.is_some()) && near.peek().is_some() {
            page.paragraph(heading);
            page.lines(near);
        }
        page
    }

    /// The candidates with their ±, their bundle and their joint.
    fn found_onto(&self, page: &mut Page, u: &Units, is_full: bool, winner: Option<&str>) {
        page.gap();
        self.choices_onto(page, u);
        self.candidates_onto(page, u, is_full);
        if let Some(words) = self.uncertainty_words.as_ref().filter(|_| is_full) {
            page.lines(
                words
                    .text_in(u)
                    .map(|text| format!("± of the first: {text}.")),
            );
            page.lines(words.bench_in(u).map(|text| text + "."));
        }
        if let Some(bundle) = &self.bundle {
            bundle_onto(bundle, page, u);
        }
        let first = self.candidates.first();
        if let Some(joint) = first.and_then(|first| first.joint) {
            page.paragraph(joint.text(self.several(), winner, u));
        }
    }

    /// One muscle, the slimmest bundle, the sure and the cast one beside each other.
    fn choices_onto(&self, page: &mut Page, u: &Units) {
        let (length, force) = (u.length.digits(3), u.force.digits(2));
        let pull = |c: &ChoiceAnswer| {
            let ends = [c.predicted_low_n?, c.predicted_high_n?];
            let [low, high] = ends.map(|n| force.to(n, 2));
            Some(format!("{low} to {high}"))
        };
        let pulls = match &self.wanted {
            DemandAnswer::Points { points } if points.len() > 1 => {
                format!("pulls at {} (95 %)", percent(points[0].contraction))
            }
            _ => "pulls (95 %)".into(),
        };
        let table = Table::of(&self.choices)
            .text("choice", |c| &c.name)
            .quantity("width", &length, |c| c.envelope_mm)
            .quantity("L0", &length, |c| c.length_mm)
            .quantity("set", &u.pressure.digits(3), |c| c.pressure_mpa)
            .text(&pulls, pull)
            .quantity("air", &NORMAL_LITRES.digits(2), |c| c.air_normal_litres)
            .quantity("liquid", &u.volume.digits(2), |c| c.liquid_volume_mm3)
            .text("parts", |c| &c.parts);
        page.table(table);
        page.gap();
    }

    /// How many muscles share what is required, where it is more than one.
    fn several(&self) -> Option<u32> {
        Some(self.candidates.first()?.count).filter(|count| *count > 1)
    }

    /// What was required, searched and limited.
    fn search_onto(&self, page: &mut Page, u: &Units) {
        let searched = &self.searched;
        let liquid = self.liquid.as_ref();
        let each = self
            .several()
            .map(|count| format!(" of each of {count} muscles"));
        let gas = liquid.map(|l| l.gas_share).filter(|share| *share > 0.0);
        let guaranteed = searched.guaranteed.map(|share| {
            let share = percent(share);
            format!(", guaranteed: the lower end of the ± ({share}) meets it")
        });
        let required = [
            Some("Required".into()),
            each,
            Some(format!(": {}", self.wanted.text(self.load.as_deref(), u))),
            Some(format!(
                " with at most {}",
                u.pressure.show(self.max_pressure_mpa)
            )),
            liquid.map(|l| format!(" of {}", l.name)),
            gas.map(|share| format!(" with {} of gas", percent(share))),
            guaranteed,
        ];
        page.line(required.into_iter().flatten().collect::<String>());
        let other = Some(&self.searched_with).filter(|with| **with != self.model);
        let other = other
            .map(|with| format!(", searched with {with}"))
            .unwrap_or_default();
        let length = u.length.of(searched.length_mm);
        let length = length
            .map(|length| format!("L0 {length}, "))
            .unwrap_or_default();
        page.line(format!(
            "Model {}{other}; {} muscles examined, {} fit; {length}{}, {}",
            self.model, self.looked_at, self.fitting, searched.rubber, searched.braid
        ));
        let strain = searched
            .max_strand_strain
            .map(|strain| format!("strands stretched by at most {}; ", percent(strain)));
        let burst = match (searched.min_burst_margin, searched.min_tube_margin) {
            (None, _) => "no limit on burst".into(),
            (Some(factor), _) if !searched.burst_checked => format!(
                "burst not checked (safety factor {}), because the strength of the strands is not \
                 stated",
                number(factor, 4)
            ),
            (Some(strands), Some(tube)) => format!(
                "allowed pressure: that at which strands or clamps fail over {}, that of the tube \
                 over {}",
                number(strands, 4),
                number(tube, 4)
            ),
            (Some(_), None) => String::new(),
        };
        page.line(format!("Safety: {}{burst}", strain.unwrap_or_default()));
    }

    /// The muscles as sold that would do.
    fn bought_onto(&self, page: &mut Page, u: &Units) {
        let length = u.length.digits(4);
        let force = u.force.digits(4);
        let each = self.several().map(|count| format!(", {count} of one"));
        let table = Table::of(&self.bought)
            .text("product", |b| &b.product)
            .text("name", |b| &b.name)
            .quantity("D0", &length, |b| b.outer_diameter_mm)
            .quantity("L0", &length, |b| b.length_mm)
            .quantity("F", &force, |b| (b.force_n, Some(b.uncertainty_n)))
            .quantity("at", &PERCENT, |b| b.wanted.contraction)
            .quantity("P", &u.pressure, |b| b.pressure_mpa)
            .quantity("required", &force, |b| b.wanted.force_n);
        page.table_under(
            &format!("As sold these would do{}", each.unwrap_or_default()),
            table,
        );
    }
}

/// What the muscles of a bundle do together.
fn bundle_onto(bundle: &Bundle, page: &mut Page, u: &Units) {
    let length = u.length.digits(3);
    let force = u.force.digits(4);
    let is_one = bundle.muscles < 2;
    let apart = (!is_one && bundle.touch_contraction.is_none()).then_some("do not touch");
    page.paragraph(format!(
        "Bundle of {} of the first muscle, at the maximum pressure",
        bundle.muscles
    ));
    page.rows(
        Rows::default()
            .quantity(
                "circle around them at rest",
                &length,
                bundle.rest_envelope_mm,
            )
            .quantity("at the bulge", &length, bundle.envelope_mm)
            .quantity("width in one flat row", &length, bundle.row_mm)
            .quantity(
                "distance of their axes",
                &length,
                bundle.pitch_mm.filter(|_| !is_one),
            )
            .quantity("neighbours touch at", &PERCENT, bundle.touch_contraction)
            .text("neighbours touch at", apart),
    );
    page.table(
        Table::of(&bundle.points)
            .quantity("required", &force, |q| q.wanted.force_n)
            .quantity("at", &PERCENT, |q| q.wanted.contraction)
            .quantity("F", &force, |q| {
                (q.force_at_max_pressure_n, q.uncertainty_n)
            })
            .quantity("air", &NORMAL_LITRES.digits(3), |q| q.air_normal_litres)
            .quantity("liquid", &u.volume.digits(3), |q| q.liquid_volume_mm3),
    );
}

impl DemandAnswer {
    /// What the muscle must do, with the load as it was written.
    fn text(&self, load: Option<&str>, u: &Units) -> String {
        let load = load.unwrap_or_default();
        match self {
            Self::Points { points } => {
                let one = |q: &super::OperatingPoint| {
                    format!("{} at {}", u.force.show(q.force_n), percent(q.contraction))
                };
                joined(points.iter().map(one), ", ")
            }
            Self::Stroke { stroke_mm } => format!("{load} lifted by {}", u.length.show(*stroke_mm)),
            Self::Contraction { contraction } => {
                format!("{load} lifted to {}", percent(*contraction))
            }
            Self::Joint { torques, .. } => {
                let one = |t: &super::TorqueWanted| {
                    let torque = NEWTON_METRES.show(t.torque_nm);
                    let angle = number(t.angle_deg, 4);
                    format!("{torque} at ±{angle}°")
                };
                joined(torques.iter().map(one), ", ")
            }
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
    fn text(&self, several: Option<u32>, winner: Option<&str>, u: &Units) -> String {
        let share = several.map(|count| format!(" (its torque is that of one of {count})"));
        let share = share.unwrap_or_default();
        let radius = u.length.show(self.radius_mm);
        let neutral = self.neutral();
        let place = match winner {
            Some(_) => "beside the muscle file",
            None => "with the muscle in winner.toml (-o winner.toml)",
        };
        let file = self.file(winner.unwrap_or("winner.toml"));
        format!(
            "The first muscle on a pulley of radius {radius}, both muscles contracted by {neutral} % \
             at the neutral angle. As a joint file{share}, {place}:\n\n{}",
            file.trim_end()
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

    /// By how much it misses all limits together, where that is a share worth saying.
    fn missed_in_all(&self) -> String {
        let share = self.muscle.misses_by.filter(|share| *share < 1.0);
        let share = share.map(|share| percent((1e3 * share).ceil() / 1e3));
        share.map_or_else(String::new, |share| format!(" (misses by {share} in all)"))
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
        let changes = self.relaxations.iter();
        page.lines(changes.map(|change| format!("  - {}", u.sentence(&change.text))));
        page.lines(self.hint.clone());
    }
}
