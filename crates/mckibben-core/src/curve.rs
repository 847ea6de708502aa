//! The three tests of a muscle (isometric, isotonic, isobaric) as families of curves.
//!
//! - isometric: ε fixed, F(P);
//! - isotonic: F fixed, ε(P);
//! - isobaric: P fixed, F(ε).

use crate::{
    analysis::{AnalysisError, Evaluation},
    answer::Answer,
    cancel,
};
use serde::{Deserialize, Serialize};

/// Which test.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "kebab-case")]
pub enum Test {
    /// ε fixed, F over P.
    Isometric,
    /// F fixed, ε over P.
    Isotonic,
    /// P fixed, F over ε.
    #[default]
    Isobaric,
}

mckibben_units::display_as_serde_word!(Test);

/// One point of a curve: the question, and the answer or why there is none.
#[derive(Debug, Clone)]
pub struct CurvePoint {
    /// Pressure in MPa.
    pub pressure_mpa: f64,
    /// Given contraction (isometric, isobaric).
    pub contraction: Option<f64>,
    /// Given pull in N (isotonic).
    pub force_n: Option<f64>,
    /// The answer.
    pub answer: Result<Answer, AnalysisError>,
}

/// One curve of a family.
#[derive(Debug, Clone)]
pub struct Curve {
    /// What is fixed along it: ε, F in N, or P in MPa.
    pub fixed: f64,
    /// Its points in the given order.
    pub points: Vec<CurvePoint>,
}

impl Evaluation<'_> {
    /// A family of curves: `fixed` holds ε, F or P of each curve, `along` the P or ε of its points.
    ///
    /// Points without an answer carry their reason; the others keep theirs.
    pub fn curves(&mut self, test: Test, fixed: &[f64], along: &[f64]) -> Vec<Curve> {
        let curve = |&fixed: &f64| {
            // Along an isobaric curve it is sought once how the muscle hangs, at the first slack
            // point.
            let mut hanging = None;
            let mut one = |&x: &f64| {
                let open = cancel::check().map_err(AnalysisError::from);
                if test == Test::Isotonic {
                    return CurvePoint {
                        pressure_mpa: x,
                        contraction: None,
                        force_n: Some(fixed),
                        answer: open.and_then(|()| self.contraction_point(fixed, x)),
                    };
                }
                if test == Test::Isometric {
                    hanging = None;
                }
                let (p, e) = if test == Test::Isobaric {
                    (fixed, x)
                } else {
                    (x, fixed)
                };
                CurvePoint {
                    pressure_mpa: p,
                    contraction: Some(e),
                    force_n: None,
                    answer: open.and_then(|()| Ok(self.point_beyond(p, e, &mut hanging)?)),
                }
            };
            Curve {
                fixed,
                points: along.iter().map(&mut one).collect(),
            }
        };
        fixed.iter().map(curve).collect()
    }
}

impl Curve {
    /// (P, F), (P, ε) or (ε, F) of the answered points, to be drawn.
    ///
    /// A line breaks (NaN) where there is no answer. Where the muscle becomes slack the line ends
    /// on zero, at the place that a straight line between the two neighbours gives.
    pub fn line(&self, test: Test) -> Vec<(f64, f64)> {
        let mut out: Vec<(f64, f64)> = Vec::with_capacity(self.points.len() + 2);
        let mut before: Option<(f64, f64)> = None;
        for p in &self.points {
            let x = if test == Test::Isobaric {
                p.contraction.unwrap_or(f64::NAN)
            } else {
                p.pressure_mpa
            };
            let Ok(a) = &p.answer else {
                out.push((x, f64::NAN));
                before = None;
                continue;
            };
            if test == Test::Isotonic {
                out.push((x, a.response.contraction));
                continue;
            }
            let y = if a.slack {
                a.two_sided_force_n
            } else {
                a.response.force_n
            };
            if let Some((x0, y0)) = before
                && (a.slack || y0 < 0.0)
                && (y0 < 0.0) != (y < 0.0)
            {
                out.push((x0 + (x - x0) * y0 / (y0 - y), 0.0));
            } else if let (Test::Isobaric, Some(free)) = (test, a.free_contraction)
                && before.is_some_and(|(x0, y0)| x0 < free && y0 > 0.0)
            {
                out.push((free, 0.0));
            }
            out.push((x, if a.slack { f64::NAN } else { y }));
            before = Some((x, y));
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        analysis::Options,
        model::{ForceModel, ThickWall, Workspace},
        muscle::Muscle,
    };

    /// The drawn line of a slack muscle starts on zero between the two pressures around P′.
    #[test]
    fn a_line_starts_on_zero_at_the_dead_pressure() {
        let model = ThickWall::between_ends(&Muscle::prototype());
        let pressures: Vec<f64> = (0..=250).map(|i| f64::from(i) / 1000.0).collect();
        let family = Evaluation::new(&model, &mut Workspace::new(), Options::default()).curves(
            Test::Isometric,
            &[0.15],
            &pressures,
        );
        let line = family[0].line(Test::Isometric);
        let start = line.iter().find(|p| p.1 == 0.0).unwrap().0;
        let dead = Evaluation::new(&model, &mut Workspace::new(), Options::default())
            .start_pressure_mpa(0.15)
            .unwrap();
        assert!((start - dead).abs() < 1e-5, "{start} {dead}");
        assert!(
            model
                .force_n(&mut Workspace::new(), start, 0.15)
                .unwrap()
                .abs()
                < 0.05
        );
        assert!(line.iter().all(|p| p.1.is_nan() || p.1 >= 0.0));
    }
}
