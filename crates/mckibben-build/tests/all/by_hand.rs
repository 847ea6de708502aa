//! Ends, safety and mould, by hand.

use mckibben_build::{
    Ends,
    ends::{Clamped, Ferrule, Press, bolted_n},
    energy_j,
    frame::{Bar, Frame, rod_mm},
    mould::{CASTABLE, castable},
};
use mckibben_core::{
    analysis::{Burst, FailurePressure, NoBurst, SAFETY},
    muscle::EndsMade,
};

/// By hand: two ties of 4.8 mm hold 2 · 2π · 0.3 · 180/3 = 226 N, a quarter of it is 56.5 N. A
/// clamp of 9 mm on 26 mm over 3 mm of μ 0.4 MPa: 0.3 π 26 · 9 · 4 · 0.4 · 0.25 = 88.2 N, bonded
/// (S = 1.5) 3.25 times as much.
#[test]
fn by_hand_ends_hold_their_proof_or_are_of_another_kind() {
    let tube = Clamped {
        bore_mm: 20.0,
        wall_mm: 3.0,
        sleeve_mm: 0.5,
        mu_mpa: 0.4,
        diameter_mm: 26.0,
    };
    // By the load in use, of which the proof is twice as much.
    let ends = |load_n: f64| Ends::new([2.0 * load_n; 2], tube, None);
    let tied = ends(56.0);
    assert_eq!((tied.made, tied.at_each_end), (EndsMade::Tied, 2));
    assert!((tied.holds_n[0] - 226.2).abs() < 0.05);
    assert_eq!(
        (ends(57.0).made, ends(57.0).at_each_end),
        (EndsMade::Tied, 3)
    );
    let clamped = ends(96.0);
    assert_eq!(clamped.made, EndsMade::Clamped);
    let [low, high] = clamped.holds_n;
    assert!((low - 88.22).abs() < 0.01 && (high / low - 3.25).abs() < 1e-9);
    assert_eq!(ends(501.0).made, EndsMade::Crimped);
    // Twice 144 N is above what one clamp holds at best, 287 N; twice 287 N above that of two.
    assert_eq!([143.0, 144.0].map(|n| ends(n).at_each_end), [1, 2]);
    assert_eq!(ends(286.0).made, EndsMade::Clamped);
    assert!(matches!(ends(287.0).press, Some(Press::Ferrule(_))));
    let stated = Ends::new([192.0; 2], tube, Some(EndsMade::Tied));
    assert!(!stated.bear(192.0));
    let narrow = Clamped {
        bore_mm: 4.0,
        wall_mm: 1.0,
        diameter_mm: 6.8,
        ..tube
    };
    let narrow = Ends::new([120.0; 2], narrow, None);
    assert!(matches!(narrow.press, Some(Press::Ferrule(_))));
    assert_eq!(narrow.band(), "cable tie");
    let stated = Ends::new([900.0; 2], tube, Some(EndsMade::Clamped));
    assert!(!stated.bear(900.0));
}

/// By hand: 15 N m on M8 are 15/(0.2 · 0.008) = 9375 N, and 2π · 0.15 · 9375 = 8836 N with little
/// friction.
#[test]
fn by_hand_a_wide_shoulder_has_clamps_with_a_bolt_for_the_proof_test() {
    let tube = Clamped {
        bore_mm: 80.0,
        wall_mm: 4.0,
        sleeve_mm: 0.5,
        mu_mpa: 0.2,
        diameter_mm: 90.0,
    };
    let press = |load_n: f64| Ends::new([2000.0, load_n], tube, None).press;
    assert_eq!(press(8800.0), Some(Press::BoltClamps(1)));
    assert_eq!(press(9000.0), Some(Press::BoltClamps(2)));
    let [low, high] = bolted_n();
    assert!((low - 8835.7).abs() < 0.1 && (high - 2.0 * low).abs() < 1e-9);
}

/// By hand: 0.5 L at 6 bar gauge, 0.701325 MPa · 500 000 mm³ = 350.66 J, ln(6.92154) =
/// 1.934638, together 678.4 J.
#[test]
fn the_energy_of_air_is_that_of_an_isothermal_expansion() {
    assert!(
        (energy_j(0.6, 5e5) - 678.4).abs() < 0.05,
        "{}",
        energy_j(0.6, 5e5)
    );
    assert_eq!(energy_j(0.0, 5e5), 0.0);
}

#[test]
fn a_proof_is_half_of_the_burst_where_the_working_pressure_is_a_quarter_of_it() {
    let burst = |strained: FailurePressure| Burst {
        mesh: FailurePressure::at(1.0),
        strained,
        ..Burst::unknown(NoBurst::NO_ANSWER)
    };
    let free = burst(FailurePressure::None);
    assert_eq!(free.highest_proof_mpa(1.0 / SAFETY), 0.5);
    // A tube may work at half of its burst pressure, and is not proved at all of it.
    assert_eq!(free.highest_proof_mpa(0.5), 0.75);
    // Between both a relief valve has room: a tenth.
    assert!(!Burst::is_proof(free.highest_proof_mpa(0.69), 0.69));
    let strained = burst(FailurePressure::at(0.6));
    assert_eq!(strained.highest_proof_mpa(0.5), 0.6);
    assert!(Burst::is_proof(0.6, 0.5) && !Burst::is_proof(0.6, 0.55));
}

/// The rows of the maker's bulletins; a gap is none.
#[test]
fn the_table_has_what_makers_state_and_keeps_gaps() {
    let of = |name: &str| castable(name).map(|r| (r.pot_life_min, r.cure_h));
    assert_eq!(of("dragon-skin-30"), Some((45.0, 16.0)));
    assert_eq!(of("ecoflex-00-50"), Some((18.0, 3.0)));
    assert_eq!(of("mold-star-20t"), None);
    let rows = CASTABLE.lines().filter(|line| !line.starts_with('#'));
    for row in rows.skip(1) {
        let name = row.split(',').next().unwrap_or_default();
        assert!(mckibben_core::rubber::library::entry(name).is_ok(), "{row}");
    }
}

/// By hand, of E235+N at 235 MPa: 2 mm by 14 mm carry 6580 N around, and hold 2π · 0.15 · 6580 =
/// 6201.5 N to twice as much. 12.2 kN ask for 12 200/442.96 = 27.5 mm of it. Over 30.5 mm with a
/// sleeve of 1 mm the next bore is 31 mm; pressed to a bore of 30 mm, π (35² − 31²)/4 of steel lie
/// within √(30² + 264) = 34.12 mm.
#[test]
fn by_hand_a_ferrule_is_as_long_as_the_proof_asks() {
    let ferrule = Ferrule {
        outer_mm: 35.0,
        wall_mm: 2.0,
        length_mm: 14.0,
        pressed_mm: 34.0,
    };
    let [low, high] = ferrule.holds_n();
    assert!((low - 6201.5).abs() < 0.1 && (high - 2.0 * low).abs() < 1e-9);
    let over = Clamped {
        bore_mm: 20.0,
        wall_mm: 3.0,
        sleeve_mm: 1.0,
        mu_mpa: 0.4,
        diameter_mm: 30.5,
    };
    let chosen = Ferrule::new(over, 12_200.0);
    assert_eq!(
        [chosen.outer_mm, chosen.wall_mm, chosen.length_mm],
        [35.0, 2.0, 28.0]
    );
    assert!((chosen.pressed_mm - 34.12).abs() < 0.01, "{chosen:?}");
    assert!(chosen.pressed_mm < chosen.outer_mm);
    for load_n in [100.0, 1000.0, 5000.0, 20_000.0] {
        for diameter_mm in [3.0, 8.0, 17.3, 39.9, 60.0] {
            let ferrule = Ferrule::new(
                Clamped {
                    diameter_mm,
                    ..over
                },
                load_n,
            );
            assert!(ferrule.holds_n()[0] >= load_n, "{ferrule:?}");
            assert!(ferrule.outer_mm - 2.0 * ferrule.wall_mm >= diameter_mm + 0.3);
        }
    }
}

/// By hand, at 1000 N: a bar of 10 × 4 mm with a hole of 4.5 mm, its rods 50 mm beside the muscle, has M =
/// 12 500 N mm on 4 (10³ − 4.5³)/60 = 60.59 mm³; a bridge of 20 × 3 mm with a hole of 9 mm, 28 mm long on
/// bars of 4 mm, 3000 N mm on 11 · 9/6 = 16.5 mm³. A rod M6 of 250 mm buckles at π³ 210 000 · 4.71⁴/(64 ·
/// 250²) = 801 N, M8 at 2532 N: 500 N, three times, ask for M8.
#[test]
fn by_hand_the_frame_bears_the_proof() {
    let bar = Bar {
        width_mm: 10.0,
        thick_mm: 4.0,
        reach_mm: 50.0,
    };
    let frame = Frame {
        bar,
        bar_length_mm: 130.0,
        bridge_mm: [28.0, 20.0, 3.0],
        rod_mm: 8.0,
        rod_length_mm: 290.0,
    };
    for (stress, mpa) in [
        (bar.stress(4.0, 1000.0), 206.30),
        (frame.stress(1000.0), 181.82),
    ] {
        assert!((stress.mpa - mpa).abs() < 0.01, "{stress:?}");
        assert_eq!(stress.yields_mpa, 235.0);
    }
    assert_eq!([500.0, 260.0].map(|n| rod_mm(n, 250.0)), [8.0, 6.0]);
    // A short one yields: 640/1.1 MPa on 4.71 mm are 10 137 N.
    assert_eq!([10_100.0, 10_200.0].map(|n| rod_mm(n, 10.0)), [6.0, 8.0]);
}
