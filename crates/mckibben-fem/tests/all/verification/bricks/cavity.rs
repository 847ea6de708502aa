//! E. Follower pressure and conservation on a muscle in bricks, and terminals that are bodies: the
//! cavity is closed by real faces.
//!
//! Loaded and held: pressure inside, the length given or both along a path; the ends are bonded, or
//! the far end of tube, braid and plug is held.

use super::{BRICKS, at_rest, coarse, maxwell, numerics::tangent_error, prototype, settle};
use crate::verification::{Rows, pressure::balance};
use mckibben_core::muscle::Muscle;
use mckibben_fem::{
    solver::continuation::Continuation,
    three_dimensional::{Brick, BrickSpec, MuscleInBricks, Plug, PlugMaterial, ThreeDimensional},
};

/// The rows of the pressure.
pub fn follower_pressure(rows: &mut Rows) {
    for (brick, name) in BRICKS {
        let slopes = prototype(brick).and_then(|mut c| {
            c.reach(0.2, 0.08).ok()?;
            maxwell(&mut c.body.bricks)
        });
        let (by_pressure, by_length) = slopes.unzip();
        rows.add(
            format!("{name}, Maxwell: ∂F/∂P = −∂V/∂L (mm²)"),
            by_length,
            by_pressure,
            1e-9,
        );
        let spec = BrickSpec {
            along: None,
            ..coarse(brick)
        };
        let model = ThreeDimensional::between_ends_with(&Muscle::prototype(), &spec).ok();
        rows.add(
            format!("{name}, (∫P dV + ∫F dL)/ΔW along a path"),
            1.0,
            model.and_then(|m| balance(&m)),
            1e-7,
        );
    }
}

/// A muscle with a plug in equilibrium.
fn reached(
    brick: Brick,
    plug: Option<Plug>,
    (pressure, contraction): (f64, f64),
) -> Option<Continuation<MuscleInBricks>> {
    let spec = BrickSpec {
        plug,
        ..coarse(brick)
    };
    let mut c = at_rest(&Muscle::prototype(), &spec)?;
    c.reach(pressure, contraction).ok()?;
    Some(c)
}

fn plug(material: PlugMaterial, insertion_mm: f64, nose_mm: f64) -> Option<Plug> {
    Some(Plug {
        material,
        insertion_mm: Some(insertion_mm),
        nose_mm: Some(nose_mm),
    })
}

/// The rows of terminals.
pub fn terminals(rows: &mut Rows) {
    let rigid = PlugMaterial::Rigid;
    let aluminium = PlugMaterial::Aluminium;
    for (brick, name) in BRICKS {
        let mut row = |what: &str, reference: Option<f64>, ours: Option<f64>, tolerance: f64| {
            rows.add(format!("{name}, {what}"), reference, ours, tolerance);
        };
        let p = 0.2;
        let e = 0.1;
        let lid = reached(brick, None, (p, e)).map(|c| {
            // The lid is round, a plug's face has the rim of the inner surface: a prism of the
            // muscle's length lies between them.
            let more = c.body.mesh.lid_mm2() - c.body.mesh.polygon_mm2();
            let bricks = &c.body.bricks;
            let prism = more * (1.0 - e) * bricks.discretisation.half;
            (c.pull() + 4.0 * p * more, bricks.totals.volume - prism)
        });
        let (lid_pull, lid_volume) = lid.unzip();
        let [sharp, nose] = [0.0, 4.0].map(|nose| {
            [(p, e), (0.1, 0.0)].map(|point| {
                let c = reached(brick, plug(rigid, 0.0, nose), point);
                c.map(|c| c.body.bricks.totals)
            })
        });
        let what = "rigid plug without insertion or nose: F of the lid (N)";
        let [sharp_pull, nose_pull] = [sharp, nose].map(|totals| totals[0].map(|t| t.pull));
        row(what, lid_pull, sharp_pull, 1e-10);
        let sharp_volume = sharp[0].map(|t| t.volume);
        let what = "the same: V of the eighth (mm³)";
        row(what, lid_volume, sharp_volume, 1e-10);
        // A nose takes the same volume from every state, and no pull.
        row("nose: F as without it (N)", sharp_pull, nose_pull, 1e-9);
        let [one, two] = [0, 1].map(|i| Some(sharp[i]?.volume - nose[i]?.volume));
        row("nose: volume it takes, in two states (mm³)", one, two, 1e-8);
        for (material, what) in [(rigid, "rigid"), (aluminium, "aluminium")] {
            let checks =
                reached(brick, plug(material, 10.0, 3.0), (0.2, 0.08)).and_then(|mut c| {
                    let body = &mut c.body.bricks;
                    settle(body);
                    Some((maxwell(body)?, tangent_error(body)?))
                });
            let (slopes, error) = checks.unzip();
            let (by_pressure, by_length) = slopes.unzip();
            row(
                &format!("{what} plug, Maxwell: ∂F/∂P = −∂V/∂L (mm²)"),
                by_length,
                by_pressure,
                1e-9,
            );
            row(
                &format!("{what} plug: tangent against differences"),
                Some(0.0),
                error,
                1e-7,
            );
        }
    }
}
