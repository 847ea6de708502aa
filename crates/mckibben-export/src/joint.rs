//! A joint for a controller or a simulator: its muscles in closed form, on their ways about the
//! joint.

use crate::{
    Artefact, BoxRequest, ExportError, ExportTarget, ExportedMuscle, MARK, Result, muscle::plain,
    template::list,
};
use mckibben_core::{
    analysis::{Evaluation, Options},
    by_number::ByNumber,
    extremes::{even, peak},
    joint::{Joint, JointSpring, Path},
    model::{ForceModel, Workspace},
};
use serde::Serialize;

/// Angles and pressures at which the stiffness is compared.
const STATES: [u32; 2] = [24, 8];
/// The same where a host has other pulls than the form.
const HOST_STATES: [u32; 2] = [240, 120];
/// How many numbers a joint has beside its muscles.
pub const JOINT_NUMBERS: usize = 23;

/// A joint whose muscles are fitted for export.
#[derive(Debug, Clone, Serialize, schemars::JsonSchema)]
pub struct ExportedJoint {
    /// Name of the joint in the files.
    pub name: String,
    /// The first 16 digits of the SHA-256 of the joint and of the hashes of its muscles.
    pub hash: String,
    /// Its muscles, in the order of the joint file; lengths of the hosts are those of their paths.
    #[serde(skip)]
    pub muscles: Vec<ExportedMuscle>,
    /// Largest difference of the torque from that of `joint`, N m: the stated largest errors of the
    /// pulls on their largest arms.
    pub torque_error_nm: f64,
    /// The same of the stiffness, N m/rad, where each muscle is slack or pulls by more than 2 % of
    /// its blocked force: 1.5 times the largest at 200 states.
    pub stiffness_error_nm_per_rad: f64,
    #[serde(skip)]
    pub(crate) joint: Joint,
}

impl ExportedJoint {
    /// Fits each muscle over the contractions that it has in the range of the joint.
    ///
    /// # Errors
    /// [`ExportError`] of a muscle; a range in which a muscle is stretched further than its form
    /// reaches.
    pub fn fit(
        joint: &Joint,
        models: &[&dyn ForceModel],
        name: &str,
        supply_mpa: f64,
    ) -> Result<Self> {
        let angles = angles(joint, STATES[0]);
        let mut muscles = Vec::<ExportedMuscle>::new();
        let mut torque = 0.0;
        let mut stiffness = 0.0;
        let mut boxes: Vec<BoxRequest> = vec![];
        for (i, (&model, held)) in models.iter().zip(joint.muscles()).enumerate() {
            let all = angles
                .iter()
                .filter_map(|&angle| joint.contraction(i, angle));
            let at = |&angle: &f64| Some((joint.contraction(i, angle)?.0, angle));
            let shortest = angles.iter().filter_map(at).min_by_number(|a| a.0);
            let (least, angle) = shortest.unwrap_or_default();
            let reaches = |why: String| {
                ExportError::Host(format!(
                    "muscle {}: at {:.1} deg its contraction is {:.1} %, and {why}; a narrower [joint] \
                     range or a larger contraction_at_neutral keeps it shorter",
                    i + 1,
                    angle.to_degrees(),
                    100.0 * least
                ))
            };
            let contraction_low = (least < BoxRequest::LOW).then_some(least - 1e-3);
            let wanted = BoxRequest {
                supply_mpa,
                contraction_low,
                contraction_high: None,
            };
            // Opposed muscles are often alike: one fit serves both.
            let is_same = |other: &dyn ForceModel| {
                other.muscle() == model.muscle() && other.info().name == model.info().name
            };
            let known = boxes
                .iter()
                .zip(models)
                .position(|(of, other)| *of == wanted && is_same(*other));
            // Short enough that what tells the muscles apart stays in their identifiers.
            let name = format!("{name:.36}_{}", i + 1);
            let mut muscle = match known.and_then(|k| muscles.get(k)) {
                Some(known) => ExportedMuscle {
                    name,
                    ..known.clone()
                },
                None => match ExportedMuscle::fit(model, &name, wanted) {
                    Err(ExportError::Model(error)) if contraction_low.is_some() => {
                        return Err(reaches(format!("its model has no answer there: {error}")));
                    }
                    fitted => fitted?,
                },
            };
            boxes.push(wanted);
            if muscle.form.contraction_low > least {
                return Err(reaches(format!(
                    "its form is accurate from {:.1} %",
                    100.0 * muscle.form.contraction_low
                )));
            }
            let neutral_m = muscle.form.length_m * (1.0 - held.contraction_at_neutral);
            muscle.cord_m = 1e-3 * held.path.length_mm(0.0) - neutral_m;
            let arm_m = peak(all.map(|(_, s)| 1e-3 * s.arm_mm.abs()));
            torque += arm_m * muscle.errors.force_worst_ratio * muscle.blocked_force_n;
            stiffness += 1.5 * stiffness_error(joint, i, model, &muscle);
            muscles.push(muscle);
        }
        let hashes: String = muscles.iter().map(|muscle| muscle.hash.as_str()).collect();
        Ok(Self {
            name: name.to_owned(),
            hash: mckibben_core::hash::short(&format!("{joint:?}{hashes}")),
            muscles,
            torque_error_nm: torque,
            stiffness_error_nm_per_rad: stiffness,
            joint: joint.clone(),
        })
    }

    /// The files for a target.
    pub fn to(&self, target: ExportTarget) -> Result<Artefact> {
        let mut artefact = (target.joint)(self)?;
        // Muscles share files.
        let mut names = std::collections::BTreeSet::new();
        artefact
            .files
            .retain(|file| names.insert(file.name.clone()));
        Ok(artefact)
    }

    /// The facts in every artefact, a line each.
    pub fn facts(&self) -> Vec<String> {
        let mut facts = vec![
            format!(
                "Joint {}, {MARK} {}, hash {}. Licence of this file: MIT OR Apache-2.0.",
                plain(&self.name),
                env!("CARGO_PKG_VERSION"),
                self.hash
            ),
            format!(
                "Against the joint of the program: torque {:.3} N m at most; stiffness {:.3} N \
                 m/rad where each muscle is slack or pulls by more than 2 %.",
                self.torque_error_nm, self.stiffness_error_nm_per_rad
            ),
        ];
        facts.extend(
            self.muscles
                .iter()
                .flat_map(|muscle| muscle.facts().into_iter().take(3)),
        );
        facts
    }

    /// The name as a word of a programming language and of files, as of a muscle.
    pub fn identifier(&self) -> String {
        let word = crate::muscle::word(&self.name);
        if word.starts_with("joint") {
            word
        } else {
            format!("joint_{word}")
        }
    }

    /// The same joint where its muscles have other pulls (N, and their slopes in the length in N/m, at
    /// q and L/L0): its errors are those of the form and the largest differences of its muscles from the
    /// form.
    pub(crate) fn with_pulls(&self, pulls: impl Fn(usize, f64, f64) -> (f64, f64)) -> Self {
        let mut largest = [0.0_f64; 2];
        for angle in angles(&self.joint, HOST_STATES[0]) {
            let mut both = [0.0; 2];
            for (i, muscle) in self.muscles.iter().enumerate() {
                let at = |q, contraction| Some(pulls(i, q, 1.0 - contraction));
                let off = differences(&self.joint, i, muscle, (angle, HOST_STATES[1]), at);
                both = [both[0] + off[0], both[1] + off[1]];
            }
            largest = [largest[0].max(both[0]), largest[1].max(both[1])];
        }
        Self {
            torque_error_nm: self.torque_error_nm + largest[0],
            stiffness_error_nm_per_rad: self.stiffness_error_nm_per_rad + largest[1],
            ..self.clone()
        }
    }

    pub(crate) fn range_rad(&self) -> [f64; 2] {
        let (low, high) = self.joint.range_deg();
        [low, high].map(f64::to_radians)
    }

    /// The ways of two muscles and of a spring; a pulley of 1 m where there is none.
    pub(crate) fn paths(&self) -> [Path; 3] {
        let none = Path::Pulley { radius_mm: 1e3 };
        let of = |i: usize| self.joint.muscles().get(i).map_or(none, |m| m.path);
        let spring = match self.joint.spring() {
            Some(JointSpring::Rope { path, .. }) => *path,
            _ => none,
        };
        [of(0), of(1), spring]
    }

    /// Torque and slope of a torsion spring; pull and slope of a spring on a rope, in the length of
    /// its path.
    pub(crate) fn springs(&self) -> ([f64; 2], [f64; 2]) {
        match self.joint.spring() {
            None => ([0.0; 2], [0.0; 2]),
            Some(&JointSpring::Torsion {
                rate_nm_per_rad,
                preload_nm,
            }) => ([preload_nm, rate_nm_per_rad], [0.0; 2]),
            Some(&JointSpring::Rope {
                path,
                rate_n_per_mm,
                preload_n,
            }) => (
                [0.0; 2],
                [
                    preload_n - rate_n_per_mm * path.length_mm(0.0),
                    1e3 * rate_n_per_mm,
                ],
            ),
        }
    }

    /// The ways, springs, weight and range, as C has them, in SI units.
    pub(crate) fn numbers(&self) -> Vec<f64> {
        let path = |path: Path| match path {
            Path::Pulley { radius_mm } => [radius_mm, 0.0, 0.0, 0.0, 0.0],
            Path::Points {
                origin_mm: [x, y],
                insertion_mm: [u, v],
            } => [0.0, x, y, u, v],
        };
        let mut numbers =
            Vec::from_iter(self.paths().into_iter().flat_map(path).map(|mm| 1e-3 * mm));
        let inclination = self.joint.link().inclination_deg.to_radians();
        let (torsion, rope) = self.springs();
        let weight = [-self.joint.link().weight_nm(-inclination).0, inclination];
        numbers.extend([rope, torsion, weight, self.range_rad()].concat());
        numbers
    }

    /// The values for templates whose lists are between these brackets.
    pub(crate) fn values(
        &self,
        [open, close]: [&str; 2],
        one: impl Fn(f64) -> String + Copy,
    ) -> Vec<(&'static str, String)> {
        let numbers = self.numbers();
        let list = |values: &[f64]| list(values, [open, close], one);
        let path = |p: &[f64]| {
            format!(
                "{open}{}, {}, {}{close}",
                one(p[0]),
                list(&p[1..3]),
                list(&p[3..5])
            )
        };
        let (paths, others) = numbers.split_at(15);
        let paths: Vec<String> = paths.chunks_exact(5).map(path).collect();
        let mut values = vec![
            ("paths", format!("{open}{}{close}", paths.join(", "))),
            ("name", plain(&self.name)),
            ("version", env!("CARGO_PKG_VERSION").into()),
            ("ID", self.identifier().to_ascii_uppercase()),
            ("id", self.identifier()),
            ("count", self.muscles.len().to_string()),
        ];
        values.extend(
            ["rope", "torsion", "weight", "range"]
                .into_iter()
                .zip(others.chunks_exact(2).map(list)),
        );
        values
    }
}

/// So many angles and one, even over the range, in rad.
fn angles(joint: &Joint, parts: u32) -> Vec<f64> {
    let angles = even(joint.range_deg(), parts);
    angles.map(f64::to_radians).collect()
}

/// Largest difference of a muscle's part of the stiffness from its model, N m/rad.
fn stiffness_error(
    joint: &Joint,
    i: usize,
    model: &dyn ForceModel,
    muscle: &ExportedMuscle,
) -> f64 {
    let w = &mut Workspace::new();
    let mut evaluation = Evaluation::new(model, w, Options::extrapolating());
    let mut pulls = |q: f64, contraction| {
        let pressure_mpa = 1e-6 * muscle.form.supply_pa * q;
        let r = evaluation.response(pressure_mpa, contraction).ok()?;
        let n_per_mm = evaluation.stiffness_n_per_mm(&r).ok()?;
        let is_taut = r.force_n > 0.02 * muscle.blocked_force_n;
        is_taut.then_some((r.force_n, 1e3 * n_per_mm))
    };
    let at = |angle| differences(joint, i, muscle, (angle, STATES[1]), &mut pulls)[1];
    peak(angles(joint, STATES[0]).into_iter().map(at))
}

/// Largest differences of a muscle's parts of the torque and the stiffness, N m and N m/rad, from
/// pulls (N, and their slopes in the length in N/m) at q and ε, at an angle and so many pressures; of
/// the stiffness where it is slack or pulls by more than 2 % of its blocked force.
fn differences(
    joint: &Joint,
    i: usize,
    muscle: &ExportedMuscle,
    (angle, pressures): (f64, u32),
    mut other: impl FnMut(f64, f64) -> Option<(f64, f64)>,
) -> [f64; 2] {
    let mut largest = [0.0_f64; 2];
    let Some((contraction, s)) = joint.contraction(i, angle) else {
        return largest;
    };
    for n in 0..=pressures {
        let q = f64::from(n) / f64::from(pressures);
        let form = muscle.form.point_at(q * muscle.form.supply_pa, contraction);
        let Some((pull, slope)) = other(q, contraction) else {
            continue;
        };
        let more = 1e-3 * (pull - form.force_n);
        largest[0] = largest[0].max((more * s.arm_mm).abs());
        if form.force_n == 0.0 || form.force_n > 0.02 * muscle.blocked_force_n {
            let stiffer = 1e-6 * (slope - form.stiffness_n_per_m) * s.arm_mm * s.arm_mm;
            largest[1] = largest[1].max((stiffer - more * s.arm_by_angle_mm).abs());
        }
    }
    largest
}
