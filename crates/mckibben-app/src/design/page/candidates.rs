//! The table of candidates.

use crate::{
    CandidateAnswer, DesignAnswer, Units,
    print::{Page, Table},
    units::{DEGREES, GRAMS, NORMAL_LITRES, PERCENT},
};
use mckibben_core::joined;

impl DesignAnswer {
    /// The candidates with what differs among them; with `is_full` everything that is known of
    /// them.
    fn table(&self, u: &Units, is_full: bool) -> Table<'_, CandidateAnswer> {
        let list = &self.candidates;
        let have_tubes = list.iter().any(|c| c.candidate.tube.is_some());
        let have_lengths =
            self.searched.length_mm.is_none() || differ(list, |c| c.muscle.length_mm);
        let (length, length_3) = (u.length.digits(4), u.length.digits(3));
        let pressure = u.pressure.digits(3);
        let ranks = (1..=list.len()).map(|rank| format!("{rank}."));
        let mut table = Table::of(list)
            .column(" ".into(), ranks.collect())
            .text("tube", |c| c.candidate.tube.as_ref())
            .text("sleeve", |c| c.muscle.sleeve.as_ref());
        if is_full || !have_tubes {
            table = table
                .quantity("D0", &length, |c| c.muscle.outer_diameter_mm)
                .quantity("s", &length_3, |c| c.muscle.wall_mm)
                .quantity("θ0", &DEGREES, |c| c.muscle.angle_deg);
        }
        if have_lengths {
            table = table.quantity("L0", &length, |c| c.muscle.length_mm);
        }
        if is_full && differ(list, |c| c.family_stiffness_n_per_mm) {
            table = table.quantity("k", &u.stiffness().digits(3), |c| {
                c.family_stiffness_n_per_mm
            });
        }
        table = table
            .text(&u.pressure.heading("P required"), |c| {
                let points = c.candidate.points.iter();
                let needs = points.map(|q| u.pressure.to(q.response.pressure_mpa, 3));
                joined(needs, ", ")
            })
            .quantity("P sure", &pressure, |c| c.candidate.sure_pressure_mpa);
        if self.highest_differ() {
            table = table.quantity("P max", &pressure, |c| c.candidate.highest_pressure_mpa);
        }
        if is_full {
            let ratio = PERCENT.digits(3);
            table = table
                .quantity("margin", &ratio, |c| c.candidate.margin)
                .quantity("F blocked", &u.force.digits(4), |c| {
                    c.candidate.blocked_force_n
                })
                .quantity("ε free", &ratio, |c| c.candidate.free_contraction);
        }
        table = table.quantity("bulged D", &length_3, |c| c.bulged_diameter_mm);
        if is_full {
            let force = u.force.digits(3);
            table = table
                .quantity("stiffness", &u.stiffness().digits(3), |c| {
                    c.stiffness_n_per_mm
                })
                .quantity("liquid", &u.volume.digits(3), |c| c.liquid_volume_mm3)
                .quantity("air", &NORMAL_LITRES.digits(3), |c| c.air_normal_litres);
            table = if list.iter().any(|c| c.strand_tension_n.is_some()) {
                table.quantity("strand", &force, |c| c.strand_tension_n)
            } else {
                table.quantity("braid", &force, |c| c.braid_tension_n)
            };
        }
        table = table.text(&u.force.heading("±"), |c| {
            c.uncertainty_n.map(|half| u.force.half_width(half))
        });
        if is_full {
            table = table.quantity("P burst", &pressure, |c| c.limits.burst_pressure_mpa);
        }
        let mass = GRAMS.digits(3);
        table = if list.iter().any(|c| c.muscle.mass_g.is_some()) {
            table.quantity("mass", &mass, |c| c.muscle.mass_g)
        } else {
            table.quantity("rubber", &mass, |c| c.muscle.rubber_mass_g)
        };
        if !have_tubes && differ(list, |c| &c.muscle.rubber) {
            table = table.text("rubber", |c| &c.muscle.rubber);
        }
        table
    }

    fn highest_differ(&self) -> bool {
        differ(&self.candidates, |c| c.candidate.highest_pressure_mpa)
    }

    /// The table of the candidates, and what its headings mean.
    pub(super) fn candidates_onto(&self, page: &mut Page, u: &Units, is_full: bool) {
        page.table(self.table(u, is_full));
        let list = &self.candidates;
        let sure = if list.iter().any(|c| c.candidate.sure_pressure_mpa.is_some()) {
            " P sure: that at which the lower end of the ± meets it."
        } else {
            ""
        };
        let max = if self.highest_differ() {
            " P max: what supply and muscle allow."
        } else {
            ""
        };
        page.line(format!(
            "P required: the lowest pressure that gives each pull.{sure}{max}"
        ));
        if is_full {
            page.line(
                "margin: pull above the required pull, F blocked and ε free: at P max. stiffness: \
                 at the first point. bulged D, air or liquid, strand or braid, ±: the largest of \
                 the points.",
            );
            page.line(
                "air (normal litres: at 0 °C and 1.01325 bar) and liquid: from rest to the point. \
                 k: stiffness of one strand family. strand: tension of one strand; braid: of all \
                 together.",
            );
            page.line("±: 95 % half-width of the pull, against a measured muscle.");
            let first = list.first().map(|c| c.candidate.from_thick_wall.join(", "));
            let first = first.filter(|quantities| !quantities.is_empty());
            page.lines(first.map(|quantities| format!("From the thick-wall model: {quantities}.")));
        }
    }
}

/// Whether a value is not the same for all.
fn differ<'a, V: PartialEq>(
    list: &'a [CandidateAnswer],
    value: impl Fn(&'a CandidateAnswer) -> V,
) -> bool {
    list.windows(2).any(|w| value(&w[0]) != value(&w[1]))
}
