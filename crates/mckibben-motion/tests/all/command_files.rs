//! Commands, loads from outside and their tables in drive files.

use mckibben_motion::*;

#[test]
fn commands_are_spoken() {
    let read = |text: &str| {
        let text = format!(
            "muscle = 'm'\n[regulator]\ntime_constant = '0.1 s'\n[command]\npressure = \
             '{text}'\nuntil = '1 s'\n"
        );
        match parse_drive(&text, &Tables::default()).ok()?.target {
            Commanded::Pressure(commands) => commands.into_iter().next(),
            _ => None,
        }
    };
    assert_eq!(
        read("ramp 0..3 bar in 2 s"),
        Some(Command::Ramps(vec![(0.0, 0.0), (2.0, 0.3)]))
    );
    let Some(Command::Sine {
        mean,
        amplitude,
        frequency_hz,
        ..
    }) = read("sine 1..3 bar at 2 Hz")
    else {
        panic!()
    };
    assert!((mean - 0.2).abs() < 1e-12 && (amplitude - 0.1).abs() < 1e-12 && frequency_hz == 2.0);
    assert!(read("chirp 1..3 bar from 0.1..5 Hz in 10 s").is_some());
    assert_eq!(read("3 bar"), Some(Command::Constant(0.3)));
    assert_eq!(read("saw 1..3 bar"), None);
}

/// A bare number is what it is in a text, in MPa; and what `motion` writes is read.
#[test]
fn identity_bare_numbers_and_own_columns_are_read() {
    let drive = |value: &str, table: &str| {
        let text = format!(
            "joint = 'j'\n[regulator]\ntime_constant = '0.1 s'\n[command]\npressure_1 = \
             {value}\npressure_2 = 0\nuntil = '1 s'\n"
        );
        let texts = [("t.csv".to_owned(), table.to_owned())].into();
        let tables = Tables {
            texts,
            rest_length_mm: 1.0,
        };
        parse_drive(&text, &tables).unwrap().target
    };
    assert_eq!(drive("0.2", ""), drive("'0.2'", ""));
    assert_eq!(drive("0.2", ""), drive("'2 bar'", ""));
    let own = "time_s,angle_deg,pressure_1_mpa,pressure_2_mpa\n0,1,0.2,0.1\n1,2,0.3,0.1\n";
    let Commanded::Pressure(commands) = drive("'table:t.csv'", own) else {
        panic!()
    };
    assert_eq!(commands[0].value(0.0), 0.2);
}

/// Forces and torques of a table are joined by straight lines, a torque in N mm against the angle.
#[test]
fn identity_external_tables_are_joined_by_straight_lines() {
    let external = |of: &str, key: &str, table: &str| {
        let text = format!(
            "{of} = 'm'\n[regulator]\ntime_constant = '0.1 s'\n[external]\n{key} = \
             'table:t.csv'\n[command]\npressure = 0\nuntil = '1 s'\n"
        );
        let tables = Tables {
            texts: [("t.csv".to_owned(), table.to_owned())].into(),
            rest_length_mm: 1.0,
        };
        parse_drive(&text, &tables).map(|drive| drive.external.value(0.5))
    };
    let force = "t [ms];Kraft [kN]\n0;0\n1000;0,2\n";
    assert!((external("muscle", "force", force).unwrap() - 100.0).abs() < 1e-9);
    let torque = "time_s,torque_nm\n0,1\n1,2\n";
    assert!((external("joint", "torque", torque).unwrap() + 1500.0).abs() < 1e-9);
    let error = external("muscle", "force", torque).unwrap_err();
    assert!(error.to_string().contains("forces"), "{error}");
}
