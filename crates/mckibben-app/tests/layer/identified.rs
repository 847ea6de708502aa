//! Constants of a drive from a recorded motion, and of a muscle from several tables.

use super::reply;
use serde_json::{Value, json};

const NAMES: [&str; 3] = ["valve.sonic_conductance", "air.dead_volume", "load.damping"];
const TRUE: [f64; 3] = [0.5, 1e4, 200.0];

/// The drive with these constants, of which it states the unit.
fn drive([conductance, volume_mm3, damping]: [f64; 3]) -> String {
    format!(
        "muscle = 'm.toml'\n[valve]\nsonic_conductance = '{conductance} L/(s \
         bar)'\n[air]\ndead_volume = '{volume_mm3} mm3'\n\
         [load]\nmass = '10 kg'\ndamping = '{damping} N s/m'\nstops = '0..100 mm'\n\
         [command]\npressure = [[0, 0], [0.05, 0.3], [0.5, 0.1]]\nuntil = '1 s'\noutput_step = '5 \
         ms'\n"
    )
}

fn moved(drive: &str, log: Option<&str>, free: &[&str]) -> Value {
    let file = |text: &str| json!({ "name": "m.toml", "text": text });
    let muscle = file("[tube]\nouter_diameter = 30\nwall_thickness = 3\n");
    let log = log.map(file);
    let request = json!({ "drive": file(drive), "muscle": muscle, "model": "thick-wall", "log": log, "free": free });
    reply("motion", request)
}

/// What a motion records with normal errors of 2 kPa and 0.1 % (sums of twelve even ones), by the
/// number of their series.
fn log(answer: &Value, series: Option<u64>) -> String {
    let mut seed = series.map(|series| 1 + 7919 * series);
    let mut error = move || {
        let Some(seed) = &mut seed else { return 0.0 };
        let mut even = || {
            *seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (*seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        (0..12).map(|_| even()).sum::<f64>() - 6.0
    };
    let list = |key: &str| {
        answer["series"][key]
            .as_array()
            .unwrap()
            .iter()
            .map(|v| v.as_f64().unwrap())
    };
    let rows = list("time_s").zip(list("pressure_mpa").zip(list("contraction")));
    let row = |(t, (p, e)): (f64, (f64, f64))| {
        let (p, e) = (
            (10.0 * p + 0.02 * error()).max(0.0),
            285.0 * (e + 1e-3 * error()),
        );
        format!("{},{p},{e}\n", 1e3 * t)
    };
    "t [ms],p [bar],Shortening [mm]\n".to_owned() + &rows.map(row).collect::<String>()
}

/// Value, half-width and whether it is identifiable, of each constant.
fn found(answer: &Value) -> Vec<(f64, f64, bool)> {
    let all = answer["parameters"].as_array().unwrap();
    let one = |name: &&str| {
        let p = all.iter().find(|p| p["name"] == *name).unwrap();
        let half_width = p["half_width_95"].as_f64().unwrap_or(f64::INFINITY);
        (
            p["value"].as_f64().unwrap(),
            half_width,
            p["identifiable"].as_bool().unwrap(),
        )
    };
    NAMES.iter().map(one).collect()
}

#[test]
fn a_log_of_our_own_gives_its_constants_back() {
    let exact = moved(&drive(TRUE), None, &[]);
    let answer = moved(&drive([1.0, 3e4, 50.0]), Some(&log(&exact, None)), &[]);
    for ((value, _, is_identifiable), real) in found(&answer).into_iter().zip(TRUE) {
        assert!(
            is_identifiable && (value / real - 1.0).abs() < 1e-3,
            "{value} {real}"
        );
    }
    // The file has them, and its motion is the log, also in the half that was not fitted.
    let again = moved(answer["drive_file"].as_str().unwrap(), None, &[]);
    let rest = |answer: &Value| answer["series"]["contraction"][150].as_f64().unwrap();
    assert!(
        (rest(&again) - rest(&exact)).abs() < 1e-5,
        "{} {}",
        rest(&again),
        rest(&exact)
    );
    for errors in answer["errors"].as_array().unwrap() {
        assert!(errors["held_out_rms"].as_f64().unwrap() < 1e-4, "{errors}");
    }
}

/// 95 % of 12 intervals: 11.4, and fewer than 10 in 1 of 50 times.
#[test]
fn the_intervals_of_a_noisy_log_hold_the_constants() {
    let exact = moved(&drive(TRUE), None, &[]);
    let mut held = 0;
    for series in 0..4 {
        let log = log(&exact, Some(series));
        for ((value, half, _), real) in found(&moved(&drive(TRUE), Some(&log), &[]))
            .into_iter()
            .zip(TRUE)
        {
            assert!(half < 0.6 * real, "{value} ± {half}");
            held += usize::from((value - real).abs() <= half);
        }
    }
    println!("{held} of 12 intervals");
    assert!(held >= 10, "{held}");
}

#[test]
fn what_a_log_does_not_determine_is_said_and_not_written() {
    // The muscle is vented in the second half alone.
    let file = |c: &str| {
        drive(TRUE).replace(
            "[air]",
            &format!("exhaust_conductance = '{c} L/(s bar)'\n[air]"),
        )
    };
    let log = log(&moved(&file("0.3"), None, &[]), Some(1));
    let answer = moved(
        &file("0.4"),
        Some(&log),
        &["valve.sonic_conductance", "valve.exhaust_conductance"],
    );
    let of = |name: &str| {
        answer["parameters"]
            .as_array()
            .unwrap()
            .iter()
            .find(|p| p["name"] == name)
            .unwrap()
    };
    assert_eq!(of("valve.sonic_conductance")["identifiable"], true);
    assert_eq!(of("valve.exhaust_conductance")["identifiable"], false);
    let written = answer["drive_file"].as_str().unwrap();
    assert!(
        written.contains("exhaust_conductance = '0.4 L/(s bar)'"),
        "{written}"
    );
    for errors in answer["errors"].as_array().unwrap() {
        let [fitted, held_out] = ["rms", "held_out_rms"].map(|key| errors[key].as_f64().unwrap());
        assert!(held_out > 3.0 * fitted, "{errors}");
    }
}

/// What the valve makes up for of a dead volume that the muscle of the log does not have.
#[test]
fn a_constant_on_its_bound_keeps_its_value_and_the_others_are_identified_with_it() {
    let log = log(&moved(&drive([0.5, 0.0, 200.0]), None, &[]), Some(1));
    let answer = moved(&drive([0.5, 1e5, 200.0]), Some(&log), &[]);
    let [valve, volume, _] = found(&answer)[..] else {
        panic!()
    };
    assert!(
        valve.2 && valve.0 > 0.6 && !volume.2,
        "{valve:?} {volume:?}"
    );
}

/// An identity: a table with no weight, whatever is in it, is none; and with one it is not.
#[test]
fn a_table_of_weight_zero_is_left_out() {
    let example = |name: &str| {
        let path = crate::root().join("examples").join(name);
        std::fs::read_to_string(path).unwrap()
    };
    let points = example("bench.csv");
    // The same points with pulls that are a fifth larger.
    let larger = points.lines().map(|line| {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        if let Some(Ok(force)) = cells.get(2).map(|cell| cell.parse::<f64>()) {
            cells[2] = (1.2 * force).to_string();
        }
        cells.join(",") + "\n"
    });
    let larger: String = larger.collect();
    assert_ne!(larger, points);
    let constants = |tables: &[&str], weights: Value| -> Vec<f64> {
        let data = tables
            .iter()
            .map(|text| json!({ "name": "t.csv", "text": text }));
        let muscle = json!({ "name": "bench.toml", "text": example("bench.toml") });
        let request = json!({ "muscle": { "file": muscle }, "data": data.collect::<Vec<_>>(), "weights": weights,
            "model": "thick-wall", "free": ["mu", "braid.stiffness"] });
        let parameters = reply("identify", request)["parameters"].take();
        let value = |p: &Value| p["value"].as_f64().unwrap();
        parameters.as_array().unwrap().iter().map(value).collect()
    };
    let alone = constants(&[&points], Value::Null);
    let without = constants(&[&points, &larger], json!([1, 0]));
    let with = constants(&[&points, &larger], json!([1, 1]));
    for ((alone, without), with) in alone.iter().zip(without).zip(with) {
        assert!((without / alone - 1.0).abs() < 1e-9, "{without} {alone}");
        assert!((with / alone - 1.0).abs() > 1e-3, "{with} {alone}");
    }
}
