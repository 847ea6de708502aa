//! From points to a formula with its range, errors and provenance.

use super::{
    data::{FitPoint, Grid, HELD_OUT, PRESSURES, distinct, same},
    error::{FitError, Result},
    errors::{Compared, ForceScales, Section, errors, regions, section},
    global::{MOST_TERMS, global},
    paper_method::{PaperMethod, is_left_out, paper_method},
};
use crate::{columns::PointRow, hash};
use mckibben_core::{
    extremes::ends,
    formula::{
        Body, Coefficients, Formula, FormulaErrors, FormulaRange, HeldOut, Made, MadeBraid,
        MadeRubber, NamedBraid, Provenance,
    },
    muscle::{Muscle, NEUTRAL_ANGLE_DEG},
};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeSet;

/// How a formula of one make is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The paper's seven steps.
    Paper,
    /// One least-squares problem with at most as many terms as the paper has coefficients.
    Global,
}

impl Method {
    /// The usual name of a formula by it.
    pub fn name(self) -> &'static str {
        match self {
            Method::Paper => "paper-method",
            Method::Global => "global",
        }
    }

    /// The method in words, with the rule that left curves out.
    fn text(self, leaves_out: bool, has_terms: bool) -> String {
        match self {
            Method::Paper => {
                let rule = "left out: D0 < 35, s > 3 at 0.05 MPa; ";
                let rule = if leaves_out { rule } else { "" };
                format!("paper (seven steps; {rule}force two-sided (negative forces count))")
            }
            Method::Global if has_terms => {
                "global (given terms; points where the muscle pulls)".into()
            }
            Method::Global => format!(
                "global (forward selection, at most {MOST_TERMS} terms, number by diameters left \
                 out one at a time; points where the muscle pulls)"
            ),
        }
    }
}

/// Points and method of a formula of one make.
#[derive(Debug, Clone)]
pub struct FormulaRequest<'a> {
    /// Also those that are held out.
    pub points: Vec<FitPoint>,
    /// The make of their muscles; length and angle are those of the points.
    pub made_for: Made,
    /// How the terms are chosen.
    pub method: Method,
    /// Powers of x, p, e, d of the terms that the global method fits in place of those that it
    /// chooses.
    pub terms: Option<&'a [[u8; 4]]>,
    /// Diameters in mm that are kept out of the fit, to test it.
    pub hold_out: &'a [f64],
    /// Share of the muscles that is kept out, evenly in the order of their diameters and walls.
    pub hold_out_share: f64,
    /// Name of the formula.
    pub name: String,
    /// Name of the table, plan hash and seed, where they are known.
    pub from: Provenance,
}

/// A formula with the points that it was fitted to.
#[derive(Debug, Clone)]
pub struct FittedFormula {
    /// With its range, which is that of the points.
    pub formula: Formula,
    /// The tables of the paper's method.
    pub paper: Option<PaperMethod>,
    /// How many terms the global method had to choose from.
    pub candidates: Option<usize>,
    /// The points, those that were fitted before those that are held out.
    pub points: Vec<FitPoint>,
    forces: ForceScales,
    /// Points that no method uses: those at other pressures than the paper's.
    pub unused: usize,
}

impl FittedFormula {
    /// The published formula, with its errors on the same points.
    pub fn published(&self) -> Formula {
        let diameters = self
            .formula
            .errors
            .held_out
            .as_ref()
            .map_or_else(Vec::new, |h| h.outer_diameters_mm.clone());
        let of = |p: &FitPoint| self.forces.compared(*p, p.published_n() - p.force_n);
        Formula {
            name: "paper".into(),
            body: Body::Paper(Box::new(*Coefficients::published())),
            errors: formula_errors(
                self.points.split_at(self.formula.provenance.points),
                diameters,
                of,
            ),
            provenance: Provenance {
                method: "published (Table 2)".into(),
                ..self.formula.provenance.clone()
            },
            ..self.formula.clone()
        }
    }
}

/// The errors of points that were fitted and of their regions, and those of points that were not,
/// of these diameters in mm.
fn formula_errors(
    (fitted, held_out): (&[FitPoint], &[FitPoint]),
    outer_diameters_mm: Vec<f64>,
    compared: impl Fn(&FitPoint) -> Compared,
) -> FormulaErrors {
    let fitted = fitted.iter().map(&compared);
    FormulaErrors {
        against: "the forces of its table, where they pull, as shares of the muscle's blocked \
            force at the table's highest pressure"
            .into(),
        fit: errors(fitted.clone()).unwrap_or_default(),
        regions: regions(fitted),
        held_out: errors(held_out.iter().map(&compared)).map(|errors| HeldOut {
            outer_diameters_mm,
            errors,
        }),
    }
}

/// A share of the muscles, evenly in the order of their diameters and walls.
fn shared(points: &[FitPoint], share: f64) -> BTreeSet<Section> {
    let mut sections = BTreeSet::new();
    if share > 0.0 {
        sections.extend(points.iter().map(section));
    }
    let mut sum: f64 = 0.0;
    sections.retain(|_| {
        let before = sum.round();
        sum += share;
        sum.round() > before
    });
    sections
}

/// Fits a formula of one make.
///
/// # Errors
/// [`FitError`] where points are too few, of several makes or no multiples of each other as the
/// paper's method needs them.
pub fn make(request: FormulaRequest<'_>) -> Result<FittedFormula> {
    let mut points = request.points;
    if points.is_empty() {
        return Err(FitError::empty(""));
    }
    let length_mm = single(&points, "length_mm", |p| p.length_mm)?;
    let angle_deg = single(&points, "angle_deg", |p| p.angle_deg)?;
    let there = points.len();
    keep_pressures(&mut points, request.method);
    let unused = there - points.len();
    let shared = shared(&points, request.hold_out_share);
    let held = |p: &FitPoint| {
        request
            .hold_out
            .iter()
            .any(|d: &f64| same(*d, p.outer_diameter_mm))
            || shared.contains(&section(p))
    };
    points.sort_by_key(held);
    let parts = points.split_at(points.partition_point(|p| !held(p)));
    let fitted = parts.0;
    let kept = fitted.iter().filter(|p| !is_left_out(p));
    let leaves_out = kept.clone().count() < fitted.len();
    let (body, paper, candidates) = match request.method {
        Method::Paper => {
            let steps = paper_method(&Vec::from_iter(kept.copied()))?;
            (Body::Paper(Box::new(steps.coefficients)), Some(steps), None)
        }
        Method::Global => {
            let (terms, candidates) = global(fitted, request.terms)?;
            (Body::Global(terms), None, Some(candidates))
        }
    };
    let mut formula = Formula {
        name: request.name.clone(),
        body,
        made_for: Made {
            length_mm,
            angle_deg,
            ..request.made_for.clone()
        },
        range: range(fitted),
        errors: FormulaErrors::default(),
        provenance: Provenance {
            method: request.method.text(leaves_out, request.terms.is_some()),
            points: fitted.len(),
            data_hash: hash::numbers(numbers(fitted)),
            ..request.from.clone()
        },
    };
    let forces = ForceScales::new(&points)?;
    let of = |p: &FitPoint| forces.compared(*p, p.difference_n(&formula));
    formula.errors = formula_errors(parts, distinct(request.hold_out.iter().copied()), of);
    FitError::refuse_absurd(formula.errors.fit.rms)?;
    Ok(FittedFormula {
        formula,
        paper,
        candidates,
        points,
        forces,
        unused,
    })
}

/// The paper's method takes the paper's five pressures where the table has them all and none above,
/// else every pressure above zero; `global` takes everything above zero.
fn keep_pressures(points: &mut Vec<FitPoint>, method: Method) {
    let pressures = distinct(points.iter().map(|p| p.pressure_mpa));
    let has = |v: &f64| pressures.iter().any(|p| same(*p, *v));
    let top = PRESSURES[PRESSURES.len() - 1];
    let papers = method == Method::Paper
        && PRESSURES.iter().all(has)
        && pressures.iter().all(|p| *p <= top + 1e-9);
    let is_used = |p: f64| {
        if papers {
            PRESSURES.iter().any(|q| same(*q, p))
        } else {
            p > 0.0
        }
    };
    points.retain(|p| is_used(p.pressure_mpa));
}

fn single(points: &[FitPoint], quantity: &'static str, value: fn(&FitPoint) -> f64) -> Result<f64> {
    let list = distinct(points.iter().map(value));
    match list.as_slice() {
        [one] => Ok(*one),
        [low, .., high] => Err(FitError::mixed_make(&format!(
            "{quantity} ({low} to {high})"
        ))),
        [] => Err(FitError::empty("")),
    }
}

fn range(points: &[FitPoint]) -> FormulaRange {
    let extent = |f: fn(&FitPoint) -> f64| ends(points.iter().map(f));
    FormulaRange {
        outer_diameter_mm: extent(|p| p.outer_diameter_mm),
        wall_mm: extent(|p| p.wall_mm),
        pressure_mpa: extent(|p| p.pressure_mpa),
        contraction: extent(|p| p.contraction),
    }
}

/// All numbers of the points, in their order.
fn numbers(points: &[FitPoint]) -> impl Iterator<Item = f64> {
    points.iter().flat_map(|p| {
        [
            p.outer_diameter_mm,
            p.wall_mm,
            p.length_mm,
            p.angle_deg,
            p.pressure_mpa,
            p.contraction,
            p.force_n,
        ]
    })
}

/// A formula of the paper's muscles from points.
pub fn fitted(points: &[FitPoint], method: Method, hold_out: &[f64]) -> Result<FittedFormula> {
    let made_for = Made::from_muscle(&Muscle::prototype());
    let request = FormulaRequest {
        points: points.to_vec(),
        made_for,
        method,
        terms: None,
        hold_out,
        hold_out_share: 0.0,
        name: method.name().into(),
        from: Provenance::default(),
    };
    make(request)
}

/// The formula of the paper's campaign by finite elements; D0 35 mm is held out.
pub fn refitted(method: Method) -> Result<FittedFormula> {
    let base = Muscle::prototype();
    let points = [Grid::PAPER, Grid::HELD_OUT].map(|grid| grid.points(&base));
    fitted(&points.concat(), method, &[HELD_OUT])
}

/// Constants and stiffnesses within this, relative, are the same.
const TOLERANCE: f64 = 1e-9;

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= TOLERANCE * a.abs().max(b.abs())
}

/// What a table's muscles have in common, row after row.
#[derive(Debug, Clone)]
pub struct MakeOfRows {
    made: Made,
    /// The descriptions of the braid that hold for every row so far, the simplest first.
    braids: Vec<MadeBraid>,
}

fn rubber_of(row: &PointRow) -> MadeRubber {
    MadeRubber {
        name: Some(row.rubber.clone()).filter(|name| !name.is_empty()),
        law: row.law.clone(),
        constants: row.constants.iter().cloned().collect(),
        bulk_modulus_mpa: None,
    }
}

impl MakeOfRows {
    /// That of one row.
    pub fn new(first: &PointRow) -> Self {
        let k = first.braid_stiffness_n_per_mm;
        let mut braids = vec![
            MadeBraid::Named(NamedBraid::Paper),
            MadeBraid::Named(NamedBraid::Inextensible),
        ];
        braids.extend(k.map(MadeBraid::Stiffness));
        braids.extend(k.map(|k| MadeBraid::TimesDiameter(k * first.outer_diameter_mm)));
        let made = Made {
            length_mm: first.length_mm,
            angle_deg: first.angle_deg,
            rubber: rubber_of(first),
            braid: MadeBraid::Named(NamedBraid::Inextensible),
            strands: None,
        };
        Self { made, braids }
    }

    /// A further row.
    ///
    /// # Errors
    /// [`FitError::Refused`] where it has another length, angle, rubber or braid, or where a
    /// measure varies that no formula has.
    pub fn add(&mut self, row: &PointRow) -> Result<()> {
        for (part, made, row) in [
            ("length_mm", self.made.length_mm, row.length_mm),
            ("angle_deg", self.made.angle_deg, row.angle_deg),
        ] {
            if !same(made, row) {
                return Err(FitError::mixed_make(&format!("{part} ({made} and {row})")));
            }
        }
        if !rubber_of(row).is_like(&self.made.rubber, TOLERANCE) {
            return Err(FitError::mixed_make("rubber"));
        }
        if let Some((column, _)) = row.measures.first() {
            return Err(FitError::varies(column));
        }
        let made = &mut self.made;
        self.braids.retain(|braid| {
            made.braid = *braid;
            let a = made.stiffness_n_per_mm(row.outer_diameter_mm);
            let b = row.braid_stiffness_n_per_mm;
            a.zip(b).map_or(a == b, |(a, b)| close(a, b))
        });
        if self.braids.is_empty() {
            return Err(FitError::mixed_make("braid"));
        }
        Ok(())
    }

    /// What all of them are made for.
    pub fn made_for(self) -> Made {
        let braid = self.braids.into_iter().next();
        Made {
            braid: braid.unwrap_or(MadeBraid::Named(NamedBraid::Inextensible)),
            ..self.made
        }
    }
}

/// The method that a table is fit for, or why none is.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, JsonSchema)]
pub struct Fits {
    /// `global` for muscles of one make, `universal` for several.
    pub fit_method: Option<&'static str>,
    /// Why no method suits.
    pub no_fit: Option<String>,
}

/// What methods need, row after row.
#[derive(Debug, Clone, Default)]
pub struct Fittable {
    make: Option<MakeOfRows>,
    first: PointRow,
    last_muscle: Option<u64>,
    /// Whether its muscles are of several makes.
    several: bool,
    /// Whether angle, wall over diameter, and rubber vary.
    varied: [bool; 3],
    /// Whether an inflated muscle has an answer at contraction 0.
    blocked: bool,
    /// Why the rows make no formula.
    refused: Option<FitError>,
}

impl Fittable {
    /// Adds a row that has an answer.
    pub fn add(&mut self, row: &PointRow) {
        self.blocked |= row.contraction == 0.0 && row.pressure_mpa > 0.0;
        if self.last_muscle.replace(row.muscle) == Some(row.muscle) {
            return;
        }
        if let Some((column, _)) = row.measures.first() {
            self.refused = Some(FitError::varies(column));
        } else if row.angle_deg >= NEUTRAL_ANGLE_DEG {
            self.refused = Some(FitError::extends(row.angle_deg));
        }
        let make = self.make.get_or_insert_with(|| {
            self.first = row.clone();
            MakeOfRows::new(row)
        });
        self.several |= make.add(row).is_err();
        let first = &self.first;
        let wall = |row: &PointRow| row.wall_mm / row.outer_diameter_mm;
        self.varied[0] |= !same(first.angle_deg, row.angle_deg);
        self.varied[1] |= !same(wall(first), wall(row));
        self.varied[2] |= !rubber_of(row).is_like(&rubber_of(first), TOLERANCE);
    }

    /// What can be fitted to the rows, and why nothing else.
    pub fn fits(&self) -> Fits {
        let method = if self.several { "universal" } else { "global" };
        let one = VARIED.iter().zip(self.varied).find(|(_, varied)| !varied);
        let refused = match (&self.refused, one) {
            (None, _) if !self.blocked => Some(FitError::Refused(
                "no inflated muscle has an answer at contraction 0, and errors are shares of the \
                 blocked force: add contraction 0 to the plan, or pressures that have answers"
                    .into(),
            )),
            (None, Some((quantity, _))) if self.several => Some(FitError::of_one(quantity)),
            (refused, _) => refused.clone(),
        };
        Fits {
            fit_method: refused.is_none().then_some(method),
            no_fit: refused.map(|error| error.to_string()),
        }
    }
}

/// What varies in a table that the method universal takes.
pub const VARIED: [&str; 3] = ["angle", "wall over diameter", "rubber"];
