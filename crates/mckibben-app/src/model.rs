//! Every model there is, by name, and the one policy of which of them answers.

use crate::{
    Direction, MeshFields, ModelFields, NameOrFile, Problem, ProblemKind, Result, TextFile,
};
pub use mckibben::Model;
use mckibben_core::{answer::Options, muscle::Muscle};
use mckibben_fem::{
    elements::Elements,
    three_dimensional::{BrickSpec, Match},
};

impl ModelFields {
    /// The model that answers a request, and the only rule about it: the one that is named; where
    /// none is, `fe`.
    pub fn choose(&self) -> Result<Model> {
        let model = match &self.name {
            Some(name) => self.mesh.model_of(name)?,
            None => self.mesh.model("fe")?,
        };
        self.mesh.check_used(&[&model])?;
        Ok(model)
    }
}

/// The model of a formula's file.
pub fn model_from_formula(file: &TextFile) -> Result<Model> {
    if !cfg!(feature = "whole") {
        return Err(ProblemKind::Formula
            .problem("formula files need the full engine; this is a reduced one"));
    }
    Ok(Model::from_formula(&file.text).map_err(|e| e.in_file(std::path::Path::new(&file.name)))?)
}

/// A muscle of the make that a formula is for.
pub fn made_for(model: &Model) -> Result<Option<Muscle>> {
    match model {
        Model::Formula(f) => Ok(Some(f.made_for.muscle(&f.range)?)),
        _ => Ok(None),
    }
}

impl MeshFields {
    /// The model of a name, or of a formula's file.
    pub fn model_of(&self, name: &NameOrFile) -> Result<Model> {
        match name {
            NameOrFile::Name(name) => self.model(name),
            NameOrFile::File(file) => self.no_terminal().and_then(|()| model_from_formula(file)),
        }
    }

    /// The model of a name of the list, with this mesh.
    pub fn model(&self, name: &str) -> Result<Model> {
        match name.parse() {
            Ok(Model::Elements(elements)) => Ok(Model::Elements(self.meshed(elements)?)),
            Ok(model) => self.no_terminal().map(|()| model),
            Err(unknown) => {
                self.no_terminal()?;
                Err(ProblemKind::Model.problem(unknown.to_string()))
            }
        }
    }

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
    pub fn check_used(&self, models: &[&Model]) -> Result<()> {
        let elements = models.iter().any(|m| m.is_elements());
        let why = "only `model` fe and fe3d have a mesh";
        Problem::refuse_unused(&[("mesh", self.mesh.is_some() && !elements)], why)?;
        let bricks = |m: &&Model| matches!(m, Model::Elements(Elements::ThreeDimensional(_)));
        let why = "it applies only to the bricks of `model` fe3d";
        Problem::refuse_unused(
            &[(
                "match",
                self.keep != Match::default() && !models.iter().any(bricks),
            )],
            why,
        )
    }

    /// Refuses a terminal of models that have none.
    fn no_terminal(&self) -> Result<()> {
        if self.terminal.is_none() {
            return Ok(());
        }
        Err(Problem::new(
            ProblemKind::Terminal,
            "only `model` fe3d can model the terminal as a body",
            "the other models have rigid planes: leave it out",
        )
        .in_field("terminal"))
    }
}

/// Refuses both branches where one is requested, or where the friction is not known.
pub fn check_both(options: Options, muscle: &Muscle) -> Result<()> {
    let of_job = muscle.job().and_then(|job| job.branch);
    if options.direction.is_mean() || of_job == Some(options.direction) {
        return check_branch(
            Options {
                direction: Direction::Contraction,
                ..options
            },
            muscle,
        );
    }
    Err(Problem::usage(
        "`direction` selects one branch and `both` selects two",
        "leave one of them out",
    ))
}

/// Refuses a branch of the hysteresis of a muscle whose friction is neither stated nor estimated.
pub fn check_branch(options: Options, muscle: &Muscle) -> Result<()> {
    if options.direction.is_mean() || muscle.friction().is_some() || options.friction_share > 0.0 {
        return Ok(());
    }
    Err(Problem::new(
        ProblemKind::MissingInput,
        "`direction` needs the braid's friction, which this muscle does not state; it is \
        estimated only of muscles that contract",
        "add [friction] with coefficient (N at 1 MPa) and exponent to the muscle file",
    ))
}
