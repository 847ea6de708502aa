//! A point as people read it.

use super::{Background, PointAnswer};
use crate::{
    PointQuantity, Scale, Units,
    print::{Page, Rows, Show, sentences},
    units::{NUMBER, PERCENT},
};
use mckibben_core::answer::Answer;

impl Show for PointAnswer {
    fn warnings(&self) -> Vec<String> {
        sentences(&self.point.warnings)
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
    pub(crate) fn limit_rows(&self, u: &Units) -> Rows {
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

    fn half_width(self, of: &Answer) -> Option<f64> {
        match self {
            Self::Force => of.uncertainty_n,
            Self::Pressure => of.pressure_uncertainty_mpa,
            Self::Contraction => of.contraction_uncertainty,
        }
    }
}

impl PointAnswer {
    pub(crate) fn rows(&self, u: &Units) -> Rows {
        let a = &self.point;
        let background = &self.background;
        let r = &a.response;
        let length = u.length.digits(4);
        // The ± belongs to what was sought.
        let quantity = |quantity: PointQuantity| {
            let scale = quantity.scale(u);
            let value = quantity.value(a);
            match quantity.half_width(a) {
                _ if quantity != self.sought => scale.of(value),
                None => Some(format!("{} ± unknown {}", scale.bare(value), scale.name)),
                half => scale.of((value, half)),
            }
        };
        let pull = if a.slack {
            let zero = u.force.show(0.0);
            Some(format!("{zero} (slack: the muscle would have to push)"))
        } else {
            quantity(PointQuantity::Force)
        };
        let of = match self.sought {
            PointQuantity::Force => "",
            _ => "of the pull ",
        };
        let words = &background.uncertainty_words;
        Rows::default()
            .text("muscle", background.muscle.line(u))
            .text(
                "model",
                format!("{} ({})", a.model, background.about.source),
            )
            .text("pressure", quantity(PointQuantity::Pressure))
            .quantity("pressure from (95 %)", &u.pressure, a.pressure_low_mpa)
            .quantity("pressure to (95 %)", &u.pressure, a.pressure_high_mpa)
            .text("contraction", quantity(PointQuantity::Contraction))
            .quantity("contraction from (95 %)", &PERCENT, a.contraction_low)
            .quantity("contraction to (95 %)", &PERCENT, a.contraction_high)
            .quantity(
                "shortening",
                &length,
                r.contraction * background.muscle.length_mm,
            )
            .text("pull", pull)
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
            .text("selected branch", words.branch_in(u))
            .text("suggested test", words.bench_in(u))
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
