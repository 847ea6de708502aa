//! The least of a function of one variable.

/// Golden section between `left` and `right`, from a sample between them.
pub fn golden<S: Abscissa, M: PartialOrd>(
    left: f64,
    start: S,
    right: f64,
    steps: usize,
    merit: impl Fn(&S) -> M,
    at: &mut impl FnMut(f64) -> S,
) -> S {
    const SHARE: f64 = 0.381_966_011_250_105;
    let mut a = left;
    let mut best = start;
    let mut c = right;
    for _ in 0..steps {
        let b = best.place();
        let x = if c - b > b - a {
            b + SHARE * (c - b)
        } else {
            b - SHARE * (b - a)
        };
        if x == b {
            break;
        }
        let tried = at(x);
        if merit(&tried) < merit(&best) {
            if x > b {
                a = b
            } else {
                c = b
            }
            best = tried;
        } else if x > b {
            c = x;
        } else {
            a = x;
        }
    }
    best
}

/// Something at a place of an axis.
pub trait Abscissa {
    /// The place.
    fn place(&self) -> f64;
}

impl<T> Abscissa for (f64, T) {
    fn place(&self) -> f64 {
        self.0
    }
}
