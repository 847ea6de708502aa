//! Motion against closed forms, identities and rates of convergence.

mod chamber;
mod mechanics;
mod support;
