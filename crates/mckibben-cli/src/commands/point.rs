//! `force`, `pressure`, `contraction`: one point.

use crate::{Args, Problem, burst_first, output::loaded::loaded, pairs};
use mckibben_app::{PointAnswer, PointQuantity, rows::point_rows};

/// F(P, ε).
pub fn force(args: &Args) -> Result<u8, Problem> {
    show(
        args,
        mckibben_app::force(&args.request()?)?,
        PointQuantity::Force,
    )
}

/// P(F, ε).
pub fn pressure(args: &Args) -> Result<u8, Problem> {
    show(
        args,
        mckibben_app::pressure(&args.request()?)?,
        PointQuantity::Pressure,
    )
}

/// ε(F, P).
pub fn contraction(args: &Args) -> Result<u8, Problem> {
    show(
        args,
        mckibben_app::contraction(&args.request()?)?,
        PointQuantity::Contraction,
    )
}

fn show(args: &Args, answer: PointAnswer, of: PointQuantity) -> Result<u8, Problem> {
    args.show(&answer, "", |answer, u| {
        let load = answer
            .loaded
            .as_ref()
            .map_or_else(String::new, |load| loaded(load, u));
        burst_first(&answer.point.warnings) + &pairs(&point_rows(answer, of, u)) + &load
    })
}
