//! A tube under a braid, divided into elements: everything that does not change while it deforms.

use super::{body::Body, layout::Layout, mesh::Mesh};
use crate::{
    FemError, Result,
    element::{
        q2::{Geometry, NODES, POINTS, Point, point},
        strand::{self, STRAND_POINTS, StrandPoint},
    },
    solver::{body::Control, continuation::Continuation},
};
use mckibben_core::{
    muscle::{Bulk, Crimp, Parts, StrandLay},
    rubber::{Law, RubberLaw, over_time::OgdenRoxburgh},
};
use std::f64::consts::PI;

/// Length ℓ of the layer beside a terminal over the outer radius.
pub const LAYER: f64 = 1.4;

/// Smallest share of the way in which a tube is drawn on its plugs.
const SMALLEST_DRAW: f64 = 1.0 / 256.0;

/// What holds the last station.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ends {
    /// Bonded to a rigid terminal: r fixed, all z together.
    Bonded,
    /// A slice of an infinitely long muscle: r free, all z together.
    Sliding,
    /// A pole on the axis: r fixed, z free.
    Pole,
}

/// The braid of a model.
#[derive(Debug, Clone, Copy)]
pub struct BraidSpec {
    /// Where the strands lie.
    pub lay: StrandLay,
    /// What straightens in them before they stretch.
    pub crimp: Option<Crimp>,
    /// k of one family in N/mm; `None` for strands that do not stretch.
    pub stiffness: Option<f64>,
    /// Whether strands carry compression.
    pub compression: bool,
}

/// Rubber, braid and ends of a model.
#[derive(Debug, Clone)]
pub struct Problem {
    /// The law of the rubber.
    pub law: Law,
    /// Incompressible or a bulk modulus.
    pub bulk: Bulk,
    /// The braid, where there is one.
    pub braid: Option<BraidSpec>,
    /// What holds the last station.
    pub ends: Ends,
    /// λp: by how much the rubber is stretched along where nothing is displaced.
    pub prestretch: f64,
    /// [`Parts::plug_mm2`]
    pub plug_mm2: f64,
}

impl Problem {
    /// Rubber and braid of a muscle between bonded terminals.
    pub fn from_parts(parts: &Parts) -> Self {
        let Parts { tube, braid, .. } = parts;
        let rubber = tube.rubber_at_temperature();
        let braid = BraidSpec {
            lay: braid.lay(tube),
            crimp: braid.crimp,
            stiffness: braid.family_stiffness_n_per_mm(tube),
            compression: braid.compression,
        };
        let whole = Self::new(rubber.law.clone(), rubber.bulk, Some(braid), Ends::Bonded);
        Self {
            prestretch: tube.prestretch,
            plug_mm2: parts.plug_mm2(),
            ..whole
        }
    }

    /// Of its parts.
    pub fn new(law: Law, bulk: Bulk, braid: Option<BraidSpec>, ends: Ends) -> Self {
        Self {
            law,
            bulk,
            braid,
            ends,
            prestretch: 1.0,
            plug_mm2: 0.0,
        }
    }
}

/// How the rubber softens, and what each of its points has seen.
#[derive(Debug, Clone)]
pub struct Memory {
    /// Softening constants.
    pub softening: OgdenRoxburgh,
    /// W_m in MPa of every integration point of every element.
    pub seen_mpa: Vec<[f64; POINTS]>,
}

/// A body divided into elements.
#[derive(Debug, Clone)]
pub struct Discretisation {
    /// Places of the unknowns.
    pub layout: Layout,
    /// The nodes at rest: where the tube has them on its plugs.
    pub mesh: Mesh,
    /// The nodes of the tube before it is drawn on plugs.
    pub cylinder: Mesh,
    /// Rubber, braid, ends.
    pub problem: Problem,
    /// Elements, slab by slab, each from the inner surface outwards.
    pub elements: Vec<Geometry>,
    /// Points of the braid, slab by slab; empty without a braid.
    pub strands: Vec<[StrandPoint; STRAND_POINTS]>,
    /// 1/K in 1/MPa.
    pub compliance: f64,
    /// γ: what the volume condition is augmented with, in MPa.
    pub augment: f64,
    /// The same for the strands, in N/mm.
    pub augment_strand: f64,
    /// Outer radius in mm.
    pub radius: f64,
    /// Area of rubber in the middle section in mm².
    pub section: f64,
    /// Shear modulus in MPa.
    pub shear: f64,
    /// What rubber that softens has seen; `None` on a first inflation.
    pub memory: Option<Memory>,
}

/// Nodes of an element of a slab, in the element's order.
pub fn nodes(mesh: &Mesh, slab: usize, element: usize) -> [[f64; 2]; NODES] {
    let stations = Layout::numbers(slab);
    std::array::from_fn(|a| mesh.node(2 * element + a % 3, stations[a / 3]))
}

impl Discretisation {
    /// Divides a body.
    ///
    /// # Errors
    /// [`FemError::Refused`] where an element is turned inside out.
    pub fn new(cylinder: Mesh, problem: Problem) -> Result<Self> {
        let mesh = match problem.braid {
            Some(_) if problem.plug_mm2 != 0.0 => on_plugs(&cylinder, &problem)?,
            _ => cylinder.clone(),
        };
        let multipliers = matches!(
            problem.braid,
            Some(BraidSpec {
                stiffness: None,
                ..
            })
        );
        let layout = mesh.layout(multipliers);
        let element = |index: usize| {
            let nodes = nodes(&mesh, index / mesh.through, index % mesh.through);
            let mut geometry = Geometry::new(&nodes).ok_or_else(|| {
                FemError::Refused(format!(
                    "mesh: element {index} is turned inside out at rest"
                ))
            })?;
            geometry.points = geometry.points.map(|p| p.prestretched(problem.prestretch));
            Ok(geometry)
        };
        let elements = (0..mesh.through * mesh.along)
            .map(element)
            .collect::<Result<_>>()?;
        let outer = 2 * mesh.through;
        let strands = problem.braid.map_or(vec![], |braid| {
            let radius = cylinder.node(outer, 0)[0];
            (0..mesh.along)
                .map(|slab| strand::strand_points(mesh.line(slab, outer), radius, &braid.lay))
                .collect()
        });
        let inner = cylinder.node(0, 0)[0];
        let radius = cylinder.node(outer, 0)[0];
        let shear = problem.law.shear_modulus_mpa();
        let (compliance, augment) = match problem.bulk {
            Bulk::Incompressible => (0.0, 20.0 * shear),
            Bulk::Modulus(k) => (1.0 / k, (20.0 * shear).min(0.5 * k)),
        };
        Ok(Self {
            layout,
            elements,
            strands,
            compliance,
            augment,
            augment_strand: 30.0 * shear * (radius - inner),
            radius,
            section: PI * (radius * radius - inner * inner),
            shear,
            memory: None,
            mesh,
            cylinder,
            problem,
        })
    }

    /// Smallest force that is distinguished from zero, in N, at a pressure in MPa. Stiff strands
    /// add what rounding leaves of their tension.
    pub fn force_scale(&self, pressure: f64) -> f64 {
        let k = self.problem.braid.and_then(|b| b.stiffness).unwrap_or(0.0);
        let inside = PI * self.radius * self.radius;
        pressure.abs() * inside + self.shear * self.section + 1e-4 * k * self.radius
    }

    /// Gradients at local coordinates of an element with these nodes.
    pub fn point(&self, nodes: &[[f64; 2]; NODES], xi: f64, eta: f64) -> Option<Point> {
        Some(point(nodes, xi, eta, 1.0)?.prestretched(self.problem.prestretch))
    }

    /// Whether ∂F by the muscle's constants are those of the tangent: what conditioned rubber has
    /// seen and the shape on a plug change with them as well.
    pub fn has_slopes(&self) -> bool {
        self.memory.is_none() && self.problem.plug_mm2 == 0.0
    }

    /// Half length at rest in mm.
    pub fn half_length(&self) -> f64 {
        self.mesh.node(0, 2 * self.mesh.along)[1]
    }
}

/// The tube on plugs that are not as wide as its bore, in equilibrium without a braid and as long
/// as before. The wall on a plug keeps its section, r² = R² + rp² − Ri². What draws the tube back
/// from its plugs is omitted: the muscle begins without stress in this shape.
fn on_plugs(cylinder: &Mesh, problem: &Problem) -> Result<Mesh> {
    let tube = Problem {
        braid: None,
        prestretch: 1.0,
        ..problem.clone()
    };
    let mut path = Continuation::new(Body::new(Discretisation::new(cylinder.clone(), tube)?));
    let half = path.body.discretisation.half_length();
    let layer = LAYER * path.body.discretisation.radius;
    let l = path.body.discretisation.layout;
    let drawn = |r: f64, share: f64| (r * r + share * problem.plug_mm2).sqrt();
    let mut done = 0.0;
    let mut step = 0.25;
    while done < 1.0 {
        let before = path.body.state.clone();
        let next = f64::min(done + step, 1.0);
        for j in 0..=2 * l.along {
            for i in 0..l.nodes() {
                let [r, z] = cylinder.node(i, j);
                let fall = ((z - half) / layer).exp();
                path.body.state.u[l.station_offset(j) + 2 * i] +=
                    drawn(r, next * fall) - drawn(r, done * fall);
            }
        }
        match path.solve(Control::Length(0.0)) {
            Ok(()) => done = next,
            Err(stop) if stop.is_final() || step < SMALLEST_DRAW => {
                return Err(FemError::on_plugs(stop));
            }
            Err(_) => {
                path.body.state = before;
                step *= 0.5;
            }
        }
    }
    let mut mesh = cylinder.clone();
    for (k, node) in mesh.nodes.iter_mut().enumerate() {
        let at = l.station_offset(k / l.nodes()) + 2 * (k % l.nodes());
        *node = [
            node[0] + path.body.state.u[at],
            node[1] + path.body.state.u[at + 1],
        ];
    }
    Ok(mesh)
}
