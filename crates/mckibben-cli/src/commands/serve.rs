//! `serve`: the workbench in a browser.

use crate::{Context, Format, Problem, progress};
use mckibben_app::ProblemKind;
use mckibben_server::Config;
use std::{
    io::ErrorKind,
    net::{Ipv4Addr, TcpListener},
};

/// Serves until a signal ends it.
#[derive(clap::Args)]
#[command(
    next_help_heading = "Options",
    after_long_help = "Example:
  mckibben serve --port 0

Open the address that it prints in a browser; Ctrl-C ends it."
)]
pub struct Serve {
    /// Port; 0 selects a free port
    #[arg(long, default_value_t = 8080)]
    port: u16,
    /// Open the page in the browser
    #[arg(long)]
    open: bool,
}

impl Serve {
    pub fn run(self, context: &Context) -> Result<u8, Problem> {
        // Signals are taken over before anybody can know that the server is there.
        progress::stopped();
        let port = self.port;
        let listener =
            TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(|e| unbound(port, &e))?;
        let address = listener.local_addr().map_err(|e| unbound(port, &e))?;
        let address = format!("http://{address}");
        let line = match context.format {
            Format::Json => serde_json::json!({ "address": address }).to_string(),
            _ => address.clone(),
        };
        context.emit(&(line + "\n"), None)?;
        if self.open
            && let Err(error) = open::that_detached(&address)
        {
            context.warn(format!(
                "no browser can be opened ({error}): open {address} yourself"
            ));
        }
        mckibben_server::run(listener, Config::default(), progress::stopped)
            .map_err(|e| ProblemKind::Output.problem(format!("the server cannot run: {e}")))?;
        Ok(0)
    }
}

fn unbound(port: u16, error: &std::io::Error) -> Problem {
    let message = match error.kind() {
        ErrorKind::AddrInUse => format!("port {port} is in use by another program"),
        _ => format!("cannot listen at port {port}: {error}"),
    };
    Problem::usage(message, "--port 0 takes any free port")
}
