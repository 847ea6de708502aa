//! Text → muscle.

use super::error::{FileError, Problem};
use super::source::{Section, Source};
use super::{bench, braid, material};
use crate::muscle::{EndFactor, Friction, Muscle, MuscleError, Terminals, Tube};
use crate::rubber::Law;
use crate::units::Dimension;
use std::sync::LazyLock;

const TOP: &[&str] = &["tube", "braid", "terminals", "friction", "model", "identified", "name", "notes"];
const TUBE: &[&str] = &["outer_diameter", "wall_thickness", "length", "rubber", "material"];
/// The two factors belong to a model; these are their keys of before.
const TERMINALS: &[&str] = &["insertion", "seating", "slip", "grip", "end_factor", "cone_factor"];
const MODELS: &[&str] = &["tondu-lopez", "conical-ends"];
const FRICTION: &[&str] = &["coefficient", "exponent", "lever"];

/// Every key of a muscle file, dotted; tells a key in the wrong table from one that means nothing anywhere.
pub(super) static ALL: LazyLock<Vec<&'static str>> = LazyLock::new(|| {
    static CONSTANTS: LazyLock<Vec<String>> = LazyLock::new(|| {
        let names = Law::KINDS.iter().flat_map(|k| k.names());
        names.map(|name| format!("tube.material.{name}")).collect()
    });
    KEYS.iter().copied().chain(CONSTANTS.iter().map(String::as_str)).collect()
});

/// All but the constants of the rubber laws, and those of `[identified]`, which nobody writes by hand.
const KEYS: &[&str] = &[
    "tube.outer_diameter",
    "tube.wall_thickness",
    "tube.length",
    "tube.rubber",
    "tube.material",
    "tube.material.law",
    "tube.material.bulk_modulus",
    "tube.material.fitted_to_stretch",
    "tube.material.softening",
    "tube.material.conditioned",
    "tube.material.prony",
    "tube.material.held",
    "braid.name",
    "braid.angle",
    "braid.stiffness",
    "braid.strands",
    "braid.strand_area",
    "braid.strand_diameter",
    "braid.strand_modulus",
    "braid.strand_strength",
    "braid.strand_length",
    "braid.turns",
    "braid.compression",
    "braid.thickness",
    "braid.diameter",
    "braid.crimp",
    "braid.crimp_stiffness",
    "terminals.insertion",
    "terminals.seating",
    "terminals.slip",
    "terminals.grip",
    "terminals.end_factor",
    "terminals.cone_factor",
    "model.tondu-lopez",
    "model.tondu-lopez.end_factor",
    "model.conical-ends",
    "model.conical-ends.cone_factor",
    "friction.coefficient",
    "friction.exponent",
    "friction.lever",
];

/// Reads the text of a muscle file.
///
/// # Errors
/// [`FileError`] with line, column, key, what stood there and what is expected.
pub fn parse_muscle(text: &str) -> Result<Muscle, FileError> {
    parse_muscle_beside(text, &[])
}

/// Reads the muscle of a text that holds `others` beside it: the tables of a plan, say.
///
/// # Errors
/// As [`parse_muscle`].
pub fn parse_muscle_beside(text: &str, others: &[&'static str]) -> Result<Muscle, FileError> {
    let source = Source::parse(text)?;
    let root = source.root();
    root.only(&[TOP, others].concat(), &ALL)?;
    // For people; they have no meaning in a calculation.
    root.text("name", "a text in quotes")?;
    root.text("notes", "a text in quotes")?;
    let tube = tube(&root)?;
    let braid = braid::read(&root.section("braid", "braid")?, tube.outer_diameter_mm)?;
    let terminals = terminals(&root)?;
    let friction = friction(&root.section("friction", "friction")?)?;
    let bench = bench::read(&root.section("identified", "identified")?)?;
    let muscle = Muscle::new(tube, braid, terminals, friction).map_err(|e| located(&source, e))?;
    Ok(match bench {
        Some(bench) => muscle.with_bench(bench),
        None => muscle,
    })
}

/// The error of the finished muscle, at the line of the key that caused it.
fn located(source: &Source<'_>, error: MuscleError) -> FileError {
    let keys = error.keys();
    let written = keys.iter().find(|k| source.has(k)).or(keys.first());
    let key = written.map_or_else(|| "muscle".to_owned(), |k| k.clone().into_owned());
    // Wall and diameter must suit each other, and either may be a default.
    let wall = matches!(error, MuscleError::WallTooThick { .. });
    let default = keys.iter().find(|k| wall && !source.has(k)).map(|k| k.clone().into_owned());
    source.error(&key, Problem::Muscle { error, key: key.clone(), default })
}

fn tube(root: &Section<'_>) -> Result<Tube, FileError> {
    let section = root.section("tube", "tube")?;
    section.only(TUBE, &ALL)?;
    let default = Tube::prototype();
    let length = |key| section.quantity(key, Dimension::Length);
    Ok(Tube {
        outer_diameter_mm: length("outer_diameter")?.unwrap_or(default.outer_diameter_mm),
        wall_mm: length("wall_thickness")?.unwrap_or(default.wall_mm),
        length_mm: length("length")?.unwrap_or(default.length_mm),
        rubber: material::read(&section)?,
    })
}

/// The terminals, and what models of their own say of the ends.
fn terminals(root: &Section<'_>) -> Result<Terminals, FileError> {
    let section = root.section("terminals", "terminals")?;
    section.only(TERMINALS, &ALL)?;
    let models = root.section("model", "model")?;
    models.only(MODELS, &ALL)?;
    let ends = models.section("tondu-lopez", "model.tondu-lopez")?;
    ends.only(&["end_factor"], &ALL)?;
    let cones = models.section("conical-ends", "model.conical-ends")?;
    cones.only(&["cone_factor"], &ALL)?;
    for (table, key) in [(&ends, "end_factor"), (&cones, "cone_factor")] {
        if table.has(key) && section.has(key) {
            let said = format!("stands at {} as well: leave one of them out", table.dotted(key));
            return Err(section.error(key, Problem::Said(said)));
        }
    }
    Ok(Terminals {
        insertion_mm: section.quantity("insertion", Dimension::Length)?,
        seating_mm: section.quantity("seating", Dimension::Length)?,
        slip_mm_per_n: section.quantity("slip", Dimension::Compliance)?,
        grip_mm: section.quantity("grip", Dimension::Length)?,
        end_factor: end_factor(&ends, "model.tondu-lopez.end_factor")?
            .or(end_factor(&section, "terminals.end_factor")?),
        cone_factor: cones.number("cone_factor")?.or(section.number("cone_factor")?),
    })
}

/// A number, or a table of `a` and `b`: k(P) = a·e^(−P) + b, P in bar.
fn end_factor(section: &Section<'_>, path: &'static str) -> Result<Option<EndFactor>, FileError> {
    let Ok(table) = section.section("end_factor", path) else {
        return Ok(section.number("end_factor")?.map(EndFactor::Constant));
    };
    if !table.is_written() {
        return Ok(None);
    }
    table.only(&["a", "b"], &ALL)?;
    let one = |key| {
        let needs = "an end factor is a number, or { a = …, b = … } for a·e^(−P) + b with P in bar";
        table.number(key)?.ok_or_else(|| table.missing(key, None, needs))
    };
    Ok(Some(EndFactor::OfPressure { a: one("a")?, b: one("b")? }))
}

fn friction(section: &Section<'_>) -> Result<Option<Friction>, FileError> {
    section.only(FRICTION, &ALL)?;
    let needs = "friction is C·P^β: coefficient C in N/MPa^β and exponent β";
    let lever = section.quantity("lever", Dimension::Length)?;
    let lever_mm = lever.unwrap_or(0.0);
    match (section.number("coefficient")?, section.number("exponent")?) {
        (None, None) => Ok(lever.map(|lever_mm| Friction { lever_mm, ..Friction::power_law(0.0, 0.0) })),
        (Some(coefficient), Some(exponent)) => Ok(Some(Friction { coefficient, exponent, lever_mm })),
        (Some(_), None) => Err(section.missing("exponent", Some("coefficient"), needs)),
        (None, Some(_)) => Err(section.missing("coefficient", Some("exponent"), needs)),
    }
}
