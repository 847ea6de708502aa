//! Answers with many points as columns of numbers, named as the keys of their points; curves so.

use crate::curve::{CurveRequest, curve_by_curve};
use crate::problem::{Problem, ProblemKind};
use mckibben::answer::Answer;
use mckibben::curve::{Curve, CurvePoint};
use mckibben::progress::Progress;
use mckibben::size;
use mckibben::status::Status;
use serde_json::Value;

#[derive(Debug, Clone, PartialEq)]
pub enum Column {
    /// Numbers; NaN where a point has none.
    Numbers(Vec<f64>),
    Truths(Vec<bool>),
    /// Words or sentences, where there are some.
    Texts(Vec<Option<String>>),
}

/// An answer with its points as columns.
#[derive(Debug, Clone, PartialEq)]
pub struct AnswerColumns {
    /// The answer as JSON has it, without its points.
    pub head: Value,
    /// The points, column by column.
    pub columns: Vec<(&'static str, Column)>,
}

/// What is read off an answered point.
type Read = fn(&Answer) -> Option<f64>;

const NUMBERS: [(&str, Read); 17] = [
    ("force_n", |a| Some(a.response.force_n)),
    ("volume_mm3", |a| a.response.volume_mm3),
    ("volume_per_pressure_mm3_per_mpa", |a| a.response.volume_per_pressure_mm3_per_mpa),
    ("volume_per_contraction_mm3", |a| a.response.volume_per_contraction_mm3),
    ("stiffness_n_per_mm", |a| a.response.stiffness_n_per_mm),
    ("force_per_pressure_n_per_mpa", |a| a.response.force_per_pressure_mm2),
    ("braid_tension_n", |a| a.response.braid_tension_n),
    ("strand_tension_n", |a| a.response.strand_tension_n),
    ("bulged_diameter_mm", |a| a.response.bulged_diameter_mm),
    ("middle_stretch", |a| a.response.middle_stretch),
    ("max_stretch", |a| a.response.max_stretch),
    ("free_contraction", |a| a.free_contraction),
    ("start_pressure_mpa", |a| a.start_pressure_mpa),
    ("uncertainty_n", |a| a.uncertainty_n),
    ("pressure_uncertainty_mpa", |a| a.pressure_uncertainty_mpa),
    ("contraction_uncertainty", |a| a.contraction_uncertainty),
    ("wanted_force_n", |_| None),
];

const POINT_BYTES: f64 = 266.0;

/// A family of curves as columns, curve after curve; columns without any number are left out.
pub fn curve_columns(request: &CurveRequest, progress: &dyn Progress) -> Result<AnswerColumns, Problem> {
    let mut table = Table::default();
    let mut answer = curve_by_curve(request, progress, &mut |curve: Curve| {
        size::bytes("pressures_mpa", POINT_BYTES * (table.pressures.len() + curve.points.len()) as f64)?;
        curve.points.iter().for_each(|point| table.push(curve.fixed, point));
        Ok(())
    })?;
    if let Some(problem) = answer.problem.take() {
        return Err(problem);
    }
    let wrong = |e: serde_json::Error| Problem::new(ProblemKind::Internal, e.to_string(), "");
    let mut head = serde_json::to_value(&answer).map_err(wrong)?;
    if let Some(map) = head.as_object_mut() {
        map.shift_remove("points");
    }
    Ok(AnswerColumns { head, columns: table.columns() })
}

#[derive(Default)]
struct Table {
    fixed: Vec<f64>,
    pressures: Vec<f64>,
    contractions: Vec<f64>,
    numbers: [Vec<f64>; NUMBERS.len()],
    slack: Vec<bool>,
    directions: Vec<Option<String>>,
    status: Vec<Option<String>>,
    causes: Vec<Option<String>>,
}

impl Table {
    fn push(&mut self, fixed: f64, point: &CurvePoint) {
        let found = point.answer.as_ref().ok();
        let contraction = found.map(|a| a.response.contraction).or(point.contraction);
        self.fixed.push(fixed);
        self.pressures.push(point.pressure_mpa);
        self.contractions.push(contraction.unwrap_or(f64::NAN));
        for (list, (_, read)) in self.numbers.iter_mut().zip(NUMBERS) {
            list.push(found.and_then(read).unwrap_or(f64::NAN));
        }
        if let (None, Some(wanted), Some(last)) =
            (found, point.force_n, self.numbers.last_mut().and_then(|l| l.last_mut()))
        {
            *last = wanted;
        }
        self.slack.push(found.is_some_and(|a| a.slack));
        self.directions.push(found.filter(|a| !a.direction.is_mean()).map(|a| a.direction.to_string()));
        let status = point.answer.as_ref().map_or_else(Status::from, |_| Status::Ok);
        self.status.push(Some(status.to_string()));
        self.causes.push(point.answer.as_ref().err().map(ToString::to_string));
    }

    fn columns(self) -> Vec<(&'static str, Column)> {
        let mut out = vec![
            ("fixed", Column::Numbers(self.fixed)),
            ("pressure_mpa", Column::Numbers(self.pressures)),
            ("contraction", Column::Numbers(self.contractions)),
        ];
        let there = |list: &[f64]| list.iter().any(|v| !v.is_nan());
        let numbers = NUMBERS.iter().zip(self.numbers).filter(|(_, list)| there(list));
        out.extend(numbers.map(|((name, _), list)| (*name, Column::Numbers(list))));
        out.push(("slack", Column::Truths(self.slack)));
        let texts = [("direction", self.directions), ("status", self.status), ("cause", self.causes)];
        let said = texts.into_iter().filter(|(_, list)| list.iter().any(Option::is_some));
        out.extend(said.map(|(name, list)| (name, Column::Texts(list))));
        out
    }
}
