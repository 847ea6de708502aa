//! The form fitted to a force model.
//!
//! Linear least squares at the points of the box at which the muscle pulls, and at no other: behind
//! its free contraction a model carries nearly nothing, with a kink that a smooth form must not
//! follow. There only the sign counts: rows that hold the form below zero are added where it would
//! pull, and at the end of the box where its slope would let a pull return. The errors are those at
//! other points, with slack as 0 N.

use crate::{
    ExportError, Form, Point, Result,
    form::{FUNCTIONS, functions},
};
use mckibben_core::{
    analysis::{Evaluation, Options, bisect},
    cancel,
    extremes::{even, peak},
    model::{ForceModel, Response, Workspace},
    muscle::{Direction, Friction},
    threads,
};
use nalgebra::{DMatrix, DVector};
use serde::Serialize;
use std::iter::repeat_n;

/// The requested box over which a muscle is exported; where it is `None` it is chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoxRequest {
    /// Supply pressure, MPa.
    pub supply_mpa: f64,
    /// Lower end in ε, zero or negative: below 0 strands lock, and the form is less accurate.
    pub contraction_low: f64,
    /// Upper end in ε; `None`: the free contraction at the supply, or the end of the range of a
    /// model that pulls up to there.
    pub contraction_high: Option<f64>,
}

/// Errors of the form against its model at points that it was not fitted to.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FormErrors {
    /// Error of the pull at the points: rms, share of the blocked force at the supply.
    pub force_rms: f64,
    /// Error of the pull at 95 % of the points: they err by less, share of the blocked force.
    pub force_95_ratio: f64,
    /// Largest error of the pull: share of the blocked force, 1.5 times the largest at the points,
    /// and 0.0002.
    pub force_worst_ratio: f64,
    /// Error of ∂F/∂L at the points: rms, share of the form's own at the supply and at rest; where
    /// the muscle pulls by more than 2 % of its blocked force.
    pub stiffness_rms: f64,
    /// Largest error of ∂F/∂L: the same share, 1.5 times the largest at the points.
    pub stiffness_worst_ratio: f64,
    /// Error of ∂F/∂P at the points: rms, likewise.
    pub force_per_pressure_rms: f64,
    /// Largest error of ∂F/∂P: likewise.
    pub force_per_pressure_worst_ratio: f64,
    /// Error of the volume at the points: rms, share of the largest volume.
    pub volume_rms: f64,
    /// Largest error of the volume: share of the largest volume, twice the largest at the points,
    /// and 0.0002.
    pub volume_worst_ratio: f64,
}

/// A sampled point of the model: q, ε, pull over the blocked force, volume in m³; ∂F/∂L in N/m and
/// ∂F/∂P in m², where the muscle pulls by more than [`TAUT`]. A pull that is negative, or that the
/// model cannot find behind the free contraction, is slack.
#[derive(Debug, Clone, Copy, Default)]
struct Sample {
    q: f64,
    contraction: f64,
    pull: Option<f64>,
    volume_m3: Option<f64>,
    slopes: Option<[f64; 2]>,
}

impl Sample {
    /// The pull where there is one.
    fn taut(&self) -> Option<f64> {
        self.pull.filter(|pull| *pull > 0.0)
    }
}

/// The form, its errors and the blocked force.
pub struct Fitted {
    pub form: Form,
    pub errors: FormErrors,
    pub blocked_n: f64,
}

/// Share of the blocked force from which on slopes are compared: they jump where it becomes slack.
pub const TAUT: f64 = 0.02;

/// Halvings towards the end of a pull.
const EDGE: usize = 8;
/// What is stated as the largest error of pull and volume: the largest at the points that the form
/// was not fitted to, so many times, and a share. Of 200 random muscles at 2500 other points each
/// none missed by more; the largest was 1.24 and 1.87 times that at the points.
const BETWEEN: [f64; 2] = [1.5, 2.0];
const BESIDE: f64 = 2e-4;
/// Pressures at which the form is fitted, shares of the supply: more of them where the pull bends.
const PRESSURES: [f64; 15] = [
    0.0, 0.02, 0.05, 0.075, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0,
];
/// Contractions at which it is fitted, shares of the upper end.
const SHARES: [f64; 15] = [
    0.0, 0.03125, 0.0625, 0.09375, 0.125, 0.1875, 0.25, 0.3125, 0.40625, 0.5, 0.59375, 0.6875,
    0.8125, 0.9375, 1.0,
];

/// The nodes of the form in ε.
fn nodes(low: f64, high: f64) -> Vec<f64> {
    let stretched = if low < 0.0 {
        vec![low, 0.7 * low, 0.4 * low, 0.15 * low]
    } else {
        vec![]
    };
    let shortened = [0.0, 1.0 / 24.0, 0.125, 0.285, 0.55, 1.0].map(|share| share * high);
    stretched.into_iter().chain(shortened).collect()
}

/// The contraction up to which a muscle pulls at the supply, within the range of its model: the
/// range of a formula may end before it stops to pull.
pub fn free_contraction(model: &dyn ForceModel, w: &mut Workspace, supply: f64) -> Result<f64> {
    let end = model.info().range.contraction.1;
    match Evaluation::new(model, w, Options::extrapolating()).free_contraction(supply) {
        Err(_) if end < 0.5 => Ok(end),
        free => Ok(free?.min(end)),
    }
}

pub fn fit(model: &dyn ForceModel, wanted: BoxRequest) -> Result<Fitted> {
    let supply = wanted.supply_mpa;
    let low = wanted.contraction_low;
    let w = &mut Workspace::new();
    model.muscle().check_contracts()?;
    let high = match wanted.contraction_high {
        Some(high) => high,
        None => free_contraction(model, w, supply)?,
    };
    let mut evaluation = Evaluation::new(model, w, Options::extrapolating());
    let blocked_n = evaluation.force_n(supply, 0.0)?;
    if !(blocked_n > 0.0 && high > low.max(0.0)) {
        return Err(ExportError::NoPull(supply));
    }
    let stretched = |n| even((low, 0.0), n).filter(move |_| low < 0.0);
    let contractions = Vec::from_iter(stretched(10).chain(SHARES.map(|share| share * high)));
    let at = sample(model, [&PRESSURES, &contractions], supply, blocked_n)?;
    // Others for the errors: between those of the fit, where strands lock and where they become
    // slack too.
    let held = Vec::from_iter(stretched(20).chain(even((0.0, high), 48)));
    let middles = PRESSURES.windows(2).map(|w| 0.5 * (w[0] + w[1]));
    let between = Vec::from_iter([0.0].into_iter().chain(middles).chain([1.0]));
    let held_out = sample(model, [&between, &held], supply, blocked_n)?;
    let ends = edges(model, &held_out, supply, blocked_n);
    // A muscle without pressure at its length at rest pulls nothing, unless its tube is stretched:
    // exactly.
    let at_rest = evaluation
        .force_n(0.0, 0.0)
        .is_ok_and(|f| f.abs() < 1e-6 * blocked_n);
    let mut form = Form {
        length_m: model.muscle().length_mm() / 1e3,
        supply_pa: 1e6 * supply,
        contraction_low: low,
        contraction_high: high,
        contractions: nodes(low, high),
        a: Default::default(),
        b: Default::default(),
        v: [0.0; FUNCTIONS],
        friction_n: friction(model, w, supply, high),
        presliding_m: 1e-3
            * model
                .muscle()
                .friction()
                .map_or(Friction::PRESLIDING_MM, Friction::presliding_length_mm),
    };
    pulls(&mut form, &at, at_rest)?;
    form.a
        .iter_mut()
        .chain(&mut form.b)
        .flatten()
        .for_each(|value| *value *= blocked_n);
    volumes(&mut form, &at, &model.info().name)?;
    Ok(Fitted {
        errors: errors(&form, &held_out, &ends, blocked_n),
        form,
        blocked_n,
    })
}

/// Samples a model along falling pulls: behind the second point at which the muscle would push it
/// is slack.
fn sample(
    model: &dyn ForceModel,
    [pressures, contractions]: [&[f64]; 2],
    supply_mpa: f64,
    blocked_n: f64,
) -> Result<Vec<Sample>> {
    let rows = threads::map(pressures, |&q| {
        let w = &mut Workspace::new();
        let mut row = vec![];
        let mut slack = false;
        for &contraction in contractions {
            let mut point = Sample {
                q,
                contraction,
                ..Sample::default()
            };
            if !slack {
                cancel::check()?;
                match model.response(w, q * supply_mpa, contraction) {
                    Ok(response) => {
                        slack = response.force_n < -1e-3 * blocked_n;
                        point.pull = Some(response.force_n / blocked_n);
                        point.volume_m3 = response.volume_mm3.map(|v| 1e-9 * v);
                        if response.force_n > TAUT * blocked_n {
                            point.slopes = Some(slopes(model, w, &response)?);
                        }
                    }
                    // What has no equilibrium without pressure, and is not stretched, has
                    // collapsed.
                    Err(_) if contraction > 0.0 && q < 0.2 => slack = true,
                    Err(error) => return Err(ExportError::from(error)),
                }
            }
            row.push(point);
        }
        Ok(row)
    });
    Ok(rows.into_iter().collect::<Result<Vec<_>, _>>()?.concat())
}

/// ∂F/∂L in N/m and ∂F/∂P in m² of a model.
fn slopes(model: &dyn ForceModel, w: &mut Workspace, response: &Response) -> Result<[f64; 2]> {
    let mut evaluation = Evaluation::new(model, w, Options::extrapolating());
    Ok([
        1e3 * evaluation.stiffness_n_per_mm(response)?,
        1e-6 * evaluation.force_per_pressure_mm2(response)?,
    ])
}

/// The last points of each pressure at which the muscle pulls: there the form misses its volume by
/// most.
fn edges(model: &dyn ForceModel, at: &[Sample], supply_mpa: f64, blocked_n: f64) -> Vec<Sample> {
    let pairs: Vec<&[Sample]> = at
        .windows(2)
        .filter(|w| w[0].q == w[1].q && w[0].taut().is_some() && w[1].taut().is_none())
        .collect();
    threads::map(&pairs, |pair| {
        let w = &mut Workspace::new();
        let mut edge = pair[0];
        bisect(
            pair[0].contraction,
            pair[1].contraction,
            EDGE,
            |contraction| {
                let response = model.response(w, edge.q * supply_mpa, contraction).ok();
                let Some(response) = response.filter(|response| response.force_n > 0.0) else {
                    return false;
                };
                edge.contraction = contraction;
                edge.pull = Some(response.force_n / blocked_n);
                edge.volume_m3 = response.volume_mm3.map(|v| 1e-9 * v);
                true
            },
        );
        edge
    })
}

/// A cubic spline between the nodes, as a sum: powers of ε, and cubes that begin at each inner node
/// and are zero between it and the length at rest. All but the first are zero at the length at
/// rest.
struct Spline {
    low: f64,
    high: f64,
    inner: Vec<f64>,
}

impl Spline {
    fn len(&self) -> usize {
        4 + self.inner.len()
    }

    /// The value of each summand at ε, and its slope.
    fn weights_at(&self, e: f64) -> Vec<(f64, f64)> {
        let x = e / self.high;
        let mut out: Vec<(f64, f64)> = (0..4)
            .map(|j| (x.powi(j), f64::from(j) * x.powi((j - 1).max(0)) / self.high))
            .collect();
        out.extend(self.inner.iter().map(|&node| {
            let span = if node >= 0.0 {
                self.high - node
            } else {
                self.low - node
            };
            let t = ((e - node) / span).max(0.0);
            (t * t * t, 3.0 * t * t / span)
        }));
        out
    }
}

/// The row of a point: the factor of each coefficient in the pull, and in its slope in ε.
fn row(spline: &Spline, q: f64, e: f64) -> (Vec<f64>, Vec<f64>) {
    let at = spline.weights_at(e);
    functions(q)
        .0
        .iter()
        .flat_map(|phi| {
            at.iter()
                .map(move |(value, slope)| (phi * value, phi * slope))
        })
        .unzip()
}

/// How often rows are added where the form pulls and the muscle does not.
const ROUNDS: usize = 40;
/// Share of the blocked force by which the form has to lie below zero where the muscle is slack.
const BELOW: f64 = 5e-4;
/// Weight of coefficients that the points do not determine: of those of inner nodes, and of the
/// later functions of the pressure.
const RIDGE: f64 = 3e-5;

fn pulls(form: &mut Form, at: &[Sample], at_rest: bool) -> Result<()> {
    let high = form.contraction_high;
    let spline = Spline {
        low: form.contraction_low,
        high,
        inner: form.contractions[1..form.contractions.len() - 1].to_vec(),
    };
    let mut rows = vec![];
    for p in at {
        if let Some(pull) = p.pull.filter(|pull| *pull >= 0.0) {
            rows.push((row(&spline, p.q, p.contraction).0, pull, 1.0));
        }
    }
    let points = rows.len();
    // c0 is 0 where the muscle at rest pulls nothing.
    let first = usize::from(at_rest);
    let count = FUNCTIONS * spline.len();
    if points < count - first {
        return Err(ExportError::Points(points));
    }
    for index in 0..count {
        if index % spline.len() >= 4 || index / spline.len() > 2 {
            rows.push(ridge(index, count));
        }
    }
    let free = free_by_pressure(at, high);
    for _ in 0..ROUNDS {
        let all = least_squares(&rows, first).ok_or(ExportError::Points(points))?;
        for (i, coefficients) in all.chunks(spline.len()).enumerate() {
            let at_nodes = |e: &f64| {
                spline
                    .weights_at(*e)
                    .into_iter()
                    .zip(coefficients)
                    .fold((0.0, 0.0), |(value, slope), ((v, s), c)| {
                        (value + c * v, slope + c * s)
                    })
            };
            (form.a[i], form.b[i]) = form.contractions.iter().map(at_nodes).unzip();
        }
        let before = rows.len();
        rows.extend(slack_rows(form, &spline, &free, at_rest));
        // Pulls that come back behind a dip are lowered; the dip of a tube that pulls by itself is
        // lifted.
        let again = form.pulls_again();
        for &(q, e, pull) in again.iter().step_by(1 + again.len() / 100) {
            match pull_between(at, q, e).filter(|model| !at_rest && *model > 2.0 * BELOW) {
                Some(model) if pull < BELOW => rows.push((row(&spline, q, e).0, model, 0.3)),
                // Along the tangent below the box as well: a muscle that is vented fast has less
                // than the atmosphere.
                None if pull > 0.0 => {
                    rows.extend([q, -0.1].map(|q| (row(&spline, q, e).0, -BELOW, 0.1)))
                }
                _ => {}
            }
        }
        if rows.len() == before {
            break;
        }
    }
    Ok(())
}

/// A fine grid of the slack part: rows where the form pulls or does not fall with the contraction;
/// `free` is the contraction at which the muscle pulls nothing, by pressure.
fn slack_rows(form: &Form, spline: &Spline, free: &[f64], at_rest: bool) -> Vec<Row> {
    let high = form.contraction_high;
    let mut rows = vec![];
    for (k, &from) in free.iter().enumerate() {
        let q = k as f64 / 40.0;
        for m in 0..=24 {
            let e = from + (high - from) * f64::from(m) / 24.0;
            let most = if m == 0 {
                -0.001
            } else {
                -0.01 - 0.3 * (e - from)
            };
            // What takes up slack first pulls nothing even at its length at rest.
            let is_beyond = e > from + 0.01 || m == 0 && from == 0.0 && !at_rest;
            if is_beyond && form.two_sided_n(q * form.supply_pa, e).0 > -BELOW {
                rows.push((row(spline, q, e).0, most, 0.3));
            }
        }
        for q in [q, q * q] {
            if form.two_sided_n(q * form.supply_pa, high).1 > -0.05 {
                rows.push((row(spline, q, high).1, -0.2, 0.03));
            }
        }
    }
    rows
}

/// A row of the least squares: the factor of each coefficient, the value and the weight.
type Row = (Vec<f64>, f64, f64);

/// The row that holds one of `count` coefficients near 0 where the points do not determine it.
fn ridge(index: usize, count: usize) -> Row {
    let mut one = vec![0.0; count];
    one[index] = 1.0;
    (one, 0.0, RIDGE)
}

/// The coefficients with the least squares by Householder's QR, 0 before the one at `first`; `None`
/// where they are not finite.
fn least_squares(rows: &[Row], first: usize) -> Option<Vec<f64>> {
    let count = rows[0].0.len() - first;
    let matrix = DMatrix::from_fn(rows.len(), count, |r, c| rows[r].2 * rows[r].0[first + c]);
    let values = DVector::from_iterator(rows.len(), rows.iter().map(|r| r.2 * r.1));
    let qr = matrix.qr();
    let solved = qr
        .r()
        .solve_upper_triangular(&(qr.q().transpose() * values))
        .filter(|s| s.iter().all(|v| v.is_finite()))?;
    Some(repeat_n(0.0, first).chain(solved.iter().copied()).collect())
}

/// The pull of the model between four samples; `None` where one of them is slack.
fn pull_between(at: &[Sample], q: f64, e: f64) -> Option<f64> {
    let columns = at.partition_point(|p| p.q <= at[0].q);
    let lines = at.chunks(columns);
    let first = &at[..columns];
    let k = lines.clone().position(|line| line[0].q >= q)?.max(1);
    let m = first
        .partition_point(|p| p.contraction < e)
        .clamp(1, columns - 1);
    let in_line = |line: &[Sample]| {
        let a = &line[m - 1];
        let b = &line[m];
        let t = (e - a.contraction) / (b.contraction - a.contraction);
        Some((1.0 - t) * a.pull? + t * b.pull?)
    };
    let mut lines = lines.skip(k - 1);
    let a = lines.next()?;
    let b = lines.next()?;
    let t = (q - a[0].q) / (b[0].q - a[0].q);
    Some((1.0 - t) * in_line(a)? + t * in_line(b)?)
}

/// The contraction at which the model stops pulling, at 41 pressures: between its samples in
/// proportion.
fn free_by_pressure(at: &[Sample], high: f64) -> Vec<f64> {
    let end = |line: &[Sample]| {
        let crossing = |w: &[Sample]| {
            let pull = w[0].taut()?;
            let share = w[1].pull.map_or(1.0, |next| pull / (pull - next));
            Some(w[0].contraction + share * (w[1].contraction - w[0].contraction))
        };
        let free = match line.last().and_then(Sample::taut) {
            Some(_) => high,
            None => line.windows(2).rev().find_map(crossing).unwrap_or_default(),
        };
        (line[0].q, free.max(0.0))
    };
    let ends = Vec::from_iter(at.chunk_by(|a, b| a.q == b.q).map(end));
    let at = |q: f64| {
        let k = ends.partition_point(|e| e.0 < q).clamp(1, ends.len() - 1);
        let ((a, x), (b, y)) = (ends[k - 1], ends[k]);
        // The curve is steep at low pressure and bends down: the upper one is never exceeded.
        if b > a {
            (x + (y - x) * ((q - a) / (b - a)).clamp(0.0, 1.0).sqrt()).max(x)
        } else {
            y
        }
    };
    (0..=40).map(|k| at(f64::from(k) / 40.0)).collect()
}

/// v0 to v4 from the volumes less those of the potential.
fn volumes(form: &mut Form, at: &[Sample], model: &str) -> Result<()> {
    let known = Vec::from_iter(
        at.iter()
            .filter(|p| p.pull.is_some_and(|pull| pull >= 0.0))
            .filter_map(|p| {
                Some((
                    p.q,
                    p.volume_m3? - form.point_at(p.q * form.supply_pa, p.contraction).volume_m3,
                ))
            }),
    );
    if known.is_empty() {
        return Err(ExportError::NoVolume(model.to_owned()));
    }
    let scale = peak(known.iter().map(|k| k.1.abs()));
    // Of a muscle that pulls from a higher pressure on, the points do not determine all of them.
    let rows = Vec::from_iter(
        known
            .iter()
            .map(|k| (functions(k.0).0.to_vec(), k.1 / scale, 1.0))
            .chain((2..FUNCTIONS).map(|i| ridge(i, FUNCTIONS))),
    );
    let solved = least_squares(&rows, 0).ok_or(ExportError::Points(known.len()))?;
    form.v = std::array::from_fn(|i| solved[i] * scale);
    Ok(())
}

fn rms(errors: &[f64]) -> f64 {
    (errors.iter().map(|e| e * e).sum::<f64>() / errors.len().max(1) as f64).sqrt()
}

fn slopes_of(point: &Point) -> [f64; 2] {
    [point.stiffness_n_per_m, point.force_per_pressure_m2]
}

fn errors(form: &Form, held_out: &[Sample], ends: &[Sample], blocked_n: f64) -> FormErrors {
    let largest = peak(held_out.iter().filter_map(|p| p.volume_m3));
    let here = |p: &Sample| form.point_at(p.q * form.supply_pa, p.contraction);
    let force = |p: &Sample| (here(p).force_n / blocked_n - p.taut().unwrap_or_default()).abs();
    let volume = |p: &Sample| {
        p.taut()?;
        Some((here(p).volume_m3 - p.volume_m3?).abs() / largest)
    };
    let at_rest = slopes_of(&form.point_at(form.supply_pa, 0.0));
    let slope = |i: usize| {
        let error = |p: &Sample| {
            Some((slopes_of(&here(p))[i] / at_rest[i] - p.slopes?[i] / at_rest[i]).abs())
        };
        Vec::from_iter(held_out.iter().filter_map(error))
    };
    let mut forces = Vec::from_iter(held_out.iter().map(force));
    forces.sort_by(f64::total_cmp);
    let [stiffness, by_pressure] = [0, 1].map(slope);
    let all = || held_out.iter().chain(ends);
    FormErrors {
        force_rms: rms(&forces),
        force_95_ratio: forces[(0.95 * forces.len() as f64) as usize],
        force_worst_ratio: BETWEEN[0] * peak(all().map(force)) + BESIDE,
        stiffness_rms: rms(&stiffness),
        stiffness_worst_ratio: BETWEEN[0] * peak(stiffness),
        force_per_pressure_rms: rms(&by_pressure),
        force_per_pressure_worst_ratio: BETWEEN[0] * peak(by_pressure),
        volume_rms: rms(&Vec::from_iter(held_out.iter().filter_map(volume))),
        volume_worst_ratio: BETWEEN[1] * peak(all().filter_map(volume)) + BESIDE,
    }
}

/// Half the hysteresis, exact at a quarter of the supply and at the supply, at three contractions
/// at which the muscle pulls.
fn friction(model: &dyn ForceModel, w: &mut Workspace, supply: f64, high: f64) -> [f64; 6] {
    let mut half = |q: f64, e: f64| {
        let stated = model.friction_half_n(w, q * supply, e);
        let of_law = |w| Evaluation::new(model, w, Direction::Mean).half_width_n(q * supply, e);
        stated.unwrap_or_else(|| of_law(w)).ok()
    };
    // Powers of ε through 0, h and 2 h.
    let mut powers = |q: f64, h: f64| {
        let [a, b, c] = [half(q, 0.0)?, half(q, h)?, half(q, 2.0 * h)?];
        let bend = (c - 2.0 * b + a) / (2.0 * h * h);
        Some([a, (b - a) / h - bend * h, bend])
    };
    let (Some(quarter), Some(whole)) = (powers(0.25, 0.3 * high), powers(1.0, 0.45 * high)) else {
        return [0.0; 6];
    };
    std::array::from_fn(|i| {
        let [quarter, whole] = [quarter, whole].map(|powers| powers[i % 3]);
        if i < 3 {
            4.0 * quarter - whole
        } else {
            2.0 * whole - 4.0 * quarter
        }
    })
}
