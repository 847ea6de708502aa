//! What is written down of an integration: the series while it goes, and the sums at its end.

use crate::{
    ATMOSPHERE_MPA, Actuator, Coordinate, Energies, Event, EventKind, Fluid, Motion, MotionError,
    Result,
    air::normal_litres,
    integrate::Stepper,
    member::Substitute,
    metrics::{Passed, rest, step_figures},
    run::Integration,
    state::State,
    system::{Point, System},
};
use mckibben_core::{by_number::SortByNumber, extremes::peak};

impl Integration<'_> {
    /// The largest speed within the last step, which ended at `t`, by its dense output: the largest
    /// of nine points, and the top of the parabola through it and its neighbours.
    pub fn fastest(&mut self, method: &Stepper, t: f64) {
        const PIECES: usize = 8;
        let Some(largest) = self.largest_speed.filter(|_| !self.rests()) else {
            return;
        };
        let from = self.t;
        let width = t - self.t;
        let mut speed = |i: usize| {
            self.within(method, from + width * i as f64 / PIECES as f64)
                .map_or(0.0, |state| state.velocity.abs())
        };
        let speeds: [f64; PIECES + 1] = std::array::from_fn(&mut speed);
        let of_points = peak(speeds.iter().copied());
        let tops = speeds.windows(3).filter_map(|w| {
            let &[a, b, c] = w else { return None };
            let bend = a - 2.0 * b + c;
            (b >= a && b >= c && bend < 0.0).then(|| b - (c - a).powi(2) / (8.0 * bend))
        });
        self.largest_speed = Some(tops.fold(largest.max(of_points), f64::max));
    }

    /// Notes a point that was passed.
    pub fn pass_by(&mut self, time_s: f64, state: &State) {
        self.passed.push(Passed {
            time_s,
            coordinate: state.coordinate,
            velocity: if self.rests() { 0.0 } else { state.velocity },
            gauge_mpa: state.first_gauge_mpa(),
        });
    }

    /// The output that is due up to a time within the last step, which ended at `t`. Pull and
    /// volume between its ends are cubic in time, by their derivatives there: as good as the dense
    /// output, and no model is evaluated.
    pub fn records(&mut self, method: &Stepper, last: f64, (t, end): (f64, &State)) -> Result<()> {
        let system = self.system;
        let step = system.drive.output_step_s;
        if step * self.outputs as f64 > last {
            return Ok(());
        }
        // At the end of the step alone: that state, with the answer of the model.
        if step * self.outputs as f64 == t {
            return self.record(t, end.clone());
        }
        let from = self.t;
        let ends = (
            system.answers(self.t, &self.state)?,
            system.answers(t, end)?,
        );
        loop {
            let due = step * self.outputs as f64;
            if due > last {
                break;
            }
            let Some(state) = self.within(method, due) else {
                break;
            };
            for (member, (a, b)) in system.members.iter().zip(ends.0.iter().zip(&ends.1)) {
                member.substitute.set(Some(Substitute::between(
                    a,
                    b,
                    (due - from) / (t - from),
                    t - from,
                )));
            }
            let recorded = self.record(due, state);
            system.members.iter().for_each(|m| m.substitute.set(None));
            recorded?;
        }
        Ok(())
    }

    /// A point of the series.
    pub fn record(&mut self, t: f64, state: State) -> Result<()> {
        self.outputs += 1;
        let state = self.resting(state);
        self.pass_by(t, &state);
        let point = self.system.point(t, &state)?;
        let series = &mut self.motion.series;
        series.time_s.push(t);
        series.coordinate.push(state.coordinate);
        series.velocity.push(state.velocity);
        for (series, m) in series.muscles.iter_mut().zip(&point.muscles) {
            let values = [
                [m.pressure_mpa, m.contraction, m.pull_n.max(0.0), m.mass_g],
                [m.temperature_k, m.volume_mm3, m.opening, m.command],
            ];
            series
                .lists_mut()
                .into_iter()
                .zip(values.concat())
                .for_each(|(list, value)| list.push(value));
        }
        self.note_limits(t, &point);
        Ok(())
    }

    /// Notes each limit of a muscle that its pressure passed since the last point.
    fn note_limits(&mut self, time_s: f64, point: &Point) {
        let modes = &mut self.system.modes.borrow_mut().muscles;
        let members = self.system.members.iter().zip(1..);
        for ((mode, m), (member, muscle)) in modes.iter_mut().zip(&point.muscles).zip(members) {
            let kinds = [EventKind::AboveAllowed, EventKind::AboveBurst];
            let limits = member.limits_mpa().into_iter().zip(kinds);
            for (was_above, (limit_mpa, kind)) in mode.above.iter_mut().zip(limits) {
                let is_above = m.pressure_mpa > limit_mpa;
                if is_above && !*was_above {
                    self.motion.events.push(Event {
                        time_s,
                        kind,
                        muscle,
                        lost_j: 0.0,
                    });
                }
                *was_above = is_above;
            }
        }
    }

    /// The motion, of all that was integrated.
    pub fn end(mut self, ended: Option<MotionError>) -> Result<Motion> {
        let system = self.system;
        let drive = &system.drive;
        // The very end, if no multiple of the step was it.
        let until = if ended.is_some() {
            self.t
        } else {
            drive.until_s
        };
        if self
            .motion
            .series
            .time_s
            .last()
            .is_some_and(|t| until - t > 1e-9 * until)
        {
            // Where the model has no answer any more, the last point is the one before.
            let recorded = self.record(until, self.state.clone());
            if ended.is_none() {
                recorded?;
            }
        }
        let moves = drive
            .target
            .commands()
            .iter()
            .any(|c| c.bounds().1 > c.bounds().0);
        if moves && ended.is_none() {
            self.motion.never_lifted = self.on_stop.map(MotionError::NeverLifted);
        }
        let air = match system.fluid_mj_mm3(&self.state) {
            Err(_) if ended.is_some() => self.air,
            air => air?,
        };
        let energies = self.energies(air);
        let supplied = self.state.supplied_g();
        let mut flowed = 0.0;
        let mut missing: f64 = 0.0;
        for (end, first) in self.state.muscles.iter().zip(&self.first.muscles) {
            let grown = end.mass_g - first.mass_g;
            missing = missing.max((grown - end.supplied_g + end.exhausted_g).abs());
            flowed += end.supplied_g.abs() + end.exhausted_g.abs() + first.mass_g;
        }
        let largest_speed = self.largest_speed.unwrap_or_default();
        let mut motion = self.motion;
        motion.energies = energies;
        motion.mass_defect = missing / flowed.max(f64::MIN_POSITIVE);
        let cycle = self.cycle.filter(|_| ended.is_none());
        motion.liquid_volume_mm3 = system.pushed_mm3(&self.state);
        if motion.liquid_volume_mm3.is_none() {
            motion.air_normal_litres = normal_litres(supplied);
            motion.air_normal_litres_per_cycle = cycle
                .as_ref()
                .map(|c| normal_litres(supplied - c.supplied_g));
        }
        let mut equilibrium = None;
        if ended.is_none() {
            // A step before an event was taken twice, the second time up to the event.
            self.passed.sort_by_number(|a| a.time_s);
            let rest = rest(system, &self.passed);
            motion.end = rest.map(|(end, _)| end);
            equilibrium = rest.and_then(|(_, q)| q);
            let goal = equilibrium.filter(|_| motion.at_rest() == Some(false));
            step_figures(drive, &mut motion, &self.passed, goal);
        }
        match drive.mechanism.coordinate() {
            Coordinate::Angle => {
                motion.largest_velocity_deg_per_s = Some(largest_speed.to_degrees());
                motion.equilibrium_angle_deg = equilibrium.map(f64::to_degrees);
            }
            Coordinate::Shortening { rest_length_mm } => {
                motion.largest_velocity_mm_per_s = Some(largest_speed);
                motion.equilibrium_contraction = equilibrium.map(|q| q / rest_length_mm);
            }
        }
        motion.ended = ended;
        Ok(motion)
    }

    /// The energies up to where it is, with the internal energy of what fills the muscles in mJ and
    /// its volume in mm³ there.
    fn energies(&self, (internal, volume): (f64, f64)) -> Energies {
        let drive = &self.system.drive;
        let totals = self.state.totals;
        let kinetic = |state: &State| {
            let v = state.velocity;
            if v == 0.0 {
                0.0
            } else {
                0.5 * drive.mechanism.inertia() * v * v
            }
        };
        let load = |state: &State| drive.mechanism.load_energy_mj(state.coordinate);
        let external = totals.external.unwrap_or_default();
        Energies {
            enthalpy_in_j: 1e-3 * totals.enthalpy_in,
            enthalpy_out_j: 1e-3 * totals.enthalpy_out,
            heat_j: 1e-3 * totals.heat,
            internal_j: 1e-3 * (internal - self.air.0),
            gas_work_j: 1e-3 * totals.gas_work,
            stored_j: 1e-3
                * (totals.gas_work - ATMOSPHERE_MPA * (volume - self.air.1) - totals.static_work),
            static_work_j: 1e-3 * totals.static_work,
            friction_j: 1e-3 * totals.friction,
            viscoelastic_j: 1e-3 * totals.viscoelastic,
            damper_j: 1e-3 * totals.damper,
            impacts_j: self.impacts_j,
            load_j: 1e-3 * (load(&self.state) - load(&self.first) + external),
            kinetic_j: 1e-3 * (kinetic(&self.state) - kinetic(&self.first)),
            work_j: 1e-3 * totals.positive_work,
        }
    }
}

impl System {
    /// Liquid in mm³ at atmospheric pressure that came from the supply, or that syringes have pushed
    /// out and not drawn back; `None` of air.
    pub fn pushed_mm3(&self, state: &State) -> Option<f64> {
        let muscles = self.drive.muscles.iter().zip(&state.muscles);
        muscles
            .map(|(muscle, now)| {
                let Fluid::Liquid(liquid) = &muscle.fluid else {
                    return None;
                };
                let of_syringe = match &muscle.actuator {
                    Actuator::Syringe(s) => now.opening.unwrap_or_default() * s.volume_mm3,
                    _ => 0.0,
                };
                Some(liquid.volume_mm3(now.supplied_g) + of_syringe)
            })
            .sum()
    }

    /// Internal energy of all air or liquid in mJ, and the volume of all cavities in mm³.
    pub fn fluid_mj_mm3(&self, state: &State) -> Result<(f64, f64)> {
        let point = self.point(0.0, state)?;
        let muscles = point
            .muscles
            .iter()
            .zip(&self.drive.muscles)
            .zip(&state.muscles);
        Ok(
            muscles.fold((0.0, 0.0), |(energy, cavities), ((m, muscle), now)| {
                let volume = m.volume_mm3 + muscle.outside_mm3(now.opening);
                (
                    energy
                        + muscle
                            .fluid
                            .medium()
                            .internal_mj(m.pressure_mpa + ATMOSPHERE_MPA, volume),
                    cavities + m.volume_mm3,
                )
            }),
        )
    }
}
