//! A model with its memory and options, and what it says on a branch of the hysteresis loop.

use super::ATMOSPHERE_MPA;
use crate::{
    cancel,
    model::{ForceModel, ModelError, Response, Result, ThickWall, Workspace, pivoting_n_per_mm},
    muscle::{Direction, Muscle},
};

/// How questions are answered.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// Answer outside of the model's range, with a warning, instead of refusing.
    pub extrapolate: bool,
    /// Give negative forces where the muscle would have to push, instead of slack.
    pub two_sided: bool,
    /// The branch of the hysteresis loop, for a muscle whose friction is known or estimated.
    pub direction: Direction,
    /// c_f, by which the friction of a muscle that states none is estimated; 0: it is not.
    pub friction_share: f64,
}

impl Options {
    /// The same for a muscle: one that extends pushes, and is not slack where it does.
    #[must_use]
    pub fn for_muscle(self, muscle: &Muscle) -> Self {
        Self {
            two_sided: self.two_sided || muscle.is_extensile(),
            ..self
        }
    }

    /// Also outside of the model's range.
    pub fn extrapolating() -> Self {
        Self {
            extrapolate: true,
            ..Self::default()
        }
    }
}

impl From<Direction> for Options {
    fn from(direction: Direction) -> Self {
        Self {
            direction,
            ..Self::default()
        }
    }
}

/// A model that is evaluated, with the memory in which it works, and how questions are answered. On
/// a branch of the hysteresis loop the friction of the muscle's braid is part of each answer: F =
/// F_model ± (C P^β + μw G).
pub struct Evaluation<'a> {
    /// The model.
    pub model: &'a dyn ForceModel,
    /// Its memory.
    pub workspace: &'a mut Workspace,
    /// How questions are answered.
    pub options: Options,
}

impl<'a> Evaluation<'a> {
    /// A model with its memory, and options or a branch of the hysteresis loop.
    pub fn new(
        model: &'a dyn ForceModel,
        workspace: &'a mut Workspace,
        options: impl Into<Options>,
    ) -> Self {
        Self {
            model,
            workspace,
            options: options.into().for_muscle(model.muscle()),
        }
    }

    /// The same with other options.
    pub fn with(&mut self, options: impl Into<Options>) -> Evaluation<'_> {
        Evaluation::new(self.model, self.workspace, options)
    }

    /// Whether friction is part of the pull: on a branch, where the muscle states it or it is
    /// estimated.
    pub(crate) fn has_friction(&self) -> bool {
        let known = self.options.friction_share > 0.0 || self.model.muscle().friction().is_some();
        known && !self.options.direction.is_mean()
    }

    /// Half the width of the hysteresis loop in N ([`Friction`](crate::muscle::Friction)): C P^β +
    /// μw G, or where the muscle does not state it c_f T cosθ.
    pub fn half_width_n(&mut self, pressure_mpa: f64, contraction: f64) -> Result<f64> {
        if pressure_mpa.is_nan() || pressure_mpa <= 0.0 {
            return Ok(0.0);
        }
        let muscle = self.model.muscle();
        let share = self.options.friction_share;
        match muscle.friction() {
            Some(friction) if friction.lever_mm > 0.0 => {
                let pivoting =
                    pivoting_n_per_mm(self.model, self.workspace, pressure_mpa, contraction)?;
                Ok(friction.half_width_n(pressure_mpa, pivoting))
            }
            Some(friction) => Ok(friction.half_width_n(pressure_mpa, 0.0)),
            None if share > 0.0 => {
                Ok(share
                    * ThickWall::between_ends(muscle).strand_pull_n(pressure_mpa, contraction)?)
            }
            None => Ok(0.0),
        }
    }

    /// What friction adds to the pull, in N.
    pub fn friction_n(&mut self, pressure_mpa: f64, contraction: f64) -> Result<f64> {
        let sign = self.options.direction.sign();
        if sign == 0.0 {
            Ok(0.0)
        } else {
            Ok(sign * self.half_width_n(pressure_mpa, contraction)?)
        }
    }

    /// Everything that the model has at a pressure in MPa and a contraction, and its slopes in both
    /// with those of the friction.
    pub fn response(&mut self, pressure_mpa: f64, contraction: f64) -> Result<Response> {
        /// Of the pressure (relative) and the contraction, for differences of the friction.
        const STEP: f64 = 1e-4;
        self.check_point(pressure_mpa, contraction)?;
        let response = self
            .model
            .response(self.workspace, pressure_mpa, contraction)?
            .finite(&self.model.info().name)?;
        // The point is the given one, to the last bit: a model may compute with 1 − ε.
        let mut response = Response {
            pressure_mpa,
            contraction,
            ..response
        };
        if self.has_friction() && pressure_mpa > 0.0 {
            response.force_n += self.friction_n(pressure_mpa, contraction)?;
            let mut slope = |by_mpa: f64, by: f64| -> Result<f64> {
                let above = self.friction_n(pressure_mpa + by_mpa, contraction + by)?;
                let below = self.friction_n(pressure_mpa - by_mpa, contraction - by)?;
                Ok((above - below) / (2.0 * (by_mpa + by)))
            };
            let by_pressure = slope(STEP * pressure_mpa, 0.0)?;
            response.force_per_pressure_mm2 =
                response.force_per_pressure_mm2.map(|f| f + by_pressure);
            // K = −(1/L0) ∂F/∂ε.
            if let Some(k) = &mut response.stiffness_n_per_mm {
                *k -= slope(0.0, STEP)? / self.model.muscle().length_mm();
            }
        }
        Ok(response)
    }

    /// The pull alone, in N.
    pub fn force_n(&mut self, pressure_mpa: f64, contraction: f64) -> Result<f64> {
        self.check_point(pressure_mpa, contraction)?;
        let force_n = self
            .model
            .force_n(self.workspace, pressure_mpa, contraction)?;
        let force_n = force_n + self.friction_n(pressure_mpa, contraction)?;
        ModelError::finite(force_n, &self.model.info().name, pressure_mpa, contraction)
    }

    /// That the work goes on, and the point is one.
    fn check_point(&self, pressure_mpa: f64, contraction: f64) -> Result<()> {
        cancel::check().map_err(ModelError::Cancelled)?;
        if !(pressure_mpa.is_finite() && contraction.is_finite()) {
            return Err(ModelError::not_finite(
                &self.model.info().name,
                pressure_mpa,
                contraction,
            ));
        }
        if pressure_mpa >= -ATMOSPHERE_MPA {
            return Ok(());
        }
        Err(ModelError::NoEquilibrium(format!(
            "a gauge pressure of {pressure_mpa}\u{a0}MPa lies below vacuum, \
             -{ATMOSPHERE_MPA}\u{a0}MPa"
        )))
    }

    /// K = ∂F/∂L in N/mm of a response: the model's, or by differences of its pull where it does
    /// not state it.
    pub fn stiffness_n_per_mm(&mut self, response: &Response) -> Result<f64> {
        const STEP: f64 = 1e-5;
        if let Some(k) = response.stiffness_n_per_mm {
            return Ok(k);
        }
        let p = response.pressure_mpa;
        let e = response.contraction;
        let length_mm = self.model.muscle().length_mm();
        Ok((self.force_n(p, e - STEP)? - self.force_n(p, e + STEP)?) / (2.0 * STEP * length_mm))
    }

    /// ∂F/∂P in mm² of a response: the model's, or by differences of its pull.
    pub fn force_per_pressure_mm2(&mut self, response: &Response) -> Result<f64> {
        const STEP: f64 = 1e-4;
        if let Some(slope) = response.force_per_pressure_mm2 {
            return Ok(slope);
        }
        let p = response.pressure_mpa;
        let e = response.contraction;
        let low = (p - STEP).max(0.0);
        let high = p + STEP;
        Ok((self.force_n(high, e)? - self.force_n(low, e)?) / (high - low))
    }
}

/// Where an answer comes from: the model's source, and that of the friction.
pub fn source_of(model: &dyn ForceModel, direction: Direction) -> String {
    let source = &model.info().source;
    if direction.is_mean() {
        return source.to_string();
    }
    let friction = match model.muscle().friction() {
        None => "estimated as a share of the strands' axial pull (Tondu 2012)",
        Some(f) if f.lever_mm > 0.0 && f.coefficient > 0.0 => {
            "C·P^β (Tondu 2012) and of the strands' contact"
        }
        Some(f) if f.lever_mm > 0.0 => "of the strands' contact",
        _ => "C·P^β (Tondu 2012)",
    };
    format!(
        "{source}; braid friction {friction}, branch of {}",
        direction.motion()
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{model::Ideal, muscle::Friction};

    #[test]
    fn the_branches_lie_on_both_sides_of_the_mean() {
        let m = Muscle::prototype();
        let friction = Friction::power_law(40.0, 0.7);
        let m = m.with_friction(Some(friction)).unwrap();
        let (model, w) = (Ideal::between_ends(&m), &mut Workspace::new());
        let (p, e, h) = (0.2, 0.1, 1e-6);
        let ideal = model.force_n(w, p, e).unwrap();
        let half = 40.0 * 0.2f64.powf(0.7);
        for direction in Direction::ALL {
            let response = Evaluation::new(&model, w, direction)
                .response(p, e)
                .unwrap();
            let mut force = |p: f64| Evaluation::new(&model, w, direction).force_n(p, e).unwrap();
            assert!((response.force_n - ideal - direction.sign() * half).abs() < 1e-10);
            assert_eq!(force(p), response.force_n);
            let slope = (force(p + h) - force(p - h)) / (2.0 * h);
            assert!((slope / response.force_per_pressure_mm2.unwrap() - 1.0).abs() < 1e-6);
        }
    }

    /// Rigid strands, no rubber to speak of: pc = P, G = (4π/3) P r cotθ; slopes by differences.
    #[test]
    fn friction_from_contact_has_the_half_width_of_an_infinitely_long_muscle() {
        use crate::{
            model::ThickWall,
            muscle::{Braid, BraidStiffness, Rubber, Tube},
            rubber::{Law, NeoHookean},
        };
        let rubber = Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa: 1e-9 }));
        let m = Muscle::prototype();
        let m = m
            .with_tube(Tube {
                rubber,
                ..m.tube().clone()
            })
            .unwrap();
        let braid = Braid {
            stiffness: BraidStiffness::Inextensible,
            ..m.braid().clone()
        };
        let friction = Friction {
            coefficient: 0.0,
            exponent: 0.0,
            lever_mm: 0.7,
            presliding_mm: None,
        };
        let m = m
            .with_braid(braid)
            .unwrap()
            .with_friction(Some(friction))
            .unwrap();
        let (model, w) = (ThickWall::between_ends(&m), &mut Workspace::new());
        for (p, e) in [(0.2, 0.0), (0.3, 0.2)] {
            let cos = (1.0 - e) * 28f64.to_radians().cos();
            let sin = (1.0 - cos * cos).sqrt();
            let r = 15.0 * sin / 28f64.to_radians().sin();
            let half = 0.7 * 4.0 * std::f64::consts::PI / 3.0 * p * r * cos / sin;
            let mut at =
                |p: f64, d: Direction| Evaluation::new(&model, w, d).force_n(p, e).unwrap();
            let loop_n = at(p, Direction::Elongation) - at(p, Direction::Contraction);
            assert!(
                (loop_n / (2.0 * half) - 1.0).abs() < 1e-6,
                "{loop_n} {half}"
            );
            let h = 1e-6;
            let slope =
                (at(p + h, Direction::Contraction) - at(p - h, Direction::Contraction)) / (2.0 * h);
            let response = Evaluation::new(&model, w, Direction::Contraction)
                .response(p, e)
                .unwrap();
            assert!((slope / response.force_per_pressure_mm2.unwrap() - 1.0).abs() < 1e-6);
            // K = −(1/L0) ∂F/∂ε on every branch; that of G is of the order of the muscle's own.
            for d in Direction::ALL {
                let mut at = |e: f64| Evaluation::new(&model, w, d).force_n(p, e).unwrap();
                let k = (at(e - h) - at(e + h)) / (2.0 * h * m.length_mm());
                let response = Evaluation::new(&model, w, d).response(p, e).unwrap();
                assert!(
                    (response.stiffness_n_per_mm.unwrap() / k - 1.0).abs() < 1e-6,
                    "{d:?} {k}"
                );
            }
        }
        assert!(source_of(&model, Direction::Contraction).contains("strands' contact"));
    }
}
