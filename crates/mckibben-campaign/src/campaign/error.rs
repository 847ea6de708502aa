//! Why a campaign does not run, or a store cannot be read.

use mckibben_core::{cancel::Cancelled, threads::ThreadsError};
#[cfg(feature = "store")]
use mckibben_io::files::ReadError;
#[cfg(feature = "store")]
use std::path::Path;
use std::path::PathBuf;
use thiserror::Error;

pub type Result<T, E = CampaignError> = std::result::Result<T, E>;

/// Why a campaign does not run, or a store cannot be read.
#[derive(Debug, Error)]
pub enum CampaignError {
    /// The store holds the table of another plan, or of another version of the program, whose
    /// numbers may differ.
    #[error("{0}")]
    OtherPlan(String),
    /// Another process writes to the store.
    #[error("another process is writing to {}", .0.display())]
    Locked(PathBuf),
    /// A file that is not what was written, and what shows it.
    #[error("{path} is damaged: {1}", path = .0.display())]
    Damaged(PathBuf, String),
    /// Parts are missing.
    #[error("{0}")]
    Incomplete(String),
    /// Two files claim to be the same part and are not.
    #[error("{} and {} are the same part of the plan and differ", .0.display(), .1.display())]
    Conflict(PathBuf, PathBuf),
    /// A place without a campaign, and its content.
    #[error("{path} is not a campaign: {1}", path = .0.display())]
    NoCampaign(PathBuf, String),
    /// A place that conflicts with the rest of the request, and what to do about it.
    #[error("{0}")]
    Refused(String, &'static str),
    /// A file cannot be written; what was there before is untouched.
    #[error("cannot write {path}: {1}", path = .0.display())]
    Write(PathBuf, std::io::Error),
    /// A file that is not read.
    #[cfg(feature = "store")]
    #[error("{path} {1}", path = .0.display())]
    Read(PathBuf, ReadError),
    /// A file in the place of one of the campaign that is of something else, and of what.
    #[error("{path} is not a file of a campaign ({1}) and would be overwritten", path = .0.display())]
    Foreign(PathBuf, String),
    /// A file where that of the campaign would be written.
    #[error("{} exists and would be overwritten", .0.display())]
    Appeared(PathBuf),
    /// The caller wanted it to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// No threads to be had.
    #[error(transparent)]
    Threads(#[from] ThreadsError),
}

impl CampaignError {
    /// What to do about it; may be empty.
    pub fn hint(&self) -> &'static str {
        match self {
            Self::OtherPlan { .. } => {
                "write to another place, or replace it with `overwrite`; a table is of one text of \
                 a plan and one version of the program"
            }
            Self::Foreign { .. } => {
                "write to another place, move it away, or replace it with `overwrite`"
            }
            Self::Appeared { .. } => {
                "move it away and give the same command again; `overwrite` replaces it"
            }
            #[cfg(feature = "store")]
            Self::Read(_, ReadError::System(error))
                if error.kind() != std::io::ErrorKind::NotFound =>
            {
                "the operating system refused to read it; it is not necessarily damaged"
            }
            Self::Locked { .. } => "wait for it to end, or write to another place",
            Self::Damaged { .. } => {
                "parts of a folder are recomputed when the campaign is run again; another file is \
                 replaced with `overwrite`"
            }
            Self::Incomplete { .. } => {
                "run the campaign (or the missing shards) again: it computes what is missing"
            }
            Self::Conflict { .. } => {
                "they come from different programs or machines: recompute one of them"
            }
            Self::Refused(_, hint) => hint,
            Self::Write { .. } => {
                "what was written before is a valid store; the same command continues from there"
            }
            Self::Threads(_) => "take fewer threads; the table does not depend on them",
            _ => "",
        }
    }
}

#[cfg(feature = "store")]
impl CampaignError {
    pub(super) fn write(path: &Path) -> impl FnOnce(std::io::Error) -> Self {
        let path = path.to_path_buf();
        move |error| Self::Write(path, error)
    }

    /// A folder or file that is not read.
    pub(super) fn read<E: Into<ReadError>>(path: &Path) -> impl FnOnce(E) -> Self {
        let path = path.to_path_buf();
        move |error| Self::Read(path, error.into())
    }

    pub(super) fn other_format(path: &Path) -> Self {
        let path = path.display();
        Self::Refused(
            format!(
                "a campaign is one file that ends in .parquet, or a folder of parts; {path} would \
                 be neither"
            ),
            "name it FILE.parquet, which pandas, DuckDB and others read, and write as CSV",
        )
    }

    pub(super) fn damaged(path: &Path, why: impl ToString) -> Self {
        Self::Damaged(path.into(), why.to_string())
    }
}
