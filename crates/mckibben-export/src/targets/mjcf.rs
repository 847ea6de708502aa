//! MuJoCo: the form as a plugin around the C target, an actuator of a tendon with sensors, as a part
//! of any model and in a scene.

use super::c::{SOURCES, Source, files};
use crate::{
    Artefact, ExportTarget, ExportedJoint, ExportedMuscle, File, Result,
    template::{number, render},
};
use mckibben_core::joint::{JointSpring, Path};

pub const TARGET: ExportTarget = ExportTarget {
    name: "mjcf",
    about: "MuJoCo: a plugin in C with the pressure or a valve as control and sensors of pressure, \
        pull and contraction; a part of any model, and a scene",
    needs: "MuJoCo 3.3.1 or later with its headers (the Python package has them), and a C compiler",
    loses: "of a valve its lag, and hoses; MJX and MuJoCo Warp run no plugins",
    make,
    joint,
};

const PLUGIN: [Source; 2] = [
    (
        "@{id}_plugin.c",
        "the plugin; its first lines have the commands to compile and load it",
        include_str!("../../templates/muscle_plugin.c"),
    ),
    (
        "mckibben_air.h",
        "a valve and the air, the same for all muscles",
        include_str!("../../templates/air.c"),
    ),
];

/// A place in a template, and its text.
type Place = (&'static str, String);

/// The path of a muscle about a joint, and the name of the hinge; none between two sites of any
/// model.
type Way<'a> = Option<(&'a Path, &'a str)>;

/// A tendon: over a pulley it follows the hinge.
fn tendon(name: &str, way: Way<'_>) -> String {
    match way {
        Some((Path::Pulley { radius_mm }, hinge)) => format!(
            "<fixed name=\"{name}\"> <joint joint=\"{hinge}\" coef=\"{}\"/> </fixed>",
            number(radius_mm / -1e3)
        ),
        _ => format!(
            "<spatial name=\"{name}\"> <site site=\"{name}_origin\"/> <site \
             site=\"{name}_insertion\"/> </spatial>"
        ),
    }
}

/// Tendon, actuator and sensors as a file that a model includes, and the sources of the plugin.
fn muscle_files(muscle: &ExportedMuscle, way: Way<'_>) -> Vec<File> {
    let id = muscle.identifier();
    let tendon = tendon(&id, way);
    let needs = if tendon.contains("<site") {
        format!("; it has the sites {id}_origin and {id}_insertion")
    } else {
        String::new()
    };
    let places = [
        ("needs", needs),
        ("supply", number(muscle.form.supply_pa)),
        ("tendon", tendon),
        ("id", id.clone()),
    ];
    let text = include_str!("../../templates/muscle_part.xml");
    [
        vec![File::text(
            format!("{id}_part.xml"),
            "the muscle as a part of any model",
            render(text, &muscle.facts(), &places),
        )],
        files(muscle, &PLUGIN),
        files(muscle, &SOURCES),
    ]
    .concat()
}

/// A scene in which a mass hangs from the muscle, and the muscle.
fn make(muscle: &ExportedMuscle) -> Result<Artefact> {
    let length = muscle.form.length_m;
    let blocked_n = muscle.blocked_force_n;
    let id = muscle.identifier();
    let mass_kg = 0.4 * blocked_n / 9.81;
    let stiffness = 6.0 * blocked_n / length;
    let places = [
        ("below", number(-length - muscle.cord_m)),
        ("mass", number(mass_kg)),
        ("damping", number(0.5 * 2.0 * (stiffness * mass_kg).sqrt())),
        ("half", number(0.5 * muscle.form.supply_pa)),
        ("version", muscle.version.into()),
        ("id", id.clone()),
    ];
    let text = include_str!("../../templates/muscle.xml");
    Ok(Artefact {
        files: [
            vec![File::text(
                id + ".xml",
                "a mass that hangs from the muscle",
                render(text, &muscle.facts(), &places),
            )],
            muscle_files(muscle, None),
        ]
        .concat(),
    })
}

/// The moving link: mass, inertia, damping and range.
fn link_places(joint: &ExportedJoint) -> Vec<Place> {
    let link = joint.joint.link();
    let mass = link.mass_kg + link.payload_kg;
    let moment = (link.mass_kg * link.centre_mm + link.payload_kg * link.payload_at_mm) / 1e3;
    let centre = if mass > 0.0 { moment / mass } else { 0.0 };
    let inertia = link.whole_inertia_kg_m2();
    let along = link.inclination_deg.to_radians().sin_cos();
    let at = |r: f64| format!("{:.9} {:.9} 0", r * along.1, r * along.0);
    let end_m = link.centre_mm.max(link.payload_at_mm).max(50.0) / 1e3;
    vec![
        ("range", joint.range_rad().map(number).join(" ")),
        ("damping", number(link.damping_nm_s_per_rad)),
        ("armature", number((inertia - moment * centre).max(0.0))),
        ("mass", number(mass.max(1e-6))),
        ("centre", at(centre)),
        ("end", at(end_m)),
    ]
}

/// The sites of muscles and of a spring between two points, on the fixed and on the moving link.
fn site_places(joint: &ExportedJoint, spring: &str) -> Vec<Place> {
    let paths = joint.paths();
    let names = joint.muscles.iter().map(ExportedMuscle::identifier);
    let mut sites = [String::new(), String::new()];
    for (name, path) in names.zip(&paths).chain([(spring.to_owned(), &paths[2])]) {
        let Path::Points {
            origin_mm,
            insertion_mm,
        } = path
        else {
            continue;
        };
        let ends = [("origin", origin_mm), ("insertion", insertion_mm)];
        for (sites, (word, [x, y])) in sites.iter_mut().zip(ends) {
            *sites += &format!(
                "<site name=\"{name}_{word}\" pos=\"{} {} 0\" size=\"0.005\"/>",
                number(x / 1e3),
                number(y / 1e3)
            );
        }
    }
    ["fixed_sites", "moving_sites"]
        .into_iter()
        .zip(sites)
        .filter(|place| !place.1.is_empty())
        .collect()
}

/// The spring of a joint.
fn spring_places(joint: &ExportedJoint, spring: &str) -> Vec<Place> {
    let id = joint.identifier();
    let (torsion, rope) = joint.springs();
    let bias = |k: [f64; 2]| ("bias", k.map(|v| number(-v)).join(" "));
    match joint.joint.spring() {
        None => vec![],
        Some(JointSpring::Torsion { .. }) => {
            vec![("spring", format!("joint=\"{id}\"")), bias(torsion)]
        }
        Some(JointSpring::Rope { .. }) => vec![
            ("rope", tendon(spring, Some((&joint.paths()[2], &id)))),
            // It pulls or is slack.
            (
                "spring",
                format!("tendon=\"{spring}\" forcelimited=\"true\" forcerange=\"-1e12 0\""),
            ),
            bias(rope),
        ],
    }
}

/// The joint as a hinge with its link, and its muscles.
fn joint(joint: &ExportedJoint) -> Result<Artefact> {
    let id = joint.identifier();
    let spring = format!("{id}_spring");
    let include = |m: &ExportedMuscle| format!("<include file=\"{}_part.xml\"/>", m.identifier());
    let half = |m: &ExportedMuscle| number(0.5 * m.form.supply_pa);
    let mut halves = Vec::from_iter(joint.muscles.iter().map(half));
    halves.extend(joint.joint.spring().map(|_| "0".into()));
    let mut places = vec![
        ("includes", joint.muscles.iter().map(include).collect()),
        ("half", halves.join(" ")),
        ("id", id.clone()),
    ];
    places.extend(link_places(joint));
    places.extend(site_places(joint, &spring));
    places.extend(spring_places(joint, &spring));
    let text = include_str!("../../templates/joint.xml");
    let scene = File::text(
        format!("{id}.xml"),
        "the joint with its link",
        render(text, &joint.facts(), &places),
    );
    let paths = joint.paths();
    let muscles = joint
        .muscles
        .iter()
        .zip(&paths)
        .flat_map(|(muscle, path)| muscle_files(muscle, Some((path, &id))));
    Ok(Artefact {
        files: std::iter::once(scene).chain(muscles).collect(),
    })
}
