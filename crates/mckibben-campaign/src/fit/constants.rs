//! The constants of the paper's finite elements, from its Table 1 and its formula (11).
//!
//! Unknown are C10 (C01 comes out as 0) and the stiffness k = k₅₀ (D0/50 mm)ⁿ of a strand family.
//! They are found in three steps; errors count as shares of the blocked force of each muscle.
//!
//! 1. Both sets together by least squares: C10. Walls of 1 to 5 mm determine it, Table 1 with its
//!    one thin wall hardly does.
//! 2. C10 held, Table 1 alone: k₅₀. It is from finite elements, from which (11) differs by some per
//!    cent; its largest error is stated, so that the sixth power is minimised.
//! 3. Both held, (11): n.

use super::{
    data::{CONTRACTIONS, DIAMETERS, FULL_PRESSURE, PRESSURES, WALLS, same},
    error::{FitError, Result},
};
use mckibben_core::{
    formula::Coefficients,
    model::{ForceModel, ModelError, Workspace},
    muscle::{Braid, BraidStiffness, Direction, Muscle, Rubber},
    rubber::{Law, MooneyRivlin},
    threads,
};
use mckibben_fem::axisymmetric::Axisymmetric;
use mckibben_fit::{
    compare::MeasuredPoint,
    identify::{DataPoint, IdentificationRequest, Section, pulls_and_slack},
    least_squares::{Loss, Residuals, Unknown, estimate},
};

/// Table 1 of the paper: P in MPa, and a, b, c in N of F = a ε² + b ε + c at D0 50, s 1.
pub const TABLE_1: [[f64; 4]; 5] = [
    [0.05, 4121.9, -2997.4, 546.21],
    [0.10, 7158.6, -5587.3, 1091.8],
    [0.15, 10195.0, -8177.2, 1637.4],
    [0.20, 13232.0, -10767.0, 2183.0],
    [0.25, 16269.0, -13357.0, 2728.6],
];

/// D0 and s of the muscle of Table 1, as Table 2 tells.
const TABLE_1_SECTION: (f64, f64) = (50.0, 1.0);

/// F of Table 1 in N at one of its pressures.
pub fn table_1(pressure_mpa: f64, contraction: f64) -> Option<f64> {
    let row = TABLE_1.iter().find(|r| same(r[0], pressure_mpa))?;
    Some((row[1] * contraction + row[2]) * contraction + row[3])
}

/// C10 and k = k₄₀ (D0/40)ⁿ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants {
    /// C10 in MPa.
    pub c10_mpa: f64,
    /// k at D0 40 mm in N/mm.
    pub stiffness_at_40_n_per_mm: f64,
    /// n
    pub exponent: f64,
}

impl Constants {
    /// The paper's muscle with these constants; `None` where they make none.
    pub fn muscle(&self, outer_diameter_mm: f64, wall_mm: f64) -> Option<Muscle> {
        let base = Muscle::prototype()
            .with_section(outer_diameter_mm, wall_mm)
            .ok()?;
        let k = self.stiffness_at_40_n_per_mm * (outer_diameter_mm / 40.0).powf(self.exponent);
        let braid = Braid {
            stiffness: BraidStiffness::NewtonPerMm(k),
            ..base.braid().clone()
        };
        let mut tube = base.tube().clone();
        tube.rubber = Rubber::new(Law::MooneyRivlin(MooneyRivlin {
            c10_mpa: self.c10_mpa,
            c01_mpa: 0.0,
        }));
        base.with_braid(braid).ok()?.with_tube(tube).ok()
    }
}

/// F of a pressure and contraction as points, their errors in units of the blocked force.
fn points((d, s): (f64, f64), force: impl Fn(f64, f64) -> Option<f64>) -> Vec<DataPoint> {
    let error = Some(force(FULL_PRESSURE, 0.0).unwrap_or(1.0));
    let section = Section {
        outer_diameter_mm: Some(d),
        wall_mm: Some(s),
        ..Section::default()
    };
    let point = |contraction: f64, pressure_mpa: f64| {
        let at = MeasuredPoint {
            pressure_mpa,
            contraction,
            force_n: force(pressure_mpa, contraction)?,
            branch: Some(Direction::Mean),
        };
        Some(DataPoint {
            section,
            error,
            ..DataPoint::new(at)
        })
    };
    CONTRACTIONS
        .iter()
        .flat_map(|&e| PRESSURES.iter().filter_map(move |&p| point(e, p)))
        .collect()
}

/// (11) on the campaign's points.
fn formula_points() -> Vec<DataPoint> {
    let sections = DIAMETERS
        .iter()
        .flat_map(|&d| WALLS.iter().map(move |&s| (d, s)));
    let points = |(d, s): (f64, f64)| {
        let section = Coefficients::published().section(d, s);
        points((d, s), |p, e| Some(section.force_n(p, e)))
    };
    sections.flat_map(points).collect()
}

fn elements(m: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
    Ok(Box::new(
        Axisymmetric::between_ends(m).map_err(ModelError::from)?,
    ))
}

/// What is unknown: C10, k₅₀ and n, each with the start of the search and its scale.
fn unknown(place: usize) -> Unknown {
    match place {
        0 => Unknown::free(0.1, 0.1),
        1 => Unknown::above(600.0, 0.0, 300.0),
        _ => Unknown::free(1.0, 1.0),
    }
}

/// The residuals at points as a function of some of the constants.
struct Problem<'a> {
    free: &'a [usize],
    /// C10, k₅₀ and n where they are held.
    held: [f64; 3],
    points: &'a [DataPoint],
}

impl Problem<'_> {
    fn constants(&self, x: &[f64]) -> [f64; 3] {
        let mut all = self.held;
        self.free.iter().zip(x).for_each(|(&i, x)| all[i] = *x);
        all
    }

    /// The residuals of points of one muscle.
    fn of_muscle(constants: &Constants, points: &[DataPoint]) -> Option<Vec<f64>> {
        let section = points.first()?.section;
        let muscle = constants.muscle(section.outer_diameter_mm?, section.wall_mm?)?;
        let model = elements(&muscle).ok()?;
        let w = &mut Workspace::new();
        let off = |DataPoint { at, .. }: &DataPoint| {
            let force_n = model.force_n(w, at.pressure_mpa, at.contraction).ok()?;
            Some(force_n - at.force_n)
        };
        points.iter().map(off).collect()
    }
}

impl Residuals for Problem<'_> {
    fn residuals_at(&self, x: &[f64]) -> Option<Vec<f64>> {
        let [c10_mpa, k, exponent] = self.constants(x);
        let constants = Constants {
            c10_mpa,
            stiffness_at_40_n_per_mm: k * (40.0 / TABLE_1_SECTION.0).powf(exponent),
            exponent,
        };
        let sections: Vec<&[DataPoint]> = self
            .points
            .chunk_by(|a, b| a.section == b.section)
            .collect();
        let lists = threads::map(&sections, |points| Self::of_muscle(&constants, points));
        Some(lists.into_iter().collect::<Option<Vec<_>>>()?.concat())
    }
}

/// Values of some of the constants, others being held.
fn values<const N: usize>(
    free: [usize; N],
    held: [f64; 3],
    points: &[DataPoint],
    loss: Loss,
) -> Result<[f64; N]> {
    let failed = || FitError::singular("the constants of the paper");
    // Where the formula does not pull it says nothing.
    let muscle = Muscle::prototype();
    let (points, _) = pulls_and_slack(&IdentificationRequest::new(&muscle, &[], points, &elements));
    let problem = Problem {
        free: &free,
        held,
        points: &points,
    };
    let weight = |p: &DataPoint| p.error.map_or(1.0, |e| 1.0 / (e * e));
    let weights: Vec<f64> = points.iter().map(weight).collect();
    let found = estimate(&problem, &free.map(unknown), &weights, loss);
    found
        .ok()
        .and_then(|f| f.x.try_into().ok())
        .ok_or_else(failed)
}

/// The constants with which our finite elements come nearest to Table 1 and (11).
pub fn fit_constants() -> Result<Constants> {
    let [c10, k, n] = [0, 1, 2];
    let table = points(TABLE_1_SECTION, table_1);
    let formula = formula_points();
    let both = [table.clone(), formula.clone()].concat();
    let [c10_mpa, ..] = values([c10, k, n], [0.0; 3], &both, Loss::Squares)?;
    let [stiffness] = values([k], [c10_mpa, 0.0, 1.0], &table, Loss::Largest)?;
    let held = [c10_mpa, stiffness, 0.0];
    let [exponent] = values([n], held, &formula, Loss::Squares)?;
    let ratio: f64 = 40.0 / TABLE_1_SECTION.0;
    Ok(Constants {
        c10_mpa,
        stiffness_at_40_n_per_mm: stiffness * ratio.powf(exponent),
        exponent,
    })
}
