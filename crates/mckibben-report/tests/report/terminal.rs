//! The chart of characters.

use crate::figures;
use mckibben_report::{Axis, Figure, Mark, Panel, Series, Style};
use proptest::prelude::*;
use unicode_width::UnicodeWidthStr;

/// Drops the colour codes; anything else after an escape character would stay and show.
fn plain(text: &str) -> String {
    let mut out = String::new();
    let mut parts = text.split("\u{1b}[");
    out.push_str(parts.next().unwrap());
    for part in parts {
        out.push_str(part.split_once('m').unwrap().1);
    }
    out
}

fn check(text: &str, width: usize) {
    for line in text.lines() {
        let line = plain(line);
        assert!(line.as_str().width() <= width, "wider than {width}: {line}");
        assert_eq!(line.trim_end(), line, "trailing blanks");
    }
}

#[test]
fn no_line_is_wider_than_asked() {
    for (_, figure) in figures::all() {
        for width in [1, 2, 5, 13, 20, 40, 80, 120, 200] {
            for colour in [false, true] {
                check(&figure.to_text(width, 24, colour), width);
            }
        }
    }
}

#[test]
fn a_single_panel_keeps_to_the_height() {
    for (name, figure) in figures::all().into_iter().filter(|(_, f)| f.panels.len() == 1) {
        for height in [18, 24, 40] {
            let lines = figure.to_text(90, height, false).lines().count();
            assert!(lines <= height && lines + 8 >= height, "{name}: {lines} lines for {height}");
        }
    }
}

#[test]
fn without_colour_there_are_no_escape_codes_and_series_have_letters() {
    let text = figures::models().to_text(90, 28, false);
    assert!(!text.contains('\u{1b}'));
    for letter in ['a', 'b', 'c', 'd'] {
        assert!(text.contains(&format!("─{letter}─ ")), "no legend entry {letter}");
        let chart: String = text.lines().filter(|l| l.contains(['│', '┤'])).collect();
        assert!(chart.contains(letter), "no {letter} on a line");
    }
    assert!(text.matches('○').count() > 5, "measured points");
}

#[test]
fn with_colour_every_code_is_closed() {
    let text = figures::models().to_text(90, 28, true);
    assert!(text.contains("\u{1b}[38;5;32m"));
    for line in text.lines() {
        let last = line.rfind("\u{1b}[").map(|at| &line[at..]);
        assert!(last.is_none_or(|code| code.starts_with("\u{1b}[0m")), "{line:?}");
    }
}

#[test]
fn operating_points_are_marked_and_told() {
    let text = figures::isobars(400.0).to_text(100, 30, false);
    assert_eq!(text.matches('①').count(), 2);
    assert_eq!(text.matches('②').count(), 2);
    assert!(text.contains("② holds 5 kg at ε = 0.20 (0.2, 326.019)"));
    let single = Figure::new("t").panel(
        Panel::new(Axis::new("x"), Axis::new("y"))
            .series(Series::new("s", vec![(0.0, 0.0), (1.0, 1.0)]))
            .mark(Mark::new(0.5, 0.5, "here")),
    );
    assert_eq!(single.to_text(60, 20, false).matches('◎').count(), 2);
}

#[test]
fn lines_without_a_label_are_named_by_their_end_text() {
    let text = figures::isobars(0.0).to_text(100, 30, false);
    for p in ["0.1", "0.2", "0.3", "0.4", "0.5"] {
        assert_eq!(text.matches(&format!("{p} MPa")).count(), 1, "{p}:\n{text}");
    }
}

#[test]
fn panels_stand_side_by_side_where_there_is_room() {
    let narrow = figures::grid().to_text(80, 20, false).lines().count();
    let wide = figures::grid().to_text(200, 20, false).lines().count();
    assert!(wide * 2 < narrow, "{wide} and {narrow}");
}

#[test]
fn control_characters_do_not_reach_the_terminal() {
    let nasty = "a\u{1b}[2Jb\u{7}";
    let figure = Figure::new(nasty).caption(nasty).panel(
        Panel::new(Axis::new(nasty), Axis::new(nasty))
            .title(nasty)
            .series(Series::new(nasty, vec![(0.0, 0.0), (1.0, 1.0)]).style(Style::Dashed).end_label(nasty))
            .mark(Mark::new(0.5, 0.5, nasty)),
    );
    let text = figure.to_text(70, 20, false);
    assert!(text.chars().all(|c| c == '\n' || !c.is_control()));
}

#[test]
fn a_panel_that_cannot_be_drawn_says_why() {
    let figure = Figure::new("t").panel(Panel::new(Axis::new("x"), Axis::new("pull").range(2.0, 1.0)));
    assert!(figure.to_text(80, 20, false).contains("axis \"pull\": 2 to 1 is not a range"));
}

#[test]
fn long_series_are_quick() {
    let noise =
        |i: u32| (f64::from(i.wrapping_mul(2_654_435_761) >> 8), f64::from(i.wrapping_mul(40_503) % 9973));
    let points: Vec<_> = (0..100_000).map(noise).collect();
    let start = std::time::Instant::now();
    let figure =
        Figure::new("t").panel(Panel::new(Axis::new("x"), Axis::new("y")).series(Series::new("s", points)));
    check(&figure.to_text(100, 30, false), 100);
    assert!(start.elapsed().as_secs() < 30);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn any_size_and_text_keeps_the_width(
        width in 0_usize..140, height in 0_usize..50, text in ".{0,30}",
        points in prop::collection::vec((-1e3..1e3_f64, -1e3..1e3_f64), 0..30),
    ) {
        let figure = Figure::new(text.clone()).caption(text.clone()).panel(
            Panel::new(Axis::new(text.clone()), Axis::new(text.clone()))
                .series(Series::new(text.clone(), points.clone()).end_label(text.clone()))
                .series(Series::scatter("points", points))
                .mark(Mark::new(0.0, 0.0, text)),
        );
        for colour in [false, true] {
            check(&figure.to_text(width, height, colour), width.max(1));
        }
    }
}

#[test]
fn an_operating_point_keeps_its_own_colour() {
    let text = figures::isobars(400.0).to_text(100, 30, true);
    let line = text.lines().find(|l| l.contains('②') && l.contains(['│', '┤'])).unwrap();
    let before = line.split('②').next().unwrap();
    assert!(before.rfind("\u{1b}[0m").unwrap() > before.rfind("\u{1b}[38").unwrap(), "{line:?}");
}

#[test]
fn many_marks_and_series_do_not_flood_the_terminal() {
    let mut panel = Panel::new(Axis::new("x"), Axis::new("y"));
    for i in 0..2000 {
        panel = panel
            .mark(Mark::new(f64::from(i), 1.0, format!("m{i}")))
            .series(Series::new(format!("a rather long name {i}"), vec![(0.0, 0.0), (1.0, f64::from(i))]));
    }
    let text = Figure::new("t").panel(panel).to_text(80, 24, false);
    assert!(text.lines().count() < 110);
    assert!(text.contains("… and 1961 lines more"));
}
