//! The proof test, and muscles that are filled with a liquid.

use crate::files::{operating, plan_from, plan_of, pull, texts};
use mckibben_build::{Plan, Wishes, paper};
use mckibben_core::{
    analysis::{FailureMode, STRETCH},
    clean,
    muscle::file::parse_muscle,
};

/// By hand: P·A of the bore alone is what a free muscle puts on its ends; held it pulls too. 0.5 MPa on
/// a bore of 7 mm are 19.24 N, 300 N with it 319.24 N; in use 165 N and 0.275 MPa are 175.58 N,
/// stretched 175 N and 185.58 N: 1.818 and 1.720 times.
#[test]
fn by_hand_the_proof_test_loads_the_ends_with_the_stretched_muscle() {
    let plan = plan_of(10.0, 1.5, &Wishes::default());
    let loads = plan.loads;
    for (is, should) in [
        (loads.proof_end_load_n, 319.242),
        (loads.end_load_n, 175.583),
        (loads.proof_to_use, 1.818),
        (loads.proof_to_stretched, 1.720),
    ] {
        assert!((is - should).abs() < 1e-3, "{is} {should}");
    }
    let warnings = plan.warnings().join("\n");
    for said in [
        "NOT INCLUDE the ends",
        "176 N in use",
        "1.82 times as much",
        "1.72 times",
    ] {
        assert!(warnings.contains(said), "{said}: {warnings}");
    }
    // 200 mm and 12 mm on each plug, stretched by 4 mm.
    let paper = paper(&plan).to_html("").unwrap();
    let (steps, record) = paper.split_once("<h2>Record").unwrap();
    assert!(steps.contains("228 mm") && record.contains("228 mm"));
}

/// A proof that the burst pressure lowers to 1.19 times the load in use is refused with the pressure
/// that would give 1.2; one at 1.2 is not, nor one at twice the working pressure.
#[test]
fn a_proof_that_says_little_of_the_ends_is_refused() {
    let plan = |proof_mpa: f64, times: f64| {
        let muscle = parse_muscle("[braid]\nangle = 30\n").unwrap();
        let mut operating = operating(&muscle, 0.25);
        let pulled = |mpa: f64, load_n: f64| {
            let bore_n = mckibben_core::analysis::burst::ends::clamp_load_n(&muscle, 0.0, mpa);
            pull(mpa, -STRETCH, load_n - bore_n)
        };
        operating.in_use = pulled(0.275, 1000.0);
        operating.stretched = operating.in_use;
        operating.proof = pulled(proof_mpa, times * 1000.0);
        Plan::new(muscle, operating, &Wishes::default())
    };
    let refused = plan(0.3, 1.19).unwrap_err();
    assert_eq!(refused.fields, ["pressure_mpa"], "{refused}");
    // By hand 0.25 · 1.19/1.2 = 0.2479.
    assert!(refused.message.contains("work at 0.24 MPa"), "{refused}");
    // Above 1.2 it is said up to 1.5: 0.25 · 1.201/1.5 = 0.2002.
    let said = |plan: Plan| plan.warnings().join("\n");
    let little = said(plan(0.3, 1.201).unwrap());
    assert!(
        little.contains("less than 1.5; work at 0.2 MPa"),
        "{little}"
    );
    assert!(!said(plan(0.3, 1.501).unwrap()).contains("less than"));
    assert!(!said(plan(0.5, 1.19).unwrap()).contains("less than"));
}

/// Of a muscle that works at 0.25 MPa and bursts at 0.4 MPa or not known: 0.3 MPa are three quarters
/// of that; below it strands limit the proof.
#[test]
fn a_low_proof_says_what_limits_it() {
    let muscle = parse_muscle("[braid]\nangle = 30\n").unwrap();
    let refused = |burst_mpa: Option<f64>, strained_mpa: Option<f64>, proof_mpa: f64| {
        let mut operating = operating(&muscle, 0.25);
        operating.limits.burst_pressure_mpa = burst_mpa;
        operating.limits.burst_by = burst_mpa.map(|_| FailureMode::Bladder);
        operating.strained_mpa = strained_mpa;
        operating.proof = pull(proof_mpa, -STRETCH, operating.in_use.force_n);
        let plan = Plan::new(muscle.clone(), operating, &Wishes::default());
        plan.unwrap_err().message
    };
    let burst = "three quarters of the least burst pressure, at which the rubber tears, allow a";
    let strained = "strands that are stretched to their limit allow a proof test of";
    let borne = "three quarters of what strands and ends bear, stretched by 2 %, allow a proof";
    for (message, said) in [
        (refused(Some(0.4), None, 0.3), burst),
        (refused(Some(0.4), Some(0.35), 0.3), burst),
        (refused(Some(0.8), Some(0.3), 0.3), strained),
        (refused(None, Some(0.3), 0.3), strained),
        (refused(Some(0.8), Some(0.35), 0.3), borne),
        (refused(None, None, 0.3), borne),
    ] {
        assert!(message.starts_with(said), "{message}");
    }
}

/// The liquid of a job is written and read back, and bleeds and tests the muscle as `liquid` does.
#[test]
fn a_muscle_whose_job_names_a_liquid_is_built_for_it() {
    let plan = |job: &str| {
        let text = format!("[tube]\nouter_diameter = 10\nwall_thickness = 1.5\n[job]\n{job}");
        plan_from(&text, &Wishes::default())
    };
    let wet = plan("pressure = \"2.5 bar\"\nliquid = \"water\"\n");
    assert!(wet.liquid && wet.eye_plug.port.is_some());
    // Its texts name the liquid; of air they speak where it must go.
    assert_eq!(wet.fluid(), "water");
    for (name, text) in texts(&wet) {
        let text = text.to_lowercase();
        assert!(
            !text.contains("air plug") && !text.contains("air-plug"),
            "{name}"
        );
        assert!(!text.contains("with air:"), "{name}");
    }
    let all = texts(&wet);
    let has = |name: &str, what: &str| all.iter().any(|f| f.0 == name && f.1.contains(what));
    assert!(has("bom.csv", "\nwater plug,") && has("README.md", "bodies/water-plug."));
    assert!(
        has("build.html", "Push the water plug into") && has("build.html", "Leak test with water:")
    );
    let text = mckibben_core::muscle::file::to_toml(&wet.muscle);
    let job = parse_muscle(&text).unwrap().job().unwrap().clone();
    assert_eq!(job.liquid.as_deref(), Some("water"));
    let dry = plan("pressure = \"2.5 bar\"\n");
    assert!(!dry.liquid && dry.eye_plug.port.is_none());
    assert_eq!(dry.fluid(), "air");
    let wishes = Wishes {
        liquid: true,
        ..Wishes::default()
    };
    assert_eq!(plan_of(10.0, 1.5, &wishes).fluid(), "liquid");
}

/// An end that slips flies off whatever fills the muscle: rubber and strands store energy too. Only
/// what is in it is spoken of.
#[test]
fn the_first_page_speaks_of_what_fills_the_muscle_and_of_the_line_of_fire() {
    for liquid in [false, true] {
        let wishes = Wishes {
            liquid,
            ..Wishes::default()
        };
        let plan = plan_of(10.0, 1.5, &wishes);
        assert_eq!(plan.safety.air_energy_j.is_none(), liquid);
        let (_, readme) = texts(&plan)
            .into_iter()
            .find(|(name, _)| name == "README.md")
            .unwrap();
        for said in [
            "keep everyone out of the line of the muscle",
            &clean::markdown(&plan.energy()),
        ] {
            assert!(readme.contains(said), "{liquid}: {readme}");
        }
        assert_eq!(readme.contains("the air stores"), !liquid, "{readme}");
        assert_eq!(readme.contains("bleed it"), liquid, "{readme}");
    }
}

#[test]
fn a_muscle_that_no_clamp_holds_is_refused() {
    let plan = |insertion_mm: f64| {
        let text = format!("[terminals]\ninsertion = {insertion_mm}\n");
        let muscle = parse_muscle(&text).unwrap();
        let operating = operating(&muscle, 0.25);
        Plan::new(muscle, operating, &Wishes::default())
    };
    assert!(plan(40.0).is_ok());
    let refused = plan(2.9).unwrap_err();
    assert_eq!(refused.fields, ["insertion_mm"], "{refused}");
    let refused = plan(20.0).unwrap_err();
    assert_eq!(refused.fields, ["insertion_mm"], "{refused}");
}
