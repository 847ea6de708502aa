//! Plans that are read, and plans that are refused with the place and what is expected.

use super::*;
use std::path::Path;

const TEST: &str = "[test]\ncontractions = \"0,10%\"\npressures = \"0..0.2:0.1\"\n";

fn plan(text: &str) -> Plan {
    Plan::parse(&format!("{text}\n{TEST}")).unwrap()
}

fn refused(text: &str) -> String {
    Plan::parse(text).map_or_else(|e| e.to_string(), |_| "is read".into())
}

fn repository(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../plans").join(name)
}

/// 4 diameters, 5 walls, 5 contractions, 26 pressures: the paper's 100 curves.
#[test]
fn the_papers_plan_has_2600_points() {
    let plan = Plan::read(repository("paper.toml")).unwrap();
    assert_eq!((plan.muscles(), plan.points_per_muscle(), plan.points()), (20, 130, 2600));
    let section = |i: u64| {
        let inputs = plan.inputs(i);
        (inputs.parts.tube.outer_diameter_mm, inputs.parts.tube.wall_mm)
    };
    // The first axis changes slowest.
    assert_eq!(
        [section(0), section(4), section(5), section(19)],
        [(30., 1.), (30., 5.), (40., 1.), (50., 5.)]
    );
    assert_eq!(plan.testing.contractions, [0.0, 0.05, 0.1, 0.15, 0.2]);
    assert_eq!(plan.testing.pressures_mpa[25], 0.25);
    let base = Muscle::prototype();
    assert_eq!(plan.inputs(13).muscle().unwrap(), base.with_section(45.0, 4.0).unwrap());
}

#[test]
fn every_muscle_of_the_universal_plan_is_one_and_spans_the_design_space() {
    let plan = Plan::read(repository("universal.toml")).unwrap();
    let all: Vec<Muscle> = (0..plan.muscles()).map(|i| plan.inputs(i).muscle().unwrap()).collect();
    let spans = |of: fn(&Muscle) -> f64, low: f64, high: f64| {
        let values: Vec<f64> = all.iter().map(of).collect();
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let most = values.iter().copied().fold(0.0, f64::max);
        assert!(low <= least && least < low * 1.01 && high * 0.99 < most && most <= high, "{least} {most}");
    };
    spans(|m| m.outer_diameter_mm(), 10.0, 60.0);
    spans(|m| m.wall_mm() / m.outer_diameter_mm(), 0.017, 0.18500001);
    spans(|m| m.length_mm() / m.outer_diameter_mm(), 4.4, 22.000001);
    spans(|m| m.braid().angle_deg, 16.5, 39.0);
    spans(|m| m.family_stiffness_n_per_mm().unwrap() / m.outer_diameter_mm(), 3.0, 300.00001);
    spans(|m| m.tube().rubber.law.values()[0], 0.03, 0.5);
    spans(|m| 1.0 + m.tube().rubber.law.values()[1] / m.tube().rubber.law.values()[0], 1.0, 1.43);
}

#[test]
fn a_latin_hypercube_hits_each_stratum_once() {
    for samples in [1_u64, 7, 100, 1000] {
        let head = format!("[sampling]\nmethod = \"latin-hypercube\"\nsamples = {samples}\nseed = 3\n");
        let plan = plan(&format!(
            "{head}[vary]\ntube.outer_diameter = \"10..60 mm\"\ntube.wall_ratio = \"2..20% log\"\nbraid.angle = \"15..40\""
        ));
        let shares: [fn(&Inputs) -> f64; 3] = [
            |i| (i.parts.tube.outer_diameter_mm - 10.0) / 50.0,
            |i| (i.parts.tube.wall_mm / i.parts.tube.outer_diameter_mm / 0.02).ln() / 10f64.ln(),
            |i| (i.parts.braid.angle_deg - 15.0) / 25.0,
        ];
        for share in shares {
            let mut hits = vec![0; samples as usize];
            for number in 0..samples {
                let at = share(&plan.inputs(number)) * samples as f64;
                hits[(at + 1e-6).floor().min(samples as f64 - 1.0) as usize] += 1;
            }
            // Rounding to ten digits may carry a value over an edge.
            let wrong = hits.iter().filter(|h| **h != 1).count();
            assert_eq!(wrong, 0, "{samples}: {hits:?}");
        }
    }
}

/// A (0, m, 1)-net on each axis: of 2^m points one lies in each interval of length 2^-m; and in two dimensions a
/// (0, m, 2)-net for the first two axes: one in each elementary rectangle.
#[test]
fn sobol_points_are_a_net() {
    let plan = plan(
        "[sampling]\nmethod = \"sobol\"\nsamples = 256\nseed = 9\n[vary]\ntube.outer_diameter = \"10..60\"\nbraid.angle = \"15..40\"",
    );
    let at = |i: u64| {
        let inputs = plan.inputs(i);
        ((inputs.parts.tube.outer_diameter_mm - 10.0) / 50.0, (inputs.parts.braid.angle_deg - 15.0) / 25.0)
    };
    for m in 0..=8_u32 {
        let (columns, rows) = (1_usize << m, 1_usize << (8 - m));
        let mut hits = vec![0; 256];
        for i in 0..256 {
            let (x, y) = at(i);
            let cell = |v: f64, n: usize| ((v * n as f64 + 1e-7) as usize).min(n - 1);
            hits[cell(x, columns) * rows + cell(y, rows)] += 1;
        }
        assert!(hits.iter().all(|h| *h == 1), "{columns} x {rows}: {hits:?}");
    }
}

/// A regression value: what a plan means must not change with a library.
#[test]
fn the_first_samples_stay_what_they_are() {
    let of = |method: &str| {
        let plan = plan(&format!(
            "[sampling]\nmethod = \"{method}\"\nsamples = 8\nseed = 1\n[vary]\ntube.length = \"100..300\"\nbraid.angle = \"20..30\""
        ));
        let inputs = plan.inputs(0);
        (inputs.parts.tube.length_mm, inputs.parts.braid.angle_deg)
    };
    assert_eq!([of("latin-hypercube"), of("sobol")], GOLD);
}

const GOLD: [(f64, f64); 2] = [(228.8163174, 25.85303634), (185.9611034, 27.4933517)];

#[test]
fn levels_of_a_list_get_equal_shares_and_ratios_follow_the_diameter() {
    let plan = plan(
        "[sampling]\nmethod = \"latin-hypercube\"\nsamples = 30\n[vary]\ntube.outer_diameter = \"20,30,40\"\ntube.length_ratio = 10\ntube.wall_ratio = \"10%\"\nbraid.stiffness_per_diameter = 5\ntube.material.scale = 2",
    );
    for d in [20.0, 30.0, 40.0] {
        let these: Vec<Inputs> =
            (0..30).map(|i| plan.inputs(i)).filter(|i| i.parts.tube.outer_diameter_mm == d).collect();
        assert_eq!(these.len(), 10);
        assert_eq!((these[0].parts.tube.length_mm, these[0].parts.tube.wall_mm), (10.0 * d, 0.1 * d));
        assert_eq!(these[0].family_stiffness_n_per_mm(), Some(5.0 * d));
    }
    assert_eq!(constants(&plan.inputs(3).parts.tube.rubber.law)[0], ("c10_mpa".into(), 0.224));
}

#[test]
fn keys_can_be_written_as_tables_too() {
    let dotted = plan("[vary]\ntube.outer_diameter = \"30,40\"\ntube.material.c10 = [0.1, \"200 kPa\"]");
    let tables =
        plan("[vary.tube]\nouter_diameter = [30, \"4 cm\"]\n[vary.tube.material]\nc10 = \"0.1,0.2 MPa\"");
    assert_eq!(dotted.axes, tables.axes);
    assert_eq!(dotted.muscles(), 4);
    assert_ne!(dotted.hash(), tables.hash());
}

/// The plan, and what must stand in the message; `line` is where.
#[test]
fn wrong_plans_are_refused_with_place_key_and_what_is_expected() {
    let lhs = "[sampling]\nmethod = \"latin-hypercube\"\nsamples = 4\n";
    let cases: &[(&str, &[&str])] = &[
        ("", &["test.contractions is missing", "0..20:5%"]),
        ("[test]\ncontractions = 0\n", &["line 1", "test.pressures is missing"]),
        (
            "[vary]\ntube.wall = \"1,2\"\n",
            &["line 2, column 6", "vary.tube.wall: unknown key", "wall_thickness"],
        ),
        ("[vary]\nbraid.angel = 28\n", &["vary.braid.angel", "did you mean", "angle"]),
        ("[vary]\nrubber = \"paper\"\n", &["vary.rubber: unknown key", "tube, braid"]),
        ("[varied]\ntube.length = 3\n", &["varied: unknown key", "vary"]),
        ("[sampling]\nsample = 3\n", &["sampling.sample: unknown key", "did you mean samples?"]),
        ("[sampling]\nmethod = \"sobel\"\n", &["line 2, column 10", "\"sobel\"", "did you mean sobol?"]),
        ("[sampling]\nmethod = 3\n", &["is a number", "factorial, latin-hypercube, sobol"]),
        ("[sampling]\nsamples = 3\n", &["sampling.samples = 3", "neither samples nor a seed"]),
        (
            "[sampling]\nmethod = \"sobol\"\n[vary]\ntube.length = \"1..2\"\n",
            &["sampling.samples is missing"],
        ),
        ("[sampling]\nmethod = \"sobol\"\nsamples = 65537\n", &["whole number up to 65536"]),
        ("[sampling]\nmethod = \"latin-hypercube\"\nsamples = 1000001\n", &["whole number up to 1000000"]),
        ("[sampling]\nmethod = \"sobol\"\nsamples = 2.5\n", &["whole number"]),
        ("[sampling]\nmethod = \"sobol\"\nsamples = 0\n", &["above zero"]),
        ("[sampling]\nmethod = \"sobol\"\nsamples = 4\nseed = -1\n", &["sampling.seed = -1", "whole number"]),
        ("LHS\n", &["needs something to vary"]),
        ("[vary]\ntube.length = \"100..200\"\n", &["\"100..200\"", "without a step", "factorial"]),
        ("[vary]\ntube.length = \"200..100:10\"\n", &["is reversed"]),
        ("[vary]\ntube.length = \"1..2 bar\"\n", &["is a pressure; expected a length"]),
        ("[vary]\ntube.length = \"0,100\"\n", &["begins at 0; it must be above zero"]),
        ("LHS[vary]\ntube.length = \"100,200 log\"\n", &["is a list, and `log` goes with a range"]),
        ("LHS[vary]\ntube.material.c01 = \"0..1 log\"\n", &["begins at 0"]),
        ("[vary]\nbraid.angle = \"20,60\"\n", &["reaches 60 deg", "54.7356"]),
        ("[vary]\ntube.wall_ratio = \"10%,50%\"\n", &["reaches 0.5", "no bore"]),
        (
            "[vary]\ntube.material.mu = \"0.1,0.2\"\n",
            &["not a constant of the mooney-rivlin law", "c10, c01"],
        ),
        (
            "[vary]\ntube.wall_thickness = 1\ntube.wall_ratio = \"5%\"\n",
            &["vary either this or tube.wall_thickness"],
        ),
        ("[vary]\ntube.wall_thickness = \"20,30\"\n", &["line 1", "makes no muscle", "20 mm"]),
        (
            "[vary]\ntube.length = \"1..1000:0.01\"\ntube.outer_diameter = \"20..80:0.1\"\n",
            &["more than 20000000"],
        ),
        ("[vary]\ntube.length = true\n", &["is true or false"]),
        ("[tube]\nouter_diamter = 3\n", &["tube.outer_diamter", "did you mean"]),
        ("[tube]\nwall_thickness = \"40 mm\"\n", &["line 2", "tube.wall_thickness"]),
        ("[test]\ncontractions = \"0..20\"\npressures = 1\n", &["without a step"]),
        ("[test]\ncontractions = 15\npressures = 0.1\n", &["contains 15", "between 0 and 0.9"]),
        ("[test]\ncontractions = 0\npressures = \"-0.1,0\"\n", &["contains -0.1 MPa"]),
        ("[test]\ncontractions = []\npressures = 0\n", &["is an empty list"]),
        (
            "[test]\ncontractions = 0\npressures = 1\nmodel = \"paper\"\n",
            &["\"paper\"", "finite-element model: fe or fe3d"],
        ),
        ("[test]\ncontractions = 0\npressures = 1\nmodel = \"fe3d\"\nmesh = \"2x0x8\"\n", &["around is 0"]),
        (
            "[test]\ncontractions = 0\npressures = 1\nmodel = \"fe3d\"\nsensitivities = true\n",
            &["fe3d has none"],
        ),
        ("[test]\ncontractions = 0\npressures = 1\nmesh = \"2by8\"\n", &["\"2by8\"", "2x8"]),
        ("[test]\ncontractions = 0\npressures = 1\nmesh = \"0x8\"\n", &["through is 0"]),
        (
            "[test]\ncontractions = 0\npressures = 1\nsensitivities = \"yes\"\n",
            &["true or false, without quotes"],
        ),
        ("[test]\ncontractions = \"0..0.5:0.001\"\npressures = \"0..1:0.001\"\n", &["more than 100000"]),
        ("[vary\n", &["not valid TOML", "line 1"]),
    ];
    let mut wrong = vec![];
    for (text, wanted) in cases {
        let mut text = text.replace("LHS", lhs);
        if !text.contains("[test]") && !text.is_empty() {
            text.push_str(TEST);
        }
        let message = refused(&text);
        for part in *wanted {
            if !message.contains(part) {
                wrong.push(format!("{text}{message}\nlacks: {part}\n"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_plan_file_is_named_in_its_errors() {
    let error = Plan::read("nowhere/plan.toml").unwrap_err().to_string();
    assert!(error.starts_with("nowhere/plan.toml: cannot be read"), "{error}");
}

#[test]
fn parts_are_a_hundredth_of_the_plan_and_never_too_long() {
    let of = |samples: u64, test: &str| {
        let head = format!("[sampling]\nmethod = \"latin-hypercube\"\nsamples = {samples}\n");
        Plan::parse(&format!("{head}[vary]\ntube.length = \"100..200\"\n{test}")).unwrap().block()
    };
    assert_eq!([of(20, TEST), of(1000, TEST), of(1_000_000, TEST)], [1, 10, 4096 / 6]);
    assert_eq!(of(10_000, &format!("{TEST}sensitivities = true\n")), 512 / 6);
    assert_eq!(of(10_000, &format!("{TEST}mesh = \"2x12\"\n")), 512 / 6);
}

/// All rows of a plan have the law of the base muscle, whatever a muscle of their measures would have by name.
#[test]
fn a_plan_has_one_rubber() {
    let text = "[tube]\nrubber = \"dragon-skin-30\"\n[vary]\nbraid.angle = \"16,28,40 deg\"\n[test]\ncontractions = \"0\"\npressures = \"0.1\"\n";
    let plan = Plan::parse(text).unwrap();
    let law = &plan.base.tube().rubber.law;
    for number in 0..3 {
        let muscle = plan.inputs(number).muscle().unwrap();
        assert_eq!(muscle.tube().rubber.law, *law);
    }
}

/// Every measure of the muscle varies, and each muscle is the base with that value: an identity with [`Muscle::with`].
#[test]
fn every_measure_of_a_muscle_varies() {
    let lever = mckibben::muscle::Measure::of_field("friction_lever_mm").unwrap();
    for measure in mckibben::muscle::measures::MEASURES {
        // A presliding length needs a friction.
        let (base, stated) = match measure.key {
            "friction.presliding" => {
                (Muscle::prototype().with(lever, 0.1).unwrap(), "[friction]\nlever = \"0.1 mm\"\n")
            }
            _ => (Muscle::prototype(), ""),
        };
        let value = measure
            .identify
            .as_ref()
            .and_then(|i| i.start(&base))
            .or(base.measure(measure))
            .or(measure.default);
        let Some(value) = value else { continue };
        let text = format!("{stated}[vary]\n{} = [{value}, {}]\n{TEST}", measure.key, 1.05 * value + 0.01);
        let plan = Plan::parse(&text).unwrap_or_else(|e| panic!("{}: {e}", measure.key));
        let expected = base.with(measure, value).map_err(|e| e.to_string());
        let found = plan.inputs(0).muscle().map_err(|e| e.to_string());
        assert_eq!(found, expected, "{}", measure.key);
        let own =
            ["tube.outer_diameter", "tube.wall_thickness", "tube.length", "braid.angle", "braid.stiffness"];
        assert_eq!(plan.measures().len(), usize::from(!own.contains(&measure.key)), "{}", measure.key);
    }
    let plan = plan("[vary]\nterminals.slip = \"0,0.001 mm/N\"\nbraid.thickness = \"0.3,0.5 mm\"");
    assert_eq!(plan.measures(), ["slip_mm_per_n", "braid_thickness_mm"]);
    assert!(refused(&format!("[vary]\ntube.prestretch = [0.9, 3]\n{TEST}")).contains("between 0.5 and 2"));
    assert!(refused(&format!("[vary]\nterminals.slip = [-0.1, 3]\n{TEST}")).contains("zero or above"));
    // A count has levels, each of them even.
    assert!(refused(&format!("[vary]\nbraid.strands = [24, 25, 36]\n{TEST}")).contains("reaches 25"));
    let interval = "[sampling]\nmethod = \"latin-hypercube\"\nsamples = 5\n";
    let sampled = refused(&format!("[vary]\nbraid.strands = \"24..48\"\n{interval}{TEST}"));
    assert!(sampled.contains("a count needs levels"), "{sampled}");
}

/// However many muscles, at most 6000 parts.
#[test]
fn ten_million_muscles_are_a_plan() {
    let plan = plan("[vary]\ntube.outer_diameter = \"20..50:0.01 mm\"\nbraid.angle = \"20..30:0.0025\"");
    assert!(plan.muscles() > 10_000_000 && plan.muscles().div_ceil(plan.block()) <= 6000);
}
