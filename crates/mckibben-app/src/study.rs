//! `curve --study`: the paper's thickness study.

use crate::{Model, MuscleSummary, PointRow, Problem, QuestionFields, Units, answered, figure, warnings};
use mckibben::muscle::measures::{LENGTH, OUTER_DIAMETER, WALL, fields};
use mckibben::study::{Finding, Study, StudyPanel, thickness};
use mckibben::{cancel, curve::Test, progress::Progress, warning::Warning};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize, Serializer};

/// The thickness study with a rubber, a braid and a model.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct StudyRequest {
    /// The muscle, the model, and how it is asked.
    #[serde(flatten)]
    pub question: QuestionFields,
    /// Add a figure to the answer, in these units: `bar`, or `psi,lbf,in`.
    pub figure: Option<Units>,
}

/// The study: curves of five walls and of the ideal formula, and the paper's findings with a verdict on each.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct StudyAnswer {
    /// The model's name.
    pub model: String,
    /// `thickness`.
    pub test: String,
    /// The paper's findings.
    pub findings: Vec<Finding>,
    /// The points of all curves.
    #[serde(rename = "points", serialize_with = "points")]
    #[schemars(with = "Vec<StudyRow>")]
    pub panels: Vec<StudyPanel>,
    /// Warnings, in sentences: those of the points, once per wall.
    #[schemars(with = "Vec<String>")]
    pub warnings: Vec<Warning>,
    /// The figure, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub figure: Option<Figure>,
}

/// A point of the study.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct StudyRow {
    /// The point.
    #[serde(flatten)]
    pub point: PointRow,
    /// Isometric or isotonic.
    pub test: Test,
    /// ΔL in mm of an isometric test, F in N of an isotonic one.
    pub fixed: f64,
    /// Which curve.
    pub curve: String,
    /// Its wall, mm; the ideal formula has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wall_mm: Option<f64>,
}

pub fn study(request: &StudyRequest, _progress: &dyn Progress) -> Result<StudyAnswer, Problem> {
    let QuestionFields { muscle: m, model, asking } = &request.question;
    let own = fields()
        .filter(|(_, measure)| [&OUTER_DIAMETER, &WALL, &LENGTH].contains(measure))
        .map(|(field, measure)| (field, m.measures.get(measure).is_some()));
    let own: Vec<(&str, bool)> = own.collect();
    Problem::refuse_unused(&own, "the study has the diameter, walls and length of the paper")
        .map_err(|p| p.with_hint("leave it out, or draw other muscles with `test`"))?;
    let base = m.resolve()?;
    let options = asking.options(&base)?;
    let model = Model::choose(model)?;
    model.admit(&base)?;
    let study = thickness(&base, options, |m| model.build(m));
    cancel::check()?;
    let study = study?;
    let figure = request.figure.as_ref().map(|unit| {
        let MuscleSummary { angle_deg, rubber, .. } = (&base).into();
        let about = format!("D0 30 mm, L0 285 mm, θ0 {angle_deg}°, rubber {rubber}");
        figure::study(&study, &about, unit)
    });
    let curves = study.panels.iter().flat_map(|p| &p.curves).map(|c| &c.curve);
    let warnings = warnings::of_points(answered(curves));
    let Study { model, panels, findings } = study;
    Ok(StudyAnswer { model, test: "thickness".into(), findings, panels, warnings, figure })
}

/// The points of all curves, row by row.
fn points<S: Serializer>(panels: &[StudyPanel], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(panels.iter().flat_map(|panel| {
        panel.curves.iter().flat_map(move |curve| {
            curve.curve.points.iter().map(move |point| StudyRow {
                point: point.into(),
                test: panel.test,
                fixed: panel.fixed,
                curve: curve.label.clone(),
                wall_mm: curve.wall_mm,
            })
        })
    }))
}
