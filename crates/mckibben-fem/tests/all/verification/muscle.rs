//! I. The two identities of the muscle, and the independent prototype.
//!
//! Loaded and held: pressure inside, the length given, both ends bonded to rigid terminals.

use super::{Rows, changed, section_pull};
use mckibben_core::{
    differences::slope,
    model::{ForceModel, Workspace},
    muscle::{Braid, BraidStiffness, Muscle, Rubber, Strands, Tube},
    rubber::{Law, MooneyRivlin},
};
use mckibben_fem::axisymmetric::Axisymmetric;
use std::f64::consts::PI;

/// π D0² P (3 cos²θ − 1)/(4 sin²θ): blocked force in N at D0 50, θ 28°, P 0.25 of strands that do
/// not stretch.
pub fn outer_diameter_limit_n() -> f64 {
    let theta = 28.0_f64.to_radians();
    PI * 2500.0 * 0.25 / (4.0 * theta.sin().powi(2)) * (3.0 * theta.cos().powi(2) - 1.0)
}

/// The rows of I.
pub fn identities(rows: &mut Rows) {
    for (d0, s, p, e) in [
        (30.0, 3.0, 0.2, 0.0),
        (30.0, 3.0, 0.2, 0.1),
        (50.0, 1.0, 0.15, 0.15),
        (40.0, 5.0, 0.25, 0.05),
    ] {
        let slopes = maxwell(d0, s, p, e);
        let by_volume = slopes.map_or(f64::INFINITY, |f| f.1);
        let what = "against −∂V/∂L (mm²)";
        let begins = format!("D0 {d0}, s {s}, P {p}, ε {e}: ∂F/∂P ");
        for (how, ours) in [
            ("by differences", slopes.map(|f| f.0)),
            ("of the tangent", slopes.map(|f| f.2)),
        ] {
            rows.add(format!("{begins}{how} {what}"), by_volume, ours, 1e-7);
        }
    }
    rows.source = "I: outer-diameter limit of strands that do not stretch";
    let stiff = BraidStiffness::NewtonPerMm(1e6);
    for s in [1.0, 3.0, 5.0] {
        for (name, stiffness, tolerance) in [
            ("inextensible", BraidStiffness::Inextensible, 1e-9),
            ("k 1e6 N/mm", stiff, 2e-4),
        ] {
            let ours = changed(|t, b| {
                (t.outer_diameter_mm, t.wall_mm, b.stiffness) = (50.0, s, stiffness)
            })
            .and_then(|m| section_pull(&m, 0.25, 0.0));
            rows.add(
                format!("blocked force, D0 50, s {s}, P 0.25, {name} (N)"),
                outer_diameter_limit_n(),
                ours,
                tolerance,
            );
        }
    }
}

/// ∂F/∂P at fixed L and −∂V/∂L at fixed P, both by differences, and ∂F/∂P from the tangent.
fn maxwell(d0: f64, s: f64, p: f64, e: f64) -> Option<(f64, f64, f64)> {
    let muscle = Muscle::prototype().with_section(d0, s).ok()?;
    let model = Axisymmetric::between_ends(&muscle).ok()?;
    let at = |p: f64, e: f64| model.response(&mut Workspace::new(), p, e).ok();
    let force = slope(2e-3 * p, |h| at(p + h, e).map(|r| r.force_n).ok_or(())).ok()?;
    let volume = slope(5e-4, |h| at(p, e + h).and_then(|r| r.volume_mm3).ok_or(())).ok()?;
    Some((
        force,
        volume / muscle.length_mm(),
        at(p, e)?.force_per_pressure_mm2?,
    ))
}

/// The rubber and the strands of the prototype in other programs.
pub fn compared(tube: &mut Tube, braid: &mut Braid) {
    tube.rubber = Rubber::new(Law::MooneyRivlin(MooneyRivlin {
        c10_mpa: 0.12,
        c01_mpa: 0.03,
    }));
    braid.strands = Some(Strands::new(48, Some((0.3, 2500.0)), None));
    braid.stiffness = BraidStiffness::OfStrands;
}

/// An independent axisymmetric code, and the limit of bricks and trusses in FElupe 11.3.
pub fn prototype(rows: &mut Rows) {
    let muscle = changed(|tube, braid| {
        compared(tube, braid);
        tube.length_mm = 287.83;
    });
    let ours = |p: f64, e: f64| section_pull(muscle.as_ref()?, p, e);
    for (e, p, force) in [
        (0.0, 0.25, 846.03),
        (0.10, 0.10, 100.14),
        (0.10, 0.25, 440.59),
    ] {
        // 0.03 % of the blocked force.
        rows.add(
            format!("D0 30, s 3, L0 287.83, 48 strands, P {p}, ε {e}: F (N)"),
            force,
            ours(p, e),
            3e-4 * 846.0 / force,
        );
    }
    rows.source = "FElupe 11.3, refined";
    rows.add(
        "the same in three dimensions, P 0.25, ε 0.10: F (N), ±0.5",
        440.6,
        ours(0.25, 0.10),
        0.5 / 440.6,
    );
}
