//! A joint for a controller or a simulator: its muscles in closed form, on their ways about the
//! joint.

use crate::{
    Artefact, BoxRequest, ExportError, ExportTarget, ExportedMuscle, MARK, Result,
    fit::{TAUT, free_contraction},
    muscle::plain,
    template::{list, lists},
};
use mckibben_core::{
    extremes::{ends, even, peak},
    joint::{Joint, JointSpring, Path, Shortening},
    model::{ForceModel, Workspace},
};
use serde::Serialize;

/// Angles of the range at which contractions and arms are looked at.
const ANGLES: u32 = 96;
/// By so much the box of a muscle is wider than its contractions in the range of the joint.
const BESIDE: f64 = 1e-3;
/// The least upper end of a box.
const LEAST_HIGH: f64 = 0.01;
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
    /// its blocked force: those of pulls and slopes on their largest arms.
    pub stiffness_error_nm_per_rad: f64,
    /// The joint, whose muscles were fitted.
    #[serde(skip)]
    pub joint: Joint,
}

/// Pairs of numbers with their names.
type Pairs = [(&'static str, [f64; 2]); 4];

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
        let mut muscles = Vec::<ExportedMuscle>::new();
        let mut torque = 0.0;
        let mut stiffness = 0.0;
        for (i, (&model, held)) in models.iter().zip(joint.muscles()).enumerate() {
            let states = Vec::from_iter(states(joint, i));
            // Short enough that what tells the muscles apart stays in their identifiers.
            let mut muscle =
                fit_muscle(model, &format!("{name:.36}_{}", i + 1), supply_mpa, &states)?;
            let neutral_m = muscle.form.length_m * (1.0 - held.contraction_at_neutral);
            muscle.cord_m = held.path.length_mm(0.0) / 1e3 - neutral_m;
            let arm_m = peak(states.iter().map(|s| 1e-3 * s.1.arm_mm.abs()));
            let arm_by_angle_m = peak(states.iter().map(|s| 1e-3 * s.1.arm_by_angle_mm.abs()));
            let force_n = muscle.errors.force_worst_ratio * muscle.blocked_force_n;
            let at_rest = muscle.form.point_at(muscle.form.supply_pa, 0.0);
            let n_per_m = muscle.errors.stiffness_worst_ratio * at_rest.stiffness_n_per_m.abs();
            torque += arm_m * force_n;
            stiffness += arm_m * arm_m * n_per_m + arm_by_angle_m * force_n;
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
                "Against the joint of built muscles: torque {:.3} N m at most; stiffness {:.3} N \
                 m/rad where each muscle is slack or pulls by more than {} %.",
                self.torque_error_nm,
                self.stiffness_error_nm_per_rad,
                100.0 * TAUT
            ),
        ];
        facts.extend(self.muscles.iter().flat_map(|muscle| {
            muscle
                .facts()
                .into_iter()
                .filter(|fact| !fact.contains("against"))
        }));
        facts
    }

    /// The name as a word of a programming language and of files, as of a muscle.
    pub fn identifier(&self) -> String {
        crate::muscle::identifier("joint", &self.name)
    }

    /// Its range in rad from the neutral angle.
    pub fn range_rad(&self) -> [f64; 2] {
        let (low, high) = self.joint.range_deg();
        [low, high].map(f64::to_radians)
    }

    /// The ways of two muscles and of a spring; a pulley of 1 m where there is none.
    pub fn paths(&self) -> [Path; 3] {
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
    pub fn springs(&self) -> ([f64; 2], [f64; 2]) {
        let none = [0.0; 2];
        match self.joint.spring() {
            None => (none, none),
            Some(&JointSpring::Torsion {
                rate_nm_per_rad,
                preload_nm,
            }) => ([preload_nm, rate_nm_per_rad], none),
            Some(&JointSpring::Rope {
                path,
                rate_n_per_mm,
                preload_n,
            }) => (
                none,
                [
                    preload_n - rate_n_per_mm * path.length_mm(0.0),
                    1e3 * rate_n_per_mm,
                ],
            ),
        }
    }

    /// The ways, springs, weight and range, as C has them, in SI units.
    pub fn numbers(&self) -> ([Vec<f64>; 3], Pairs) {
        let paths = self.paths().map(|path| {
            let mm = match path {
                Path::Pulley { radius_mm } => [radius_mm, 0.0, 0.0, 0.0, 0.0],
                Path::Points {
                    origin_mm: [x, y],
                    insertion_mm: [u, v],
                } => [0.0, x, y, u, v],
            };
            mm.map(|mm| mm / 1e3).to_vec()
        });
        let inclination = self.joint.link().inclination_deg.to_radians();
        let (torsion, rope) = self.springs();
        let weight = [-self.joint.link().weight_nm(-inclination).0, inclination];
        let range = self.range_rad();
        (
            paths,
            [
                ("rope", rope),
                ("torsion", torsion),
                ("weight", weight),
                ("range", range),
            ],
        )
    }

    /// The values for templates whose lists are between these brackets.
    pub fn values(
        &self,
        brackets: [&str; 2],
        one: impl Fn(f64) -> String + Copy,
    ) -> Vec<(&'static str, String)> {
        let (paths, others) = self.numbers();
        let mut values = vec![
            ("paths", lists(&paths, brackets, one)),
            ("name", plain(&self.name)),
            ("version", env!("CARGO_PKG_VERSION").into()),
            ("ID", self.identifier().to_ascii_uppercase()),
            ("id", self.identifier()),
            ("count", self.muscles.len().to_string()),
        ];
        values.extend(others.map(|(name, pair)| (name, list(&pair, brackets, one))));
        values
    }
}

/// The contractions of a muscle over the range, with the arms and the angles in degrees.
fn states(joint: &Joint, i: usize) -> impl Iterator<Item = (f64, Shortening, f64)> {
    even(joint.range_deg(), ANGLES).filter_map(move |deg| {
        let (contraction, s) = joint.contraction(i, deg.to_radians())?;
        Some((contraction, s, deg))
    })
}

/// A muscle fitted over its contractions in the range of the joint, as far as it pulls.
fn fit_muscle(
    model: &dyn ForceModel,
    name: &str,
    supply_mpa: f64,
    states: &[(f64, Shortening, f64)],
) -> Result<ExportedMuscle> {
    let (least, most) = ends(states.iter().map(|s| s.0));
    let free = free_contraction(model, &mut Workspace::new(), supply_mpa)?;
    let wanted = BoxRequest {
        supply_mpa,
        contraction_low: if least < 0.0 { least - BESIDE } else { 0.0 },
        contraction_high: Some((most + BESIDE).max(LEAST_HIGH).min(free)),
    };
    ExportedMuscle::fit(model, name, wanted).map_err(|error| match error {
        ExportError::Cancelled(_) => error,
        error => {
            let at = states.iter().find(|s| s.0 == least);
            ExportError::Host(format!(
                "{name}: at {:.1} deg its contraction is {:.1} %; {error}; a narrower [joint] \
                 range or a larger contraction_at_neutral keeps it shorter",
                at.map_or(0.0, |s| s.2),
                100.0 * least
            ))
        }
    })
}
