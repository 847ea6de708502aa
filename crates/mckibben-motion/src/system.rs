//! The equations of motion of a drive.

use crate::{
    ATMOSPHERE_MPA, Commanded, Drive, Fluid, MotionError, PidOutput, Result,
    air::{Cavity, cavity_area_mm2},
    fluid::{FluidRates, Medium},
    integrate::Equations,
    member::{Answer, Member, Moment, Substitute},
    state::{ControllerState, Layout, MuscleState, State, Totals},
};
use mckibben_core::muscle::Presliding;
use std::cell::{Cell, RefCell};

/// What an on–off valve does.
#[derive(Clone, Copy, PartialEq)]
#[repr(u8)]
pub enum Switch {
    Fill,
    Hold,
    Vent,
}

/// Which side of each kink holds.
#[derive(Clone)]
pub struct Modes {
    /// On the lower (−1) or upper (1) stop.
    pub stop: Option<f64>,
    pub muscles: Vec<Mode>,
}

#[derive(Clone)]
pub struct Mode {
    pub slack: bool,
    /// The sign of the shortening speed, where there is friction.
    pub sign: f64,
    /// Of the friction: up to the last step, and without a reversal from there on.
    pub presliding: Option<Presliding>,
    pub switch: Switch,
    /// Whether the pressure lies above the allowed one, and above the least burst pressure.
    pub above: [bool; 2],
}

/// One muscle at one time.
#[derive(Clone)]
pub struct MusclePoint {
    pub pressure_mpa: f64,
    pub contraction: f64,
    /// The model's pull; negative where it would push.
    pub model_n: f64,
    pub pull_n: f64,
    pub volume_mm3: f64,
    pub temperature_k: f64,
    pub mass_g: f64,
    pub opening: f64,
    /// The command of this muscle: pressure or opening.
    pub command: f64,
    /// What an on–off valve looks at.
    pub signal: f64,
    /// ε − ε_free where it is slack
    pub beyond: f64,
}

/// Everything at one time.
#[derive(Clone, Default)]
pub struct Point {
    pub muscles: Vec<MusclePoint>,
    /// Net generalised force with damping.
    pub net: f64,
    /// The state's derivative in time.
    pub rates: State,
}

#[derive(Clone)]
pub struct System {
    pub drive: Drive,
    pub members: Vec<Member>,
    pub layout: Layout,
    /// The size of each number of the state.
    pub scale: State,
    scales: Vec<f64>,
    pub modes: RefCell<Modes>,
    /// A time within the piece of the command that holds.
    pub within: Cell<f64>,
    pub failed: RefCell<Option<MotionError>>,
    /// For [`Equations::rates`].
    room: RefCell<(State, Point)>,
    /// Added to the commands, for the linear system: to those of muscles that turn a joint to −,
    /// the negative.
    pub offset: Cell<f64>,
}

/// Another one in the same state.
impl System {
    pub fn new(drive: &Drive) -> Result<Self> {
        drive.check()?;
        let members = Vec::from_iter(
            drive
                .muscles
                .iter()
                .map(|m| Member::new(m, drive.tolerance)),
        );
        let layout = Layout::new(drive);
        let scale = sizes(drive, &members, &layout);
        let drive = drive.clone();
        let room = (layout.filled(0.0), Point::default());
        let modes = Modes {
            stop: None,
            muscles: vec![
                Mode {
                    slack: false,
                    sign: 1.0,
                    presliding: None,
                    above: [false; 2],
                    switch: Switch::Hold,
                };
                members.len()
            ],
        };
        Ok(Self {
            drive,
            members,
            layout,
            scales: scale.to_vec(),
            scale,
            modes: RefCell::new(modes),
            within: Cell::new(0.0),
            failed: RefCell::new(None),
            room: RefCell::new(room),
            offset: Cell::new(0.0),
        })
    }

    /// Quantities at a time, and the rates.
    pub fn point(&self, t: f64, state: &State) -> Result<Point> {
        let mut point = Point::default();
        self.point_within(t, state, &mut point)?;
        Ok(point)
    }

    /// The same into the memory of another point.
    fn point_within(&self, t: f64, state: &State, point: &mut Point) -> Result<()> {
        let modes = self.modes.borrow();
        let mechanism = &self.drive.mechanism;
        let q = state.coordinate;
        let v = modes.stop.map_or(state.velocity, |_| 0.0);
        let control = self.control(t, state);
        let mut net = 0.0;
        let Point { muscles, rates, .. } = point;
        muscles.clear();
        rates.muscles.clear();
        *rates = State {
            muscles: std::mem::take(&mut rates.muscles),
            controller: control.map(|c| c.rates),
            ..State::default()
        };
        let totals = &mut rates.totals;
        let parts = self.members.iter().zip(&state.muscles).zip(&modes.muscles);
        for (i, ((member, now), mode)) in parts.enumerate() {
            let (muscle, medium) = (&member.muscle, member.muscle.fluid.medium());
            let lever = mechanism.lever(i, q);
            let absolute_mpa = now.absolute_mpa;
            let gauge = now.gauge_mpa();
            let at = self.answer_at(t, i, mode, gauge, lever.contraction)?;
            if medium.boils(absolute_mpa) {
                return Err(MotionError::Boils(format!(
                    "the liquid in muscle {} boils at {t} s: its absolute pressure falls below \
                     {absolute_mpa}\u{a0}MPa",
                    i + 1
                )));
            }
            let speed = member.length_mm * lever.per_coordinate * v;
            let swept_mm3_per_s = if mode.slack {
                0.0
            } else {
                at.volume_mm3.by_contraction * lever.per_coordinate * v
            };
            let cavity = cavity(member, now, &at, swept_mm3_per_s);
            let (wall_n, pulls) = pulls(member, now, mode, &at, lever.contraction);
            net += pulls.pull_n * member.length_mm * lever.per_coordinate;

            let command = self.command(t, i, control);
            let fluid = self.flows(muscle, now, command, mode, &cavity);
            rates.muscles.push(MuscleState {
                absolute_mpa: fluid.pressure_rate,
                mass_g: fluid.supply.mass_g_per_s + fluid.exhaust.mass_g_per_s,
                opening: now.opening.map(|_| fluid.opening_rate),
                branches_n: muscle.rubber.rates(wall_n, &now.branches_n),
                supplied_g: fluid.supply.mass_g_per_s,
                exhausted_g: -fluid.exhaust.mass_g_per_s,
            });
            add_flows(totals, medium, &fluid, &cavity);
            totals.static_work += pulls.model_n * speed;
            totals.viscoelastic += pulls.excess_n * speed;
            totals.friction += pulls.opposing_n * speed;
            totals.positive_work += (pulls.pull_n * speed).max(0.0);
            muscles.push(MusclePoint {
                pressure_mpa: gauge,
                contraction: lever.contraction,
                model_n: at.force_n.value,
                pull_n: pulls.pull_n,
                volume_mm3: at.volume_mm3.value,
                temperature_k: cavity.temperature_k,
                mass_g: now.mass_g,
                opening: fluid.opening,
                command,
                signal: fluid.signal,
                beyond: lever.contraction - at.contraction.value,
            });
        }
        let damping = mechanism.damping() * v;
        let external = self.drive.external.value_within(t, self.within.get());
        net -= mechanism.load(q) + external + damping;
        totals.damper = damping * v;
        totals.external = state.totals.external.map(|_| external * v);
        if modes.stop.is_none() {
            (rates.coordinate, rates.velocity) = (v, net / mechanism.inertia());
        }
        point.net = net;
        Ok(())
    }

    /// What a muscle answers.
    fn answer_at(&self, t: f64, i: usize, mode: &Mode, p: f64, e: f64) -> Result<Answer> {
        self.members[i]
            .answer_or_slack(mode.slack, p, e)
            .map_err(|error| MotionError::model(error, t, i, p, e))
    }

    /// After a step: the friction of each muscle remembers where it went, and its pressure there.
    pub fn remember(&self, t: f64, state: &State) -> Result<()> {
        let mut modes = self.modes.borrow_mut();
        let parts = self
            .members
            .iter()
            .zip(&state.muscles)
            .zip(&mut modes.muscles);
        for (i, ((member, now), mode)) in parts.enumerate() {
            if mode.presliding.is_none() {
                continue;
            }
            let e = self.drive.mechanism.lever(i, state.coordinate).contraction;
            let at = self.answer_at(t, i, mode, now.gauge_mpa(), e)?;
            let limit_n = half_width_n(member, now, &at);
            if let Some(presliding) = &mut mode.presliding {
                presliding.go(member.length_mm * e, limit_n);
            }
        }
        Ok(())
    }

    /// What each muscle answers at a time, with its derivative in time: for everything between two
    /// of them.
    pub fn answers(&self, t: f64, state: &State) -> Result<Vec<Moment>> {
        let rates = self.point(t, state)?.rates;
        let modes = self.modes.borrow();
        let muscles = state.muscles.iter().zip(&rates.muscles);
        muscles
            .zip(&modes.muscles)
            .enumerate()
            .map(|(i, ((now, rate), mode))| {
                let p = now.gauge_mpa();
                let lever = self.drive.mechanism.lever(i, state.coordinate);
                let at = self.answer_at(t, i, mode, p, lever.contraction)?;
                let p_rate = rate.absolute_mpa;
                let e_rate = at
                    .contraction
                    .rate(p_rate, lever.per_coordinate * rates.coordinate);
                Ok(at.quantities().map(|q| (q, q.rate(p_rate, e_rate))))
            })
            .collect()
    }
}

/// What is in a muscle: a slack one follows the pressure alone.
fn cavity(member: &Member, now: &MuscleState, at: &Answer, swept_mm3_per_s: f64) -> Cavity {
    let medium = member.muscle.fluid.medium();
    let absolute_mpa = now.absolute_mpa;
    let inside = at.volume_mm3;
    let contraction = at.contraction;
    let volume_mm3 = inside.value + member.muscle.outside_mm3(now.opening);
    let length_mm = member.length_mm * (1.0 - contraction.value);
    Cavity {
        absolute_mpa,
        temperature_k: medium.temperature_k(absolute_mpa, now.mass_g, volume_mm3),
        volume_mm3,
        volume_per_pressure_mm3_per_mpa: inside.by_pressure
            + inside.by_contraction * contraction.by_pressure,
        swept_mm3_per_s,
        area_mm2: if medium.needs_area() {
            cavity_area_mm2(inside.value, length_mm)
        } else {
            0.0
        },
    }
}

/// The energies a second that a fluid carries, exchanges and gives.
fn add_flows(totals: &mut Totals, medium: &dyn Medium, fluid: &FluidRates, cavity: &Cavity) {
    let absolute_mpa = cavity.absolute_mpa;
    let swelling =
        cavity.swept_mm3_per_s + cavity.volume_per_pressure_mm3_per_mpa * fluid.pressure_rate;
    totals.enthalpy_in += medium.enthalpy_mw(fluid.supply, absolute_mpa);
    let pushed = fluid.piston_mm3_per_s.max(0.0);
    totals.enthalpy_in += absolute_mpa * pushed;
    totals.enthalpy_out += absolute_mpa * (pushed - fluid.piston_mm3_per_s);
    totals.enthalpy_out -= medium.enthalpy_mw(fluid.exhaust, absolute_mpa);
    totals.heat += medium.heat_mw(fluid.pressure_rate, cavity, &[fluid.supply, fluid.exhaust]);
    totals.gas_work += absolute_mpa * swelling;
}

/// The parts of a muscle's pull; none of a slack one.
#[derive(Default)]
struct Pulls {
    model_n: f64,
    /// Of the viscoelastic wall.
    excess_n: f64,
    /// Of friction.
    opposing_n: f64,
    /// At the muscle's end.
    pull_n: f64,
}

/// The wall's part of the pull, and the pulls.
fn pulls(
    member: &Member,
    now: &MuscleState,
    mode: &Mode,
    at: &Answer,
    contraction: f64,
) -> (f64, Pulls) {
    let muscle = &member.muscle;
    let pressure_mpa = now.gauge_mpa();
    let wall_n = if muscle.rubber.0.is_empty() {
        0.0
    } else {
        member.wall_n(pressure_mpa, at)
    };
    if mode.slack {
        return (wall_n, Pulls::default());
    }
    let model_n = at.force_n.value;
    let excess_n = muscle.rubber.excess_n(wall_n, &now.branches_n);
    let friction_n = mode.presliding.as_ref().map_or(0.0, |presliding| {
        presliding.friction(
            member.length_mm * contraction,
            half_width_n(member, now, at),
        )
    });
    // A rope cannot push, and its end is free of force where it goes slack: friction and overstress
    // are no larger than the pull.
    let most_n = model_n.max(0.0);
    let pull_n = model_n + (excess_n - friction_n).clamp(-most_n, most_n);
    (
        wall_n,
        Pulls {
            model_n,
            excess_n,
            opposing_n: model_n + excess_n - pull_n,
            pull_n,
        },
    )
}

/// Half the width of the hysteresis at a pressure and an answer.
fn half_width_n(member: &Member, now: &MuscleState, at: &Answer) -> f64 {
    let pivoting = at.pivoting_n_per_mm.value.max(0.0);
    member
        .muscle
        .friction
        .map_or(0.0, |f| f.half_width_n(now.gauge_mpa(), pivoting))
}

/// The size of each number of the state.
fn sizes(drive: &Drive, members: &[Member], layout: &Layout) -> State {
    let mut scale = layout.filled(1e3);
    let stroke = 0.01 / drive.mechanism.shortening(0.0);
    (scale.coordinate, scale.velocity) = (stroke, 10.0 * stroke);
    for (size, member) in scale.muscles.iter_mut().zip(members) {
        let volume = member.ideal_mm3(0.0).max(1.0);
        let mass_g = match &member.muscle.fluid {
            Fluid::Air(_) => 1.2e-6 * volume,
            Fluid::Liquid(liquid) => liquid.mass_g(ATMOSPHERE_MPA, volume),
        };
        *size = MuscleState {
            absolute_mpa: 0.1,
            mass_g,
            opening: size.opening.map(|_| 1.0),
            branches_n: vec![10.0; size.branches_n.len()],
            supplied_g: mass_g,
            exhausted_g: mass_g,
        };
    }
    if let (Some(size), Commanded::Position { pid, .. }) = (&mut scale.controller, &drive.target) {
        *size = ControllerState {
            integral: if pid.output == PidOutput::Opening {
                1.0
            } else {
                0.1
            },
            filtered: stroke * drive.mechanism.position_per_coordinate().abs(),
        };
    }
    scale
}

impl Equations for System {
    fn core(&self) -> usize {
        self.layout.core
    }

    /// With the air from the supply and to the outside: what goes in, comes out and stays.
    fn implicit(&self) -> usize {
        self.layout.core + 2 * self.members.len()
    }

    fn scales(&self) -> &[f64] {
        &self.scales
    }

    /// Forces and volumes are linear about the point where the differences are taken: one answer of
    /// the models serves for all of them.
    fn differences(&self, y: Option<&[f64]>) {
        self.members
            .iter()
            .for_each(|member| member.substitute.set(None));
        let Some(state) = y.map(|y| self.layout.state(y)) else {
            return;
        };
        let modes = self.modes.borrow();
        let parts = self
            .members
            .iter()
            .zip(&state.muscles)
            .zip(&modes.muscles)
            .enumerate();
        for (i, ((member, now), mode)) in parts {
            let p = now.gauge_mpa();
            let e = self.drive.mechanism.lever(i, state.coordinate).contraction;
            member.substitute.set(
                member
                    .answer_or_slack(mode.slack, p, e)
                    .ok()
                    .map(|answer| Substitute::Near(p, e, answer)),
            );
        }
    }

    fn near(&self, begin: bool) {
        self.members
            .iter()
            .for_each(|member| member.substitute.set(begin.then_some(Substitute::Nearest)));
    }

    fn rates(&self, t: f64, y: &[f64], rates: &mut [f64]) {
        let (state, point) = &mut *self.room.borrow_mut();
        state.read(y);
        let result = self.point_within(t, state, point);
        point.rates.write(rates);
        let error = match result {
            Err(error) => error,
            Ok(()) if rates.iter().all(|r| r.is_finite()) => return,
            Ok(()) => MotionError::diverged(t, "a rate is not finite"),
        };
        rates.fill(0.0);
        self.failed.borrow_mut().get_or_insert(error);
    }
}
