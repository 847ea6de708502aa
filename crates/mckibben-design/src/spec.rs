//! What is wanted, and what may be varied.

use crate::{
    Demand, Limits, OperatingPoint, TubePart,
    assess::normal_deviations,
    bundle::MOST,
    held::Precision,
    tubes::{self, CAST_RUBBER},
};
use mckibben_core::{
    analysis::{LEAST_SAFETY, Options, PROVED},
    cancel::Cancelled,
    extremes::peak,
    liquid::LiquidSupply,
    muscle::{Braid, Direction, EndsMade, Muscle, MuscleError, Rubber},
    sleeve::{self, SleeveEntry},
    units::{
        Values, tidy,
        typed::{Pressure, Ratio},
    },
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
    /// Best chance at the maximum pressure.
    Chance,
    /// Smallest outer diameter at the operating points, ends included; where the length is searched
    /// the least space. Of muscles that are about equal the one with the best chance.
    #[default]
    BulgedDiameter,
    /// Shortest between the terminals at rest.
    Length,
    /// Least mass with the ends.
    Mass,
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

/// What is wanted of a muscle, what may be varied, and within which bounds: begun by [`Spec::pull`]
/// or [`Spec::new`], the rest are fields to be set.
#[derive(Debug, Clone)]
pub struct Spec {
    /// What all muscles together must do.
    pub wanted: Demand,
    /// Muscles side by side that share it, at least.
    pub count: u32,
    /// At most so many side by side; `count` where the number is stated.
    pub most_side_by_side: u32,
    /// The ends of a muscle; without them only tubes and sleeves have width and mass.
    pub ends: Option<EndsOf>,
    /// Muscles as sold that are held against it as well.
    pub products: Vec<Product>,
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
    /// Longer ones that are looked at where no single muscle of those does.
    pub longer_mm: Vec<f64>,
    /// Least length over the outer diameter, where the length is searched freely.
    pub least_slenderness: f64,
    /// Braid angles, or sleeves.
    pub braid: BraidChoice,
    /// Rubbers; empty means the base muscle's.
    pub rubbers: Vec<Rubber>,
    /// Bounds on what comes out.
    pub limits: Limits,
    /// The chance with which a built muscle must meet every point at some pressure that is allowed,
    /// from 0.5 to 0.999. None: the pull itself must.
    pub certainty: Option<f64>,
    /// Quantity to rank by.
    pub objective: Objective,
    /// How many candidates and rejected muscles to report.
    pub top: usize,
    /// Ask the model outside of its range.
    pub extrapolate: bool,
}

/// The share of the supply's pressure that is set at most: a regulator varies by 2 to 5 %.
pub const SUPPLY_SHARE: f64 = 0.95;

/// The chance with which a muscle must do what it is taken for.
pub const CERTAINTY: f64 = 0.9;

/// Muscles side by side in place of one, at most.
pub const LARGEST_BUNDLE: u32 = 7;

/// The ends of a muscle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "CandidateEnds")]
pub struct Ends {
    /// How they hold tube and sleeve.
    #[serde(rename = "ends")]
    pub made: EndsMade,
    /// Load of each in the proof test, N: the pull, and the pressure on the bore.
    #[serde(rename = "proof_end_load_n")]
    pub load_n: f64,
    /// Largest diameter of plugs and clamps, mm.
    #[serde(rename = "end_diameter_mm")]
    pub width_mm: f64,
    /// Mass of both plugs, g.
    #[serde(rename = "ends_mass_g")]
    pub mass_g: f64,
}

impl Ends {
    /// Of muscles whose ends are not known.
    pub const NONE: Self = Self {
        made: EndsMade::Tied,
        load_n: 0.0,
        width_mm: 0.0,
        mass_g: 0.0,
    };
}

/// The ends of a muscle for a load in N of each in the proof test, and the most that it may be as
/// built, on demand without their mass, which takes long; `None` where its length on the plugs holds
/// none.
pub type EndsOf = fn(&Muscle, [f64; 2], Precision) -> Option<Ends>;

/// A muscle as sold.
#[derive(Debug, Clone)]
pub struct Product {
    /// What its seller calls it, with its name in the library.
    pub name: String,
    /// The muscle, with the bench on which it was measured.
    pub muscle: Muscle,
}

impl Spec {
    /// A specification of points and a supply: the prototype's length, braid and rubber, diameters
    /// from 5 to 80 mm and walls from 0.5 to 10 mm, the limits of [`Limits::safe`], the smallest
    /// diameter the best, five candidates. Everything else is a field to be set.
    pub fn new(points: Vec<OperatingPoint>, max_pressure_mpa: f64) -> Self {
        let base = Muscle::prototype();
        Self {
            wanted: Demand::Points { points },
            count: 1,
            most_side_by_side: 1,
            ends: None,
            products: vec![],
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
            longer_mm: vec![],
            least_slenderness: 0.0,
            rubbers: vec![],
            limits: Limits::safe(),
            certainty: Some(CERTAINTY),
            objective: Objective::default(),
            top: 5,
            extrapolate: false,
        }
    }

    /// A pull in N at a contraction with a supply, and the rest as of [`Spec::new`].
    pub fn pull(force_n: f64, contraction: Ratio, most: Pressure) -> Self {
        Self::new(
            vec![OperatingPoint {
                force_n,
                contraction: contraction.0,
            }],
            most.0,
        )
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
        self.tubes = tubes::catalogue()
            .map_err(|e| SpecError::Refused("", e.to_string()))?
            .iter()
            .filter(usual)
            .cloned()
            .collect();
        let sleeves = sleeve::library::entries().map_err(|e| SpecError::Refused("", e.message))?;
        // Each on the least tube that it fits; the search lays it on others.
        let on_least = |entry: &SleeveEntry| entry.sleeve.on(entry.sleeve.diameters().0);
        let braids: Result<_, _> = sleeves.iter().map(on_least).collect();
        self.braid = BraidChoice::Sleeves(braids.map_err(SpecError::NoMuscle)?);
        self.most_side_by_side = LARGEST_BUNDLE;
        Ok(self)
    }

    /// So many side by side, within those that may be.
    pub(crate) fn count_of(&self, needed: f64) -> u32 {
        needed.clamp(
            f64::from(self.count),
            f64::from(self.most_side_by_side.max(self.count)),
        ) as u32
    }

    /// z of the chance that is required.
    pub fn deviations(&self) -> Option<f64> {
        self.certainty.map(normal_deviations)
    }

    /// How its models are evaluated: with the friction that is stated or estimated, on the branch
    /// that is wanted.
    #[doc(hidden)]
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

    /// Checks that it can be searched, and that a braid may do it.
    ///
    /// # Errors
    /// [`SpecError`] with the field, its value, and what it must be.
    pub fn check(&self) -> Result<(), SpecError> {
        let mut lengths = match &self.length_mm {
            Some(Values::List(list)) => list.clone(),
            // The longest has most to give.
            Some(Values::Interval(_, high)) => vec![*high],
            None => vec![self.base.length_mm()],
        };
        lengths.extend(self.longer_mm.last());
        for length_mm in &lengths {
            self.wanted.check(*length_mm)?;
        }
        self.check_numbers()?;
        if let (Some(volume_mm3), None) = (self.limits.liquid_volume_mm3, &self.liquid) {
            return Err(SpecError::NoLiquid(volume_mm3));
        }
        let count = |values: &Values| match values {
            Values::List(list) => list.len(),
            Values::Interval(..) => 1,
        };
        let braids = match &self.braid {
            BraidChoice::Angle(angles) => count(angles),
            BraidChoice::StrandLengthPerTurn(list) => list.len(),
            BraidChoice::Sleeves(list) => list.len(),
        };
        if braids == 0 {
            return refused(
                "braid",
                "the list of braids is empty: give one angle or sleeve",
            );
        }
        let axes = [
            count(&self.outer_diameter_mm),
            count(&self.wall_mm),
            self.length_mm.as_ref().map_or(1, count),
            braids,
            self.rubbers.len().max(1),
        ];
        let all: f64 = axes.map(|n| n as f64).iter().product();
        if all > 1e6 {
            return refused(
                "",
                format!(
                    "{all:.3e} combinations are too many; at most 1 million: take larger steps or \
                 fewer values"
                ),
            );
        }
        self.check_contraction(peak(lengths))
    }

    fn check_numbers(&self) -> Result<(), SpecError> {
        let one = |value: f64| Some((value, value));
        let mut numbers = vec![
            ("max_pressure_mpa", one(self.max_pressure_mpa)),
            ("supply_share", one(self.supply_share)),
            ("outer_diameter_mm", Some(self.outer_diameter_mm.bounds())),
            ("wall_mm", Some(self.wall_mm.bounds())),
            ("length_mm", self.length_mm.as_ref().map(Values::bounds)),
            (
                "radius_mm",
                self.wanted.joint().map(|joint| joint.radii_mm.bounds()),
            ),
            ("pitch_mm", self.pitch_mm.and_then(one)),
            ("top", one(self.top as f64)),
            ("count", one(f64::from(self.count))),
        ];
        numbers.extend(
            self.limits
                .positive()
                .map(|(name, value)| (name, value.and_then(one))),
        );
        for (name, bounds) in numbers {
            let sound = |(low, high): (f64, f64)| low > 0.0 && low <= high && high.is_finite();
            if let Some((low, high)) = bounds.filter(|ends| !sound(*ends)) {
                let value = if low == high || low.is_nan() {
                    low.to_string()
                } else {
                    format!("{low} to {high}")
                };
                return refused(
                    name,
                    format!("`{name}` is {value}; it must be above zero, the smaller end first"),
                );
            }
        }
        let count = self.count.max(self.most_side_by_side);
        if count > MOST {
            return refused(
                "count",
                format!("`count` is {count}; it must be at most {MOST}"),
            );
        }
        for (name, factor, least) in [
            ("min_burst_margin", self.limits.burst_margin, LEAST_SAFETY),
            ("min_tube_margin", self.limits.tube_margin, PROVED),
        ] {
            if let Some(factor) = factor.filter(|factor| *factor < least) {
                return refused(
                    name,
                    format!(
                        "`{name}` is {factor}; give {least} or more, so that the muscle can be tested \
                     above the set pressure, or 0 to leave failures out"
                    ),
                );
            }
        }
        match self
            .certainty
            .filter(|share| !(0.5..=0.999).contains(share))
        {
            Some(share) => refused(
                "certainty",
                format!("`certainty` is {share}; it must be from 0.5 (50 %) to 0.999 (99.9 %)"),
            ),
            None => Ok(()),
        }
    }

    /// Refuses a contraction that inextensible strands do not reach at any pressure: ε = 1 − 1/(√3
    /// cosθ0), the least of whose angles is that of the search.
    fn check_contraction(&self, length_mm: f64) -> Result<(), SpecError> {
        if self.wanted.extends() {
            return Ok(());
        }
        let least_mm = self
            .wanted
            .joint()
            .map_or(0.0, |joint| joint.radii_mm.bounds().0);
        let points = self.wanted.points(length_mm, least_mm);
        let required = peak(points.iter().map(|q| q.contraction));
        let least_deg = self.least_angle_deg();
        let most = 1.0 - 1.0 / (3f64.sqrt() * least_deg.to_radians().cos());
        if required < most {
            return Ok(());
        }
        let [required, most] = [required, most].map(|share| tidy(100.0 * share, 3));
        Err(SpecError::OutOfReach {
            required,
            most,
            least_deg: tidy(least_deg, 3),
        })
    }

    /// The smallest angle of the braids on their tubes, in degrees.
    fn least_angle_deg(&self) -> f64 {
        match &self.braid {
            BraidChoice::Angle(angles) => angles.bounds().0,
            BraidChoice::StrandLengthPerTurn(_) => 0.0,
            BraidChoice::Sleeves(list) => {
                let on = |braid: &Braid, tube: &TubePart| {
                    Some(
                        braid
                            .clone()
                            .on_diameter(tube.outer_diameter_mm)
                            .ok()?
                            .angle_deg,
                    )
                };
                let tubes = &self.tubes;
                let angles = list
                    .iter()
                    .flat_map(|b| tubes.iter().filter_map(move |t| on(b, t)));
                angles.reduce(f64::min).unwrap_or_default()
            }
        }
    }
}

/// Refuses a specification with the reason.
pub(crate) fn refused<T>(field: &'static str, why: impl Into<String>) -> Result<T, SpecError> {
    Err(SpecError::Refused(field, why.into()))
}

/// Why a specification cannot be searched at all.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SpecError {
    /// The field, and a sentence of it, its value and what it must be.
    #[error("{1}")]
    Refused(&'static str, String),
    /// A largest liquid volume without a liquid.
    #[error(
        "`max_liquid_volume_mm3` is {0} mm³, and the muscle is filled with air: give `liquid`, or \
         leave `max_liquid_volume_mm3` out"
    )]
    NoLiquid(f64),
    /// A contraction that no braid of the search reaches, in percent and degrees.
    #[error(
        "a contraction of {required} % is required: a braid at {least_deg}° contracts by {most} % \
         at most, no braid by more than 42.2 %"
    )]
    OutOfReach {
        /// Percent.
        required: f64,
        /// Percent, of the largest angle that is searched.
        most: f64,
        /// The smallest angle of the search.
        least_deg: f64,
    },
    /// No combination is a muscle at all.
    #[error("none of the combinations is a muscle: {0}")]
    NoMuscle(MuscleError),
    /// The caller wanted the search to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
