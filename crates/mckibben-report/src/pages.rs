//! A report on paper: A4 pages with headings, paragraphs, steps, tables, figures and drawings.

use crate::{
    document::{Document, Part},
    drawing::{
        Anchor::{End, Start},
        Drawing,
    },
    figure::Result,
    font::Metrics,
    pdf,
    rect::PER_MM,
    sheet::{
        CAPITALS, DrawingSheet,
        Pen::{self, Outline, Thin},
    },
};

/// A4 upright and its margins (left with room for binding), in mm.
const PAPER_MM: [f64; 2] = [210.0, 297.0];
const LEFT_MM: f64 = 20.0;
const RIGHT_MM: f64 = 195.0;
const WIDTH_MM: f64 = RIGHT_MM - LEFT_MM;
const TOP_MM: f64 = 277.0;
const BOTTOM_MM: f64 = 18.0;
/// Heights of capitals in mm (ISO 3098: at least 1.8).
const TEXT_MM: f64 = 2.1;
const HEADING_MM: f64 = 2.9;
const TITLE_MM: f64 = 4.0;
/// The same as the size of the font.
const SIZE: f64 = TEXT_MM * PER_MM / CAPITALS;
/// From one line of a text to the next, over the height of its capitals.
const LEADING: f64 = 2.0;
const ROW_MM: f64 = LEADING * TEXT_MM;
/// Between columns of a table.
const GUTTER_MM: f64 = 4.0;
/// Largest height of a figure.
const FIGURE_MM: f64 = 115.0;
/// Room for a heading above a drawing.
const HEAD_MM: f64 = 16.0;

/// Pages that are filled from above.
struct Pages {
    metrics: Metrics,
    done: Vec<DrawingSheet>,
    sheet: DrawingSheet,
    /// Where the next line begins.
    y: f64,
}

impl Document {
    /// The report as a PDF of A4 pages, without bodies and texts of files.
    pub fn to_pdf(&self) -> Result<Vec<u8>> {
        let mut pages = Pages {
            metrics: Metrics::new()?,
            done: vec![],
            sheet: empty(),
            y: TOP_MM,
        };
        pages.text(&self.title, LEFT_MM, TITLE_MM);
        pages.y -= 2.0;
        pages.part(&self.block())?;
        pages.text(&self.lead, LEFT_MM, TEXT_MM);
        for (i, part) in self.parts.iter().enumerate() {
            if let (Part::Heading(_), Some(Part::Drawing(sheet))) = (part, self.parts.get(i + 1)) {
                pages.room(sheet.drawing()?.height / PER_MM + HEAD_MM);
            }
            pages.part(part)?;
        }
        pages.text(&self.footer, LEFT_MM, 1.8);
        let sheets = pages.numbered(&self.title);
        let sheets = sheets.iter().map(DrawingSheet::drawing);
        pdf::render(&sheets.collect::<Result<Vec<_>>>()?, &self.title)
    }
}

fn empty() -> DrawingSheet {
    DrawingSheet::new(String::new(), PAPER_MM[0], PAPER_MM[1])
}

impl Pages {
    /// Begins a new page where this one has less room than a height in mm.
    fn room(&mut self, height_mm: f64) {
        if self.y - height_mm < BOTTOM_MM && self.y < TOP_MM {
            self.done.push(std::mem::replace(&mut self.sheet, empty()));
            self.y = TOP_MM;
        }
    }

    /// The lines of a text in a width of mm.
    fn lines(&self, text: &str, height_mm: f64, width_mm: f64) -> Vec<String> {
        self.metrics
            .wrap(text, height_mm * PER_MM / CAPITALS, width_mm * PER_MM)
    }

    /// Width in mm of a text of a table.
    fn width_mm(&self, text: &str) -> f64 {
        self.metrics.width(text, SIZE) / PER_MM
    }

    fn text(&mut self, text: &str, x: f64, height_mm: f64) {
        for line in self.lines(text, height_mm, RIGHT_MM - x) {
            self.room(LEADING * height_mm);
            self.y -= LEADING * height_mm;
            self.sheet.text([x, self.y], height_mm, Start, line);
        }
    }

    fn part(&mut self, part: &Part) -> Result<()> {
        match part {
            Part::Heading(text) => {
                // With at least two lines behind it.
                self.room(22.0);
                self.y -= 4.0;
                self.text(text, LEFT_MM, HEADING_MM);
                self.y -= 1.2;
                self.rule(Thin);
            }
            Part::Text(text) => {
                self.y -= 1.0;
                self.text(text, LEFT_MM, TEXT_MM);
            }
            Part::List(list) => list.iter().for_each(|text| self.item("–", text)),
            Part::Stop(list) => self.stop(list),
            Part::Steps(steps) => {
                for (i, step) in steps.iter().enumerate() {
                    self.item(&format!("□ {}", i + 1), step);
                }
            }
            Part::Table { head, rows } => self.table(head, rows),
            Part::Figure(figure) => self.picture(&figure.drawing()?),
            Part::Drawing(sheet) => self.picture(sheet.drawing()?),
            Part::Break => self.room(TOP_MM),
            // What is read on a screen.
            Part::Body(_) => {}
        }
        Ok(())
    }

    fn rule(&mut self, pen: Pen) {
        let y = self.y;
        self.sheet.line(pen, [[LEFT_MM, y], [RIGHT_MM, y]]);
    }

    /// A text behind a mark.
    fn item(&mut self, mark: &str, text: &str) {
        self.y -= 1.0;
        self.room(ROW_MM);
        let y = self.y - ROW_MM;
        let x = LEFT_MM + self.width_mm(mark) + 2.5;
        self.sheet.text([LEFT_MM, y], TEXT_MM, Start, mark);
        self.text(text, x, TEXT_MM);
    }

    /// Sentences between two thick lines.
    fn stop(&mut self, list: &[String]) {
        self.y -= 2.0;
        self.rule(Outline);
        list.iter().for_each(|text| self.item("!", text));
        self.y -= 2.5;
        self.rule(Outline);
        self.y -= 1.0;
    }

    /// Widths of columns in mm: as wide as their texts, the widest narrower where all have no room.
    fn columns(&self, head: &[String], rows: &[Vec<String>]) -> Vec<f64> {
        let all = || rows.iter().map(Vec::as_slice).chain([head]);
        let count = all().map(<[String]>::len).max().unwrap_or(0);
        let widest = |i: usize| {
            let cells = all().filter_map(|row| row.get(i));
            cells
                .map(|text| self.width_mm(text))
                .fold(GUTTER_MM, f64::max)
        };
        let mut widths: Vec<f64> = (0..count).map(widest).collect();
        let room = WIDTH_MM - GUTTER_MM * count.saturating_sub(1) as f64;
        let total = |widths: &[f64]| widths.iter().sum::<f64>();
        let mut most = room;
        while total(&widths) > room && most > 5.0 {
            most -= 2.0;
            widths.iter_mut().for_each(|w| *w = w.min(most));
        }
        widths
    }

    fn table(&mut self, head: &[String], rows: &[Vec<String>]) {
        self.y -= 1.5;
        let widths = self.columns(head, rows);
        let head = (!head.is_empty()).then(|| head.to_vec());
        for (i, row) in head.iter().chain(rows).enumerate() {
            let cells: Vec<Vec<String>> = row
                .iter()
                .zip(&widths)
                .map(|(text, width)| self.lines(text, TEXT_MM, *width))
                .collect();
            let tall = cells.iter().map(Vec::len).max().unwrap_or(1).max(1);
            self.room(ROW_MM * tall as f64 + 1.4);
            let mut x = LEFT_MM;
            for (lines, width) in cells.iter().zip(&widths) {
                for (k, line) in lines.iter().enumerate() {
                    let y = self.y - ROW_MM * (k + 1) as f64;
                    self.sheet.text([x, y], TEXT_MM, Start, line);
                }
                x += width + GUTTER_MM;
            }
            self.y -= ROW_MM * tall as f64 + 1.4;
            let is_head = i == 0 && head.is_some();
            self.rule(if is_head { Outline } else { Thin });
        }
        self.y -= 1.0;
    }

    /// A picture as wide as the text, or as high as a figure may be.
    fn picture(&mut self, drawing: &Drawing) {
        let [width, height] = [drawing.width, drawing.height].map(|side| side / PER_MM);
        let scale = (WIDTH_MM / width).min(FIGURE_MM / height);
        self.room(scale * height + 3.0);
        self.y -= 3.0 + scale * height;
        self.sheet
            .embed(drawing, [LEFT_MM, self.y + scale * height], scale);
    }

    /// All pages with their numbers.
    fn numbered(mut self, title: &str) -> Vec<DrawingSheet> {
        self.done.push(self.sheet);
        let count = self.done.len();
        for (i, sheet) in self.done.iter_mut().enumerate() {
            sheet.text([LEFT_MM, 10.0], 1.8, Start, title);
            let number = format!("page {} of {count}", i + 1);
            sheet.text([RIGHT_MM, 10.0], 1.8, End, number);
        }
        self.done
    }
}
