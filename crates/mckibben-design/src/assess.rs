//! What the core says of a muscle: the pull of a built one with its spread, the highest pressure
//! that it may have, and what it is like there.
//!
//! Everything that a design asks of a muscle at a pressure is asked here.

use crate::{Build, Ends, OperatingPoint, Precision, Spec};
use mckibben_core::{
    analysis::{
        Allowed, AnalysisError, Burst, Evaluation, FailureMode, NoBurst, Options, RELIEF, STRETCH,
        bisect, burst::ends::clamp_load_n, burst_below, find_root, root_near,
    },
    built::{Built, HALF_95},
    cancel,
    model::{ForceModel, ModelError, ModelKind, Response, Result, Workspace},
    muscle::{Direction, Muscle},
    rubber::over_time::erf,
};

/// A muscle of a specification with its model, and the thick-wall model for what that does not
/// know.
pub struct Assessed<'a> {
    pub spec: &'a Spec,
    pub muscle: &'a Muscle,
    pub model: Box<dyn ForceModel>,
    pub thick_wall: Box<dyn ForceModel>,
    pub workspace: Workspace,
    /// The pressures at which it fails, as far as they bound its use, with the safety factors of
    /// the specification.
    pub burst: Burst,
    /// The pressure up to which it is used: the least of those of the supply and of the allowed one,
    /// each with room for its valve, and of that which strains its strands to their limit.
    pub highest_mpa: f64,
    /// What keeps it below the supply.
    pub below: Option<Allowed>,
}

/// A pull at a pressure and a contraction.
#[derive(Debug, Clone, Copy)]
pub struct Pull {
    /// Held against what is required: the median of a built muscle, or the model's own pull, N.
    pub held_n: f64,
    /// Median and standard deviation of a built muscle, N, where measured muscles tell them.
    pub spread: Option<(f64, f64)>,
}

impl Pull {
    /// The pull that all but the share below z standard deviations of built muscles reach; where no
    /// z is asked, or the spread is not known, the pull that is held. Of a push that is wanted
    /// `force_n` is below zero.
    pub fn quantile_n(&self, z: Option<f64>, force_n: f64) -> f64 {
        match (z, self.spread) {
            (Some(z), Some((median_n, sd_n))) => median_n - force_n.signum() * z * sd_n,
            _ => self.held_n,
        }
    }
}

/// Φ(z), the share of a normal distribution below z standard deviations.
pub fn normal_share(z: f64) -> f64 {
    0.5 * (1.0 + erf(z * std::f64::consts::FRAC_1_SQRT_2))
}

/// z with Φ(z) = p, within 8 standard deviations.
pub fn normal_deviations(p: f64) -> f64 {
    let (low, high) = bisect(-8.0, 8.0, 60, |z| normal_share(z) < p);
    0.5 * (low + high)
}

/// A pressure is known to this share of the highest.
const TOLERANCE: f64 = 1e-6;
/// Halvings towards the pressure at which strands are strained to their limit.
const HALVINGS: usize = 40;

impl<'a> Assessed<'a> {
    pub fn new(spec: &'a Spec, build: &Build<'_>, muscle: &'a Muscle) -> Result<Self> {
        // Of what is to end, not even the model is made.
        cancel::check()?;
        let model = build(muscle)?;
        let thick_wall = ModelKind::ThickWall.build(muscle)?;
        let safety = spec.limits.safety();
        let factor = safety.strands.max(safety.tube).max(1.0);
        let failures = match burst_below(&*model, RELIEF * spec.max_pressure_mpa, factor) {
            Ok(failures) => failures,
            Err(AnalysisError::Model(error @ ModelError::Cancelled(_))) => return Err(error),
            Err(_) => Burst::unknown(NoBurst::NO_ANSWER),
        };
        let mut assessed = Self {
            spec,
            muscle,
            model,
            thick_wall,
            workspace: Workspace::new(),
            burst: spec.limits.of(failures),
            highest_mpa: spec.supply_share * spec.max_pressure_mpa,
            below: None,
        };
        assessed.keep_allowed();
        Ok(assessed)
    }

    /// Lowers the highest pressure to the allowed one, with room for the relief valve.
    fn keep_allowed(&mut self) {
        if let Some(allowed) = self.burst.allowed()
            && allowed.mpa / RELIEF < self.highest_mpa
        {
            (self.highest_mpa, self.below) = (allowed.mpa / RELIEF, Some(allowed));
        }
    }

    /// Lowers it so that the strands are strained by no more than their limit, not shortened and at
    /// operating points.
    pub fn keep_strands(&mut self, points: &[OperatingPoint]) -> Result<()> {
        let Some(bound) = self.spec.limits.strand_strain else {
            return Ok(());
        };
        let contractions = points.iter().map(|q| q.contraction);
        for contraction in std::iter::once(0.0).chain(contractions) {
            let high_mpa = self.highest_mpa;
            let mut bears = |p: f64| match self.strand_strain(p, contraction) {
                Ok(strain) => Ok(strain.is_none_or(|strain| strain <= bound)),
                // Where they stretch further there is no answer at all.
                Err(ModelError::Overstretched { .. } | ModelError::NoEquilibrium(_)) => Ok(false),
                Err(error) => Err(error),
            };
            if bears(high_mpa)? {
                continue;
            }
            let (mpa, _) = bisect(0.0, high_mpa, HALVINGS, |p| bears(p).unwrap_or_default());
            let below = Allowed {
                mpa,
                by: FailureMode::StrandStrain,
                factor: 1.0,
            };
            (self.highest_mpa, self.below) = (mpa, Some(below));
        }
        Ok(())
    }

    /// The strain of the strands, where it is known.
    pub fn strand_strain(&mut self, p: f64, contraction: f64) -> Result<Option<f64>> {
        Ok(self
            .full_response(p, contraction)?
            .braid_tension_n
            .and_then(|tension_n| self.muscle.strand_strain(tension_n)))
    }

    /// Its model, ready for questions.
    pub fn evaluation(&mut self) -> Evaluation<'_> {
        Evaluation::new(&*self.model, &mut self.workspace, self.spec.options())
    }

    /// The answer of its model; where that has none, of the thick-wall model.
    pub fn either<T, E>(&mut self, ask: impl Fn(&mut Evaluation<'_>) -> Result<T, E>) -> Option<T> {
        let options = self.spec.options();
        [&self.model, &self.thick_wall]
            .into_iter()
            .find_map(|model| {
                ask(&mut Evaluation::new(&**model, &mut self.workspace, options)).ok()
            })
    }

    /// What a muscle that is built pulls, with its interval, where the model's error is known.
    pub fn predicted(&mut self, p: f64, contraction: f64) -> Option<Built> {
        let two_sided = Options {
            two_sided: true,
            ..self.spec.options()
        };
        let mut model = self.evaluation();
        let mut model = model.with(two_sided);
        let force_n = model.force_n(p, contraction).ok()?;
        Some(model.predicted(p, contraction, force_n)?.0)
    }

    pub fn pull(&mut self, p: f64, contraction: f64) -> Result<Pull> {
        let built = self.predicted(p, contraction);
        let held_n = match built {
            Some(built) if self.spec.built => built.predicted_n,
            None if self.spec.built => return Err(ModelError::not_converged(p, contraction)),
            _ => self.evaluation().force_n(p, contraction)?,
        };
        Ok(Pull {
            held_n,
            spread: built.map(|b| (b.predicted_n, b.half_n() / HALF_95)),
        })
    }

    /// The pressure in MPa below which a share of all muscles meets every point of one.
    pub fn needed_mpa(&mut self, wanted: &[OperatingPoint], share: f64) -> Option<f64> {
        let z = Some(normal_deviations(share));
        let mut needs = wanted.iter().map(|q| self.need_mpa(q, z).ok());
        needs.try_fold(0.0, |most: f64, mpa| Some(most.max(mpa?)))
    }

    /// The ends that bear a proof test at a pressure in MPa.
    pub fn proved_ends(&mut self, proof_mpa: f64) -> Option<Ends> {
        let ends = self.spec.ends?;
        let lengthening = Options {
            direction: Direction::Elongation,
            ..self.spec.options()
        };
        let mut model = self.evaluation();
        let point = model.with(lengthening).point(proof_mpa, -STRETCH).ok()?;
        let pulls_n = match point.built {
            Some(built) => [built.predicted_n, built.predicted_high_n],
            None => [point.response.force_n; 2],
        };
        let load_n = |n: f64| clamp_load_n(self.muscle, n.max(0.0), proof_mpa);
        ends(self.muscle, pulls_n.map(load_n), Precision::Exact)
    }

    /// Refuses a point outside of the model's range.
    pub fn check_range(&self, p: f64, contraction: f64) -> Result<()> {
        let info = self.model.info();
        match self.spec.extrapolate {
            true => Ok(()),
            false => info.range.check(&info.name, p, contraction),
        }
    }

    /// The share of the pull of a point that a quantile misses at a pressure.
    fn missed(&mut self, p: f64, point: &OperatingPoint, z: Option<f64>) -> Result<f64> {
        let pull = self.pull(p, point.contraction)?;
        Ok(1.0 - pull.quantile_n(z, point.force_n) / point.force_n)
    }

    /// The pressure at which a quantile of the pull is what is required, up to the highest; the
    /// highest where it is not reached.
    pub fn need_mpa(&mut self, point: &OperatingPoint, z: Option<f64>) -> Result<f64> {
        /// Where the search of a quantile above the model's own pull begins.
        const LEAST: f64 = 0.05;
        let own_mpa = self.own_mpa(point)?;
        if z.is_none() && !self.spec.built {
            return Ok(own_mpa);
        }
        let max_mpa = self.highest_mpa;
        let tolerance = TOLERANCE * max_mpa;
        let is_met = self.missed(own_mpa, point, z)? <= 0.0;
        let (low, high) = match is_met {
            true => (LEAST * own_mpa, own_mpa),
            false => (own_mpa, max_mpa),
        };
        let root = find_root(|p| self.missed(p, point, z), low, high, tolerance)?;
        let end = if is_met { low } else { high };
        Ok(root.map_or(end, |p| (p + tolerance).min(max_mpa)))
    }

    /// The same where nothing bounds the pressure; `None` where no pressure does.
    pub fn need_beyond(&mut self, point: &OperatingPoint, z: Option<f64>) -> Option<f64> {
        const REACH: f64 = 30.0;
        let from_mpa = self.highest_mpa;
        let missed = |p| self.missed(p, point, z).ok();
        root_near(missed, (from_mpa, -1.0 / from_mpa, REACH * from_mpa))
    }

    /// The pressure at which the model's own pull is what is required, or the highest.
    fn own_mpa(&mut self, point: &OperatingPoint) -> Result<f64> {
        let (force_n, contraction) = (point.force_n, point.contraction);
        let max_mpa = self.highest_mpa;
        let mut model = self.evaluation();
        if let Some(p) = model.pressure_below(force_n, contraction, max_mpa) {
            return Ok(p);
        }
        match model.pressure_at(force_n, contraction) {
            Ok(p) => Ok(p.min(max_mpa)),
            Err(AnalysisError::Model(error)) => Err(error),
            // At the lowest pressure of its range the model already pulls more.
            Err(AnalysisError::NoPressure {
                nearest_force_n,
                nearest_pressure_mpa,
                ..
            }) if nearest_force_n / force_n >= 1.0 => Ok(nearest_pressure_mpa),
            Err(_) => Ok(max_mpa),
        }
    }

    /// A response with what the model does not know filled in from the thick-wall model.
    pub fn full_response(&mut self, p: f64, contraction: f64) -> Result<Response> {
        cancel::check()?;
        let own = self.model.response(&mut self.workspace, p, contraction)?;
        let known = [own.bulged_diameter_mm, own.volume_mm3, own.max_stretch];
        if known.iter().all(Option::is_some) {
            return Ok(own);
        }
        let other = self
            .thick_wall
            .response(&mut self.workspace, p, contraction);
        Ok(match other {
            Ok(other) => Response {
                bulged_diameter_mm: own.bulged_diameter_mm.or(other.bulged_diameter_mm),
                volume_mm3: own.volume_mm3.or(other.volume_mm3),
                max_stretch: own.max_stretch.or(other.max_stretch),
                middle_stretch: own.middle_stretch.or(other.middle_stretch),
                braid_tension_n: own.braid_tension_n.or(other.braid_tension_n),
                strand_tension_n: own.strand_tension_n.or(other.strand_tension_n),
                stiffness_n_per_mm: own.stiffness_n_per_mm.or(other.stiffness_n_per_mm),
                ..own
            },
            Err(_) => own,
        })
    }

    /// What is pushed in from rest to a pressure and contraction, normal litres of air or mm³ of
    /// liquid.
    pub fn stroke(&mut self, p: f64, contraction: f64) -> Option<f64> {
        let liquid = self.spec.liquid.as_ref();
        self.either(|model| match liquid {
            Some(supply) => model.liquid_per_stroke_mm3(supply, p, contraction),
            None => Ok(model.air_per_stroke(p, contraction)?.normal_litres),
        })
    }
}
