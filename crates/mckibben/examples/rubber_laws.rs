//! Fits the laws of the named rubbers with a measured curve, and prints `crates/mckibben/data/rubber-laws.json`: `cargo xtask golds`.

use mckibben::rubber::fit::{ReadOptions, read_tension};
use mckibben::rubber::library::{entries, windows_of};
use std::error::Error;
use std::fs::File;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    let mut rubbers = vec![];
    for entry in entries()? {
        let Some(data) = &entry.data else { continue };
        let points = read_tension(File::open(folder.join(data))?, ReadOptions::default())?;
        let mut windows = vec![];
        for mut window in windows_of(&points)? {
            // One line a law.
            let laws = std::mem::take(&mut window.laws);
            let laws = laws.iter().map(serde_json::to_string).collect::<Result<Vec<_>, _>>()?;
            let head = serde_json::to_string(&window)?.replace("\"laws\":[]}", "\"laws\":[");
            windows.push(format!("{head}\n{}\n]}}", laws.join(",\n")));
        }
        rubbers.push(format!("\"{}\":[\n{}\n]", entry.name, windows.join(",\n")));
    }
    println!("{{\n{}\n}}", rubbers.join(",\n"));
    Ok(())
}
