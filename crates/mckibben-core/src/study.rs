//! The paper's thickness study (its section 3.1 and Figure 4), with any model.
//!
//! Prototype (D0 30, L0 285, θ0 28°) with walls of 1 to 5 mm: isometric at ΔL = 0, 20 and 40 mm,
//! isotonic at 20, 80 and 150 N, beside the ideal formulas (1) and (4) with D0 = 24 mm (the
//! prototype's bore, as the paper drew them) and with D0 = 30 mm. The paper's findings are computed
//! from the curves, each with a verdict; they do not all hold.

use crate::{
    analysis::{AnalysisError, Evaluation, Options},
    curve::{Curve, Test},
    extremes::peak,
    joined,
    model::{ForceModel, Ideal, ModelError, Workspace},
    muscle::{Muscle, MuscleError, Tube},
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
    let mut walls: Vec<Wall> = WALLS_MM
        .iter()
        .map(|&s| Ok((build(&with(30.0, s)?)?, Workspace::new())))
        .collect::<Result<_, StudyError>>()?;
    let ideals: Vec<(f64, Ideal)> = [24.0, 30.0]
        .map(|d0| with(d0, 1.0).map(|m| (d0, Ideal::between_ends(&m))))
        .into_iter()
        .collect::<Result<_, _>>()?;
    let pressures: Vec<f64> = (0..=25).map(|i| f64::from(i) / 100.0).collect();
    let mut panels = vec![];
    let tests = SHORTENINGS_MM
        .map(|x| (Test::Isometric, x))
        .into_iter()
        .chain(PULLS_N.map(|x| (Test::Isotonic, x)));
    for (test, fixed) in tests {
        let (value, equation) = if test == Test::Isometric {
            (fixed / 285.0, "(1)")
        } else {
            (fixed, "(4)")
        };
        let mut curves = vec![];
        let mut draw =
            |model: &dyn ForceModel, workspace: &mut Workspace, label: String, wall_mm| {
                let drawn =
                    Evaluation::new(model, workspace, options).curves(test, &[value], &pressures);
                curves.extend(drawn.into_iter().map(|curve| StudyCurve {
                    label: label.clone(),
                    wall_mm,
                    curve,
                }));
            };
        for ((model, workspace), wall) in walls.iter_mut().zip(WALLS_MM) {
            draw(&**model, workspace, format!("s = {wall} mm"), Some(wall));
        }
        for (d0, ideal) in &ideals {
            let label = format!("{equation} with D0 = {d0} mm");
            draw(ideal, &mut Workspace::new(), label, None);
        }
        panels.push(StudyPanel {
            test,
            fixed,
            curves,
        });
    }
    let options = Options {
        extrapolate: true,
        ..options.direction.into()
    };
    let mut findings = isometric(&mut walls, &ideals, options)?;
    findings.extend([
        isotonic(
            &panels,
            "isotonic: a thicker wall contracts less at the same pressure",
            "with each thicker wall that contracts",
            &[0, 1, 2, 3, 4],
        ),
        isotonic(
            &panels,
            "isotonic: (4) with D0 = 24 mm contracts more than the model",
            "more than s = 1 where both contract, without the paper's shift of (4)",
            &[WALLS_MM.len(), 0],
        ),
    ]);
    Ok(Study {
        model: walls[0].0.info().name.to_string(),
        panels,
        findings,
    })
}

/// The model with a wall, and its workspace.
type Wall = (Box<dyn ForceModel>, Workspace);

/// For each value the answers with all walls.
fn answers(
    walls: &mut [Wall],
    options: Options,
    values: &[f64],
    ask: impl Fn(&mut Evaluation<'_>, f64) -> Result<f64, AnalysisError>,
) -> Result<Vec<Vec<f64>>, AnalysisError> {
    let of_walls = |&value: &f64| {
        walls
            .iter_mut()
            .map(|(m, w)| ask(&mut Evaluation::new(&**m, w, options), value))
            .collect()
    };
    values.iter().map(of_walls).collect()
}

/// Whether no wall has more than a thinner one.
fn falls(answers: &[Vec<f64>]) -> bool {
    answers
        .iter()
        .all(|of_walls| of_walls.is_sorted_by(|a, b| a >= b))
}

fn either(holds: bool, yes: &'static str, no: &'static str) -> &'static str {
    if holds { yes } else { no }
}

/// Up to which pressure, and from which one, no curve of a row contracts more than the one before
/// it. Where a muscle is stretched, or the model has no answer, there is nothing to compare.
fn isotonic(panels: &[StudyPanel], statement: &'static str, text: &str, row: &[usize]) -> Finding {
    let mut holds = true;
    let mut parts = vec![];
    for StudyPanel { fixed, curves, .. } in panels.iter().filter(|p| p.test == Test::Isotonic) {
        let mut pressures = vec![];
        for (i, point) in curves[0].curve.points.iter().enumerate() {
            let contraction = |&curve: &usize| {
                let answer = curves[curve].curve.points[i].answer.as_ref().ok()?;
                Some(answer.response.contraction).filter(|e| *e > 0.0)
            };
            let compared: Vec<f64> = row.iter().filter_map(contraction).collect();
            if compared.len() < 2 {
                continue;
            }
            if falls(&[compared]) {
                pressures.push(point.pressure_mpa);
            } else {
                holds = false;
                pressures.clear();
            }
        }
        parts.push(match pressures[..] {
            [from, .., to] => format!("{fixed} N from {from}\u{a0}MPa to {to}\u{a0}MPa"),
            _ => format!("{fixed} N nowhere"),
        });
    }
    Finding {
        statement,
        holds,
        ours: format!("{text}: {}", joined(parts, ", ")),
    }
}

fn isometric(
    walls: &mut [Wall],
    ideals: &[(f64, Ideal)],
    options: Options,
) -> Result<Vec<Finding>, AnalysisError> {
    let contractions = SHORTENINGS_MM.map(|x| x / 285.0);
    let forces = answers(walls, options, &contractions, |m, e| {
        Ok(m.force_n(HIGHEST_MPA, e)?.max(0.0))
    })?;
    let loss: Vec<f64> = forces.iter().map(|f| f[0] - f[4]).collect();
    let largest = peak(loss.iter().copied());
    let starts = answers(walls, options, &contractions[1..], |m, e| {
        m.start_pressure_mpa(e)
    })?;
    let rise: Vec<f64> = starts.iter().map(|s| s[4] - s[0]).collect();
    let falling = falls(&forces);
    let rising = starts.iter().all(|of_walls| of_walls.is_sorted());
    let joined = |forces: Vec<f64>| joined(forces.iter().map(|f| format!("{f:.0}")), " / ");
    let thinnest: Vec<f64> = forces.iter().map(|f| f[0]).collect();
    let bore = contractions.map(|e| ideals[0].1.pull(HIGHEST_MPA, e));
    let finding = |statement, holds, ours| Finding {
        statement,
        ours,
        holds,
    };
    Ok(vec![
        finding(
            "a thicker wall gives less force at the same pressure and shortening",
            falling,
            format!(
                "{} with s at .25\u{a0}MPa for every shortening",
                either(falling, "falls", "does not always fall")
            ),
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
            format!(
                "{} at 20 and 40 mm",
                either(rising, "rises", "does not always rise")
            ),
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
            bore.iter().zip(&thinnest).all(|(ideal, f)| ideal >= f),
            format!(
                "(1) gives {} N, the model with s = 1 {} N at ΔL 0/20/40",
                joined(bore.to_vec()),
                joined(thinnest)
            ),
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
        let build = |m: &Muscle| Ok(Box::new(ThickWall::between_ends(m)) as Box<dyn ForceModel>);
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
        assert!(study.findings[0].holds && study.findings[2].holds);
        assert!(!study.findings[4].holds);
        // By hand at 150 N: (4) with D0 = 24 gives 13.97 % at 0.10 MPa and 25.67 % at 0.25 MPa, the
        // model with s = 1 more.
        let (sin, cos) = 28f64.to_radians().sin_cos();
        for (point, pressure_mpa) in [(10, 0.1), (25, 0.25)] {
            let [ours, ideal] = [0, 5].map(|curve| {
                let answer = study.panels[5].curves[curve].curve.points[point]
                    .answer
                    .as_ref();
                answer.unwrap().response.contraction
            });
            let stretch = 4.0 * sin * sin / (std::f64::consts::PI * 576.0) * 150.0 / pressure_mpa;
            let by_hand = 1.0 - ((1.0 + stretch) / (3.0 * cos * cos)).sqrt();
            assert!(
                (ideal - by_hand).abs() < 1e-9 && ideal < ours,
                "{ideal} {ours}"
            );
        }
        let Finding { holds, ours, .. } = &study.findings[6];
        assert!(!holds && ours.contains("150 N nowhere"), "{ours}");
        assert!(study.findings[5].holds, "{}", study.findings[5].ours);
    }

    /// Formula (11) ends at a contraction of 0.20: of 20 N it says nothing at 0.25 MPa.
    #[test]
    fn findings_are_of_the_points_that_have_an_answer() {
        let build = |m: &Muscle| crate::model::ModelKind::Paper.build(m);
        let study = thickness(&Muscle::prototype(), Options::default(), build).unwrap();
        let thin = &study.panels[3].curves[0].curve.points;
        let last = thin.iter().rfind(|p| p.answer.is_ok()).unwrap();
        assert!(last.pressure_mpa < 0.1);
        let said = format!("20 N from 0.01\u{a0}MPa to {}\u{a0}MPa", last.pressure_mpa);
        assert!(
            study.findings[6].ours.contains(&said),
            "{}",
            study.findings[6].ours
        );
    }
}
