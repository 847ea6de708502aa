//! Joints against virtual work, symmetry and their own inverses.

use super::rows::Rows;
use mckibben_core::{
    analysis::{Evaluation, Options},
    joint::{BoundJoint, Joint, JointMuscle, JointSpring, JointTarget, Link, Path, Rest, Turning},
    load::GRAVITY_M_PER_S2,
    model::{ForceModel, Ideal, Workspace},
    muscle::{Muscle, Tube},
    random::Random,
};
use std::sync::Arc;

/// Random joints of the inverse round trip.
const JOINTS: usize = 10_000;
/// Step of the differences in degrees.
const STEP_DEG: f64 = 1e-3;

fn muscle(path: Path, contraction_at_neutral: f64) -> JointMuscle {
    JointMuscle {
        muscle: Muscle::prototype(),
        path,
        contraction_at_neutral,
    }
}

/// An elbow with attachment points, a torsion spring and weight.
fn elbow() -> Option<Joint> {
    let points = |origin_mm, insertion_mm| Path::Points {
        origin_mm,
        insertion_mm,
    };
    let muscles = vec![
        muscle(points([-10.0, 330.0], [45.0, 5.0]), 0.08),
        muscle(points([-30.0, 310.0], [-40.0, -2.0]), 0.12),
    ];
    let link = Link {
        mass_kg: 1.2,
        centre_mm: 150.0,
        inclination_deg: -20.0,
        payload_kg: 0.5,
        payload_at_mm: 300.0,
        ..Link::default()
    };
    let spring = JointSpring::Torsion {
        rate_nm_per_rad: 1.5,
        preload_nm: 0.2,
    };
    Joint::new(muscles, Some(spring), link, (-45.0, 60.0)).ok()
}

/// The muscles of a joint as ideal ones.
fn ideals(joint: &Joint) -> Vec<Ideal> {
    joint
        .muscles()
        .iter()
        .map(|m| Ideal::between_ends(&m.muscle))
        .collect()
}

fn model(joint: &Joint, ideals: &[Ideal]) -> Option<BoundJoint> {
    let shared = |m: &Ideal| Arc::new(m.clone()) as Arc<dyn ForceModel>;
    BoundJoint::new(joint.clone(), ideals.iter().map(shared).collect(), true).ok()
}

/// (W(φ + h) − W(φ − h))/2h against τ, and −dτ/dφ by differences.
pub fn virtual_work(rows: &mut Rows) {
    let joint = elbow().unwrap();
    let models = ideals(&joint);
    let model = model(&joint, &models).unwrap();
    let pressures = [0.2, 0.12];
    let at = |deg: f64| {
        let workspaces = &mut model.workspaces();
        model
            .point_at(workspaces, &pressures, deg, Turning::Mean)
            .ok()
    };
    let work = |deg: f64| {
        let angle = deg.to_radians();
        let work = |i: usize| {
            let (e, _) = joint.contraction(i, angle)?;
            Evaluation::new(&models[i], &mut Workspace::new(), Options::default())
                .work_per_stroke_j(pressures[i], 0.0, e)
                .ok()
        };
        let height = 1e-3 * (1.2 * 150.0 + 0.5 * 300.0) * (angle - 20f64.to_radians()).sin();
        Some(work(0)? + work(1)? - GRAVITY_M_PER_S2 * height - (0.2 * angle + 0.75 * angle * angle))
    };
    let slope = |f: &dyn Fn(f64) -> Option<f64>, deg: f64| {
        Some((f(deg + STEP_DEG)? - f(deg - STEP_DEG)?) / (2.0 * STEP_DEG.to_radians()))
    };
    for deg in [-40.0, -10.0, 0.0, 25.0, 55.0] {
        let point = at(deg);
        let torque = slope(&work, deg);
        let stiffness = slope(&|deg| at(deg).map(|p| p.torque_nm), deg).map(|slope| -slope);
        let (ours, stiff) = point.map(|p| (p.torque_nm, p.stiffness_nm_per_rad)).unzip();
        let name = |what: &str| format!("elbow at {deg}°: {what}");
        rows.add(name("torque (N m)"), torque, ours, 1e-6);
        rows.add(name("stiffness (N m/rad)"), stiffness, stiff, 1e-5);
    }
}

/// Rest in the middle, with r²(K1 + K2).
pub fn symmetric(rows: &mut Rows) {
    let radius = 25.0;
    let on = |radius_mm: f64| muscle(Path::Pulley { radius_mm }, 0.1);
    let joint = Joint::new(
        vec![on(radius), on(-radius)],
        None,
        Link::default(),
        (-60.0, 60.0),
    )
    .unwrap();
    let ideals = ideals(&joint);
    let model = model(&joint, &ideals).unwrap();
    let workspaces = &mut model.workspaces();
    let rest = match model.rests(workspaces, &[0.2, 0.2], 0.0).unwrap()[..] {
        [
            Rest::Balance {
                angle_deg,
                stable: true,
            },
        ] => Some(angle_deg),
        _ => None,
    };
    let point = model
        .point_at(workspaces, &[0.2, 0.2], 0.0, Turning::Mean)
        .unwrap();
    let k = ideals[0]
        .response(&mut Workspace::new(), 0.2, 0.1)
        .unwrap()
        .stiffness_n_per_mm
        .unwrap();
    let stiffness = 2e-3 * radius * radius * k;
    let ours = point.stiffness_nm_per_rad;
    rows.add("two equal muscles: rest (°)", 0.0, rest, 1e-9);
    let name = "two equal muscles: r²(K1 + K2) (N m/rad)";
    rows.add(name, stiffness, ours, 1e-12);
}

/// (P1, P2) → torque and stiffness → pressures with the same torque and stiffness; the largest
/// difference, relative.
pub fn inverses(rows: &mut Rows) {
    let mut random = Random(20_261_121);
    let mut done = 0;
    let mut largest = Some(0.0_f64);
    while done < JOINTS {
        if let Some(off) = round_trip(&mut random) {
            done += 1;
            largest = largest.zip(off).map(|(a, b)| a.max(b));
        }
    }
    let name = format!("{JOINTS} random joints: largest error of the inverse");
    rows.add(name, 0.0, largest, 1e-8);
}

/// The error of one random joint, `Some(None)` where the inverse has no answer; `None` where it has
/// no model.
fn round_trip(random: &mut Random) -> Option<Option<f64>> {
    let mut uniform = |low: f64, high: f64| random.between(low, high);
    let lengths = [uniform(150.0, 400.0), uniform(150.0, 400.0)];
    let radii = [uniform(10.0, 40.0), -uniform(10.0, 40.0)];
    let points = uniform(0.0, 1.0) < 0.5;
    let mut muscles = vec![];
    for i in 0..2 {
        let m = Muscle::prototype()
            .with_section(uniform(15.0, 40.0), 1.0)
            .ok()?;
        let tube = Tube {
            length_mm: lengths[i],
            ..m.tube().clone()
        };
        let up = lengths[i] + uniform(20.0, 60.0);
        let path = if points {
            Path::Points {
                origin_mm: [uniform(-20.0, 20.0), up],
                insertion_mm: [1.5 * radii[i], 0.0],
            }
        } else {
            Path::Pulley {
                radius_mm: radii[i],
            }
        };
        muscles.push(JointMuscle {
            muscle: m.with_tube(tube).ok()?,
            path,
            contraction_at_neutral: 0.12,
        });
    }
    let link = Link {
        mass_kg: uniform(0.0, 2.0),
        centre_mm: 150.0,
        ..Link::default()
    };
    let p = [uniform(0.01, 0.6), uniform(0.01, 0.6)];
    let deg = uniform(-25.0, 25.0);
    let joint = Joint::new(muscles, None, link, (-30.0, 30.0)).ok()?;
    let ideals = ideals(&joint);
    let model = model(&joint, &ideals)?;
    let w = &mut model.workspaces();
    let there = model.point_at(w, &p, deg, Turning::Mean).ok()?;
    if there.muscles.iter().any(|m| m.answer.slack) {
        return None;
    }
    let stiffness_nm_per_rad = Some(there.stiffness_nm_per_rad);
    let wanted = JointTarget {
        angle_deg: deg,
        torque_nm: there.torque_nm,
        stiffness_nm_per_rad,
    };
    let back = model.pressures(w, wanted, 0.6).ok();
    Some(back.map(|back| {
        let torque = (back.torque_nm - there.torque_nm).abs() / (1.0 + there.torque_nm.abs());
        torque.max((back.stiffness_nm_per_rad / there.stiffness_nm_per_rad - 1.0).abs())
    }))
}
