//! A note on a pressure that was typed without its unit.

use mckibben_core::{
    joined,
    units::{Dimension, short_numbers},
};

/// A bare number is a pressure in MPa; where that is high, bar was probably meant.
pub fn unit_note(flag: &str, text: &str) -> Option<String> {
    const HIGH_MPA: f64 = 1.0;
    if !(flag.ends_with("pressure") || flag == "--supply") {
        return None;
    }
    let numbers: Result<Vec<f64>, _> = text
        .replace("..", ",")
        .split([',', ':'])
        .map(|part| part.trim().parse())
        .collect();
    Some(format!(
        "{flag} {text}: {}",
        meant(numbers.ok()?.into_iter().find(|p| *p >= HIGH_MPA)?)
    ))
}

/// What a bare pressure as high as no muscle bears may have been meant to be.
fn meant(mpa: f64) -> String {
    /// Pressures of muscles in MPa.
    const USUAL: std::ops::RangeInclusive<f64> = 0.08..=1.2;
    let units = ["bar", "psi", "kPa", "mbar", "Pa"];
    let is_usual = |unit: &&str| {
        let unit = Dimension::Pressure.unit(unit);
        unit.is_some_and(|unit| USUAL.contains(&unit.inside(mpa)))
    };
    let likely = Vec::from_iter(units.into_iter().filter(is_usual));
    let [mpa, bar] = [mpa, 10.0 * mpa].map(|v| short_numbers(&v.to_string()).into_owned());
    let said = format!("a bare {mpa} is {mpa} MPa = {bar} bar");
    match likely[..] {
        [] => format!("{said}; for bar write {mpa}bar"),
        [one] => format!("{said}; was {one} meant? write {mpa}{one}"),
        _ => {
            let write = joined(likely.iter().map(|unit| format!("{mpa}{unit}")), " or ");
            format!("{said}; was {} meant? write {write}", likely.join(" or "))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_high_bare_pressure_has_a_likely_unit() {
        for (mpa, said) in [
            (6.0, "6 MPa = 60 bar; was bar meant? write 6bar"),
            (36.0, "36 MPa = 360 bar; was psi meant? write 36psi"),
            (
                100.0,
                "100 MPa = 1000 bar; was psi or kPa meant? write 100psi or 100kPa",
            ),
            (250.0, "was kPa meant? write 250kPa"),
            (250_000.0, "was Pa meant? write 250000Pa"),
            (40.0e6, "for bar write 40000000bar"),
        ] {
            let text = meant(mpa);
            assert!(text.contains(said), "{text}");
        }
    }
}
