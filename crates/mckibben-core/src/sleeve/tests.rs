use super::*;
use crate::muscle::{Muscle, Tube};

const INCH: f64 = 25.4;

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * (1.0 + b.abs())
}

/// A sleeve with everything: 48 strands of 0.25 mm, 8530 MPa, 20° on 10 mm.
fn whole() -> Sleeve {
    let helix = Helix::at(10.0, 20.0).unwrap();
    let (least_mm, largest_mm) = helix.jams_at(12.0).unwrap();
    Sleeve {
        strands: Some(48),
        strand_diameter_mm: Some(0.25),
        strand_modulus_mpa: Some(8530.0),
        ..Sleeve::new(SleeveShape {
            name: "whole".into(),
            helix,
            least_mm,
            largest_mm,
            angle_deviation_deg: 1.6,
        })
    }
}

fn tube(outer_diameter_mm: f64) -> Tube {
    Tube {
        outer_diameter_mm,
        wall_mm: 0.5,
        ..Tube::prototype()
    }
}

#[test]
fn stiffness_times_spacing_is_that_of_a_strand_on_every_tube() {
    let sleeve = whole();
    for d in [8.0, 10.0, 15.0, 23.0] {
        let braid = sleeve.on(d).unwrap();
        let tube = tube(d);
        let k = braid.family_stiffness_n_per_mm(&tube).unwrap();
        let spacing = PI * d * braid.angle_rad().cos() / 24.0;
        assert!(close(k * spacing, 8530.0 * PI * 0.25 * 0.25 / 4.0), "{d}");
        assert!(close(k, sleeve.stiffness_n_per_mm(d).unwrap().unwrap()));
        assert!(close(
            braid.angle_rad().sin() / d,
            20f64.to_radians().sin() / 10.0
        ));
    }
}

#[test]
fn at_54_7_degrees_no_contraction_is_left() {
    let shape = whole().shape;
    let neutral = shape.helix.diameter_mm(NEUTRAL_ANGLE_DEG);
    let left = |d: f64| shape.largest_contraction_on(d).unwrap();
    assert!(left(neutral * (1.0 - 1e-12)).abs() < 1e-9);
    assert!(left(10.0) > left(15.0));
    // As the ideal muscle: 1 − 1/(√3 cosθ0).
    let ideal = Muscle::prototype().with_braid(crate::muscle::Braid {
        angle_deg: 20.0,
        ..crate::muscle::Braid::paper()
    });
    assert!(close(left(10.0), ideal.unwrap().max_ideal_contraction()));
    assert!(close(shape.tubes_mm().1, neutral));
}

/// Strands that jam before 54.7° end the contraction there.
#[test]
fn jammed_strands_end_the_contraction_before() {
    let helix = Helix::at(10.0, 40.0).unwrap();
    let shape = SleeveShape {
        name: "dense".into(),
        helix,
        least_mm: 9.0,
        largest_mm: helix.diameter_mm(50.0),
        angle_deviation_deg: 1.6,
    };
    let expected = 1.0 - 50f64.to_radians().cos() / 40f64.to_radians().cos();
    assert!(close(shape.largest_contraction_on(10.0).unwrap(), expected));
}

/// The pantograph of a muscle runs along the helix of its sleeve.
#[test]
fn a_contracted_muscle_lies_on_the_helix_of_its_sleeve() {
    let sleeve = whole();
    let muscle = Muscle::prototype()
        .with_tube(tube(10.0))
        .unwrap()
        .with_braid(sleeve.on(10.0).unwrap())
        .unwrap();
    for contraction in [0.05, 0.15, 0.3] {
        let d = muscle.pantograph_diameter_mm(contraction);
        let angle = sleeve.shape.helix.angle_deg(d).unwrap().to_radians();
        assert!(close(
            angle.cos(),
            (1.0 - contraction) * muscle.braid().angle_rad().cos()
        ));
    }
}

#[test]
fn a_muscle_of_a_sleeve_has_another_angle_on_another_tube() {
    let sleeve = whole();
    let muscle = Muscle::prototype()
        .with_tube(tube(10.0))
        .unwrap()
        .with_braid(sleeve.on(10.0).unwrap())
        .unwrap();
    assert!(close(muscle.braid().angle_deg, 20.0));
    let wider = muscle.with_section(15.0, 0.5).unwrap();
    assert_eq!(wider.braid(), &sleeve.on(15.0).unwrap());
    assert!(wider.family_stiffness_n_per_mm() < muscle.family_stiffness_n_per_mm());
    // Wall and length do not change it, nor an angle that was measured on it.
    let measured = muscle
        .braid()
        .clone()
        .with_stated_angle(20.3, 10.0)
        .unwrap();
    let measured = muscle.with_braid(measured).unwrap();
    assert!(close(
        measured.with_section(10.0, 0.7).unwrap().braid().angle_deg,
        20.3
    ));
    let error = muscle.with_section(40.0, 0.5).unwrap_err();
    assert!(
        error.fields == ["braid.name", "tube.outer_diameter"],
        "{error}"
    );
    let error = muscle
        .braid()
        .clone()
        .with_stated_angle(20.6, 10.0)
        .unwrap_err();
    let said = error.to_string();
    assert!(
        said.contains("20.6 deg") && said.contains("20.00 deg"),
        "{said}"
    );
}

#[test]
fn a_tube_outside_of_the_range_is_told_both_bounds() {
    let shape = library::find("nfl-19").unwrap().shape;
    let message = |d| shape.angle_deg_on(d).unwrap_err().to_string();
    for d in [14.9, 35.1, 0.0, -3.0, f64::NAN, f64::INFINITY] {
        assert!(
            message(d).contains("15\u{a0}mm") && message(d).contains("35\u{a0}mm"),
            "{}",
            message(d)
        );
    }
    assert!(
        message(34.0).contains("63.24 deg")
            && message(34.0).contains("15\u{a0}mm")
            && message(34.0).contains("31.0913\u{a0}mm"),
        "{}",
        message(34.0)
    );
}

/// By hand, of PET: n w = 2π·15·35/√(15² + 35²) = 86.63 mm, 346.5 strands of 0.25 mm; 407 MPa on
/// 0.049087 mm² are 19.98 N.
#[test]
fn what_is_not_stated_is_an_estimate_and_can_be_given() {
    let sleeve = library::find("nfl-19").unwrap();
    assert_eq!(
        sleeve.estimated,
        [
            "strand_diameter",
            "strand_modulus",
            "strands_per_carrier",
            "strand_strength"
        ]
    );
    assert_eq!(
        (sleeve.strand_count(), sleeve.stiffness_factor()),
        (Some(346), 3.0)
    );
    let braid = sleeve.on(20.0).unwrap();
    let strands = braid.strands.unwrap();
    assert_eq!((strands.count, braid.stiffness_factor), (346, 3.0));
    assert!((strands.strength_n.unwrap() - 19.98).abs() < 0.01);
    // Twice as thick: four times the strength; the modulus is still an estimate.
    let thick = sleeve.clone().with_measured(None, Some(0.5), None, None);
    assert!((thick.strand_strength_n.unwrap() - 79.92).abs() < 0.01);
    assert_eq!(
        (thick.estimated.clone(), thick.stiffness_factor()),
        (
            vec!["strand_modulus", "strands_per_carrier", "strand_strength"],
            3.0
        )
    );
    // Measured: the rest is that the strands may not touch all along.
    let measured = sleeve
        .clone()
        .with_measured(None, Some(0.25), Some(8530.0), None);
    assert_eq!(
        (measured.strand_count(), measured.stiffness_factor()),
        (Some(346), 1.25)
    );
    assert_eq!(
        measured
            .with_measured(Some(300), None, None, Some(30.0))
            .stiffness_factor(),
        1.0
    );
    let thin = library::find("s-muscle-20").unwrap();
    assert_eq!(thin.estimated, ["strand_modulus", "strand_strength"]);
    assert_eq!(
        thin.with_measured(None, None, Some(5e3), None)
            .on(2.0)
            .unwrap()
            .strands
            .unwrap()
            .count,
        24
    );
}

/// The aramid sock is sold for 3 to 6 in; who bought it writes that one orders up to twice the
/// tube's length for the widest tube (rocketreviews.com, review 230703004941). Its helix comes from
/// the range alone; the lengths were not used.
#[test]
fn the_range_of_the_sock_gives_the_shortening_that_its_buyers_report() {
    let entry = library::entry("kevlar-sock").unwrap();
    let helix = entry.sleeve.shape.helix;
    let along = |d: f64| helix.angle_deg(d).unwrap().to_radians().cos();
    let order = along(entry.nominal_mm.unwrap()) / along(6.0 * INCH);
    assert!((order / 2.0 - 1.0).abs() < 0.05, "{order}");
    // 12 in of a 3 in tube take more than 12 and less than 13 in ("at least an extra inch", with
    // what hangs over).
    let order = 12.0 * along(entry.nominal_mm.unwrap()) / along(3.0 * INCH);
    assert!(order > 12.0 && order < 13.0, "{order}");
}

/// The thin muscle contracts by 20 to 25 % (the same table); its helix allows 39 %.
#[test]
fn every_sleeve_of_the_library_makes_a_muscle_somewhere() {
    let entries = library::entries().unwrap();
    assert!(entries.len() >= 10);
    for entry in entries {
        let name = entry.sleeve.name();
        let (least, largest) = entry.sleeve.shape.tubes_mm();
        assert!(least < largest, "{name}");
        let middle = 0.5 * (least + largest);
        let sleeve = entry.sleeve.clone();
        let modulus = sleeve.strand_modulus_mpa.or(Some(5e3));
        let diameter = sleeve.strand_diameter_mm.or(Some(0.2));
        let braid = sleeve
            .with_measured(None, diameter, modulus, None)
            .on(middle)
            .unwrap();
        assert!(Muscle::prototype().with_braid(braid).is_ok(), "{name}");
        assert_eq!(library::find(name).unwrap(), entry.sleeve);
        assert!(
            entry.source.contains("http") || entry.source.contains("Cable Sleeve"),
            "{name} has no source"
        );
        if let (true, Some(nominal)) = (entry.helix_from.contains("angle"), entry.nominal_mm) {
            assert!(
                close(entry.sleeve.shape.angle_deg_on(nominal).unwrap(), 18.0),
                "{name}"
            );
        }
    }
    let thin = library::find("s-muscle-20").unwrap().shape;
    assert!((thin.largest_contraction_on(2.0).unwrap() - 0.393).abs() < 1e-3);
}

#[test]
fn materials_are_what_their_sources_say() {
    let modulus = |name| {
        library::materials()
            .unwrap()
            .iter()
            .find(|m| m.name == name)
            .unwrap()
            .modulus_mpa
    };
    // 70 g/den at 1.38 g/cm³: 1 gf/den = 9.80665e-3 N · 9000 m/g.
    let grams_per_denier = 9.806_65e-3 * 9e3 * 1.38;
    assert!((modulus("pet") / (70.0 * grams_per_denier) - 1.0).abs() < 1e-3);
    // 28e6 psi.
    assert!((modulus("stainless-steel") / (28e6 * 0.006_894_757) - 1.0).abs() < 1e-3);
    for material in library::materials().unwrap() {
        assert!(
            material.source.contains("http") || material.source.contains('['),
            "{}",
            material.name
        );
    }
}

/// By hand: 3-4-5, ℓ = π √(6² + 8²) = 10π; the family's 8 mm is that of 4.8 to 14.4 mm.
#[test]
fn two_diameters_are_a_sleeve_and_a_family_has_its_sizes() {
    let own = library::find("pet: 6..8 mm").unwrap();
    assert!(close(
        own.shape.helix.strand_length_per_turn_mm(),
        10.0 * PI
    ));
    assert_eq!((own.name(), own.diameters()), ("pet:6..8mm", (6.0, 8.0)));
    let mut family = library::find("pet-sleeve-8").unwrap();
    let same = library::find("pet:4.8..14.4mm").unwrap();
    assert_eq!((family.factor, same.factor), (3.0, 2.5));
    // Nor is the range of a family that of a sleeve.
    assert_eq!((family.count_factor, same.count_factor), (2.0, 1.25));
    (family.factor, family.count_factor) = (same.factor, same.count_factor);
    family.shape.name.clone_from(&same.shape.name);
    assert_eq!(family, same);
    let mine =
        library::read("[[sleeve]]\nname = \"mine\"\nleast_diameter = 6\nlargest_diameter = 8\n")
            .unwrap();
    assert_eq!(
        mine[0].sleeve.stiffness_n_per_mm(7.0),
        own.stiffness_n_per_mm(7.0)
    );
}

#[test]
fn names_are_forgiving_and_slips_are_named() {
    assert_eq!(
        library::find("NFL 19").unwrap(),
        library::find("nfl-19").unwrap()
    );
    assert_eq!(library::find("em20").unwrap().name(), "s-muscle-20");
    let message = |name| library::find(name).unwrap_err().to_string();
    assert_eq!(
        message("nfl-18"),
        "there is no sleeve named \"nfl-18\" (did you mean nfl-19?)"
    );
    assert!(message("concrete").contains("known: s-muscle-13, "));
}

/// The braid `antonelli2018` belongs to muscles of 30 to 50 mm; beyond, and on no other braid, there
/// is a sentence.
#[test]
fn the_papers_braid_beyond_its_diameters_is_a_warning() {
    let at = |d| Muscle::prototype().with_section(d, 2.0).unwrap().warnings();
    for d in [30.0, 40.0, 50.0] {
        assert!(at(d).is_empty(), "{d}");
    }
    for d in [10.0, 29.9, 50.1] {
        assert_eq!(at(d).len(), 1, "{d}");
        assert!(
            at(d)[0].contains("30\u{a0}mm") && at(d)[0].contains(&format!("{d}\u{a0}mm")),
            "{:?}",
            at(d)
        );
    }
    let named = Muscle::prototype()
        .with_section(10.0, 1.0)
        .unwrap()
        .with_braid(whole().on(10.0).unwrap());
    assert!(named.unwrap().warnings().is_empty());
}

/// By hand: a sleeve that closes to 30 and opens to 90 mm lies at 18.4° at its least diameter; 716
/// strands of PET (1380 kg/m³) of 0.25 mm have 716 · 0.0491 mm² · 1380 kg/m³ / cos 18.4° = 51.1 g/m.
/// Half of the mass is half of the strands. A flat width of 15 mm is a diameter of 30 mm/π.
#[test]
fn by_hand_the_mass_of_a_metre_gives_the_number_of_strands() {
    let sleeve = |keys: &str| {
        let text = format!("[[sleeve]]\nname = \"mine\"\n{keys}");
        library::read(&text).unwrap().remove(0).sleeve
    };
    let range = "least_diameter = 30\nlargest_diameter = 90\n";
    let count = |grams: f64| {
        let strands = sleeve(&format!("{range}grams_per_metre = {grams}")).strands;
        f64::from(strands.unwrap())
    };
    assert!((count(51.1) / 716.0 - 1.0).abs() < 5e-3, "{}", count(51.1));
    assert!(
        (count(25.55) / 358.0 - 1.0).abs() < 7e-3,
        "{}",
        count(25.55)
    );
    let flat = sleeve("least_flat_width = 15\nlargest_flat_width = \"40 mm\"");
    assert!(close(flat.shape.least_mm, 30.0 / PI) && close(flat.shape.largest_mm, 80.0 / PI));
    let unknown = format!("[[sleeve]]\nname = \"n\"\nmaterial = \"x\"\n{range}grams_per_metre = 5");
    let refused = library::read(&unknown).unwrap_err();
    assert!(refused.to_string().contains("density"), "{refused}");
}
