//! What is wanted, and what may be varied.

use crate::{
    Demand, LARGEST_BUNDLE, Limits, OperatingPoint, TubePart,
    tubes::{self, CAST_RUBBER},
};
use mckibben_core::{
    analysis::{LEAST_SAFETY, Options, PROVED, bisect},
    cancel::Cancelled,
    liquid::LiquidSupply,
    muscle::{Braid, BraidStiffness, Direction, Muscle, MuscleError, Rubber},
    rubber::over_time::erf,
    sleeve::{self, SleeveEntry},
    units::Values,
};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// What is ranked first.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, schemars::JsonSchema,
)]
#[schemars(rename = "ObjectiveWord")]
#[serde(rename_all = "kebab-case")]
pub enum Objective {
    /// Smallest outer diameter at rest.
    Diameter,
    /// Lowest pressure needed.
    Pressure,
    /// Least air per stroke; with a liquid, least liquid volume.
    Air,
    /// Most pull to spare at the maximum pressure.
    Margin,
    /// Smallest outer diameter at the operating points; where the length is searched the least
    /// space. Of muscles that are about equal the one that can be relied on.
    #[default]
    BulgedDiameter,
    /// Shortest between the terminals at rest.
    Length,
}

/// Which angle the braid has.
#[derive(Debug, Clone, PartialEq)]
pub enum BraidChoice {
    /// Angles at rest in degrees: a list or an interval.
    Angle(Values),
    /// A sleeve as sold: the length of strand per turn in mm is fixed, so that the diameter it is
    /// pulled over sets the angle, sinθ0 = π D0/ℓ.
    StrandLengthPerTurn(Vec<f64>),
    /// Named sleeves: each braid lies on a tube as its sleeve does there ([`Braid::on_diameter`]).
    Sleeves(Vec<Braid>),
}

#[derive(Debug, Clone)]
pub struct Spec {
    /// What the muscle must do.
    pub wanted: Demand,
    /// Muscles side by side that share the requirement; `wanted` is that of one.
    pub count: u32,
    /// Up to so many side by side may take the place of one; 1 where the number is stated.
    pub most_side_by_side: u32,
    /// Distance in mm between the axes of neighbours; that of the largest envelope, or the bulged
    /// diameter, where there is none.
    pub pitch_mm: Option<f64>,
    /// Whether it is met by what a muscle that is built pulls, by the median; else by the model's own
    /// pull on the branch.
    pub built: bool,
    /// The branch on which it must pull, where its friction is stated or estimated.
    pub direction: Direction,
    /// What the supply gives, in MPa.
    pub max_pressure_mpa: f64,
    /// The share of it that is set at most, so that a regulator can hold it.
    pub supply_share: f64,
    /// Liquid that fills the muscle; air where there is none.
    pub liquid: Option<LiquidSupply>,
    /// Everything that is not searched: length, braid stiffness, terminals, friction.
    pub base: Muscle,
    /// Tubes as sold or cast, each with its diameters and rubber; none: diameters, walls and
    /// rubbers are searched.
    pub tubes: Vec<TubePart>,
    /// Outer diameters in mm.
    pub outer_diameter_mm: Values,
    /// Walls in mm.
    pub wall_mm: Values,
    /// Lengths between the terminals in mm; the base muscle's where there are none.
    pub length_mm: Option<Values>,
    /// Least length over the outer diameter, where the length is searched freely.
    pub least_slenderness: f64,
    /// Braid angles, or sleeves.
    pub braid: BraidChoice,
    /// Rubbers; empty means the base muscle's.
    pub rubbers: Vec<Rubber>,
    /// Bounds on what comes out.
    pub limits: Limits,
    /// Share of muscles, from 0.5 to 0.999, that meet the requirement by the ±: 0.95 asks it of the
    /// lower end of the ±. None: of the pull itself.
    pub guaranteed: Option<f64>,
    /// Quantity to rank by.
    pub objective: Objective,
    /// How many candidates and rejected muscles to report.
    pub top: usize,
    /// Ask the model outside of its range.
    pub extrapolate: bool,
}

/// The share of the supply's pressure that is set at most: a regulator varies by 2 to 5 %.
pub const SUPPLY_SHARE: f64 = 0.95;

/// z with erf(z/√2) = p, by bisection: p from 0.5 to 0.999.
fn deviations(p: f64) -> f64 {
    let (low, high) = bisect(0.0, 4.0, 60, |z| {
        erf(z * std::f64::consts::FRAC_1_SQRT_2) < p
    });
    0.5 * (low + high)
}

impl Spec {
    /// A specification of points and a supply: the prototype's length, braid and rubber, diameters
    /// from 5 to 80 mm and walls from 0.5 to 10 mm, the limits of [`Limits::safe`], the smallest
    /// diameter the best, five candidates. Everything else is a field to be set.
    pub fn new(points: Vec<OperatingPoint>, max_pressure_mpa: f64) -> Self {
        let base = Muscle::prototype();
        Self {
            wanted: points.into(),
            count: 1,
            most_side_by_side: 1,
            pitch_mm: None,
            built: true,
            direction: Direction::Contraction,
            max_pressure_mpa,
            supply_share: SUPPLY_SHARE,
            liquid: None,
            tubes: vec![],
            outer_diameter_mm: Values::Interval(5.0, 80.0),
            wall_mm: Values::Interval(0.5, 10.0),
            braid: BraidChoice::Angle(Values::List(vec![base.braid().angle_deg])),
            base,
            length_mm: None,
            least_slenderness: 0.0,
            rubbers: vec![],
            limits: Limits::safe(),
            guaranteed: None,
            objective: Objective::default(),
            top: 5,
            extrapolate: false,
        }
    }

    /// A pull in N at a contraction with a supply in MPa, and the rest as of [`Spec::new`].
    pub fn pull(force_n: f64, contraction: f64, max_pressure_mpa: f64) -> Self {
        let point = OperatingPoint {
            force_n,
            contraction,
        };
        Self::new(vec![point], max_pressure_mpa)
    }

    /// The same with one length between the terminals in mm.
    #[must_use]
    pub fn length_mm(mut self, length_mm: f64) -> Self {
        self.length_mm = Some(Values::List(vec![length_mm]));
        self
    }

    /// The same with lower and upper end of the outer diameter in mm.
    #[must_use]
    pub fn outer_diameter_mm(mut self, low_mm: f64, high_mm: f64) -> Self {
        self.outer_diameter_mm = Values::Interval(low_mm, high_mm);
        self
    }

    /// The same of what one buys or casts: the tubes of the catalogue and those cast of
    /// [`CAST_RUBBER`], every sleeve of the library, and up to [`LARGEST_BUNDLE`] muscles side by
    /// side in place of one.
    ///
    /// # Errors
    /// [`SpecError::Refused`] where a built-in table cannot be read.
    pub fn of_parts(mut self) -> Result<Self, SpecError> {
        let usual =
            |tube: &&TubePart| !tube.is_cast || tube.rubber.name.as_deref() == Some(CAST_RUBBER);
        let tubes = tubes::catalogue().map_err(|e| SpecError::Refused(e.to_string()))?;
        self.tubes = tubes.iter().filter(usual).cloned().collect();
        let sleeves = sleeve::library::entries().map_err(|e| SpecError::Refused(e.message))?;
        // Each on the least tube that it fits; the search lays it on others.
        let on_least = |entry: &SleeveEntry| entry.sleeve.on(entry.sleeve.diameters().0);
        let braids: Result<_, _> = sleeves.iter().map(on_least).collect();
        self.braid = BraidChoice::Sleeves(braids.map_err(SpecError::NoMuscle)?);
        self.most_side_by_side = LARGEST_BUNDLE;
        Ok(self)
    }

    /// The same, with a pull that is guaranteed.
    pub(crate) fn to_be_sure(&self) -> Self {
        Self {
            guaranteed: Some(0.95),
            top: 1,
            ..self.clone()
        }
    }

    /// Whether one muscle must do, and no bundle is tried in its place.
    pub(crate) fn is_alone(&self) -> bool {
        self.count == 1 && self.most_side_by_side <= 1
    }

    /// The same for one of so many muscles that share what is required, and the liquid.
    #[must_use]
    pub fn shared_by(&self, count: u32) -> Self {
        let share = 1.0 / f64::from(count);
        let mut shared = Self {
            wanted: self.wanted.times(share),
            count: self.count * count,
            ..self.clone()
        };
        if let Some(volume_mm3) = &mut shared.limits.liquid_volume_mm3 {
            *volume_mm3 /= f64::from(count);
        }
        shared
    }

    /// Whether the braid is the paper's, whose stiffness follows from the diameter.
    pub fn has_paper_braid(&self) -> bool {
        !matches!(self.braid, BraidChoice::Sleeves(_))
            && self.base.braid().stiffness == BraidStiffness::Paper
    }

    /// How its models are evaluated: with the friction that is stated or estimated, on the branch
    /// that is wanted.
    pub fn options(&self) -> Options {
        let friction_share = if self.wanted.extends() {
            0.0
        } else {
            self.base.friction_share()
        };
        let known = friction_share > 0.0 || self.base.friction().is_some();
        Options {
            extrapolate: self.extrapolate,
            direction: if known {
                self.direction
            } else {
                Direction::Mean
            },
            friction_share,
            ..Options::default()
        }
    }

    /// What it asks of a muscle, without what muscles are chosen among: a copy of it is small.
    pub(super) fn without_parts(&self) -> Self {
        Self {
            tubes: vec![],
            rubbers: vec![],
            braid: BraidChoice::Sleeves(vec![]),
            ..self.clone()
        }
    }

    /// Half-widths of the pull that it must hold against: 1 for 95 %, none where the pull itself is
    /// meant.
    ///
    /// A share p of normal deviations lies within z(p) standard ones, and the ± is z(0.95) of them.
    pub(super) fn half_widths(&self) -> Option<f64> {
        Some(deviations(self.guaranteed?) / deviations(0.95))
    }

    /// The operating points of a muscle of the search.
    pub(super) fn points(&self, muscle: &Muscle) -> std::borrow::Cow<'_, [OperatingPoint]> {
        self.wanted.points(muscle.length_mm())
    }

    pub fn check(&self) -> Result<(), SpecError> {
        let lengths = match &self.length_mm {
            Some(Values::List(list)) => list.clone(),
            // The longest has most to give.
            Some(Values::Interval(_, high)) => vec![*high],
            None => vec![self.base.length_mm()],
        };
        lengths
            .iter()
            .try_for_each(|length| self.wanted.check(*length))?;
        if !(self.max_pressure_mpa.is_finite() && self.max_pressure_mpa > 0.0) {
            return Err(SpecError::Refused(format!(
                "the maximum pressure is {}\u{a0}MPa; it must be above zero",
                self.max_pressure_mpa
            )));
        }
        let sizes = [
            ("the outer diameter", Some(self.outer_diameter_mm.bounds())),
            ("the wall", Some(self.wall_mm.bounds())),
            ("the length", self.length_mm.as_ref().map(Values::bounds)),
            ("`top`", Some((self.top as f64, self.top as f64))),
        ];
        let limits = self.limits.positive().into_iter();
        let limits = limits.map(|(name, value)| (name, value.map(|v| (v, v))));
        for (name, bounds) in sizes.into_iter().chain(limits) {
            let sound = |(low, high): (f64, f64)| low > 0.0 && low <= high && high.is_finite();
            if let Some((low, high)) = bounds.filter(|ends| !sound(*ends)) {
                let value = if low == high || low.is_nan() {
                    low.to_string()
                } else {
                    format!("{low} to {high}")
                };
                return Err(SpecError::Refused(format!(
                    "{name} is {value}; it must be above zero, the smaller end first"
                )));
            }
        }
        let factors = [
            ("the safety factor", self.limits.burst_margin, LEAST_SAFETY),
            (
                "the safety factor of the tube",
                self.limits.tube_margin,
                PROVED,
            ),
        ];
        for (name, factor, least) in factors {
            if let Some(factor) = factor.filter(|factor| *factor < least) {
                return Err(SpecError::Refused(format!(
                    "{name} is {factor}; give {least} or more, so that the muscle can be tested \
                     above the pressure that is set, or 0 to leave failures out"
                )));
            }
        }
        if let (Some(volume_mm3), None) = (self.limits.liquid_volume_mm3, &self.liquid) {
            return Err(SpecError::NoLiquid(volume_mm3 * f64::from(self.count)));
        }
        let count = |v: &Values| match v {
            Values::List(list) => list.len() as f64,
            Values::Interval(..) => 1.0,
        };
        let braids = match &self.braid {
            BraidChoice::Angle(v) => count(v),
            BraidChoice::StrandLengthPerTurn(list) => list.len() as f64,
            BraidChoice::Sleeves(list) => list.len() as f64,
        };
        if braids == 0.0 {
            return Err(SpecError::Refused(
                "the list of braids is empty: give one angle or sleeve at least".into(),
            ));
        }
        let sections = count(&self.outer_diameter_mm) * count(&self.wall_mm);
        let lengths = self.length_mm.as_ref().map_or(1.0, count);
        let all = sections * lengths * braids * self.rubbers.len().max(1) as f64;
        if all > 5e6 {
            return Err(SpecError::Refused(format!(
                "{all:.3e} combinations are too many; at most 5 million: take larger steps or \
                 fewer values"
            )));
        }
        Ok(())
    }
}

/// Why a specification cannot be searched at all.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SpecError {
    /// Refused: field, value, what it must be.
    #[error("{0}")]
    Refused(String),
    /// A largest liquid volume without a liquid.
    #[error(
        "`max_liquid_volume_mm3` is {0} mm³, and the muscle is filled with air: give `liquid`, or \
         leave `max_liquid_volume_mm3` out"
    )]
    NoLiquid(f64),
    /// No combination is a muscle at all.
    #[error("none of the combinations is a muscle: {0}")]
    NoMuscle(MuscleError),
    /// The caller wanted the search to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
