//! What is typed and what is said: the tables of `tests/rows`.

use crate::common::{assert_finite, copy, mckibben, names, run_in};
use serde_json::Value;
use std::path::Path;

/// Words, exit code, kind of the error, parts of what is said (`!`: is not said; `^`: standard
/// output begins with it), and the content of the file `bad.*` that the words name, in Latin-1.
/// Kind `all`: also as JSON and CSV.
const ROWS: &str = include_str!("../rows/rows.tsv");

fn flat(text: &str) -> String {
    text.split_whitespace().collect()
}

/// Whether a part is not said, or is although it is not to be.
fn wrong(said: &str, out: &str, part: &str) -> bool {
    // Moduli have a fixed unit, and so has a power law of the pressure.
    let is_fixed = |l: &&str| {
        ["modul", "1.2 MPa", "law ", "neo-hookean", "P/MPa"]
            .iter()
            .any(|w| l.contains(w))
    };
    match (part.strip_prefix('!'), part.strip_prefix('^')) {
        (Some(part), _) => said
            .lines()
            .filter(|l| !is_fixed(l))
            .any(|l| l.contains(part)),
        (_, Some(part)) => !out.starts_with(part),
        // However it is broken into lines.
        _ => !flat(said).contains(&flat(part)),
    }
}

fn judge(dir: &Path, row: &str) -> Result<(), String> {
    let cells: Vec<&str> = row.split('\t').collect();
    let [line, code, kind, parts, ..] = cells[..] else {
        return Err("too few cells".into());
    };
    if let Some(content) = cells.get(4) {
        let name = line
            .split(' ')
            .find(|word| word.starts_with("bad."))
            .unwrap();
        let bytes: Vec<u8> = content
            .replace("\\n", "\n")
            .chars()
            .map(|c| c as u8)
            .collect();
        std::fs::write(dir.join(name), bytes).unwrap();
    }
    let before = names(dir);
    let ran = run_in(dir, line);
    let said = format!("{}{}", ran.text(), ran.err);
    assert_finite(ran.text());
    let answers = kind.is_empty() || kind == "all" || kind == "-";
    let form = answers
        || line.contains("--format")
        || (ran.err.starts_with("error: ") && ran.out.is_empty());
    if ran.code.to_string() != code
        || !form
        || (!answers && (said.len() > 1200 || names(dir) != before))
    {
        return Err(said);
    }
    if let Some(part) = parts
        .split(";;")
        .find(|part| !part.is_empty() && wrong(&said, ran.text(), part))
    {
        return Err(format!("{part}: {said}"));
    }
    if kind == "all" {
        for format in ["json", "csv"] {
            assert_finite(
                run_in(dir, &format!("{line} --format {format}"))
                    .ok()
                    .text(),
            );
        }
    } else if !answers && !line.contains("--format") {
        // A value that is missing stays the last word.
        let json = match line.strip_suffix(" -p") {
            Some(command) => format!("{command} --format json -p"),
            None => format!("{line} --format json"),
        };
        let ran = run_in(dir, &json);
        let points = |q: Value| {
            q["points"]
                .as_array()
                .is_some_and(|p| p.iter().all(|q| q["status"] == kind))
        };
        if if ran.out.is_empty() {
            ran.error()["kind"] != kind
        } else {
            !points(ran.json())
        } {
            return Err(format!("{}{}", ran.text(), ran.err));
        }
    }
    Ok(())
}

#[test]
fn every_row_is_said() {
    let dir = copy();
    std::fs::create_dir_all(dir.path().join("folder.svg")).unwrap();
    std::fs::create_dir_all(dir.path().join("folder")).unwrap();
    let fit = "fit data/campaign/paper.csv --method global --hold-out 35 -o g.json";
    run_in(dir.path(), fit).ok();
    // Muscles with another angle than those of the paper.
    let table = std::fs::read_to_string(dir.path().join("data/campaign/paper.csv")).unwrap();
    std::fs::write(dir.path().join("own.csv"), table.replace(",28,", ",24,")).unwrap();
    let mut block = "";
    let mut failed = vec![];
    for row in ROWS.lines() {
        if let Some(heading) = row.strip_prefix("# ") {
            block = heading;
        } else if let Err(said) = judge(dir.path(), row) {
            failed.push(format!("{block}: {row}\n    {said}"));
        }
    }
    assert!(
        failed.is_empty(),
        "{} rows:\n{}",
        failed.len(),
        failed.join("\n")
    );
}

/// Groups of lines between blank lines. Constants of a rubber's law are separate columns.
#[test]
fn tables_have_the_same_columns_whatever_the_values() {
    let dir = copy();
    for group in include_str!("../rows/same_columns.txt").split("\n\n") {
        let mut heads = group.lines().map(|line| {
            let text = run_in(dir.path(), &format!("{line} --format csv"))
                .ok()
                .text()
                .to_owned();
            let columns = text
                .lines()
                .next()
                .unwrap_or_default()
                .split(',')
                .map(str::to_owned);
            columns
                .filter(|c| !["c10", "c01", "mu"].contains(&c.as_str()))
                .collect::<Vec<_>>()
        });
        let first = heads.next().unwrap();
        assert!(heads.all(|head| head == first), "{group}");
    }
}

/// Every flag of a question, with a value and with the question in which it counts: the answer
/// becomes another one, or the flag is refused.
#[test]
fn every_flag_of_a_question_counts_or_is_refused() {
    let dir = copy();
    let counts: Vec<Vec<&str>> = include_str!("../rows/counts.tsv")
        .lines()
        .map(|l| l.split('\t').collect())
        .collect();
    let help = mckibben("force --help").ok();
    let flags = help.text().lines().filter_map(|l| {
        let words = l
            .trim_start()
            .split_once("--")
            .filter(|(short, _)| short.is_empty() || short.len() == 4)?;
        words.1.split([' ', '=']).next()
    });
    // The others say how an answer is shown.
    let flags: Vec<&str> = flags
        .filter(|f| !["format", "units", "output", "overwrite", "help"].contains(f))
        .collect();
    assert!(flags.len() > 20, "{flags:?}");
    // What a key of the muscle file says counts as well.
    let keys = counts
        .iter()
        .map(|c| c[0])
        .filter(|name| name.contains('.'));
    for flag in flags.into_iter().chain(keys) {
        let known = counts.iter().find(|c| c[0] == flag);
        let [_, value, with] =
            known.unwrap_or_else(|| panic!("say in which question --{flag} counts"))[..]
        else {
            panic!("{flag}")
        };
        let mut base = format!("force my.toml --format json {with}");
        for (given, usual) in [
            ("pressure", "-p 2bar"),
            ("contraction", "-e 5%"),
            ("model", "--model thick-wall"),
        ] {
            if flag != given && !with.contains(usual.split(' ').next().unwrap()) {
                base = format!("{base} {usual}");
            }
        }
        let more = if flag.contains('.') {
            format!("{base} --with {flag}={value}")
        } else {
            format!("{base} --{flag} {value}")
        };
        let (without, with) = (run_in(dir.path(), &base), run_in(dir.path(), &more));
        assert!(
            with.code == 2 || (with.code == 0 && with.out != without.out),
            "changes nothing: {more}"
        );
    }
}

/// Commands with a pressure in bar, or with files or figures that state it.
const IN_BAR: [&str; 17] = [
    "force examples/bench.toml -p 1bar -e 5%",
    "pressure examples/prototype.toml -F 300N -e 5% --units bar",
    "contraction examples/prototype.toml -F 300N -p 2bar",
    "fill examples/prototype.toml --liquid water --volume 20mL --units bar",
    "curve isobaric examples/prototype.toml --model universal -p 0..6:1bar -e 0..20:5% --plot f.svg",
    "curve --study thickness --units bar --plot f.svg",
    "joint examples/elbow.toml -p 2bar,1bar",
    "joint examples/elbow.toml -p 2bar,1bar --angle -40..40:20deg --model universal --plot f.svg",
    "motion examples/drive.toml --model universal --plot f.svg",
    "simulate examples/prototype.toml -p 1bar..2bar:0.5bar -e 5% --plot f.svg",
    "check examples/bench.toml -p 1bar",
    "check examples/bench.toml -p 6bar",
    "build examples/bench.toml -p 1bar -o out",
    "export examples/prototype.toml --model thick-wall -p 6bar --as c",
    "compare --models ideal,paper -p 1,2bar --plot f.svg",
    "identify examples/bench.toml --data examples/bench.csv --model thick-wall --units bar --plot \
     f.svg",
    "design -F 500N -e 5% -p 2.5bar -D 30 -s 2 --model paper --plot f.svg",
];

/// After one pressure in bar every pressure is in bar, in texts, figures, drawings and steps;
/// moduli, stresses and energies stay.
#[test]
fn a_pressure_in_bar_is_the_unit_of_all_pressures() {
    let dir = copy();
    let is_fixed = |line: &&str| {
        [
            "odul",
            "law ",
            "mu ",
            "c10",
            "c01",
            "rubber.material",
            "tube.material",
            "pressure_mpa",
            "braid 500",
            "with its gas",
            "presses on it",
        ]
        .iter()
        .any(|w| line.contains(w))
    };
    let mut wrong = vec![];
    for line in IN_BAR {
        let ran = run_in(dir.path(), line);
        let mut said = vec![format!("{}{}", ran.text(), ran.err)];
        for name in ["f.svg", "out/README.md", "out/bom.csv", "out/test.csv"] {
            let path = dir.path().join(name);
            // A line for each text of a drawing.
            said.extend(
                std::fs::read_to_string(&path)
                    .ok()
                    .map(|text| text.replace("</text>", "\n")),
            );
            let _ = std::fs::remove_file(path);
        }
        let lines = said
            .iter()
            .flat_map(|text| text.lines())
            .filter(|l| l.contains("MPa") && !is_fixed(l));
        wrong.extend(lines.map(|said| format!("{line}: {said:.200}")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
