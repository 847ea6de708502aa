//! Ends that give way: any model of a muscle whose terminals state a seating, a slip or a grip.
//!
//!   F(P, ε) = F₀(P, x),   x of ε by [`Ends`],
//!
//! F₀ of the model of the muscle between its ends. One muscle cannot tell a seating from an error in the zero of its length; muscles of several
//! lengths can.

use super::{Accuracy, ForceModel, ModelError, ModelRange, Response, Workspace};
use crate::muscle::{Ends, Met, Muscle};

/// A model of a muscle whose ends give way.
pub struct Seated<M: ForceModel + ?Sized> {
    inner: Box<M>,
    muscle: Muscle,
    ends: Ends,
}

/// The model itself where nothing is said of the ends of `muscle`, else the whole muscle; `model` is of [`Muscle::between_ends`].
pub fn seated(model: Box<dyn ForceModel>, muscle: &Muscle) -> Box<dyn ForceModel> {
    if muscle.ends().give() { Box::new(Seated::new(model, muscle)) } else { model }
}

impl<M: ForceModel + ?Sized> std::fmt::Debug for Seated<M> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Seated").field("inner", &self.inner.name()).finish_non_exhaustive()
    }
}

impl<M: ForceModel + ?Sized> Seated<M> {
    /// A whole muscle with the model of what is between its ends ([`Muscle::between_ends`]).
    pub fn new(inner: Box<M>, muscle: &Muscle) -> Self {
        Self { inner, muscle: muscle.clone(), ends: muscle.ends() }
    }

    /// The model of the muscle between its ends.
    pub fn inner(&self) -> &M {
        &self.inner
    }

    /// The ends.
    pub fn ends(&self) -> &Ends {
        &self.ends
    }

    /// What the whole muscle answers where the muscle between its ends answers `inner`.
    pub fn whole(&self, at: &Met, inner: Response) -> Response {
        let (ends, k) = (&self.ends, at.stiffness_n_per_mm);
        let (slip, bore, softer) = (ends.slip_mm_per_n, ends.bore_mm2(), ends.softer(k));
        let by_pressure = inner.force_per_pressure_mm2.map(|slope| (slope - k * slip * bore) / softer);
        let by_contraction = inner.volume_per_contraction_mm3.map(|slope| {
            slope * (ends.length_mm / ends.active_mm()) / softer - slip * bore * k * ends.length_mm / softer
        });
        let volume_by_pressure = inner.volume_per_pressure_mm3_per_mpa.and_then(|slope| {
            if slip == 0.0 {
                return Some(slope);
            }
            let way = slip * (by_pressure? + bore);
            Some(slope + (inner.volume_per_contraction_mm3? / ends.active_mm() + bore) * way)
        });
        Response {
            contraction: at.whole,
            volume_mm3: inner.volume_mm3.map(|v| v + slip * bore * at.load_n),
            volume_per_pressure_mm3_per_mpa: volume_by_pressure,
            volume_per_contraction_mm3: by_contraction,
            stiffness_n_per_mm: inner.stiffness_n_per_mm.map(|k| k / softer),
            force_per_pressure_mm2: by_pressure,
            ..inner
        }
    }

    /// Where the ends stand, and what the muscle between them answers there.
    fn met(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<(Met, Response), ModelError> {
        let mut last = None;
        let slips = self.ends.slip_mm_per_n > 0.0;
        let met = self.ends.meet(p, e, |x| {
            let mut ask = |x| self.inner.response(workspace, p, x).map_err(|error| self.told(error, e, x));
            let found = ask(x)?;
            let stiffness = match found.stiffness_n_per_mm {
                Some(k) => k,
                None if slips => {
                    (ask(x - H)?.force_n - ask(x + H)?.force_n) / (2.0 * H * self.ends.active_mm())
                }
                None => 0.0,
            };
            last = Some(found);
            Ok::<_, ModelError>((found.force_n, stiffness))
        })?;
        met.zip(last).ok_or(ModelError::NotConverged {
            pressure_mpa: p,
            contraction: e,
            iterations: Ends::STEPS,
            residual: f64::NAN,
        })
    }

    /// x of a point with its pull.
    fn between(&self, p: f64, e: f64, force_n: f64) -> f64 {
        self.ends.between(e, self.ends.way_mm(p, force_n))
    }

    /// An error at x, with contractions of the whole muscle.
    fn told(&self, mut error: ModelError, e: f64, x: f64) -> ModelError {
        let way = self.ends.way_between_mm(e, x);
        match &mut error {
            ModelError::Geometry { contraction, lowest, highest } => {
                for value in [contraction, lowest, highest] {
                    *value = self.ends.whole(*value, way);
                }
            }
            ModelError::NoEquilibrium { reason } | ModelError::Stopped { reason, .. } => {
                reason.push_str(" (contractions of the muscle between its ends, which give way)");
            }
            ModelError::Overstretched { contraction, .. }
            | ModelError::Locked { contraction, .. }
            | ModelError::NotConverged { contraction, .. }
            | ModelError::NotFinite { contraction, .. } => *contraction = self.ends.whole(*contraction, way),
            _ => {}
        }
        error
    }
}

/// Half the width in x of the difference that stands for K₀ where a model does not know it.
const H: f64 = 1e-5;

impl<M: ForceModel + ?Sized> ForceModel for Seated<M> {
    fn name(&self) -> &str {
        self.inner.name()
    }

    fn muscle(&self) -> &Muscle {
        &self.muscle
    }

    fn source(&self) -> &str {
        self.inner.source()
    }

    /// The way of a slip is left out of the contractions.
    fn range(&self) -> ModelRange {
        let range = self.inner.range();
        let whole = |x: f64| self.ends.whole(x, self.ends.seating_mm);
        let (low, high) = range.contraction;
        ModelRange { contraction: (whole(low).max(-1.0), whole(high)), ..range }
    }

    fn accuracy(&self) -> Accuracy {
        self.inner.accuracy()
    }

    fn notes(&self, workspace: &Workspace) -> Vec<String> {
        self.inner.notes(workspace)
    }

    fn response(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<Response, ModelError> {
        let (met, found) = self.met(workspace, p, e)?;
        Ok(self.whole(&met, found))
    }

    fn force_n(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<f64, ModelError> {
        if self.ends.slip_mm_per_n > 0.0 {
            return Ok(self.met(workspace, p, e)?.1.force_n);
        }
        let x = self.between(p, e, 0.0);
        self.inner.force_n(workspace, p, x).map_err(|error| self.told(error, e, x))
    }

    fn blocked_scale_n(&self, workspace: &mut Workspace, p: f64) -> Result<f64, ModelError> {
        self.inner.blocked_scale_n(workspace, p)
    }

    fn mesh_error_n(
        &self,
        workspace: &mut Workspace,
        p: f64,
        e: f64,
        force_n: f64,
        blocked_n: f64,
    ) -> Option<f64> {
        self.inner.mesh_error_n(workspace, p, self.between(p, e, force_n), force_n, blocked_n)
    }

    fn force_by(
        &self,
        workspace: &mut Workspace,
        p: f64,
        e: f64,
        names: &[String],
    ) -> Option<Result<Vec<f64>, ModelError>> {
        let (met, found) = match self.met(workspace, p, e) {
            Ok(met) => met,
            Err(error) => return Some(Err(error)),
        };
        found.stiffness_n_per_mm?;
        let inside: Vec<String> =
            names.iter().filter_map(|n| Ends::inner_name(n)).map(str::to_owned).collect();
        let known = match self.inner.force_by(workspace, p, met.between, &inside)? {
            Ok(known) => known,
            Err(error) => return Some(Err(self.told(error, e, met.between))),
        };
        let mut known = known.into_iter();
        let one = |name: &String| {
            let inner = Ends::inner_name(name).map_or(Some(0.0), |_| known.next())?;
            Some(self.ends.slope(&met, name, inner))
        };
        names.iter().map(one).collect::<Option<Vec<f64>>>().map(Ok)
    }

    fn pivoting_n_per_mm(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<f64, ModelError> {
        let met = self.met(workspace, p, e)?.0;
        let inner = self.inner.pivoting_n_per_mm(workspace, p, met.between);
        // Of the whole muscle's change of length the strands get a share.
        inner
            .map(|g| g / self.ends.softer(met.stiffness_n_per_mm))
            .map_err(|error| self.told(error, e, met.between))
    }

    fn is_costly(&self) -> bool {
        self.inner.is_costly()
    }

    fn exact_pressure(&self, force_n: f64, e: f64) -> Option<f64> {
        if self.ends.slip_mm_per_n > 0.0 {
            return None;
        }
        self.inner.exact_pressure(force_n, self.between(0.0, e, force_n))
    }

    fn exact_contraction(&self, force_n: f64, p: f64) -> Option<f64> {
        let x = self.inner.exact_contraction(force_n, p)?;
        Some(self.ends.whole(x, self.ends.way_mm(p, force_n)))
    }

    fn pressure_under_load(&self, workspace: &mut Workspace, force_n: f64, e: f64) -> Option<f64> {
        if self.ends.slip_mm_per_n > 0.0 {
            return None;
        }
        self.inner.pressure_under_load(workspace, force_n, self.between(0.0, e, force_n))
    }

    fn contraction_under_load(&self, workspace: &mut Workspace, force_n: f64, p: f64) -> Option<f64> {
        let x = self.inner.contraction_under_load(workspace, force_n, p)?;
        Some(self.ends.whole(x, self.ends.way_mm(p, force_n)))
    }
}

#[cfg(test)]
mod tests;
