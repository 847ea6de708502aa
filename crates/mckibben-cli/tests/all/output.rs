//! What an answer looks like: formats, units, columns, widths, figures, documents.

use crate::common::{
    Ran, assert_close, command, folder, json, json_in, mckibben, names, number, ran, root, run_in,
};
use serde_json::Value;

#[test]
fn units_are_read_and_change_what_people_see_and_nothing_else() {
    let bare = mckibben("force -D 40 -s 2 -L 285 --angle 28 -p 0.2 -e 0.1 --format json").ok();
    let units =
        mckibben("force -D 4cm -s 2mm -L 0.285m --angle 28deg -p 2bar -e 10% --format json").ok();
    assert_eq!(bare, units);
    for line in [
        "force -p 0.2 -e 0.1",
        "curve isobaric -p 0.1,0.2",
        "design -F 300 -e 10% -p 0.25 -D 40 -s 2 --model thick-wall",
    ] {
        let bar = mckibben(&format!("{line} --units bar")).ok();
        assert!(
            bar.text().contains("bar") && mckibben(line).ok().out != bar.out,
            "{line}"
        );
        for format in ["json", "csv"] {
            let of = |more| mckibben(&format!("{line} --format {format}{more}")).ok();
            assert_eq!(of(""), of(" --units psi"), "{line} {format}");
        }
    }
}

/// The columns of a table are keys of the answer, and the table is data for another command.
#[test]
fn csv_columns_are_the_json_keys() {
    for line in [
        "curve isobaric -D 40 -s 2 -p 0.1..0.2:0.05 -e 0..0.15:0.05",
        "curve isotonic -D 40 -s 2 -p 0.2..0.25:0.05 -F 550,600",
    ] {
        let csv = mckibben(&format!("{line} --format csv")).ok();
        let points = json(line)["points"].as_array().unwrap().clone();
        let mut reader = csv::Reader::from_reader(csv.text().as_bytes());
        let columns: Vec<String> = reader
            .headers()
            .unwrap()
            .iter()
            .map(str::to_owned)
            .collect();
        let records: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
        assert_eq!(records.len(), points.len());
        for (record, point) in records.iter().zip(&points) {
            for (key, field) in columns.iter().zip(record.iter()) {
                match &point[key] {
                    Value::Null => assert_eq!(field, "", "{key}"),
                    Value::String(s) => assert_eq!(field, s, "{key}"),
                    Value::Number(n) => {
                        assert_close(field.parse().unwrap(), n.as_f64().unwrap(), 1e-15)
                    }
                    other => assert_eq!(field, other.to_string(), "{key}"),
                }
            }
            let lists = ["warnings", "uncertainty_parts_n", "predicted_shift_n"];
            let mut keys = point.as_object().unwrap().keys();
            assert!(
                keys.all(|k| lists.contains(&k.as_str()) || columns.contains(k)),
                "{point}"
            );
        }
    }
    let dir = folder();
    let ask = |line: &str| json_in(dir.path(), line);
    let line = "curve isobaric -D 40 -s 2 -p 0.1..0.2:0.05 -e 0..0.15:0.05 -o curve.csv";
    run_in(dir.path(), line).ok();
    let same = ask("compare -D 40 -s 2 --models fe,ideal --data curve.csv");
    assert_eq!(same["reference"], "measured");
    let rms_n = |i: usize| number(&same["models"][i], "rms_n");
    assert!(rms_n(0) < 1e-6 && rms_n(1) > 1.0, "{same}");
    // Points without answer are left out.
    let line = "curve isobaric -p 0.2,0.3 --model paper -o some.csv";
    run_in(dir.path(), line).ok();
    assert_eq!(ask("compare --models paper --data some.csv")["points"], 21);
}

/// A result goes to a file whole, in the format of its ending; what fails leaves an older file as
/// it was, whatever the terminal.
#[test]
fn a_file_is_written_in_the_format_of_its_ending() {
    let dir = folder();
    let read = |name: &str| std::fs::read_to_string(dir.path().join(name)).unwrap();
    let line = "curve isobaric --model ideal -p 0.1,0.2 -e 0,0.1";
    for format in ["csv", "json"] {
        let saved = run_in(dir.path(), &format!("{line} -o x.{format}")).ok();
        assert!(saved.out.is_empty());
        assert_eq!(
            read(&format!("x.{format}")),
            mckibben(&format!("{line} --format {format}")).text()
        );
    }
    assert_eq!(
        run_in(
            dir.path(),
            "force -p 0.3 --model paper -o x.json --overwrite"
        )
        .code,
        2
    );
    assert_eq!(
        read("x.json"),
        mckibben(&format!("{line} --format json")).text()
    );
    let text = |columns: &str| {
        let line = "force -p 2.5bar -e 10% --model thick-wall --overwrite -o out.txt";
        let mut command = command(dir.path());
        ran(command
            .args(line.split(' '))
            .env("COLUMNS", columns)
            .output()
            .unwrap())
        .ok();
        read("out.txt")
    };
    assert_eq!(text("60"), text("200"));
    assert_eq!(names(dir.path()), ["out.txt", "x.csv", "x.json"]);
}

/// 88 mm are 249.45 points. Figures in a folder whose name is that of a muscle: the muscle answers by
/// its name as before.
#[test]
fn figures_are_whole() {
    let dir = folder();
    let words =
        "curve isobaric -D 50 -s 1 -p 1bar,2bar -e 0..0.2:0.05 --model paper --overwrite --plot f.";
    let read = |ending: &str| {
        run_in(dir.path(), &format!("{words}{ending}")).ok();
        std::fs::read(dir.path().join(format!("f.{}", &ending[..3]))).unwrap()
    };
    let png = read("png");
    assert!(png.starts_with(b"\x89PNG\r\n\x1a\n") && png.ends_with(b"IEND\xaeB`\x82"));
    let svg = String::from_utf8(read("svg")).unwrap();
    assert!(svg.contains("<svg") && svg.trim_end().ends_with("</svg>"));
    for (more, points) in [
        ("pdf", 160.0 * 72.0 / 25.4),
        ("pdf --plot-width 88mm", 249.45),
    ] {
        let pdf = read(more);
        assert!(pdf.starts_with(b"%PDF-1.") && pdf.ends_with(b"%%EOF"));
        let text = String::from_utf8_lossy(&pdf).into_owned();
        let size = text
            .split("/MediaBox [0 0 ")
            .nth(1)
            .unwrap()
            .split(' ')
            .next()
            .unwrap();
        assert!(
            (size.parse::<f64>().unwrap() - points).abs() < 0.01,
            "{size}"
        );
    }
    assert_eq!(
        names(dir.path()),
        ["f.pdf", "f.png", "f.svg"],
        "no temporary files"
    );
    let named = || json_in(dir.path(), "force paper -p 2bar -e 10%");
    let before = named();
    let table = root().join("data/campaign/paper.csv");
    let fit = format!("fit {} --method paper --figures paper", table.display());
    run_in(dir.path(), &fit).ok();
    assert_eq!(named(), before);
    let folder = dir.path().join("paper");
    // Figures 5 to 12, and four tables.
    assert_eq!(names(&folder).len(), 8 + 4);
    let file = folder.join("figure_5_isobaric_curves.svg");
    assert!(std::fs::read(file).unwrap().starts_with(b"<svg"));
}

fn with_columns(words: &str, columns: Option<&str>) -> Ran {
    let mut command = command(&root());
    command.args(words.split(' '));
    if let Some(columns) = columns {
        command.env("COLUMNS", columns);
    }
    ran(command.output().unwrap())
}

fn widest(text: &str) -> usize {
    text.lines()
        .map(|line| line.chars().count())
        .max()
        .unwrap_or(0)
}

const WIDE: [&str; 9] = [
    "force -p 2.5bar -e 10% --model thick-wall",
    "contraction -p 2.5bar --load mass:20kg --model thick-wall",
    "check -p 2bar --model thick-wall",
    "design -F 700N -e 15% -p 2.5bar --model thick-wall --all",
    "design -F 700N -e 15% -p 100bar -D 20,30 -s 1,2 --model thick-wall",
    "curve isobaric -p 0.5..2.5:0.25bar -e 0..30%:10% --model thick-wall",
    "joint examples/elbow.toml -p 2bar,1bar -p 3bar,1bar --model thick-wall",
    "rubber crates/mckibben-cli/tests/tension/zwick.csv --set gauge_length=25mm,area=8mm2",
    "parts show fe",
];

#[test]
fn text_fits_a_terminal_of_80_columns_and_tables_in_files_100() {
    for words in WIDE {
        let ran = with_columns(words, Some("80"));
        assert!(
            widest(ran.text()) <= 80,
            "{words}: {} columns\n{}",
            widest(ran.text()),
            ran.text()
        );
        let ran = with_columns(words, None);
        let wide = ran.text().lines().filter(|line| line.chars().count() > 100);
        // A sentence has no columns: no two blanks stand in it.
        let tables: Vec<&str> = wide
            .filter(|line| line.trim_start().contains("  "))
            .collect();
        assert!(tables.is_empty(), "{words}: {tables:#?}");
    }
}

/// In a terminal: one of 80 columns, made by `script`, which every Linux has.
#[cfg(target_os = "linux")]
#[test]
fn in_a_terminal_no_progress_bar_appears_before_half_a_second() {
    let program = env!("CARGO_BIN_EXE_mckibben");
    let words = "design -F 700N -e 15% -p 2.5bar --model thick-wall --all";
    let line = format!("stty rows 24 cols 80; {program} {words}");
    let output = std::process::Command::new("script")
        .args(["-qec", &line, "/dev/null"])
        .current_dir(root())
        .env("TERM", "xterm")
        .env_remove("COLUMNS")
        .output();
    let Ok(output) = output else {
        return eprintln!("skipped: there is no `script`");
    };
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(
        text.contains("blocked force") && !text.contains("left") && !text.contains("a second"),
        "{text}"
    );
    let shown = text
        .lines()
        .map(|line| line.trim_end_matches('\r').replace("\u{1b}[0m", ""));
    assert!(
        shown
            .filter(|l| !l.contains('\u{1b}'))
            .all(|l| l.chars().count() <= 80),
        "{text}"
    );
}
