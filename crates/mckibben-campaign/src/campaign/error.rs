//! Why a campaign does not run, or a store cannot be read.

use mckibben::cancel::Cancelled;
use mckibben::threads::ThreadsError;
#[cfg(feature = "store")]
use std::path::Path;
use std::path::PathBuf;
use thiserror::Error;

/// Why a campaign does not run, or a store cannot be read.
#[derive(Debug, Error)]
pub enum CampaignError {
    /// The store holds the table of another plan.
    #[error("{} contains a campaign of another plan (sha256 {}, this plan has {})", .path.display(), short(.theirs), short(.ours))]
    OtherPlan {
        /// The store, or the file in it.
        path: PathBuf,
        /// Hash of the plan in the store.
        theirs: String,
        /// Hash of this plan.
        ours: String,
    },
    /// The store was made by another version of the program, whose numbers may differ.
    #[error("{} was written by mckibben {theirs}, and this is version {ours}", .path.display())]
    OtherVersion {
        /// The store, or the file in it.
        path: PathBuf,
        /// Version that made it.
        theirs: String,
        /// This version.
        ours: String,
    },
    /// Another process writes to the store.
    #[error("another process is writing to {}", .path.display())]
    Locked {
        /// The store.
        path: PathBuf,
    },
    /// A file that is not what was written.
    #[error("{} is damaged: {why}", .path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What shows it.
        why: String,
    },
    /// Parts are missing.
    #[error("{} is incomplete: {missing} of {parts} parts are missing, the first is {first}", .path.display())]
    Incomplete {
        /// The store.
        path: PathBuf,
        /// Number of parts that are missing.
        missing: u64,
        /// Number of all parts.
        parts: u64,
        /// Name of the first that is missing.
        first: String,
    },
    /// Two files claim to be the same part and are not.
    #[error("{} and {} are the same part of the plan and differ", .one.display(), .other.display())]
    Conflict {
        /// One of them.
        one: PathBuf,
        /// The other.
        other: PathBuf,
    },
    /// Nothing of a campaign is there.
    #[error("{} is not a campaign: {why}", .path.display())]
    NoCampaign {
        /// The file or folder.
        path: PathBuf,
        /// What is there instead.
        why: String,
    },
    /// A shard of a campaign that is to be one file.
    #[error("a shard writes parts, and {} would be one file", .path.display())]
    ShardOfFile {
        /// The file.
        path: PathBuf,
    },
    /// A name that promises another format.
    #[error("a campaign is one file that ends in .parquet, or a folder of parts; {} would be neither", .path.display())]
    OtherFormat {
        /// The name.
        path: PathBuf,
    },
    /// A file cannot be written; what was there before is untouched.
    #[error("cannot write {}: {source}", .path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A file is not read, whatever it holds.
    #[cfg(feature = "store")]
    #[error("{} {source}", .path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: mckibben_io::files::ReadError,
    },
    /// Something that is not of this campaign is where a file of it would.
    #[error("{} is not a file of a campaign ({why}) and would be overwritten", .path.display())]
    Foreign {
        /// The value in the file.
        path: PathBuf,
        /// What it is.
        why: String,
    },
    /// A file where that of the campaign would be written.
    #[error("{} exists and would be overwritten", .path.display())]
    Appeared {
        /// The file.
        path: PathBuf,
    },
    /// A table cannot be encoded.
    #[error("cannot write the table: {0}")]
    Encode(String),
    /// The caller wanted it to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// No threads to be had.
    #[error(transparent)]
    Threads(#[from] ThreadsError),
}

fn short(hash: &str) -> &str {
    hash.get(..12).unwrap_or(hash)
}

impl CampaignError {
    /// What can be done about it; may be empty.
    pub fn hint(&self) -> &'static str {
        match self {
            Self::OtherPlan { .. } => {
                "write to another place, or replace it with `overwrite`; any change of a plan's text makes another plan"
            }
            Self::OtherVersion { .. } => {
                "write to another place, continue with that version, or replace it with `overwrite`"
            }
            Self::Foreign { .. } => "write to another place, move it away, or replace it with `overwrite`",
            Self::Appeared { .. } => {
                "move it away, and the same command continues from here; `overwrite` replaces it"
            }
            #[cfg(feature = "store")]
            Self::Read { source: mckibben_io::files::ReadError::System(error), .. }
                if error.kind() != std::io::ErrorKind::NotFound =>
            {
                "the operating system refused to read it; it is not necessarily damaged"
            }
            Self::Locked { .. } => "wait for it to end, or write to another place",
            Self::Damaged { .. } => {
                "parts of a folder are recomputed when the campaign is run again; another file is replaced with `overwrite`"
            }
            Self::Incomplete { .. } => {
                "run the campaign (or the missing shards) again: it computes what is missing"
            }
            Self::Conflict { .. } => "they come from different programs or machines: recompute one of them",
            Self::ShardOfFile { .. } => {
                "give a folder, and merge the parts into a file when all shards are there"
            }
            Self::OtherFormat { .. } => {
                "name it FILE.parquet, which pandas, DuckDB and others read, and write as CSV"
            }
            Self::Write { .. } | Self::Encode(_) => {
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
        move |source| Self::Write { path, source }
    }

    /// A folder or file that the system does not read.
    pub(super) fn read(path: &Path) -> impl FnOnce(std::io::Error) -> Self {
        let unread = Self::unread(path);
        move |source| unread(source.into())
    }

    pub(super) fn unread(path: &Path) -> impl FnOnce(mckibben_io::files::ReadError) -> Self {
        let path = path.to_path_buf();
        move |source| Self::Read { path, source }
    }

    pub(super) fn damaged(path: &Path, why: impl ToString) -> Self {
        Self::Damaged { path: path.into(), why: why.to_string() }
    }
}
