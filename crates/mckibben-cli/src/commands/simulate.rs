//! `simulate`: one finite-element test with everything it knows.

use crate::asked::Asked;
use crate::failure::Failure;
use crate::format::Format;
use crate::output::text::{Units, aligned, columns, number, percent, percents, place};
use crate::output::{burst_first, check, check_ending, put, save};
use crate::progress::Bar;
use crate::shown;
use mckibben::model::Response;
use mckibben_app::{MuscleSummary, Problem, ProblemKind, Shapes, SimulateAnswer, SimulateRequest, Simulated};
use mckibben_fem::output::{Extent, Shape, VtuFile, VtuSeries};
use mckibben_fem::results::Solution;
use serde_json::json;
use std::path::PathBuf;

pub const TEXT: &str = "simulate: One finite-element test with all results: curves, shape, strands, stretches, sensitivities
Question: test p/pressures_mpa=pressure e/contractions=contraction
of_largest | Give contractions as shares of the free contraction at the highest pressure
F/forces_n=force
@muscle
Advanced:
model | Model: fe (axisymmetric) or fe3d (three-dimensional) [fe]
@mesh two_sided*
Output:
folder=vtu<DIR> | Write the deformed muscle, point by point, into a folder that ParaView opens (muscle.pvd)
whole*&folder | Write the whole muscle, not only the eighth that fe3d computes; fe always writes the whole muscle
export_inp<FILE> | Write mesh, material, loads and steps of an isometric test with fe3d as an input deck for CalculiX and Abaqus
@plot @output
Examples:
  mckibben simulate examples/prototype.toml -e 10% -p 0..0.25:0.05 --vtu out/
  mckibben simulate -D 40 -s 2 --test isotonic -F 150N -p 0.5..2.5:0.5bar \\
    --plot shape.svg
  mckibben simulate --model fe3d --match angle -e 10% -p 0.01..0.25:0.01 \\
    --export-inp muscle.inp
  mckibben simulate --model fe3d --terminal aluminium:20mm:3mm -e 10% \\
    -p 0.25 --vtu out/
  mckibben simulate --of-largest -e 0,45%,90% -p 0.25 --format csv";

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    let deck = asked.path("export_inp");
    check_ending(deck.as_deref(), &["inp"])?;
    let mut fields = asked.fields()?;
    fields.entry("test").or_insert_with(|| json!("isometric"));
    fields.insert("deck".into(), deck.is_some().into());
    let request: SimulateRequest = mckibben_app::understood(&fields.into())?;
    let extent = if asked.is("whole") { Extent::Whole } else { Extent::Eighth };
    let mut folder = asked.path("folder").map(|path| Folder { path, series: VtuSeries::new(""), extent });
    let shapes = folder.as_mut().map(|f| f as &mut dyn Shapes);
    let mut answer = mckibben_app::simulate(&request, &Bar::new("points"), shapes)?;
    let opened = folder.map(|f| f.write(&f.series.list())).transpose()?;
    if let Some(text) = answer.deck.take() {
        save(deck.as_deref(), text.as_bytes())?;
    }
    asked.draw(&mut answer.figure)?;
    if let Some(problem) = answer.problem.take_if(|_| asked.format == Format::Text) {
        return Err(problem.into());
    }
    let text = || {
        let burst = burst_first(&answer.warnings);
        let opened = opened.as_ref().map(|path| format!("\nParaView opens {}.\n", place(path)));
        burst + &as_text(&answer, &shown::units()) + &opened.unwrap_or_default()
    };
    asked.show(&answer, "points", text)?;
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
        points.iter().zip(responses()).map(|(q, r)| r.map(|r| r.contraction).or(q.held.contraction()));
    let pulls = points.iter().zip(responses()).map(|(q, r)| match r {
        _ if q.slack => Some(0.0),
        Some(r) => Some(r.force_n),
        None => q.held.force_n(),
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
    let ends = Some(s.energies.ends_n_mm).filter(|ends| *ends > 0.0);
    let ends = ends.map_or_else(String::new, |ends| format!(", ends {}", joules(ends)));
    let [rubber, braid, air] =
        [s.energies.rubber_n_mm, s.energies.braid_n_mm, s.energies.pressure_n_mm].map(joules);
    out += &format!("  energy: rubber {rubber}, strands {braid}{ends}, P·(V − V0) {air}\n");
    let ([r, z], unit) = (s.max_stretch.rest_mm.map(|mm| u.length.to(mm, 4)), &u.length.name);
    let stretch = number(s.max_stretch.value, 4);
    out += &format!("  largest stretch {stretch} at r {r}, z {z} {unit} from the middle (at rest)\n");
    if let (Some(first), Some(last)) = (s.strands.first(), s.strands.last()) {
        let [middle, end] = [first, last].map(|at| number(at.angle_deg, 4));
        let [from, to] = [first, last].map(|at| number(at.stretch, 5));
        out +=
            &format!("  strands: {middle}° in the middle, {end}° at the terminal; stretch {from} to {to}\n");
    }
    if !s.sensitivities.is_empty() {
        out.push_str("\nChange of the pull if one of these grows by 1 %\n");
    }
    for x in &s.sensitivities {
        let gain = 0.01 * x.value * x.force_n_per_unit;
        let space = if x.unit.is_empty() { "" } else { " " };
        let (name, value, gain) = (&x.name, number(x.value, 4), u.force.to(gain, 3));
        out += &format!("  {name:<22} {value:>9}{space}{:<5} {gain:>9} {}\n", x.unit, u.force.name);
    }
    out
}
