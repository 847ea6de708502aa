//! `simulate`: one finite-element test with everything it knows.

use crate::{
    Asked, Bar, Failure, Format, Units, burst_first, check_ending, listed, output::check, overwrite, pairs,
    percent, place, save, save_inside, shown, tabled, value,
};
use mckibben::model::Response;
use mckibben_app::{MuscleSummary, Problem, ProblemKind, Shapes, SimulateAnswer, SimulateRequest, Simulated};
use mckibben_fem::output::{Extent, Shape, VtuFile, VtuSeries};
use serde_json::{Value, json};
use std::path::PathBuf;

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    let deck = asked.path("export_inp");
    check_ending(deck.as_deref(), &["inp"])?;
    let mut fields = asked.fields()?;
    fields.entry("test").or_insert_with(|| json!("isometric"));
    fields.insert("deck".into(), deck.is_some().into());
    let request: SimulateRequest = mckibben_app::understood(&fields.into())?;
    let extent = if asked.is("whole") { Extent::Whole } else { Extent::Eighth };
    let mut folder =
        asked.path("folder").map(|path| Folder { path, series: VtuSeries::new(""), extent, is_begun: false });
    let shapes = folder.as_mut().map(|f| f as &mut dyn Shapes);
    let mut answer = mckibben_app::simulate(&request, &Bar::new("points"), shapes)?;
    let opened = folder.map(|mut f| f.write(&f.series.list())).transpose()?;
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
    /// Whether its list is written.
    is_begun: bool,
}

impl Folder {
    /// Writes a file. The list, which is written again with each point, is ours from the first one on.
    fn write(&mut self, file: &VtuFile) -> Result<PathBuf, Problem> {
        let path = self.path.join(&file.name);
        let is_list = file.name == self.series.list().name;
        let ours = is_list && std::mem::replace(&mut self.is_begun, is_list);
        save_inside(&self.path, [(&file.name, &file.text)], ours || overwrite())
            .map_err(Failure::into_problem)?;
        Ok(path)
    }
}

impl Shapes for Folder {
    fn begin(&mut self, muscle: &MuscleSummary) -> Result<(), Problem> {
        self.series = VtuSeries::new(&muscle.line(&Units::default()));
        check(&self.path.join(self.series.list().name)).map_err(Failure::into_problem)?;
        save_inside::<&str, &str>(&self.path, [], false).map_err(Failure::into_problem)
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

const POINTS: &str = "pressure_mpa=P contraction=ε:4% force_n=F:5 volume_mm3=V bulged_diameter_mm=bulged_D strand_tension_n=strand braid_tension_n=braid stiffness_n_per_mm=stiffness max_stretch=stretch:3 note=_";

fn as_text(answer: &SimulateAnswer, u: &Units) -> String {
    let mut points = value(answer)["points"].take();
    for (row, q) in points.as_array_mut().into_iter().flatten().zip(&answer.simulated) {
        row["note"] = match &q.solution {
            _ if q.slack => hangs(q),
            Err(_) => q.status.to_string(),
            Ok(s) if s.unstable_directions > 0 => "unstable".into(),
            Ok(_) => String::new(),
        }
        .into();
    }
    let points = points.as_array().map_or(&[][..], Vec::as_slice);
    let mut out = format!("{} test, model {}\n{}\n", answer.test.name(), answer.model, answer.muscle.line(u));
    answer.notes.iter().for_each(|note| out.push_str(&format!("note: {}\n", u.sentence(note))));
    out += &format!(
        "\n{}\nstrand: tension of one strand; braid: of all strands together. ",
        tabled(points, POINTS, u)
    );
    out += "stretch: 99 % of the rubber is stretched by less.\n";
    if let Some(last) = points.iter().rfind(|q| q["profile"].is_array()) {
        out += &last_text(last, u);
    }
    out
}

/// Where a slack muscle hangs.
fn hangs(q: &Simulated) -> String {
    q.free_contraction.map_or_else(|| "slack".into(), |e| format!("slack, free contraction {}", percent(e)))
}

const LAST: &str = "pressure_mpa contraction:% rubber_energy_j=energy_of_the_rubber braid_energy_j=of_the_strands ends_energy_j=of_the_ends pressure_work_j=P·(V_−_V0) max_stretch_at.rest_r_mm=largest_stretch_at_r_(at_rest) max_stretch_at.rest_z_mm=z_from_the_middle";

/// What is known of one equilibrium beyond the table.
fn last_text(point: &Value, u: &Units) -> String {
    let rows = |name: &str| point[name].as_array().cloned().unwrap_or_default();
    let mut out = format!("\nThe last point\n{}", pairs(&listed(point, LAST, u)));
    let strands = rows("strands");
    let ends: Vec<&Value> = strands.first().into_iter().chain(strands.last()).collect();
    let strands = tabled(&ends, "rest_z_mm=z_at_rest angle_deg stretch:5", u);
    out += &format!("\nStrands in the middle and at the terminal\n{strands}");
    let gain = |mut row: Value| {
        let gain = row["value"].as_f64().zip(row["force_n_per_unit"].as_f64());
        row["gain_n"] = gain.map(|(value, slope)| 0.01 * value * slope).into();
        row
    };
    let gains: Vec<Value> = rows("sensitivities").into_iter().map(gain).collect();
    if !gains.is_empty() {
        let keys = "name=_ value:4~ unit gain_n=pull:3~";
        out += &format!("\nChange of the pull if one of these grows by 1 %\n{}", tabled(&gains, keys, u));
    }
    out
}
