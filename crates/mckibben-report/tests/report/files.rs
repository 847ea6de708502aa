//! Saving and the page.

use std::fs;

use crate::figures;
use mckibben_report::{Axis, Figure, FigureError, Mark, Panel, Series};

#[test]
fn the_ending_names_the_format() {
    let folder = tempfile::tempdir().unwrap();
    let figure = figures::models();
    for (name, start) in [
        ("a.svg", &b"<svg"[..]),
        ("a.PNG", b"\x89PNG"),
        ("a.pdf", b"%PDF-1.4"),
        ("a.html", b"<!DOCTYPE html>"),
    ] {
        let path = folder.path().join(name);
        figure.save(&path).unwrap();
        assert!(fs::read(&path).unwrap().starts_with(start), "{name}");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 4, "a temporary file was left behind");
}

#[test]
fn unknown_endings_are_named() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.docx", "a", ".svg"] {
        let error = figures::models().save(&folder.path().join(name)).unwrap_err();
        assert!(matches!(error, FigureError::UnknownExtension { .. }), "{error}");
        let text = error.to_string();
        assert!(text.contains(".svg") && text.contains(".png") && text.contains(".html"), "{text}");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn a_missing_folder_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("nowhere/a.svg");
    let error = figures::models().save(&path).unwrap_err();
    assert!(matches!(&error, FigureError::NoFolder(folder) if folder.ends_with("nowhere")), "{error}");
}

#[test]
fn what_the_system_refuses_is_told_and_nothing_is_left() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.svg");
    fs::create_dir(&path).unwrap();
    let error = figures::models().save(&path).unwrap_err();
    assert!(matches!(&error, FigureError::Write(p, _) if *p == path), "{error}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_figure_that_cannot_be_drawn_leaves_the_old_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.svg");
    fs::write(&path, "old").unwrap();
    assert!(Figure::new("no panels").save(&path).is_err());
    assert_eq!(fs::read_to_string(&path).unwrap(), "old");
    figures::models().save(&path).unwrap();
    assert!(fs::read_to_string(&path).unwrap().starts_with("<svg"));
}

#[cfg(unix)]
#[test]
fn a_saved_figure_can_be_read_by_others_as_the_umask_allows() {
    use std::os::unix::fs::PermissionsExt as _;
    let folder = tempfile::tempdir().unwrap();
    let (plain, saved) = (folder.path().join("plain"), folder.path().join("a.svg"));
    fs::write(&plain, "").unwrap();
    figures::models().save(&saved).unwrap();
    let mode = |p| fs::metadata(p).unwrap().permissions().mode() & 0o777;
    assert_eq!(mode(&saved), mode(&plain));
}

#[test]
fn the_page_needs_nothing_from_elsewhere() {
    let html = figures::grid().to_html().unwrap();
    let outside = html.replace("http://www.w3.org/2000/svg", "");
    assert!(!outside.contains("http://") && !outside.contains("https://"));
    assert!(!outside.contains("src=") && !outside.contains("@import") && !outside.contains("url("));
    assert_eq!(html.matches("<details>").count(), 6);
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
    let figure = Figure::new("t").panel(
        Panel::new(Axis::new("x"), Axis::new("y"))
            .series(Series::new("s", vec![(0.1 + 0.2, -2.0), (f64::NAN, 1.0), (1e-7, 5.0)])),
    );
    let html = figure.to_html().unwrap();
    assert!(html.contains("<td>0.3</td><td>-2</td>"));
    assert!(html.contains("<td>1e-7</td><td>5</td>"));
    assert!(!html.contains("NaN"));
}

#[test]
fn a_figure_comes_back_from_its_data() {
    for (name, figure) in figures::all() {
        let json = serde_json::to_string(&figure).unwrap();
        assert_eq!(serde_json::from_str::<Figure>(&json).unwrap(), figure, "{name}");
    }
}

#[test]
fn gaps_are_null_in_the_data_and_few_keys_make_a_figure() {
    let gap = Series::new("s", vec![(0.0, 1.0), (1.0, f64::NAN)]);
    let json = serde_json::to_value(&gap).unwrap();
    assert_eq!(json["points"], serde_json::json!([[0.0, 1.0], [1.0, null]]));
    let back: Series = serde_json::from_value(json).unwrap();
    assert!(back.points[1].1.is_nan());
    let few =
        r#"{"panels": [{"x": {"label": "x [mm]"}, "series": [{"points": [[0, 1]], "style": "dash-dot"}]}]}"#;
    assert!(serde_json::from_str::<Figure>(few).unwrap().to_svg().unwrap().contains("x [mm]"));
}
