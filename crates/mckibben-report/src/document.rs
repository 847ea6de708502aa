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
    /// At the top of the first page.
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
    /// Of a section.
    Heading(String),
    /// A paragraph.
    Text(String),
    /// Sentences, one below the other.
    List(Vec<String>),
    /// What people must heed, in a frame.
    Stop(Vec<String>),
    /// Work in its order, each step with a box to tick.
    Steps(Vec<String>),
    /// Cells in rows.
    Table {
        /// Its head, where it has one.
        head: Vec<String>,
        /// Each as long as the head.
        rows: Vec<Vec<String>>,
    },
    /// Curves in a frame with axes.
    Figure(Box<Figure>),
    /// A drawing to scale.
    Drawing(DrawingSheet),
    /// What follows begins on a new page.
    Break,
    /// A body in space: the data of the script that shows it, as JSON.
    Body(String),
}

const STYLE: &str = include_str!("document.css");

/// What every page begins with: it loads nothing, and phones show it at the width of their screen.
const HEAD: &str = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n\
    <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
    <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; \
    style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:\">\n";

impl Document {
    /// Its title block as a table.
    pub(crate) fn block(&self) -> Part {
        Part::pairs(self.title_block.clone())
    }

    /// The report as one HTML page. `viewer` is a script (a module without imports) that finds each
    /// body's data in an element `.body` as JSON and shows it there.
    pub fn to_html(&self, viewer: &str) -> Result<String> {
        let title = markup(&self.title);
        let lead = markup(&self.lead);
        let mut out = format!(
            "{HEAD}<title>{title}</title><style>{STYLE}</style></head>\n<body>\n<h1>{title}</h1>\n"
        );
        self.block().write(&mut out)?;
        let _ = writeln!(out, "<p class=\"lead\">{lead}</p>");
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
    /// The heading of a section.
    pub fn heading(text: &str) -> Self {
        Self::Heading(text.to_owned())
    }

    /// A table with a head.
    pub fn table(head: &[&str], rows: Vec<Vec<String>>) -> Self {
        let head = head.iter().map(ToString::to_string).collect();
        Self::Table { head, rows }
    }

    /// A table of names and values.
    pub fn pairs(rows: impl IntoIterator<Item = (impl Into<String>, String)>) -> Self {
        let rows = rows.into_iter();
        let rows = rows.map(|(name, value)| vec![name.into(), value]);
        Self::table(&[], rows.collect())
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
