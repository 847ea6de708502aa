//! McKibben pneumatic muscles: rubber laws, force models, their inverses and curves.
//!
//! Data flows one way: specification → [`muscle`] → [`model`] → response → curve → figure. The
//! central trait is [`model::ForceModel`]: whatever answers F(P, ε) for a muscle can be inverted,
//! plotted, compared and designed with (`mckibben-fit`, `mckibben-design`).
//!
//! Units: mm, MPa (= N/mm²), N. Angles are in degrees where a name says `_deg`.
//!
//! A first session: build a muscle and ask a model.
//!
//! ```
//! use mckibben_core::{
//!     analysis::{Evaluation, Options},
//!     model::{ForceModel, ThickWall, Workspace},
//!     muscle::Muscle,
//! };
//!
//! // A tube of 40 mm with a wall of 2 mm; length, braid and rubber are those of the paper's prototype.
//! let muscle = Muscle::prototype().with_section(40.0, 2.0)?;
//! let model = ThickWall::between_ends(&muscle);
//! let workspace = &mut Workspace::new();
//!
//! // What does it pull at 0.25 MPa, contracted by 10 %, and how far does it bulge?
//! let pull = model.response(workspace, 0.25, 0.10)?;
//! assert!(pull.force_n > 900.0 && pull.bulged_diameter_mm > Some(50.0));
//! // Which pressure gives 500 N there, and how far does it contract when nothing holds it?
//! let mut model = Evaluation::new(&model, workspace, Options::default());
//! assert!(model.pressure_at(500.0, 0.10)? < 0.25);
//! assert!(model.free_contraction(0.25)? < muscle.max_ideal_contraction());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Finite elements, deformed shapes for ParaView (VTU) and campaigns are in the crates
//! `mckibben-fem` and `mckibben-campaign`, which has four longer examples: a first muscle, a rubber
//! and a formula of one's own, and constants from a bench (`crates/mckibben-campaign/examples`).

// The physics is documented on its public types.
#![warn(clippy::print_stdout, clippy::print_stderr)]

pub mod analysis;
pub mod answer;
pub mod built;
pub mod by_number;
pub mod catalogue;
pub mod curve;
pub mod differences;
pub mod extremes;
pub mod formula;
pub mod hash;
pub mod joint;
pub mod liquid;
pub mod load;
pub mod model;
pub mod muscle;
pub mod progress;
pub mod random;
pub mod refused;
pub mod rubber;
pub mod size;
pub mod sleeve;
pub mod status;
pub mod study;
pub mod threads;
pub mod warning;

pub use mckibben_units::{self as units, cancel, clean, joined, nearest};

/// The paper whose formula (11) is [`model::FormulaModel::paper`] and whose method makes formulas
/// from campaigns; equation numbers in code and documents are its. Sources are cited by their key
/// in `literature.bib`.
pub const PAPER: &str = "M. G. Antonelli, P. Beomonte Zobel, W. D'Ambrogio, F. Durante, T. \
    Raparelli, An analytical formula for \
designing McKibben pneumatic muscles, International Journal of Mechanical Engineering and \
Technology 9 (2018) 320–337, \
hdl:11697/130466 [antonelli2018]";
