//! Chosen constants of a measured muscle by least squares of its pulls, without a prior.
//!
//! Any parameter of [`Target`] is free. Standard errors are those of linearised least squares
//! (Seber & Wild 2003 \[seber2003\], ch. 2). A parameter is identifiable where the half-width of its
//! 95 % interval is below its limit and it lies on no bound.

use crate::Result;
use mckibben_core::{
    built::{Experience, Prior},
    muscle::{Constant, Muscle},
};
use mckibben_fit::{
    identify::{
        Build, Found, IdentificationRequest, Pulls, Target, left_over, pulls_and_slack, start,
        target_and_numbers, written_bench,
    },
    least_squares::Unknown,
    measured::DataPoint,
};

/// A limit (I1 − 3, or a stretch) of so much is never felt: Gent's law and that of Arruda and Boyce
/// are then neo-Hookean.
const NO_LOCK: f64 = 1000.0;

/// A free parameter, with its start and bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    pub target: Target,
    /// Where the search begins; the value of the muscle where `None`.
    pub start: Option<f64>,
    /// Lowest and highest value; the natural ones where `None`.
    pub bounds: Option<(f64, f64)>,
}

impl Parameter {
    /// A free parameter that starts from the value of the muscle.
    pub fn free(target: Target) -> Self {
        Self {
            target,
            start: None,
            bounds: None,
        }
    }

    /// `name`, `name=start` or `name=start:low:high`, quantities with a unit if you like.
    pub fn parse(text: &str, muscle: &Muscle) -> Result<Self> {
        let (target, numbers) = target_and_numbers(text, muscle)?;
        let (start, bounds) = match *numbers.as_slice() {
            [] => (None, None),
            [start] => (Some(start), None),
            [start, low, high] if low < high && (low..=high).contains(&start) => {
                (Some(start), Some((low, high)))
            }
            _ => {
                return Err(format!(
                    "`{text}` is not of the form name, name=start or name=start:low:high, where \
                     start must lie between low and high"
                )
                .into());
            }
        };
        Ok(Self {
            target,
            start,
            bounds,
        })
    }

    /// What a muscle can have at all.
    fn natural_bounds(&self, muscle: &Muscle) -> (f64, f64) {
        let law = &muscle.tube().rubber.law;
        let of_law = match self.target {
            Target::Law(i) => law.constants().into_iter().nth(i),
            _ => None,
        };
        match of_law {
            Some(c) if law.locks_at().is_some() && !c.constant.is_modulus() => {
                (c.constant.bounds.0, c.value.max(NO_LOCK))
            }
            Some(c) => c.constant.bounds,
            None => match self.target.identify() {
                Some(identify) => identify.bounds(muscle),
                None => (0.0, f64::INFINITY),
            },
        }
    }
}

/// Constants of a muscle that are sought.
#[derive(Clone, Copy)]
pub struct ChosenFit<'a> {
    /// The muscle, with a value for everything that is not free.
    pub muscle: &'a Muscle,
    pub free: &'a [Parameter],
    pub points: &'a [DataPoint],
    pub build: &'a Build<'a>,
    /// Whether forces of zero and below are measurements: by default the muscle was slack there.
    pub two_sided: bool,
}

impl<'a> ChosenFit<'a> {
    /// The usual fit: forces above zero.
    pub fn new(
        muscle: &'a Muscle,
        free: &'a [Parameter],
        points: &'a [DataPoint],
        build: &'a Build<'a>,
    ) -> Self {
        Self {
            muscle,
            free,
            points,
            build,
            two_sided: false,
        }
    }

    fn request(&self) -> IdentificationRequest<'a> {
        IdentificationRequest {
            two_sided: self.two_sided,
            ..IdentificationRequest::new(self.muscle, &[], self.points, self.build)
        }
    }

    fn unknown(&self, free: &Parameter) -> Result<Unknown> {
        let value = free
            .start
            .or_else(|| start(free.target, self.muscle, self.points));
        let start = value.ok_or_else(|| {
            let name = free.target.name(self.muscle);
            format!("{name} has no value to begin with in this muscle: write {name}=START")
        })?;
        let bounds = free
            .bounds
            .unwrap_or_else(|| free.natural_bounds(self.muscle));
        Ok(Unknown {
            start,
            low: bounds.0,
            high: bounds.1,
            scale: free.target.scale(self.muscle, start),
        })
    }

    /// c_f of the friction that is estimated: that of points of one branch alone, which do not tell
    /// it.
    fn friction_share(&self) -> f64 {
        let muscle = self.muscle;
        let one = self.points.first().and_then(|p| p.at.branch);
        let of_one =
            one.is_some_and(|one| !one.is_mean()) && self.points.iter().all(|p| p.at.branch == one);
        let known = self.free.iter().any(|p| p.target.is_of_friction());
        if of_one && !known && muscle.friction().is_none() && !muscle.is_extensile() {
            muscle.friction_share()
        } else {
            0.0
        }
    }

    /// The constants with which the model comes closest to the points.
    ///
    /// # Errors
    /// Points that do not tell them.
    pub fn found(&self) -> Result<Found> {
        let unknowns = self.free.iter().map(|free| self.unknown(free));
        let unknowns = unknowns.collect::<Result<Vec<Unknown>>>()?;
        let start: Vec<f64> = unknowns.iter().map(|u| u.start).collect();
        let targets: Vec<Target> = self.free.iter().map(|p| p.target).collect();
        let request = self.request();
        let (counted, _) = pulls_and_slack(&request);
        let fit = |points| Pulls {
            friction_share: self.friction_share(),
            ..Pulls::new(&request, self.muscle, &targets, points)
        };
        // Points without an answer at the start are left out.
        let rows = fit(&counted).rows(&start).ok_or("no model at the start")?;
        let answered = counted.iter().zip(rows).filter(|row| row.1.is_ok());
        let points: Vec<DataPoint> = answered.map(|row| *row.0).collect();
        let weights: Vec<f64> = points.iter().map(|p| p.weight).collect();
        let found = fit(&points).found(&unknowns, &weights);
        found.ok_or_else(|| "no minimum was found".into())
    }

    /// The muscle that was found, with its bench: what points tell beside its constants.
    pub fn with_bench(&self, found: &Found) -> Muscle {
        let prior = Prior::of(&found.muscle, Experience::built_in());
        let mut kept = [0.0; Constant::ALL.len()];
        kept[Constant::Friction as usize] = prior.centre[Constant::Friction as usize];
        let points: Vec<DataPoint> = found.left.iter().map(|p| p.0).collect();
        let left = left_over(&self.request(), &found.muscle, &points, &kept);
        let bench = left.ok().flatten().and_then(|left| {
            let model = (self.build)(&found.muscle).ok()?.info().name.to_string();
            written_bench(&found.muscle, &left, model, false)
        });
        match bench {
            Some(bench) => found.muscle.clone().with_bench(bench),
            None => found.muscle.clone(),
        }
    }
}
