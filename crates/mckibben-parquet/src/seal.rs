//! Files that know whether they are as they were written.
//!
//! Behind Parquet's four magic bytes stand 32 more that no reader of Parquet looks at: the SHA-256 of all the others. A
//! file that was cut or changed is found out before any of its numbers is believed.
//!
//! A program that writes the table again leaves the seal out, and the file is refused. That is meant: the table is then that
//! program's, and its numbers are whatever it made of them. Among the metadata a checksum could only be of the rows, which have no
//! one form as bytes (and it would be copied along with the metadata by programs that changed the rows); a second file gets lost,
//! or is left beside another table.

use crate::sink::Sink;
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::Path;

/// What every Parquet file begins and ends with.
pub(crate) const MAGIC: &[u8] = b"PAR1";
/// Length of the seal.
pub(crate) const SEAL: usize = 32;
const BEFORE: usize = MAGIC.len();

/// Writes through; of a file that is sealed it hashes what comes, and leaves out the bytes of the seal.
pub(crate) struct Output<'a> {
    inner: &'a mut dyn Sink,
    hash: Option<Sha256>,
    at: usize,
}

impl<'a> Output<'a> {
    pub(crate) fn new(inner: &'a mut dyn Sink, sealed: bool) -> Self {
        Self { inner, hash: sealed.then(Sha256::new), at: 0 }
    }

    /// Puts the seal in its place.
    pub(crate) fn finish(self) -> std::io::Result<()> {
        self.inner.flush()?;
        if let Some(hash) = self.hash {
            self.inner.seek(SeekFrom::Start(BEFORE as u64))?;
            self.inner.write_all(&hash.finalize())?;
            self.inner.flush()?;
        }
        Ok(())
    }
}

impl Write for Output<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let n = self.inner.write(bytes)?;
        if let Some(hash) = &mut self.hash {
            update(hash, self.at, &bytes[..n]);
        }
        self.at += n;
        Ok(n)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.inner.flush()
    }
}

/// Hashes `bytes`, which begin at `at`, save for the seal.
fn update(hash: &mut Sha256, at: usize, bytes: &[u8]) {
    let share = |offset: usize| offset.saturating_sub(at).min(bytes.len());
    hash.update(&bytes[..share(BEFORE)]);
    hash.update(&bytes[share(BEFORE + SEAL)..]);
}

/// Why a file is not as it was written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Broken {
    /// It does not begin as Parquet does.
    NotParquet,
    /// It does not end as Parquet does.
    Cut,
    /// Its bytes are not those that were sealed.
    Changed,
}

impl Broken {
    /// The same in words.
    pub fn words(&self) -> &'static str {
        match self {
            Self::NotParquet => "it does not begin as a Parquet file does",
            Self::Cut => "it is cut off: it does not end as a Parquet file does",
            Self::Changed => {
                "its checksum does not match its content: it was changed, or written again by another program"
            }
        }
    }
}

/// Whether a file begins and ends as Parquet does; the rest of it is not read.
pub(crate) fn check_ends(file: &mut File, length: u64) -> std::io::Result<Result<(), Broken>> {
    let (mut head, mut tail) = ([0; BEFORE], [0; BEFORE]);
    file.seek(SeekFrom::Start(0))?;
    let n = file.read(&mut head)?;
    if n > 0 && &head[..n] != MAGIC {
        return Ok(Err(Broken::NotParquet));
    }
    // Of an empty file nothing can be lost: it is one that was cut.
    if length < (2 * BEFORE + SEAL) as u64 {
        return Ok(Err(Broken::Cut));
    }
    file.seek(SeekFrom::End(-(BEFORE as i64)))?;
    file.read_exact(&mut tail)?;
    Ok(if tail == MAGIC { Ok(()) } else { Err(Broken::Cut) })
}

/// Whether a file begins and ends as one that was written to its end; what is between is not looked at.
pub fn has_ends(path: &Path) -> std::io::Result<bool> {
    let mut file = File::open(path)?;
    let length = file.metadata()?.len();
    Ok(check_ends(&mut file, length)?.is_ok())
}

/// Whether a file that ends as it should holds what was sealed.
pub(crate) fn check(file: &mut File) -> std::io::Result<Result<(), Broken>> {
    let (mut hash, mut seal, mut at) = (Sha256::new(), [0; SEAL], 0);
    let mut buffer = vec![0; 1 << 16];
    file.seek(SeekFrom::Start(BEFORE as u64))?;
    file.read_exact(&mut seal)?;
    file.seek(SeekFrom::Start(0))?;
    loop {
        match file.read(&mut buffer)? {
            0 => break,
            n => {
                update(&mut hash, at, &buffer[..n]);
                at += n;
            }
        }
    }
    Ok(if hash.finalize()[..] == seal { Ok(()) } else { Err(Broken::Changed) })
}

/// The seal of a file that was checked.
pub fn seal_of(path: &Path) -> std::io::Result<[u8; SEAL]> {
    let mut file = File::open(path)?;
    let mut seal = [0; SEAL];
    file.seek(SeekFrom::Start(BEFORE as u64))?;
    file.read_exact(&mut seal)?;
    Ok(seal)
}
