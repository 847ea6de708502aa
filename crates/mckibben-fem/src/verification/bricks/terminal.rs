//! E. Terminals that are bodies: the cavity is closed by real faces.

use super::numerics::tangent_error;
use super::{BRICKS, solve};
use crate::three_dimensional::{Brick, BrickSpec, Engine, Plug, PlugMaterial, Totals};
use crate::verification::Row;
use mckibben::muscle::Muscle;

const SOURCE: &str = "E: closed cavity, terminals as bodies (bricks)";

fn engine(brick: Brick, plug: Option<Plug>) -> Option<Engine> {
    let (around, along) = (Some(4 / brick.order()), Some(12 / brick.order()));
    let spec = BrickSpec { brick, around, along, plug, ..BrickSpec::default() };
    Engine::new(&Muscle::prototype(), &spec).ok()
}

fn plug(material: PlugMaterial, insertion_mm: f64, nose_mm: f64) -> Option<Plug> {
    Some(Plug { material, insertion_mm: Some(insertion_mm), nose_mm: Some(nose_mm) })
}

fn totals(brick: Brick, plug: Option<Plug>, pressure: f64, contraction: f64) -> Option<Totals> {
    let mut engine = engine(brick, plug)?;
    engine.reach(pressure, contraction).ok()?;
    Some(engine.body.totals)
}

/// The rows of terminals.
pub fn terminal() -> Vec<Row> {
    let (rigid, aluminium) = (PlugMaterial::Rigid, PlugMaterial::Aluminium);
    let mut rows = Vec::new();
    for (brick, name) in BRICKS {
        let mut row = |what: &str, reference: Option<f64>, ours: Option<f64>, tolerance: f64| {
            let reference = reference.unwrap_or(f64::INFINITY);
            rows.push(Row::new(format!("{name}, {what}"), SOURCE, reference, ours, tolerance));
        };
        let (p, e) = (0.2, 0.1);
        let lid = (|| {
            let mut engine = engine(brick, None)?;
            engine.reach(p, e).ok()?;
            // The lid is round, a plug's face has the rim of the bore: a prism of the muscle's length lies between them.
            let more = engine.mesh.lid_mm2() - engine.mesh.polygon_mm2();
            let (pull, volume) = (engine.body.totals.pull, engine.body.totals.volume);
            Some((pull + 4.0 * p * more, volume - more * (1.0 - e) * engine.half_length()))
        })();
        let sharp = totals(brick, plug(rigid, 0.0, 0.0), p, e);
        let what = "rigid plug without insertion or nose: F of the lid (N)";
        row(what, lid.map(|t| t.0), sharp.map(|t| t.pull), 1e-10);
        row("the same: V of the eighth (mm³)", lid.map(|t| t.1), sharp.map(|t| t.volume), 1e-10);
        // A nose takes the same volume from every state, and no pull.
        let nose = |p: f64, e: f64| {
            let (with, without) =
                (totals(brick, plug(rigid, 0.0, 4.0), p, e)?, totals(brick, plug(rigid, 0.0, 0.0), p, e)?);
            Some((without.volume - with.volume, with.pull, without.pull))
        };
        let (one, two) = (nose(0.2, 0.1), nose(0.1, 0.0));
        row("nose: F as without it (N)", one.map(|n| n.2), one.map(|n| n.1), 1e-9);
        row("nose: volume it takes, in two states (mm³)", one.map(|n| n.0), two.map(|n| n.0), 1e-8);
        for (material, what) in [(rigid, "rigid"), (aluminium, "aluminium")] {
            let found = (|| {
                let mut engine = engine(brick, plug(material, 10.0, 3.0))?;
                engine.reach(0.2, 0.08).ok()?;
                let terminal = engine.body.state.terminal;
                solve(&mut engine.body, terminal).or(Some(Default::default()))?;
                engine.body.factorise().ok()?;
                let maxwell = (engine.body.force_per_pressure(), engine.body.volume_per_length());
                Some((maxwell, tangent_error(&mut engine.body)?))
            })();
            row(
                &format!("{what} plug, Maxwell: ∂F/∂P = −∂V/∂L (mm²)"),
                found.map(|f| f.0.1),
                found.map(|f| f.0.0),
                1e-9,
            );
            row(&format!("{what} plug: tangent against differences"), Some(0.0), found.map(|f| f.1), 1e-7);
        }
    }
    rows
}
