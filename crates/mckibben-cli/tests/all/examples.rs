//! Every command that is shown to users works as shown.

use crate::common::{command, copy, json, mckibben, number, ran, root, words};
use std::path::Path;

/// Runs a command as shown, `mckibben` and what follows.
fn works(folder: &Path, line: &str) {
    let words = words(line);
    let mut words: Vec<&str> = words.iter().skip(1).map(String::as_str).collect();
    if let ["serve", more @ ..] = &words[..] {
        return crate::serve::works(folder, more);
    }
    // They are run in one folder.
    words.push("--overwrite");
    let result = ran(command(folder).args(words).output().unwrap());
    assert_eq!(result.code, 0, "{line}\n{}", result.err);
}

/// The help of a command and of all commands below it.
fn helps(path: &[String], out: &mut Vec<(String, String)>) {
    // As on a terminal of the usual width: an example must not be wrapped there.
    let mut command = command(&root());
    let help = ran(command
        .args(path)
        .arg("--help")
        .env("COLUMNS", "80")
        .output()
        .unwrap())
    .ok();
    let help = help.text().to_owned();
    if let Some((_, list)) = help.split_once("\nCommands:\n") {
        let names = list.lines().take_while(|l| l.starts_with("  "));
        for name in names
            .filter(|l| !l.starts_with("   "))
            .filter_map(|l| l.split_whitespace().next())
        {
            helps(&[path, &[name.to_owned()]].concat(), out);
        }
    }
    out.push((path.join(" "), help));
}

/// The examples of every command's help.
fn shown_by_help() -> Vec<String> {
    let mut list = vec![];
    helps(&[], &mut list);
    let mut out = vec![];
    for (name, help) in list {
        let text = help.replace("\\\n", "");
        let shown = text
            .lines()
            .filter(|l| l.starts_with("  mckibben "))
            .map(|l| l.trim().to_owned());
        let before = out.len();
        out.extend(shown);
        let parent = help.contains("\nCommands:\n");
        assert!(
            parent || out.len() > before,
            "the help of `{name}` shows no example"
        );
    }
    out
}

#[test]
fn the_commands_in_help_texts_run() {
    let help = shown_by_help();
    assert!(help.len() >= 14, "{} examples", help.len());
    let dir = copy();
    for line in help {
        works(dir.path(), &line);
    }
    for written in ["f.svg", "muscle.svg", "winner.toml"] {
        assert!(dir.path().join(written).is_file(), "{written} is written");
    }
}

#[test]
fn the_example_muscles_are_muscles() {
    let mut count = 0;
    for entry in std::fs::read_dir(root().join("examples")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|e| e == "toml") {
            let text = std::fs::read_to_string(&path).unwrap();
            if text.contains("[joint]") {
                let pressures = if text.contains("[muscle_2]") {
                    "2bar,1bar"
                } else {
                    "2bar"
                };
                mckibben(&format!(
                    "joint {} -p {pressures} --model thick-wall",
                    path.display()
                ))
                .ok();
                continue;
            }
            if text.contains("[command]") {
                mckibben(&format!("motion {} --model thick-wall", path.display())).ok();
                continue;
            }
            mckibben(&format!("check {}", path.display())).ok();
            mckibben(&format!("force --muscle {} -p 1bar -e 5%", path.display())).ok();
            count += 1;
        }
    }
    assert!(count >= 2);
}

/// B. Tondu (2012), Fig. 3: the ideal model is off by 92–95 N.
#[test]
fn the_20_degree_muscle_is_compared_and_identified() {
    let compared = json(
        "compare --models ideal,thick-wall --muscle examples/tondu2012.toml \
         --data data/tondu2012/static_force_20deg.csv",
    );
    let ideal = &compared["models"][0];
    assert!((number(ideal, "rms_n") - 95.2).abs() < 0.5, "{ideal}");
    // Its loops' half-widths alone give C 71.5 and β 0.560 (examples/tondu2012.toml).
    let identified =
        json("identify examples/tondu2012.toml --data data/tondu2012/static_force_20deg.csv");
    for (name, alone) in [("friction.coefficient", 71.46), ("friction.exponent", 0.56)] {
        let p = identified["parameters"]
            .as_array()
            .unwrap()
            .iter()
            .find(|p| p["name"] == name)
            .unwrap();
        assert!(
            (number(p, "value") - alone).abs() <= number(p, "half_width_95"),
            "{p}"
        );
    }
    assert!(
        identified["warnings"]
            .to_string()
            .contains("follow a pattern"),
        "{identified}"
    );
}

/// The friction of the example is the fit of the measured half-widths that its comment states.
#[test]
fn the_friction_of_the_example_is_the_fit_of_its_half_widths() {
    let points = [
        (0.1, 19.6),
        (0.2, 29.1),
        (0.3, 37.6),
        (0.4, 41.0),
        (0.5, 49.2),
    ];
    let logs: Vec<(f64, f64)> = points
        .iter()
        .map(|&(p, f): &(f64, f64)| (p.ln(), f.ln()))
        .collect();
    let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / 5.0;
    let (x, y) = (mean(|q| q.0), mean(|q| q.1));
    let slope = logs.iter().map(|q| (q.0 - x) * (q.1 - y)).sum::<f64>()
        / logs.iter().map(|q| (q.0 - x).powi(2)).sum::<f64>();
    let text = std::fs::read_to_string(root().join("examples/tondu2012.toml")).unwrap();
    assert!(
        text.contains(&format!("\nexponent = {slope:.3}\n")),
        "β {slope}"
    );
    assert!(
        text.contains(&format!("\ncoefficient = {:.2}\n", (y - slope * x).exp())),
        "C {}",
        (y - slope * x).exp()
    );
}
