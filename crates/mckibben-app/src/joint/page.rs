//! A joint as people read it.

use super::{JointAnswer, JointMap, JointRow};
use crate::{
    LimitRows, Units, number,
    print::{Amount, Csv, Page, Show, Table},
    units::{DEGREES, NEWTON_METRES, Scale},
};
use mckibben_core::{extremes::ends, warning::Warning};

const NM_PER_RAD: Scale = Scale::fixed("N m/rad");

impl Show for JointAnswer {
    fn warnings(&self) -> Vec<Warning> {
        self.warnings.clone()
    }

    fn page(&self, u: &Units) -> Page {
        let mut page = Page::default();
        page.line(format!("model {}", self.model));
        page.lines(
            self.muscles
                .iter()
                .zip(1..)
                .map(|(muscle, i)| format!("muscle {i}: {}", muscle.line(u))),
        );
        page.lines(self.limits.lines(u));
        if !self.points.is_empty() {
            page.gap();
            page.table(table(&self.points, u));
            if let Some(text) = &self.uncertainty_text {
                page.paragraph(text);
            }
        }
        if let Some(map) = &self.map {
            reached(map, &mut page);
        }
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(&self.points)
    }
}

/// What the joint reaches at all pressures.
fn reached(map: &JointMap, page: &mut Page) {
    let at_rest = Vec::from_iter(map.points.iter().flatten().filter(|q| !q.at_limit));
    let reach = |(low, high)| format!("{} to {}", number(low, 4), number(high, 4));
    let angles = reach(ends(at_rest.iter().map(|q| q.angle_deg)));
    let stiffnesses = reach(ends(at_rest.iter().map(|q| q.stiffness_nm_per_rad)));
    let torques = reach(ends(map.torques.iter().flat_map(|t| [t.1, t.2])));
    page.paragraph(if at_rest.is_empty() {
        "at all of these pressures the joint rests at a limit of its range, or is loose".into()
    } else {
        format!("at rest it reaches {angles} ° and {stiffnesses} N m/rad")
    });
    page.line(format!(
        "its torques reach from {torques} N m over its range"
    ));
}

fn table<'a>(points: &'a [JointRow], u: &Units) -> Table<'a, JointRow> {
    let pull = |slack: bool, force_n: Option<f64>| {
        if slack {
            Amount::from("slack")
        } else {
            force_n.into()
        }
    };
    let force = u.force.digits(4);
    Table::of(points)
        .quantity("φ", &DEGREES, |q| {
            (q.point.angle_deg, q.angle_uncertainty_deg)
        })
        .quantity("P1", &u.pressure, |q| {
            (q.pressure_1_mpa, q.pressure_1_uncertainty_mpa)
        })
        .quantity("P2", &u.pressure, |q| {
            (q.pressure_2_mpa, q.pressure_2_uncertainty_mpa)
        })
        .quantity("τ as built", &NEWTON_METRES, |q| {
            (q.point.predicted_nm, q.point.uncertainty_nm)
        })
        .quantity("τ of the model", &NEWTON_METRES, |q| q.point.torque_nm)
        .quantity("turning to +", &NEWTON_METRES, |q| q.torque_turning_plus_nm)
        .quantity("to −", &NEWTON_METRES, |q| q.torque_turning_minus_nm)
        .quantity("−dτ/dφ", &NM_PER_RAD, |q| {
            (
                q.point.stiffness_nm_per_rad,
                q.point.stiffness_uncertainty_nm_per_rad,
            )
        })
        .quantity("valves shut, slow", &NM_PER_RAD, |q| {
            q.point.shut.isothermal_nm_per_rad
        })
        .quantity("quick", &NM_PER_RAD, |q| q.point.shut.adiabatic_nm_per_rad)
        .quantity("F1", &force, |q| pull(q.slack_1, Some(q.force_1_n)))
        .quantity("F2", &force, |q| pull(q.slack_2 == Some(true), q.force_2_n))
        .text("rest", |q| q.rest.map(|rest| rest.to_string()))
}
