//! Draws how errors of models are spread on random muscles that no fit has seen: the share of
//! points within an error.
//!
//! `cargo study universal_figure -- docs/figures/universal.svg 150` takes the file and the number
//! of muscles.

use mckibben_core::model::{ModelKind, Workspace};
use mckibben_campaign::fit::universal::held_out_samples;
use mckibben_report::{Axis, Figure, Panel, Series};
use std::{error::Error, path::Path};

/// Points of a curve, as steps of its share.
const STEPS: usize = 200;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let file = arguments.next().unwrap_or_else(|| "universal.svg".into());
    let samples = held_out_samples(arguments.next().map_or(Ok(150), |n| n.parse())?, 7);
    let points: usize = samples.iter().map(|s| s.points.len()).sum();
    let mut panel = Panel::new(
        Axis::new("|error| in % of the blocked force, log10").range(-4.0, 2.0),
        Axis::new("share of points within it, %").range(0.0, 100.0),
    );
    for kind in [
        ModelKind::Universal,
        ModelKind::ThickWall,
        ModelKind::Ideal,
    ] {
        let mut errors = vec![];
        for s in &samples {
            let model = kind.build(&s.muscle)?;
            for p in &s.points {
                let force = model.force_n(&mut Workspace::new(), p.pressure_mpa, p.contraction)?;
                errors.push((100.0 * (force - p.force_n) / p.blocked_n).abs().max(1e-9));
            }
        }
        errors.sort_by(f64::total_cmp);
        let at = |step: usize| {
            let place = (step * errors.len() / STEPS).min(errors.len().saturating_sub(1));
            (errors[place].log10(), 100.0 * step as f64 / STEPS as f64)
        };
        panel = panel.series(Series::line(
            kind.name(),
            (1..=STEPS).map(at).collect::<Vec<_>>(),
        ));
    }
    let title = "Errors against finite elements";
    let caption = format!(
        "{points} points of {} random muscles that no fit has seen, where they pull",
        samples.len()
    );
    let figure = Figure::new(title).caption(caption).panel(panel);
    std::fs::write(&file, figure.bytes(Path::new(&file))?)?;
    Ok(())
}
