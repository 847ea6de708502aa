//! The kinds of tables: what each may hold, and what must be there.

use super::vocabulary::Meaning::{self, *};

/// The quantities of one kind of table.
#[derive(Debug)]
pub struct Vocabulary {
    quantities: &'static [&'static [Meaning]],
    /// What a table of this kind is called, for messages.
    pub(crate) what: &'static str,
    /// What there must be: any one of each group. Messages name the group by the first.
    pub(crate) needed: &'static [Need],
}

impl Vocabulary {
    /// What a table of this kind may hold.
    pub(crate) fn quantities(&self) -> impl Iterator<Item = Meaning> + Clone {
        self.quantities.iter().copied().flatten().copied()
    }
}

/// A group of quantities of which one must be there.
#[derive(Debug)]
pub struct Need {
    /// In the plural, for messages.
    pub wanted: &'static str,
    /// The first that is there is taken.
    pub any_of: &'static [Meaning],
    /// Headings that would do.
    pub names: &'static str,
}

const TIMES: Need = Need {
    wanted: "times",
    any_of: &[Time],
    names: "time_s or Time [ms]",
};
const PRESSURES_OF_MUSCLE: Need = Need {
    wanted: "pressures",
    any_of: &[Pressure],
    names: "pressure_mpa, pressure_kpa, pressure_bar or Pressure [psi]",
};
const CONTRACTIONS_OF_MUSCLE: Need = Need {
    wanted: "contractions",
    any_of: &[Contraction, Shortening, Length, Extension],
    names: "contraction, contraction_percent, Shortening [mm], Length [mm] or Extension [mm]",
};
const FORCES_OF_MUSCLE: Need = Need {
    wanted: "forces",
    any_of: &[Force, Volume],
    names: "force_n, Force [kN] or Force [lbf] (or volumes: Volume [mL])",
};

/// What a muscle was commanded over time.
const COMMANDS: &[&[Meaning]] = &[&[Time, Pressure, Contraction, Opening, Volume, JointAngle]];
/// Pressure and length of a muscle.
const STATE: &[Meaning] = &[Pressure, Contraction, Shortening, RestLength, Length];
/// The length against that without load.
const EXTENSION: &[Meaning] = &[Extension, FreeLength];
/// What was measured in a state, and of which muscle.
pub const MEASURED: &[Meaning] = &[
    Force,
    Volume,
    VolumeError,
    Branch,
    Measured,
    Status,
    ForceError,
    ContractionError,
    PressureError,
    Weight,
    OuterDiameter,
    Wall,
    Angle,
];

/// A rubber strip over time.
pub static HISTORIES: Vocabulary = Vocabulary {
    what: "a test over time",
    quantities: &[&[Time, Stretch, NominalStress]],
    needed: &[
        TIMES,
        Need {
            wanted: "stretches",
            any_of: &[Stretch],
            names: "stretch",
        },
        Need {
            wanted: "stresses",
            any_of: &[NominalStress],
            names: "nominal_stress_mpa (or _kpa, _psi)",
        },
    ],
};
/// Measured points of a muscle.
pub static POINTS: Vocabulary = Vocabulary {
    what: "measured points",
    quantities: &[STATE, EXTENSION, MEASURED],
    needed: &[
        PRESSURES_OF_MUSCLE,
        CONTRACTIONS_OF_MUSCLE,
        FORCES_OF_MUSCLE,
    ],
};
/// Points of a muscle over time, whose pressures another instrument may have recorded.
pub static RECORDED: Vocabulary = Vocabulary {
    what: "points over time",
    quantities: &[&[Time], STATE, EXTENSION, MEASURED],
    needed: &[
        PRESSURES_OF_MUSCLE,
        CONTRACTIONS_OF_MUSCLE,
        FORCES_OF_MUSCLE,
        TIMES,
    ],
};
/// Tension tests of a rubber.
pub static TESTS: Vocabulary = Vocabulary {
    what: "tension tests",
    quantities: &[&[
        Stretch,
        Stretch2,
        Strain,
        TrueStrain,
        Extension,
        RestLength,
        Length,
        NominalStress,
        TrueStress,
        NominalStress2,
        TrueStress2,
        TrueStressDifference,
        Force,
        Mode,
        Area,
    ]],
    needed: &[
        Need {
            wanted: "stretches",
            any_of: &[Stretch, Strain, TrueStrain, Extension, Length],
            names: "stretch, engineering_strain, strain_percent or extension_mm",
        },
        Need {
            wanted: "stresses",
            any_of: &[NominalStress, TrueStress, Force, TrueStressDifference],
            names: "nominal_stress_mpa (or _kpa, _psi), true_stress_mpa or force_n",
        },
    ],
};
/// A load over the shortening of the muscle that meets it.
pub static LOADS: Vocabulary = Vocabulary {
    what: "a load",
    quantities: &[STATE, MEASURED],
    needed: &[
        Need {
            wanted: "shortenings",
            any_of: &[Shortening, Contraction],
            names: "Shortening [mm] or contraction",
        },
        Need {
            wanted: "forces",
            any_of: &[Force],
            names: "force_n, Force [kN] or Force [lbf]",
        },
    ],
};
/// A quantity over time, in the order of [`OverTime`](super::OverTime).
pub static OVER_TIME: [Vocabulary; 5] = [
    over_time(
        COMMANDS,
        &[
            TIMES,
            Need {
                wanted: "pressures",
                any_of: &[Pressure],
                names: "pressure_mpa, pressure_bar or Pressure [psi]",
            },
        ],
    ),
    over_time(
        COMMANDS,
        &[
            TIMES,
            Need {
                wanted: "openings",
                any_of: &[Opening],
                names: "opening (-1 to 1)",
            },
        ],
    ),
    over_time(
        COMMANDS,
        &[
            TIMES,
            Need {
                wanted: "volumes",
                any_of: &[Volume],
                names: "volume_mm3 or volume_ml",
            },
        ],
    ),
    over_time(
        &[&[
            Time,
            Pressure,
            Contraction,
            Shortening,
            Opening,
            Volume,
            JointAngle,
        ]],
        &[
            TIMES,
            Need {
                wanted: "contractions",
                any_of: &[Contraction, Shortening],
                names: "contraction, contraction_percent or Shortening [mm]",
            },
        ],
    ),
    over_time(
        COMMANDS,
        &[
            TIMES,
            Need {
                wanted: "angles",
                any_of: &[JointAngle],
                names: "angle_deg or Angle [rad]",
            },
        ],
    ),
];

const fn over_time(
    quantities: &'static [&'static [Meaning]],
    needed: &'static [Need],
) -> Vocabulary {
    Vocabulary {
        what: "a command",
        quantities,
        needed,
    }
}
