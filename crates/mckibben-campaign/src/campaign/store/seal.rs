//! Files that know whether they are as they were written.
//!
//! Behind Parquet's four magic bytes stand 32 more that no reader of Parquet looks at: the SHA-256 of all the others. A
//! file that was cut or changed is found out before anything in it is believed.

use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::Path;

/// What every Parquet file begins and ends with.
pub(super) const MAGIC: &[u8] = b"PAR1";
/// Length of the seal.
pub(super) const SEAL: usize = 32;
const BEFORE: usize = MAGIC.len();

/// Writes through and hashes; the bytes of the seal are left out.
#[derive(Debug)]
pub(super) struct Sealing<W> {
    inner: W,
    hash: Sha256,
    at: usize,
}

impl<W: Write> Sealing<W> {
    pub(super) fn new(inner: W) -> Self {
        Self { inner, hash: Sha256::new(), at: 0 }
    }
}

impl<W: Write + Seek> Sealing<W> {
    /// Puts the seal in its place.
    pub(super) fn seal(mut self) -> std::io::Result<W> {
        self.inner.flush()?;
        self.inner.seek(SeekFrom::Start(BEFORE as u64))?;
        self.inner.write_all(&self.hash.finalize())?;
        self.inner.flush()?;
        Ok(self.inner)
    }
}

impl<W: Write> Write for Sealing<W> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let n = self.inner.write(bytes)?;
        update(&mut self.hash, self.at, &bytes[..n]);
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
pub(super) enum Broken {
    /// It does not begin as Parquet does.
    NotParquet,
    /// It does not end as Parquet does.
    Cut,
    /// Its bytes are not those that were sealed.
    Changed,
}

impl Broken {
    pub(super) fn words(&self) -> &'static str {
        match self {
            Self::NotParquet => "it does not begin as a Parquet file does",
            Self::Cut => "it is cut off: it does not end as a Parquet file does",
            Self::Changed => "its checksum does not match what it holds",
        }
    }
}

/// Whether a file is as it was written.
pub(super) fn check(file: &mut File) -> std::io::Result<Result<(), Broken>> {
    let mut hash = Sha256::new();
    let mut seal = [0; SEAL];
    let mut buffer = vec![0; 1 << 16];
    let (mut at, mut head, mut tail) = (0_usize, [0_u8; BEFORE], [0_u8; BEFORE]);
    file.seek(SeekFrom::Start(0))?;
    loop {
        // Whole buffers, so that head and seal come together.
        let mut n = 0;
        while n < buffer.len() {
            match file.read(&mut buffer[n..])? {
                0 => break,
                more => n += more,
            }
        }
        if n == 0 {
            break;
        }
        if at == 0 {
            let m = n.min(BEFORE);
            head[..m].copy_from_slice(&buffer[..m]);
            if n >= BEFORE + SEAL {
                seal.copy_from_slice(&buffer[BEFORE..BEFORE + SEAL]);
            }
        }
        for &b in &buffer[n.saturating_sub(BEFORE)..n] {
            tail.rotate_left(1);
            tail[BEFORE - 1] = b;
        }
        update(&mut hash, at, &buffer[..n]);
        at += n;
    }
    Ok(if head != MAGIC {
        Err(Broken::NotParquet)
    } else if at < 2 * BEFORE + SEAL || tail != MAGIC {
        Err(Broken::Cut)
    } else if hash.finalize()[..] != seal {
        Err(Broken::Changed)
    } else {
        Ok(())
    })
}

/// The seal of a file that was checked.
pub(crate) fn seal_of(path: &Path) -> std::io::Result<[u8; SEAL]> {
    let mut file = File::open(path)?;
    let mut seal = [0; SEAL];
    file.seek(SeekFrom::Start(BEFORE as u64))?;
    file.read_exact(&mut seal)?;
    Ok(seal)
}
