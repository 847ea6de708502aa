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

const fn need(wanted: &'static str, any_of: &'static [Meaning], names: &'static str) -> Need {
    Need {
        wanted,
        any_of,
        names,
    }
}

const TIMES: Need = need("times", &[Time], "time_s or Time [ms]");
const PRESSURES_OF_MUSCLE: Need = need(
    "pressures",
    &[Pressure],
    "pressure_mpa, pressure_kpa, pressure_bar or Pressure [psi]",
);
const CONTRACTIONS_OF_MUSCLE: Need = need(
    "contractions",
    &[Contraction, Shortening, Length, Extension],
    "contraction, contraction_percent, Shortening [mm], Length [mm] or Extension [mm]",
);
const FORCES_OF_MUSCLE: Need = need(
    "forces",
    &[Force, Volume],
    "force_n, Force [kN] or Force [lbf] (or volumes: Volume [mL])",
);

const FORCES: Need = need("forces", &[Force], "force_n, Force [kN] or Force [lbf]");

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
        need("stretches", &[Stretch], "stretch"),
        need(
            "stresses",
            &[NominalStress],
            "nominal_stress_mpa (or _kpa, _psi)",
        ),
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
        need(
            "stretches",
            &[Stretch, Strain, TrueStrain, Extension, Length],
            "stretch, engineering_strain, strain_percent or extension_mm",
        ),
        need(
            "stresses",
            &[NominalStress, TrueStress, Force, TrueStressDifference],
            "nominal_stress_mpa (or _kpa, _psi), true_stress_mpa or force_n",
        ),
    ],
};
/// A load over the shortening of the muscle that meets it.
pub static LOADS: Vocabulary = Vocabulary {
    what: "a load",
    quantities: &[STATE, MEASURED],
    needed: &[
        need(
            "shortenings",
            &[Shortening, Contraction],
            "Shortening [mm] or contraction",
        ),
        FORCES,
    ],
};
/// A quantity over time, in the order of [`OverTime`](super::OverTime).
pub static OVER_TIME: [Vocabulary; 7] = [
    over_time(COMMANDS, &[TIMES, PRESSURES_OF_MUSCLE]),
    over_time(
        COMMANDS,
        &[TIMES, need("openings", &[Opening], "opening (-1 to 1)")],
    ),
    over_time(
        COMMANDS,
        &[TIMES, need("volumes", &[Volume], "volume_mm3 or volume_ml")],
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
            need(
                "contractions",
                &[Contraction, Shortening],
                "contraction, contraction_percent or Shortening [mm]",
            ),
        ],
    ),
    over_time(
        COMMANDS,
        &[
            TIMES,
            need("angles", &[JointAngle], "angle_deg or Angle [rad]"),
        ],
    ),
    over_time(&[&[Time, Force]], &[TIMES, FORCES]),
    over_time(
        &[&[Time, Torque]],
        &[
            TIMES,
            need("torques", &[Torque], "torque_nm or Torque [N mm]"),
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
