//! A chain of slabs: symmetric systems in which slab e joins station e to station e + 1.
//!
//! A vector is laid out [station 0 | inside 0 | station 1 | inside 1 | … | last station]; the
//! matrix of a slab is ordered [inside | left station | right station]. Going along the chain each
//! slab loses its inside and its left station, and hands the Schur complement of its right station
//! to the next. The last station remains.

use super::{
    dense,
    newton::{Solved, Stopped},
};

/// The chain and its factorisation.
#[derive(Debug, Clone)]
pub struct Chain {
    station: usize,
    inside: usize,
    slabs: usize,
    matrices: Vec<f64>,
    /// Schur complement of the last station by rows, upper triangle.
    pub end: Vec<f64>,
    scratch: Vec<f64>,
    /// Negative pivots so far.
    pub negative: usize,
}

impl Chain {
    /// A chain of `slabs` slabs with `station` unknowns at each station and `inside` unknowns
    /// inside of each slab.
    pub fn new(slabs: usize, station: usize, inside: usize) -> Self {
        let size = inside + 2 * station;
        Self {
            station,
            inside,
            slabs,
            matrices: vec![0.0; slabs * size * size],
            end: vec![0.0; station * station],
            scratch: vec![0.0; size],
            negative: 0,
        }
    }

    /// Order of a slab's matrix.
    pub fn size(&self) -> usize {
        self.inside + 2 * self.station
    }

    /// Begins a factorisation.
    pub fn begin(&mut self) {
        self.negative = 0;
        self.end.fill(0.0);
    }

    /// Matrix of a slab by rows, to be filled (upper triangle).
    pub fn slab_mut(&mut self, slab: usize) -> &mut [f64] {
        let size = self.size();
        &mut self.matrices[slab * size * size..(slab + 1) * size * size]
    }

    /// Adds what came from the slab before and eliminates; slabs go in order.
    pub fn eliminate(&mut self, slab: usize) -> Solved {
        let n = self.inside;
        let m = self.station;
        let size = self.size();
        let a = &mut self.matrices[slab * size * size..(slab + 1) * size * size];
        for i in 0..m {
            for j in i..m {
                a[(n + i) * size + n + j] += self.end[i * m + j];
            }
        }
        self.negative += dense::eliminate(a, size, n + m).map_err(|_| Stopped::Singular)?;
        for i in 0..m {
            for j in i..m {
                self.end[i * m + j] = a[(n + m + i) * size + n + m + j];
            }
        }
        Ok(())
    }

    fn exchange(
        &mut self,
        slab: usize,
        rhs: &mut [f64],
        whole: fn(&[f64], usize, usize, &mut [f64]),
    ) {
        let n = self.inside;
        let m = self.station;
        let size = self.size();
        let a = &self.matrices[slab * size * size..(slab + 1) * size * size];
        let part = &mut rhs[slab * (n + m)..][..size];
        let y = &mut self.scratch;
        y[..n].copy_from_slice(&part[m..m + n]);
        y[n..n + m].copy_from_slice(&part[..m]);
        y[n + m..].copy_from_slice(&part[m + n..]);
        whole(a, size, n + m, y);
        part[m..m + n].copy_from_slice(&y[..n]);
        part[..m].copy_from_slice(&y[n..n + m]);
        part[m + n..].copy_from_slice(&y[n + m..]);
    }

    /// Forward substitution; the last station then holds the condensed right-hand side.
    pub fn forward(&mut self, rhs: &mut [f64]) {
        for slab in 0..self.slabs {
            self.exchange(slab, rhs, dense::forward);
        }
    }

    /// Backward substitution from given values at the last station.
    pub fn backward(&mut self, rhs: &mut [f64]) {
        for slab in (0..self.slabs).rev() {
            self.exchange(slab, rhs, dense::backward);
        }
    }
}
