//! A grid of characters with colours, on which a chart for a terminal is drawn.

use std::collections::BTreeMap;
use unicode_width::UnicodeWidthStr;

/// How a character looks: a colour of the terminal's 256, or its own.
pub(crate) type Look = Option<u8>;

/// Dots of a braille character by row and column, and the character without any.
const DOTS: [[u32; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];
const BRAILLE: u32 = 0x2800;

/// One place of a grid; empty behind a character that is two columns wide.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Cell {
    pub text: String,
    pub look: Look,
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Grid {
    pub width: usize,
    pub height: usize,
    cells: Vec<Cell>,
}

/// Where a part of a grid lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Area {
    pub x: usize,
    pub y: usize,
    pub width: usize,
    pub height: usize,
}

impl Grid {
    pub fn new(width: usize, height: usize) -> Self {
        let blank = Cell { text: " ".into(), look: None };
        Self { width, height, cells: vec![blank; width * height] }
    }

    pub fn cell(&self, x: usize, y: usize) -> Option<&Cell> {
        (x < self.width).then(|| self.cells.get(y * self.width + x)).flatten()
    }

    /// Writes a text as far as the grid reaches.
    pub fn put(&mut self, mut x: usize, y: usize, text: &str, look: Look) {
        for c in text.chars().filter(|c| !c.is_control()) {
            let text = c.to_string();
            let columns = text.width();
            if y >= self.height || x + columns.max(1) > self.width {
                return;
            }
            let at = y * self.width + x;
            if columns == 0 {
                // It belongs to the character before.
                if x > 0 {
                    self.cells[at - 1].text.push(c);
                }
                continue;
            }
            self.cells[at] = Cell { text, look };
            self.cells[at + 1..at + columns].fill(Cell::default());
            x += columns;
        }
    }

    /// Sets dots in an area, two a column and four a row, counted from its upper left corner: of a place with dots of several colours the last one counts.
    pub fn dots(&mut self, area: Area, all: impl IntoIterator<Item = ((u16, u16), Look)>) {
        let mut places: BTreeMap<(usize, usize), (u32, Look)> = BTreeMap::new();
        for ((x, y), look) in all {
            let (x, y) = (usize::from(x), usize::from(y));
            let place = places.entry((x / 2, y / 4)).or_default();
            *place = (place.0 | DOTS[y % 4][x % 2], look);
        }
        for ((column, row), (dots, look)) in places {
            if let Some(c) =
                char::from_u32(BRAILLE + dots).filter(|_| column < area.width && row < area.height)
            {
                self.put(area.x + column, area.y + row, &c.to_string(), look);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By the code chart of Unicode: dots 1, 4, 7 and 8 are 0x01, 0x08, 0x40 and 0x80.
    #[test]
    fn dots_are_those_of_the_code_chart() {
        let mut grid = Grid::new(3, 1);
        let area = Area { x: 1, y: 0, width: 2, height: 1 };
        grid.dots(
            area,
            [((0, 0), None), ((1, 0), Some(2)), ((1, 3), Some(3)), ((2, 3), None), ((9, 0), None)],
        );
        assert_eq!(grid.cell(1, 0), Some(&Cell { text: "\u{2889}".into(), look: Some(3) }));
        assert_eq!(grid.cell(2, 0).unwrap().text, "\u{2840}");
        assert_eq!(grid.cell(0, 0).unwrap().text, " ");
    }

    #[test]
    fn a_text_ends_with_the_grid_and_wide_characters_take_two_places() {
        let mut grid = Grid::new(4, 1);
        grid.put(0, 0, "a漢b漢", None);
        let texts: Vec<&str> = (0..4).map(|x| grid.cell(x, 0).unwrap().text.as_str()).collect();
        assert_eq!(texts, ["a", "漢", "", "b"]);
        grid.put(0, 7, "outside", None);
        assert_eq!(grid.cell(4, 0), None);
    }
}
