//! Points in a folder of the library.

use mckibben::muscle::Direction;
use mckibben_app::points_table;
use mckibben_fit::measured::{DataPoint, MeasuredPoint, Quantity, Section, read_data};

/// An identity: what is written reads back as the same points.
#[test]
fn points_that_are_written_read_back_the_same() {
    let at = |pressure_mpa, contraction, force_n, branch| MeasuredPoint {
        pressure_mpa,
        contraction,
        force_n,
        branch,
    };
    let plain = [
        DataPoint::of(at(0.1, 0.0, 123.456_789, Direction::Mean)),
        DataPoint::of(at(1.0 / 3.0, 0.07, 12.0, Direction::Mean)),
    ];
    assert_eq!(points_table(&plain).lines().next(), Some("pressure_mpa,contraction,force_n"));
    let section = Section { length_mm: Some(233.0), outer_diameter_mm: Some(13.6), ..Section::default() };
    let rich = [
        DataPoint { section, error: Some(2.5), ..DataPoint::of(at(0.2, 0.1, 50.0, Direction::Contraction)) },
        DataPoint {
            section,
            measured: Quantity::Contraction,
            weight: 0.5,
            error: Some(0.01),
            ..DataPoint::of(at(0.2, 0.2, 20.0, Direction::Elongation))
        },
    ];
    for points in [&plain, &rich] {
        let read = read_data(points_table(points).as_bytes()).unwrap();
        let same: Vec<DataPoint> = read.into_iter().map(|p| DataPoint { line: 0, ..p }).collect();
        assert_eq!(same, points);
    }
}
