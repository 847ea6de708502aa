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
    Output,
    /// The only integer.
    Status,
}
use Role::{Fixed, Input, Local, Output, State, Status, Tunable};

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
    on: &'static [&'static str],
}

const ANY: (f64, f64) = (-f64::MAX, f64::MAX);
const POSITIVE: (f64, f64) = (0.0, f64::MAX);

/// The variables of a unit.
pub(super) fn variables(muscle: &ExportedMuscle, kind: Kind) -> Vec<Variable> {
    let (form, volume_m3) = (&muscle.form, muscle.form.at(0.0, 0.0).volume_m3);
    let found = |name, role, unit, on, about| {
        let (start, range, nominal) = (f64::NAN, (f64::NAN, f64::NAN), f64::NAN);
        Variable { name, role, unit, about, on, start, range, nominal, derivative_of: None }
    };
    let held: &[&str] = if kind == Kind::Valve { &["length", "air"] } else { &["pressure", "length"] };
    let (length_m, supply_pa) = (form.length_m, form.supply_pa);
    let mut all = vec![
        found("length", Input, "m", &[], "length between the terminals").within(length_m, ANY, length_m),
        found("force_factor", Tunable, "1", &[], "multiplies the pull: to explore its uncertainty")
            .within(1.0, POSITIVE, 1.0),
    ];
    if kind == Kind::Pressure {
        all.insert(0, found("pressure", Input, "Pa", &[], "gauge pressure").within(0.0, ANY, supply_pa));
    } else {
        let air: &[&str] = &["length", "air", "air_mass"];
        let flow: &[&str] = &["command", "length", "air", "air_mass"];
        let state = |name, unit, nominal, about| Variable { nominal, ..found(name, State, unit, &[], about) };
        let rate = |of, name, role, unit, about| Variable {
            derivative_of: Some(of),
            ..found(name, role, unit, flow, about)
        };
        let opening = "opening of the valve, limited to -1 to 1: above 0 from the supply into the muscle, below 0 into the atmosphere";
        all.insert(0, found("command", Input, "1", &[], opening).within(0.0, ANY, 1.0));
        for (c, b, of_c) in [
            ("sonic_conductance", "critical_ratio", "sonic conductance from the supply (ISO 6358)"),
            ("exhaust_conductance", "exhaust_critical_ratio", "sonic conductance into the atmosphere"),
        ] {
            all.push(found(c, Tunable, "m3/(s.Pa)", &[], of_c).within(5e-9, (0.0, 1e-2), 1e-8));
            all.push(found(b, Tunable, "1", &[], "critical ratio of pressures there").within(
                0.3,
                (0.0, 0.98),
                1.0,
            ));
        }
        all.extend([
            found("supply_pressure", Tunable, "Pa", &[], "gauge pressure of the supply")
                .within(supply_pa, POSITIVE, supply_pa),
            found("temperature", Fixed, "K", &[], "of the supply, the walls, and the air at the start")
                .within(293.15, (50.0, 2000.0), 300.0),
            found("dead_volume", Fixed, "m3", &[], "volume of the air outside of the cavity")
                .within(0.0, POSITIVE, volume_m3),
            found(
                "polytropic_exponent",
                Fixed,
                "1",
                &[],
                "1 isothermal; 1.4 adiabatic, or with heat_conductance the balance of energy",
            )
            .within(1.0, (1.0, 1.4), 1.0),
            found(
                "heat_conductance",
                Fixed,
                "W/K",
                &[],
                "heat from the walls per kelvin, with the exponent 1.4",
            )
            .within(0.0, POSITIVE, 1.0),
            found("initial_pressure", Fixed, "Pa", &[], "gauge pressure at the start").within(
                0.0,
                (-1e5, f64::MAX),
                supply_pa,
            ),
            state("air", "m3", volume_m3, "volume that the air has at 101325 Pa without heat"),
            state("air_mass", "kg", 1.2 * volume_m3, "mass of the air"),
            rate("air", "air_rate", Local, "m3/s", "derivative of air"),
            rate("air_mass", "air_flow", Output, "kg/s", "mass flow into the muscle"),
            found("air_temperature", Output, "K", air, "temperature of the air"),
            found("pressure", Output, "Pa", held, "gauge pressure"),
        ]);
        all.extend(EVENTS.map(|(name, on, about)| found(name, Local, "1", on, about)));
    }
    all.extend([
        found("force", Output, "N", held, "pull; 0 where the muscle is slack"),
        found("stiffness", Output, "N/m", held, "slope of the pull in the length at constant pressure"),
        found("volume", Output, "m3", held, "volume of the cavity"),
        found(
            "force_per_pressure",
            Output,
            "m2",
            held,
            "slope of the pull in the pressure at constant length",
        ),
        found(
            "status",
            Status,
            "",
            held,
            "0, or a sum: 1 slack, 2 pressure outside of the box, 4 contraction outside",
        ),
    ]);
    all
}

type Event = (&'static str, &'static [&'static str], &'static str);
const EVENTS: [Event; 3] = [
    ("command_sign", &["command"], "indicator of an event: another way of the valve opens"),
    ("command_limit", &["command"], "indicator of an event: the valve is wide open"),
    ("taut", &["length", "air"], "indicator of an event: the muscle becomes slack or taut"),
];

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
    fn within(self, start: f64, range: (f64, f64), nominal: f64) -> Self {
        Self { start, range, nominal, ..self }
    }

    fn causality(&self) -> &'static str {
        match self.role {
            Input => "input",
            Fixed | Tunable => "parameter",
            State | Local => "local",
            Output | Status => "output",
        }
    }

    /// Causality, variability and how it is initialised.
    fn nature(&self) -> String {
        let variability = match self.role {
            Fixed => "fixed",
            Tunable => "tunable",
            Status => "discrete",
            Input | State | Local | Output => "continuous",
        };
        let initial = match self.role {
            Input => "",
            Fixed | Tunable => " initial=\"exact\"",
            _ => " initial=\"calculated\"",
        };
        format!("causality=\"{}\" variability=\"{variability}\"{initial}", self.causality())
    }

    /// Start, unit, range and nominal value.
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
    let is_event = |v: &Variable| EVENTS.iter().any(|(name, ..)| *name == v.name);
    unknowns("Output", &|v| matches!(v.role, Output | Status), true);
    unknowns("ContinuousStateDerivative", &|v| v.derivative_of.is_some(), true);
    unknowns("InitialUnknown", &Variable::is_unknown_at_the_start, false);
    unknowns("EventIndicator", &is_event, true);
    (out.trim_end().into(), structure.trim_end().into())
}

/// How many event indicators there are.
pub(super) fn events(kind: Kind) -> usize {
    if kind == Kind::Valve { EVENTS.len() } else { 0 }
}
