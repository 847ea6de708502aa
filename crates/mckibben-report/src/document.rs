//! A report: headings, texts, tables, figures and a body, as one page that needs no network.

use crate::{
    figure::{Figure, Result},
    sheet::DrawingSheet,
};
use mckibben_units::clean::{self, markup};
use std::fmt::Write as _;

/// A report.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Document {
    pub title: String,
    /// Its title block: names and texts of fields; an empty one is filled in by hand.
    pub title_block: Vec<(String, String)>,
    /// Its purpose, in a sentence or two.
    pub lead: String,
    /// Its parts, in order.
    pub parts: Vec<Part>,
    /// Small print at its end: versions, hashes.
    pub footer: String,
}

/// A part of a report.
#[derive(Debug, Clone, PartialEq)]
pub enum Part {
    Heading(String),
    /// A paragraph.
    Text(String),
    /// Sentences, one below the other.
    List(Vec<String>),
    /// What people must heed, in a frame.
    Stop(Vec<String>),
    /// Work in its order, each step with a box to tick.
    Steps(Vec<String>),
    Table {
        /// Its head; empty for pairs of names and values.
        head: Vec<String>,
        rows: Vec<Vec<String>>,
    },
    Figure(Box<Figure>),
    Drawing(DrawingSheet),
    /// What follows begins on a new page.
    Break,
    /// A body in space: the data of the script that shows it, as JSON.
    Body(String),
}

const STYLE: &str = include_str!("document.css");

/// What every page begins with; it loads nothing. `more` is in the head, and the policy allows
/// `also`.
pub fn head(title: &str, style: &str, more: &str, also: &str) -> String {
    let policy = format!("default-src 'none'; style-src 'unsafe-inline'{also}");
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n{more}\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">\n\
         <title>{}</title><style>{style}</style></head>\n<body>\n",
        markup(title)
    )
}

/// Phones show a report at the width of their screen.
const VIEWPORT: &str = "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";

impl Document {
    /// The report as one HTML page. `viewer` is a script (a module without imports) that finds each
    /// body's data in an element `.body` as JSON and shows it there.
    pub fn to_html(&self, viewer: &str) -> Result<String> {
        let mut out = head(
            &self.title,
            STYLE,
            VIEWPORT,
            "; script-src 'unsafe-inline'; img-src data:",
        );
        let title = markup(&self.title);
        let lead = markup(&self.lead);
        let block = title_block(&self.title_block);
        let _ = writeln!(
            out,
            "<header><h1>{title}</h1>{block}</header>\n<p class=\"lead\">{lead}</p>"
        );
        for part in &self.parts {
            part.write(&mut out)?;
        }
        let _ = writeln!(out, "<footer>{}</footer>", markup(&self.footer));
        if self.parts.iter().any(|part| matches!(part, Part::Body(_))) {
            let _ = writeln!(
                out,
                "<script type=\"module\">\n{}\n</script>",
                viewer.replace("</", "<\\/")
            );
        }
        out.push_str("</body></html>\n");
        Ok(out)
    }
}

impl Part {
    pub fn heading(text: &str) -> Self {
        Self::Heading(text.to_owned())
    }

    pub fn table(head: &[&str], rows: Vec<Vec<String>>) -> Self {
        let head = head.iter().map(ToString::to_string).collect();
        Self::Table { head, rows }
    }

    fn write(&self, out: &mut String) -> Result<()> {
        // Writing to a string cannot fail.
        let _ = match self {
            Self::Heading(text) => writeln!(out, "<h2>{}</h2>", markup(text)),
            Self::Text(text) => writeln!(out, "<p>{}</p>", markup(text)),
            Self::List(list) | Self::Stop(list) => writeln!(out, "<ul>{}</ul>", items(list)),
            Self::Steps(steps) => writeln!(out, "<ol>{}</ol>", items(steps)),
            Self::Table { head, rows } => writeln!(out, "{}", table(head, rows)),
            Self::Figure(figure) => writeln!(out, "<figure>{}</figure>", figure.to_svg()?),
            Self::Drawing(sheet) => {
                writeln!(
                    out,
                    "<figure class=\"drawing\">{}</figure>",
                    sheet.to_svg()?
                )
            }
            Self::Break => writeln!(out, "<hr>"),
            Self::Body(data) => {
                let data = clean::json(data);
                writeln!(
                    out,
                    "<div class=\"body\"><script type=\"application/json\">{data}</script></div>"
                )
            }
        };
        Ok(())
    }
}

fn items(list: &[String]) -> String {
    list.iter()
        .map(|text: &String| format!("<li>{}</li>", markup(text)))
        .collect()
}

fn title_block(fields: &[(String, String)]) -> String {
    let one = |(name, value): &(String, String)| {
        format!(
            "<div><dt>{}</dt><dd>{}</dd></div>",
            markup(name),
            markup(value)
        )
    };
    let all: String = fields.iter().map(one).collect();
    if all.is_empty() {
        all
    } else {
        format!("<dl class=\"block\">{all}</dl>")
    }
}

fn table(head: &[String], rows: &[Vec<String>]) -> String {
    let line = |row: &[String], first: &str, other: &str| {
        let cell = |(i, text): (usize, &String)| {
            let tag = if i == 0 { first } else { other };
            // Sentences begin at the left.
            let class = if text.chars().count() > 40 {
                " class=\"words\""
            } else {
                ""
            };
            format!("<{tag}{class}>{}</{tag}>", markup(text))
        };
        format!(
            "<tr>{}</tr>",
            row.iter().enumerate().map(cell).collect::<String>()
        )
    };
    let head = if head.is_empty() {
        String::new()
    } else {
        format!("<thead>{}</thead>", line(head, "th", "th"))
    };
    let body: String = rows.iter().map(|row| line(row, "th", "td")).collect();
    format!("<table>{head}{body}</table>")
}
