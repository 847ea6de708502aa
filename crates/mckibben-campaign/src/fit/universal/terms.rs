//! The products that the forms are sums of.

use mckibben::formula::Form;

/// S, A, B, M, L: chosen one by one on a campaign with muscles left out (forward selection among the products up to the
/// third degree), then kept.
const BULGE: [[u8; 5]; 16] = [
    [0, 0, 0, 0, 0],
    [0, 0, 0, 1, 0],
    [0, 0, 0, 0, 3],
    [0, 1, 0, 2, 0],
    [0, 1, 0, 0, 0],
    [0, 1, 0, 1, 0],
    [0, 0, 0, 3, 0],
    [0, 0, 0, 2, 0],
    [0, 0, 1, 0, 2],
    [0, 0, 0, 0, 1],
    [0, 1, 1, 0, 1],
    [0, 0, 0, 2, 1],
    [0, 0, 1, 0, 1],
    [0, 0, 2, 0, 1],
    [0, 0, 1, 2, 0],
    [0, 0, 3, 0, 0],
];

/// All products of a form: for `membrane` the 21 of degree two and less.
pub fn products(form: Form) -> Vec<[u8; 5]> {
    match form {
        Form::Bulge => BULGE.to_vec(),
        Form::Membrane => {
            let mut out = vec![[0; 5]];
            let unit = |i: usize| {
                let mut n = [0_u8; 5];
                n[i] = 1;
                n
            };
            out.extend((0..5).map(unit));
            out.extend((0..5).flat_map(|i| {
                (i..5).map(move |j| {
                    let mut n = unit(i);
                    n[j] += 1;
                    n
                })
            }));
            out
        }
    }
}
