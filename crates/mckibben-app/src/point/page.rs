//! A point as people read it.

use super::{Background, PointAnswer};
use crate::{
    LimitRows, PointQuantity, Scale, Units,
    print::{Page, Rows, Show},
    uncertainty::bounds,
    units::{NUMBER, PERCENT},
};
use mckibben_core::{answer::Answer, joined, muscle::Direction, warning::Warning};

impl Show for PointAnswer {
    fn warnings(&self) -> Vec<Warning> {
        self.point.warnings.clone()
    }

    fn page(&self, u: &Units) -> Page {
        let mut page = Page::from(self.rows(u));
        if let Some(loaded) = &self.loaded {
            loaded.onto(&mut page, u);
        }
        page
    }
}

impl Background {
    /// What the muscle bears.
    pub fn limit_rows(&self, u: &Units) -> Rows {
        self.limits.rows_with(self.muscle.estimate(), u)
    }
}

impl PointQuantity {
    fn scale(self, u: &Units) -> Scale {
        match self {
            Self::Force => u.force.clone(),
            Self::Pressure => u.pressure.clone(),
            Self::Contraction => PERCENT,
        }
    }

    fn value(self, of: &Answer) -> f64 {
        match self {
            Self::Force => of.response.force_n,
            Self::Pressure => of.response.pressure_mpa,
            Self::Contraction => of.response.contraction,
        }
    }

    /// What it is of a muscle that is built, and the ends of its 95 % interval.
    fn built_in(self, of: &PointAnswer, u: &Units) -> Option<String> {
        let a = &of.point;
        let sought = match self {
            Self::Force => return of.background.uncertainty_words.pull_in(u),
            Self::Pressure => [
                a.predicted_mpa?,
                a.predicted_low_mpa?,
                a.predicted_high_mpa?,
            ],
            Self::Contraction => [a.predicted?, a.predicted_low?, a.predicted_high?],
        };
        let way = a.built.map_or_else(String::new, |built| built.way());
        Some(bounds(sought, &self.scale(u)) + &way)
    }
}

impl PointAnswer {
    /// The lines of the answer: the built muscle first.
    pub fn rows(&self, u: &Units) -> Rows {
        let a = &self.point;
        let background = &self.background;
        let r = &a.response;
        let length = u.length.digits(4);
        let words = &background.uncertainty_words;
        let is_pull = self.sought == PointQuantity::Force;
        let of = if is_pull { "" } else { "of the pull " };
        let built = a.predicted.filter(|_| !self.is_model_named);
        // Of a model that was named its number comes first, else that of a muscle that is built.
        let first = |quantity: PointQuantity| {
            self.sought
                .built_in(self, u)
                .filter(|_| quantity == self.sought && !self.is_model_named)
                .or_else(|| self.of_model(quantity, u))
        };
        Rows::default()
            .text("muscle", background.muscle.line(u))
            .text(
                "model",
                format!("{} ({})", a.model, background.about.source),
            )
            .text("pressure", first(PointQuantity::Pressure))
            .text("contraction", first(PointQuantity::Contraction))
            .quantity(
                "shortening",
                &length,
                built.unwrap_or(r.contraction) * background.muscle.length_mm,
            )
            .text("pull", first(PointQuantity::Force))
            .and(self.other_row(u))
            .and(self.branch_rows(u))
            .quantity("stiffness", &u.stiffness(), r.stiffness_n_per_mm)
            .quantity("pull per pressure", &u.slope(), r.force_per_pressure_mm2)
            .quantity("starts to pull at", &u.pressure, a.start_pressure_mpa)
            .quantity("free contraction", &PERCENT, a.free_contraction)
            .quantity("buckles at a push of", &u.force, a.buckling_load_n)
            .quantity("bulged diameter", &length, r.bulged_diameter_mm)
            .quantity("volume", &u.volume, r.volume_mm3)
            .quantity(
                "tension of one strand",
                &u.force.digits(4),
                r.strand_tension_n,
            )
            .quantity(
                "tension of all strands",
                &u.force.digits(4),
                r.braid_tension_n,
            )
            .and(background.limit_rows(u))
            .quantity(
                "stretch at mid-length, inside",
                &NUMBER.digits(3),
                r.middle_stretch,
            )
            .quantity(
                "99th percentile of stretch",
                &NUMBER.digits(3),
                r.max_stretch,
            )
            .text(
                "uncertainty",
                words.text_in(u).map(|text| format!("{of}{text}")),
            )
            .text("to measure", words.bench_in(u))
    }

    /// A quantity of the model's answer.
    fn of_model(&self, quantity: PointQuantity, u: &Units) -> Option<String> {
        let value = quantity.scale(u).of(quantity.value(&self.point))?;
        let is_slack = self.point.slack && quantity == PointQuantity::Force;
        let slack = " (slack: the muscle would have to push)";
        Some(value + if is_slack { slack } else { "" })
    }

    /// What was sought by the model, where that of a muscle that is built comes first; or that.
    fn other_row(&self, u: &Units) -> Rows {
        let words = &self.background.uncertainty_words;
        let direction = self.point.direction;
        let unknown = "unknown: see the warnings, or take the model fe";
        match self.sought.built_in(self, u) {
            None => Rows::default().text("as built", unknown),
            Some(built) if self.is_model_named => Rows::default().text("as built", built),
            Some(_) => {
                let value = self.of_model(self.sought, u);
                let value = value.map(|value| format!("{value}, {}", direction.motion()));
                let is_pull = self.sought == PointQuantity::Force;
                let shifts = words.model_in(u).filter(|_| is_pull);
                let value = match (direction, shifts) {
                    (Direction::Mean, Some(shifts)) => shifts,
                    (_, shifts) => joined(value.into_iter().chain(shifts), "; "),
                };
                Rows::default().text("by the model alone", value)
            }
        }
    }

    /// What was sought on both branches of the friction, and their distance.
    fn branch_rows(&self, u: &Units) -> Rows {
        let [shortening, lengthening] = &self.branches[..] else {
            return Rows::default();
        };
        let (sought, scale) = (self.sought, self.sought.scale(u));
        let on = |branch: &Answer| {
            if branch.slack && sought == PointQuantity::Force {
                Some("slack".to_owned())
            } else {
                scale.of(sought.value(branch))
            }
        };
        let band = (sought.value(shortening) - sought.value(lengthening)).abs();
        Rows::default()
            .text("while shortening", on(shortening))
            .text("while lengthening", on(lengthening))
            .quantity("friction's band", &scale, band)
    }
}
