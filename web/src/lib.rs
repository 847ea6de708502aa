//! The workbench as files: the page with its scripts.
//!
//! The page asks one engine, by JSON. Which one it is says the module `js/kind.js`:
//! [`KIND_OF_SERVER`] for a page that a server hands out; the file of that name is for one that
//! brings its own engine as WebAssembly.

#![warn(clippy::print_stdout, clippy::print_stderr)]

use include_dir::{Dir, File, include_dir};

/// The page's own files.
pub static PAGE: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/page");
/// Muscles, joints and points that the page's gallery opens.
pub static EXAMPLES: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/examples");
/// The page's path to them.
pub const EXAMPLES_AT: &str = "examples/";

/// Where the page looks for its engine.
pub const KIND: &str = "js/kind.js";

/// The module in place of [`KIND`] in a page that a server hands out: the engine is that server.
pub const KIND_OF_SERVER: &str =
    "export { Engine } from \"./engine/http.js\";\nexport const DOCUMENTATION = \"\";\n";

/// A file of the page as it is kept, by its path from the page's folder, such as `index.html`.
pub fn file(path: &str) -> Option<&'static [u8]> {
    let file = match path.strip_prefix(EXAMPLES_AT) {
        Some(path) => EXAMPLES.get_file(path),
        None => PAGE.get_file(path),
    };
    file.map(File::contents)
}

/// The script that turns the muscle in a report: the page's own view, in one piece.
pub fn viewer() -> String {
    // By themselves: the Python package has no other file of the page.
    let modules = concat!(
        include_str!("../page/js/body.js"),
        include_str!("../page/js/dom.js"),
        include_str!("../page/js/life.js"),
        include_str!("../page/js/shaders.js"),
        include_str!("../page/js/view3d.js"),
        include_str!("../page/js/report-viewer.js"),
    );
    let lines = modules.lines().filter(|line| !line.starts_with("import "));
    lines
        .flat_map(|line| [line.strip_prefix("export ").unwrap_or(line), "\n"])
        .collect()
}
