//! Joint files: TOML in the muscle file's manner.

use super::{Joint, JointError, JointMuscle, JointSpring, Link, Path, PulleyFriction};
use crate::{
    muscle::{
        Muscle,
        file::{FileError, Source},
    },
    units::{
        Interval, NotNegative, Positive,
        typed::{
            Angle, AngularDamping, AngularStiffness, Force, Inertia, Length, Mass, Ratio,
            Stiffness, Torque,
        },
    },
};
use schemars::JsonSchema;
use serde::Deserialize;

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
    pub fn with_muscles(&self, muscles: Vec<Muscle>) -> Result<Joint, JointError> {
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

/// A joint with one muscle and a spring, or with two muscles.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointKeys {
    /// The joint
    #[serde(default)]
    joint: OfJoint,
    /// The weight of the moving parts
    #[serde(default)]
    link: OfLink,
    /// The muscle that turns the joint to +
    muscle_1: OfMuscle,
    /// The muscle that turns the joint to -
    muscle_2: Option<OfMuscle>,
    /// A spring against the first muscle
    spring: Option<OfSpring>,
    /// Name, for people
    #[serde(rename = "name")]
    _name: Option<String>,
    /// Notes, for people
    #[serde(rename = "notes")]
    _notes: Option<String>,
}

#[derive(Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
struct OfJoint {
    /// Radius of the pulley of every muscle without its own geometry
    radius: Option<Positive<Length>>,
    /// Limits of the angle, such as "-60..60 deg"
    range: Option<Interval<Angle>>,
    /// Moment of inertia about the axis, with that of the link's mass and without the payload's, for
    /// motion
    inertia: Option<Positive<Inertia>>,
    /// Damping, for motion
    damping: AngularDamping,
}

#[derive(Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
struct OfLink {
    /// Mass of the moving parts
    mass: Mass,
    /// Distance of their centre of mass from the axis
    centre: Length,
    /// Angle of the line from the axis to it, against the horizontal, at the neutral angle
    inclination: Angle,
    /// Mass of a payload
    payload: Mass,
    /// Its distance from the axis
    payload_at: Length,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct OfMuscle {
    /// Path of the muscle file, relative to this file
    file: String,
    /// Contraction at the neutral angle
    #[serde(default)]
    contraction_at_neutral: Ratio,
    /// Angle of the rope on its pulley, at the neutral angle
    wrap_angle: Option<Positive<Angle>>,
    /// Coefficient of friction between rope and pulley
    wrap_friction: Option<NotNegative<f64>>,
    /// Radius of a pulley of its own
    radius: Option<Positive<Length>>,
    /// Point on the fixed link, x and y from the axis
    origin: Option<(Length, Length)>,
    /// Point on the moving link, x and y from the axis at the neutral angle
    insertion: Option<(Length, Length)>,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct OfSpring {
    /// Rate of a spring on a rope
    rate: Option<Positive<Stiffness>>,
    /// Its force at the neutral angle
    #[serde(default)]
    preload: Force,
    /// Rate of a torsion spring
    angular_rate: Option<Positive<AngularStiffness>>,
    /// Its torque at the neutral angle
    #[serde(default)]
    preload_torque: Torque,
    /// Radius of a pulley of its own
    radius: Option<Positive<Length>>,
    /// Point on the fixed link, x and y from the axis
    origin: Option<(Length, Length)>,
    /// Point on the moving link, x and y from the axis at the neutral angle
    insertion: Option<(Length, Length)>,
}

/// Reads the text of a joint file.
///
/// ```
/// use mckibben_core::joint::parse_joint;
/// let file = parse_joint(
///     "[joint]\nradius = '25 mm'\nrange = '-60..60 deg'\n\
///      [muscle_1]\nfile = 'biceps.toml'\ncontraction_at_neutral = '10%'\n\
///      [muscle_2]\nfile = 'triceps.toml'\ncontraction_at_neutral = '10%'\n",
/// )?;
/// assert_eq!(file.files().collect::<Vec<_>>(), ["biceps.toml", "triceps.toml"]);
/// # Ok::<(), mckibben_core::muscle::file::FileError>(())
/// ```
///
/// # Errors
/// [`FileError`] with line, column, key, what stood there and what is expected.
pub fn parse_joint(text: &str) -> Result<JointFile, FileError> {
    let source = Source::parse(text)?;
    let keys: JointKeys = source.read()?;
    let joint = keys.joint;
    let link = keys.link;
    let mut muscles = vec![];
    let mut pulleys = vec![];
    let both = [
        ("muscle_1", Some(keys.muscle_1), 1.0),
        ("muscle_2", keys.muscle_2, -1.0),
    ];
    for (name, muscle, sign) in both {
        let Some(muscle) = muscle else {
            continue;
        };
        let table = Table(&source, name);
        let radius = muscle.radius.or(joint.radius);
        let path = table.path(muscle.origin, muscle.insertion, radius, sign)?;
        pulleys.push(table.pulley_friction(muscle.wrap_angle, muscle.wrap_friction, &path)?);
        muscles.push((muscle.file, path, muscle.contraction_at_neutral.0));
    }
    let spring = keys.spring.map(|spring| spring.read(&source, joint.radius));
    Ok(JointFile {
        muscles,
        pulleys,
        spring: spring.transpose()?,
        link: Link {
            mass_kg: link.mass.0,
            centre_mm: link.centre.0,
            inclination_deg: link.inclination.0,
            payload_kg: link.payload.0,
            payload_at_mm: link.payload_at.0,
            inertia_kg_m2: joint.inertia.map(f64::from),
            damping_nm_s_per_rad: joint.damping.0,
        },
        range_deg: joint
            .range
            .map_or((-60.0, 60.0), |range| (range.low.0, range.high.0)),
    })
}

/// A table of the file.
struct Table<'s>(&'s Source<'s>, &'static str);

impl Table<'_> {
    fn error(&self, key: &str, problem: &str) -> FileError {
        self.0.error(&format!("{}.{key}", self.1), problem)
    }

    /// A pulley, of the table or of the joint, or two points.
    fn path(
        &self,
        origin: Option<(Length, Length)>,
        insertion: Option<(Length, Length)>,
        radius: Option<Positive<Length>>,
        sign: f64,
    ) -> Result<Path, FileError> {
        let inside = |(x, y): (Length, Length)| [x.0, y.0];
        let origin = ("origin", origin, "the point on the fixed link");
        let insertion = ("insertion", insertion, "the point on the moving link");
        match (self.0.both(self.1, origin, insertion)?, radius) {
            (Some((origin, insertion)), _) => Ok(Path::Points {
                origin_mm: inside(origin),
                insertion_mm: inside(insertion),
            }),
            (None, Some(radius)) => Ok(Path::Pulley {
                radius_mm: sign * f64::from(radius),
            }),
            (None, None) => {
                let needs = "the pulley's radius, here or in [joint], or origin and insertion";
                let missing = format!("{}.radius", self.1);
                Err(self.0.missing(&missing, self.1, needs))
            }
        }
    }

    /// The friction of the rope on its pulley: both values, or neither.
    fn pulley_friction(
        &self,
        angle: Option<Positive<Angle>>,
        coefficient: Option<NotNegative<f64>>,
        path: &Path,
    ) -> Result<PulleyFriction, FileError> {
        let angle = ("wrap_angle", angle, "the angle of the rope on its pulley");
        let friction = ("wrap_friction", coefficient, "the coefficient of friction");
        match self.0.both(self.1, angle, friction)? {
            None => Ok(PulleyFriction::default()),
            Some(_) if matches!(path, Path::Points { .. }) => {
                let said = "needs a pulley: give radius, not origin and insertion";
                Err(self.error("wrap_friction", said))
            }
            Some((angle, coefficient)) => Ok(PulleyFriction {
                coefficient: coefficient.into(),
                wrap_rad: f64::from(angle).to_radians(),
            }),
        }
    }
}

impl OfSpring {
    fn read(
        self,
        source: &Source<'_>,
        radius: Option<Positive<Length>>,
    ) -> Result<JointSpring, FileError> {
        let table = Table(source, "spring");
        match (self.rate, self.angular_rate) {
            (Some(rate), None) => {
                let radius = self.radius.or(radius);
                Ok(JointSpring::Rope {
                    path: table.path(self.origin, self.insertion, radius, -1.0)?,
                    rate_n_per_mm: rate.into(),
                    preload_n: self.preload.0,
                })
            }
            (None, Some(rate)) => Ok(JointSpring::Torsion {
                rate_nm_per_rad: rate.into(),
                preload_nm: self.preload_torque.0,
            }),
            (Some(_), Some(_)) => {
                let said = "conflicts with angular_rate: a spring acts by a rope, or it is a \
                    torsion spring";
                Err(table.error("rate", said))
            }
            (None, None) => {
                let needs = "of a spring on a rope, or angular_rate of a torsion spring";
                Err(source.missing("spring.rate", "spring", needs))
            }
        }
    }
}
