//! MuJoCo: a muscle of native actuators in MJCF, and the form itself as a plugin around the C
//! target, each with a scene that includes it.
//!
//! MuJoCo has no actuator F(P, L). Two of its actuators on one tendon make one, with x = L/L0 and
//! the pressure P as the control of both:
//!
//! ```text
//! muscle: − (k2 P + m2) x²        gaintype and biastype "muscle" on their first quarters, which are parabolas
//! affine: − (k0 + k1 x) P − (m0 + m1 x)
//! ```
//!
//! The gain of a muscle is −force · 2 L² for 0 ≤ L ≤ 1/2 with `lmin` 0, and L = length/span with
//! `range` 0 1 and `lengthrange` 0 span; where k2 is negative it is −force (1 − (L − 1)²/2) for 1 ≤
//! L ≤ 2 with `lmax` 3, whose constant the affine actuator takes back. Its bias is −force · fpmax
//! (L − 1)²/2 for 1 ≤ L ≤ 2 with `lmax` 3, and L − 1 = length/span with `range` 1 2. (MuJoCo,
//! "Computation", section "Muscle actuators"; engine_util_misc.c.) A limit of the force of all
//! actuators at the tendon makes it slack.

use super::{
    c::{SOURCES, Source, files, rendered},
    fit,
};
use crate::{
    Artefact, ExportError, ExportTarget, ExportedJoint, ExportedMuscle, File, HostError, Result,
    muscle::LIMIT,
    template::{number, render},
};
use mckibben_core::joint::{JointSpring, Path};

pub const TARGET: ExportTarget = ExportTarget {
    name: "mjcf",
    about: "MuJoCo: native actuators on a tendon, without plugin or callback; beside them the form \
        itself as a plugin in C; each as a part of any model, and a scene",
    needs: "MuJoCo 3.3.1 or later; for the plugin its headers (the Python package has them) and a \
        C compiler",
    loses: "without the plugin friction and the form: pull is linear in the pressure and of second \
        degree in the length, from the length at rest to the free contraction; no volume",
    make,
    joint,
};

/// Lengths up to this share of that at rest lie on the parabola of the gain.
const REACH: f64 = 1.25;
/// Largest share of the pull beyond the blocked force at the supply.
const STRONGEST: f64 = 3.0;

/// k0, k1, k2, m0, m1, m2 over the blocked force, and their error; the tendon's limit makes the
/// muscle slack. MuJoCo has no m2 below zero: without it then.
fn fitted(muscle: &ExportedMuscle) -> Option<([f64; 6], HostError)> {
    let all = fit(muscle, |q, x| [q, q * x, q * x * x, 1.0, x, x * x])?;
    if all.0[5] > 0.0 {
        return Some(all);
    }
    let ([k0, k1, k2, m0, m1], error) = fit(muscle, |q, x| [q, q * x, q * x * x, 1.0, x])?;
    Some(([k0, k1, k2, m0, m1, f64::MIN_POSITIVE], error))
}

/// Of dF/dL where both pull, over the blocked force over the stroke at the supply.
fn stiffness_error(muscle: &ExportedMuscle, k: &[f64; 6]) -> HostError {
    let form = &muscle.form;
    let blocked_n = muscle.blocked_force_n;
    let errors: Vec<f64> = muscle
        .held_out
        .iter()
        .filter(|p| p.contraction >= 0.0 && p.pull.is_some_and(|pull| pull > 0.0))
        .filter_map(|p| {
            let (pull, slope) = pull(muscle, k, p.q, 1.0 - p.contraction);
            let stiffness = form
                .point_at(p.q * form.supply_pa, p.contraction)
                .stiffness_n_per_m;
            let of_blocked = form.length_m * form.contraction_high / blocked_n;
            (pull > 0.0).then_some((slope - stiffness) * of_blocked)
        })
        .collect();
    HostError::from_errors(&errors)
}

/// The pull in N of native actuators with these constants at q and L/L0, and its slope in the length
/// in N/m.
fn pull(muscle: &ExportedMuscle, k: &[f64; 6], q: f64, x: f64) -> (f64, f64) {
    let pull = (k[0] + (k[1] + k[2] * x) * x) * q + k[3] + (k[4] + k[5] * x) * x;
    let slope = (k[1] + 2.0 * k[2] * x) * q + k[4] + 2.0 * k[5] * x;
    let n = if pull > 0.0 {
        muscle.blocked_force_n
    } else {
        0.0
    };
    (n * pull, n * slope / muscle.form.length_m)
}

/// The muscle of native actuators as a part of any model, what is to be known of it, and its
/// constants.
fn native(muscle: &ExportedMuscle, way: Way<'_>) -> Result<(File, Vec<String>, [f64; 6])> {
    let f = &muscle.form;
    let blocked_n = muscle.blocked_force_n;
    let refused = || {
        ExportError::Host(
            "the pull of this muscle is not of the form that MuJoCo's actuators \
            have; the targets c and python have all of it"
                .into(),
        )
    };
    let (k, error) = fitted(muscle)
        .filter(|(_, error)| error.worst <= LIMIT)
        .ok_or_else(refused)?;
    let length = f.length_m;
    let per_pa = blocked_n / f.supply_pa;
    let span = 2.0 * REACH * length;
    let cord = muscle.cord_m / length;
    let per_square = (span / length).powi(2);
    // A parabola that opens upwards lies on the first quarter, one that opens downwards on the
    // third, which begins at 1.
    let (gain_range, gain_ends, gain_square, offset) = if k[2] >= 0.0 {
        (
            "0 1",
            "0 1.6",
            (0.5 * k[2] * per_pa * per_square).max(f64::MIN_POSITIVE),
            0.0,
        )
    } else {
        let square = -2.0 * k[2] * per_pa * per_square;
        ("1 2", "0.5 3", square, square)
    };
    let reach = format!(
        "Pull of the actuators against the model, from the length at rest to the free contraction: \
         {error}, of the blocked force."
    );
    let slope = stiffness_error(muscle, &k);
    let slope = format!(
        "Stiffness of the actuators against the form, there: {:.1} % rms, {:.1} % worst, of the \
         mean stiffness at the supply of {:.0} N/m.",
        100.0 * slope.rms,
        100.0 * slope.worst,
        blocked_n / (f.contraction_high * f.length_m)
    );
    let notes = vec![reach, slope];
    let values = [
        ("id", muscle.identifier()),
        ("cord", number(muscle.cord_m)),
        ("end", number(muscle.cord_m + span)),
        ("gain_square", number(gain_square)),
        ("gain_range", gain_range.into()),
        ("gain_ends", gain_ends.into()),
        // MuJoCo requires more than zero.
        (
            "bias_square",
            number((2.0 * k[5] * blocked_n * per_square).max(f64::MIN_POSITIVE)),
        ),
        (
            "gain_0",
            number(offset - k[0] * per_pa + k[1] * per_pa * cord),
        ),
        ("gain_1", number(-k[1] * per_pa / length)),
        ("bias_0", number((k[4] * cord - k[3]) * blocked_n)),
        ("bias_1", number(-k[4] * blocked_n / length)),
    ];
    let actuators = include_str!("../../templates/muscle_native.xml");
    let places = [("limit", number(-STRONGEST * blocked_n))];
    let facts = [muscle.facts(), notes.clone()].concat();
    Ok((
        part(
            muscle,
            &facts,
            way,
            [NATIVE, &render(actuators, &[], &values)],
            &places,
        ),
        notes,
        k,
    ))
}

const PLUGINS: [Source; 2] = [
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

/// The form itself with one control for a muscle, as a part of any model.
fn plugin(muscle: &ExportedMuscle, way: Way<'_>) -> Vec<File> {
    let actuator = rendered(include_str!("../../templates/muscle_plugin.xml"), muscle);
    let places = [("extension", String::new())];
    let part = part(muscle, &muscle.facts(), way, [PLUGIN, &actuator], &places);
    let sources = files(muscle, &[&PLUGINS[..], &SOURCES].concat());
    [vec![part], sources].concat()
}

/// What the names of parts and scenes have behind that of the muscle.
const NATIVE: &str = "";
const PLUGIN: &str = "_plugin";

/// A place in a template, and its text.
type Place = (&'static str, String);

/// The path of a muscle about a joint, and the name of the hinge; none between two sites of any
/// model.
type Way<'a> = Option<(&'a Path, &'a str)>;

/// A tendon: over a pulley it follows the hinge.
fn tendon(name: &str, class: &str, way: Way<'_>) -> String {
    match way {
        Some((Path::Pulley { radius_mm }, hinge)) => format!(
            "<fixed name=\"{name}\"{class}> <joint joint=\"{hinge}\" coef=\"{}\"/> </fixed>",
            number(-1e-3 * radius_mm)
        ),
        _ => format!(
            "<spatial name=\"{name}\"{class}> <site site=\"{name}_origin\"/> <site \
             site=\"{name}_insertion\"/> </spatial>"
        ),
    }
}

/// Tendon and actuators as a file that a model includes.
fn part(
    muscle: &ExportedMuscle,
    facts: &[String],
    way: Way<'_>,
    [kind, actuators]: [&str; 2],
    places: &[Place],
) -> File {
    let id = muscle.identifier();
    let file = format!("{id}{kind}_part.xml");
    let (class, about) = match kind {
        NATIVE => (
            format!(" class=\"{id}\""),
            "the muscle as a part of any model",
        ),
        _ => (String::new(), "the same by the plugin"),
    };
    let held = tendon(&id, &class, way);
    let needs = if held.contains("<site") {
        format!("; it has the sites {id}_origin and {id}_insertion")
    } else {
        String::new()
    };
    let common = [
        ("file", file.clone()),
        ("needs", needs),
        ("supply", number(muscle.form.supply_pa)),
        ("tendon", held),
        ("actuators", actuators.trim_end().to_owned()),
        ("id", id),
    ];
    let text = render(
        include_str!("../../templates/muscle_part.xml"),
        facts,
        &[&common[..], places].concat(),
    );
    File::text(file, about, text)
}

fn make(muscle: &ExportedMuscle) -> Result<Artefact> {
    let (part, mut notes, _) = native(muscle, None)?;
    let facts = [muscle.facts(), notes.clone()].concat();
    notes.push("both actuators of a muscle take the same control: its gauge pressure in Pa".into());
    let half = number(0.5 * muscle.form.supply_pa);
    let mut files = vec![
        scene(muscle, &facts, NATIVE, &format!("{half} {half}")),
        part,
    ];
    files.push(scene(muscle, &muscle.facts(), PLUGIN, &half));
    files.extend(plugin(muscle, None));
    Ok(Artefact { files, notes })
}

/// A scene in which a mass hangs from the muscle.
fn scene(muscle: &ExportedMuscle, facts: &[String], kind: &str, half: &str) -> File {
    let length = muscle.form.length_m;
    let blocked_n = muscle.blocked_force_n;
    let id = muscle.identifier();
    let mass_kg = 0.4 * blocked_n / 9.81;
    let stiffness = 6.0 * blocked_n / length;
    let places = [
        ("part", format!("{id}{kind}_part.xml")),
        ("below", number(-length - muscle.cord_m)),
        ("mass", number(mass_kg)),
        ("damping", number(0.5 * 2.0 * (stiffness * mass_kg).sqrt())),
        ("half", half.to_owned()),
        ("id", id.clone()),
    ];
    let about = match kind {
        NATIVE => "a mass that hangs from the muscle, with native actuators",
        _ => "the same mass by the plugin",
    };
    let text = render(include_str!("../../templates/muscle.xml"), facts, &places);
    File::text(format!("{id}{kind}.xml"), about, text)
}

/// Body, sites and springs of a joint.
fn places(joint: &ExportedJoint) -> Vec<Place> {
    let id = joint.identifier();
    let link = joint.joint.link();
    let paths = joint.paths();
    let mass = link.mass_kg + link.payload_kg;
    let moment = 1e-3 * (link.mass_kg * link.centre_mm + link.payload_kg * link.payload_at_mm);
    let centre = if mass > 0.0 { moment / mass } else { 0.0 };
    let inertia = link.whole_inertia_kg_m2();
    let least = moment * centre;
    let along = link.inclination_deg.to_radians().sin_cos();
    let at = |r: f64| format!("{:.9} {:.9} 0", r * along.1, r * along.0);
    let spring = format!("{id}_spring");
    let mut places: Vec<Place> = vec![
        ("range", joint.range_rad().map(number).join(" ")),
        ("damping", number(link.damping_nm_s_per_rad)),
        ("armature", number((inertia - least).max(0.0))),
        ("mass", number(mass.max(1e-6))),
        ("centre", at(centre)),
        (
            "end",
            at(1e-3 * link.centre_mm.max(link.payload_at_mm).max(50.0)),
        ),
    ];
    let names = joint.muscles.iter().map(ExportedMuscle::identifier);
    let mut sites = [String::new(), String::new()];
    for (name, path) in names.zip(&paths).chain([(spring.clone(), &paths[2])]) {
        if let Path::Points {
            origin_mm,
            insertion_mm,
        } = path
        {
            let ends = [("origin", origin_mm), ("insertion", insertion_mm)];
            for (sites, (word, [x, y])) in sites.iter_mut().zip(ends) {
                *sites += &format!(
                    "<site name=\"{name}_{word}\" pos=\"{} {} 0\" size=\"0.005\"/>",
                    number(1e-3 * x),
                    number(1e-3 * y)
                );
            }
        }
    }
    places.extend(
        ["fixed_sites", "moving_sites"]
            .into_iter()
            .zip(sites)
            .filter(|p| !p.1.is_empty()),
    );
    let (torsion, rope) = joint.springs();
    let bias = |k: [f64; 2]| ("bias", k.map(|v| number(-v)).join(" "));
    match joint.joint.spring() {
        None => {}
        Some(JointSpring::Torsion { .. }) => {
            places.extend([("spring", format!("joint=\"{id}\"")), bias(torsion)])
        }
        Some(JointSpring::Rope { .. }) => places.extend([
            ("rope", tendon(&spring, "", Some((&paths[2], &id)))),
            // It pulls or is slack.
            (
                "spring",
                format!("tendon=\"{spring}\" forcelimited=\"true\" forcerange=\"-1e12 0\""),
            ),
            bias(rope),
        ]),
    }
    places.push(("id", id));
    places
}

/// The joint as a hinge with its link, by native actuators and by the plugins of its muscles.
fn joint(joint: &ExportedJoint) -> Result<Artefact> {
    let id = joint.identifier();
    let mut parts = vec![];
    let mut plugins = vec![];
    let mut notes = vec![];
    let mut constants = vec![];
    for (muscle, path) in joint.muscles.iter().zip(&joint.paths()) {
        let (part, said, k) = native(muscle, Some((path, &id)))?;
        constants.push(k);
        notes.extend(
            said.into_iter()
                .map(|said| format!("{}: {said}", muscle.name)),
        );
        parts.push(part);
        plugins.extend(plugin(muscle, Some((path, &id))));
    }
    let places = places(joint);
    let native = joint.with_pulls(|i, q, x| pull(&joint.muscles[i], &constants[i], q, x));
    notes.push(format!(
        "{id}.xml, by native actuators. {}",
        native.facts()[1]
    ));
    let scene = |kind: &str, about: &'static str| {
        let include =
            |m: &ExportedMuscle| format!("<include file=\"{}{kind}_part.xml\"/>", m.identifier());
        let controls = if kind == NATIVE { 2 } else { 1 };
        let half = |m: &ExportedMuscle| vec![number(0.5 * m.form.supply_pa); controls];
        let mut halves: Vec<String> = joint.muscles.iter().flat_map(half).collect();
        halves.extend(joint.joint.spring().map(|_| "0".into()));
        let own = [
            ("includes", joint.muscles.iter().map(include).collect()),
            ("half", halves.join(" ")),
        ];
        let of = if kind == NATIVE { &native } else { joint };
        let text = include_str!("../../templates/joint.xml");
        File::text(
            format!("{id}{kind}.xml"),
            about,
            render(text, &of.facts(), &[&own[..], &places].concat()),
        )
    };
    let mut files = vec![scene(
        NATIVE,
        "the joint with its link, with native actuators",
    )];
    files.extend(parts);
    files.push(scene(PLUGIN, "the same by the plugins"));
    files.extend(plugins);
    Ok(Artefact { files, notes })
}
