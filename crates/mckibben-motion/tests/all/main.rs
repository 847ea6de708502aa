//! Motion against closed forms, identities and rates of convergence.

mod chamber;
mod control;
mod frequency;
mod mechanics;
mod refusals;
mod support;
