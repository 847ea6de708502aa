//! `joint`: torque, stiffness, rest angles and pressures of a muscle against a spring, or of two
//! against each other.

mod answer;
mod page;

pub use answer::{JointAnswer, JointRow, RestWord};

use crate::{
    Count, Model, ModelFields, MuscleFields, PressureLimits, Problem, ProblemKind, Result,
    TextFile, Units, above_zero, breakdown, burst_of, figure, finite, flags::Args, number,
    warnings,
};
use mckibben_core::{
    by_number::ByNumber,
    cancel,
    joint::{
        BoundJoint, Joint, JointError, JointMap, JointMuscle, JointPoint, JointTarget, Rest,
        Turning, parse_joint,
    },
    model::{ForceModel, Workspace},
    progress::Progress,
    size, threads,
    units::typed::{Angle, AngularStiffness, List, Pressure, Torque},
    warning::Warning,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A joint: its file and those of its muscles.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct JointFields {
    /// Joint file (TOML).
    pub joint: Option<TextFile>,
    /// The muscle files that it names, each under the name that is there.
    pub muscles: Vec<TextFile>,
}

impl JointFields {
    /// The names of the muscle files that a joint file names.
    pub fn files_of(joint: &TextFile) -> Result<Vec<String>> {
        Ok(joint
            .parsed(parse_joint)?
            .files()
            .map(str::to_owned)
            .collect())
    }

    /// The joint of its file, with its muscles.
    pub fn resolve(&self) -> Result<Joint> {
        let text = self
            .joint
            .as_ref()
            .ok_or_else(|| Problem::missing("joint", "a joint file (TOML)"))?;
        let file = text.parsed(parse_joint)?;
        let muscle = |name: &str| {
            let missing = || {
                let message = format!("{}: its muscle file {name} is missing", text.name);
                ProblemKind::File.problem(message).in_field("muscles")
            };
            let found = self.muscles.iter().find(|m| m.name == name);
            MuscleFields::from_file(found.ok_or_else(missing)?.clone()).resolve()
        };
        let muscles = file.files().map(muscle).collect::<Result<Vec<_>>>()?;
        file.with_muscles(muscles)
            .map_err(|e| ProblemKind::File.problem(format!("{}: {e}", text.name)))
    }
}

/// A joint. Pressures and angles give its torques; pressures alone give its rest position; angles
/// alone give the pressures for a torque and a stiffness.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct JointRequest {
    /// The joint.
    #[serde(flatten)]
    #[arg(skip)]
    pub joint: JointFields,
    /// Pressures of the muscles, such as 2bar,1bar; may be repeated for a family
    #[arg(short, long, value_name = "PRESSURES")]
    pub pressures_mpa: Vec<List<Pressure>>,
    /// Angles from the neutral one
    #[arg(long)]
    pub angles_deg: Option<List<Angle>>,
    /// Torque: without pressures the required torque [0]; with pressures alone an external torque
    /// that turns to +
    #[arg(long)]
    pub torque_nm: Option<Torque>,
    /// Required stiffness [the lowest pressures]
    #[arg(long)]
    pub stiffness_nm_per_rad: Option<AngularStiffness>,
    /// Supply pressure, for computed pressures and for the map [6bar]
    #[arg(long)]
    pub max_pressure_mpa: Option<Pressure>,
    /// Map of the reachable angles and stiffnesses, with this number of pressures of each muscle
    #[arg(long, value_name = "N")]
    pub map: Option<Count<2, 65535>>,
    /// The model.
    #[serde(deserialize_with = "ModelFields::or_name")]
    #[command(flatten)]
    pub model: ModelFields,
    /// Compute outside the model's range too, with a warning
    #[arg(long, help_heading = "Advanced")]
    pub extrapolate: bool,
    /// Leave out P′ of the muscles, the pressures below which they are slack, which takes most of
    /// the time.
    #[arg(skip)]
    pub without_start_pressures: bool,
    /// Add a figure to the answer, in these units: `bar`, or `psi,lbf,in`.
    #[arg(skip)]
    pub figure: Option<Units>,
}

/// Pressure of the supply where none is said, MPa.
const SUPPLY_MPA: f64 = 0.6;
/// Share of a torque within which built muscles give it, and how often it is asked for.
const NEAR: f64 = 1e-4;
const MOST_ROUNDS: usize = 30;
/// Memory of a point of a map, bytes.
const MAP_POINT_BYTES: f64 = 500.0;

/// The command `joint`: torques and stiffnesses of two muscles on a joint.
pub fn joint(request: &JointRequest, progress: &dyn Progress) -> Result<JointAnswer> {
    let joint = request.joint.resolve()?;
    let named = request.model.choose()?;
    let models = models_of(&joint, &named)?;
    let model = BoundJoint::new(joint.clone(), models.clone(), request.extrapolate)?;
    let mut solver = Solver {
        model: &model,
        workspaces: model.workspaces(),
        warnings: joint.doubts().into_iter().map(Warning::from).collect(),
    };
    let rows = solver.rows(request, progress);
    cancel::check()?;
    let mut rows = rows?;
    if !request.without_start_pressures {
        add_start_pressures(&model, &mut rows);
        cancel::check()?;
    }
    let mut supplied_mpa = 0.0;
    let map = match request.map {
        Some(count) => {
            supplied_mpa = supply(request)?;
            Some(solver.map(supplied_mpa, count.0, progress)?)
        }
        None => None,
    };
    if rows.is_empty() && map.is_none() {
        return Err(Problem::usage(
            "the request is incomplete: give `pressures_mpa`, `angles_deg` or `map`",
            "`pressures_mpa` alone gives the rest position",
        ));
    }
    let bursts = models
        .iter()
        .map(|m| burst_of(&named, &**m))
        .collect::<Result<Vec<_>>>()?;
    let highest = |i: usize| {
        rows.iter()
            .filter_map(|row| [Some(row.pressure_1_mpa), row.pressure_2_mpa][i])
            .fold(supplied_mpa, f64::max)
    };
    let said = bursts
        .iter()
        .enumerate()
        .flat_map(|(i, burst)| burst.warnings(highest(i)));
    let mut warnings = Warning::gravest(&solver.warnings);
    Warning::put_first(&mut warnings, said);
    let mut answer = JointAnswer {
        uncertainty_text: largest_uncertainty(&rows),
        limits: PressureLimits::of_all(&bursts),
        model: models
            .first()
            .map_or_else(String::new, |m| m.info().name.to_string()),
        muscles: joint.muscles().iter().map(|m| (&m.muscle).into()).collect(),
        range_deg: joint.range_deg(),
        points: rows,
        map,
        warnings,
        figure: None,
    };
    let figure = request.figure.as_ref();
    answer.figure =
        figure.and_then(|unit| figure::joint(&answer, request.angles_deg.is_some(), unit));
    Ok(answer)
}

/// The models of its muscles.
pub fn models_of(joint: &Joint, choice: &Model) -> Result<Vec<Arc<dyn ForceModel>>> {
    joint
        .muscles()
        .iter()
        .map(|m| Ok(choice.build(&m.muscle)?.into()))
        .collect()
}

/// What is said of points that are left out.
fn gaps(left_out: usize, of: usize, what: &str, reason: &str) -> Warning {
    Warning::from(format!("{left_out} of {of} {what} are left out: {reason}"))
}

fn supply(request: &JointRequest) -> Result<f64> {
    above_zero(
        ProblemKind::Quantity,
        "max_pressure_mpa",
        request.max_pressure_mpa.map_or(SUPPLY_MPA, f64::from),
    )
}

struct Solver<'m> {
    model: &'m BoundJoint,
    workspaces: Vec<Workspace>,
    warnings: Vec<Warning>,
}

impl JointRequest {
    /// Whether pressures are sought.
    fn is_wanted(&self) -> bool {
        self.torque_nm.is_some() || self.stiffness_nm_per_rad.is_some()
    }

    /// Which fields exclude each other, and which ones need others.
    fn validate(&self) -> Result<()> {
        let has_angles = self.angles_deg.is_some();
        if self.pressures_mpa.is_empty() {
            if self.is_wanted() && !has_angles {
                return Err(Problem::missing(
                    "angles_deg",
                    "the angle at which the torque and the stiffness are required",
                ));
            }
        } else {
            Problem::refuse_unused(
                &[("stiffness_nm_per_rad", self.stiffness_nm_per_rad.is_some())],
                "it applies if the pressures are computed, and `pressures_mpa` are given",
            )?;
            let torque = self.torque_nm.is_some() && has_angles;
            Problem::refuse_unused(
                &[("torque_nm", torque)],
                "with `pressures_mpa` and `angles_deg` the torque is the answer",
            )?;
            let supply = self.max_pressure_mpa.is_some() && self.map.is_none();
            Problem::refuse_unused(
                &[("max_pressure_mpa", supply)],
                "it limits pressures that are computed, and `pressures_mpa` are given",
            )?;
        }
        for &p in self.pressures_mpa.iter().flat_map(|list| list.iter()) {
            if !(p.is_finite() && p >= 0.0) {
                return Err(ProblemKind::Quantity
                    .problem(format!(
                        "{p}\u{a0}MPa is not a valid gauge pressure of a muscle"
                    ))
                    .in_field("pressures_mpa"));
            }
        }
        for &angle in self.angles_deg.as_deref().unwrap_or_default() {
            finite("angles_deg", angle)?;
        }
        finite("torque_nm", self.torque_nm.unwrap_or_default())?;
        finite(
            "stiffness_nm_per_rad",
            self.stiffness_nm_per_rad.unwrap_or_default(),
        )
        .map(drop)
    }
}

impl Solver<'_> {
    fn map(&mut self, supply_mpa: f64, count: usize, progress: &dyn Progress) -> Result<JointMap> {
        let points = (count as f64).powi(self.workspaces.len() as i32);
        size::points("map", points)?;
        size::bytes("map", MAP_POINT_BYTES * points)?;
        self.warnings.extend(
            self.model
                .outside(supply_mpa)?
                .into_iter()
                .map(Warning::from),
        );
        let map = self.model.map(supply_mpa, count, progress)?;
        let gap = map.gaps.first();
        let gap = gap.map(|gap| gaps(map.gaps.len(), map.points.len(), "points", &gap.reason));
        self.warnings.extend(gap);
        Ok(map)
    }

    fn rows(&mut self, request: &JointRequest, progress: &dyn Progress) -> Result<Vec<JointRow>> {
        request.validate()?;
        let families = &request.pressures_mpa;
        let angles = request.angles_deg.as_deref();
        let all = families.len().max(1) * angles.map_or(1, <[f64]>::len);
        size::points("angles_deg", all as f64)?;
        match (families.is_empty(), angles) {
            (true, None) => Ok(vec![]),
            (true, Some(_)) if !request.is_wanted() && request.map.is_some() => Ok(vec![]),
            (true, Some(angles)) => self.rows_of_targets(request, angles),
            (false, Some(angles)) => self.rows_along(families, angles, progress),
            (false, None) => {
                self.rows_at_rest(families, request.torque_nm.unwrap_or_default().into())
            }
        }
    }

    /// The pressures at which built muscles give a torque, where that is known: their model is asked
    /// for as much more as they give less.
    fn built_point(&mut self, wanted: JointTarget, max_mpa: f64) -> Result<JointPoint, JointError> {
        let mut point = self
            .model
            .pressures(&mut self.workspaces, wanted, max_mpa)?;
        let mut asked = wanted;
        for _ in 0..MOST_ROUNDS {
            let miss_nm = wanted.torque_nm - point.predicted_nm.unwrap_or(wanted.torque_nm);
            if miss_nm.abs() <= NEAR * wanted.torque_nm.abs() {
                break;
            }
            asked.torque_nm += miss_nm;
            let found = self.model.pressures(&mut self.workspaces, asked, max_mpa);
            point = found.map_err(|error| match error {
                JointError::OutOfReach { most, message } => JointError::OutOfReach {
                    most,
                    message: format!(
                        "built muscles give {} N m where their model gives {:.4}: {message}",
                        wanted.torque_nm, asked.torque_nm
                    ),
                },
                other => other,
            })?;
        }
        Ok(point)
    }

    /// The pressures of a torque and a stiffness at each angle.
    fn rows_of_targets(&mut self, request: &JointRequest, angles: &[f64]) -> Result<Vec<JointRow>> {
        let max_mpa = supply(request)?;
        let row = |&angle_deg: &f64| {
            let wanted = JointTarget {
                angle_deg,
                torque_nm: request.torque_nm.unwrap_or_default().into(),
                stiffness_nm_per_rad: request.stiffness_nm_per_rad.map(f64::from),
            };
            let point = if request.model.name.is_some() {
                self.model
                    .pressures(&mut self.workspaces, wanted, max_mpa)?
            } else {
                self.built_point(wanted, max_mpa)?
            };
            let halves = self
                .model
                .pressure_uncertainties_mpa(&mut self.workspaces, &point);
            let half = |i: usize| halves.get(i).copied().flatten();
            Ok(JointRow {
                pressure_1_uncertainty_mpa: half(0),
                pressure_2_uncertainty_mpa: half(1),
                ..self.row(point, None)?
            })
        };
        angles.iter().map(row).collect()
    }

    /// The torques of each family over the angles; beside angles at which a muscle has no state a
    /// family goes on.
    fn rows_along(
        &mut self,
        families: &[List<Pressure>],
        angles: &[f64],
        progress: &dyn Progress,
    ) -> Result<Vec<JointRow>> {
        let mut rows = vec![];
        for (i, pressures) in families.iter().enumerate() {
            progress.report(i, families.len());
            progress.check()?;
            let points = self.model.along(&mut self.workspaces, pressures, angles);
            let is_gap = |e: &Result<_, JointError>| e.as_ref().is_err_and(JointError::is_of_point);
            let without = points.iter().filter(|point| is_gap(point)).count();
            let only = without == points.len();
            let mut gap = None;
            for point in points {
                match point {
                    Err(error) if !only && error.is_of_point() => gap = gap.or(Some(error)),
                    point => rows.push(self.row(point?, None)?),
                }
            }
            self.warnings
                .extend(gap.map(|error| gaps(without, angles.len(), "angles", &error.to_string())));
        }
        Ok(rows)
    }

    /// The angles at which each family rests against a torque.
    fn rows_at_rest(
        &mut self,
        families: &[List<Pressure>],
        torque_nm: f64,
    ) -> Result<Vec<JointRow>> {
        let mut rows = vec![];
        for pressures in families {
            let (rests, gap) =
                self.model
                    .rests_and_gap(&mut self.workspaces, pressures, torque_nm)?;
            self.warnings
                .extend(gap.map(|gap| Warning::from(format!("other rests are not sought: {gap}"))));
            for rest in rests {
                let point = self.model.point_at(
                    &mut self.workspaces,
                    pressures,
                    rest.angle_deg(),
                    Turning::Mean,
                )?;
                let balance = matches!(rest, Rest::Balance { .. });
                rows.push(JointRow {
                    angle_uncertainty_deg: self
                        .model
                        .angle_uncertainty_deg(&point)
                        .filter(|_| balance),
                    ..self.row(point, Some((&rest).into()))?
                });
            }
        }
        Ok(rows)
    }

    fn row(&mut self, point: JointPoint, rest: Option<RestWord>) -> Result<JointRow> {
        let (model, workspaces) = (self.model, &mut self.workspaces);
        let mut torque_nm = |turning| {
            let at = model.point_at(workspaces, &point.pressures_mpa, point.angle_deg, turning);
            at.map(|at| at.torque_nm)
        };
        let [plus, minus] = [Turning::Plus, Turning::Minus].map(|turning| {
            let is_known = model.joint().has_friction();
            is_known.then(|| torque_nm(turning)).transpose()
        });
        self.warnings
            .extend(warnings::of_points(point.muscles.iter().map(|m| &m.answer)));
        let muscle = |i: usize| {
            let m = point.muscles.get(i)?;
            Some((m.answer.response, m.arm_mm, m.answer.slack))
        };
        let (response, arm_1_mm, slack_1) = muscle(0).unwrap_or_default();
        let second = muscle(1);
        Ok(JointRow {
            pressure_1_mpa: point.pressures_mpa.first().copied().unwrap_or_default(),
            pressure_2_mpa: point.pressures_mpa.get(1).copied(),
            torque_turning_plus_nm: plus?,
            torque_turning_minus_nm: minus?,
            rest,
            force_1_n: response.force_n,
            force_2_n: second.map(|m| m.0.force_n),
            contraction_1: response.contraction,
            contraction_2: second.map(|m| m.0.contraction),
            arm_1_mm,
            arm_2_mm: second.map(|m| m.1),
            slack_1,
            slack_2: second.map(|m| m.2),
            point,
            ..JointRow::default()
        })
    }
}

/// The largest ± of the torques, in words.
fn largest_uncertainty(rows: &[JointRow]) -> Option<String> {
    let known = rows
        .iter()
        .filter_map(|row| Some((row.point.angle_deg, row.point.uncertainty_parts_nm?)));
    let (angle_deg, parts) = known.max_by_number(|a| a.1.total())?;
    let angle = number(
        if angle_deg.abs() < 1e-9 {
            0.0
        } else {
            angle_deg
        },
        4,
    );
    Some(format!(
        "at φ {angle}°: {}",
        breakdown(&parts, &crate::units::NEWTON_METRES)
    ))
}

/// A kind of muscle and its contraction, as a key: those of opposed muscles at opposite angles
/// differ by rounding.
fn key(kind: usize, contraction: f64) -> (usize, i64) {
    (kind, (1e12 * contraction).round() as i64)
}

/// Adds P′ to rows: each contraction of each kind of muscle once, on all threads.
fn add_start_pressures(model: &BoundJoint, rows: &mut [JointRow]) {
    let muscles = model.joint().muscles();
    let digest = |m: &JointMuscle| m.muscle.digest();
    let alike = muscles.first().map(digest) == muscles.last().map(digest);
    let kinds = [0, usize::from(!alike)];
    let contractions = |row: &JointRow| [Some(row.contraction_1), row.contraction_2];
    let mut wanted = BTreeMap::new();
    for row in &*rows {
        wanted.extend(
            kinds
                .into_iter()
                .zip(contractions(row))
                .filter_map(|(kind, e)| Some((key(kind, e?), e?))),
        );
    }
    let wanted = Vec::from_iter(wanted);
    let pressures = threads::map(&wanted, |&((kind, _), contraction)| {
        model.start_pressure_mpa(kind, &mut Workspace::new(), contraction)
    });
    let pressures = BTreeMap::from_iter(wanted.into_iter().map(|(key, _)| key).zip(pressures));
    let start_pressure = |i: usize, e: f64| pressures.get(&key(kinds[i], e)).copied().flatten();
    for row in rows {
        row.start_pressure_1_mpa = start_pressure(0, row.contraction_1);
        row.start_pressure_2_mpa = row.contraction_2.and_then(|e| start_pressure(1, e));
    }
}
