//! MuJoCo: the form itself as a plugin around the C target, with one control for a muscle.

use super::c::{rendered, sources};
use super::entry::TargetEntry;
use super::mjcf::scene;
use crate::error::ExportError;
use crate::muscle::ExportedMuscle;
use crate::template::{number, render};
use crate::{Artefact, File};

pub(super) const ENTRY: TargetEntry = TargetEntry {
    name: "mjcf-plugin",
    about: "a plugin for MuJoCo in C, with one control for a muscle, and a scene that uses it",
    needs: "MuJoCo with its headers (the Python package has them), and a C compiler",
    loses: "friction; the volume is not an output",
    make,
};

fn make(muscle: &ExportedMuscle) -> Result<Artefact, ExportError> {
    let (id, supply) = (muscle.identifier(), number(muscle.form.supply_pa));
    let actuator = include_str!("../../templates/muscle_plugin.xml");
    let own = [
        ("also", " and <extension>".to_owned()),
        ("extension", format!("  <extension><plugin plugin=\"mckibben.{id}\"/></extension>")),
        ("limit", String::new()),
        ("actuators", render(actuator, &[], &[("id", id), ("supply", supply)])),
        ("half", number(0.5 * muscle.form.supply_pa)),
    ];
    let plugin = rendered(include_str!("../../templates/muscle_plugin.c"), muscle);
    let mut files = vec![
        File::text(
            "muscle_plugin.c",
            "the plugin; its first lines have the commands to compile and load it",
            plugin,
        ),
        scene(muscle, &muscle.facts(), &own),
    ];
    files.extend(sources(muscle));
    Ok(Artefact { files, notes: vec![] })
}
