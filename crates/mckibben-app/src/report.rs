//! The report of `build`: all that is known of a muscle, as one document.

use crate::{
    BuildRequest, CheckAnswer, CheckRequest, CurveRequest, ForceRequest, PointAnswer, Result,
    ShapeRequest, Units, check, curve, flags::Args, force, number, percent, ratio, shape,
    words::fixed,
};
use mckibben_build::Plan;
use mckibben_core::{
    analysis::{Burst, FailureMode, FailurePressure, SAFETY},
    curve::Test,
    muscle::file::to_toml,
    progress::Progress,
};
use mckibben_report::{Document, DrawingSheet, Figure, Part};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What a report states of itself; what is empty is a field to fill in by hand.
#[derive(Debug, PartialEq, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
#[command(next_help_heading = "Title block of the report")]
pub struct TitleBlock {
    /// Name of the muscle
    #[arg(long, value_name = "TEXT")]
    pub name: Option<String>,
    /// Project
    #[arg(long, value_name = "TEXT")]
    pub project: Option<String>,
    /// Number of the document
    #[arg(long, value_name = "TEXT")]
    pub number: Option<String>,
    /// Revision of the document
    #[arg(long, value_name = "TEXT")]
    pub revision: Option<String>,
    /// Date of the document
    #[arg(long, value_name = "TEXT")]
    pub date: Option<String>,
}

impl TitleBlock {
    /// Its fields, with those that are signed by hand.
    pub fn fields(&self) -> Vec<(String, String)> {
        let version = concat!("mckibben ", env!("CARGO_PKG_VERSION"));
        let fields = [
            ("muscle", &self.name),
            ("project", &self.project),
            ("document no.", &self.number),
            ("revision", &self.revision),
            ("date", &self.date),
            ("computed by", &Some(version.to_owned())),
            ("checked", &None),
        ];
        let filled = |(name, text): (&str, &Option<String>)| {
            (name.to_owned(), text.clone().unwrap_or_default())
        };
        fields.map(filled).to_vec()
    }
}

/// A report of a muscle whose plan is made, by `fe`.
pub fn report(
    request: &BuildRequest,
    (plan, burst, drawing): (&Plan, &Burst, &DrawingSheet),
    progress: &dyn Progress,
) -> Result<Document> {
    let step = |done| {
        progress.report(done, 5);
        progress.check()
    };
    let pressure_mpa = plan.operating.pressure_mpa;
    let wanted = CheckRequest {
        question: request.muscle.clone().into(),
        pressure_mpa: Some(pressure_mpa.into()),
        ..CheckRequest::default()
    };
    let shown = check(&wanted)?;
    step(1)?;
    let job = plan
        .operating
        .pulls
        .first()
        .filter(|at| at.required_n.is_some());
    // To a whole percent: a state that one can set.
    let usual = job.map_or(
        (50.0 * plan.operating.free_contraction).round() / 100.0,
        |at| at.contraction,
    );
    let contraction = match &request.contraction {
        Some(contraction) => contraction.of_length(plan.muscle.length_mm())?,
        None => ratio(usual)?,
    };
    let point = force(&ForceRequest {
        question: request.muscle.clone().into(),
        pressure_mpa: Some(pressure_mpa.into()),
        contraction: Some(contraction.into()),
        ..ForceRequest::default()
    })?;
    step(2)?;
    let units = &request.units;
    let mut parts: Vec<Part> = shown
        .warnings
        .iter()
        .filter(|w| w.is_of_burst())
        .map(|w| Part::Text(w.to_string()))
        .chain(state(&shown, &point, plan.liquid, units))
        .collect();
    let deformed = ShapeRequest {
        muscle: request.muscle.clone(),
        pressure_mpa: Some(pressure_mpa.into()),
        contraction: Some(contraction.into()),
        ..ShapeRequest::default()
    };
    parts.push(body_part(&deformed)?);
    step(3)?;
    parts.extend(margins(plan, burst, units));
    parts.push(Part::Drawing(drawing.clone()));
    parts.push(Part::heading("Curves"));
    for test in [Test::Isobaric, Test::Isometric] {
        parts.extend(
            curves(request, test, pressure_mpa, progress)?.map(|f| Part::Figure(Box::new(f))),
        );
    }
    step(4)?;
    parts.extend(limits(&shown, &point));
    let hash = mckibben_campaign::sha256(to_toml(&shown.muscle).as_bytes());
    Ok(Document {
        title: format!("Report: {}", plan.title()),
        title_block: request.title_block.fields(),
        lead: format!(
            "{}. At {} and a contraction of {}. All numbers by {}, axisymmetric finite elements, unless \
             stated otherwise; ± covers 95 % against a measured muscle.",
            shown.summary.line(units),
            units.pressure.show(pressure_mpa),
            percent(contraction),
            point.point.model
        ),
        parts,
        footer: format!("Muscle file: SHA-256 {hash}."),
    })
}

/// The state and what the muscle can do at this pressure, in numbers.
fn state(shown: &CheckAnswer, point: &PointAnswer, liquid: bool, u: &Units) -> Vec<Part> {
    // The title and the lead say these.
    let said = ["muscle", "model", "pressure", "contraction", "shortening"];
    let rows = point.rows(u).only(|label| !said.contains(&label));
    let more = shown
        .characteristics
        .as_ref()
        .map(|c| c.rows(u))
        .unwrap_or_default()
        .only(|label| rows.iter().all(|(name, _)| name != label))
        .only(|label| !liquid || label != "air of a free stroke");
    vec![Part::heading("Performance"), Part::pairs(rows.and(more))]
}

/// The deformed muscle by itself.
pub fn body(request: &ShapeRequest) -> Result<Document> {
    Ok(Document {
        title: "The deformed muscle".into(),
        parts: vec![body_part(request)?],
        ..Document::default()
    })
}

fn body_part(request: &ShapeRequest) -> Result<Part> {
    let mut answer = shape(request)?;
    for list in answer.arrays.values_mut() {
        // A few micrometres are finer than a screen.
        list.iter_mut().for_each(|v| *v = (*v * 1e4).round() / 1e4);
    }
    Ok(Part::Body(
        serde_json::to_string(&answer).unwrap_or_default(),
    ))
}

fn curves(
    request: &BuildRequest,
    test: Test,
    pressure_mpa: f64,
    progress: &dyn Progress,
) -> Result<Option<Figure>> {
    let count = if test == Test::Isobaric { 5 } else { 20 };
    let share = |i: u8| pressure_mpa * f64::from(i) / f64::from(count);
    let pressures_mpa = Vec::from_iter((1..=count).map(share));
    let wanted = CurveRequest {
        test,
        question: request.muscle.clone().into(),
        pressures_mpa: Some(pressures_mpa.into()),
        figure: Some(request.units.clone()),
        ..CurveRequest::default()
    };
    Ok(curve(&wanted, progress)?.figure)
}

fn limits(shown: &CheckAnswer, point: &PointAnswer) -> Vec<Part> {
    let mut list =
        vec![
        "The tube is bonded to rigid terminals; the strands move with its outer surface and turn \
         freely at their crossings, with friction only where the muscle file states it.".to_owned(),
        "The braid has no thickness and lies on the tube from the start; the rubber has no \
         relaxation and no softening.".to_owned(),
        format!("The ±: {}", point.background.about.uncertainty_basis),
    ];
    if shown.muscle.terminals().insertion_mm.is_none() {
        let cut = number(shown.muscle.insertion_mm(), 4);
        list.push(format!(
            "The clamped length on each plug is not stated; the cut lengths assume {cut} mm."
        ));
    }
    list.extend(
        shown
            .warnings
            .iter()
            .chain(&point.point.warnings)
            .filter(|w| !w.is_of_burst())
            .map(ToString::to_string),
    );
    list.dedup();
    vec![Part::heading("Assumptions and limits"), Part::List(list)]
}

/// The pressure of each failure over the working pressure, beside what is required.
fn margins(plan: &Plan, burst: &Burst, units: &Units) -> Vec<Part> {
    let working_mpa = plan.operating.pressure_mpa;
    let mut rows: Vec<Vec<String>> = burst
        .modes()
        .into_iter()
        .map(|(mode, at)| {
            let required = number(SAFETY * mode.share(), 3);
            let (pressure, factor) = match at {
                FailurePressure::At { mpa, least_mpa } => {
                    let least = units.pressure.show(least_mpa);
                    let least = (least_mpa < mpa).then(|| format!(" ({least} at least)"));
                    (
                        units.pressure.show(mpa) + &least.unwrap_or_default(),
                        Some(mpa / working_mpa),
                    )
                }
                FailurePressure::None => ("at no pressure".into(), None),
                FailurePressure::Unknown(_) if mode == FailureMode::Ends => {
                    (format!("NOT INCLUDED: {}", plan.ends_hold()), None)
                }
                FailurePressure::Unknown(why) => (
                    format!("not known: {}", units.sentence(&why.to_string())),
                    None,
                ),
            };
            let factor = factor.map_or_else(|| "–".into(), |factor| fixed(factor, 1));
            vec![mode.to_string(), factor, required, pressure]
        })
        .collect();
    if let Some(rated) = burst.rated_mpa {
        let factor = fixed(rated / working_mpa, 1);
        rows.push(vec![
            "the fittings are rated for".into(),
            factor,
            "1".into(),
            units.pressure.show(rated),
        ]);
    }
    let [working, proof] =
        [working_mpa, plan.safety.proof_pressure_mpa].map(|p| units.pressure.show(p));
    vec![
        Part::heading("Margins of safety"),
        Part::Text(format!(
            "Factor: pressure of the failure over {working}. Estimates of new parts under a slowly \
             rising pressure; proof test with water at {proof}. Of the ends, {}. {}",
            plan.ends_carry(),
            plan.energy()
        )),
        Part::table(&["failure", "factor", "required", "pressure"], rows),
    ]
}
