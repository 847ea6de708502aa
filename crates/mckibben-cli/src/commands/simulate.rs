//! `simulate`: one finite-element test with everything it knows.

use crate::failure::Failure;
use crate::flags::{MuscleFlags, OutputFlags, PlotFlag, mesh_fields};
use crate::format::Format;
use crate::output::text::{Units, aligned, columns, number, percent, percents, place};
use crate::output::{burst_first, check, check_ending, put, save, show};
use crate::plot;
use crate::progress::Bar;
use crate::quantities::{contractions, forces, points};
use crate::shown;
use crate::word::word;
use clap::Args;
use mckibben::curve::Test;
use mckibben::model::Response;
use mckibben::units::Dimension;
use mckibben_app::{
    Keep, MuscleSummary, Problem, ProblemKind, Shapes, SimulateAnswer, SimulateRequest, Simulated,
};
use mckibben_fem::output::{Extent, Shape, VtuFile, VtuSeries};
use mckibben_fem::results::Solution;
use std::path::PathBuf;

pub const EXAMPLES: &str = "Examples:
  mckibben simulate examples/prototype.toml -e 10% -p 0..0.25:0.05 --vtu out/
  mckibben simulate -D 40 -s 2 --test isotonic -F 150N -p 0.5..2.5:0.5bar \\
    --plot shape.svg
  mckibben simulate --model fe3d --match angle -e 10% -p 0.01..0.25:0.01 \\
    --export-inp muscle.inp
  mckibben simulate --model fe3d --terminal aluminium:20mm:3mm -e 10% \\
    -p 0.25 --vtu out/
  mckibben simulate --of-largest -e 0,45%,90% -p 0.25 --format csv";

/// `simulate`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct SimulateArgs {
    /// Kind of test
    #[arg(long, value_parser = word::<Test>(), default_value = "isometric")]
    pub test: Test,
    /// Pressures [0.05..0.25:0.05]
    #[arg(short, long, value_name = "RANGE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    /// Contraction ratios of an isometric or isobaric test [0..0.2:0.1]
    #[arg(short = 'e', long, value_name = "RANGE", allow_hyphen_values = true)]
    pub contraction: Option<String>,
    /// Give contractions as shares of the free contraction at the highest pressure
    #[arg(long)]
    pub of_largest: bool,
    /// Pulls of an isotonic test [20,80,150N]
    #[arg(short = 'F', long, value_name = "RANGE", allow_hyphen_values = true)]
    pub force: Option<String>,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    /// Model: fe (axisymmetric) or fe3d (three-dimensional)
    #[arg(long, value_name = "NAME", default_value = "fe", help_heading = "Advanced")]
    pub model: String,
    /// Mesh of fe: elements along the half length, or through the wall x along, or with :grading; of fe3d: bricks around
    /// the quarter, or through x around, or through x around x along [automatic]
    #[arg(long, value_name = "N or MxN:G", hide_short_help = true, help_heading = "Advanced")]
    pub mesh: Option<String>,
    /// Dimension that fe3d keeps if bricks with strands at ±θ0 do not fill the length exactly
    #[arg(long = "match", value_parser = word::<Keep>(), value_name = "WHAT", default_value = "length", hide_short_help = true, help_heading = "Advanced")]
    pub keep: Keep,
    /// Terminal of fe3d: none (a rigid plane), rigid or aluminium (a plug), with :insertion and :radius of its nose [none]
    #[arg(long, value_name = "WORD:MM:MM", hide_short_help = true, help_heading = "Advanced")]
    pub terminal: Option<String>,
    /// Give the negative force, not slack, where the muscle would have to push
    #[arg(long, hide_short_help = true, help_heading = "Advanced")]
    pub two_sided: bool,
    /// Write the deformed muscle, point by point, into a folder that ParaView opens (muscle.pvd)
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub vtu: Option<PathBuf>,
    /// Write the whole muscle, not only the eighth that fe3d computes; fe always writes the whole muscle
    #[arg(long, requires = "vtu", hide_short_help = true, help_heading = "Output")]
    pub whole: bool,
    /// Write mesh, material, loads and steps of an isometric test with fe3d as an input deck for CalculiX and Abaqus
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub export_inp: Option<PathBuf>,
    #[command(flatten)]
    pub plot: PlotFlag,
    #[command(flatten)]
    pub output: OutputFlags,
}

pub fn run(args: &SimulateArgs, format: Format) -> Result<u8, Failure> {
    plot::check(&args.plot)?;
    check_ending(args.export_inp.as_deref(), &["inp"])?;
    let unit = shown::units();
    let request = SimulateRequest {
        test: args.test,
        muscle: args.muscle.fields()?,
        model: Some(args.model.clone()),
        mesh: mesh_fields(args.mesh.as_deref(), args.keep, args.terminal.as_deref())?,
        pressures_mpa: points("--pressure", args.pressure.as_deref(), Dimension::Pressure, 5)?,
        contractions: contractions(args.contraction.as_deref())?,
        of_largest: args.of_largest,
        forces_n: forces(args.force.as_deref())?,
        two_sided: args.two_sided,
        deck: args.export_inp.is_some(),
        // Written into a folder, point by point.
        vtu: false,
        figure: args.plot.plot.as_ref().map(|_| unit.clone()),
    };
    let extent = if args.whole { Extent::Whole } else { Extent::Eighth };
    let mut folder = args.vtu.clone().map(|path| Folder { path, series: VtuSeries::new(""), extent });
    let shapes = folder.as_mut().map(|f| f as &mut dyn Shapes);
    let mut answer = mckibben_app::simulate(&request, &Bar::new("points"), shapes)?;
    let opened = folder.map(|f| f.write(&f.series.list())).transpose()?;
    if let Some(deck) = answer.deck.take() {
        save(args.export_inp.as_deref(), deck.as_bytes())?;
    }
    plot::save(answer.figure.take(), &args.plot)?;
    if let Some(problem) = answer.problem.take_if(|_| format == Format::Text) {
        return Err(problem.into());
    }
    let text = || {
        let burst = burst_first(&answer.warnings);
        let opened = opened.as_ref().map(|path| format!("\nParaView opens {}.\n", place(path)));
        burst + &as_text(&answer, &unit) + &opened.unwrap_or_default()
    };
    show(&answer, format, "points", text, args.output.target())?;
    Ok(answer.problem.map_or(0, |problem| Failure::from(problem).exit()))
}

/// A folder of files for ParaView.
struct Folder {
    path: PathBuf,
    series: VtuSeries,
    extent: Extent,
}

impl Folder {
    fn write(&self, file: &VtuFile) -> Result<PathBuf, Problem> {
        let path = self.path.join(&file.name);
        put(&path, file.text.as_bytes()).map_err(Failure::into_problem)?;
        Ok(path)
    }
}

impl Shapes for Folder {
    fn begin(&mut self, muscle: &MuscleSummary) -> Result<(), Problem> {
        self.series = VtuSeries::new(&muscle.line(&Units::default()));
        // Its list, which is written again with each point.
        check(&self.path.join(self.series.list().name)).map_err(Failure::into_problem)?;
        std::fs::create_dir_all(&self.path).map_err(|e| {
            let message = format!("the folder {} cannot be made: {e}", self.path.display());
            Problem::new(ProblemKind::Output, message, "give the name of a new folder or of one that exists")
        })
    }

    fn add(&mut self, shape: Shape, response: &Response) -> Result<(), Problem> {
        let files = self.series.add(shape, response);
        let files = files.map_err(|e| Problem::new(ProblemKind::Output, e.to_string(), ""))?;
        files.iter().try_for_each(|file| self.write(file).map(drop))
    }

    fn extent(&self) -> Extent {
        self.extent
    }
}

fn as_text(answer: &SimulateAnswer, u: &Units) -> String {
    let (strands, points) = (answer.strands, &answer.simulated);
    let tension = |r: &Response| if strands { r.strand_tension_n } else { r.braid_tension_n };
    let responses = || points.iter().map(|q| q.solution.as_ref().ok().map(|s| &s.response));
    let of = |what: fn(&Response) -> Option<f64>| responses().map(move |r| r.and_then(what));
    let contractions =
        points.iter().zip(responses()).map(|(q, r)| r.map(|r| r.contraction).or(q.contraction()));
    let pulls = points.iter().zip(responses()).map(|(q, r)| match r {
        _ if q.slack => Some(0.0),
        Some(r) => Some(r.force_n),
        None => q.force_n(),
    });
    let notes = points.iter().map(|q| match &q.solution {
        _ if q.slack => hangs(q),
        Err(_) => q.status.to_string(),
        Ok(s) if s.unstable_directions > 0 => "unstable".into(),
        Ok(_) => String::new(),
    });
    let stiffness = u.stiffness();
    let list = [
        (u.pressure.heading("P"), u.pressure.column(points.iter().map(|q| Some(q.pressure_mpa)), 4)),
        ("ε".into(), percents(contractions, 4)),
        (u.force.heading("F"), u.force.column(pulls, 5)),
        (u.volume.heading("V"), u.volume.column(of(|r| r.volume_mm3), 4)),
        (u.length.heading("bulged D"), u.length.column(of(|r| r.bulged_diameter_mm), 4)),
        (
            u.force.heading(if strands { "strand" } else { "braid" }),
            u.force.column(responses().map(|r| r.and_then(tension)), 4),
        ),
        (stiffness.heading("stiffness"), stiffness.column(of(|r| r.stiffness_n_per_mm), 4)),
        ("stretch".into(), aligned(&of(|r| r.max_stretch).collect::<Vec<_>>(), 3)),
        (String::new(), notes.collect()),
    ];
    let mut out = format!("{} test, model {}\n{}\n", answer.test.name(), answer.model, answer.muscle.line(u));
    answer.notes.iter().for_each(|note| out.push_str(&format!("note: {}\n", u.sentence(note))));
    out.push('\n');
    out.push_str(&columns(list));
    let what =
        if strands { "strand: tension of one strand" } else { "braid: tension of all strands together" };
    out.push_str(&format!("\n{what}. stretch: 99 % of the rubber is stretched by less.\n"));
    if let Some(s) = points.iter().rev().find_map(|q| q.solution.as_ref().ok()) {
        out.push_str(&last_text(s, u));
    }
    out
}

/// Where a slack muscle hangs.
fn hangs(q: &Simulated) -> String {
    q.free_contraction.map_or_else(|| "slack".into(), |e| format!("slack, free contraction {}", percent(e)))
}

/// What is known of one equilibrium beyond the table.
fn last_text(s: &Solution, u: &Units) -> String {
    let r = &s.response;
    let mut out = format!("\nAt {} and {}\n", u.pressure.show(r.pressure_mpa), percent(r.contraction));
    let joules = |v: f64| format!("{} J", number(1e-3 * v, 4));
    out.push_str(&format!(
        "  energy: rubber {}, strands {}{}, P·(V − V0) {}\n",
        joules(s.energies.rubber_n_mm),
        joules(s.energies.braid_n_mm),
        if s.energies.ends_n_mm > 0.0 {
            format!(", ends {}", joules(s.energies.ends_n_mm))
        } else {
            String::new()
        },
        joules(s.energies.pressure_n_mm)
    ));
    let at = s.max_stretch.rest_mm;
    out.push_str(&format!(
        "  largest stretch {} at r {}, z {} {} from the middle (at rest)\n",
        number(s.max_stretch.value, 4),
        u.length.to(at[0], 4),
        u.length.to(at[1], 4),
        u.length.name
    ));
    if let (Some(first), Some(last)) = (s.strands.first(), s.strands.last()) {
        out.push_str(&format!(
            "  strands: {}° in the middle, {}° at the terminal; stretch {} to {}\n",
            number(first.angle_deg, 4),
            number(last.angle_deg, 4),
            number(first.stretch, 5),
            number(last.stretch, 5)
        ));
    }
    if !s.sensitivities.is_empty() {
        out.push_str("\nChange of the pull if one of these grows by 1 %\n");
    }
    for x in &s.sensitivities {
        let gain = 0.01 * x.value * x.force_n_per_unit;
        let space = if x.unit.is_empty() { "" } else { " " };
        out.push_str(&format!(
            "  {:<22} {:>9}{space}{:<5} {:>9} {}\n",
            x.name,
            number(x.value, 4),
            x.unit,
            u.force.to(gain, 3),
            u.force.name
        ));
    }
    out
}
