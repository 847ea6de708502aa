//! `build`: from a muscle to report, drawing, plugs, cut list, bill of materials, steps and test
//! sheet.

use crate::{
    AskFields, Contraction, ModelFields, MuscleFields, MuscleSummary, PressureLimits, Problem,
    ProblemKind, Result, TextFile, TitleBlock, UncertaintyWords, Units, above_zero, borne,
    burst_with,
    flags::{self, Args},
    print::{Csv, Page, Show},
    proof_mpa,
    report::report,
    usual_mpa,
};
use base64::{Engine as _, engine::general_purpose::STANDARD};
pub use mckibben_build::is_blank_sheet;
use mckibben_build::{
    BuildPart, Content, Cut, EndLoads, File, Operating, Plan, PullAt, Safety, Shown, TestPoint,
    ToMeasure, USUAL_PROOF, Wishes, relief_mpa,
};
use mckibben_core::{
    analysis::{Burst, Evaluation, STRETCH},
    answer::Options,
    built::{Built, Left},
    cancel,
    joint::parse_joint,
    model::Workspace,
    muscle::{Direction, EndsMade, JobPoint, Muscle},
    progress::Progress,
    units::{
        Dimension,
        typed::{Length, Pressure},
    },
    warning::Warning,
};
use mckibben_report::Document;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A muscle to be built.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct BuildRequest {
    /// Working pressure [2.5bar, or the allowed pressure where that is lower, or that at which a
    /// proof test loads the ends with 1.5 times what use does]
    #[arg(short, long)]
    pub pressure_mpa: Option<Pressure>,
    /// Allow a working pressure above the allowed pressure, up to a proof test at three quarters of
    /// the burst pressure
    #[arg(long)]
    pub overpressure: bool,
    /// Fitting of the air: m3, m5, g1/8, g1/4, or barb:4 for a hose with a bore of 4 mm [m3; m5
    /// from 8 mm, g1/8 from 15 mm]
    ///
    /// Push-in fittings and barbs are sold with these threads.
    #[arg(long)]
    pub fitting: Option<String>,
    /// Filled with a liquid: a bleed port, and a leak test with the liquid
    ///
    /// A muscle whose `[job]` names a liquid is filled with it.
    #[arg(long)]
    pub liquid: bool,
    /// Bolts of both heads [by the load of an end]
    #[arg(long, value_name = "DIAMETER", value_parser = flags::bolt)]
    pub bolt_mm: Option<Length>,
    /// Diameter of the sleeve as it comes off the roll [nominal diameter]
    #[arg(long, value_name = "DIAMETER")]
    pub sleeve_diameter_mm: Option<Length>,
    /// Add the report to the files.
    #[arg(skip)]
    pub report: bool,
    /// Contraction of the state in the report [half the free contraction]
    #[arg(short = 'e', long)]
    pub contraction: Option<Contraction>,
    /// Units of the report: `bar`, or `psi,lbf,in`.
    #[arg(skip)]
    pub units: Units,
    /// Title block of the report.
    #[serde(flatten)]
    #[command(flatten)]
    pub title_block: TitleBlock,
    /// The muscle.
    #[serde(deserialize_with = "MuscleFields::or_name")]
    #[command(flatten)]
    pub muscle: MuscleFields,
}

/// All that is needed to build a muscle.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BuildAnswer {
    /// The muscle.
    pub muscle: MuscleSummary,
    /// The model that all numbers come from.
    pub model: String,
    /// Contraction of its job, else half of the free contraction.
    pub contraction: f64,
    /// What a built muscle pulls there at the working pressure.
    #[serde(flatten)]
    pub built: Option<Built>,
    /// Blocked force of the model at the working pressure, N.
    pub blocked_force_n: f64,
    /// Free contraction at the working pressure.
    pub free_contraction: f64,
    /// Largest outer diameter at the working pressure without load, mm.
    pub bulged_diameter_mm: f64,
    /// What each end carries.
    #[serde(flatten)]
    pub loads: EndLoads,
    /// How the ends hold tube and sleeve.
    pub ends: EndsMade,
    /// What they hold at least by estimate, N.
    pub ends_hold_n: f64,
    /// Distance between the inner faces of both heads at rest, mm: what a ruler reaches.
    pub heads_distance_mm: f64,
    /// Diameter over tube and sleeve on a plug, mm: what a clamp closes on.
    pub clamped_diameter_mm: f64,
    /// Diameter of the plugs' stem, mm.
    pub plug_diameter_mm: f64,
    /// Side of the plugs' square heads, mm.
    pub head_side_mm: f64,
    /// Bolts of the heads, mm.
    pub bolt_mm: f64,
    /// Pressures of the tests, and the energy of the air.
    #[serde(flatten)]
    pub safety: Safety,
    /// The pressures that the muscle bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
    /// What is cut.
    pub cut: Cut,
    /// The bill of materials.
    pub parts: Vec<BuildPart>,
    /// Mass of the parts whose mass is known, g.
    pub mass_g: f64,
    /// The points of the first test.
    pub test: Vec<TestPoint>,
    /// The files: the steps first, which link to the others.
    pub files: Vec<BuiltFile>,
    /// Warnings.
    pub warnings: Vec<Warning>,
    /// The report, where one is wanted.
    #[serde(skip)]
    pub document: Option<Document>,
    /// The drawing of the muscle as SVG.
    #[serde(skip)]
    pub drawing: String,
}

impl Show for BuildAnswer {
    fn warnings(&self) -> Vec<Warning> {
        self.warnings.clone()
    }

    fn page(&self, u: &Units) -> Page {
        Page::of(self, u, &["test"])
    }

    fn csv(&self) -> Csv {
        Csv::flat(self)
    }
}

/// The files of the report: as a page, and for printing.
pub const REPORT: [&str; 2] = ["report.html", "report.pdf"];

/// A file that a command makes.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct BuiltFile {
    /// Its name.
    pub name: String,
    /// What it is.
    pub about: String,
    /// What is in it, if it is text.
    pub text: Option<String>,
    /// What is in it, if it is not text: its bytes in base64.
    pub base64: Option<String>,
    /// The same as bytes.
    #[serde(skip)]
    pub content: Vec<u8>,
}

impl From<File> for BuiltFile {
    fn from(file: File) -> Self {
        let content = file.content.bytes().to_vec();
        let (text, base64) = match file.content {
            Content::Text(text) => (Some(text), None),
            Content::Bytes(bytes) => (None, Some(STANDARD.encode(bytes))),
        };
        Self {
            name: file.name,
            about: file.about.into(),
            text,
            base64,
            content,
        }
    }
}

/// All that is needed to build a muscle.
pub fn build(request: &BuildRequest, progress: &dyn Progress) -> Result<BuildAnswer> {
    if !request.report {
        let fields = [("contraction", request.contraction.is_some())];
        Problem::refuse_unused(&fields, "it is part of the report, and `report` is not set")?;
    }
    let (mut plan, burst) = planned(request)?;
    plan.expected = expected(&plan)?;
    let said = burst.warnings(plan.operating.pressure_mpa);
    let wrong = |e| ProblemKind::Internal.problem(format!("the drawing cannot be drawn: {e}"));
    let files = mckibben_build::files(&plan).map_err(wrong)?;
    let mut files: Vec<BuiltFile> = files
        .into_iter()
        .map(|file| named(file, request.muscle.file()).into())
        .collect();
    let drawing = mckibben_build::drawing(&plan);
    let document = request
        .report
        .then(|| report(request, (&plan, &burst, &drawing), progress))
        .transpose()?;
    if let Some(document) = &document {
        let about = "all that is known of the muscle";
        let wrong = |e| ProblemKind::Plot.problem(e);
        files.push(File::text(REPORT[0], about, document.to_html("").map_err(wrong)?).into());
        #[cfg(feature = "files")]
        files.push(File::bytes(REPORT[1], about, document.to_pdf().map_err(wrong)?).into());
    }
    let outside = Warning::not_measured(&plan.muscle, plan.safety.pressure_mpa);
    let of_plan = plan.muscle.warnings().into_iter().chain(plan.warnings());
    let first = plan.operating.pulls.first();
    Ok(BuildAnswer {
        muscle: (&plan.muscle).into(),
        contraction: first.map_or(0.0, |pull| pull.contraction),
        built: first.and_then(|pull| pull.built),
        blocked_force_n: plan.operating.blocked_force_n,
        free_contraction: plan.operating.free_contraction,
        bulged_diameter_mm: plan.operating.bulged_diameter_mm,
        loads: plan.loads,
        ends: plan.ends.made,
        ends_hold_n: plan.ends.holds_n[0],
        heads_distance_mm: plan.faces_mm(0.0),
        clamped_diameter_mm: plan.clamped_diameter_mm,
        plug_diameter_mm: plan.air_plug.stem.diameter_mm,
        head_side_mm: plan.air_plug.side_mm,
        bolt_mm: plan.eye_plug.bolt.mm,
        safety: plan.safety,
        mass_g: plan.mass_g(),
        limits: (&burst).into(),
        warnings: said
            .into_iter()
            .chain(outside)
            .chain(of_plan.map(Warning::from))
            .collect(),
        files,
        document,
        drawing: drawing.to_svg().map_err(wrong)?,
        cut: plan.cut,
        parts: plan.parts,
        test: plan.test,
        model: plan.operating.model,
    })
}

/// A muscle file keeps the line with the name of the one that was given.
fn named(mut file: File, given: Option<&TextFile>) -> File {
    let text = given.map_or("", |given| &*given.text);
    let mut lines = text.lines().take_while(|line| !line.starts_with('['));
    let name = lines.find(|line| line.starts_with("name"));
    if let (Some(name), Content::Text(text), "muscle.toml") = (name, &mut file.content, &*file.name)
    {
        *text = text.replacen("[tube]", &format!("{name}\n\n[tube]"), 1);
    }
    file
}

/// The folder of a joint is that of its muscle.
fn of_joint(request: &BuildRequest) -> Option<Problem> {
    let file = request.muscle.file()?;
    let joint = parse_joint(&file.text).ok()?;
    let mut names: Vec<&str> = joint.files().collect();
    names.dedup();
    let message = format!("{} is a joint: build {}", file.name, names.join(" and "));
    Some(ProblemKind::File.problem(message))
}

/// The plan of a muscle, and the pressures at which it fails.
fn planned(request: &BuildRequest) -> Result<(Plan, Burst)> {
    let muscle = request.muscle.resolve();
    let muscle = muscle.map_err(|error| of_joint(request).unwrap_or(error))?;
    let fitting = request.fitting.as_deref().map(str::parse).transpose();
    let fitting = fitting.map_err(|e: mckibben_build::UnknownFitting| {
        ProblemKind::Usage.problem(e).in_field("fitting")
    })?;
    let above_zero = |field: &str, value: Option<f64>| {
        value
            .map(|value| above_zero(ProblemKind::OutOfRange, field, value))
            .transpose()
    };
    let wishes = Wishes {
        fitting,
        bolt_mm: above_zero("bolt_mm", request.bolt_mm.map(f64::from))?,
        sleeve_diameter_mm: above_zero(
            "sleeve_diameter_mm",
            request.sleeve_diameter_mm.map(f64::from),
        )?,
        liquid: request.liquid,
        shown: Shown {
            pressure: request.units.pressure.unit(Dimension::Pressure),
            force: request.units.force.unit(Dimension::Force),
            length: request.units.length.unit(Dimension::Length),
        },
        title_block: request.title_block.fields(),
    };
    let pressure_mpa = above_zero("pressure_mpa", request.pressure_mpa.map(f64::from))?;
    let (mut found, mut burst) = operating(request, &muscle, pressure_mpa)?;
    let loads = EndLoads::new(&muscle, &found);
    if pressure_mpa.is_none() && muscle.job().is_none() && loads.proof_to_use < USUAL_PROOF {
        let lower_mpa = loads.proved_mpa(&found, USUAL_PROOF);
        (found, burst) = operating(request, &muscle, Some(lower_mpa))?;
    }
    let plan = Plan::new(muscle, found, &wishes).map_err(|error| {
        let field = error.fields.first().copied().unwrap_or_default();
        ProblemKind::OutOfRange
            .problem(error.message)
            .in_field(field)
    })?;
    Ok((plan, burst))
}

/// What the muscle was designed for, or half of its free contraction.
fn pulls(evaluation: &mut Evaluation<'_>, pressure_mpa: f64, half: f64) -> Result<Vec<PullAt>> {
    let job = evaluation.model.muscle().job();
    let points = job.map_or(&[][..], |job| &job.points);
    let pull = |point: &JobPoint| {
        Ok(PullAt {
            required_n: Some(point.force.into()),
            ..pull_at(evaluation, pressure_mpa, point.contraction.into())?
        })
    };
    let mut pulls = points.iter().map(pull).collect::<Result<Vec<_>>>()?;
    if pulls.is_empty() {
        pulls.push(pull_at(evaluation, pressure_mpa, half)?);
    }
    Ok(pulls)
}

fn pull_at(evaluation: &mut Evaluation<'_>, pressure_mpa: f64, contraction: f64) -> Result<PullAt> {
    let point = evaluation.point(pressure_mpa, contraction)?;
    Ok(PullAt {
        pressure_mpa,
        contraction,
        required_n: None,
        force_n: point.response.force_n,
        built: point.built,
    })
}

/// What is expected at the points of the first test, on their branches.
fn expected(plan: &Plan) -> Result<Vec<PullAt>> {
    let choice = ModelFields::default().choose()?;
    let model = choice.build(&plan.muscle)?;
    let one = |point: &TestPoint| {
        cancel::check()?;
        let options = Options {
            direction: point.branch,
            ..Options::default()
        };
        let mut workspace = Workspace::new();
        let mut evaluation = Evaluation::new(&*model, &mut workspace, options);
        pull_at(&mut evaluation, point.pressure_mpa, point.contraction)
    };
    plan.test.iter().map(one).collect()
}

/// What `fe` finds of the muscle.
fn operating(
    request: &BuildRequest,
    muscle: &Muscle,
    given_mpa: Option<f64>,
) -> Result<(Operating, Burst)> {
    let choice = ModelFields::default().choose()?;
    let model = choice.build(muscle)?;
    let model = &*model;
    let mut workspace = Workspace::new();
    let in_use = AskFields::default().options(muscle)?;
    let mut evaluation = Evaluation::new(model, &mut workspace, in_use);
    let burst = burst_with(request.overpressure, &choice, model)?;
    let pressure_mpa = given_mpa.unwrap_or(usual_mpa(&burst, muscle));
    borne(&burst, pressure_mpa)?;
    evaluation.check_range(pressure_mpa, 0.0)?;
    let free = evaluation.free_contraction(pressure_mpa)?;
    let mut free_contractions = vec![];
    for p in Plan::test_pressures_mpa(pressure_mpa) {
        // Below the pressure at which it begins to pull there is nothing to test.
        free_contractions.extend(evaluation.free_contraction(p).ok().map(|free| (p, free)));
        cancel::check()?;
    }
    let blocked_force_n = evaluation.force_n(pressure_mpa, 0.0)?;
    let pulls = pulls(&mut evaluation, pressure_mpa, 0.5 * free)?;
    let point = evaluation.point(pressure_mpa, 0.5 * free)?;
    let words = UncertaintyWords::of(&point, &mut evaluation);
    let left: Vec<Left> = words.worth().copied().collect();
    let to_measure = point.uncertainty_n.filter(|_| !left.is_empty());
    let to_measure = to_measure.map(|uncertainty_n| ToMeasure {
        contraction: 0.5 * free,
        uncertainty_n,
        left,
    });
    let response = evaluation.response(pressure_mpa, free)?;
    let allowed_mpa = burst.allowed().map_or(f64::INFINITY, |allowed| allowed.mpa);
    let of_job = muscle.job().and_then(|job| job.highest);
    let highest_mpa = of_job.map_or(pressure_mpa, |mpa| pressure_mpa.max(mpa.into()));
    let highest_mpa = given_mpa.unwrap_or(highest_mpa);
    let relief_mpa = relief_mpa(highest_mpa, allowed_mpa);
    let job = muscle.job().into_iter().flat_map(|job| &job.points);
    let longest = job
        .map(|point| f64::from(point.contraction))
        .reduce(f64::min);
    let mut lengthening = evaluation.with(Options {
        direction: Direction::Elongation,
        ..in_use
    });
    let proof_mpa = proof_mpa(&burst, &mut lengthening, highest_mpa)?;
    let mut pull = |mpa, contraction| pull_at(&mut lengthening, mpa, contraction);
    let operating = Operating {
        model: model.info().name.to_string(),
        pressure_mpa,
        highest_mpa,
        blocked_force_n,
        branch: in_use.direction,
        free_contraction: free,
        bulged_diameter_mm: response.bulged_diameter_mm.unwrap_or_default(),
        volume_mm3: response
            .volume_mm3
            .unwrap_or_else(|| muscle.rest_volume_mm3()),
        in_use: pull(relief_mpa, longest.unwrap_or_default())?,
        stretched: pull(relief_mpa, -STRETCH)?,
        proof: pull(proof_mpa, -STRETCH)?,
        limits: (&burst).into(),
        strained_mpa: burst.strained.mpa(),
        pulls,
        free_contractions,
        to_measure,
    };
    Ok((operating, burst))
}
