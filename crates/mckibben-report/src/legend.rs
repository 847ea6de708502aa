//! The legend: its entries, and rows of them below what they explain.

use crate::{
    figure::{Panel, Style},
    font::Metrics,
    rect::Rect,
};

/// Font size of the entries.
pub const SIZE: f64 = 10.0;
/// Length of the line sample before a text.
pub const SAMPLE: f64 = 26.0;
/// Height of a row of entries.
pub const ROW: f64 = 14.5;
const GAP: f64 = 6.0;

/// One entry: a sample of the line and its text.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    pub label: String,
    pub style: Style,
    pub colour: usize,
}

pub struct Legend {
    pub frame: Rect,
    /// Entries with the left end of their sample and the middle of their row.
    pub entries: Vec<(f64, f64, Entry)>,
}

impl Legend {
    /// Moves it to the right and down; its frame is as wide as its paper.
    pub fn shift(&mut self, right: f64, down: f64) {
        self.frame.y += down;
        for (x, y, _) in &mut self.entries {
            *x += right;
            *y += down;
        }
    }
}

/// The entries of a panel, each once.
pub fn entries(panel: &Panel) -> Vec<Entry> {
    let mut all = Vec::new();
    for (colour, series) in panel.numbered() {
        let entry = Entry {
            label: series.label.clone(),
            style: series.style,
            colour,
        };
        if !entry.label.trim().is_empty() && !all.contains(&entry) {
            all.push(entry);
        }
    }
    all
}

/// The entries of all panels if one legend can serve them all: most of them are common,
/// and no sample stands for two different texts.
pub fn shared(panels: &[Panel]) -> Option<Vec<Entry>> {
    let each: Vec<_> = panels.iter().map(entries).collect();
    let most = each.iter().map(Vec::len).max().unwrap_or(0);
    let with_entries = each.iter().filter(|e| !e.is_empty()).count();
    let mut all: Vec<Entry> = Vec::new();
    for entry in each.into_iter().flatten() {
        if !all.contains(&entry) {
            all.push(entry);
        }
    }
    let clash = all.iter().enumerate().any(|(i, a)| {
        all[..i]
            .iter()
            .any(|b| a.style == b.style && a.colour == b.colour)
    });
    (with_entries > 1 && all.len() <= most + 2 && !clash).then_some(all)
}

/// The entries with texts shortened to what fits beside a sample in a width.
pub fn fitted(entries: Vec<Entry>, metrics: &Metrics, width: f64) -> Vec<Entry> {
    let room = width - SAMPLE - 3.0 * GAP;
    let short = |e: Entry| Entry {
        label: metrics.fit(&e.label, SIZE, room),
        ..e
    };
    entries.into_iter().map(short).collect()
}

/// Rows of entries set one after the other within a width; the height is that of the frame.
pub fn rows(entries: &[Entry], metrics: &Metrics, x: f64, y: f64, width: f64) -> Legend {
    let long = |e: &Entry| SAMPLE + GAP + metrics.width(&e.label, SIZE);
    // equal columns read better than ragged rows when there is more than one row
    let total: f64 = entries.iter().map(|e| long(e) + 18.0).sum();
    let widest = entries.iter().map(long).fold(0.0, f64::max) + 18.0;
    let columns = if total - 18.0 <= width {
        entries.len().max(1)
    } else {
        ((width / widest).floor() as usize).clamp(1, entries.len().max(1))
    };
    let count = entries.len().div_ceil(columns);
    let mut placed = Vec::new();
    let mut at = x;
    for (i, entry) in entries.iter().enumerate() {
        let left = if count == 1 {
            at
        } else {
            x + (i % columns) as f64 * widest
        };
        placed.push((left, y + ((i / columns) as f64 + 0.5) * ROW, entry.clone()));
        at += long(entry) + 18.0;
    }
    let frame = Rect {
        x,
        y,
        w: width,
        h: count as f64 * ROW,
    };
    Legend {
        frame,
        entries: placed,
    }
}
