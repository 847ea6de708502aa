//! A law fitted to measured stresses, and what it leaves of them.

use super::rubber::{RubberCaseFit, RubberFitResult, RubberGroup};
use crate::rubber::{FitSettings, Mode, StressErrors, TensionFit, TensionPoint, fit_tension_with, no_fit};
use crate::rubber_over_time::{Bar, Result, TimePoint, fit_prony};
use mckibben::progress::Progress;
use mckibben::rubber::Law;
use mckibben::rubber::over_time::Prony;

/// Strain that tells a move from a hold.
const MOVE: f64 = 1e-3;

type Found = Result<(TensionFit, Law, RubberFitResult)>;

impl RubberCaseFit {
    /// The law that it finds: held stable where the free one is not.
    fn law(&self, points: &[TensionPoint], settings: FitSettings, progress: &dyn Progress) -> Found {
        let found = fit_tension_with(points, &settings, progress)?;
        let taken = found.recommended.or(Some(0)).and_then(|i| found.laws.get(i)).cloned();
        let Some(taken) = taken else {
            let none = || no_fit(self.form, "no law was left");
            return Err(found.failed.into_iter().next().unwrap_or_else(none).into());
        };
        let (stable, parameters) = (taken.quality.stable, taken.parameters);
        Ok((found, taken.law, RubberFitResult { stable, parameters, ..RubberFitResult::default() }))
    }

    fn settings(&self) -> FitSettings {
        let (forms, fit_modes) = (vec![self.form], self.modes.clone());
        FitSettings { forms, fit_modes, up_to_stretch: self.up_to_stretch, ..FitSettings::default() }
    }
}

pub(super) fn tests(
    fit: &RubberCaseFit,
    points: &[TensionPoint],
    progress: &dyn Progress,
) -> Result<RubberFitResult> {
    let (found, law, result) = fit.law(points, fit.settings(), progress)?;
    let whole = FitSettings { up_to_stretch: None, ..fit.settings() };
    // What lies behind a rupture is left out of both.
    let beyond = match fit.up_to_stretch {
        Some(end) => {
            let all = fit_tension_with(points, &whole, progress)?;
            let further = |p: &TensionPoint| p.stretch.max(p.across) > end;
            all.points.into_iter().chain(all.held_out).filter(further).collect()
        }
        None => vec![],
    };
    let of = |list: &[TensionPoint], blind: bool, name: &dyn Fn(Mode) -> String| -> Vec<RubberGroup> {
        let of_mode = |mode: Mode| {
            let own = list.iter().filter(|p| p.mode == mode);
            let pairs = own.map(|p| (p.stretch.max(p.across), p.nominal_stress_mpa, p.stress_mpa(&law)));
            RubberGroup { of: name(mode), blind, errors: StressErrors::of(pairs) }
        };
        Mode::ALL.into_iter().map(of_mode).filter(|g| g.errors.points > 0).collect()
    };
    let plain = |mode: Mode| mode.name().to_owned();
    let further = |mode: Mode| format!("{}, further", mode.name());
    let groups =
        [of(&found.points, false, &plain), of(&found.held_out, true, &plain), of(&beyond, true, &further)];
    Ok(RubberFitResult { groups: groups.concat(), ..result })
}

pub(super) fn history(
    fit: &RubberCaseFit,
    points: &[TimePoint],
    progress: &dyn Progress,
) -> Result<RubberFitResult> {
    let list: Vec<TensionPoint> = points.iter().map(TimePoint::tension).collect();
    let elastic = FitSettings { history: true, ..fit.settings() };
    let (_, mut law, mut result) = fit.law(&list, elastic, progress)?;
    let mut prony = Prony::default();
    if let Some(branches) = fit.relaxation {
        let found = fit_prony(points, fit.form, branches)?;
        let constants = found.instantaneous.constants();
        for (parameter, constant) in result.parameters.iter_mut().zip(constants) {
            (parameter.value, parameter.standard_error) = (constant.value, None);
        }
        (law, prony) = (found.instantaneous.clone(), found.prony());
        result.prony = prony.branches.iter().map(|b| (b.share, b.time_constant_s)).collect();
    }
    let computed = Bar::new(&law, None, &prony).over(points)?;
    let mut before = 1.0;
    let mut branch = vec![];
    for p in points {
        let step = p.stretch - before;
        before = p.stretch;
        branch.push(if step > MOVE {
            "loading"
        } else if step < -MOVE {
            "unloading"
        } else {
            "held"
        });
    }
    let groups = ["loading", "unloading", "held"].map(|name| {
        let own = points.iter().zip(&computed).zip(&branch).filter(|p| *p.1 == name);
        let errors = StressErrors::of(own.map(|((p, c), _)| (p.stretch, p.nominal_stress_mpa, *c)));
        RubberGroup { of: name.into(), blind: false, errors }
    });
    Ok(RubberFitResult { groups: groups.into_iter().filter(|g| g.errors.points > 0).collect(), ..result })
}
