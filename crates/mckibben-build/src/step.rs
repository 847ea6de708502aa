//! A turned plug as a body of exact faces for a machine shop: ISO 10303-21 (STEP), AP214.
//!
//! Where the passage meets the hole of the thread their edge is a spline through points of both, which
//! is off by less than 1 µm.

use crate::{
    body::{Circle, Face, Loop, Point, Surface, Z, across, cross, dot},
    plug::Plug,
};
use mckibben_core::joined;
use std::{
    collections::HashMap,
    fmt::{Display, Write as _},
};

/// The number of a line, as `#12`.
type Id = String;

/// An edge of a loop, and whether it runs forwards.
type Edge = (Id, bool);

/// The numbered lines of a file, each of them once.
#[derive(Default)]
struct Step {
    data: String,
    known: HashMap<String, Id>,
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

impl Step {
    fn add(&mut self, entity: &str) -> Id {
        let next = format!("#{}", self.known.len() + 1);
        let id = self.known.entry(entity.to_owned()).or_insert_with(|| {
            let _ = writeln!(self.data, "{next}={entity};");
            next
        });
        id.clone()
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

    /// Axes at a point, the first along `axis`.
    fn axes(&mut self, at: Point, axis: Point) -> Id {
        let at = self.point(at);
        let [axis, reference] = [axis, across(axis)].map(|to| self.direction(to));
        self.unnamed("AXIS2_PLACEMENT_3D", &[&at, &axis, &reference])
    }

    /// What its axes and a radius describe.
    fn about(&mut self, kind: &str, circle: &Circle) -> Id {
        let axes = self.axes(circle.centre, circle.axis);
        self.unnamed(kind, &[&axes, &format!("{:?}", circle.radius)])
    }

    fn edge(&mut self, from: Point, to: Point, curve: Id) -> Id {
        let [from, to] = [from, to].map(|at| self.vertex(at));
        self.unnamed("EDGE_CURVE", &[&from, &to, &curve, &sense(true)])
    }

    fn circle(&mut self, circle: &Circle) -> Edge {
        let curve = self.about("CIRCLE", circle);
        let start = circle.points()[0];
        (self.edge(start, start, curve), true)
    }

    /// From a corner to the next; an edge is the same from both.
    fn line(&mut self, a: Point, b: Point) -> Edge {
        if a > b {
            return (self.line(b, a).0, false);
        }
        let along = [0, 1, 2].map(|k| b[k] - a[k]);
        let length = dot(along, along).sqrt();
        let (at, way) = (self.point(a), self.direction(along.map(|v| v / length)));
        let vector = self.unnamed("VECTOR", &[&way, &"1.0"]);
        let curve = self.unnamed("LINE", &[&at, &vector]);
        (self.edge(a, b, curve), true)
    }

    /// A closed cubic spline through points.
    fn spline(&mut self, points: &[Point]) -> Edge {
        // The curve of these poles is off by a share of (2π/n)⁴/36 of the radius.
        let n = points.len();
        let pole = |i: usize| {
            let [before, at, behind] = [n - 1, 0, 1].map(|k| points[(i + k) % n]);
            [0, 1, 2].map(|k| (8.0 * at[k] - before[k] - behind[k]) / 6.0)
        };
        let ids: Vec<Id> = (0..n + 3).map(|i| self.point(pole(i + n - 1))).collect();
        let knots: Vec<f64> = (0..n + 7).map(|i| i as f64 - 3.0).collect();
        let curve = format!(
            "B_SPLINE_CURVE_WITH_KNOTS('',3,{},.UNSPECIFIED.,.T.,.F.,{},{},.UNSPECIFIED.)",
            list(ids),
            list(vec![1; n + 7]),
            numbers(&knots)
        );
        let curve = self.add(&curve);
        (self.edge(points[0], points[0], curve), true)
    }

    fn edges(&mut self, line: &Loop) -> Vec<Edge> {
        match line {
            Loop::Circle(circle) => vec![self.circle(circle)],
            Loop::Smooth(points) => vec![self.spline(points)],
            Loop::Corners([a, b, c, d]) => [(a, b), (b, c), (c, d), (d, a)]
                .map(|(a, b)| self.line(*a, *b))
                .into(),
        }
    }

    fn face(&mut self, Face { surface, lines }: &Face) -> Id {
        let mut bounds = vec![];
        for line in lines {
            let is_first = bounds.is_empty();
            let runs_forwards = match surface {
                // The outline runs counter-clockwise, a hole clockwise.
                Surface::Flat(normal) => runs_about(*normal, &line.points()) == is_first,
                Surface::Round { .. } => is_first,
            };
            let mut edges = self.edges(line);
            if !runs_forwards {
                edges.reverse();
            }
            let mut oriented = vec![];
            for (edge, forwards) in edges {
                let sense = sense(forwards == runs_forwards);
                oriented.push(self.unnamed("ORIENTED_EDGE", &[&"*", &"*", &edge, &sense]));
            }
            let edges = self.unnamed("EDGE_LOOP", &[&list(oriented)]);
            let kind = if is_first {
                "FACE_OUTER_BOUND"
            } else {
                "FACE_BOUND"
            };
            bounds.push(self.unnamed(kind, &[&edges, &sense(true)]));
        }
        let (surface, outwards) = match surface {
            Surface::Flat(normal) => {
                let at = lines.first().map_or([0.0; 3], |line| line.points()[0]);
                let axes = self.axes(at, *normal);
                (self.unnamed("PLANE", &[&axes]), true)
            }
            Surface::Round {
                circle,
                slope,
                is_hole,
            } => (self.round(circle, *slope), !is_hole),
        };
        self.unnamed(
            "ADVANCED_FACE",
            &[&list(bounds), &surface, &sense(outwards)],
        )
    }

    /// A cylinder, or a cone, by how its radius grows along its axis.
    fn round(&mut self, circle: &Circle, slope: f64) -> Id {
        if slope.abs() < 1e-6 {
            return self.about("CYLINDRICAL_SURFACE", circle);
        }
        // The half angle of a cone is above zero: a narrowing one points down.
        let axis = circle.axis.map(|v| v * slope.signum());
        let axes = self.axes(circle.centre, axis);
        let [radius, angle] = [circle.radius, slope.abs().atan()].map(|v| format!("{v:?}"));
        self.unnamed("CONICAL_SURFACE", &[&axes, &radius, &angle])
    }
}

/// Whether corners run counter-clockwise about a direction.
fn runs_about(direction: Point, corners: &[Point]) -> bool {
    let next = corners.iter().cycle().skip(1);
    let areas = corners.iter().zip(next).map(|(a, b)| cross(*a, *b));
    areas.map(|area| dot(area, direction)).sum::<f64>() > 0.0
}

/// The plug as a file.
pub fn text(plug: &Plug, name: &str) -> String {
    let mut step = Step::default();
    CONTEXT.iter().for_each(|line| {
        step.add(line);
    });
    let faces: Vec<Id> = plug.body().iter().map(|face| step.face(face)).collect();
    let shell = step.unnamed("CLOSED_SHELL", &[&list(faces)]);
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

/// The first lines of a file: units, how exact it is, and what its product is for.
const CONTEXT: [&str; 9] = [
    "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))",
    "(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))",
    "(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())",
    "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-04),#1,'','')",
    "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#4))\
     GLOBAL_UNIT_ASSIGNED_CONTEXT((#1,#2,#3))REPRESENTATION_CONTEXT('',''))",
    "APPLICATION_CONTEXT('automotive design')",
    "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#6)",
    "PRODUCT_CONTEXT('',#6,'mechanical')",
    "PRODUCT_DEFINITION_CONTEXT('',#6,'design')",
];

/// What makes a product of a solid.
fn product(step: &mut Step, solid: Id, plug: &Plug, name: &str) {
    let axes = step.axes([0.0; 3], Z);
    let shape = step.add(&format!(
        "ADVANCED_BREP_SHAPE_REPRESENTATION('{name}',({axes},{solid}),#5)"
    ));
    let material = plug.material.name;
    let product = step.add(&format!("PRODUCT('{name}','{name}','{material}',(#8))"));
    let formation = step.unnamed("PRODUCT_DEFINITION_FORMATION", &[&"''", &product]);
    let definition = step.unnamed("PRODUCT_DEFINITION", &[&"''", &formation, &"#9"]);
    let of_shape = step.unnamed("PRODUCT_DEFINITION_SHAPE", &[&"''", &definition]);
    step.add(&format!(
        "SHAPE_DEFINITION_REPRESENTATION({of_shape},{shape})"
    ));
}
