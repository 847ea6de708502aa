use super::*;
use mckibben_io::table::{Columns, TableError};

pub fn read(text: &str) -> Result<Vec<TensionPoint>, TableError> {
    read_tension(text)
}

/// λ = 1.5 and P = 0.3 MPa, said in many ways.
#[test]
fn headings_and_units_are_understood() {
    let specimen = ["mode=planar", "area=10mm2", "gauge_length=40mm"].map(str::to_owned);
    for line in include_str!("spellings.tsv").lines().skip(1) {
        let (text, columns) = line.split_once('\t').unwrap();
        let text = text
            .replace("\\n", "\n")
            .replace("\\t", "\t")
            .replace("\\u{feff}", "\u{feff}");
        let chosen = Some(columns).filter(|text| !text.is_empty());
        let columns = chosen
            .map_or_else(Columns::default, |text| Columns::parse(text).unwrap())
            .with_constants(&specimen, (0, 1), "test.csv")
            .unwrap();
        let (points, understood) =
            read_tests(&text, &columns).unwrap_or_else(|e| panic!("{text}: {e}"));
        assert_eq!(
            (understood.rows, understood.columns.len()),
            (1, 2 + specimen.len()),
            "{text}"
        );
        assert_eq!(points.len(), 1, "{text}");
        assert_eq!(points[0].mode, Mode::Planar);
        assert!(
            (points[0].stretch - 1.5).abs() < 1e-12,
            "{text}: {points:?}"
        );
        assert!(
            (points[0].nominal_stress_mpa - 0.3).abs() < 1e-12,
            "{text}: {points:?}"
        );
    }
}

/// Three workbooks of a testing machine for three modes: each states its mode and dimensions, as
/// constants of its table or in columns.
#[test]
fn a_table_states_its_mode_and_its_specimen() {
    let read = |text: &str, set: &[&str]| {
        let set: Vec<String> = set.iter().map(|s| (*s).to_owned()).collect();
        let columns = Columns::default().with_constants(&set, (0, 1), "test.csv")?;
        Ok::<_, TableError>(read_tests(text, &columns)?.0[0])
    };
    let text = "Traversenweg [mm];Standardkraft [N]\n20;3\n";
    let point = read(text, &["mode=planar", "area=10mm2", "gauge_length=40mm"]).unwrap();
    assert_eq!((point.mode, point.stretch), (Mode::Planar, 1.5));
    assert!((point.nominal_stress_mpa - 0.3).abs() < 1e-12);
    let text = "Extension (mm),Load (N),Gauge length (mm),Cross-section (mm²)\n20,3,40,10\n";
    let point = read(text, &["mode=biaxial"]).unwrap();
    assert_eq!((point.mode, point.stretch), (Mode::Equibiaxial, 1.5));
    assert!((point.nominal_stress_mpa - 0.3).abs() < 1e-12);
    assert!(
        read(text, &["mode=bent"])
            .unwrap_err()
            .to_string()
            .contains("the mode \"bent\"")
    );
}

#[test]
fn modes_are_understood() {
    let text = "mode,stretch,stress_mpa\nUniaxial,1.5,1\npure_shear,1.5,1\nPlanar,1.5,1\nbiaxial,1.5,1\nequi-biaxial,1.5,1\n";
    let modes: Vec<Mode> = read(text).unwrap().iter().map(|p| p.mode).collect();
    use Mode::{Equibiaxial, Planar, Uniaxial};
    assert_eq!(modes, [Uniaxial, Planar, Planar, Equibiaxial, Equibiaxial]);
}
