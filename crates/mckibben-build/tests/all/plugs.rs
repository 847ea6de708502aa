//! The plugs as surfaces of triangles.

use crate::files::plan_of;
use mckibben_build::{Content, Mesh, Plug, Wishes, files, frame::Frame};
use std::{
    collections::HashMap,
    f64::consts::{PI, TAU},
};

/// Corners of a circle.
const N: f64 = 96.0;

/// Identities of a closed surface: each edge is that of two triangles, which run along it in
/// opposite directions; one piece; V − E + F = 2 − 2g, with g holes through it.
fn assert_closed(mesh: &Mesh, holes: i64, what: &str) {
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
    assert_eq!(euler, 2 - 2 * holes, "{what}: V − E + F");
}

/// Volume in mm³ by the theorem of Gauss: Σ a · (b × c)/6.
fn volume_mm3(mesh: &Mesh) -> f64 {
    let volume = |t: &[usize; 3]| {
        let [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = t.map(|i| mesh.corners[i]);
        (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6.0
    };
    mesh.triangles.iter().map(volume).sum()
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

/// Stem, collar and head, less the hole of the bolt, the hole of the thread, and the passage up to
/// where it meets that: h − the mean of √(R² − x²) over it.
fn exact_mm3(plug: &Plug) -> f64 {
    let head = plug.side_mm * plug.side_mm * (plug.length_mm - plug.foot_mm);
    let collar = plug.collar_mm.map_or(0.0, |d| {
        0.25 * PI * d * d * (plug.foot_mm - plug.stem.length_mm)
    });
    // A printed hole has a roof: the corner above the circle is r² (1 − π/4).
    let r = 0.5 * plug.hole_mm;
    let roof = if plug.is_printed() {
        r * r * (1.0 - PI / 4.0)
    } else {
        0.0
    };
    let eye = (PI * r * r + roof) * plug.side_mm;
    let port = plug.port.map_or(0.0, |port| {
        let (r, p) = (0.5 * port.hole_mm, 0.5 * port.passage_mm);
        let steps = 2000;
        let strip = |i: usize| {
            let x = p * ((2 * i + 1) as f64 / steps as f64 - 1.0);
            2.0 * (p * p - x * x).sqrt() * (r * r - x * x).sqrt() * 2.0 * p / steps as f64
        };
        let met: f64 = (0..steps).map(strip).sum();
        PI * r * r * port.depth_mm + PI * p * p * port.height_mm - met
    });
    revolved_mm3(&plug.stem.profile) + collar + head - eye - port
}

fn wishes(fitting: &str, bolt_mm: Option<f64>) -> Wishes {
    Wishes {
        fitting: Some(fitting.parse().unwrap()),
        bolt_mm,
        ..Wishes::default()
    }
}

/// Every kind of end, each fitting, given and chosen bolts, printed and turned, with one port and
/// two: closed, with the volume of its sections, all walls 1 mm or more, and standing on the end of
/// its head.
#[test]
fn every_plug_is_closed_and_has_the_volume_of_its_section() {
    let mut printed = 0;
    for (outer_mm, wall_mm) in [
        (2.0, 0.4),
        (5.0, 1.0),
        (9.525, 1.5875),
        (21.0, 1.5),
        (30.0, 3.0),
        (60.0, 4.0),
    ] {
        for (fitting, bolt_mm) in [
            ("m3", None),
            ("m5", None),
            ("g1/8", Some(5.0)),
            ("g1/4", Some(12.0)),
            ("barb:4", Some(3.0)),
        ] {
            for liquid in [false, true] {
                let what = format!("{outer_mm} mm, {fitting}, {bolt_mm:?}, {liquid}");
                let wishes = Wishes {
                    liquid,
                    ..wishes(fitting, bolt_mm)
                };
                let plan = plan_of(outer_mm, wall_mm, &wishes);
                for plug in [&plan.air_plug, &plan.eye_plug] {
                    printed += usize::from(plug.is_printed());
                    let mesh = plug.mesh();
                    let holes = 1 + i64::from(plug.port.is_some());
                    assert_closed(&mesh, holes, &what);
                    let exact = exact_mm3(plug);
                    // A circle of N corners has this share of its area.
                    let facets = N / TAU * (TAU / N).sin();
                    let stated = plug.volume_mm3() / exact - 1.0;
                    assert!(stated.abs() < 2e-4, "{what}: {stated}");
                    let off = volume_mm3(&mesh) / exact - 1.0;
                    assert!(off.abs() < 2.0 * (1.0 - facets), "{what}: {off}");
                    if let Some(port) = plug.port {
                        let back = plug.side_mm - port.depth_mm;
                        let below = port.height_mm - 0.5 * port.hole_mm - plug.stem.length_mm;
                        let beside = 0.5 * (plug.side_mm - port.hole_mm);
                        let eye = plug.eye_mm - port.height_mm;
                        let between = eye - 0.5 * (port.hole_mm + 1.42 * plug.hole_mm);
                        for wall in [back, below, beside, between] {
                            assert!(wall >= 1.0 - 1e-9, "{what}: {wall} {plug:?}");
                        }
                    }
                    let stands = plug.printed();
                    let foot = stands.corners.iter().filter(|c| c[2].abs() < 1e-9);
                    assert_eq!(foot.count(), 4, "{what}");
                    assert!(stands.corners.iter().all(|c| c[2] > -1e-9), "{what}");
                    assert!((volume_mm3(&stands) - volume_mm3(&mesh)).abs() < 1e-6 * exact);
                }
            }
        }
    }
    assert!(printed > 10 && printed < 110, "{printed}");
}

/// The file as its format demands: 84 bytes, and 50 for each triangle, whose corners are those of
/// the surface in 32 bits.
#[test]
fn the_stl_has_all_triangles() {
    let plan = plan_of(9.525, 1.5875, &Wishes::default());
    let all = files(&plan).unwrap();
    for (name, plug) in [
        ("bodies/air-plug.stl", &plan.air_plug),
        ("bodies/eye-plug.stl", &plan.eye_plug),
    ] {
        let file = all.iter().find(|f| f.name == name).unwrap();
        let Content::Bytes(stl) = &file.content else {
            panic!("{file:?}")
        };
        let mesh = plug.printed();
        assert!(stl.starts_with(b"mckibben build"));
        assert_eq!(stl.len(), 84 + 50 * mesh.triangles.len());
        let number = |at: usize| f32::from_le_bytes(stl[at..at + 4].try_into().unwrap());
        let corner = mesh.corners[mesh.triangles[0][0]];
        for (k, value) in corner.iter().enumerate() {
            assert_eq!(number(84 + 12 + 4 * k), *value as f32);
        }
    }
}

#[test]
fn words_that_are_no_fitting_are_refused() {
    for word in ["", "g1/2", "barb:", "barb:0.5", "barb:14", "barb:NaN", "m6"] {
        assert!(word.parse::<mckibben_build::Fitting>().is_err(), "{word}");
    }
}

/// Identity of a closed surface of exact faces: each edge bounds two faces, and runs along them in
/// opposite directions; every real number has a point.
#[test]
fn the_edges_of_a_turned_plug_are_each_those_of_two_faces() {
    for (outer_mm, wall_mm, liquid) in [(3.0, 0.5, false), (30.0, 3.0, true), (60.0, 4.0, false)] {
        let wishes = Wishes {
            liquid,
            ..Wishes::default()
        };
        let all = files(&plan_of(outer_mm, wall_mm, &wishes)).unwrap();
        let steps: Vec<&str> = all
            .iter()
            .filter(|f| f.name.ends_with(".step"))
            .map(|f| std::str::from_utf8(f.content.bytes()).unwrap())
            .collect();
        assert_eq!(steps.len(), 2);
        for step in steps {
            let mut used: HashMap<&str, Vec<&str>> = HashMap::new();
            for oriented in step
                .lines()
                .filter_map(|l| l.split_once("ORIENTED_EDGE('',*,*,"))
            {
                let (edge, sense) = oriented.1.split_once(',').unwrap();
                used.entry(edge).or_default().push(sense);
            }
            assert!(used.len() > 20);
            for (edge, mut senses) in used {
                senses.sort_unstable();
                assert_eq!(senses, [".F.);", ".T.);"], "{outer_mm} mm: {edge}");
            }
            assert!(!step.contains("NaN") && !step.contains("inf"));
        }
    }
}

/// By hand, M8 in a head of 20 mm at 2000 N: M = 2000 · (20 + 16)/8 = 9000 N mm on a root of 6.28 mm, W =
/// π 6.28³/32 = 24.315 mm³; shear 4/3 · 2000/(2 · 30.97) MPa; 2000 N on 8 · 20 mm², and beside the hole
/// of 9 mm on 20 · 11 mm².
#[test]
fn by_hand_bolt_and_head_bear_the_proof() {
    let mut plug = plan_of(30.0, 3.0, &wishes("m5", Some(8.0))).air_plug;
    (plug.side_mm, plug.eye_mm, plug.length_mm) = (20.0, 50.0, 64.0);
    let stresses = plug.stresses(2000.0);
    let of = |what: &str| stresses.iter().find(|s| s.what == what).unwrap();
    for (what, mpa) in [
        ("bolt, bending", 370.14),
        ("bolt, shear", 43.05),
        ("bolt on its hole", 12.5),
        ("head beside the bolt", 9.0909),
        // 14 − 4.5 mm behind the hole, on both sides.
        ("head behind the bolt, shear", 2000.0 / (2.0 * 20.0 * 9.5)),
    ] {
        assert!((of(what).mpa - mpa).abs() < 0.01, "{:?}", of(what));
    }
    assert_eq!(of("bolt, bending").yields_mpa, 640.0);
}

/// A bolt that is chosen stays a tenth below its yield, is one that is sold, no longer than ten times
/// its diameter, and goes through head, cheeks and nut.
#[test]
fn every_bolt_that_is_chosen_bears_and_is_sold() {
    for (outer_mm, wall_mm) in [
        (3.0, 0.5),
        (9.525, 1.5875),
        (16.0, 3.0),
        (30.0, 3.0),
        (90.0, 5.0),
    ] {
        for liquid in [false, true] {
            let wishes = Wishes {
                liquid,
                ..Wishes::default()
            };
            let plan = plan_of(outer_mm, wall_mm, &wishes);
            for plug in [&plan.air_plug, &plan.eye_plug] {
                for stress in plug.stresses(plan.loads.proof_end_load_high_n) {
                    assert!(
                        stress.yields_mpa >= 1.1 * stress.mpa,
                        "{outer_mm}: {stress:?}"
                    );
                }
            }
            // The bars have room between collar and bolt, and the rods between the bars.
            let frame = Frame::new(&plan);
            let load_n = plan.loads.proof_end_load_high_n;
            for stress in [
                frame.stress(load_n),
                frame.bar.stress(plan.air_plug.bolt.mm, load_n),
            ] {
                assert!(
                    stress.yields_mpa >= 1.1 * stress.mpa,
                    "{outer_mm}: {stress:?}"
                );
            }
            for plug in [&plan.air_plug, &plan.eye_plug] {
                let room = plug.eye_mm - plug.foot_mm - 0.5 * frame.bar.width_mm;
                assert!(room >= 1.0 - 1e-9, "{outer_mm}: {room}");
                assert!(frame.rod_mm <= plug.side_mm, "{outer_mm}: {frame:?}");
            }
            for bolt in plan
                .parts
                .iter()
                .filter(|part| part.part == "bolt with nut")
            {
                let numbers: Vec<f64> = bolt
                    .size
                    .split([' ', 'M', ','])
                    .filter_map(|word| word.parse().ok())
                    .collect();
                let [diameter, length] = numbers[..2] else {
                    panic!("{bolt:?}")
                };
                assert!(length <= 10.0 * diameter, "{outer_mm}: {bolt:?}");
                assert!(length >= plan.eye_plug.side_mm + 3.0 * diameter, "{bolt:?}");
            }
        }
    }
}

/// A ferrule lies clear of tube and head, and its dies pass a collar behind it.
#[test]
fn a_ferrule_has_room_for_its_dies() {
    let mut seen = 0;
    for outer_mm in [12.0, 20.0, 30.0, 36.0] {
        let plan = plan_of(outer_mm, 0.1 * outer_mm, &Wishes::default());
        let Some(mckibben_build::ends::Press::Ferrule(ferrule)) = plan.ends.press else {
            continue;
        };
        seen += 1;
        let stem = &plan.air_plug.stem;
        let [from, to] = stem.pressed_mm[0];
        assert_eq!(to - from, ferrule.length_mm);
        assert!(from >= stem.shoulder_mm.unwrap()[1] + 1.0 && stem.length_mm - to >= 3.0 - 1e-9);
        assert!(
            plan.air_plug
                .collar_mm
                .is_none_or(|collar| collar < ferrule.pressed_mm)
        );
        assert!(ferrule.holds_n()[0] >= plan.loads.proof_end_load_high_n);
    }
    assert!(seen > 1);
}
