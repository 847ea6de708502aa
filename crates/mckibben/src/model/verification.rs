//! Muscles on a core rod and on a pulley against independent minima, plane finite elements, virtual work and the capstan equation.

use super::{Bent, BentMuscle, OnPulley, Strands, ThickWall, Workspace};
use crate::muscle::{Braid, BraidStiffness, Direction, Muscle, Rubber, Terminals, Tube};
use crate::rubber::{Law, NeoHookean};
use crate::verification::VerificationRow;

const MINIMUM: &str = "SciPy: minimum of the potential over the bore, and its slope in the stretch";
const PLANE: &str = "plane finite elements of the section (studies/bent_section.py)";
const WORK: &str = "virtual work: F dL - P dV is the change of the energy";
const CAPSTAN: &str = "capstan equation, by a sum over the arc";

/// Every case.
pub fn cases() -> Vec<VerificationRow> {
    let mut rows = rod();
    rows.extend(sections());
    rows.extend(pulley());
    rows
}

fn neo_hookean(
    mu_mpa: f64,
    outer_diameter_mm: f64,
    length_mm: f64,
    angle_deg: f64,
    k: f64,
) -> Option<Muscle> {
    let rubber = Rubber::of(Law::NeoHookean(NeoHookean { mu_mpa }));
    let braid = Braid { angle_deg, stiffness: BraidStiffness::NewtonPerMm(k), ..Braid::paper() };
    Muscle::new(Tube::new(outer_diameter_mm, 2.0, length_mm, rubber), braid, Terminals::default(), None).ok()
}

/// A tube of 20 x 2 mm, 150 mm long, strands at 62° with 120 N/mm, μ 0.4 MPa, and a rod of 15.6 mm through a seal or of a length in mm.
fn on_rod(rod_length_mm: Option<f64>) -> Option<Muscle> {
    let ends = Terminals { rod_diameter_mm: Some(15.6), rod_length_mm, ..Terminals::default() };
    neo_hookean(0.4, 20.0, 150.0, 62.0, 120.0)?.with_terminals(ends).ok()
}

/// Pull of a tube that lies on its rod. By SciPy 1.17: Π by 40 Gauss points, its minimum over r ≥ rc by `brentq`, the share of the tube on a rod of 90 mm by a root
/// of the central difference of Ψ, and F by central differences of the minimum (h 10⁻⁴ and 10⁻³ in λ).
fn rod() -> Vec<VerificationRow> {
    let response = |m: Option<Muscle>, p: f64, l: f64| {
        let m = m?;
        let model = super::ModelKind::ThickWall.build(&m).ok()?;
        model.response(&mut Workspace::new(), p, 1.0 - l).ok()
    };
    let mut rows = vec![];
    for (p, l, through_n, inside_n) in [
        (0.0, 1.1, 13.433_234, 12.898_295),
        (0.02, 1.2, 57.031_872, 27.744_923),
        (0.1, 1.3, 127.357_757, 47.483_991),
        (0.0, 1.3, 127.357_757, 42.242_724),
    ] {
        for (length_mm, what, reference, tolerance) in
            [(None, "through a seal", through_n, 1e-6), (Some(90.0), "of 90 mm inside", inside_n, 1e-5)]
        {
            let ours = response(on_rod(length_mm), p, l).map(|r| r.force_n);
            let name = format!("tube on a core rod {what}, {p} MPa, stretch {l}: pull (N)");
            rows.push(VerificationRow::new(name, MINIMUM, reference, ours, tolerance));
        }
    }
    let (p, l, h) = (0.1, 1.25, 1e-5);
    let volume = |l: f64| response(on_rod(Some(90.0)), p, l).and_then(|r| r.volume_mm3);
    let by_contraction = volume(l - h).zip(volume(l + h)).map(|(a, b)| (a - b) / (2.0 * h));
    let by_pressure = response(on_rod(Some(90.0)), p, l).and_then(|r| r.force_per_pressure_mm2);
    rows.push(VerificationRow::new(
        "tube on a core rod of 90 mm inside: L0 dF/dP (mm³)".into(),
        WORK,
        by_contraction.unwrap_or(f64::NAN),
        by_pressure.map(|slope| 150.0 * slope),
        1e-6,
    ));
    rows
}

/// F and M of a held section at 0.2 MPa: within 3 % of F and 5 % of M up to an oval of 0.06, of which the wave of n = 2 alone is in the model.
fn sections() -> Vec<VerificationRow> {
    let bent = neo_hookean(0.3, 20.0, 285.0, 30.0, 300.0).map(|m| BentMuscle::new(&m));
    let mut rows = vec![];
    for (strands, l, kappa, force_n, moment_n_mm) in [
        (Strands::Sliding, 0.95, 0.0, 203.23, 0.0),
        (Strands::Sliding, 0.95, 0.01, 202.59, 53.21),
        (Strands::Sliding, 0.95, 0.02, 200.58, 106.69),
        (Strands::Sliding, 0.85, 0.01, 85.58, 63.81),
        (Strands::Sliding, 0.85, 0.02, 84.18, 129.89),
        (Strands::Fixed, 0.95, 0.005, 213.93, 748.32),
        (Strands::Fixed, 0.95, 0.01, 243.03, 1397.97),
        (Strands::Fixed, 0.85, 0.005, 91.83, 436.53),
        (Strands::Fixed, 0.85, 0.01, 108.58, 847.09),
        (Strands::Fixed, 0.85, 0.015, 133.33, 1188.61),
    ] {
        let found = bent.as_ref().and_then(|bent| bent.section(strands, 0.2, l, kappa).ok());
        let how = match strands {
            Strands::Sliding => "sliding",
            Strands::Fixed => "fixed",
        };
        let head = format!("bent section, {how} strands, stretch {l}, curvature {kappa}/mm");
        let force = found.map(|s| s.force_n);
        rows.push(VerificationRow::new(format!("{head}: pull (N)"), PLANE, force_n, force, 0.03));
        let (moment, tolerance) =
            (found.map(|s| s.moment_n_mm), if moment_n_mm == 0.0 { 1e-9 } else { 0.05 });
        rows.push(VerificationRow::new(
            format!("{head}: moment (N mm)"),
            PLANE,
            moment_n_mm,
            moment,
            tolerance,
        ));
    }
    rows
}

/// The prototype on a pulley of 60 mm: F against −dΠ/dx and V against −dΠ/dP by central differences; friction on the pulley.
fn pulley() -> Vec<VerificationRow> {
    let muscle = Muscle::prototype();
    let (radius_mm, angle_rad) = (60.0, 70f64.to_radians());
    let arc_mm = (radius_mm + muscle.tube().outer_radius_mm()) * angle_rad;
    let on = OnPulley { radius_mm, angle_rad, straight_mm: 0.92 * muscle.length_mm() - arc_mm };
    let bent = BentMuscle::new(&muscle);
    let mut rows = vec![];
    for (strands, how) in [(Strands::Sliding, "sliding"), (Strands::Fixed, "fixed")] {
        let at = |p: f64, x: f64| bent.on_pulley(strands, &on, p, x).ok();
        let (p, x, h, hp) = (0.2, 10.0, 1e-3, 1e-6);
        let slope = |a: Option<super::BentState>, b: Option<super::BentState>, h: f64| {
            Some(-(a?.potential_n_mm - b?.potential_n_mm) / (2.0 * h))
        };
        let force = slope(at(p, x + h), at(p, x - h), h).unwrap_or(f64::NAN);
        let volume = slope(at(p + hp, x), at(p - hp, x), hp).unwrap_or(f64::NAN);
        let here = at(p, x);
        let head = format!("prototype on a pulley of 60 mm, {how} strands");
        let ours = here.map(|s| s.force_n);
        rows.push(VerificationRow::new(format!("{head}: pull (N)"), WORK, force, ours, 1e-6));
        let ours = here.map(|s| s.volume_mm3);
        rows.push(VerificationRow::new(format!("{head}: volume (mm³)"), WORK, volume, ours, 1e-6));
    }
    let model = Bent::new(Box::new(ThickWall::new(&muscle)), on, 0.08, 0.3, None);
    const PARTS: usize = 2000;
    for (direction, sign, way) in
        [(Direction::Contraction, 1.0, "shortening"), (Direction::Elongation, -1.0, "lengthening")]
    {
        let grown = |i: usize| (sign * 0.3 * angle_rad * (i as f64 + 0.5) / PARTS as f64).exp();
        let over_arc = (0..PARTS).map(grown).sum::<f64>() / PARTS as f64;
        let by_hand = (arc_mm + on.straight_mm) / (on.straight_mm + arc_mm * over_arc);
        let (factor, _) = model.friction_factor(0.08, direction);
        let name = format!("{way} against friction 0.3 on a pulley over 70°: share of the pull");
        rows.push(VerificationRow::new(name, CAPSTAN, by_hand, Some(factor), 1e-8));
    }
    rows
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_case_of_the_table_holds() {
        for row in super::cases() {
            assert!(row.ok, "{row:?}");
        }
    }
}
