//! Texts beside marks, kept clear of the data and of each other.

use crate::{
    curve::Frame,
    figure::Mark,
    font::Metrics,
    rect::{Rect, Spot, between},
    room::Room,
};

/// Font size of these texts.
pub const SIZE: f64 = 10.0;
/// Radius of the ring of a mark.
pub const RING: f64 = 5.2;
/// Height kept for them.
pub const HEIGHT: f64 = 11.0;

/// Directions tried for the text of a mark, degrees, the best liked first.
const DIRECTIONS: [f64; 14] = [
    30.0, -30.0, 150.0, -150.0, 0.0, 180.0, 90.0, -90.0, 60.0, -60.0, 120.0, -120.0, 15.0, -15.0,
];

/// Distances tried between ring and text.
const GAPS: [f64; 7] = [3.0, 12.0, 24.0, 40.0, 56.0, 72.0, 90.0];

pub struct Label {
    /// Left end of the text at half its height.
    pub at: Spot,
    pub text: String,
    /// Colour number; `None`: ink.
    pub colour: Option<usize>,
    /// A thin line from the mark to its text.
    pub leader: Option<(Spot, Spot)>,
}

fn around(at: Spot, w: f64) -> Rect {
    Rect {
        x: at.0,
        y: at.1 - HEIGHT / 2.0,
        w,
        h: HEIGHT,
    }
}

/// Left end of a text of a width at the place of the least cost, and takes its box: of drawn lines and
/// points under it, of texts under it, of parts outside of the plot, and what each place costs by itself.
pub fn cheapest(places: impl Iterator<Item = (f64, Spot)>, w: f64, room: &mut Room) -> Spot {
    let within = room.plot.grown(-2.0);
    let mut best = (f64::INFINITY, Spot::default());
    for (least, at) in places {
        if least >= best.0 {
            continue;
        }
        let rect = around(at, w);
        let near = rect.grown(1.0);
        let mut cost = 2.0 * room.drawn_under(&near) as f64 + least;
        if room.meets_box(&near) {
            cost += 1000.0;
        }
        if !within.holds(&rect) {
            cost += 3000.0;
        }
        if cost < best.0 {
            best = (cost, at);
        }
    }
    let (_, (x, y)) = best;
    let at = (
        x.min(within.right() - w).max(within.x),
        y.min(within.bottom() - HEIGHT / 2.0)
            .max(within.y + HEIGHT / 2.0),
    );
    room.add_box(around(at, w));
    at
}

/// Notes the rings of the marks, so that texts keep away from all of them.
pub fn add_rings(marks: &[Mark], frame: &Frame, room: &mut Room) {
    for spot in marks.iter().filter_map(|m| frame.mark(m)) {
        room.add_box(Rect::about(spot, RING + 1.0));
    }
}

/// Places the texts of the marks.
pub fn for_marks(marks: &[Mark], frame: &Frame, metrics: &Metrics, room: &mut Room) -> Vec<Label> {
    let within = frame.plot.grown(-2.0);
    let mut labels = Vec::new();
    for mark in marks {
        let text = metrics.fit(mark.label.trim(), SIZE, within.w);
        let Some(spot) = frame.mark(mark).filter(|_| !text.is_empty()) else {
            continue;
        };
        let w = metrics.width(&text, SIZE);
        let at = cheapest(beside(spot, w), w, room);
        labels.push(Label {
            at,
            text,
            colour: None,
            leader: leader(spot, &around(at, w)),
        });
    }
    labels
}

/// Places for the text of a mark; the farther away, the more they cost.
fn beside(spot: Spot, w: f64) -> impl Iterator<Item = (f64, Spot)> {
    let place = move |(ring, gap): (usize, f64), (turn, angle): (usize, f64)| {
        let distance = RING + gap;
        let (up, across) = f64::to_radians(angle).sin_cos();
        // the text begins or ends at this distance; straight above and below it is centred
        let half = if across.abs() > 0.01 {
            across.signum() * w / 2.0
        } else {
            0.0
        };
        let at = (
            spot.0 + across * distance + half - w / 2.0,
            spot.1 - up * (distance + HEIGHT / 2.0 - 2.0),
        );
        (5.0 * ring as f64 + 0.4 * turn as f64, at)
    };
    let directions = || DIRECTIONS.into_iter().enumerate();
    let gaps = GAPS.into_iter().enumerate();
    gaps.flat_map(move |gap| directions().map(move |direction| place(gap, direction)))
}

/// The line from a ring to the nearest place of a text's box.
fn leader(spot: Spot, rect: &Rect) -> Option<(Spot, Spot)> {
    let near = (
        spot.0.clamp(rect.x - 1.0, rect.right() + 1.0),
        spot.1.clamp(rect.y, rect.bottom()),
    );
    let length = (near.0 - spot.0).hypot(near.1 - spot.1);
    (length > RING + 5.5).then(|| (between(spot, near, RING / length), near))
}
