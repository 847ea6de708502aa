//! Pictures of bodies: what is seen, what is hidden, what is refused.

use mckibben_report::{Axis, Face, FigureError, Scene, Thread, View};

/// The faces of a cube of side `a` about the origin, counter-clockwise from outside, each with its own value.
fn cube(a: f64) -> Vec<Face> {
    let h = a / 2.0;
    let corner = |i: usize| [0, 1, 2].map(|k| if i >> k & 1 == 1 { h } else { -h });
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
        .iter()
        .enumerate()
        .map(|(i, f)| Face { corners: f.map(corner), values: Some([i as f64; 4]) })
        .collect()
}

fn scene(faces: Vec<Face>, threads: Vec<Thread>) -> Scene {
    Scene {
        title: "a cube".into(),
        caption: String::new(),
        faces,
        threads,
        values: Axis::new("face").range(0.0, 5.0),
        length_unit: "mm".into(),
        view: View { azimuth_deg: 30.0, elevation_deg: 30.0 },
        width_mm: 100.0,
    }
}

/// Outline of a convex body: three faces of a cube are seen from a general direction, and they cover its silhouette.
#[test]
fn three_faces_of_a_cube_are_seen() {
    let plain: Vec<Face> = cube(10.0).into_iter().map(|f| Face { values: None, ..f }).collect();
    let svg = scene(plain, vec![]).to_svg().unwrap();
    assert_eq!(svg.matches("Z\" fill=").count(), 3);
}

#[test]
fn a_thread_on_a_face_that_looks_away_is_hidden() {
    let line = |y: f64| Thread {
        points: vec![[0.0, y, -4.0], [0.0, y, 4.0]],
        outward: vec![[0.0, y, 0.0]; 2],
        width_mm: 0.2,
    };
    let strokes = |t| scene(cube(10.0), vec![t]).to_svg().unwrap().matches("stroke=\"#1d1d1d\"").count();
    assert_eq!(strokes(line(5.0)), 1);
    assert_eq!(strokes(line(-5.0)), 0);
}

/// The part drawn last hides the others: the nearer of two parallel squares.
#[test]
fn the_nearer_of_two_squares_is_drawn_last() {
    let square = |y: f64| Face {
        corners: [[-1.0, y, -1.0], [-1.0, y, 1.0], [1.0, y, 1.0], [1.0, y, -1.0]],
        values: None,
    };
    let front = View { azimuth_deg: 0.0, elevation_deg: 0.0 };
    let size =
        |face: &Face| Face { corners: face.corners.map(|c| [c[0] * 0.5, c[1], c[2] * 0.5]), ..face.clone() };
    let (far, near) = (square(0.0), size(&square(3.0)));
    let one = Scene { view: front, ..scene(vec![far.clone(), near.clone()], vec![]) };
    let other = Scene { view: front, ..scene(vec![near, far], vec![]) };
    assert_eq!(one.to_svg().unwrap(), other.to_svg().unwrap());
}

#[test]
fn a_picture_is_a_png_of_its_width() {
    let png = scene(cube(10.0), vec![]).to_png().unwrap();
    assert_eq!(&png[1..4], b"PNG");
    assert_eq!(u32::from_be_bytes([png[16], png[17], png[18], png[19]]), 1000);
}

#[test]
fn nothing_to_see_and_numbers_that_are_none_are_refused() {
    assert!(matches!(scene(vec![], vec![]).to_svg(), Err(FigureError::NoPanels { .. })));
    let mut faces = cube(10.0);
    faces[0].corners[0][0] = f64::NAN;
    assert!(matches!(scene(faces, vec![]).to_svg(), Err(FigureError::NotFinite { .. })));
    let mut faces = cube(10.0);
    faces[1].values = Some([f64::INFINITY; 4]);
    assert!(matches!(scene(faces, vec![]).to_svg(), Err(FigureError::NotFinite { .. })));
    let path = std::path::Path::new("picture.html");
    assert!(matches!(scene(cube(1.0), vec![]).save(path), Err(FigureError::UnknownExtension { .. })));
}
