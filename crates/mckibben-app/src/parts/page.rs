//! What has a name, as people read it.

use super::{PartKind, PartShowAnswer, PartsListAnswer};
use crate::{
    LibraryFit, RubberDetails, Units,
    print::{Csv, Page, Show, Table},
    units::{MEGAPASCALS, NUMBER, PERCENT},
    words::law_text,
};
use mckibben_core::{rubber::library::Standing, warning::Warning};

impl Show for PartsListAnswer {
    fn page(&self, u: &Units) -> Page {
        let mut page = Page::default();
        page.list(
            "tubes",
            &self.tubes,
            u,
            &[
                "name",
                "inner_diameter_mm",
                "outer_diameter_mm",
                "wall_mm",
                "rubber",
                "is_cast",
            ],
        );
        page.list(
            "sleeves",
            &self.sleeves,
            u,
            &[
                "name",
                "least_diameter_mm",
                "largest_diameter_mm",
                "least_angle_deg",
                "strands",
                "stiffness_factor",
                "title",
            ],
        );
        page.list(
            "rubbers",
            &self.rubbers,
            u,
            &[
                "name",
                "shear_modulus_mpa",
                "law",
                "curve",
                "max_strain",
                "title",
            ],
        );
        page.list(
            "muscles",
            &self.muscles,
            u,
            &[
                "name",
                "outer_diameter_mm",
                "length_mm",
                "pressure_mpa",
                "blocked_force_n",
                "free_contraction",
                "points",
                "product",
                "source",
            ],
        );
        page.list("models", &self.models, u, &["name", "description"]);
        page.gap();
        if !self.muscles.is_empty() {
            page.line("A muscle replaces a file: mckibben force lib:dmsp-20-300 -p 5bar -e 10%");
        }
        page.line("`mckibben parts show NAME` shows source, price and use.");
        page
    }

    /// The kind that was asked for, else the tubes.
    fn csv(&self) -> Csv {
        match self.kind {
            None | Some(PartKind::Tubes) => Csv::rows(&self.tubes),
            Some(PartKind::Sleeves) => Csv::rows(&self.sleeves),
            Some(PartKind::Rubbers) => Csv::rows(&self.rubbers),
            Some(PartKind::Muscles) => Csv::rows(&self.muscles),
            Some(PartKind::Models) => Csv::rows(&self.models),
        }
    }
}

impl Show for PartShowAnswer {
    fn warnings(&self) -> Vec<Warning> {
        let rubber = self.rubber.as_ref();
        rubber.map_or_else(Vec::new, |rubber| rubber.warnings.clone())
    }

    fn page(&self, u: &Units) -> Page {
        let mut page = Page::of(self, u, &["fits", "muscle_file"]);
        if let Some(rubber) = &self.rubber {
            page.gap();
            rubber.fits_onto(&mut page);
        }
        if let Some(muscle) = &self.muscle {
            page.gap();
            page.lines(muscle.muscle_file.text.lines().map(str::to_owned));
        }
        page
    }
}

impl RubberDetails {
    /// The laws of a rubber, without those that the data refuse.
    fn fits_onto(&self, page: &mut Page) {
        let standing = |fit: &LibraryFit| fit.fitted.as_ref().map(|f| f.standing);
        let fits = Vec::from_iter(
            self.fits
                .iter()
                .filter(|fit| standing(fit) != Some(Standing::Behind)),
        );
        page.table(
            Table::of(&fits)
                .text("", |f| if f.by_reach { "→" } else { "" })
                .unaligned("reach", &NUMBER.digits(3), |f| f.reach_up_to)
                .quantity("data to", &PERCENT.digits(3), |f| f.up_to_strain)
                .text("points", |f| f.fitted.as_ref().map(|f| f.points))
                .text("law and constants", |f| law_text(&f.fit))
                .unaligned("μ", &MEGAPASCALS.digits(3), |f| f.shear_modulus_mpa)
                .unaligned("R²", &NUMBER.digits(5), |f| f.r_squared)
                .text("standing", |f| {
                    standing(f).map(|standing| match standing {
                        Standing::Recommended => "recommended",
                        Standing::Equal => "equal",
                        Standing::Behind => "behind",
                    })
                })
                .unaligned("differs", &PERCENT.digits(2), |f| {
                    f.fitted.as_ref().map(|f| f.planar_difference)
                }),
        );
        page.line(format!(
            "→: the name {} means it, for a muscle that stretches its rubber up to the reach \
             (`mckibben check`); between two reaches it means constants between theirs, beyond the \
             last those of the last.",
            self.rubber
        ));
        page.line(
            "standing: equal where the data do not distinguish a law from the recommended one. \
             differs: at most so much from it in planar tension. Laws that fit less well: in JSON.",
        );
    }
}
