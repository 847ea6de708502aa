//! Lines through few points.

use mckibben_report::smooth::smooth;

type Spot = (f64, f64);

/// The largest distance of the drawn line from a function, in y.
fn off(spots: &[Spot], function: impl Fn(f64) -> f64) -> f64 {
    let between = |p: &[Spot], s: f64| {
        (
            p[0].0 + s * (p[1].0 - p[0].0),
            p[0].1 + s * (p[1].1 - p[0].1),
        )
    };
    let all = spots
        .windows(2)
        .flat_map(|p| (0..=10).map(move |k| between(p, f64::from(k) / 10.0)));
    all.map(|(x, y)| (y - function(x)).abs())
        .fold(0.0, f64::max)
}

fn sampled(places: &[f64], function: impl Fn(f64) -> f64) -> Vec<Spot> {
    places.iter().map(|x| (*x, function(*x))).collect()
}

/// Exact: the cubic through four points of a parabola or a cubic is that; its error is that of
/// chords of a part of the way.
#[test]
fn parabolas_and_cubics_have_no_facets_at_any_spacing() {
    let places = [
        0.0, 55.0, 100.0, 160.0, 240.0, 300.0, 380.0, 450.0, 520.0, 600.0,
    ];
    let parabola = |x: f64| 400.0 - (600.0 - x).powi(2) / 900.0;
    let cubic = |x: f64| 100.0 + (x - 700.0).powi(3) / 1e6;
    for of in [parabola, cubic] {
        let chords = sampled(&places, of);
        assert!(off(&chords, of) > 0.5);
        assert!(
            off(&smooth(&chords), of) < 0.2,
            "{}",
            off(&smooth(&chords), of)
        );
        let back: Vec<Spot> = chords.iter().rev().copied().collect();
        assert!(off(&smooth(&back), of) < 0.2);
    }
}

#[test]
fn corners_jumps_loops_and_straight_lines_are_kept() {
    let places: Vec<f64> = (0..12).map(|i| 20.0 * f64::from(i)).collect();
    let corner = sampled(&places, |x| (x - 100.0).abs());
    let jump = sampled(&places, |x| if x < 90.0 { 10.0 } else { 60.0 });
    let line = sampled(&places, |x| 3.0 * x);
    let round: Vec<Spot> = places
        .iter()
        .map(|x| ((x / 20.0).cos() * 50.0, (x / 20.0).sin() * 50.0))
        .collect();
    for run in [
        corner,
        jump,
        line,
        round,
        vec![],
        vec![(0.0, 1.0), (1.0, 4.0), (2.0, 9.0)],
    ] {
        assert_eq!(smooth(&run), run);
    }
}

/// A parabola that ends at zero and goes on flat, as a pull where a muscle becomes slack:
/// nothing is drawn beyond the corner.
#[test]
fn beside_a_corner_the_chord_is_kept() {
    let places: Vec<f64> = (0..21).map(|i| 30.0 * f64::from(i)).collect();
    let run = sampled(&places, |x| {
        if x < 400.0 {
            (400.0 - x).powi(2) / 400.0 + (400.0 - x) / 5.0
        } else {
            0.0
        }
    });
    let drawn = smooth(&run);
    assert!(drawn.len() > run.len() && drawn.iter().all(|s| s.1 >= 0.0));
    assert!(
        drawn
            .iter()
            .filter(|s| s.0 > 390.0)
            .all(|s| run.contains(s))
    );
}
