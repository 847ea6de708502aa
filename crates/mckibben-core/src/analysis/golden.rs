//! The least of a function of one variable.

/// Where a function is least, and its value there, by golden section between `left` and `right` from
/// a sample between them.
pub fn golden(
    left: f64,
    start: (f64, f64),
    right: f64,
    steps: usize,
    mut at: impl FnMut(f64) -> f64,
) -> (f64, f64) {
    const SHARE: f64 = 0.381_966_011_250_105;
    let mut a = left;
    let (mut b, mut least) = start;
    let mut c = right;
    for _ in 0..steps {
        let x = if c - b > b - a {
            b + SHARE * (c - b)
        } else {
            b - SHARE * (b - a)
        };
        if x == b {
            break;
        }
        let value = at(x);
        if value < least {
            if x > b {
                a = b
            } else {
                c = b
            }
            (b, least) = (x, value);
        } else if x > b {
            c = x;
        } else {
            a = x;
        }
    }
    (b, least)
}
