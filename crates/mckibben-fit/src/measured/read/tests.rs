use super::*;

const L0: f64 = 200.0;

fn read_with(text: &str, columns: &str) -> Result<(Vec<DataPoint>, Understood), TableError> {
    read_points(
        text,
        &PointOptions {
            columns: if columns.is_empty() {
                Columns::default()
            } else {
                Columns::parse(columns).unwrap()
            },
            rest_length_mm: Some(L0),
            log: None,
        },
    )
}

fn read(text: &str) -> Result<(Vec<DataPoint>, Understood), TableError> {
    read_with(text, "")
}

/// P 0.25 MPa, ε 0.1 of L0 200 mm, F 300 N, said in many ways. The units' values are those of their
/// definitions.
#[test]
fn one_point_in_many_spellings_is_that_point() {
    for line in include_str!("spellings.txt").lines().skip(1) {
        let text = &line.replace("\\n", "\n").replace("\\t", "\t");
        let (points, understood) = read(text).unwrap_or_else(|e| panic!("{text}: {e}"));
        let at = points[0].at;
        assert!((at.pressure_mpa - 0.25).abs() < 1e-12, "{text}: {at:?}");
        assert!((at.contraction - 0.1).abs() < 1e-7, "{text}: {at:?}");
        assert!((at.force_n - 300.0).abs() < 1e-6, "{text}: {at:?}");
        assert_eq!(understood.rows, points.len());
    }
}

#[test]
fn columns_are_chosen_where_headings_say_nothing() {
    let text = "t,P1,P2,x,F\n0,250,7,20,300\n";
    let (points, understood) =
        read_with(text, "pressure=\"P1:kPa\",contraction=\"x:mm\",force=F:N").unwrap();
    let at = points[0].at;
    assert_eq!(
        (at.pressure_mpa, at.contraction, at.force_n),
        (0.25, 0.1, 300.0)
    );
    assert_eq!(
        understood.line(),
        "1 points; P1 → pressure (kPa), x → shortening (mm, over L0 200 mm), F → force (N); not \
         used: t, P2"
    );
    assert_eq!(
        understood.columns[0].range.as_deref(),
        Some("0.25..0.25MPa")
    );
    // What is chosen goes before what a heading says; a table without headings is read by numbers.
    let two = "pressure_mpa,P,contraction,force_n\n1,2.5,0.1,300\n";
    assert_eq!(
        read_with(two, "pressure=P:bar").unwrap().0[0]
            .at
            .pressure_mpa,
        0.25
    );
    let numbers = "250;20;300\n300;20;400\n";
    let (points, understood) =
        read_with(numbers, "pressure=#1:kPa,shortening=#2:mm,force=#3:N").unwrap();
    assert_eq!(
        (points.len(), points[0].line, understood.heading_line),
        (2, 1, None)
    );
    // A minus before a heading turns the sign.
    let (points, understood) = read_with("p_bar,hub_mm,F\n1,20,-300\n", "force=−#3:N").unwrap();
    assert_eq!(points[0].at.force_n, 300.0);
    assert_eq!(
        understood.columns[2].note.as_deref(),
        Some("with the opposite sign")
    );
    // A length that is said to be the present one is, even where it does not vary.
    let (points, _) = read_with("p_bar,l,F_N\n1,180,5\n2,180,6\n", "length=l:mm").unwrap();
    assert!((points[1].at.contraction - 0.1).abs() < 1e-12);
}

/// Without a muscle there is no L0. (What is said of other tables is in the messages of
/// `mckibben-app`.)
#[test]
fn a_shortening_needs_the_length_of_the_muscle() {
    let error = read_data("p_bar,hub_mm,F_N\n1,2,3\n")
        .unwrap_err()
        .to_string();
    assert!(error.contains("`length_mm`"), "{error}");
}

/// A column whose heading says nothing of friction, one in German, and the words that the program
/// prints.
#[test]
fn a_branch_is_stated_or_not() {
    use Direction::{Contraction, Elongation, Mean};
    let points = |heading: &str, word: &str| {
        read(&format!(
            "pressure_bar,contraction,force_n,{heading}\n2,0.1,3,{word}\n"
        ))
        .unwrap()
        .0[0]
            .at
            .branch
    };
    for (heading, word, branch) in [
        ("branch", "contraction", Some(Contraction)),
        ("branch", "shortening", Some(Contraction)),
        ("branch", "lengthening", Some(Elongation)),
        ("Richtung", "auf", Some(Contraction)),
        ("Zweig", "ab", Some(Elongation)),
        ("Zweig", "Verkürzung", Some(Contraction)),
        ("direction", "mean", Some(Mean)),
        ("branch", "", None),
        ("remark", "contraction", None),
    ] {
        assert_eq!(points(heading, word), branch, "{heading} {word}");
    }
}

/// Row B3 of the trials: the only heading with a unit of pressure is the pressure, and words that a
/// bench has for its phases mean what is said of them, here pressure up.
#[test]
fn words_of_a_bench_mean_what_is_said_of_them() {
    let sheet = "Phase,Setpoint_kPa,Force_N\nExtension,100,0.1\nRetraction,150,3.0\n";
    let read = |set: &[&str]| {
        let columns = Columns::parse("branch=Phase").unwrap();
        let set: Vec<String> = set.iter().map(|&text| text.to_owned()).collect();
        let columns = columns.with_constants(&set, (0, 1), "bench.csv").unwrap();
        let options = PointOptions {
            columns,
            ..PointOptions::default()
        };
        read_points(sheet, &options)
    };
    let said = read(&["contraction=0"]).unwrap_err().to_string();
    assert!(
        said.contains("`set`") && said.contains("branch=velocity"),
        "{said}"
    );
    // Any word for a branch will do.
    let set = [
        "contraction=0",
        "Extension=shortening",
        "Retraction=lengthening",
    ];
    assert_eq!(read(&set).unwrap().0.len(), 2);
    let set = [
        "contraction=0",
        "Extension=contraction",
        "Retraction=elongation",
    ];
    let (points, _) = read(&set).unwrap();
    let seen: Vec<_> = points
        .iter()
        .map(|p| (p.at.pressure_mpa, p.at.branch))
        .collect();
    assert_eq!(
        seen,
        [
            (0.1, Some(Direction::Contraction)),
            (0.15, Some(Direction::Elongation))
        ]
    );
}

/// The sheet that `build` writes, half of it filled in.
#[test]
fn rows_that_are_not_filled_in_are_left_out() {
    let sheet = "pressure_mpa,contraction,force_n,branch,distance between the clamps \
        (mm)\n0.06,0,,contraction,220\n\
                 0.14,0,62,contraction,220\n0.2,0,,contraction,220\n0.14,0,70,elongation,220\n";
    let (points, understood) = read(sheet).unwrap();
    assert_eq!(points.iter().map(|p| p.line).collect::<Vec<_>>(), [3, 5]);
    assert_eq!((understood.rows, understood.not_filled), (2, 2));
    assert!(
        understood.line().contains("; 2 not filled in and left out"),
        "{}",
        understood.line()
    );
    // Of a reading of contractions it is the contraction that is blank.
    let text = "pressure_bar,contraction,force_n,measured\n1,,9,contraction\n1,0.1,9,contraction\n";
    assert_eq!(read(text).unwrap().0.len(), 1);
}

fn constants(set: &[&str], of: (usize, usize), file: &str) -> Result<Columns, TableError> {
    let set: Vec<String> = set.iter().map(|s| (*s).to_owned()).collect();
    Columns::default().with_constants(&set, of, file)
}

/// The pull of a testing machine at a constant pressure, from the length at which the muscle bears
/// nothing there: L0 200, 160 at 3 bar, so that 1 − (160 + x)/200.
#[test]
fn a_pull_at_constant_pressure_is_points() {
    let text = "\"Time\",\"Extension\",\"Load\"\n\"(s)\",\"(mm)\",\"(N)\"\n\"0.98\",\"0.5\",\"0.678\"\n\"39.01\",\"20\",\"8.637\"\n";
    let read = |set: &[&str], file: &str| {
        read_points(
            text,
            &PointOptions {
                columns: constants(set, (1, 2), file)?,
                rest_length_mm: Some(L0),
                log: None,
            },
        )
    };
    let set = [
        "{pressure}bar",
        "free_length=170mm",
        "free_length=16cm",
        "branch=elongation",
    ];
    let (points, understood) = read(&set, "a/pull_at_3_bar.csv").unwrap();
    let at = points[1].at;
    assert!((at.contraction - 0.1).abs() < 1e-12);
    assert_eq!(
        (at.pressure_mpa, at.force_n, at.branch),
        (0.3, 8.637, Some(Direction::Elongation))
    );
    let line = understood.line();
    for part in [
        "Extension → extension (mm, from the free length at its pressure)",
        "pressure=3bar → pressure",
        "branch=elongation → branch",
    ] {
        assert!(line.contains(part), "{line}");
    }
    for (set, said) in [
        (&["pressure=3bar"][..], "free_length=250mm in `set`"),
        (
            &["{pressure}bar"],
            "\"{pressure}bar\" gives no value for pull.csv",
        ),
        (
            &["pressure=3"],
            "`set`: pressure=3 has no unit; write pressure=3kPa",
        ),
        (&["pressure=3bar"; 3], "given 3 times for 2 tables"),
        (
            &["colour=3bar"],
            "`set`: measured points have no quantity \"colour\"",
        ),
    ] {
        let message = read(set, "pull.csv").unwrap_err().to_string();
        assert!(message.contains(said), "{message}");
    }
    for (pattern, file, value) in [
        ("{pressure}bar", "run2 2.5bar.csv", 0.25),
        ("p{pressure}kPa", "p250kPa_L300.csv", 0.25),
        ("_{pressure}_bar_", "x_13 bar_up.csv", 1.3),
        ("{pressure}bar", "12bars_4-bar.csv", 0.4),
    ] {
        let (points, _) = read(&[pattern, "free_length=160mm"], file).unwrap();
        assert!((points[0].at.pressure_mpa - value).abs() < 1e-12, "{file}");
    }
}

/// An isometric test: the load cell's log, and that of a pressure sensor whose clock is 1.37 s late
/// and which is read less often. The pressure rises to 0.3 MPa in 5 s and falls again; the pull is
/// 1000 N/MPa above 0.03 MPa.
#[test]
fn a_log_of_pressures_is_joined_by_time() {
    let pressure = |t: f64| 0.3 * (1.0 - (t - 5.0).abs() / 5.0);
    let rows = (0..=100)
        .map(|i| 0.1 * f64::from(i))
        .map(|t| format!("{t:.2};{:.3}\n", (1e3 * pressure(t) - 30.0).max(0.0)));
    let text = format!(
        "Zeit [s];Kraft [N]\n{}",
        rows.collect::<String>().replace('.', ",")
    );
    let points: Vec<(f64, f64)> = (0..=50)
        .map(|i| 0.19 * f64::from(i) + 0.15)
        .map(|t| (t - 1.37, pressure(t)))
        .collect();
    let columns = constants(&["contraction=0", "branch=velocity"], (0, 1), "log.csv").unwrap();
    let read = |offset_s| {
        let log = PressureLog {
            name: "p.csv".into(),
            points: points.clone(),
            offset_s,
        };
        read_points(
            &text,
            &PointOptions {
                columns: columns.clone(),
                rest_length_mm: None,
                log: Some(log),
            },
        )
        .unwrap()
    };
    let (joined, understood) = read(None);
    for p in &joined {
        let t = 0.1 * (p.line as f64 - 2.0);
        assert!((p.at.pressure_mpa - pressure(t)).abs() < 0.006, "{p:?}");
        let branch = if t < 4.99 {
            Direction::Contraction
        } else {
            Direction::Elongation
        };
        assert!(
            p.at.branch == Some(branch) || (t - 5.0).abs() < 0.2,
            "{p:?}"
        );
    }
    let line = understood.line();
    for part in [
        "from p.csv at its times + 1.3",
        "found: the pull follows",
        "; 6 rows outside of it",
        "branches by the sign of the velocity",
    ] {
        assert!(line.contains(part), "{line}");
    }
    assert!(read(Some(1.0)).1.line().contains("+ 1.0000 s, given"));
}

/// A loop over the contraction with noise, and a dwell at its end.
#[test]
fn a_log_is_cut_into_branches_by_the_sign_of_its_velocity() {
    let values = [
        0.0, 0.02, 0.019, 0.05, 0.1, 0.0995, 0.1, 0.06, 0.0605, 0.03, 0.05, 0.08,
    ];
    let rows = values.map(|e| format!("3,{e},100\n")).concat();
    let options = PointOptions {
        columns: constants(&["branch=velocity"], (0, 1), "log.csv").unwrap(),
        ..PointOptions::default()
    };
    let (points, _) = read_points(
        &format!("pressure_bar,contraction,force_n\n{rows}"),
        &options,
    )
    .unwrap();
    let sign = |p: &DataPoint| {
        if p.at.branch == Some(Direction::Contraction) {
            '+'
        } else {
            '-'
        }
    };
    assert_eq!(points.iter().map(sign).collect::<String>(), "+++++++---++");
}

#[test]
fn percents_that_are_likely_ratios_are_named() {
    let note = |values: &str| {
        let read = read(&format!(
            "p_bar,contraction_percent,force_n\n1,0,9\n1,{values},3\n"
        ))
        .unwrap();
        read.1.columns[1].note.clone().unwrap_or_default()
    };
    assert!(note("0.15").contains("if they are ratios"));
    assert_eq!(note("15"), "");
}

/// Columns of our tables mean what they meant, beside columns that people would call alike.
#[test]
fn tables_of_this_program_are_read_as_ever() {
    let text = "pressure_mpa,contraction,force_n,measured,model_force_n,residual_n,weight,outlier,line,data,contraction_error\n\
                0.1,0.05,200,contraction,201,1,0.5,false,2,1,0.002\n0.1,0.05,200,,,,,,,,\n";
    let (points, understood) = read(text).unwrap();
    let stated = |p: &DataPoint| (p.measured, p.error, p.weight);
    assert_eq!(
        stated(&points[0]),
        (Quantity::Contraction, Some(0.002), 0.5)
    );
    assert_eq!(stated(&points[1]), (Quantity::Force, None, 1.0));
    assert_eq!(
        understood.not_used,
        ["model_force_n", "residual_n", "outlier", "line", "data"]
    );
    let text = "muscle,outer_diameter_mm,wall_mm,length_mm,angle_deg,pressure_mpa,contraction,force_n,start_pressure_mpa,status,cause\n\
                0,30,3,285,28,0.1,0.05,200,0.01,ok,\n0,30,3,285,28,0.1,0.3,,0.01,not_converged,no\n\
                1,40,3,300,28,0.1,0.05,300,0.01,ok,\n";
    let (points, understood) = read(text).unwrap();
    assert_eq!((points.len(), understood.left_out), (2, 1));
    assert_eq!(points[1].section.length_mm, Some(300.0));
    let section = points[0].section;
    assert_eq!(
        (section.outer_diameter_mm, section.angle_deg, points[1].line),
        (Some(30.0), Some(28.0), 4)
    );
    let quantities: Vec<&str> = understood
        .columns
        .iter()
        .map(|c| c.quantity.as_str())
        .collect();
    assert_eq!(
        quantities[..4],
        ["outer_diameter", "wall", "rest_length", "angle"]
    );
}

/// Volumes count where there are no pulls, and in rows that say so; a volume beside pulls is none
/// of the reading.
#[test]
fn volumes_are_read_where_they_were_measured() {
    let (points, _) = read("pressure_bar,contraction_percent,Volume [mL]\n2.5,10,40\n").unwrap();
    assert_eq!(
        (points[0].measured, points[0].volume_mm3),
        (Quantity::Volume, Some(4e4))
    );
    let text = "pressure_mpa,contraction,force_n,volume_mm3,measured\n0.1,0,30,,force\n0.1,0.1,,5000,volume\n";
    let (points, _) = read(text).unwrap();
    assert_eq!(
        points.iter().map(|p| p.volume_mm3).collect::<Vec<_>>(),
        [None, Some(5000.0)]
    );
    let (points, understood) =
        read("pressure_mpa,contraction,force_n,volume\n0.1,0,30,nothing\n").unwrap();
    assert_eq!(
        (points[0].measured, understood.not_used),
        (Quantity::Force, vec!["volume".to_owned()])
    );
}
