//! The PDF: of the figure's size, with every shape and text of the drawing.

use crate::figures;
use flate2::read::ZlibDecoder;
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

/// The streams of a file, without their compression.
fn streams(pdf: &[u8]) -> Vec<String> {
    let starts = (0..pdf.len()).filter(|i| pdf[*i..].starts_with(b">>\nstream\n"));
    let unpacked = starts.map(|start| {
        let stream = between(&pdf[start..], ">>\nstream\n", "\nendstream\nendobj\n");
        let before = &pdf[..start];
        let length = before.windows(8).rposition(|w| w == b"/Length ").unwrap();
        assert_eq!(
            text(between(&before[length..], "/Length ", "\n")),
            stream.len().to_string()
        );
        let mut content = vec![];
        ZlibDecoder::new(stream).read_to_end(&mut content).unwrap();
        String::from_utf8_lossy(&content).into_owned()
    });
    unpacked.collect()
}

/// 1 in is 25.4 mm and 72 points; the paper is white.
#[test]
fn the_page_has_the_size_of_the_figure_and_all_of_its_shapes_and_texts() {
    for (name, figure) in figures::all() {
        let svg = figure.to_svg().unwrap();
        let pdf = figure.to_pdf().unwrap();
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
        let content = &streams(&pdf)[0];
        let ends = |word: &str| {
            let operator = |line: &&str| line.split(' ').next_back() == Some(word);
            content.lines().filter(operator).count()
        };
        let drawn = |element: &str| svg.matches(&format!("<{element} ")).count();
        let shapes = drawn("rect") + drawn("path") + drawn("circle");
        assert_eq!(ends("f") + ends("B") + ends("S"), shapes, "{name}");
        assert_eq!(ends("Tj"), drawn("text"), "{name}");
        assert!(shapes > 5 && drawn("text") > 5);
        assert_eq!(ends("q"), ends("Q"), "{name}");
        assert!(
            !content.contains("NaN") && !content.contains("inf"),
            "{name}"
        );
    }
}

/// Texts are glyphs of the embedded font, whose characters are known: they can be searched.
#[test]
fn the_font_knows_its_characters() {
    let pdf = figures::isobars(400.0).to_pdf().unwrap();
    let all = streams(&pdf);
    let characters = all.last().unwrap();
    assert!(characters.contains("begincmap"));
    for c in "contraction ε [–]".chars() {
        assert!(characters.contains(&format!("> <{:04X}>", c as u32)), "{c}");
    }
    assert!(pdf.len() < 30_000, "{}", pdf.len());
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
