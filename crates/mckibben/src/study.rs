//! The paper's thickness study (its section 3.1 and Figure 4), with any model.
//!
//! Prototype (D0 30, L0 285, θ0 28°) with walls of 1 to 5 mm: isometric at ΔL = 0, 20 and 40 mm,
//! isotonic at 20, 80 and 150 N, beside the ideal formulas (1) and (4) with D0 = 24 mm (the
//! prototype's bore, as the paper drew them) and with D0 = 30 mm. The paper's findings are computed
//! from the curves, each with a verdict; they do not all hold.

use crate::{
    analysis::{AnalysisError, Evaluation, Options},
    curve::{Curve, Test},
    model::{ForceModel, Ideal, ModelError, Workspace},
    muscle::{Direction, Muscle, MuscleError, Tube},
};
use serde::Serialize;
use thiserror::Error;

/// Walls in mm.
pub const WALLS_MM: [f64; 5] = [1.0, 2.0, 3.0, 4.0, 5.0];
/// Shortenings of the isometric tests in mm.
pub const SHORTENINGS_MM: [f64; 3] = [0.0, 20.0, 40.0];
/// Pulls of the isotonic tests in N.
pub const PULLS_N: [f64; 3] = [20.0, 80.0, 150.0];
const HIGHEST_MPA: f64 = 0.25;

/// A labelled curve of the study.
#[derive(Debug, Clone)]
pub struct StudyCurve {
    /// `s = 1 mm`, `(1) with D0 = 24 mm`, …
    pub label: String,
    /// Wall in mm for curves of the model; `None` for the ideal formulas.
    pub wall_mm: Option<f64>,
    /// The curve.
    pub curve: Curve,
}

/// One panel: one shortening or one pull.
#[derive(Debug, Clone)]
pub struct StudyPanel {
    /// Isometric or isotonic.
    pub test: Test,
    /// ΔL in mm or F in N.
    pub fixed: f64,
    /// The model with each wall, then the ideal formulas.
    pub curves: Vec<StudyCurve>,
}

/// One of the paper's statements beside what this model says.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "FindingAnswer")]
pub struct Finding {
    /// What the paper reports.
    pub statement: &'static str,
    /// What came out here.
    pub ours: String,
    /// Whether it holds.
    pub holds: bool,
}

/// The study.
#[derive(Debug, Clone)]
pub struct Study {
    /// The model's name.
    pub model: String,
    /// Six panels.
    pub panels: Vec<StudyPanel>,
    /// The paper's findings, each with a verdict.
    pub findings: Vec<Finding>,
}

/// Why the study cannot be made.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum StudyError {
    /// A muscle of the study is none.
    #[error(transparent)]
    Muscle(#[from] MuscleError),
    /// The model refuses one of the muscles.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A question of the findings has no answer.
    #[error(transparent)]
    Analysis(#[from] AnalysisError),
}

/// Makes the study on `base` (its rubber and braid) with the model that `build` makes.
///
/// # Errors
/// [`StudyError`] where the model does not take the muscles at all; single points without answer
/// stay in the curves.
pub fn thickness<B>(base: &Muscle, options: Options, build: B) -> Result<Study, StudyError>
where
    B: Fn(&Muscle) -> Result<Box<dyn ForceModel>, ModelError>,
{
    let with = |d0: f64, s: f64| {
        base.with_tube(Tube {
            outer_diameter_mm: d0,
            wall_mm: s,
            length_mm: 285.0,
            ..base.tube().clone()
        })
    };
    let models: Vec<Box<dyn ForceModel>> = WALLS_MM
        .iter()
        .map(|&s| Ok(build(&with(30.0, s)?)?))
        .collect::<Result<_, StudyError>>()?;
    let mut workspaces: Vec<Workspace> = models.iter().map(|_| Workspace::new()).collect();
    let ideals = [24.0, 30.0].map(|d0| with(d0, 1.0).map(|m| (d0, Ideal::new(&m))));
    let ideals: Vec<(f64, Ideal)> = ideals.into_iter().collect::<Result<_, _>>()?;
    let pressures: Vec<f64> = (0..=25).map(|i| f64::from(i) / 100.0).collect();
    let mut panels = vec![];
    let tests = SHORTENINGS_MM
        .map(|x| (Test::Isometric, x))
        .into_iter()
        .chain(PULLS_N.map(|x| (Test::Isotonic, x)));
    for (test, fixed) in tests {
        let value = if test == Test::Isometric {
            fixed / 285.0
        } else {
            fixed
        };
        let mut list = vec![];
        for ((model, workspace), wall) in models.iter().zip(&mut workspaces).zip(WALLS_MM) {
            let mut model = Evaluation::new(model.as_ref(), workspace, options);
            for curve in model.curves(test, &[value], &pressures) {
                list.push(StudyCurve {
                    label: format!("s = {wall} mm"),
                    wall_mm: Some(wall),
                    curve,
                });
            }
        }
        let equation = if test == Test::Isometric {
            "(1)"
        } else {
            "(4)"
        };
        for (d0, ideal) in &ideals {
            let workspace = &mut Workspace::new();
            for curve in
                Evaluation::new(ideal, workspace, options).curves(test, &[value], &pressures)
            {
                let label = format!("{equation} with D0 = {d0} mm");
                list.push(StudyCurve {
                    label,
                    wall_mm: None,
                    curve,
                });
            }
        }
        panels.push(StudyPanel {
            test,
            fixed,
            curves: list,
        });
    }
    let findings = findings(&models, &mut workspaces, &ideals, options.direction)?;
    Ok(Study {
        model: models[0].info().name.to_string(),
        panels,
        findings,
    })
}

fn findings(
    models: &[Box<dyn ForceModel>],
    workspaces: &mut [Workspace],
    ideals: &[(f64, Ideal)],
    direction: Direction,
) -> Result<Vec<Finding>, StudyError> {
    let options = Options {
        extrapolate: true,
        direction,
        ..Options::default()
    };
    let contractions = SHORTENINGS_MM.map(|x| x / 285.0);
    let mut each = |ask: &dyn Fn(&mut Evaluation<'_>) -> Result<f64, AnalysisError>| {
        let muscles = models.iter().zip(&mut *workspaces);
        muscles
            .map(|(m, w)| ask(&mut Evaluation::new(&**m, w, options)))
            .collect::<Result<Vec<f64>, _>>()
    };
    let at_contractions = contractions
        .iter()
        .map(|&e| each(&|m| Ok(m.force_n(HIGHEST_MPA, e)?.max(0.0))));
    let forces = at_contractions.collect::<Result<Vec<_>, _>>()?;
    let loss: Vec<f64> = forces.iter().map(|f| f[0] - f[4]).collect();
    let largest = loss.iter().copied().fold(0.0, f64::max);
    let falling = forces.iter().all(|f| f.windows(2).all(|w| w[0] >= w[1]));
    let shortened = contractions[1..]
        .iter()
        .map(|&e| each(&|m| m.start_pressure_mpa(e)));
    let starts = shortened.collect::<Result<Vec<_>, _>>()?;
    let rise: Vec<f64> = starts.iter().map(|s| s[4] - s[0]).collect();
    let rising = starts.iter().all(|s| s.windows(2).all(|w| w[0] <= w[1]));
    let ideal = |i: usize, e: f64| ideals[i].1.pull(HIGHEST_MPA, e);
    let at = |i: usize| {
        contractions
            .map(|e| format!("{:.0}", ideal(i, e)))
            .join(" / ")
    };
    let thinnest = forces
        .iter()
        .map(|f| format!("{:.0}", f[0]))
        .collect::<Vec<_>>()
        .join(" / ");
    let steepest = |i: usize| (0..3).all(|j| ideal(i, contractions[j]) >= forces[j][0]);
    let mut isotonic_falls = true;
    let mut shorter = true;
    for &f in &PULLS_N {
        let list = each(&|m| m.contraction_at(f, HIGHEST_MPA))?;
        isotonic_falls &= list.windows(2).all(|w| w[0] >= w[1]);
        let ideal = Evaluation::new(&ideals[0].1, &mut Workspace::new(), options)
            .contraction_at(f, HIGHEST_MPA);
        shorter &= ideal? >= list[0];
    }
    let word = |holds: bool, yes: &'static str, no: &'static str| if holds { yes } else { no };
    let finding = |statement, holds, ours| Finding {
        statement,
        ours,
        holds,
    };
    let falls = word(falling, "falls with s", "does not always fall with s");
    let rises = word(rising, "rises", "does not always rise");
    let contracts = word(
        isotonic_falls,
        "contracts less",
        "does not always contract less",
    );
    let more = word(shorter, "more", "not always more");
    Ok(vec![
        finding(
            "a thicker wall gives less force at the same pressure and shortening",
            falling,
            format!("{falls} at .25\u{a0}MPa for every shortening"),
        ),
        finding(
            "the loss from s = 1 to 5 mm reaches about 300 N",
            (250.0..=350.0).contains(&largest),
            format!(
                "at most {largest:.0} N (ΔL 0/20/40: {:.0}/{:.0}/{:.0} N)",
                loss[0], loss[1], loss[2]
            ),
        ),
        finding(
            "for ΔL > 0 the pressure P′ at which force starts rises with s",
            rising,
            format!("{rises} at 20 and 40 mm"),
        ),
        finding(
            "P′ rises by up to about 0.07\u{a0}MPa from s = 1 to 5 mm",
            (0.06..=0.08).contains(&rise[0].max(rise[1])),
            format!(
                "{:.3}\u{a0}MPa at 20 mm, {:.3}\u{a0}MPa at 40 mm",
                rise[0], rise[1]
            ),
        ),
        finding(
            "the curves of (1) with D0 = 24 mm are the steepest",
            steepest(0),
            format!(
                "(1) gives {} N, the model with s = 1 {thinnest} N at ΔL 0/20/40",
                at(0)
            ),
        ),
        finding(
            "the same with the outer diameter, D0 = 30 mm (not in the paper)",
            steepest(1),
            format!("(1) gives {} N", at(1)),
        ),
        finding(
            "isotonic: a thicker wall contracts less at the same pressure",
            isotonic_falls,
            format!("{contracts} at 20, 80 and 150 N"),
        ),
        finding(
            "isotonic: (4) with D0 = 24 mm contracts more than the model",
            shorter,
            format!("{more} than s = 1 at .25\u{a0}MPa"),
        ),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::ThickWall;

    /// (1) with D0 = 30 at .25 MPa: 1073 / 819 / 584 N; with D0 = 24: 687 N at ΔL = 0.
    #[test]
    fn ideal_figures_of_the_study() {
        let build = |m: &Muscle| Ok(Box::new(ThickWall::new(m)) as Box<dyn ForceModel>);
        let study = thickness(&Muscle::prototype(), Options::default(), build).unwrap();
        assert_eq!(study.panels.len(), 6);
        let force = |panel: usize, curve: usize| {
            let curve = &study.panels[panel].curves[curve].curve;
            curve
                .points
                .last()
                .unwrap()
                .answer
                .as_ref()
                .unwrap()
                .response
                .force_n
        };
        for (panel, expected) in [(0, 1073.0), (1, 819.0), (2, 584.0)] {
            assert!(
                (force(panel, 6) - expected).abs() < 0.5,
                "{}",
                force(panel, 6)
            );
        }
        assert!((force(0, 5) - 687.0).abs() < 0.5);
        // The rubber of the wall can only take from the pull of a rigid braid.
        assert!(study.findings[0].holds && study.findings[2].holds && study.findings[5].holds);
        assert!(!study.findings[4].holds);
    }
}
