//! The errors of each law of a measured rubber, at the stresses it was fitted to and at those it
//! predicts.

use crate::{
    Result,
    case::{Points, RubberCase, RubberFit},
};
use mckibben_core::rubber::over_time::Prony;
use mckibben_fit::{
    rubber::{
        FitSettings, FittedLaw, Mode, Parameter, StressErrors, TensionFit, TensionPoint,
        fit_tension,
    },
    rubber_over_time::{Bar, TimePoint, fit_prony},
};

/// A law that was fitted, with its constants and errors.
#[derive(Debug, Default)]
pub struct FittedRubber {
    pub fit: String,
    /// Its constants, with a Prony series those at once.
    pub parameters: Vec<Parameter>,
    /// The Prony series, where one was fitted.
    pub prony: Prony,
    /// Whether the law is stable in a muscle.
    pub stable: bool,
    /// Errors, group by group: fitted points before those that are predicted.
    pub groups: Vec<RubberGroup>,
}

/// Errors at some nominal stresses: measured less computed.
#[derive(Debug, Clone)]
pub struct RubberGroup {
    /// A mode, a mode `further` than the law was fitted, or a branch of a test over time.
    pub of: String,
    /// Whether nothing was fitted to them.
    pub blind: bool,
    pub errors: StressErrors,
}

/// Every fit of a rubber.
pub fn report(case: &RubberCase) -> Result<Vec<FittedRubber>> {
    let one = |fit: &RubberFit| {
        let result = match &case.points {
            Points::Tests(points) => fit.to_tests(points),
            Points::History(points) => fit.to_history(points),
        };
        let fitted = result.map_err(|e| format!("{}, fit \"{}\": {e}", case.name, fit.name))?;
        Ok(FittedRubber {
            fit: fit.name.clone(),
            ..fitted
        })
    };
    case.fits.iter().map(one).collect()
}

/// Strain that tells a move from a hold.
const MOVE: f64 = 1e-3;

impl RubberFit {
    /// The recommended law of a fit: held stable where the free one is not.
    fn law(&self, fit: &TensionFit) -> Result<FittedLaw> {
        let place = fit.recommended.unwrap_or(0);
        let law = fit.laws.get(place).cloned();
        law.ok_or_else(|| match fit.failed.first() {
            Some(failed) => failed.to_string().into(),
            None => "no law was left".into(),
        })
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
    fn to_tests(&self, points: &[TensionPoint]) -> Result<FittedRubber> {
        let fit = fit_tension(points, &self.settings())?;
        let fitted = self.law(&fit)?;
        let whole = FitSettings {
            up_to_stretch: None,
            ..self.settings()
        };
        // Points behind a rupture are in neither.
        let beyond = match self.up_to_stretch {
            Some(end) => {
                let all = fit_tension(points, &whole)?;
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
        Ok(FittedRubber {
            stable: fitted.quality.stable,
            parameters: fitted.parameters,
            groups,
            ..FittedRubber::default()
        })
    }

    /// Fits the law to a test over time, with a Prony series if it is wanted.
    fn to_history(&self, points: &[TimePoint]) -> Result<FittedRubber> {
        let list: Vec<TensionPoint> = points.iter().map(TimePoint::tension).collect();
        let elastic = FitSettings {
            history: true,
            ..self.settings()
        };
        let fit = fit_tension(&list, &elastic)?;
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
        Ok(FittedRubber {
            stable: quality.stable,
            parameters,
            prony,
            groups,
            ..FittedRubber::default()
        })
    }
}
