//! A muscle in bricks, ready to be led from equilibrium to equilibrium; its first guesses are
//! axisymmetric equilibria of the same muscle.

use super::{
    body::Body,
    discretisation::Discretisation,
    mesh::{BrickMesh, BrickSpec, Quarter},
    model::ENTRY,
    plug::Plug,
    problem::Problem,
};
use crate::{
    FemError, Result,
    axisymmetric::{self, Axisymmetric, Section},
    simulation::Divided,
    solver::{
        body::{self, Control, Settings, State, Totals},
        continuation::Continuation,
        newton::{NewtonOptions, NewtonSystem, Stopped},
    },
};
use mckibben_core::{
    model::{ForceModel, ModelEntry},
    muscle::{BraidStiffness, Muscle},
};
use std::sync::Arc;

/// What of a muscle in bricks does not change.
#[derive(Debug, Clone)]
pub struct MuscleMesh {
    /// The grid.
    pub mesh: Arc<BrickMesh>,
    /// The unknowns and what they are made of.
    pub discretisation: Arc<Discretisation>,
    /// Whether it is not stated how far its plug reaches into the tube.
    pub insertion_assumed: bool,
    /// The limit of fine meshes and many strands.
    pub limit: Axisymmetric,
    axisymmetric: Option<Axisymmetric>,
    /// Width that one strand of the mesh represents, in mm.
    width: f64,
}

impl MuscleMesh {
    /// Divides a muscle.
    ///
    /// # Errors
    /// [`FemError`] where the numbers give no valid mesh.
    pub fn new(muscle: &Muscle, spec: &BrickSpec) -> Result<Self> {
        let tube = muscle.tube();
        let braid = muscle.braid();
        let missing = [
            ("braid.thickness", braid.thickness_mm > 0.0),
            ("braid.diameter", !braid.lay(tube).is_on(tube)),
            ("braid.crimp", braid.crimp.is_some()),
            ("tube.material.conditioned", tube.rubber.is_conditioned()),
            ("terminals.plug_diameter", muscle.parts().plug_mm2() != 0.0),
        ];
        if let Some((key, _)) = missing.into_iter().find(|(_, stated)| *stated) {
            return Err(FemError::Refused(format!(
                "three-dimensional elements have no {key}: their strands are trusses on the \
                 cylinder of the tube's surface, their rubber is that of a first inflation; take \
                 fe, or leave the key out"
            )));
        }
        // How far the plug reaches into the tube is the muscle's to say.
        let insertion = muscle.insertion_mm();
        let stated =
            |p: &Plug| p.insertion_mm.is_some() || muscle.terminals().insertion_mm.is_some();
        let insertion_assumed = spec.plug.as_ref().is_some_and(|p| !stated(p));
        let plug = spec.plug.map(|p| Plug {
            insertion_mm: p.insertion_mm.or(Some(insertion)),
            ..p
        });
        let mesh = BrickMesh::new(&Quarter::from_muscle(muscle), &BrickSpec { plug, ..*spec })?;
        Ok(Self {
            limit: Axisymmetric::between_ends(muscle)?,
            axisymmetric: same_muscle(muscle, &mesh),
            width: mesh.strand_width_mm(muscle),
            discretisation: Arc::new(Discretisation::new(Problem::from_muscle(muscle, &mesh))?),
            mesh: Arc::new(mesh),
            insertion_assumed,
        })
    }
}

impl Divided for MuscleMesh {
    const ENTRY: ModelEntry = ENTRY;
    type Body = MuscleInBricks;

    fn at_rest(&self) -> Result<MuscleInBricks> {
        let section = self.axisymmetric.as_ref().map(|model| {
            let section = model.divided.at_rest().map(Continuation::new);
            section.map(|section| (model.muscle().clone(), section))
        });
        Ok(MuscleInBricks {
            bricks: Body::new(self.discretisation.clone())?,
            mesh: self.mesh.clone(),
            section: section.transpose()?,
            width: self.width,
        })
    }

    fn limit(&self) -> Option<&Axisymmetric> {
        Some(&self.limit)
    }
}

/// The axisymmetric model of the same muscle, with the mesh's length and angle and the same
/// strands.
fn same_muscle(muscle: &Muscle, mesh: &BrickMesh) -> Option<Axisymmetric> {
    let mut tube = muscle.tube().clone();
    tube.length_mm = 2.0 * mesh.tube.half_mm;
    let mut braid = muscle.braid().clone();
    if let Some(k) = muscle.family_stiffness_n_per_mm() {
        // Strands of the mesh lie closer together where they are steeper.
        let ratio = braid.angle_rad().cos() / mesh.tube.angle_rad.cos();
        braid.stiffness = BraidStiffness::NewtonPerMm(k * ratio);
    }
    braid.angle_deg = mesh.tube.angle_rad.to_degrees();
    braid.measured = None;
    Axisymmetric::between_ends(&muscle.with_tube(tube).ok()?.with_braid(braid).ok()?).ok()
}

/// A muscle in bricks with its state.
#[derive(Debug)]
pub struct MuscleInBricks {
    /// Its bricks and strands.
    pub bricks: Body,
    /// The grid.
    pub mesh: Arc<BrickMesh>,
    /// The axisymmetric muscle with the mesh's length and angle.
    section: Option<(Muscle, Continuation<axisymmetric::Body>)>,
    pub(super) width: f64,
}

impl body::Body for MuscleInBricks {
    const SETTINGS: Settings = Settings {
        newton: NewtonOptions {
            tolerance: 1e-9,
            iterations: 14,
            ..NewtonOptions::DEFAULT
        },
        kept: 4,
        near_pressure: 0.15,
        near_contraction: 0.01,
        first_step: 0.25,
        first_step_down: 0.25,
        smallest_step: 1.0 / 128.0,
        budget: 400,
        take_unstable: true,
    };
    const COPIES: f64 = 8.0;

    fn system(&mut self) -> &mut dyn NewtonSystem {
        &mut self.bricks
    }

    fn state(&self) -> &State {
        &self.bricks.state
    }

    fn state_mut(&mut self) -> &mut State {
        &mut self.bricks.state
    }

    fn hold_control(&mut self, control: Control) {
        self.bricks.control = control;
    }

    fn half_length(&self) -> f64 {
        self.bricks.discretisation.half
    }

    fn totals(&self) -> Totals {
        self.bricks.totals
    }

    fn unstable_directions(&self) -> usize {
        self.bricks.unstable_directions()
    }

    fn terminal_stiffness(&mut self) -> f64 {
        self.bricks.terminal_response().0
    }

    fn force_per_pressure(&mut self) -> f64 {
        self.bricks.force_per_pressure()
    }

    fn smallest_pressure(&self) -> f64 {
        1e-3 * self.bricks.discretisation.shear
    }

    fn guess(&mut self, attempt: usize, pressure: f64, terminal: f64) -> Option<bool> {
        (attempt == 0).then(|| self.guess_taut(pressure, terminal))
    }

    /// Fills the state with the axisymmetric equilibrium; `false` where there is none.
    fn guess_taut(&mut self, pressure: f64, terminal: f64) -> bool {
        let contraction = -terminal / self.bricks.discretisation.half;
        let Some((muscle, c)) = &mut self.section else {
            return false;
        };
        if c.reach(pressure, contraction).is_err() {
            return false;
        }
        let section = Section::from_state(&c.body.discretisation, &c.body.state, muscle);
        let state = &mut self.bricks.state;
        state.pressure = pressure;
        state.terminal = terminal;
        self.carry_over(&section);
        true
    }

    fn pulling_pressure(&self, contraction: f64) -> Option<f64> {
        body::Body::pulling_pressure(&self.section.as_ref()?.1.body, contraction)
    }

    fn guess_contraction(&mut self, force: f64, pressure: f64) -> Result<f64> {
        let Some((_, section)) = &mut self.section else {
            return Ok(0.0);
        };
        section.reach_force(force, pressure)?;
        Ok(section.contraction())
    }

    fn guess_pressure(&mut self, force: f64, contraction: f64) -> Result<f64> {
        let Some((_, section)) = &mut self.section else {
            return Err(FemError::Force {
                force_n: force,
                reason: Stopped::Diverged,
            });
        };
        section.reach_pressure(force, contraction)?;
        Ok(section.body.state.pressure)
    }

    fn taut_pressure(&self, contraction: f64) -> f64 {
        self.section
            .as_ref()
            .map_or(0.0, |section| section.1.body.taut_pressure(contraction))
    }

    fn expected_pull(&self, pressure: f64, contraction: f64) -> Option<f64> {
        self.section
            .as_ref()?
            .1
            .body
            .expected_pull(pressure, contraction)
    }

    fn radius(&self) -> f64 {
        self.bricks.discretisation.radius
    }
}
