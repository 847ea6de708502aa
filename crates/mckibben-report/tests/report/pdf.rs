//! The PDF: of the figure's size, with every path of the drawing.

use crate::figures;
use flate2::read::ZlibDecoder;
use mckibben_report::texts_as_outlines;
use resvg::usvg::{self, Group, Node};
use std::io::Read as _;

/// The bytes from `start` on, up to `end`.
fn between<'a>(bytes: &'a [u8], start: &str, end: &str) -> &'a [u8] {
    let find = |from: &[u8], what: &str| {
        from.windows(what.len())
            .position(|w| w == what.as_bytes())
            .unwrap()
    };
    let from = &bytes[find(bytes, start) + start.len()..];
    &from[..find(from, end)]
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).trim().to_owned()
}

fn paths(group: &Group) -> usize {
    let count = |node: &Node| match node {
        Node::Group(inner) => paths(inner),
        Node::Path(_) => 1,
        _ => 0,
    };
    group.children().iter().map(count).sum()
}

/// 1 in is 25.4 mm and 72 points.
#[test]
fn the_page_has_the_size_of_the_figure_and_all_of_its_paths() {
    for (name, figure) in figures::all() {
        let svg = figure.to_svg().unwrap();
        let pdf = figure.to_pdf().unwrap();
        let tree =
            usvg::Tree::from_str(&texts_as_outlines(&svg).unwrap(), &usvg::Options::default())
                .unwrap();
        let page: Vec<f64> = text(between(&pdf, "/MediaBox [", "]"))
            .split(' ')
            .map(|v| v.parse().unwrap())
            .collect();
        for (i, side) in ["width=\"", "height=\""].into_iter().enumerate() {
            let mm: f64 = text(between(svg.as_bytes(), side, "mm\"")).parse().unwrap();
            assert!(
                (page[2 + i] - mm * 72.0 / 25.4).abs() < 0.01,
                "{name}: {page:?} {mm}"
            );
        }
        let length: usize = text(between(&pdf, "/Length ", "\n")).parse().unwrap();
        let stream = between(&pdf, ">>\nstream\n", "\nendstream\nendobj\n");
        assert_eq!(stream.len(), length, "{name}");
        let mut content = String::new();
        ZlibDecoder::new(stream)
            .read_to_string(&mut content)
            .unwrap();
        let count = |word: &str| content.lines().filter(|line| *line == word).count();
        assert_eq!(
            (count("q"), count("Q")),
            (paths(tree.root()), paths(tree.root())),
            "{name}"
        );
        let painted = ["f", "f*", "B", "B*", "S"]
            .into_iter()
            .map(count)
            .sum::<usize>();
        assert_eq!(painted, paths(tree.root()), "{name}");
        assert!(
            !content.contains("NaN") && !content.contains("inf"),
            "{name}"
        );
    }
}

#[test]
fn a_column_of_a_journal_is_wide_enough() {
    for (name, figure) in [
        ("isobars", figures::isobars(400.0)),
        ("models", figures::models()),
        ("grid", figures::grid()),
        ("markers", figures::markers()),
    ] {
        for mm in [85.0, 180.0] {
            let svg = figure
                .clone()
                .width_mm(mm)
                .to_svg()
                .unwrap_or_else(|e| panic!("{name}, {mm}: {e}"));
            assert!(svg.contains(&format!("width=\"{mm}mm\"")), "{name}, {mm}");
        }
    }
}
