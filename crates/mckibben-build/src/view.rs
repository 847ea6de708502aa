//! Tools of a drawing: a view at a scale, sections, dimensions.

use crate::plug::Plug;
use mckibben_report::{
    Anchor, DrawingSheet,
    Pen::{self, Outline, Thin},
};

/// Height of dimensions and notes in mm.
const SMALL_MM: f64 = 2.5;
/// Length and half width of an arrow in mm.
const ARROW_MM: (f64, f64) = (2.5, 0.42);
/// An extension line begins so far from the body, and ends so far beyond the dimension, in mm.
const GAP_MM: f64 = 0.8;
const BEYOND_MM: f64 = 1.5;
/// Greys of arrows and sections.
const INK: u8 = 0x22;
const METAL: u8 = 0xe0;
const WHITE: u8 = 0xff;

/// A body drawn at a scale: `origin` is where its point (0, 0) lies on the sheet.
pub struct View {
    pub sheet: DrawingSheet,
    pub origin: [f64; 2],
    /// mm on paper for each mm of the body.
    pub scale: f64,
}

impl View {
    /// Where a point of the body lies on the sheet.
    pub fn on_sheet(&self, x: f64, y: f64) -> [f64; 2] {
        [
            self.origin[0] + self.scale * x,
            self.origin[1] + self.scale * y,
        ]
    }

    fn all_on_sheet(&self, points: &[[f64; 2]]) -> Vec<[f64; 2]> {
        points.iter().map(|[x, y]| self.on_sheet(*x, *y)).collect()
    }

    pub fn line(&mut self, pen: Pen, points: &[[f64; 2]]) {
        self.sheet.line(pen, self.all_on_sheet(points));
    }

    pub fn outline(&mut self, pen: Pen, corners: &[[f64; 2]]) {
        self.sheet.outline(pen, self.all_on_sheet(corners));
    }

    pub fn rectangle(&mut self, x: [f64; 2], y: [f64; 2]) {
        self.outline(
            Outline,
            &[[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]],
        );
    }

    /// A plug in section, whose free length ends at `datum` of the body, with its head away from the
    /// middle.
    pub fn plug(&mut self, plug: &Plug, datum: f64, side: f64) {
        let place = |loop_: Vec<[f64; 2]>| -> Vec<[f64; 2]> {
            let at = |[z, y]: [f64; 2]| [datum + side * (z - plug.stem.datum_mm), y];
            loop_.into_iter().map(at).collect()
        };
        let (outline, hollows) = plug.section();
        self.section(METAL, Outline, &place(outline));
        for hollow in hollows {
            self.section(WHITE, Outline, &place(hollow));
        }
    }

    /// What is cut, or hollow in it.
    fn section(&mut self, grey: u8, pen: Pen, corners: &[[f64; 2]]) {
        self.sheet.fill(grey, self.all_on_sheet(corners));
        self.outline(pen, corners);
    }

    /// A cut ring, on both sides of the axis.
    pub fn cut(&mut self, [a, b]: [f64; 2], [inner, outer]: [f64; 2], grey: u8) {
        for sign in [-1.0, 1.0] {
            let [low, high] = [sign * inner, sign * outer];
            self.section(grey, Thin, &[[a, low], [b, low], [b, high], [a, high]]);
        }
    }

    /// A horizontal dimension between x of the body; its line lies at `row`, in mm on paper from
    /// the axis. Extension lines begin at `from` of the body.
    pub fn across(&mut self, x: (f64, f64), from: (f64, f64), row: f64, text: &str) {
        self.extended(
            [self.on_sheet(x.0, from.0), self.on_sheet(x.1, from.1)],
            1,
            row,
            text,
        );
    }

    /// A vertical dimension beside the body: its line lies at `column`, in mm on paper from the
    /// origin.
    pub fn beside(&mut self, y: (f64, f64), from: f64, column: f64, text: &str) {
        self.extended(
            [self.on_sheet(from, y.0), self.on_sheet(from, y.1)],
            0,
            column,
            text,
        );
    }

    /// A dimension whose line lies at `offset` from the origin along a coordinate, with arrows,
    /// extension lines from both ends, and its text: above a horizontal one, to the left of an upright
    /// one. Where arrows have no room inside they point from outside.
    fn extended(&mut self, ends: [[f64; 2]; 2], across: usize, offset: f64, text: &str) {
        let is_upright = across == 0;
        let along = 1 - across;
        let sheet = &mut self.sheet;
        let place = self.origin[across] + offset;
        let at = |v: f64, w: f64| if is_upright { [w, v] } else { [v, w] };
        for end in ends {
            let gap = GAP_MM * (place - end[across]).signum();
            let last = place + BEYOND_MM * offset.signum();
            let from = at(end[along], end[across] + gap);
            sheet.line(Thin, [from, at(end[along], last)]);
        }
        let [a, b] = ends.map(|end| end[along]);
        let way = (b - a).signum();
        let length = (b - a).abs();
        let fits = length > 2.5 * ARROW_MM.0;
        let inward = if fits { way } else { -way };
        let half = if is_upright { -way } else { way } * ARROW_MM.1;
        for (tip, way) in [(a, inward), (b, -inward)] {
            let foot = tip + way * ARROW_MM.0;
            let corners = [
                at(tip, place),
                at(foot, place + half),
                at(foot, place - half),
            ];
            sheet.fill(INK, corners);
        }
        let out = if fits { 0.0 } else { 2.0 * ARROW_MM.0 * way };
        let [from, to] = [at(a - out, place), at(b + out, place)];
        let middle = 0.5 * (a + b);
        if is_upright {
            sheet.line(Thin, [from, to]);
            return sheet.text_upwards([place - 1.0, middle], SMALL_MM, Anchor::Middle, text);
        }
        let width = width_of(text);
        if fits && width + 2.0 < length {
            sheet.line(Thin, [from, to]);
            return sheet.text([middle, place + 1.0], SMALL_MM, Anchor::Middle, text);
        }
        // Beyond the end, on a shelf.
        sheet.line(Thin, [from, to, [to[0] + width + 1.5, place]]);
        sheet.text([to[0] + 1.0, place + 1.0], SMALL_MM, Anchor::Start, text);
    }
}

/// The approximate width of a text, in mm.
fn width_of(text: &str) -> f64 {
    0.75 * SMALL_MM * text.chars().count() as f64
}
