//! Unknowns with bounds, as unknowns without any.
//!
//! James & Roos (1975) \[james1975\], the transformations of MINUIT:
//!
//!   both ends      x = (low + high)/2 + (high − low)/2 · sin u
//!   low end only   x = low + h (√(u² + 1) − 1)
//!   none           x = start + h u
//!
//! h: the unknown's scale, so that u is of order one whatever the unit.

/// One unknown of an estimate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unknown {
    /// Where the search begins; moved inside of the bounds if it is not.
    pub start: f64,
    /// Lowest value; −∞ for none.
    pub low: f64,
    /// Highest value; +∞ for none.
    pub high: f64,
    /// A change of this unknown that would matter: its typical size. Positive.
    pub scale: f64,
}

impl Unknown {
    /// Without bounds.
    pub fn free(start: f64, scale: f64) -> Self {
        Self {
            start,
            low: f64::NEG_INFINITY,
            high: f64::INFINITY,
            scale,
        }
    }

    /// With a lower bound alone.
    pub fn above(start: f64, low: f64, scale: f64) -> Self {
        Self {
            start,
            low,
            high: f64::INFINITY,
            scale,
        }
    }

    /// Whether the numbers make an unknown.
    pub(super) fn is_sound(&self) -> bool {
        let numbers = self.start.is_finite() && self.scale.is_finite() && self.scale > 0.0;
        numbers && self.low < self.high && !(self.low.is_infinite() && self.high.is_finite())
    }

    /// How near to a bound counts as on it.
    fn margin(&self) -> f64 {
        let width = self.high - self.low;
        1e-3 * if width.is_finite() {
            self.scale.min(width)
        } else {
            self.scale
        }
    }

    /// Whether a value lies on a bound.
    pub fn is_at_bound(&self, x: f64) -> bool {
        x - self.low < self.margin() || self.high - x < self.margin()
    }

    /// The value itself, or the bound on which it lies.
    pub fn at_its_bound(&self, x: f64) -> f64 {
        match (x - self.low < self.margin(), self.high - x < self.margin()) {
            (true, _) => self.low,
            (_, true) => self.high,
            _ => x,
        }
    }

    /// u of the start.
    pub(super) fn inner_start(&self) -> f64 {
        let inside = self.start.clamp(
            self.low + 20.0 * self.margin(),
            self.high - 20.0 * self.margin(),
        );
        if self.high.is_finite() {
            ((2.0 * inside - self.low - self.high) / (self.high - self.low))
                .clamp(-1.0, 1.0)
                .asin()
        } else if self.low.is_finite() {
            let y = (inside - self.low) / self.scale + 1.0;
            (y * y - 1.0).max(0.0).sqrt()
        } else {
            0.0
        }
    }

    /// x(u) and dx/du.
    pub(super) fn outer(&self, u: f64) -> (f64, f64) {
        if self.high.is_finite() {
            let half = 0.5 * (self.high - self.low);
            (
                0.5 * (self.low + self.high) + half * u.sin(),
                half * u.cos(),
            )
        } else if self.low.is_finite() {
            let root = (u * u + 1.0).sqrt();
            (self.low + self.scale * (root - 1.0), self.scale * u / root)
        } else {
            (self.start + self.scale * u, self.scale)
        }
    }
}
