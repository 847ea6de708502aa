//! The door in: a regular file, no longer than a file of its kind may be.

use std::{
    fs::{File, Metadata},
    io::{Error, Read as _},
    path::Path,
};

/// Why a file is not read. None of these says that what it holds is damaged.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// A directory, a device, a pipe.
    #[error("is {what}; it must be a regular file")]
    NotAFile {
        /// A folder, a pipe, a device.
        what: &'static str,
    },
    /// Longer than a file of its kind may be.
    #[error("is longer than {limit} bytes, too long for such a file")]
    TooLarge {
        /// In bytes.
        limit: u64,
    },
    /// It is not there, may not be read, or the system fails.
    #[error("cannot be read: {0}")]
    System(#[from] Error),
}

/// Opens a regular file.
pub fn open(path: &Path) -> Result<File, ReadError> {
    // Asked before opening: to open a pipe would wait for its other end, to open a device may do
    // anything.
    regular(&std::fs::metadata(path)?)?;
    let file = File::open(path)?;
    regular(&file.metadata()?)?;
    Ok(file)
}

fn regular(kind: &Metadata) -> Result<(), ReadError> {
    match (kind.is_file(), kind.is_dir()) {
        (true, _) => Ok(()),
        (_, true) => Err(ReadError::NotAFile {
            what: "a directory",
        }),
        _ => Err(ReadError::NotAFile {
            what: "a device or a pipe",
        }),
    }
}

/// The bytes of a regular file of at most `limit` bytes.
pub fn read(path: &Path, limit: u64) -> Result<Vec<u8>, ReadError> {
    let file = open(path)?;
    let mut bytes = Vec::new();
    // Its length alone is not believed: files of the system say zero, and others grow.
    if file.metadata()?.len() <= limit {
        file.take(limit + 1).read_to_end(&mut bytes)?;
    } else {
        return Err(ReadError::TooLarge { limit });
    }
    if bytes.len() as u64 > limit {
        Err(ReadError::TooLarge { limit })
    } else {
        Ok(bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::ErrorKind;

    #[test]
    fn a_file_is_read_up_to_its_limit() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        std::fs::write(&path, [7; 10]).unwrap();
        assert_eq!(read(&path, 10).unwrap(), [7; 10]);
        assert!(matches!(
            read(&path, 9),
            Err(ReadError::TooLarge { limit: 9 })
        ));
        // Twenty gigabytes that are nowhere on the disk.
        let sparse = folder.path().join("sparse");
        File::create(&sparse).unwrap().set_len(20 << 30).unwrap();
        assert!(matches!(
            read(&sparse, 1 << 20),
            Err(ReadError::TooLarge { .. })
        ));
        let missing = read(&folder.path().join("b"), 9).unwrap_err();
        assert!(matches!(missing, ReadError::System(e) if e.kind() == ErrorKind::NotFound));
        assert!(matches!(
            read(folder.path(), 9),
            Err(ReadError::NotAFile {
                what: "a directory"
            })
        ));
    }

    #[cfg(unix)]
    #[test]
    fn devices_and_pipes_are_refused_without_waiting() {
        use std::process::Command;
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        assert!(
            Command::new("mkfifo")
                .arg(&pipe)
                .status()
                .unwrap()
                .success()
        );
        for path in [pipe.as_path(), Path::new("/dev/zero")] {
            assert!(matches!(
                read(path, 9),
                Err(ReadError::NotAFile {
                    what: "a device or a pipe"
                })
            ));
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_file_whose_length_says_zero_is_read_all_the_same() {
        assert!(
            !read(Path::new("/proc/self/stat"), 1 << 16)
                .unwrap()
                .is_empty()
        );
        assert!(matches!(
            read(Path::new("/proc/self/stat"), 4),
            Err(ReadError::TooLarge { limit: 4 })
        ));
    }
}
