//! The burst pressure: one value in every command, said first where it is reached, and said to be missing where it is not known.

use crate::common::{Ran, folder, run_in};
use serde_json::Value;
use std::path::Path;

const HOSE: &str = "[tube]\nouter_diameter = \"14 mm\"\nwall_thickness = \"2 mm\"\nlength = \"200 mm\"\n\
    [tube.material]\nlaw = \"neo-hookean\"\nmu = \"1.2 MPa\"\n\
    [braid]\nangle = \"22 deg\"\nstrands = 96\nstrand_diameter = \"0.25 mm\"\nstrand_modulus = \"8.5 GPa\"\n";
const STRENGTH: &str = "strand_strength = \"40 N\"\n";
const JOINT: &str = "[joint]\nradius = \"20 mm\"\nrange = \"-45..45 deg\"\ninertia = \"0.01 kg m2\"\n\
    [muscle_1]\nfile = \"hose.toml\"\ncontraction_at_neutral = \"8%\"\n\
    [muscle_2]\nfile = \"hose.toml\"\ncontraction_at_neutral = \"8%\"\n";

fn asked(dir: &Path, words: &str) -> Ran {
    run_in(dir, &words.split_whitespace().collect::<Vec<_>>()).ok()
}

fn as_json(dir: &Path, words: &str) -> Value {
    asked(dir, &format!("{words} --format json")).json()
}

fn with(strength: &str) -> tempfile::TempDir {
    let dir = folder();
    std::fs::write(dir.path().join("hose.toml"), format!("{HOSE}{strength}")).unwrap();
    std::fs::write(dir.path().join("joint.toml"), JOINT).unwrap();
    dir
}

fn first_warning(answer: &Value) -> &str {
    answer["warnings"][0].as_str().unwrap_or_default()
}

const MOTION: &str =
    "motion --muscle hose.toml --load mass:5kg --valve festo-mh2 --damping 200Ns/m --until 0.3s";

/// The identity that defines it: there the tension of the most loaded strand of the blocked muscle is its strength.
#[test]
fn one_burst_pressure_in_every_command_to_the_last_digit() {
    let dir = with(STRENGTH);
    let dir = dir.path();
    let burst = as_json(dir, "check hose.toml -p 6bar")["characteristics"]["burst_pressure_mpa"].clone();
    let there = as_json(dir, &format!("force hose.toml -p {burst}MPa"));
    let tension = there["strand_tension_n"].as_f64().unwrap();
    assert!((tension / 40.0 - 1.0).abs() < 1e-8, "{tension} at {burst}");
    for words in [
        "force hose.toml -p 6bar -e 5%",
        "force hose.toml -p 60bar",
        "force hose.toml -p 22bar",
        "pressure hose.toml -F 300N -e 5%",
        "contraction hose.toml -F 100N -p 3bar",
        "curve isobaric hose.toml -p 2bar",
        "simulate hose.toml --test isobaric -p 2bar",
        "joint joint.toml -p 3bar,1bar --angle 0",
        &format!("{MOTION} -p 3bar"),
        "build hose.toml -p 3bar",
    ] {
        let answer = as_json(dir, words);
        assert_eq!(answer["burst_pressure_mpa"], burst, "{words}");
    }
    // A muscle that was designed has the burst pressure of the file that was written.
    let found = as_json(dir, "design hose.toml -F 300N -e 5% -p 4bar -s 2 --safety 1.5 -o winner.toml");
    let designed = &found["candidates"][0]["burst_pressure_mpa"];
    assert!(designed.as_f64().unwrap() > 0.6, "{designed}");
    assert_eq!(as_json(dir, "force winner.toml -p 4bar")["burst_pressure_mpa"], *designed);
}

#[test]
fn a_pressure_beyond_the_burst_pressure_is_said_before_all_else() {
    let dir = with(STRENGTH);
    let dir = dir.path();
    for words in [
        "check hose.toml -p 60bar",
        "force hose.toml -p 60bar",
        "force hose.toml -p 22bar",
        "curve isobaric hose.toml -p 22bar -e 0,5%",
        "simulate hose.toml --test isobaric -p 22bar -e 0",
        "joint joint.toml -p 60bar,1bar --angle 0",
        &format!("{MOTION} -p 40bar --supply 50bar"),
    ] {
        let text = asked(dir, words);
        let first = text.text().lines().next().unwrap_or_default().to_owned();
        assert!(first.starts_with("BURST: ") && first.contains("21.19 bar"), "{words}: {first}");
        assert!(first_warning(&as_json(dir, words)).starts_with("BURST: "), "{words}");
    }
    // A table has no place for it.
    let csv = asked(dir, "force hose.toml -p 22bar --format csv");
    assert!(csv.err.contains("BURST: ") && !csv.text().contains("BURST"), "{}", csv.err);
    let page = asked(dir, "build hose.toml -p 22bar");
    assert!(page.text().contains("BURST: "));
    // Below it a quarter of it, 5.298 bar, is allowed.
    for words in ["force hose.toml -p 21bar", "curve isobaric hose.toml -p 6bar -e 0,5%"] {
        let text = asked(dir, words);
        let first = text.text().lines().next().unwrap_or_default().to_owned();
        assert!(!first.contains("BURST") && first.starts_with("ABOVE THE ALLOWED PRESSURE: "), "{first}");
        assert!(
            first.contains("5.3 bar is allowed") && first.contains("its strands break at 21.19 bar"),
            "{first}"
        );
    }
    assert!(!asked(dir, "force hose.toml -p 5bar").text().contains("ALLOWED"));
}

/// Of muscles of a list every one is looked at once: their burst pressures by `check` say which of them burst too early.
#[test]
fn where_nothing_fits_the_answer_says_what_burst_has_to_do_with_it() {
    let dir = with(STRENGTH);
    let dir = dir.path();
    let diameters = [12.0, 14.0, 16.0, 18.0];
    let margin = |d: f64| {
        let shown = as_json(dir, &format!("check hose.toml -D {d} --model thick-wall -p 6bar"));
        shown["characteristics"]["burst_pressure_mpa"].as_f64().unwrap() / 0.6
    };
    let margins: Vec<f64> = diameters.iter().map(|d| margin(*d)).collect();
    let wanted = 0.5 * (margins[1] + margins[2]);
    let early = margins.iter().filter(|m| **m < wanted).count();
    assert_eq!(early, 2, "{margins:?}");
    let words = |force: f64, margin: f64| {
        format!(
            "design hose.toml -F {force}N -e 2% -p 6bar -s 2 -D 12,14,16,18 --model thick-wall --safety {margin}"
        )
    };
    let refused = |words: &str| {
        let all: Vec<&str> = words.split_whitespace().collect();
        let text = run_in(dir, &all).text().to_owned();
        (text, run_in(dir, &[&all[..], &["--format", "json"]].concat()).json())
    };
    // All that are strong enough burst too early, and the others are too weak.
    let (text, answer) = refused(&words(9000.0, wanted));
    assert_eq!((&answer["excluded_by_burst"], &answer["excluded_by_burst_alone"]), (&2.into(), &0.into()));
    assert!(text.contains("Of 4 muscles 2 miss the safety factor of"), "{text}");
    assert!(text.contains("each of them also misses another limit"), "{text}");
    let (text, answer) = refused(&words(1.0, 1000.0));
    assert_eq!((&answer["excluded_by_burst"], &answer["excluded_by_burst_alone"]), (&4.into(), &4.into()));
    assert_eq!(answer["closest"]["limit"], "burst_margin");
    assert!(text.contains("they meet every other limit"), "{text}");
    // Of strands whose strength is not stated nobody can say.
    let unknown = with("");
    let dir = unknown.path();
    let all = words(9000.0, 4.0).replace("--safety 4", "");
    let ran = run_in(dir, &all.split_whitespace().collect::<Vec<_>>());
    let text = ran.text();
    let first = text.lines().next().unwrap_or_default();
    assert!(first.starts_with("BURST NOT CHECKED: ") && first.contains("strand_strength"), "{text}");
    assert!(text.contains("Nothing fits."), "{text}");
}

#[test]
fn a_burst_pressure_that_is_not_known_is_said_with_the_number_that_is_missing() {
    let dir = with("");
    let dir = dir.path();
    for (words, missing) in [
        ("check hose.toml -p 3bar", "strand_strength"),
        ("joint joint.toml -p 3bar,1bar --angle 0", "strand_strength"),
        (&format!("{MOTION} -p 3bar"), "strand_strength"),
        ("design hose.toml -F 300N -e 5% -p 4bar -s 2", "strand_strength"),
        ("design -F 700N -e 15% -p 3bar --continuous", "`strands` (how many)"),
        ("check -p 3bar", "`strands` (how many)"),
        ("force hose.toml -p 7bar", "strand_strength"),
    ] {
        let text = asked(dir, words);
        let first = text.text().lines().next().unwrap_or_default().to_owned();
        assert!(first.starts_with("BURST NOT CHECKED: ") && first.contains(missing), "{words}: {first}");
        assert!(first_warning(&as_json(dir, words)).starts_with("BURST NOT CHECKED: "), "{words}");
    }
    assert!(asked(dir, "build hose.toml -p 3bar").text().contains("BURST NOT CHECKED: "));
    // A single point says nothing at the pressure of a usual supply; its key is there all the same.
    let answer = as_json(dir, "force hose.toml -p 6bar");
    assert!(answer["warnings"].as_array().unwrap().is_empty(), "{answer}");
    assert_eq!(answer.get("burst_pressure_mpa"), Some(&Value::Null));
}
