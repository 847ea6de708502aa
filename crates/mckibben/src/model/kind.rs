//! The models by name.

use super::{
    Belforte, ChouHannaford, ConicalEnds, FestoHunt, FestoSarosi, ForceBalance, ForceModel, Ideal,
    KluteHannaford, ModelError, Paper, RoundedEnds, ThickWall, TonduLopez, Universal, seated,
};
use crate::formula::UniversalFormula;
use crate::muscle::Muscle;
use crate::nearest::nearest;
use std::fmt;
use std::str::FromStr;
use std::sync::Arc;
use thiserror::Error;

/// A model that answers without a solver of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ModelKind {
    /// [`Ideal`]
    Ideal,
    /// [`ThickWall`]
    ThickWall,
    /// [`ChouHannaford`]
    ChouHannaford,
    /// [`ForceBalance`]
    ForceBalance,
    /// [`TonduLopez`]
    TonduLopez,
    /// [`Belforte`]
    Belforte,
    /// [`KluteHannaford`]
    KluteHannaford,
    /// [`ConicalEnds`]
    ConicalEnds,
    /// [`RoundedEnds`]
    RoundedEnds,
    /// [`FestoSarosi`], size 10
    FestoDmsp10,
    /// [`FestoSarosi`], size 20, 200 mm
    FestoDmsp20,
    /// [`FestoHunt`]
    FestoHunt10,
    /// [`Universal`]
    Universal,
    /// [`Universal`] in its short form
    UniversalSmall,
    /// [`Paper`]
    Paper,
}

/// A word that names no model.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("there is no model `{given}`{}; the models are {}", meant(*.nearest), ModelKind::NAMES.join(", "))]
pub struct UnknownModel {
    /// What was given.
    pub given: String,
    /// The name that was probably meant.
    pub nearest: Option<&'static str>,
}

fn meant(nearest: Option<&str>) -> String {
    nearest.map_or_else(String::new, |name| format!(" (did you mean {name}?)"))
}

/// Kind, name, one line for `--help`.
const TABLE: [(ModelKind, &str, &str); 15] = [
    (ModelKind::Ideal, "ideal", "cylinder without wall, rubber and ends"),
    (
        ModelKind::ThickWall,
        "thick-wall",
        "energy of a long muscle: any rubber, any wall, strands that stretch",
    ),
    (ModelKind::ChouHannaford, "chou-hannaford", "ideal muscle inside of a wall of constant thickness"),
    (ModelKind::ForceBalance, "force-balance", "incompressible wall without the rubber's own stress"),
    (ModelKind::TonduLopez, "tondu-lopez", "ideal muscle with an empirical end factor on the contraction"),
    (ModelKind::Belforte, "belforte", "ideal muscle with strand length and turns as measured"),
    (ModelKind::KluteHannaford, "klute-hannaford", "ideal muscle and a thin Mooney-Rivlin tube"),
    (ModelKind::ConicalEnds, "conical-ends", "cylinder between two cones (Tondu 2012)"),
    (ModelKind::RoundedEnds, "rounded-ends", "force balance of the middle of a muscle with round ends"),
    (ModelKind::FestoDmsp10, "festo-dmsp-10", "Festo DMSP-10 by Sarosi's fit; ignores the given muscle"),
    (
        ModelKind::FestoDmsp20,
        "festo-dmsp-20-200",
        "Festo DMSP-20-200N by Sarosi's fit; ignores the given muscle",
    ),
    (
        ModelKind::FestoHunt10,
        "festo-hunt-10",
        "Festo 10 mm muscle by Hunt's fit; takes only the muscle's length",
    ),
    (
        ModelKind::Universal,
        "universal",
        "long muscle with computed ends: any size, rubber, wall, braid and length",
    ),
    (ModelKind::UniversalSmall, "universal-small", "the same with ends of 16 terms, for hand calculation"),
    (
        ModelKind::Paper,
        "paper",
        "formula (11) of Antonelli et al. 2018 [antonelli2018]: D0 30-50, s 1-5, L0 285 mm, 28 deg, up to 0.25 MPa",
    ),
];

impl ModelKind {
    /// All kinds, in the order of [`ModelKind::NAMES`].
    pub const ALL: [ModelKind; 15] = {
        let mut all = [ModelKind::Ideal; 15];
        let mut i = 0;
        while i < all.len() {
            all[i] = TABLE[i].0;
            i += 1;
        }
        all
    };

    /// The words for `--model`.
    pub const NAMES: [&'static str; 15] = {
        let mut names = [""; 15];
        let mut i = 0;
        while i < names.len() {
            names[i] = TABLE[i].1;
            i += 1;
        }
        names
    };

    fn row(self) -> &'static (ModelKind, &'static str, &'static str) {
        // The variants stand in the order of the table (see the test below).
        &TABLE[self as usize]
    }

    /// The word for `--model`.
    pub fn name(self) -> &'static str {
        self.row().1
    }

    /// One line for `--help`.
    pub fn description(self) -> &'static str {
        self.row().2
    }

    /// The model of a muscle.
    ///
    /// # Errors
    /// [`ModelError`] where the muscle does not state what the model needs.
    pub fn build(self, muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
        let whole = muscle;
        let muscle = &*whole.between_ends();
        let model: Box<dyn ForceModel> = match self {
            ModelKind::Ideal => Box::new(Ideal::new(muscle)),
            ModelKind::ThickWall => Box::new(ThickWall::new(muscle)),
            ModelKind::ChouHannaford => Box::new(ChouHannaford::new(muscle)),
            ModelKind::ForceBalance => Box::new(ForceBalance::new(muscle)),
            ModelKind::TonduLopez => Box::new(TonduLopez::new(muscle)?),
            ModelKind::Belforte => Box::new(Belforte::new(muscle)?),
            ModelKind::KluteHannaford => Box::new(KluteHannaford::new(muscle)?),
            ModelKind::ConicalEnds => Box::new(ConicalEnds::new(muscle)?),
            ModelKind::RoundedEnds => Box::new(RoundedEnds::new(muscle)?),
            ModelKind::FestoDmsp10 => Box::new(FestoSarosi::dmsp_10(muscle)),
            ModelKind::FestoDmsp20 => Box::new(FestoSarosi::dmsp_20_200(muscle)),
            ModelKind::FestoHunt10 => Box::new(FestoHunt::new(muscle)),
            ModelKind::Universal => universal("universal", UniversalFormula::large(), muscle)?,
            ModelKind::UniversalSmall => universal("universal-small", UniversalFormula::small(), muscle)?,
            ModelKind::Paper => Box::new(Paper::new(muscle)),
        };
        Ok(seated(model, whole))
    }
}

fn universal(
    model: &'static str,
    formula: Option<Arc<UniversalFormula>>,
    muscle: &Muscle,
) -> Result<Box<dyn ForceModel>, ModelError> {
    let missing = "its built-in coefficients, which cannot be read; rebuild the program";
    let formula = formula.ok_or(ModelError::Missing { model, missing, key: "" })?;
    Ok(Box::new(Universal::new(formula, muscle)))
}

impl fmt::Display for ModelKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for ModelKind {
    type Err = UnknownModel;

    fn from_str(s: &str) -> Result<Self, UnknownModel> {
        let kind = Self::ALL.into_iter().find(|k| k.name() == s);
        kind.ok_or_else(|| UnknownModel {
            given: s.chars().take(60).collect(),
            nearest: nearest(s, Self::NAMES),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_go_there_and_back() {
        for (i, kind) in ModelKind::ALL.into_iter().enumerate() {
            assert_eq!(kind as usize, i);
            assert_eq!(kind.name().parse(), Ok(kind));
            assert_eq!(kind.to_string(), ModelKind::NAMES[i]);
            assert!(!kind.description().is_empty());
            if let Ok(model) = kind.build(&Muscle::prototype()) {
                assert_eq!(model.name(), kind.name());
            }
        }
        let error = "idael".parse::<ModelKind>().unwrap_err().to_string();
        assert!(
            error.contains("idael` (did you mean ideal?)") && error.contains("festo-dmsp-20-200"),
            "{error}"
        );
    }
}
