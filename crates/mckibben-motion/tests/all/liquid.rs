//! Losses of restrictions and lines, and the flow of a pump.

use mckibben_core::{analysis::find_root, liquid::Liquid};
use mckibben_motion::*;

fn water() -> Liquid {
    Liquid::named("water", 0.0).unwrap()
}

/// 1 m of 4 mm.
fn line() -> Hose {
    Hose::new(4.0, 1000.0).unwrap()
}

/// What the line lets through at a pressure difference in MPa, behind a pump that is large enough.
fn through_line(difference_mpa: f64, liquid: &Liquid) -> f64 {
    let pump = Pump {
        kind: ValveKind::DEFAULT,
        flow_mm3_per_s: f64::MAX,
        line: Some(line()),
    };
    pump.flow(
        1.0_f64.copysign(difference_mpa),
        difference_mpa,
        0.0,
        liquid,
    )
}

/// The pressure difference in MPa, up to 0.3, at which there is a flow.
fn difference(flow: impl Fn(f64) -> f64, wanted: f64) -> f64 {
    find_root(|p| Ok::<_, ()>(flow(p) - wanted), 0.0, 0.3, 1e-13)
        .unwrap()
        .unwrap()
}

/// Water (998.2 kg/m³, 1.00 mPa s) in 1 m of 4 mm: computed apart with Darcy and Weisbach's
/// equation, f = 64/Re and 0.3164 Re^−0.25. 3 mL/s, Re 953: 477.5 Pa. 20 mL/s, Re 6355: 11.20
/// kPa.
#[test]
fn losses_of_a_line_are_those_of_darcy_and_weisbach() {
    let through = |p: f64| through_line(p, &water());
    for (q_mm3_per_s, loss_mpa) in [(3e3, 4.774648e-4), (2e4, 1.1200306e-2)] {
        let flow = through(loss_mpa);
        assert!(
            (flow / q_mm3_per_s - 1.0).abs() < 1e-6,
            "{flow} {q_mm3_per_s}"
        );
        assert_eq!(through(-loss_mpa), -flow);
    }
    assert_eq!(through(0.0), 0.0);
}

/// Kv of water at 1 bar by definition, less the laminar term's 0.05 %; four times the pressure,
/// twice the flow.
#[test]
fn a_flow_coefficient_is_the_flow_at_one_bar() {
    let restriction = Restriction::new(1e5).unwrap();
    let water = Liquid {
        density_kg_per_m3: 1000.0,
        ..water()
    };
    let valve = |line: Option<Hose>| LiquidValve {
        kind: ValveKind::DEFAULT,
        supply: restriction,
        tank: restriction,
        line,
    };
    let flow = |p: f64| valve(None).flow(1.0, p, &water);
    assert!((flow(0.1) / 1e5 - 0.9995).abs() < 1e-6, "{}", flow(0.1));
    assert!((flow(0.4) / 2e5 - 0.99975).abs() < 1e-6);
    // With a line behind it the sum of both losses is the difference.
    let both = valve(Some(line())).flow(1.0, 0.3, &water);
    let sum = difference(flow, both) + difference(|p| through_line(p, &water), both);
    assert!((sum / 0.3 - 1.0).abs() < 1e-9, "{sum}");
}

#[test]
fn a_pump_gives_its_flow_up_to_its_relief_valve() {
    let fill = LiquidFill {
        liquid: water(),
        temperature_k: 293.15,
        dead_volume_mm3: 0.0,
    };
    let pump = Pump {
        kind: ValveKind::DEFAULT,
        flow_mm3_per_s: 1e4,
        line: None,
    };
    let flow = |opening, muscle| {
        let (into, out) = fill.flows(opening, (0.5, muscle), |p| {
            pump.flow(opening, p, 0.5, &fill.liquid)
        });
        fill.volume_mm3(into.mass_g_per_s + out.mass_g_per_s)
    };
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-6 * 1e4, "{a} {b}");
    near(flow(1.0, 0.2), 1e4);
    near(flow(0.5, 0.2), 5e3);
    near(flow(-1.0, 0.2), -1e4);
    near(flow(1.0, 0.4975), 5e3);
    near(flow(1.0, 0.5), 0.0);
    near(flow(-1.0, 0.0), 0.0);
    near(flow(0.0, 0.2), 0.0);
}
