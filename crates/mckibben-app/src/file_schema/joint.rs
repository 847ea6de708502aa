//! The joint file.

use super::parts::{needing, number, point, positive, quantity, root, table, text};
use mckibben::units::Dimension;
use serde_json::Value;

pub(super) fn schema() -> Value {
    let joint = [
        (
            "radius",
            positive(Dimension::Length, "Radius of the pulley of every muscle without its own geometry"),
        ),
        ("range", text("Limits of the angle, such as \"-60..60 deg\"")),
        ("inertia", positive(Dimension::Inertia, "Moment of inertia about the axis, for motion")),
        ("damping", quantity(Dimension::AngularDamping, "Damping, for motion")),
    ];
    let link = [
        ("mass", quantity(Dimension::Mass, "Mass of the moving parts")),
        ("centre", quantity(Dimension::Length, "Distance of their centre of mass from the axis")),
        (
            "inclination",
            quantity(
                Dimension::Angle,
                "Angle of the line from the axis to it, against the horizontal, at the neutral angle",
            ),
        ),
        ("payload", quantity(Dimension::Mass, "Mass of a payload")),
        ("payload_at", quantity(Dimension::Length, "Its distance from the axis")),
    ];
    let spring = [
        ("rate", positive(Dimension::Stiffness, "Rate of a spring on a rope")),
        ("preload", quantity(Dimension::Force, "Its force at the neutral angle")),
        ("angular_rate", positive(Dimension::AngularStiffness, "Rate of a torsion spring")),
        ("preload_torque", quantity(Dimension::Torque, "Its torque at the neutral angle")),
    ];
    let mut file = root([
        ("joint", table("The joint", joint)),
        ("link", table("The weight of the moving parts", link)),
        ("muscle_1", muscle("The muscle that turns the joint to +")),
        ("muscle_2", muscle("The muscle that turns the joint to -")),
        ("spring", table("A spring against the first muscle", spring.into_iter().chain(path()))),
    ]);
    file["required"] = serde_json::json!(["muscle_1"]);
    file
}

fn muscle(about: &str) -> Value {
    let keys = [
        ("file", text("Path of the muscle file, relative to this file")),
        ("contraction_at_neutral", quantity(Dimension::Ratio, "Contraction at the neutral angle")),
        ("wrap_angle", positive(Dimension::Angle, "Angle of the rope on its pulley, at the neutral angle")),
        ("wrap_friction", number("Coefficient of friction between rope and pulley")),
    ];
    needing(table(about, keys.into_iter().chain(path())), &["file"])
}

/// A pulley, or two points.
fn path() -> [(&'static str, Value); 3] {
    [
        ("radius", positive(Dimension::Length, "Radius of a pulley of its own")),
        ("origin", point("Point on the fixed link, x and y from the axis")),
        ("insertion", point("Point on the moving link, x and y from the axis at the neutral angle")),
    ]
}
