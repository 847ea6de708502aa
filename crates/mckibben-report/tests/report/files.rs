//! Files and the page.

use std::path::Path;

use crate::figures;
use mckibben_report::{Axis, Document, Figure, FigureError, Mark, Panel, Part, Series};

#[test]
fn the_ending_names_the_format() {
    let figure = figures::models();
    for (name, start) in [
        ("a.svg", &b"<svg"[..]),
        ("a.PNG", b"\x89PNG"),
        ("a.pdf", b"%PDF-1."),
        ("a.html", b"<!DOCTYPE html>"),
    ] {
        assert!(
            figure.bytes(Path::new(name)).unwrap().starts_with(start),
            "{name}"
        );
    }
}

#[test]
fn unknown_endings_are_named() {
    for name in ["a.docx", "a", ".svg"] {
        let error = figures::models().bytes(Path::new(name)).unwrap_err();
        assert!(
            matches!(error, FigureError::UnknownExtension { .. }),
            "{error}"
        );
        let text = error.to_string();
        assert!(
            text.contains(".svg") && text.contains(".png") && text.contains(".html"),
            "{text}"
        );
    }
}

#[test]
fn the_page_needs_nothing_from_elsewhere() {
    let html = figures::grid().to_html().unwrap();
    let outside = html.replace("http://www.w3.org/2000/svg", "");
    assert!(!outside.contains("http://") && !outside.contains("https://"));
    assert!(!outside.contains("src=") && !outside.contains("@import") && !outside.contains("url("));
    assert_eq!(html.matches("<h2>Data").count(), 6);
    assert_eq!(html.matches("<svg").count(), 1);
}

#[test]
fn texts_cannot_break_out_of_the_page() {
    let nasty = "</script><script>alert(1)</script>";
    let figure = Figure::new(nasty).panel(
        Panel::new(Axis::new(nasty), Axis::new(nasty))
            .series(Series::new(nasty, vec![(0.0, 1.0), (1.0, 2.0)]))
            .mark(Mark::new(0.5, 1.5, nasty)),
    );
    let html = figure.to_html().unwrap();
    assert!(!html.contains("<script"));
}

#[test]
fn the_table_holds_the_data_in_plain_numbers() {
    let figure = Figure::new("t").panel(Panel::new(Axis::new("x"), Axis::new("y")).series(
        Series::new("s", vec![(0.1 + 0.2, -2.0), (f64::NAN, 1.0), (1e-7, 5.0)]),
    ));
    let html = figure.to_html().unwrap();
    assert!(html.contains("<td>0.3</td><td>-2</td>"));
    assert!(html.contains("<td>0.0000001</td><td>5</td>"));
    assert!(!html.contains("NaN"));
}

#[test]
fn a_figure_comes_back_from_its_data() {
    for (name, figure) in figures::all() {
        let json = serde_json::to_string(&figure).unwrap();
        assert_eq!(
            serde_json::from_str::<Figure>(&json).unwrap(),
            figure,
            "{name}"
        );
    }
}

#[test]
fn gaps_are_null_in_the_data_and_few_keys_make_a_figure() {
    let gap = Series::new("s", vec![(0.0, 1.0), (1.0, f64::NAN)]);
    let json = serde_json::to_value(&gap).unwrap();
    assert_eq!(json["points"], serde_json::json!([[0.0, 1.0], [1.0, null]]));
    let back: Series = serde_json::from_value(json).unwrap();
    assert!(back.points[1].1.is_nan());
    let few = r#"{"panels": [{"x": {"label": "x [mm]"}, "series": [{"points": [[0, 1]], "style": "dash-dot"}]}]}"#;
    assert!(
        serde_json::from_str::<Figure>(few)
            .unwrap()
            .to_svg()
            .unwrap()
            .contains("x [mm]")
    );
}

/// What a user typed is in the page as text, wherever it comes from.
#[test]
fn texts_are_no_markup() {
    let evil = "</script><script>alert(1)</script>";
    let one = || evil.to_owned();
    let parts = vec![
        Part::Heading(one()),
        Part::Text(one()),
        Part::List(vec![one()]),
        Part::Table {
            head: vec![one()],
            rows: vec![vec![one()]],
        },
        Part::Body(format!("\"{evil}\"")),
    ];
    let html = Document {
        title: one(),
        title_block: vec![(one(), one())],
        lead: one(),
        parts,
        footer: one(),
    }
    .to_html("")
    .unwrap_or_default();
    assert!(
        html.len() > 1000 && !html.contains("<script>alert"),
        "{html}"
    );
}
