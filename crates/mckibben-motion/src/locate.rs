//! When an event comes: the first guard that fails within a step, by its dense output.

use crate::{OnStop, Result, events::Guard, integrate::Stepper, run::Integration, state::State};
use mckibben_core::analysis::find_root;

/// Whether the function of a guard needs an answer of a model.
fn needs_model(guard: Guard) -> bool {
    matches!(guard, Guard::Release | Guard::Slack(_) | Guard::Taut(_))
}

impl Integration<'_> {
    /// The first guard that fails within the last step, which ended at `t` with `end`, and when.
    pub fn event(&mut self, method: &Stepper, t: f64, end: &State) -> Result<Option<(Guard, f64)>> {
        const INSIDE: usize = 4;
        let from = self.t;
        let mut before = from;
        for i in 1..=INSIDE {
            let (time, inside) = if i == INSIDE {
                (t, None)
            } else {
                let time = from + (t - from) * i as f64 / INSIDE as f64;
                (time, self.within(method, time))
            };
            let state = inside.as_ref().unwrap_or(end);
            let guards = self.system.guards(time, state, i == INSIDE)?;
            if let Some(on_stop) = self.on_stop.as_mut().filter(|_| i == INSIDE)
                && let Some((_, g)) = guards.iter().find(|g| g.0 == Guard::Release)
                && -g > on_stop.net
            {
                *on_stop = OnStop {
                    net: -g,
                    time_s: time,
                    pressure_mpa: state.first_gauge_mpa(),
                };
            }
            let mut first: Option<(Guard, f64)> = None;
            let failing = |guards: Vec<(Guard, f64)>| guards.into_iter().filter(|(_, g)| *g < 0.0);
            for (guard, _) in failing(guards) {
                let low = if needs_model(guard) { from } else { before };
                let at = self.root(method, guard, (low, time))?;
                if first.is_none_or(|f| at < f.1) {
                    first = Some((guard, at));
                }
            }
            // Guards of the model may fail before the others.
            while let Some((_, at)) = first {
                let Some(state) = self.within(method, at) else {
                    break;
                };
                let all = self.system.guards(at, &state, true)?;
                let Some((guard, _)) = failing(all).find(|(g, _)| needs_model(*g)) else {
                    break;
                };
                let earlier = self.root(method, guard, (from, at))?;
                if earlier >= at {
                    break;
                }
                first = Some((guard, earlier));
            }
            if first.is_some() {
                return Ok(first);
            }
            before = time;
        }
        Ok(None)
    }

    /// When a guard fails that holds at the one time and not at the other.
    fn root(&self, method: &Stepper, guard: Guard, (low, high): (f64, f64)) -> Result<f64> {
        let function = |time: f64| -> Result<f64> {
            let Some(state) = self.within(method, time) else {
                return Ok(0.0);
            };
            Ok(self
                .system
                .guards(time, &state, needs_model(guard))?
                .into_iter()
                .find(|g| g.0 == guard)
                .map_or(0.0, |g| g.1))
        };
        Ok(find_root(function, low, high, 1e-9 * (high - self.t))?.unwrap_or(low))
    }
}
