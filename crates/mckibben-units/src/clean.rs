//! Texts of others (names, sources, remarks) in what is written.

use std::borrow::Cow;

/// Characters that turn the direction of text, or hide in it (Unicode's bidirectional controls,
/// marks and separators).
const TURNING: [std::ops::RangeInclusive<char>; 6] = [
    '\u{61c}'..='\u{61c}',
    '\u{200b}'..='\u{200f}',
    '\u{2028}'..='\u{202e}',
    '\u{2060}'..='\u{2069}',
    '\u{feff}'..='\u{feff}',
    '\u{e0000}'..='\u{e007f}',
];

/// A character that no reader sees, and that moves, turns or hides what he reads.
pub fn is_unseen(c: char) -> bool {
    c.is_control()
        || TURNING.iter().any(|range| range.contains(&c))
        || matches!(c, '\u{fffe}' | '\u{ffff}')
}

/// A text in a comment: on one line, of characters that are seen.
pub fn line(text: &str) -> String {
    let one = |c: char| {
        if matches!(c, '\t' | '\n' | '\r') {
            ' '
        } else {
            c
        }
    };
    text.chars().map(one).filter(|c| !is_unseen(*c)).collect()
}

/// A text in XML and HTML: content and values of attributes.
pub fn markup(text: &str) -> String {
    [
        ('&', "&amp;"),
        ('<', "&lt;"),
        ('>', "&gt;"),
        ('"', "&quot;"),
        ('\'', "&#39;"),
    ]
    .into_iter()
    .fold(line(text), |text, (c, entity)| text.replace(c, entity))
}

/// A text in Markdown, and in a cell of a table of Markdown: no HTML, no link, no code.
pub fn markdown(text: &str) -> String {
    [
        ("&", "&amp;"),
        ("<", "&lt;"),
        ("|", "&#124;"),
        ("`", "'"),
        ("](", "]&#40;"),
    ]
    .into_iter()
    .fold(line(text), |text, (part, entity)| {
        text.replace(part, entity)
    })
}

/// JSON in HTML: what would end a script, or is not seen, is escaped. It occurs only in a text,
/// where this means the same.
pub fn json(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if c == '<' || is_unseen(c) && !c.is_ascii_control() {
            for unit in c.encode_utf16(&mut [0; 2]) {
                out += &format!("\\u{unit:04x}");
            }
        } else {
            out.push(c);
        }
    }
    out
}

/// A text in a cell of CSV: with an apostrophe before what a spreadsheet would compute.
pub fn cell(text: &str) -> Cow<'_, str> {
    let computes = text.starts_with(['=', '+', '-', '@', '\t', '\r'])
        && text.parse::<f64>().is_err()
        && text.len() > 1;
    if computes {
        Cow::Owned(format!("'{text}"))
    } else {
        Cow::Borrowed(text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_text_of_others_does_anything_in_what_is_written() {
        let hostile = "a\u{202e}b\n<script>x</script>|`rm`|[l](javascript:y)\u{1b}[2J";
        assert_eq!(
            line(hostile),
            "ab <script>x</script>|`rm`|[l](javascript:y)[2J"
        );
        assert_eq!(
            markup("\u{2066}<a b=\"'&\">\u{0}"),
            "&lt;a b=&quot;&#39;&amp;&quot;&gt;"
        );
        assert_eq!(
            markdown(hostile),
            "ab &lt;script>x&lt;/script>&#124;'rm'&#124;[l]&#40;javascript:y)[2J"
        );
        assert_eq!(
            json("\"</b>\u{202e}\u{e0001}\""),
            r#""\u003c/b>\u202e\udb40\udc01""#
        );
        for text in ["=1+1", "+cmd|' /C calc'!A0", "-2+3", "@SUM(A1)", "\t=1"] {
            assert_eq!(cell(text), format!("'{text}"));
        }
        for plain in ["-1.5", "+3e-2", "latex", "a=b", "-", "", "5 %"] {
            assert_eq!(cell(plain), plain);
        }
    }
}
