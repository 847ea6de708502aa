//! A checked muscle as people read it.

use super::{Characteristics, CheckAnswer, FindingKind};
use crate::{
    LimitRows, Units, number,
    print::{Csv, Page, Rows, Show},
    units::{DEGREES, GRAMS, JOULES, MEGAPASCALS, NORMAL_LITRES, NUMBER, PERCENT},
    words::{braid_name, law_text},
};
use mckibben_core::{
    joined,
    muscle::{EndFactor, Muscle},
    warning::Warning,
};

/// The kinds, each with its heading, and what is said where nothing was found.
const HEADINGS: [(FindingKind, &str, &str); 4] = [
    (
        FindingKind::Implausible,
        "Is it plausible?",
        "nothing unusual was found",
    ),
    (
        FindingKind::Unknown,
        "What is not known",
        "nothing is missing",
    ),
    (
        FindingKind::Outside,
        "Outside of the measured muscles",
        "it lies within the sizes and pressures of measured muscles",
    ),
    (
        FindingKind::Measure,
        "What to measure first",
        "no measurement would reduce the ± much",
    ),
];

impl Show for CheckAnswer {
    /// The others are among the findings.
    fn warnings(&self) -> Vec<Warning> {
        self.warnings
            .iter()
            .filter(|w| w.is_of_burst())
            .cloned()
            .collect()
    }

    fn page(&self, u: &Units) -> Page {
        let mut page = Page::default();
        for (heading, rows) in self.sheets(u) {
            page.paragraph(heading);
            page.rows(rows);
        }
        if let Some(c) = &self.characteristics {
            let at = u.pressure.show(c.pressure_mpa);
            page.paragraph(format!("At {at}, model {}", c.model));
            page.rows(c.rows(u));
            page.lines(c.uncertainty_words.text_in(u));
        }
        for (kind, heading, none) in HEADINGS {
            page.paragraph(heading);
            let mut said = self.sentences(kind, u);
            if said.is_empty() {
                said.push(none.into());
            }
            page.lines(said.iter().map(|line| format!("  - {}", u.sentence(line))));
        }
        page
    }

    fn csv(&self) -> Csv {
        Csv::flat(self)
    }
}

impl Characteristics {
    /// The blocked force of a built muscle and that of the model; of a model that was named first.
    fn blocked_rows(&self, u: &Units) -> Rows {
        let words = &self.uncertainty_words;
        let model = u.force.of(self.blocked_force_n);
        match words.pull_in(u) {
            Some(built) if !self.is_model_named => {
                let alone = model.into_iter().chain(words.model_in(u));
                Rows::default()
                    .text("blocked force", built)
                    .text("by the model alone", joined(alone, "; "))
            }
            built => Rows::default()
                .text("blocked force", model)
                .text("as built", built),
        }
    }

    /// The lines of measures, limits and costs.
    pub fn rows(&self, u: &Units) -> Rows {
        let limits = self.limits.rows(u);
        let unknown = limits.is_empty().then_some("not stated");
        Rows::default()
            .and(self.blocked_rows(u))
            .quantity("free contraction", &PERCENT, self.free_contraction)
            .quantity("work of a free stroke", &JOULES, self.work_j)
            .quantity("cavity at its end", &u.volume, self.volume_mm3)
            .quantity(
                "air of a free stroke",
                &NORMAL_LITRES,
                self.air_normal_litres,
            )
            .quantity("liquid of a free stroke", &u.volume, self.liquid_volume_mm3)
            .and(limits)
            .text("burst pressure", unknown)
    }
}

impl CheckAnswer {
    /// What was understood of a muscle, what follows from it, and how to build it.
    pub fn sheets(&self, u: &Units) -> [(&'static str, Rows); 3] {
        [
            ("Muscle", self.understood(u)),
            ("Derived", self.derived_rows(u)),
            ("Build sheet", self.build_rows(u)),
        ]
    }

    fn understood(&self, u: &Units) -> Rows {
        let m = &self.muscle;
        let summary = &self.summary;
        let braid = self.stiffness_n_per_mm.map(|k| {
            let stiffness = u.stiffness().show(k);
            format!("{} ({stiffness} a strand family)", braid_name(m))
        });
        let bulk = MEGAPASCALS.of(self.bulk_modulus_mpa);
        let strands = m.braid().strands;
        let estimate = summary.estimate();
        let strength = strands.and_then(|s| Some(u.force.show(s.strength_n?) + estimate));
        let end_factor = m.terminals().end_factor.map(|factor| match factor {
            EndFactor::Constant(k) => number(k, 4),
            EndFactor::OfPressure { a, b } => {
                format!("{} e^(−P/bar) + {}", number(a, 4), number(b, 4))
            }
        });
        let mut rows = Rows::default()
            .quantity("outer diameter D0", &u.length, summary.outer_diameter_mm)
            .quantity("wall s", &u.length, summary.wall_mm)
            .quantity("length L0", &u.length, summary.length_mm)
            .quantity("braid angle θ0", &DEGREES.digits(5), summary.angle_deg)
            .text("rubber", &summary.rubber)
            .text("law", law_text(&m.tube().rubber.law))
            .text("largest stretch", reach(m))
            .quantity("shear modulus", &MEGAPASCALS, self.shear_modulus_mpa)
            .text("bulk modulus", bulk.unwrap_or("incompressible".into()))
            .text("braid", braid.unwrap_or("inextensible".into()))
            .text(
                "strands in compression",
                if m.braid().compression {
                    "carry load"
                } else {
                    "go slack"
                },
            )
            .quantity(
                "stiffness within a factor of",
                &NUMBER.digits(3),
                summary.stiffness_factor,
            )
            .text("strands", strands.map(|s| format!("{}{estimate}", s.count)))
            .text("strand strength", strength)
            .text("end factor", end_factor);
        for (measure, v) in self.stated.iter().filter(|(measure, _)| measure.is_shown) {
            rows = rows.text(measure.label, u.show(measure.dimension, v));
        }
        rows.text("friction", friction(m, u))
    }

    fn derived_rows(&self, u: &Units) -> Rows {
        let derived = &self.derived;
        let summary = &self.summary;
        let both = GRAMS.of(summary.mass_g);
        let rubber = GRAMS.of(summary.rubber_mass_g).filter(|_| both.is_none());
        Rows::default()
            .text("kind", derived.kind.to_string())
            .quantity("inner diameter", &u.length, derived.inner_diameter_mm)
            .quantity("strand length", &u.length, derived.strand_length_mm)
            .quantity("turns of a strand", &NUMBER, derived.turns)
            .quantity(
                "strand length per turn",
                &u.length,
                derived.strand_length_per_turn_mm,
            )
            .quantity(
                if derived.max_ideal_contraction < 0.0 {
                    "largest ideal extension"
                } else {
                    "largest ideal contraction"
                },
                &PERCENT,
                derived.max_ideal_contraction.abs(),
            )
            .quantity("cavity at rest", &u.volume, derived.volume_mm3)
            .text(
                "mass of tube and sleeve",
                both.map(|mass| mass + ", without terminals"),
            )
            .text(
                "mass of the rubber",
                rubber.map(|mass| mass + ", without braid and terminals"),
            )
    }

    /// What to cut and clamp.
    fn build_rows(&self, u: &Units) -> Rows {
        let m = &self.muscle;
        let sheet = self.muscle.build_sheet();
        let mm = |v: f64| u.length.show(v);
        let assumed = match m.terminals().insertion_mm {
            None => ", assumed",
            Some(_) => "",
        };
        let fit = match m.terminals().plug_diameter_mm {
            None => ", and what a tight fit adds",
            Some(_) => "",
        };
        let tube = mm(sheet.tube_cut_mm);
        let clamp = mm(m.insertion_mm());
        let (braid, angle) = (mm(sheet.braid_cut_mm), number(m.braid().angle_deg, 4));
        let strands = sheet
            .strands
            .map(|n| format!("{n}{}", self.summary.estimate()));
        Rows::default()
            .text(
                "tube to cut",
                format!("{tube} ({clamp}{assumed} on each plug)"),
            )
            .text("braid to cut", format!("{braid} at {angle}°"))
            .text("strand in the braid", mm(sheet.strand_cut_mm))
            .text("plug diameter", mm(sheet.plug_diameter_mm) + fit)
            .text("strands", strands.unwrap_or("not stated".into()))
            .text("rubber", u.volume.show(sheet.rubber_volume_mm3))
    }
}

/// How far the muscle stretches its rubber, and how far the rubber is known.
fn reach(m: &Muscle) -> String {
    let known = m
        .tube()
        .rubber
        .fitted_to_stretch
        .map(|end| format!(", fitted up to {}", number(end, 3)));
    let place = if m.is_extensile() {
        "along the tube"
    } else {
        "at the bore"
    };
    format!(
        "{} {place}{}",
        number(m.reach(), 3),
        known.unwrap_or_default()
    )
}

fn friction(m: &Muscle, u: &Units) -> Option<String> {
    let f = m.friction()?;
    let force = u.force.show(f.coefficient);
    let exponent = number(f.exponent, 3);
    let rule = format!("± {force} · (P/MPa)^{exponent}");
    let contact = format!("of the strands' contact, μw {}", u.length.show(f.lever_mm));
    Some(match (f.coefficient > 0.0, f.lever_mm > 0.0) {
        (true, true) => format!("{rule}, and {contact}"),
        (false, true) => contact,
        _ => rule,
    })
}
