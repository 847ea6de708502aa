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
mod tests {
    use super::*;
    use crate::model::ModelKind;
    use crate::muscle::Terminals;

    fn with(terminals: Terminals) -> Muscle {
        Muscle::prototype().with_terminals(terminals).unwrap()
    }

    fn muscle(seating_mm: f64) -> Muscle {
        with(Terminals { seating_mm: Some(seating_mm), ..Terminals::default() })
    }

    /// Seating 0 leaves every digit; δ shifts the contraction by δ/L0, in pull, volume, inverses and range.
    #[test]
    fn a_seated_muscle_is_the_same_one_contracted_by_the_seating() {
        let workspace = &mut Workspace::new();
        for kind in [ModelKind::Ideal, ModelKind::ThickWall, ModelKind::Universal] {
            let (held, none, gives) = (
                kind.build(&Muscle::prototype()).unwrap(),
                kind.build(&muscle(0.0)).unwrap(),
                kind.build(&muscle(2.85)).unwrap(),
            );
            for (p, e) in [(0.1, 0.0), (0.25, 0.1), (0.2, 0.2)] {
                let here = held.response(workspace, p, e).unwrap();
                assert_eq!(none.response(workspace, p, e).unwrap(), here);
                let found = gives.response(workspace, p, e - 0.01).unwrap();
                assert!((found.force_n - here.force_n).abs() < 1e-9 * here.force_n.abs().max(1.0));
                assert_eq!(found.contraction, e - 0.01);
                if let Some(exact) = gives.exact_contraction(here.force_n, p) {
                    assert!((exact - (e - 0.01)).abs() < 1e-9);
                }
            }
            assert!((gives.range().contraction.1 - (held.range().contraction.1 - 0.01)).abs() < 1e-12);
        }
    }

    /// K δ: what rigid strands lose of the blocked force of a muscle, to first order in δ; the error is of second order.
    #[test]
    fn the_blocked_force_falls_by_stiffness_times_seating_to_second_order() {
        let workspace = &mut Workspace::new();
        let held = ModelKind::Ideal.build(&Muscle::prototype()).unwrap();
        let at_rest = held.response(workspace, 0.25, 0.0).unwrap();
        let stiffness = at_rest.stiffness_n_per_mm.unwrap();
        let miss = |seating: f64, w: &mut Workspace| {
            let gives = ModelKind::Ideal.build(&muscle(seating)).unwrap();
            (gives.force_n(w, 0.25, 0.0).unwrap() - (at_rest.force_n - stiffness * seating)).abs()
        };
        let (coarse, fine) = (miss(2.0, workspace), miss(1.0, workspace));
        assert!((coarse / fine - 4.0).abs() < 1e-6, "{coarse} {fine}");
    }

    /// ∂F/∂δ and ∂F/∂L0 against central differences.
    #[test]
    fn slopes_by_seating_and_length_are_those_of_differences() {
        let workspace = &mut Workspace::new();
        let names = ["terminals.seating".to_owned(), "tube.length".into(), "tube.wall_thickness".into()];
        let at = |m: &Muscle, w: &mut Workspace| {
            ModelKind::ThickWall.build(m).unwrap().force_n(w, 0.25, 0.1).unwrap()
        };
        let base = muscle(3.0);
        let longer = |h: f64| {
            let mut tube = base.tube().clone();
            tube.length_mm += h;
            base.with_tube(tube).unwrap()
        };
        let by_seating = (at(&muscle(3.01), workspace) - at(&muscle(2.99), workspace)) / 0.02;
        let by_length = (at(&longer(0.1), workspace) - at(&longer(-0.1), workspace)) / 0.2;
        let model = ModelKind::ThickWall.build(&base).unwrap();
        let Some(found) = model.force_by(workspace, 0.25, 0.1, &names) else {
            let stiffness = model.response(workspace, 0.25, 0.1).unwrap().stiffness_n_per_mm.unwrap();
            assert!((by_seating + stiffness).abs() < 1e-5 * stiffness);
            // The thick wall is endless: its pull depends on L0 through δ/L0 alone.
            assert!((by_length - stiffness * (3.0 / 285.0)).abs() < 1e-5 * stiffness);
            return;
        };
        let found = found.unwrap();
        assert!((found[0] - by_seating).abs() < 1e-5 * by_seating.abs(), "{found:?}");
        assert!((found[1] - by_length).abs() < 1e-5 * by_seating.abs(), "{found:?}");
    }

    fn slipping(grip_mm: f64, slip_mm_per_n: f64) -> Muscle {
        with(Terminals {
            seating_mm: Some(1.5),
            slip_mm_per_n: Some(slip_mm_per_n),
            grip_mm: Some(grip_mm),
            ..Terminals::default()
        })
    }

    /// The ends carry F + π Ri² P: whoever stretches the ends' spring by hand and asks the muscle between them finds the same pull.
    #[test]
    fn slip_is_a_spring_under_the_load_of_the_plug() {
        let workspace = &mut Workspace::new();
        let whole = slipping(5.0, 4e-3);
        for kind in [ModelKind::Ideal, ModelKind::ThickWall, ModelKind::Universal] {
            let model = kind.build(&whole).unwrap();
            let inner = kind.build(&whole.between_ends()).unwrap();
            for (p, e) in [(0.1, 0.0), (0.25, 0.1), (0.2, 0.2), (0.2, -0.02)] {
                let force = model.force_n(workspace, p, e).unwrap();
                let load = force + p * std::f64::consts::PI * 12.0 * 12.0;
                let x = (e * 285.0 + 1.5 + 4e-3 * load) / 275.0;
                let by_hand = inner.force_n(workspace, p, x).unwrap();
                assert!((force - by_hand).abs() < 1e-6, "{force} {by_hand}");
                if let Some(exact) = model.exact_contraction(force, p) {
                    assert!((exact - e).abs() < 1e-9);
                }
            }
        }
    }

    /// K, ∂F/∂P, ∂V/∂P and ∂V/∂ε against central differences, and L0 ∂F/∂P = ∂V/∂ε, which is that of any muscle with a potential.
    #[test]
    fn tangents_of_slipping_ends_are_those_of_differences() {
        let workspace = &mut Workspace::new();
        for kind in [ModelKind::Ideal, ModelKind::ThickWall, ModelKind::Universal] {
            let model = kind.build(&slipping(5.0, 4e-3)).unwrap();
            let (p, e, h) = (0.2, 0.08, 1e-4);
            let mut at = |p: f64, e: f64| model.response(workspace, p, e).unwrap();
            let here = at(p, e);
            let by_e = ((at(p, e + h).force_n - at(p, e - h).force_n) / (2.0 * h), {
                (at(p, e + h).volume_mm3.unwrap() - at(p, e - h).volume_mm3.unwrap()) / (2.0 * h)
            });
            let by_p = ((at(p + h, e).force_n - at(p - h, e).force_n) / (2.0 * h), {
                (at(p + h, e).volume_mm3.unwrap() - at(p - h, e).volume_mm3.unwrap()) / (2.0 * h)
            });
            let close = |a: Option<f64>, b: f64| {
                let Some(a) = a else { return };
                assert!((a - b).abs() < 1e-5 * b.abs(), "{kind:?} {a} {b}");
            };
            close(here.stiffness_n_per_mm, -by_e.0 / 285.0);
            close(here.force_per_pressure_mm2, by_p.0);
            close(here.volume_per_contraction_mm3, by_e.1);
            close(here.volume_per_pressure_mm3_per_mpa, by_p.1);
            // `universal` has no potential.
            if kind != ModelKind::Universal {
                close(Some(285.0 * by_p.0), by_e.1);
            }
        }
    }
}
