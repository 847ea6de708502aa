//! A finite-element test as people read it.

use super::{SimulateAnswer, Simulated, SimulatedPoint, SimulatedRow};
use crate::{
    Units, number, percent,
    print::{Csv, Page, Rows, Show, Table},
    units::{DEGREES, JOULES, NUMBER, PERCENT},
};
use mckibben_core::{model::Response, warning::Warning};

type Line<'a> = (&'a Simulated, &'a SimulatedRow);

impl Show for SimulateAnswer {
    fn warnings(&self) -> Vec<Warning> {
        self.warnings.clone()
    }

    fn page(&self, u: &Units) -> Page {
        let rows: Vec<SimulatedRow> = self.simulated.iter().map(SimulatedRow::from).collect();
        let mut page = Page::default();
        page.line(format!("{} test, model {}", self.test.name(), self.model));
        page.line(self.muscle.line(u));
        page.lines(
            self.notes
                .iter()
                .map(|note| format!("note: {}", u.sentence(note))),
        );
        page.gap();
        let lines: Vec<Line<'_>> = self.simulated.iter().zip(&rows).collect();
        page.table(table(&lines, u));
        page.paragraph(
            "strand: tension of one strand; braid: of all strands together. \
             stretch: 99 % of the rubber is stretched by less.",
        );
        let last = rows.iter().rev().find_map(|row| match row {
            SimulatedRow::Answered(point) => Some(point),
            SimulatedRow::Failed(_) => None,
        });
        if let Some(last) = last {
            last.onto(&mut page, u);
        }
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(self.simulated.iter().map(SimulatedRow::from))
    }
}

fn table<'a>(lines: &'a [Line<'a>], u: &Units) -> Table<'a, Line<'a>> {
    let response = |line: &Line<'_>| match line.1 {
        SimulatedRow::Answered(point) => point.response,
        SimulatedRow::Failed(_) => Response::default(),
    };
    let contraction = |(question, row): &Line<'_>| match row {
        SimulatedRow::Answered(point) => Some(point.response.contraction),
        SimulatedRow::Failed(_) => question.requested.contraction,
    };
    let length = u.length.digits(4);
    let force = u.force.digits(4);
    Table::of(lines)
        .quantity("P", &u.pressure, |line| line.0.requested.pressure_mpa)
        .quantity("ε", &PERCENT, contraction)
        .quantity("F", &u.force, |line| {
            line.0.solution.is_ok().then(|| response(line).force_n)
        })
        .quantity("V", &u.volume, |line| response(line).volume_mm3)
        .quantity("bulged D", &length, |line| {
            response(line).bulged_diameter_mm
        })
        .quantity("strand", &force, |line| response(line).strand_tension_n)
        .quantity("braid", &force, |line| response(line).braid_tension_n)
        .quantity("stiffness", &u.stiffness(), |line| {
            response(line).stiffness_n_per_mm
        })
        .quantity("stretch", &NUMBER.digits(3), |line| {
            response(line).max_stretch
        })
        .text(" ", |line| note(line.0))
}

/// How a point ended, and where a slack muscle hangs.
fn note(q: &Simulated) -> String {
    match (&q.solution, q.free_contraction) {
        (_, Some(e)) if q.slack => format!("slack, free contraction {}", percent(e)),
        _ if q.slack => "slack".into(),
        (Err(_), _) => q.status.to_string(),
        (Ok(s), _) if s.unstable_directions > 0 => "unstable".into(),
        _ => String::new(),
    }
}

impl SimulatedPoint {
    /// What is known of an equilibrium beyond the table.
    fn onto(&self, page: &mut Page, u: &Units) {
        let length = u.length.digits(4);
        page.paragraph("The last point");
        page.rows(
            Rows::default()
                .quantity("pressure", &u.pressure, self.response.pressure_mpa)
                .quantity("contraction", &PERCENT, self.response.contraction)
                .quantity("energy of the rubber", &JOULES, self.rubber_energy_j)
                .quantity("of the strands", &JOULES, self.braid_energy_j)
                .quantity("of the ends", &JOULES, self.ends_energy_j)
                .quantity("P·(V − V0)", &JOULES, self.pressure_work_j)
                .quantity(
                    "largest stretch at r (at rest)",
                    &length,
                    self.max_stretch_at.rest_r_mm,
                )
                .quantity("z from the middle", &length, self.max_stretch_at.rest_z_mm),
        );
        let ends: Vec<_> = self
            .strands
            .first()
            .into_iter()
            .chain(self.strands.last())
            .collect();
        page.paragraph("Strands in the middle and at the terminal");
        page.table(
            Table::of(&ends)
                .quantity("z at rest", &length, |strand| strand.rest_mm)
                .quantity("angle", &DEGREES, |strand| strand.angle_deg)
                .quantity("stretch", &NUMBER.digits(5), |strand| strand.stretch),
        );
        page.table_under(
            "Change of the pull if one of these grows by 1 %",
            Table::of(&self.sensitivities)
                .text(" ", |of| &of.name)
                .text("value", |of| number(of.value, 4))
                .text("unit", |of| of.unit)
                .text(&u.force.heading("pull"), |of| {
                    u.force.to(0.01 * of.value * of.force_n_per_unit, 3)
                }),
        );
    }
}
