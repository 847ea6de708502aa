//! A motion as people read it.

use super::{MotionAnswer, MotionRun};
use crate::{
    LimitRows, Units, number,
    print::{Csv, Page, Rows, Show, Table},
    uncertainty::bounds,
    units::{DEGREES, JOULES, NORMAL_LITRES, PERCENT, Scale},
};
use mckibben_core::warning::Warning;

const SECONDS: Scale = Scale::fixed("s");
const HERTZ: Scale = Scale::fixed("Hz");
/// Most events of a run that are shown.
const SHOWN: usize = 12;

impl Show for MotionAnswer {
    fn warnings(&self) -> Vec<Warning> {
        self.warnings.clone()
    }

    fn page(&self, u: &Units) -> Page {
        if let Some(identified) = &self.identified {
            return identified.page(&self.model);
        }
        let mut page = Page::default();
        page.line(format!("model {}", self.model));
        page.lines(
            self.muscles
                .iter()
                .map(|muscle| format!("muscle: {}", muscle.line(u))),
        );
        page.lines(self.limits.lines(u));
        if let Some(c) = self.sonic_conductance_l_per_s_bar {
            let conductance = number(c, 4);
            page.paragraph(format!("the smallest valve has {conductance} L/(s bar)"));
        }
        for run in self.runs() {
            page.gap();
            page.rows(run.end_rows(u).and(run.rows(u)));
            run.events(&mut page);
        }
        page
    }

    fn csv(&self) -> Csv {
        Csv::columns(&self.motion.motion.series)
    }
}

impl MotionRun {
    /// Where it ends; the ± belongs to where it rests.
    fn end_rows(&self, u: &Units) -> Rows {
        let run = &self.motion;
        let end = &self.end;
        let last = |list: &[f64]| list.last().copied();
        let degrees = run.series.degrees();
        let angle_deg = degrees.as_ref().and_then(|[angle, _]| last(angle));
        let muscle = run.series.muscles.first().filter(|_| degrees.is_none());
        let contraction = muscle.and_then(|muscle| last(&muscle.contraction));
        let half_deg = end.end_angle_uncertainty_deg;
        let moves = run.at_rest() != Some(true);
        let rows = Rows::default()
            .quantity(
                "ends at",
                &DEGREES,
                (angle_deg, half_deg.filter(|_| !moves)),
            )
            .quantity("ends at", &PERCENT, contraction)
            .text("at rest", run.at_rest().filter(|_| moves).map(|_| "no"))
            .quantity(
                "its equilibrium",
                &DEGREES,
                (run.equilibrium_angle_deg.filter(|_| moves), half_deg),
            )
            .quantity(
                "its equilibrium",
                &PERCENT,
                run.equilibrium_contraction.filter(|_| moves),
            );
        let built = || {
            let ends = [
                end.end_contraction_predicted?,
                end.end_contraction_predicted_low?,
                end.end_contraction_predicted_high?,
            ];
            Some(bounds(ends, &PERCENT))
        };
        let pressure_mpa = muscle.and_then(|muscle| last(&muscle.pressure_mpa));
        rows.text("as built", built())
            .quantity("with a pressure of", &u.pressure, pressure_mpa)
            .text("uncertainty", self.uncertainty_in(u))
    }

    /// The poles, of a conjugate pair one; that of the air's mass, 0, is left out.
    fn poles(&self) -> String {
        let poles = self.motion.poles_per_s.iter();
        let poles = poles.filter(|(re, _)| re.abs() > 1e-9);
        let one = |(re, im): &(f64, f64)| match im.abs() {
            // Rounding makes a pair of a double pole.
            im if im < 5e-4 => format!("{re:.3}"),
            im => format!("{re:.3} ± {im:.3}i"),
        };
        let mut poles = Vec::from_iter(poles.map(one));
        poles.dedup();
        poles.join(", ")
    }

    fn rows(&self, u: &Units) -> Rows {
        let run = &self.motion;
        Rows::default()
            .text("with", self.value.as_deref())
            .quantity("rise time (10–90 %)", &SECONDS, run.rise_time_s)
            .quantity("settling time (2 %)", &SECONDS, run.settling_time_s)
            .quantity("fill time", &SECONDS, run.fill_time_s)
            .quantity("vent time", &SECONDS, run.vent_time_s)
            .quantity("overshoot", &PERCENT, run.overshoot)
            .quantity(
                "largest velocity",
                &Scale::fixed("°/s"),
                run.largest_velocity_deg_per_s,
            )
            .quantity(
                "largest velocity",
                &u.speed(),
                run.largest_velocity_mm_per_s,
            )
            .quantity("liquid pushed in", &u.volume, run.liquid_volume_mm3)
            .quantity("air from the supply", &NORMAL_LITRES, run.air_normal_litres)
            .quantity(
                "air of a cycle",
                &NORMAL_LITRES,
                run.air_normal_litres_per_cycle,
            )
            .quantity("work", &JOULES, run.energies.work_j)
            .quantity("bandwidth (−3 dB)", &HERTZ, run.bandwidth_hz)
            .quantity("while filling", &HERTZ, run.bandwidth_filling_hz)
            .quantity("while venting", &HERTZ, run.bandwidth_venting_hz)
            .quantity("eigenfrequency", &HERTZ, run.eigenfrequency_hz)
            .quantity(
                "natural frequency, constant pressure",
                &HERTZ,
                run.frequency_constant_pressure_hz,
            )
            .quantity("valves shut", &HERTZ, run.frequency_shut_hz)
            .text("poles [1/s]", self.poles())
    }

    fn events(&self, page: &mut Page) {
        let all = &self.motion.events;
        let table = Table::of(&all[..all.len().min(SHOWN)])
            .text("time [s]", |event| number(event.time_s, 4))
            .text("kind", |event| event.kind.to_string());
        page.table_under(
            "events",
            if self.motion.series.degrees().is_some() {
                table.text("muscle", |event| event.muscle)
            } else {
                table
            },
        );
        if all.len() > SHOWN {
            let more = all.len() - SHOWN;
            page.line(format!("and {more} more (JSON has them all)"));
        }
    }
}
