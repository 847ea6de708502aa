//! `force`, `pressure`, `contraction`: one point.

use crate::{Context, Output, Result, examples::examples};
use clap::Args;
use mckibben_app::{ContractionRequest, ForceRequest, PressureRequest};

/// F(P, ε).
#[derive(Args)]
#[command(after_long_help = examples(&[
    "force -D 50 -s 1 -p 0.25 -e 0.1 --model paper"
]))]
pub struct Force {
    #[command(flatten)]
    request: ForceRequest,
    #[command(flatten)]
    output: Output,
}

/// P(F, ε).
#[derive(Args)]
#[command(after_long_help = examples(&[
    "pressure -D 40 -s 2 -F 300N -e 10% --units bar"
]))]
pub struct Pressure {
    #[command(flatten)]
    request: PressureRequest,
    #[command(flatten)]
    output: Output,
}

/// ε(F, P).
#[derive(Args)]
#[command(after_long_help = examples(&[
    "contraction -D 40 -s 2 -F 600N -p 2.5bar"
]))]
pub struct Contraction {
    #[command(flatten)]
    request: ContractionRequest,
    #[command(flatten)]
    output: Output,
}

impl Force {
    pub fn run(self, context: &Context) -> Result<u8> {
        self.output
            .print(context, &mckibben_app::force(&self.request)?)
    }
}

impl Pressure {
    pub fn run(self, context: &Context) -> Result<u8> {
        self.output
            .print(context, &mckibben_app::pressure(&self.request)?)
    }
}

impl Contraction {
    pub fn run(mut self, context: &Context) -> Result<u8> {
        self.request.load.read_tables()?;
        self.output
            .print(context, &mckibben_app::contraction(&self.request)?)
    }
}
