//! `simulate`: one finite-element test with everything it knows.

use crate::{
    Bar, Format, Output, Plot, Problem, Units, burst_first, check_ending, exit_code, headed,
    listed, output::check, pairs, percent, place, save, save_all, tabled, value,
};
use mckibben_app::{SimulateAnswer, SimulateRequest, Simulated};
use serde_json::Value;
use std::path::PathBuf;

/// One finite-element test.
#[derive(Debug, clap::Args)]
#[command(after_long_help = "Examples:
  mckibben simulate examples/prototype.toml -e 10% -p 0..0.25:0.05 --vtu out/
  mckibben simulate -D 40 -s 2 --test isotonic -F 150N -p 0.5..2.5:0.5bar \\
    --plot shape.svg
  mckibben simulate --model fe3d --match angle -e 10% -p 0.01..0.25:0.01 \\
    --export-inp muscle.inp
  mckibben simulate --model fe3d --terminal aluminium:20mm:3mm -e 10% \\
    -p 0.25 --vtu out/
  mckibben simulate --of-largest -e 0,45%,90% -p 0.25 --format csv")]
pub struct Simulate {
    #[command(flatten)]
    request: SimulateRequest,
    /// Write the deformed muscle, point by point, into a folder that ParaView opens (muscle.pvd)
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    vtu: Option<PathBuf>,
    /// Write the whole muscle, not only the eighth that fe3d computes; fe always writes the whole
    /// muscle
    #[arg(
        long,
        requires = "vtu",
        hide_short_help = true,
        help_heading = "Output"
    )]
    whole: bool,
    /// Write mesh, material, loads and steps of an isometric test with fe3d as an input deck for
    /// CalculiX and Abaqus
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    export_inp: Option<PathBuf>,
    #[command(flatten)]
    plot: Plot,
    #[command(flatten)]
    output: Output,
}

impl Simulate {
    pub fn run(mut self, format: Format) -> Result<u8, Problem> {
        let deck = self.export_inp.as_deref();
        check_ending(deck, &["inp"])?;
        let opened = self.vtu.as_ref().map(|folder| folder.join("muscle.pvd"));
        opened.as_deref().map_or(Ok(()), check)?;
        self.request.figure = self.plot.wanted();
        self.request.deck = deck.is_some();
        self.request.vtu = self.vtu.is_some();
        self.request.eighth = !self.whole;
        let mut answer = mckibben_app::simulate(&self.request, &Bar::new("points"))?;
        let files = std::mem::take(&mut answer.files);
        self.vtu
            .map_or(Ok(()), |folder| save_all(&files, &folder))?;
        if let Some(text) = answer.deck.take() {
            save(deck, text.as_bytes())?;
        }
        self.plot.save(&mut answer.figure)?;
        if let Some(problem) = answer.problem.take_if(|_| format == Format::Text) {
            return Err(problem);
        }
        self.output.show(format, &answer, "points", |answer, u| {
            let opened = opened.map(|path| format!("\nParaView opens {}.\n", place(&path)));
            burst_first(&answer.warnings) + &as_text(answer, u) + &opened.unwrap_or_default()
        })?;
        Ok(exit_code(answer.problem.as_ref()))
    }
}

const POINTS: &str = "pressure_mpa=P contraction=ε:4% force_n=F:5 volume_mm3=V \
    bulged_diameter_mm=bulged_D strand_tension_n=strand braid_tension_n=braid \
    stiffness_n_per_mm=stiffness max_stretch=stretch:3 note=_";

fn as_text(answer: &SimulateAnswer, u: &Units) -> String {
    let mut points = value(answer)["points"].take();
    for (row, q) in points
        .as_array_mut()
        .into_iter()
        .flatten()
        .zip(&answer.simulated)
    {
        row["note"] = match &q.solution {
            _ if q.slack => hangs(q),
            Err(_) => q.status.to_string(),
            Ok(s) if s.unstable_directions > 0 => "unstable".into(),
            Ok(_) => String::new(),
        }
        .into();
    }
    let points = points.as_array().map_or(&[][..], Vec::as_slice);
    let mut out = format!(
        "{} test, model {}\n{}\n",
        answer.test.name(),
        answer.model,
        answer.muscle.line(u)
    );
    answer
        .notes
        .iter()
        .for_each(|note| out.push_str(&format!("note: {}\n", u.sentence(note))));
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
    q.free_contraction.map_or_else(
        || "slack".into(),
        |e| format!("slack, free contraction {}", percent(e)),
    )
}

const LAST: &str = "pressure_mpa contraction:% rubber_energy_j=energy_of_the_rubber \
    braid_energy_j=of_the_strands ends_energy_j=of_the_ends pressure_work_j=P·(V_−_V0) \
    max_stretch_at.rest_r_mm=largest_stretch_at_r_(at_rest) \
    max_stretch_at.rest_z_mm=z_from_the_middle";

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
    let (gains, keys) = (
        rows("sensitivities").into_iter().map(gain),
        "name=_ value:4~ unit gain_n=pull:3~",
    );
    out + &headed(
        "Change of the pull if one of these grows by 1 %",
        gains,
        keys,
        u,
    )
}
