//! The paper's formula: force as a polynomial of pressure, contraction, wall and diameter (Antonelli et al. 2018
//! \[antonelli2018\]; [`crate::PAPER`]).
//!
//!   (11)  F = a ε² + b ε + c,   a = m_a P + q_a,   m_a = A1 s² + A2 s + A3,   q_a = A4 s² + A5 s + A6
//!         A_k = A_k1 D0² + A_k2 D0 + A_k3;  b likewise with B, c with C, where C_k is a straight line in D0
//!
//! F in N, P in MPa, s and D0 in mm. 48 published numbers (Table 2), fitted by the paper's authors to finite elements of
//! one make: θ0 28°, L0 285 mm, one rubber, one braid.

use super::{
    Accuracy, BlockedAt, ForceModel, Interval, ModelError, ModelRange, Quantity, Reference, Response,
    Workspace,
};
use crate::muscle::Muscle;

/// Diameters, walls, pressures and contractions for which (11) was made.
const DIAMETER: (f64, f64) = (30.0, 50.0);
const WALL: (f64, f64) = (1.0, 5.0);
const PRESSURE: (f64, f64) = (0.0, 0.25);
const CONTRACTION: (f64, f64) = (0.0, 0.20);
const ANGLE_DEG: f64 = 28.0;
const LENGTH_MM: f64 = 285.0;

/// The numbers X_k1, X_k2, X_k3 of (11) for X = A, B, C and k = 1…6.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coefficients {
    /// A, of ε².
    pub a: [[f64; 3]; 6],
    /// B, of ε.
    pub b: [[f64; 3]; 6],
    /// C; its D0² column is zero in the paper.
    pub c: [[f64; 3]; 6],
}

/// Table 2 of the paper, columns D0², D0, 1.
static TABLE_2: Coefficients = Coefficients {
    a: [
        [-12.079, 1122.2, -26214.0],
        [43.917, -4364.9, 100482.0],
        [14.061, 1969.0, -64578.0],
        [2.5976, -247.07, 5929.1],
        [-9.1771, 935.22, -21081.0],
        [3.888, -495.47, 13380.0],
    ],
    b: [
        [0.882, -89.553, 2331.4],
        [-1.9985, 309.05, -7824.9],
        [-23.591, -1.3836, 4592.1],
        [-0.1886, 19.928, -534.44],
        [0.414, -66.297, 1433.3],
        [0.6582, -22.524, -89.23],
    ],
    c: [
        [0.0, -0.0366, -7.9276],
        [0.0, -4.9662, 78.727],
        [0.0, 345.94, -6378.4],
        [0.0, 0.0477, -2.2277],
        [0.0, -0.2709, 8.9142],
        [0.0, 0.3005, -10.664],
    ],
};

/// (11) for one diameter and wall: a = m P + q and likewise b and c.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// Slope and intercept of a in P (mm², N).
    pub a: (f64, f64),
    /// Slope and intercept of b in P.
    pub b: (f64, f64),
    /// Slope and intercept of c in P.
    pub c: (f64, f64),
}

impl Coefficients {
    /// The published numbers.
    pub fn published() -> &'static Self {
        &TABLE_2
    }

    /// Puts in diameter and wall, in mm.
    pub fn section(&self, outer_diameter_mm: f64, wall_mm: f64) -> Section {
        let (d, s) = (outer_diameter_mm, wall_mm);
        let line = |x: &[[f64; 3]; 6]| {
            let [x1, x2, x3, x4, x5, x6] = x.map(|[d2, d1, d0]| (d2 * d + d1) * d + d0);
            ((x1 * s + x2) * s + x3, (x4 * s + x5) * s + x6)
        };
        Section { a: line(&self.a), b: line(&self.b), c: line(&self.c) }
    }
}

impl Section {
    /// a, b, c of F = a ε² + b ε + c at a pressure in MPa.
    pub fn at(&self, pressure_mpa: f64) -> (f64, f64, f64) {
        let line = |(m, q): (f64, f64)| m * pressure_mpa + q;
        (line(self.a), line(self.b), line(self.c))
    }

    /// F in N.
    pub fn force_n(&self, pressure_mpa: f64, contraction: f64) -> f64 {
        let (a, b, c) = self.at(pressure_mpa);
        (a * contraction + b) * contraction + c
    }

    /// ∂F/∂ε in N.
    pub fn by_contraction(&self, pressure_mpa: f64, contraction: f64) -> f64 {
        let (a, b, _) = self.at(pressure_mpa);
        2.0 * a * contraction + b
    }

    /// ∂F/∂P in mm².
    pub fn by_pressure(&self, contraction: f64) -> f64 {
        (self.a.0 * contraction + self.b.0) * contraction + self.c.0
    }

    /// Pressure in MPa at which F has a value; `None` where F does not rise with P.
    pub fn pressure_mpa(&self, force_n: f64, contraction: f64) -> Option<f64> {
        let slope = self.by_pressure(contraction);
        (slope > 0.0).then(|| (force_n - self.force_n(0.0, contraction)) / slope)
    }

    /// Contraction at which F has a value, on the branch where F falls with ε; `None` where there is none.
    pub fn contraction(&self, force_n: f64, pressure_mpa: f64) -> Option<f64> {
        let (a, b, c) = self.at(pressure_mpa);
        let c = c - force_n;
        let root = (b * b - 4.0 * a * c).sqrt();
        // ε = (−b − √(b² − 4ac))/(2a), where 2aε + b = −√… < 0. For b < 0 this form stands a = 0 and does not cancel.
        let e = if b < 0.0 { 2.0 * c / (root - b) } else { (-b - root) / (2.0 * a) };
        e.is_finite().then_some(e)
    }
}

/// The paper's formula (11) for one muscle.
#[derive(Debug, Clone)]
pub struct Paper {
    muscle: Muscle,
    section: Section,
}

impl Paper {
    /// The formula with the published numbers.
    pub fn new(muscle: &Muscle) -> Self {
        let section = Coefficients::published().section(muscle.outer_diameter_mm(), muscle.wall_mm());
        Self { muscle: muscle.clone(), section }
    }

    /// The six numbers of this muscle.
    pub fn section(&self) -> &Section {
        &self.section
    }
}

impl ForceModel for Paper {
    fn name(&self) -> &str {
        "paper"
    }

    fn muscle(&self) -> &Muscle {
        &self.muscle
    }

    fn source(&self) -> &str {
        "formula (11) with Table 2 of M. G. Antonelli, P. Beomonte Zobel, W. D'Ambrogio, F. Durante, T. Raparelli, Int. J. Mech. Eng. Technol. 9 (2018) 320–337 [antonelli2018]"
    }

    fn range(&self) -> ModelRange {
        let m = &self.muscle;
        let rubber = &m.tube().rubber;
        let mut make = vec![];
        if !m.is_paper_make() {
            if !rubber.is_paper() {
                let name = rubber.name.as_deref().filter(|n| *n != "paper").unwrap_or("another");
                make.push(format!("the rubber is {name}, the formula is for the rubber `paper`"));
            }
            if m.braid().stiffness != crate::muscle::BraidStiffness::Paper {
                make.push("the braid has its own stiffness, the formula is for the braid `paper`".into());
            }
        }
        ModelRange { pressure_mpa: PRESSURE, contraction: CONTRACTION, make, ..ModelRange::open() }
            .with_measures(&[
                (Interval::new(Quantity::OuterDiameter, DIAMETER), m.outer_diameter_mm()),
                (Interval::new(Quantity::WallThickness, WALL), m.wall_mm()),
                (Interval::only(Quantity::Length, LENGTH_MM), m.length_mm()),
                (Interval::only(Quantity::BraidAngle, ANGLE_DEG), m.braid().angle_deg),
            ])
    }

    fn accuracy(&self) -> Accuracy {
        Accuracy {
            share_of_blocked: Some(0.05),
            blocked_at: BlockedAt::Pressure(PRESSURE.1),
            reference: Reference::Paper,
        }
    }

    fn response(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Response, ModelError> {
        let force_n = self.force_n(workspace, pressure_mpa, contraction)?;
        let slope = self.section.by_contraction(pressure_mpa, contraction);
        Ok(Response {
            pressure_mpa,
            contraction,
            force_n,
            stiffness_n_per_mm: Some(-slope / self.muscle.length_mm()),
            force_per_pressure_mm2: Some(self.section.by_pressure(contraction)),
            ..Response::default()
        })
    }

    fn force_n(&self, _: &mut Workspace, pressure_mpa: f64, contraction: f64) -> Result<f64, ModelError> {
        let force = self.section.force_n(pressure_mpa, contraction);
        if force.is_finite() {
            Ok(force)
        } else {
            Err(ModelError::NotFinite { model: "paper".into(), pressure_mpa, contraction })
        }
    }

    fn exact_pressure(&self, force_n: f64, contraction: f64) -> Option<f64> {
        self.section.pressure_mpa(force_n, contraction)
    }

    fn exact_contraction(&self, force_n: f64, pressure_mpa: f64) -> Option<f64> {
        self.section.contraction(force_n, pressure_mpa)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_numbers_are_those_of_the_table_shipped() {
        let mut csv = csv::Reader::from_reader(include_str!("../../data/table2.csv").as_bytes());
        let rows: Vec<(String, usize, f64, f64, f64)> = csv.deserialize().map(Result::unwrap).collect();
        assert_eq!(rows.len(), 18);
        for (family, row, d2, d1, d0) in rows {
            let block = match family.as_str() {
                "A" => TABLE_2.a,
                "B" => TABLE_2.b,
                _ => TABLE_2.c,
            };
            assert_eq!(block[row - 1], [d2, d1, d0], "{family}{row}");
        }
    }

    /// Table 1: a, b, c of one finite-element model, which (11) gives back at D0 50, s 1.
    #[test]
    fn table_1_comes_back_within_1_8_percent() {
        let section = Coefficients::published().section(50.0, 1.0);
        let mut csv = csv::Reader::from_reader(include_str!("../../data/table1.csv").as_bytes());
        let rows: Vec<[f64; 4]> = csv.deserialize().map(Result::unwrap).collect();
        assert_eq!(rows.len(), 5);
        for [p, a, b, c] in rows {
            let (fa, fb, fc) = section.at(p);
            for (formula, table) in [(fa, a), (fb, b), (fc, c)] {
                assert!((formula / table - 1.0).abs() < 0.018, "P {p}: {formula} {table}");
            }
        }
    }

    /// What the formula says of the wall: at .25 MPa it costs at most about 205 N at D0 30, 275 N at D0 50.
    #[test]
    fn the_drop_from_thin_to_thick_walls() {
        for (d0, drop) in [(30.0, 205.0), (50.0, 275.0)] {
            let (thin, thick) =
                (Coefficients::published().section(d0, 1.0), Coefficients::published().section(d0, 5.0));
            let worst = (0..=200)
                .map(|i| f64::from(i) / 1000.0)
                .map(|e| thin.force_n(0.25, e) - thick.force_n(0.25, e))
                .fold(0.0, f64::max);
            assert!((worst - drop).abs() < 3.0, "D0 {d0}: {worst}");
        }
    }

    #[test]
    fn inverses_come_back_also_without_a_square_term() {
        let mut section = Coefficients::published().section(40.0, 2.0);
        for a in [section.a, (0.0, 0.0), (1e-13, 0.0), (-500.0, 0.0)] {
            section.a = a;
            for (p, e) in [(0.25, 0.0), (0.1, 0.1), (0.2, 0.19)] {
                let force = section.force_n(p, e);
                assert!((section.pressure_mpa(force, e).unwrap() - p).abs() < 1e-13);
                if section.by_contraction(p, e) < 0.0 {
                    assert!((section.contraction(force, p).unwrap() - e).abs() < 1e-13, "a {a:?}");
                }
            }
        }
        assert_eq!(Coefficients::published().section(40.0, 2.0).contraction(-1e5, 0.2), None);
        let flat = Section { a: (0.0, 0.0), b: (0.0, 0.0), c: (0.0, 1.0) };
        assert_eq!(flat.contraction(1.0, 0.1), None);
        assert_eq!(flat.pressure_mpa(1.0, 0.1), None);
    }

    #[test]
    fn what_lies_outside_of_the_box_is_named() {
        assert!(Paper::new(&Muscle::prototype()).range().check("paper", 0.25, 0.2).is_ok());
        let other = Muscle::prototype().with_section(60.0, 0.5).unwrap();
        let text = Paper::new(&other).range().check("paper", 0.3, 0.25).unwrap_err().to_string();
        for part in ["outer_diameter 60", "wall_thickness 0.5", "pressure 0.3", "contraction 0.25"] {
            assert!(text.contains(part), "{text}");
        }
        let stiff = crate::muscle::Braid {
            stiffness: crate::muscle::BraidStiffness::Inextensible,
            angle_deg: 25.0,
            ..crate::muscle::Braid::paper()
        };
        let range = Paper::new(&Muscle::prototype().with_braid(stiff).unwrap()).range();
        assert_eq!((range.make.len(), range.muscle.len()), (1, 1));
        assert!(Paper::new(&Muscle::prototype()).force_n(&mut Workspace::new(), f64::NAN, 0.1).is_err());
    }
}
