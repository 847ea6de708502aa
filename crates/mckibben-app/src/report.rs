//! `report`: all that is known of a muscle, as one document.

use crate::compare::{CompareRequest, compare};
use crate::curve::{CurveRequest, curve};
use crate::fields::{AskFields, MuscleFields};
use crate::figure;
use crate::muscle::MuscleSummary;
use crate::point::{ForceRequest, PointAnswer, force, given, ratio};
use crate::problem::Problem;
use crate::shape::{ShapeAnswer, ShapeRequest, shaped};
use crate::show::{MuscleShowAnswer, MuscleShowRequest, muscle_show};
use crate::simulate::PictureFields;
use crate::units::Units;
use crate::words::{law_text, number, percent, within};
use mckibben::curve::Test;
use mckibben::muscle::file::to_toml;
use mckibben::progress::Progress;
use mckibben_fem::output::Shape;
use mckibben_report::{Body, Document, Figure, Part};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A muscle to be reported on.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct ReportRequest {
    /// The muscle.
    #[serde(flatten)]
    pub muscle: MuscleFields,
    /// Gauge pressure P in MPa; default 0.25.
    pub pressure_mpa: Option<f64>,
    /// Contraction ratio ε of the state that is shown; default half the free contraction.
    pub contraction: Option<f64>,
    /// Units: `bar`, or `psi,lbf,in`.
    pub units: Units,
}

/// A report.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ReportAnswer {
    /// The muscle.
    pub muscle: MuscleSummary,
    /// Burst pressure, MPa: the strands of the blocked muscle reach their strength; none if that is not stated.
    pub burst_pressure_mpa: Option<f64>,
    /// Warnings, in sentences.
    pub warnings: Vec<String>,
    /// The report.
    pub document: Document,
}

/// Models that are compared.
const MODELS: [&str; 4] = ["fe", "universal", "thick-wall", "ideal"];

/// A report of a muscle, by `fe`.
///
/// # Errors
/// [`Problem`].
pub fn report(request: &ReportRequest, progress: &dyn Progress) -> Result<ReportAnswer, Problem> {
    let step = |done| {
        progress.report(done, 5);
        if progress.cancelled() { Err(Problem::cancelled()) } else { Ok(()) }
    };
    let pressure_mpa = given("pressure_mpa", request.pressure_mpa.or(Some(0.25)), "a pressure")?;
    let show = MuscleShowRequest {
        muscle: request.muscle.clone(),
        pressure_mpa: Some(pressure_mpa),
        ..MuscleShowRequest::default()
    };
    let shown = muscle_show(&show)?;
    step(1)?;
    let free = shown.characteristics.as_ref().and_then(|c| c.free_contraction);
    // To a whole percent: a state that one can set.
    let usual = (50.0 * free.unwrap_or(0.2)).round() / 100.0;
    let contraction = ratio(request.contraction.unwrap_or(usual))?;
    let point = force(
        &ForceRequest {
            muscle: request.muscle.clone(),
            pressure_mpa: Some(pressure_mpa),
            contraction: Some(contraction),
            ..ForceRequest::default()
        },
        progress,
    )?;
    step(2)?;
    let units = &request.units;
    let burst = shown.warnings.iter().filter(|w| is_of_burst(w)).cloned().map(Part::Text);
    let mut parts: Vec<Part> = burst.chain(state(&shown, &point, units)).collect();
    let of = ShapeRequest {
        muscle: request.muscle.clone(),
        pressure_mpa: Some(pressure_mpa),
        contraction: Some(contraction),
        ..ShapeRequest::default()
    };
    parts.push(body_of(&of, units, progress)?);
    step(3)?;
    parts.push(Part::Heading("Curves".into()));
    for test in [Test::Isobaric, Test::Isometric] {
        parts.extend(curves(request, test, pressure_mpa, progress)?.map(|f| Part::Figure(Box::new(f))));
    }
    step(4)?;
    parts.extend(models(request, pressure_mpa, progress)?);
    parts.extend(build(&shown, units));
    parts.extend(limits(&shown, &point));
    let file = to_toml(&shown.muscle);
    let hash = mckibben_campaign::sha256(file.as_bytes());
    parts.extend([Part::Heading("Muscle file".into()), Part::Code(file)]);
    let version = env!("CARGO_PKG_VERSION");
    let document = Document {
        title: format!("McKibben muscle: {}", shown.summary.line(units)),
        lead: format!(
            "At {} and a contraction of {}. All numbers by {}, axisymmetric finite elements, unless stated otherwise; ± covers 95 % against a measured muscle.",
            units.pressure.show(pressure_mpa),
            percent(contraction),
            point.point.model
        ),
        parts,
        footer: format!("mckibben {version}. Muscle file: SHA-256 {hash}."),
    };
    let burst_pressure_mpa = shown.characteristics.as_ref().and_then(|c| c.burst_pressure_mpa);
    Ok(ReportAnswer { muscle: shown.summary, burst_pressure_mpa, warnings: shown.warnings, document })
}

/// Whether a warning is about the burst of the muscle: it comes first in the report.
fn is_of_burst(sentence: &str) -> bool {
    sentence.starts_with("BURST")
}

/// Rows of names and values.
fn pairs(rows: Vec<(&str, Option<String>)>) -> Part {
    let rows = rows.into_iter().filter_map(|(name, value)| Some(vec![name.to_owned(), value?]));
    Part::Table { head: vec![], rows: rows.collect() }
}

/// The state, in numbers.
fn state(shown: &MuscleShowAnswer, point: &PointAnswer, u: &Units) -> Vec<Part> {
    let (p, r) = (&point.point, &point.point.response);
    let pull = match p.uncertainty_n {
        _ if p.slack => "slack".to_owned(),
        Some(half) => format!(
            "{} ± {} {}",
            within(u.force.value(r.force_n), u.force.value(half)),
            u.force.to(half, 2),
            u.force.name
        ),
        None => u.force.show(r.force_n),
    };
    let c = shown.characteristics.as_ref();
    let rows = vec![
        ("pull", Some(pull)),
        ("starts to pull at", p.start_pressure_mpa.map(|v| u.pressure.show(v))),
        ("stiffness", r.stiffness_n_per_mm.map(|v| u.stiffness().show(v))),
        ("bulged diameter", r.bulged_diameter_mm.map(|v| u.length.show(v))),
        ("cavity", r.volume_mm3.map(|v| u.volume.show(v))),
        ("largest stretch of the rubber", r.max_stretch.map(|v| number(v, 4))),
        ("tension of a strand", r.strand_tension_n.map(|v| u.force.show(v))),
        ("blocked force", c.map(|c| u.force.show(c.blocked_force_n))),
        ("free contraction", c.and_then(|c| c.free_contraction).map(percent)),
        ("work of a free stroke", c.and_then(|c| c.work_j).map(|v| format!("{} J", number(v, 4)))),
        (
            "air of a free stroke",
            c.and_then(|c| c.air_normal_litres).map(|v| format!("{} normal litres", number(v, 4))),
        ),
        ("burst pressure", c.and_then(|c| c.burst_pressure_mpa).map(|v| u.pressure.show(v))),
    ];
    vec![Part::Heading("Performance".into()), pairs(rows)]
}

/// The deformed muscle by itself, without the picture for paper (of 600 kB), for front ends that show many.
///
/// # Errors
/// [`Problem`], as [`shape`](crate::shape).
pub fn body(request: &ShapeRequest, progress: &dyn Progress) -> Result<Document, Problem> {
    let (answer, _) = shaped(request, progress)?;
    let part = Part::Body(Body { data: data_of(answer), picture: None });
    Ok(Document { title: "The deformed muscle".into(), parts: vec![part], ..Document::default() })
}

fn body_of(request: &ShapeRequest, units: &Units, progress: &dyn Progress) -> Result<Part, Problem> {
    let (answer, section) = shaped(request, progress)?;
    let wanted = PictureFields { units: units.clone(), ..PictureFields::default() };
    let picture =
        figure::picture(&wanted, "fe", &answer.muscle, &Shape::of_section(&section), &answer.point.response)?;
    Ok(Part::Body(Body { data: data_of(answer), picture: Some(picture) }))
}

/// What the script of a page gets.
fn data_of(mut answer: ShapeAnswer) -> String {
    for list in answer.arrays.values_mut() {
        // A few micrometres are finer than a screen.
        list.iter_mut().for_each(|v| *v = (*v * 1e4).round() / 1e4);
    }
    serde_json::to_string(&answer).unwrap_or_default()
}

fn curves(
    request: &ReportRequest,
    test: Test,
    pressure_mpa: f64,
    progress: &dyn Progress,
) -> Result<Option<Figure>, Problem> {
    let shares = |n: usize| (1..=n).map(|i| pressure_mpa * i as f64 / n as f64).collect::<Vec<_>>();
    let asked = CurveRequest {
        test,
        muscle: request.muscle.clone(),
        model: Default::default(),
        asking: AskFields::default(),
        pressures_mpa: Some(shares(if test == Test::Isobaric { 5 } else { 20 })),
        contractions: None,
        forces_n: None,
        load: Default::default(),
        both: false,
        figure: Some(request.units.clone()),
    };
    Ok(curve(&asked, progress)?.figure)
}

/// What other models say.
fn models(request: &ReportRequest, pressure_mpa: f64, progress: &dyn Progress) -> Result<Vec<Part>, Problem> {
    let asked = CompareRequest {
        models: MODELS.map(str::to_owned).to_vec(),
        muscle: request.muscle.clone(),
        pressures_mpa: Some(vec![0.5 * pressure_mpa, pressure_mpa]),
        asking: AskFields { extrapolate: true, ..AskFields::default() },
        figure: Some(request.units.clone()),
        ..CompareRequest::default()
    };
    let answer = compare(&asked, progress)?;
    let force = &request.units.force;
    let shown = |v: Option<f64>| v.map_or_else(|| "–".to_owned(), |v| force.show(v));
    let rows = answer.models.iter().filter(|m| m.model != answer.reference);
    let rows = rows.map(|m| vec![m.model.clone(), shown(m.rms_n), shown(m.max_n)]).collect();
    let head = ["model", "rms", "largest"].map(str::to_owned).to_vec();
    let mut parts = vec![
        Part::Heading("Other models".into()),
        Part::Text(format!("Their differences from {}.", answer.reference)),
        Part::Table { head, rows },
    ];
    parts.extend(answer.figure.map(|f| Part::Figure(Box::new(f))));
    Ok(parts)
}

/// What to cut and clamp.
fn build(shown: &MuscleShowAnswer, u: &Units) -> Vec<Part> {
    let (m, sheet, derived) = (&shown.muscle, &shown.build_sheet, &shown.derived);
    let mm = |v: f64| Some(u.length.show(v));
    let rows = vec![
        (
            "tube",
            Some(format!(
                "{} outside, wall {}",
                u.length.show(m.outer_diameter_mm()),
                u.length.show(m.wall_mm())
            )),
        ),
        ("tube to cut", mm(sheet.tube_cut_mm)),
        ("length between the terminals", mm(m.length_mm())),
        ("rubber", Some(format!("{}: {}", shown.summary.rubber, law_text(&m.tube().rubber.law)))),
        ("rubber between the terminals", shown.summary.rubber_mass_g.map(|g| format!("{} g", number(g, 4)))),
        ("braid", Some(format!("{}, {}°", shown.summary.braid, number(m.braid().angle_deg, 4)))),
        ("braid to cut", mm(sheet.braid_cut_mm)),
        ("strand in the braid", mm(sheet.strand_cut_mm)),
        ("turns of a strand", Some(number(derived.turns, 4))),
        ("strand length per turn", mm(derived.strand_length_per_turn_mm)),
        ("strands", sheet.strands.map(|n| n.to_string())),
        ("plug diameter", mm(sheet.plug_diameter_mm)),
    ];
    vec![Part::Heading("Build sheet".into()), pairs(rows)]
}

/// Assumptions and limits.
fn limits(shown: &MuscleShowAnswer, point: &PointAnswer) -> Vec<Part> {
    let mut list = vec![
        "The tube is bonded to rigid terminals; the strands move with its outer surface and turn freely at their crossings, with friction only where the muscle file states it.".to_owned(),
        "The braid has no thickness and lies on the tube from the start; the rubber has no relaxation and no softening.".to_owned(),
        format!("The ±: {}", point.about.uncertainty_basis),
    ];
    if shown.muscle.terminals().insertion_mm.is_none() {
        let assumed = number(shown.muscle.terminals().insertion_mm(), 4);
        list.push(format!(
            "The clamped length on each plug is not stated; the cut lengths assume {assumed} mm."
        ));
    }
    list.extend(shown.warnings.iter().cloned());
    list.extend(point.point.warnings.iter().map(ToString::to_string));
    list.retain(|sentence| !is_of_burst(sentence));
    list.dedup();
    vec![Part::Heading("Assumptions and limits".into()), Part::List(list)]
}
