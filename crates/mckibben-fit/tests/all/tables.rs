//! Any bytes end in points or in an error; the same points in any form are the same points.

use mckibben_fit::{
    measured::{PointOptions, read_points},
    rubber::read_tests,
};
use mckibben_io::table::{Columns, read_text};
use proptest::prelude::*;

fn both(bytes: &[u8]) {
    let Ok((text, _)) = read_text(bytes, None) else {
        return;
    };
    let columns = Columns::parse("pressure=P:kPa,contraction=#2:%").unwrap_or_default();
    for columns in [Columns::default(), columns] {
        let _ = read_points(
            &text,
            &PointOptions {
                columns: columns.clone(),
                rest_length_mm: Some(200.0),
                log: None,
            },
        );
        let specimen = ["area=1mm2".to_owned(), "gauge_length=1mm".to_owned()];
        let _ = read_tests(
            &text,
            &columns
                .with_constants(&specimen, (0, 1), "test.csv")
                .unwrap(),
        );
    }
}

/// Texts that nearly are tables.
fn tables() -> impl Strategy<Value = String> {
    let heading = prop_oneof![
        3 => r"(Pressure|p|Druck|P|Force|Kraft|contraction|strain|stretch|ΔL|length_mm|stress|mode|status)",
        1 => "\\PC{0,8}",
    ];
    let unit = prop_oneof![
        r"( ?[\[(/{]| in |_)(kPa|bar|mm|%|N|lbf|inch|Pa|-)?[\])}]?",
        "\\PC{0,3}"
    ];
    let cell = prop_oneof![
        4 => r#"-?[0-9]{0,3}[.,]?[0-9]{0,3}( ?(kPa|%|N))?"#,
        1 => r#"["'#;,.€−%\t ]{0,3}[0-9e+]{0,3}"#,
        1 => "\\PC{0,4}",
    ];
    let mark = prop_oneof![Just(","), Just(";"), Just("\t"), Just("|"), Just(" ")];
    let headings = proptest::collection::vec((heading, unit), 1..6);
    let rows = proptest::collection::vec(proptest::collection::vec(cell, 0..6), 0..6);
    (headings, rows, mark, r"(|\r\n|sep=;\n|#|//|1,2\n|\x{feff})").prop_map(
        |(headings, rows, mark, before)| {
            let headings: Vec<String> = headings.into_iter().map(|(h, u)| h + &u).collect();
            let rows: Vec<String> = rows.iter().map(|r| r.join(mark)).collect();
            format!("{before}{}\n{}\n", headings.join(mark), rows.join("\n"))
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes_are_points_or_an_error(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        both(&bytes);
    }

    #[test]
    fn any_near_table_is_points_or_an_error(text in tables()) {
        both(text.as_bytes());
        let wide: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        both(&wide);
    }

    /// With two decimals, of which the last is not zero, no number can be taken for thousands.
    #[test]
    fn the_same_points_in_any_form_are_the_same_points(
        points in proptest::collection::vec((0_u32..100_000, 0_u32..9_000, 0_u32..1_000_000), 1..20),
        form in (0_usize..4, any::<bool>(), 0_usize..4, any::<bool>(), any::<bool>()),
    ) {
        let (mark, comma, encoding, preamble, units_row) = form;
        let mark = [";", "\t", "|", ","][mark];
        let comma = comma && mark != ",";
        let hundredth = |n: u32| {
            let text = format!("{}.{:02}", n / 100, n % 100);
            if comma { text.replace('.', ",") } else { text }
        };
        let mut text = String::new();
        if preamble {
            text.push_str("Prüfstand 3\r\nBediener: N. N.\r\n\r\n");
        }
        text.push_str(&if units_row {
            ["Druck", "Verkürzung", "Kraft\r\n"].join(mark) + &["[kPa]", "[mm]", "[N]\r\n"].join(mark)
        } else {
            ["Druck in kPa", "Verkürzung / mm", "Kraft (N)\r\n"].join(mark)
        });
        for (p, x, f) in &points {
            text.push_str(&[hundredth(*p), hundredth(*x), hundredth(*f) + "\r\n"].join(mark));
        }
        let sixteen = |order: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(order).collect::<Vec<u8>>();
        let bytes = match encoding {
            0 => text.clone().into_bytes(),
            1 => [&b"\xff\xfe"[..], &sixteen(u16::to_le_bytes)].concat(),
            2 => sixteen(u16::to_be_bytes),
            _ => text.chars().map(|c| u8::try_from(u32::from(c)).unwrap_or(b'?')).collect(),
        };
        let options = PointOptions { rest_length_mm: Some(200.0), ..PointOptions::default() };
        let (text, _) = read_text(&bytes, None).map_err(|e| TestCaseError::fail(e.to_string()))?;
        let (read, understood) = read_points(&text, &options).map_err(|e| TestCaseError::fail(e.to_string()))?;
        prop_assert_eq!(read.len(), points.len());
        prop_assert_eq!(understood.heading_line, Some(if preamble { 4 } else { 1 }));
        for (read, (p, x, f)) in read.iter().zip(&points) {
            prop_assert!((read.at.pressure_mpa - f64::from(*p) / 1e5).abs() <= 1e-14 * f64::from(*p));
            prop_assert!((read.at.contraction - f64::from(*x) / 2e4).abs() < 1e-14);
            prop_assert!((read.at.force_n - f64::from(*f) / 1e2).abs() < 1e-9);
        }
    }
}
