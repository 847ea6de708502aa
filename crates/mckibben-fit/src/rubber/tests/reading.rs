use super::*;
use mckibben_io::table::{Columns, TableError};

fn read_with(text: &str, options: ReadOptions) -> Result<Vec<TensionPoint>, TableError> {
    read_tension(text.as_bytes(), options)
}

fn read(text: &str) -> Result<Vec<TensionPoint>, TableError> {
    read_with(text, ReadOptions::default())
}

/// λ = 1.5 and P = 0.3 MPa, said in many ways.
#[test]
fn headings_and_units_are_understood() {
    let options = ReadOptions { mode: Mode::Planar, area_mm2: Some(10.0), gauge_length_mm: Some(40.0) };
    for text in [
        "stretch,nominal_stress_MPa\n1.5,0.3\n",
        "Engineering strain,Stress (kPa)\n0.5,300\n",
        "Strain (%),Stress [MPa]\n50,0.3\n",
        "lambda,true_stress_mpa\n1.5,0.45\n",
        "true_strain;cauchy stress [MPa]\n0,4054651081081644;0,45\n",
        "extension_mm,force_n\n20,3\n",
        "elongation %\tload [kN]\n50\t0.003\n",
        "\u{feff}# a comment\nstrain,stress_psi\n0.5,43.511321319062766\n",
        "λ,nominal stress N/mm²\n1.5,0.3\n\n",
        "Dehnung [%];Spannung [N/mm²]\n50,0;0,30\n",
        "Standardweg;Prüfkraft;Kraft\nmm;N;N\n20,0;7;3,0\n",
        "Specimen 3\nExtension (mm),Load (N)\n20.0,3.0,\n",
        "Longueur / mm;Contrainte / kPa\n60,0;300,0\n",
        "\"1,5\",\"0,3\"\n",
    ] {
        let columns = match text {
            t if t.starts_with("Standardweg") => "extension=Standardweg",
            t if t.starts_with('"') => "stretch=#1,stress=#2:MPa",
            _ => "",
        };
        let columns = Columns::parse(columns).unwrap();
        let (found, understood) =
            read_tests(text.as_bytes(), options, &columns).unwrap_or_else(|e| panic!("{text}: {e}"));
        assert_eq!((understood.rows, understood.columns.len()), (1, 2), "{text}");
        assert_eq!(found.len(), 1, "{text}");
        assert_eq!(found[0].mode, Mode::Planar);
        assert!((found[0].stretch - 1.5).abs() < 1e-12, "{text}: {found:?}");
        assert!((found[0].nominal_stress_mpa - 0.3).abs() < 1e-12, "{text}: {found:?}");
    }
}

#[test]
fn modes_are_understood() {
    let text = "mode,stretch,stress_mpa\nUniaxial,1.5,1\npure_shear,1.5,1\nPlanar,1.5,1\nbiaxial,1.5,1\nequi-biaxial,1.5,1\n";
    let modes: Vec<Mode> = read(text).unwrap().iter().map(|p| p.mode).collect();
    use Mode::{Equibiaxial, Planar, Uniaxial};
    assert_eq!(modes, [Uniaxial, Planar, Planar, Equibiaxial, Equibiaxial]);
}

#[test]
fn errors_name_line_and_column_and_what_to_do() {
    let cases = [
        ("", "no column of stretches"),
        ("a,b\n1,2\n", "the columns are: a, b"),
        ("stretch,b\n1,2\n", "no column of stresses"),
        ("stretch,stress\n1,2\n", "column stress does not state its unit"),
        ("stretch,stress\n1,2\n", "`columns` nominal_stress=\"stress:MPa\""),
        ("stretch,force_n\n1,2\n", "`area_mm2`"),
        ("extension_mm,stress_mpa\n1,2\n", "`gauge_length_mm`"),
        ("stretch,stress_mpa\n1,0\n1.2,NaN\n", "line 3, column stress_mpa: \"NaN\""),
        ("stretch,stress_mpa\n1,\n", "the field is empty: leave the whole line out"),
        ("stretch,stress_mpa\n1.0\n", "every line needs as many fields"),
        ("stretch,stress_mpa\n\"1,2\",0.5\n", "can be read in two ways"),
        ("stretch,stress_mpa\n0,0\n", "if it is a strain, name the column engineering_strain"),
        ("stretch,stress_mpa\n-1,0\n", "above 0"),
        ("stretch,stress_mpa\n150,0.3\n", "name the column strain_percent"),
        ("strain,stress_mpa\n150,0.3\n", "name the column strain_percent"),
        ("strain,stress_mpa\n-1.5,0.3\n", "no length left"),
        (
            "strain,stress_mpa\n0.5,1e300\n",
            "line 2, column stress_mpa: 1e300 gives a stress that no rubber can bear",
        ),
        (
            "strain,stress_mpa\n0,0\n0.5,300\n",
            "line 3, column stress_mpa: 300 gives a stress that no rubber can bear; check its unit",
        ),
        ("strain,stress_mpa\n1e308,0.3\n", "column strain: 1e308"),
        ("strain,stress_mpa,stress_mpa\n0.5,0.3,0.4\n", "could all be nominal_stress"),
        ("strain;stress_mpa\n0,5;0.3\n", "can be read in two ways"),
        ("mode,strain,stress_mpa\nbending,0.5,0.3\n", "line 2: the mode \"bending\" is none of uniaxial"),
        ("strain,stress_mpa\n", "no points"),
    ];
    for (text, fragment) in cases {
        let message = read(text).unwrap_err().to_string();
        assert!(message.contains(fragment), "{text}: {message}");
    }
}
