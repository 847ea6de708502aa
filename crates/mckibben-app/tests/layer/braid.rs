//! Tubes on which a sleeve is shown.

use super::reply;
use serde_json::json;

#[test]
fn diameters_are_round_and_inside() {
    let tubes = |name: &str| -> Vec<f64> {
        let shown = reply("parts-show", json!({ "name": name }));
        let points = shown["sleeve"]["points"].as_array().unwrap();
        points
            .iter()
            .map(|point| point["outer_diameter_mm"].as_f64().unwrap())
            .collect()
    };
    let round = [
        10.0, 12.0, 14.0, 16.0, 18.0, 20.0, 22.0, 24.0, 26.0, 28.0, 30.0, 32.0,
    ];
    assert_eq!(
        tubes("flexo-overexpanded-0.38in"),
        [&[9.525], &round[..]].concat()
    );
    assert_eq!(tubes("nfl-19")[..3], [15.0, 16.0, 18.0]);
}
