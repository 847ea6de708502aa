//! The paper's method on our finite elements by each reading of what the paper leaves open, against
//! the published formula: writes the table of docs/paper.md; `-- --check` compares.

use mckibben_campaign::fit::{
    data::{FitPoint, Grid},
    errors::{ForceScales, errors},
    paper_method::{fit, is_left_out, paper_method},
};
use mckibben_core::muscle::Muscle;
use mckibben_studies::{Result, keep, with_texts};
use std::{fs, path::Path};

/// A row: what is compared on which points, and the difference in N.
fn row(name: &str, points: &[FitPoint], difference_n: impl Fn(&FitPoint) -> f64) -> Result<String> {
    let forces = ForceScales::new(points)?;
    let compared = points.iter().map(|p| forces.compared(*p, difference_n(p)));
    let e = errors(compared).ok_or("no point pulls")?;
    let [max, p95, rms] = [e.max, e.p95, e.rms].map(|share| 100.0 * share);
    Ok(format!(
        "| {name} | {} | {max:.2} | {p95:.2} | {rms:.2} | {:.1} |\n",
        e.points, e.max_n
    ))
}

/// The points that the method takes by each reading.
fn readings(points: &[FitPoint]) -> [(&'static str, Vec<FitPoint>); 5] {
    let curve = |p: &FitPoint| (p.outer_diameter_mm, p.wall_mm, p.pressure_mpa);
    let isobar = |of| points.iter().filter(move |q| curve(q) == of);
    let line = |p: &FitPoint| {
        let near = isobar(curve(p)).filter(|q| q.contraction < 0.06 && is_left_out(q));
        let near: Vec<_> = near.map(|q| (q.contraction, q.force_n)).collect();
        let force_n = fit::<2>(&near).map_or(p.force_n, |line| line.at(p.contraction));
        FitPoint { force_n, ..*p }
    };
    let zero = |p: &FitPoint| FitPoint {
        force_n: p.force_n.max(0.0),
        ..*p
    };
    let pulls = |p: &&FitPoint| p.force_n > 0.0;
    let usual = || points.iter().filter(|p| !is_left_out(p));
    let pulling = usual().filter(|p| pulls(p) && isobar(curve(p)).filter(pulls).count() > 2);
    [
        ("default", usual().copied().collect()),
        (
            "thick walls at .05 MPa: straight line",
            points.iter().map(line).collect(),
        ),
        ("thick walls at .05 MPa: whole", points.to_vec()),
        ("points that pull only", pulling.copied().collect()),
        ("zero where it would push", usual().map(zero).collect()),
    ]
}

fn main() -> Result<()> {
    let base = Muscle::prototype();
    let halves = |low: f64, step: f64| (0..=8).map(|i| low + step * f64::from(i)).collect();
    let [diameters, contractions]: [Vec<f64>; 2] = [halves(30.0, 2.5), halves(0.0, 0.025)];
    let finer = Grid {
        diameters: &diameters,
        contractions: &contractions,
        ..Grid::PAPER
    };
    let [campaign, held, finer] = [Grid::PAPER, Grid::HELD_OUT, finer].map(|g| g.points(&base));
    let (slim, mut wide): (Vec<_>, Vec<_>) = [&campaign[..], &held]
        .concat()
        .into_iter()
        .partition(|p| p.outer_diameter_mm < 34.0);
    wide.retain(|p| p.wall_mm < 4.5);
    let mut table =
        "| | points | largest % | 95 % | rms % | N |\n|---|---|---|---|---|---|\n".to_owned();
    for (reading, used) in readings(&campaign) {
        let formula = paper_method(&used)?.coefficients;
        let difference = |p: &FitPoint| {
            let section = formula.section(p.outer_diameter_mm, p.wall_mm);
            section.force_n(p.pressure_mpa, p.contraction) - p.published_n()
        };
        table += &row(&format!("{reading}, D0 35-50, s 1-4"), &wide, difference)?;
        table += &row(&format!("{reading}, D0 30, s 1-5"), &slim, difference)?;
    }
    let off = |p: &FitPoint| p.published_n() - p.force_n;
    table += &row("published against FE, half steps of D0 and ε", &finer, off)?;
    let page = Path::new("docs/paper.md");
    let made = with_texts(&fs::read_to_string(page)?, &[("rules", table)])?;
    let check = std::env::args().any(|word| word == "--check");
    (keep(page, &made, check)? || !check)
        .then_some(())
        .ok_or("docs/paper.md is another".into())
}
