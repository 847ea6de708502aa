mod any;

use super::*;
use crate::{
    muscle::{
        measures::{END_FACTOR, MEASURES},
        *,
    },
    rubber::{
        Gent, Law, MooneyRivlin, NeoHookean, Ogden, Yeoh, library,
        over_time::{OgdenRoxburgh, Prony},
    },
};
use any::muscle;
use proptest::prelude::*;

proptest! {
    /// What a saved number loses is rounding: what is read is off by 1e-15, and is written as the same
    /// text.
    #[test]
    fn what_is_written_reads_back_as_the_same_muscle(muscle in muscle()) {
        let text = to_toml(&muscle);
        let read = parse_muscle(&text).map_err(|e| format!("{e}\n{text}")).unwrap();
        prop_assert_eq!(to_toml(&read), text.clone());
        prop_assert_eq!(parse_muscle(&text.replace('\n', "\r\n")).map_err(|e| e.to_string()), Ok(read.clone()));
        for measure in MEASURES {
            let (Some(ours), Some(theirs)) = (muscle.measure(measure), read.measure(measure)) else {
                prop_assert_eq!(muscle.measure(measure), read.measure(measure), "{}", measure.key);
                continue;
            };
            // One that follows the pressure is the difference of two numbers.
            let most = if measure.key == END_FACTOR.key { 1e-12 } else { 5.2e-15 };
            prop_assert!((ours - theirs).abs() <= most * ours.abs(), "{} {} {}", measure.key, ours, theirs);
        }
        let constants = |m: &Muscle| m.tube().rubber.law.values();
        for (ours, theirs) in constants(&muscle).iter().zip(constants(&read)) {
            // Those of a named rubber follow the stretch that the muscle reaches.
            prop_assert!((ours - theirs).abs() <= 1e-11 * ours.abs(), "{ours} {theirs} {text}");
        }
        let values = text.lines().filter_map(|line| line.split_once(" = ")?.1.split(" #").next());
        for word in values.flat_map(|v| v.split(|c: char| !(c.is_ascii_digit() || ".eE-+".contains(c)))) {
            let mantissa = word.split(['e', 'E']).next().unwrap().trim_start_matches(['-', '0', '.']);
            let digits = mantissa.chars().filter(char::is_ascii_digit).count();
            prop_assert!(digits <= 17, "{} in {}", word, text);
        }
    }

    #[test]
    fn no_text_makes_it_panic(text in any::<String>()) {
        let _ = parse_muscle(&text).map_err(|e| e.to_string());
    }

    #[test]
    fn no_damage_to_a_file_makes_it_panic(
        muscle in muscle(),
        cuts in prop::collection::vec((any::<prop::sample::Index>(), 0..9usize, "\\PC{0,3}|[\\[\\]{}=\"',.#\n\r\u{0}-]{0,3}|nan|1e999"), 1..4),
    ) {
        let mut chars: Vec<char> = to_toml(&muscle).chars().collect();
        for (at, removed, added) in cuts {
            let at = at.index(chars.len());
            let end = (at + removed).min(chars.len());
            chars.splice(at..end, added.chars());
        }
        let text: String = chars.into_iter().collect();
        if let Err(error) = parse_muscle(&text) {
            let message = error.to_string();
            prop_assert!(message.len() < 2000 && !message.contains('\n'), "{}", message);
            prop_assert!(error.place.is_some(), "{}", message);
        }
    }
}

#[test]
fn nothing_written_means_the_prototype() {
    for text in [
        "",
        "\u{feff}",
        "# nothing\n",
        "[tube]\n[braid]\r\n[terminals]\n[friction]\n",
    ] {
        assert_eq!(parse_muscle(text).unwrap(), Muscle::prototype(), "{text:?}");
    }
    assert_eq!(
        parse_muscle("name = \"left leg\"\nnotes = \"first try\"\n").unwrap(),
        Muscle::prototype()
    );
}

/// The example of the documentation, with every unit and every form a value can take.
#[test]
fn every_key_is_understood() {
    let muscle = parse_muscle(
        r#"
        [tube]
        outer_diameter = "3 cm"
        wall_thickness = 3
        length = 285.0                   # between the terminals
        [tube.material]
        law = "ogden"
        mu = ["620 kPa", 0.0012, "-0.0098 MPa"]
        alpha = [1.3, 5, -2.0]
        bulk_modulus = "1.5 GPa"
        softening = { r = 1.5, m = "50 kPa" }
        conditioned = "2.5 bar"
        prony = [[0.2, "2 s"], [0.1, "3 min"]]
        [braid]
        angle = "28 deg"
        strands = 48
        strand_area = "0.3 mm2"
        strand_modulus = "2500 MPa"
        strand_strength = "40 N"
        strand_length = "340 mm"
        turns = 1.6
        compression = true
        [terminals]
        insertion = "2 cm"
        seating = "1.6 mm"
        slip = "3 mm/kN"
        grip = "4 mm"
        end_factor = { a = 0.2, b = 1 }
        [friction]
        coefficient = 61
        exponent = 0.57
        "#,
    )
    .unwrap();
    let rubber = Rubber {
        bulk: Bulk::Modulus(1500.0),
        softening: Some(OgdenRoxburgh {
            r: 1.5,
            m_mpa: 0.05,
            beta: 0.0,
        }),
        conditioned: Some(Conditioned::Pressure(0.25)),
        prony: Some(Prony::from(vec![(0.2, 2.0), (0.1, 180.0)])),
        ..Rubber::new(Law::Ogden(Ogden {
            terms: vec![(0.62, 1.3), (0.0012, 5.0), (-0.0098, -2.0)],
        }))
    };
    assert_eq!(muscle.tube().rubber, rubber);
    let strands = Strands::new(48, Some((0.3, 2500.0)), Some(40.0));
    assert_eq!(muscle.braid().strands, Some(strands));
    assert_eq!(muscle.braid().stiffness, BraidStiffness::OfStrands);
    assert!(muscle.braid().compression);
    let measured = MeasuredStrand {
        strand_length_mm: 340.0,
        turns: 1.6,
    };
    assert_eq!(muscle.braid().measured, Some(measured));
    let terminals = Terminals {
        made: None,
        insertion_mm: Some(20.0),
        seating_mm: Some(1.6),
        slip_mm_per_n: Some(0.003),
        grip_mm: Some(4.0),
        plug_diameter_mm: None,
        pull_off_n: None,
        rated_pressure_mpa: None,
        end_factor: Some(EndFactor::OfPressure { a: 0.2, b: 1.0 }),
    };
    assert_eq!(muscle.terminals(), &terminals);
    assert_eq!(muscle.friction(), Some(&Friction::power_law(61.0, 0.57)));
    // A count beside a stiffness only informs; dotted keys and inline tables are TOML like any
    // other.
    let muscle = parse_muscle("braid.stiffness = \"inextensible\"\nbraid.strands = 96\n").unwrap();
    assert_eq!(muscle.braid().stiffness, BraidStiffness::Inextensible);
    let muscle = parse_muscle("tube = { rubber = \"Dragon Skin 30:mooney-rivlin\" }").unwrap();
    assert_eq!(
        muscle.tube().rubber.fitted_to_stretch,
        Some(1.05 * muscle.reach())
    );
}

/// What users see and keep; a change of this text is a change of the format.
#[test]
fn the_prototype_is_written_for_people() {
    let text = format!(
        r#"# McKibben muscle, written by mckibben {}.
# A number without unit is in mm, MPa, N, N/mm, mm2 or degrees.
#:schema muscle.schema.json

[tube]
outer_diameter = "30 mm"         # Outer diameter D0 of the tube at rest
wall_thickness = "3 mm"          # Wall thickness s of the tube at rest
length = "285 mm"                # Length L0 between the terminals at rest
rubber = "antonelli2018"         # or [tube.material] with a law and its constants

[braid]
angle = "28 deg"                 # Angle θ0 of the strands to the axis at rest
stiffness = "antonelli2018"      # Stiffness k of one strand family
"#,
        env!("CARGO_PKG_VERSION")
    );
    assert_eq!(to_toml(&Muscle::prototype()), text);
}

/// Beside a stiffness the area of a strand still says what openings are between them; the modulus is
/// what a file may not say.
#[test]
fn beside_a_stiffness_the_area_of_a_strand_is_kept() {
    let strands = Strands::new(48, Some((0.3, 2500.0)), None);
    let braid = Braid {
        strands: Some(strands),
        ..Braid::paper()
    };
    let text = to_toml(&Muscle::prototype().with_braid(braid).unwrap());
    let read = parse_muscle(&text).unwrap().braid().strands.unwrap();
    assert_eq!(read.area_mm2, Some(0.3), "{text}");
    assert_eq!(read.modulus_mpa, None, "{text}");
}

/// A named sleeve gives angle and strands, stays a name, and says only what it does not say by
/// itself.
#[test]
fn named_sleeves_are_read_and_written_by_name() {
    let read = |diameter: f64, braid: &str| {
        let text =
            format!("[tube]\nouter_diameter = {diameter}\nwall_thickness = 0.4\n[braid]\n{braid}");
        let muscle = parse_muscle(&text).unwrap();
        let written = to_toml(&muscle);
        assert_eq!(to_toml(&parse_muscle(&written).unwrap()), written);
        (muscle, written)
    };
    let (muscle, text) = read(2.0, "name = \"SM20\"\nstrand_modulus = \"5 GPa\"");
    assert!((muscle.braid().angle_deg - 18.0).abs() < 1e-12);
    let strands = muscle.braid().strands.unwrap();
    assert_eq!((strands.count, strands.modulus_mpa.unwrap()), (24, 5000.0));
    assert!(
        text.contains("name = \"s-muscle-20\"") && !text.contains("angle ="),
        "{text}"
    );
    // Its diameter is not stated by the seller; with it the number of strands follows from the
    // range.
    let (muscle, text) = read(
        12.0,
        "name = \"flexo-overexpanded-0.38in\"\nstrand_diameter = \"0.2 mm\"",
    );
    let sleeve = crate::sleeve::library::find("flexo-overexpanded-0.38in").unwrap();
    let same = sleeve
        .with_measured(None, Some(0.2), None, None)
        .on(12.0)
        .unwrap();
    assert_eq!(muscle.braid(), &same);
    assert!(
        text.contains("strands = 290") && text.contains("strand_area = "),
        "{text}"
    );
    // A counted number conflicts with the one that follows.
    let counted = "name = \"flexo-overexpanded-0.38in\"\nstrand_diameter = 0.25\nstrands = 96";
    assert_eq!(read(12.0, counted).0.braid().strands.unwrap().count, 96);
    // A stiffness beside the name is k on this tube.
    let (muscle, text) = read(
        20.0,
        "name = \"nfl-19\"\nstiffness = \"300 N/mm\"\nangle = \"31.5 deg\"",
    );
    assert_eq!(muscle.family_stiffness_n_per_mm(), Some(300.0));
    assert_eq!(muscle.braid().angle_deg, 31.5);
    assert!(
        text.contains("name = \"nfl-19\"") && text.contains("angle = \"31.5 deg\""),
        "{text}"
    );
    // An angle that the sleeve does not have is written instead of its name.
    let other = Braid {
        angle_deg: 25.0,
        ..muscle.braid().clone()
    };
    let text = to_toml(&muscle.with_braid(other).unwrap());
    assert!(
        !text.contains("nfl-19") && text.contains("angle = \"25 deg\""),
        "{text}"
    );
}

/// `strand_diameter` is a circle's: A = π d²/4.
#[test]
fn a_strand_diameter_is_a_round_cross_section() {
    let text = "[braid]\nstrands = 48\nstrand_diameter = \"0.5 mm\"\nstrand_modulus = \"2.5 GPa\"";
    let muscle = parse_muscle(text).unwrap();
    let area = std::f64::consts::PI / 16.0;
    let strands = muscle.braid().strands.unwrap();
    assert_eq!(
        strands.area_mm2.zip(strands.modulus_mpa),
        Some((area, 2500.0))
    );
    let spacing = muscle.braid().strand_spacing_mm(muscle.tube(), 48);
    let k = muscle.family_stiffness_n_per_mm().unwrap();
    assert!((k * spacing / (2500.0 * area) - 1.0).abs() < 1e-12);
    let read = parse_muscle(&to_toml(&muscle)).unwrap();
    let written = read.braid().strands.unwrap().area_mm2.unwrap();
    assert!((written / area - 1.0).abs() < 5e-15);
}

/// A named rubber stays a name, whichever of its laws is used; one whose constants were changed
/// does not.
#[test]
fn named_rubbers_are_written_by_name() {
    let with = |rubber| {
        let tube = Tube {
            rubber,
            ..Tube::prototype()
        };
        to_toml(&Muscle::prototype().with_tube(tube).unwrap())
    };
    for name in [
        "dragon-skin-30",
        "dragon-skin-30:mooney-rivlin",
        "treloar-natural-rubber:ogden",
    ] {
        let text = with(library::find(name).unwrap());
        assert!(
            text.contains(&format!("\nrubber = \"{name}\" ")) && !text.contains("law ="),
            "{text}"
        );
    }
    let rubber = library::find("dragon-skin-30").unwrap();
    let text = with(Rubber {
        law: rubber.law.scaled(2.0),
        ..rubber
    });
    assert!(
        text.contains("[tube.material]\nname = \"dragon-skin-30\""),
        "{text}"
    );
    assert!(
        text.contains("c10 = \"0.17") && text.contains("fitted_to_stretch = 2.06"),
        "{text}"
    );
}

/// The factor of a single model is in the table of this model; files from before, that have it
/// under the terminals, say the same.
#[test]
fn constants_of_models_are_read_from_both_places_and_written_to_theirs() {
    let new = "[model.tondu-lopez]\nend_factor = 1.2\n";
    let old = "[terminals]\nend_factor = 1.2\n";
    let muscle = parse_muscle(new).unwrap();
    assert_eq!(muscle, parse_muscle(old).unwrap());
    assert_eq!(
        muscle.terminals().end_factor,
        Some(EndFactor::Constant(1.2))
    );
    let text = to_toml(&muscle);
    assert!(
        text.contains("[model.tondu-lopez]\nend_factor = 1.2"),
        "{text}"
    );
    let twice = parse_muscle(&format!("{new}{old}"))
        .unwrap_err()
        .to_string();
    assert!(
        twice.contains("terminals.end_factor") && twice.contains("model.tondu-lopez.end_factor"),
        "{twice}"
    );
    let wrong = parse_muscle("[model.tondu-lopez]\nend_factor = -1\n")
        .unwrap_err()
        .to_string();
    assert!(
        wrong.contains("model.tondu-lopez.end_factor = -1"),
        "{wrong}"
    );
    assert!(parse_muscle("[model.ideal]\nend_factor = 1\n").is_err());
}

/// A muscle that is held has its remaining moduli: all at once, (1 − Σg) of them after long, and
/// energies with them; the softening keeps its shape.
#[test]
fn a_held_muscle_has_what_is_left_of_its_moduli() {
    let read = |held: &str| {
        let text = format!(
            "[tube.material]\nlaw = \"gent\"\nmu = 0.3\njm = 40\nprony = [[0.2, 2], [0.1, \"3 \
             min\"]]\nsoftening = {{ r = 1.5, m = 0.05 }}\n{held}"
        );
        parse_muscle(&text).unwrap().tube().rubber.clone()
    };
    let at_once = read("");
    let long = read("held = \"long\"");
    assert_eq!(read("held = 0").law, at_once.law);
    assert_eq!(
        long.law,
        Law::Gent(Gent {
            mu_mpa: 0.7 * 0.3,
            jm: 40.0
        })
    );
    assert_eq!(long.softening.unwrap().m_mpa, 0.7 * 0.05);
    assert_eq!((long.prony, at_once.prony.is_some()), (None, true));
    let left = 1.0 - 0.2 * (1.0 - (-30.0_f64).exp()) - 0.1 * (1.0 - (-1.0_f64 / 3.0).exp());
    let Law::Gent(Gent { mu_mpa, .. }) = read("held = \"1 min\"").law else {
        panic!()
    };
    assert!((mu_mpa / 0.3 - left).abs() < 1e-14);
}

/// A strain is a ratio with its `%`, a bare number a pressure in MPa; the largest energy is that of
/// the neo-Hookean law in simple tension, (μ/2)(λ² + 2/λ − 3).
#[test]
fn rubber_is_conditioned_by_a_pressure_or_by_a_strain() {
    let rubber = |text: &str| {
        let material =
            "[tube.material]\nlaw = \"neo-hookean\"\nmu = 0.4\nsoftening = { r = 1.5, m = 0.05 }\n";
        parse_muscle(&format!("{material}conditioned = {text}"))
            .unwrap()
            .tube()
            .rubber
            .clone()
    };
    for text in ["\"100%\"", "\"100 %\""] {
        assert_eq!(
            rubber(text).conditioned,
            Some(Conditioned::Strain { strain: 1.0 })
        );
        let (_, seen_mpa) = rubber(text).conditioned_alike().unwrap();
        assert!((seen_mpa - 0.2 * (4.0 + 1.0 - 3.0)).abs() < 1e-15);
    }
    assert_eq!(
        rubber("0.25").conditioned,
        Some(Conditioned::Pressure(0.25))
    );
    assert_eq!(rubber("\"2.5 bar\"").conditioned().map(|c| c.1), Some(0.25));
    let gent =
        "[tube.material]\nlaw = \"gent\"\nmu = 0.4\njm = 2\nsoftening = { r = 1.5, m = 0.05 }\n";
    let locked = parse_muscle(&format!("{gent}conditioned = \"100 %\"")).unwrap_err();
    assert_eq!(locked.place.map(|at| at.line), Some(6), "{locked}");
}
