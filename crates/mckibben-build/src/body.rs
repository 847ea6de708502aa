//! A body by its exact faces; from them follow its triangles and its file for a machine shop.

use std::f64::consts::{FRAC_PI_4, SQRT_2, TAU};

pub type Point = [f64; 3];
pub const Z: Point = [0.0, 0.0, 1.0];
pub const X: Point = across(Z);
pub const Y: Point = across(X);
/// Corners of a circle as it is drawn and printed.
pub const FACETS: usize = 96;

pub fn minus(p: Point) -> Point {
    p.map(|v| -v)
}

pub fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Point, b: Point) -> Point {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]| a[i] * b[j] - a[j] * b[i])
}

/// A direction across that of an axis: Y across X, Z across Y, X across Z.
pub const fn across([x, y, z]: Point) -> Point {
    [z, x, y]
}

/// Points around a circle of one from `across` its axis on: shares of that, and of what is across both.
fn turn() -> impl Iterator<Item = [f64; 2]> {
    (0..FACETS).map(|i| {
        let (sin, cos) = (TAU * i as f64 / FACETS as f64).sin_cos();
        [cos, sin]
    })
}

/// A circle counter-clockwise about an axis.
#[derive(Debug, Clone, Copy)]
pub struct Circle {
    pub centre: Point,
    pub axis: Point,
    pub radius: f64,
    /// Of a hole that is printed: lines of 45° and a ridge close it downwards.
    pub has_roof: bool,
}

impl Circle {
    pub fn about(axis: Point, centre: Point, radius: f64) -> Self {
        Self {
            centre,
            axis,
            radius,
            has_roof: false,
        }
    }

    pub fn points(&self) -> Vec<Point> {
        let u = across(self.axis);
        let v = cross(self.axis, u);
        let at = |[cos, sin]: [f64; 2]| {
            let is_roof = self.has_roof && sin < -FRAC_PI_4.sin() - 1e-9;
            // On the line from the end of the roof to its ridge.
            let scale = if is_roof {
                SQRT_2 / (sin.abs() + cos.abs())
            } else {
                1.0
            };
            let r = self.radius * scale;
            [0, 1, 2].map(|k| self.centre[k] + r * (cos * u[k] + sin * v[k]))
        };
        turn().map(at).collect()
    }
}

/// A closed line around a face or a hole in it.
#[derive(Debug, Clone)]
pub enum Loop {
    Corners([Point; 4]),
    Circle(Circle),
    /// A smooth line through points.
    Smooth(Vec<Point>),
}

impl Loop {
    pub fn points(&self) -> Vec<Point> {
        match self {
            Self::Corners(corners) => corners.to_vec(),
            Self::Circle(circle) => circle.points(),
            Self::Smooth(points) => points.clone(),
        }
    }
}

/// What a face is a part of.
pub enum Surface {
    /// A plane, and what it looks to.
    Flat(Point),
    /// A cylinder or cone with a circle on it, and how its radius grows along the axis.
    Round {
        circle: Circle,
        slope: f64,
        is_hole: bool,
    },
}

/// A face of a body: the line around it first, a hole in it last. Of a round one the outer side is to the
/// right of the way from the first line to the second as a section shows it with the axis on the left,
/// and a hole is opposite to where its circles begin.
pub struct Face {
    pub surface: Surface,
    pub lines: Vec<Loop>,
}

impl Face {
    pub fn flat(normal: Point, lines: impl Into<Vec<Loop>>) -> Self {
        Self {
            surface: Surface::Flat(normal),
            lines: lines.into(),
        }
    }

    /// From a circle to another one about the same axis.
    pub fn round(circle: Circle, to: Circle) -> Self {
        let rise = dot(to.centre, circle.axis) - dot(circle.centre, circle.axis);
        Self {
            surface: Surface::Round {
                circle,
                slope: (to.radius - circle.radius) / rise,
                is_hole: rise < 0.0,
            },
            lines: [circle, to].map(Loop::Circle).into(),
        }
    }
}

/// The faces of a profile of radii and heights that is revolved about the z axis.
pub fn revolved(profile: &[[f64; 2]]) -> Vec<Face> {
    let circle = |[r, z]: [f64; 2]| Circle::about(Z, [0.0, 0.0, z], r);
    let face = |pair: &[[f64; 2]]| {
        let [a, b] = [pair[0], pair[1]].map(circle);
        match b.radius > a.radius {
            _ if (pair[1][1] - pair[0][1]).abs() > 1e-6 => Face::round(a, b),
            true => Face::flat(minus(Z), [b, a].map(Loop::Circle)),
            false => Face::flat(Z, [a, b].map(Loop::Circle)),
        }
    };
    profile.windows(2).map(face).collect()
}

/// Where a hole about the z axis ends on the wall of one about a line along y at a height: their radii.
pub fn met([r, p]: [f64; 2], height: f64) -> Vec<Point> {
    let place = |[cos, sin]: [f64; 2]| {
        let x = p * cos;
        [x, p * sin, height - (r * r - x * x).sqrt()]
    };
    turn().map(place).collect()
}
