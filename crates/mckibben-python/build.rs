//! On macOS a library whose symbols come from the interpreter that loads it is linked differently.

fn main() {
    pyo3_build_config::add_extension_module_link_args();
}
