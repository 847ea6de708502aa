//! `force`, `pressure`, `contraction`: one point.

use crate::{Asked, Bar, Failure, burst_first, output::loaded::loaded, pairs, shown};
use mckibben_app::{PointAnswer, PointQuantity, rows::point_rows};

/// F(P, ε).
pub fn force(asked: &Asked) -> Result<u8, Failure> {
    show(asked, mckibben_app::force(&asked.request()?, &Bar::hidden())?, PointQuantity::Force)
}

/// P(F, ε).
pub fn pressure(asked: &Asked) -> Result<u8, Failure> {
    show(asked, mckibben_app::pressure(&asked.request()?, &Bar::hidden())?, PointQuantity::Pressure)
}

/// ε(F, P).
pub fn contraction(asked: &Asked) -> Result<u8, Failure> {
    show(asked, mckibben_app::contraction(&asked.request()?, &Bar::hidden())?, PointQuantity::Contraction)
}

fn show(asked: &Asked, answer: PointAnswer, of: PointQuantity) -> Result<u8, Failure> {
    let text = || {
        let u = shown::units();
        let load = answer.loaded.as_ref().map_or_else(String::new, |load| loaded(load, &u));
        burst_first(&answer.point.warnings) + &pairs(&point_rows(&answer, of, &u)) + &load
    };
    asked.show(&answer, "", text)
}
