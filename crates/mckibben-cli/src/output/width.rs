//! How wide text is: as wide as the terminal, or as `COLUMNS` in the environment says; else tables
//! are 100 columns wide at most, and sentences stay on one line.

use mckibben_core::joined;
use std::path::Path;
use terminal_size::{Width, terminal_size_of};

/// Of tables in files and pipes.
pub const STABLE: usize = 100;
/// No text is narrower.
const LEAST: usize = 40;

/// Of the place where a result is read, where it has a width.
pub fn of_result(target: Option<&Path>) -> Option<usize> {
    if target.is_some() {
        return None;
    }
    let said = || std::env::var("COLUMNS").ok()?.parse::<usize>().ok();
    Some(
        terminal_size_of(std::io::stdout())
            .map(|(Width(width), _)| usize::from(width))
            .or_else(said)?
            .max(LEAST),
    )
}

/// Of standard error, where it has a width.
pub fn aside() -> Option<usize> {
    terminal_size_of(std::io::stderr()).map(|(Width(width), _)| LEAST.max(width.into()))
}

/// Sentences of a text, broken at blanks where there is a width. What is indented goes on indented.
pub fn broken(text: &str, width: Option<usize>) -> String {
    let Some(width) = width else {
        return text.to_owned();
    };
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
            broken("one two three\n  four five six", Some(9)),
            "one two\nthree\n  four\n    five\n    six"
        );
        assert_eq!(
            broken("a-word-that-is-too-long b", Some(9)),
            "a-word-that-is-too-long\nb"
        );
        assert_eq!(
            broken("at a pull of 12.5 N", Some(16)),
            "at a pull of\n12.5 N"
        );
        let short = "  name     value\n\n";
        assert_eq!(broken(short, Some(80)), short);
    }
}
