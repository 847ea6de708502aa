//! Every model there is, by name, and the one policy of which of them answers.

use crate::{
    Direction, MeshFields, ModelFields, NameOrFile, Problem, ProblemKind, Result, TextFile,
};
use mckibben_core::{
    answer::Options,
    formula::{Document, Formula, FormulaRange, UniversalFormula},
    model::{
        ForceModel, FormulaModel, ModelEntry, ModelError, ModelKind, Universal, unknown_model,
        with_ends,
    },
    muscle::Muscle,
};
use mckibben_fem::{
    axisymmetric::MeshSpec,
    elements::{Elements, section},
    three_dimensional::{BrickSpec, Match},
};
use std::sync::Arc;

/// A force model that is not yet bound to a muscle: a closed form, a fitted formula, or finite
/// elements with their mesh.
#[derive(Debug, Clone, PartialEq)]
pub enum Model {
    /// A closed form, `universal` with its built-in coefficients among them.
    ClosedForm(ModelKind),
    /// A formula that the paper's method or one least-squares problem fitted.
    Formula(Arc<Formula>),
    /// A universal formula with other coefficients than the built-in ones.
    Universal(Arc<UniversalFormula>),
    Elements(Elements),
}

impl Model {
    /// Axisymmetric finite elements on the mesh that the program chooses.
    pub const FE: Model = Model::Elements(Elements::Axisymmetric(MeshSpec {
        through: None,
        along: None,
        grading: None,
    }));

    pub fn all() -> Vec<ModelEntry> {
        ModelKind::ALL
            .into_iter()
            .map(ModelKind::entry)
            .chain(Elements::ENTRIES)
            .collect()
    }

    /// Whether a word is the name of a model already.
    pub fn is_taken(name: &str) -> bool {
        Self::all().iter().any(|entry| entry.name == name.trim())
    }

    /// The model that answers a request, and the only rule about it: the one that is named; where
    /// none is, `fe`.
    pub fn choose(fields: &ModelFields) -> Result<Self> {
        let model = match &fields.name {
            Some(name) => Self::of(name, &fields.mesh)?,
            None => Self::named("fe", &fields.mesh)?,
        };
        fields.mesh.check_used(&[&model])?;
        Ok(model)
    }

    /// The model of a name, or of a formula's file.
    pub(crate) fn of(name: &NameOrFile, mesh: &MeshFields) -> Result<Self> {
        match name {
            NameOrFile::Name(name) => Self::named(name, mesh),
            NameOrFile::File(file) => mesh.no_terminal().and_then(|()| Self::from_formula(file)),
        }
    }

    /// The model of a name of the list.
    pub fn named(name: &str, mesh: &MeshFields) -> Result<Self> {
        let name = name.trim();
        if let Ok(elements) = name.parse::<Elements>() {
            return Ok(Self::Elements(mesh.meshed(elements)?));
        }
        mesh.no_terminal()?;
        if let Ok(kind) = name.parse::<ModelKind>() {
            return Ok(Self::ClosedForm(kind));
        }
        let names: Vec<_> = Self::all().into_iter().map(|entry| entry.name).collect();
        Err(ProblemKind::Model.problem(unknown_model(name, &names).to_string()))
    }

    /// The model of a formula's file.
    pub fn from_formula(file: &TextFile) -> Result<Self> {
        if !cfg!(feature = "whole") {
            return Err(ProblemKind::Formula
                .problem("formula files need the full engine; this is a reduced one"));
        }
        let read =
            Document::parse(&file.text).map_err(|e| e.in_file(std::path::Path::new(&file.name)))?;
        Ok(match read {
            Document::Section(formula) => Self::Formula(Arc::new(formula)),
            Document::Universal(formula) => Self::Universal(Arc::new(formula)),
        })
    }

    /// A muscle of the make that a formula is for.
    pub(crate) fn made_for(&self) -> Result<Option<Muscle>> {
        match self {
            Self::Formula(f) => Ok(Some(f.made_for.muscle(&f.range)?)),
            _ => Ok(None),
        }
    }

    pub fn name(&self) -> &str {
        match self {
            Self::ClosedForm(kind) => kind.name(),
            Self::Formula(formula) => &formula.name,
            Self::Universal(formula) => &formula.name,
            Self::Elements(elements) => elements.name(),
        }
    }

    /// Sections, pressures and contractions that it was made for, where it is bound to some.
    pub fn range(&self) -> Option<&FormulaRange> {
        match self {
            Self::Formula(f) => Some(&f.range),
            Self::ClosedForm(ModelKind::Paper) => Some(&FormulaModel::PAPER_RANGE),
            _ => None,
        }
    }

    /// Refuses what would not fit into memory with this muscle.
    pub fn admit(&self, muscle: &Muscle) -> Result<(), ModelError> {
        match self {
            Self::Elements(elements) => Ok(elements.admit(muscle)?),
            _ => Ok(()),
        }
    }

    /// A muscle that it admits, bound to it.
    pub(crate) fn bound(&self, muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
        self.admit(muscle)?;
        self.build(muscle)
    }

    pub fn build(&self, muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
        match self {
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
            Self::Elements(elements) => Ok(elements.build(muscle)?),
        }
    }
}

impl MeshFields {
    /// Elements with this mesh.
    fn meshed(&self, elements: Elements) -> Result<Elements> {
        let elements = match elements {
            Elements::Axisymmetric(spec) => {
                self.no_terminal()?;
                Elements::Axisymmetric(spec)
            }
            Elements::ThreeDimensional(spec) => Elements::ThreeDimensional(BrickSpec {
                keep: self.keep,
                plug: self.terminal,
                ..spec
            }),
        };
        let Some(text) = &self.mesh else {
            return Ok(elements);
        };
        elements.with_mesh(text).map_err(|error| {
            Problem::new(
                ProblemKind::Mesh,
                error.to_string(),
                "leave it out: the program then selects the mesh",
            )
            .in_field("mesh")
        })
    }

    /// Refuses a mesh that none of the models has.
    pub(crate) fn check_used(&self, models: &[&Model]) -> Result<()> {
        let elements = models.iter().any(|m| matches!(m, Model::Elements(_)));
        let why = "only `model` fe and fe3d have a mesh";
        Problem::refuse_unused(&[("mesh", self.mesh.is_some() && !elements)], why)?;
        let bricks = |m: &&Model| matches!(m, Model::Elements(Elements::ThreeDimensional(_)));
        let why = "it applies only to the bricks of `model` fe3d";
        let unused = self.keep != Match::default() && !models.iter().any(bricks);
        Problem::refuse_unused(&[("match", unused)], why)
    }

    /// Refuses a terminal of models that have none.
    fn no_terminal(&self) -> Result<()> {
        if self.terminal.is_none() {
            return Ok(());
        }
        let message = "only `model` fe3d can model the terminal as a body";
        let hint = "the other models have rigid planes: leave it out";
        Err(Problem::new(ProblemKind::Terminal, message, hint).in_field("terminal"))
    }
}

/// Refuses both branches where one is requested, or where the friction is not known.
pub fn check_both(options: Options, muscle: &Muscle) -> Result<()> {
    if options.direction.is_mean() {
        return check_branch(
            Options {
                direction: Direction::Contraction,
                ..options
            },
            muscle,
        );
    }
    let hint = "leave one of them out";
    Err(Problem::new(
        ProblemKind::Usage,
        "`direction` selects one branch and `both` selects two",
        hint,
    ))
}

/// Refuses a branch of the hysteresis of a muscle whose friction is neither stated nor estimated.
pub fn check_branch(options: Options, muscle: &Muscle) -> Result<()> {
    if options.direction.is_mean() || muscle.friction().is_some() || options.friction_share > 0.0 {
        return Ok(());
    }
    let message = "`direction` needs the braid's friction, which this muscle does not state; it is \
        estimated only of muscles that contract";
    let hint = "add [friction] with coefficient (N at 1 MPa) and exponent to the muscle file";
    Err(Problem::new(ProblemKind::MissingInput, message, hint))
}
