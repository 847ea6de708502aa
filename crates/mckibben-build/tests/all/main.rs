//! Builds.

mod files;
mod plugs;
