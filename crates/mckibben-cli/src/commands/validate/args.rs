//! The flags of `validate`.

use crate::flags::{OutputFlags, PlotFlag};
use crate::names::MODELS;
use clap::Args;
use std::path::PathBuf;

/// `validate`.
#[derive(Debug, Args)]
pub struct ValidateArgs {
    /// Also compute the finest meshes (some seconds more)
    #[arg(long, conflicts_with = "sweep")]
    pub all: bool,
    /// Robustness sweep over N random muscles: the share of random points with an answer
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub sweep: Option<u32>,
    /// Seed of the random muscles
    #[arg(long, default_value_t = 1, requires = "sweep")]
    pub seed: u64,
    /// Validation report of measured muscles and rubbers: known data, fitted constants, errors at fitted points and at predicted points. Cases of DIR, one folder each [the built-in cases]
    #[arg(long, value_name = "DIR", num_args = 0..=1, conflicts_with_all = ["sweep", "all"])]
    pub measured: Option<Option<PathBuf>>,
    /// Only these cases, by folder name
    #[arg(long, value_name = "NAME", value_delimiter = ',', requires = "measured")]
    pub only: Vec<String>,
    /// Model of the measured muscles [fe]
    #[arg(long, value_name = "NAME", requires = "measured", value_parser = MODELS, hide_possible_values = true)]
    pub model: Option<String>,
    #[command(flatten)]
    pub plot: PlotFlag,
    #[command(flatten)]
    pub output: OutputFlags,
}
