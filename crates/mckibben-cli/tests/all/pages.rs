//! README.md and the pages of docs/: behind each block of commands stands what they print, and a
//! number in a sentence is one of those numbers.
//!
//! `cargo xtask book` writes the outputs, `--check` compares them (`MCKIBBEN_PAGES`, and
//! `MCKIBBEN_WRITE` to write); README.md alone is always compared.

use crate::common::{command, copy, ran, root, words};
use std::{
    collections::HashMap,
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
const LINES: usize = 24;

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

/// The first and the last lines, at most `limit`.
fn shortened(lines: Vec<String>, limit: usize) -> Vec<String> {
    if lines.len() <= limit + 1 {
        return lines;
    }
    let last = limit / 3;
    let left_out = lines.len() - limit;
    let mark = format!("[… {left_out} more lines …]");
    let (head, tail) = (&lines[..limit - last], &lines[lines.len() - last..]);
    [head, &[mark], tail].concat()
}

/// What a command prints; its warnings, which are never shortened, follow.
fn printed(page: &str, folder: &Path, line: &str, limit: usize) -> Vec<String> {
    /// Cases of verification and validation take minutes: once for all pages.
    static SLOW: Mutex<Option<HashMap<String, String>>> = Mutex::new(None);
    let words = words(line);
    let words: Vec<&str> = words.iter().skip(1).map(String::as_str).collect();
    if let ["serve", more @ ..] = &words[..] {
        crate::serve::works(folder, more);
        return vec![];
    }
    let run = || {
        let output = command(folder).args(&words).env("COLUMNS", "80").output();
        let result = ran(output.unwrap());
        assert_eq!(result.code, 0, "{page}: {line}\n{}", result.err);
        (result.text().to_owned(), result.err)
    };
    if words == ["validate"] {
        let mut slow = SLOW.lock().unwrap();
        let slow = slow.get_or_insert_default();
        let out = slow.entry(line.to_owned()).or_insert_with(|| run().0);
        return shortened(broken(out), limit);
    }
    let (out, err) = run();
    let mut lines = shortened(broken(&out), limit);
    lines.extend(broken(&err));
    let blank = lines
        .iter()
        .rev()
        .take_while(|line| line.is_empty())
        .count();
    lines.truncate(lines.len() - blank);
    lines
}

/// A page with the outputs of its commands, which build on each other.
fn with_outputs(page: &str, text: &str) -> String {
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
        let limit = fence
            .split("lines=")
            .nth(1)
            .map_or(LINES, |n| n.trim().parse().unwrap());
        let mut outputs = vec![];
        for line in &commands {
            let output = printed(page, folder.path(), line, limit);
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
    made
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
        let made = with_outputs(&name, &text);
        if made == text {
            return;
        }
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
    let lines = |n: usize| (1..=n).map(|i| i.to_string()).collect::<Vec<_>>();
    assert_eq!(shortened(lines(4), 3), lines(4));
    assert_eq!(
        shortened(lines(6), 3),
        ["1", "2", "[… 3 more lines …]", "6"]
    );
}
