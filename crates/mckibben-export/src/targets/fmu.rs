//! FMI 2.0: a Functional Mock-up Unit around the C target, for Model Exchange and Co-Simulation, with its sources.

use super::TargetEntry;
use super::c::{rendered, sources};
use super::zip::zip;
use crate::error::ExportError;
use crate::muscle::ExportedMuscle;
use crate::template::{number, render};
use crate::{Artefact, File};

pub(super) const ENTRY: TargetEntry = TargetEntry {
    name: "fmu",
    about: "a Functional Mock-up Unit of FMI 2.0, Model Exchange and Co-Simulation, with its sources",
    needs: "a tool that reads FMI 2.0; a C compiler (cc) where this program runs, or a tool that compiles sources",
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
    let description = render(include_str!("../../templates/fmu2.xml"), &facts, &values);
    let source = rendered(include_str!("../../templates/fmu2.c"), muscle).replace("@{guid}", &guid.1);
    let mut files = vec![("sources/fmu2.c".to_owned(), source.into_bytes())];
    for file in sources(muscle) {
        files.push((format!("sources/{}", file.name), file.content.bytes().to_vec()));
    }
    let mut notes = vec![];
    match binary::compiled(&files) {
        Some(bytes) => files.push((format!("binaries/{}/{id}.{}", binary::PLATFORM, binary::ENDING), bytes)),
        None => notes.push("no C compiler (cc) was found: the FMU has sources alone, which the tool that reads it must compile".into()),
    }
    let mut all: Vec<(&str, &[u8])> = vec![("modelDescription.xml", description.as_bytes())];
    all.extend(files.iter().map(|(name, bytes)| (name.as_str(), bytes.as_slice())));
    Ok(Artefact { files: vec![File::bytes("muscle.fmu", "the unit", zip(&all))], notes })
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
                    .args(["fmu2.c", "-o", "muscle.so", "-lm"])
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
        pub const ENDING: &str = "none";

        pub fn compiled(_files: &[(String, Vec<u8>)]) -> Option<Vec<u8>> {
            None
        }
    }
}
