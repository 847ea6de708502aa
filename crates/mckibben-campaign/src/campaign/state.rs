//! What stands in a folder of parts beside them: of which plan it is, and how each shard is.
//!
//! None of it is data: a folder without these files is the same campaign. A shard that cannot write its state goes on.

use super::resume::belongs;
use super::store::{Folder, MARKER, Opened, Provenance, STATE};
use super::{CampaignError, Outcome, Shard};
use mckibben_files::{Unfinished, read, replace};
use serde::{Deserialize, Serialize};
use std::io::{ErrorKind, Write as _};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::Duration;

/// A running shard gives a sign of life this often.
const BEAT: Duration = Duration::from_secs(15);
/// The longest file of this kind in bytes.
const LONGEST: u64 = 1 << 16;

/// Of which plan and version a folder is: the first process writes it, every other one must agree.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Marker {
    pub(super) version: String,
    pub(super) plan_sha256: String,
    pub(super) muscles: u64,
    pub(super) parts: u64,
}

impl Marker {
    pub(super) fn of(provenance: &Provenance) -> Self {
        Self {
            version: provenance.version.clone(),
            plan_sha256: provenance.plan_sha256.clone(),
            muscles: provenance.muscles,
            parts: provenance.parts(),
        }
    }

    pub(super) fn read(folder: &Path) -> Option<Self> {
        serde_json::from_slice(&read(&folder.join(MARKER), LONGEST).ok()?).ok()
    }

    /// Claims a folder for a plan; one of another plan or version is refused.
    pub(super) fn claim(
        folder: &Path,
        provenance: &Provenance,
        overwrite: bool,
    ) -> Result<(), CampaignError> {
        let path = folder.join(MARKER);
        let ours = Self::of(provenance);
        // Written by another process between the look and the write, it is looked at again.
        for _ in 0..2 {
            match Self::read(folder) {
                Some(theirs) if theirs == ours => return Ok(()),
                Some(theirs) if !overwrite => {
                    let Self { version, plan_sha256, .. } = theirs;
                    let theirs = Provenance { version, plan_sha256, ..provenance.clone() };
                    return belongs(&theirs, provenance, folder);
                }
                there => {
                    // A folder of an earlier version has parts alone.
                    if let (None, false, Some(part)) =
                        (&there, overwrite, Folder::parts(folder)?.into_values().next())
                        && let Ok(opened) = Opened::file(&part)
                    {
                        belongs(&opened.provenance, provenance, &part)?;
                    }
                    let text =
                        serde_json::to_string(&ours).map_err(|e| CampaignError::Encode(e.to_string()))?;
                    let put = || {
                        let mut file = Unfinished::beside(&path)?;
                        file.file().write_all(text.as_bytes())?;
                        file.put(there.is_some() || path.exists())
                    };
                    match put() {
                        Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                        put => return put.map_err(CampaignError::write(&path)),
                    }
                }
            }
        }
        Ok(())
    }
}

/// How a process ended, or that it did not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Phase {
    /// It works, or it was killed.
    Running,
    /// Its share is there.
    Done,
    /// It was asked to end.
    Stopped,
    /// It ended with an error.
    Failed,
}

/// What a shard says of itself.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct State {
    pub(super) phase: Phase,
    pub(super) host: String,
    pub(super) process: u32,
    pub(super) cause: String,
}

impl State {
    fn write(&self, path: &Path) {
        // A state that cannot be written is no reason to lose what is computed.
        let _ = serde_json::to_vec(self).map(|text| replace(path, &text));
    }

    pub(super) fn all(folder: &Path) -> Vec<(Shard, PathBuf)> {
        let names = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.file_name());
        let shard = |name: &str| Shard::of_file_name(name.strip_prefix(STATE)?.strip_suffix(".json")?);
        names.filter_map(|name| Some((shard(&name.to_string_lossy())?, folder.join(name)))).collect()
    }

    /// That of a shard.
    pub(super) fn read(path: &Path) -> Option<Self> {
        serde_json::from_slice(&read(path, LONGEST).ok()?).ok()
    }
}

/// The name of this machine.
pub(super) fn host() -> String {
    let named = std::fs::read_to_string("/proc/sys/kernel/hostname").map(|name| name.trim().to_owned());
    named
        .or_else(|_| std::env::var("HOSTNAME"))
        .or_else(|_| std::env::var("COMPUTERNAME"))
        .unwrap_or_default()
}

/// Signs of life of a shard while it works.
pub(super) struct Alive {
    path: PathBuf,
    state: State,
    beats: Option<(Sender<()>, JoinHandle<()>)>,
}

impl Alive {
    pub(super) fn begin(folder: &Folder, shard: Shard) -> Self {
        let path = folder.path.join(format!("{STATE}{}.json", shard.file_name()));
        let state =
            State { phase: Phase::Running, host: host(), process: std::process::id(), cause: String::new() };
        state.write(&path);
        let (sender, receiver) = channel::<()>();
        let (place, beat) = (path.clone(), state.clone());
        let work = move || {
            while receiver.recv_timeout(BEAT) == Err(RecvTimeoutError::Timeout) {
                beat.write(&place);
            }
        };
        // Where there is no thread for it, the lock alone shows that it works.
        let thread = std::thread::Builder::new().spawn(work).ok();
        Self { path, state, beats: thread.map(|thread| (sender, thread)) }
    }

    pub(super) fn end(mut self, done: &Result<Outcome, CampaignError>) {
        if let Some((sender, thread)) = self.beats.take() {
            drop(sender);
            let _ = thread.join();
        }
        let (phase, cause) = match done {
            Ok(outcome) if outcome.complete => (Phase::Done, String::new()),
            Ok(_) => (Phase::Stopped, String::new()),
            Err(error) => (Phase::Failed, error.to_string()),
        };
        State { phase, cause, ..self.state }.write(&self.path);
    }
}
