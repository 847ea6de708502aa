//! The paper's formula: force as a polynomial of pressure, contraction, wall and diameter
//! (Antonelli et al. 2018 \[antonelli2018\]; [`crate::PAPER`]).
//!
//!   (11)  F = a ε² + b ε + c,   a = m_a P + q_a,   m_a = A1 s² + A2 s + A3,   q_a = A4 s² + A5 s + A6
//!         A_k = A_k1 D0² + A_k2 D0 + A_k3;  b likewise with B, c with C, where C_k is a straight line in D0
//!
//! F in N, P in MPa, s and D0 in mm. 48 published numbers (Table 2), fitted by the paper's authors
//! to finite elements of one make: θ0 28°, L0 285 mm, one rubber, one braid.

use super::{
    Accuracy, BlockedAt, FormulaModel, ModelEntry, ModelInfo, ModelRange, Reference, ThickWall,
    formula::{Bound, of_sections},
};
use crate::{
    formula::{Coefficients, FormulaRange},
    muscle::Muscle,
};

pub const ENTRY: ModelEntry = ModelEntry {
    name: "paper",
    description: "formula (11) of Antonelli et al. 2018 [antonelli2018]: D0 30-50, s 1-5, L0 285 \
        mm, 28 deg, up to 0.25 MPa",
    source: "formula (11) with Table 2 of M. G. Antonelli, P. Beomonte Zobel, W. D'Ambrogio, F. \
        Durante, T. Raparelli, Int. J. Mech. Eng. Technol. 9 (2018) 320–337 [antonelli2018]",
};

const ANGLE_DEG: f64 = 28.0;
const LENGTH_MM: f64 = 285.0;

/// The box, and what of a muscle lies outside.
fn range(m: &Muscle) -> ModelRange {
    let rubber = m.rubber();
    let mut make = vec![];
    if !rubber.is_paper() {
        let name = rubber
            .name
            .as_deref()
            .filter(|n| *n != "antonelli2018")
            .unwrap_or("another");
        make.push(format!(
            "the rubber is {name}, the formula is for the rubber `antonelli2018`"
        ));
    }
    if m.braid().stiffness != crate::muscle::BraidStiffness::Paper {
        make.push(
            "the braid has its own stiffness, the formula is for the braid `antonelli2018`".into(),
        );
    }
    of_sections(&FormulaModel::PAPER_RANGE, (LENGTH_MM, ANGLE_DEG), make, m)
}

impl FormulaModel {
    /// Sections, pressures and contractions for which the paper's formula was made.
    pub const PAPER_RANGE: FormulaRange = FormulaRange {
        outer_diameter_mm: (30.0, 50.0),
        wall_mm: (1.0, 5.0),
        pressure_mpa: (0.0, 0.25),
        contraction: (0.0, 0.20),
    };

    /// The paper's formula (11) with the published numbers, for one muscle.
    pub fn paper(muscle: &Muscle) -> Self {
        let section =
            Coefficients::published().section(muscle.outer_diameter_mm(), muscle.wall_mm());
        let accuracy = Accuracy {
            share_of_blocked: Some(0.05),
            blocked_at: BlockedAt::Pressure(FormulaModel::PAPER_RANGE.pressure_mpa.1),
            reference: Reference::Elements(
                "its authors state about 2 % and at most 50 N against their own finite elements; \
                 95 % of 1889 points over its box lie within 3.9 % of this program's axisymmetric \
                 ones (rubber and braid `antonelli2018`), the worst at 5.9 % near D0 37.5 mm, where \
                 the published C block, linear in D0, is weakest",
            ),
        };
        let info = ModelInfo {
            range: range(muscle),
            accuracy,
            ..ModelInfo::new(&ENTRY, muscle)
        };
        Self {
            info,
            bound: Bound::Paper(section),
            at_rest: ThickWall::between_ends(muscle),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{ForceModel, Workspace};

    #[test]
    fn the_numbers_are_those_of_the_table_shipped() {
        let mut csv = csv::Reader::from_reader(include_str!("../../data/table2.csv").as_bytes());
        let rows: Vec<(String, usize, f64, f64, f64)> =
            csv.deserialize().map(Result::unwrap).collect();
        assert_eq!(rows.len(), 18);
        for (family, row, d2, d1, d0) in rows {
            let block = match family.as_str() {
                "A" => Coefficients::published().a,
                "B" => Coefficients::published().b,
                _ => Coefficients::published().c,
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
            let (fa, fb, fc) = section.quadratic_at(p);
            for (formula, table) in [(fa, a), (fb, b), (fc, c)] {
                assert!(
                    (formula / table - 1.0).abs() < 0.018,
                    "P {p}: {formula} {table}"
                );
            }
        }
    }

    /// What the formula says of the wall: at .25 MPa it costs at most about 205 N at D0 30, 275 N
    /// at D0 50.
    #[test]
    fn the_drop_from_thin_to_thick_walls() {
        for (d0, drop) in [(30.0, 205.0), (50.0, 275.0)] {
            let (thin, thick) = (
                Coefficients::published().section(d0, 1.0),
                Coefficients::published().section(d0, 5.0),
            );
            let worst = (0..=200)
                .map(|i| f64::from(i) / 1000.0)
                .map(|e| thin.force_n(0.25, e) - thick.force_n(0.25, e))
                .fold(0.0, f64::max);
            assert!((worst - drop).abs() < 3.0, "D0 {d0}: {worst}");
        }
    }

    #[test]
    fn what_lies_outside_of_the_box_is_named() {
        assert!(
            FormulaModel::paper(&Muscle::prototype())
                .info
                .range
                .check("paper", 0.25, 0.2)
                .is_ok()
        );
        let other = Muscle::prototype().with_section(60.0, 0.5).unwrap();
        let text = FormulaModel::paper(&other)
            .info
            .range
            .check("paper", 0.3, 0.25)
            .unwrap_err()
            .to_string();
        for part in [
            "outer_diameter 60",
            "wall_thickness 0.5",
            "pressure 0.3",
            "contraction 0.25",
        ] {
            assert!(text.contains(part), "{text}");
        }
        let stiff = crate::muscle::Braid {
            stiffness: crate::muscle::BraidStiffness::Inextensible,
            angle_deg: 25.0,
            ..crate::muscle::Braid::paper()
        };
        let range = FormulaModel::paper(&Muscle::prototype().with_braid(stiff).unwrap())
            .info
            .range;
        assert_eq!((range.make.len(), range.muscle.len()), (1, 1));
        assert!(
            FormulaModel::paper(&Muscle::prototype())
                .force_n(&mut Workspace::new(), f64::NAN, 0.1)
                .is_err()
        );
    }
}
