//! Finite elements for McKibben muscles: the axisymmetric muscle in real time, and the
//! three-dimensional one as its reference.
//!
//! With a balanced braid there is no torsion, so the whole state is (r, z)(R, Z), and one potential
//! rules:
//!
//! ```text
//! Π(u; P, L) = W_tube(u) + W_braid(u) − P·V(u),   equilibrium ∂Π/∂u = 0,   pull F = −dΠ/d(ΔL)
//! ```
//!
//! | part | what it does |
//! |---|---|
//! | [`element`] | Q2/P−1 rubber of any law, two strand families on a line; bricks and single strands |
//! | [`load`] | the cavity's volume with its derivatives |
//! | [`solver`] | dense, chained and sparse factorisations, Newton's method; the continuation that finds equilibria and curves |
//! | [`axisymmetric`] | mesh, assembly, equilibrium, first guesses, the muscle as a [`ForceModel`](mckibben_core::model::ForceModel), sensitivities |
//! | [`three_dimensional`] | the same muscle in bricks with single strands |
//! | [`simulation`], [`results`] | questions to either, and answers |
//! | [`elements`] | both by name, with their mesh |
//!
//! ```
//! use mckibben_core::model::{ForceModel, Workspace};
//! use mckibben_core::muscle::Muscle;
//! use mckibben_fem::axisymmetric::Axisymmetric;
//! use mckibben_fem::simulation::{Detail, ElementModel};
//!
//! let (muscle, workspace) = (Axisymmetric::between_ends(&Muscle::prototype())?, &mut Workspace::new());
//! let force = muscle.force_n(workspace, 0.25, 0.10)?;
//! assert!((force - 491.43).abs() < 0.01);
//! let curve = muscle.isometric(workspace, 0.10, &[0.05, 0.15, 0.25], Detail::Point);
//! assert_eq!(curve.iter().flatten().filter(|point| point.force_n < 0.0).count(), 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Units: mm, MPa (= N/mm²), N.

// The physics is documented on its public types.
#![warn(clippy::print_stdout, clippy::print_stderr)]
// Components, nodes, rows and columns are counted: several arrays share an index.
#![allow(clippy::needless_range_loop)]

pub mod axisymmetric;
pub mod element;
pub mod elements;
mod error;
pub mod load;
pub mod output;
pub mod results;
mod seated;
pub mod simulation;
pub mod solver;
pub mod three_dimensional;

pub use error::{FemError, Result};
pub use seated::with_ends;
pub use simulation::ElementModel;
