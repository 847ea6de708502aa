//! E. Terminals that are bodies: the cavity is closed by real faces.
//!
//! Loaded and held: pressure inside, the length given; the far end of tube, braid and plug is held.

use super::numerics::tangent_error;
use super::{BRICKS, at_rest, coarse, maxwell, solve};
use crate::solver::body::Totals;
use crate::solver::continuation::Continuation;
use crate::three_dimensional::{Brick, BrickSpec, MuscleInBricks, Plug, PlugMaterial};
use crate::verification::Rows;
use mckibben::muscle::Muscle;

fn muscle(brick: Brick, plug: Option<Plug>) -> Option<Continuation<MuscleInBricks>> {
    at_rest(
        &Muscle::prototype(),
        &BrickSpec {
            plug,
            ..coarse(brick)
        },
    )
}

fn plug(material: PlugMaterial, insertion_mm: f64, nose_mm: f64) -> Option<Plug> {
    Some(Plug {
        material,
        insertion_mm: Some(insertion_mm),
        nose_mm: Some(nose_mm),
    })
}

fn totals(brick: Brick, plug: Option<Plug>, pressure: f64, contraction: f64) -> Option<Totals> {
    let mut c = muscle(brick, plug)?;
    c.reach(pressure, contraction).ok()?;
    Some(c.body.bricks.totals)
}

/// The rows of terminals.
pub fn terminal(rows: &mut Rows) {
    let (rigid, aluminium) = (PlugMaterial::Rigid, PlugMaterial::Aluminium);
    for (brick, name) in BRICKS {
        let mut row = |what: &str, reference: Option<f64>, ours: Option<f64>, tolerance: f64| {
            rows.add(format!("{name}, {what}"), reference, ours, tolerance);
        };
        let (p, e) = (0.2, 0.1);
        let lid = muscle(brick, None).and_then(|mut c| {
            c.reach(p, e).ok()?;
            // The lid is round, a plug's face has the rim of the inner surface: a prism of the
            // muscle's length lies between them.
            let more = c.body.mesh.lid_mm2() - c.body.mesh.polygon_mm2();
            let half = c.body.bricks.discretisation.half;
            Some([
                c.pull() + 4.0 * p * more,
                c.body.bricks.totals.volume - more * (1.0 - e) * half,
            ])
        });
        let [sharp, nose] = [0.0, 4.0].map(|nose| {
            [(p, e), (0.1, 0.0)].map(|(p, e)| totals(brick, plug(rigid, 0.0, nose), p, e))
        });
        let what = "rigid plug without insertion or nose: F of the lid (N)";
        row(what, lid.map(|t| t[0]), sharp[0].map(|t| t.pull), 1e-10);
        row(
            "the same: V of the eighth (mm³)",
            lid.map(|t| t[1]),
            sharp[0].map(|t| t.volume),
            1e-10,
        );
        // A nose takes the same volume from every state, and no pull.
        row(
            "nose: F as without it (N)",
            sharp[0].map(|t| t.pull),
            nose[0].map(|t| t.pull),
            1e-9,
        );
        let [one, two] = [0, 1].map(|i| Some(sharp[i]?.volume - nose[i]?.volume));
        row("nose: volume it takes, in two states (mm³)", one, two, 1e-8);
        for (material, what) in [(rigid, "rigid"), (aluminium, "aluminium")] {
            let checks = (|| {
                let mut c = muscle(brick, plug(material, 10.0, 3.0))?;
                c.reach(0.2, 0.08).ok()?;
                let body = &mut c.body.bricks;
                let terminal = body.state.terminal;
                solve(body, terminal).or(Some(Default::default()))?;
                Some((maxwell(body)?, tangent_error(body)?))
            })();
            let (by_pressure, by_length) = checks.map(|f| f.0).unzip();
            row(
                &format!("{what} plug, Maxwell: ∂F/∂P = −∂V/∂L (mm²)"),
                by_length,
                by_pressure,
                1e-9,
            );
            row(
                &format!("{what} plug: tangent against differences"),
                Some(0.0),
                checks.map(|f| f.1),
                1e-7,
            );
        }
    }
}
