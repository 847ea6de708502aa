//! Every command of mckibben as a request and an answer.
//!
//! A front end (command line, page, Python, server) fills in a request, calls one function, and
//! shows the answer:
//!
//! ```
//! use mckibben_app::{ForceRequest, force};
//!
//! let request = ForceRequest {
//!     pressure_mpa: Some(0.25.into()),
//!     contraction: Some("10%".parse()?),
//!     ..Default::default()
//! };
//! let answer = force(&request)?;
//! assert_eq!(answer.point.model, "fe");
//! assert!((answer.point.response.force_n - 491.43).abs() < 0.01);
//! # Ok::<(), mckibben_app::Problem>(())
//! ```
//!
//! Requests and answers are plain data with serde; their JSON is that of the command line, and
//! [`schema`] describes it. A [`Problem`] says why there is no answer, in words that hold in every
//! front end. Files are read by the front end and handed over as text ([`TextFile`]), so that all
//! this runs without an operating system too; only campaigns, which live on disk, need the feature
//! `files`. A panic is a [`Problem`] as well, where [`guarded`] is around the call.
//!
//! Which model answers is decided in one place, [`ModelFields::choose`].
//!
//! Units: mm, MPa (= N/mm²), N.

#![warn(clippy::print_stdout, clippy::print_stderr)]
// The documentation of a request's field is its help too, which shows defaults in brackets.
#![allow(rustdoc::broken_intra_doc_links)]

mod batch;
mod braid;
mod build;
#[cfg(feature = "files")]
mod bundle;
mod burst;
#[cfg(feature = "files")]
mod campaign;
mod check;
mod commands;
mod compare;
mod contraction;
mod count;
mod curve;
mod design;
mod export;
mod fields;
mod figure;
#[cfg(feature = "files")]
mod file_schema;
mod files;
mod fill;
mod fit;
mod flags;
mod identify;
mod joint;
mod library;
mod load;
mod model;
mod motion;
mod muscle;
mod muscle_fields;
mod parts;
mod plan;
mod point;
pub mod print;
mod problem;
mod quantities;
mod report;
mod rubber;
mod rubber_fit;
#[cfg(feature = "files")]
mod schemas;
mod shape;
mod simulate;
mod uncertainty;
mod unique_keys;
pub mod units;
mod warnings;
pub mod words;

pub use batch::{ArrayError, BoundModel, Many, PointQuantity, with_parameters};
pub use braid::*;
pub use build::*;
#[cfg(feature = "files")]
pub use bundle::{bundle, schema};
pub use burst::*;
#[cfg(feature = "files")]
pub use campaign::*;
pub use check::*;
pub use commands::{
    COMMANDS, CommandEntry, Ready, ask, ask_packed, ask_value, find, packed, understood,
};
pub use compare::*;
pub use contraction::*;
pub use count::Count;
pub use curve::*;
pub use design::*;
pub use export::*;
pub use fields::*;
pub use figure::model_colour;
#[cfg(feature = "files")]
pub use file_schema::file_schema;
pub use fill::*;
pub use fit::*;
pub use identify::*;
pub use joint::*;
pub use library::*;
pub use load::{LoadAnswer, LoadFields, LoadedAt};
pub use mckibben_core::model::ModelEntry;
pub use mckibben_design::TubePart;
pub use mckibben_motion::{Event, Subject};
pub use model::*;
pub use motion::*;
pub use muscle::*;
pub use parts::*;
pub use plan::*;
pub use point::*;
pub use problem::*;
pub use quantities::*;
pub use report::{TitleBlock, body};
pub use rubber::*;
pub use rubber_fit::*;
pub use shape::*;
pub use simulate::*;
pub use uncertainty::*;
pub use unique_keys::UniqueKeys;
pub use units::{Scale, Units};
pub(crate) use words::{number, percent};
