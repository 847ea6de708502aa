//! A turned plug as a body of exact faces for a machine shop: ISO 10303-21 (STEP), AP214.
//!
//! The stem and the collar are cylinders, cones and rings about the axis, the head has planes, and
//! its holes are cylinders. Where the passage meets the hole of the thread their edge is a spline
//! through points of both.

use crate::plug::{Plug, Port};
use mckibben_core::joined;
use std::fmt::{self, Display, Write as _};

type Point = [f64; 3];
const X: Point = [1.0, 0.0, 0.0];
const Y: Point = [0.0, 1.0, 0.0];
const Z: Point = [0.0, 0.0, 1.0];
/// Points of the edge between passage and hole; the spline is off by less than 1 µm.
const SPLINE: usize = 48;

/// The number of a line.
#[derive(Debug, Clone, Copy)]
struct Id(usize);

impl Display for Id {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{}", self.0)
    }
}

/// An edge of a loop, and whether it runs forwards.
type Edge = (Id, bool);

/// The numbered lines of a file.
#[derive(Default)]
struct Step {
    data: String,
    count: usize,
    faces: Vec<Id>,
}

fn list<T: Display>(items: impl IntoIterator<Item = T>) -> String {
    let items = items.into_iter().map(|item| item.to_string());
    format!("({})", joined(items, ","))
}

fn numbers(values: &[f64]) -> String {
    // A real number has a point.
    list(
        values
            .iter()
            .map(|v| format!("{:?}", (v * 1e9).round() / 1e9)),
    )
}

/// `.T.` or `.F.`
fn sense(yes: bool) -> &'static str {
    if yes { ".T." } else { ".F." }
}

fn minus(p: Point) -> Point {
    p.map(|v| -v)
}

impl Step {
    fn add(&mut self, entity: &str) -> Id {
        self.count += 1;
        let id = Id(self.count);
        let _ = writeln!(self.data, "{id}={entity};");
        id
    }

    /// An entity whose name is empty.
    fn unnamed(&mut self, kind: &str, values: &[&dyn Display]) -> Id {
        let values = joined(values.iter().map(|value| value.to_string()), ",");
        self.add(&format!("{kind}('',{values})"))
    }

    fn point(&mut self, at: Point) -> Id {
        self.unnamed("CARTESIAN_POINT", &[&numbers(&at)])
    }

    fn vertex(&mut self, at: Point) -> Id {
        let point = self.point(at);
        self.unnamed("VERTEX_POINT", &[&point])
    }

    fn direction(&mut self, to: Point) -> Id {
        self.unnamed("DIRECTION", &[&numbers(&to)])
    }

    /// Axes at a point: along `axis`, and `reference` across it.
    fn axes(&mut self, at: Point, axis: Point, reference: Point) -> Id {
        let at = self.point(at);
        let [axis, reference] = [axis, reference].map(|to| self.direction(to));
        self.unnamed("AXIS2_PLACEMENT_3D", &[&at, &axis, &reference])
    }

    fn edge(&mut self, from: Id, to: Id, curve: Id) -> Id {
        self.unnamed("EDGE_CURVE", &[&from, &to, &curve, &sense(true)])
    }

    /// A whole circle about an axis, counter-clockwise; its edge begins at the reference.
    fn circle(&mut self, centre: Point, (axis, reference): (Point, Point), radius: f64) -> Id {
        let axes = self.axes(centre, axis, reference);
        let curve = self.unnamed("CIRCLE", &[&axes, &format!("{radius:?}")]);
        let start = self.vertex([0, 1, 2].map(|k| centre[k] + radius * reference[k]));
        self.edge(start, start, curve)
    }

    fn line(&mut self, (from, a): (Id, Point), (to, b): (Id, Point)) -> Id {
        let along = [0, 1, 2].map(|k| b[k] - a[k]);
        let length = along.iter().map(|v| v * v).sum::<f64>().sqrt();
        let (at, way) = (self.point(a), self.direction(along.map(|v| v / length)));
        let vector = self.unnamed("VECTOR", &[&way, &"1.0"]);
        let curve = self.unnamed("LINE", &[&at, &vector]);
        self.edge(from, to, curve)
    }

    /// A closed cubic spline through points.
    fn spline(&mut self, points: &[Point]) -> Id {
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
        let ids: Vec<Id> = (0..n + 3)
            .map(|i| self.point(poles[(i + n - 1) % n]))
            .collect();
        let knots: Vec<f64> = (0..n + 7).map(|i| i as f64 - 3.0).collect();
        let curve = format!(
            "B_SPLINE_CURVE_WITH_KNOTS('',3,{},.UNSPECIFIED.,.T.,.F.,{},{},.UNSPECIFIED.)",
            list(ids),
            list(vec![1; n + 7]),
            numbers(&knots)
        );
        let curve = self.add(&curve);
        let start = self.vertex(points[0]);
        self.edge(start, start, curve)
    }

    /// A face of a surface with loops; the first is the outer one. `outwards` states whether the
    /// normal of the surface points out of the body.
    fn face(&mut self, surface: Id, outwards: bool, loops: &[&[Edge]]) {
        let mut bounds = vec![];
        for (edges, kind) in loops
            .iter()
            .zip(["FACE_OUTER_BOUND", "FACE_BOUND", "FACE_BOUND"])
        {
            let mut oriented = vec![];
            for (edge, forwards) in *edges {
                let values: [&dyn Display; 4] = [&"*", &"*", edge, &sense(*forwards)];
                oriented.push(self.unnamed("ORIENTED_EDGE", &values));
            }
            let edges = self.unnamed("EDGE_LOOP", &[&list(oriented)]);
            bounds.push(self.unnamed(kind, &[&edges, &sense(true)]));
        }
        let face = self.unnamed(
            "ADVANCED_FACE",
            &[&list(bounds), &surface, &sense(outwards)],
        );
        self.faces.push(face);
    }

    fn plane(&mut self, at: Point, (axis, reference): (Point, Point)) -> Id {
        let axes = self.axes(at, axis, reference);
        self.unnamed("PLANE", &[&axes])
    }

    fn cylinder(&mut self, at: Point, (axis, reference): (Point, Point), radius: f64) -> Id {
        let axes = self.axes(at, axis, reference);
        self.unnamed("CYLINDRICAL_SURFACE", &[&axes, &format!("{radius:?}")])
    }
}

/// The plug as a file.
pub fn text(plug: &Plug, name: &str) -> String {
    let mut step = Step::default();
    let rings = revolved(&mut step, plug);
    head(&mut step, plug, rings);
    let shell = list(step.faces.clone());
    let shell = step.unnamed("CLOSED_SHELL", &[&shell]);
    let solid = step.add(&format!("MANIFOLD_SOLID_BREP('{name}',{shell})"));
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
fn revolved(step: &mut Step, plug: &Plug) -> [Id; 2] {
    let mut profile = plug.turned();
    profile.dedup_by(|a, b| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-6);
    let circles: Vec<Id> = profile
        .iter()
        .map(|[r, z]| step.circle([0.0, 0.0, *z], (Z, X), *r))
        .collect();
    for (pair, edges) in profile.windows(2).zip(circles.windows(2)) {
        let ([r0, z0], [r1, z1]) = (pair[0], pair[1]);
        let at = [0.0, 0.0, z0];
        let mut loops: [&[Edge]; 2] = [&[(edges[0], true)], &[(edges[1], false)]];
        let widens = r1 > r0;
        let surface = if (z1 - z0).abs() < 1e-6 {
            // A ring: it looks down where it widens.
            if widens {
                loops.reverse();
            }
            step.plane(at, (if widens { minus(Z) } else { Z }, X))
        } else if (r1 - r0).abs() < 1e-6 {
            step.cylinder(at, (Z, X), r0)
        } else {
            // The half angle of a cone is above zero: a narrowing one points down.
            let axes = step.axes(at, if widens { Z } else { minus(Z) }, X);
            let angle = ((r1 - r0).abs() / (z1 - z0)).atan();
            let [radius, angle] = [r0, angle].map(|v| format!("{v:?}"));
            step.unnamed("CONICAL_SURFACE", &[&axes, &radius, &angle])
        };
        step.face(surface, true, &loops);
    }
    [circles[0], circles[circles.len() - 1]]
}

/// The square head with the hole of its bolt and of its port.
fn head(step: &mut Step, plug: &Plug, [tip, root]: [Id; 2]) {
    let half = 0.5 * plug.side_mm;
    let corner = |k: usize, z: f64| {
        let [x, y] = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]][k % 4];
        [half * x, half * y, z]
    };
    let levels = [plug.foot_mm, plug.length_mm];
    let [(low_corners, low), (high_corners, high)] = levels.map(|z| {
        let vertices: Vec<_> = (0..4)
            .map(|k| (step.vertex(corner(k, z)), corner(k, z)))
            .collect();
        let edges = (0..4).map(|k| step.line(vertices[k], vertices[(k + 1) % 4]));
        let edges: Vec<Id> = edges.collect();
        (vertices, edges)
    });
    let posts = low_corners.into_iter().zip(high_corners);
    let posts: Vec<Id> = posts.map(|(low, high)| step.line(low, high)).collect();
    let end: Vec<Edge> = high.iter().map(|edge| (*edge, true)).collect();
    let foot: Vec<Edge> = low.iter().rev().map(|edge| (*edge, false)).collect();
    let top = step.plane([0.0, 0.0, levels[1]], (Z, X));
    step.face(top, true, &[&end]);
    // Under the head, or the top of the collar around it.
    let mut loops: [&[Edge]; 2] = [&foot, &[(root, true)]];
    let mut down = minus(Z);
    if plug.collar_mm.is_some() {
        loops.reverse();
        down = Z;
    }
    let below = step.plane([0.0, 0.0, levels[0]], (down, X));
    step.face(below, true, &loops);
    let r = 0.5 * plug.hole_mm;
    let eye = [-half, half].map(|x| step.circle([x, 0.0, plug.eye_mm], (X, Y), r));
    let hole = step.cylinder([-half, 0.0, plug.eye_mm], (X, Y), r);
    step.face(hole, false, &[&[(eye[0], false)], &[(eye[1], true)]]);
    let mouth = plug.port.map(|port| bore(step, port, half, tip));
    if mouth.is_none() {
        let nose = step.plane([0.0; 3], (minus(Z), X));
        step.face(nose, true, &[&[(tip, false)]]);
    }
    let normals = [Y, minus(X), minus(Y), X];
    let mouth = mouth.map(|edge| (edge, false));
    let holes = [mouth, Some((eye[0], true)), None, Some((eye[1], false))];
    for (k, (normal, hole)) in normals.into_iter().zip(holes).enumerate() {
        let outline = [
            (low[k], true),
            (posts[(k + 1) % 4], true),
            (high[k], false),
            (posts[k], false),
        ];
        let plane = step.plane(corner(k, levels[0]), (normal, Z));
        match hole {
            Some(edge) => step.face(plane, true, &[&outline, &[edge]]),
            None => step.face(plane, true, &[&outline]),
        }
    }
}

/// The hole of the thread and the passage: the circle at the flat.
fn bore(step: &mut Step, port: Port, half: f64, tip: Id) -> Id {
    let (r, p, height) = (0.5 * port.hole_mm, 0.5 * port.passage_mm, port.height_mm);
    let floor_y = half - port.depth_mm;
    let [mouth, floor] = [half, floor_y].map(|y| step.circle([0.0, y, height], (Y, Z), r));
    let met = step.spline(&port.met(SPLINE));
    let entry = step.circle([0.0; 3], (Z, X), p);
    let wall = step.cylinder([0.0, floor_y, height], (Y, Z), r);
    let edges = [(floor, false), (mouth, true), (met, false)].map(|edge| [edge]);
    step.face(wall, false, &edges.each_ref().map(|edge| &edge[..]));
    let bottom = step.plane([0.0, floor_y, height], (Y, Z));
    step.face(bottom, true, &[&[(floor, true)]]);
    let passage = step.cylinder([0.0; 3], (Z, X), p);
    step.face(passage, false, &[&[(entry, false)], &[(met, true)]]);
    let nose = step.plane([0.0; 3], (minus(Z), X));
    step.face(nose, true, &[&[(tip, false)], &[(entry, true)]]);
    mouth
}

/// What makes a product of a solid.
fn product(step: &mut Step, solid: Id, plug: &Plug, name: &str) {
    let mm = step.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    let radian = step.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    let solid_angle = step.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    let exact = step.add(&format!(
        "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-04),{mm},'','')"
    ));
    let context = step.add(&format!(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({exact}))\
         GLOBAL_UNIT_ASSIGNED_CONTEXT(({mm},{radian},{solid_angle}))REPRESENTATION_CONTEXT('',''))"
    ));
    let axes = step.axes([0.0; 3], Z, X);
    let shape = step.add(&format!(
        "ADVANCED_BREP_SHAPE_REPRESENTATION('{name}',({axes},{solid}),{context})"
    ));
    let application = step.add("APPLICATION_CONTEXT('automotive design')");
    step.add(&format!(
        "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,\
         {application})"
    ));
    let of_product = step.unnamed("PRODUCT_CONTEXT", &[&application, &"'mechanical'"]);
    let material = plug.material.name;
    let product = step.add(&format!(
        "PRODUCT('{name}','{name}','{material}',({of_product}))"
    ));
    let formation = step.unnamed("PRODUCT_DEFINITION_FORMATION", &[&"''", &product]);
    let design = step.unnamed("PRODUCT_DEFINITION_CONTEXT", &[&application, &"'design'"]);
    let definition = step.unnamed("PRODUCT_DEFINITION", &[&"''", &formation, &design]);
    let of_shape = step.unnamed("PRODUCT_DEFINITION_SHAPE", &[&"''", &definition]);
    step.add(&format!(
        "SHAPE_DEFINITION_REPRESENTATION({of_shape},{shape})"
    ));
}
