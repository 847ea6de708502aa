//! Draws a few figures into a folder (first argument, default: the system's temporary
//! folder) and as characters, to look at.

mod figures;

use std::path::PathBuf;

use mckibben_report::FigureError;

fn main() -> Result<(), FigureError> {
    let folder = std::env::args_os().nth(1).map_or_else(std::env::temp_dir, PathBuf::from);
    for (name, figure) in figures::all() {
        for ending in ["svg", "png", "html"] {
            let path = folder.join(format!("figure-{name}.{ending}"));
            figure.save(&path)?;
            let size = std::fs::metadata(&path).map_or(0, |m| m.len());
            println!("{} ({size} bytes)", path.display());
        }
        println!("{}", figure.to_text(100, 30, std::env::args_os().len() > 2));
    }
    Ok(())
}
