//! What may be in the table `[vary]`.

use super::{
    axis::{Axis, CONSTANT, RUBBER, SCALE},
    sampling::SamplingMethod,
};
use mckibben_core::{
    joined,
    muscle::{
        NEUTRAL_ANGLE_DEG,
        file::{FileError, Source},
        measures::{ANGLE, Bounds},
    },
    rubber::Law,
    units::Values,
};

/// Pairs of which a plan has one.
const EITHER: [(&str, &str); 3] = [
    ("tube.wall_thickness", "tube.wall_ratio"),
    ("tube.length", "tube.length_ratio"),
    ("braid.stiffness", "braid.stiffness_per_diameter"),
];

/// The key of what a varied quantity stands in place of: its own, or that of which it is a ratio.
fn stated_key(key: &str) -> &str {
    EITHER
        .iter()
        .find(|pair| pair.1 == key)
        .map_or(key, |pair| pair.0)
}

pub fn check_all(
    axes: &[Axis],
    source: &Source<'_>,
    law: &Law,
    method: SamplingMethod,
) -> Result<(), FileError> {
    for (i, axis) in axes.iter().enumerate() {
        let wrong = |why: String| match method {
            SamplingMethod::Table => source.error("samples", format!("{} {why}", axis.key)),
            _ => source.error(&format!("vary.{}", axis.key), why),
        };
        check(axis, law, method).map_err(wrong)?;
        let by_rubber = |a: &Axis| a.key == RUBBER;
        if axis.key.starts_with(CONSTANT) && axis.key != SCALE && axes.iter().any(by_rubber) {
            let why = "is a constant of one law, and tube.rubber varies: vary tube.material.scale";
            return Err(wrong(why.into()));
        }
        if by_rubber(axis) && source.has("tube.material") {
            return Err(wrong(
                "varies, and tube.material is stated: leave that out".into(),
            ));
        }
        let stated = stated_key(&axis.key);
        if !stated.starts_with(CONSTANT) && source.has(stated) {
            return Err(wrong(format!(
                "varies, and {stated} is stated: leave that out"
            )));
        }
        if stated != axis.key && axes[..i].iter().any(|a| a.key == stated) {
            return Err(wrong(format!(
                "vary either this or {stated}; both are given"
            )));
        }
    }
    Ok(())
}

/// Refuses a value that a list has twice.
pub fn distinct(list: &[f64]) -> Result<(), String> {
    let mut sorted = list.to_vec();
    sorted.sort_by(f64::total_cmp);
    match sorted.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => Err(format!("contains {} twice", pair[0])),
        None => Ok(()),
    }
}

/// Checks an axis; the error is a sentence behind its key.
fn check(axis: &Axis, law: &Law, method: SamplingMethod) -> Result<(), String> {
    let interval = matches!(axis.values, Values::Interval(..));
    let (low, high) = axis.values.bounds();
    if axis.key == RUBBER {
        let some = !axis.names.is_empty();
        return some.then_some(()).ok_or_else(|| "is an empty list".into());
    }
    if let Values::List(list) = &axis.values {
        distinct(list)?;
    }
    if interval && method == SamplingMethod::Factorial {
        return Err(
            "is a range without a step, and a factorial plan needs levels: give a list \
            (30,40,50) or a step (10..60:10), or another [sampling] method"
                .into(),
        );
    }
    if axis.log && !interval {
        return Err("is a list, and `log` goes with a range such as 0.04..0.4 log".into());
    }
    let mut least = 0.0;
    let constant = axis
        .key
        .strip_prefix(CONSTANT)
        .filter(|_| axis.key != SCALE);
    if let Some(name) = constant {
        let constants = law.constants();
        let Some(constant) = constants.iter().find(|c| c.name == name) else {
            return Err(format!(
                "is not a constant of the {} law of the base muscle; its constants are {}",
                law.name(),
                joined(constants.iter().map(|c| c.name.as_str()), ", ")
            ));
        };
        least = constant.constant.bounds.0;
    }
    if let Some(measure) = axis.measure()
        && measure.bounds != Bounds::Positive
        && measure.bounds != Bounds::OfPart
    {
        let all = match &axis.values {
            Values::List(list) => list.clone(),
            Values::Interval(..) if measure.bounds == Bounds::Even => {
                return Err(
                    "is a range without a step, and a count needs levels: give a list \
                    (24,36,48) or a step (24..48:12)"
                        .into(),
                );
            }
            Values::Interval(..) => vec![low, high],
        };
        if let Some(error) = all.into_iter().find_map(|value| measure.check(value).err()) {
            return Err(format!("is not possible: {error}"));
        }
        least = f64::NEG_INFINITY;
    }
    if axis.log {
        least = least.max(0.0);
    }
    if low <= least {
        let least = if least == 0.0 {
            "zero".to_owned()
        } else {
            least.to_string()
        };
        return Err(format!("begins at {low}; it must be above {least}"));
    }
    if axis.key == ANGLE.key && high >= NEUTRAL_ANGLE_DEG {
        return Err(format!(
            "reaches {high} deg; a muscle that contracts needs an angle between 0 and \
             {NEUTRAL_ANGLE_DEG:.4} deg to its axis"
        ));
    }
    if axis.key == "tube.wall_ratio" && high >= 0.5 {
        return Err(format!(
            "reaches {high}; a wall of half the outer diameter leaves no bore"
        ));
    }
    Ok(())
}
