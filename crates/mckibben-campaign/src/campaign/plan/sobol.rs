//! Sobol's sequence beyond 65,536 points, scrambled by Owen's method.
//!
//! Point n is the sum modulo 2 of the direction numbers v_j of the digits j of n that are one. The library that gives shorter
//! sequences has the first 16 direction numbers of Joe and Kuo (2008, file new-joe-kuo-6) \[joe2008\] in 32 bits. The others follow from their recurrence
//!
//!   v_j = v_{j−s} ⊕ (v_{j−s} ≫ s) ⊕ Σ_{k=1}^{s−1} a_k v_{j−k}
//!
//! with the primitive polynomial x^s + a_1 x^{s−1} + … + a_{s−1} x + 1 of the dimension. Each dimension is scrambled with the hash of
//! Burley (2020) \[burley2020\].

use sobol_burley::parts::{hash, owen_scramble_rev, sobol_rev};
use std::sync::LazyLock;

/// Direction numbers, one for each binary digit of a point's number.
const DIGITS: usize = 32;
/// Direction numbers that the library has.
const KNOWN: usize = 16;

/// Degree s and coefficients a_1 … a_{s−1} as binary digits, from the second dimension on: the primitive polynomials modulo 2 in the
/// order of Joe and Kuo.
const POLYNOMIALS: [(u8, u8); 52] = [
    (1, 0),
    (2, 1),
    (3, 1),
    (3, 2),
    (4, 1),
    (4, 4),
    (5, 2),
    (5, 4),
    (5, 7),
    (5, 11),
    (5, 13),
    (5, 14),
    (6, 1),
    (6, 13),
    (6, 16),
    (6, 19),
    (6, 22),
    (6, 25),
    (7, 1),
    (7, 4),
    (7, 7),
    (7, 8),
    (7, 14),
    (7, 19),
    (7, 21),
    (7, 28),
    (7, 31),
    (7, 32),
    (7, 37),
    (7, 41),
    (7, 42),
    (7, 50),
    (7, 55),
    (7, 56),
    (7, 59),
    (7, 62),
    (8, 14),
    (8, 21),
    (8, 22),
    (8, 38),
    (8, 47),
    (8, 49),
    (8, 50),
    (8, 52),
    (8, 56),
    (8, 67),
    (8, 70),
    (8, 84),
    (8, 97),
    (8, 103),
    (8, 115),
    (8, 122),
];

pub(super) const MOST_DIMENSIONS: usize = POLYNOMIALS.len() + 1;

static VECTORS: LazyLock<Vec<[u32; DIGITS]>> = LazyLock::new(|| (0..MOST_DIMENSIONS).map(vectors).collect());

fn vectors(dimension: usize) -> [u32; DIGITS] {
    let mut v = [0; DIGITS];
    for (j, v) in v.iter_mut().enumerate() {
        // Of the first dimension (van der Corput's) all are powers of two.
        *v = if dimension == 0 { 1 << (DIGITS - 1 - j) } else { 0 };
    }
    let Some((s, a)) = dimension.checked_sub(1).map(|i| POLYNOMIALS[i]) else { return v };
    let (s, a) = (usize::from(s), u32::from(a));
    for j in 0..DIGITS {
        v[j] = if j < KNOWN {
            sobol_rev((1_u32 << j).reverse_bits(), dimension as u32).reverse_bits()
        } else {
            let first = v[j - s] ^ (v[j - s] >> s);
            (1..s).filter(|k| a >> (s - 1 - k) & 1 == 1).fold(first, |sum, k| sum ^ v[j - k])
        };
    }
    v
}

/// Coordinate of a point before it is scrambled, times 2³².
fn plain(number: u32, dimension: usize) -> u32 {
    let vectors = &VECTORS[dimension];
    (0..DIGITS).filter(|j| number >> j & 1 == 1).fold(0, |sum, j| sum ^ vectors[j])
}

/// A coordinate of a point, 0 ≤ u < 1.
pub(super) fn sample(number: u32, dimension: usize, seed: u32) -> f64 {
    // Numbers that follow one another make unlike scrambles only after a hash of each.
    let scramble = hash(hash(seed) ^ dimension as u32);
    let bits = owen_scramble_rev(plain(number, dimension).reverse_bits(), scramble).reverse_bits();
    f64::from(bits) / 4_294_967_296.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The recurrence gives the library's own numbers where it has them, in every dimension.
    #[test]
    fn the_polynomials_are_those_of_the_library() {
        for dimension in 1..MOST_DIMENSIONS {
            let v = VECTORS[dimension];
            let (s, a) = POLYNOMIALS[dimension - 1];
            let (s, a) = (usize::from(s), u32::from(a));
            for j in s..KNOWN {
                let first = v[j - s] ^ (v[j - s] >> s);
                let next = (1..s).filter(|k| a >> (s - 1 - k) & 1 == 1).fold(first, |sum, k| sum ^ v[j - k]);
                assert_eq!(v[j], next, "dimension {dimension}, number {j}");
            }
        }
    }

    /// Points of SciPy 1.17.1, `qmc.Sobol(d=53, scramble=False, bits=32)`, which counts in Gray's code: its point n is point n ⊕ (n ≫ 1) here.
    #[test]
    fn points_beyond_the_library_are_those_of_scipy() {
        for (number, dimension, expected) in SCIPY {
            let gray = number ^ (number >> 1);
            assert_eq!(plain(gray, dimension), expected, "point {number}, dimension {dimension}");
        }
    }

    const SCIPY: [(u32, usize, u32); 24] = [
        (65536, 0, 98304),
        (65536, 1, 2147450880),
        (65536, 4, 1648132096),
        (65536, 17, 2411692032),
        (65536, 36, 518815744),
        (65536, 52, 3298918400),
        (70001, 0, 2476310528),
        (70001, 1, 2718400512),
        (70001, 4, 3313795072),
        (70001, 17, 1915191296),
        (70001, 36, 2289336320),
        (70001, 52, 3843653632),
        (1000003, 0, 1187450880),
        (1000003, 1, 2413424640),
        (1000003, 4, 3773812736),
        (1000003, 17, 2179633152),
        (1000003, 36, 796602368),
        (1000003, 52, 2365394944),
        (9999999, 0, 45820672),
        (9999999, 1, 3658317056),
        (9999999, 4, 2657412352),
        (9999999, 17, 2859214080),
        (9999999, 36, 2999917312),
        (9999999, 52, 362660608),
    ];

    /// A (0, m, 2)-net for the first two dimensions, scrambled, where the library ends: of 2^m points that begin at a multiple of 2^m one
    /// lies in each rectangle of area 2^−m.
    #[test]
    fn scrambled_points_beyond_the_library_are_a_net() {
        let from = 5 << 16;
        for m in 0..=10_u32 {
            let (columns, rows) = (1_usize << m, 1_usize << (10 - m));
            let mut hits = vec![0; 1024];
            for i in from..from + 1024 {
                let cell = |dimension, n: usize| (sample(i, dimension, 7) * n as f64) as usize;
                hits[cell(0, columns) * rows + cell(1, rows)] += 1;
            }
            assert!(hits.iter().all(|h| *h == 1), "{columns} x {rows}");
        }
    }
}
