//! The legend: its entries, and rows of them below what they explain.

use crate::{
    figure::{Panel, Style},
    font::Metrics,
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
    pub height: f64,
    /// Where the longest row ends.
    pub right: f64,
    /// Entries with the left end of their sample and the middle of their row.
    pub entries: Vec<(f64, f64, Entry)>,
}

impl Legend {
    /// Moves it to the right and down.
    pub fn shift(&mut self, right: f64, down: f64) {
        for (x, y, _) in &mut self.entries {
            *x += right;
            *y += down;
        }
    }
}

/// The entries of some panels, each once.
pub fn entries(panels: &[Panel]) -> Vec<Entry> {
    let mut all = Vec::new();
    for (colour, series) in panels.iter().flat_map(Panel::numbered) {
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
    let counts = panels.chunks(1).map(|panel| entries(panel).len());
    let counts: Vec<usize> = counts.filter(|count| *count > 0).collect();
    let all = entries(panels);
    let clash = all.iter().enumerate().any(|(i, a)| {
        all[..i]
            .iter()
            .any(|b| a.style == b.style && a.colour == b.colour)
    });
    let most = counts.iter().max()?;
    (counts.len() > 1 && all.len() <= most + 2 && !clash).then_some(all)
}

/// Rows of entries set one after the other within a width, with texts shortened to what fits beside a
/// sample.
pub fn rows(mut entries: Vec<Entry>, metrics: &Metrics, (x, y): (f64, f64), width: f64) -> Legend {
    let room = width - SAMPLE - 3.0 * GAP;
    for entry in &mut entries {
        entry.label = metrics.fit(&entry.label, SIZE, room);
    }
    let long = |e: &Entry| SAMPLE + GAP + metrics.width(&e.label, SIZE);
    // equal columns read better than ragged rows when there is more than one row
    let total: f64 = entries.iter().map(|e| long(e) + 18.0).sum();
    let widest = entries.iter().map(long).fold(0.0, f64::max) + 18.0;
    let most = entries.len().max(1);
    let columns = if total - 18.0 <= width {
        most
    } else {
        ((width / widest).floor() as usize).clamp(1, most)
    };
    let count = entries.len().div_ceil(columns);
    let mut legend = Legend {
        height: count as f64 * ROW,
        right: x,
        entries: vec![],
    };
    let mut at = x;
    for (i, entry) in entries.into_iter().enumerate() {
        if count > 1 {
            at = x + (i % columns) as f64 * widest;
        }
        let end = at + long(&entry);
        let row = y + ((i / columns) as f64 + 0.5) * ROW;
        legend.entries.push((at, row, entry));
        legend.right = legend.right.max(end);
        at = end + 18.0;
    }
    legend
}
