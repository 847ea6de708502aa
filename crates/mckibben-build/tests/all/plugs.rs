//! The plugs as surfaces of triangles.

use crate::files::plan_of;
use mckibben_build::{Content, EyePlug, Mesh, Plan, Wishes, files};
use std::{
    collections::HashMap,
    f64::consts::{PI, TAU},
};

/// Corners of a circle.
const N: f64 = 96.0;

/// Identities of a closed surface: each edge is that of two triangles, which run along it in
/// opposite directions; one piece; V − E + F = 2 − 2g, with one hole through each plug.
fn assert_closed(mesh: &Mesh, what: &str) {
    let mut edges: HashMap<(usize, usize), u32> = HashMap::new();
    for [a, b, c] in &mesh.triangles {
        for edge in [(*a, *b), (*b, *c), (*c, *a)] {
            *edges.entry(edge).or_default() += 1;
        }
    }
    for ((a, b), count) in &edges {
        assert_eq!(
            (*count, edges.get(&(*b, *a))),
            (1, Some(&1)),
            "{what}: edge {a}–{b}"
        );
    }
    let mut root: Vec<usize> = (0..mesh.corners.len()).collect();
    fn top(root: &mut [usize], mut i: usize) -> usize {
        while root[i] != i {
            root[i] = root[root[i]];
            i = root[i];
        }
        i
    }
    for (a, b) in edges.keys() {
        let (a, b) = (top(&mut root, *a), top(&mut root, *b));
        root[a] = b;
    }
    let pieces = (0..root.len()).filter(|i| root[*i] == *i).count();
    assert_eq!(pieces, 1, "{what}: pieces, or corners without a triangle");
    let euler = mesh.corners.len() as i64 - edges.len() as i64 / 2 + mesh.triangles.len() as i64;
    assert_eq!(euler, 0, "{what}: V − E + F");
}

/// What lies between the z axis and a profile (r, z) that is revolved around it: frusta, π/3 (r0² +
/// r0 r1 + r1²) h each.
fn revolved_mm3(profile: &[[f64; 2]]) -> f64 {
    let cone = |p: &[[f64; 2]]| {
        let ([r0, z0], [r1, z1]) = (p[0], p[1]);
        (r0 * r0 + r0 * r1 + r1 * r1) * (z1 - z0)
    };
    PI / 3.0 * profile.windows(2).map(cone).sum::<f64>()
}

/// The stem, and the plate of the eye less its hole.
fn exact_mm3(eye: &EyePlug) -> f64 {
    let (w, hole) = (eye.width_mm, 0.5 * eye.hole_mm);
    let area = w * eye.centre_mm + 0.125 * PI * w * w - PI * hole * hole;
    let mut closed = vec![[0.0, 0.0]];
    closed.extend(eye.stem.profile());
    closed.push([0.0, eye.stem.top_mm()]);
    revolved_mm3(&closed) + area * eye.thickness_mm
}

fn wishes(fitting: &str, bolt_mm: Option<f64>) -> Wishes {
    Wishes {
        fitting: Some(fitting.parse().unwrap()),
        bolt_mm,
        ..Wishes::default()
    }
}

/// Muscles of 2 to 60 mm, each fitting, given and chosen bolts.
#[test]
fn every_plug_is_closed_and_has_the_volume_of_its_section() {
    // A circle of N corners has this share of its area.
    let facets = N / TAU * (TAU / N).sin();
    for (outer_mm, wall_mm) in [
        (2.0, 0.4),
        (5.0, 1.0),
        (9.525, 1.5875),
        (21.0, 1.5),
        (30.0, 3.0),
        (60.0, 4.0),
    ] {
        for (fitting, bolt_mm) in [
            ("m5", None),
            ("g1/8", Some(5.0)),
            ("g1/4", Some(12.0)),
            ("barb:4", Some(3.0)),
            ("barb:9mm", Some(7.3)),
        ] {
            let plan = plan_of(outer_mm, wall_mm, &wishes(fitting, bolt_mm));
            let what = format!("{outer_mm} mm, {fitting}");
            let air = plan.air_plug.mesh();
            assert_closed(&air, &what);
            // An identity: between rings of corners lie plane trapezia.
            let exact = facets * revolved_mm3(&plan.air_plug.profile());
            assert!(
                (air.volume_mm3() / exact - 1.0).abs() < 1e-9,
                "{what}: {} {exact}",
                air.volume_mm3()
            );
            let eye = plan.eye_plug.mesh();
            assert_closed(&eye, &what);
            // 1 − (N/2π) sin(2π/N) is 2π²/3N² and less.
            let off = eye.volume_mm3() / exact_mm3(&plan.eye_plug) - 1.0;
            assert!(off.abs() < 2.0 * PI * PI / (3.0 * N * N), "{what}: {off}");
        }
    }
}

/// The volume read back from the file is that of the surface; its numbers have 24 bits.
#[test]
fn the_file_for_the_printer_has_every_triangle() {
    let plan = plan_of(21.0, 1.5, &Wishes::default());
    for mesh in [plan.air_plug.mesh(), plan.eye_plug.mesh()] {
        let bytes = mesh.to_stl("mckibben build");
        let count = u32::from_le_bytes(bytes[80..84].try_into().unwrap()) as usize;
        assert_eq!(
            (count, bytes.len()),
            (mesh.triangles.len(), 84 + 50 * mesh.triangles.len())
        );
        // A file in text would begin so.
        assert!(!bytes.starts_with(b"solid"));
        let number = |at: &[u8]| f64::from(f32::from_le_bytes(at.try_into().unwrap()));
        let mut volume = 0.0;
        for record in bytes[84..].chunks_exact(50) {
            let v: Vec<f64> = record[..48].chunks_exact(4).map(number).collect();
            let (normal, a, b, c) = (&v[..3], &v[3..6], &v[6..9], &v[9..12]);
            let cross = [
                b[1] * c[2] - b[2] * c[1],
                b[2] * c[0] - b[0] * c[2],
                b[0] * c[1] - b[1] * c[0],
            ];
            volume += (0..3).map(|k| a[k] * cross[k]).sum::<f64>() / 6.0;
            assert!((normal.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-5);
        }
        assert!((volume / mesh.volume_mm3() - 1.0).abs() < 1e-5, "{volume}");
    }
}

/// By hand: a bore of 8 mm, 5 % wider 8.4 mm, ± a quarter of 0.4 mm; the groove of 0.504 mm leaves
/// 7.392 mm around a passage of 2.5 mm, 38 mm² that carry 1900 N with 50 MPa. Printed layers are
/// taken to bear 10 MPa.
#[test]
fn a_printed_stem_that_its_load_would_tear_is_said() {
    let plan = plan_of(12.0, 2.0, &Wishes::default());
    assert!((plan.air_plug.stem.diameter_mm - 8.4).abs() < 1e-9);
    let text = |plan: &Plan, name: &str| {
        let file = files(plan)
            .unwrap()
            .into_iter()
            .find(|f| f.name == name)
            .unwrap();
        if let Content::Text(text) = file.content {
            text
        } else {
            panic!("{name}")
        }
    };
    assert!(text(&plan, "plugs.svg").contains("⌀8.4 ±0.1"));
    let section = 0.25 * PI * (7.392f64.powi(2) - plan.air_plug.passage_mm.powi(2));
    let torn = Plan {
        end_load_n: 50.0 * section,
        ..plan.clone()
    };
    assert!(
        torn.warnings().iter().any(|w| w.contains("carries 50 MPa")),
        "{:?}",
        torn.warnings()
    );
    assert!(
        text(&torn, "plugs.svg").contains("Turn ") && !text(&torn, "README.md").contains("Print ")
    );
    assert!(
        !Plan {
            end_load_n: 9.9 * section,
            ..plan
        }
        .warnings()
        .iter()
        .any(|w| w.contains("MPa across"))
    );
}
