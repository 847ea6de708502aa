//! The workbench as files: the page with its scripts.
//!
//! The page asks one engine, by JSON. Which one it is says the module `js/kind.js`:
//! [`KIND_OF_SERVER`] for a page that a server hands out; the file of that name is for one that
//! brings its own engine as WebAssembly.

#![warn(clippy::print_stdout, clippy::print_stderr)]

use rust_embed::Embed;
use std::borrow::Cow;

#[derive(Embed)]
#[folder = "page/"]
struct Page;

/// Muscles, joints and points that the page's gallery opens.
#[derive(Embed)]
#[folder = "examples/"]
#[prefix = "examples/"]
struct Examples;

/// Where the page looks for its engine.
pub const KIND: &str = "js/kind.js";

/// The module in place of [`KIND`] in a page that a server hands out: the engine is that server.
pub const KIND_OF_SERVER: &str =
    "export { Engine } from \"./engine/http.js\";\nexport const DOCUMENTATION = \"\";\n";

/// A file of the page as it is kept, by its path from the page's folder, such as `index.html`.
pub fn file(path: &str) -> Option<Cow<'static, [u8]>> {
    Page::get(path)
        .or_else(|| Examples::get(path))
        .map(|file| file.data)
}

/// Paths of all files that are kept.
pub fn paths() -> impl Iterator<Item = Cow<'static, str>> {
    Page::iter().chain(Examples::iter())
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
