//! A folder of parts: `part-000012.parquet` holds block 12 of the plan.
//!
//! A part appears whole or not at all: written under a temporary name, brought to the disk,
//! renamed.

use super::shard::Shard;
use crate::campaign::error::{CampaignError, Result};
use mckibben_io::files::{Unfinished, check_writable, put_all, sync};
use std::{
    collections::BTreeMap,
    fs::{DirEntry, File, OpenOptions, TryLockError},
    io::{Error, ErrorKind, Write},
    path::{Path, PathBuf},
    time::{Duration, SystemTime},
};

const LOCK: &str = ".lock";
/// The file that names the plan.
pub const MANIFEST: &str = ".campaign.json";

/// The file name of a part.
pub fn part_name(number: u64) -> String {
    format!("part-{number:06}.parquet")
}

fn part_number(name: &str) -> Option<u64> {
    name.strip_prefix("part-")?
        .strip_suffix(".parquet")?
        .parse()
        .ok()
}

/// Whether a path names one file (`campaign.parquet`), not a folder of parts.
pub fn is_file_name(path: &Path) -> bool {
    path.extension()
        .is_some_and(|e| e.eq_ignore_ascii_case("parquet"))
        && !path.is_dir()
}

/// Endings of tables of other formats.
const OTHER_FORMATS: [&str; 12] = [
    "csv", "tsv", "txt", "md", "json", "xls", "xlsx", "ods", "arrow", "feather", "h5", "mat",
];

/// Refuses a name that promises another format than is written.
pub fn check_name(path: &Path) -> Result<()> {
    let ending = path
        .extension()
        .map(|e| e.to_string_lossy().to_ascii_lowercase());
    if ending.is_some_and(|e| OTHER_FORMATS.contains(&e.as_str())) && !path.is_dir() {
        return Err(CampaignError::other_format(path));
    }
    Ok(())
}

fn lock_name(shard: Shard) -> String {
    format!("{LOCK}-{shard}").replace('/', "-of-")
}

fn names(folder: &Path) -> Result<Vec<String>> {
    let name =
        |entry: std::io::Result<DirEntry>| Ok(entry?.file_name().to_string_lossy().into_owned());
    std::fs::read_dir(folder)
        .and_then(|entries| entries.map(name).collect())
        .map_err(CampaignError::read(folder))
}

/// A folder of parts.
pub struct Folder {
    pub path: PathBuf,
    /// Held while the store is written.
    locks: Vec<File>,
}

impl Folder {
    /// Opens or makes a folder for writing; no other process may write to it, save other shards.
    pub fn for_writing(path: &Path, shard: Option<Shard>) -> Result<Self> {
        if !path.exists() {
            check_writable(path).map_err(CampaignError::write(path))?;
        }
        std::fs::create_dir_all(path).map_err(CampaignError::write(path))?;
        let mut folder = Self {
            path: path.into(),
            locks: vec![],
        };
        folder.lock(LOCK, shard.is_some())?;
        if let Some(shard) = shard {
            folder.lock(&lock_name(shard), false)?;
        }
        folder.sweep(shard)?;
        Ok(folder)
    }

    fn lock(&mut self, name: &str, shared: bool) -> Result<()> {
        let path = self.path.join(name);
        if path.is_symlink() {
            return Err(CampaignError::write(&path)(Error::other(
                "is a link, and the lock of a folder lies in it",
            )));
        }
        let file = OpenOptions::new()
            .create(true)
            .truncate(false)
            .read(true)
            .write(true)
            .open(&path)
            .map_err(CampaignError::write(&path))?;
        let lock = || {
            if shared {
                file.try_lock_shared()
            } else {
                file.try_lock()
            }
        };
        let mut locked = lock();
        // Whoever looks whether a shard is alive holds its lock for a moment.
        for _ in 0..5 {
            if matches!(locked, Err(TryLockError::WouldBlock)) {
                std::thread::sleep(Duration::from_millis(20));
                locked = lock();
            }
        }
        match locked {
            Ok(()) => {
                // Tells which shard began last.
                let _ = file.set_modified(SystemTime::now());
                // No file is left empty: it says what it is for.
                if file.metadata().is_ok_and(|m| m.len() == 0) {
                    let _ = (&file).write_all(b"locked while a process writes parts here\n");
                }
                self.locks.push(file);
                Ok(())
            }
            Err(TryLockError::WouldBlock) => Err(CampaignError::Locked(self.path.clone())),
            // A file system without locks: parts are still renamed whole, and equal whoever writes
            // them.
            Err(TryLockError::Error(e)) if e.kind() == ErrorKind::Unsupported => Ok(()),
            Err(TryLockError::Error(e)) => Err(CampaignError::write(&path)(e)),
        }
    }

    /// Whether a process holds the lock of a shard, or that of the whole plan.
    pub fn is_locked(path: &Path, shard: Shard) -> bool {
        let held = |name: &str| {
            let file = File::open(path.join(name));
            file.is_ok_and(|file| matches!(file.try_lock_shared(), Err(TryLockError::WouldBlock)))
        };
        held(LOCK) || held(&lock_name(shard))
    }

    /// Of how many shards that is which began last.
    pub fn shards(path: &Path) -> Result<u64> {
        let begun = |name: String| {
            let shard = name
                .strip_prefix(LOCK)?
                .strip_prefix('-')?
                .replace("-of-", "/");
            Some((
                path.join(name).metadata().ok()?.modified().ok()?,
                shard.parse::<Shard>().ok()?.count(),
            ))
        };
        Ok(names(path)?
            .into_iter()
            .filter_map(begun)
            .max()
            .map_or(1, |newest| newest.1))
    }

    /// Removes the unfinished files of killed processes: of the parts of a shard, whose lock is
    /// held; without one all, since nobody else is writing.
    fn sweep(&self, shard: Option<Shard>) -> Result<()> {
        let part = |rest: &str| part_number(&rest[..rest.find(".parquet")? + ".parquet".len()]);
        for name in names(&self.path)? {
            let Some(rest) = name.strip_prefix(Unfinished::PREFIX) else {
                continue;
            };
            if shard.is_none_or(|shard| part(rest).is_some_and(|part| shard.holds(part))) {
                self.discard(&self.path.join(&name))?;
            }
        }
        Ok(())
    }

    /// The parts that are there.
    pub fn parts(path: &Path) -> Result<BTreeMap<u64, PathBuf>> {
        Ok(names(path)?
            .into_iter()
            .filter_map(|n| Some((part_number(&n)?, path.join(n))))
            .collect())
    }

    /// Writes a part so that it survives whatever follows.
    pub fn write(&self, number: u64, bytes: Vec<u8>) -> Result<()> {
        put_all(&self.path, [(part_name(number), bytes)], true)
            .map_err(|(path, error)| CampaignError::Write(path, error))?;
        sync(&self.path);
        Ok(())
    }

    /// Removes all parts, and whose they are.
    pub fn clear(&self) -> Result<()> {
        for part in Self::parts(&self.path)?.values() {
            self.discard(part)?;
        }
        self.discard(&self.path.join(MANIFEST))
    }

    /// Removes parts, and the folder if nothing else is in it: they are in one file now.
    pub fn remove(mut self, parts: impl Iterator<Item = u64>) -> Result<()> {
        for part in parts {
            self.discard(&self.path.join(part_name(part)))?;
        }
        let names = names(&self.path)?;
        // Some systems do not remove what is open.
        self.locks.clear();
        let is_ours = |name: &&String| {
            [LOCK, Unfinished::PREFIX, MANIFEST]
                .iter()
                .any(|prefix| name.starts_with(prefix))
        };
        for name in names.iter().filter(is_ours) {
            self.discard(&self.path.join(name))?;
        }
        // Something foreign in it keeps it.
        let _ = std::fs::remove_dir(&self.path);
        Ok(())
    }

    /// Removes a file, where it is there.
    pub fn discard(&self, file: &Path) -> Result<()> {
        match std::fs::remove_file(file) {
            Err(error) if error.kind() != ErrorKind::NotFound => {
                Err(CampaignError::write(file)(error))
            }
            _ => Ok(()),
        }
    }
}
