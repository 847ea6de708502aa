//! Fits the laws of the named rubbers with a measured curve or a table of fits, and prints
//! `crates/mckibben-core/data/rubber-laws.json`: `cargo xtask golds`.

mod table_of_fits;
mod windows;

use mckibben_core::rubber::library::{TABLE_OF_FITS, entries};
use mckibben_fit::rubber::read_tension;
use std::{error::Error, fs::File, path::Path};
use table_of_fits::curve_of_fits;
use windows::windows_of;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    let mut rubbers = vec![];
    for entry in entries()? {
        let Some(data) = &entry.data else { continue };
        let file = File::open(folder.join(data))?;
        let points = match data.as_str() {
            TABLE_OF_FITS => curve_of_fits(file, &entry.name)?,
            _ => read_tension(&std::io::read_to_string(file)?)?,
        };
        let mut windows = vec![];
        for mut window in windows_of(&points)? {
            // One line a law.
            let laws = std::mem::take(&mut window.laws);
            let laws = laws
                .iter()
                .map(serde_json::to_string)
                .collect::<Result<Vec<_>, _>>()?;
            let head = serde_json::to_string(&window)?.replace("\"laws\":[]}", "\"laws\":[");
            windows.push(format!("{head}\n{}\n]}}", laws.join(",\n")));
        }
        rubbers.push(format!("\"{}\":[\n{}\n]", entry.name, windows.join(",\n")));
    }
    println!("{{\n{}\n}}", rubbers.join(",\n"));
    Ok(())
}
