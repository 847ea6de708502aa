//! `force`, `pressure`, `contraction`: one point.

use crate::{Asked, Bar, Failure, burst_first, output::loaded::loaded, pairs, shown};
use mckibben_app::{PointAnswer, PointQuantity, rows::point_rows};

pub const FORCE: &str = "force: Pull at a pressure and contraction: F(P, ε)
Question: p/pressure_mpa e/contraction @both
@muscle @model @output
Example:
  mckibben force -D 50 -s 1 -p 0.25 -e 0.1 --model paper";

pub const PRESSURE: &str = "pressure: Pressure that gives a pull at a contraction: P(F, ε)
Question: F/force_n e/contraction @both
@muscle @model @output
Example:
  mckibben pressure -D 40 -s 2 -F 300N -e 10% --units bar";

pub const CONTRACTION: &str = "contraction: Contraction at which a pressure gives a pull: ε(F, P)
Question: p/pressure_mpa F/force_n @load @both
@muscle @model @output
Example:
  mckibben contraction -D 40 -s 2 -F 600N -p 2.5bar";

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
