//! Drive files: what they say, and where they are wrong.

use mckibben_motion::*;

const MUSCLE: &str = "muscle = 'm.toml'\n";
const HEAD: &str = "muscle = 'm.toml'\n[valve]\nsonic_conductance = '0.5 L/(s bar)'\n";
const GAINS: &str = "[controller]\nproportional = '5 bar'\nintegral = '0.2 MPa/s'\n\
    derivative = '3 kPa s'\n";
const TAIL: &str = "[command]\npressure = '3 bar'\nuntil = '1 s'\n";

#[test]
fn the_file_of_the_contract_is_read() {
    let drive = parse_drive(
        "muscle = \"muscle.toml\"\n[supply]\npressure = \"6 bar\"\ntemperature = \"20 degC\"\n\
         [valve]\nsonic_conductance = \"0.5 L/(s bar)\"\ncritical_ratio = 0.3\n\
         [air]\ndead_volume = \"10 cm3\"\nheat = \"25 W/(m2 K)\"\n\
         [load]\nmass = \"10 kg\"\ndamping = \"400 N s/m\"\nstops = \"-5..80 mm\"\n\
         [command]\npressure = [[\"0 s\", \"0 bar\"], [\"0.1 s\", \"3 bar\"]]\nuntil = \"5 \
         s\"\n",
        &Tables::default(),
    )
    .unwrap();
    assert_eq!(
        drive.supply,
        Supply {
            pressure_mpa: 0.6,
            temperature_k: 293.15
        }
    );
    let Actuator::Valve(valve) = drive.actuator else {
        panic!()
    };
    assert_eq!(valve.supply, Orifice::new(0.5, 0.3).unwrap());
    let Fluid::Air(air) = &drive.fluid else {
        panic!()
    };
    assert_eq!((air.heat, air.dead_volume_mm3), (Heat::Transfer(25.0), 1e4));
    assert_eq!(drive.presliding_mm, None);
    assert_eq!(
        (drive.damping_n_s_per_m, drive.stops_mm),
        (400.0, (-5.0, 80.0))
    );
    assert_eq!(
        drive.target,
        Commanded::Pressure(vec![Command::Steps(vec![(0.0, 0.0), (0.1, 0.3)])])
    );
    assert_eq!((drive.until_s, drive.output_step_s), (5.0, 0.005));
}

/// n lies between isothermal and adiabatic, and the key that does not is named with its line.
#[test]
fn a_polytropic_index_outside_of_1_to_the_heat_ratio_is_refused_by_its_key() {
    let read = |n: f64| {
        parse_drive(
            &format!("{HEAD}[air]\npolytropic_index = {n}\n{TAIL}"),
            &Tables::default(),
        )
    };
    assert!(read(1.2).is_ok());
    for wrong in [0.9, 1.6] {
        let said = read(wrong).err().unwrap().to_string();
        assert!(
            said.starts_with("line 5") && said.contains("from 1 to 1.4"),
            "{said}"
        );
        assert!(said.contains("air.polytropic_index"), "{said}");
    }
}

#[test]
fn liquids_have_valves_pumps_and_syringes() {
    let read = |text: &str| {
        parse_drive(
            &format!("muscle = 'm.toml'\n[liquid]\nname = 'oil'\n{text}"),
            &Tables::default(),
        )
        .unwrap()
    };
    let drive = read(&format!(
        "gas_share = '1 %'\n[valve]\nflow_coefficient = '0.36 m3/h'\nhose_length = '1 \
         m'\nhose_diameter = '4 mm'\n{TAIL}"
    ));
    let Fluid::Liquid(fill) = &drive.fluid else {
        panic!()
    };
    assert_eq!((fill.liquid.name, fill.liquid.gas_share), ("oil", 0.01));
    // 0.36 m³/h is 0.1 L/s.
    let Actuator::LiquidValve(valve) = drive.actuator else {
        panic!()
    };
    assert!((valve.supply.kv_mm3_per_s - 1e5).abs() < 1e-6 && valve.tank == valve.supply);
    assert!(valve.line.is_some());
    let drive = read(
        "[syringe]\nvolume = '20 mL'\n[command]\nvolume = 'ramp 0..15 mL in 2 s'\nuntil = '3 \
         s'\n",
    );
    assert_eq!(
        drive.actuator,
        Actuator::Syringe(Syringe {
            volume_mm3: 20e3,
            time_constant_s: 0.05
        })
    );
    assert_eq!(
        drive.target,
        Commanded::Volume(vec![Command::Ramps(vec![(0.0, 0.0), (2.0, 15e3)])])
    );
}

/// A start and a torque of a joint in rad, MPa and N mm against the angle; of a muscle a force.
/// 5 bar = 0.5 MPa; a joint's gains are per rad.
#[test]
fn gains_are_read_with_their_units() {
    let gains = |text: &str| {
        let drive = parse_drive(text, &Tables::default()).unwrap();
        let Commanded::Position { pid, .. } = drive.target else {
            panic!()
        };
        [pid.proportional, pid.integral_per_s, pid.derivative_s]
    };
    let position = |value: &str| format!("[command]\nposition = '{value}'\nuntil = '1 s'\n");
    let muscle = format!("{HEAD}{GAINS}{}", position("10%"));
    assert_eq!(gains(&muscle), [0.5, 0.2, 0.003]);
    let of_joint = GAINS
        .replace("bar'", "bar/rad'")
        .replace("MPa/s'", "MPa/(rad s)'")
        .replace("kPa s'", "kPa s/rad'");
    let joint = format!("{HEAD}{of_joint}{}", position("10 deg"));
    let joint = joint.replace("muscle = 'm.toml'", "joint = 'j.toml'");
    assert_eq!(gains(&joint), [0.5, 0.2, 0.003]);
}

#[test]
fn starts_and_external_torques_are_read() {
    let read = |text: String| parse_drive(&text, &Tables::default());
    let joint = "joint = 'j.toml'\n[regulator]\ntime_constant = '20 ms'\n";
    let rest = "[start]\nposition = '90 deg'\npressures = ['2 bar', 0.1]\n[external]\n\
                torque = [['0 s', '0 N m'], ['0.1 s', '0.5 N m']]\n";
    let drive = read(format!("{joint}{rest}{TAIL}")).unwrap();
    assert_eq!(drive.start, Some(std::f64::consts::FRAC_PI_2));
    assert_eq!(drive.start_mpa, [0.2, 0.1]);
    let Command::Steps(points) = drive.external else {
        panic!()
    };
    assert_eq!(points[1], (0.1, -500.0));
    let force = "[start]\nposition = '10 %'\n[external]\nforce = '20 N'\n";
    let drive = read(format!("{HEAD}{force}{TAIL}")).unwrap();
    assert_eq!(drive.start, Some(0.1));
    assert_eq!(drive.external, Command::Constant(20.0));
    for (wrong, words) in [
        (
            format!("{HEAD}[external]\ntorque = '1 N m'\n{TAIL}"),
            "on a muscle",
        ),
        (
            format!("{joint}[external]\nforce = '1 N'\n{TAIL}"),
            "on a joint",
        ),
        (
            format!("{HEAD}[external]\nforce = 'table:f.csv'\n{TAIL}"),
            "not supplied",
        ),
        (
            format!("{HEAD}[load]\nheld = '10%'\n[start]\nposition = 0.1\n{TAIL}"),
            "[start]",
        ),
        (
            format!("{HEAD}[load]\nheld = '10%'\nmass = '1 kg'\n{TAIL}"),
            "[load]",
        ),
    ] {
        let error = read(wrong).unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
    }
}

#[test]
#[allow(clippy::too_many_lines)] // a table of cases
fn files_say_where_they_are_wrong() {
    for (text, words) in [
        (format!("[valve]\nname = 'x'\n{TAIL}"), "muscle"),
        (format!("{MUSCLE}{TAIL}"), "[regulator]"),
        (
            format!("{HEAD}[regulator]\ntime_constant = '20 ms'\n{TAIL}"),
            "conflicts with [valve]",
        ),
        (
            format!("{MUSCLE}[valve]\nsonic_conductance = '0 L/(s bar)'\n{TAIL}"),
            "above zero",
        ),
        (
            format!("{MUSCLE}[valve]\nname = 'festo-mh3'\n{TAIL}"),
            "festo-mh2",
        ),
        (format!("{HEAD}critical_ratio = 1.5\n{TAIL}"), "critical"),
        (
            format!("{HEAD}[friction]\npresliding = '0 mm'\n{TAIL}"),
            "above zero",
        ),
        (format!("{HEAD}[air]\nheat = 'warm'\n{TAIL}"), "isothermal"),
        (format!("{HEAD}[command]\npressure = '3 bar'\n"), "until"),
        (
            format!("{HEAD}[command]\nuntil = '1 s'\n"),
            "what is commanded",
        ),
        (
            format!(
                "{HEAD}[command]\npressure = [['1 s', '1 bar'], ['0 s', '2 bar']]\nuntil = '1 \
                 s'\n"
            ),
            "must increase",
        ),
        (
            format!("{HEAD}[command]\npressure = [['1 s']]\nuntil = '1 s'\n"),
            "pairs",
        ),
        (
            format!("{HEAD}[command]\npressure = 'NaN bar'\nuntil = '1 s'\n"),
            "command",
        ),
        (
            format!("{HEAD}[supply]\ntemperature = '-300 degC'\n{TAIL}"),
            "absolute zero",
        ),
        (
            format!("{HEAD}hose_length = '1 m'\n{TAIL}"),
            "hose_diameter",
        ),
        (
            format!("{HEAD}[command]\nposition = '10%'\nuntil = '1 s'\n"),
            "proportional",
        ),
        (
            format!("{HEAD}[command]\nposition = true\nuntil = '1 s'\n"),
            "ramp 0..3 bar in 2 s",
        ),
        (
            format!("{HEAD}{GAINS}[command]\nposition = '10%'\nuntil = '1 s'\n")
                .replace("MPa/s", "MPa/rad"),
            "write \"0.5 MPa/s\"",
        ),
        (
            format!(
                "{HEAD}{GAINS}output = 'opening'\n[command]\nposition = '10%'\nuntil = '1 s'\n"
            ),
            "of an opening a number",
        ),
        (
            format!("{HEAD}[liquid]\nname = 'water'\n{TAIL}"),
            "flow_coefficient alone",
        ),
        (
            format!("{HEAD}flow_coefficient = '0.1 m3/h'\n{TAIL}"),
            "no [liquid]",
        ),
        (
            format!("{MUSCLE}[liquid]\nname = 'beer'\n[pump]\nflow = '1 L/min'\n{TAIL}"),
            "glycol",
        ),
        (
            format!("{MUSCLE}[liquid]\nname = 'oil'\n[air]\nheat = 'adiabatic'\n{TAIL}"),
            "keep one",
        ),
        (
            format!("{MUSCLE}[pump]\nflow = '1 L/min'\n[syringe]\nvolume = '1 mL'\n{TAIL}"),
            "keep one",
        ),
        (
            format!("{MUSCLE}[liquid]\nname = 'oil'\n[pump]\n{TAIL}"),
            "Largest flow",
        ),
        (
            format!("joint = 'j.toml'\n[valve]\nname = 'festo-mh2'\n[load]\nmass = '1 kg'\n{TAIL}"),
            "own file",
        ),
    ] {
        let error = parse_drive(&text, &Tables::default())
            .map(|_| String::new())
            .unwrap_or_else(|e| e.to_string());
        assert!(error.contains(words), "{text}: {error}");
    }
}
