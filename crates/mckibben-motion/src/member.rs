//! A force model as the equations of motion ask it: both pulls and volumes with their derivatives, and the slack muscle.

use crate::{Actuated, Hysteresis};
use mckibben::analysis::{Evaluation, Options};
use mckibben::model::{ForceModel, Ideal, ModelError, ThickWall, Workspace, pivoting_n_per_mm};
use std::cell::{Cell, OnceCell, RefCell};

/// F and V at a gauge pressure and contraction, with their derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Answer {
    pub force_n: f64,
    /// ∂F/∂ε in N
    pub force_e: f64,
    /// ∂F/∂P in mm²
    pub force_p: f64,
    pub volume_mm3: f64,
    pub volume_e: f64,
    pub volume_p: f64,
    /// G of the strands' contact in N/mm; 0 where nobody needs it.
    pub pivoting_n_per_mm: f64,
    pub pivoting_e: f64,
    pub pivoting_p: f64,
}

impl Answer {
    /// The first order about the point of this answer.
    fn moved(self, pressure_mpa: f64, contraction: f64) -> Self {
        Self {
            force_n: self.force_n + self.force_p * pressure_mpa + self.force_e * contraction,
            volume_mm3: self.volume_mm3 + self.volume_p * pressure_mpa + self.volume_e * contraction,
            pivoting_n_per_mm: self.pivoting_n_per_mm
                + self.pivoting_p * pressure_mpa
                + self.pivoting_e * contraction,
            ..self
        }
    }
}

/// The slack muscle: where it hangs, and how its volume follows the pressure alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SlackState {
    pub contraction: f64,
    pub answer: Answer,
    /// dε_free/dP
    pub contraction_p: f64,
}

/// What replaces the model between two answers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Substitute {
    /// At one moment within a step.
    Moment(SlackState),
    /// About a pressure and contraction: first order.
    Near(f64, f64, SlackState),
    /// The same about the nearest question that was asked last.
    Nearest,
}

impl Substitute {
    /// At the share `s` of a step of length `h` between two answers with their derivatives in time.
    pub fn between(a: &(SlackState, SlackState), b: &(SlackState, SlackState), s: f64, h: f64) -> Self {
        let r = 1.0 - s;
        let cubic = |x: f64, k: f64, y: f64, l: f64| {
            x * r * r * (1.0 + 2.0 * s) + y * s * s * (3.0 - 2.0 * s) + h * (k * s * r * r - l * s * s * r)
        };
        let line = |x: f64, y: f64| r * x + s * y;
        let (of, by, to, then) = (&a.0.answer, &a.1.answer, &b.0.answer, &b.1.answer);
        let answer = Answer {
            force_n: cubic(of.force_n, by.force_n, to.force_n, then.force_n),
            volume_mm3: cubic(of.volume_mm3, by.volume_mm3, to.volume_mm3, then.volume_mm3),
            pivoting_n_per_mm: cubic(
                of.pivoting_n_per_mm,
                by.pivoting_n_per_mm,
                to.pivoting_n_per_mm,
                then.pivoting_n_per_mm,
            ),
            force_e: line(of.force_e, to.force_e),
            force_p: line(of.force_p, to.force_p),
            volume_e: line(of.volume_e, to.volume_e),
            volume_p: line(of.volume_p, to.volume_p),
            pivoting_e: line(of.pivoting_e, to.pivoting_e),
            pivoting_p: line(of.pivoting_p, to.pivoting_p),
        };
        let contraction = cubic(a.0.contraction, a.1.contraction, b.0.contraction, b.1.contraction);
        Self::Moment(SlackState {
            contraction,
            answer,
            contraction_p: line(a.0.contraction_p, b.0.contraction_p),
        })
    }
}

/// Steps of central differences where a model does not know the derivatives of its volume.
const STEP_MPA: f64 = 1e-4;
const STEP: f64 = 1e-4;

/// Below 1 Pa force and volume go on linearly in the pressure: at none the strands are slack, the volume has a kink, and below it no model
/// is made.
const LEAST_MPA: f64 = 1e-6;

/// Closer than this to where it goes slack, as a contraction, a muscle is asked itself.
const SLACK: f64 = 1e-3;

/// Questions asked last, with their answers: a step asks for its start, three stages and its end, some of them again.
type Kept = [Option<(f64, f64, Answer)>; 8];

pub(crate) struct Member<'a> {
    pub model: &'a dyn ForceModel,
    pub length_mm: f64,
    /// So far from an answer that is kept, as a contraction (ten times as far as a share of the pressure), its first order is the model.
    near: f64,
    ideal: Ideal,
    pub memory: Memory,
    /// Whether friction needs G.
    has_contact: bool,
    pub asked: Cell<usize>,
    /// In place of the model, where there is one.
    pub substitute: Cell<Option<Substitute>>,
}

/// What a member has learnt: it begins the next piece of the same motion with it.
#[derive(Default)]
pub(crate) struct Memory {
    workspace: RefCell<Workspace>,
    kept: RefCell<Kept>,
    next: Cell<usize>,
    clamp_slack: Cell<Option<f64>>,
    /// The infinitely long muscle that has G or its slopes, where friction needs them.
    long: OnceCell<ThickWall>,
}

impl Memory {
    /// The same for another simulation; the workspace of its model begins anew.
    pub fn duplicate(&self) -> Self {
        let Self { kept, next, clamp_slack, .. } = self;
        let (kept, next, clamp_slack) = (kept.clone(), next.clone(), clamp_slack.clone());
        Self { kept, next, clamp_slack, ..Self::default() }
    }
}

impl<'a> Member<'a> {
    /// A member with the relative tolerance of the motion.
    pub fn new(muscle: &Actuated<'a>, tolerance: f64) -> Self {
        let model = muscle.model;
        Self {
            model,
            near: tolerance,
            length_mm: model.muscle().length_mm(),
            ideal: Ideal::new(model.muscle()),
            memory: Memory::default(),
            has_contact: muscle.friction.as_ref().is_some_and(Hysteresis::has_contact),
            asked: Cell::new(0),
            substitute: Cell::new(None),
        }
    }

    /// The wall's part of a pull: what the ideal formula does not have.
    pub fn wall_n(&self, force_n: f64, pressure_mpa: f64, contraction: f64) -> f64 {
        force_n - self.ideal.pull(pressure_mpa, contraction)
    }

    /// The ideal formula's volume.
    pub fn ideal_mm3(&self, contraction: f64) -> f64 {
        self.ideal.volume(contraction)
    }

    /// F and V with their derivatives.
    pub fn answer(&self, pressure_mpa: f64, contraction: f64) -> Result<Answer, ModelError> {
        match self.substitute.get() {
            Some(Substitute::Moment(h)) => return Ok(h.answer),
            Some(Substitute::Near(p, e, h)) => return Ok(h.answer.moved(pressure_mpa - p, contraction - e)),
            Some(Substitute::Nearest) => {
                let kept = self.memory.kept.borrow();
                let away = |k: &&(f64, f64, Answer)| (k.0 - pressure_mpa).abs() + (k.1 - contraction).abs();
                let nearest = kept.iter().flatten().min_by(|a, b| away(a).total_cmp(&away(b)));
                if let Some((p, e, answer)) = nearest {
                    return Ok(answer.moved(pressure_mpa - p, contraction - e));
                }
            }
            None => {}
        }
        let p = pressure_mpa.max(LEAST_MPA);
        // Not where the muscle goes slack: the pull at which it does is that of the slack muscle, to the last digits.
        let near = |(at_mpa, at, answer): &&(f64, f64, Answer)| {
            let pulls = answer.force_n > SLACK * answer.force_e.abs();
            let near = (at_mpa - p).abs() <= 10.0 * self.near * p && (at - contraction).abs() <= self.near;
            near && pulls || *at_mpa == p && *at == contraction
        };
        let known = self.memory.kept.borrow().iter().flatten().find(near).copied();
        let (from_mpa, from, at) = match known {
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

    /// The model's own answer at a pressure of at least [`LEAST_MPA`].
    fn exact(&self, p: f64, contraction: f64) -> Result<Answer, ModelError> {
        let known =
            self.memory.kept.borrow().iter().flatten().find(|k| k.0 == p && k.1 == contraction).map(|k| k.2);
        if let Some(at) = known {
            return Ok(at);
        }
        let at = self.ask(p, contraction)?;
        let kept = &mut *self.memory.kept.borrow_mut();
        let place = self.memory.next.get();
        self.memory.next.set((place + 1) % kept.len());
        if let Some(slot) = kept.get_mut(place) {
            *slot = Some((p, contraction, at));
        }
        Ok(at)
    }

    fn ask(&self, p: f64, e: f64) -> Result<Answer, ModelError> {
        let w = &mut *self.memory.workspace.borrow_mut();
        self.asked.set(self.asked.get() + 1);
        let not_finite = || ModelError::NotFinite {
            model: self.model.info().name.to_string(),
            pressure_mpa: p,
            contraction: e,
        };
        let mut at = |p: f64, e: f64| {
            let r = self.model.response(w, p, e)?;
            let volume = r.volume_mm3.ok_or_else(not_finite)?;
            Ok::<_, ModelError>((r, volume))
        };
        let (r, volume_mm3) = at(p, e)?;
        // At the least pressure only its own side is asked.
        let low = (p - STEP_MPA).max(LEAST_MPA);
        let (mut force_p, mut volume_p) = (r.force_per_pressure_mm2, r.volume_per_pressure_mm3_per_mpa);
        if force_p.is_none() || volume_p.is_none() {
            let (above, below) = (at(p + STEP_MPA, e)?, at(low, e)?);
            let width = p + STEP_MPA - low;
            volume_p = volume_p.or(Some((above.1 - below.1) / width));
            force_p = force_p.or(Some((above.0.force_n - below.0.force_n) / width));
        }
        let (mut force_e, mut volume_e) =
            (r.stiffness_n_per_mm.map(|k| -k * self.length_mm), r.volume_per_contraction_mm3);
        if force_e.is_none() || volume_e.is_none() {
            let (above, below) = (at(p, e + STEP)?, at(p, e - STEP)?);
            volume_e = volume_e.or(Some((above.1 - below.1) / (2.0 * STEP)));
            force_e = force_e.or(Some((above.0.force_n - below.0.force_n) / (2.0 * STEP)));
        }
        let [pivoting_n_per_mm, pivoting_e, pivoting_p] = self.pivoting(w, p, e)?;
        let answer = Answer {
            pivoting_n_per_mm,
            pivoting_e,
            pivoting_p,
            force_n: r.force_n,
            force_e: force_e.ok_or_else(not_finite)?,
            force_p: force_p.ok_or_else(not_finite)?,
            volume_mm3,
            volume_e: volume_e.ok_or_else(not_finite)?,
            volume_p: volume_p.ok_or_else(not_finite)?,
        };
        let Answer { force_n, force_e, force_p, volume_e, volume_p, .. } = answer;
        let numbers = [force_n, force_e, force_p, volume_mm3, volume_e, volume_p];
        let mut numbers = numbers.into_iter().chain([pivoting_n_per_mm, pivoting_e, pivoting_p]);
        let finite = numbers.all(f64::is_finite);
        if finite { Ok(answer) } else { Err(not_finite()) }
    }

    /// G, ∂G/∂ε and ∂G/∂P of the strands' contact, where friction needs them: G is the model's own, or else that of the infinitely long
    /// muscle; its slopes are those of the infinitely long muscle in the same proportion, by one-sided differences.
    fn pivoting(&self, w: &mut Workspace, p: f64, e: f64) -> Result<[f64; 3], ModelError> {
        /// Of the pressure (relative) and the contraction.
        const SHARE: f64 = 1e-4;
        if !self.has_contact {
            return Ok([0.0; 3]);
        }
        let long = self.memory.long.get_or_init(|| ThickWall::new(self.model.muscle()));
        let of_long = |w: &mut Workspace, p: f64, e: f64| pivoting_n_per_mm(long, w, p, e);
        let at = of_long(w, p, e);
        let own = match self.model.extensions().contact {
            Some(contact) => contact.pivoting_n_per_mm(w, p, e)?,
            None => at.clone()?,
        };
        let Some(at) = at.ok().filter(|at| *at > 0.0) else { return Ok([own, 0.0, 0.0]) };
        let mut change = |p: f64, e: f64| own / at * (of_long(w, p, e).unwrap_or(at) - at);
        Ok([own, change(p, e + SHARE) / SHARE, change(p * (1.0 + SHARE), e) / (SHARE * p)])
    }

    /// The slack muscle at a pressure: Newton's method from where it was slack last, else a search.
    pub fn slack(&self, pressure_mpa: f64) -> Result<SlackState, ModelError> {
        if let Some(Substitute::Moment(h)) = self.substitute.get() {
            return Ok(h);
        }
        let p = pressure_mpa.max(LEAST_MPA);
        let near = self.memory.clamp_slack.get().and_then(|last| self.polished(p, last));
        let contraction = match near {
            Some(e) => e,
            None => {
                // Below zero where the ends give way or the sleeve is wider than the tube: it then hangs longer than at rest.
                let options = Options { two_sided: true, ..Options::extrapolating() };
                let search = Evaluation::new(self.model, &mut self.memory.workspace.borrow_mut(), options)
                    .free_contraction(p);
                let e = search.map_err(|error| ModelError::NoEquilibrium {
                    reason: format!("a slack muscle has no free contraction: {error}"),
                })?;
                self.polished(p, e).unwrap_or(e)
            }
        };
        self.memory.clamp_slack.set(Some(contraction));
        let at = self.answer(p, contraction)?;
        let contraction_p = if at.force_e < 0.0 { -at.force_p / at.force_e } else { 0.0 };
        // Below the least pressure, and below none, where a liquid can come, it goes on linearly as the taut muscle does.
        let further = contraction_p * (pressure_mpa - p);
        Ok(SlackState {
            contraction: contraction + further,
            answer: at.moved(pressure_mpa - p, further),
            contraction_p,
        })
    }

    /// The free contraction by Newton's method from near it, to the model's last digits.
    fn polished(&self, p: f64, mut e: f64) -> Option<f64> {
        let mut before = f64::INFINITY;
        for _ in 0..12 {
            let a = self.exact(p, e).ok().filter(|a| a.force_e < 0.0)?;
            let step = -a.force_n / a.force_e;
            if step.abs() < 1e-13 || step.abs() < 1e-9 && step.abs() >= 0.5 * before {
                return Some(e);
            }
            (e, before) = (e + step, step.abs());
        }
        None
    }
}
