//! What holds for every figure that a command draws.

use crate::{refusal, reply};
use mckibben_report::{Figure, Panel, Series, Style};
use serde_json::{Value, json};
use std::path::Path;

fn text_file(name: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(name);
    let name = path.file_name().unwrap().to_string_lossy();
    json!({ "name": name, "text": std::fs::read_to_string(&path).unwrap() })
}

/// Figures of every command that has one, with few curves and many, with bands and without.
fn figures() -> Vec<(String, Figure)> {
    let nine: Vec<f64> = (1..=9).map(|i| 0.025 * f64::from(i)).collect();
    let bench = text_file("examples/bench.toml");
    let points = text_file("examples/bench.csv");
    let rows = (0..81).map(|k| {
        let (p, e) = (0.02 * f64::from(k / 9 + 1), 0.02 * f64::from(k % 9));
        format!("{p},{e},{}\n", 1500.0 * p * (1.0 - 3.0 * e))
    });
    let table = String::from("pressure_mpa,contraction,force_n\n") + &rows.collect::<String>();
    let of_nine = json!({ "name": "nine.csv", "text": table });
    let joint = || {
        let muscle = text_file("examples/biceps.toml");
        json!({ "joint": text_file("examples/elbow.toml"), "muscles": [muscle, muscle], "model": "universal" })
    };
    let with = |mut request: Value, more: Value| {
        request
            .as_object_mut()
            .unwrap()
            .extend(more.as_object().unwrap().clone());
        request
    };
    let curve = |test: &str, model: &str| json!({ "test": test, "model": model, "pressures_mpa": [0.1, 0.2], "contractions": [0.0, 0.1, 0.2, 0.3], "forces_n": [100, 300] });
    let only = |request: Value, without: &str| {
        let mut request = request;
        request.as_object_mut().unwrap().remove(without);
        request
    };
    let requests = vec![
        ("curve", only(curve("isobaric", "ideal"), "forces_n")),
        ("curve", only(curve("isobaric", "fe"), "forces_n")),
        ("curve", only(curve("isometric", "universal"), "forces_n")),
        (
            "curve",
            only(curve("isotonic", "universal"), "contractions"),
        ),
        (
            "curve",
            json!({ "test": "isobaric", "model": "universal", "pressures_mpa": nine, "contractions": [0.0, 0.1, 0.2] }),
        ),
        (
            "curve",
            json!({ "test": "isobaric", "model": "universal", "pressures_mpa": [0.1, 0.2], "contractions": [0.0, 0.1, 0.2], "load": "mass:10kg" }),
        ),
        ("study", json!({})),
        (
            "compare",
            json!({ "models": ["ideal", "paper", "universal"], "pressures_mpa": [0.1, 0.2], "contractions": [0.0, 0.1, 0.2] }),
        ),
        (
            "compare",
            json!({ "models": ["universal", "thick-wall"], "muscle": { "file": bench }, "data": [points] }),
        ),
        (
            "identify",
            json!({ "muscle": { "file": bench }, "data": [points], "model": "thick-wall" }),
        ),
        (
            "identify",
            json!({ "muscle": { "file": bench }, "data": [of_nine], "model": "thick-wall" }),
        ),
        (
            "joint",
            with(
                joint(),
                json!({ "pressures_mpa": [[0.2, 0.1], [0.1, 0.1]], "angles_deg": [-40, -20, 0, 20, 40] }),
            ),
        ),
        (
            "joint",
            with(joint(), json!({ "map": 8, "max_pressure_mpa": 0.3 })),
        ),
        (
            "motion",
            json!({ "drive": text_file("examples/drive.toml"), "muscle": text_file("examples/prototype.toml"), "model": "universal" }),
        ),
        (
            "simulate",
            json!({ "test": "isometric", "pressures_mpa": nine, "contractions": [0.05] }),
        ),
        (
            "simulate",
            json!({ "test": "isometric", "pressures_mpa": [0.1, 0.2], "contractions": [0.05, 0.1] }),
        ),
        (
            "design",
            json!({ "force_n": 500, "contraction": 0.05, "max_pressure_mpa": 0.25, "outer_diameter_mm": 30, "wall_mm": 2, "model": "paper" }),
        ),
        (
            "rubber",
            json!({ "data": [text_file("data/treloar/tension.csv")], "laws": ["yeoh", "neo-hookean"] }),
        ),
        (
            "rubber",
            json!({ "data": [text_file("data/treloar/tension.csv")] }),
        ),
    ];
    requests
        .into_iter()
        .map(|(command, request)| {
            let figure = if command == "rubber" {
                json!(true)
            } else {
                json!("MPa")
            };
            let answer = reply(command, with(request.clone(), json!({ "figure": figure })));
            let name = format!("{command} {:.200}", request.to_string());
            let figure = serde_json::from_value(answer["figure"].clone())
                .unwrap_or_else(|e| panic!("{name}: {e}"));
            (name, figure)
        })
        .collect()
}

fn seen(series: &Series) -> Vec<(f64, f64)> {
    series
        .points
        .iter()
        .copied()
        .filter(|(x, y)| x.is_finite() && y.is_finite())
        .collect()
}

fn last_x(series: &Series) -> f64 {
    seen(series)
        .iter()
        .map(|p| p.0)
        .fold(f64::NEG_INFINITY, f64::max)
}

/// What is wrong with a panel of a figure.
fn faults(figure: &Figure, panel: &Panel) -> Vec<String> {
    let mut out = vec![];
    let look = |s: &Series, i: usize| (s.style, s.colour.unwrap_or(i));
    let all: Vec<(usize, &Series)> = panel.series.iter().enumerate().collect();
    for (i, series) in &all {
        // Every entry of the legend is drawn, and one text stands for one kind of line.
        if !series.label.is_empty() {
            let same = || all.iter().filter(|(_, other)| other.label == series.label);
            if same().all(|(_, other)| seen(other).is_empty()) {
                out.push(format!("nothing is drawn of \"{}\"", series.label));
            }
            let lines = same().filter(|(_, other)| other.style != Style::Points);
            if lines
                .clone()
                .any(|(j, other)| look(other, *j) != look(series, *i))
                && series.style != Style::Points
            {
                out.push(format!("two lines are called \"{}\"", series.label));
            }
        }
        // Every line of a colour with a meaning is named there or in another panel, or has the
        // colour of one that is; the caption says what dots are.
        let named = |(j, other): (usize, &Series)| {
            look(other, j).1 == look(series, *i).1
                && !(other.label.is_empty() && other.end_label.is_empty())
        };
        let is_line = ![Style::Band, Style::Points].contains(&series.style) && !series.neutral;
        let is_named = figure
            .panels
            .iter()
            .any(|p| p.series.iter().enumerate().any(named));
        if is_line && panel.series.len() > 1 && !is_named {
            out.push(format!("line {i} has no name"));
        }
        // A band ends where its line does.
        if series.style == Style::Band {
            let lines = all.iter().filter(|(j, other)| {
                look(other, *j).1 == look(series, *i).1
                    && ![Style::Band, Style::Points, Style::Dotted].contains(&other.style)
            });
            let end = lines
                .map(|(_, line)| last_x(line))
                .fold(f64::NEG_INFINITY, f64::max);
            if (end - last_x(series)).abs() > 1e-9 * end.abs() {
                out.push(format!(
                    "band {i} ends at {} and its line at {end}",
                    last_x(series)
                ));
            }
        }
    }
    out
}

#[test]
fn what_a_figure_announces_is_drawn_and_what_is_drawn_is_named() {
    let mut wrong = vec![];
    for (name, figure) in figures() {
        let has_band = figure
            .panels
            .iter()
            .flat_map(|p| &p.series)
            .any(|s| s.style == Style::Band);
        if has_band != figure.caption.contains("band") {
            wrong.push(format!(
                "{name}: band {has_band}, and the caption: {}",
                figure.caption
            ));
        }
        let faults = figure
            .panels
            .iter()
            .flat_map(|panel| faults(&figure, panel));
        wrong.extend(faults.map(|fault| format!("{name}: {fault}")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Of nine pressures six are drawn, of nine shapes five: the caption says so.
#[test]
fn what_is_left_out_of_a_figure_is_said() {
    let said: Vec<String> = figures()
        .into_iter()
        .map(|(_, figure)| figure.caption)
        .collect();
    for part in [
        "6 of 9 pressures are drawn",
        "5 of 9 shapes are drawn",
        " laws are drawn",
    ] {
        assert!(
            said.iter().any(|caption| caption.contains(part)),
            "{part}: {said:?}"
        );
    }
}

/// The rows of the paper's campaign that are wanted, with another angle of the braid.
fn campaign(angle: &str, wanted: impl Fn(f64) -> bool) -> Value {
    let mut file = text_file("data/campaign/paper.csv");
    let text = file["text"].as_str().unwrap();
    let diameter = |line: &str| line.split(',').next().unwrap().parse::<f64>();
    let lines = text.lines().filter(|l| diameter(l).map_or(true, &wanted));
    let lines: Vec<String> = lines
        .map(|l| l.replacen(",28,", &format!(",{angle},"), 1))
        .collect();
    file["text"] = lines.join("\n").into();
    file
}

/// Figures 5 to 12 of a table, by number.
fn of_a_fit(request: Value) -> impl Fn(usize) -> Figure {
    let answer = reply("fit", request);
    move |number| {
        let figures = answer["figures"].as_array().unwrap();
        serde_json::from_value(figures[number - 5]["figure"].clone()).unwrap()
    }
}

/// The legend names every kind of line, the published formula where it is drawn; the rule of the
/// paper for D0 below 35 mm stands where such curves are left out.
#[test]
fn figures_of_a_fit_say_what_they_show() {
    let paper = of_a_fit(json!({ "table": campaign("28", |_| true), "figures": true,
        "method": "paper", "hold_out_mm": [35] }));
    let own = of_a_fit(
        json!({ "table": campaign("24", |d| d > 35.0), "figures": true,
        "method": "paper" }),
    );
    let legend = |figure: &Figure| -> Vec<Vec<(Style, String)>> {
        let named = |p: &Panel| {
            let named = p.series.iter().filter(|s| !s.label.is_empty());
            named.map(|s| (s.style, s.label.clone())).collect()
        };
        figure.panels.iter().map(named).collect()
    };
    let entry = |style, label: &str| (style, label.to_owned());
    let fitted = entry(Style::Line, "paper-method");
    let three = vec![
        entry(Style::Points, "table, held out of the fit"),
        fitted.clone(),
        entry(Style::Dashed, "paper"),
    ];
    assert_eq!(legend(&paper(12)), vec![three; 5]);
    let two = vec![entry(Style::Points, "table"), fitted];
    assert_eq!(legend(&own(12)), vec![two; 5]);
    let dashed = |p: &Panel| p.series.iter().any(|s| s.style == Style::Dashed);
    assert!(!own(12).panels.iter().any(dashed));
    assert!(paper(12).caption.contains("where the table pulls"));
    let rule = |figure: Figure| figure.caption.contains("D0 < 35");
    assert!(rule(paper(12)) && !(5..9).any(|n| rule(paper(n))));
    assert!(!(5..13).any(|n| rule(own(n))));
    // Without the prototype the first muscle is shown.
    assert!(own(5).title.ends_with("D0 40 mm, s 1 mm"));
    assert!(paper(5).title.ends_with("D0 30 mm, s 3 mm"));
    // Of shifted curves the axes are those of the one that is not shifted.
    for (upper, lower) in [(0, 2), (1, 3)] {
        let [upper, lower] = [upper, lower].map(|i| paper(6).panels[i].clone());
        assert!(lower.y.label.contains("front curve") && lower.x.label.contains("front curve"));
        assert_eq!(upper.series[0].points, lower.series[0].points);
    }
    assert!(paper(6).caption.contains("further right and up"));
}

#[test]
fn muscles_that_are_not_in_the_table_are_refused_with_those_that_are() {
    for (more, parts) in [
        (
            json!({ "hold_out_mm": [35, 33] }),
            ["D0 33 mm", "30, 35, 40, 45, 50"],
        ),
        (
            json!({ "hold_out_mm": "31..34" }),
            ["of this range", "30, 35, 40, 45, 50"],
        ),
        (json!({ "hold_out_share": 1.2 }), ["120 %", "no muscle"]),
        (json!({ "hold_out_share": 0 }), ["0 %", "no muscle"]),
        (
            json!({ "hold_out_mm": 35, "hold_out_share": 0.2 }),
            ["diameters and a share", "leave one out"],
        ),
    ] {
        let mut request = json!({ "table": text_file("data/campaign/paper.csv") });
        request
            .as_object_mut()
            .unwrap()
            .extend(more.as_object().unwrap().clone());
        let problem = refusal("fit", request);
        assert_eq!(problem.field.as_deref(), Some("hold_out"));
        for part in parts {
            assert!(problem.message.contains(part), "{}", problem.message);
        }
    }
}

/// An identity: a range leaves out the diameters of the table in it, and a list of powers gives the
/// formula of those terms.
#[test]
fn a_range_of_diameters_is_left_out_and_a_list_of_powers_is_a_sum() {
    let table = text_file("data/campaign/paper.csv");
    let fit = |more: Value| {
        let mut request = json!({ "table": table });
        request
            .as_object_mut()
            .unwrap()
            .extend(more.as_object().unwrap().clone());
        reply("fit", request)
    };
    let range = fit(json!({ "hold_out_mm": "32..42" }));
    assert_eq!(range, fit(json!({ "hold_out_mm": [35, 40] })));
    assert_eq!(range["kind"], "global");
    let held = &range["errors"]["held_out"]["outer_diameters_mm"];
    assert_eq!(held, &json!([35.0, 40.0]));
    let powers = json!({ "name": "powers.json", "text": "[[0,1,0,0],[0,1,1,0]]" });
    let own = fit(json!({ "terms": powers }));
    assert_eq!(own["terms"].as_array().unwrap().len(), 2);
    let formula = json!({ "name": "own.json", "text": own.to_string() });
    assert_eq!(fit(json!({ "terms": formula }))["terms"], own["terms"]);
}
