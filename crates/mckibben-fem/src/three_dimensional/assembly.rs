//! Residual and tangent of a body, element by element.

use super::discretisation::{Discretisation, Material};
use super::mesh::Brick;
use crate::element::brick::{Input, Output, ShapePoint, run};
use crate::element::hexahedron::points;
use crate::element::lanes::Real;
use crate::element::lanes::on_lanes;
use crate::element::law::with;
use crate::element::spatial::{AT, SpatialLaw};
use crate::load::cavity_faces::{self, FacePoint, skew, volume};
use crate::solver::body::{State, Totals};
use crate::solver::newton::{Result, Stopped};
use mckibben::cancel;
use std::ops::Range;
use std::sync::LazyLock;

/// Bricks between two checks of the cancel flag: some tenths of a second at the most. A multiple of
/// all widths of lanes.
const PIECE: usize = 1024;

static POINTS8: LazyLock<Vec<ShapePoint>> = LazyLock::new(|| points(1));
static POINTS27: LazyLock<Vec<ShapePoint>> = LazyLock::new(|| points(2));
static FACE4: LazyLock<Vec<FacePoint<4>>> = LazyLock::new(cavity_faces::points);
static FACE9: LazyLock<Vec<FacePoint<9>>> = LazyLock::new(cavity_faces::points);

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
        let (start, end) = (m.bricks.start, m.bricks.end);
        for first in (start..end).step_by(PIECE) {
            cancel::check()?;
            let bricks = first..(first + PIECE).min(end);
            with(&m.law, |law| {
                let piece = Piece {
                    d,
                    s,
                    m,
                    law: law.space,
                    bricks,
                };
                add::<TANGENT>(piece, work, &mut totals)
            })?;
        }
    }
    trusses::<TANGENT>(d, s, work, &mut totals);
    match d.problem.brick {
        Brick::Linear => faces::<4, TANGENT>(&FACE4, d, s, work, &mut totals),
        Brick::Quadratic => faces::<9, TANGENT>(&FACE9, d, s, work, &mut totals),
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
fn add<const TANGENT: bool>(
    piece: Piece<'_>,
    work: &mut Assembled,
    totals: &mut Totals,
) -> Result<()> {
    match piece.d.problem.brick {
        Brick::Linear => wide::<8, 1, TANGENT>(piece.d.width, &POINTS8, piece, work, totals),
        Brick::Quadratic => wide::<27, 4, TANGENT>(piece.d.width, &POINTS27, piece, work, totals),
    }
}

on_lanes! {
    fn wide[NN: usize, NM: usize, TANGENT: bool](
        points: &[ShapePoint],
        piece: Piece<'_>,
        work: &mut Assembled,
        totals: &mut Totals,
    ) -> Result<()> = all
}

#[inline(always)]
fn all<R: Real, const NN: usize, const NM: usize, const TANGENT: bool>(
    points: &[ShapePoint],
    piece: Piece<'_>,
    work: &mut Assembled,
    totals: &mut Totals,
) -> Result<()> {
    let Piece {
        d,
        s,
        m,
        law,
        bricks: Range { start, end: count },
    } = piece;
    let o = R::splat(0.0);
    let mut input = Input {
        rest: [[o; 3]; NN],
        now: [[o; 3]; NN],
        p: [o; NM],
        volume: o,
        centre: [o; 3],
        factors: [[o; 4]; 4],
        compliance: m.compliance,
        augment: m.augment,
    };
    let mut out = Output::<R, NN, NM>::zero();
    let per_map = d.per_map();
    let mut twice = d.twice[d.twice.partition_point(|t| (t.0 as usize) < start)..]
        .iter()
        .peekable();
    for first in (start..count).step_by(R::LANES) {
        for lane in 0..R::LANES {
            // The last ones are looked at more than once and written once.
            let e = (first + lane).min(count - 1);
            for a in 0..NN {
                let node = d.problem.bricks[e][a] as usize;
                let (x, u) = (&d.problem.nodes[node], &s.u[3 * node..3 * node + 3]);
                let rest = d.problem.rest(e, node as u32);
                for i in 0..3 {
                    input.rest[a][i].set_lane(lane, rest[i]);
                    input.now[a][i].set_lane(lane, x[i] + u[i]);
                }
            }
            let m = &d.rest[e];
            input.volume.set_lane(lane, m.volume);
            for i in 0..3 {
                input.centre[i].set_lane(lane, m.centre[i]);
            }
            for k in 0..NM {
                input.p[k].set_lane(lane, s.p[e * NM + k]);
                for i in 0..4 {
                    input.factors[k][i].set_lane(lane, m.factors[k][i]);
                }
            }
        }
        run::<R, NN, NM, TANGENT>(points, &input, law, &mut out);
        for lane in 0..R::LANES.min(count - first) {
            let e = first + lane;
            let j = out.smallest_j.lane(lane);
            totals.smallest_j = totals.smallest_j.min(j);
            if j.is_nan() || j <= 0.0 {
                return Err(Stopped::Inverted);
            }
            totals.rubber += out.energy.lane(lane);
            for a in 0..NN {
                let node = 3 * d.problem.bricks[e][a] as usize;
                for i in 0..3 {
                    work.force[node + i] += out.force[a][i].lane(lane);
                }
            }
            for k in 0..NM {
                let defect = out.defect[k].lane(lane);
                work.defect[e * NM + k] = defect;
                totals.defect = totals.defect.max(defect.abs() / d.rest[e].volume);
            }
            if TANGENT {
                let gradient = &mut work.gradient[e * NM * NN * 3..(e + 1) * NM * NN * 3];
                for k in 0..NM {
                    for a in 0..NN {
                        for i in 0..3 {
                            gradient[(k * NN + a) * 3 + i] = out.gradient[k][a][i].lane(lane);
                        }
                    }
                }
                let map = &d.brick_map[e * per_map..(e + 1) * per_map];
                for (block, places) in out.tangent.iter().zip(map.chunks_exact(9)) {
                    for i in 0..9 {
                        work.values[places[i] as usize] += block[i].lane(lane);
                    }
                }
                while let Some((_, entry)) = twice.next_if(|t| t.0 as usize == e) {
                    let entry = *entry as usize;
                    work.values[map[entry] as usize] +=
                        out.tangent[entry / 9][entry % 9].lane(lane);
                }
            }
        }
    }
    Ok(())
}

fn trusses<const TANGENT: bool>(
    d: &Discretisation,
    s: &State,
    work: &mut Assembled,
    totals: &mut Totals,
) {
    for (t, ([a, b], truss)) in d.problem.trusses.iter().enumerate() {
        let (a, b) = (*a as usize, *b as usize);
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

fn faces<const N: usize, const TANGENT: bool>(
    points: &[FacePoint<N>],
    d: &Discretisation,
    s: &State,
    work: &mut Assembled,
    totals: &mut Totals,
) {
    let mut map = d.face_map.chunks_exact(9);
    for nodes in &d.problem.faces {
        let x: [[f64; 3]; N] = std::array::from_fn(|a| {
            let n = nodes[a] as usize;
            std::array::from_fn(|i| d.problem.nodes[n][i] + s.u[3 * n + i])
        });
        let v = volume::<N, TANGENT>(points, &x);
        totals.volume += v.value;
        for a in 0..N {
            for i in 0..3 {
                work.cavity[3 * nodes[a] as usize + i] += v.first[a][i];
            }
        }
        if TANGENT {
            for a in 0..N {
                for b in a + 1..N {
                    let block = skew(&v.second[a][b]);
                    if let Some(places) = map.next() {
                        for (k, place) in places.iter().enumerate() {
                            work.values[*place as usize] -= s.pressure * block[k / 3][k % 3];
                        }
                    }
                }
            }
        }
    }
}
