//! The door out: a file appears whole or not at all.

use std::{
    fs::{File, Metadata, OpenOptions, create_dir_all},
    io::{Error, ErrorKind, Result, Write as _},
    path::{Path, PathBuf},
    sync::{Mutex, MutexGuard, PoisonError},
};
use tempfile::NamedTempFile;

/// Puts `bytes` at `path`, whole or not at all; an existing file is overwritten only with
/// `overwrite`. A device or pipe (`/dev/stdout`) is written in place.
///
/// # Errors
/// Those of [`check_free`], and whatever the system says.
pub fn put(path: &Path, bytes: &[u8], overwrite: bool) -> Result<()> {
    check_free(path, overwrite)?;
    if std::fs::metadata(path).is_ok_and(|m| !m.is_file() && !m.is_dir()) {
        return std::fs::write(path, bytes);
    }
    Unfinished::sweep(path);
    Unfinished::beside(path)?
        .with_content(bytes)?
        .put(overwrite)
}

/// Puts files into a folder, which is made where it is missing: all of them, or none where one
/// exists and `overwrite` is not set. A link in the folder is no way out of it: it exists like a
/// file, and is overwritten itself.
///
/// # Errors
/// The path that is not written, with `AlreadyExists` or whatever the system says.
pub fn put_all<N: AsRef<Path>, B: AsRef<[u8]>>(
    folder: &Path,
    files: impl IntoIterator<Item = (N, B)>,
    overwrite: bool,
) -> std::result::Result<(), (PathBuf, Error)> {
    create_dir_all(folder).map_err(|e| (folder.into(), e))?;
    let mut whole = vec![];
    let files = files.into_iter().collect::<Vec<_>>();
    // One file of a long series is not worth a look through its folder.
    if files.len() > 1 {
        files
            .iter()
            .for_each(|(name, _)| Unfinished::sweep(&folder.join(name)));
    }
    for (name, bytes) in files {
        let path = folder.join(name);
        let inner = folder_of(&path);
        let file = match inner != folder && inner.is_symlink() {
            true => Err(exists()),
            false => create_dir_all(inner),
        };
        let file =
            file.and_then(|()| Unfinished::inside(&path, overwrite)?.with_content(bytes.as_ref()));
        whole.push(file.map_err(|e| (path, e))?);
    }
    whole.into_iter().try_for_each(|file| {
        let path = file.target.clone();
        file.put(overwrite).map_err(|e| (path, e))
    })
}

/// Whether a file may be put at `path`: nothing is there, what is no file (a device), or a file
/// that may be overwritten.
///
/// # Errors
/// `AlreadyExists` for a file without `overwrite`, `IsADirectory`, `PermissionDenied` for one that
/// is read-only, `NotFound` where the folder does not exist, and whatever the system says.
pub fn check_free(path: &Path, overwrite: bool) -> Result<()> {
    // What is no regular file is written in place, or refused when it is written.
    if !path.is_file() {
        return Ok(());
    }
    check_writable(path)?;
    if overwrite { Ok(()) } else { Err(exists()) }
}

fn exists() -> Error {
    Error::new(ErrorKind::AlreadyExists, "exists and would be overwritten")
}

/// Whether a file may be put at `path`: nothing is there, or a file that may be written.
///
/// # Errors
/// `IsADirectory`, `PermissionDenied` for a file that is read-only, `NotFound` where the folder
/// does not exist, and whatever the system says.
pub fn check_writable(path: &Path) -> Result<()> {
    Destination::new(behind_links(path)?).map(drop)
}

/// Where a file goes: behind links, with what is there.
struct Destination {
    target: PathBuf,
    old: Option<Metadata>,
}

impl Destination {
    fn new(target: PathBuf) -> Result<Self> {
        // A link inside a folder is not followed and not checked.
        let old = match std::fs::symlink_metadata(&target) {
            Ok(link) if link.is_symlink() => None,
            Ok(old) => Some(old),
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        match &old {
            Some(old) if old.is_dir() => {
                return Err(Error::new(ErrorKind::IsADirectory, "is a directory"));
            }
            // To rename over a file asks its folder for leave, and not the file.
            Some(old) if old.permissions().readonly() => {
                return Err(Error::new(
                    ErrorKind::PermissionDenied,
                    "the file is read-only",
                ));
            }
            Some(old) if old.is_file() => drop(OpenOptions::new().write(true).open(&target)?),
            _ => {}
        }
        let place = Self { target, old };
        if !place.folder().is_dir() {
            return Err(Error::new(
                ErrorKind::NotFound,
                format!("the folder {} does not exist", place.folder().display()),
            ));
        }
        Ok(place)
    }

    fn folder(&self) -> &Path {
        folder_of(&self.target)
    }
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// The file that a link points to, whether it is there or not.
fn behind_links(path: &Path) -> Result<PathBuf> {
    let mut target = path.to_path_buf();
    // As many links as Linux follows.
    for _ in 0..40 {
        match std::fs::read_link(&target) {
            Ok(next) => target = folder_of(&target).join(next),
            Err(_) => return Ok(target),
        }
    }
    Err(Error::other("too many links point to one another"))
}

/// The unfinished files of this process; of others that it put or dropped since.
static BEGUN: Mutex<Vec<PathBuf>> = Mutex::new(vec![]);

fn begun() -> MutexGuard<'static, Vec<PathBuf>> {
    BEGUN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A file that has no name yet: it lies beside its place under a temporary name and is removed
/// unless it is put there.
#[derive(Debug)]
pub struct Unfinished {
    temporary: NamedTempFile,
    target: PathBuf,
}

impl Unfinished {
    /// What names of unfinished files begin with.
    pub const PREFIX: &'static str = ".unfinished-";

    /// Begins the file at `path`; where that is a link, at the file that it points to. The mode of
    /// an older file is kept, a new one gets the usual one.
    pub fn beside(path: &Path) -> Result<Self> {
        Self::begun(Destination::new(behind_links(path)?)?)
    }

    /// Begins a file of a folder, in which no link is followed.
    ///
    /// # Errors
    /// `AlreadyExists` without `overwrite` where there is a file or a link, whatever it points to;
    /// whatever the system says.
    pub fn inside(path: &Path, overwrite: bool) -> Result<Self> {
        if !overwrite && std::fs::symlink_metadata(path).is_ok_and(|m| !m.is_dir()) {
            return Err(exists());
        }
        Self::begun(Destination::new(path.into())?)
    }

    fn begun(place: Destination) -> Result<Self> {
        let prefix = prefix(&place.target);
        let mut builder = tempfile::Builder::new();
        builder.prefix(&prefix);
        #[cfg(unix)]
        {
            // The usual permissions of a new file (the umask applies), not those of a secret.
            use std::os::unix::fs::PermissionsExt as _;
            builder.permissions(std::fs::Permissions::from_mode(0o666));
        }
        let mut all = begun();
        let temporary = builder.tempfile_in(place.folder())?;
        all.retain(|path| path.exists());
        all.push(temporary.path().to_owned());
        drop(all);
        // Held while it is written, so that `sweep` knows it from what a killed program left.
        let _ = temporary.as_file().try_lock();
        if let Some(old) = place.old {
            temporary.as_file().set_permissions(old.permissions())?;
        }
        Ok(Self {
            temporary,
            target: place.target,
        })
    }

    /// Removes all unfinished files of this process, which is about to end. None is begun while the
    /// answer is held.
    pub fn abandon() -> impl Drop {
        let all = begun();
        for path in all.iter() {
            // Nothing better can be done at the end.
            let _ = std::fs::remove_file(path);
        }
        all
    }

    /// The temporary file, which `finish` renames.
    pub fn file(&mut self) -> &mut File {
        self.temporary.as_file_mut()
    }

    /// The file with what is in it.
    pub fn with_content(mut self, bytes: &[u8]) -> Result<Self> {
        self.file().write_all(bytes)?;
        Ok(self)
    }

    /// Brings it to the disk and gives it its name. An existing file is overwritten only with
    /// `clobber`.
    ///
    /// # Errors
    /// `AlreadyExists` without `clobber` where there is such a file now; whatever the system says.
    /// What was there before is as it was.
    pub fn put(self, clobber: bool) -> Result<()> {
        let Self { temporary, target } = self;
        temporary.as_file().sync_all()?;
        if clobber {
            return temporary
                .persist(target)
                .map(drop)
                .map_err(|failure| failure.error);
        }
        match temporary.persist_noclobber(&target) {
            Ok(_) => Ok(()),
            // A file system that cannot do both at once.
            Err(failure)
                if failure.error.kind() != ErrorKind::AlreadyExists && !target.exists() =>
            {
                failure
                    .file
                    .persist(target)
                    .map(drop)
                    .map_err(|failure| failure.error)
            }
            Err(failure) => Err(failure.error),
        }
    }

    /// Removes what programs that were killed left of a file at `path`. What another program writes
    /// just now stays, as far as the file system knows locks.
    pub fn sweep(path: &Path) {
        let Ok(target) = behind_links(path) else {
            return;
        };
        let prefix = prefix(&target);
        let Ok(entries) = std::fs::read_dir(folder_of(&target)) else {
            return;
        };
        for entry in entries
            .flatten()
            .filter(|e| e.file_name().to_string_lossy().starts_with(&prefix))
        {
            // To open a pipe would wait for its other end.
            if !entry.file_type().is_ok_and(|kind| kind.is_file()) {
                continue;
            }
            let left = OpenOptions::new().write(true).open(entry.path());
            if left.is_ok_and(|file| file.try_lock().is_ok()) {
                // Nothing depends on it.
                let _ = std::fs::remove_file(entry.path());
            }
        }
    }
}

fn prefix(target: &Path) -> String {
    format!(
        "{}{}-",
        Unfinished::PREFIX,
        target.file_name().unwrap_or_default().to_string_lossy()
    )
}

/// Brings the names in a folder to the disk, where the system can.
pub fn sync(folder: &Path) {
    let folder = if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    };
    if let Ok(folder) = File::open(folder) {
        // Nothing better can be done where folders cannot be synchronised.
        let _ = folder.sync_all();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    #[cfg(unix)]
    use std::os::unix::fs::symlink;

    /// A folder, and the path of a file in it.
    fn folder() -> (tempfile::TempDir, PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        (folder, path)
    }

    /// What is in the file, which is alone in its folder.
    fn alone(path: &Path) -> Vec<u8> {
        assert_eq!(names(path.parent().unwrap()), 1);
        std::fs::read(path).unwrap()
    }

    fn names(folder: &Path) -> usize {
        std::fs::read_dir(folder).unwrap().count()
    }

    #[test]
    fn a_file_is_replaced_only_where_that_is_said_and_nothing_is_left_behind() {
        let (_folder, path) = folder();
        put(&path, b"one", false).unwrap();
        assert_eq!(
            put(&path, b"two", false).unwrap_err().kind(),
            ErrorKind::AlreadyExists
        );
        assert_eq!(alone(&path), b"one");
        put(&path, b"two", true).unwrap();
        assert_eq!(alone(&path), b"two");
    }

    #[test]
    fn what_cannot_be_written_is_refused_and_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(
            put(folder.path(), b"x", true).unwrap_err().kind(),
            ErrorKind::IsADirectory
        );
        let missing = folder.path().join("no/such/folder/a.txt");
        assert_eq!(
            put(&missing, b"x", true).unwrap_err().kind(),
            ErrorKind::NotFound
        );
        assert_eq!(names(folder.path()), 0);
    }

    /// As files of any program: the umask decides of a new file, and one that was there keeps its
    /// mode.
    #[cfg(unix)]
    #[test]
    fn a_file_can_be_read_by_others_as_the_umask_or_its_mode_allows() {
        use std::os::unix::fs::PermissionsExt as _;
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        let mode = |name: &str| std::fs::metadata(at(name)).unwrap().permissions().mode() & 0o777;
        std::fs::write(at("plain"), b"x").unwrap();
        put(&at("alone"), b"x", false).unwrap();
        put_all(folder.path(), [("one", b"x"), ("two", b"x")], false).unwrap();
        for name in ["alone", "one", "two"] {
            assert_eq!(mode(name), mode("plain"), "{name}");
        }
        for kept in [0o600, 0o640] {
            let of_old = std::fs::Permissions::from_mode(kept);
            std::fs::set_permissions(at("alone"), of_old).unwrap();
            put(&at("alone"), b"y", true).unwrap();
            assert_eq!(mode("alone"), kept);
        }
    }

    #[test]
    fn a_read_only_file_stays_as_it_is() {
        let (_folder, path) = folder();
        std::fs::write(&path, b"mine").unwrap();
        let mut mode = std::fs::metadata(&path).unwrap().permissions();
        mode.set_readonly(true);
        std::fs::set_permissions(&path, mode).unwrap();
        assert_eq!(
            put(&path, b"x", true).unwrap_err().kind(),
            ErrorKind::PermissionDenied
        );
        assert_eq!(alone(&path), b"mine");
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_a_link_and_the_file_that_it_points_to_is_written() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::create_dir(at("far")).unwrap();
        symlink("far/file", at("one")).unwrap();
        symlink("one", at("two")).unwrap();
        for content in [b"first".as_slice(), b"again"] {
            put(&at("two"), content, true).unwrap();
            assert_eq!(std::fs::read(at("far/file")).unwrap(), content);
            assert!(at("two").is_symlink() && at("one").is_symlink());
        }
        symlink("circle", at("circle")).unwrap();
        assert!(put(&at("circle"), b"x", true).is_err());
    }

    /// A folder in the folder is made; a link in its place is no way out.
    #[cfg(unix)]
    #[test]
    fn files_go_into_a_folder_inside_but_not_through_a_link() {
        let outer = tempfile::tempdir().unwrap();
        let folder = outer.path().join("folder");
        let files = || [("bodies/a", b"one".as_slice()), ("b", b"two")];
        put_all(&folder, files(), false).unwrap();
        assert_eq!(std::fs::read(folder.join("bodies/a")).unwrap(), b"one");
        std::fs::remove_dir_all(folder.join("bodies")).unwrap();
        symlink("..", folder.join("bodies")).unwrap();
        let (path, error) = put_all(&folder, files(), true).unwrap_err();
        assert_eq!(
            (path, error.kind()),
            (folder.join("bodies/a"), ErrorKind::AlreadyExists)
        );
        assert!(!outer.path().join("a").exists());
    }

    /// Row D5 of the trials: `identified.toml -> ../elsewhere`, a dangling `README.md`.
    #[cfg(unix)]
    #[test]
    fn a_link_inside_a_folder_is_refused_or_overwritten_itself() {
        let outer = tempfile::tempdir().unwrap();
        let folder = outer.path().join("folder");
        std::fs::create_dir(&folder).unwrap();
        std::fs::write(outer.path().join("elsewhere"), b"theirs").unwrap();
        symlink("../elsewhere", folder.join("file")).unwrap();
        symlink("../nowhere", folder.join("dangling")).unwrap();
        let files = |name| [("first", b"ours".as_slice()), (name, b"ours")];
        for name in ["file", "dangling"] {
            let (path, error) = put_all(&folder, files(name), false).unwrap_err();
            assert_eq!(
                (path, error.kind()),
                (folder.join(name), ErrorKind::AlreadyExists)
            );
            // All or none.
            assert_eq!(names(&folder), 2);
        }
        for name in ["file", "dangling"] {
            put_all(&folder, files(name), true).unwrap();
            assert!(
                !folder.join(name).is_symlink()
                    && std::fs::read(folder.join(name)).unwrap() == b"ours"
            );
        }
        assert_eq!(
            std::fs::read(outer.path().join("elsewhere")).unwrap(),
            b"theirs"
        );
        assert!(!outer.path().join("nowhere").exists());
    }

    #[test]
    fn without_clobbering_a_file_that_has_come_since_stays() {
        let (_folder, path) = folder();
        let unfinished = Unfinished::beside(&path).unwrap();
        std::fs::write(&path, b"theirs").unwrap();
        assert_eq!(
            unfinished.put(false).unwrap_err().kind(),
            ErrorKind::AlreadyExists
        );
        assert_eq!(alone(&path), b"theirs");
    }

    #[test]
    fn what_a_killed_program_left_is_swept_and_what_is_written_just_now_stays() {
        let (folder, path) = folder();
        let left = folder.path().join(".unfinished-a.txt-x7");
        std::fs::write(&left, b"half").unwrap();
        std::fs::write(
            folder.path().join(".unfinished-b.txt-x7"),
            b"of another file",
        )
        .unwrap();
        let alive = Unfinished::beside(&path).unwrap();
        Unfinished::sweep(&path);
        assert!(!left.exists());
        assert_eq!(names(folder.path()), 2);
        alive.put(false).unwrap();
        assert!(path.exists());
    }
}
