//! The variables of a unit, and what `modelDescription.xml` has of them in both versions of FMI.

use super::Kind;
use crate::ExportedMuscle;
use crate::template::number;
use std::fmt::Write as _;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Role {
    Input,
    Fixed,
    Tunable,
    State,
    Local,
    /// The indicator of an event.
    Event,
    Output,
    /// The only integer.
    Status,
}
use Role::{Event, Fixed, Input, Local, Output, State, Status, Tunable};

/// The word of each role in the table, and what a description says of it.
const ROLES: [(&str, Role, &str); 8] = [
    ("input", Input, "causality=\"input\" variability=\"continuous\""),
    ("fixed", Fixed, "causality=\"parameter\" variability=\"fixed\" initial=\"exact\""),
    ("tunable", Tunable, "causality=\"parameter\" variability=\"tunable\" initial=\"exact\""),
    ("state", State, "causality=\"local\" variability=\"continuous\" initial=\"calculated\""),
    ("local", Local, "causality=\"local\" variability=\"continuous\" initial=\"calculated\""),
    ("event", Event, "causality=\"local\" variability=\"continuous\" initial=\"calculated\""),
    ("output", Output, "causality=\"output\" variability=\"continuous\" initial=\"calculated\""),
    ("status", Status, "causality=\"output\" variability=\"discrete\" initial=\"calculated\""),
];

/// One variable; its value reference is the place of its name in the list at the beginning of fmu2.c.
pub(super) struct Variable {
    name: &'static str,
    role: Role,
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

/// The variables of a unit, by a table; `-` is none, `held` stands for pressure and length or what gives them.
pub(super) fn variables(muscle: &ExportedMuscle, kind: Kind) -> Vec<Variable> {
    let (form, is_valve) = (&muscle.form, kind == Kind::Valve);
    let volume_m3 = form.at(0.0, 0.0).volume_m3;
    let value = |text: &str| match text {
        "max" => f64::MAX,
        "-max" => -f64::MAX,
        "length" => form.length_m,
        "supply" => form.supply_pa,
        "volume" => volume_m3,
        "mass" => 1.2 * volume_m3,
        number => number.parse().unwrap_or(f64::NAN),
    };
    let other = if is_valve { "pressure" } else { "valve" };
    let table = include_str!("../../../templates/fmu_variables.tsv").lines().skip(1);
    let one = |line: &'static str| {
        let cells: Vec<&str> = line.split('\t').collect();
        let &[of, name, word, state, unit, on, start, low, high, nominal, about] = &cells[..] else {
            return None;
        };
        let role = ROLES.iter().find(|role| role.0 == word)?.1;
        let on = match on {
            "held" if is_valve => "length air",
            "held" => "pressure length",
            on => on,
        };
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
        .filter(|_| of != other)
    };
    table.filter_map(one).collect()
}

/// The names of fmu2.c: the place of each is its value reference, and those before `force` can be set or are states.
pub(super) fn references() -> Vec<String> {
    let source = include_str!("../../../templates/fmu2.c");
    let list = source.split_once("enum {\n    PRESSURE").and_then(|(_, rest)| rest.split_once("\n};"));
    let names = list.map_or("", |(names, _)| names);
    format!("PRESSURE{names}").split(',').map(|name| name.trim().to_ascii_lowercase()).collect()
}

fn reference(name: &str) -> usize {
    references().iter().position(|known| known == name).unwrap_or(usize::MAX)
}

/// Start, range and nominal value of each variable that can be set or is a state, as muscle.bin has them.
pub(super) fn settings(variables: &[Variable]) -> Vec<f64> {
    let names = references();
    let known = names.iter().take_while(|name| *name != "force");
    known
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
    /// With its value at the start, its least and largest value, and its usual size.
    fn nature(&self) -> &'static str {
        ROLES.iter().find(|role| role.1 == self.role).map_or("", |role| role.2)
    }

    fn values(&self) -> String {
        if self.role == Status {
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

    pub(super) fn is_state(&self) -> bool {
        self.role == State
    }

    fn is_unknown_at_the_start(&self) -> bool {
        self.is_state() || matches!(self.role, Output | Status) || self.derivative_of.is_some()
    }
}

/// `ModelVariables` and `ModelStructure` of FMI 2.0, which names a variable by its place, from 1.
pub(super) fn second(variables: &[Variable]) -> (String, String) {
    let place = |name: &str| variables.iter().position(|v| v.name == name).map_or(0, |at| at + 1).to_string();
    let mut out = String::new();
    for v in variables {
        let element = if v.role == Status { "Integer" } else { "Real" };
        let _ = writeln!(
            out,
            "    <ScalarVariable name=\"{}\" valueReference=\"{}\" {} description=\"{}\"><{element}{}{}/></ScalarVariable>",
            v.name,
            reference(v.name),
            v.nature(),
            v.about,
            v.values(),
            attribute("derivative", v.derivative_of.map(place)),
        );
    }
    let unknowns = |which: &dyn Fn(&Variable) -> bool, dependent: bool| {
        let each = variables.iter().filter(|v| which(v)).map(|v| {
            let on = dependent.then(|| v.on.iter().map(|name| place(name)).collect::<Vec<_>>().join(" "));
            format!("      <Unknown index=\"{}\"{}/>\n", place(v.name), attribute("dependencies", on))
        });
        each.collect::<String>()
    };
    let mut structure =
        format!("    <Outputs>\n{}    </Outputs>\n", unknowns(&|v| matches!(v.role, Output | Status), true));
    if variables.iter().any(Variable::is_state) {
        let derivatives = unknowns(&|v| v.derivative_of.is_some(), true);
        let _ = writeln!(structure, "    <Derivatives>\n{derivatives}    </Derivatives>");
    }
    let initial = unknowns(&Variable::is_unknown_at_the_start, false);
    let _ = write!(structure, "    <InitialUnknowns>\n{initial}    </InitialUnknowns>");
    (out.trim_end().into(), structure)
}

/// The same of FMI 3.0, which names a variable by its value reference.
pub(super) fn third(variables: &[Variable]) -> (String, String) {
    let place = |name: &str| reference(name).to_string();
    let mut out = format!(
        "    <Float64 name=\"time\" valueReference=\"{}\" causality=\"independent\" variability=\"continuous\" unit=\"s\"/>\n",
        place("time")
    );
    for v in variables {
        let element = if v.role == Status { "Int32" } else { "Float64" };
        let _ = writeln!(
            out,
            "    <{element} name=\"{}\" valueReference=\"{}\" {}{}{} description=\"{}\"/>",
            v.name,
            place(v.name),
            v.nature(),
            v.values(),
            attribute("derivative", v.derivative_of.map(place)),
            v.about,
        );
    }
    let mut structure = String::new();
    let mut unknowns = |element: &str, which: &dyn Fn(&Variable) -> bool, dependent: bool| {
        for v in variables.iter().filter(|v| which(v)) {
            let on = dependent.then(|| v.on.iter().map(|name| place(name)).collect::<Vec<_>>().join(" "));
            let dependencies = attribute("dependencies", on);
            let _ =
                writeln!(structure, "    <{element} valueReference=\"{}\"{dependencies}/>", place(v.name));
        }
    };
    unknowns("Output", &|v| matches!(v.role, Output | Status), true);
    unknowns("ContinuousStateDerivative", &|v| v.derivative_of.is_some(), true);
    unknowns("InitialUnknown", &Variable::is_unknown_at_the_start, false);
    unknowns("EventIndicator", &|v| v.role == Event, true);
    (out.trim_end().into(), structure.trim_end().into())
}

/// How many of them indicate events.
pub(super) fn events(variables: &[Variable]) -> usize {
    variables.iter().filter(|v| v.role == Event).count()
}
