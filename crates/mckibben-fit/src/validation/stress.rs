//! A law fitted to measured stresses, and its errors there.

use super::{
    case::RubberCaseFit,
    rubber::{RubberFit, RubberGroup},
};
use crate::{
    rubber::{
        FitSettings, FittedLaw, Mode, StressErrors, TensionFit, TensionPoint, fit_tension_with,
        no_fit,
    },
    rubber_over_time::{Bar, Result, TimePoint, fit_prony},
};
use mckibben_core::{progress::Progress, rubber::over_time::Prony};

/// Strain that tells a move from a hold.
const MOVE: f64 = 1e-3;

impl RubberCaseFit {
    /// The recommended law of a fit: held stable where the free one is not.
    fn law(&self, fit: &TensionFit) -> Result<FittedLaw> {
        let law = fit
            .recommended
            .or(Some(0))
            .and_then(|i| fit.laws.get(i))
            .cloned();
        let failed = || {
            fit.failed
                .first()
                .cloned()
                .unwrap_or_else(|| no_fit(self.form, "no law was left"))
        };
        law.ok_or_else(|| failed().into())
    }

    fn settings(&self) -> FitSettings {
        FitSettings {
            forms: vec![self.form],
            fit_modes: self.modes.clone(),
            up_to_stretch: self.up_to_stretch,
            ..FitSettings::default()
        }
    }

    /// Fits the law to tests without time.
    pub(super) fn to_tests(
        &self,
        points: &[TensionPoint],
        progress: &dyn Progress,
    ) -> Result<RubberFit> {
        let fit = fit_tension_with(points, &self.settings(), progress)?;
        let fitted = self.law(&fit)?;
        let whole = FitSettings {
            up_to_stretch: None,
            ..self.settings()
        };
        // Points behind a rupture are in neither.
        let beyond = match self.up_to_stretch {
            Some(end) => {
                let all = fit_tension_with(points, &whole, progress)?;
                let further = |p: &TensionPoint| p.stretch.max(p.across) > end;
                all.points
                    .into_iter()
                    .chain(all.held_out)
                    .filter(further)
                    .collect()
            }
            None => vec![],
        };
        let mut groups = vec![];
        for (list, blind, further) in [
            (&fit.points, false, ""),
            (&fit.held_out, true, ""),
            (&beyond, true, ", further"),
        ] {
            groups.extend(Mode::ALL.map(|mode| {
                let points = list.iter().filter(|p| p.mode == mode);
                RubberGroup {
                    of: format!("{mode}{further}"),
                    blind,
                    errors: StressErrors::for_law(&fitted.law, points),
                }
            }));
        }
        groups.retain(|g| g.errors.points > 0);
        Ok(RubberFit {
            stable: fitted.quality.stable,
            parameters: fitted.parameters,
            groups,
            ..RubberFit::default()
        })
    }

    /// Fits the law to a test over time, with a Prony series if it is wanted.
    pub(super) fn to_history(
        &self,
        points: &[TimePoint],
        progress: &dyn Progress,
    ) -> Result<RubberFit> {
        let list: Vec<TensionPoint> = points.iter().map(TimePoint::tension).collect();
        let elastic = FitSettings {
            history: true,
            ..self.settings()
        };
        let fit = fit_tension_with(&list, &elastic, progress)?;
        let FittedLaw {
            mut law,
            quality,
            mut parameters,
            ..
        } = self.law(&fit)?;
        let mut prony = Prony::default();
        if let Some(branches) = self.relaxation {
            let fit = fit_prony(points, self.form, branches)?;
            for (parameter, constant) in parameters.iter_mut().zip(fit.instantaneous.constants()) {
                (parameter.value, parameter.standard_error) = (constant.value, None);
            }
            prony = fit.prony();
            law = fit.instantaneous;
        }
        let computed = Bar::new(&law, None, &prony).over(points)?;
        let before = std::iter::once(1.0).chain(points.iter().map(|p| p.stretch));
        let branch = |step: f64| match step {
            s if s > MOVE => "loading",
            s if s < -MOVE => "unloading",
            _ => "held",
        };
        let branches: Vec<&str> = points
            .iter()
            .zip(before)
            .map(|(p, b)| branch(p.stretch - b))
            .collect();
        let group = |name: &str| {
            let points = points
                .iter()
                .zip(&computed)
                .zip(&branches)
                .filter(|p| *p.1 == name);
            let stresses =
                points.map(|((p, computed), _)| (p.stretch, p.nominal_stress_mpa, *computed));
            RubberGroup {
                of: name.into(),
                blind: false,
                errors: StressErrors::new(stresses),
            }
        };
        let mut groups = ["loading", "unloading", "held"].map(group).to_vec();
        groups.retain(|g| g.errors.points > 0);
        let prony = prony
            .branches
            .iter()
            .map(|b| (b.share, b.time_constant_s))
            .collect();
        Ok(RubberFit {
            stable: quality.stable,
            parameters,
            prony,
            groups,
            ..RubberFit::default()
        })
    }
}
