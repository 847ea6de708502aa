//! How a muscle fails, at which pressure, and why that is not known.

use crate::{muscle::Muscle, warning::Warning};
use serde::Serialize;
use std::fmt;
use thiserror::Error;

/// Burst pressure over allowed pressure, of strands and clamps: that of new hose for compressed air
/// (RMA, Hose Handbook, IP-2, 2003).
pub const SAFETY: f64 = 4.0;

/// The least that a burst pressure may be over the allowed pressure, where number or strength of
/// the strands are estimates: a proof test with water shows that they hold, before people rely on
/// them.
pub const PROVED: f64 = 1.5;

/// The least safety factor of strands and clamps that may be asked for; the tube then has
/// [`PROVED`]. With less there is no room for a proof test above the pressure that is set.
pub const LEAST_SAFETY: f64 = 2.0;

/// The load at which a muscle that extends buckles over the allowed push: half of [`SAFETY`], as of
/// the tube, since what buckles bends and flies apart in no case.
pub const BUCKLING: f64 = 2.0;

/// A relief valve opens at this multiple of the pressure that is set: it needs about a tenth to
/// close again, and a regulator holds its pressure within 2 to 5 %.
pub const RELIEF: f64 = 1.1;

/// Pressure in MPa up to which a single point or a curve says nothing of a burst pressure that is
/// not known: that of a usual supply. Whoever builds reads of it at any pressure.
pub const QUIET_MPA: f64 = 0.6;

/// How a muscle fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FailureMode {
    /// A strand breaks.
    Strands,
    /// The tube bulges through an opening of the braid.
    Mesh,
    /// The rubber tears.
    Bladder,
    /// Tube and braid are pulled off a plug.
    Ends,
}

impl FailureMode {
    /// The share of a safety factor that this failure needs: a half where the tube fails. It leaks
    /// then, and flies apart in no case; the pressure is that of the unloaded muscle, at the widest
    /// openings, and builders use muscles up to 0.9 of it.
    pub fn share(self) -> f64 {
        match self {
            Self::Strands | Self::Ends => 1.0,
            Self::Mesh | Self::Bladder => 0.5,
        }
    }
}

impl fmt::Display for FailureMode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Strands => "its strands break",
            Self::Mesh => "the tube bulges through the openings of the braid",
            Self::Bladder => "the rubber tears",
            Self::Ends => "the clamps let go",
        })
    }
}

/// Safety factors: the pressure of a failure over the allowed pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Safety {
    /// Of strands and clamps; 0 for none.
    pub strands: f64,
    /// Of the tube; 0 for none.
    pub tube: f64,
}

impl Default for Safety {
    fn default() -> Self {
        Self::new(SAFETY, None)
    }
}

impl Safety {
    /// A factor of strands and clamps; the tube has the half of it ([`FailureMode::share`]), and
    /// [`PROVED`] at least, where none is given.
    pub fn new(strands: f64, tube: Option<f64>) -> Self {
        Self {
            strands,
            tube: tube.unwrap_or(match strands {
                0.0 => 0.0,
                strands => (FailureMode::Mesh.share() * strands).max(PROVED),
            }),
        }
    }

    /// The factor of a failure.
    pub fn factor(self, mode: FailureMode) -> f64 {
        if mode.share() < 1.0 {
            self.tube
        } else {
            self.strands
        }
    }
}

/// The pressure of one failure mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FailurePressure {
    /// In MPa; from `least_mpa` on, where it follows from estimates of the strands.
    At {
        /// With these numbers; infinite where only fewer strands fail.
        mpa: f64,
        /// With the least that the strands may be ([`Strands`](crate::muscle::Strands)).
        least_mpa: f64,
    },
    /// At no pressure that the other parts bear, or that matters.
    None,
    /// A number is missing, or the model has no answer up to there.
    Unknown(NoBurst),
}

impl FailurePressure {
    /// One in MPa that follows from no estimate.
    pub fn at(mpa: f64) -> Self {
        Self::At {
            mpa,
            least_mpa: mpa,
        }
    }

    /// In MPa, where there is one.
    pub fn mpa(self) -> Option<f64> {
        match self {
            Self::At { mpa, .. } => Some(mpa).filter(|mpa| mpa.is_finite()),
            Self::None | Self::Unknown(_) => None,
        }
    }

    /// The least that it may be in MPa, where there is one.
    pub fn least_mpa(self) -> Option<f64> {
        match self {
            Self::At { least_mpa, .. } => Some(least_mpa),
            Self::None | Self::Unknown(_) => None,
        }
    }

    /// This pressure, looked for up to one in MPa, and the least that it may be: that of fewer or
    /// weaker strands.
    pub(super) fn down_to(self, least: Self, up_to_mpa: f64) -> Self {
        let Some(least_mpa) = least.mpa() else {
            return self;
        };
        let mpa = match self {
            Self::At { mpa, .. } => mpa,
            Self::None => up_to_mpa.max(least_mpa),
            Self::Unknown(_) => least_mpa,
        };
        Self::At { mpa, least_mpa }
    }
}

/// Why the pressure of a failure mode is not known.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum NoBurst {
    /// The muscle does not state what it takes, or the model has no answer.
    #[error("{0}")]
    Missing(&'static str),
    /// The model has no answer beyond this pressure in MPa, and nothing fails up to there.
    #[error(
        "the model has no answer beyond {0:.3}\u{a0}MPa, and nothing fails up to there; another \
         model may answer"
    )]
    NoAnswerBeyond(f64),
}

impl NoBurst {
    /// The model has no answer.
    pub const NO_ANSWER: Self =
        Self::Missing("the model has no answer for the blocked muscle; another model may answer");
}

/// The pressure up to which a muscle may be used.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Allowed {
    /// In MPa.
    pub mpa: f64,
    /// The failure that it keeps its distance from; none where the fittings are rated for less.
    pub by: Option<FailureMode>,
    /// The pressure of that failure over this one.
    pub factor: f64,
}

impl Allowed {
    /// The pressure of the failure in MPa, from which this one follows.
    pub fn failure_mpa(&self) -> f64 {
        self.mpa * self.factor
    }
}

/// The pressures at which a muscle fails.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Burst {
    /// A strand breaks.
    pub strands: FailurePressure,
    /// The tube bulges through the braid.
    pub mesh: FailurePressure,
    /// The rubber tears.
    pub bladder: FailurePressure,
    /// The clamps let go.
    pub ends: FailurePressure,
    /// The pressure for which the fittings are rated, in MPa.
    pub rated_mpa: Option<f64>,
    /// The factors of the allowed pressure.
    pub safety: Safety,
    /// The answering model has no tension of the strands, and the thick-wall model gave it.
    pub from_thick_wall: bool,
}

impl Burst {
    /// One of which nothing is known.
    pub fn unknown(why: NoBurst) -> Self {
        let none = FailurePressure::Unknown(why);
        Self {
            strands: none,
            mesh: none,
            bladder: none,
            ends: none,
            rated_mpa: None,
            safety: Safety::default(),
            from_thick_wall: false,
        }
    }

    /// All failure modes.
    pub fn modes(&self) -> [(FailureMode, FailurePressure); 4] {
        [
            (FailureMode::Strands, self.strands),
            (FailureMode::Mesh, self.mesh),
            (FailureMode::Bladder, self.bladder),
            (FailureMode::Ends, self.ends),
        ]
    }

    /// The failure that comes first, with its pressure in MPa.
    pub fn first(&self) -> Option<(FailureMode, f64)> {
        self.earliest(FailurePressure::mpa)
    }

    /// The least that P_b may be, with the least of what is estimated, and the failure.
    pub fn least(&self) -> Option<(FailureMode, f64)> {
        self.earliest(FailurePressure::least_mpa)
    }

    fn earliest(&self, of: fn(FailurePressure) -> Option<f64>) -> Option<(FailureMode, f64)> {
        self.modes()
            .into_iter()
            .filter_map(|(mode, p)| Some((mode, of(p)?)))
            .reduce(|a, b| if b.1 < a.1 { b } else { a })
    }

    /// P_b in MPa, where it is known.
    pub fn pressure_mpa(&self) -> Option<f64> {
        Some(self.first()?.1)
    }

    /// The allowed pressure: the least failure pressure over its factor of safety, and the least
    /// that it may be over [`PROVED`], or that factor where it is smaller.
    pub fn allowed(&self) -> Option<Allowed> {
        let of = |(mode, at): (FailureMode, FailurePressure)| {
            let factor = Some(self.safety.factor(mode)).filter(|factor| *factor > 0.0)?;
            let from = |failure_mpa: f64, factor: f64| Allowed {
                mpa: failure_mpa / factor,
                by: Some(mode),
                factor,
            };
            let nominal = from(at.mpa().unwrap_or(f64::INFINITY), factor);
            let least = from(at.least_mpa()?, factor.min(PROVED));
            Some(if least.mpa < nominal.mpa {
                least
            } else {
                nominal
            })
        };
        let rated = self.rated_mpa.map(|mpa| Allowed {
            mpa,
            by: None,
            factor: 1.0,
        });
        self.modes()
            .into_iter()
            .filter_map(of)
            .chain(rated)
            .reduce(|a, b| if b.mpa < a.mpa { b } else { a })
    }

    /// What is said of it where the largest pressure is `highest_mpa`; of one that is not known only
    /// above `quiet_mpa`.
    pub fn warnings(&self, highest_mpa: f64, quiet_mpa: f64) -> Vec<Warning> {
        let above = match (self.least(), self.allowed()) {
            (Some((by, burst_mpa)), _) if highest_mpa >= burst_mpa => {
                Some(Warning::of_burst(highest_mpa, burst_mpa, by))
            }
            (_, Some(allowed)) if highest_mpa > allowed.mpa => {
                Some(Warning::above_allowed(highest_mpa, allowed))
            }
            _ => None,
        };
        let unknown = self
            .not_checked()
            .filter(|_| highest_mpa > quiet_mpa)
            .map(Warning::burst_not_checked);
        above.into_iter().chain(unknown).collect()
    }

    /// Why the strength of the strands was not checked.
    pub fn not_checked(&self) -> Option<NoBurst> {
        match self.strands {
            FailurePressure::Unknown(why) => Some(why),
            FailurePressure::At { .. } | FailurePressure::None => None,
        }
    }

    /// What a muscle must state for the pressure at which its strands break to be known.
    pub fn missing(muscle: &Muscle) -> Option<NoBurst> {
        Self::strand_strength_n(muscle).err()
    }

    /// The strength of a strand in N.
    pub(super) fn strand_strength_n(muscle: &Muscle) -> Result<f64, NoBurst> {
        let strands = muscle.braid().strands.ok_or(NoBurst::Missing(
            "the strength of the braid is not stated; give `braid.strands` (how many) and \
             `braid.strand_strength` (such as \"40 N\") in the muscle file",
        ))?;
        strands.strength_n.ok_or(NoBurst::Missing(
            "the strength of the strands is not stated; give `braid.strand_strength` (such as \"40 \
             N\") in the muscle file",
        ))
    }
}
