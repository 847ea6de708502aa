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

fn repository(name: &str) -> Plan {
    let plans = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../plans");
    Plan::parse(&std::fs::read_to_string(plans.join(name)).unwrap()).unwrap()
}

/// 4 diameters, 5 walls, 5 contractions, 26 pressures: the paper's 100 curves.
#[test]
fn the_papers_plan_has_2600_points() {
    let plan = repository("paper.toml");
    assert_eq!((plan.muscles(), plan.points_per_muscle()), (20, 130));
    let section = |i: u64| {
        let inputs = plan.inputs(i);
        (
            inputs.parts.tube.outer_diameter_mm,
            inputs.parts.tube.wall_mm,
        )
    };
    // The first axis changes slowest.
    assert_eq!(
        [section(0), section(4), section(5), section(19)],
        [(30., 1.), (30., 5.), (40., 1.), (50., 5.)]
    );
    assert_eq!(plan.testing.contractions, [0.0, 0.05, 0.1, 0.15, 0.2]);
    assert_eq!(plan.testing.pressures_mpa[25], 0.25);
    let base = Muscle::prototype();
    assert_eq!(
        plan.inputs(13).muscle().unwrap(),
        base.with_section(45.0, 4.0).unwrap()
    );
}

#[test]
fn every_muscle_of_the_universal_plan_is_one_and_spans_the_design_space() {
    let plan = repository("universal.toml");
    let all: Vec<Muscle> = (0..plan.muscles())
        .map(|i| plan.inputs(i).muscle().unwrap())
        .collect();
    let spans = |value: fn(&Muscle) -> f64, low: f64, high: f64| {
        let values: Vec<f64> = all.iter().map(value).collect();
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let most = values.iter().copied().fold(0.0, f64::max);
        assert!(
            low <= least && least < low * 1.01 && high * 0.99 < most && most <= high,
            "{least} {most}"
        );
    };
    spans(mckibben_core::muscle::Muscle::outer_diameter_mm, 10.0, 60.0);
    spans(|m| m.wall_mm() / m.outer_diameter_mm(), 0.017, 0.18500001);
    spans(|m| m.length_mm() / m.outer_diameter_mm(), 4.4, 22.000001);
    spans(|m| m.braid().angle_deg, 16.5, 39.0);
    spans(
        |m| m.family_stiffness_n_per_mm().unwrap() / m.outer_diameter_mm(),
        3.0,
        300.00001,
    );
    spans(|m| m.tube().rubber.law.values()[0], 0.03, 0.5);
    spans(
        |m| 1.0 + m.tube().rubber.law.values()[1] / m.tube().rubber.law.values()[0],
        1.0,
        1.43,
    );
}

/// A (0, m, 1)-net on each axis: of 2^m points one lies in each interval of length 2^-m; and in two
/// dimensions a (0, m, 2)-net for the first two axes: one in each elementary rectangle.
#[test]
fn sobol_points_are_a_net() {
    let plan = plan(
        "[sampling]\nmethod = \"sobol\"\nsamples = 256\nseed = 9\n[vary]\ntube.outer_diameter \
         = \"10..60\"\nbraid.angle = \"15..40\"",
    );
    let at = |i: u64| {
        let inputs = plan.inputs(i);
        (
            (inputs.parts.tube.outer_diameter_mm - 10.0) / 50.0,
            (inputs.parts.braid.angle_deg - 15.0) / 25.0,
        )
    };
    for m in 0..=8_u32 {
        let columns = 1_usize << m;
        let rows = 1_usize << (8 - m);
        let mut hits = vec![0; 256];
        for i in 0..256 {
            let (x, y) = at(i);
            let cell = |v: f64, n: usize| ((v * n as f64 + 1e-7) as usize).min(n - 1);
            hits[cell(x, columns) * rows + cell(y, rows)] += 1;
        }
        assert!(hits.iter().all(|h| *h == 1), "{columns} x {rows}: {hits:?}");
    }
}

/// More samples keep the first ones; beyond a net of the library the next one is a net of its own.
#[test]
fn a_longer_sobol_plan_begins_with_the_shorter_one_and_goes_on_with_another_net() {
    let of = |samples: u32| {
        plan(&format!(
            "[sampling]\nmethod = \"sobol\"\nsamples = {samples}\nseed = 9\n[vary]\nbraid.angle \
             = \"15..40\""
        ))
    };
    let (short, long) = (of(2000), of(131_072));
    let share = |plan: &Plan, i: u64| (plan.inputs(i).parts.braid.angle_deg - 15.0) / 25.0;
    assert!((0..2000).all(|i| share(&short, i) == share(&long, i)));
    let net = |from: u64| -> Vec<f64> { (from..from + 256).map(|i| share(&long, i)).collect() };
    for shares in [net(0), net(65_536)] {
        let mut hits = [0; 256];
        for share in shares {
            hits[((share * 256.0 + 1e-7) as usize).min(255)] += 1;
        }
        assert_eq!(hits, [1; 256]);
    }
    assert_ne!(net(0), net(65_536));
}

/// A table of muscles is what it says, in the units of its headings and fields.
#[test]
fn muscles_of_a_table_are_those_of_its_lines() {
    let table = "tube.outer_diameter [in],wall_mm,tube.rubber,braid.angle\n\
                 1,2,latex,24 deg\n1.5,3,dragon-skin-30,0.5 rad\n";
    let text = format!("[tube]\nlength = \"200 mm\"\n{TEST}");
    let plan = Plan::check(&text, Some(table)).unwrap();
    assert_eq!(
        (plan.muscles(), plan.sampling().method),
        (2, SamplingMethod::Table)
    );
    let of = |number: u64| {
        let parts = plan.inputs(number).parts;
        let (tube, angle) = (parts.tube, parts.braid.angle_deg);
        (
            tube.outer_diameter_mm,
            tube.wall_mm,
            tube.length_mm,
            tube.rubber.name,
            angle,
        )
    };
    assert_eq!(of(0), (25.4, 2.0, 200.0, Some("latex".into()), 24.0));
    let second = of(1);
    assert_eq!(second.3.as_deref(), Some("dragon-skin-30"));
    assert!((second.4 - 90.0 / std::f64::consts::PI).abs() < 1e-12);
    // Another table is another plan.
    let other = Plan::check(&text, Some(&table.replace(",2,", ",2.5,"))).unwrap();
    assert_ne!(plan.hash(), other.hash());
    for (table, said) in [
        (
            "wall_mm,colour\n2,3\n",
            "column colour: no measure of a muscle",
        ),
        (
            "wall_mm,tube.wall_thickness\n2,3\n",
            "tube.wall_thickness stands twice",
        ),
        ("wall_mm\n2 N\n", "line 2, column wall_mm: \"2 N\""),
        ("wall_mm\n-2\n", "tube.wall_thickness begins at -2"),
        ("length_mm\n200\n", "tube.length is stated: leave that out"),
    ] {
        let error = Plan::check(&text, Some(table)).unwrap_err()[0].to_string();
        assert!(
            error.starts_with("samples: ") && error.contains(said),
            "{error}"
        );
    }
}

/// What is wrong in several places is said of all, and what follows from it of none.
#[test]
fn all_mistakes_of_a_plan_are_said_at_once() {
    let text = "[tube]\nlength = \"20 cm\"\nwall_thickness = \"2 N\"\n[braid]\nangel = 20\n\
                [sampling]\nmethod = \"sobol\"\nsamples = 0\n[vary]\ntube.outer_diameter \
                = \"50..30\"\n[test]\ncontractions = \"0,10%\"\npressures = \"0..3:0.1\"\n";
    let said = Plan::check(text, None).unwrap_err();
    let keys: Vec<&str> = said.iter().filter_map(|e| e.key.as_deref()).collect();
    let wrong = [
        "tube.wall_thickness",
        "braid.angel",
        "vary.tube.outer_diameter",
        "sampling.samples",
        "test.pressures",
    ];
    assert!(wrong.iter().all(|key| keys.contains(key)), "{keys:?}");
    assert_eq!(keys.len(), wrong.len(), "{said:?}");
    let line = said
        .iter()
        .find(|e| e.key.as_deref() == Some("test.pressures"))
        .unwrap();
    assert_eq!(line.place.unwrap().line, 13);
    assert_eq!(Plan::check(TEST, None).unwrap().muscles(), 1);
}

#[test]
fn another_seed_draws_other_muscles_and_the_same_one_the_same() {
    let lengths = |seed: u32| -> Vec<f64> {
        let plan = plan(&format!(
            "[sampling]\nmethod = \"sobol\"\nsamples = 20\nseed = {seed}\n[vary]\ntube.length \
             = \"100..300\""
        ));
        let length = |i| plan.inputs(i).parts.tube.length_mm;
        (0..20).map(length).collect()
    };
    assert_eq!(lengths(4), lengths(4));
    assert_ne!(lengths(4), lengths(5));
}

/// A regression value: what a plan means must not change with a library.
#[test]
fn the_first_samples_stay_what_they_are() {
    let plan = plan(
        "[sampling]\nmethod = \"sobol\"\nsamples = 8\nseed = 1\n[vary]\ntube.length = \"100..300\"\n\
         braid.angle = \"20..30\"",
    );
    let parts = plan.inputs(0).parts;
    assert_eq!(
        (parts.tube.length_mm, parts.braid.angle_deg),
        (185.9611034, 27.4933517)
    );
}

/// Of a net of 2^m points one lies in each interval of length 2^-m: each of four levels has a
/// quarter of the muscles.
#[test]
fn levels_of_a_list_get_equal_shares_and_ratios_follow_the_diameter() {
    let plan = plan(
        "[sampling]\nmethod = \"sobol\"\nsamples = 32\n[vary]\ntube.outer_diameter = \"20,30,40,50\"\n\
         tube.length_ratio = 10\ntube.wall_ratio = \"10%\"\nbraid.stiffness_per_diameter = 5\n\
         tube.material.scale = 2",
    );
    for d in [20.0, 30.0, 40.0, 50.0] {
        let these: Vec<Inputs> = (0..32)
            .map(|i| plan.inputs(i))
            .filter(|i| i.parts.tube.outer_diameter_mm == d)
            .collect();
        assert_eq!(these.len(), 8);
        assert_eq!(
            (these[0].parts.tube.length_mm, these[0].parts.tube.wall_mm),
            (10.0 * d, 0.1 * d)
        );
        assert_eq!(these[0].family_stiffness_n_per_mm(), Some(5.0 * d));
    }
    assert_eq!(
        constants(&plan.inputs(3).parts.tube.rubber.law)[0],
        ("c10_mpa".into(), 0.224)
    );
}

#[test]
fn keys_can_be_written_as_tables_too() {
    let dotted =
        plan("[vary]\ntube.outer_diameter = \"30,40\"\ntube.material.c10 = [0.1, \"200 kPa\"]");
    let tables = plan(
        "[vary.tube]\nouter_diameter = [30, \"4 cm\"]\n[vary.tube.material]\nc10 = \"0.1,0.2 MPa\"",
    );
    assert_eq!(dotted.axes, tables.axes);
    assert_eq!(dotted.muscles(), 4);
    assert_ne!(dotted.hash(), tables.hash());
}

#[test]
fn wrong_plans_are_refused_with_place_key_and_what_is_expected() {
    let sobol = "[sampling]\nmethod = \"sobol\"\nsamples = 4\n";
    for line in include_str!("refused.tsv").lines().skip(1) {
        let mut cells = line.split('\t');
        let mut text = cells
            .next()
            .unwrap()
            .replace("\\n", "\n")
            .replace("SOBOL", sobol);
        if !text.contains("[test]") && !text.is_empty() {
            text.push_str(TEST);
        }
        let message = refused(&text).replace('\u{a0}', " ");
        for part in cells {
            assert!(message.contains(part), "{text}{message}\nlacks: {part}");
        }
    }
}

#[test]
fn parts_are_a_hundredth_of_the_plan_and_never_too_long() {
    let block = |samples: u64, test: &str| {
        let head = format!("[sampling]\nmethod = \"sobol\"\nsamples = {samples}\n");
        Plan::parse(&format!("{head}[vary]\ntube.length = \"100..200\"\n{test}"))
            .unwrap()
            .block()
    };
    assert_eq!(
        [block(20, TEST), block(1000, TEST), block(1_000_000, TEST)],
        [1, 10, 4096 / 6]
    );
    assert_eq!(
        block(10_000, &format!("{TEST}sensitivities = true\n")),
        512 / 6
    );
    assert_eq!(block(10_000, &format!("{TEST}mesh = \"2x12\"\n")), 512 / 6);
}

/// Row B38 of the trials: the law of a name followed a base muscle that nobody saw. All muscles have
/// one law under the name of their rubber: that of the muscle of the plan which stretches it most.
#[test]
fn a_named_rubber_has_the_law_of_the_muscle_that_stretches_it_most() {
    let vary = "[vary]\nbraid.angle = \"28,16,40 deg\"\n[test]\ncontractions = \"0\"\npressures = \
        \"0.1\"\n";
    for name in ["dragon-skin-30", "ecoflex-00-30", "dragon-skin-30:gent"] {
        let plan = Plan::parse(&format!("[tube]\nrubber = \"{name}\"\n{vary}")).unwrap();
        let widest = format!(
            "[tube]\nouter_diameter = 30\nwall_thickness = 3\nlength = 285\nrubber = \
             \"{name}\"\n[braid]\nangle = 16\n"
        );
        let widest = mckibben_core::muscle::file::parse_muscle(&widest).unwrap();
        for number in 0..3 {
            let muscle = plan.inputs(number).muscle().unwrap();
            assert_eq!(muscle.tube().rubber.law, widest.tube().rubber.law);
            assert_eq!(muscle.tube().rubber.name.as_deref(), Some(name));
        }
    }
}

/// The muscle that stretches the rubber most is the last of 2,000, where the first axis changes
/// slowest.
#[test]
fn the_law_of_a_large_plan_is_that_of_all_its_muscles() {
    let vary = "[vary]\nbraid.angle = \"28,16 deg\"\ntube.length = \"100..1099:1 mm\"\n[test]\n\
        contractions = \"0\"\npressures = \"0.1\"\n";
    let plan = Plan::parse(&format!("[tube]\nrubber = \"dragon-skin-30\"\n{vary}")).unwrap();
    assert_eq!(plan.muscles(), 2000);
    let widest = "[tube]\nrubber = \"dragon-skin-30\"\n[braid]\nangle = 16\n";
    let widest = mckibben_core::muscle::file::parse_muscle(widest).unwrap();
    assert_eq!(
        plan.base().unwrap().tube().rubber.law,
        widest.tube().rubber.law
    );
}

/// Every measure of the muscle varies, and each muscle is the base with that value: an identity
/// with [`Muscle::with`].
#[test]
fn every_measure_of_a_muscle_varies() {
    let [lever, coefficient] = ["friction.lever", "friction.coefficient"]
        .map(|key| mckibben_core::muscle::Measure::of_key(key).unwrap());
    for measure in mckibben_core::muscle::measures::MEASURES {
        // A presliding length needs a friction.
        let (base, stated) = match measure.key {
            "friction.presliding" => (
                Muscle::prototype().with(lever, 0.1).unwrap(),
                "[friction]\nlever = \"0.1 mm\"\n",
            ),
            // An exponent needs its coefficient.
            "friction.exponent" => (
                Muscle::prototype().with(coefficient, 7.0).unwrap(),
                "[friction]\ncoefficient = 7\n",
            ),
            _ => (Muscle::prototype(), ""),
        };
        let within = match measure.key {
            "tube.prestretch" => Some(1.02),
            "terminals.plug_diameter" => Some(base.inner_diameter_mm()),
            "braid.diameter" => Some(1.01 * base.outer_diameter_mm()),
            "braid.thickness" => Some(0.6),
            "braid.crimp" => Some(0.005),
            "braid.take_up" => Some(0.02),
            _ => measure.identify.as_ref().and_then(|i| i.start(&base)),
        };
        let value = within.or(base.measure(measure)).or(measure.default);
        let Some(value) = value else { continue };
        let text = format!(
            "{stated}[vary]\n{} = [{value}, {}]\n{TEST}",
            measure.key,
            1.05 * value + 0.01
        );
        let plan = Plan::parse(&text).unwrap_or_else(|e| panic!("{}: {e}", measure.key));
        let expected = base.with(measure, value).map_err(|e| e.to_string());
        let muscle = plan.inputs(0).muscle().map_err(|e| e.to_string());
        assert_eq!(muscle, expected, "{}", measure.key);
        let with_column = [
            "tube.outer_diameter",
            "tube.wall_thickness",
            "tube.length",
            "braid.angle",
            "braid.stiffness",
        ];
        assert_eq!(
            plan.measures().is_empty(),
            with_column.contains(&measure.key),
            "{}",
            measure.key
        );
    }
    let plan = plan("[vary]\nterminals.slip = \"0,0.001 mm/N\"\nbraid.thickness = \"0.3,0.5 mm\"");
    assert_eq!(plan.measures(), ["slip_mm_per_n", "braid_thickness_mm"]);
    assert!(
        refused(&format!("[vary]\ntube.prestretch = [0.9, 3]\n{TEST}"))
            .contains("between 0.5 and 2")
    );
    assert!(
        refused(&format!("[vary]\nterminals.slip = [-0.1, 3]\n{TEST}"))
            .contains("not be below zero")
    );
    // A count has levels, each of them even.
    assert!(
        refused(&format!("[vary]\nbraid.strands = [24, 25, 36]\n{TEST}"))
            .contains("is 25; it must be an even")
    );
    let interval = "[sampling]\nmethod = \"sobol\"\nsamples = 5\n";
    let sampled = refused(&format!(
        "[vary]\nbraid.strands = \"24..48\"\n{interval}{TEST}"
    ));
    assert!(sampled.contains("a count needs levels"), "{sampled}");
}

/// However many muscles, at most 6000 parts.
#[test]
fn ten_million_muscles_are_a_plan() {
    let plan =
        plan("[vary]\ntube.outer_diameter = \"20..50:0.01 mm\"\nbraid.angle = \"20..30:0.0025\"");
    assert!(plan.muscles() > 10_000_000 && plan.muscles().div_ceil(plan.block()) <= 6000);
}
