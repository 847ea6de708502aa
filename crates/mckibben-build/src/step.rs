//! A turned plug as a body of exact faces for a machine shop: ISO 10303-21 (STEP), AP214.
//!
//! The stem and the collar are cylinders, cones and rings about the axis, the head has planes, and
//! its holes are cylinders. Where the passage meets the hole of the thread their edge is a spline
//! through points of both.

use crate::plug::{Plug, Port};
use mckibben_core::joined;
use std::{f64::consts::TAU, fmt::Write as _};

type Point = [f64; 3];
const X: Point = [1.0, 0.0, 0.0];
const Y: Point = [0.0, 1.0, 0.0];
const Z: Point = [0.0, 0.0, 1.0];
/// Points of the edge between passage and hole; the spline is off by less than 1 µm.
const SPLINE: usize = 48;

/// The numbered lines of a file.
#[derive(Default)]
struct Step {
    data: String,
    count: usize,
    faces: Vec<usize>,
}

fn list(ids: &[usize]) -> String {
    let all = joined(ids.iter().map(|id| format!("#{id}")), ",");
    format!("({all})")
}

fn numbers(values: &[f64]) -> String {
    // A real number has a point.
    let real = |v: &f64| format!("{:?}", (v * 1e9).round() / 1e9);
    let all = joined(values.iter().map(real), ",");
    format!("({all})")
}

fn minus(p: Point) -> Point {
    p.map(|v| -v)
}

impl Step {
    fn add(&mut self, entity: &str) -> usize {
        self.count += 1;
        let _ = writeln!(self.data, "#{}={entity};", self.count);
        self.count
    }

    fn point(&mut self, at: Point) -> usize {
        self.add(&format!("CARTESIAN_POINT('',{})", numbers(&at)))
    }

    fn vertex(&mut self, at: Point) -> usize {
        let point = self.point(at);
        self.add(&format!("VERTEX_POINT('',#{point})"))
    }

    fn direction(&mut self, to: Point) -> usize {
        self.add(&format!("DIRECTION('',{})", numbers(&to)))
    }

    /// Axes at a point: along `axis`, and `reference` across it.
    fn axes(&mut self, at: Point, axis: Point, reference: Point) -> usize {
        let (at, axis, reference) = (
            self.point(at),
            self.direction(axis),
            self.direction(reference),
        );
        self.add(&format!(
            "AXIS2_PLACEMENT_3D('',#{at},#{axis},#{reference})"
        ))
    }

    /// A whole circle about an axis, counter-clockwise; its edge begins at the reference.
    fn circle(&mut self, centre: Point, (axis, reference): (Point, Point), radius: f64) -> usize {
        let axes = self.axes(centre, axis, reference);
        let curve = self.add(&format!("CIRCLE('',#{axes},{radius:?})"));
        let start = self.vertex([0, 1, 2].map(|k| centre[k] + radius * reference[k]));
        self.add(&format!("EDGE_CURVE('',#{start},#{start},#{curve},.T.)"))
    }

    fn line(&mut self, (from, a): (usize, Point), (to, b): (usize, Point)) -> usize {
        let along = [0, 1, 2].map(|k| b[k] - a[k]);
        let length = along.iter().map(|v| v * v).sum::<f64>().sqrt();
        let (at, to_) = (self.point(a), self.direction(along.map(|v| v / length)));
        let vector = self.add(&format!("VECTOR('',#{to_},1.0)"));
        let curve = self.add(&format!("LINE('',#{at},#{vector})"));
        self.add(&format!("EDGE_CURVE('',#{from},#{to},#{curve},.T.)"))
    }

    /// A closed cubic spline through points.
    fn spline(&mut self, points: &[Point]) -> usize {
        // Of a periodic curve with even knots: B(i−1)/6 + 4 B(i)/6 + B(i+1)/6 = P(i).
        let n = points.len();
        let mut poles = points.to_vec();
        for _ in 0..60 {
            let last = poles.clone();
            for i in 0..n {
                let (a, b) = (last[(i + n - 1) % n], last[(i + 1) % n]);
                poles[i] = [0, 1, 2].map(|k| 1.5 * points[i][k] - 0.25 * (a[k] + b[k]));
            }
        }
        let pole = |i: usize| poles[(i + n - 1) % n];
        let ids: Vec<usize> = (0..n + 3).map(|i| self.point(pole(i))).collect();
        let knots: Vec<f64> = (0..n + 7).map(|i| i as f64 - 3.0).collect();
        let ones = vec!["1"; n + 7].join(",");
        let curve = self.add(&format!(
            "B_SPLINE_CURVE_WITH_KNOTS('',3,{},.UNSPECIFIED.,.T.,.F.,({ones}),{},.UNSPECIFIED.)",
            list(&ids),
            numbers(&knots)
        ));
        let start = self.vertex(points[0]);
        self.add(&format!("EDGE_CURVE('',#{start},#{start},#{curve},.T.)"))
    }

    fn looped(&mut self, edges: &[(usize, bool)]) -> usize {
        let oriented: Vec<usize> = edges
            .iter()
            .map(|(edge, forwards)| {
                let sense = if *forwards { ".T." } else { ".F." };
                self.add(&format!("ORIENTED_EDGE('',*,*,#{edge},{sense})"))
            })
            .collect();
        self.add(&format!("EDGE_LOOP('',{})", list(&oriented)))
    }

    /// A face of a surface with loops; the first is the outer one. `outwards` states whether the
    /// normal of the surface points out of the body.
    fn face(&mut self, surface: &str, outwards: bool, loops: &[&[(usize, bool)]]) {
        let surface = self.add(surface);
        let bounds: Vec<usize> = loops
            .iter()
            .enumerate()
            .map(|(i, edges)| {
                let edges = self.looped(edges);
                let kind = if i == 0 {
                    "FACE_OUTER_BOUND"
                } else {
                    "FACE_BOUND"
                };
                self.add(&format!("{kind}('',#{edges},.T.)"))
            })
            .collect();
        let sense = if outwards { ".T." } else { ".F." };
        let face = self.add(&format!(
            "ADVANCED_FACE('',{},#{surface},{sense})",
            list(&bounds)
        ));
        self.faces.push(face);
    }

    fn plane(&mut self, at: Point, (axis, reference): (Point, Point)) -> String {
        let axes = self.axes(at, axis, reference);
        format!("PLANE('',#{axes})")
    }

    fn cylinder(&mut self, at: Point, (axis, reference): (Point, Point), radius: f64) -> String {
        let axes = self.axes(at, axis, reference);
        format!("CYLINDRICAL_SURFACE('',#{axes},{radius:?})")
    }
}

/// The plug as a file.
pub fn text(plug: &Plug, name: &str) -> String {
    let mut step = Step::default();
    let rings = revolved(&mut step, plug);
    head(&mut step, plug, rings);
    let shell = list(&step.faces.clone());
    let shell = step.add(&format!("CLOSED_SHELL('',{shell})"));
    let solid = step.add(&format!("MANIFOLD_SOLID_BREP('{name}',#{shell})"));
    product(&mut step, solid, plug, name);
    format!(
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('{name}: {}; stem Ra 1.6, all else Ra 3.2; threads \
         and radii by the drawing'),'2;1');\nFILE_NAME('{name}','',(''),(''),'{}','','');\n\
         FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n{}ENDSEC;\nEND-ISO-10303-21;\n",
        plug.material.name,
        crate::MARK,
        step.data
    )
}

/// Stem and collar: the circles at the tip and at the foot of the head.
fn revolved(step: &mut Step, plug: &Plug) -> [usize; 2] {
    let mut profile = plug.turned();
    profile.dedup_by(|a, b| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-6);
    let circles: Vec<usize> = profile
        .iter()
        .map(|[r, z]| step.circle([0.0, 0.0, *z], (Z, X), *r))
        .collect();
    for (pair, edges) in profile.windows(2).zip(circles.windows(2)) {
        let ([r0, z0], [r1, z1]) = (pair[0], pair[1]);
        let (low, high) = ([(edges[0], true)], [(edges[1], false)]);
        if (z1 - z0).abs() < 1e-6 {
            // A ring: it looks down where it widens.
            let widens = r1 > r0;
            let plane = step.plane([0.0, 0.0, z0], (if widens { minus(Z) } else { Z }, X));
            if widens {
                step.face(&plane, true, &[&[(edges[1], false)], &[(edges[0], true)]]);
            } else {
                step.face(&plane, true, &[&[(edges[0], true)], &[(edges[1], false)]]);
            }
            continue;
        }
        let surface = if (r1 - r0).abs() < 1e-6 {
            step.cylinder([0.0, 0.0, z0], (Z, X), r0)
        } else {
            // The half angle of a cone is above zero: a narrowing one points down.
            let axis = if r1 > r0 { Z } else { minus(Z) };
            let axes = step.axes([0.0, 0.0, z0], axis, X);
            let angle = ((r1 - r0).abs() / (z1 - z0)).atan();
            format!("CONICAL_SURFACE('',#{axes},{r0:?},{angle:?})")
        };
        step.face(&surface, true, &[&low, &high]);
    }
    [circles[0], circles[circles.len() - 1]]
}

/// The square head with the hole of its bolt and of its port.
fn head(step: &mut Step, plug: &Plug, [tip, root]: [usize; 2]) {
    let half = 0.5 * plug.side_mm;
    let corner = |k: usize, z: f64| {
        let [x, y] = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]][k % 4];
        [half * x, half * y, z]
    };
    let level = |step: &mut Step, z: f64| -> (Vec<usize>, Vec<usize>) {
        let vertices: Vec<usize> = (0..4).map(|k| step.vertex(corner(k, z))).collect();
        let edges = (0..4).map(|k| {
            let end = (k + 1) % 4;
            step.line((vertices[k], corner(k, z)), (vertices[end], corner(end, z)))
        });
        let edges = edges.collect();
        (vertices, edges)
    };
    let (low, high) = (plug.foot_mm, plug.length_mm);
    let (low_vertices, low_edges) = level(step, low);
    let (high_vertices, high_edges) = level(step, high);
    let posts: Vec<usize> = (0..4)
        .map(|k| {
            step.line(
                (low_vertices[k], corner(k, low)),
                (high_vertices[k], corner(k, high)),
            )
        })
        .collect();
    let around = |edges: &[usize], forwards: bool| -> Vec<(usize, bool)> {
        let mut all: Vec<(usize, bool)> = edges.iter().map(|edge| (*edge, forwards)).collect();
        if !forwards {
            all.reverse();
        }
        all
    };
    let end = step.plane([0.0, 0.0, high], (Z, X));
    step.face(&end, true, &[&around(&high_edges, true)]);
    if plug.collar_mm.is_some() {
        // The top of the collar around the head.
        let top = step.plane([0.0, 0.0, low], (Z, X));
        step.face(&top, true, &[&[(root, true)], &around(&low_edges, false)]);
    } else {
        let foot = step.plane([0.0, 0.0, low], (minus(Z), X));
        step.face(&foot, true, &[&around(&low_edges, false), &[(root, true)]]);
    }
    let r = 0.5 * plug.hole_mm;
    let eye = [-half, half].map(|x| step.circle([x, 0.0, plug.eye_mm], (X, Y), r));
    let hole = step.cylinder([-half, 0.0, plug.eye_mm], (X, Y), r);
    step.face(&hole, false, &[&[(eye[0], false)], &[(eye[1], true)]]);
    let mouth = plug.port.map(|port| bore(step, port, half, tip));
    if mouth.is_none() {
        let nose = step.plane([0.0; 3], (minus(Z), X));
        step.face(&nose, true, &[&[(tip, false)]]);
    }
    let normals = [Y, minus(X), minus(Y), X];
    for (k, normal) in normals.into_iter().enumerate() {
        let outline = [
            (low_edges[k], true),
            (posts[(k + 1) % 4], true),
            (high_edges[k], false),
            (posts[k], false),
        ];
        let inner = match k {
            0 => mouth.map(|edge| (edge, false)),
            1 => Some((eye[0], true)),
            3 => Some((eye[1], false)),
            _ => None,
        };
        let plane = step.plane(corner(k, low), (normal, Z));
        match inner {
            Some(edge) => step.face(&plane, true, &[&outline, &[edge]]),
            None => step.face(&plane, true, &[&outline]),
        }
    }
}

/// The hole of the thread and the passage: the circle at the flat.
fn bore(step: &mut Step, port: Port, half: f64, tip: usize) -> usize {
    let (r, p, height) = (0.5 * port.hole_mm, 0.5 * port.passage_mm, port.height_mm);
    let floor_y = half - port.depth_mm;
    let [mouth, floor] = [half, floor_y].map(|y| step.circle([0.0, y, height], (Y, Z), r));
    let met: Vec<Point> = (0..SPLINE)
        .map(|i| {
            let (sin, cos) = (TAU * i as f64 / SPLINE as f64).sin_cos();
            let x = p * cos;
            [x, p * sin, height - (r * r - x * x).sqrt()]
        })
        .collect();
    let met = step.spline(&met);
    let entry = step.circle([0.0; 3], (Z, X), p);
    let wall = step.cylinder([0.0, floor_y, height], (Y, Z), r);
    step.face(
        &wall,
        false,
        &[&[(floor, false)], &[(mouth, true)], &[(met, false)]],
    );
    let bottom = step.plane([0.0, floor_y, height], (Y, Z));
    step.face(&bottom, true, &[&[(floor, true)]]);
    let passage = step.cylinder([0.0; 3], (Z, X), p);
    step.face(&passage, false, &[&[(entry, false)], &[(met, true)]]);
    let nose = step.plane([0.0; 3], (minus(Z), X));
    step.face(&nose, true, &[&[(tip, false)], &[(entry, true)]]);
    mouth
}

/// What makes a product of a solid.
fn product(step: &mut Step, solid: usize, plug: &Plug, name: &str) {
    let mm = step.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    let radian = step.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    let solid_angle = step.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    let exact = step.add(&format!(
        "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-04),#{mm},'','')"
    ));
    let context = step.add(&format!(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{exact}))\
         GLOBAL_UNIT_ASSIGNED_CONTEXT((#{mm},#{radian},#{solid_angle}))REPRESENTATION_CONTEXT('',''))"
    ));
    let axes = step.axes([0.0; 3], Z, X);
    let shape = step.add(&format!(
        "ADVANCED_BREP_SHAPE_REPRESENTATION('{name}',(#{axes},#{solid}),#{context})"
    ));
    let application = step.add("APPLICATION_CONTEXT('automotive design')");
    step.add(&format!(
        "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,\
         #{application})"
    ));
    let of_product = step.add(&format!("PRODUCT_CONTEXT('',#{application},'mechanical')"));
    let material = plug.material.name;
    let product = step.add(&format!(
        "PRODUCT('{name}','{name}','{material}',(#{of_product}))"
    ));
    let formation = step.add(&format!("PRODUCT_DEFINITION_FORMATION('','',#{product})"));
    let design = step.add(&format!(
        "PRODUCT_DEFINITION_CONTEXT('',#{application},'design')"
    ));
    let definition = step.add(&format!("PRODUCT_DEFINITION('','',#{formation},#{design})"));
    let of_shape = step.add(&format!("PRODUCT_DEFINITION_SHAPE('','',#{definition})"));
    step.add(&format!(
        "SHAPE_DEFINITION_REPRESENTATION(#{of_shape},#{shape})"
    ));
}
