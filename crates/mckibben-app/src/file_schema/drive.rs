//! The drive file.

use super::parts::{boolean, named, needing, number, pairs, positive, quantity, root, table, text, word};
use mckibben::liquid::LIQUIDS;
use mckibben::units::Dimension;
use mckibben_motion::valves;
use serde_json::{Value, json};

pub(super) fn schema() -> Value {
    let supply = [
        (
            "pressure",
            positive(Dimension::Pressure, "Gauge pressure of the supply, or of a pump's relief valve"),
        ),
        ("temperature", quantity(Dimension::Temperature, "Temperature of the air and of the walls")),
    ];
    let air = [
        ("dead_volume", quantity(Dimension::Volume, "Volume beside the muscle")),
        (
            "heat",
            named(
                "Exchange of heat: a word, or a coefficient such as \"25 W/(m2 K)\"",
                ["isothermal", "adiabatic"],
            ),
        ),
        (
            "polytropic_index",
            json!({ "type": "number", "minimum": 1, "maximum": 1.4, "description": "Polytropic index, in place of heat" }),
        ),
    ];
    let liquid = [
        ("name", word("The liquid", LIQUIDS.map(|liquid| liquid.name))),
        ("bulk_modulus", positive(Dimension::Pressure, "Its bulk modulus, in place of that of the table")),
        ("gas_share", quantity(Dimension::Ratio, "Gas in it by volume at atmospheric pressure")),
        ("dead_volume", quantity(Dimension::Volume, "Volume beside the muscle, without hose and syringe")),
    ];
    let syringe = [
        ("volume", positive(Dimension::Volume, "What it holds; it is full at the start")),
        ("time_constant", positive(Dimension::Time, "Time constant with which its piston follows")),
    ];
    let load = [
        ("mass", quantity(Dimension::Mass, "Mass that hangs from the muscle")),
        ("level", boolean("Whether the mass slides on a level track")),
        ("line", text("A load such as \"spring:2N/mm@50N\", \"lever:5kg@300mm/40mm\" or \"table:load.csv\"")),
        ("damping", quantity(Dimension::Damping, "Damper")),
        ("stops", text("Lowest and highest shortening, such as \"0..80 mm\"")),
        ("held", quantity(Dimension::Ratio, "Contraction at which both ends are held, in place of a load")),
    ];
    let controller = [
        ("proportional", number("Gain in MPa (or opening) per unit of position")),
        ("integral", number("Integral gain, 1/s")),
        ("derivative", number("Derivative gain, s")),
        ("filter", positive(Dimension::Time, "Time constant of the filter of the derivative")),
        ("tracking", positive(Dimension::Time, "Time constant of the back-calculation")),
        ("output", word("What the controller commands", ["pressure", "opening"])),
        ("bias", quantity(Dimension::Pressure, "Pressure without an error of the position")),
    ];
    let regulator =
        [("time_constant", positive(Dimension::Time, "Time constant with which it follows its command"))];
    let length = positive(Dimension::Length, "Presliding length of the friction");
    let several =
        pairs("Shares of the friction, each with a presliding length: [[0.6, \"0.5 mm\"], [0.4, \"3 mm\"]]");
    let about = "Over which length the friction builds up after a reversal";
    let friction = [("presliding", json!({ "description": about, "anyOf": [length, several] }))];
    let rubber =
        [("prony", pairs("Shares of the wall's pull, each with a time constant: [[0.1, \"50 ms\"]]"))];
    let mut file = root([
        ("muscle", text("Path of a muscle file, relative to this file")),
        ("joint", text("Path of a joint file, relative to this file")),
        ("supply", table("The air supply", supply)),
        ("valve", valve()),
        (
            "regulator",
            needing(table("An ideal regulator, in place of a valve", regulator), &["time_constant"]),
        ),
        ("pump", needing(pump(), &["flow"])),
        ("syringe", needing(table("A syringe of a liquid for each muscle", syringe), &["volume"])),
        ("air", table("The air in the muscle", air)),
        ("liquid", needing(table("A liquid in the muscle, in place of air", liquid), &["name"])),
        ("load", table("The load of a muscle", load)),
        ("friction", table("Motion with the friction of the muscle", friction)),
        ("rubber", table("Viscoelasticity of the rubber", rubber)),
        ("command", command()),
        ("controller", needing(table("The controller of a position", controller), &["proportional"])),
    ]);
    file["required"] = json!(["command"]);
    file
}

fn valve() -> Value {
    let ratio = |about: &str| json!({ "type": "number", "minimum": 0, "maximum": 1, "description": about });
    let flow = |about: &str| positive(Dimension::Flow, about);
    let ways = [
        ("name", named("Name of a valve on sale", valves().iter().map(|valve| valve.name.as_str()))),
        ("sonic_conductance", positive(Dimension::Conductance, "Sonic conductance C (ISO 6358)")),
        ("critical_ratio", ratio("Critical pressure ratio b")),
        ("exhaust_conductance", positive(Dimension::Conductance, "C of the way out")),
        ("exhaust_critical_ratio", ratio("b of the way out")),
        ("flow_coefficient", flow("Of a liquid: flow coefficient Kv, the flow of water at 1 bar")),
        ("return_coefficient", flow("Kv of the way out")),
    ];
    table("A valve for each muscle", ways.into_iter().chain(opening()))
}

fn pump() -> Value {
    let flow = positive(Dimension::Flow, "Largest flow; the supply's pressure is that of its relief valve");
    table(
        "A pump of a liquid for each muscle, which runs both ways",
        [("flow", flow)].into_iter().chain(opening()),
    )
}

/// How a valve or a pump opens, and the hose behind it.
fn opening() -> [(&'static str, Value); 7] {
    let wide = "Error of the pressure at which a proportional valve is wide open";
    [
        ("kind", word("How it opens", ["proportional", "on-off"])),
        ("lag", quantity(Dimension::Time, "Time constant of a proportional valve")),
        ("wide_open_at", positive(Dimension::Pressure, wide)),
        ("hysteresis", positive(Dimension::Pressure, "Half of the dead band of an on-off valve")),
        ("closed_centre", boolean("Whether an on-off valve has a closed centre")),
        ("hose_length", positive(Dimension::Length, "Length of the hose to the muscle")),
        ("hose_diameter", positive(Dimension::Length, "Its inner diameter")),
    ]
}

fn command() -> Value {
    let over_time = |about: &str| {
        let about = format!(
            "{about}: pairs of times and values, a value, \"ramp 0..3 bar in 2 s\", \"sine 1..3 bar at 2 Hz\", \"chirp 1..3 bar from 0.1..5 Hz in 10 s\", or \"table:command.csv\""
        );
        json!({ "description": about, "anyOf": [{ "type": ["number", "string"] }, pairs("Pairs of times and values")] })
    };
    let keys = [
        ("pressure", over_time("Pressure")),
        ("pressure_1", over_time("Pressure of the first muscle")),
        ("pressure_2", over_time("Pressure of the second muscle")),
        ("valve", over_time("Opening of the valve, -1 to 1")),
        ("valve_1", over_time("Opening of the first valve")),
        ("valve_2", over_time("Opening of the second valve")),
        ("volume", over_time("Volume that a syringe pushes out")),
        ("volume_1", over_time("Volume of the first syringe")),
        ("volume_2", over_time("Volume of the second syringe")),
        ("position", over_time("Contraction, or angle of a joint")),
        ("until", positive(Dimension::Time, "End of the run")),
        ("output_step", positive(Dimension::Time, "Time between two points of the result")),
    ];
    needing(table("What is commanded: pressure, valve, volume or position", keys), &["until"])
}
