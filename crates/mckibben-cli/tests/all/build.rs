//! `build`: the folder, what it replaces, and the sheet that `identify` reads.

use crate::common::{folder, json, mckibben, number, run};
use mckibben_app::{ForceRequest, ModelFields, TextFile, force};
use std::fs;
use std::path::Path;

const MUSCLE: &str =
    "build --rubber latex --braid flexo-overexpanded-0.38in -D 0.375in -s 0.0625in -L 200mm -p 2bar";

fn build_into(folder: &Path, more: &[&str]) -> crate::common::Ran {
    let mut words: Vec<&str> = MUSCLE.split_whitespace().collect();
    let folder = folder.to_str().unwrap();
    words.extend(["-o", folder]);
    words.extend(more);
    run(&words)
}

/// The sheet with the forces of a model in it is read as it is, and the muscle of the folder comes back: an identity.
#[test]
fn the_test_sheet_is_read_back_by_identify() {
    let folder = folder();
    let printed = build_into(folder.path(), &[]).ok();
    assert!(printed.text().contains("begin with README.md"), "{}", printed.text());
    let file = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    let request = ForceRequest {
        model: ModelFields { model: Some("thick-wall".into()), ..ModelFields::default() },
        ..ForceRequest::default()
    };
    let mut request = request;
    request.muscle.named.muscle = Some(TextFile { name: "muscle.toml".into(), text: file("muscle.toml") });
    let (mut filled, mut points) = (String::new(), 0);
    for line in file("test.csv").lines() {
        let fields: Vec<&str> = line.split(',').collect();
        match fields[..] {
            [p, e, "", branch, distance] => {
                let (p, e): (f64, f64) = (p.parse().unwrap(), e.parse().unwrap());
                assert!((200.0 * (1.0 - e) - distance.parse::<f64>().unwrap()).abs() < 0.051);
                (request.pressure_mpa, request.contraction) = (Some(p), Some(e));
                let answer = force(&request, &mckibben::progress::Silent).unwrap();
                // The muscle pulls at every point of the test.
                assert!(answer.point.response.force_n > 0.0, "{line}");
                filled += &format!("{p},{e},{},{branch},{distance}\n", answer.point.response.force_n);
                points += 1;
            }
            _ => filled += &format!("{line}\n"),
        }
    }
    assert!(points >= 12 && filled.contains("contraction") && filled.contains("elongation"), "{filled}");
    let sheet = folder.path().join("test.csv");
    fs::write(&sheet, &filled).unwrap();
    let (muscle, sheet) = (folder.path().join("muscle.toml"), sheet.to_str().unwrap().to_owned());
    let words = [
        "identify",
        muscle.to_str().unwrap(),
        "--data",
        &sheet,
        "--model",
        "thick-wall",
        "--free",
        "modulus",
        "--format",
        "json",
    ];
    let answer = run(&words).ok().json();
    assert_eq!(answer["points"].as_array().unwrap().len(), points, "{answer:#}");
    let modulus = &answer["parameters"][0];
    assert!((number(modulus, "value") - 1.0).abs() < 1e-6, "{modulus:#}");
    // What was measured is not lost.
    let again = build_into(folder.path(), &[]);
    assert!(again.code == 2 && again.err.contains("test sheet without forces"), "{}", again.err);
    assert_eq!(fs::read_to_string(&sheet).unwrap(), filled);
}

#[test]
fn a_folder_is_renewed_where_that_is_asked_for() {
    let folder = folder();
    build_into(folder.path(), &[]).ok();
    build_into(folder.path(), &["--fitting", "g1/8", "--overwrite"]).ok();
    let readme = folder.path().join("README.md");
    assert!(fs::read_to_string(&readme).unwrap().contains("G1/8"));
    let svg = folder.path().join("drawing.svg");
    fs::remove_file(&svg).unwrap();
    fs::write(&readme, "my notes\n").unwrap();
    let refused = build_into(folder.path(), &[]);
    assert!(refused.code == 2 && refused.err.contains("would be overwritten"), "{}", refused.err);
    // None of the files was written.
    assert!(!svg.exists() && fs::read_to_string(&readme).unwrap() == "my notes\n");
    build_into(folder.path(), &["--overwrite"]).ok();
    assert!(svg.exists());
}

/// Relation of the standard: a proof at twice the working pressure; the limits are those of `check`, an identity.
#[test]
fn pressures_are_in_the_ratios_of_hoses() {
    let answer = json(MUSCLE);
    let pressure = |key: &str| number(&answer, key);
    assert!(
        (pressure("pressure_mpa") - 0.2).abs() < 1e-12
            && (pressure("proof_pressure_mpa") - 0.4).abs() < 1e-12
    );
    let shown = json(&MUSCLE.replacen("build", "check", 1));
    for key in ["burst_pressure_mpa", "allowed_pressure_mpa"] {
        assert_eq!(answer[key], shown["characteristics"][key], "{key}");
    }
    assert!(pressure("proof_pressure_mpa") < pressure("burst_pressure_mpa"));
    // By hand: p V ln(p/p₀) of the inner volume at that pressure is below that of a cavity of 20 mm over 200 mm, 62.8 cm³.
    assert!(pressure("air_energy_j") > 1.0 && pressure("air_energy_j") < 0.301_325 * 62.8 * 1.0898);
    let files = answer["files"].as_array().unwrap();
    let names: Vec<&str> = files.iter().map(|f| f["name"].as_str().unwrap()).collect();
    assert_eq!(names[0], "README.md");
    assert!(
        ["drawing.pdf", "air-plug.stl", "eye-plug.scad", "test.csv", "muscle.toml"]
            .iter()
            .all(|n| names.contains(n))
    );
    assert!(files.iter().all(|f| f.get("text").is_some() != f.get("base64").is_some()));
}

#[test]
fn wrong_wishes_are_named() {
    for (flags, words) in [
        ("--fitting m6", "--fitting: \"m6\" is not a fitting; expected m5, g1/8 or g1/4"),
        ("--fitting barb:900", "barb:4"),
        ("--bolt 0mm", "must be above zero"),
        ("--bolt 90mm", "from 2 to 64 mm"),
        ("--sleeve-diameter 90mm", "its strands allow diameters up to"),
        ("-p -1bar", "must be above zero"),
    ] {
        let refused = mckibben(&format!("{MUSCLE} {flags}").replace("-p 2bar -p", "-p"));
        assert!(refused.code == 2 && refused.err.contains(words), "{flags}: {}", refused.err);
    }
}
