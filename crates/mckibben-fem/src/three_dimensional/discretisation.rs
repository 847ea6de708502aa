//! A body divided into bricks and strands: numbers of the unknowns, places in the tangent,
//! everything that does not change while it deforms.

use super::problem::{Freedom, Problem};
use crate::{
    FemError, Result,
    element::{
        brick::{Modes, modes},
        hexahedron::integration_points,
        lanes::Width,
        spatial::PAIRS,
        truss::{Pull, Truss},
    },
    solver::{
        body::State,
        sparse::{Analysis, Pattern},
    },
};
use mckibben_core::{
    cancel::{self, Cancelled},
    extremes::peak,
    muscle::Bulk,
    rubber::{Law, RubberLaw},
};
use std::{array::from_fn, ops::Range, sync::Arc};

/// Elements or unknowns between two checks of the cancel flag.
const PIECE: usize = 4096;
/// γ over the shear modulus: the share of the bulk modulus that is condensed; what is above it is
/// iterated.
const AUGMENT: f64 = 2000.0;
/// γ of the strands over μ times the wall, likewise: of E A / L0 of one strand.
const AUGMENT_STRAND: f64 = 2e5;

/// A body divided into elements.
#[derive(Debug, Clone)]
pub struct Discretisation {
    /// What it is made of.
    pub problem: Problem,
    /// Nodes a brick.
    pub per_brick: usize,
    /// Pressure modes a brick.
    pub modes: usize,
    /// Pressure modes at rest.
    pub rest: Vec<Modes>,
    /// Number of the unknown of each displacement: below `free` an unknown, `free` the terminal,
    /// `free` + 1 held.
    pub unknown: Vec<[u32; 3]>,
    /// Number of unknowns.
    pub free: usize,
    /// Displacement (3·node + direction) of each unknown.
    pub place: Vec<u32>,
    /// Displacements that move with the terminal.
    pub terminal: Vec<u32>,
    /// Places of the entries of the tangent and of its factors.
    pub analysis: Arc<Analysis>,
    /// Where the blocks of bricks go, brick by brick.
    pub brick_map: Vec<u32>,
    /// (brick, entry) that counts twice: both displacements are one.
    pub twice: Vec<(u32, u32)>,
    /// Where the blocks of strands go: 0-0, 1-1 (six numbers each) and 0-1 (nine).
    pub truss_map: Vec<[u32; 21]>,
    /// Where the blocks of faces go: nine numbers for every pair a < b.
    pub face_map: Vec<u32>,
    /// Materials, the rubber first.
    pub materials: Vec<Material>,
    /// Rounding of nodal forces in N: of bricks much stiffer than the rubber.
    pub rounding_n: f64,
    /// 1/(E A) in 1/N, and γ of the strands in N.
    pub strand: Vec<(f64, f64)>,
    /// Shear modulus in MPa.
    pub shear: f64,
    /// Length of the body along z in mm.
    pub half: f64,
    /// Greatest distance from the axis in mm.
    pub radius: f64,
    /// Elements that are looked at together.
    pub width: Width,
}

/// One material of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// Its bricks.
    pub bricks: Range<usize>,
    /// Its law.
    pub law: Law,
    /// 1/K in 1/MPa.
    pub compliance: f64,
    /// γ in MPa.
    pub augment: f64,
}

impl Material {
    fn new(bricks: Range<usize>, law: &Law, bulk: Bulk) -> Self {
        let most = AUGMENT * law.shear_modulus_mpa();
        let (compliance, augment) = match bulk {
            Bulk::Incompressible => (0.0, most),
            Bulk::Modulus(k) => (1.0 / k, k.min(most)),
        };
        Self {
            bricks,
            law: law.clone(),
            compliance,
            augment,
        }
    }

    fn all_of(problem: &Problem) -> Vec<Self> {
        let end = problem.bricks.len();
        let first = problem.other.as_ref().map_or(end, |other| other.first);
        let rubber = Self::new(0..first, &problem.law, problem.bulk);
        let other = problem
            .other
            .as_ref()
            .map(|other| Self::new(first..end, &other.law, other.bulk));
        [rubber].into_iter().chain(other).collect()
    }
}

/// β = 1 − γ/k; 0 where γ = k but for rounding.
pub fn share(compliance: f64, augment: f64) -> f64 {
    let share = 1.0 - augment * compliance;
    if share > 1e-12 { share } else { 0.0 }
}

impl Discretisation {
    /// Numbers the unknowns and finds every entry's place.
    ///
    /// # Errors
    /// [`FemError::Refused`] where an element is turned inside out at rest, [`FemError::Refused`]
    /// without enough memory, [`FemError::Cancelled`] where the work is cancelled.
    pub fn new(problem: Problem) -> Result<Self> {
        let rest = rest_modes(&problem)?;
        let (unknown, place, terminal) = number_unknowns(&problem);
        let free = place.len();
        let pattern = pattern(&problem, &unknown, &place)?;
        cancel::check()?;
        let shear = problem.law.shear_modulus_mpa();
        let materials = Material::all_of(&problem);
        let greatest = peak(problem.nodes.iter().map(|x| x[2]));
        let half = problem.length_mm.unwrap_or(greatest);
        let rounding_n = rounding(&materials[1..], &rest, greatest);
        let radius = peak(problem.nodes.iter().map(|x| x[0].hypot(x[1])));
        let most = AUGMENT_STRAND * shear;
        let strand = problem
            .trusses
            .iter()
            .map(|(_, t)| (1.0 / t.stiffness_n, t.stiffness_n.min(most * t.length_mm)))
            .collect();
        let mut out = Self {
            per_brick: problem.brick.nodes(),
            modes: problem.brick.modes(),
            rest,
            unknown,
            free,
            place,
            terminal,
            analysis: Arc::new(Analysis::new(pattern).ok_or_else(|| FemError::too_large(free))?),
            brick_map: vec![],
            twice: vec![],
            truss_map: vec![],
            face_map: vec![],
            materials,
            rounding_n,
            strand,
            shear,
            half,
            radius,
            width: Width::here(),
            problem,
        };
        cancel::check()?;
        out.map_entries()?;
        Ok(out)
    }

    /// What a piece of a strand does in a state, with the tension in N that its tangent has: T =
    /// q + γ (strain − q/(E A)); of strands stiffer than γ the rest is iterated.
    pub fn pull(&self, s: &State, t: usize, tension: f64) -> Pull {
        let (ends, truss) = &self.problem.trusses[t];
        let end = |n: usize, i: usize| self.problem.nodes[n][i] + s.u[3 * n + i];
        let delta = [0, 1, 2].map(|i| end(ends[1] as usize, i) - end(ends[0] as usize, i));
        let (compliance, augment) = self.strand[t];
        let truss = Truss {
            stiffness_n: augment,
            ..*truss
        };
        truss.pull(delta, share(compliance, augment) * s.q[t], tension)
    }

    /// The material of a brick.
    pub fn material(&self, brick: usize) -> &Material {
        &self.materials[usize::from(brick >= self.materials[0].bricks.end)]
    }

    /// Places of the tangent's entries.
    pub fn pattern(&self) -> &Pattern {
        &self.analysis.pattern
    }

    /// Number of bricks.
    pub fn bricks(&self) -> usize {
        self.problem.bricks.len()
    }

    /// Entries a brick has in `brick_map`.
    pub fn per_map(&self) -> usize {
        self.per_brick * (self.per_brick + 1) / 2 * 9
    }

    /// Where ∂²Π of two displacements goes: into the lower half, into the terminal's column behind
    /// it, or into the last number, which is not read.
    fn entry(&self, a: u32, b: u32) -> u32 {
        let n = self.free as u32;
        let entries = self.pattern().entries() as u32;
        let high = a.max(b);
        let low = a.min(b);
        let column = (high == n).then_some(entries + low);
        let place = if high < n {
            self.pattern().position(high, low)
        } else {
            column
        };
        place.unwrap_or(entries + n + 1)
    }

    /// The places of nine numbers: rows of a node, columns of another.
    fn block(&self, a: u32, b: u32) -> [u32; 9] {
        let [x, y] = [a, b].map(|node| self.unknown[node as usize]);
        from_fn(|k| self.entry(x[k / 3], y[k % 3]))
    }

    fn map_entries(&mut self) -> Result<(), Cancelled> {
        let unread = (self.pattern().entries() + self.free + 1) as u32;
        let mut map = Vec::with_capacity(self.bricks() * self.per_map());
        let mut twice = Vec::new();
        for (e, nodes) in self.problem.bricks.iter().enumerate() {
            check_cancel(e)?;
            let start = map.len();
            for (a, b) in pairs(self.per_brick, 0) {
                let [x, y] = [a, b].map(|a| self.unknown[nodes[a] as usize]);
                for (k, entry) in self.block(nodes[a], nodes[b]).into_iter().enumerate() {
                    let i = k / 3;
                    let j = k % 3;
                    // Nodes that are one (wedges) and displacements that are one (the terminal's).
                    if a != b && x[i] == y[j] && x[i] as usize <= self.free {
                        twice.push((e as u32, (map.len() - start) as u32));
                    }
                    // Of blocks on the diagonal only one half.
                    map.push(if a == b && i > j { unread } else { entry });
                }
            }
        }
        let truss = |&([a, b], _): &([u32; 2], Truss)| {
            let [at_a, at_b] = [a, b]
                .map(|n| self.block(n, n))
                .map(|all| PAIRS.map(|(i, j)| all[3 * i + j]));
            let mut entries = at_a.into_iter().chain(at_b).chain(self.block(a, b));
            from_fn(|_| entries.next().unwrap_or(unread))
        };
        let face = |nodes: &Vec<u32>| {
            pairs(nodes.len(), 1)
                .flat_map(|(a, b)| self.block(nodes[a], nodes[b]))
                .collect::<Vec<u32>>()
        };
        let truss_map = self.problem.trusses.iter().map(truss).collect();
        let face_map = self.problem.faces.iter().flat_map(face).collect();
        self.brick_map = map;
        self.twice = twice;
        self.truss_map = truss_map;
        self.face_map = face_map;
        Ok(())
    }
}

/// Pairs (a, b) of so many nodes with b ≥ a + `apart`.
fn pairs(count: usize, apart: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..count).flat_map(move |a| (a + apart..count).map(move |b| (a, b)))
}

/// Checks the cancel flag once in [`PIECE`] numbers.
fn check_cancel(number: usize) -> Result<(), Cancelled> {
    if number.is_multiple_of(PIECE) {
        cancel::check()
    } else {
        Ok(())
    }
}

/// Forces that come of rounding places (some ulp of the greatest one): stiffness times area over
/// height of a brick.
fn rounding(stiff: &[Material], rest: &[Modes], greatest: f64) -> f64 {
    peak(stiff.iter().map(|m: &Material| {
        let modulus = m.augment + 4.0 / 3.0 * m.law.shear_modulus_mpa();
        let size = peak(rest[m.bricks.clone()].iter().map(|r| r.volume.cbrt()));
        16.0 * f64::EPSILON * greatest * modulus * size
    }))
}

fn rest_modes(problem: &Problem) -> Result<Vec<Modes>> {
    let points = integration_points(problem.brick.order());
    let element = |(e, nodes): (usize, &Vec<u32>)| {
        check_cancel(e)?;
        let places: Vec<[f64; 3]> = nodes.iter().map(|node| problem.rest(e, *node)).collect();
        modes(&points, &places, problem.brick.modes()).ok_or_else(|| {
            FemError::Refused(format!("mesh: element {e} is turned inside out at rest"))
        })
    };
    problem.bricks.iter().enumerate().map(element).collect()
}

/// Numbers of the displacements, displacement of each unknown, displacements of the terminal.
fn number_unknowns(problem: &Problem) -> (Vec<[u32; 3]>, Vec<u32>, Vec<u32>) {
    let freedom = problem.freedom.as_flattened();
    let mut place: Vec<u32> = problem
        .order
        .iter()
        .flat_map(|n| 3 * n..3 * n + 3)
        .collect();
    place.retain(|k| freedom[*k as usize] == Freedom::Free);
    let n = place.len() as u32;
    let mut numbers = vec![[n + 1; 3]; problem.nodes.len()];
    let mut terminal = vec![];
    let flat = numbers.as_flattened_mut();
    for (number, k) in (0..).zip(&place) {
        flat[*k as usize] = number;
    }
    for (k, _) in freedom
        .iter()
        .enumerate()
        .filter(|(_, f)| **f == Freedom::Terminal)
    {
        flat[k] = n;
        terminal.push(k as u32);
    }
    (numbers, place, terminal)
}

/// The lower half: unknowns of a node meet those of every node with which it shares a brick or a
/// strand.
fn pattern(problem: &Problem, unknown: &[[u32; 3]], place: &[u32]) -> Result<Pattern, Cancelled> {
    let free = place.len();
    let mut near: Vec<Vec<u32>> = vec![vec![]; problem.nodes.len()];
    for (e, nodes) in problem.bricks.iter().enumerate() {
        check_cancel(e)?;
        for &a in nodes {
            near[a as usize].extend(nodes);
        }
    }
    for &([a, b], _) in &problem.trusses {
        near[a as usize].push(b);
        near[b as usize].push(a);
    }
    for (node, around) in near.iter_mut().enumerate() {
        check_cancel(node)?;
        around.sort_unstable();
        around.dedup();
    }
    let mut columns = vec![0];
    let mut rows = vec![];
    for (c, &place) in place.iter().enumerate() {
        check_cancel(c)?;
        let all = near[place as usize / 3]
            .iter()
            .flat_map(|other| unknown[*other as usize]);
        rows.extend(all.filter(|r| (c..free).contains(&(*r as usize))));
        let start = columns[c] as usize;
        rows[start..].sort_unstable();
        columns.push(rows.len() as u32);
    }
    Ok(Pattern { columns, rows })
}
