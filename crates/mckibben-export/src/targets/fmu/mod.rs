//! FMI 2.0 and 3.0: Functional Mock-up Units around the C target, for Model Exchange and
//! Co-Simulation, with their sources.
//!
//! The library of a unit is the same for all muscles, with a pressure as input or with a valve and
//! air as states, and for joints: it reads the numbers of its muscle from `resources/muscle.bin`.
//! `checks/fmu-binaries.sh` makes it for each system, from the templates alone; a unit has all of
//! them, so that its user needs no compiler.

mod variables;

use super::{
    c::{SOURCES, Source, files},
    zip::zip,
};
use crate::{
    Artefact, ExportTarget, ExportedJoint, ExportedMuscle, File, Result, form::NODES,
    template::render,
};
use variables::{Variable, description, settings};

pub const TARGET: ExportTarget = ExportTarget {
    name: "fmu",
    about: "Functional Mock-up Units of FMI 2.0 and of FMI 3.0, with the pressure or a valve as \
        input, Model Exchange and Co-Simulation, with libraries and their sources",
    needs: "a tool that reads FMI 2.0 or 3.0, on Linux (x86-64, and with FMI 3.0 arm64), Windows \
        (x86-64) or macOS (x86-64, arm64); no compiler",
    loses: "of a valve its lag, and hoses; of a joint valves",
    make,
    joint,
};

/// A version of FMI.
#[derive(PartialEq)]
enum Version {
    Second,
    Third,
}

/// The input of a unit.
enum Kind {
    Pressure,
    /// The command of a valve.
    Valve,
    /// The pressures of so many muscles at a joint, and its angle.
    Joint(usize),
}

/// The systems: folder in FMI 2.0 and in FMI 3.0, ending of a library, and the library. FMI 2.0 has
/// one folder for both processors of macOS.
const SYSTEMS: [(&str, &str, &str, &[u8]); 5] = [
    (
        "linux64",
        "x86_64-linux",
        "so",
        include_bytes!("../../../binaries/x86_64-linux"),
    ),
    (
        "",
        "aarch64-linux",
        "so",
        include_bytes!("../../../binaries/aarch64-linux"),
    ),
    (
        "win64",
        "x86_64-windows",
        "dll",
        include_bytes!("../../../binaries/x86_64-windows"),
    ),
    ("", "x86_64-darwin", "dylib", MACOS[0]),
    ("", "aarch64-darwin", "dylib", MACOS[1]),
];
const MACOS: [&[u8]; 2] = [
    include_bytes!("../../../binaries/x86_64-darwin"),
    include_bytes!("../../../binaries/aarch64-darwin"),
];

fn make(muscle: &ExportedMuscle) -> Result<Artefact> {
    Ok(Artefact {
        files: [
            units(muscle, Kind::Pressure, None)?,
            units(muscle, Kind::Valve, None)?,
        ]
        .concat(),
    })
}

fn joint(joint: &ExportedJoint) -> Result<Artefact> {
    let kind = Kind::Joint(joint.muscles.len());
    let files = joint
        .muscles
        .first()
        .map(|muscle| units(muscle, kind, Some(joint)))
        .transpose()?;
    Ok(Artefact {
        files: files.into_iter().flatten().collect(),
    })
}

/// A file of a unit: its path, and its content.
type Entry = (String, Vec<u8>);

/// What units have beside the functions of target C; the last one those of FMI 3.0 alone.
const OF_UNIT: [Source; 3] = [
    ("air.c", "", include_str!("../../../templates/air.c")),
    ("fmu2.c", "", include_str!("../../../templates/fmu2.c")),
    ("fmu3.c", "", include_str!("../../../templates/fmu3.c")),
];

/// The unit of a kind in both versions of FMI.
fn units(muscle: &ExportedMuscle, kind: Kind, joint: Option<&ExportedJoint>) -> Result<[File; 2]> {
    let (id, facts, hash) = match joint {
        Some(joint) => (joint.identifier(), joint.facts(), &joint.hash),
        None => (muscle.identifier(), muscle.facts(), &muscle.hash),
    };
    let unit = "the unit, FMI 2.0";
    let (about, ending, what) = match kind {
        Kind::Pressure => ("", "", unit),
        Kind::Joint(_) => ("of-", "", unit),
        Kind::Valve => ("air-", "_valve", "the muscle on a valve, FMI 2.0"),
    };
    let token = format!("{{mckibben-{about}{hash}}}");
    let variables = variables::variables(muscle, kind);
    let said = format!("{} {}", facts[0], facts[2]).replace('"', "'");
    let units = include_str!("../../../templates/fmu_units.xml");
    let values = [
        ("id", id.clone()),
        ("guid", token.clone()),
        ("said", said),
        ("version", muscle.version.into()),
        ("units", units.trim_end().into()),
        ("events", variables::events(&variables).to_string()),
    ];
    let resource = resource(muscle, joint, &token, &variables);
    let sources = |of_unit: &[Source]| {
        // Without the numbers of the muscle.
        let all = [of_unit, &SOURCES[..2]].concat();
        let entry = |file: File| {
            (
                format!("sources/{}", file.name),
                file.content.bytes().to_vec(),
            )
        };
        Vec::from_iter(files(muscle, &all).into_iter().map(entry))
    };
    let unit = |version, template: &str, files: Vec<Entry>| {
        let (list, structure) = description(&variables, version);
        let own = [("variables", list), ("structure", structure)];
        let text = render(template, &facts, &[&values[..], &own].concat());
        zip([
            ("modelDescription.xml".to_owned(), text.into_bytes()),
            ("resources/muscle.bin".to_owned(), resource.clone()),
        ]
        .into_iter()
        .chain(files))
    };
    let (of_second, of_third) = libraries(&id);
    let build = include_str!("../../../templates/fmu3_build.xml");
    let build = (
        "sources/buildDescription.xml".to_owned(),
        render(build, &facts, &values).into_bytes(),
    );
    let second = unit(
        Version::Second,
        include_str!("../../../templates/fmu2.xml"),
        [of_second, sources(&OF_UNIT[..2])].concat(),
    )?;
    let third = unit(
        Version::Third,
        include_str!("../../../templates/fmu3.xml"),
        [vec![build], of_third, sources(&OF_UNIT)].concat(),
    )?;
    Ok([
        File::bytes(format!("{id}{ending}.fmu"), what, second),
        File::bytes(format!("{id}{ending}_fmi3.fmu"), "the same, FMI 3.0", third),
    ])
}

/// The libraries of all systems in FMI 2.0 and in FMI 3.0.
fn libraries(id: &str) -> (Vec<Entry>, Vec<Entry>) {
    let entry = |folder: &str, ending: &str, library: &[u8]| {
        (format!("binaries/{folder}/{id}.{ending}"), library.to_vec())
    };
    let third = SYSTEMS.map(|(_, folder, ending, library)| entry(folder, ending, library));
    let second = SYSTEMS
        .iter()
        .filter(|system| !system.0.is_empty())
        .map(|(folder, _, ending, library)| entry(folder, ending, library));
    let macos = entry("darwin64", "dylib", &universal(&MACOS));
    (second.chain([macos]).collect(), third.to_vec())
}

/// `muscle.bin`, as fmu2.c reads it.
fn resource(
    muscle: &ExportedMuscle,
    joint: Option<&ExportedJoint>,
    token: &str,
    variables: &[Variable],
) -> Vec<u8> {
    let mut out = b"mckibben".to_vec();
    out.extend(token.bytes().chain(std::iter::repeat(0)).take(32));
    let muscles = joint.map_or(std::slice::from_ref(muscle), |joint| &joint.muscles);
    let states = variables.iter().filter(|v| v.is_state()).count() as f64;
    let mut numbers = vec![
        3.0,
        states,
        if joint.is_some() {
            muscles.len() as f64
        } else {
            0.0
        },
    ];
    numbers.extend(settings(variables));
    let begun = numbers.len();
    numbers.extend(muscles.iter().flat_map(of_muscle));
    numbers.resize(begun + 2 * of_muscle(muscle).len(), 0.0);
    match joint.map(ExportedJoint::numbers) {
        Some((paths, others)) => {
            numbers.extend(paths.concat());
            numbers.extend(others.map(|pair| pair.1).concat());
        }
        // Three paths of five numbers, and four pairs.
        None => numbers.extend([0.0; 23]),
    }
    out.extend(numbers.into_iter().flat_map(f64::to_le_bytes));
    out
}

fn of_muscle(muscle: &ExportedMuscle) -> Vec<f64> {
    let form = &muscle.form;
    let mut numbers = vec![
        form.length_m,
        muscle.cord_m,
        form.supply_pa,
        form.contractions.len() as f64,
    ];
    for row in std::iter::once(&form.contractions)
        .chain(&form.a)
        .chain(&form.b)
    {
        numbers.extend(
            row.iter()
                .copied()
                .chain(std::iter::repeat(0.0))
                .take(NODES),
        );
    }
    numbers.extend(form.v);
    numbers.extend(form.friction_n);
    numbers.push(form.presliding_m);
    numbers
}

/// A file of macOS with a library for each of several processors (mach-o/fat.h): big-endian header,
/// then each at a page of 16 KiB.
fn universal(libraries: &[&[u8]]) -> Vec<u8> {
    const ALIGN: u32 = 14;
    let page = 1_usize << ALIGN;
    let mut header = Vec::from_iter(
        [0xcafe_babe_u32, libraries.len() as u32]
            .into_iter()
            .flat_map(u32::to_be_bytes),
    );
    let mut body = vec![];
    for library in libraries {
        body.resize(usize::next_multiple_of(body.len(), page), 0);
        // The processor and its kind: the second and the third word of a library, little-endian.
        header.extend(
            library[4..8]
                .iter()
                .rev()
                .chain(library[8..12].iter().rev()),
        );
        for word in [(page + body.len()) as u32, library.len() as u32, ALIGN] {
            header.extend(word.to_be_bytes());
        }
        body.extend(*library);
    }
    header.resize(page, 0);
    header.extend(body);
    header
}
