//! FMI 2.0 and 3.0: Functional Mock-up Units around the C target, for Model Exchange and Co-Simulation, with their sources.

use super::TargetEntry;
use super::c::{rendered, sources};
use super::zip::zip;
use crate::error::ExportError;
use crate::muscle::ExportedMuscle;
use crate::template::{number, render};
use crate::{Artefact, File};

pub(super) const ENTRY: TargetEntry = TargetEntry {
    name: "fmu",
    about: "Functional Mock-up Units of FMI 2.0 and of FMI 3.0, Model Exchange and Co-Simulation, with their sources",
    needs: "a tool that reads FMI 2.0 or 3.0; a C compiler (cc) where this program runs, or a tool that compiles sources",
    loses: "friction; the binary in it is for this system and processor alone",
    make,
};

fn make(muscle: &ExportedMuscle) -> Result<Artefact, ExportError> {
    let (id, facts) = (muscle.identifier(), muscle.facts());
    let guid = ("guid", format!("{{mckibben-{}}}", muscle.hash));
    let values = [
        ("id", id.clone()),
        guid.clone(),
        ("said", format!("{} {}", facts[0], facts[2]).replace('"', "'")),
        ("version", muscle.version.into()),
        ("length", number(muscle.form.length_m)),
    ];
    let described = |template: &str| render(template, &facts, &values).into_bytes();
    let source = |template: &str| rendered(template, muscle).replace("@{guid}", &guid.1).into_bytes();
    let mut files = vec![
        ("sources/fmu2.c".to_owned(), source(include_str!("../../templates/fmu2.c"))),
        ("sources/fmu3.c".to_owned(), source(include_str!("../../templates/fmu3.c"))),
    ];
    for file in sources(muscle) {
        files.push((format!("sources/{}", file.name), file.content.bytes().to_vec()));
    }
    // One library has the functions of both.
    let library = binary::compiled(&files);
    let mut notes = vec![];
    if library.is_none() {
        notes.push("no C compiler (cc) was found: the FMU has sources alone, which the tool that reads it must compile".into());
    }
    let unit = |platform: &str, mut own: Vec<(String, Vec<u8>)>| {
        own.extend(files.iter().cloned());
        own.extend(
            library
                .iter()
                .map(|bytes| (format!("binaries/{platform}/{id}.{}", binary::ENDING), bytes.clone())),
        );
        let all: Vec<(&str, &[u8])> =
            own.iter().map(|(name, bytes)| (name.as_str(), bytes.as_slice())).collect();
        zip(&all)
    };
    let description = "modelDescription.xml".to_owned();
    let second = vec![(description.clone(), described(include_str!("../../templates/fmu2.xml")))];
    let third = vec![
        (description, described(include_str!("../../templates/fmu3.xml"))),
        (
            "sources/buildDescription.xml".to_owned(),
            described(include_str!("../../templates/fmu3_build.xml")),
        ),
    ];
    let files = vec![
        File::bytes("muscle.fmu", "the unit, FMI 2.0", unit(binary::PLATFORM, second)),
        File::bytes("muscle_fmi3.fmu", "the same, FMI 3.0", unit(binary::PLATFORM_3, third)),
    ];
    Ok(Artefact { files, notes })
}

/// The library of this system.
mod binary {
    #[cfg(all(target_os = "linux", target_arch = "x86_64"))]
    pub use linux::*;
    #[cfg(not(all(target_os = "linux", target_arch = "x86_64")))]
    pub use other::*;

    #[cfg(all(target_os = "linux", target_arch = "x86_64"))]
    mod linux {
        use std::process::{Command, Stdio};

        pub const PLATFORM: &str = "linux64";
        pub const PLATFORM_3: &str = "x86_64-linux";
        pub const ENDING: &str = "so";

        /// What `cc` makes of the sources, in a folder that is removed again.
        pub fn compiled(files: &[(String, Vec<u8>)]) -> Option<Vec<u8>> {
            use std::sync::atomic::{AtomicU32, Ordering};
            static NEXT: AtomicU32 = AtomicU32::new(0);
            let (process, next) = (std::process::id(), NEXT.fetch_add(1, Ordering::Relaxed));
            let folder = std::env::temp_dir().join(format!("mckibben-fmu-{process}-{next}"));
            // A folder that exists already is not ours.
            std::fs::create_dir(&folder).ok()?;
            let made = || {
                for (name, bytes) in files {
                    std::fs::write(folder.join(name.strip_prefix("sources/")?), bytes).ok()?;
                }
                let flags =
                    ["-std=c99", "-O2", "-ffp-contract=off", "-fPIC", "-shared", "-s", "-fvisibility=hidden"];
                let done = Command::new("cc")
                    .args(flags)
                    .args(["fmu3.c", "-o", "muscle.so", "-lm"])
                    .current_dir(&folder)
                    .stdin(Stdio::null())
                    .stdout(Stdio::null())
                    .stderr(Stdio::null())
                    .status();
                done.ok().filter(|status| status.success())?;
                std::fs::read(folder.join("muscle.so")).ok()
            };
            let bytes = made();
            // What remains in the folder for temporary files does no harm.
            let _ = std::fs::remove_dir_all(&folder);
            bytes
        }
    }

    #[cfg(not(all(target_os = "linux", target_arch = "x86_64")))]
    mod other {
        pub const PLATFORM: &str = "none";
        pub const PLATFORM_3: &str = "none";
        pub const ENDING: &str = "none";

        pub fn compiled(_files: &[(String, Vec<u8>)]) -> Option<Vec<u8>> {
            None
        }
    }
}
