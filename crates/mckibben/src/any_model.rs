//! Every model there is, by name.

use mckibben_core::{
    formula::{Document, Formula, FormulaError, FormulaRange, UniversalFormula},
    model::{
        ForceModel, FormulaModel, ModelEntry, ModelError, ModelKind, Universal, unknown_model,
        with_ends,
    },
    muscle::Muscle,
    refused::Refused,
};
#[cfg(feature = "fem")]
use mckibben_fem::{
    axisymmetric::MeshSpec,
    elements::{Elements, section},
};
use std::{fmt, str::FromStr, sync::Arc};

/// A force model that is not yet bound to a muscle: finite elements with their mesh, a closed form,
/// or a fitted formula.
///
/// By its name it is what `--model` names on the command line:
///
/// ```
/// use mckibben::prelude::*;
///
/// let muscle = Muscle::prototype();
/// let mut fe = Model::FE.of(&muscle)?;
/// let mut universal = "universal".parse::<Model>()?.of(&muscle)?;
/// let (a, b) = (fe.force_n(0.25, 0.10)?, universal.force_n(0.25, 0.10)?);
/// assert!((a / b - 1.0).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Model {
    /// A closed form, `universal` with its built-in coefficients among them.
    #[doc(hidden)]
    ClosedForm(ModelKind),
    /// A formula that the paper's method or one least-squares problem fitted.
    #[doc(hidden)]
    Formula(Arc<Formula>),
    /// A universal formula with other coefficients than the built-in ones.
    #[doc(hidden)]
    Universal(Arc<UniversalFormula>),
    /// Finite elements.
    #[cfg(feature = "fem")]
    #[doc(hidden)]
    Elements(Elements),
}

impl Model {
    /// Axisymmetric finite elements on the mesh that the program chooses: the best answer, and that
    /// of every command by default.
    #[cfg(feature = "fem")]
    pub const FE: Model = Model::Elements(Elements::Axisymmetric(MeshSpec {
        through: None,
        along: None,
        grading: None,
    }));
    /// The closed form that is nearest to the finite elements, a thousand times as fast.
    pub const UNIVERSAL: Model = Model::ClosedForm(ModelKind::Universal);

    /// Names, descriptions and sources of all that have a name.
    pub fn all() -> Vec<ModelEntry> {
        let all = ModelKind::ALL.into_iter().map(ModelKind::entry);
        #[cfg(feature = "fem")]
        let all = all.chain(Elements::ENTRIES);
        all.collect()
    }

    /// The model of a formula's file, by its text.
    ///
    /// # Errors
    /// [`FormulaError`] with line, column and key.
    pub fn from_formula(text: &str) -> Result<Self, FormulaError> {
        Ok(match Document::parse(text)? {
            Document::Section(formula) => Self::Formula(formula.into()),
            Document::Universal(formula) => Self::Universal(formula.into()),
        })
    }

    /// Its name.
    pub fn name(&self) -> &str {
        match self {
            Self::ClosedForm(kind) => kind.name(),
            Self::Formula(formula) => &formula.name,
            Self::Universal(formula) => &formula.name,
            #[cfg(feature = "fem")]
            Self::Elements(elements) => elements.name(),
        }
    }

    /// Whether a point takes finite elements, and so some thousand times as long as a formula.
    pub fn is_elements(&self) -> bool {
        match self {
            #[cfg(feature = "fem")]
            Self::Elements(_) => true,
            _ => false,
        }
    }

    /// Sections, pressures and contractions that it was made for, where it is bound to some.
    #[doc(hidden)]
    pub fn range(&self) -> Option<&FormulaRange> {
        match self {
            Self::Formula(f) => Some(&f.range),
            Self::ClosedForm(ModelKind::Paper) => Some(&FormulaModel::PAPER_RANGE),
            _ => None,
        }
    }

    /// The model of a whole muscle, its ends included.
    ///
    /// # Errors
    /// [`ModelError`] where the muscle does not state what the model needs, or where a mesh would
    /// not fit into memory.
    pub fn build(&self, muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
        match self {
            #[cfg(feature = "fem")]
            Self::Elements(Elements::Axisymmetric(mesh)) => Ok(section(muscle, mesh)?),
            // The others are as large as all the rest.
            _ if !cfg!(feature = "whole") => Err(ModelError::Missing {
                model: "this model",
                missing: "the full engine; this is a reduced one",
                key: "",
            }),
            Self::ClosedForm(kind) => kind.build(muscle),
            Self::Formula(formula) => with_ends(muscle, |m| {
                Ok(Box::new(FormulaModel::between_ends(formula, m)))
            }),
            Self::Universal(formula) => with_ends(muscle, |m| {
                Ok(Box::new(Universal::between_ends(Arc::clone(formula), m)))
            }),
            #[cfg(feature = "fem")]
            Self::Elements(elements) => {
                elements.admit(muscle)?;
                Ok(elements.build(muscle)?)
            }
        }
    }
}

impl fmt::Display for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Model {
    type Err = Refused;

    fn from_str(name: &str) -> Result<Self, Refused> {
        let name = name.trim();
        #[cfg(feature = "fem")]
        if let Ok(elements) = name.parse() {
            return Ok(Self::Elements(elements));
        }
        if let Ok(kind) = name.parse() {
            return Ok(Self::ClosedForm(kind));
        }
        let names: Vec<_> = Self::all().into_iter().map(|entry| entry.name).collect();
        Err(unknown_model(name, &names))
    }
}
