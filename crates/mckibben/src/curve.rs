//! The three tests a muscle is put to, as families of curves.
//!
//! - isometric: ε fixed, F(P);
//! - isotonic: F fixed, ε(P);
//! - isobaric: P fixed, F(ε).

use crate::analysis::AnalysisError;
use crate::answer::{self, Answer, Options};
use crate::model::ForceModel;

/// Which test.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Test {
    /// ε fixed, F over P.
    Isometric,
    /// F fixed, ε over P.
    Isotonic,
    /// P fixed, F over ε.
    Isobaric,
}

impl Test {
    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            Test::Isometric => "isometric",
            Test::Isotonic => "isotonic",
            Test::Isobaric => "isobaric",
        }
    }
}

/// One point of a curve: what was asked, and the answer or why there is none.
#[derive(Debug, Clone)]
pub struct CurvePoint {
    /// Pressure in MPa.
    pub pressure_mpa: f64,
    /// Contraction asked for (isometric, isobaric).
    pub contraction: Option<f64>,
    /// Pull asked for in N (isotonic).
    pub force_n: Option<f64>,
    /// The answer.
    pub answer: Result<Answer, AnalysisError>,
}

/// One curve of a family.
#[derive(Debug, Clone)]
pub struct Curve {
    /// What is fixed along it: ε, F in N, or P in MPa.
    pub fixed: f64,
    /// Its points in the order asked.
    pub points: Vec<CurvePoint>,
}

/// A family of curves: `fixed` holds ε, F or P of each curve, `along` the P or ε of its points.
///
/// Points without an answer carry their reason; the others stand.
pub fn curves<M: ForceModel + ?Sized>(
    model: &M,
    test: Test,
    fixed: &[f64],
    along: &[f64],
    options: Options,
) -> Vec<Curve> {
    let curve = |&fixed: &f64| Curve {
        fixed,
        points: along.iter().map(|&x| point(model, test, fixed, x, options)).collect(),
    };
    fixed.iter().map(curve).collect()
}

fn point<M: ForceModel + ?Sized>(model: &M, test: Test, fixed: f64, x: f64, options: Options) -> CurvePoint {
    match test {
        Test::Isotonic => CurvePoint {
            pressure_mpa: x,
            contraction: None,
            force_n: Some(fixed),
            answer: answer::contraction(model, fixed, x, options),
        },
        Test::Isometric | Test::Isobaric => {
            let (p, e) = if test == Test::Isobaric { (fixed, x) } else { (x, fixed) };
            let answer = answer::point(model, p, e, options).map_err(AnalysisError::from);
            CurvePoint { pressure_mpa: p, contraction: Some(e), force_n: None, answer }
        }
    }
}

impl Curve {
    /// (P, F), (P, ε) or (ε, F) of the answered points, to be drawn; NaN where there is no answer, so that a line
    /// breaks there.
    pub fn line(&self, test: Test) -> Vec<(f64, f64)> {
        self.points
            .iter()
            .map(|p| {
                let answered = p.answer.as_ref().ok();
                let value = |of: fn(&Answer) -> f64| answered.map_or(f64::NAN, of);
                match test {
                    Test::Isometric => (p.pressure_mpa, value(|a| a.response.force_n)),
                    Test::Isobaric => (p.contraction.unwrap_or(f64::NAN), value(|a| a.response.force_n)),
                    Test::Isotonic => (p.pressure_mpa, value(|a| a.response.contraction)),
                }
            })
            .collect()
    }
}
