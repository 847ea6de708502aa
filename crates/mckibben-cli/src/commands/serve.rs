//! `serve`: the workbench in a browser.

use crate::{Asked, Failure, Format, emit, progress, warn};
use mckibben_app::ProblemKind;
use mckibben_server::Config;
use std::io::ErrorKind;
use std::net::{Ipv4Addr, TcpListener};

/// Serves until a signal ends it.
pub fn run(asked: &Asked) -> Result<u8, Failure> {
    // Signals are taken over before anybody can know that the server is there.
    progress::stopped();
    let port = asked.text("port").and_then(|text| text.trim().parse().ok()).unwrap_or(8080);
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(|e| unbound(port, &e))?;
    let address = listener.local_addr().map_err(|e| unbound(port, &e))?;
    let address = format!("http://{address}");
    let line = match asked.format {
        Format::Json => serde_json::json!({ "address": address }).to_string(),
        _ => address.clone(),
    };
    emit(&(line + "\n"), None)?;
    if asked.is("open")
        && let Err(error) = open::that_detached(&address)
    {
        warn(format!("no browser can be opened ({error}): open {address} yourself"));
    }
    mckibben_server::run(listener, Config::default(), progress::stopped)
        .map_err(|e| Failure::input(ProblemKind::Output, format!("the server cannot run: {e}"), ""))?;
    Ok(0)
}

fn unbound(port: u16, error: &std::io::Error) -> Failure {
    let message = match error.kind() {
        ErrorKind::AddrInUse => format!("port {port} is in use by another program"),
        _ => format!("cannot listen at port {port}: {error}"),
    };
    Failure::input(ProblemKind::Usage, message, "--port 0 takes any free port")
}
