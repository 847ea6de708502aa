//! Cases with exact values: are the equations solved right?
//!
//! The letters of the sources are those of `docs/verified.md`, which says for each problem what
//! is loaded and held. Unless stated otherwise the rubber is Mooney–Rivlin with C1 = 0.10, C2 = 0.02
//! MPa, incompressible; mm, MPa, N.

mod bricks;
mod endless;
mod homogeneous;
mod lay;
mod muscle;
mod numerics;
mod pressure;
#[path = "../../../../mckibben-core/tests/all/verification/rows.rs"]
mod rows;
mod sphere;
mod tube;

use mckibben_core::{
    extremes::peak,
    model::{ForceModel, Workspace},
    muscle::{Braid, Bulk, Muscle, Rubber, StrandLay, Terminals, Tube},
    rubber::{Law, MooneyRivlin, NeoHookean},
};
use mckibben_fem::{
    axisymmetric::{Axisymmetric, Body, BraidSpec, Discretisation, Ends, Mesh, Problem},
    solver::{
        body::Control,
        continuation::Continuation,
        newton::{self, Effort, NewtonOptions, NewtonSystem},
    },
};
use rows::Rows;

impl Rows {
    /// A row for each of the values that one computation gives, with what is exact.
    fn add_each<const N: usize>(
        &mut self,
        begins: &str,
        exact: [(&str, f64); N],
        ours: Option<[f64; N]>,
        tolerance: f64,
    ) {
        for (i, (what, reference)) in exact.into_iter().enumerate() {
            self.add(
                format!("{begins}{what}"),
                reference,
                ours.map(|values| values[i]),
                tolerance,
            );
        }
    }
}

const LONG: &str = "G: Liu & Rahn 2003 [liu2003], thick wall, strands that do not stretch";
const COOK: &str = "H: Cook 1974 [cook1974], membrane, Q1P0, plane strain";
const CONDUCT: &str = "J: numerical conduct (bricks)";

rows::cases! {
    homogeneous_states:
        "A: Rivlin 1948 [rivlin1948]; Treloar 1975 [treloar1975]" => homogeneous::homogeneous;
    rivlins_and_haughton_ogdens_thick_tube:
        "B: Rivlin 1949 [rivlin1949]; Haughton & Ogden 1979 [haughton1979]" => tube::thick_tube;
    green_zernas_thick_sphere:
        "C: Green & Zerna 1954 [green1954], thick sphere" => sphere::thick_sphere;
    follower_pressure:
        "E: pressure as −P·V of a closed cavity" => pressure::follower_pressure;
    infinitely_long_muscle:
        LONG => endless::endless_braid;
    long_muscles:
        LONG => endless::long_muscles;
    lay_of_the_strands:
        "K: work of the pressure, braid of a thickness" => lay::strand_lay;
    identities_of_the_muscle:
        "I: Maxwell relation" => muscle::identities;
    independent_prototype:
        "independent axisymmetric prototype" => muscle::prototype;
    numerical_conduct:
        "J: numerical conduct" => numerics::numerics;
    sensitivities:
        "J: sensitivities against finite differences" => numerics::sensitivities;
    patch_test_of_bricks:
        "A: Rivlin 1948 [rivlin1948]; Treloar 1975 [treloar1975] (bricks)" => bricks::homogeneous::homogeneous;
    simple_shear_of_bricks:
        "A: Rivlin 1948 [rivlin1948], simple shear (bricks)" => bricks::homogeneous::shear;
    rivlins_and_haughton_ogdens_thick_tube_in_bricks:
        "B: Rivlin 1949 [rivlin1949]; Haughton & Ogden 1979 [haughton1979] (bricks)" => bricks::tube::thick_tube;
    rivlins_torsion:
        "D: Rivlin 1949 [rivlin1949], torsion" => bricks::torsion::torsion;
    follower_pressure_on_bricks:
        "E: closed cavity, energy (bricks)" => bricks::cavity::follower_pressure;
    terminals_as_bodies:
        "E: closed cavity, terminals as bodies (bricks)" => bricks::cavity::terminals;
    von_mises_truss:
        "F: von Mises truss, engineering strain (strands)" => bricks::snap::snap;
    cooks_membrane:
        COOK => bricks::cook::cook;
    numerical_conduct_of_bricks:
        CONDUCT => bricks::numerics::numerics;
    paths_and_stability_of_bricks:
        CONDUCT => bricks::paths::paths;
    outer_diameter_limit_of_bricks:
        "I: outer-diameter limit of strands that do not stretch (bricks)" => bricks::muscle::outer_diameter_limit;
    felupes_muscle:
        "FElupe 11.3, same mesh, mean dilatation" => bricks::muscle::muscle;
    cooks_membrane_in_fine_meshes:
        COOK => bricks::cook::cook_fine;
}

/// The rubber of the cases.
fn rubber() -> Law {
    Law::MooneyRivlin(MooneyRivlin {
        c10_mpa: 0.10,
        c01_mpa: 0.02,
    })
}

fn neo_hookean(mu_mpa: f64) -> Law {
    Law::NeoHookean(NeoHookean { mu_mpa })
}

type Path = Continuation<Body>;

/// A body of an incompressible rubber at rest.
fn body(mesh: Mesh, law: Law, braid: Option<BraidSpec>, ends: Ends) -> Option<Path> {
    at_rest(mesh, Problem::new(law, Bulk::Incompressible, braid, ends))
}

fn at_rest(mesh: Mesh, problem: Problem) -> Option<Path> {
    Some(Path::new(Body::new(
        Discretisation::new(mesh, problem).ok()?,
    )))
}

/// The body at a pressure and an axial stretch of the whole, to the last digit.
fn stretched(path: Option<Path>, pressure: f64, stretch: f64) -> Option<Body> {
    let mut c = path?;
    let terminal = (stretch - 1.0) * c.body.discretisation.half_length();
    c.walk(0.0, terminal, 1.0).ok()?;
    c.walk(pressure, terminal, 1.0).ok()?;
    c.newton.tolerance = 1e-13;
    c.solve(Control::Length(terminal)).ok()?;
    Some(c.body)
}

/// The same, first inflated: then strands are taut.
fn inflated(path: Option<Path>, pressure: f64, stretch: f64) -> Option<Body> {
    let mut c = path?;
    let terminal = (stretch - 1.0) * c.body.discretisation.half_length();
    c.walk(pressure, 0.0, 1.0).ok()?;
    c.walk(pressure, terminal, 1.0).ok()?;
    Some(c.body)
}

/// Radius now of node `i` of station `j`.
fn radius(body: &Body, i: usize, j: usize) -> f64 {
    let d = &body.discretisation;
    d.mesh.node(i, j)[0] + body.state.u[d.layout.station_offset(j) + 2 * i]
}

/// A braid of strands that carry no compression; `stiffness` in N/mm.
fn braid(lay: StrandLay, stiffness: Option<f64>) -> BraidSpec {
    BraidSpec {
        lay,
        crimp: None,
        stiffness,
        compression: false,
    }
}

/// A slice of an infinitely long muscle of radii `inner` and `outer` in mm.
fn slice([inner, outer]: [f64; 2], law: Law, braid: BraidSpec) -> Option<Path> {
    body(
        Mesh::tube(inner, outer, 5.0, (THROUGH, 1, 1.0)),
        law,
        Some(braid),
        Ends::Sliding,
    )
}

/// Elements through the wall of a slice.
const THROUGH: usize = 8;

/// A muscle of radii `inner` and `outer` in mm.
fn muscle([inner, outer]: [f64; 2], length_mm: f64, law: Law, braid: Braid) -> Option<Muscle> {
    let tube = Tube::new(2.0 * outer, outer - inner, length_mm, Rubber::new(law));
    Muscle::new(tube, braid, Terminals::default(), None).ok()
}

/// The prototype of the paper, changed.
fn changed(change: impl FnOnce(&mut Tube, &mut Braid)) -> Option<Muscle> {
    let prototype = Muscle::prototype();
    let mut tube = prototype.tube().clone();
    let mut braid = Braid::paper();
    change(&mut tube, &mut braid);
    prototype.with_tube(tube).ok()?.with_braid(braid).ok()
}

/// Pull in N by a model.
fn pull(model: impl ForceModel, pressure_mpa: f64, contraction: f64) -> Option<f64> {
    model
        .force_n(&mut Workspace::new(), pressure_mpa, contraction)
        .ok()
}

/// The same of a muscle by the section.
fn section_pull(muscle: &Muscle, pressure_mpa: f64, contraction: f64) -> Option<f64> {
    pull(
        Axisymmetric::between_ends(muscle).ok()?,
        pressure_mpa,
        contraction,
    )
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    peak(a.iter().zip(b).map(|(a, b)| (a - b).abs()))
}

/// log(r3/r2)/log(r2/r1) of the last residuals of a large step above rounding, at most 2: faster is
/// no fault.
fn order_of_newton<S: NewtonSystem>(
    system: &mut S,
    options: &NewtonOptions,
    rounding: f64,
) -> Option<f64> {
    let mut seen = vec![];
    newton::solve(system, options, &mut Effort::default(), |residual| {
        seen.extend(Some(residual).filter(|r| *r > rounding));
        Ok(())
    })
    .ok()?;
    let [.., a, b, c] = seen[..] else { return None };
    Some(((c / b).ln() / (b / a).ln()).min(2.0))
}
