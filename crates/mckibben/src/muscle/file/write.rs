//! Muscle → text that [`parse_muscle`](super::parse_muscle) reads back as the same muscle.

use super::keys::{Key, keys};
use super::text::{Text, number, quantity, text};
use crate::muscle::measures::of_section;
use crate::muscle::{Braid, BraidStiffness, EndFactor, Measure, Muscle, Rubber};
use crate::rubber::library;
use crate::sleeve::{self, Sleeve};
use crate::units::Dimension;

/// The text of a muscle file. Reading it gives the same muscle to the last bit, save that a
/// cross-section of strands which the braid's stiffness does not use becomes a comment, and that a
/// strain in percent may differ in its last bit.
pub fn to_toml(muscle: &Muscle) -> String {
    let mut out = Text::default();
    out.line(concat!(
        "# McKibben muscle, written by mckibben ",
        env!("CARGO_PKG_VERSION"),
        "."
    ));
    out.line("# A number without unit is in mm, MPa, N, N/mm, mm2 or degrees.");
    // Editors complete and check the file with what
    // `mckibben schema --file muscle -o muscle.schema.json` writes beside it.
    out.line("#:schema muscle.schema.json");
    let tube = muscle.tube();
    out.table("tube");
    out.measures(muscle, "tube");
    out.rubber(&tube.rubber, muscle.reach());
    out.braid(muscle, tube.outer_diameter_mm);
    for section in ["terminals", "friction"] {
        if written(muscle, section).next().is_some() {
            out.table(section);
        }
        out.measures(muscle, section);
    }
    let (factor, comment) = match muscle.terminals().end_factor {
        Some(EndFactor::OfPressure { a, b }) => (
            Some(format!("{{ a = {}, b = {} }}", number(a), number(b))),
            "k(P) = a·e^(−P) + b, P in bar (Tondu & Lopez 2000)",
        ),
        Some(EndFactor::Constant(k)) => (
            Some(number(k)),
            "multiplies the contraction (Tondu & Lopez 2000)",
        ),
        None => (None, ""),
    };
    let cones = muscle.terminals().cone_factor.map(number);
    let tips = "conical tips of length kc·L0·ε (Tondu 2012)";
    for (model, key, value, comment) in [
        ("tondu-lopez", "end_factor", factor, comment),
        ("conical-ends", "cone_factor", cones, tips),
    ] {
        if value.is_some() {
            out.table(&format!("model.{model}"));
            out.stated(key, value, comment);
        }
    }
    if let Some(bench) = muscle.bench() {
        out.table("identified");
        out.values(&keys("identified"), bench);
    }
    out.into_string()
}

impl Text {
    /// The measures of a table that are stated.
    fn measures(&mut self, muscle: &Muscle, section: &str) {
        for (measure, value) in written(muscle, section) {
            let text = match measure.dimension {
                Dimension::Ratio => number(value),
                _ => quantity(value, measure.unit()),
            };
            self.key(measure.name(), &text, measure.comment);
        }
    }

    fn rubber(&mut self, rubber: &Rubber, reach: f64) {
        let is_named = |name: &&str| library::find_for(name, reach).is_ok_and(|r| r == *rubber);
        let named = rubber.name.as_deref().filter(is_named);
        if let Some(name) = named {
            self.key(
                "rubber",
                &text(name),
                "or [tube.material] with a law and its constants",
            );
            return;
        }
        self.table("tube.material");
        let material = Key::material(std::slice::from_ref(rubber.law.kind()));
        let rubber = Rubber {
            fitted_to_stretch: rubber.fitted_to_stretch.filter(|stretch| *stretch > 0.0),
            prony: rubber
                .prony
                .clone()
                .filter(|series| !series.branches.is_empty()),
            ..rubber.clone()
        };
        self.values(&material, &rubber);
    }

    fn braid(&mut self, muscle: &Muscle, outer_diameter_mm: f64) {
        let braid = muscle.braid();
        self.table("braid");
        let sleeve = named_sleeve(braid, outer_diameter_mm);
        self.stated(
            "name",
            sleeve.as_ref().map(|s| text(s.name())),
            "a sleeve: `mckibben parts show`",
        );
        let angle_deg = braid
            .clone()
            .on_diameter(outer_diameter_mm)
            .map(|b| b.angle_deg);
        let is_usual = sleeve.is_some() && angle_deg == Ok(braid.angle_deg);
        let angle = Some(braid.angle_deg)
            .filter(|_| !is_usual)
            .map(|angle_deg| quantity(angle_deg, "deg"));
        self.stated("angle", angle, "strands to the muscle's axis, at rest");
        let stiffness = match braid.stiffness {
            BraidStiffness::Paper => Some(text("paper")),
            BraidStiffness::Inextensible => Some(text("inextensible")),
            BraidStiffness::NewtonPerMm(k) => Some(quantity(k, "N/mm")),
            BraidStiffness::OfStrands => None,
        };
        let is_stated = stiffness.is_some();
        let comment = "k of one strand family: \"321 N/mm\", \"inextensible\", or \"paper\"";
        self.stated("stiffness", stiffness, comment);
        // What the sleeve says by itself need not be written.
        let known = sleeve.as_ref().and_then(|sleeve| match is_stated {
            true => sleeve.strands_beside_stiffness(),
            false => sleeve.of_strands().ok(),
        });
        if let Some(strands) = braid.strands.as_ref().filter(|s| known.as_ref() != Some(s)) {
            self.key(
                "strands",
                &strands.count.to_string(),
                "both families together",
            );
            let (unused, why) = if is_stated {
                ("# ", "not used: `stiffness` is given")
            } else {
                ("", "of one strand")
            };
            let area = strands.section.map(|section| quantity(section.0, "mm2"));
            self.stated(&format!("{unused}strand_area"), area, why);
            let modulus = strands.section.map(|section| quantity(section.1, "MPa"));
            self.stated(&format!("{unused}strand_modulus"), modulus, "");
            let strength = strands
                .strength_n
                .map(|strength_n| quantity(strength_n, "N"));
            self.stated(
                "strand_strength",
                strength,
                "force at which one strand breaks",
            );
        }
        let follows = match &sleeve {
            Some(sleeve) if !is_stated && braid.strands == known => sleeve.stiffness_factor(),
            _ => 1.0,
        };
        let factor = Some(braid.stiffness_factor)
            .filter(|factor| *factor != follows)
            .map(number);
        let comment = "the stiffness is known within this factor; the ± of the pull carries it";
        self.stated("stiffness_factor", factor, comment);
        let of_sleeve = sleeve.and_then(|sleeve| sleeve.strands_per_carrier);
        let per_carrier = braid
            .strands_per_carrier
            .filter(|b| Some(*b) != of_sleeve)
            .map(number);
        self.stated(
            "strands_per_carrier",
            per_carrier,
            "side by side, which leaves openings between them",
        );
        self.measures(muscle, "braid");
        let compression = braid.compression.then(|| "true".into());
        self.stated("compression", compression, "strands that carry compression");
    }
}

/// The measures of a table that are stated and have no rules of their own.
fn written(muscle: &Muscle, section: &str) -> impl Iterator<Item = (&'static Measure, f64)> {
    let plain = of_section(section).filter(|m| !m.has_rules);
    plain.filter_map(|m| Some((m, muscle.measure(m)?)))
}

/// The sleeve that the braid was cut from, where its name and angle may be written together in a
/// file.
fn named_sleeve(braid: &Braid, outer_diameter_mm: f64) -> Option<Sleeve> {
    let shape = braid.sleeve.as_ref()?;
    let sleeve = sleeve::library::find(&shape.name)
        .ok()
        .filter(|s| s.shape == *shape)?;
    braid
        .clone()
        .with_stated_angle(braid.angle_deg, outer_diameter_mm)
        .is_ok()
        .then_some(sleeve)
}
