//! A rigid vessel: C 0.5 L/(s bar), b 0.3, V 0.2 L, supply 701 325 Pa.

use crate::{support::close, verification};
use mckibben_motion::*;

#[test]
fn limits_of_heat_transfer_are_the_adiabatic_and_the_isothermal_charge() {
    let p =
        |heat| verification::pressure(verification::after(heat, 1.0, 0.0, 0.2).as_ref()).unwrap();
    close(p(Heat::Conductance(0.0)), p(Heat::Adiabatic), 1e-9);
    close(p(Heat::Conductance(1e5)), p(Heat::Isothermal), 1e-4);
    assert!(
        p(Heat::Transfer(50.0)) < p(Heat::Adiabatic)
            && p(Heat::Transfer(50.0)) > p(Heat::Isothermal)
    );
}

#[test]
fn continuity_of_the_flow_and_its_slope_near_equal_pressures_and_its_reverse() {
    let valve = Orifice::new(0.5, 0.3).unwrap();
    let flow = |p2: f64| valve.flow((0.7, 293.15), (p2, 293.15)).mass_g_per_s;
    let slope = |p2: f64| (flow(p2 + 1e-9) - flow(p2 - 1e-9)) / 2e-9;
    let edge = 0.7 * (1.0 - LINEAR_SHARE);
    close(flow(edge - 1e-12), flow(edge + 1e-12), 1e-9);
    close(slope(edge - 1e-8), slope(edge + 1e-8), 1e-3);
    close(slope(0.7 - 1e-8), slope(0.7 + 1e-8), 1e-3);
    assert_eq!(flow(0.7), 0.0);
    let back = valve.flow((0.2, 300.0), (0.7, 293.15));
    assert_eq!(
        back.mass_g_per_s,
        -valve.flow((0.7, 293.15), (0.2, 300.0)).mass_g_per_s
    );
    assert_eq!(back.temperature_k, 293.15);
    // Choked: C p1 ρ0.
    close(flow(0.1), 0.5 * 7.0 * 1.185, 1e-12);
}

#[test]
fn two_orifices_in_series_by_their_exact_flow() {
    // Both flows equal at the pressure between them, by bisection; the rule is good to 1 % choked
    // and 3 % before it chokes.
    let pairs = [
        ((0.5, 0.3), (0.5, 0.3)),
        ((1.0, 0.25), (0.5, 0.4)),
        ((0.4, 0.3), (1.2, 0.2)),
    ];
    for (a, b) in pairs {
        let (a, b) = (
            Orifice::new(a.0, a.1).unwrap(),
            Orifice::new(b.0, b.1).unwrap(),
        );
        let whole = in_series(&[a, b]).unwrap();
        for down in [0.05, 0.5, 0.65] {
            let (mut low, mut high) = (down, 0.7);
            for _ in 0..100 {
                let mid = 0.5 * (low + high);
                let more = a.flow((0.7, 293.15), (mid, 293.15)).mass_g_per_s
                    > b.flow((mid, 293.15), (down, 293.15)).mass_g_per_s;
                if more { low = mid } else { high = mid }
            }
            let exact = a.flow((0.7, 293.15), (low, 293.15)).mass_g_per_s;
            let rule = whole.flow((0.7, 293.15), (down, 293.15)).mass_g_per_s;
            println!("{a:?} {b:?} {down}: {}", rule / exact - 1.0);
            close(rule, exact, 0.06);
        }
    }
}

#[test]
fn a_rated_flow_is_that_of_its_conductance() {
    // 1 L/(s bar), b 0.3, from 7.01325 to 6.01325 bar: Q = 60 · 7.01325 · √(1 − ((0.857413 −
    // 0.3)/0.7)²) l/min.
    let ratio: f64 = 6.01325 / 7.01325;
    let litres = 60.0 * 7.01325 * (1.0 - ((ratio - 0.3) / 0.7).powi(2)).sqrt();
    close(conductance_of_rated_flow(litres, 0.3).unwrap(), 1.0, 1e-12);
    assert_eq!(valves().len(), 6);
    let valve = valve_named("ckd-m3ga1").unwrap();
    assert_eq!(
        (
            valve.supply.conductance_l_per_s_bar,
            valve.exhaust.critical_ratio
        ),
        (0.86, 0.19)
    );
}
