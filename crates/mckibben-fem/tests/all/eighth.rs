//! Files of the three-dimensional model: one eighth of a muscle, and the whole one from it.

use mckibben_core::{
    model::Workspace,
    muscle::{Muscle, file::parse_muscle},
};
use mckibben_fem::{
    FemError,
    output::{Extent, Shape, deck, increments, vtu::Grid},
    three_dimensional::{BrickSpec, Field, Plug, PlugMaterial, ThreeDimensional},
};

fn solved() -> (ThreeDimensional, Field) {
    let model = ThreeDimensional::between_ends_with(
        &Muscle::prototype(),
        &BrickSpec::parse("1x6").unwrap(),
    )
    .unwrap();
    let field = model.field_at(&mut Workspace::new(), 0.2, 0.1).unwrap();
    (model, field)
}

/// Volume of hexahedra with their corners at `place`: ∫ det ∂x/∂ξ by 2 × 2 × 2 points of Gauss,
/// which is exact.
fn enclosed(grid: &Grid, place: impl Fn(usize) -> [f64; 3]) -> f64 {
    const CORNERS: [[f64; 3]; 8] = [
        [-1.0, -1.0, -1.0],
        [1.0, -1.0, -1.0],
        [1.0, 1.0, -1.0],
        [-1.0, 1.0, -1.0],
        [-1.0, -1.0, 1.0],
        [1.0, -1.0, 1.0],
        [1.0, 1.0, 1.0],
        [-1.0, 1.0, 1.0],
    ];
    let one = |cell: &[i64]| {
        let at: [[f64; 3]; 8] = std::array::from_fn(|k| place(cell[k] as usize));
        let determinant = |point: [f64; 3]| {
            let xi = point.map(|x| x / 3.0_f64.sqrt());
            // ∂N/∂ξ of the corner c: c_k/8 times the other two factors (1 + c ξ).
            let slope = |c: [f64; 3], k: usize| {
                let others = (0..3).filter(|m| *m != k).map(|m| 1.0 + c[m] * xi[m]);
                c[k] / 8.0 * others.product::<f64>()
            };
            let j = |i: usize, k: usize| {
                at.iter()
                    .zip(CORNERS)
                    .map(|(x, c)| x[i] * slope(c, k))
                    .sum::<f64>()
            };
            nalgebra::Matrix3::from_fn(j).determinant()
        };
        CORNERS.map(determinant).into_iter().sum::<f64>()
    };
    grid.connectivity.chunks_exact(8).map(one).sum()
}

/// Incompressible rubber keeps the volume of the polygon's tube.
#[test]
fn the_whole_tube_has_eight_times_the_volume_of_one_eighth_and_keeps_it() {
    let (_, field) = solved();
    let volume = |extent, rest: bool| {
        let shape = Shape::of_field(&field, extent);
        let moved = shape
            .tube
            .data
            .iter()
            .find(|d| d.name == "displacement")
            .unwrap();
        let place = |i: usize| {
            let u = &moved.values[3 * i..3 * i + 3];
            [0, 1, 2].map(|k| shape.tube.points[i][k] - if rest { u[k] } else { 0.0 })
        };
        enclosed(&shape.tube, place)
    };
    let (eighth, whole) = (volume(Extent::Eighth, false), volume(Extent::Whole, false));
    assert!(
        (whole - 8.0 * eighth).abs() < 1e-9 * whole,
        "{whole} {eighth}"
    );
    let rest = volume(Extent::Whole, true);
    assert!((whole - rest).abs() < 1e-6 * rest, "{whole} {rest}");
}

/// Both terminals have eight times the volume of one eighth of them, of either brick; a rigid one
/// keeps its shape. Their volume is that of the prism of the inner surface's polygon over insertion
/// and nose, less what the rounding takes.
#[test]
fn terminals_are_seen_and_have_their_volume() {
    for (mesh, material) in [
        ("2x8", PlugMaterial::Rigid),
        ("2x8", PlugMaterial::Aluminium),
        ("1x4:quadratic", PlugMaterial::Aluminium),
    ] {
        let (insertion, nose, inner) = (10.0, 3.0, 12.0);
        let plug = Some(Plug {
            material,
            insertion_mm: Some(insertion),
            nose_mm: Some(nose),
        });
        let spec = BrickSpec {
            plug,
            ..BrickSpec::parse(mesh).unwrap()
        };
        let model = ThreeDimensional::between_ends_with(&Muscle::prototype(), &spec).unwrap();
        let field = model.field_at(&mut Workspace::new(), 0.2, 0.1).unwrap();
        assert!(
            field
                .nodes
                .iter()
                .all(|n| n.stretches[2] > 0.999 && n.now_mm[0].is_finite())
        );
        let volume = |extent| {
            let shape = Shape::of_field(&field, extent);
            let grid = shape.plug.clone().unwrap();
            assert!(
                grid.data
                    .iter()
                    .all(|d| d.values.iter().all(|v| v.is_finite()))
            );
            enclosed(&grid, |i| grid.points[i])
        };
        let (eighth, whole) = (volume(Extent::Eighth), volume(Extent::Whole));
        assert!(
            (whole - 8.0 * eighth).abs() < 1e-9 * whole,
            "{whole} {eighth}"
        );
        let area = field.mesh.polygon_mm2();
        // ∫ √(ρ² − s²) 2π r dr over the fillet and the plane, over the area of the circle.
        let flat: f64 = inner - nose;
        let pi = std::f64::consts::PI;
        let rounded = pi * flat * flat * nose
            + 2.0 * pi * (flat * pi / 4.0 * nose * nose + nose.powi(3) / 3.0);
        let exact = area * (insertion + rounded / (pi * inner * inner));
        // Two chords of the rounding; the linear faces of a quadratic inner surface.
        assert!(
            (eighth / exact - 1.0).abs() < 0.01,
            "{mesh} {material:?}: {eighth} {exact}"
        );
    }
}

/// Eight times the pieces of one eighth, with the same mean tension.
#[test]
fn strands_are_found_and_pull() {
    let (_, field) = solved();
    let shape = Shape::of_field(&field, Extent::Whole);
    let tension = shape
        .braid
        .data
        .iter()
        .find(|d| d.name == "mesh_strand_tension_n")
        .unwrap();
    assert_eq!(tension.values.len(), 16 * field.pieces.len());
    let mean = |v: &mut dyn Iterator<Item = f64>| {
        let (n, sum) = v.fold((0.0, 0.0), |(n, s), x| (n + 1.0, s + x));
        sum / n
    };
    let all = mean(&mut tension.values.iter().copied());
    let eighth = mean(&mut field.pieces.iter().map(|p| p.tension_n));
    assert!(
        all > 0.0 && (all - eighth).abs() < 1e-9 * all,
        "{all} {eighth}"
    );
}

#[test]
fn a_deck_with_a_terminal_that_is_a_body_is_refused() {
    let spec = BrickSpec {
        plug: Some(Plug::default()),
        ..BrickSpec::parse("6").unwrap()
    };
    let model = ThreeDimensional::between_ends_with(&Muscle::prototype(), &spec).unwrap();
    assert!(matches!(
        deck(&model, 0.0, &[0.1]),
        Err(FemError::Refused(_))
    ));
}

/// The steps of a deck: how many increments, and where the last one ends.
fn steps(model: &ThreeDimensional, contraction: f64, pressures: &[f64]) -> Vec<(f64, f64, f64)> {
    let half = model.divided.mesh.tube.half_mm;
    let text = deck(model, contraction, pressures).unwrap();
    let number = |step: &str, before: &str, after: char| -> f64 {
        let (_, rest) = step.split_once(before).unwrap();
        rest.split(after).next().unwrap().parse().unwrap()
    };
    let of_step = |step: &str| {
        (
            number(step, "*STATIC, DIRECT\n", ',').recip(),
            -number(step, "NEND, 3, 3, ", '\n') / half,
            number(step, "EIN, P6, ", '\n'),
        )
    };
    text.split("*STEP, ").skip(1).map(of_step).collect()
}

/// The path of a test at ε = .10 by 0.01 MPa: five increments of filling, twenty of shortening,
/// twenty of filling.
#[test]
fn a_muscle_is_filled_before_it_is_shortened() {
    let pressures: Vec<f64> = (1..=25).map(|i| 0.01 * f64::from(i)).collect();
    let peers = include_str!("../../../../examples/peers.toml");
    let muscle = parse_muscle(peers).unwrap();
    let model =
        ThreeDimensional::between_ends_with(&muscle, &BrickSpec::parse("1x4").unwrap()).unwrap();
    let near = |contraction: f64, wanted: &[(f64, f64, f64)]| {
        let got = steps(&model, contraction, &pressures);
        let off = |(a, b): (&(f64, f64, f64), &(f64, f64, f64))| {
            (a.0 - b.0)
                .abs()
                .max((a.1 - b.1).abs())
                .max((a.2 - b.2).abs())
        };
        assert_eq!(got.len(), wanted.len(), "{got:?}");
        assert!(
            got.iter().zip(wanted).map(off).all(|x| x < 1e-12),
            "{got:?}"
        );
    };
    near(0.0, &[(25.0, 0.0, 0.25)]);
    let filled = [(5.0, 0.0, 0.05), (20.0, 0.1, 0.05), (20.0, 0.1, 0.25)];
    near(0.1, &filled);
    assert_eq!(increments(0.1, &pressures).unwrap().len(), 45);
    let refused = |pressures: &[f64]| increments(0.1, pressures).is_err();
    assert!(refused(&[0.0, 0.1]) && refused(&[]) && refused(&[0.2, 0.1]));
}
