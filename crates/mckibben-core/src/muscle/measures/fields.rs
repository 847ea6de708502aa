//! How measures are declared, and fields of the parts of a muscle that its measures share.

use crate::muscle::{Crimp, Friction, MeasuredStrand, Parts, Strands};

/// A measure that stands in a field of a part, by the path of the field; not stated where the field
/// has its usual value.
macro_rules! stated {
    ($part:ident.$field:ident) => {
        Measure {
            field: Some(stringify!($field)),
            get: |p| Some(p.$part.$field),
            set: |p, v| p.$part.$field = v,
            ..Measure::NONE
        }
    };
    ($part:ident.$field:ident, unless $usual:literal) => {
        Measure {
            get: |p| Some(p.$part.$field).filter(|v| *v != $usual),
            ..stated!($part.$field)
        }
    };
}

/// The same of a field that may be none.
macro_rules! optional {
    ($part:ident.$field:ident) => {
        Measure {
            field: Some(stringify!($field)),
            get: |p| p.$part.$field,
            set: |p, v| p.$part.$field = Some(v),
            ..Measure::NONE
        }
    };
}

/// Every measure by its name, and the list of them: fields of requests are in its order, keys of a
/// muscle file in its order within their table.
macro_rules! measures {
    ($($(#[$symbol:meta])* $name:ident { $($of:tt)* })*) => {
        /// All of them.
        pub static MEASURES: &[&Measure] = &[$(&$name),*];
        $($(#[$symbol])* pub static $name: Measure = Measure { $($of)* };)*
    };
}

pub fn strands(p: &mut Parts) -> &mut Strands {
    p.braid.strands.get_or_insert(Strands::new(0, None, None))
}

pub fn measured(p: &mut Parts) -> &mut MeasuredStrand {
    p.braid.measured.get_or_insert(MeasuredStrand {
        strand_length_mm: 0.0,
        turns: 0.0,
    })
}

pub fn crimp(p: &mut Parts) -> &mut Crimp {
    p.braid.crimp.get_or_insert(Crimp {
        strain: 0.0,
        stiffness_ratio: Crimp::STIFFNESS_RATIO,
    })
}

pub fn friction(p: &mut Parts) -> &mut Friction {
    p.friction.get_or_insert(Friction::power_law(0.0, 0.0))
}

/// The part C·P^β, where it is stated.
pub fn power_law(p: &Parts) -> Option<&Friction> {
    p.friction
        .as_ref()
        .filter(|f| f.coefficient != 0.0 || f.exponent != 0.0 || f.lever_mm == 0.0)
}
