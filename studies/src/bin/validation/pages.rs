//! Pages and files that the study writes, or compares.

use crate::Result;
use std::{fs, path::Path};

const END: &str = "<!-- end -->";

/// A page with each text between `<!-- study NAME -->` and `<!-- end -->`.
pub fn with_texts(page: &str, texts: &[(&str, String)]) -> Result<String> {
    let mut made = page.to_owned();
    for (name, text) in texts {
        let mark = format!("<!-- study {name} -->\n");
        let Some((before, rest)) = made.split_once(&mark) else {
            continue;
        };
        let (_, behind) = rest
            .split_once(END)
            .ok_or_else(|| format!("nothing ends `study {name}`"))?;
        made = format!("{before}{mark}\n{text}\n{END}{behind}");
    }
    Ok(made)
}

/// Writes a file, or compares it; whether it is as it was.
pub fn keep(path: &Path, made: &str, check: bool) -> Result<bool> {
    let is_same = fs::read_to_string(path).is_ok_and(|kept| kept == made);
    if !is_same {
        println!("{}: changed", path.display());
        if !check {
            fs::write(path, made)?;
        }
    }
    Ok(is_same)
}
