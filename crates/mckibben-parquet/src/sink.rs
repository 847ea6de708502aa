//! Where bytes go.

use std::io::{Seek, Write};

/// Where bytes go: a file, or a cursor over memory. `dyn`, so that the writer is compiled once.
pub trait Sink: Write + Seek + Send {}

impl<T: Write + Seek + Send> Sink for T {}
