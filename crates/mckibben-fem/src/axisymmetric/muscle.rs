//! The section of a muscle, ready to be led from equilibrium to equilibrium; its first guesses come
//! from the infinitely long muscle of the same rubber and braid.

use super::{
    body::Body,
    guess::{self, Outline},
};
use crate::{
    Result,
    element::strand::STRAND_POINTS,
    solver::{
        body::{Body as _, Control, Settings, State, Totals},
        continuation::TAUT,
        newton::{NewtonOptions, NewtonSystem},
    },
};
use mckibben_core::{
    analysis::bisect,
    model::{ForceModel, Ideal, Workspace},
};
use std::f64::consts::PI;

/// Above this multiple of μ s/Ro the pressure at which a muscle is expected to pull is that of one
/// whose strands stretch first.
const PULLS_BELOW: f64 = 10.0;
/// Multiple of μ s/Ro at which strands are taut.
const RINGS: f64 = 3.0;

impl crate::solver::body::Body for Body {
    const SETTINGS: Settings = Settings {
        newton: NewtonOptions {
            iterations: 10,
            ..NewtonOptions::DEFAULT
        },
        kept: 8,
        near_pressure: 0.6,
        near_contraction: 0.08,
        first_step: 1.0,
        first_step_down: 0.3,
        smallest_step: 1.0 / 512.0,
        budget: 1500,
        take_unstable: false,
    };
    const COPIES: f64 = 2.0;

    fn system(&mut self) -> &mut dyn NewtonSystem {
        self
    }

    fn state(&self) -> &State {
        &self.state
    }

    fn state_mut(&mut self) -> &mut State {
        self.linearised = false;
        &mut self.state
    }

    fn linearised_here(&self) -> bool {
        self.linearised
    }

    fn hold_control(&mut self, control: Control) {
        self.control = control;
    }

    fn half_length(&self) -> f64 {
        self.discretisation.half_length()
    }

    fn totals(&self) -> Totals {
        self.totals
    }

    fn unstable_directions(&self) -> usize {
        let l = self.discretisation.layout;
        let negative_end = (0..self.end.free)
            .filter(|&i| self.end.matrix[i * (self.end.free + 2)] < 0.0)
            .count();
        let multipliers = l.inside() - l.station();
        (self.assembled.chain.negative + negative_end).saturating_sub(multipliers * l.along)
    }

    fn terminal_stiffness(&mut self) -> f64 {
        self.end.stiffness()
    }

    fn force_per_pressure(&mut self) -> f64 {
        self.by_pressure().1
    }

    fn smallest_pressure(&self) -> f64 {
        1e-3 * self.discretisation.shear
    }

    fn guess(&mut self, attempt: usize, pressure: f64, terminal: f64) -> Option<bool> {
        match attempt {
            0 => Some(self.guess_slack(pressure, terminal)),
            1 => Some(self.guess_taut(pressure, terminal)),
            2 => {
                self.guess_ideal(pressure, terminal);
                Some(true)
            }
            3 => Some(self.guess_net(pressure, terminal)),
            _ => None,
        }
    }

    fn guess_taut(&mut self, pressure: f64, terminal: f64) -> bool {
        self.guess_ideal(pressure, terminal);
        guess::shape(
            &self.discretisation,
            &mut self.state,
            terminal,
            Outline::Layer,
        )
    }

    fn guess_loads(&mut self) {
        guess::loads(&self.discretisation, &mut self.state, 1.0);
    }

    /// The pressure at which the infinitely long muscle begins to pull.
    fn pulling_pressure(&self, contraction: f64) -> Option<f64> {
        let high = self.discretisation.shear;
        let pull = |p: f64| self.expected_pull(p, contraction);
        let push = pull(0.0)?;
        let slope = (pull(high)? - push) / high;
        (slope > 0.0).then(|| (-push / slope).max(0.0))
    }

    /// Somewhat above the one at which it begins to pull. Where it never does, the tube is pressed
    /// outwards by what an elastic ring takes, μ s/Ro, several times.
    fn taut_pressure(&self, contraction: f64) -> f64 {
        let d = &self.discretisation;
        let ring = d.shear * (d.radius - d.mesh.node(0, 0)[0]) / d.radius;
        self.pulling_pressure(contraction)
            .filter(|p| *p < PULLS_BELOW * ring)
            .map_or(RINGS * ring, |p| TAUT * p)
    }

    /// Between the contraction −0.05 and above the ideal maximum, by bisection of the infinitely
    /// long muscle's pull.
    fn guess_contraction(&mut self, force: f64, pressure: f64) -> Result<f64> {
        let Some(endless) = &self.endless else {
            return Ok(0.0);
        };
        let pull = |e: f64| endless.force_n(&mut Workspace::new(), pressure, e).ok();
        let end = 1.2 * endless.muscle().max_ideal_contraction();
        let low = end.min(-0.05);
        let high = end.max(0.05);
        if pull(low).is_none() {
            return Ok(0.0);
        }
        let (low, _) = bisect(low, high, 40, |e| pull(e).is_some_and(|f| f > force));
        // The ends take a share of the infinitely long muscle's contraction.
        Ok(0.85 * low)
    }

    fn guess_pressure(&mut self, force: f64, contraction: f64) -> Result<f64> {
        let ideal = self.endless.as_ref().map_or(1.0, |e| {
            Ideal::between_ends(e.muscle())
                .pull(1.0, contraction)
                .max(1.0)
        });
        let start = self.pulling_pressure(contraction).unwrap_or(0.0) + force.max(0.0) / ideal;
        Ok(1.4 * start + self.smallest_pressure())
    }

    fn expected_pull(&self, pressure: f64, contraction: f64) -> Option<f64> {
        self.endless
            .as_ref()?
            .force_n(&mut Workspace::new(), pressure, contraction)
            .ok()
    }

    fn radius(&self) -> f64 {
        self.discretisation.radius
    }

    fn loose(&self) -> bool {
        let d = &self.discretisation;
        d.problem
            .braid
            .is_some_and(|b| b.lay.hoop_stretch(d.radius) < 1.0)
    }

    /// A thin tube of the modulus 3 μ and a Poisson's ratio of a half buckles axisymmetrically, by
    /// the classical formula, under a push of 4π μ s² and a shortening of 2 s/(3 R): half of both
    /// is borne without folds.
    fn folds_below(&self) -> f64 {
        let d = &self.discretisation;
        let wall = d.radius - d.mesh.node(0, 0)[0];
        let shortening = 1.0 - d.problem.prestretch * (1.0 + self.state.terminal / d.half_length());
        if shortening > wall / (3.0 * d.radius) {
            return f64::INFINITY;
        }
        -2.0 * PI * d.shear * wall.powi(2)
    }

    fn taut(&self) -> bool {
        let state = &self.state;
        let l = self.discretisation.layout;
        let taut = |q: &f64| *q > 0.0;
        let unpressurised = state.pressure == 0.0 && state.terminal >= 0.0;
        unpressurised
            || if l.multipliers {
                (0..l.along)
                    .all(|slab| state.u[l.tension(slab)..][..STRAND_POINTS].iter().all(taut))
            } else {
                state.q.iter().all(taut)
            }
    }
}

impl Body {
    /// The body at rest with the tensions and pressures of the ideal muscle.
    fn guess_ideal(&mut self, pressure: f64, terminal: f64) {
        self.rest();
        self.state.pressure = pressure;
        guess::loads(
            &self.discretisation,
            &mut self.state,
            1.0 + terminal / self.discretisation.half_length(),
        );
    }

    /// The shape of a tube that does not reach its strands; `false` where the infinitely long
    /// muscle says that it does.
    fn guess_slack(&mut self, pressure: f64, terminal: f64) -> bool {
        let contraction = -terminal / self.discretisation.half_length();
        let radius = self.endless.as_ref().and_then(|endless| {
            let r = endless
                .response(&mut Workspace::new(), pressure, contraction)
                .ok()?;
            (r.braid_tension_n? <= 0.0).then_some(0.5 * r.bulged_diameter_mm?)
        });
        let Some(radius) = radius else { return false };
        self.guess_ideal(pressure, terminal);
        guess::shape(
            &self.discretisation,
            &mut self.state,
            terminal,
            Outline::Slack(radius),
        )
    }

    /// The shape of strands alone, where the infinitely long muscle pulls.
    fn guess_net(&mut self, pressure: f64, terminal: f64) -> bool {
        let contraction = -terminal / self.discretisation.half_length();
        let pulls = self
            .expected_pull(pressure, contraction)
            .is_some_and(|force| force > 0.0);
        if !pulls {
            return false;
        }
        self.guess_ideal(pressure, terminal);
        guess::shape(
            &self.discretisation,
            &mut self.state,
            terminal,
            Outline::Net,
        )
    }
}
