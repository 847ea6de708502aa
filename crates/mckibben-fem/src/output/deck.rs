//! One eighth of a muscle as an input deck for CalculiX and Abaqus: the same nodes, bricks,
//! strands, rubber, supports and loads.
//!
//! Bricks are C3D8 (C3D20 and C3D27 do not exist or do not converge there), strands are SPRINGA,
//! whose force k (l − L) is that of a truss with engineering strain and k = E A/L. Laws are those
//! of *HYPERELASTIC: W = U(Ī1, Ī2) + (J − 1)²/D1 with D1 = 2/K; Ogden's are written there as 2
//! μi/αi². Data of the mesh are in comments `** key = value`.

use super::vtu;
use crate::{
    FemError, Result,
    three_dimensional::{Brick, ThreeDimensional},
};
use mckibben_core::{
    joined,
    model::ForceModel,
    muscle::Bulk,
    rubber::{Law, Ogden, RubberLaw},
};
use std::collections::BTreeMap;

/// Bulk modulus over shear modulus that an incompressible rubber gets.
const BULK: f64 = 1000.0;
/// Pressure in MPa up to which a muscle is filled before it is shortened: shortened at rest, its
/// strands would buckle.
const FILL: f64 = 0.05;
/// Largest step of the contraction.
const CONTRACTION: f64 = 0.005;

/// A contraction and a pressure in MPa.
type Point = (f64, f64);

/// Every increment of a deck: where it ends.
pub fn increments(contraction: f64, pressures_mpa: &[f64]) -> Result<Vec<Point>> {
    let first_mpa = pressures_mpa.first().copied().unwrap_or(0.0);
    let rising = pressures_mpa.windows(2).all(|p| p[1] > p[0]);
    if !(first_mpa > 0.0 && rising && pressures_mpa.iter().all(|p| p.is_finite())) {
        return Err(FemError::Refused(format!(
            "an input deck needs rising pressures above zero, the first of them \
             {first_mpa}\u{a0}MPa here"
        )));
    }
    if contraction == 0.0 {
        return Ok(pressures_mpa.iter().map(|p| (0.0, *p)).collect());
    }
    let filled = pressures_mpa
        .iter()
        .position(|p| *p >= FILL - 1e-12)
        .unwrap_or(pressures_mpa.len() - 1);
    let turns = (contraction.abs() / CONTRACTION - 1e-9).ceil().max(1.0);
    let shortened =
        (1..=turns as usize).map(|i| (contraction * (i as f64 / turns), pressures_mpa[filled]));
    let (before, after) = pressures_mpa.split_at(filled + 1);
    Ok(before
        .iter()
        .map(|p| (0.0, *p))
        .chain(shortened)
        .chain(after.iter().map(|p| (contraction, *p)))
        .collect())
}

/// Increments of equal size together: how many, and where the last one ends.
fn steps(increments: &[Point]) -> Vec<(usize, Point)> {
    let mut out: Vec<(usize, Point)> = vec![];
    let mut before = (0.0, 0.0);
    let mut size = (f64::NAN, f64::NAN);
    for &end in increments {
        let here = (end.0 - before.0, end.1 - before.1);
        let off = (here.0 - size.0).abs() + (here.1 - size.1).abs();
        match out.last_mut() {
            Some(last) if off < 1e-9 * end.1 => *last = (last.0 + 1, end),
            _ => out.push((1, end)),
        }
        before = end;
        size = here;
    }
    out
}

/// The deck of an isometric test: filled up to 0.05 MPa (or the next of the pressures), shortened,
/// filled further.
pub fn deck(model: &ThreeDimensional, contraction: f64, pressures_mpa: &[f64]) -> Result<String> {
    let mesh = &model.divided.mesh;
    let muscle = model.muscle();
    let refused = [
        (mesh.brick != Brick::Linear, "needs eight-node bricks"),
        (
            mesh.plug.is_some(),
            "has a rigid plane as the terminal: leave out `terminal`",
        ),
        (
            muscle.tube().prestretch != 1.0,
            "starts from unstressed rubber: leave out tube.prestretch",
        ),
        (
            muscle.terminals().plug_diameter_mm.is_some(),
            "has plugs with the diameter of the bore: leave out terminals.plug_diameter",
        ),
    ];
    if let Some((_, why)) = refused.into_iter().find(|(stated, _)| *stated) {
        return Err(FemError::Refused(format!("an input deck {why}")));
    }
    let increments = increments(contraction, pressures_mpa)?;
    let version = env!("CARGO_PKG_VERSION");
    let mut out =
        format!("*HEADING\nOne eighth of a McKibben muscle: mm, MPa, N; mckibben {version}\n");
    for (key, value) in [
        ("outer_radius_mm", mesh.tube.outer_mm),
        ("inner_radius_mm", mesh.tube.inner_mm),
        ("half_length_mm", mesh.tube.half_mm),
        ("angle_deg", mesh.tube.angle_rad.to_degrees()),
        ("contraction", contraction),
    ] {
        out += &format!("** {key} = {value:?}\n");
    }
    out += "** pull of the whole muscle = 4 x (sum of the reactions of NEND along z, less their \
        share of the pressure) - P x area of the bore\n";
    out += "*NODE, NSET=NALL\n";
    for (i, x) in mesh.nodes.iter().enumerate() {
        out += &format!("{}, {:?}, {:?}, {:?}\n", i + 1, x[0], x[1], x[2]);
    }
    out += "*ELEMENT, TYPE=C3D8, ELSET=TUBE\n";
    let bricks = mesh.bricks();
    // Ours run through the wall, around, along; theirs around the face.
    for (e, nodes) in bricks.iter().enumerate() {
        out += &format!(
            "{}, {}\n",
            e + 1,
            joined(vtu::ORDER.iter().map(|&a| (nodes[a] + 1).to_string()), ", ")
        );
    }
    strands(&mut out, model, bricks.len())?;
    sets(&mut out, model);
    rubber(&mut out, &muscle.rubber().law, muscle.rubber().bulk)?;
    out += "*BOUNDARY\nSX, 1, 1\nSY, 2, 2\nSZ, 3, 3\nNEND, 1, 2\n";
    for (count, (contraction, p)) in steps(&increments) {
        let share = 1.0 / count as f64;
        let end = -contraction * mesh.tube.half_mm;
        out += &format!("*STEP, NLGEOM, INC=2000\n*STATIC, DIRECT\n{share:?}, 1.\n");
        out += "*CONTROLS, PARAMETERS=FIELD\n1e-5, 1e-5\n";
        out += &format!("*BOUNDARY\nNEND, 3, 3, {end:?}\n*DLOAD\nEIN, P6, {p:?}\n");
        out += "*NODE PRINT, NSET=NEND, TOTALS=ONLY\nRF\n*NODE PRINT, NSET=NIN\nU\n*END STEP\n";
    }
    Ok(out)
}

fn strands(out: &mut String, model: &ThreeDimensional, before: usize) -> Result<()> {
    let trusses = &model.divided.discretisation.problem.trusses;
    // One set for each length, in the order in which they appear.
    let mut groups: BTreeMap<i64, Vec<usize>> = BTreeMap::new();
    for (i, (_, truss)) in trusses.iter().enumerate() {
        groups
            .entry((truss.length_mm * 1e9).round() as i64)
            .or_default()
            .push(i);
    }
    let mut springs = String::new();
    for (number, members) in groups.values().enumerate() {
        let truss = trusses[members[0]].1;
        let k = truss.stiffness_n / truss.length_mm;
        if !k.is_finite() {
            return Err(FemError::Refused(
                "an input deck needs strands that stretch: give the braid a stiffness".into(),
            ));
        }
        let set = format!("ELSET=STRANDS{}", number + 1);
        *out += &format!("*ELEMENT, TYPE=SPRINGA, {set}\n");
        for &i in members {
            let [a, b] = trusses[i].0;
            *out += &format!("{}, {}, {}\n", before + i + 1, a + 1, b + 1);
        }
        springs += &if truss.compression {
            format!("*SPRING, {set}\n\n{k:?}\n")
        } else {
            let less = -1e-3 * k;
            let more = 10.0 * k;
            format!("*SPRING, {set}, NONLINEAR\n\n{less:?}, -10.\n0., 0.\n{more:?}, 10.\n")
        };
    }
    out.push_str(&springs);
    Ok(())
}

fn sets(out: &mut String, model: &ThreeDimensional) {
    let mesh = &model.divided.mesh;
    let [ni, nj, nk] = mesh.grid();
    let all = |keep: &dyn Fn(usize, usize, usize) -> bool| {
        (0..ni * nj * nk)
            .filter(|n| keep(n % ni, n / ni % nj, n / (ni * nj)))
            .map(|n| n + 1)
            .collect()
    };
    let last = nk - 1;
    let mut write = |head: &str, list: Vec<usize>| {
        *out += &format!("{head}\n");
        for part in list.chunks(12) {
            *out += &format!("{},\n", joined(part.iter().map(usize::to_string), ", "));
        }
    };
    // No displacement is held twice.
    write("*NSET, NSET=SX", all(&|_, j, k| j + 1 == nj && k < last));
    write("*NSET, NSET=SY", all(&|_, j, k| j == 0 && k < last));
    write("*NSET, NSET=SZ", all(&|_, _, k| k == 0));
    write("*NSET, NSET=NEND", all(&|_, _, k| k == last));
    write("*NSET, NSET=NIN", all(&|i, _, _| i == 0));
    // Bricks at the inner surface; their face with ξ = −1 has number 6.
    let [through, around, along] = mesh.elements;
    write(
        "*ELSET, ELSET=EIN",
        (0..around * along).map(|e| e * through + 1).collect(),
    );
}

fn rubber(out: &mut String, law: &Law, bulk: Bulk) -> Result<()> {
    let k = match bulk {
        Bulk::Modulus(k) => k,
        Bulk::Incompressible => {
            *out += &format!(
                "** the rubber is incompressible; here its bulk modulus is {BULK} times the shear \
                 modulus\n"
            );
            BULK * law.shear_modulus_mpa()
        }
    };
    let (form, mut numbers, compressions) = card(law).ok_or_else(|| {
        FemError::Refused(format!(
            "an input deck cannot describe the law \"{}\"; it can describe mooney-rivlin, \
             neo-hookean, yeoh and ogden",
            law.name()
        ))
    })?;
    // One constant of compression counts, D1 = 2/K.
    let given = numbers.len();
    numbers.push(2.0 / k);
    numbers.resize(given + compressions, 0.0);
    *out += &format!("*MATERIAL, NAME=RUBBER\n*HYPERELASTIC, {form}\n");
    for part in numbers.chunks(8) {
        *out += &format!("{}\n", joined(part.iter().map(|x| format!("{x:?}")), ", "));
    }
    *out += "*SOLID SECTION, ELSET=TUBE, MATERIAL=RUBBER\n";
    Ok(())
}

/// What follows the keyword *HYPERELASTIC, the constants without those of compression, and how many
/// of these D1, D2, … there are; `None` where decks have no such law.
fn card(law: &Law) -> Option<(String, Vec<f64>, usize)> {
    Some(match law {
        Law::NeoHookean(law) => ("NEO HOOKE".into(), vec![0.5 * law.mu_mpa], 1),
        Law::MooneyRivlin(_) => ("MOONEY-RIVLIN".into(), law.values(), 1),
        Law::Yeoh(_) => ("YEOH".into(), law.values(), 3),
        Law::Ogden(Ogden { terms }) => {
            // There Σ 2 μ'i/αi² (…): μ'i = μi αi/2.
            let constants = terms
                .iter()
                .flat_map(|(mu, alpha)| [0.5 * mu * alpha, *alpha]);
            let n = terms.len();
            (format!("OGDEN, N={n}"), constants.collect(), n)
        }
        _ => return None,
    })
}
