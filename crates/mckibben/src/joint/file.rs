//! Joint files: TOML in the muscle file's manner.

use super::{Joint, JointError, JointMuscle, JointSpring, Link, Path, PulleyFriction};
use crate::muscle::Muscle;
use crate::muscle::file::{FileError, Problem, Section, Source};
use crate::units::{Dimension, Values};

const TOP: &[&str] = &["joint", "link", "muscle_1", "muscle_2", "spring", "name", "notes"];
const JOINT: &[&str] = &["radius", "range", "inertia", "damping"];
const LINK: &[&str] = &["mass", "centre", "inclination", "payload", "payload_at"];
const MUSCLE: &[&str] =
    &["file", "contraction_at_neutral", "radius", "origin", "insertion", "wrap_angle", "wrap_friction"];
const SPRING: &[&str] =
    &["rate", "preload", "angular_rate", "preload_torque", "radius", "origin", "insertion"];
const ALL: &[&str] = &[
    "joint.radius",
    "joint.range",
    "joint.inertia",
    "joint.damping",
    "link.mass",
    "link.centre",
    "link.inclination",
    "link.payload",
    "link.payload_at",
    "muscle_1.file",
    "muscle_1.contraction_at_neutral",
    "muscle_1.origin",
    "muscle_1.insertion",
    "muscle_1.wrap_angle",
    "muscle_1.wrap_friction",
    "spring.rate",
    "spring.preload",
    "spring.angular_rate",
    "spring.preload_torque",
];

/// A joint file: everything but the muscles themselves, which stand in files of their own.
#[derive(Debug, Clone, PartialEq)]
pub struct JointFile {
    /// File, way about the joint and contraction at the neutral angle of each muscle.
    muscles: Vec<(String, Path, f64)>,
    pulleys: Vec<PulleyFriction>,
    spring: Option<JointSpring>,
    link: Link,
    range_deg: (f64, f64),
}

impl JointFile {
    /// The muscle files that it names, relative to it.
    pub fn files(&self) -> impl Iterator<Item = &str> {
        self.muscles.iter().map(|m| m.0.as_str())
    }

    /// The joint with its muscles, in the order of [`JointFile::files`].
    pub fn with(&self, muscles: Vec<Muscle>) -> Result<Joint, JointError> {
        let given = muscles.len();
        let at = |(muscle, &(_, path, contraction_at_neutral)): (Muscle, &(String, Path, f64))| JointMuscle {
            muscle,
            path,
            contraction_at_neutral,
        };
        let list: Vec<JointMuscle> = muscles.into_iter().zip(&self.muscles).map(at).collect();
        if given != self.muscles.len() {
            return Err(JointError::Muscles(given));
        }
        let joint = Joint::new(list, self.spring, self.link, self.range_deg)?;
        Ok(Joint { pulleys: self.pulleys.clone(), ..joint })
    }
}

/// Reads the text of a joint file.
///
/// ```
/// use mckibben::joint::parse_joint;
/// let file = parse_joint(
///     "[joint]\nradius = '25 mm'\nrange = '-60..60 deg'\n\
///      [muscle_1]\nfile = 'biceps.toml'\ncontraction_at_neutral = '10%'\n\
///      [muscle_2]\nfile = 'triceps.toml'\ncontraction_at_neutral = '10%'\n",
/// )?;
/// assert_eq!(file.files().collect::<Vec<_>>(), ["biceps.toml", "triceps.toml"]);
/// # Ok::<(), mckibben::muscle::file::FileError>(())
/// ```
///
/// # Errors
/// [`FileError`] with line, column, key, what stood there and what is expected.
pub fn parse_joint(text: &str) -> Result<JointFile, FileError> {
    let source = Source::parse(text)?;
    let root = source.root();
    root.only(TOP, ALL)?;
    root.text("name", "a text in quotes")?;
    root.text("notes", "a text in quotes")?;
    let joint = root.section("joint", "joint")?;
    joint.only(JOINT, ALL)?;
    let radius = positive(&joint, "radius", Dimension::Length)?;
    let range_deg = match joint.values("range", Dimension::Angle, "")? {
        None => (-60.0, 60.0),
        Some((Values::Interval(low, high), _)) => (low, high),
        Some((Values::List(_), _)) => {
            return Err(
                joint.error("range", Problem::Said("must be two angles, as in \"-60..60 deg\"".into()))
            );
        }
    };
    let (mut muscles, mut pulleys) = (vec![], vec![]);
    for (name, sign) in [("muscle_1", 1.0), ("muscle_2", -1.0)] {
        let section = root.section(name, name)?;
        if !section.is_written() {
            if name == "muscle_1" {
                return Err(section.missing("file", None, "a joint has a muscle that turns it to +"));
            }
            continue;
        }
        section.only(MUSCLE, ALL)?;
        let file = section.text("file", "the path of a muscle file, in quotes")?;
        let file = file.ok_or_else(|| section.missing("file", None, "which muscle it is"))?;
        let contraction = section.quantity("contraction_at_neutral", Dimension::Ratio)?.unwrap_or(0.0);
        let path = path(&section, radius, sign)?;
        pulleys.push(pulley_friction(&section, &path)?);
        muscles.push((file.to_owned(), path, contraction));
    }
    let spring = spring(&root.section("spring", "spring")?, radius)?;
    let link = link(&root.section("link", "link")?, &joint)?;
    Ok(JointFile { muscles, pulleys, spring, link, range_deg })
}

/// A quantity above zero.
fn positive(section: &Section<'_>, key: &str, dimension: Dimension) -> Result<Option<f64>, FileError> {
    match section.quantity(key, dimension)? {
        Some(value) if value <= 0.0 => Err(section.error(key, Problem::Said("must be above zero".into()))),
        value => Ok(value),
    }
}

/// A pulley, of the section or of the joint, or two points.
fn path(section: &Section<'_>, radius: Option<f64>, sign: f64) -> Result<Path, FileError> {
    let point = |key: &str| -> Result<Option<[f64; 2]>, FileError> {
        let Some(list) = section.list(key, Some(Dimension::Length))? else { return Ok(None) };
        let two = list.try_into();
        let said = "must be two lengths x and y from the axis, as in [\"30 mm\", \"0 mm\"]";
        two.map(Some).map_err(|_| section.error(key, Problem::Said(said.into())))
    };
    let own = positive(section, "radius", Dimension::Length)?;
    match (point("origin")?, point("insertion")?) {
        (Some(origin_mm), Some(insertion_mm)) => Ok(Path::Points { origin_mm, insertion_mm }),
        (Some(_), None) => Err(section.missing("insertion", Some("origin"), "the point on the moving link")),
        (None, Some(_)) => Err(section.missing("origin", Some("insertion"), "the point on the fixed link")),
        (None, None) => {
            let radius = own.or(radius).ok_or_else(|| {
                section.missing(
                    "radius",
                    None,
                    "the pulley's radius, here or in [joint], or origin and insertion",
                )
            })?;
            Ok(Path::Pulley { radius_mm: sign * radius })
        }
    }
}

/// The friction of the rope on its pulley: both values, or neither.
fn pulley_friction(section: &Section<'_>, path: &Path) -> Result<PulleyFriction, FileError> {
    let angle = positive(section, "wrap_angle", Dimension::Angle)?;
    let said = |text: &str| Err(section.error("wrap_friction", Problem::Said(text.into())));
    match (angle, section.number("wrap_friction")?) {
        (None, None) => Ok(PulleyFriction::default()),
        (Some(_), None) => {
            Err(section.missing("wrap_friction", Some("wrap_angle"), "the coefficient of friction"))
        }
        (None, Some(_)) => {
            Err(section.missing("wrap_angle", Some("wrap_friction"), "the angle of the rope on its pulley"))
        }
        (Some(_), Some(_)) if matches!(path, Path::Points { .. }) => {
            said("needs a pulley: give radius, not origin and insertion")
        }
        (Some(_), Some(coefficient)) if coefficient < 0.0 => said("must not be below zero"),
        (Some(deg), Some(coefficient)) => Ok(PulleyFriction { coefficient, wrap_rad: deg.to_radians() }),
    }
}

fn spring(section: &Section<'_>, radius: Option<f64>) -> Result<Option<JointSpring>, FileError> {
    if !section.is_written() {
        return Ok(None);
    }
    section.only(SPRING, ALL)?;
    let rate = positive(section, "rate", Dimension::Stiffness)?;
    let angular = positive(section, "angular_rate", Dimension::AngularStiffness)?;
    match (rate, angular) {
        (Some(rate_n_per_mm), None) => {
            let preload_n = section.quantity("preload", Dimension::Force)?.unwrap_or(0.0);
            Ok(Some(JointSpring::Rope { path: path(section, radius, -1.0)?, rate_n_per_mm, preload_n }))
        }
        (None, Some(rate_nm_per_rad)) => {
            let preload_nm = section.quantity("preload_torque", Dimension::Torque)?.unwrap_or(0.0);
            Ok(Some(JointSpring::Torsion { rate_nm_per_rad, preload_nm }))
        }
        (Some(_), Some(_)) => {
            let said = "conflicts with angular_rate: a spring acts by a rope, or it is a torsion spring";
            Err(section.error("rate", Problem::Said(said.into())))
        }
        (None, None) => {
            Err(section.missing("rate", None, "of a spring on a rope, or angular_rate of a torsion spring"))
        }
    }
}

fn link(section: &Section<'_>, joint: &Section<'_>) -> Result<Link, FileError> {
    section.only(LINK, ALL)?;
    let value = |key: &str, dimension| Ok(section.quantity(key, dimension)?.unwrap_or(0.0));
    Ok(Link {
        mass_kg: value("mass", Dimension::Mass)?,
        centre_mm: value("centre", Dimension::Length)?,
        inclination_deg: value("inclination", Dimension::Angle)?,
        payload_kg: value("payload", Dimension::Mass)?,
        payload_at_mm: value("payload_at", Dimension::Length)?,
        inertia_kg_m2: positive(joint, "inertia", Dimension::Inertia)?,
        damping_nm_s_per_rad: joint.quantity("damping", Dimension::AngularDamping)?.unwrap_or(0.0),
    })
}
