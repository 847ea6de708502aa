//! Files that the program writes are files that it reads.

use crate::{reply, root};
use mckibben_app::{ModelFields, MotionRequest, TextFile, ask, motion};
use mckibben_core::progress::Silent;
use serde_json::{Value, json};

const LAWS: [&str; 5] = [
    "law = \"neo-hookean\"\nmu = 0.5",
    "law = \"gent\"\nmu = 0.5\njm = 10",
    "law = \"yeoh\"\nc10 = 0.2\nc20 = 0.01\nc30 = 0.001",
    "law = \"mooney-rivlin\"\nc10 = 0.2\nc01 = 0.02",
    "law = \"arruda-boyce\"\nmu = 0.5\nlambda_m = 3",
];
const STRANDS: [&str; 2] = ["\"inextensible\"", "\"400 N/mm\""];
const SETS: [&str; 4] = ["dmsp-10-250", "dmsp-20-300", "quadsegrity", "tondu2012"];
const FREE: [&str; 8] = [
    "modulus",
    "braid.angle",
    "braid.stiffness",
    "braid.take_up",
    "terminals.seating",
    "terminals.slip",
    "friction.lever",
    "friction.coefficient",
];

/// Every measured set with laws, strands and free constants by chance: what `identify` writes is
/// read by the commands that ask a muscle. A set may give no constants; it never gives a file that
/// is none.
#[test]
fn whatever_was_identified_is_a_muscle() {
    let mut state = 7_u64;
    let mut chance = |n: usize| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % n
    };
    let (mut written, mut refused) = (0, vec![]);
    for i in 0..60 {
        let (set, law, strands) = (
            SETS[i % SETS.len()],
            LAWS[chance(LAWS.len())],
            STRANDS[chance(2)],
        );
        let folder = root().join("crates/mckibben-fit/data/measured").join(set);
        let text = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
        let measured = mckibben_core::muscle::file::parse_muscle(&text("muscle.toml")).unwrap();
        let tube = measured.tube();
        let muscle = format!(
            "[tube]\nouter_diameter = {}\nwall_thickness = {}\nlength = \
             {}\n[tube.material]\n{law}\n[braid]\nangle = {}\nstiffness = {strands}\n",
            tube.outer_diameter_mm,
            tube.wall_mm,
            tube.length_mm,
            measured.braid().angle_deg
        );
        let mut free: Vec<&str> = (0..=chance(3)).map(|_| FREE[chance(FREE.len())]).collect();
        free.sort_unstable();
        free.dedup();
        let branches = ["both", "mean"][chance(2)];
        let request = json!({ "muscle": { "file": { "name": "m.toml", "text": muscle } }, "data": [{ "name": "points.csv", "text": text("points.csv") }], "free": free, "model": "thick-wall", "branches": branches });
        let answer: Value = match ask("identify", &request.to_string(), &Silent) {
            Ok(answer) => serde_json::from_str(&answer).unwrap(),
            Err(problem) => {
                assert!(
                    !problem.message.contains("make no muscle"),
                    "{set} {law} {free:?}: {problem}"
                );
                refused.push(format!("{set} {free:?}: {}", problem.message));
                continue;
            }
        };
        written += 1;
        let file = json!({ "name": "identified.toml", "text": answer["muscle_file"] });
        let point = json!({ "muscle": { "file": file }, "pressure_mpa": 0.3, "contraction": 0.1, "model": "thick-wall" });
        if let Err(problem) = ask("force", &point.to_string(), &Silent) {
            assert_ne!(
                serde_json::to_value(problem.kind).unwrap(),
                "file",
                "{set} {law} {free:?}: {problem}"
            );
        }
        let shown = reply(
            "check",
            json!({ "muscle": { "file": file }, "only_data": true }),
        );
        let said = shown["warnings"].to_string();
        assert!(
            !said.contains("[identified]"),
            "{set} {law} {free:?}: {said}"
        );
    }
    assert!(written > 40, "{written}: {refused:#?}");
}

/// The recommended law of every measured rubber, in a muscle.
#[test]
fn whatever_rubber_was_fitted_is_a_muscle() {
    let folder = root().join("crates/mckibben-fit/data/measured");
    for name in [
        "rubber-treloar",
        "rubber-ecoflex-00-50",
        "rubber-dragon-skin-30",
        "rubber-rtv615",
    ] {
        let text = std::fs::read_to_string(folder.join(name).join("points.csv")).unwrap();
        let muscle = json!({ "name": "p.toml", "text": mckibben_core::muscle::file::to_toml(&mckibben_core::muscle::Muscle::prototype()) });
        for law in [
            "neo-hookean",
            "gent",
            "arruda-boyce",
            "yeoh",
            "ogden",
            "extended-tube",
        ] {
            let request = json!({ "data": [{ "name": "t.csv", "text": text }], "laws": [law], "stable": true, "muscle": muscle });
            let Ok(answer) = ask("rubber", &request.to_string(), &Silent) else {
                continue;
            };
            let answer: Value = serde_json::from_str(&answer).unwrap();
            if let Some(file) = answer["muscle_file"].as_str() {
                reply(
                    "check",
                    json!({ "muscle": { "file": { "name": "r.toml", "text": file } }, "only_data": true }),
                );
            }
        }
    }
}

/// Cycles of a neo-Hookean strip: W = (μ/2)(λ² + 2/λ − 3), and of the stress μ (λ − λ⁻²) the share
/// η of Ogden and Roxburgh by the largest energy so far.
#[test]
fn the_softening_of_a_rubber_stands_in_its_muscle_file() {
    use mckibben_core::rubber::{Law, over_time::erf};
    let (mu, r, m, beta) = (0.4, 1.5, 0.04, 0.1);
    let mut text = String::from("time_s,stretch,nominal_stress_mpa\n");
    let (mut time, mut largest) = (0, 0.0_f64);
    for (from, to) in [(1.0, 1.7), (1.7, 1.0), (1.0, 2.2), (2.2, 1.0)] {
        for i in 0..25 {
            let stretch: f64 = from + (to - from) * f64::from(i) / 25.0;
            let energy = 0.5 * mu * (stretch * stretch + 2.0 / stretch - 3.0);
            largest = largest.max(energy);
            let eta = 1.0 - erf((largest - energy) / (m + beta * largest)) / r;
            let stress = eta * mu * (stretch - stretch.powi(-2));
            text += &format!("{time},{stretch},{stress}\n");
            time += 1;
        }
    }
    let data = json!([{ "name": "cycles.csv", "text": text }]);
    let answer = reply(
        "rubber",
        json!({ "data": data, "laws": ["neo-hookean"], "softening": true }),
    );
    let muscle = mckibben_core::muscle::file::parse_muscle(answer["muscle_file"].as_str().unwrap());
    let rubber = muscle.unwrap().tube().rubber.clone();
    let written = rubber.softening.unwrap();
    for (key, written, made) in [
        ("r", written.r, r),
        ("m_mpa", written.m_mpa, m),
        ("beta", written.beta, beta),
    ] {
        // A file has fifteen digits of a number.
        let answered = answer["softening"][key].as_f64().unwrap();
        assert!((written / answered - 1.0).abs() < 1e-14, "{key}: {written}");
        assert!((written / made - 1.0).abs() < 0.01, "{key}: {written}");
    }
    // The law beside it is that of the first loading.
    let Law::NeoHookean(law) = rubber.law else {
        panic!("{rubber:?}")
    };
    assert!((law.mu_mpa / mu - 1.0).abs() < 1e-9, "{law:?}");
}

/// A muscle that was designed for 10 kg has a drive file to begin with; there its load is lifted and
/// rests within 1 % of its stroke of the equilibrium of the model, well damped.
#[test]
fn a_designed_muscle_has_a_drive_file_to_begin_with() {
    let text = std::fs::read_to_string(root().join("examples/biceps.toml")).unwrap()
        + "\n[job]\npressure = '3 bar'\nsupply = '6 bar'\npoints = [{ force = '98.0665 N', contraction = 0.1 }]\n";
    let file = |name: &str, text: &str| TextFile {
        name: name.into(),
        text: text.into(),
    };
    let muscle = file("muscle.toml", &text);
    let drive = MotionRequest::drive_to_begin(&muscle).unwrap();
    assert!(drive.contains("mass = \"10.000 kg\""), "{drive}");
    assert!(drive.contains("pressure = \"0.6"), "{drive}");
    let request = MotionRequest {
        drive: Some(file("drive.toml", &drive)),
        muscle: Some(muscle),
        model: ModelFields::named("thick-wall"),
        ..MotionRequest::default()
    };
    let motion = motion(&request, &Silent).unwrap().motion.motion;
    let contraction = &motion.series.muscles[0].contraction;
    let end = contraction.last().unwrap();
    let still = motion.equilibrium_contraction.unwrap();
    assert!(
        still > 0.1 && (end - still).abs() < 0.01 * still,
        "{end} {still}"
    );
    let most = contraction.iter().copied().fold(0.0, f64::max);
    assert!(most < 1.5 * still, "{most} {still}");
    // A drive file is no muscle, and a muscle without a job has none.
    let plain = file("muscle.toml", text.split("[job]").next().unwrap());
    for other in [file("drive.toml", &drive), plain] {
        assert!(MotionRequest::drive_to_begin(&other).is_none());
    }
}
