//! Finite elements for McKibben muscles: the axisymmetric muscle in real time.
//!
//! One potential rules: Π(u; P, L) = W_tube + W_braid − P·V. Equilibrium is ∂Π/∂u = 0 and the pull F = −dΠ/d(ΔL).
//! Units: mm, MPa (= N/mm²), N.

#![cfg_attr(test, allow(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

pub mod axisymmetric;
pub mod element;
pub mod load;
pub mod output;
pub mod solver;
pub mod validation;
pub mod verification;
