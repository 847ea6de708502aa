//! What has a name, as people read it.

use super::{ModelDetails, PartKind, PartShowAnswer, PartsListAnswer};
use crate::{
    BraidDetails, LibraryDetails, LibraryFit, RubberDetails, Units,
    print::{Csv, Page, Rows, Show, Table},
    units::{DEGREES, MEGAPASCALS, NUMBER, PERCENT, Scale},
    words::law_text,
};
use mckibben_core::{rubber::library::Standing, warning::Warning};
use mckibben_design::tubes::TubePart;

impl Show for PartsListAnswer {
    fn page(&self, u: &Units) -> Page {
        let length = u.length.digits(4);
        let mut page = Page::default();
        let tubes = Table::of(&self.tubes)
            .text("tube", |t| &t.name)
            .quantity("bore", &length, |t| t.inner_diameter_mm)
            .quantity("D0", &length, |t| t.outer_diameter_mm)
            .quantity("wall", &length, |t| t.wall_mm)
            .text("rubber", |t| &t.rubber.name)
            .text("cast", |t| t.is_cast);
        part(&mut page, tubes, &[]);
        let sleeves = Table::of(&self.sleeves)
            .text("sleeve", |s| &s.name)
            .quantity("D0 from", &length, |s| s.least_diameter_mm)
            .quantity("to", &length, |s| s.largest_diameter_mm)
            .quantity("θ0 from", &DEGREES.digits(3), |s| s.least_angle_deg)
            .text("strands", |s| s.strands)
            .quantity("k within", &NUMBER, |s| s.stiffness_factor)
            .text("title", |s| &s.title);
        let about = "D0: tubes on which a muscle of it contracts. k within: factor within which \
            the stiffness is known; above 1 where its seller does not state all of its strands.";
        part(&mut page, sleeves, &[about]);
        let rubbers = Table::of(&self.rubbers)
            .text("rubber", |r| &r.name)
            .unaligned("μ", &MEGAPASCALS.digits(3), |r| r.shear_modulus_mpa)
            .text("law", |r| &r.law)
            .text("curve", |r| r.curve)
            .quantity("breaks at", &PERCENT.digits(3), |r| r.max_strain)
            .text("title", |r| &r.title);
        let about = "μ: shear modulus at rest of the law that the name means in the prototype. \
            curve: fitted to its curve, up to the stretches in the prototype: another muscle may \
            use another law; NAME:LAW selects one.";
        part(&mut page, rubbers, &[about]);
        let muscles = Table::of(&self.muscles)
            .text("muscle", |m| &m.facts.name)
            .quantity("D0", &length, |m| m.muscle.outer_diameter_mm)
            .quantity("L0", &length, |m| m.muscle.length_mm)
            .unaligned("P", &u.pressure.digits(3), |m| m.pressure_mpa)
            .quantity("F blocked", &u.force.digits(4), |m| m.blocked_force_n)
            .quantity("ε free", &PERCENT.digits(3), |m| m.free_contraction)
            .text("points", |m| m.points)
            .text("product", |m| &m.facts.product)
            .text("source", |m| &m.facts.source);
        let about = [
            "P: highest pressure of the bench. F blocked, its ± (95 %) and ε free: there, by fe.",
            "A name replaces a muscle file: mckibben force lib:dmsp-20-300 -p 5bar -e 10%",
        ];
        part(&mut page, muscles, &about);
        let models = Table::of(&self.models)
            .text("model", |m| m.name)
            .text("description", |m| m.description);
        part(&mut page, models, &[]);
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

/// The table of a kind, and what its columns are.
fn part<T>(page: &mut Page, table: Table<'_, T>, about: &[&str]) {
    if !table.is_empty() {
        page.table(table);
        page.lines(about.iter().map(ToString::to_string));
        page.gap();
    }
}

impl Show for PartShowAnswer {
    fn warnings(&self) -> Vec<Warning> {
        let rubber = self.rubber.as_ref();
        rubber.map_or_else(Vec::new, |rubber| rubber.warnings.clone())
    }

    fn page(&self, u: &Units) -> Page {
        let details = [
            self.tube.as_ref().map(|tube| tube_rows(tube, u)),
            self.sleeve.as_ref().map(|sleeve| sleeve.rows(u)),
            self.rubber.as_ref().map(RubberDetails::rows),
            self.muscle.as_ref().map(|muscle| muscle.rows(u)),
            self.model.as_ref().map(ModelDetails::rows),
        ];
        let mut page = Page::default();
        for rows in details.into_iter().flatten() {
            page.rows(rows);
            page.gap();
        }
        if let Some(rubber) = &self.rubber {
            rubber.fits_onto(&mut page);
        }
        if let Some(sleeve) = &self.sleeve {
            page.table(
                Table::of(&sleeve.points)
                    .quantity("D0", &u.length.digits(4), |p| p.outer_diameter_mm)
                    .quantity("θ0", &DEGREES, |p| p.angle_deg)
                    .quantity("k", &u.stiffness(), |p| p.stiffness_n_per_mm)
                    .quantity("contracts by", &PERCENT, |p| p.largest_contraction),
            );
        }
        let file = self.muscle.iter().flat_map(|m| m.muscle_file.text.lines());
        page.lines(file.map(str::to_owned));
        page
    }
}

fn tube_rows(tube: &TubePart, u: &Units) -> Rows {
    let length = u.length.digits(4);
    let density = Scale::fixed("kg/m3");
    Rows::default()
        .text("tube", &tube.name)
        .quantity("bore", &length, tube.inner_diameter_mm)
        .quantity("outer diameter", &length, tube.outer_diameter_mm)
        .quantity("wall", &length, tube.wall_mm)
        .text("rubber", &tube.rubber.name)
        .quantity("density", &density, tube.density_kg_per_m3)
        .text("cast by hand", tube.is_cast)
        .text("price", &tube.price)
        .quantity("largest pressure named", &u.pressure, tube.pressure_mpa)
        .text("source", &tube.source)
        .text("note", &tube.note)
}

impl BraidDetails {
    fn rows(&self, u: &Units) -> Rows {
        let (entry, sleeve) = (&self.entry, &self.entry.sleeve);
        let (length, fine) = (u.length.digits(4), &u.length);
        Rows::default()
            .text("name", &self.name)
            .text("title", &entry.title)
            .quantity("nominal diameter", &length, entry.nominal_mm)
            .quantity("least diameter", fine, self.least_diameter_mm)
            .quantity("largest diameter", fine, self.largest_diameter_mm)
            .quantity("contracts below", fine, self.neutral_diameter_mm)
            .quantity(
                "strand length per turn",
                fine,
                self.strand_length_per_turn_mm,
            )
            .text("found from", &self.helix_from)
            .text("material", &entry.material)
            .text("strands", self.strands)
            .text("strands stated", self.strands_stated)
            .quantity("strand diameter", &length, sleeve.strand_diameter_mm)
            .quantity("strand modulus", &MEGAPASCALS, sleeve.strand_modulus_mpa)
            .text("modulus from", &self.modulus_source)
            .text("filaments", sleeve.filaments)
            .quantity(
                "strand strength",
                &u.force.digits(4),
                sleeve.strand_strength_n,
            )
            .text("estimated", sleeve.estimated.join(", "))
            .quantity(
                "stiffness known within a factor of",
                &NUMBER,
                self.stiffness_factor,
            )
            .text("estimates from", &self.estimate)
            .text("price", &entry.price)
            .text("for a stiffness give", self.missing.join(", "))
            .text("source", &entry.source)
            .text("terms", &entry.terms)
            .text("note", &entry.note)
    }
}

impl RubberDetails {
    fn rows(&self) -> Rows {
        let entry = &self.entry;
        Rows::default()
            .text("name", &entry.name)
            .text("title", &entry.title)
            .quantity(
                "breaks at a strain of",
                &PERCENT.digits(3),
                entry.max_strain,
            )
            .quantity(
                "at a stress of",
                &MEGAPASCALS.digits(3),
                entry.max_stress_mpa,
            )
            .text("curve in data/", &entry.data)
            .text("laws", self.laws.join(", "))
            .text("source", &entry.source)
            .text("terms", &entry.terms)
            .text("note", &entry.note)
    }

    /// The laws of a rubber, without those that the data refuse.
    fn fits_onto(&self, page: &mut Page) {
        let standing = |fit: &LibraryFit| fit.fitted.as_ref().map(|f| f.standing);
        let fits: Vec<&LibraryFit> = self
            .fits
            .iter()
            .filter(|fit| standing(fit) != Some(Standing::Behind))
            .collect();
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

impl LibraryDetails {
    fn rows(&self, u: &Units) -> Rows {
        let of = &self.muscle;
        let facts = &self.muscle.facts;
        let a = &self.agreement;
        let length = u.length.digits(4);
        let force = u.force.digits(3);
        Rows::default()
            .text("name", &facts.name)
            .text("title", &facts.title)
            .text("product", &facts.product)
            .quantity("outer diameter", &length, of.muscle.outer_diameter_mm)
            .quantity("wall", &length, of.muscle.wall_mm)
            .quantity("length", &length, of.muscle.length_mm)
            .quantity("angle", &DEGREES, of.muscle.angle_deg)
            .text("rubber", &of.muscle.rubber)
            .text("braid", &of.muscle.braid)
            .quantity("highest pressure", &u.pressure, of.pressure_mpa)
            .quantity("blocked force", &u.force.digits(4), of.blocked_force_n)
            .quantity("free contraction", &PERCENT.digits(3), of.free_contraction)
            .text("source", &facts.source)
            .text("terms", &facts.terms)
            .text("known", &facts.known)
            .text("unknown", &facts.unknown)
            .text("fit", &self.fit)
            .text("identified", self.identified.join(", "))
            .text("points", of.points)
            .quantity("rms difference", &force, a.rms_n)
            .quantity("of the blocked force", &PERCENT.digits(2), a.rms_of_blocked)
            .quantity("largest difference", &force, a.largest_n)
            .text("points of its length", a.bench_points)
            .quantity("within the ±", &PERCENT.digits(3), a.held)
    }
}

impl ModelDetails {
    fn rows(&self) -> Rows {
        Rows::default()
            .text("name", &self.name)
            .text("description", &self.description)
            .text("needs", &self.needs)
            .text("source", &self.source)
            .text("basis of the ±", &self.uncertainty_basis)
    }
}
