//! Every model there is, by name: the closed forms of the library and the finite elements.

use crate::failure::Failure;
use crate::flags::MatchWord;
use mckibben::formula::{Document, Formula, UniversalFormula};
use mckibben::model::{ForceModel, FormulaModel, ModelError, ModelKind, Universal};
use mckibben::muscle::Muscle;
use mckibben::units::Dimension;
use mckibben_fem::axisymmetric::{Axisymmetric, FemError, MeshSpec};
use mckibben_fem::simulation::Simulation;
use mckibben_fem::three_dimensional::{BrickMesh, BrickSpec, Match, Plug, PlugMaterial, ThreeDimensional};
use std::sync::Arc;

/// A model by name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// A closed form.
    Closed(ModelKind),
    /// Axisymmetric finite elements.
    Fe(MeshSpec),
    /// Three-dimensional finite elements.
    Fe3d(BrickSpec),
    /// A fitted formula. It is read once and kept until the program ends, so that a kind stays a small value.
    Formula(&'static Arc<Formula>),
    /// A fitted formula for muscles of every make, likewise.
    Universal(&'static Arc<UniversalFormula>),
    /// What `design` proposes with outside of the paper's box: `universal` where the muscle, the highest pressure and the largest
    /// contraction lie in its box, else `thick-wall`.
    Proposing {
        /// Highest pressure in MPa.
        pressure_mpa: f64,
        /// Largest contraction.
        contraction: f64,
    },
}

const FE: &str = "fe";
const FE_ABOUT: &str = "axisymmetric finite elements: any rubber, wall, braid and length, with the ends";

const FE3D: &str = "fe3d";
const FE3D_ABOUT: &str = "three-dimensional finite elements: bricks and single strands; the reference for fe";

impl Kind {
    /// Name and one line of every model.
    pub fn all() -> Vec<(&'static str, &'static str)> {
        let closed = ModelKind::ALL.into_iter().map(|k| (k.name(), k.description()));
        closed.chain([(FE, FE_ABOUT), (FE3D, FE3D_ABOUT)]).collect()
    }

    /// A model's name, or the path of a formula's JSON; finite elements are built on the mesh that the flags say.
    pub fn parse(name: &str, flags: &MeshFlags<'_>) -> Result<Self, Failure> {
        let name = name.trim();
        if name == FE3D {
            return flags.bricks().map(Kind::Fe3d);
        }
        if flags.terminal.is_some() {
            return Err(MeshFlags::no_terminal());
        }
        let mesh = flags.section()?;
        if name == FE {
            return Ok(Kind::Fe(mesh));
        }
        let is_file = || name.parse::<ModelKind>().is_err() && std::path::Path::new(name).is_file();
        if name.to_ascii_lowercase().ends_with(".json") || is_file() {
            return Ok(match Document::read(name)? {
                Document::Section(f) => Kind::Formula(Box::leak(Box::new(Arc::new(f)))),
                Document::Universal(f) => Kind::Universal(Box::leak(Box::new(Arc::new(f)))),
            });
        }
        let known = name.parse::<ModelKind>();
        known.map(Kind::Closed).map_err(|e| {
            let all = format!("{FE}, {FE3D}");
            let message = format!("{e}, {all}").replace(&format!("?, {all}"), "?");
            Failure::input("model", message, "`mckibben models` describes them")
        })
    }

    /// Whether a word is the name of a model already.
    pub fn is_taken(name: &str) -> bool {
        [FE, FE3D].contains(&name.trim()) || name.trim().parse::<ModelKind>().is_ok()
    }

    /// Whether the model of this name knows `--terminal`.
    pub fn has_terminal(name: &str) -> bool {
        name.trim() == FE3D
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Closed(kind) => kind.name(),
            Kind::Fe(_) => FE,
            Kind::Fe3d(_) => FE3D,
            Kind::Formula(formula) => &formula.name,
            Kind::Universal(formula) => &formula.name,
            Kind::Proposing { .. } => ModelKind::Universal.name(),
        }
    }

    /// Diameters and walls it was made for, where it is bound to some.
    pub fn sections(self) -> Option<((f64, f64), (f64, f64))> {
        match self {
            Kind::Formula(f) => Some((f.range.outer_diameter_mm, f.range.wall_mm)),
            Kind::Closed(ModelKind::Paper) => Some(((30.0, 50.0), (1.0, 5.0))),
            _ => None,
        }
    }

    /// The model of a muscle.
    pub fn build(self, muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
        match self {
            Kind::Closed(kind) => kind.build(muscle),
            Kind::Fe(mesh) => match Axisymmetric::with_mesh(muscle, &mesh) {
                Ok(model) => Ok(Box::new(model)),
                Err(error) => Err(error.into_model(0.0, 0.0)),
            },
            Kind::Fe3d(spec) => match ThreeDimensional::with_mesh(muscle, &spec) {
                Ok(model) => Ok(Box::new(model)),
                Err(error) => Err(error.into_model(0.0, 0.0)),
            },
            Kind::Formula(formula) => Ok(Box::new(FormulaModel::new(Arc::clone(formula), muscle))),
            Kind::Universal(formula) => Ok(Box::new(Universal::new(Arc::clone(formula), muscle))),
            Kind::Proposing { pressure_mpa, contraction } => {
                let model = ModelKind::Universal.build(muscle)?;
                match model.range().check(model.name(), pressure_mpa, contraction) {
                    Ok(()) => Ok(model),
                    Err(_) => ModelKind::ThickWall.build(muscle),
                }
            }
        }
    }

    /// Why a muscle is not answered by the model of this name but by `thick-wall`; `None` where it is.
    pub fn replaced(self, muscle: &Muscle) -> Option<String> {
        let Kind::Proposing { pressure_mpa, contraction } = self else { return None };
        let model = ModelKind::Universal.build(muscle).ok()?;
        let outside = model.range().check(model.name(), pressure_mpa, contraction).err()?;
        Some(format!("by thick-wall, since it is {outside}"))
    }
}

/// A finite-element model, to look inside.
pub enum Meshed {
    /// Axisymmetric.
    Axisymmetric(Box<Axisymmetric>),
    /// Three-dimensional.
    ThreeDimensional(Box<ThreeDimensional>),
}

impl Meshed {
    /// What both have in common.
    pub fn simulation(&self) -> &dyn Simulation {
        match self {
            Self::Axisymmetric(model) => model.as_ref(),
            Self::ThreeDimensional(model) => model.as_ref(),
        }
    }
}

impl Kind {
    /// The finite elements of a muscle; `None` where the model is none.
    pub fn elements(self, muscle: &Muscle) -> Option<Result<Meshed, FemError>> {
        match self {
            Kind::Fe(mesh) => {
                Some(Axisymmetric::with_mesh(muscle, &mesh).map(|m| Meshed::Axisymmetric(Box::new(m))))
            }
            Kind::Fe3d(spec) => Some(
                ThreeDimensional::with_mesh(muscle, &spec).map(|m| Meshed::ThreeDimensional(Box::new(m))),
            ),
            _ => None,
        }
    }
}

/// `--mesh`, `--match` and `--terminal`.
#[derive(Debug, Clone, Copy, Default)]
pub struct MeshFlags<'a> {
    /// The mesh, in words of the model.
    pub text: Option<&'a str>,
    /// What fe3d keeps.
    pub keep: MatchWord,
    /// The terminal of fe3d.
    pub terminal: Option<&'a str>,
}

impl MeshFlags<'_> {
    /// Of `fe`: 8, 2x8 (through x along), or 2x8:2 with the grading towards the terminal.
    fn section(&self) -> Result<MeshSpec, Failure> {
        let Some(text) = self.text else { return Ok(MeshSpec::default()) };
        let wrong = || {
            let message = format!(
                "--mesh: \"{text}\" is no mesh; expected elements along the half length (8), through the wall x along (2x8), with a grading towards the terminal if you like (2x8:2)"
            );
            Failure::input("mesh", message, "leave it out and the program chooses")
        };
        let spec = MeshSpec::parse(text).ok_or_else(wrong)?;
        // The numbers themselves are checked where the mesh is made; here only for the message.
        spec.resolve(10.0, 1.0, 100.0).map_err(|e| Failure::input("mesh", format!("--mesh: {e}"), ""))?;
        Ok(spec)
    }

    /// Of `fe3d`: 12 (around the quarter), 2x12 (through x around), 2x12x39 (x along), :circle, :quadratic.
    fn bricks(&self) -> Result<BrickSpec, Failure> {
        let (keep, plug) = (self.keep.into(), self.plug()?);
        let Some(text) = self.text else { return Ok(BrickSpec { keep, plug, ..BrickSpec::default() }) };
        let wrong = || {
            let message = format!(
                "--mesh: \"{text}\" is no mesh of fe3d; expected bricks around the quarter (12), through the wall x around (2x12), or through x around x along the half length (2x12x39), with :quadratic or :circle behind if you like"
            );
            Failure::input("mesh", message, "leave it out and the program chooses")
        };
        let spec = BrickSpec { keep, plug, ..BrickSpec::parse(text).ok_or_else(wrong)? };
        BrickMesh::check(&spec).map_err(|e| Failure::input("mesh", format!("--mesh: {e}"), ""))?;
        Ok(spec)
    }
}

impl MeshFlags<'_> {
    /// What is said where `--terminal` comes with another model.
    pub fn no_terminal() -> Failure {
        let message = "--terminal: only --model fe3d has a terminal that can be a body";
        Failure::input("terminal", message, "the other models have rigid planes: leave it out")
    }

    /// none, rigid or aluminium, with the insertion and the radius of the nose behind: `aluminium:20mm:3mm`.
    fn plug(&self) -> Result<Option<Plug>, Failure> {
        let Some(text) = self.terminal else { return Ok(None) };
        let wrong = || {
            let message = format!(
                "--terminal: \"{text}\" is no terminal; expected none, rigid or aluminium, with the insertion and the radius of the nose behind if you like (aluminium:20mm:3mm)"
            );
            Failure::input("terminal", message, "leave it out for a rigid plane")
        };
        let mut words = text.split(':');
        let material = match words.next().map(str::trim) {
            Some("none") if !text.contains(':') => return Ok(None),
            Some("rigid") => PlugMaterial::Rigid,
            Some("aluminium" | "aluminum") => PlugMaterial::Aluminium,
            _ => return Err(wrong()),
        };
        let mut length = || -> Result<Option<f64>, Failure> {
            let Some(word) = words.next() else { return Ok(None) };
            crate::resolve::quantity("--terminal", Some(word), Dimension::Length)
        };
        let (insertion_mm, nose_mm) = (length()?, length()?);
        if words.next().is_some() {
            return Err(wrong());
        }
        Ok(Some(Plug { material, insertion_mm, nose_mm }))
    }
}

impl From<MatchWord> for Match {
    fn from(word: MatchWord) -> Self {
        match word {
            MatchWord::Length => Self::Length,
            MatchWord::Angle => Self::Angle,
        }
    }
}
