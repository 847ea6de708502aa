//! README.md and the pages of docs/: behind each block of commands stands what they print, and a
//! number in a sentence is one of those numbers.
//!
//! `cargo xtask book` writes the outputs, `--check` compares them (`MCKIBBEN_PAGES`, and
//! `MCKIBBEN_WRITE` to write); README.md alone is always compared.

use crate::common::{command, copy, ran, root, words};
use std::{
    fmt::Write,
    fs,
    path::{Path, PathBuf},
    sync::Mutex,
};

/// Languages of blocks whose commands run.
const SHELL: [&str; 4] = ["sh", "console", "bash", "shell"];
/// So wide is a line of a block in the book.
const WIDTH: usize = 80;
/// An output has at most so many lines, if its block has no `lines=`; the middle is left out.
const LINES: usize = 12;

/// The commands of a shell block; a backslash at the end joins lines.
fn commands(block: &[&str]) -> Vec<String> {
    let mut out = vec![];
    let mut joined = String::new();
    for line in block {
        joined.push_str(line.trim().trim_start_matches("$ "));
        if joined.ends_with('\\') {
            joined.pop();
            continue;
        }
        let line = std::mem::take(&mut joined);
        if line.starts_with("mckibben ") {
            out.push(line);
        } else if let Some(rest) = line.strip_prefix("cargo run --release -- ") {
            out.push(format!("mckibben {rest}"));
        }
    }
    out
}

/// A text without the time that a campaign took, or would take.
fn without_times(text: &str) -> String {
    let timeless = |line: &str| {
        let (name, _) = line.split_at(line.rfind("  ").map_or(0, |at| at + 2));
        if ["  time   ", "  points a second "]
            .iter()
            .any(|label| line.starts_with(label))
        {
            return Some(format!("{name}…"));
        }
        let (points, rest) = line.split_once(" points in ")?;
        let (_, more) = rest.split_once(" a second)")?;
        Some(format!("{points} points in … s (… a second){more}"))
    };
    // A log has a line a minute of how far the work is.
    let is_log = |line: &str| line.contains(" a second, ") && line.ends_with(" s left");
    let lines = text.lines().filter(|line| !is_log(line));
    let lines: Vec<String> = lines
        .map(|line| timeless(line).unwrap_or_else(|| line.to_owned()))
        .collect();
    lines.join("\n")
}

/// A text broken at blanks, as a terminal does.
fn broken(text: &str) -> Vec<String> {
    let mut out = vec![];
    for line in text.lines() {
        let mut rest = line.to_owned();
        while rest.chars().count() > WIDTH {
            let end = rest
                .char_indices()
                .nth(WIDTH + 1)
                .map_or(rest.len(), |(i, _)| i);
            let Some(blank) = rest[..end]
                .rfind(' ')
                .filter(|i| !rest[..*i].trim().is_empty())
            else {
                break;
            };
            let next = rest.split_off(blank);
            out.push(rest.trim_end().to_owned());
            rest = next.trim_start().to_owned();
        }
        out.push(rest.trim_end().to_owned());
    }
    out
}

/// What an output block asks for: the first line by its beginning, most lines, how many of them
/// are the last, and the exit code.
#[derive(Clone, Copy)]
struct Asked<'a> {
    from: &'a str,
    lines: usize,
    last: usize,
    exit: i32,
}

impl<'a> Asked<'a> {
    /// Of the line with which the block begins, such as `text from=allowed lines=6 last=2 exit=2`.
    fn of(fence: &'a str) -> Self {
        let option = |key: &str| {
            // rustdoc, which reads README.md, knows no `=` there.
            let colon = key.replace('=', ":");
            let of = |word: &'a str| word.strip_prefix(key).or(word.strip_prefix(&colon));
            let word = fence.split(' ').find_map(of);
            word.map(|number| number.parse::<u16>().unwrap())
        };
        let lines = option("lines=").map_or(LINES, usize::from);
        let from = fence.split(' ').find_map(|word| word.strip_prefix("from="));
        Self {
            from: from.unwrap_or_default(),
            lines,
            last: option("last=").map_or(lines / 3, usize::from),
            exit: option("exit=").map_or(0, i32::from),
        }
    }

    /// The lines from the one that begins so on, of these the first and the last.
    fn shortened(self, lines: Vec<String>) -> Vec<String> {
        let mark = |lines: usize| format!("[… {lines} more lines …]");
        let begins = |line: &String| line.trim_start().starts_with(self.from);
        let before = lines.iter().position(begins).unwrap_or(0);
        let skipped = (before > 0).then(|| mark(before));
        let mut kept: Vec<String> = skipped.into_iter().collect();
        let lines = &lines[before..];
        if lines.len() <= self.lines + 1 {
            kept.extend_from_slice(lines);
            return kept;
        }
        kept.extend_from_slice(&lines[..self.lines - self.last]);
        kept.push(mark(lines.len() - self.lines));
        kept.extend_from_slice(&lines[lines.len() - self.last..]);
        kept
    }
}

/// What a command prints; its warnings, which are never shortened, follow.
fn printed(page: &str, folder: &Path, line: &str, asked: Asked<'_>) -> Result<Vec<String>, String> {
    let words = words(line);
    let words: Vec<&str> = words.iter().skip(1).map(String::as_str).collect();
    if let ["serve", more @ ..] = &words[..]
        && more != ["--help"]
    {
        crate::serve::works(folder, more);
        return Ok(vec![]);
    }
    let output = command(folder).args(&words).env("COLUMNS", "80").output();
    let result = ran(output.unwrap());
    if result.code != asked.exit {
        let (code, err) = (result.code, result.err);
        return Err(format!("{page}: {line}: exit {code}: {err}"));
    }
    let (out, err) = (without_times(result.text()), without_times(&result.err));
    let mut lines = asked.shortened(broken(&out));
    lines.extend(broken(&err));
    let blank = lines
        .iter()
        .rev()
        .take_while(|line| line.is_empty())
        .count();
    lines.truncate(lines.len() - blank);
    Ok(lines)
}

/// A page with the outputs of its commands, which build on each other.
fn with_outputs(page: &str, text: &str) -> Result<String, String> {
    let folder = copy();
    let mut made = String::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        writeln!(made, "{line}").unwrap();
        let Some(language) = line.strip_prefix("```") else {
            continue;
        };
        let block: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
        for line in &block {
            writeln!(made, "{line}").unwrap();
        }
        writeln!(made, "```").unwrap();
        if !SHELL.contains(&language.trim()) {
            continue;
        }
        let commands = commands(&block);
        // The block that is there gives place to the new one, but for its limit.
        let mut behind = lines.clone();
        let mut fence = "```text".to_owned();
        if behind.next() == Some("")
            && let Some(old) = behind.next().filter(|line| line.starts_with("```text"))
            && !commands.is_empty()
        {
            behind.by_ref().take_while(|line| *line != "```").count();
            fence = old.to_owned();
            lines = behind;
        }
        let asked = Asked::of(&fence);
        let mut outputs = vec![];
        for line in &commands {
            let output = printed(page, folder.path(), line, asked)?;
            if output.is_empty() {
                continue;
            }
            let name = (commands.len() > 1).then(|| broken(&format!("$ {line}")));
            outputs.push([name.unwrap_or_default(), output].concat().join("\n"));
        }
        if !outputs.is_empty() {
            writeln!(made, "\n{fence}\n{}\n```", outputs.join("\n\n")).unwrap();
        }
    }
    Ok(made)
}

/// README.md, and where `MCKIBBEN_PAGES` is set all pages of docs/ (or those that it names).
fn pages() -> Vec<PathBuf> {
    let asked = std::env::var("MCKIBBEN_PAGES").unwrap_or_default();
    let mut pages = vec![root().join("README.md")];
    pages.extend(docs());
    let chosen = |page: &PathBuf| match asked.as_str() {
        "" => page.ends_with("README.md"),
        "1" => true,
        names => names.split(',').any(|name| page.ends_with(name)),
    };
    pages.retain(chosen);
    pages
}

/// All pages of docs/.
fn docs() -> Vec<PathBuf> {
    let mut folders = vec![root().join("docs")];
    let mut pages = vec![];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "md") {
                pages.push(path);
            }
        }
    }
    pages.sort();
    pages
}

/// A regression: a page shows what its commands print, warnings too.
#[test]
fn pages_show_what_their_commands_print() {
    let write = std::env::var_os("MCKIBBEN_WRITE").is_some();
    let wrong = Mutex::new(vec![]);
    crate::common::side_by_side(pages(), |page| {
        let name = page.strip_prefix(root()).unwrap().display().to_string();
        let text = fs::read_to_string(&page).unwrap();
        let made = match with_outputs(&name, &text) {
            Err(error) => return wrong.lock().unwrap().push(error),
            Ok(made) if made == text => return,
            Ok(made) => made,
        };
        if write {
            return fs::write(&page, made).unwrap();
        }
        let differs = made.lines().zip(text.lines()).find(|(new, old)| new != old);
        wrong.lock().unwrap().push(format!("{name}: {differs:?}"));
    });
    let wrong = wrong.into_inner().unwrap();
    assert!(
        wrong.is_empty(),
        "(what is printed, what the page shows), where they differ first; cargo xtask book writes \
         the pages: {wrong:#?}"
    );
}

#[test]
fn shell_blocks_are_understood() {
    let page = "$ mckibben force \\\n  -p 0.2 # why\ncargo run --release -- models | head";
    assert_eq!(
        commands(&page.lines().collect::<Vec<_>>()),
        ["mckibben force -p 0.2 # why", "mckibben models | head"]
    );
    assert_eq!(
        words("mckibben force -p 0.2 # why"),
        ["mckibben", "force", "-p", "0.2"]
    );
    assert_eq!(
        words("mckibben x \"a b\" '' | head"),
        ["mckibben", "x", "a b", ""]
    );
}

#[test]
fn outputs_are_broken_and_shortened_at_known_places() {
    let line = format!("{} end", "ab ".repeat(27).trim_end());
    assert_eq!(broken(&line), ["ab ".repeat(27).trim_end(), "end"]);
    assert_eq!(
        without_times("9 points in 0.8 s (2 a second), 1 left\nin 3 s"),
        "9 points in … s (… a second), 1 left\nin 3 s"
    );
    assert_eq!(
        without_times(
            "  time     2m 3s\n1 of 9 muscles, 2 a second, 4 s left\n  points a second   9"
        ),
        "  time     …\n  points a second   …"
    );
    let lines = |n: usize| (1..=n).map(|i| i.to_string()).collect::<Vec<_>>();
    let shortened = |fence: &str, n| Asked::of(fence).shortened(lines(n));
    assert_eq!(shortened("```text lines=3", 4), lines(4));
    assert_eq!(
        shortened("```text lines=3", 6),
        ["1", "2", "[… 3 more lines …]", "6"]
    );
    assert_eq!(
        shortened("```text lines=3 last=2", 6),
        ["1", "[… 3 more lines …]", "5", "6"]
    );
    assert_eq!(
        shortened("```text from=3 lines=2 last=1", 6),
        ["[… 2 more lines …]", "3", "[… 2 more lines …]", "6"]
    );
}

/// A page as prose and as what its numbers may come from: blocks, code in sentences, tables behind
/// `<!-- study NAME -->`, comments that begin with `<!-- numbers:`, equations, and the files of
/// examples/ that it links.
fn prose_and_evidence(page: &Path, text: &str) -> (String, String) {
    let (mut prose, mut evidence) = (String::new(), String::new());
    for (i, part) in text.split("```").enumerate() {
        if i % 2 == 1 {
            evidence += part;
            continue;
        }
        let mut rest = part;
        let mut spoken = String::new();
        let mut of_study = false;
        while let Some((before, after)) = rest.split_once("<!--") {
            *(if of_study { &mut evidence } else { &mut spoken }) += before;
            let (comment, after) = after.split_once("-->").unwrap();
            evidence += comment;
            of_study = comment.starts_with(" study ");
            rest = after;
        }
        spoken += rest;
        for (i, part) in spoken.split('`').enumerate() {
            if i % 2 == 0 {
                prose += part;
            } else {
                prose.push('_');
                writeln!(evidence, "{part}").unwrap();
            }
        }
    }
    let mut kept = String::new();
    for (i, part) in prose.split("](").enumerate() {
        let (target, rest) = if i == 0 {
            ("", part)
        } else {
            part.split_once(')').unwrap_or((part, ""))
        };
        if target.contains("examples/") {
            evidence +=
                &fs::read_to_string(page.parent().unwrap().join(target)).unwrap_or_default();
        }
        kept += rest;
    }
    let (mut prose, mut equations) = (String::new(), String::new());
    for (i, part) in kept.split("$$").enumerate() {
        if i % 2 == 0 {
            &mut prose
        } else {
            &mut equations
        }
        .push_str(part);
    }
    (prose, evidence + &equations)
}

/// Numbers of a text, each with its place behind it.
fn numbers(text: &str) -> Vec<(&str, usize)> {
    let bytes = text.as_bytes();
    let digit = |i: usize| bytes.get(i).is_some_and(u8::is_ascii_digit);
    let mut out = vec![];
    let mut i = 0;
    while i < bytes.len() {
        if !digit(i) {
            i += 1;
            continue;
        }
        let begin = i;
        while digit(i) || (bytes.get(i) == Some(&b'.') && digit(i + 1)) {
            i += 1;
        }
        let named = text[..begin]
            .chars()
            .next_back()
            .is_some_and(char::is_alphabetic);
        if !named {
            out.push((&text[begin..i], i));
        }
    }
    out
}

/// Numbers of a text that have one of the program's units.
fn claims(prose: &str) -> Vec<(&str, &str)> {
    const UNITS: [&str; 16] = [
        "N/mm", "N/bar", "N", "bar", "MPa", "kPa", "mm", "%", "kg", "g", "s", "ms", "J", "°", "Hz",
        "mL",
    ];
    let mut out = vec![];
    for (number, end) in numbers(prose) {
        let rest = prose[end..].trim_start_matches([' ', '\u{a0}']);
        let ends = |rest: &str| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '/');
        let unit = UNITS
            .iter()
            .find(|unit| rest.strip_prefix(**unit).is_some_and(ends));
        out.extend(unit.map(|unit| (number, *unit)));
    }
    out
}

/// A number as a sentence gives it is one of these, rounded to its digits; MPa may stand for bar
/// and kPa, a ratio for percent.
fn comes_from(claim: &str, unit: &str, evidence: &[f64]) -> bool {
    let value: f64 = claim.parse().unwrap();
    let decimals = claim.split_once('.').map_or(0, |(_, digits)| digits.len());
    let zeros = claim.len() - claim.trim_end_matches('0').len();
    let step = 10f64.powi(i32::try_from(decimals).unwrap()).recip();
    let round = if decimals == 0 {
        (0.5 * 10f64.powi(i32::try_from(zeros).unwrap())).min((0.03 * value).max(0.5))
    } else {
        0.5 * step
    };
    let factors: &[f64] = match unit {
        "bar" | "MPa" | "kPa" => &[1.0, 10.0, 0.1, 100.0, 0.01, 1000.0],
        "%" => &[1.0, 100.0],
        _ => &[1.0],
    };
    let near = |e: f64| (e - value).abs() <= round * (1.0 + 1e-9);
    evidence.iter().any(|e| factors.iter().any(|f| near(e * f)))
}

/// Pages whose numbers come from studies and from the literature, which they name beside them; all
/// other pages have them from their commands. (Of `python.md` and `python-arrays.md` the outputs
/// are still to be written.)
const FROM_STUDIES: [&str; 10] = [
    "as-mounted.md",
    "exports-simulators.md",
    "finite-elements.md",
    "interval.md",
    "motion-equations.md",
    "paper.md",
    "python.md",
    "python-arrays.md",
    "rubber-modes.md",
    "validation.md",
];

#[test]
fn a_number_with_a_unit_comes_from_a_command_of_its_page() {
    let mut wrong = vec![];
    for page in docs().into_iter().chain([root().join("README.md")]) {
        let name = page.strip_prefix(root()).unwrap().display().to_string();
        let short = name.trim_start_matches("docs/");
        if short == "SUMMARY.md" || FROM_STUDIES.contains(&short) {
            continue;
        }
        let text = fs::read_to_string(&page).unwrap();
        let (prose, evidence) = prose_and_evidence(&page, &text);
        let known: Vec<f64> = numbers(&evidence)
            .iter()
            .filter_map(|(n, _)| n.parse().ok())
            .collect();
        let unknown = claims(&prose)
            .into_iter()
            .filter(|(n, unit)| !comes_from(n, unit, &known));
        wrong.extend(unknown.map(|(number, unit)| format!("{name}: {number} {unit}")));
    }
    assert!(
        wrong.is_empty(),
        "no command of the page prints it, and no comment `<!-- numbers: … -->` says where it is \
         from: {wrong:#?}"
    );
}

#[test]
fn numbers_of_sentences_are_found_and_compared() {
    let found = claims("D0 14 mm pulls 1.5 N, not D3 of 20.5 %; 7 muscles");
    assert_eq!(found, [("14", "mm"), ("1.5", "N"), ("20.5", "%")]);
    assert!(comes_from("5.4", "bar", &[5.379]) && !comes_from("5.3", "bar", &[5.379]));
    assert!(comes_from("2.5", "bar", &[0.25]) && comes_from("15", "%", &[0.15]));
    assert!(comes_from("1700", "N", &[1711.0]) && !comes_from("1600", "N", &[1711.0]));
    let (prose, evidence) = prose_and_evidence(
        Path::new("x.md"),
        "a 1 N `2 N` <!-- numbers: 3 -->\n```text\n4\n```\n<!-- study x -->| 5 |<!-- end -->",
    );
    assert_eq!(claims(&prose), [("1", "N")]);
    assert_eq!(
        numbers(&evidence).iter().map(|n| n.0).collect::<Vec<_>>(),
        ["3", "2", "4", "5"]
    );
}

/// Words of a text outside of blocks, comments and tables that a study writes.
fn words_of_prose(text: &str) -> usize {
    let behind = |end| move |part| str::split_once(part, end).map_or(part, |(_, rest)| rest);
    let without_tables: String = text
        .split("<!-- study ")
        .map(behind("<!-- end -->"))
        .collect();
    let prose: String = without_tables.split("\n```").step_by(2).collect();
    let spoken: String = prose.split("<!--").map(behind("-->")).collect();
    spoken.split_whitespace().count()
}

/// Forty pages of four kinds. Each is one kind and has at most 1,500 words of prose, all together
/// 36,000 beside tables of flags, keys and columns.
#[test]
fn a_page_is_of_one_kind_and_short() {
    let summary = fs::read_to_string(root().join("docs/SUMMARY.md")).unwrap();
    let parts: Vec<&str> = summary
        .lines()
        .filter_map(|line| line.strip_prefix("# "))
        .collect();
    assert_eq!(parts, ["mckibben", "Learn", "Do", "Look up", "Understand"]);
    let mut wrong = vec![];
    let (mut pages, mut all) = (0, 0);
    for page in docs() {
        let name = page
            .strip_prefix(root().join("docs"))
            .unwrap()
            .display()
            .to_string();
        if name == "SUMMARY.md" {
            continue;
        }
        let named = summary.matches(&format!("]({name})")).count();
        if named != 1 {
            wrong.push(format!("{name} is {named} times in SUMMARY.md"));
        }
        let text = fs::read_to_string(&page).unwrap();
        let words = words_of_prose(&text);
        if words > 1500 {
            wrong.push(format!("{name} has {words} words, at most 1500"));
        }
        let of_a_key = |line: &&str| line.starts_with("| `");
        let keys: Vec<&str> = text.lines().filter(of_a_key).collect();
        pages += 1;
        all += words - words_of_prose(&keys.join("\n"));
    }
    if pages > 40 || all > 36_000 {
        wrong.push(format!(
            "{pages} pages have {all} words, at most 40 and 36,000"
        ));
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Set-up and tests are one command each; `.ci/run` calls the very command that stands there.
#[test]
fn the_readme_has_the_command_of_the_tests_that_ci_calls() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let (_, tests) = readme.split_once("\n## The tests\n").unwrap();
    let (_, block) = tests.split_once("\n```sh\n").unwrap();
    let (command, _) = block.split_once("\n```\n").unwrap();
    assert_eq!(command, "cargo test --workspace");
    let ci = fs::read_to_string(root().join(".ci/run")).unwrap();
    let called = |line: &str| line.split(" 2>&1 |").next() == Some(command);
    assert_eq!(ci.lines().filter(|line| called(line)).count(), 1);
    let blocks = readme.split("\n```sh\n").skip(1);
    let first = blocks.map(|block| block.lines().next().unwrap());
    let starts: Vec<&str> = first.filter(|line| line.starts_with("cargo ")).collect();
    assert!(
        matches!(starts[..], [main, tests]
            if main.starts_with("cargo run --release -- design ") && tests == command),
        "{starts:?}"
    );
}
