//! Ends: any model of a muscle whose terminals state a seating, a slip or a grip, or whose braid a
//! take-up pressure.
//!
//!   F(P, ε) = F₀(Pa, x),   Pa of P and x of ε by [`Ends`],
//!
//! F₀ of the model of the muscle between its ends. One muscle cannot tell a seating from an error
//! in the zero of its length; muscles of several lengths can.

use super::{
    ForceModel, ModelError, ModelId, ModelInfo, ModelRange, Response, Result, Workspace,
    pivoting_n_per_mm,
};
use crate::{
    differences::slope,
    muscle::{EndState, Ends, Muscle},
};
use std::sync::Arc;

/// A model of a muscle whose ends yield.
pub struct Seated<M: ForceModel + ?Sized> {
    /// The model of the muscle between its ends.
    pub inner: Box<M>,
    id: ModelId,
    info: ModelInfo,
    /// The ends.
    pub ends: Ends,
}

/// The model of a whole muscle: `build` makes that of the muscle between its ends, which is the
/// model itself where nothing is said of them.
///
/// A constructor such as [`ThickWall::between_ends`](super::ThickWall::between_ends) is that inner model: of a muscle
/// whose terminals state a seating, a slip, a grip or plugs it answers another pull.
///
/// ```
/// use mckibben_core::{model::*, muscle::{Muscle, file::parse_muscle}};
/// let muscle = parse_muscle("terminals.seating = 2")?;
/// let whole = with_ends::<ModelError>(&muscle, |inner| Ok(Box::new(ThickWall::between_ends(inner))))?;
/// let (inner, w) = (ThickWall::between_ends(&muscle), &mut Workspace::new());
/// // The ends give way by 2 mm under load.
/// assert!(whole.force_n(w, 0.2, 0.1)? != inner.force_n(w, 0.2, 0.1)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn with_ends<E>(
    muscle: &Muscle,
    build: impl FnOnce(&Muscle) -> Result<Box<dyn ForceModel>, E>,
) -> Result<Box<dyn ForceModel>, E> {
    let inner = build(&muscle.between_ends())?;
    Ok(if muscle.ends().give() {
        Box::new(Seated::new(inner, muscle))
    } else {
        inner
    })
}

impl<M: ForceModel + ?Sized> std::fmt::Debug for Seated<M> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Seated")
            .field("inner", &self.info.name)
            .finish_non_exhaustive()
    }
}

impl<M: ForceModel + ?Sized> Seated<M> {
    /// A whole muscle with the model of what is between its ends ([`Muscle::between_ends`]).
    pub fn new(inner: Box<M>, muscle: &Muscle) -> Self {
        let ends = muscle.ends();
        let of_inner = inner.info();
        // The contractions do not contain the displacement of a slip.
        let whole = |x: f64| ends.whole(x, ends.seating_mm);
        let (low, high) = of_inner.range.contraction;
        let (lowest, highest) = of_inner.range.pressure_mpa;
        let least = if lowest > 0.0 {
            ends.whole_mpa(lowest)
        } else {
            lowest
        };
        let range = ModelRange {
            pressure_mpa: (least, ends.whole_mpa(highest)),
            contraction: (whole(low).max(-1.0), whole(high)),
            ..of_inner.range.clone()
        };
        let info = ModelInfo {
            muscle: Arc::new(muscle.clone()),
            range,
            ..of_inner.clone()
        };
        Self {
            id: ModelId::new(),
            info,
            inner,
            ends,
        }
    }

    /// What the whole muscle answers where the muscle between its ends answers `inner`.
    pub fn whole(&self, at: &EndState, inner: Response) -> Response {
        let ends = &self.ends;
        let k = at.stiffness_n_per_mm;
        let slip = ends.slip_mm_per_n;
        let bore = ends.bore_mm2();
        let series = ends.series_factor(k);
        let by_pressure = inner
            .force_per_pressure_mm2
            .map(|slope| (slope - k * slip * bore) / series);
        let by_contraction = inner.volume_per_contraction_mm3.map(|slope| {
            slope * (ends.length_mm / ends.active_mm()) / series
                - slip * bore * k * ends.length_mm / series
        });
        let volume_by_pressure = inner.volume_per_pressure_mm3_per_mpa.and_then(|slope| {
            if slip == 0.0 {
                return Some(slope);
            }
            let by = slip * (by_pressure? + bore);
            Some(slope + (inner.volume_per_contraction_mm3? / ends.active_mm() + bore) * by)
        });
        Response {
            contraction: at.whole,
            volume_mm3: inner.volume_mm3.map(|v| v + slip * bore * at.load_n),
            volume_per_pressure_mm3_per_mpa: volume_by_pressure,
            volume_per_contraction_mm3: by_contraction,
            stiffness_n_per_mm: inner.stiffness_n_per_mm.map(|k| k / series),
            force_per_pressure_mm2: by_pressure,
            ..inner
        }
    }

    /// The ends at an active pressure and a contraction, and what the muscle between them answers.
    fn end_state(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<(EndState, Response)> {
        let mut last = None;
        let slips = self.ends.slip_mm_per_n > 0.0;
        let ends = self.solve_ends(workspace, p, e, |workspace, x| {
            let mut respond = |x| {
                self.inner
                    .response(workspace, p, x)
                    .map_err(|error| self.for_whole_muscle(error, e, x))
            };
            let response = respond(x)?;
            last = Some(response);
            let stiffness_n_per_mm = match response.stiffness_n_per_mm {
                None if slips => {
                    Some(-slope(H, |h| respond(x + h).map(|r| r.force_n))? / self.ends.active_mm())
                }
                known => known,
            };
            Ok::<_, ModelError>(Response {
                stiffness_n_per_mm,
                ..response
            })
        })?;
        ends.zip(last).ok_or(ModelError::not_converged(p, e))
    }

    /// The state of the ends at a point, where the muscle between them answers by `pull`: from the
    /// last state of this workspace, or without one.
    pub fn solve_ends<E>(
        &self,
        workspace: &mut Workspace,
        p: f64,
        e: f64,
        mut pull: impl FnMut(&mut Workspace, f64) -> Result<Response, E>,
    ) -> Result<Option<EndState>, E> {
        let start = workspace
            .last_ends(&self.id)
            .map(|last| self.ends.displacement_near_mm(last, p, e));
        let mut from = |start, w: &mut Workspace| {
            self.ends
                .solve_end_displacement(p, e, start, |x| pull(w, x))
        };
        let mut state = from(start, workspace);
        if start.is_some() && !matches!(state, Ok(Some(_))) {
            state = from(None, workspace);
        }
        if self.ends.slip_mm_per_n > 0.0
            && let Ok(Some(state)) = &state
        {
            workspace.keep_ends(&self.id, *state);
        }
        state
    }

    /// x of a point with its pull.
    fn between(&self, p: f64, e: f64, force_n: f64) -> f64 {
        self.ends
            .between(e, self.ends.end_displacement_mm(p, force_n))
    }

    /// An error at x, with contractions of the whole muscle.
    fn for_whole_muscle(&self, mut error: ModelError, e: f64, x: f64) -> ModelError {
        let displacement = self.ends.displacement_between_mm(e, x);
        match &mut error {
            ModelError::Geometry {
                contraction,
                lowest,
                highest,
            } => {
                for value in [contraction, lowest, highest] {
                    *value = self.ends.whole(*value, displacement);
                }
            }
            ModelError::NoEquilibrium(reason) | ModelError::Stopped { reason, .. } => {
                reason.push_str(" (contractions of the muscle between its ends, which give way)");
            }
            ModelError::Overstretched { contraction, .. }
            | ModelError::Locked { contraction, .. }
            | ModelError::NotConverged { contraction, .. }
            | ModelError::NotFinite { contraction, .. } => {
                *contraction = self.ends.whole(*contraction, displacement);
            }
            _ => {}
        }
        error
    }
}

/// Step in x of the difference that replaces K₀ where a model does not have it.
const H: f64 = 1e-5;

impl<M: ForceModel + ?Sized> ForceModel for Seated<M> {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn response(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<Response> {
        let (state, inner) = self.end_state(workspace, self.ends.active_mpa(p), e)?;
        let whole = self.whole(&state, inner);
        Ok(Response {
            pressure_mpa: p,
            ..whole
        })
    }

    fn force_n(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<f64> {
        let p = self.ends.active_mpa(p);
        if self.ends.slip_mm_per_n > 0.0 {
            return Ok(self.end_state(workspace, p, e)?.1.force_n);
        }
        let x = self.between(p, e, 0.0);
        self.inner
            .force_n(workspace, p, x)
            .map_err(|error| self.for_whole_muscle(error, e, x))
    }

    fn pressure_at_pull(&self, workspace: &mut Workspace, force_n: f64, e: f64) -> Option<f64> {
        if self.ends.slip_mm_per_n > 0.0 {
            return None;
        }
        let active_mpa =
            self.inner
                .pressure_at_pull(workspace, force_n, self.between(0.0, e, force_n))?;
        Some(self.ends.whole_mpa(active_mpa))
    }

    fn contraction_at_pull(&self, workspace: &mut Workspace, force_n: f64, p: f64) -> Option<f64> {
        let p = self.ends.active_mpa(p);
        let x = self.inner.contraction_at_pull(workspace, force_n, p)?;
        Some(
            self.ends
                .whole(x, self.ends.end_displacement_mm(p, force_n)),
        )
    }

    fn has_slopes(&self) -> bool {
        self.inner.has_slopes()
    }

    fn force_by(
        &self,
        w: &mut Workspace,
        p: f64,
        e: f64,
        names: &[String],
    ) -> Result<Option<Vec<f64>>> {
        if !self.has_slopes() {
            return Ok(None);
        }
        let p = self.ends.active_mpa(p);
        let (state, response) = self.end_state(w, p, e)?;
        let inside: Vec<String> = names
            .iter()
            .filter_map(|n| Ends::inner_name(n))
            .map(str::to_owned)
            .collect();
        let known = self
            .inner
            .force_by(w, p, state.between, &inside)
            .map_err(|error| self.for_whole_muscle(error, e, state.between))?;
        let Some((known, _)) = known.zip(response.stiffness_n_per_mm) else {
            return Ok(None);
        };
        let mut known = known.into_iter();
        let one = |name: &String| {
            Some(self.ends.slope(
                &state,
                name,
                Ends::inner_name(name).map_or(Some(0.0), |_| known.next())?,
            ))
        };
        Ok(names.iter().map(one).collect())
    }

    fn blocked_scale_n(&self, workspace: &mut Workspace, p: f64) -> Result<f64> {
        self.inner
            .blocked_scale_n(workspace, self.ends.active_mpa(p))
    }

    fn mesh_error_n(
        &self,
        w: &mut Workspace,
        p: f64,
        e: f64,
        force_n: f64,
        scale_n: f64,
    ) -> Option<f64> {
        let p = self.ends.active_mpa(p);
        self.inner
            .mesh_error_n(w, p, self.between(p, e, force_n), force_n, scale_n)
    }

    fn notes(&self, workspace: &Workspace) -> Vec<String> {
        self.inner.notes(workspace)
    }

    fn contact_n_per_mm(&self, workspace: &mut Workspace, p: f64, e: f64) -> Option<Result<f64>> {
        let p = self.ends.active_mpa(p);
        let state = match self.end_state(workspace, p, e) {
            Ok((state, _)) => state,
            Err(error) => return Some(Err(error)),
        };
        let inner = pivoting_n_per_mm(&*self.inner, workspace, p, state.between);
        // Of the whole muscle's change of length the strands get a share.
        Some(
            inner
                .map(|g| g / self.ends.series_factor(state.stiffness_n_per_mm))
                .map_err(|error| self.for_whole_muscle(error, e, state.between)),
        )
    }
}

#[cfg(test)]
mod tests;
