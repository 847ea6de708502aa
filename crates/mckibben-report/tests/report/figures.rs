//! Figures to look at and to test with.

use mckibben_report::{Axis, Figure, Mark, Panel, Series, Style};

/// Pull of an ideal braid, N: pressure in Pa, braid angle at rest in degrees, radius in m.
fn pull(pressure: f64, angle: f64, radius: f64, contraction: f64) -> f64 {
    let (sin, cos) = angle.to_radians().sin_cos();
    let (a, b) = (3.0 * (cos / sin).powi(2), 1.0 / (sin * sin));
    std::f64::consts::PI * radius * radius * pressure * (a * (1.0 - contraction).powi(2) - b)
}

/// A curve from no contraction to no pull, less an elastic part so that the ends differ.
fn isobar(pressure: f64, angle: f64, elastic: f64) -> Vec<(f64, f64)> {
    let force = |e: f64| pull(pressure, angle, 0.01, e) - elastic * e;
    (0..=120)
        .map(|i| f64::from(i) * 0.003)
        .map(|e| (e, force(e)))
        .take_while(|p| p.1 >= 0.0)
        .collect()
}

const CAPTION: &str = "Ideal braid with elastic bladder, muscle of 20 mm bore, braid angle 25° at \
    rest, \
                       active length 300 mm. mckibben 0.1.0";

/// Isobars with two operating points; without an elastic part they all end in one point.
pub fn isobars(elastic: f64) -> Figure {
    let x = Axis::new("contraction ratio ε [–]").from_zero();
    let mut panel = Panel::new(x, Axis::new("pull F [N]").from_zero());
    for (i, p) in [0.1, 0.2, 0.3, 0.4, 0.5].into_iter().enumerate() {
        let label = format!("{p:.1} MPa");
        let curve = isobar(p * 1e6, 25.0, elastic);
        panel = panel.series(Series::line("", curve).colour(i).end_label(label));
    }
    let at = |p: f64, e: f64| pull(p * 1e6, 25.0, 0.01, e) - elastic * e;
    panel = panel
        .mark(Mark::new(0.05, at(0.4, 0.05), "start of the stroke"))
        .mark(Mark::new(0.2, at(0.4, 0.2), "holds 5 kg at ε = 0.20"));
    Figure::new("Force–contraction curves at constant pressure")
        .caption(CAPTION)
        .sequential()
        .panel(panel)
}

/// Models against measured points.
pub fn models() -> Figure {
    let x = Axis::new("contraction ratio ε [–]").from_zero();
    let mut panel = Panel::new(x, Axis::new("pull F [N]").from_zero());
    let curve = isobar(0.3e6, 22.0, 150.0);
    let scaled = |k: f64, d: f64| -> Vec<_> {
        curve
            .iter()
            .map(|(e, f)| (*e, f * k - d * e))
            .filter(|p| p.1 >= 0.0)
            .collect()
    };
    panel = panel
        .series(Series::new("ideal braid", curve.clone()))
        .series(Series::new("thick wall", scaled(0.93, 120.0)))
        .series(Series::new("with friction, loading", scaled(0.86, 300.0)))
        .series(Series::new("with friction, unloading", scaled(0.80, 320.0)));
    let measured = curve.iter().step_by(8).enumerate().map(|(i, (e, f))| {
        let noise = (i as f64 * 2.7).sin() * 0.02 + 0.88;
        (*e, (f * noise - 220.0 * e).max(0.0))
    });
    panel = panel
        .series(Series::scatter("measured, 3 muscles", measured.collect::<Vec<_>>()).colour(6));
    Figure::new("Models against measured points at 0.3 MPa")
        .caption(CAPTION)
        .panel(panel)
}

/// A grid of 2 × 3 panels.
pub fn grid() -> Figure {
    let mut figure = Figure::new("Six muscles, three models, measured points")
        .caption(CAPTION)
        .columns(3);
    for (k, angle) in [18.0, 20.0, 22.0, 24.0, 26.0, 28.0].into_iter().enumerate() {
        let curve = isobar(0.3e6, angle, 100.0);
        let scaled = |s: f64| -> Vec<_> { curve.iter().map(|(e, f)| (*e, f * s)).collect() };
        let points: Vec<_> = curve
            .iter()
            .step_by(12)
            .map(|(e, f)| (*e, f * (0.9 + 0.03 * (e * 90.0).sin())))
            .collect();
        let panel = Panel::new(
            Axis::new("contraction ratio ε [–]").from_zero(),
            Axis::new("pull F [N]").from_zero(),
        )
        .title(format!(
            "({}) braid angle {angle}°",
            char::from(b'a' + k as u8)
        ))
        .series(Series::new("ideal", curve.clone()))
        .series(Series::new("thick wall", scaled(0.92)))
        .series(Series::new("with friction", scaled(0.85)))
        .series(Series::scatter("measured", points).colour(6));
        figure = figure.panel(panel);
    }
    figure
}

/// A plot without a free corner.
pub fn crowded() -> Figure {
    let mut panel = Panel::new(
        Axis::new("time t [s]"),
        Axis::new("pressure difference Δp [Pa]"),
    );
    for k in 0..6 {
        let phase = f64::from(k);
        let points: Vec<_> = (0..400)
            .map(|i| f64::from(i) * 0.025)
            .map(|t| (t, 4e5 * (t * (1.0 + 0.1 * phase) + phase).sin()))
            .collect();
        let style = if k < 3 { Style::Auto } else { Style::Line };
        panel = panel.series(Series::new(format!("channel {k}"), points).style(style));
    }
    Figure::new("Everything is full: the legend moves outside")
        .caption("Synthetic sines.")
        .panel(panel)
}

/// Lines that end at the right edge.
pub fn ends() -> Figure {
    let mut panel = Panel::new(
        Axis::new("cycle N [–]").range(0.0, 1e6),
        Axis::new("slip s [µm]").range(-2.0, 12.0),
    );
    for k in 0..5 {
        let top = 3.0 + 0.9 * f64::from(k);
        let points: Vec<_> = (0..=50)
            .map(|i| f64::from(i) * 2e4)
            .map(|n| (n, top * (1.0 - (-n / 2e5).exp())))
            .collect();
        panel = panel.series(Series::line("", points).end_label(format!("{} bar", k + 1)));
    }
    panel = panel
        .mark(Mark::new(1e6, 3.0, "at the edge"))
        .mark(Mark::new(0.0, 0.0, "new muscle"));
    Figure::new("Direct labels at the right edge").panel(panel)
}

/// Panels that need separate legends, below them.
pub fn panel_legends() -> Figure {
    let mut figure =
        Figure::new("Four panels with legends of their own").caption("Synthetic sines.");
    for k in 0..4 {
        let mut panel = Panel::new(Axis::new("pressure p [Pa]"), Axis::new("pull F [N]"));
        panel.title = format!("({}) size {k}", char::from(b'a' + k));
        for i in 0..3 {
            let wave = |t: u8| {
                50.0 * f64::from(i + k)
                    + 30.0 * f64::from(k) * (f64::from(t) / 6.0 + f64::from(i)).sin()
            };
            let points: Vec<_> = (0..40).map(|t| (f64::from(t) * 1e4, wave(t))).collect();
            let style = if i == 2 { Style::Points } else { Style::Auto };
            panel = panel.series(Series::new(format!("variant {k}.{i}"), points).style(style));
        }
        figure = figure.panel(panel.mark(Mark::new(2e5, 60.0, "a point")));
    }
    figure
}

/// Markers, and operating points that crowd.
pub fn markers() -> Figure {
    let mut panel = Panel::new(Axis::new("x [m]"), Axis::new("y [N]"));
    for i in 0..9 {
        let points: Vec<_> = (0..12)
            .map(f64::from)
            .map(|t| (t, f64::from(i) + 0.02 * t * t))
            .collect();
        panel = panel.series(Series::scatter(format!("kind {i}"), points));
    }
    for (i, at) in [0.0, 0.3, 5.0, 5.2, 5.4, 11.0].into_iter().enumerate() {
        panel = panel.mark(Mark::new(at, at, format!("operating point {i}")));
    }
    Figure::new("Markers").panel(panel)
}

/// All of them, named.
pub fn all() -> Vec<(&'static str, Figure)> {
    vec![
        ("isobars", isobars(400.0)),
        ("ideal", isobars(0.0)),
        ("models", models()),
        ("grid", grid()),
        ("crowded", crowded()),
        ("ends", ends()),
        ("own", panel_legends()),
        ("markers", markers()),
    ]
}
