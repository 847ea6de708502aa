//! One muscle, one truth: every output of a muscle at a pressure carries the same pull, interval,
//! limits and warnings. What `force` answers is the expected fact, kept in `truth/facts.tsv`; the rows
//! of `outputs` read it from all other commands, `checks/truth.py` from what runs outside of them, tests
//! of their own from the page, Rust and Python. A new command that takes a muscle and is not in the table
//! fails the last test.

use crate::{
    given::{file, number, text_of, with},
    reply, root,
};
use mckibben_app::{COMMANDS, ask_value};
use mckibben_core::progress::Silent;
use serde_json::{Value, json};
use std::collections::BTreeSet;

/// A muscle, the pressure in MPa and the contraction at which it is asked, and what is expected there:
/// a row of `truth/facts.tsv`, which the hosts of `checks/truth.py` read as well.
struct Case {
    name: String,
    text: String,
    pressure_mpa: f64,
    contraction: f64,
    facts: Vec<String>,
}

const FACTS: &str = include_str!("truth/facts.tsv");

fn cases() -> Vec<Case> {
    let case = |line: &str| {
        let mut cells = line.split('\t').map(str::to_owned);
        let mut next = || cells.next().unwrap();
        let name = next();
        let text = match name.strip_prefix("lib:") {
            Some(name) => mckibben_fit::library::file(name).unwrap().to_owned(),
            None => text_of(&format!("crates/mckibben-app/tests/layer/truth/{name}")),
        };
        let [pressure_mpa, contraction] = [next(), next()].map(|cell| cell.parse().unwrap());
        let facts = cells.collect();
        Case {
            name,
            text,
            pressure_mpa,
            contraction,
            facts,
        }
    };
    FACTS.lines().skip(1).map(case).collect()
}

/// What `force`, and `build` of its proof test, answer: a number to six decimals.
fn facts_of(case: &Case) -> Vec<String> {
    let muscle = json!({ "file": file("muscle.toml", &case.text) });
    let at = json!({ "muscle": muscle, "pressure_mpa": case.pressure_mpa });
    let asked = with(at.clone(), json!({ "contraction": case.contraction }));
    let force = reply("force", asked);
    let built = ask_value("build", at, &Silent).unwrap_or_default();
    let cell = |value: &Value| match value {
        Value::Number(number) => format!("{:.6}", number.as_f64().unwrap()),
        Value::String(text) => text.clone(),
        _ => "-".to_owned(),
    };
    let keys = FACTS.lines().next().unwrap().split('\t').skip(3);
    let fact = |key: &str| match key {
        "warnings" => kinds(&force).into_iter().collect::<Vec<_>>().join(","),
        "proof_pressure_mpa" => cell(&built[key]),
        _ => cell(found(&force, key).unwrap_or(&Value::Null)),
    };
    keys.map(fact).collect()
}

/// A regression: our own program wrote the facts (`MCKIBBEN_WRITE` writes them again). That they are
/// right is what validation and verification say; that all outputs have them, what the other tests say.
#[test]
fn regression_the_facts_of_the_muscles_are_those_that_are_kept() {
    let same = |(a, b): (&String, &String)| match [a, b].map(|cell| cell.parse::<f64>()) {
        [Ok(a), Ok(b)] => (a - b).abs() <= 2e-6 + 1e-6 * b.abs(),
        _ => a == b,
    };
    let mut made = FACTS.lines().next().unwrap().to_owned() + "\n";
    let mut wrong = vec![];
    for case in cases() {
        let now = facts_of(&case);
        let (at, facts) = (
            format!("{}\t{}", case.pressure_mpa, case.contraction),
            now.join("\t"),
        );
        made += &format!("{}\t{at}\t{facts}\n", case.name);
        if now.len() != case.facts.len() || !now.iter().zip(&case.facts).all(same) {
            wrong.push(format!("{}: {:?} is now {now:?}", case.name, case.facts));
        }
    }
    if std::env::var_os("MCKIBBEN_WRITE").is_some() {
        let path = root().join("crates/mckibben-app/tests/layer/truth/facts.tsv");
        return std::fs::write(path, made).unwrap();
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The file that `identify` writes of a muscle that pulls this share of what was read.
fn identified(text: &str, share: f64) -> String {
    let rows = [
        (0.177, 0.0, 91.0),
        (0.177, 0.05, 59.4),
        (0.177, 0.12, 30.5),
        (0.12, 0.05, 32.3),
    ];
    let line = |(p, e, n): &(f64, f64, f64)| format!("{p},{e},{},contraction\n", share * n);
    let table = "pressure_mpa,contraction,force_n,branch\n".to_owned()
        + &rows.iter().map(line).collect::<String>();
    let muscle = json!({ "file": file("muscle.toml", text) });
    let asked =
        json!({ "muscle": muscle, "data": [file("points.csv", &table)], "model": "thick-wall" });
    let answer = reply("identify", asked);
    let text = found(&answer, "muscle_file").and_then(Value::as_str);
    text.unwrap().to_owned()
}

/// The first value of this name, however deep.
fn found<'a>(value: &'a Value, key: &str) -> Option<&'a Value> {
    match value {
        Value::Object(fields) => fields
            .get(key)
            .or_else(|| fields.values().find_map(|value| found(value, key))),
        Value::Array(list) => list.iter().find_map(|value| found(value, key)),
        _ => None,
    }
}

fn kinds(answer: &Value) -> BTreeSet<String> {
    const OF_MUSCLE: [&str; 4] = [
        "burst",
        "burst_not_checked",
        "above_allowed",
        "not_measured",
    ];
    let all = answer["warnings"].as_array().into_iter().flatten();
    let kinds = all.filter_map(|w| w["kind"].as_str());
    let of_muscle = kinds.filter(|kind| OF_MUSCLE.contains(kind));
    of_muscle.map(str::to_owned).collect()
}

/// A command with a muscle beside `force`, what is asked of it, and the contraction at which its
/// `predicted_n` stands.
struct Output {
    command: &'static str,
    request: Value,
    contraction: Option<f64>,
}

fn outputs(case: &Case) -> Vec<Output> {
    let (p, e) = (case.pressure_mpa, case.contraction);
    let muscle_file = file("muscle.toml", &case.text);
    let muscle = json!({ "file": muscle_file });
    let of_job = case.text.contains("pressure = \"1.8 bar\"").then_some(e);
    let points =
        json!({ "muscle": muscle, "test": "isobaric", "pressures_mpa": [p], "contractions": [e] });
    let at = json!({ "muscle": muscle, "pressure_mpa": p });
    let joint = format!(
        "[joint]\nradius = \"20 mm\"\nrange = \"-10..10 deg\"\ninertia = \"0.01 kg m2\"\n\
         [muscle_1]\nfile = \"muscle.toml\"\ncontraction_at_neutral = \"{}%\"\n\
         [spring]\nangular_rate = \"1 N m/rad\"\n",
        100.0 * e
    );
    let joint = json!({ "joint": file("joint.toml", &joint), "muscles": [muscle_file],
        "pressures_mpa": [[p]], "angles_deg": [0] });
    let step = json!({ "load": format!("held:{}%", 100.0 * e), "pressure_mpa": p,
        "valve": "festo-mh2", "until_s": 0.2 });
    let all = [
        ("curve", points.clone(), Some(e)),
        ("simulate", points, Some(e)),
        ("check", at.clone(), Some(0.0)),
        ("build", at.clone(), of_job),
        // Without a job it is that of the length at rest.
        (
            "export",
            with(at.clone(), json!({ "target": "c" })),
            of_job.or(Some(0.0)),
        ),
        ("contraction", with(at, json!({ "force_n": 0 })), None),
        ("joint", joint, None),
        (
            "motion",
            json!({ "muscle": muscle_file, "step": step }),
            None,
        ),
    ];
    all.map(|(command, request, contraction)| Output {
        command,
        request,
        contraction,
    })
    .into()
}

#[test]
fn identity_every_output_has_the_pull_limits_and_warnings_of_force() {
    for case in cases() {
        let muscle = json!({ "file": file("muscle.toml", &case.text) });
        let force_at = |contraction: f64| {
            let pressure_mpa = case.pressure_mpa;
            let request = json!({ "muscle": muscle, "pressure_mpa": pressure_mpa, "contraction": contraction });
            reply("force", request)
        };
        let force = force_at(case.contraction);
        for Output {
            command,
            request,
            contraction,
        } in outputs(&case)
        {
            let place = format!("{}: {command}", case.name);
            let answer = match ask_value(command, request, &Silent) {
                Ok(answer) => answer,
                // A muscle that extends has no folder and no export, lifts nothing and is held by
                // no rope; nor has one without room.
                Err(problem) => {
                    let may_refuse = ["build", "export", "contraction", "joint", "motion"];
                    assert!(may_refuse.contains(&command), "{place}: {problem:?}");
                    assert!(
                        ["build", "export"].contains(&command) || case.name == "extends.toml",
                        "{place}: {problem:?}"
                    );
                    continue;
                }
            };
            for key in ["allowed_pressure_mpa", "burst_pressure_mpa", "allowed_by"] {
                assert_eq!(found(&answer, key), found(&force, key), "{place}: {key}");
            }
            assert_eq!(kinds(&answer), kinds(&force), "{place}");
            let Some(contraction) = contraction else {
                continue;
            };
            let force = force_at(contraction);
            for key in ["predicted_n", "predicted_low_n", "predicted_high_n"] {
                let at = |v: &Value| found(v, key).and_then(Value::as_f64);
                let (answered, wanted) = (at(&answer), at(&force));
                let (x, y) = (answered.unwrap_or(0.0), wanted.unwrap_or(0.0));
                assert_eq!(answered.is_some(), wanted.is_some(), "{place}: {key}");
                assert!(
                    (x - y).abs() <= 1e-9 * y.abs().max(1.0),
                    "{place}: {key} {x} {y}"
                );
            }
        }
    }
}

/// An identity: `check` and `build` of a muscle at a pressure have one blocked force of the model.
#[test]
fn identity_check_and_build_have_one_blocked_force() {
    let mut compared = 0;
    for case in cases() {
        let muscle = json!({ "file": file("muscle.toml", &case.text) });
        let at = json!({ "muscle": muscle, "pressure_mpa": case.pressure_mpa });
        let Ok(built) = ask_value("build", at.clone(), &Silent) else {
            continue;
        };
        let checked = reply("check", at);
        let [x, y] = [&checked, &built].map(|answer| {
            let found = found(answer, "blocked_force_n").and_then(Value::as_f64);
            found.unwrap()
        });
        assert!((x - y).abs() <= 1e-9 * y.abs(), "{}: {x} {y}", case.name);
        compared += 1;
    }
    assert!(compared > 4, "{compared}");
}

/// mean + friction + take-up + ends + factor = median (interface, version 4).
#[test]
fn identity_the_printed_parts_add_up_to_the_median() {
    for case in cases() {
        let muscle = json!({ "file": file("muscle.toml", &case.text) });
        let request = json!({ "muscle": muscle, "pressure_mpa": case.pressure_mpa,
            "contraction": case.contraction, "two_sided": true });
        let force = reply("force", request);
        let Some(shift) = force["predicted_shift_n"].as_object() else {
            continue;
        };
        let sum: f64 = shift.values().filter_map(Value::as_f64).sum();
        let [mean, median] = ["mean_n", "predicted_n"].map(|key| number(&force, key));
        assert!(
            (mean + sum - median).abs() < 1e-9 * mean.abs().max(1.0),
            "{}: {mean} {sum} {median}",
            case.name
        );
    }
}

/// No folder and no export above the allowed pressure, and no proof test without room for a relief
/// valve: `own` of the trials, 16 bar.
#[test]
fn what_is_handed_out_stays_below_the_allowed_pressure() {
    let own = text_of("crates/mckibben-app/tests/layer/truth/strength-unknown.toml");
    let muscle = json!({ "file": file("own.toml", &own) });
    let force = reply("force", json!({ "muscle": muscle, "pressure_mpa": 0.1 }));
    let allowed_mpa = number(&force, "allowed_pressure_mpa");
    assert_eq!(force["allowed_by"], "strand_strain");
    let of = |command: &str, pressure_mpa: f64| {
        let request = json!({ "muscle": muscle, "pressure_mpa": pressure_mpa });
        let more = if command == "export" {
            json!({ "target": "c" })
        } else {
            json!({})
        };
        ask_value(command, with(request, more), &Silent)
    };
    for command in ["build", "export"] {
        for over in [1.001 * allowed_mpa, 1.6, 2.0] {
            let refused = of(command, over).unwrap_err();
            assert_eq!(refused.kind, mckibben_app::ProblemKind::OutOfRange);
            assert_eq!(refused.field.as_deref(), Some("pressure_mpa"));
        }
    }
    let refused = of("build", 0.99 * allowed_mpa).unwrap_err();
    assert_eq!(refused.field.as_deref(), Some("pressure_mpa"));
    let built = of("build", 0.6).unwrap();
    let proof_mpa = number(&built, "proof_pressure_mpa");
    assert!(
        proof_mpa <= allowed_mpa && proof_mpa >= 1.1 * 0.6,
        "{proof_mpa}"
    );
}

/// An identity: a joint turns with what its muscles pull by `force` on their branches, times their
/// arms: those that turn it shorten, the others lengthen. Where they turn it by less than their
/// friction, no torque of theirs is left.
#[test]
fn identity_a_joint_turns_with_the_pulls_of_its_muscles_on_their_branches() {
    let joint = crate::given::joint_file("examples/elbow.toml");
    let muscle = crate::given::muscle("examples/biceps.toml");
    for (pressures, angle_deg) in [
        ([0.3, 0.1], 0.0),
        ([0.1, 0.3], 0.0),
        ([0.3, 0.1], 10.0),
        ([0.2, 0.2], 0.0),
        // The second one is slack on the branch on which it shortens.
        ([0.2, 0.1], -45.0),
        ([0.2, 0.1], -60.0),
        ([0.1, 0.28], 60.0),
    ] {
        let request = json!({ "pressures_mpa": [pressures], "angles_deg": [angle_deg], "model": "universal" });
        let point = reply("joint", crate::given::with(joint.clone(), request))["points"][0].take();
        let pulls = |direction: &str, i: usize| {
            let e = number(&point, ["contraction_1", "contraction_2"][i]);
            let request = json!({ "muscle": muscle, "pressure_mpa": pressures[i], "contraction": e,
                "direction": direction, "model": "universal" });
            number(&reply("force", request), "predicted_n")
        };
        let turns = |first: &str, second: &str| 0.025 * (pulls(first, 0) - pulls(second, 1));
        let model = 0.025 * (number(&point, "force_1_n") - number(&point, "force_2_n"));
        let of_muscles = number(&point, "predicted_nm") - number(&point, "torque_nm") + model;
        let (there, back) = (
            turns("contraction", "elongation"),
            turns("elongation", "contraction"),
        );
        let expected = there.max(0.0) + back.min(0.0);
        assert!(
            (of_muscles - expected).abs() < 1e-6,
            "{pressures:?}: {of_muscles} {there} {back}"
        );
    }
}

/// Bounds: whatever a pressure that `overpressure` allows, it is below the one that is never
/// exceeded, that below the proof test by the factor of a relief valve, and that at most three
/// quarters of the burst pressure. Above, it is refused.
#[test]
fn overpressure_leaves_a_proof_test_below_the_burst_pressure() {
    let muscle = crate::given::muscle("examples/shop.toml");
    let of = |pressure_mpa: f64| {
        let request =
            json!({ "muscle": muscle, "pressure_mpa": pressure_mpa, "overpressure": true });
        ask_value("build", request, &Silent)
    };
    let built = of(0.2).unwrap();
    let [allowed_mpa, burst_mpa] =
        ["allowed_pressure_mpa", "burst_pressure_mpa"].map(|key| number(&built, key));
    assert!((allowed_mpa * 1.1 - 0.75 * burst_mpa).abs() < 1e-9 * burst_mpa);
    for share in [0.9, 0.9999] {
        let built = of(share * allowed_mpa).unwrap();
        let proof_mpa = number(&built, "proof_pressure_mpa");
        assert!(
            proof_mpa >= 1.1 * share * allowed_mpa && proof_mpa <= 0.75 * burst_mpa * (1.0 + 1e-12)
        );
        let files = built["files"].as_array().unwrap().iter();
        let readme = files.clone().find(|f| f["name"] == "README.md").unwrap();
        let text = readme["text"].as_str().unwrap();
        let after = |words: &str| {
            let rest = text
                .split_once(words)
                .unwrap_or_else(|| panic!("{words}: {text}"))
                .1;
            rest.split_whitespace()
                .next()
                .unwrap()
                .parse::<f64>()
                .unwrap()
        };
        let (raised, never) = (after("was raised to "), after("In use never above "));
        assert!(
            never <= raised && raised <= allowed_mpa,
            "{never} {raised}: {text}"
        );
    }
    assert_eq!(
        of(1.001 * allowed_mpa).unwrap_err().field.as_deref(),
        Some("pressure_mpa")
    );
}

/// Commands of which the table above says nothing, and why.
const OTHERS: [&str; 23] = [
    // The expected fact itself, its inverses and what follows from them at other points.
    "force",
    "pressure",
    "fill",
    // Of several muscles, each by the same type: their tests stand beside them.
    "export-joint",
    "design",
    "identify",
    // Models, tables, parts and files.
    "campaign",
    "campaign-forecast",
    "campaign-show",
    "campaign-merge",
    "compare",
    "fit",
    "check-formula",
    "rubber",
    "parts-list",
    "parts-show",
    "export-list",
    "shape",
    "study",
    "units",
    "measures",
    "plan",
    "quantities",
];

const JOB: &str = "[job]\npressure = \"1.8 bar\"\nsupply = \"2 bar\"\nbranch = \"contraction\"\n\
    points = [{ force = \"50 N\", contraction = \"7.5%\" }]\n";

/// A bound: what `identify` found of a muscle that pulls less never raises its limit, whatever share
/// of the pull was read; and what is asked of the found file without a word is its job.
#[test]
fn no_pull_that_was_measured_raises_a_limit() {
    let text = "[tube]\nouter_diameter = \"15 mm\"\nwall_thickness = \"1.5 mm\"\n\
        length = \"160 mm\"\nrubber = \"dragon-skin-30\"\n[braid]\nname = \"nfl-19\"\n";
    let text = text.to_owned() + JOB;
    let of = |text: &str| json!({ "file": file("muscle.toml", text) });
    let allowed_mpa = |text: &str| {
        let asked = json!({ "muscle": of(text), "pressure_mpa": 0.1 });
        number(&reply("force", asked), "allowed_pressure_mpa")
    };
    let before_mpa = allowed_mpa(&text);
    for share in [0.5, 0.8, 1.0, 1.2] {
        let found_text = &identified(&text, share);
        let after_mpa = allowed_mpa(found_text);
        // The file keeps five digits of what was found.
        assert!(
            after_mpa <= before_mpa * (1.0 + 1e-5),
            "{share}: {after_mpa} {before_mpa}"
        );
        let takes = reply("pressure", json!({ "muscle": of(found_text) }));
        assert_eq!(number(&takes, "force_n"), 50.0);
        assert_eq!(number(&takes, "contraction"), 0.075);
        // What is to be set is nothing that the supply does not give.
        let job = reply("force", json!({ "muscle": of(found_text) }));
        assert!(number(&job, "pressure_mpa") <= 0.2);
    }
}

#[test]
fn no_command_is_missing_from_the_table() {
    let known: Vec<&str> = cases().first().map_or(vec![], |case| {
        outputs(case)
            .into_iter()
            .map(|output| output.command)
            .collect()
    });
    let missing: Vec<&str> = COMMANDS
        .iter()
        .map(|command| command.name)
        .filter(|name| !known.contains(name) && !OTHERS.contains(name))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}
