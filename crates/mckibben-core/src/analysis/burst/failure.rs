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

/// Proof over working pressure: a choice, half of the ratio of burst to working pressure of hoses
/// for compressed air (RMA, Hose Handbook, IP-2, 2003).
pub const PROOF_TO_WORKING: f64 = 2.0;

/// A proof is at most this share of the burst pressure, so that it does not destroy a good muscle:
/// a choice.
pub const PROOF_TO_BURST: f64 = 0.75;

/// What limits the pressure of a muscle: how it fails, or what else ends.
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
    /// The fittings are rated for no more.
    Fittings,
    /// The strands stretch beyond the validated range of all models.
    StrandStrain,
    /// No model answers beyond.
    NoAnswer,
}

impl FailureMode {
    /// The share of a safety factor that this failure needs: a half where the tube fails. It leaks
    /// then, and flies apart in no case; the pressure is that of the unloaded muscle, at the widest
    /// openings, and builders use muscles up to 0.9 of it.
    pub fn share(self) -> f64 {
        match self {
            Self::Mesh | Self::Bladder => 0.5,
            _ => 1.0,
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
            Self::Fittings => "its fittings are rated for no more",
            Self::StrandStrain => "its strands are stretched to their limit",
            Self::NoAnswer => "no model answers any more",
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

    /// The last pressure in MPa with an answer, where none fails up to there.
    fn answered_up_to_mpa(self) -> Option<f64> {
        match self {
            Self::Unknown(NoBurst::NoAnswerBeyond(mpa)) => Some(mpa),
            _ => None,
        }
    }

    /// A share of this pressure.
    pub(super) fn times(self, share: f64) -> Self {
        match self {
            Self::At { mpa, least_mpa } => Self::At {
                mpa: share * mpa,
                least_mpa: share * least_mpa,
            },
            other => other,
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
    /// What it keeps its distance from.
    pub by: FailureMode,
    /// The pressure of that over this one.
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
    /// The strands of the blocked muscle are stretched to the validated limit
    /// ([`VALIDATED_STRAND_STRAIN`](crate::warning::VALIDATED_STRAND_STRAIN)); no failure, but
    /// nothing is known beyond.
    pub strained: FailurePressure,
    /// The factors of the allowed pressure.
    pub safety: Safety,
    /// Whether the pressure may rise up to that of a proof test, with room for a relief valve.
    pub overpressure: bool,
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
            strained: FailurePressure::None,
            safety: Safety::default(),
            overpressure: false,
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
    /// that it may be over [`PROVED`], or that factor where it is smaller. Where strands are
    /// stretched to their limit, or no model answers any more, it ends as well.
    pub fn allowed(&self) -> Option<Allowed> {
        let one = |mpa, by| Allowed {
            mpa,
            by,
            factor: 1.0,
        };
        let of = |(mode, at): (FailureMode, FailurePressure)| {
            let factor = Some(self.safety.factor(mode)).filter(|factor| *factor > 0.0)?;
            let from = |failure_mpa: f64, factor: f64| Allowed {
                mpa: failure_mpa / factor,
                by: mode,
                factor,
            };
            if let Some(up_to_mpa) = at.answered_up_to_mpa().filter(|_| mode.share() == 1.0) {
                return Some(Allowed {
                    by: FailureMode::NoAnswer,
                    ..from(up_to_mpa, factor)
                });
            }
            let nominal = from(at.mpa().unwrap_or(f64::INFINITY), factor);
            let least = from(at.least_mpa()?, factor.min(PROVED));
            Some(if least.mpa < nominal.mpa {
                least
            } else {
                nominal
            })
        };
        let failures: Vec<Allowed> = match self.least() {
            Some((by, burst_mpa)) if self.overpressure => {
                let factor = RELIEF / PROOF_TO_BURST;
                let mpa = burst_mpa / factor;
                vec![Allowed { mpa, by, factor }]
            }
            _ => self.modes().into_iter().filter_map(of).collect(),
        };
        let rated = self.rated_mpa.map(|p| one(p, FailureMode::Fittings));
        let strained = self
            .strained
            .mpa()
            .map(|p| one(p, FailureMode::StrandStrain));
        let answered = self
            .strained
            .answered_up_to_mpa()
            .map(|p| one(p, FailureMode::NoAnswer));
        failures
            .into_iter()
            .chain(rated)
            .chain(strained)
            .chain(answered)
            .reduce(|a, b| if b.mpa < a.mpa { b } else { a })
    }

    /// Pressure of the proof test in MPa of a muscle that works at one in MPa: twice as much, at most
    /// three quarters of the least burst pressure and what the strands stretch to at most.
    pub fn highest_proof_mpa(&self, working_mpa: f64) -> f64 {
        self.least()
            .map(|(_, mpa)| PROOF_TO_BURST * mpa)
            .into_iter()
            .chain(self.strained.mpa())
            .fold(PROOF_TO_WORKING * working_mpa, f64::min)
    }

    /// What is said of it where the largest pressure is `highest_mpa`.
    pub fn warnings(&self, highest_mpa: f64) -> Vec<Warning> {
        let above = match (self.least(), self.allowed()) {
            (Some((by, burst_mpa)), _) if highest_mpa >= burst_mpa => {
                Some(Warning::of_burst(highest_mpa, burst_mpa, by))
            }
            (_, Some(allowed)) if highest_mpa > allowed.mpa => {
                Some(Warning::above_allowed(highest_mpa, allowed))
            }
            _ => None,
        };
        above
            .into_iter()
            .chain(self.not_checked().map(Warning::burst_not_checked))
            .collect()
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
