//! The SVG and the image made of it.

use crate::figures;
use mckibben_report::{Axis, Figure, Mark, Panel, Series, Style};
use proptest::prelude::*;
use roxmltree::Document;
use ttf_parser::{Face, GlyphId};

/// A pixel of CSS in units of a drawing.
const PIXEL: f64 = 4.0 * 25.4 / 96.0;

fn parse(svg: &str) -> Document<'_> {
    Document::parse(svg).unwrap()
}

/// Width and height.
fn size(svg: &str) -> [f64; 2] {
    let sides = parse(svg)
        .root_element()
        .attribute("viewBox")
        .unwrap()
        .to_owned();
    let sides: Vec<f64> = sides.split(' ').map(|side| side.parse().unwrap()).collect();
    [sides[2], sides[3]]
}

/// Left, top, right and bottom end.
#[derive(Debug)]
struct Ends([f64; 4]);

impl Ends {
    fn meets(&self, other: &Self) -> bool {
        let Self([left, top, right, bottom]) = self;
        let Self([l, t, r, b]) = other;
        left < r && l < right && top < b && t < bottom
    }
}

/// The ends of what is seen of a text at the origin, y downwards, and the end of its line; blanks
/// alone have none.
fn outlines(words: &str, size: f64) -> (Option<Ends>, f64) {
    let font = Face::parse(include_bytes!("../../data/DejaVuSans.ttf"), 0).unwrap();
    let scale = size / f64::from(font.units_per_em());
    let (mut all, mut x) = (None::<[f64; 4]>, 0.0);
    for c in words.chars() {
        let glyph = font.glyph_index(c).unwrap_or(GlyphId(0));
        if let Some(b) = font.glyph_bounding_box(glyph) {
            let [left, top] = [b.x_min, -b.y_max].map(|v| scale * f64::from(v));
            let [right, bottom] = [b.x_max, -b.y_min].map(|v| scale * f64::from(v));
            let [l, t, r, b] = all.unwrap_or([f64::MAX, f64::MAX, f64::MIN, f64::MIN]);
            all = Some([l.min(x + left), t.min(top), r.max(x + right), b.max(bottom)]);
        }
        let known = font
            .glyph_index(c)
            .and_then(|glyph| font.glyph_hor_advance(glyph));
        x += known.map_or(0.7 * size, |units| scale * f64::from(units));
    }
    (all.map(Ends), x)
}

/// Words, ends of their outlines, and whether they are upright; without the white outlines below
/// others.
fn texts(svg: &str) -> Vec<(String, Ends, bool)> {
    let document = parse(svg);
    let all = document
        .descendants()
        .filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "text")));
    let shown = all.filter(|text| text.attribute("fill") != Some("#ffffff"));
    let boxed = shown.filter_map(|text| {
        let number = |name: &str| text.attribute(name).unwrap().parse::<f64>().unwrap();
        let words = text.text().unwrap_or_default().to_owned();
        let [x, y] = [number("x"), number("y")];
        let (outlines, end) = outlines(&words, number("font-size"));
        let Ends([left, top, right, bottom]) = outlines?;
        let from = match text.attribute("text-anchor") {
            None => x,
            Some("middle") => x - 0.5 * end,
            Some(other) => {
                assert_eq!(other, "end");
                x - end
            }
        };
        let [left, right, top, bottom] = [from + left, from + right, y + top, y + bottom];
        let Some(turned) = text.attribute("transform") else {
            return Some((words, Ends([left, top, right, bottom]), true));
        };
        // A quarter of a turn to the left about a place.
        let about = turned
            .strip_prefix("rotate(-90 ")
            .unwrap()
            .strip_suffix(')');
        let (u, v) = about.unwrap().split_once(' ').unwrap();
        let [u, v] = [u, v].map(|at| at.parse::<f64>().unwrap());
        let ends = [u + top - v, v + u - right, u + bottom - v, v + u - left];
        Some((words, Ends(ends), false))
    });
    boxed.collect()
}

fn one(series: Vec<Series>) -> Figure {
    let mut panel = Panel::new(Axis::new("x [m]"), Axis::new("y [N]"));
    panel.series = series;
    Figure::new("t").panel(panel)
}

/// Every text lies on the paper, and none covers another.
fn check_texts(name: &str, figure: &Figure) {
    let svg = figure.to_svg().unwrap();
    let ([w, h], labels) = (size(&svg), texts(&svg));
    for (words, ends, _) in &labels {
        let [left, top, right, bottom] = ends.0;
        let within = left.min(top) >= PIXEL && right <= w - PIXEL && bottom <= h - PIXEL;
        assert!(within, "{name}: \"{words}\" leaves the paper: {ends:?}");
    }
    // boxes of turned texts are larger than the texts, so only upright ones can be told
    let upright: Vec<_> = labels.iter().filter(|t| t.2).collect();
    assert!(upright.len() > 5, "{name}");
    for (i, (a, ra, _)) in upright.iter().enumerate() {
        for (b, rb, _) in &upright[..i] {
            assert!(!ra.meets(rb), "{name}: \"{a}\" covers \"{b}\"");
        }
    }
}

#[test]
fn no_text_is_cut_off_and_none_covers_another() {
    for (name, figure) in figures::all() {
        check_texts(name, &figure);
    }
}

#[test]
fn texts_of_neighbouring_marks_stay_apart() {
    let mut figure = one(vec![Series::line("a line", vec![(0.0, 0.0), (1.0, 1.0)])]);
    for (i, at) in [0.0, 0.02, 0.03, 0.5, 0.51, 0.52, 0.97, 0.98, 1.0]
        .into_iter()
        .enumerate()
    {
        figure.panels[0]
            .marks
            .push(Mark::new(at, at, format!("operating point {i}")));
    }
    check_texts("marks", &figure);
}

#[test]
fn texts_of_lines_that_end_together_stay_apart() {
    let series = (0..12).map(|i| {
        let end = 1.0 + 0.001 * f64::from(i);
        Series::line("", vec![(0.0, 0.0), (1.0, end)]).end_label(format!("variant {i}"))
    });
    check_texts("ends", &one(series.collect()));
}

#[test]
fn the_same_figure_gives_the_same_bytes() {
    for (_, figure) in figures::all() {
        assert_eq!(figure.to_svg().unwrap(), figure.clone().to_svg().unwrap());
    }
    let figure = figures::models();
    assert_eq!(figure.to_png().unwrap(), figure.to_png().unwrap());
}

#[test]
fn the_image_is_a_png_of_ten_pixels_per_millimetre() {
    let png = figures::isobars(400.0).to_png().unwrap();
    assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n");
    let side = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
    assert_eq!((side(16), side(20)), (1600, 1000));
    let small = one(vec![Series::new("", vec![(0.0, 0.0), (1.0, 1.0)])]).size_mm(80.0, 60.0);
    let png = small.to_png().unwrap();
    assert_eq!(u32::from_be_bytes(png[16..20].try_into().unwrap()), 800);
}

#[test]
fn the_image_holds_ink_for_texts() {
    // without a font the title would leave no trace
    let with = one(vec![]).to_png().unwrap();
    let mut figure = one(vec![]);
    figure.title = "another title altogether".to_owned();
    assert_ne!(with, figure.to_png().unwrap());
}

#[test]
fn texts_are_escaped() {
    let nasty = "a<b>&\"c\"'d' \u{1}\u{fffe}]]>";
    let figure = Figure::new(nasty).caption(nasty).panel(
        Panel::new(Axis::new(nasty), Axis::new(nasty))
            .title(nasty)
            .series(Series::new(nasty, vec![(0.0, 0.0), (1.0, 1.0)]).end_label(nasty))
            .mark(Mark::new(0.5, 0.5, nasty)),
    );
    let svg = figure.to_svg().unwrap();
    assert!(svg.contains("a&lt;b&gt;&amp;&quot;c&quot;&#39;d&#39;"));
    assert!(!svg.contains("<b>") && !svg.contains('\u{1}') && !svg.contains('\u{fffe}'));
    parse(&svg);
}

#[test]
fn a_gap_breaks_the_line_and_reaches_no_text() {
    let points = vec![
        (0.0, 1.0),
        (1.0, 2.0),
        (2.0, f64::NAN),
        (3.0, 2.0),
        (f64::INFINITY, 3.0),
        (4.0, 1.0),
        (5.0, 1.0),
    ];
    let svg = one(vec![Series::line("", points)]).to_svg().unwrap();
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    let line = svg
        .lines()
        .find(|l| l.contains("#0072b2") && l.starts_with("<path"))
        .unwrap();
    // two pieces of line; the point between the gaps is alone
    assert_eq!(line.matches('M').count(), 2, "{line}");
    assert_eq!(svg.matches("a1.8 1.8 0 1 0 3.6 0").count(), 1);
}

#[test]
fn lines_end_at_the_border_of_the_plot() {
    let mut figure = one(vec![Series::line("", vec![(-1e9, -1e9), (1e9, 1e9)])]);
    figure.panels[0].x.range = Some((0.0, 1.0));
    figure.panels[0].y.range = Some((0.0, 1.0));
    let svg = figure.to_svg().unwrap();
    let line = svg.lines().find(|l| l.contains("#0072b2")).unwrap();
    let numbers: Vec<f64> = line
        .split('"')
        .nth(1)
        .unwrap()
        .split(['M', 'L', ' '])
        .filter_map(|n| n.parse().ok())
        .collect();
    assert_eq!(numbers.len(), 4);
    assert!(
        numbers.iter().all(|n| (0.0..=640.0).contains(n)),
        "{numbers:?}"
    );
}

#[test]
fn odd_data_give_a_figure() {
    let cases: Vec<Vec<(f64, f64)>> = vec![
        vec![],
        vec![(1.0, 2.0)],
        vec![(f64::NAN, f64::NAN)],
        vec![(3.0, 3.0); 10],
        vec![(0.0, 0.0), (0.0, 0.0)],
        vec![(1e-200, 1e200), (2e-200, 3e200)],
        vec![(1e9, 1.0), (1e9 + 1.0, 1.0 + 1e-12)],
        vec![(-1e299, 1.0), (1e299, 2.0)],
    ];
    for points in cases {
        for style in [Style::Auto, Style::Points] {
            let series = Series::new("s", points.clone())
                .style(style)
                .end_label("end");
            let svg = one(vec![series]).to_svg().unwrap();
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{points:?}");
            parse(&svg);
        }
    }
    assert!(
        one(vec![])
            .to_svg()
            .unwrap()
            .contains("no data in this range")
    );
}

#[test]
fn impossible_figures_are_refused_with_the_reason() {
    let refused = |figure: &Figure, words: &str| {
        assert!(
            figure
                .to_svg()
                .is_err_and(|error| error.to_string().contains(words)),
            "{words}"
        );
    };
    refused(&Figure::new("t"), "the figure \"t\" has no panel");
    for (low, high) in [
        (1.0, 1.0),
        (2.0, 1.0),
        (f64::NAN, 1.0),
        (0.0, f64::INFINITY),
        (-1.7e308, 1.7e308),
    ] {
        let mut figure = one(vec![]);
        figure.panels[0].y.range = Some((low, high));
        refused(&figure, "axis \"y [N]\": ");
    }
    refused(
        &one(vec![Series::new("", vec![(0.0, -1.7e308), (1.0, 1.7e308)])]),
        "is not a range",
    );
    for (w, h) in [(0.0, 100.0), (f64::NAN, 100.0), (160.0, 1e6)] {
        refused(&one(vec![]).size_mm(w, h), "(20 to 2000 mm a side)");
    }
    refused(&one(vec![]).size_mm(25.0, 25.0), "panel 1 of the figure");
}

#[test]
fn long_series_are_thinned_but_keep_their_peaks() {
    let mut points: Vec<(f64, f64)> = (0..100_000)
        .map(|i| (f64::from(i), (f64::from(i) * 0.37).sin()))
        .collect();
    points[54_321].1 = 10.0;
    let svg = one(vec![
        Series::line("", points.clone()),
        Series::scatter("", points),
    ])
    .to_svg()
    .unwrap();
    assert!(svg.len() < 1_500_000, "{}", svg.len());
    let line = svg.lines().find(|l| l.contains("#0072b2")).unwrap();
    let ys = line
        .split('"')
        .nth(1)
        .unwrap()
        .split(['M', 'L'])
        .filter_map(|p| p.split(' ').nth(1));
    let highest = ys
        .filter_map(|y| y.parse::<f64>().ok())
        .fold(f64::INFINITY, f64::min);
    assert!(highest < 60.0, "the peak is lost: {highest}");
}

#[test]
fn panels_with_the_same_entries_share_one_legend() {
    let svg = figures::grid().to_svg().unwrap();
    assert_eq!(svg.matches(">thick wall<").count(), 1);
    let mut figure = figures::grid();
    figure.panels[0].series[0].label = "something else".to_owned();
    // the same sample would now mean two things: every panel explains itself
    assert_eq!(figure.to_svg().unwrap().matches(">thick wall<").count(), 6);
}

#[test]
fn series_of_one_name_and_look_share_an_entry() {
    let line = |k: f64| Series::line("model", vec![(0.0, 0.0), (1.0, k)]).colour(0);
    let svg = one(vec![line(1.0), line(2.0), line(3.0)]).to_svg().unwrap();
    assert_eq!(svg.matches(">model<").count(), 1);
}

#[test]
fn many_and_long_entries_stay_on_the_paper() {
    let long = "a very long name that goes on and on, as names of models with all their options \
        do, and on";
    for count in [1, 9, 40] {
        let series = (0..count).map(|i| {
            Series::new(
                format!("{i} {long} {long}"),
                vec![(0.0, 0.0), (0.5, f64::from(i)), (1.0, 1.0)],
            )
        });
        let svg = one(series.collect()).to_svg().unwrap();
        let ([w, _], labels) = (size(&svg), texts(&svg));
        assert!(
            !labels.is_empty() && labels.iter().all(|t| t.1.0[2] <= w),
            "{count}"
        );
    }
}

#[test]
fn a_thousand_marks_among_lines_have_their_texts() {
    let line = |i: u32| {
        Series::line("", vec![(0.0, 0.0), (0.9, f64::from(i))]).end_label(format!("line {i}"))
    };
    let mut figure = one((0..200).map(line).collect());
    for i in 0..1000 {
        let (x, y) = (f64::from(i % 37) / 37.0, f64::from(i % 91) * 2.0);
        figure.panels[0]
            .marks
            .push(Mark::new(x, y, format!("mark {i}")));
    }
    let texts = texts(&figure.to_svg().unwrap());
    let marks = texts.iter().filter(|text| text.0.starts_with("mark "));
    assert_eq!(marks.count(), 1000);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn any_data_give_valid_svg_or_a_typed_error(
        points in prop::collection::vec((prop::num::f64::ANY, prop::num::f64::ANY), 0..20),
        mark in (prop::num::f64::ANY, prop::num::f64::ANY),
        label in ".{0,20}",
    ) {
        let mut figure = one(vec![Series::new(label.clone(), points).end_label(label.clone())]);
        figure.panels[0].marks.push(Mark::new(mark.0, mark.1, label));
        if let Ok(svg) = figure.to_svg() {
            parse(&svg);
            figure.to_pdf().unwrap();
        }
    }
}

/// A band is a pale area below the lines, cut at the edges of the plot; it has no entry in the
/// legend.
#[test]
fn a_band_is_drawn_below_its_line() {
    let edges = [(0.0, 1.0, 3.0), (1.0, 2.0, 4.0), (2.0, 1.0, 30.0)];
    let line = Series::line("a line", vec![(0.0, 2.0), (1.0, 3.0), (2.0, 4.0)]).colour(0);
    let panel = Panel::new(Axis::new("x"), Axis::new("y").range(0.0, 5.0));
    let with = panel
        .clone()
        .series(line.clone())
        .series(Series::band(&edges).colour(0));
    let svg = Figure::new("f").panel(with).to_svg().unwrap();
    let area = svg
        .lines()
        .find(|l| l.contains("fill-opacity=\"0.14\""))
        .unwrap();
    let spots = area.matches(['M', 'L']).count();
    // Six corners, one of which lies above the plot: two cuts in its place.
    assert_eq!(spots, 7, "{area}");
    let place = |what: &str| svg.find(what).unwrap();
    assert!(place("fill-opacity=\"0.14\"") < place("stroke-width=\"1.7\""));
    let without = Figure::new("f").panel(panel.series(line)).to_svg().unwrap();
    assert_eq!(
        svg.matches("a line").count(),
        without.matches("a line").count()
    );
}
