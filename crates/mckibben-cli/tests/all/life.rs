//! `life`: its quantities are those of `force`, its cycles those of the rubber's own curve.

use crate::common::{folder, json, mckibben, number, run_in};

/// A muscle whose openings are described: 96 strands of 0.25 mm, four on a carrier.
const WOVEN: &str = r#"[tube]
outer_diameter = "20 mm"
wall_thickness = "2 mm"
length = "200 mm"
rubber = "nbr-50"

[braid]
angle = "25 deg"
strands = 96
strand_area = "0.0491 mm2"
strand_modulus = "8500 MPa"
strands_per_carrier = 4
"#;

/// Across commands: states are those of `force` and `contraction`, to the last digit.
#[test]
fn quantities_are_those_of_the_points_of_the_cycle() {
    let dir = folder();
    std::fs::write(dir.path().join("woven.toml"), WOVEN).unwrap();
    let json = |line: &str| {
        let words: Vec<&str> = line.split_whitespace().chain(["--format", "json"]).collect();
        run_in(dir.path(), &words).json()
    };
    let answer = json("life woven.toml -p 0.5..2bar -e 2%,15%");
    let one = &answer["muscles"][0];
    for (state, point) in [("low", "-p 0.5bar -e 2%"), ("high", "-p 2bar -e 15%")] {
        let force = json(&format!("force woven.toml {point}"));
        for key in ["force_n", "strand_tension_n", "braid_tension_n", "middle_stretch", "max_stretch"] {
            assert_eq!(one[state][key], force[key], "{state} {key}");
        }
    }
    let (low, high) = (&one["low"], &one["high"]);
    let range = number(high, "strand_tension_n") - number(low, "strand_tension_n");
    assert_eq!(number(&one["range"], "strand_tension_n"), range.abs());
    assert!(number(high, "between_strands_stretch") > number(high, "middle_stretch"));
    assert!(number(high, "clear_distance_mm") > number(low, "clear_distance_mm"));
    // Within the half muscle, by finite elements.
    assert!(number(high, "max_stretch_from_terminal_mm") <= 100.0);
    assert!(number(one, "friction_work_per_lever_n") > 0.0 && one["friction_work_j"].is_null());
    assert!(one["least_rubber_cycles"].is_null(), "no number of cycles without a curve");
    assert_eq!(answer["measured"].as_array().unwrap().len(), 4);
    assert_eq!(answer["measures"].as_array().unwrap().len(), 9);
}

#[test]
fn a_load_sets_the_contractions_and_stands_on_its_stop_before_it_is_lifted() {
    let answer = json("life examples/prototype.toml -p 0..2.5bar --load mass:20kg --model thick-wall");
    let loaded = json("contraction examples/prototype.toml -p 2.5bar --load mass:20kg --model thick-wall");
    let one = &answer["muscles"][0];
    assert_eq!(number(&one["high"], "contraction"), number(&loaded, "contraction"));
    assert_eq!((number(&one["low"], "contraction"), number(&one["low"], "energy_density_mpa")), (0.0, 0.0));
    let free = json("life examples/prototype.toml -p 1..2.5bar --model thick-wall");
    let unloaded = json("contraction examples/prototype.toml -p 1bar --model thick-wall");
    assert_eq!(number(&free["muscles"][0]["low"], "contraction"), number(&unloaded, "contraction"));
}

/// ln N is linear in ln λ between the points of examples/life-curve.csv, and there is no number beyond them.
#[test]
fn cycles_come_from_the_curve_alone_and_end_with_it() {
    let dir = folder();
    let write = |text: &str| std::fs::write(dir.path().join("curve.csv"), text).unwrap();
    let ask = |more: &str| {
        let line = format!(
            "life -D 30 -s 2 -p 0..2bar -e 0,15% --model thick-wall --life-curve curve.csv {more} --format json"
        );
        run_in(dir.path(), &line.split_whitespace().collect::<Vec<_>>()).json()
    };
    write("stretch,cycles\n1.1,1e8\n3,1e4\n");
    let answer = ask("--scatter 4");
    let one = &answer["muscles"][0];
    let stretch = number(one, "largest_stretch");
    let expected = 1e8 * (1e-4_f64.ln() * (stretch / 1.1).ln() / (3.0_f64 / 1.1).ln()).exp();
    assert!((number(one, "rubber_cycles") / expected - 1.0).abs() < 1e-12);
    assert!((number(one, "least_rubber_cycles") * 4.0 / expected - 1.0).abs() < 1e-12);
    write("stretch,cycles\n2.5,1e6\n3,1e4\n");
    let answer = ask("");
    let one = &answer["muscles"][0];
    assert!(one["rubber_cycles"].is_null());
    let cause = one["cause"].as_str().unwrap();
    assert!(cause.contains("reaches from 2.5 to 3"), "{cause}");
    write("energy density [MPa],cycles\n0.001,1e8\n10,1e3\n");
    let answer = ask("");
    let w = number(&answer["muscles"][0]["range"], "energy_density_mpa");
    let expected = 1e8 * (1e-5_f64.ln() * (w / 0.001).ln() / 1e4_f64.ln()).exp();
    assert!((number(&answer["muscles"][0], "rubber_cycles") / expected - 1.0).abs() < 1e-12);
}

#[test]
fn muscles_are_compared_in_one_cycle() {
    let text = mckibben(
        "life examples/biceps.toml -p 0.5..3bar -e 0,10% --beside examples/prototype.toml --model thick-wall",
    )
    .ok();
    let text = text.text();
    for said in [
        "muscle 2 (examples/prototype.toml)",
        "range 2/1",
        "at least 1.20e8 cycles",
        "swaged",
        "at most 18000 cycles",
    ] {
        assert!(text.contains(said), "{said}: {text}");
    }
}

#[test]
fn a_cycle_that_is_none_is_refused() {
    for (line, said) in [
        ("life -p 1,2,3bar", "--pressure: a cycle has two pressures; 3 given"),
        ("life -p 3bar,1bar", "is no cycle of pressures"),
        (
            "life -p 1..2bar -e 0,10%,20%",
            "--contraction: a cycle has two contractions, or one for both; 3 given",
        ),
        ("life -p 1..2bar -e 0,10% --load mass:2kg", "conflicts with"),
        (
            "life --life-curve examples/life-curve.csv --scatter 0.5",
            "--scatter: the factor of scatter is 0.5",
        ),
        ("life --life-curve examples/bench.csv", "no column of stretches or energies"),
    ] {
        let found = mckibben(line);
        assert_eq!(found.code, 2, "{line}");
        assert!(found.err.contains(said), "{line}: {}", found.err);
    }
}

/// The limit is the stretch at which the curve has the cycles times their scatter: 1e5 · 3 between (1.5, 1e6) and (2, 1e5).
#[test]
fn a_design_with_a_life_stays_below_the_stretch_of_the_curve() {
    let line = "design -F 300N -e 12% -p 2.5bar -D 20..60 -s 1..4 --model thick-wall";
    let life = "--min-life 1e5 --life-curve examples/life-curve.csv --scatter 3";
    let found = json(&format!("{line} {life}"));
    let bound = 1.5 * ((2.0_f64 / 1.5).ln() * 0.3_f64.ln() / 0.1_f64.ln()).exp();
    assert!((number(&found["searched"], "life_stretch") / bound - 1.0).abs() < 1e-12);
    for candidate in found["candidates"].as_array().unwrap() {
        for point in candidate["points"].as_array().unwrap() {
            assert!(point["max_stretch"].as_f64().is_none_or(|s| s <= bound), "{point}");
        }
        assert!(number(candidate, "max_stretch") <= bound * (1.0 + 1e-9), "{candidate}");
    }
    for (more, said) in [
        ("--min-life 1e5", "life curve"),
        ("--min-life 1e5 --life-curve examples/life-curve.csv", "scatter"),
        ("--min-life 1e7 --life-curve examples/life-curve.csv --scatter 3", "3.000e7 cycles are required"),
        ("--scatter 3", "--min-life"),
        ("--min-life -1 --life-curve examples/life-curve.csv --scatter 3", "--min-life"),
    ] {
        let found = mckibben(&format!("{line} {more}"));
        assert_eq!(found.code, 2, "{more}: {}", found.err);
        assert!(found.err.contains(said), "{more}: {}", found.err);
    }
}
