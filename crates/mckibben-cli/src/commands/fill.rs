//! `fill`: a volume of liquid pushed into a muscle.

use crate::{FLAT, Format, Output, Problem, Units, burst_first, listed, pairs, value};
use mckibben_app::rows::{estimated, limit_rows};
use mckibben_app::{FillAnswer, FillRequest};

const KEYS: &str = "model about.source=by liquid.name=liquid liquid.gas_share=gas:% \
    liquid.bulk_modulus_mpa=bulk_modulus effective_bulk_modulus_mpa=with_its_gas_at_this_pressure \
    pushed_volume_mm3=pushed_in compressed_volume_mm3=of_it_by_compression pressure_mpa stroke_mm \
    contraction+contraction_uncertainty:% state force_n+uncertainty_n=pull \
    shut_stiffness_n_per_mm=stiffness,_liquid_shut_in stiffness_n_per_mm=at_constant_pressure \
    pump_work_j=work_of_the_pump muscle_energy_j=stored_in_the_muscle \
    liquid_energy_j=stored_in_the_liquid load_work_j=work_on_the_load \
    friction_work_j=taken_by_friction volume_mm3=cavity rest_volume_mm3=cavity_at_the_start";

/// A volume of liquid pushed into a muscle.
#[derive(Debug, clap::Args)]
#[command(after_long_help = "Examples:
  mckibben fill -D 30 -s 2 -L 200 --volume 20mL --load mass:10kg
  mckibben fill examples/festo-dmsp-20.toml --volume 30mL -e 10% \\
    --liquid oil --gas 1% --dead-volume 15mL")]
pub struct Fill {
    #[command(flatten)]
    request: FillRequest,
    #[command(flatten)]
    output: Output,
}

impl Fill {
    pub fn run(mut self, format: Format) -> Result<u8, Problem> {
        self.request.load.read_tables()?;
        let answer = mckibben_app::fill(&self.request)?;
        self.output.show(format, &answer, FLAT, text)
    }
}

fn text(answer: &FillAnswer, u: &Units) -> String {
    let uncertainty = answer
        .background
        .uncertainty_words
        .text_in(u)
        .map(|text| format!("of the pull {text}"));
    let mut rows = vec![("muscle".to_owned(), answer.background.muscle.line(u))];
    rows.extend(listed(&value(answer), KEYS, u));
    rows.extend(limit_rows(
        &answer.background.limits,
        estimated(&answer.background.muscle),
        u,
    ));
    rows.extend(uncertainty.map(|text| ("uncertainty".to_owned(), text)));
    burst_first(&answer.fill.answer.warnings) + &pairs(&rows)
}
