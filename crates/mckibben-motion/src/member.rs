//! A force model as the equations of motion need it: both pulls and volumes with their derivatives,
//! and the slack muscle.

use crate::Actuated;
use mckibben_core::{
    analysis::{Burst, Evaluation, Options, burst},
    by_number::ByNumber,
    model::{Ideal, ModelError, ThickWall, Workspace, pivoting_n_per_mm},
};
use std::cell::{Cell, OnceCell, RefCell};

/// A quantity of a muscle with its derivatives.
#[derive(Clone, Copy, Default)]
pub struct Quantity {
    pub value: f64,
    /// ∂/∂P in 1/MPa
    pub by_pressure: f64,
    /// ∂/∂ε
    pub by_contraction: f64,
}

impl Quantity {
    /// Its derivative in time.
    pub fn rate(self, pressure_rate: f64, contraction_rate: f64) -> f64 {
        self.by_pressure * pressure_rate + self.by_contraction * contraction_rate
    }
}

/// What a muscle answers at a gauge pressure and contraction.
#[derive(Clone, Copy)]
pub struct Answer {
    pub force_n: Quantity,
    pub volume_mm3: Quantity,
    /// G of the strands' contact in N/mm; 0 without friction of the contact.
    pub pivoting_n_per_mm: Quantity,
    /// Of a slack muscle that at which it hangs, which follows the pressure alone.
    pub contraction: Quantity,
}

impl Answer {
    pub fn quantities(self) -> [Quantity; 4] {
        [
            self.force_n,
            self.volume_mm3,
            self.pivoting_n_per_mm,
            self.contraction,
        ]
    }

    fn from_quantities(
        [force_n, volume_mm3, pivoting_n_per_mm, contraction]: [Quantity; 4],
    ) -> Self {
        Self {
            force_n,
            volume_mm3,
            pivoting_n_per_mm,
            contraction,
        }
    }

    /// The first order about the point of this answer.
    fn moved(self, p: f64, e: f64) -> Self {
        let moved = |q: Quantity| q.value + q.by_pressure * p + q.by_contraction * e;
        Self::from_quantities(self.quantities().map(|q| Quantity {
            value: moved(q),
            ..q
        }))
    }
}

/// The quantities of an answer, each with its derivative in time.
pub type Moment = [(Quantity, f64); 4];

/// What replaces the model between two answers.
#[derive(Clone, Copy)]
pub enum Substitute {
    /// At one moment within a step.
    Moment(Answer),
    /// About a pressure and contraction: first order.
    Near(f64, f64, Answer),
    /// The same about the nearest of the last points.
    Nearest,
}

impl Substitute {
    /// At the share `s` of a step of length `h` between two moments.
    pub fn between(a: &Moment, b: &Moment, s: f64, h: f64) -> Self {
        let r = 1.0 - s;
        let cubic = |x: f64, k: f64, y: f64, l: f64| {
            x * r * r * (1.0 + 2.0 * s)
                + y * s * s * (3.0 - 2.0 * s)
                + h * (k * s * r * r - l * s * s * r)
        };
        Self::Moment(Answer::from_quantities(std::array::from_fn(|i| {
            let ((x, k), (y, l)) = (a[i], b[i]);
            Quantity {
                value: cubic(x.value, k, y.value, l),
                by_pressure: r * x.by_pressure + s * y.by_pressure,
                by_contraction: r * x.by_contraction + s * y.by_contraction,
            }
        })))
    }
}

/// Steps of central differences where a model does not know the derivatives of its volume.
const STEP_MPA: f64 = 1e-4;
const STEP: f64 = 1e-4;

/// Below 1 Pa force and volume go on linearly in the pressure: at none the strands are slack, the
/// volume has a kink, and below it no model is made.
const LEAST_MPA: f64 = 1e-6;

/// Closer than this to where it goes slack, as a contraction, a muscle is evaluated by its model.
const SLACK: f64 = 1e-3;

/// The last points with their answers: a step evaluates its start, three stages and its end, some
/// of them again.
type Kept = [Option<Known>; 8];

/// A pressure, a contraction, and the answer there.
type Known = (f64, f64, Answer);

#[derive(Clone)]
pub struct Member {
    pub muscle: Actuated,
    pub length_mm: f64,
    /// So far from an answer that is kept, as a contraction (ten times as far as a share of the
    /// pressure), its first order is the model.
    near: f64,
    ideal: Ideal,
    pub memory: Memory,
    /// In place of the model, where there is one.
    pub substitute: Cell<Option<Substitute>>,
}

/// What a member has learnt: it begins the next piece of the same motion with it.
#[derive(Default)]
pub struct Memory {
    workspace: RefCell<Workspace>,
    kept: RefCell<Kept>,
    /// Where it was slack.
    slack: RefCell<Kept>,
    /// The infinitely long muscle that has G or its slopes, where friction needs them.
    long: OnceCell<ThickWall>,
    limits_mpa: OnceCell<[f64; 2]>,
}

impl Clone for Memory {
    /// For another simulation; workspaces begin anew.
    fn clone(&self) -> Self {
        Self {
            kept: self.kept.clone(),
            slack: self.slack.clone(),
            ..Self::default()
        }
    }
}

impl Memory {
    /// It as numbers; workspaces begin anew.
    pub fn numbers(&self) -> Vec<f64> {
        let (slack, kept) = (self.slack.borrow(), self.kept.borrow());
        let mut out = vec![slack.iter().flatten().count() as f64];
        for (p, e, answer) in slack.iter().chain(&*kept).flatten() {
            out.extend([*p, *e]);
            let three = |q: Quantity| [q.value, q.by_pressure, q.by_contraction];
            out.extend(answer.quantities().map(three).concat());
        }
        out
    }

    /// That of numbers.
    pub fn of(numbers: &[f64]) -> Option<Self> {
        let (count, known) = numbers.split_first()?;
        let mut known = known.chunks_exact(14).map(|numbers| {
            let quantity = |i: usize| Quantity {
                value: numbers[3 * i + 2],
                by_pressure: numbers[3 * i + 3],
                by_contraction: numbers[3 * i + 4],
            };
            let answer = Answer::from_quantities(std::array::from_fn(quantity));
            (numbers[0], numbers[1], answer)
        });
        let slack: Kept = std::array::from_fn(|i| ((i as f64) < *count).then(|| known.next())?);
        let kept: Kept = std::array::from_fn(|_| known.next());
        Some(Self {
            slack: slack.into(),
            kept: kept.into(),
            ..Self::default()
        })
    }
}

/// Keeps an answer in the place of the oldest.
fn keep(kept: &RefCell<Kept>, known: Known) {
    let kept = &mut *kept.borrow_mut();
    kept.rotate_right(1);
    kept[0] = Some(known);
}

impl Member {
    /// The allowed and the least burst pressure in MPa; infinite where they are not known.
    pub fn limits_mpa(&self) -> [f64; 2] {
        *self.memory.limits_mpa.get_or_init(|| {
            let burst = burst(&*self.muscle.model).ok();
            [
                burst.as_ref().and_then(Burst::allowed).map(|a| a.mpa),
                burst.as_ref().and_then(Burst::least).map(|least| least.1),
            ]
            .map(|mpa| mpa.unwrap_or(f64::INFINITY))
        })
    }

    /// A member with the relative tolerance of the motion.
    pub fn new(muscle: &Actuated, tolerance: f64) -> Self {
        let shape = muscle.model.muscle();
        Self {
            muscle: muscle.clone(),
            near: tolerance,
            length_mm: shape.length_mm(),
            ideal: Ideal::between_ends(shape),
            memory: Memory::default(),
            substitute: Cell::new(None),
        }
    }

    /// The wall's part of a pull: what the ideal formula does not have.
    pub fn wall_n(&self, pressure_mpa: f64, at: &Answer) -> f64 {
        at.force_n.value - self.ideal.pull(pressure_mpa, at.contraction.value)
    }

    /// The ideal formula's volume.
    pub fn ideal_mm3(&self, contraction: f64) -> f64 {
        self.ideal.volume(contraction)
    }

    /// The muscle at a pressure: slack, or taut at a contraction.
    pub fn answer_or_slack(
        &self,
        slack: bool,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Answer, ModelError> {
        if slack {
            return self.slack(pressure_mpa, Some(contraction));
        }
        Ok(Answer {
            contraction: Quantity {
                value: contraction,
                by_pressure: 0.0,
                by_contraction: 1.0,
            },
            ..self.answer(pressure_mpa, contraction)?
        })
    }

    /// F and V with their derivatives.
    pub fn answer(&self, pressure_mpa: f64, contraction: f64) -> Result<Answer, ModelError> {
        match self.substitute.get() {
            Some(Substitute::Moment(answer)) => return Ok(answer),
            Some(Substitute::Near(p, e, answer)) => {
                return Ok(answer.moved(pressure_mpa - p, contraction - e));
            }
            Some(Substitute::Nearest) => {
                let kept = self.memory.kept.borrow();
                let away = |k: &&(f64, f64, Answer)| {
                    (k.0 - pressure_mpa).abs() + (k.1 - contraction).abs()
                };
                if let Some((p, e, answer)) = kept.iter().flatten().min_by_number(away) {
                    return Ok(answer.moved(pressure_mpa - p, contraction - e));
                }
            }
            None => {}
        }
        let p = pressure_mpa.max(LEAST_MPA);
        // Not where the muscle goes slack: the pull at which it does is that of the slack muscle,
        // to the last digits.
        let near = |(at_mpa, at, answer): &&(f64, f64, Answer)| {
            let pulls = answer.force_n.value > SLACK * answer.force_n.by_contraction.abs();
            let near = if pulls { self.near } else { 1e-3 * self.near };
            (at_mpa - p).abs() <= 10.0 * near * p && (at - contraction).abs() <= near
        };
        let (from_mpa, from, at) = match self.kept(near) {
            Some(known) => known,
            None => (p, contraction, self.exact(p, contraction)?),
        };
        Ok(at.moved(pressure_mpa - from_mpa, contraction - from))
    }

    /// The same to the model's last digits, where it rests.
    pub fn at_rest(&self, pressure_mpa: f64, contraction: f64) -> Result<Answer, ModelError> {
        let p = pressure_mpa.max(LEAST_MPA);
        Ok(self.exact(p, contraction)?.moved(pressure_mpa - p, 0.0))
    }

    /// The answer that is remembered of a state.
    fn kept(&self, is: impl Fn(&&(f64, f64, Answer)) -> bool) -> Option<(f64, f64, Answer)> {
        self.memory.kept.borrow().iter().flatten().find(is).copied()
    }

    /// The answer of the model at a pressure of at least [`LEAST_MPA`].
    fn exact(&self, p: f64, contraction: f64) -> Result<Answer, ModelError> {
        if let Some((_, _, at)) = self.kept(|k| k.0 == p && k.1 == contraction) {
            return Ok(at);
        }
        let at = self.evaluate(p, contraction)?;
        keep(&self.memory.kept, (p, contraction, at));
        Ok(at)
    }

    fn evaluate(&self, p: f64, e: f64) -> Result<Answer, ModelError> {
        let w = &mut *self.memory.workspace.borrow_mut();
        let model = &self.muscle.model;
        let not_finite = || ModelError::not_finite(&model.info().name, p, e);
        let mut at = |p: f64, e: f64| {
            let r = model.response(w, p, e)?;
            Ok::<_, ModelError>((r, r.volume_mm3.ok_or_else(not_finite)?))
        };
        let (r, volume_mm3) = at(p, e)?;
        // The slopes of pull and volume: those of the model, or differences between two points.
        let mut slopes =
            |known: [Option<f64>; 2], above: (f64, f64), below: (f64, f64), width: f64| {
                if let [Some(force), Some(volume)] = known {
                    return Ok::<_, ModelError>([force, volume]);
                }
                let above = at(above.0, above.1)?;
                let below = at(below.0, below.1)?;
                let [force, volume] =
                    [above.0.force_n - below.0.force_n, above.1 - below.1].map(|d| d / width);
                Ok([known[0].unwrap_or(force), known[1].unwrap_or(volume)])
            };
        // At the least pressure the difference is one-sided.
        let low = (p - STEP_MPA).max(LEAST_MPA);
        let by_pressure = slopes(
            [r.force_per_pressure_mm2, r.volume_per_pressure_mm3_per_mpa],
            (p + STEP_MPA, e),
            (low, e),
            p + STEP_MPA - low,
        )?;
        let by_contraction = slopes(
            [
                r.stiffness_n_per_mm.map(|k| -k * self.length_mm),
                r.volume_per_contraction_mm3,
            ],
            (p, e + STEP),
            (p, e - STEP),
            2.0 * STEP,
        )?;
        let quantity = |value: f64, i: usize| Quantity {
            value,
            by_pressure: by_pressure[i],
            by_contraction: by_contraction[i],
        };
        let answer = Answer {
            force_n: quantity(r.force_n, 0),
            volume_mm3: quantity(volume_mm3, 1),
            pivoting_n_per_mm: self.pivoting(w, p, e)?,
            contraction: Quantity::default(),
        };
        let finite = |q: Quantity| (q.value + q.by_pressure + q.by_contraction).is_finite();
        if answer.quantities().into_iter().all(finite) {
            Ok(answer)
        } else {
            Err(not_finite())
        }
    }

    /// G, ∂G/∂ε and ∂G/∂P of the strands' contact, where friction needs them: G is that of the
    /// model, or else of the infinitely long muscle; its slopes are those of the infinitely long
    /// muscle in the same proportion, by one-sided differences.
    fn pivoting(&self, w: &mut Workspace, p: f64, e: f64) -> Result<Quantity, ModelError> {
        /// Of the pressure (relative) and the contraction.
        const SHARE: f64 = 1e-4;
        if !self
            .muscle
            .friction
            .is_some_and(|friction| friction.lever_mm > 0.0)
        {
            return Ok(Quantity::default());
        }
        let model = &self.muscle.model;
        let long = self
            .memory
            .long
            .get_or_init(|| ThickWall::between_ends(model.muscle()));
        let of_long = |w: &mut Workspace, p: f64, e: f64| pivoting_n_per_mm(long, w, p, e);
        let at = of_long(w, p, e);
        let value = model
            .contact_n_per_mm(w, p, e)
            .unwrap_or_else(|| at.clone())?;
        let Some(at) = at.ok().filter(|at| *at > 0.0) else {
            return Ok(Quantity {
                value,
                ..Quantity::default()
            });
        };
        let mut change = |p: f64, e: f64| value / at * (of_long(w, p, e).unwrap_or(at) - at);
        Ok(Quantity {
            value,
            by_contraction: change(p, e + SHARE) / SHARE,
            by_pressure: change(p * (1.0 + SHARE), e) / (SHARE * p),
        })
    }

    /// The slack muscle at a pressure: Newton's method from where it was slack last, else from a
    /// contraction near which it goes slack, else a search.
    pub fn slack(&self, pressure_mpa: f64, from: Option<f64>) -> Result<Answer, ModelError> {
        let substitute = self.substitute.get();
        let p = pressure_mpa.max(LEAST_MPA);
        let last = match substitute {
            Some(Substitute::Moment(answer)) => return Ok(answer),
            Some(Substitute::Near(p, e, at)) => Some((p, e, at)),
            _ => {
                let slack = self.memory.slack.borrow();
                let away = |k: &&Known| (k.0 - p).abs();
                slack.iter().flatten().min_by_number(away).copied()
            }
        };
        let (at_mpa, at) = match last {
            Some((at_mpa, _, at))
                if substitute.is_some() || (at_mpa - p).abs() <= 10.0 * self.near * p =>
            {
                (at_mpa, at)
            }
            _ => {
                // Not far along the tangent.
                let further = |(at_mpa, e, at): Known| {
                    let step_mpa = (p - at_mpa).clamp(-0.2 * at_mpa, 0.2 * at_mpa);
                    e + at.contraction.by_pressure * step_mpa
                };
                let near = last.map(further).or(from);
                let near = near.and_then(|e| self.polished(p, e));
                let at = near.map_or_else(|| self.searched(p), Ok)?;
                keep(&self.memory.slack, (p, at.contraction.value, at));
                (p, at)
            }
        };
        // Below the least pressure, and below none, where a liquid can come, it goes on linearly as
        // the taut muscle does.
        let step_mpa = pressure_mpa - at_mpa;
        Ok(at.moved(step_mpa, at.contraction.by_pressure * step_mpa))
    }

    /// The slack muscle by a search of its free contraction.
    fn searched(&self, p: f64) -> Result<Answer, ModelError> {
        // Below zero where the ends slip or the sleeve is wider than the tube: it then hangs longer
        // than at rest.
        let options = Options {
            two_sided: true,
            ..Options::extrapolating()
        };
        let search = {
            let workspace = &mut self.memory.workspace.borrow_mut();
            Evaluation::new(&self.muscle.model, workspace, options).free_contraction(p)
        };
        let why = |error| format!("a slack muscle has no free contraction: {error}");
        let e = search.map_err(|error| ModelError::NoEquilibrium(why(error)))?;
        self.polished(p, e)
            .map_or_else(|| Ok(slack_at(self.exact(p, e)?, e)), Ok)
    }

    /// Whether it is slack at a contraction, as far as that is known.
    pub fn hangs(&self, pressure_mpa: f64, contraction: f64) -> bool {
        self.slack(pressure_mpa, None)
            .is_ok_and(|at| contraction >= at.contraction.value)
    }

    /// The slack muscle by Newton's method from near its free contraction, to the model's last digits:
    /// the error of a step is its square.
    fn polished(&self, p: f64, mut e: f64) -> Option<Answer> {
        for _ in 0..12 {
            let at = self.exact(p, e).ok()?;
            let force = Some(at.force_n).filter(|f| f.by_contraction < 0.0)?;
            let step = -force.value / force.by_contraction;
            e += step;
            if step.abs() < 1e-7 {
                return Some(slack_at(at.moved(0.0, step), e));
            }
        }
        None
    }
}

/// What a muscle answers that hangs at its free contraction.
fn slack_at(at: Answer, contraction: f64) -> Answer {
    let slope = at.force_n.by_contraction;
    let by_pressure = if slope < 0.0 {
        -at.force_n.by_pressure / slope
    } else {
        0.0
    };
    Answer {
        contraction: Quantity {
            value: contraction,
            by_pressure,
            by_contraction: 0.0,
        },
        ..at
    }
}
