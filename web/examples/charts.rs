//! Writes the chart library to standard output, for `web/build.sh`.

use std::io::{Write, stdout};

fn main() -> std::io::Result<()> {
    stdout().write_all(mckibben_web::charts().as_bytes())
}
