//! Texts on a terminal: their width, and their lines.

use unicode_width::UnicodeWidthStr;

/// Columns a text takes on a terminal.
pub(crate) fn columns_of(text: &str) -> usize {
    text.width()
}

/// Breaks a text into lines of at most `width` columns, within words only if it must.
pub(crate) fn wrap(text: &str, width: usize) -> Vec<String> {
    let mut lines = Vec::new();
    for paragraph in text.lines() {
        let mut line = String::new();
        for word in paragraph.split_whitespace() {
            let word: String = word.chars().filter(|c| !c.is_control()).collect();
            if word.is_empty() {
                continue;
            }
            if !line.is_empty() && columns_of(&line) + 1 + columns_of(&word) <= width {
                line.push(' ');
            } else if !line.is_empty() {
                lines.push(std::mem::take(&mut line));
            }
            for c in word.chars().filter(|c| columns_of(&c.to_string()) <= width) {
                line.push(c);
                if columns_of(&line) > width {
                    line.pop();
                    lines.push(std::mem::take(&mut line));
                    line.push(c);
                }
            }
        }
        if columns_of(&line) <= width && !line.is_empty() {
            lines.push(line);
        }
    }
    lines
}
