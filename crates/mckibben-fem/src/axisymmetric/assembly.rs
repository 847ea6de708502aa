//! Forces, volume defects and tangent of the whole body.

use super::discretisation::{BraidSpec, Discretisation};
use crate::{
    element::{
        law,
        plane::AnyPlaneLaw,
        q2::{MODES, NODES, PADDED},
        solid::{self, Contribution, Material, NodalRow},
        strand::STRAND_POINTS,
    },
    load::cavity::volume,
    solver::{
        body::{State, Totals},
        chain::Chain,
        newton::{Result, Stopped},
    },
};

/// Below this strain a strand that carries no compression is slack. At rest a strand counts as
/// taut.
const SLACK: f64 = -1e-9;

/// Memory for assembling and solving; made once.
#[derive(Debug, Clone)]
pub struct Assembled {
    /// The tangent and its factorisation.
    pub chain: Chain,
    /// ∂Π/∂x
    pub residual: Vec<f64>,
    /// ∂V/∂x of the cavity
    pub volume: Vec<f64>,
    /// B of every element: ∂g/∂u_r, ∂g/∂u_z as of the last tangent.
    pub coupling: Vec<[[NodalRow; MODES]; 2]>,
    /// ∂λf/∂u of every strand point (zero where slack) as of the last tangent.
    pub strand: Vec<[f64; 6]>,
    element: Contribution,
}

impl Assembled {
    /// Memory for a body.
    pub fn new(d: &Discretisation) -> Self {
        let l = d.layout;
        Self {
            chain: Chain::new(l.along, l.station(), l.inside()),
            residual: vec![0.0; l.unknowns()],
            volume: vec![0.0; l.unknowns()],
            coupling: vec![[[[0.0; PADDED]; MODES]; 2]; d.elements.len()],
            strand: vec![[0.0; 6]; STRAND_POINTS * d.strands.len()],
            element: Contribution::default(),
        }
    }
}

/// Assembles residual and, where `TANGENT`, the factorised chain.
///
/// # Errors
/// [`Stopped`] where an element is turned inside out, a stress is not finite or the tangent is
/// singular.
pub fn assemble<const TANGENT: bool>(
    d: &Discretisation,
    s: &State,
    w: &mut Assembled,
) -> Result<Totals> {
    let totals = Totals {
        smallest_j: f64::INFINITY,
        ..Totals::default()
    };
    let mut work = Assembly { d, s, w, totals };
    law::with_law(&d.problem.law, |law| work.sum::<TANGENT>(law.plane))?;
    Ok(work.totals)
}

/// An assembly: what is read, and what is filled.
struct Assembly<'a> {
    d: &'a Discretisation,
    s: &'a State,
    w: &'a mut Assembled,
    totals: Totals,
}

impl Assembly<'_> {
    fn sum<const TANGENT: bool>(&mut self, law: &dyn AnyPlaneLaw) -> Result<()> {
        let d = self.d;
        self.w.residual.fill(0.0);
        self.w.volume.fill(0.0);
        if TANGENT {
            self.w.chain.begin();
        }
        let share = 1.0 / d.force_scale(self.s.pressure);
        for slab in 0..d.layout.along {
            if TANGENT {
                self.w.chain.slab_mut(slab).fill(0.0);
            }
            for i in 0..d.layout.through {
                self.solid::<TANGENT>(law, slab, i)?;
            }
            self.strands::<TANGENT>(slab);
            self.cavity::<TANGENT>(slab);
            if TANGENT {
                if slab == 0 {
                    symmetry(d, self.w);
                }
                self.w.chain.eliminate(slab)?;
            }
            self.measure(slab, share)?;
        }
        let end = d.layout.end();
        self.totals.pull = (0..d.layout.nodes())
            .map(|i| self.w.residual[end + 2 * i + 1])
            .sum();
        if self.totals.pull.is_finite() {
            Ok(())
        } else {
            Err(Stopped::NotFinite)
        }
    }

    /// Largest residual of what is complete after slab `slab`, forces as a `share` of one N.
    fn measure(&mut self, slab: usize, share: f64) -> Result<()> {
        let (d, l, r) = (self.d, self.d.layout, &self.w.residual);
        let m = l.station();
        let start = slab * l.stride();
        // A sum so that numbers which are none show.
        let mut largest = 0.0_f64;
        let mut sum = 0.0;
        for i in 0..2 * m {
            let fixed = slab == 0 && i < m && i % 2 == 1;
            if !fixed {
                largest = largest.max(r[start + i].abs());
                sum += r[start + i];
            }
        }
        let mut defect = 0.0_f64;
        for i in 0..l.through {
            let volume = d.elements[slab * l.through + i].volume;
            for k in 0..MODES {
                let g = r[l.pressure(slab, i) + k];
                defect = defect.max(g.abs() / volume);
                sum += g;
            }
        }
        if l.multipliers {
            for g in 0..STRAND_POINTS {
                let c = r[l.tension(slab) + g];
                defect = defect.max(c.abs() / d.strands[slab][g].area);
                sum += c;
            }
        }
        self.totals.defect = self.totals.defect.max(largest * share).max(defect);
        if sum.is_finite() {
            Ok(())
        } else {
            Err(Stopped::NotFinite)
        }
    }

    #[inline(always)]
    fn solid<const TANGENT: bool>(
        &mut self,
        law: &dyn AnyPlaneLaw,
        slab: usize,
        i: usize,
    ) -> Result<()> {
        let Self {
            d,
            s,
            ref mut w,
            ref mut totals,
        } = *self;
        let at = Places::new(d, slab, 2 * i);
        let pressure = d.layout.pressure(slab, i);
        let index = slab * d.layout.through + i;
        let geometry = &d.elements[index];
        let u = d.layout.element(&s.u, slab, i);
        let c = &mut w.element;
        let material = Material {
            law,
            compliance: d.compliance,
            memory: d.memory.as_ref().map(|m| (m.softening, &m.seen_mpa[index])),
        };
        if !solid::contribute::<TANGENT>(geometry, &u, &material, c) {
            return Err(Stopped::Inverted);
        }
        totals.smallest_j = totals.smallest_j.min(c.smallest_j);
        totals.rubber += c.energy;
        for a in 0..NODES {
            let k = at.vector[a / 3] + 2 * (a % 3);
            w.residual[k] += c.fr[a];
            w.residual[k + 1] += c.fz[a];
        }
        w.residual[pressure..pressure + MODES].copy_from_slice(&c.g);
        if TANGENT {
            let share = d.augment / geometry.volume;
            for k in 0..MODES {
                for a in 0..NODES {
                    let r = share * c.br[k][a];
                    let z = share * c.bz[k][a];
                    for b in 0..PADDED {
                        c.rr[a][b] += r * c.br[k][b];
                        c.rz[a][b] += r * c.bz[k][b];
                        c.zz[a][b] += z * c.bz[k][b];
                    }
                }
            }
            w.coupling[index] = [c.br, c.bz];
            scatter(d, w, &at, i, geometry.volume, slab);
        }
        Ok(())
    }

    #[inline(always)]
    fn strands<const TANGENT: bool>(&mut self, slab: usize) {
        let Self {
            d,
            s,
            ref mut w,
            ref mut totals,
        } = *self;
        let Some(braid) = d.problem.braid else { return };
        let l = d.layout;
        let outer = 2 * l.through;
        let at = Places::new(d, slab, outer);
        let u = l.line(&s.u, slab, outer);
        let size = w.chain.size();
        for (g, point) in d.strands[slab].iter().enumerate() {
            let stretch = point.stretch(&u);
            let strain = stretch.value - 1.0;
            let both = 2.0 * point.area;
            let unknown = l.tension(slab) + g;
            let multiplier = if l.multipliers { s.u[unknown] } else { 0.0 };
            let (q, k) = tension(&braid, strain, multiplier, d.augment_strand);
            for i in 0..6 {
                w.residual[at.vector[i / 2] + i % 2] += both * q * stretch.first[i];
            }
            let taut = k > 0.0;
            if l.multipliers {
                // Taut: ∂Π/∂q = 2w c. Slack: q must vanish.
                w.residual[unknown] = if taut {
                    both * strain
                } else {
                    -both / d.augment_strand * multiplier
                };
            } else {
                totals.braid += match (&braid.crimp, braid.stiffness) {
                    (Some(crimp), Some(k)) if k > 0.0 && q != 0.0 => {
                        both * k * crimp.energy_and_slopes(strain)[0]
                    }
                    _ => 0.5 * both * q * strain,
                };
            }
            if TANGENT {
                let index = slab * STRAND_POINTS + g;
                w.strand[index] = if taut { stretch.first } else { [0.0; 6] };
                let matrix = w.chain.slab_mut(slab);
                if taut {
                    let carried = match braid.stiffness {
                        Some(_) if braid.compression || s.q[index] > 0.0 => s.q[index],
                        _ => q,
                    };
                    add_line(matrix, size, &at.matrix, |i, j| {
                        both * (k * stretch.first[i] * stretch.first[j]
                            + carried * point.curvature(&stretch, i, j))
                    });
                }
                if l.multipliers {
                    let row = l.station() + MODES * l.through + g;
                    if taut {
                        for i in 0..6 {
                            let column = at.matrix[i / 2] + i % 2;
                            let low = row.min(column);
                            matrix[low * size + row.max(column)] += both * stretch.first[i];
                        }
                    } else {
                        matrix[row * size + row] = -both / d.augment_strand;
                    }
                }
            }
        }
    }

    #[inline(always)]
    fn cavity<const TANGENT: bool>(&mut self, slab: usize) {
        let Self {
            d,
            s,
            ref mut w,
            ref mut totals,
        } = *self;
        let at = Places::new(d, slab, 0);
        let mut x = d.layout.line(&s.u, slab, 0);
        for (x, rest) in x.iter_mut().zip(d.mesh.line(slab, 0).as_flattened()) {
            *x += rest;
        }
        let v = volume::<TANGENT>(&x);
        totals.volume += v.value;
        for i in 0..6 {
            let k = at.vector[i / 2] + i % 2;
            w.volume[k] += v.first[i];
            w.residual[k] -= s.pressure * v.first[i];
        }
        if TANGENT {
            let size = w.chain.size();
            add_line(w.chain.slab_mut(slab), size, &at.matrix, |i, j| {
                -s.pressure * v.second[i][j]
            });
        }
    }
}

/// At Z = 0: u_z = 0.
fn symmetry(d: &Discretisation, w: &mut Assembled) {
    let size = w.chain.size();
    let inside = d.layout.inside();
    let a = w.chain.slab_mut(0);
    for i in 0..d.layout.nodes() {
        let k = inside + 2 * i + 1;
        for row in 0..k {
            a[row * size + k] = 0.0;
        }
        a[k * size + k..(k + 1) * size].fill(0.0);
        a[k * size + k] = 1.0;
    }
}

/// Places of the element's nodes in a slab: station offsets in the vector and in the matrix.
struct Places {
    vector: [usize; 3],
    matrix: [usize; 3],
}

impl Places {
    fn new(d: &Discretisation, slab: usize, node: usize) -> Self {
        let l = d.layout;
        let m = l.station();
        let n = l.inside();
        let first = 2 * node;
        Self {
            vector: l.stations(slab).map(|start| start + first),
            matrix: [first, n + first, n + m + first],
        }
    }
}

/// Adds the element's tangent to the slab's matrix (upper triangle).
#[inline(always)]
fn scatter(d: &Discretisation, w: &mut Assembled, at: &Places, i: usize, volume: f64, slab: usize) {
    let l = d.layout;
    let size = w.chain.size();
    let first = l.station() + MODES * i;
    let beta = 1.0 - d.augment * d.compliance;
    let chain = &mut w.chain;
    let c = &w.element;
    let matrix = chain.slab_mut(slab);
    let place: [usize; NODES] = std::array::from_fn(|a| at.matrix[a / 3] + 2 * (a % 3));
    for a in 0..NODES {
        let (row_r, row_z) = matrix[place[a] * size..(place[a] + 2) * size].split_at_mut(size);
        for (b, &k) in place.iter().enumerate().skip(a) {
            row_r[k] += c.rr[a][b];
            row_r[k + 1] += c.rz[a][b];
            row_z[k] += c.rz[b][a];
            row_z[k + 1] += c.zz[a][b];
        }
    }
    for k in 0..MODES {
        let row = first + k;
        for a in 0..3 {
            matrix[place[a] * size + row] = beta * c.br[k][a];
            matrix[(place[a] + 1) * size + row] = beta * c.bz[k][a];
        }
        for a in 3..NODES {
            matrix[row * size + place[a]] = beta * c.br[k][a];
            matrix[row * size + place[a] + 1] = beta * c.bz[k][a];
        }
        matrix[row * size + row] = -beta * volume * d.compliance;
    }
}

/// Adds a 6 × 6 block of a line element (middle, left, right), of which the upper triangle is
/// given.
#[inline(always)]
fn add_line(matrix: &mut [f64], size: usize, at: &[usize; 3], value: impl Fn(usize, usize) -> f64) {
    for i in 0..6 {
        let row = (at[i / 2] + i % 2) * size;
        for j in i..6 {
            matrix[row + at[j / 2] + j % 2] += value(i, j);
        }
    }
}

/// Tension per width q at a strand point and the stiffness behind it; zero where the strand is
/// slack.
#[inline]
pub fn tension(braid: &BraidSpec, strain: f64, multiplier: f64, augment: f64) -> (f64, f64) {
    match braid.stiffness {
        Some(k) if braid.compression || strain > SLACK => match &braid.crimp {
            None => (k * strain, k),
            Some(crimp) => {
                let [_, force, slope] = crimp.energy_and_slopes(strain);
                (k * force, k * slope)
            }
        },
        None if braid.compression || multiplier + augment * strain >= 0.0 => (multiplier, augment),
        _ => (0.0, 0.0),
    }
}
