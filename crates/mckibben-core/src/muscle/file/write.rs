//! Muscle → text that [`parse_muscle`](super::parse_muscle) reads back as the same muscle.

use super::text::{Text, list, number, percent, quantity, text};
use crate::{
    muscle::{
        Bench, Braid, BraidStiffness, Bulk, Conditioned, EndFactor, Job, JobPoint, Measure, Muscle,
        OwnPoint, Rubber, Strands,
        measures::{STRANDS_FACTOR, STRENGTH_FACTOR, of_section},
    },
    rubber::{
        Law, library,
        over_time::{Branch, OgdenRoxburgh},
    },
    sleeve::{self, Sleeve, SleeveShape},
    units::{Dimension, Positive, typed::Pressure},
};

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
        let made = muscle.terminals().made.filter(|_| section == "terminals");
        if made.is_some() || written(muscle, section).next().is_some() {
            out.table(section);
        }
        out.stated(
            "made",
            made.map(|made| text(made.name())),
            "how the ends hold the braid",
        );
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
    if factor.is_some() {
        out.table("model.tondu-lopez");
        out.stated("end_factor", factor, comment);
    }
    if let Some(job) = muscle.job() {
        out.job(job);
    }
    if let Some(bench) = muscle.bench() {
        out.bench(bench);
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
        if let Some(name) = rubber.name.as_deref().filter(is_named) {
            self.key(
                "rubber",
                &text(name),
                "or [tube.material] with a law and its constants",
            );
            return;
        }
        self.table("tube.material");
        self.stated(
            "name",
            rubber.name.as_deref().map(text),
            "where the constants come from",
        );
        self.law(&rubber.law);
        let bulk = match rubber.bulk {
            Bulk::Incompressible => text("incompressible"),
            Bulk::Modulus(modulus_mpa) => quantity(modulus_mpa, "MPa"),
        };
        self.key("bulk_modulus", &bulk, "\"incompressible\", or a pressure");
        let stretch = rubber.fitted_to_stretch.filter(|stretch| *stretch > 0.0);
        self.stated(
            "fitted_to_stretch",
            stretch.map(number),
            "largest stretch of the data behind the constants",
        );
        self.stated(
            "elongation_at_break",
            rubber.elongation_at_break.map(percent),
            "at which a strip of it breaks",
        );
        let softening = rubber.softening.map(|OgdenRoxburgh { r, m_mpa, beta }| {
            let r = number(r);
            let m = quantity(m_mpa, "MPa");
            let beta = number(beta);
            format!("{{ r = {r}, m = {m}, beta = {beta} }}")
        });
        self.stated(
            "softening",
            softening,
            "of rubber that was stretched before (Ogden & Roxburgh 1999)",
        );
        let conditioned = rubber.conditioned.map(|seen| match seen {
            Conditioned::Pressure(pressure_mpa) => quantity(pressure_mpa, "MPa"),
            Conditioned::Strain { strain } => percent(strain),
        });
        self.stated(
            "conditioned",
            conditioned,
            "pressure of its cycles, or largest strain that all of it has seen",
        );
        let branch = |b: &Branch| {
            format!(
                "[{}, {}]",
                number(b.share),
                quantity(b.time_constant_s, "s")
            )
        };
        let series = rubber.prony.as_ref().filter(|s| !s.branches.is_empty());
        self.stated(
            "prony",
            series.map(|series| list(&series.branches, branch)),
            "shares of the stress that relax, and their time constants",
        );
    }

    fn law(&mut self, law: &Law) {
        let kind = law.kind();
        let values = law.values();
        self.key("law", &text(kind.name), "");
        for (i, constant) in kind.constants.iter().enumerate() {
            let one = |v: &f64| {
                if constant.is_modulus() {
                    quantity(*v, "MPa")
                } else {
                    number(*v)
                }
            };
            let terms: Vec<f64> = values
                .iter()
                .skip(i)
                .step_by(kind.constants.len())
                .copied()
                .collect();
            let value = if kind.is_sum {
                list(&terms, one)
            } else {
                terms.iter().map(one).collect()
            };
            self.key(constant.name, &value, constant.doc);
        }
    }

    fn job(&mut self, job: &Job) {
        let pressure = |p: Positive<Pressure>| quantity(p.into(), "MPa");
        self.table("job");
        self.key("pressure", &pressure(job.pressure), "to set");
        self.stated("supply", job.supply.map(pressure), "");
        self.stated(
            "branch",
            job.branch.map(|branch| text(branch.name())),
            "of the friction hysteresis",
        );
        self.stated("liquid", job.liquid.as_deref().map(text), "");
        let point = |q: &JobPoint| {
            let force = quantity(q.force.into(), "N");
            let contraction = number(q.contraction.into());
            format!("{{ force = {force}, contraction = {contraction} }}")
        };
        self.key("points", &list(&job.points, point), "required of it");
    }

    fn bench(&mut self, bench: &Bench) {
        let numbers = |row: &Vec<f64>| list(row, |v| number(*v));
        self.table("identified");
        self.stated(
            "laboratory",
            bench.laboratory.as_deref().map(text),
            "who measured it; the ± includes that yours is another specimen",
        );
        self.key(
            "model",
            &text(&bench.model),
            "by which the constants were found",
        );
        let lengths = Some(&bench.lengths_mm).filter(|lengths| !lengths.is_empty());
        self.stated(
            "lengths",
            lengths.map(|lengths| list(lengths, |l| quantity(*l, "mm"))),
            "of the muscles that were measured, this one first",
        );
        self.key("points", &bench.points.to_string(), "");
        self.key(
            "branches",
            &list(&bench.branches, |branch| text(branch.name())),
            "of the hysteresis loop that the points state; [] where they state none",
        );
        let (low, high) = bench.pressure_mpa;
        let pressure = list(&[low, high], |p| quantity(*p, "MPa"));
        self.key("pressure", &pressure, "");
        let (low, high) = bench.contraction;
        self.key("contraction", &numbers(&vec![low, high]), "");
        self.key(
            "pull_factor",
            &number(bench.pull_factor),
            "on the pull, that no constant explains",
        );
        self.key(
            "friction_share",
            &number(bench.friction_share),
            "half the width of the hysteresis loop over the strands' pull",
        );
        self.key("constants", &list(&bench.constants, |c| text(c.word())), "");
        self.key(
            "covariance",
            &list(&bench.covariance, numbers),
            "in the units of the constants",
        );
        let point = |(p, e, sign, off_n): &OwnPoint| numbers(&vec![*p, *e, *sign, *off_n]);
        self.key(
            "own_points",
            &list(&bench.own_points, point),
            "MPa, contraction, branch, measured less predicted in N",
        );
        self.key(
            "of",
            &text(&bench.of),
            "checksum of the muscle and of this table: it is not valid with other values",
        );
    }

    /// The strands, beside a stiffness that is stated or not.
    fn strands(&mut self, muscle: &Muscle, strands: Strands, is_stated: bool) {
        self.key(
            "strands",
            &strands.count.to_string(),
            "both families together",
        );
        let modulus_mpa = strands.modulus_mpa.filter(|_| !is_stated);
        for (key, value, unit, comment) in [
            ("strand_area", strands.area_mm2, "mm2", "of one strand"),
            ("strand_modulus", modulus_mpa, "MPa", ""),
            (
                "strand_strength",
                strands.strength_n,
                "N",
                "force at which one strand breaks",
            ),
        ] {
            self.stated(key, value.map(|value| quantity(value, unit)), comment);
        }
        for m in [&STRANDS_FACTOR, &STRENGTH_FACTOR] {
            self.stated(m.name(), (m.get)(muscle.parts()).map(number), m.comment);
        }
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
        if let Some(own) = sleeve
            .as_ref()
            .filter(|s| library_sleeve(&s.shape).is_none())
        {
            let (least, largest) = own.diameters();
            let comment = "at which its strands touch";
            self.key("least_diameter", &quantity(least, "mm"), comment);
            self.key("largest_diameter", &quantity(largest, "mm"), comment);
        }
        let angle_deg = braid
            .clone()
            .on_diameter(outer_diameter_mm)
            .map(|b| b.angle_deg);
        let is_usual = sleeve.is_some() && angle_deg == Ok(braid.angle_deg);
        self.stated(
            "angle",
            (!is_usual).then(|| quantity(braid.angle_deg, "deg")),
            "strands to the muscle's axis, at rest",
        );
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
        let known = sleeve.as_ref().and_then(|sleeve| {
            if is_stated {
                sleeve.strands_beside_stiffness()
            } else {
                sleeve.of_strands().ok()
            }
        });
        if let Some(strands) = braid.strands.filter(|s| known != Some(*s)) {
            self.strands(muscle, strands, is_stated);
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
        for (key, holds, comment) in [
            (
                "compression",
                braid.compression,
                "strands that carry compression",
            ),
            ("in_rubber", braid.in_rubber, "strands inside of the rubber"),
        ] {
            self.stated(key, holds.then(|| "true".into()), comment);
        }
    }
}

/// The measures of a table that are stated and have no rules of their own.
fn written(muscle: &Muscle, section: &str) -> impl Iterator<Item = (&'static Measure, f64)> {
    of_section(section)
        .filter(|m| !m.has_rules)
        .filter_map(|m| Some((m, muscle.measure(m)?)))
}

/// The sleeve of the library that has this shape.
fn library_sleeve(shape: &SleeveShape) -> Option<Sleeve> {
    Some(sleeve::library::find(&shape.name).ok()?).filter(|s| s.shape == *shape)
}

/// The sleeve that the braid was cut from, where its name and angle may be written together in a
/// file.
fn named_sleeve(braid: &Braid, outer_diameter_mm: f64) -> Option<Sleeve> {
    let shape = braid.sleeve.as_ref()?;
    let own = || {
        let sleeve = sleeve::library::between("pet", shape.least_mm, shape.largest_mm).ok()?;
        let is_unknown = sleeve::library::find(&shape.name).is_err();
        Some(sleeve.named(Some(&shape.name))).filter(|s| is_unknown && s.shape == *shape)
    };
    let sleeve = library_sleeve(shape).or_else(own)?;
    braid
        .clone()
        .with_stated_angle(braid.angle_deg, outer_diameter_mm)
        .is_ok()
        .then_some(sleeve)
}
