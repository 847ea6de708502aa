//! What is to be run.

use crate::{
    ATMOSPHERE_MPA, Command, Fluid, Hose, LiquidValve, Mechanism, MotionError, Pid, PidOutput,
    Prony, Pump, Result, Syringe, Valve, ValveKind, error::within,
};
use mckibben_core::{model::ForceModel, muscle::Friction};
use std::sync::Arc;

/// The supply of compressed air.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Supply {
    /// Gauge pressure in MPa.
    pub pressure_mpa: f64,
    /// Temperature in K.
    pub temperature_k: f64,
}

impl Default for Supply {
    /// 6 bar, 20 °C.
    fn default() -> Self {
        Self {
            pressure_mpa: 0.6,
            temperature_k: 293.15,
        }
    }
}

impl Supply {
    pub(crate) fn state(&self) -> (f64, f64) {
        (self.pressure_mpa + ATMOSPHERE_MPA, self.temperature_k)
    }
}

/// What gives a muscle its air.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Actuator {
    /// An ideal regulator: ṗ = (command − p)/τ, the flow follows from the balance.
    Regulator {
        /// τ in s.
        time_constant_s: f64,
    },
    /// A valve of air.
    Valve(Valve),
    /// A valve of a liquid.
    LiquidValve(LiquidValve),
    /// A pump of a liquid.
    Pump(Pump),
    /// A syringe of a liquid.
    Syringe(Syringe),
}

impl Actuator {
    /// How its valve moves, with the hose behind it.
    fn port(&self) -> Option<(ValveKind, Option<Hose>)> {
        match self {
            Self::Valve(valve) => Some((valve.kind, valve.hose)),
            Self::LiquidValve(valve) => Some((valve.kind, valve.line)),
            Self::Pump(pump) => Some((pump.kind, pump.line)),
            Self::Regulator { .. } | Self::Syringe(_) => None,
        }
    }

    /// How it moves, of what has an opening.
    pub fn kind(&self) -> Option<ValveKind> {
        self.port().map(|port| port.0)
    }

    fn name(&self) -> &'static str {
        match self {
            Self::Regulator { .. } => "a regulator",
            Self::Valve(_) => "a valve of air",
            Self::LiquidValve(_) => "a valve of a liquid",
            Self::Pump(_) => "a pump",
            Self::Syringe(_) => "a syringe",
        }
    }
}

/// A muscle with all that acts on it.
#[derive(Clone)]
pub struct Actuated {
    /// Its static pull and volume.
    pub model: Arc<dyn ForceModel>,
    /// What gives it air.
    pub actuator: Actuator,
    /// What fills it.
    pub fluid: Fluid,
    /// Friction of its braid, half the width of its loop, which builds up again after each reversal
    /// ([`Presliding`](mckibben_core::muscle::Presliding)). Together with the overstress of the rubber
    /// it is no larger than the model's pull.
    pub friction: Option<Friction>,
    /// Viscoelasticity of its rubber.
    #[doc(hidden)]
    pub rubber: Prony,
    /// Gauge pressure at the start in MPa; without it, what the first command says (0 where that is
    /// an opening that is closed).
    pub initial_pressure_mpa: Option<f64>,
}

impl Actuated {
    /// A muscle on an actuator: isothermal, no dead volume, no friction, elastic.
    pub fn new(model: impl ForceModel + 'static, actuator: Actuator) -> Self {
        Self {
            model: Arc::new(model),
            actuator,
            fluid: Fluid::default(),
            friction: None,
            rubber: Prony::default(),
            initial_pressure_mpa: None,
        }
    }

    /// Dead volume, hose and the rest in a syringe in mm³; `opening` is the share of the syringe
    /// that was pushed out.
    pub fn outside_mm3(&self, opening: Option<f64>) -> f64 {
        let syringe = match &self.actuator {
            Actuator::Syringe(syringe) => (1.0 - opening.unwrap_or_default()) * syringe.volume_mm3,
            _ => 0.0,
        };
        let hose = self.actuator.port().and_then(|port| port.1);
        self.fluid.medium().dead_volume_mm3() + hose.map_or(0.0, |h| h.volume_mm3()) + syringe
    }
}

/// What is commanded.
#[derive(Debug, Clone, PartialEq)]
pub enum Commanded {
    /// Gauge pressures in MPa, one for each muscle: by the regulator, or by the law of the valve.
    Pressure(Vec<Command>),
    /// Openings of the valves, −1 … 1, one for each muscle; an on–off valve fills above ½, vents
    /// below −½ and holds between, without a closed centre fills above 0.
    Opening(Vec<Command>),
    /// Volumes in mm³ that syringes push out, one for each muscle; 0 at the start.
    Volume(Vec<Command>),
    /// The position: contraction of a single muscle, angle of a joint in rad.
    Position {
        /// The command.
        command: Command,
        /// The controller.
        pid: Pid,
    },
}

impl Commanded {
    /// All commands.
    pub fn commands(&self) -> &[Command] {
        match self {
            Self::Pressure(c) | Self::Opening(c) | Self::Volume(c) => c,
            Self::Position { command, .. } => std::slice::from_ref(command),
        }
    }

    /// Whether pressures are commanded, by a controller or at once.
    pub fn is_pressure(&self) -> bool {
        match self {
            Self::Pressure(_) => true,
            Self::Opening(_) | Self::Volume(_) => false,
            Self::Position { pid, .. } => pid.output != PidOutput::Opening,
        }
    }
}

/// A mechanism, its muscles, what is commanded, and for how long.
#[derive(Clone)]
pub struct Drive {
    /// What moves.
    pub mechanism: Arc<dyn Mechanism>,
    /// What pulls.
    pub muscles: Vec<Actuated>,
    /// Where the air comes from.
    pub supply: Supply,
    /// What is commanded.
    pub target: Commanded,
    /// The end in s; it begins at 0.
    pub until_s: f64,
    /// Time between two points of the series in s.
    pub output_step_s: f64,
    /// Relative tolerance of the integration; absolute ones are this share of a scale of each
    /// quantity (1 % of the stroke, 0.1 MPa, 10 N, 1 J, …).
    pub tolerance: f64,
    /// Most steps of the integration.
    pub most_steps: usize,
    /// The coordinate at the start in mm or rad, at rest; without it, the equilibrium at the first
    /// command.
    pub initial_coordinate: Option<f64>,
    /// A generalised force from outside that opposes growing q, over time: in N (q in mm) or N mm (q
    /// in rad).
    pub external: Command,
}

impl Drive {
    /// With 6 bar, a thousand points of output and the default tolerance.
    pub fn new(
        mechanism: impl Mechanism + 'static,
        muscles: Vec<Actuated>,
        target: Commanded,
        until_s: f64,
    ) -> Self {
        Self {
            mechanism: Arc::new(mechanism),
            muscles,
            supply: Supply::default(),
            target,
            until_s,
            output_step_s: until_s / 1000.0,
            tolerance: 1e-6,
            most_steps: 1_000_000,
            initial_coordinate: None,
            external: Command::Constant(0.0),
        }
    }

    /// Whether it can be run.
    pub fn check(&self) -> Result<()> {
        self.count(self.muscles.len(), "muscles with an actuator")?;
        self.mechanism.check()?;
        self.muscles
            .iter()
            .try_for_each(|m| m.model.muscle().check_contracts())?;
        for (what, value, low, high) in [
            (
                "the supply's temperature in K",
                self.supply.temperature_k,
                50.0,
                2000.0,
            ),
            (
                "the supply's gauge pressure in MPa",
                self.supply.pressure_mpa,
                0.0,
                100.0,
            ),
            ("the end of the run in s", self.until_s, 1e-9, 1e9),
            (
                "the time between two points in s",
                self.output_step_s,
                1e-12,
                1e9,
            ),
            (
                "the coordinate at the start",
                self.initial_coordinate.unwrap_or_default(),
                -1e9,
                1e9,
            ),
            ("the tolerance", self.tolerance, 1e-12, 1e-2),
        ] {
            within(what, value, low, high)?;
        }
        self.check_commands()?;
        (1..)
            .zip(&self.muscles)
            .try_for_each(|(number, muscle)| self.check_muscle(number, muscle))
    }

    /// One of what is given for each muscle.
    fn count(&self, given: usize, what: &str) -> Result<()> {
        let n = self.mechanism.muscles();
        MotionError::require(given == n, || {
            format!("there are {n} muscles in the mechanism, and {given} {what}; give one for each")
        })
    }

    fn check_commands(&self) -> Result<()> {
        let commands = self.target.commands().iter();
        commands
            .chain([&self.external])
            .try_for_each(Command::check)?;
        self.external
            .check_bounds("the force or torque from outside", -1e12, 1e12)?;
        match &self.target {
            Commanded::Pressure(commands) => {
                self.count(commands.len(), "commands")?;
                for command in commands {
                    let (low, high) = command.bounds();
                    let supply_mpa = self.supply.pressure_mpa;
                    within("a commanded pressure in MPa", low, 0.0, 100.0)?;
                    MotionError::require(high <= supply_mpa, || {
                        format!(
                            "the command is {high}\u{a0}MPa, above the supply pressure of \
                             {supply_mpa}\u{a0}MPa; raise the supply or lower the command"
                        )
                    })?;
                }
                Ok(())
            }
            Commanded::Opening(commands) => {
                self.count(commands.len(), "commands")?;
                commands
                    .iter()
                    .try_for_each(|c| c.check_bounds("a commanded opening", -1.0, 1.0))
            }
            Commanded::Volume(commands) => self.count(commands.len(), "commands"),
            Commanded::Position { pid, .. } => pid.check(),
        }
    }

    /// Whether a muscle's actuator goes with its command and with what fills it.
    fn check_muscle(&self, number: usize, muscle: &Actuated) -> Result<()> {
        muscle.check()?;
        let opened = !self.target.is_pressure() && !matches!(self.target, Commanded::Volume(_));
        let has_regulator = matches!(muscle.actuator, Actuator::Regulator { .. });
        MotionError::require(!(opened && has_regulator), || {
            format!(
                "an opening is commanded, but muscle {number} has a regulator; command its \
                 pressure, or give it a valve"
            )
        })?;
        let actuator = muscle.actuator.name();
        let volume = match &self.target {
            Commanded::Volume(commands) => commands.get(number - 1),
            _ => None,
        };
        match (&muscle.actuator, volume) {
            (Actuator::Syringe(syringe), Some(command)) => {
                command.check_bounds("a commanded volume in mm³", 0.0, syringe.volume_mm3)?;
            }
            (Actuator::Syringe(_), None) | (_, Some(_)) => {
                return Err(MotionError::Refused(format!(
                    "muscle {number} has {actuator}: a commanded volume goes with a syringe, and a \
                     syringe with a commanded volume"
                )));
            }
            _ => {}
        }
        let fits = match muscle.actuator {
            Actuator::Regulator { .. } => true,
            Actuator::Valve(_) => !muscle.fluid.is_liquid(),
            _ => muscle.fluid.is_liquid(),
        };
        MotionError::require(fits, || {
            format!(
                "muscle {number} has {actuator}, which is not for what fills it: a liquid goes \
                 with a flow coefficient, a pump, a syringe or a regulator, air with a sonic \
                 conductance or a regulator"
            )
        })
    }
}

impl Actuated {
    fn check(&self) -> Result<()> {
        within(
            "the wall's temperature in K",
            self.fluid.medium().wall_temperature_k(),
            50.0,
            2000.0,
        )?;
        // Up to 1000 m³.
        within(
            "the dead volume in mm³",
            self.fluid.medium().dead_volume_mm3(),
            0.0,
            1e12,
        )?;
        if let Fluid::Air(air) = &self.fluid {
            air.heat.check()?;
        }
        self.check_actuator()?;
        if let Some(Friction {
            coefficient,
            exponent,
            lever_mm,
            presliding_mm,
        }) = self.friction
        {
            within(
                "the friction's coefficient in N/MPa^β",
                coefficient,
                0.0,
                1e9,
            )?;
            within("the friction's exponent", exponent, 0.0, 10.0)?;
            within("the friction's lever in mm", lever_mm, 0.0, 1e6)?;
            within(
                "the friction's presliding length in mm",
                presliding_mm.unwrap_or(1.0),
                1e-6,
                1e6,
            )?;
        }
        if let Some(p) = self.initial_pressure_mpa {
            within("the gauge pressure at the start in MPa", p, 0.0, 100.0)?;
        }
        self.rubber.check()
    }

    fn check_actuator(&self) -> Result<()> {
        let lag = |what, time_constant_s| within(what, time_constant_s, 1e-6, 1e6);
        match &self.actuator {
            Actuator::Regulator { time_constant_s } => {
                lag("the regulator's time constant in s", *time_constant_s)?
            }
            Actuator::Pump(pump) => {
                within("the pump's flow in mm³/s", pump.flow_mm3_per_s, 1e-6, 1e12)?
            }
            Actuator::Syringe(syringe) => {
                lag("the syringe's time constant in s", syringe.time_constant_s)?;
                within(
                    "the syringe's volume in mm³",
                    syringe.volume_mm3,
                    1e-6,
                    1e12,
                )?;
            }
            Actuator::Valve(_) | Actuator::LiquidValve(_) => {}
        }
        match self.actuator.kind() {
            Some(ValveKind::OnOff { hysteresis_mpa, .. }) => {
                within(
                    "the on–off valve's hysteresis in MPa",
                    hysteresis_mpa,
                    1e-6,
                    100.0,
                )?;
            }
            Some(ValveKind::Proportional {
                time_constant_s,
                gain_per_mpa,
            }) => {
                if time_constant_s != 0.0 {
                    lag("the valve's lag, where it has one, in s", time_constant_s)?;
                }
                within("the valve's gain in 1/MPa", gain_per_mpa, 1e-3, 1e6)?;
            }
            None => {}
        }
        Ok(())
    }
}
