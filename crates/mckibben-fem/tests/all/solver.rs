//! Chains, sparse patterns, orders of unknowns and predicted states, without elements.

use mckibben_core::random::Random;
use mckibben_fem::solver::{
    body::State,
    chain::Chain,
    dense,
    dissection::Sheet,
    symbolic::{Pattern, Symbolic},
    trail::{Along, Trail},
};
use nalgebra::{DMatrix, DVector};

/// Up to how many columns a supernode may have which share of zeros.
const ZEROS: [(usize, f64); 4] = [(4, 1.0), (16, 0.8), (48, 0.1), (usize::MAX, 0.05)];

fn patterns() -> impl Iterator<Item = Pattern> {
    let mut r = Random(5);
    (0..300).map(move |case| {
        let n = case % 41;
        let density = [0.02, 0.06, 0.15, 0.6][case % 4];
        let (mut columns, mut rows) = (vec![0], vec![]);
        for j in 0..n {
            rows.push(j as u32);
            let near = |i: usize| case % 3 == 0 && i < j + 3;
            rows.extend(
                (j + 1..n)
                    .filter(|i| r.between(0.0, 1.0) < density || near(*i))
                    .map(|i| i as u32),
            );
            columns.push(rows.len() as u32);
        }
        Pattern { columns, rows }
    })
}

/// Rows of each column of L by elimination on the whole matrix.
fn eliminated(pattern: &Pattern) -> Vec<Vec<u32>> {
    let n = pattern.dimension();
    let mut full = vec![vec![false; n]; n];
    for (j, column) in full.iter_mut().enumerate() {
        for k in pattern.columns[j]..pattern.columns[j + 1] {
            column[pattern.rows[k as usize] as usize] = true;
        }
    }
    for k in 0..n {
        let pivot = full[k].clone();
        for j in (k + 1..n).filter(|j| pivot[*j]) {
            full[j][j..]
                .iter_mut()
                .zip(&pivot[j..])
                .for_each(|(to, from)| *to |= from);
        }
    }
    full.iter()
        .map(|c| (0..n as u32).filter(|i| c[*i as usize]).collect())
        .collect()
}

/// Rows of each column as the supernodes have them.
fn columns(s: &Symbolic) -> Vec<Vec<u32>> {
    let supernode = |i: usize| {
        s.columns(i)
            .map(move |j| (j as u32..s.columns(i).end as u32).chain(s.below(i).iter().copied()))
    };
    (0..s.count())
        .flat_map(supernode)
        .map(Iterator::collect)
        .collect()
}

#[test]
fn fundamental_supernodes_have_the_rows_of_the_elimination() {
    for pattern in patterns() {
        let s = Symbolic::fundamental(&pattern).unwrap();
        let wanted = eliminated(&pattern);
        assert_eq!(columns(&s), wanted);
        // Two neighbours are one supernode just where the later one is the parent of the
        // earlier one alone and has the same rows.
        for j in 1..pattern.dimension() {
            let parent = |c: &Vec<u32>| c.get(1) == Some(&(j as u32));
            let only =
                parent(&wanted[j - 1]) && wanted[..j].iter().filter(|c| parent(c)).count() == 1;
            let one = only && wanted[j - 1].len() == wanted[j].len() + 1;
            let begins = (0..s.count()).any(|i| s.columns(i).start == j);
            assert_eq!(!begins, one, "{j}");
        }
    }
}

#[test]
fn merged_supernodes_hold_the_elimination_with_few_zeros_more() {
    for pattern in patterns() {
        let s = Symbolic::from_pattern(&pattern).unwrap();
        let (wanted, got) = (eliminated(&pattern), columns(&s));
        assert_eq!(got.len(), wanted.len());
        assert!(
            wanted
                .iter()
                .zip(&got)
                .all(|(w, g)| w.iter().all(|r| g.contains(r)))
        );
        for i in 0..s.count() {
            let entries =
                |c: &[Vec<u32>]| c[s.columns(i)].iter().map(Vec::len).sum::<usize>() as f64;
            let (all, width) = (entries(&got), s.columns(i).len());
            let share = ZEROS.iter().find(|z| z.0 >= width).unwrap().1;
            assert!(all - entries(&wanted) <= share * all);
            assert_eq!(s.values(i).len(), width * s.height(i));
            let inside = |d: &usize| {
                s.below(*d)
                    .iter()
                    .any(|r| s.columns(i).contains(&(*r as usize)))
            };
            let earlier: Vec<u32> = (0..i).filter(inside).map(|d| d as u32).collect();
            assert_eq!(s.updates(i), earlier);
        }
        assert_eq!(
            s.entries(),
            (0..s.count()).map(|i| s.values(i).len()).sum::<usize>()
        );
    }
}

/// Indefinite chains of random slabs, against the product of the whole matrix and its dense
/// eigenvalues: x from K x, and by Sylvester's law as many negative pivots as eigenvalues.
#[test]
fn a_chain_has_the_dense_solution_and_inertia() {
    let mut random = Random(7);
    for (slabs, station, inside) in [(1, 1, 0), (1, 3, 2), (5, 4, 7), (12, 2, 1)] {
        let mut chain = Chain::new(slabs, station, inside);
        let (size, step) = (chain.size(), inside + station);
        let dimension = slabs * step + station;
        let mut whole = DMatrix::<f64>::zeros(dimension, dimension);
        chain.begin();
        for slab in 0..slabs {
            // A slab is ordered [inside | left station | right station].
            let place = |i: usize| {
                let local = if i < inside {
                    station + i
                } else if i < step {
                    i - inside
                } else {
                    i
                };
                slab * step + local
            };
            let a = chain.slab_mut(slab);
            for (i, j) in (0..size).flat_map(|i| (i..size).map(move |j| (i, j))) {
                let (p, q) = (place(i), place(j));
                let sign = if p % 3 == 1 { -1.0 } else { 1.0 };
                a[i * size + j] = if i == j {
                    sign * size as f64
                } else {
                    random.between(-0.5, 0.5)
                };
                whole[(p, q)] += a[i * size + j];
                whole[(q, p)] = whole[(p, q)];
            }
            chain.eliminate(slab).unwrap();
        }
        let mut end = chain.end.clone();
        let negative = chain.negative + dense::eliminate(&mut end, station, station).unwrap();
        let wanted = DVector::from_fn(dimension, |i, _| 1.5 + ((i * i) as f64).sin());
        let mut x = (&whole * &wanted).as_slice().to_vec();
        chain.forward(&mut x);
        let last = &mut x[slabs * step..];
        dense::forward(&end, station, station, last);
        dense::backward(&end, station, station, last);
        chain.backward(&mut x);
        let off = x.iter().zip(&wanted).map(|(x, y)| (x - y).abs());
        let off = off.fold(0.0, f64::max);
        assert!(off < 1e-12, "{slabs} {station} {inside}: {off:e}");
        let eigenvalues = whole.symmetric_eigenvalues();
        let expected = eigenvalues.iter().filter(|x| **x < 0.0).count();
        assert_eq!(negative, expected, "{slabs} {station} {inside}");
    }
}

#[test]
fn every_point_comes_once() {
    for (around, along, stride) in [(1, 1, 1), (13, 39, 1), (25, 78, 2), (2, 100, 1), (3, 7, 2)] {
        let mut all = Sheet {
            around,
            along,
            stride,
        }
        .order();
        assert_eq!(all.len(), around * along);
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), around * along);
    }
}

#[test]
fn a_cubic_is_predicted_exactly() {
    let at = |p: f64| State {
        u: vec![p * p * p - 2.0 * p],
        pressure: p,
        ..State::default()
    };
    let mut trail = Trail::default();
    for p in [9.0, 0.1, 0.3, 0.4, 0.9] {
        trail.push(&at(p));
    }
    let mut out = at(0.0);
    assert!(trail.predict(Along::Pressure, 1.5, &mut out));
    assert!((out.u[0] - at(1.5).u[0]).abs() < 1e-13 && out.pressure == 1.5);
    assert!(!trail.predict(Along::Length, 1.0, &mut out));
}
