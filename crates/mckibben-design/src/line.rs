//! One measure varied alone: where on a line of muscles do all limits hold?
//!
//! Each limit by itself varies slowly along the line, so that a few samples find all of its roots;
//! their intersection may be much narrower than the step from sample to sample. Between
//! neighbouring roots nothing changes: one muscle in the middle tells.

use crate::limits::check::{Check, NO_SCORE, Probe, Score};
use mckibben_core::{
    analysis::{Abscissa, find_root, golden},
    by_number::SortByNumber,
};
use std::cmp::Ordering;

/// Ratio of neighbouring samples.
const RATIO: f64 = 1.18;
/// A root is known to this share of its place.
const TOLERANCE: f64 = 1e-7;
/// A limit that all samples miss by more than this is not looked for between them.
const NEARLY: f64 = 0.3;
/// Steps towards a local minimum, or the best score.
pub const STEPS: usize = 12;
/// Steps towards the least violation, which as a rule lies where one limit begins to be missed:
/// there the others are known as well as that place.
const STEPS_TO_LEAST: usize = 30;
/// Halvings towards the edge of where there is an answer at all.
const HALVINGS: usize = 14;

/// A muscle of the line.
#[derive(Debug, Clone)]
pub struct Sample {
    pub x: f64,
    /// By which share each limit is missed; empty where the muscle or the model gives no answer.
    pub excess: Vec<f64>,
    pub score: Score,
}

impl Sample {
    /// Of a muscle that was held against a specification; `None`: without an answer.
    pub fn new(x: f64, probe: Option<Probe>) -> Self {
        let held = |probe: Probe| {
            (
                probe.checks.iter().map(Check::excess).collect(),
                probe.score,
            )
        };
        let (excess, score) = probe.map_or((vec![], NO_SCORE), held);
        Self { x, excess, score }
    }

    fn answered(&self) -> bool {
        !self.excess.is_empty()
    }

    /// The sum of the shares by which limits are missed: it is least where as few as possible are.
    pub fn violation(&self) -> f64 {
        if self.answered() {
            self.excess.iter().map(|e| e.max(0.0)).sum()
        } else {
            f64::INFINITY
        }
    }

    pub fn fits(&self) -> bool {
        self.violation() <= 0.0
    }
}

/// How good a muscle is: the shares by which it misses its limits, then its score. The smaller the
/// better.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
pub struct Merit(f64, Score);

impl Merit {
    pub const NONE: Merit = Merit(f64::INFINITY, NO_SCORE);

    /// Of a muscle that misses by `violation`, or fits.
    pub fn new(violation: f64, score: Score) -> Self {
        if violation > 0.0 {
            Self(violation, NO_SCORE)
        } else {
            Self(0.0, score)
        }
    }

    pub fn fits(self) -> bool {
        self.0 <= 0.0
    }
}

/// What a line gave.
#[derive(Debug, Default)]
pub struct Found {
    /// The intervals on which every limit holds, as far as they were looked for.
    pub fitting: Vec<(f64, f64)>,
    /// The best muscle among them, or the one that misses by least.
    pub best: Option<Sample>,
}

/// Looks along `low..=high` in samples. With `first` it ends with the first interval that fits.
pub fn along(low: f64, high: f64, first: bool, mut at: impl FnMut(f64) -> Sample) -> Found {
    let mut found = Found::default();
    let mut samples: Vec<Sample> = vec![];
    for x in places(low, high) {
        samples.push(at(x));
        if let [.., before, last] = &samples[..] {
            let next = samples.len() >= 3;
            let local_minimum = next
                .then(|| local_minimum(&samples[samples.len() - 3..], &mut at))
                .flatten();
            // A local minimum that was found between the last three goes where it belongs.
            let segments = match local_minimum {
                None => vec![(before.clone(), last.clone())],
                Some(local_minimum) if local_minimum.x > before.x => {
                    vec![
                        (before.clone(), local_minimum.clone()),
                        (local_minimum, last.clone()),
                    ]
                }
                Some(local_minimum) => {
                    let oldest = samples[samples.len() - 3].clone();
                    vec![
                        (oldest, local_minimum.clone()),
                        (local_minimum, before.clone()),
                        (before.clone(), last.clone()),
                    ]
                }
            };
            for (a, b) in &segments {
                segment(a, b, &mut at, &mut found.fitting);
            }
        } else if low == high && samples[0].fits() {
            found.fitting.push((low, low));
        }
        if first && !found.fitting.is_empty() {
            break;
        }
    }
    found.fitting.sort_by_number(|a| a.0);
    found.best = if found.fitting.is_empty() {
        least_violation(&samples, &mut at)
    } else {
        None
    };
    found
}

/// Places in equal ratios, both ends among them.
fn places(low: f64, high: f64) -> Vec<f64> {
    if high <= low {
        return vec![low];
    }
    let n = ((high / low).ln() / RATIO.ln()).ceil().clamp(1.0, 60.0);
    (0..=n as usize)
        .map(|i| {
            if i as f64 == n {
                high
            } else {
                low * (high / low).powf(i as f64 / n)
            }
        })
        .collect()
}

/// Between the last three samples, the place where a limit that all of them miss is missed by
/// least, if it is met there.
fn local_minimum(three: &[Sample], at: &mut impl FnMut(f64) -> Sample) -> Option<Sample> {
    let [a, b, c] = three else { return None };
    if ![a, b, c].iter().all(|s| s.answered()) {
        return None;
    }
    let limits = b.excess.len().min(a.excess.len()).min(c.excess.len());
    (0..limits).find_map(|j| {
        let l = a.excess[j];
        let m = b.excess[j];
        let r = c.excess[j];
        let dips = m > 0.0 && m < NEARLY && l > m && r >= m;
        let value = |s: &Sample| Merit(s.excess.get(j).copied().unwrap_or(f64::INFINITY), [0.0; 2]);
        let least = dips.then(|| golden(a.x, b.clone(), c.x, STEPS, value, at))?;
        least
            .excess
            .get(j)
            .is_some_and(|e| *e <= 0.0)
            .then_some(least)
    })
}

/// Adds the parts of a segment that fit.
fn segment(
    a: &Sample,
    b: &Sample,
    at: &mut impl FnMut(f64) -> Sample,
    fitting: &mut Vec<(f64, f64)>,
) {
    let (a, b) = match (a.answered(), b.answered()) {
        (true, true) => (a.clone(), b.clone()),
        (false, true) => (edge(a.x, b, at), b.clone()),
        (true, false) => (a.clone(), edge(b.x, a, at)),
        (false, false) => return,
    };
    let pairs = || a.excess.iter().zip(&b.excess);
    if a.excess.len() != b.excess.len() || pairs().any(|(l, r)| *l > 0.0 && *r > 0.0) {
        return;
    }
    let mut ends = vec![a.x, b.x];
    for (j, (l, r)) in pairs().enumerate() {
        if (*l > 0.0) != (*r > 0.0) {
            let excess = |x: f64| at(x).excess.get(j).copied().ok_or(());
            ends.extend(find_root(excess, a.x, b.x, TOLERANCE * b.x).ok().flatten());
        }
    }
    ends.sort_by(f64::total_cmp);
    for pair in ends.windows(2) {
        let middle = 0.5 * (pair[0] + pair[1]);
        let fits = if ends.len() == 2 {
            a.fits() && b.fits()
        } else {
            at(middle).fits()
        };
        if !fits {
            continue;
        }
        match fitting.last_mut() {
            Some(last) if last.1 == pair[0] => last.1 = pair[1],
            _ => fitting.push((pair[0], pair[1])),
        }
    }
}

/// The last muscle with an answer between one without and one with.
fn edge(without: f64, with: &Sample, at: &mut impl FnMut(f64) -> Sample) -> Sample {
    let mut without = without;
    let mut with = with.clone();
    for _ in 0..HALVINGS {
        let middle = at(0.5 * (without + with.x));
        if middle.answered() {
            with = middle
        } else {
            without = middle.x
        }
    }
    with
}

/// The muscle that misses its limits by least, between the neighbours of the best sample.
fn least_violation(samples: &[Sample], at: &mut impl FnMut(f64) -> Sample) -> Option<Sample> {
    let i = least(samples, Sample::violation)?;
    if !samples[i].answered() || samples[i].violation() > 1.0 {
        return Some(samples[i].clone());
    }
    Some(refine(
        samples,
        i,
        STEPS_TO_LEAST,
        |s| Merit(s.violation(), [0.0; 2]),
        at,
    ))
}

/// The best muscle of an interval that fits, by its score, after so many golden sections.
pub fn best_of(
    low: f64,
    high: f64,
    steps: usize,
    at: &mut impl FnMut(f64) -> Sample,
) -> Option<Sample> {
    let merit = |s: &Sample| Merit::new(s.violation(), s.score);
    let inside = |share: f64| low + share * (high - low);
    // The ends themselves may miss by rounding.
    let samples: Vec<Sample> = [1e-6, 0.25, 0.5, 0.75, 1.0 - 1e-6]
        .map(|share| at(inside(share)))
        .into();
    let best = refine(&samples, least(&samples, merit)?, steps, merit, at);
    best.fits().then_some(best)
}

/// The place in a list of the sample with the least merit, the first of those that are equal.
pub fn least<S, M: PartialOrd>(samples: &[S], merit: impl Fn(&S) -> M) -> Option<usize> {
    let order = |a: &usize, b: &usize| merit(&samples[*a]).partial_cmp(&merit(&samples[*b]));
    (0..samples.len()).min_by(|a, b| order(a, b).unwrap_or(Ordering::Equal))
}

/// Golden section about one of the samples, between its neighbours.
pub fn refine<S: Abscissa + Clone, M: PartialOrd>(
    samples: &[S],
    i: usize,
    steps: usize,
    merit: impl Fn(&S) -> M,
    at: &mut impl FnMut(f64) -> S,
) -> S {
    let left = &samples[i.saturating_sub(1)];
    let right = &samples[(i + 1).min(samples.len() - 1)];
    golden(
        left.place(),
        samples[i].clone(),
        right.place(),
        steps,
        merit,
        at,
    )
}

impl Abscissa for Sample {
    fn place(&self) -> f64 {
        self.x
    }
}
