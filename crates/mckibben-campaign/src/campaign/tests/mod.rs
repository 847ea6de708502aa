//! Stores: the same bytes whatever happens on the way, and nothing that is damaged is believed.

#![allow(clippy::unwrap_used, clippy::panic)] // in what the tests share

mod damage;
mod rows;
mod same_bytes;

use super::{error::Result, *};
use crate::PointRow;
use mckibben_core::{
    progress::{Progress, Silent},
    status::Status,
};
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Twelve muscles on a coarse mesh, six points each, one part each.
const PLAN: &str = "[sampling]\nmethod = \"sobol\"\nsamples = 12\nseed = 2\n\
    [vary]\ntube.outer_diameter = \"20..50 mm\"\ntube.wall_ratio = \"4..12%\"\n\
    [test]\ncontractions = \"0,10%\"\npressures = \"0.1,0.2,0.3\"\nmesh = \"3\"\n";

fn plan() -> Plan {
    Plan::parse(PLAN).unwrap()
}

fn folder() -> TempDir {
    tempfile::tempdir().unwrap()
}

fn run_to(out: &Path) -> CampaignOutcome {
    run(&plan(), out, &RunOptions::default(), &Silent).unwrap()
}

fn share(text: &str) -> RunOptions {
    RunOptions {
        shard: Some(text.parse().unwrap()),
        ..RunOptions::default()
    }
}

fn read(path: impl AsRef<Path>) -> Result<Vec<PointRow>> {
    rows(path)?.collect()
}

fn bytes(path: &Path) -> Vec<u8> {
    std::fs::read(path).unwrap()
}

/// The bytes of one uninterrupted run.
fn reference(dir: &TempDir) -> Vec<u8> {
    let path = dir.path().join("reference.parquet");
    assert!(run_to(&path).complete);
    bytes(&path)
}

fn part(folder: &Path, number: u64) -> PathBuf {
    folder.join(super::store::folder::part_name(number))
}
