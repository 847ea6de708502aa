//! The paper's method (section 3.3): 48 coefficients in seven steps.
//!
//!   1–2  for each (D0, s, P)   F = a ε² + b ε + c                                  (5)
//!   3    for each (D0, s)      a = m_a P + q_a, likewise b, c                      (8)
//!   4–5  for each D0           m_a = A1 s² + A2 s + A3, q_a = A4 s² + A5 s + A6    (9), (10)
//!   6–7                        A_k = A_k1 D0² + A_k2 D0 + A_k3, B_k likewise, C_k = C_k1 D0 + C_k2   (11)
//!
//! Each step is a separate least-squares fit; the residuals of one are not in the next.

use super::{
    data::{FitPoint, distinct, same},
    error::{FitError, Result},
    least_squares::least_squares,
};
use mckibben_core::{extremes::peak, formula::Coefficients};
use nalgebra::{DMatrix, DVector};

/// Steps 1–2: one isobaric curve (a row of the paper's Table 1).
#[derive(Debug, Clone, PartialEq)]
pub struct CurveFit {
    /// D0 in mm.
    pub outer_diameter_mm: f64,
    /// s in mm.
    pub wall_mm: f64,
    /// P in MPa.
    pub pressure_mpa: f64,
    /// a, b, c in N, with R².
    pub abc: PolynomialFit<3>,
    /// (ε, F)
    pub points: Vec<(f64, f64)>,
}

/// Step 3: a, b, c over P for one (D0, s).
#[derive(Debug, Clone, PartialEq)]
pub struct LineFit {
    /// D0 in mm.
    pub outer_diameter_mm: f64,
    /// s in mm.
    pub wall_mm: f64,
    /// Slope m (mm²) and intercept q (N) of a, b and c.
    pub lines: [PolynomialFit<2>; 3],
    /// How many pressures they rest on.
    pub pressures: usize,
}

/// Steps 4–5: slopes and intercepts over s for one D0.
#[derive(Debug, Clone, PartialEq)]
pub struct WallFit {
    /// D0 in mm.
    pub outer_diameter_mm: f64,
    /// Of a, b and c: the parabola of m (X1, X2, X3) and that of q (X4, X5, X6).
    pub parabolas: [[PolynomialFit<3>; 2]; 3],
}

impl WallFit {
    /// X1…X6 of a, b or c.
    pub fn x(&self, family: usize) -> [f64; 6] {
        let [m, q] = &self.parabolas[family];
        let ([x1, x2, x3], [x4, x5, x6]) = (m.coefficients, q.coefficients);
        [x1, x2, x3, x4, x5, x6]
    }
}

/// The results of all steps of the method.
#[derive(Debug, Clone, PartialEq)]
pub struct PaperMethod {
    /// Steps 1–2.
    pub curves: Vec<CurveFit>,
    /// Step 3.
    pub lines: Vec<LineFit>,
    /// Steps 4–5.
    pub walls: Vec<WallFit>,
    /// Steps 6–7: R² of A_k, B_k and C_k over D0.
    pub r2: [[f64; 6]; 3],
    /// The result, in the layout of Table 2.
    pub coefficients: Coefficients,
}

/// Whether a point is of a thick wall of a thin muscle at low pressure (D0 < 35, s > 3 at .05 MPa).
/// The paper takes two of the five contractions of such a curve, too few for a quadratic, and does
/// not say how it went on; here the curve is left out.
pub fn is_left_out(p: &FitPoint) -> bool {
    p.outer_diameter_mm < 35.0 && p.wall_mm > 3.0 && same(p.pressure_mpa, 0.05)
}

/// The seven steps. All points count: choose curves, pressures and diameters before.
pub fn paper_method(points: &[FitPoint]) -> Result<PaperMethod> {
    if points.is_empty() {
        return Err(FitError::empty(" at the method's pressures"));
    }
    let diameters = distinct(points.iter().map(|p| p.outer_diameter_mm));
    enough("outer_diameter_mm", diameters.len(), 3, "the table")?;
    let mut curves = vec![];
    let mut lines = vec![];
    let mut walls = vec![];
    for &d in &diameters {
        let of_diameter: Vec<&FitPoint> = points
            .iter()
            .filter(|p| same(p.outer_diameter_mm, d))
            .collect();
        let start = lines.len();
        for s in distinct(of_diameter.iter().map(|p| p.wall_mm)) {
            let of_wall: Vec<&FitPoint> = of_diameter
                .iter()
                .copied()
                .filter(|p| same(p.wall_mm, s))
                .collect();
            let first = curves.len();
            for p in distinct(of_wall.iter().map(|q| q.pressure_mpa)) {
                let isobar = of_wall
                    .iter()
                    .filter(|q| same(q.pressure_mpa, p))
                    .map(|q| (q.contraction, q.force_n));
                curves.push(curve(d, s, p, isobar.collect())?);
            }
            lines.push(line(d, s, &curves[first..])?);
        }
        walls.push(parabolas(d, &lines[start..])?);
    }
    let (coefficients, r2) = over_diameters(&walls)?;
    Ok(PaperMethod {
        curves,
        lines,
        walls,
        r2,
        coefficients,
    })
}

fn enough(quantity: &'static str, count: usize, needed: usize, place: &str) -> Result<()> {
    if count >= needed {
        return Ok(());
    }
    Err(FitError::Refused(format!(
        "{place} has {count} different values of {quantity}; {needed} are needed at least"
    )))
}

/// Step 1.
fn curve(d: f64, s: f64, p: f64, points: Vec<(f64, f64)>) -> Result<CurveFit> {
    let place = format!("the curve of D0 {d}, s {s} mm at {p} MPa");
    let contractions = distinct(points.iter().map(|q| q.0));
    enough("contraction", contractions.len(), 3, &place)?;
    Ok(CurveFit {
        outer_diameter_mm: d,
        wall_mm: s,
        pressure_mpa: p,
        abc: fit::<3>(&points).ok_or_else(|| FitError::singular(place))?,
        points,
    })
}

/// Step 3.
fn line(d: f64, s: f64, curves: &[CurveFit]) -> Result<LineFit> {
    let place = format!("the muscle D0 {d}, s {s} mm");
    enough("pressure_mpa", curves.len(), 2, &place)?;
    let line = |k: usize| {
        let point = |c: &CurveFit| (c.pressure_mpa, c.abc.coefficients[k]);
        fit::<2>(&Vec::from_iter(curves.iter().map(point)))
            .ok_or_else(|| FitError::singular(&place))
    };
    Ok(LineFit {
        outer_diameter_mm: d,
        wall_mm: s,
        lines: [line(0)?, line(1)?, line(2)?],
        pressures: curves.len(),
    })
}

/// Steps 4–5.
fn parabolas(d: f64, lines: &[LineFit]) -> Result<WallFit> {
    let place = format!("the diameter D0 {d} mm");
    enough("wall_mm", lines.len(), 3, &place)?;
    let parabola = |k: usize, j: usize| {
        let points: Vec<(f64, f64)> = lines
            .iter()
            .map(|l| (l.wall_mm, l.lines[k].coefficients[j]))
            .collect();
        fit::<3>(&points).ok_or_else(|| FitError::singular(&place))
    };
    let pair = |k| Ok::<_, FitError>([parabola(k, 0)?, parabola(k, 1)?]);
    Ok(WallFit {
        outer_diameter_mm: d,
        parabolas: [pair(0)?, pair(1)?, pair(2)?],
    })
}

/// Steps 6–7.
fn over_diameters(walls: &[WallFit]) -> Result<(Coefficients, [[f64; 6]; 3])> {
    let mut x = [[[0.0; 3]; 6]; 3];
    let mut r2 = [[0.0; 6]; 3];
    for family in 0..3 {
        for k in 0..6 {
            let points: Vec<(f64, f64)> = walls
                .iter()
                .map(|w| (w.outer_diameter_mm, w.x(family)[k]))
                .collect();
            let fitted = match family {
                0 | 1 => fit::<3>(&points).map(|f| (f.coefficients, f.r2)),
                _ => fit::<2>(&points).map(|f| ([0.0, f.coefficients[0], f.coefficients[1]], f.r2)),
            };
            let failed =
                || FitError::singular(format!("{}{} over D0", ["A", "B", "C"][family], k + 1));
            (x[family][k], r2[family][k]) = fitted.ok_or_else(failed)?;
        }
    }
    let [a, b, c] = x;
    Ok((Coefficients { a, b, c }, r2))
}

/// A fitted polynomial of degree N − 1, highest power first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PolynomialFit<const N: usize> {
    /// Coefficients, of the highest power first.
    pub coefficients: [f64; N],
    /// R² = 1 − Σ(y − ŷ)²/Σ(y − ȳ)²; 1 where all y are the same and met.
    pub r2: f64,
}

impl<const N: usize> PolynomialFit<N> {
    /// Its value by Horner's rule.
    pub fn at(&self, x: f64) -> f64 {
        self.coefficients.iter().fold(0.0, |sum, c| sum * x + c)
    }
}

/// Σ (y − ŷ)² → min over ŷ = c₁ xᴺ⁻¹ + … + c_N, by QR of the matrix in x/max|x|. `None` for fewer
/// than N points, or points that do not determine it.
pub fn fit<const N: usize>(points: &[(f64, f64)]) -> Option<PolynomialFit<N>> {
    let scale = peak(points.iter().map(|p| p.0.abs()));
    if points.len() < N || scale == 0.0 {
        return None;
    }
    let power = |j: usize| (N - 1 - j) as i32;
    let matrix = DMatrix::from_fn(points.len(), N, |i, j| (points[i].0 / scale).powi(power(j)));
    let solved = least_squares(
        matrix,
        DVector::from_iterator(points.len(), points.iter().map(|p| p.1)),
    )?;
    let mut fitted = PolynomialFit {
        coefficients: std::array::from_fn(|j| solved[j] / scale.powi(power(j))),
        r2: 1.0,
    };
    let mean = points.iter().map(|p| p.1).sum::<f64>() / points.len() as f64;
    let left: f64 = points.iter().map(|p| (p.1 - fitted.at(p.0)).powi(2)).sum();
    let all: f64 = points.iter().map(|p| (p.1 - mean).powi(2)).sum();
    if all > 0.0 {
        fitted.r2 = 1.0 - left / all;
    }
    Some(fitted)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_free_polynomials_come_back() {
        let points: Vec<(f64, f64)> = [30.0, 40.0, 45.0, 50.0]
            .iter()
            .map(|&x| (x, (-12.079 * x + 1122.2) * x - 26214.0))
            .collect();
        let f = fit::<3>(&points).unwrap();
        for (c, exact) in f.coefficients.iter().zip([-12.079, 1122.2, -26214.0]) {
            assert!((c / exact - 1.0).abs() < 1e-11, "{c} {exact}");
        }
        assert!((f.r2 - 1.0).abs() < 1e-14);
        assert!(fit::<3>(&points[..2]).is_none());
        assert!(fit::<2>(&[(0.0, 1.0), (0.0, 2.0)]).is_none());
        assert!(fit::<2>(&[(1.0, 1.0), (1.0, f64::NAN)]).is_none());
    }

    /// y = 1, 2, 4 at x = 0, 1, 2: slope 3/2, intercept 5/6, R² = 1 − (1/6)/(14/3) = 27/28.
    #[test]
    fn a_line_through_three_points_by_hand() {
        let f = fit::<2>(&[(0.0, 1.0), (1.0, 2.0), (2.0, 4.0)]).unwrap();
        assert!(
            (f.coefficients[0] - 1.5).abs() < 1e-14
                && (f.coefficients[1] - 5.0 / 6.0).abs() < 1e-14
        );
        assert!((f.r2 - 27.0 / 28.0).abs() < 1e-14);
    }
}
