//! The figure of `docs/finite-elements.md`: one muscle by three-dimensional and axisymmetric
//! elements, by the ideal formula, and by other programs (`data/peers`).
//! `cargo study peers_figure -- FILE.svg`, from the root of the repository.

use mckibben_core::{
    model::{ForceModel, Ideal, Workspace},
    muscle::file::read_muscle,
};
use mckibben_fem::{
    axisymmetric::Axisymmetric,
    three_dimensional::{BrickSpec, Match, ThreeDimensional},
};
use mckibben_fit::compare::read_measured;
use mckibben_report::{Axis, Figure, Panel, Series, Style};
use std::error::Error;

const PROGRAMS: [(&str, &str); 3] = [
    ("FElupe", "felupe"),
    ("CalculiX, K 30", "calculix_k_30"),
    ("CalculiX, K 300", "calculix_k_300"),
];

fn main() -> Result<(), Box<dyn Error>> {
    let out = std::env::args().nth(1).ok_or("wanted: a file to write")?;
    let muscle = read_muscle("examples/peers.toml")?;
    let spec = BrickSpec {
        through: Some(2),
        around: Some(12),
        keep: Match::Angle,
        ..BrickSpec::default()
    };
    let bricks = ThreeDimensional::between_ends_with(&muscle, &spec)?;
    // Their mesh is a little longer than the muscle.
    let mut tube = muscle.tube().clone();
    tube.length_mm = 2.0 * bricks.divided.mesh.tube.half_mm;
    let muscle = muscle.with_tube(tube)?;
    let section = Axisymmetric::between_ends(&muscle)?;
    let ideal = Ideal::between_ends(&muscle);
    let models: [(&str, &dyn ForceModel, Style); 3] = [
        ("fe3d", &bricks, Style::Line),
        ("fe", &section, Style::Dashed),
        ("ideal formula", &ideal, Style::Dotted),
    ];

    let pressure = Axis::new("pressure P [MPa]").from_zero();
    let mut pull = Panel::new(pressure.clone(), Axis::new("pull F [N]").from_zero());
    let mut off = Panel::new(pressure, Axis::new("F less that of fe3d [N]"));
    for (turn, contraction) in [0.0, 0.1].into_iter().enumerate() {
        let reference = |p: f64| bricks.force_n(&mut Workspace::new(), p, contraction);
        for (number, (name, model, style)) in models.iter().enumerate() {
            let answers = (1..=25).map(|i| 0.01 * f64::from(i)).filter_map(|p| {
                let force = model.force_n(&mut Workspace::new(), p, contraction);
                Some((p, force.ok()?))
            });
            // Below P' a muscle does not pull.
            let line: Vec<(f64, f64)> = answers.filter(|(_, force)| *force >= 0.0).collect();
            let name = if turn == 0 { *name } else { "" };
            let mut series = Series::line(name, line.clone())
                .colour(number)
                .style(*style);
            if number == 0 {
                series = series.end_label(format!("ε {} %", 100.0 * contraction));
            }
            pull = pull.series(series);
            if number == 1 {
                let off_fe = line
                    .iter()
                    .filter_map(|&(p, f)| Some((p, f - reference(p).ok()?)));
                off = off.series(Series::line(name, off_fe).colour(number).style(*style));
            }
        }
        for (number, (name, file)) in PROGRAMS.iter().enumerate() {
            let points =
                read_measured(&std::fs::read_to_string(format!("data/peers/{file}.csv"))?)?;
            let here = points
                .iter()
                .filter(|p| (p.contraction - contraction).abs() < 1e-9 && p.force_n >= 0.0);
            let pulls = here.clone().step_by(2).map(|p| (p.pressure_mpa, p.force_n));
            let name = if turn == 0 { *name } else { "" };
            pull = pull.series(Series::scatter(name, pulls).colour(3 + number));
            let differences = here.filter_map(|p| {
                Some((p.pressure_mpa, p.force_n - reference(p.pressure_mpa).ok()?))
            });
            off = off.series(Series::scatter(name, differences).colour(3 + number));
        }
    }
    let figure = Figure::new("One muscle, several programs")
        .caption(format!(
            "D0 30, s 3, L0 287.83, 28°, C10 0.12, C01 0.03, K 300 MPa; ε 0 and 10 %. The ideal \
             formula is off by too much for the right panel. mckibben {}",
            env!("CARGO_PKG_VERSION")
        ))
        .panel(pull)
        .panel(off);
    std::fs::write(&out, figure.bytes(out.as_ref())?)?;
    Ok(())
}
