//! `force`, `pressure`, `contraction`: one point.

use crate::{Args, Problem};

/// F(P, ε).
pub fn force(args: &Args) -> Result<u8, Problem> {
    args.output(&mckibben_app::force(&args.request()?)?)
}

/// P(F, ε).
pub fn pressure(args: &Args) -> Result<u8, Problem> {
    args.output(&mckibben_app::pressure(&args.request()?)?)
}

/// ε(F, P).
pub fn contraction(args: &Args) -> Result<u8, Problem> {
    args.output(&mckibben_app::contraction(&args.request()?)?)
}
