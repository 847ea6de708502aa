//! What an answer promises: its ± belongs to what was asked, and what is said to be sure is.

use crate::common::{folder, json, mckibben, number, root, run_in};
use std::fs;

/// u/(∂F/∂P) and u/(K L0) by hand from the keys of the same answer.
#[test]
fn an_inverse_has_the_uncertainty_of_what_was_asked() {
    let p = json("pressure -F 500N -e 10% --model thick-wall");
    let half = number(&p, "uncertainty_n") / number(&p, "force_per_pressure_n_per_mpa");
    assert!((number(&p, "pressure_uncertainty_mpa") / half - 1.0).abs() < 1e-9);
    assert!(p.get("contraction_uncertainty").is_none());
    let e = json("contraction -F 200N -p 2.5bar --model thick-wall");
    let half = number(&e, "uncertainty_n") / (number(&e, "stiffness_n_per_mm") * 285.0);
    assert!((number(&e, "contraction_uncertainty") / half - 1.0).abs() < 1e-9);
    assert!(e.get("pressure_uncertainty_mpa").is_none());
    let f = json("force -p 2.5bar -e 10% --model thick-wall");
    assert!(f.get("pressure_uncertainty_mpa").is_none() && f.get("contraction_uncertainty").is_none());
    // With a load its slope counts too: the ± over the stiffness of both together.
    let l = json("contraction --load spring:12N/mm@50N -p 2.5bar --model thick-wall");
    let at = &l["loaded"]["at"][0]["equilibria"][0];
    let half = number(at, "uncertainty_n") / (number(at, "held_stiffness_n_per_mm") * 285.0);
    assert!((number(&l, "contraction_uncertainty") / half - 1.0).abs() < 1e-9);
}

/// The user's own input carries no ±.
#[test]
fn the_text_of_an_inverse_has_its_uncertainty_at_what_was_asked() {
    let line = |text: &str, name: &str| {
        let line = text.lines().find(|l| l.trim_start().starts_with(name));
        line.unwrap_or_else(|| panic!("{name}: {text}")).to_owned()
    };
    let p = mckibben("pressure -F 500N -e 10% --model thick-wall --units bar").ok();
    assert!(line(p.text(), "pressure").contains(" ± ") && line(p.text(), "pressure").contains("bar"));
    assert!(!line(p.text(), "pull ").contains('±') && !line(p.text(), "contraction").contains('±'));
    let e = mckibben("contraction -F 200N -p 2.5bar --model thick-wall").ok();
    assert!(line(e.text(), "contraction").contains(" ± "));
    assert!(!line(e.text(), "pull ").contains('±') && !line(e.text(), "pressure").contains('±'));
    let f = mckibben("force -p 2.5bar -e 10% --model thick-wall").ok();
    assert!(line(f.text(), "pull ").contains(" ± ") && !line(f.text(), "pressure").contains('±'));
    let c = mckibben("curve isotonic -F 100,200N -p 1..2.5:0.5bar --model thick-wall").ok();
    assert!(line(c.text(), "± ").contains(" %: 95 %"), "{}", c.text());
}

const BENCH: &str = "examples/bench.toml";

#[test]
fn flipped_signs_end_identify_with_their_lines() {
    let dir = folder();
    let rises =
        "pressure_bar,contraction,force_n\n1,0,247\n1,0.05,300\n2,0,483\n2,0.05,500\n3,0,700\n3,0.1,900\n";
    let negative = "pressure_bar,contraction,force_n\n1,0,-247\n1,0.05,-150\n2,0,-483\n2,0.05,-300\n3,0,-724\n3,0.1,-300\n";
    fs::write(dir.path().join("rises.csv"), rises).unwrap();
    fs::write(dir.path().join("negative.csv"), negative).unwrap();
    let muscle = root().join(BENCH).display().to_string();
    for (file, said) in
        [("rises.csv", "sign of the contraction flipped"), ("negative.csv", "sign of the force flipped")]
    {
        let ran = run_in(
            dir.path(),
            &["identify", &muscle, "--data", file, "--model", "thick-wall", "--format", "json"],
        );
        assert_eq!(ran.code, 2, "{}", ran.err);
        let error = ran.error()["message"].as_str().unwrap_or_default().to_owned();
        assert!(error.contains(said) && error.contains("lines 2, 3"), "{error}");
    }
}

/// The ± of an identified muscle: on its bench that of the fit, elsewhere and of another muscle the general one.
#[test]
fn an_identified_muscle_has_the_uncertainty_of_its_bench() {
    let dir = folder();
    let file = |name: &str| root().join(name).display().to_string();
    let (muscle, data) = (file(BENCH), file("examples/bench.csv"));
    run_in(dir.path(), &["identify", &muscle, "--data", &data, "-o", "found.toml"]).ok();
    let force = |more: &[&str]| {
        let words = [&["force", "--muscle", "found.toml", "--format", "json"], more].concat();
        run_in(dir.path(), &words).ok().json()
    };
    let inside = force(&["-p", "3bar", "-e", "8%"]);
    let outside = force(&["-p", "4bar", "-e", "8%"]);
    let wider = force(&["-p", "3bar", "-e", "8%", "-D", "21"]);
    // Noise of 4 N: t(8) √(1 + …) times as much.
    assert!((9.0..16.0).contains(&number(&inside, "uncertainty_n")), "{inside}");
    assert!(number(&inside["uncertainty_parts_n"], "fit") > 9.0);
    assert!(number(&outside, "uncertainty_n") > 60.0 && number(&wider, "uncertainty_n") > 60.0);
    let warned = |a: &serde_json::Value| a["warnings"].to_string().contains("[identified]");
    assert!(warned(&wider) && !warned(&inside));
    // A formula is no bench.
    run_in(
        dir.path(),
        &["identify", "--formula", "paper", "--free", "c10", "--model", "thick-wall", "-o", "paper.toml"],
    )
    .ok();
    assert!(!fs::read_to_string(dir.path().join("paper.toml")).unwrap().contains("[identified]"));
}

/// The number that `design` names, asked for: its lower bound is what was wanted.
#[test]
fn what_design_says_to_ask_for_is_sure() {
    let line = "design -F 700N -e 15% -p 2.5bar --continuous --model thick-wall --verify none";
    let first = json(line);
    let ask = number(&first["to_be_sure"]["points"][0], "force_n");
    assert!(ask > 800.0 && ask == ask.round(), "{ask}");
    let sure = json(&line.replace("700N", &format!("{ask}N")));
    let half = number(&sure["candidates"][0], "uncertainty_n");
    assert!(ask - half >= 700.0 && ask - half < 710.0, "{ask} ± {half}");
    let text = mckibben(line).ok();
    assert!(
        text.text().contains(&format!("to cover 700 N with the ±, design for {ask} N")),
        "{}",
        text.text()
    );
}

/// The ± of where a hanging mass comes to rest is that of `contraction` with the same load, by hand from its keys: ±F/(K L0).
#[test]
fn the_end_of_a_motion_has_the_uncertainty_of_its_equilibrium() {
    let muscle = root().join("examples/prototype.toml").display().to_string();
    let words = |more: &[&str]| {
        let common = ["--muscle", &muscle, "--load", "mass:20kg", "-p", "2bar", "--model", "thick-wall"];
        [more, &common].concat().into_iter().map(str::to_owned).collect::<Vec<_>>()
    };
    let drive = ["--valve", "0.5 L/(s bar)", "--damping", "3000 N s/m", "--until", "4s"];
    let ask = |list: Vec<String>, format: &[&str]| {
        let list: Vec<&str> = list.iter().map(String::as_str).chain(format.iter().copied()).collect();
        run_in(folder().path(), &list).ok()
    };
    let motion = ask(words(&[&["motion"], &drive[..]].concat()), &["--format", "json"]).json();
    let still = ask(words(&["contraction"]), &["--format", "json"]).json();
    let at = &still["loaded"]["at"][0]["equilibria"][0];
    let half = number(at, "uncertainty_n") / (number(at, "held_stiffness_n_per_mm") * 285.0);
    assert!((number(&motion, "end_contraction_uncertainty") / half - 1.0).abs() < 1e-9, "{half}");
    assert_eq!(motion["at_rest"], true);
    let text = ask(words(&[&["motion"], &drive[..]].concat()), &[]);
    let line = text.text().lines().find(|l| l.contains("ends at")).unwrap().to_owned();
    assert!(line.contains(" ± ") && line.contains('%'), "{line}");
    assert!(text.text().contains("of the pull ± "), "{}", text.text());
    // What a controller corrects, and what lies on a stop, has none.
    let position = json("motion examples/elbow-drive.toml --model universal");
    assert!(number(&position, "end_angle_uncertainty_deg") > 0.0);
}

/// The breakdown is one text: in JSON, in the terminal, of a joint and of a curve.
#[test]
fn every_uncertainty_says_what_it_consists_of() {
    let line = "force -p 0.25 -e 10% --model thick-wall";
    let words = json(line)["uncertainty_words"].clone();
    let text = words["text"].as_str().unwrap_or_default();
    assert!(text.starts_with("± ") && text.contains(" N (95 %): friction unknown "), "{text}");
    let flat = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let shown = flat(mckibben(line).ok().text());
    assert!(shown.contains(text), "{shown}");
    let bench = words["bench"].as_str().unwrap_or_default();
    assert!(
        bench.starts_with("10 points on both branches at 0.1 MPa and 0.25 MPa would leave about ± "),
        "{bench}"
    );
    assert!(shown.contains(bench) && number(&words, "bench_uncertainty_n") > 0.0);
    let joint = json("joint examples/elbow.toml -p 2bar,1bar --angle 0,20deg --model thick-wall");
    let text = joint["uncertainty_text"].as_str().unwrap_or_default();
    assert!(text.starts_with("at φ ") && text.contains(" N m (95 %): friction unknown "), "{text}");
    assert!(number(&joint["points"][0], "stiffness_uncertainty_nm_per_rad") > 0.0);
    let curve = mckibben("curve isobaric -p 1bar,2bar -e 0..0.2:0.05 --model thick-wall").ok();
    assert!(curve.text().contains("(95 %): friction unknown "), "{}", curve.text());
}
