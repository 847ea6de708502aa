//! Residual and tangent of a body, element by element.

use super::{
    discretisation::{Discretisation, Material},
    mesh::Brick,
};
use crate::{
    element::{
        brick::{Input, Output, ShapePoint, integrate_bricks},
        hexahedron::integration_points,
        lanes::{Real, on_lanes},
        law::with_law,
        spatial::{AT, SpatialLaw},
    },
    load::cavity_faces::{self, FacePoint, skew, volume},
    solver::{
        body::{State, Totals},
        newton::{Result, Stopped},
    },
};
use mckibben_core::cancel;
use std::{array::from_fn, ops::Range, sync::LazyLock};

/// Bricks between two checks of the cancel flag: some tenths of a second at the most. A multiple of
/// all widths of lanes.
const PIECE: usize = 1024;

static POINTS8: LazyLock<Vec<ShapePoint>> = LazyLock::new(|| integration_points(1));
static POINTS27: LazyLock<Vec<ShapePoint>> = LazyLock::new(|| integration_points(2));
static FACE4: LazyLock<Vec<FacePoint<4>>> = LazyLock::new(cavity_faces::face_points);
static FACE9: LazyLock<Vec<FacePoint<9>>> = LazyLock::new(cavity_faces::face_points);

/// What an assembly fills.
#[derive(Debug, Clone)]
pub struct Assembled {
    /// Lower half of the tangent, the terminal's column, its diagonal entry, and a number that is
    /// not read.
    pub values: Vec<f64>,
    /// ∂Π/∂u of every displacement, with what is condensed.
    pub force: Vec<f64>,
    /// ∂V/∂u of every displacement.
    pub cavity: Vec<f64>,
    /// G_k, brick by brick.
    pub gradient: Vec<f64>,
    /// c_k, brick by brick.
    pub defect: Vec<f64>,
    /// Direction and strain of the strands, and whether they carry.
    pub strands: Vec<([f64; 3], f64, bool)>,
}

impl Assembled {
    /// Empty.
    pub fn new(d: &Discretisation) -> Self {
        let displacements = 3 * d.problem.nodes.len();
        Self {
            values: vec![0.0; d.pattern().entries() + d.free + 2],
            force: vec![0.0; displacements],
            cavity: vec![0.0; displacements],
            gradient: vec![0.0; d.bricks() * d.modes * d.per_brick * 3],
            defect: vec![0.0; d.bricks() * d.modes],
            strands: vec![([0.0; 3], 0.0, false); d.problem.trusses.len()],
        }
    }
}

/// Adds up the elements; the tangent only where `TANGENT`.
pub fn assemble<const TANGENT: bool>(
    d: &Discretisation,
    s: &State,
    work: &mut Assembled,
) -> Result<Totals> {
    work.force.fill(0.0);
    work.cavity.fill(0.0);
    if TANGENT {
        work.values.fill(0.0);
    }
    let mut totals = Totals {
        smallest_j: f64::INFINITY,
        ..Totals::default()
    };
    for m in &d.materials {
        let end = m.bricks.end;
        for first in m.bricks.clone().step_by(PIECE) {
            cancel::check()?;
            let bricks = first..(first + PIECE).min(end);
            with_law(&m.law, |law| {
                let piece = Piece {
                    d,
                    s,
                    m,
                    law: law.space,
                    bricks,
                };
                assemble_piece::<TANGENT>(piece, work, &mut totals)
            })?;
        }
    }
    assemble_trusses::<TANGENT>(d, s, work, &mut totals);
    match d.problem.brick {
        Brick::Linear => assemble_faces::<4, TANGENT>(&FACE4, d, s, work, &mut totals),
        Brick::Quadratic => assemble_faces::<9, TANGENT>(&FACE9, d, s, work, &mut totals),
    }
    for (f, v) in work.force.iter_mut().zip(&work.cavity) {
        *f -= s.pressure * v;
    }
    for (f, dead) in work.force.chunks_exact_mut(3).zip(&d.problem.dead) {
        (0..3).for_each(|i| f[i] -= s.pressure * dead[i]);
    }
    // The terminal's share of the cavity.
    let cap = d.problem.cap_mm2;
    totals.volume += cap * (d.half + s.terminal) / 3.0;
    let reaction: f64 = d.terminal.iter().map(|&i| work.force[i as usize]).sum();
    totals.pull = 4.0 * (reaction - s.pressure * cap / 3.0);
    if !totals.pull.is_finite() {
        return Err(Stopped::NotFinite);
    }
    Ok(totals)
}

/// Some bricks of one material.
struct Piece<'a> {
    d: &'a Discretisation,
    s: &'a State,
    m: &'a Material,
    law: SpatialLaw<'a>,
    bricks: Range<usize>,
}

/// Adds up bricks of one material until one is turned inside out.
fn assemble_piece<const TANGENT: bool>(
    piece: Piece<'_>,
    work: &mut Assembled,
    totals: &mut Totals,
) -> Result<()> {
    let width = piece.d.width;
    match piece.d.problem.brick {
        Brick::Linear => on_width::<8, 1, TANGENT>(width, &POINTS8, piece, work, totals),
        Brick::Quadratic => on_width::<27, 4, TANGENT>(width, &POINTS27, piece, work, totals),
    }
}

on_lanes! {
    fn on_width[NN: usize, NM: usize, TANGENT: bool](
        points: &[ShapePoint],
        piece: Piece<'_>,
        work: &mut Assembled,
        totals: &mut Totals,
    ) -> Result<()> = assemble_bricks
}

#[inline(always)]
fn assemble_bricks<R: Real, const NN: usize, const NM: usize, const TANGENT: bool>(
    points: &[ShapePoint],
    piece: Piece<'_>,
    work: &mut Assembled,
    totals: &mut Totals,
) -> Result<()> {
    let o = R::splat(0.0);
    let mut input = Input {
        rest: [[o; 3]; NN],
        now: [[o; 3]; NN],
        p: [o; NM],
        volume: o,
        centre: [o; 3],
        factors: [[o; 4]; 4],
        compliance: piece.m.compliance,
        augment: piece.m.augment,
    };
    let mut out = Output::<R, NN, NM>::zero();
    let Range { start, end } = piece.bricks;
    for first in (start..end).step_by(R::LANES) {
        for lane in 0..R::LANES {
            // The last ones are looked at more than once and written once.
            input.read_brick(piece.d, piece.s, (first + lane).min(end - 1), lane);
        }
        integrate_bricks::<R, NN, NM, TANGENT>(points, &input, piece.law, &mut out);
        for lane in 0..R::LANES.min(end - first) {
            out.add_brick::<TANGENT>(piece.d, (first + lane, lane), work, totals)?;
        }
    }
    Ok(())
}

impl<R: Real, const NN: usize, const NM: usize> Input<R, NN, NM> {
    /// Takes a brick into a lane.
    #[inline(always)]
    fn read_brick(&mut self, d: &Discretisation, s: &State, brick: usize, lane: usize) {
        let problem = &d.problem;
        let modes = &d.rest[brick];
        for a in 0..NN {
            let node = problem.bricks[brick][a];
            let rest = problem.rest(brick, node);
            let node = node as usize;
            let x = &problem.nodes[node];
            let u = &s.u[3 * node..3 * node + 3];
            for i in 0..3 {
                self.rest[a][i].set_lane(lane, rest[i]);
                self.now[a][i].set_lane(lane, x[i] + u[i]);
            }
        }
        self.volume.set_lane(lane, modes.volume);
        for i in 0..3 {
            self.centre[i].set_lane(lane, modes.centre[i]);
        }
        for k in 0..NM {
            self.p[k].set_lane(lane, s.p[brick * NM + k]);
            for i in 0..4 {
                self.factors[k][i].set_lane(lane, modes.factors[k][i]);
            }
        }
    }
}

impl<R: Real, const NN: usize, const NM: usize> Output<R, NN, NM> {
    /// Adds what a brick in a lane gives; refused where it is turned inside out.
    #[inline(always)]
    fn add_brick<const TANGENT: bool>(
        &self,
        d: &Discretisation,
        (brick, lane): (usize, usize),
        work: &mut Assembled,
        totals: &mut Totals,
    ) -> Result<()> {
        let j = self.smallest_j.lane(lane);
        totals.smallest_j = totals.smallest_j.min(j);
        if j.is_nan() || j <= 0.0 {
            return Err(Stopped::Inverted);
        }
        totals.rubber += self.energy.lane(lane);
        for a in 0..NN {
            let node = 3 * d.problem.bricks[brick][a] as usize;
            for i in 0..3 {
                work.force[node + i] += self.force[a][i].lane(lane);
            }
        }
        for k in 0..NM {
            let defect = self.defect[k].lane(lane);
            work.defect[brick * NM + k] = defect;
            totals.defect = totals.defect.max(defect.abs() / d.rest[brick].volume);
        }
        if TANGENT {
            let gradient = work.gradient[brick * NM * NN * 3..].iter_mut();
            for (to, from) in gradient.zip(self.gradient.as_flattened().as_flattened()) {
                *to = from.lane(lane);
            }
            let per_map = d.per_map();
            let map = &d.brick_map[brick * per_map..(brick + 1) * per_map];
            for (place, value) in map.iter().zip(self.tangent.as_flattened()) {
                work.values[*place as usize] += value.lane(lane);
            }
            let first = d.twice.partition_point(|t| (t.0 as usize) < brick);
            for (_, entry) in d.twice[first..]
                .iter()
                .take_while(|t| t.0 as usize == brick)
            {
                let entry = *entry as usize;
                work.values[map[entry] as usize] += self.tangent.as_flattened()[entry].lane(lane);
            }
        }
        Ok(())
    }
}

fn assemble_trusses<const TANGENT: bool>(
    d: &Discretisation,
    s: &State,
    work: &mut Assembled,
    totals: &mut Totals,
) {
    for (t, ([a, b], truss)) in d.problem.trusses.iter().enumerate() {
        let a = *a as usize;
        let b = *b as usize;
        let pull = d.pull(s, t, s.q[t]);
        totals.braid += 0.5 * pull.tension * pull.tension * d.strand[t].0 * truss.length_mm;
        work.strands[t] = (pull.direction, pull.strain, pull.carries);
        for i in 0..3 {
            let f = pull.tension * pull.direction[i];
            work.force[3 * a + i] -= f;
            work.force[3 * b + i] += f;
        }
        if TANGENT {
            let map = &d.truss_map[t];
            for k in 0..6 {
                work.values[map[k] as usize] += pull.tangent[k];
                work.values[map[6 + k] as usize] += pull.tangent[k];
            }
            for i in 0..3 {
                for j in 0..3 {
                    work.values[map[12 + 3 * i + j] as usize] -= pull.tangent[AT[i][j]];
                }
            }
        }
    }
}

fn assemble_faces<const N: usize, const TANGENT: bool>(
    points: &[FacePoint<N>],
    d: &Discretisation,
    s: &State,
    work: &mut Assembled,
    totals: &mut Totals,
) {
    let mut map = d.face_map.iter();
    for nodes in &d.problem.faces {
        let x: [[f64; 3]; N] = from_fn(|a| {
            let n = nodes[a] as usize;
            from_fn(|i| d.problem.nodes[n][i] + s.u[3 * n + i])
        });
        let v = volume::<N, TANGENT>(points, &x);
        totals.volume += v.value;
        for a in 0..N {
            for i in 0..3 {
                work.cavity[3 * nodes[a] as usize + i] += v.first[a][i];
            }
        }
        if TANGENT {
            for (a, b) in (0..N).flat_map(|a| (a + 1..N).map(move |b| (a, b))) {
                for (value, place) in skew(&v.second[a][b]).as_flattened().iter().zip(&mut map) {
                    work.values[*place as usize] -= s.pressure * value;
                }
            }
        }
    }
}
