//! Joint files: TOML in the muscle file's manner.

use super::{Joint, JointError, JointMuscle, JointSpring, Link, Path, PulleyFriction};
use crate::muscle::Muscle;
use crate::muscle::file::{FileError, Section, Source};

/// A joint file: everything but the muscles themselves, which have their own files.
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
        let at = |(muscle, &(_, path, contraction_at_neutral)): (Muscle, &(String, Path, f64))| {
            JointMuscle {
                muscle,
                path,
                contraction_at_neutral,
            }
        };
        let list: Vec<JointMuscle> = muscles.into_iter().zip(&self.muscles).map(at).collect();
        if given != self.muscles.len() {
            return Err(JointError::Muscles(given));
        }
        let joint = Joint::new(list, self.spring, self.link, self.range_deg)?;
        Ok(Joint {
            pulleys: self.pulleys.clone(),
            ..joint
        })
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
    let source = Source::read(text, "joint-file people")?;
    let root = source.root();
    let joint = root.at("joint");
    let radius = joint.get("radius");
    let (mut muscles, mut pulleys) = (vec![], vec![]);
    for (name, sign) in [("muscle_1", 1.0), ("muscle_2", -1.0)] {
        let section = root.at(name);
        let Some(file) = section.get("file") else {
            continue;
        };
        let path = path(&section, radius, sign)?;
        pulleys.push(pulley_friction(&section, &path)?);
        muscles.push((
            file,
            path,
            section.get("contraction_at_neutral").unwrap_or(0.0),
        ));
    }
    let link = root.at("link");
    let value = |key: &str| link.get(key).unwrap_or(0.0);
    Ok(JointFile {
        muscles,
        pulleys,
        spring: spring(&root.at("spring"), radius)?,
        link: Link {
            mass_kg: value("mass"),
            centre_mm: value("centre"),
            inclination_deg: value("inclination"),
            payload_kg: value("payload"),
            payload_at_mm: value("payload_at"),
            inertia_kg_m2: joint.get("inertia"),
            damping_nm_s_per_rad: joint.get("damping").unwrap_or(0.0),
        },
        range_deg: joint.get("range").unwrap_or((-60.0, 60.0)),
    })
}

/// A pulley, of the section or of the joint, or two points.
fn path(section: &Section<'_>, radius: Option<f64>, sign: f64) -> Result<Path, FileError> {
    match (section.get("origin"), section.get("insertion")) {
        (Some(origin_mm), Some(insertion_mm)) => Ok(Path::Points {
            origin_mm,
            insertion_mm,
        }),
        (Some(_), None) => {
            Err(section.missing("insertion", Some("origin"), "the point on the moving link"))
        }
        (None, Some(_)) => {
            Err(section.missing("origin", Some("insertion"), "the point on the fixed link"))
        }
        (None, None) => {
            let needs = "the pulley's radius, here or in [joint], or origin and insertion";
            let radius = section.get("radius").or(radius);
            let radius: f64 = radius.ok_or_else(|| section.missing("radius", None, needs))?;
            Ok(Path::Pulley {
                radius_mm: sign * radius,
            })
        }
    }
}

/// The friction of the rope on its pulley: both values, or neither.
fn pulley_friction(section: &Section<'_>, path: &Path) -> Result<PulleyFriction, FileError> {
    const KEYS: (&str, &str) = ("wrap_angle", "wrap_friction");
    match (section.get::<f64>(KEYS.0), section.get(KEYS.1)) {
        (None, None) => Ok(PulleyFriction::default()),
        (Some(_), None) => {
            Err(section.missing(KEYS.1, Some(KEYS.0), "the coefficient of friction"))
        }
        (None, Some(_)) => {
            Err(section.missing(KEYS.0, Some(KEYS.1), "the angle of the rope on its pulley"))
        }
        (Some(_), Some(_)) if matches!(path, Path::Points { .. }) => Err(section.error(
            KEYS.1,
            "needs a pulley: give radius, not origin and insertion",
        )),
        (Some(deg), Some(coefficient)) => Ok(PulleyFriction {
            coefficient,
            wrap_rad: deg.to_radians(),
        }),
    }
}

fn spring(section: &Section<'_>, radius: Option<f64>) -> Result<Option<JointSpring>, FileError> {
    if !section.is_written() {
        return Ok(None);
    }
    match (section.get("rate"), section.get("angular_rate")) {
        (Some(rate_n_per_mm), None) => {
            let preload_n = section.get("preload").unwrap_or(0.0);
            Ok(Some(JointSpring::Rope {
                path: path(section, radius, -1.0)?,
                rate_n_per_mm,
                preload_n,
            }))
        }
        (None, Some(rate_nm_per_rad)) => {
            let preload_nm = section.get("preload_torque").unwrap_or(0.0);
            Ok(Some(JointSpring::Torsion {
                rate_nm_per_rad,
                preload_nm,
            }))
        }
        (Some(_), Some(_)) => {
            let said =
                "conflicts with angular_rate: a spring acts by a rope, or it is a torsion spring";
            Err(section.error("rate", said))
        }
        (None, None) => Err(section.missing(
            "rate",
            None,
            "of a spring on a rope, or angular_rate of a torsion spring",
        )),
    }
}
