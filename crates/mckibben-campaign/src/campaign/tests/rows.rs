//! What is in the rows.

use super::*;
use crate::campaign::plan::rounded;
use mckibben_core::model::Workspace;
use mckibben_fem::simulation::Given;

fn run_plan(text: &str) -> Vec<PointRow> {
    let dir = folder();
    let out = dir.path().join("c.parquet");
    run(
        &Plan::parse(text).unwrap(),
        &out,
        &RunOptions::default(),
        &Silent,
    )
    .unwrap();
    read(&out).unwrap()
}

/// Rows are the answers of the finite elements, and their derivatives those of the forces around
/// them.
#[test]
fn rows_are_what_the_model_says_and_derivatives_are_those_of_the_forces() {
    let text = "[vary]\ntube.outer_diameter = \"30,45\"\n\
        [test]\ncontractions = \"0.0999,0.1,0.1001\"\npressures = \"0.1999,0.2,0.2001\"\nmesh \
        = \"4\"\nsensitivities = true\n";
    let rows = run_plan(text);
    let plan = Plan::parse(text).unwrap();
    assert_eq!(rows.len(), 18);
    for (muscle, nine) in rows.chunks(9).enumerate() {
        let muscle = plan.inputs(muscle as u64).muscle().unwrap();
        let model = plan.testing.elements.build(&muscle).unwrap();
        let at = |e: usize, p: usize| nine[3 * e + p].force_n.unwrap();
        let here = &nine[4];
        let solution = model
            .solve(&mut Workspace::new(), Given::at(0.2, 0.1))
            .unwrap();
        assert!((at(1, 1) / solution.response.force_n - 1.0).abs() < 1e-9);
        let slope = (at(1, 2) - at(1, 0)) / 2e-4;
        assert!((here.force_per_pressure_n_per_mpa.unwrap() / slope - 1.0).abs() < 1e-5);
        let stiffness = -(at(2, 1) - at(0, 1)) / 2e-4 / 285.0;
        assert!((here.stiffness_n_per_mm.unwrap() / stiffness - 1.0).abs() < 1e-5);
        assert_eq!(here.sensitivities.len(), solution.sensitivities.len());
        for ((key, value), s) in here.sensitivities.iter().zip(&solution.sensitivities) {
            assert_eq!(key, &s.name);
            assert!(
                (value - s.force_n_per_unit).abs() < 1e-6 * s.force_n_per_unit.abs().max(1.0),
                "{key}"
            );
        }
        assert!(here.volume_mm3.unwrap() > muscle.rest_volume_mm3());
        assert_eq!((here.status, here.cause.as_str()), (Status::Ok, ""));
        assert_eq!(
            (here.law.as_str(), here.constants[0].clone()),
            ("mooney-rivlin", ("c10_mpa".into(), 0.112))
        );
    }
}

/// Row A14 of the trials: a named sleeve took its angle once, on the default tube. The muscle of a
/// row is that of a file with its values, of every sleeve and on every tube that it fits; a tube
/// that it does not fit is no muscle.
#[test]
fn identity_a_row_of_a_named_sleeve_is_the_muscle_of_a_file() {
    let test = "[test]\ncontractions = \"0,5%\"\npressures = \"0.2\"\nmesh = \"3\"\n";
    let mut compared = 0;
    for entry in mckibben_core::sleeve::library::entries().unwrap() {
        let name = entry.sleeve.name();
        let (least, largest) = entry.sleeve.diameters();
        let sizes = [0.3, 0.6, 1.2].map(|share| least + share * (largest - least));
        let table: String = sizes.map(|d| format!("{d},{}\n", 0.1 * d)).concat();
        let table = format!("outer_diameter_mm,wall_mm\n{table}");
        let varied = format!("{},{},{}", sizes[0], sizes[1], sizes[2]);
        let base = format!("[tube]\nlength = \"200 mm\"\n[braid]\nname = \"{name}\"\n");
        let vary = format!("[vary]\ntube.outer_diameter = \"{varied}\"\ntube.wall_ratio = 0.1\n");
        let plans = [
            Plan::parse(&format!("{base}{vary}{test}")),
            Plan::check(&format!("{base}{test}"), Some(&table)).map_err(|mut e| e.remove(0)),
        ];
        for plan in plans {
            let plan = match plan {
                Ok(plan) => plan,
                // Its seller does not state its strands.
                Err(error) => {
                    assert!(
                        error.to_string().contains("does not state"),
                        "{name}: {error}"
                    );
                    continue;
                }
            };
            let rows = compute(&plan, &Silent).unwrap();
            for (d, pair) in sizes.into_iter().zip(rows.chunks(2)) {
                let file = format!(
                    "[tube]\nouter_diameter = {d}\nwall_thickness = {}\nlength = \"200 mm\"\n\
                     [braid]\nname = \"{name}\"\n",
                    rounded(0.1 * d)
                );
                let muscle = match mckibben_core::muscle::file::parse_muscle(&file) {
                    Ok(muscle) => muscle,
                    Err(_) => {
                        assert_eq!(pair[0].status, Status::NoMuscle, "{name} {d}");
                        continue;
                    }
                };
                let model = plan.testing.elements.build(&muscle).unwrap();
                for row in pair {
                    assert_eq!(row.angle_deg, muscle.braid().angle_deg, "{name} {d}");
                    let force_n = model.force_n(&mut Workspace::new(), 0.2, row.contraction);
                    let Some(of_row) = row.force_n else {
                        assert!(force_n.is_err(), "{name} {d}: {}", row.cause);
                        continue;
                    };
                    let difference = of_row / force_n.unwrap() - 1.0;
                    assert!(difference.abs() < 1e-9, "{name} {d}: {difference}");
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 100, "{compared}");
}

/// By `force` on a muscle file, in N: the three tubes of row A14.
#[test]
fn a_sleeve_has_another_angle_on_each_tube() {
    let rows = run_plan(
        "[tube]\nwall_thickness = \"1.5 mm\"\n[braid]\nname = \"flexo-overexpanded-0.38in\"\n\
         [vary]\ntube.outer_diameter = \"11,14,18 mm\"\n\
         [test]\ncontractions = 0\npressures = \"0.2 MPa\"\n",
    );
    for (row, angle_deg) in rows.iter().zip([16.27, 20.88, 27.28]) {
        assert!((row.angle_deg - angle_deg).abs() < 0.005, "{row:?}");
    }
    let own = "[braid]\nname = \"pet:6..18mm\"\n[vary]\ntube.outer_diameter = \"8,12,20 mm\"\n\
        tube.wall_ratio = \"10%\"\n[test]\ncontractions = 0\npressures = \"0.2 MPa\"\n";
    let statuses: Vec<_> = run_plan(own).iter().map(|row| row.status).collect();
    assert_eq!(statuses, [Status::Ok, Status::Ok, Status::NoMuscle]);
}

/// What can be fitted to a table is said before it is computed: one make, several, or why none.
#[test]
fn a_plan_says_what_can_be_fitted_to_its_table() {
    let test = "[test]\ncontractions = \"0,10%\"\npressures = \"0.1\"\nmesh = \"3\"\n";
    let later = test.replace("0,10%", "5,10%");
    let beyond = test.replace("\"0.1\"", "\"500bar\"");
    for (vary, test, method, why) in [
        ("tube.outer_diameter = \"20,30\"", test, Some("global"), ""),
        (
            "braid.angle = \"22,24\"\ntube.wall_thickness = \"2,3\"\ntube.material.scale = \"1,2\"",
            test,
            Some("universal"),
            "",
        ),
        ("tube.length = \"200,300\"", test, None, "of one angle"),
        (
            "terminals.seating = \"0,1\"",
            test,
            None,
            "seating_mm varies",
        ),
        (
            "tube.outer_diameter = \"20,30\"",
            &*later,
            None,
            "contraction 0",
        ),
        // No tube bears 500 bar.
        (
            "tube.outer_diameter = \"20,30\"",
            &*beyond,
            None,
            "no inflated muscle has an answer at contraction 0",
        ),
    ] {
        let plan = Plan::parse(&format!("[vary]\n{vary}\n{test}")).unwrap();
        let said = forecast(&plan, &RunOptions::default(), &Silent)
            .unwrap()
            .fits;
        assert_eq!(said.fit_method, method, "{vary}");
        assert!(
            said.no_fit.clone().unwrap_or_default().contains(why),
            "{said:?}"
        );
        let dir = folder();
        let out = dir.path().join("c.parquet");
        run(&plan, &out, &RunOptions::default(), &Silent).unwrap();
        assert_eq!(summary(&out).unwrap().fits, said, "{vary}");
    }
    let extends = format!("[braid]\nangle = 60\n{test}");
    let plan = Plan::parse(&extends).unwrap();
    let said = forecast(&plan, &RunOptions::default(), &Silent)
        .unwrap()
        .fits;
    assert!(said.no_fit.unwrap().contains("60 deg extend"));
}

#[test]
fn failures_are_rows() {
    let rows = run_plan(
        "[tube]\nouter_diameter = \"30 mm\"\n[vary]\ntube.wall_thickness = \"3,14.9,15,20\"\n\
         [test]\ncontractions = \"0,0.6\"\npressures = \"0,0.2\"\nmesh = \"3\"\n",
    );
    assert_eq!(rows.len(), 16);
    assert!(rows.iter().all(|r| r.status.is_ok() == r.force_n.is_some()));
    assert!(rows.iter().all(|r| r.status.is_ok() == r.cause.is_empty()));
    assert!(
        rows[8..]
            .iter()
            .all(|r| r.status == Status::NoMuscle && r.cause.contains("wall_thickness"))
    );
    assert_eq!(rows[8].wall_mm, 15.0);
    assert!(
        rows[..8]
            .iter()
            .any(|r| [Status::Collapsed, Status::NotConverged].contains(&r.status))
    );
    // Pressure holds a wall out.
    let collapsed = rows.iter().filter(|r| r.status == Status::Collapsed);
    let mut without_pressure = collapsed.filter(|r| r.pressure_mpa == 0.0);
    assert!(without_pressure.all(|r| r.cause.contains("raise the pressure")));
    assert_eq!(
        (rows[0].status, rows[0].force_n.is_some()),
        (Status::Ok, true)
    );
}

#[test]
fn inextensible_strands_and_other_laws_have_their_columns() {
    let rows = run_plan(
        "[tube.material]\nlaw = \"ogden\"\nmu = [0.62, 0.0012, -0.01]\nalpha = [1.3, 5.0, -2.0]\n\
         [braid]\nstiffness = \"inextensible\"\n[vary]\ntube.material.scale = \"0.5,1\"\n\
         [test]\ncontractions = 0.1\npressures = 0.3\nmesh = \"3\"\nsensitivities = true\n",
    );
    let names: Vec<&str> = rows[1].constants.iter().map(|c| c.0.as_str()).collect();
    assert_eq!(
        names,
        [
            "mu1_mpa", "alpha1", "mu2_mpa", "alpha2", "mu3_mpa", "alpha3"
        ]
    );
    assert_eq!(
        (rows[0].constants[0].1, rows[1].constants[0].1),
        (0.31, 0.62)
    );
    assert_eq!(rows[0].braid_stiffness_n_per_mm, None);
    let keys: Vec<&str> = rows[0].sensitivities.iter().map(|s| s.0.as_str()).collect();
    assert!(
        keys.contains(&"tube.material.alpha3") && !keys.contains(&"braid.stiffness"),
        "{keys:?}"
    );
}

/// Contractions as shares of the ideal muscle's largest: 1 − 1/(√3 cos θ0).
#[test]
fn contractions_can_be_shares_of_the_largest() {
    let rows = run_plan(
        "[vary]\nbraid.angle = \"20,30\"\n[test]\ncontractions = \"0,50%\"\nof_ideal = \
         true\npressures = 0.2\nmesh = \"3\"\n",
    );
    let largest = |deg: f64| 1.0 - 1.0 / (3f64.sqrt() * deg.to_radians().cos());
    assert!((rows[1].contraction - 0.5 * largest(20.0)).abs() < 1e-9);
    assert!((rows[3].contraction - 0.5 * largest(30.0)).abs() < 1e-9);
}

/// Reading goes row group by row group; how a table was cut into parts cannot be seen from its
/// groups.
#[test]
fn tables_larger_than_a_group_come_back_row_by_row() {
    use crate::campaign::store::{
        file::{Opened, write},
        layout::Layout,
        table::Table,
    };
    let plan = Plan::parse(
        "[sampling]\nmethod = \"sobol\"\nsamples = 700\n[vary]\ntube.length \
         = \"100..200\"\n\
         [test]\ncontractions = \"0..0.5:0.05\"\npressures = \"0..0.09:0.01\"\n",
    )
    .unwrap();
    let provenance = Provenance::for_plan(&plan);
    assert_eq!(plan.muscles() * plan.points_per_muscle() as u64, 77_000);
    let blank = run_plan("[test]\ncontractions = 0\npressures = 0.1\nmesh = \"3\"\n").remove(0);
    let row = |i: u64| PointRow {
        muscle: i / 110,
        force_n: (!i.is_multiple_of(7)).then_some(i as f64 * 0.1),
        cause: if i.is_multiple_of(7) {
            format!("cause “{}”", i % 21)
        } else {
            String::new()
        },
        iterations: (i % 9) as u32,
        ..blank.clone()
    };
    let dir = folder();
    let mut files = vec![];
    for cut in [1000, 33_333] {
        let tables = (0..77_000_u64).step_by(cut).map(|from| {
            let mut table = Table::new(Layout::for_plan(&plan).fields());
            (from..77_000.min(from + cut as u64)).for_each(|i| table.push(row(i)));
            Ok(table)
        });
        let path = dir.path().join(format!("{cut}.parquet"));
        let mut file = std::io::Cursor::new(vec![]);
        write(&provenance, None, tables, &mut file, &path).unwrap();
        std::fs::write(&path, file.into_inner()).unwrap();
        files.push(bytes(&path));
        assert_eq!(Opened::file(&path).unwrap().tables().count(), 2);
        let mut count = 0;
        for (i, read) in super::super::rows(&path).unwrap().enumerate() {
            assert_eq!(read.unwrap(), row(i as u64));
            count += 1;
        }
        assert_eq!(count, 77_000);
    }
    assert!(files[0] == files[1]);
}

/// A plan with the three-dimensional model: rows are the answers of that model.
#[test]
fn rows_of_a_plan_with_fe3d_are_what_that_model_says() {
    let text = "[vary]\ntube.outer_diameter = \"30,30.5\"\n\
        [test]\nmodel = \"fe3d\"\nmesh = \"1x4x13\"\ncontractions = \"0,0.1\"\npressures \
        = \"0.1,0.2\"\n";
    let rows = run_plan(text);
    let plan = Plan::parse(text).unwrap();
    assert_eq!(rows.len(), 8);
    for row in rows {
        let muscle = plan.inputs(row.muscle).muscle().unwrap();
        let model = plan.testing.elements.build(&muscle).unwrap();
        assert_eq!((&*model.info().name, row.status), ("fe3d", Status::Ok));
        let force = model
            .force_n(&mut Workspace::new(), row.pressure_mpa, row.contraction)
            .unwrap();
        assert!((row.force_n.unwrap() / force - 1.0).abs() < 1e-8);
    }
}

/// Each rubber of an axis gives the rows of a plan of its own, with the columns of both laws.
#[test]
fn rows_of_several_rubbers_are_those_of_each_alone() {
    let points = "[test]\ncontractions = \"0,10%\"\npressures = \"0.1,0.2\"\nmesh = \"3\"\n";
    let names = ["dragon-skin-30", "paper"];
    let both = run_plan(&format!("[vary]\ntube.rubber = {names:?}\n{points}"));
    for (name, rows) in names.into_iter().zip(both.chunks(4)) {
        let alone = run_plan(&format!("[tube]\nrubber = \"{name}\"\n{points}"));
        for (row, alone) in rows.iter().zip(alone) {
            let muscle = row.muscle;
            assert_eq!(*row, PointRow { muscle, ..alone });
        }
    }
    let columns = |row: &PointRow| {
        row.constants
            .iter()
            .map(|c| c.0.clone())
            .collect::<Vec<_>>()
    };
    assert_eq!(columns(&both[0]), ["c10_mpa", "c20_mpa", "c30_mpa"]);
    assert_eq!(columns(&both[4]), ["c10_mpa", "c01_mpa"]);
}

/// A warning stands in a row where a question about the same point would have it.
#[test]
fn warnings_of_rows_are_those_of_answers() {
    use mckibben_core::{
        analysis::burst,
        warning::{WarningKind, of_response},
    };
    let text = "[tube]\nrubber = \"ecoflex-00-50\"\n[braid]\nstrands = 60\nstrand_strength \
                = \"9 N\"\nstiffness = \"40 N/mm\"\n[vary]\n\
                tube.outer_diameter = \"14,30\"\n[test]\ncontractions = \"0,15%\"\npressures \
                = \"0.02,0.1,0.3,0.6\"\nmesh = \"3\"\n";
    let (plan, rows) = (Plan::parse(text).unwrap(), run_plan(text));
    let mut seen = [[false; 2]; 4];
    for row in rows {
        let inputs = plan.inputs(row.muscle);
        let mut muscle = inputs.muscle().unwrap();
        let mut tube = muscle.tube().clone();
        tube.rubber.fitted_to_stretch = inputs.data_to_stretch;
        muscle = muscle.with_tube(tube).unwrap();
        let model = plan.testing.elements.build(&muscle).unwrap();
        let at = (row.pressure_mpa, row.contraction);
        let Ok(response) = model.response(&mut Workspace::new(), at.0, at.1) else {
            continue;
        };
        let mut said = of_response(&muscle, &response);
        said.extend(burst(&*model).unwrap().warnings(at.0));
        let has = |kind| said.iter().any(|warning| warning.kind == kind);
        let burst = has(WarningKind::Burst);
        let expected = [
            burst,
            burst || has(WarningKind::AboveAllowed),
            has(WarningKind::StrandStrain),
            has(WarningKind::RubberStretch),
        ];
        let found = [
            row.warning_burst,
            row.warning_allowed_pressure,
            row.warning_strand_strain,
            row.warning_rubber_stretch,
        ];
        assert_eq!(found, expected.map(Some), "{at:?} {said:?}");
        for (seen, flag) in seen.iter_mut().zip(expected) {
            seen[usize::from(flag)] = true;
        }
    }
    assert_eq!(seen, [[true; 2]; 4], "each is there and not there");
}

/// What is said of a campaign before it runs holds of it.
#[test]
fn a_forecast_holds() {
    let dir = folder();
    let out = dir.path().join("c.parquet");
    run_to(&out);
    let said = forecast(&plan(), &RunOptions::default(), &Silent).unwrap();
    let found = summary(&out).unwrap();
    assert_eq!((said.muscles, said.points), (12, 72));
    assert_eq!((said.muscles_tried, said.muscles_checked), (6, 12));
    assert_eq!(said.plan_sha256, found.provenance.plan_sha256);
    let two = forecast(&plan(), &share("1/3"), &Silent).unwrap();
    assert_eq!(
        (two.muscles, two.points, two.shard.as_deref()),
        (4, 24, Some("1/3"))
    );
    // Names and cause of failures are texts: on such a small table they vary in size.
    let rows = run_plan(PLAN);
    assert_eq!(rows.len() as u64, said.points);
    assert_eq!(said.points_failed, 0);
    assert!(
        std::fs::read_dir(dir.path()).unwrap().count() == 1,
        "it writes nothing"
    );
}

/// DuckDB, Polars and pyarrow skip row groups by these; orders that they do not have yet hide them.
#[test]
fn every_column_of_numbers_has_its_extremes_in_an_order_that_readers_have() {
    use parquet::{
        basic::{ColumnOrder, SortOrder},
        file::reader::{FileReader, SerializedFileReader},
    };
    let dir = folder();
    let out = dir.path().join("c.parquet");
    run_to(&out);
    let file = SerializedFileReader::new(std::fs::File::open(&out).unwrap()).unwrap();
    let group = file.metadata().row_group(0);
    for (i, column) in group.columns().iter().enumerate() {
        let order = file.metadata().file_metadata().column_order(i);
        assert!(
            matches!(order, ColumnOrder::TYPE_DEFINED_ORDER(o) if o != SortOrder::UNDEFINED),
            "{} {order:?}",
            column.column_path()
        );
        assert!(column.column_index_offset().is_some() && column.offset_index_offset().is_some());
        let statistics = column.statistics().unwrap();
        let all_null = statistics.null_count_opt() == Some(72);
        assert!(
            all_null || statistics.min_bytes_opt().is_some(),
            "{}",
            column.column_path()
        );
    }
}

/// An axis without a column in every table has a separate one, in files as in memory.
#[test]
fn measures_that_vary_are_in_the_file() {
    let rows = run_plan(
        "[vary]\nterminals.seating = \"0,1 mm\"\n[test]\ncontractions = 0\npressures = 0.1\nmesh \
         = \"3\"\n",
    );
    let seating: Vec<_> = rows.into_iter().map(|r| r.measures).collect();
    assert_eq!(
        seating,
        [0.0, 1.0].map(|mm| vec![("seating_mm".to_owned(), mm)])
    );
}
