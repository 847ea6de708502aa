//! Places and rectangles of the drawing.

/// Units of the drawing for a millimetre.
pub const PER_MM: f64 = 4.0;

/// A point of the drawing, in its units, y downward.
pub type Spot = (f64, f64);

/// The spot a part of the way from one to another.
pub fn between(from: Spot, to: Spot, part: f64) -> Spot {
    (
        from.0 + part * (to.0 - from.0),
        from.1 + part * (to.1 - from.1),
    )
}

/// A rectangle of the drawing.
#[derive(Clone, Copy)]
pub struct Rect {
    pub x: f64,
    pub y: f64,
    pub w: f64,
    pub h: f64,
}

impl Rect {
    /// A square about its middle.
    pub fn about((x, y): Spot, half: f64) -> Self {
        Self {
            x,
            y,
            w: 0.0,
            h: 0.0,
        }
        .grown(half)
    }

    pub fn middle(&self) -> Spot {
        (self.x + self.w / 2.0, self.y + self.h / 2.0)
    }

    pub fn right(&self) -> f64 {
        self.x + self.w
    }

    pub fn bottom(&self) -> f64 {
        self.y + self.h
    }

    /// Grown by `by` on every side.
    pub fn grown(&self, by: f64) -> Self {
        Self {
            x: self.x - by,
            y: self.y - by,
            w: self.w + 2.0 * by,
            h: self.h + 2.0 * by,
        }
    }

    pub fn meets(&self, other: &Self) -> bool {
        self.x < other.right()
            && other.x < self.right()
            && self.y < other.bottom()
            && other.y < self.bottom()
    }

    pub fn holds(&self, other: &Self) -> bool {
        self.x <= other.x
            && other.right() <= self.right()
            && self.y <= other.y
            && other.bottom() <= self.bottom()
    }

    pub fn has(&self, (x, y): Spot) -> bool {
        x >= self.x && x <= self.right() && y >= self.y && y <= self.bottom()
    }
}
