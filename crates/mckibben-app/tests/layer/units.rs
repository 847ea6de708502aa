//! Units of what a user reads.

use mckibben_app::units::Units;

#[test]
fn units_show_their_definitions() {
    let u: Units = "psi, lbf, in".parse().unwrap();
    assert_eq!(u.pressure.show(0.25), "36.26 psi");
    assert_eq!(u.force.show(4.448_221_615_260_5), "1 lbf");
    assert_eq!(u.length.show(25.4), "1 in");
    assert_eq!(u.volume.show(25.4_f64.powi(3)), "1 in³");
    // 1 lbf/in is 0.175 126 8 N/mm (NIST SP 811).
    assert_eq!(u.stiffness().show(0.175_126_8), "1 lbf/in");
    assert_eq!(u.to_string(), "psi,lbf,in");
    assert!(
        "psi,stone"
            .parse::<Units>()
            .unwrap_err()
            .contains("\"stone\"")
    );
}

#[test]
fn a_typed_unit_is_the_shown_one() {
    assert_eq!(Units::typed(["2.5bar", "15 %"]).pressure.name, "bar");
    assert_eq!(Units::typed(["0..40:5psi", "70lbf"]).to_string(), "psi,lbf");
    // Nobody reads muscles in mbar or cm.
    assert_eq!(Units::typed(["2500mbar", "3cm", "0.25"]), Units::default());
}

#[test]
fn of_each_kind_the_first_unit_that_was_typed_is_shown() {
    assert_eq!(
        Units::typed(["2bar,1bar", "30psi", "1.2in"]).to_string(),
        "bar,in"
    );
    assert_eq!(Units::typed(["700lbf@15%,900N@5%"]).force.name, "lbf");
}

#[test]
fn pressures_of_sentences_are_shown_in_the_unit_and_moduli_are_not() {
    let bar: Units = "bar".parse().unwrap();
    for (sentence, shown) in [
        (
            "no pressures up to 0.25\u{a0}MPa give 3 N m",
            "no pressures up to 2.5 bar give 3 N m",
        ),
        (
            "nearest 12.5\u{a0}N at 0.095000\u{a0}MPa.",
            "nearest 12.5 N at 0.95 bar.",
        ),
        (
            "falls when it rises (-1200\u{a0}N/MPa): soft",
            "falls when it rises (-120 N/bar): soft",
        ),
        (
            "P -1e-2\u{a0}MPa to 3\u{a0}MPa, of\u{a0}MPa",
            "P -0.1 bar to 30 bar, of MPa",
        ),
        ("a modulus of 0.1 MPa", "a modulus of 0.1 MPa"),
    ] {
        assert_eq!(bar.sentence(sentence), shown);
    }
    // 1 psi is 6 894.757 Pa (NIST SP 811).
    let psi: Units = "psi".parse().unwrap();
    assert_eq!(psi.sentence("at 0.3\u{a0}MPa"), "at 43.5 psi");
    assert_eq!(psi.sentence("at 0.345\u{a0}MPa"), "at 50 psi");
    let inches: Units = "lbf,in".parse().unwrap();
    assert_eq!(
        inches.sentence("12.70\u{a0}mm at 4.448222\u{a0}N"),
        "0.5 in at 1 lbf"
    );
    assert_eq!(Units::default().sentence("at 0.3\u{a0}MPa"), "at 0.3 MPa");
}

#[test]
fn what_rounding_leaves_of_zero_is_zero() {
    let bar: Units = "bar".parse().unwrap();
    assert_eq!(bar.pressure.show(5.444e-20), "0 bar");
    assert_eq!(bar.stiffness().show(-1e-12), "0 N/mm");
    assert_eq!(bar.pressure.show(1e-4), "0.001 bar");
}

#[test]
fn bar_stay_the_decimals_that_were_typed() {
    let bar: Units = "bar".parse().unwrap();
    assert_eq!(bar.pressure.value(0.15), 1.5);
    assert_eq!(bar.stiffness().name, "N/mm");
    assert_eq!(bar.slope().value(10.0), 1.0);
}
