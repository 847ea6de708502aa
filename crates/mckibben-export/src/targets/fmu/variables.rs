//! The variables of a unit, and their part of `modelDescription.xml` in both versions of FMI.

use super::{Kind, Version};
use crate::{ExportedMuscle, template::number};
use mckibben_core::joined;
use std::fmt::Write as _;

/// What the role of a variable is in a description.
fn nature(role: &str) -> &'static str {
    match role {
        "input" => "causality=\"input\" variability=\"continuous\"",
        "fixed" => "causality=\"parameter\" variability=\"fixed\" initial=\"exact\"",
        "tunable" => "causality=\"parameter\" variability=\"tunable\" initial=\"exact\"",
        "output" => "causality=\"output\" variability=\"continuous\" initial=\"calculated\"",
        // The only integer.
        "status" => "causality=\"output\" variability=\"discrete\" initial=\"calculated\"",
        // A state, a derivative, the indicator of an event.
        _ => "causality=\"local\" variability=\"continuous\" initial=\"calculated\"",
    }
}

/// One variable; its value reference is the place of its name in the list at the beginning of
/// fmu2.c.
pub struct Variable {
    name: &'static str,
    role: &'static str,
    unit: &'static str,
    about: &'static str,
    start: f64,
    range: (f64, f64),
    nominal: f64,
    /// The state whose derivative it is.
    derivative_of: Option<&'static str>,
    /// The inputs and states that it depends on at once.
    on: Vec<&'static str>,
}

/// The variables of a unit, by a table; `-` is none, `held` stands for pressure and length, what
/// gives them, or pressures and angle.
pub fn variables(muscle: &ExportedMuscle, kind: Kind) -> Vec<Variable> {
    let form = &muscle.form;
    let (rows, held) = match kind {
        Kind::Pressure => (["any", "muscle", "pressure"], "pressure length"),
        Kind::Valve => (["any", "muscle", "valve"], "length air"),
        Kind::Joint(1) => (["any", "joint", ""], "pressure_1 angle"),
        Kind::Joint(_) => (["any", "joint", "second"], "pressure_1 pressure_2 angle"),
    };
    let volume_m3 = form.point_at(0.0, 0.0).volume_m3;
    let value = |text: &str| match text {
        "max" => f64::MAX,
        "-max" => -f64::MAX,
        "length" => form.length_m,
        "cord" => muscle.cord_m,
        "reach" => form.length_m + muscle.cord_m,
        "supply" => form.supply_pa,
        "volume" => volume_m3,
        "mass" => 1.2 * volume_m3,
        number => number.parse().unwrap_or(f64::NAN),
    };
    let table = include_str!("../../../templates/fmu_variables.tsv")
        .lines()
        .skip(1);
    let one = |line: &'static str| {
        let cells = Vec::from_iter(line.split('\t'));
        let &[
            kind,
            name,
            role,
            state,
            unit,
            on,
            start,
            low,
            high,
            nominal,
            about,
        ] = &cells[..]
        else {
            return None;
        };
        let on = if on == "held" { held } else { on };
        Some(Variable {
            name,
            role,
            unit,
            about,
            start: value(start),
            range: (value(low), value(high)),
            nominal: value(nominal),
            derivative_of: Some(state).filter(|state| *state != "-"),
            on: on.split(' ').filter(|name| *name != "-").collect(),
        })
        .filter(|_| rows.contains(&kind))
    };
    table.filter_map(one).collect()
}

/// The names of fmu2.c: the place of each is its value reference, and those before `force` can be
/// set or are states.
pub fn references() -> Vec<String> {
    let source = include_str!("../../../templates/fmu2.c");
    let names = source
        .split_once("enum {\n    PRESSURE")
        .and_then(|(_, rest)| rest.split_once("\n};"))
        .map_or("", |(names, _)| names);
    format!("PRESSURE{names}")
        .split(',')
        .map(|name| name.trim().to_ascii_lowercase())
        .collect()
}

fn reference(name: &str) -> usize {
    references()
        .iter()
        .position(|known| known == name)
        .unwrap_or(usize::MAX)
}

/// Start, range and nominal value of each variable that can be set or is a state, as muscle.bin has
/// them.
pub fn settings(variables: &[Variable]) -> Vec<f64> {
    references()
        .iter()
        .take_while(|name| *name != "force")
        .flat_map(|name| match variables.iter().find(|v| v.name == name) {
            Some(v) => [v.start, v.range.0, v.range.1, v.nominal],
            None => [0.0, f64::NAN, f64::NAN, 1.0],
        })
        .collect()
}

fn attribute(name: &str, value: Option<String>) -> String {
    value.map_or_else(String::new, |value| format!(" {name}=\"{value}\""))
}

impl Variable {
    /// Its start, unit, range and nominal value.
    fn values(&self) -> String {
        if self.role == "status" {
            return String::new();
        }
        let finite = |v: f64| (v.is_finite() && v.abs() < f64::MAX).then(|| number(v));
        let nominal = finite(self.nominal).filter(|_| self.nominal != 1.0);
        [
            attribute("start", finite(self.start)),
            attribute("unit", Some(self.unit.into())),
            attribute("min", finite(self.range.0)),
            attribute("max", finite(self.range.1)),
            attribute("nominal", nominal),
        ]
        .concat()
    }

    pub fn is_state(&self) -> bool {
        self.role == "state"
    }

    fn is_output(&self) -> bool {
        matches!(self.role, "output" | "status")
    }

    fn is_unknown_at_the_start(&self) -> bool {
        self.is_state() || self.is_output() || self.derivative_of.is_some()
    }
}

/// The unknowns of a description: their group in FMI 2.0 and their element in FMI 3.0, which
/// variables, and whether dependencies are stated.
type Unknowns = (&'static str, &'static str, fn(&Variable) -> bool, bool);

const UNKNOWNS: [Unknowns; 4] = [
    ("Outputs", "Output", Variable::is_output, true),
    (
        "Derivatives",
        "ContinuousStateDerivative",
        |v| v.derivative_of.is_some(),
        true,
    ),
    (
        "InitialUnknowns",
        "InitialUnknown",
        Variable::is_unknown_at_the_start,
        false,
    ),
    ("", "EventIndicator", |v| v.role == "event", true),
];

/// `ModelVariables` and `ModelStructure`. FMI 2.0 names a variable by its place, from 1, and FMI
/// 3.0 by its value reference.
pub fn description(variables: &[Variable], version: Version) -> (String, String) {
    let is_third = version == Version::Third;
    let key = |name: &str| {
        if is_third {
            reference(name)
        } else {
            let place = variables.iter().position(|v| v.name == name);
            place.map_or(0, |place| place + 1)
        }
        .to_string()
    };
    let mut list = String::new();
    if is_third {
        let time = key("time");
        let _ = writeln!(
            list,
            "    <Float64 name=\"time\" valueReference=\"{time}\" causality=\"independent\" \
             variability=\"continuous\" unit=\"s\"/>"
        );
    }
    for v in variables {
        let names = format!(
            "name=\"{}\" valueReference=\"{}\" {}",
            v.name,
            reference(v.name),
            nature(v.role)
        );
        let values = v.values() + &attribute("derivative", v.derivative_of.map(key));
        let about = v.about;
        let is_status = v.role == "status";
        let _ = if is_third {
            let element = if is_status { "Int32" } else { "Float64" };
            writeln!(
                list,
                "    <{element} {names}{values} description=\"{about}\"/>"
            )
        } else {
            let element = if is_status { "Integer" } else { "Real" };
            writeln!(
                list,
                "    <ScalarVariable {names} \
                 description=\"{about}\"><{element}{values}/></ScalarVariable>"
            )
        };
    }
    let mut structure = String::new();
    for (group, element, is_unknown, states_dependencies) in UNKNOWNS {
        let start = if is_third {
            format!("    <{element} valueReference")
        } else {
            "      <Unknown index".into()
        };
        let unknown = |v: &Variable| {
            let on = states_dependencies.then(|| joined(v.on.iter().map(|name| key(name)), " "));
            format!(
                "{start}=\"{}\"{}/>\n",
                key(v.name),
                attribute("dependencies", on)
            )
        };
        let unknowns: String = variables
            .iter()
            .filter(|v| is_unknown(v))
            .map(unknown)
            .collect();
        if is_third {
            structure += &unknowns;
        } else if !(group.is_empty() || unknowns.is_empty()) {
            structure += &format!("    <{group}>\n{unknowns}    </{group}>\n");
        }
    }
    (list.trim_end().into(), structure.trim_end().into())
}

/// How many of them indicate events.
pub fn events(variables: &[Variable]) -> usize {
    variables.iter().filter(|v| v.role == "event").count()
}
