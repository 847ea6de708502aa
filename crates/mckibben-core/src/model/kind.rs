//! The models by name: one list from which names, help, sources and construction come.

use super::*;
use crate::{
    formula::UniversalFormula,
    nearest::{meant, nearest},
    refused::Refused,
};
use std::{fmt, str::FromStr};

/// Models of version 3, and what stays in their place.
const GONE: [(&str, &str); 6] = [
    ("klute-hannaford", "thick-wall"),
    ("conical-ends", "fe"),
    ("rounded-ends", "fe"),
    ("festo-dmsp-10", "the measured muscle lib:dmsp-10-250"),
    ("festo-dmsp-20-200", "the measured muscle lib:dmsp-20-300"),
    ("universal-small", "universal"),
];

/// That no model has a name: what stays in its place, or the nearest and all that there are.
pub fn unknown_model(name: &str, names: &[&'static str]) -> Refused {
    if let Some((gone, stays)) = GONE.iter().find(|(gone, _)| *gone == name.trim()) {
        return Refused::new(
            ["model"],
            format!("the model `{gone}` is gone: take {stays}"),
        );
    }
    let meant = meant(nearest(name, names.iter().copied()));
    Refused::new(
        ["model"],
        format!(
            "there is no model `{name:.60}`{meant}; the models are {}",
            names.join(", ")
        ),
    )
}

macro_rules! models {
    ($($(#[$doc:meta])* $kind:ident = $entry:expr, $build:expr;)*) => {
        /// A model that answers without a solver of its own.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum ModelKind {
            $($(#[$doc])* $kind,)*
        }

        const ENTRIES: &[ModelEntry] = &[$($entry,)*];
        /// How they are made of a muscle between its ends: beside the entries, so that a program
        /// may know the names without the models.
        const BUILDS: &[fn(&Muscle) -> Result<Box<dyn ForceModel>>] = &[$($build,)*];

        impl ModelKind {
            /// All kinds.
            pub const ALL: [Self; ENTRIES.len()] = [$(Self::$kind,)*];
        }
    };
}

models! {
    /// [`Ideal`]
    Ideal = ideal::ENTRY, |m| Ok(Box::new(Ideal::between_ends(m)));
    /// [`ThickWall`]
    ThickWall = thick_wall::ENTRY, |m| Ok(Box::new(ThickWall::between_ends(m)));
    /// The ideal muscle inside of a wall of constant thickness
    ChouHannaford = chou_hannaford::ENTRY, chou_hannaford::build;
    /// An incompressible wall whose rubber carries nothing
    ForceBalance = force_balance::ENTRY, force_balance::build;
    /// [`TonduLopez`]
    TonduLopez = tondu_lopez::ENTRY, |m| Ok(Box::new(TonduLopez::between_ends(m)?));
    /// The ideal muscle by a measured strand
    Belforte = belforte::ENTRY, belforte::build;
    /// [`Universal`]
    Universal = universal::ENTRY, universal;
    /// [`FormulaModel::paper`]
    Paper = paper::ENTRY, |m| Ok(Box::new(FormulaModel::paper(m)));
}

fn universal(muscle: &Muscle) -> Result<Box<dyn ForceModel>> {
    let formula = UniversalFormula::large().ok_or(ModelError::Missing {
        model: universal::ENTRY.name,
        missing: "its built-in coefficients, which cannot be read; rebuild the program",
        key: "",
    })?;
    Ok(Box::new(Universal::between_ends(formula, muscle)))
}

impl ModelKind {
    /// Name, description and source.
    pub fn entry(self) -> ModelEntry {
        ENTRIES[self as usize]
    }

    /// The word for `--model`.
    pub fn name(self) -> &'static str {
        self.entry().name
    }

    /// The model of a muscle.
    ///
    /// # Errors
    /// [`ModelError`] where the muscle does not state what the model needs.
    #[inline(always)]
    pub fn build(self, muscle: &Muscle) -> Result<Box<dyn ForceModel>> {
        with_ends(muscle, BUILDS[self as usize])
    }
}

impl fmt::Display for ModelKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for ModelKind {
    type Err = Refused;

    fn from_str(s: &str) -> Result<Self, Refused> {
        Self::ALL
            .into_iter()
            .find(|k| k.name() == s)
            .ok_or_else(|| unknown_model(s, &Self::ALL.map(Self::name)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_go_there_and_back() {
        for kind in ModelKind::ALL {
            assert_eq!(kind.name().parse(), Ok(kind));
            assert_eq!(kind.to_string(), kind.name());
            assert!(!kind.entry().description.is_empty());
            if let Ok(model) = kind.build(&Muscle::prototype()) {
                assert_eq!(model.info().name, kind.name());
                assert!(model.info().source.starts_with(kind.entry().source));
            }
        }
        let error = "idael".parse::<ModelKind>().unwrap_err().to_string();
        assert!(
            error.contains("`idael`") && error.contains("ideal?") && error.contains("universal"),
            "{error}"
        );
    }

    #[test]
    fn a_model_of_version_3_names_what_stays() {
        for (gone, stays) in GONE {
            let error = gone.parse::<ModelKind>().unwrap_err().to_string();
            assert_eq!(error, format!("the model `{gone}` is gone: take {stays}"));
        }
    }
}
