//! The ranges by which the core tells that a muscle was not measured are those of the measured
//! muscles of the program.

use super::measured;
use mckibben_core::{
    built::{MEASURED, measured_values},
    extremes::ends,
};

#[test]
fn identity_the_ranges_of_the_core_are_those_of_the_measured_muscles() {
    let points = measured().iter().flat_map(|of| {
        of.points.iter().filter_map(|point| {
            let muscle = point.section.apply(&of.muscle).ok()?;
            Some(measured_values(&muscle, point.at.pressure_mpa))
        })
    });
    let all: Vec<[f64; 5]> = points.collect();
    for (i, (name, _, stated)) in MEASURED.into_iter().enumerate() {
        let (low, high) = ends(all.iter().map(|values| values[i]));
        let low = if name == "the pressure" { 0.0 } else { low };
        for (stated, found) in [(stated.0, low), (stated.1, high)] {
            assert!(
                (stated - found).abs() <= 1e-6 * found,
                "{name}: {stated} {found}"
            );
        }
    }
}
