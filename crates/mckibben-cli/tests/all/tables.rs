//! Tables as people have them. The points of `tests/bench` are one muscle's with a shear modulus of 0.25 MPa (`muscle.toml`,
//! which begins at 0.4), computed by finite elements, in the spellings of seventeen benches.

use crate::common::{folder, json, mckibben, number, root, run, run_in};
use mckibben::units::{Dimension, parse_values};
use serde_json::Value;

const FOLDER: &str = "crates/mckibben-cli/tests/bench";
const MUSCLE: &str = "crates/mckibben-cli/tests/bench/muscle.toml";

/// File, flags, and what is understood: quantity and unit of pressure, contraction, force.
type Case = (&'static str, &'static str, [(&'static str, &'static str); 3]);

const BENCHES: &[Case] = &[
    ("1_kpa_shortening_mm.csv", "", [("pressure", "kPa"), ("shortening", "mm"), ("force", "N")]),
    ("2_german.csv", "", [("pressure", "kPa"), ("shortening", "mm"), ("force", "N")]),
    ("3_percent.csv", "", [("pressure", "bar"), ("contraction", "%"), ("force", "N")]),
    ("4_imperial.csv", "", [("pressure", "psi"), ("contraction", "%"), ("force", "lbf")]),
    ("5_length.csv", "", [("pressure", "kPa"), ("length", "mm"), ("force", "N")]),
    ("6_units_row.tsv", "", [("pressure", "kPa"), ("shortening", "mm"), ("force", "N")]),
    ("7_excel_unicode.txt", "", [("pressure", "bar"), ("shortening", "mm"), ("force", "N")]),
    ("8_latin1_metadata.csv", "", [("pressure", "mbar"), ("shortening", "mm"), ("force", "N")]),
    ("9_french.csv", "", [("pressure", "kPa"), ("shortening", "mm"), ("force", "mN")]),
    ("10_spanish_inch.csv", "", [("pressure", "psi"), ("shortening", "in"), ("force", "lbf")]),
    ("11_units_row_brackets.csv", "", [("pressure", "MPa"), ("length", "cm"), ("force", "kN")]),
    ("12_sep_line.csv", "", [("pressure", "bar"), ("contraction", ""), ("force", "N")]),
    ("13_kgf.csv", "", [("force", "kgf"), ("pressure", "kgf/cm2"), ("contraction", "%")]),
    ("14_numpy.txt", "", [("pressure", "Pa"), ("shortening", "m"), ("force", "N")]),
    ("15_sheets_quoted.csv", "", [("pressure", "bar"), ("length", "in"), ("force", "N")]),
    (
        "16_instrument.csv",
        "--columns pressure=P1:kPa,contraction=x:mm,force=F:N",
        [("pressure", "kPa"), ("shortening", "mm"), ("force", "N")],
    ),
    ("17_cells.csv", "", [("pressure", ""), ("contraction", ""), ("force", "")]),
];

fn columns(found: &Value) -> Vec<(String, String)> {
    let list = found["understood"][0]["columns"].as_array().unwrap();
    let word = |c: &Value, key: &str| c[key].as_str().unwrap().to_owned();
    list.iter().map(|c| (word(c, "quantity"), word(c, "unit"))).collect()
}

/// Forces are rounded to 0.01 N; what conversions round adds less than 0.001 N. With J = ∂F/∂μ at the n points, least squares
/// move μ by JᵀδF/JᵀJ, at most |δF|/|J| = 0.006 N/rms(J), and rms(J) is the rms residual at the start over the way from there.
#[test]
fn every_bench_gives_the_modulus_that_made_its_points() {
    for (file, flags, wanted) in BENCHES {
        let found = json(&format!("identify {MUSCLE} --data {FOLDER}/{file} --free mu {flags}"));
        let mu = &found["parameters"][0];
        let slope = number(&found, "rms_before_n") / (0.4 - 0.25);
        let tolerance = 0.006 / slope;
        assert!(tolerance < 3e-5, "{file}: {tolerance}");
        assert!((number(mu, "value") - 0.25).abs() <= tolerance, "{file}: {mu}");
        assert_eq!(found["understood"][0]["rows"], 12, "{file}");
        let columns = columns(&found);
        let columns: Vec<(&str, &str)> = columns.iter().map(|c| (c.0.as_str(), c.1.as_str())).collect();
        assert_eq!(columns, wanted, "{file}");
        // The same values in every spelling: 0.1 to 0.3 MPa.
        let list = found["understood"][0]["columns"].as_array().unwrap();
        let pressure = list.iter().find(|c| c["quantity"] == "pressure").unwrap();
        let range = parse_values(pressure["range"].as_str().unwrap(), Dimension::Pressure).unwrap().bounds();
        assert!((range.0 - 0.1).abs() < 1e-6 && (range.1 - 0.3).abs() < 1e-6, "{file}: {pressure}");
    }
}

/// The rms error moves by no more than the rms of what is rounded, 0.006 N a force.
#[test]
fn every_bench_is_compared() {
    let rms: Vec<f64> = BENCHES
        .iter()
        .map(|(file, flags, _)| {
            let line =
                format!("compare --models thick-wall --muscle {MUSCLE} --data {FOLDER}/{file} {flags}");
            let found = json(&line);
            assert_eq!((&found["points"], &found["models"][0]["points"]), (&12.into(), &12.into()), "{file}");
            number(&found["models"][0], "rms_n")
        })
        .collect();
    assert!(rms[0] > 20.0 && rms.iter().all(|r| (r - rms[0]).abs() < 2.0 * 0.006), "{rms:?}");
}

#[test]
fn people_see_what_was_understood() {
    let ran =
        mckibben(&format!("compare --models ideal --muscle {MUSCLE} --data {FOLDER}/8_latin1_metadata.csv"))
            .ok();
    assert_eq!(
        ran.text().lines().next(),
        Some(
            "crates/mckibben-cli/tests/bench/8_latin1_metadata.csv: 12 points; Überdruck in mbar → pressure (mbar), \
             Hub in mm → shortening (mm, over L0 200 mm), Zugkraft in N → force (N); heading in line 5; not used: Zeit [s]"
        )
    );
    let found =
        json(&format!("compare --models ideal --muscle {MUSCLE} --data {FOLDER}/11_units_row_brackets.csv"));
    let understood = &found["understood"][0];
    assert_eq!((&understood["heading_line"], &understood["units_line"]), (&1.into(), &2.into()));
    assert_eq!((&understood["separator"], &understood["decimal"]), (&"comma".into(), &"point".into()));
    assert!(json("compare --models ideal -p 0.1")["understood"].as_array().unwrap().is_empty());
}

/// What a program writes it reads.
#[test]
fn tables_of_our_own_are_read() {
    let dir = folder();
    let path = dir.path().join("own.csv");
    for line in [
        "curve isobaric -p 0.1,0.2 -e 0,0.1 --model thick-wall --format csv",
        "simulate --test isobaric -p 0.1 -e 0,0.05 --format csv",
        "identify examples/bench.toml --data examples/bench.csv --model thick-wall --free mu --format csv",
    ] {
        let written = mckibben(line).ok();
        std::fs::write(&path, written.out).unwrap();
        let found = json(&format!("compare --models ideal --data {}", path.display()));
        let units: Vec<(String, String)> = columns(&found);
        for wanted in [("pressure", "MPa"), ("contraction", ""), ("force", "N")] {
            assert!(units.iter().any(|u| (u.0.as_str(), u.1.as_str()) == wanted), "{line}: {units:?}");
        }
    }
}

/// Table, flags, part of the message: line and column, and the way out in the words of the command line.
const REFUSED: &[(&[u8], &str, &str)] = &[
    (b"Druck;Kontraktion;Kraft\n1;0,1;3\n", "", "give --columns pressure=\"Druck:kPa\""),
    (
        b"p_bar,contraction,F_N\n1,0,3\n1,12,3\n",
        "",
        "line 3, column contraction: 12 is not a valid contraction ratio",
    ),
    (b"p_bar,contraction,F_N\n1,0,3\n1,12,3\n", "", "--columns contraction=\"contraction:%\""),
    (
        b"p_bar,contraction,F_N\n1,0.1,\"1,234\"\n",
        "",
        "line 2, column F_N: \"1,234\" can be read in two ways",
    ),
    (b"p_bar;contraction;F_N\n1;0,1;1.234\n", "", "line 2, column F_N: \"1.234\" can be read in two ways"),
    (b"p_bar,x,F_N\n1,2,3\n", "", "--columns contraction="),
    (b"p_bar,x,F_N\n1,2,3\n", "--columns contraction=y:mm", "there is no column"),
    (b"p_bar,x,F_N\n1,2,3\n", "--columns contraction", "write quantity="),
    (b"p_bar,x,F_N\n1,2,3\n", "--columns contraction=x:kPa", "is not a unit of contraction"),
    (b"p_bar,x,F_N\n1,2,3\n", "--columns kontrakt=x:mm", "no quantity"),
    (b"PK\x03\x04 sheet", "", "save the table as CSV"),
];

#[test]
fn what_is_not_understood_is_refused_with_the_way_out() {
    let dir = folder();
    for (bytes, flags, fragment) in REFUSED {
        std::fs::write(dir.path().join("t.csv"), bytes).unwrap();
        for command in ["compare --models ideal", "identify --model ideal --free braid.angle"] {
            let line = format!("{command} --data t.csv --format json {flags}");
            let ran = run_in(dir.path(), &line.split_whitespace().collect::<Vec<_>>());
            assert_eq!(ran.code, 2, "{line}: {ran:?}");
            let message = ran.error()["message"].as_str().unwrap().to_owned();
            assert!(message.contains(fragment) && !message.contains('`'), "{line}: {message}");
        }
    }
}

/// Treloar's uniaxial test as an old machine would write it: force in kgf on 8 mm², extension in mm of 25 mm.
#[test]
fn a_rubber_test_of_an_old_machine_is_the_same_test() {
    let text = std::fs::read_to_string(root().join("data/treloar/tension.csv")).unwrap();
    let uniaxial = text.lines().filter(|l| l.starts_with("uniaxial"));
    let points: Vec<(f64, f64)> = uniaxial
        .map(|l| {
            let mut fields = l.split(',').skip(1).map(|f| f.parse::<f64>().unwrap());
            (fields.next().unwrap(), fields.next().unwrap())
        })
        .collect();
    assert!(points.len() > 20);
    let plain: String = "stretch,stress_mpa\n".to_owned()
        + &points.iter().map(|(l, s)| format!("{l},{s}\n")).collect::<String>();
    let row = |(l, s): &(f64, f64)| {
        format!("{:.6};{:.8};x\r\n", 25.0 * (l - 1.0), s * 8.0 / 9.80665).replace('.', ",")
    };
    let old = "Pr\u{fc}fung 7;20 \u{b0}C\r\n\r\nTraversenweg;Pr\u{fc}fkraft;Bemerkung\r\nmm;kgf;\r\n"
        .to_owned()
        + &points.iter().map(row).collect::<String>();
    let latin: Vec<u8> = old.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect();
    let dir = folder();
    std::fs::write(dir.path().join("plain.csv"), plain).unwrap();
    std::fs::write(dir.path().join("old.csv"), latin).unwrap();
    let fit = |words: &[&str]| {
        let common = ["rubber", "--law", "yeoh", "--up-to", "3", "--format", "json"];
        run_in(dir.path(), &[&common[..], words].concat()).ok().json()
    };
    let wanted = fit(&["plain.csv"]);
    let found =
        fit(&["old.csv", "--area", "8mm2", "--gauge-length", "25mm", "--columns", "force=Pr\u{fc}fkraft"]);
    assert_eq!(found["points"], wanted["points"]);
    for (a, b) in found["parameters"].as_array().unwrap().iter().zip(wanted["parameters"].as_array().unwrap())
    {
        assert!(
            (number(a, "value") - number(b, "value")).abs() <= 1e-4 * number(b, "value").abs(),
            "{a} {b}"
        );
    }
    let understood = &found["understood"][0];
    assert_eq!((&understood["heading_line"], &understood["units_line"]), (&3.into(), &4.into()));
    assert_eq!(understood["columns"][1]["note"], "over 8 mm²");
    assert_eq!(run(&["rubber", "data/treloar/tension.csv", "--columns", "mode"]).code, 2);
}
