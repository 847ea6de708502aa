//! Files for ParaView, read back.

use base64::Engine as _;
use mckibben_core::{
    model::{ForceModel as _, Response, Workspace},
    muscle::{Braid, BraidStiffness, Muscle, Strands},
};
use mckibben_fem::{
    axisymmetric::{Axisymmetric, MeshSpec},
    output::{Shape, VtuError, VtuFile, VtuSeries},
    simulation::{ElementModel as _, Given},
};
use std::{
    f64::consts::{PI, TAU},
    io::Read as _,
};

const AROUND: f64 = 48.0;

fn array(text: &str, name: &str) -> (String, Vec<u8>) {
    let document = roxmltree::Document::parse(text).unwrap();
    let node = document
        .descendants()
        .find(|n| n.attribute("Name") == Some(name))
        .unwrap();
    let text = node.text().unwrap();
    let engine = base64::engine::general_purpose::STANDARD;
    // Four numbers of eight bytes are 44 characters.
    let header = engine.decode(&text[..44]).unwrap();
    let number = |k: usize| u64::from_le_bytes(header[8 * k..8 * k + 8].try_into().unwrap());
    let packed = engine.decode(&text[44..]).unwrap();
    assert_eq!(
        (number(0), number(2), number(3)),
        (1, 0, packed.len() as u64)
    );
    let mut bytes = vec![];
    flate2::read::ZlibDecoder::new(&packed[..])
        .read_to_end(&mut bytes)
        .unwrap();
    assert_eq!(number(1), bytes.len() as u64);
    (node.attribute("type").unwrap().to_owned(), bytes)
}

fn numbers(text: &str, name: &str) -> Vec<f64> {
    let (kind, bytes) = array(text, name);
    let double = |c: &[u8]| f64::from_le_bytes(c.try_into().unwrap());
    match kind.as_str() {
        "Float64" => bytes.chunks(8).map(double).collect(),
        "Float32" => bytes
            .chunks(4)
            .map(|c| f64::from(f32::from_le_bytes(c.try_into().unwrap())))
            .collect(),
        "Int64" => bytes
            .chunks(8)
            .map(|c| i64::from_le_bytes(c.try_into().unwrap()) as f64)
            .collect(),
        other => panic!("{other}"),
    }
}

fn points(text: &str, name: &str) -> Vec<[f64; 3]> {
    numbers(text, name)
        .chunks(3)
        .map(|c| c.try_into().unwrap())
        .collect()
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[k] - b[k])
}

fn norm(a: [f64; 3]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Volume of a hexahedron with plane faces: six tetrahedra around the diagonal 0–6; each must be
/// turned outside out.
fn hexahedron(p: &[[f64; 3]]) -> f64 {
    [[1, 2], [2, 3], [3, 7], [7, 4], [4, 5], [5, 1]]
        .iter()
        .map(|&[a, b]| {
            let [u, v, w] = [p[a], p[b], p[6]].map(|q| minus(q, p[0]));
            let cross = [
                u[1] * v[2] - u[2] * v[1],
                u[2] * v[0] - u[0] * v[2],
                u[0] * v[1] - u[1] * v[0],
            ];
            let volume = cross.iter().zip(w).map(|(a, b)| a * b).sum::<f64>() / 6.0;
            assert!(volume > 0.0);
            volume
        })
        .sum()
}

fn volume(text: &str, points: &[[f64; 3]]) -> f64 {
    let connectivity = numbers(text, "connectivity");
    connectivity
        .chunks(8)
        .map(|cell| hexahedron(&cell.iter().map(|&k| points[k as usize]).collect::<Vec<_>>()))
        .sum()
}

/// The lines of a braid.
fn lines(text: &str) -> Vec<Vec<[f64; 3]>> {
    let (places, connectivity) = (points(text, "Points"), numbers(text, "connectivity"));
    let mut start = 0;
    numbers(text, "offsets")
        .into_iter()
        .map(|end| {
            let line = connectivity[start..end as usize]
                .iter()
                .map(|&k| places[k as usize])
                .collect();
            start = end as usize;
            line
        })
        .collect()
}

fn length(line: &[[f64; 3]]) -> f64 {
    line.windows(2).map(|p| norm(minus(p[1], p[0]))).sum()
}

fn text(files: &[VtuFile], name: &str) -> String {
    files.iter().find(|f| f.name == name).unwrap().text.clone()
}

/// One step: (tube, braid).
fn written(fe: &Axisymmetric, response: &Response) -> (String, String) {
    let section = fe
        .section_at(
            &mut Workspace::new(),
            response.pressure_mpa,
            response.contraction,
        )
        .unwrap();
    let files = VtuSeries::new("a test")
        .add(Shape::of_section(&section), response)
        .unwrap();
    (
        text(&files, "tube_0000.vtu"),
        text(&files, "braid_0000.vtu"),
    )
}

fn contracted() -> (Muscle, Axisymmetric, Response) {
    let muscle = Muscle::prototype();
    let fe = Axisymmetric::between_ends(&muscle).unwrap();
    let response = fe.response(&mut Workspace::new(), 0.2, 0.1).unwrap();
    (muscle, fe, response)
}

/// A polygon of n corners has the share sin(2π/n)/(2π/n) of its circle's area.
#[test]
fn elements_at_rest_fill_the_tube_but_for_the_polygon() {
    let muscle = Muscle::prototype();
    for mesh in [
        MeshSpec::default(),
        MeshSpec {
            through: Some(2),
            along: Some(9),
            grading: Some(1.0),
        },
    ] {
        let fe = Axisymmetric::between_ends_with(&muscle, &mesh).unwrap();
        let (tube, _) = written(&fe, &Response::default());
        let polygon = (TAU / AROUND).sin() / (TAU / AROUND);
        let exact = muscle.build_sheet().rubber_volume_mm3;
        let plain = exact * muscle.length_mm() / muscle.build_sheet().tube_cut_mm;
        let of_file = volume(&tube, &points(&tube, "Points"));
        assert!(
            (of_file / (plain * polygon) - 1.0).abs() < 1e-12,
            "{of_file} {plain}"
        );
    }
}

/// Incompressible rubber: the same after contraction, but for lines drawn straight. Along, h²κ/8 of
/// the radius.
#[test]
fn elements_keep_their_volume_and_displacements_lead_back_to_rest() {
    let (_, fe, response) = contracted();
    let (tube, _) = written(&fe, &response);
    let now = points(&tube, "Points");
    let rest: Vec<[f64; 3]> = now
        .iter()
        .zip(points(&tube, "displacement"))
        .map(|(a, b)| minus(*a, b))
        .collect();
    let at_rest = volume(&tube, &rest);
    let (untouched, _) = written(
        &Axisymmetric::between_ends(&Muscle::prototype()).unwrap(),
        &Response::default(),
    );
    for (a, b) in rest.iter().zip(points(&untouched, "Points")) {
        assert!(norm(minus(*a, b)) < 1e-12);
    }
    assert!((volume(&tube, &now) / at_rest - 1.0).abs() < 2e-3);
    let bulge = now.iter().map(|p| p[0].hypot(p[1])).fold(0.0, f64::max);
    // The elements' surface may rise between their nodes.
    let short = 1.0 - 2.0 * bulge / response.bulged_diameter_mm.unwrap();
    assert!((-1e-13..2e-4).contains(&short), "{short}");
}

/// A helix of length L0/cosθ0; a chord over the turn δ is shorter by the share sin²θ0 δ²/24 at
/// most.
#[test]
fn strands_at_rest_have_the_length_of_a_helix() {
    let muscle = Muscle::prototype();
    let (_, braid) = written(
        &Axisymmetric::between_ends(&muscle).unwrap(),
        &Response::default(),
    );
    let lines = lines(&braid);
    assert_eq!(lines.len(), 48);
    let turn =
        |p: [f64; 3], q: [f64; 3]| (p[0] * q[1] - p[1] * q[0]).atan2(p[0] * q[0] + p[1] * q[1]);
    let sin = muscle.braid().angle_rad().sin();
    for (k, line) in lines.iter().enumerate() {
        let turns: Vec<f64> = line.windows(2).map(|p| turn(p[0], p[1])).collect();
        let largest = turns.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let lost = 1.0 - length(line) / muscle.strand_length_mm();
        assert!(
            lost > 0.0 && lost < (sin * largest).powi(2) / 24.0,
            "{lost} {largest}"
        );
        // Families by their hand, the number of turns as the muscle tells it.
        let sign = if k < 24 { 1.0 } else { -1.0 };
        assert!((turns.iter().sum::<f64>() / TAU - sign * muscle.turns()).abs() < 1e-12);
    }
}

/// Under pressure strands stretch by what the model says: the mean of λf along the strand is its
/// length now.
#[test]
fn strands_under_pressure_are_as_long_as_their_stretch_says() {
    let (muscle, fe, response) = contracted();
    let (_, braid) = written(&fe, &response);
    let solution = fe
        .solve(&mut Workspace::new(), Given::at(0.2, 0.1))
        .unwrap();
    let stretches: Vec<f64> = solution.strands.iter().map(|s| s.stretch).collect();
    let (low, high) = (
        stretches.iter().copied().fold(f64::MAX, f64::min),
        stretches.iter().copied().fold(0.0, f64::max),
    );
    let written = numbers(&braid, "stretch");
    assert!(written.iter().all(|x| *x > low - 1e-6 && *x < high + 1e-6));
    for line in lines(&braid) {
        let stretch = length(&line) / muscle.strand_length_mm();
        assert!(
            stretch > low - 1e-3 && stretch < high + 1e-3,
            "{low} {stretch} {high}"
        );
    }
}

#[test]
fn strands_are_counted_where_their_number_is_known() {
    let strands = Strands::new(60, None, None);
    let braid = Braid {
        stiffness: BraidStiffness::Inextensible,
        strands: Some(strands),
        ..Muscle::prototype().braid().clone()
    };
    let fe = Axisymmetric::between_ends(&Muscle::prototype().with_braid(braid).unwrap()).unwrap();
    let response = fe.response(&mut Workspace::new(), 0.2, 0.1).unwrap();
    let (_, braid) = written(&fe, &response);
    assert_eq!(lines(&braid).len(), 60);
    assert!(!braid.contains("for display"));
    let largest = numbers(&braid, "tension_n").into_iter().fold(0.0, f64::max);
    assert!((largest / response.strand_tension_n.unwrap() - 1.0).abs() < 1e-6);
}

#[test]
fn both_halves_are_mirror_images() {
    let (_, fe, response) = contracted();
    let (tube, _) = written(&fe, &response);
    let rings: Vec<Vec<[f64; 3]>> = points(&tube, "Points")
        .chunks(48)
        .map(<[_]>::to_vec)
        .collect();
    let across = 2 * fe
        .section_at(&mut Workspace::new(), 0.2, 0.1)
        .unwrap()
        .through
        + 1;
    let stations = rings.len() / across;
    for (k, ring) in rings.iter().enumerate() {
        let (j, i) = (k / across, k % across);
        for (p, q) in ring.iter().zip(&rings[(stations - 1 - j) * across + i]) {
            assert_eq!((p[0], p[1], p[2]), (q[0], q[1], -q[2]));
        }
    }
}

/// Lamé, the bore and the outer surface of a long tube far from its ends carry −P and the braid's
/// pressure; axial stress over the section is the pull less the pressure's share. Limits: error of
/// the elements' stress at their nodes.
#[test]
fn stress_in_the_middle_is_in_equilibrium() {
    let muscle = Muscle::prototype();
    let mesh = MeshSpec {
        through: Some(6),
        along: Some(24),
        grading: None,
    };
    let fe = Axisymmetric::between_ends_with(&muscle, &mesh).unwrap();
    let response = fe.response(&mut Workspace::new(), 0.2, 0.1).unwrap();
    let section = fe.section_at(&mut Workspace::new(), 0.2, 0.1).unwrap();
    let middle: Vec<_> = (0..=12)
        .map(|i| section.nodes[section.index(i, 0)])
        .collect();
    let (bore, outside) = (middle[0], middle[12]);
    assert!((bore.stress_mpa[0] + 0.2).abs() < 1e-3, "{bore:?}");
    let strand = section.strands[0];
    let cos0 = muscle.braid().angle_rad().cos();
    // Force over the section: ∫ σzz dA + braid = F + P π r_i².
    let mut rubber = 0.0;
    for k in 0..6 {
        let [a, b, c] = [middle[2 * k], middle[2 * k + 1], middle[2 * k + 2]];
        let width = c.now_mm[0] - a.now_mm[0];
        let f = |n: &mckibben_fem::axisymmetric::SectionNode| n.stress_mpa[2] * TAU * n.now_mm[0];
        rubber += width / 6.0 * (f(&a) + 4.0 * f(&b) + f(&c));
    }
    // A family's strands crossing the section: 2πRo cosθ0 of width, each pulling along cosθ.
    let pull =
        2.0 * TAU * 15.0 * cos0 * strand.tension_n_per_mm * strand.angle_deg.to_radians().cos();
    let expected = response.force_n + 0.2 * PI * bore.now_mm[0].powi(2);
    assert!(
        ((rubber + pull) / expected - 1.0).abs() < 1e-3,
        "{rubber} {pull} {expected}"
    );
    // Normal pressure of the braid outside: F·sinθ tanθ/(2π r²) per family pull along the axis.
    let tan = strand.angle_deg.to_radians().tan();
    let braid = pull * tan * tan / (TAU * outside.now_mm[0].powi(2));
    assert!(
        (outside.stress_mpa[0] + braid).abs() < 2e-3,
        "{outside:?} {braid}"
    );
}

#[test]
fn the_same_muscle_gives_the_same_bytes_in_well_formed_xml() {
    let run = || {
        let (_, fe, _) = contracted();
        let mut series = VtuSeries::new("a < b -- & --- c-");
        let w = &mut Workspace::new();
        let step = |p: f64| {
            let response = fe.response(w, p, 0.1).unwrap();
            let section = fe.section_at(w, p, 0.1).unwrap();
            series.add(Shape::of_section(&section), &response).unwrap()
        };
        let steps: Vec<Vec<VtuFile>> = [0.15, 0.2].map(step).into();
        (steps, series.list())
    };
    let (steps, last) = run();
    assert_eq!((steps.clone(), last.clone()), run());
    let names: Vec<Vec<&str>> = steps
        .iter()
        .map(|files| files.iter().map(|f| f.name.as_str()).collect())
        .collect();
    assert_eq!(names[0], ["tube_0000.vtu", "braid_0000.vtu", "muscle.pvd"]);
    assert_eq!(names[1], ["tube_0001.vtu", "braid_0001.vtu", "muscle.pvd"]);
    assert_eq!(
        steps[1][2], last,
        "the list comes last and names all steps so far"
    );
    for file in steps.iter().flatten() {
        assert!(
            file.text.len() < 300_000,
            "{}: {}",
            file.name,
            file.text.len()
        );
        roxmltree::Document::parse(&file.text).unwrap();
    }
    let list = roxmltree::Document::parse(&last.text).unwrap();
    let listed: Vec<_> = list
        .descendants()
        .filter(|n| n.has_tag_name("DataSet"))
        .map(|n| {
            (
                n.attribute("timestep").unwrap(),
                n.attribute("part").unwrap(),
                n.attribute("file").unwrap(),
            )
        })
        .collect();
    assert_eq!(
        listed,
        [
            ("0", "0", "tube_0000.vtu"),
            ("0", "1", "braid_0000.vtu"),
            ("1", "0", "tube_0001.vtu"),
            ("1", "1", "braid_0001.vtu")
        ]
    );
}

#[test]
fn what_is_no_number_is_refused_and_is_no_step() {
    let fe = Axisymmetric::between_ends(&Muscle::prototype()).unwrap();
    let mut series = VtuSeries::new("");
    let section = fe.section_at(&mut Workspace::new(), 0.0, 0.0).unwrap();
    let bad = Response {
        force_n: f64::NAN,
        ..Response::default()
    };
    let error = series.add(Shape::of_section(&section), &bad).unwrap_err();
    assert!(
        matches!(
            error,
            VtuError {
                name: "force_n",
                ..
            }
        ),
        "{error}"
    );
    assert!(!series.list().text.contains("tube_0000.vtu"));
}
