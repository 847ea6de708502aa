//! `force`, `pressure`, `contraction`: one point.

use crate::{Format, Output, Problem, burst_first, output::loaded::loaded, pairs};
use clap::Args;
use mckibben_app::{
    ContractionRequest, ForceRequest, PointAnswer, PointQuantity, PressureRequest, rows::point_rows,
};

/// F(P, ε).
#[derive(Debug, Args)]
#[command(after_long_help = "Example:
  mckibben force -D 50 -s 1 -p 0.25 -e 0.1 --model paper")]
pub struct Force {
    #[command(flatten)]
    request: ForceRequest,
    #[command(flatten)]
    output: Output,
}

/// P(F, ε).
#[derive(Debug, Args)]
#[command(after_long_help = "Example:
  mckibben pressure -D 40 -s 2 -F 300N -e 10% --units bar")]
pub struct Pressure {
    #[command(flatten)]
    request: PressureRequest,
    #[command(flatten)]
    output: Output,
}

/// ε(F, P).
#[derive(Debug, Args)]
#[command(after_long_help = "Example:
  mckibben contraction -D 40 -s 2 -F 600N -p 2.5bar")]
pub struct Contraction {
    #[command(flatten)]
    request: ContractionRequest,
    #[command(flatten)]
    output: Output,
}

impl Force {
    pub fn run(self, format: Format) -> Result<u8, Problem> {
        let answer = mckibben_app::force(&self.request)?;
        show(&self.output, format, answer, PointQuantity::Force)
    }
}

impl Pressure {
    pub fn run(self, format: Format) -> Result<u8, Problem> {
        let answer = mckibben_app::pressure(&self.request)?;
        show(&self.output, format, answer, PointQuantity::Pressure)
    }
}

impl Contraction {
    pub fn run(mut self, format: Format) -> Result<u8, Problem> {
        self.request.load.read_tables()?;
        let answer = mckibben_app::contraction(&self.request)?;
        show(&self.output, format, answer, PointQuantity::Contraction)
    }
}

fn show(
    output: &Output,
    format: Format,
    answer: PointAnswer,
    of: PointQuantity,
) -> Result<u8, Problem> {
    output.show(format, &answer, "", |answer, u| {
        let load = answer
            .loaded
            .as_ref()
            .map_or_else(String::new, |load| loaded(load, u));
        burst_first(&answer.point.warnings) + &pairs(&point_rows(answer, of, u)) + &load
    })
}
