//! mckibben for Python: `mckibben._native`, on which the Python package is built.
//!
//! A thin border. Requests and answers are maps and lists of Python, turned into those of the
//! application layer by way of JSON ([`ask`]); lists of numbers are NumPy arrays, read where they
//! lie ([`model`]). The interpreter is released around all work, and hears of it now and then
//! ([`run`]): a progress bar moves, Ctrl-C ends the work. What is wrong is raised as one of the
//! package's exceptions ([`error`]); a panic is one of them.

mod ask;
mod error;
mod files;
mod formula;
mod joint;
mod model;
mod muscle;
mod request;
mod run;
mod simulation;
mod value;
mod view;

use pyo3::pymodule;

/// The compiled half of mckibben; what users call is in the package `mckibben`.
#[pymodule(gil_used = false)]
mod _native {
    #[pymodule_export]
    use crate::{
        ask::{ask, quantities, quantity, unit_of},
        files::{read, toml, toml_text, write_file},
        formula::Formula,
        joint::Joint,
        model::Model,
        muscle::Muscle,
        request::{stated_request, unlikely},
        simulation::{Simulation, rollout},
        view::page_html,
    };

    /// The version of the crates, and of the package.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");

    /// The sources that code and data name, BibTeX.
    #[pymodule_export]
    const LITERATURE: &str = include_str!("../../../literature.bib");

    #[pymodule_init]
    fn init() {
        mckibben_app::panics_are_problems();
    }
}
