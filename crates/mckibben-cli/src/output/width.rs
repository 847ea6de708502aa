//! How wide text is: as wide as the terminal, or as `COLUMNS` in the environment says; else tables
//! are 100 columns wide at most, and sentences stay on one line.

use mckibben_core::joined;
use std::sync::atomic::{AtomicBool, Ordering};
use terminal_size::{Width, terminal_size_of};

/// Of tables in files and pipes.
const STABLE: usize = 100;
/// No text is narrower.
const LEAST: usize = 40;
/// Whether the text goes to a file.
static IN_FILE: AtomicBool = AtomicBool::new(false);

/// Notes that the text goes to a file, where no terminal counts.
pub fn in_file() {
    IN_FILE.store(true, Ordering::Relaxed);
}

/// Of the place where standard output is read, where it has a width.
fn of_reader() -> Option<usize> {
    if IN_FILE.load(Ordering::Relaxed) {
        return None;
    }
    or_environment(terminal_size_of(std::io::stdout()).map(|(width, _)| width))
}

fn or_environment(terminal: Option<Width>) -> Option<usize> {
    let said = || std::env::var("COLUMNS").ok()?.parse::<usize>().ok();
    Some(
        terminal
            .map(|Width(width)| usize::from(width))
            .or_else(said)?
            .max(LEAST),
    )
}

pub fn of_tables() -> usize {
    of_reader().unwrap_or(STABLE)
}

/// Sentences of a text, broken at blanks where standard output has a width. What is indented goes
/// on indented.
pub fn broken(text: &str) -> String {
    of_reader().map_or_else(|| text.to_owned(), |width| lines(text, width))
}

/// The same of standard error.
pub fn broken_aside(text: &str) -> String {
    let terminal =
        terminal_size_of(std::io::stderr()).map(|(Width(width), _)| usize::from(width).max(LEAST));
    terminal.map_or_else(|| text.to_owned(), |width| lines(text, width))
}

fn lines(text: &str, width: usize) -> String {
    let one = |line: &str| {
        let blanks = line.len() - line.trim_start_matches(' ').len();
        let indent = " ".repeat(if blanks > 0 { blanks + 2 } else { 0 }.min(width / 2));
        let first = " ".repeat(blanks);
        let parts = fold(
            line.trim_start_matches(' '),
            width - indent.len().max(blanks),
        );
        first + &parts.join(&format!("\n{indent}"))
    };
    joined(
        text.split('\n').map(|line| {
            if line.chars().count() <= width {
                line.to_owned()
            } else {
                one(line)
            }
        }),
        "\n",
    )
}

/// A text in lines of at most so many characters, broken at blanks, but not between a number and
/// its unit; a word that is longer has a separate line.
pub fn fold(text: &str, width: usize) -> Vec<String> {
    let mut out: Vec<String> = vec![];
    let mut length = 0;
    let mut words: Vec<String> = vec![];
    for word in text.split(' ') {
        let unit = |c: char| c.is_alphabetic() || "%°".contains(c);
        match words.last_mut() {
            Some(last)
                if last.ends_with(|c: char| c.is_ascii_digit()) && word.starts_with(unit) =>
            {
                last.push(' ');
                last.push_str(word);
            }
            _ => words.push(word.to_owned()),
        }
    }
    for word in &words {
        let more = word.chars().count();
        match out.last_mut() {
            Some(last) if length + 1 + more <= width => {
                last.push(' ');
                last.push_str(word);
                length += 1 + more;
            }
            _ => {
                out.push(word.to_owned());
                length = more;
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_broken_at_blanks_and_indented_ones_go_on_indented() {
        assert_eq!(
            lines("one two three\n  four five six", 9),
            "one two\nthree\n  four\n    five\n    six"
        );
        assert_eq!(
            lines("a-word-that-is-too-long b", 9),
            "a-word-that-is-too-long\nb"
        );
        assert_eq!(lines("at a pull of 12.5 N", 16), "at a pull of\n12.5 N");
        let short = "  name     value\n\n";
        assert_eq!(lines(short, 80), short);
    }
}
