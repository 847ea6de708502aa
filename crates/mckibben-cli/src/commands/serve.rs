//! `serve`: the workbench in a browser.

use crate::failure::Failure;
use crate::format::Format;
use crate::output::{emit, warn};
use crate::progress;
use clap::Args;
use mckibben_app::ProblemKind;
use mckibben_server::{Config, ServeError, Server};
use std::io::ErrorKind;
use std::net::{IpAddr, Ipv4Addr, SocketAddr, TcpListener};

pub const EXAMPLES: &str = "Example:
  mckibben serve --port 0

Open the address that it prints in a browser; Ctrl-C ends it.";

/// `serve`.
#[derive(Debug, Args)]
pub struct ServeArgs {
    /// Port; 0 selects a free port
    #[arg(long, value_name = "PORT", default_value_t = 8080)]
    pub port: u16,
    /// Open the page in the browser
    #[arg(long)]
    pub open: bool,
    /// Address to listen on; any address other than this computer's own requires --host-name, and opens the server to everyone on that network
    #[arg(long, value_name = "ADDRESS", default_value_t = IpAddr::V4(Ipv4Addr::LOCALHOST))]
    pub address: IpAddr,
    /// Host name of this computer that the server accepts besides localhost; may be repeated
    #[arg(long, value_name = "NAME")]
    pub host_name: Vec<String>,
}

/// Serves until a signal ends it.
pub fn run(args: ServeArgs, format: Format) -> Result<u8, Failure> {
    if !args.address.is_loopback() && args.host_name.is_empty() {
        let message = format!("--address: {} requires --host-name", args.address);
        let hint = "give the name or address that clients use, such as --host-name bench.local";
        return Err(Failure::input(ProblemKind::Usage, message, hint));
    }
    // Signals are taken over before anybody can know that the server is there.
    progress::stopped();
    let at = SocketAddr::new(args.address, args.port);
    let listener = TcpListener::bind(at).map_err(|e| unbound(at, &e))?;
    let address = listener.local_addr().map_err(|e| unbound(at, &e))?;
    let address = format!("http://{address}");
    let config = Config { host_names: args.host_name, ..Config::default() };
    let cannot = |e: ServeError| Failure::input(ProblemKind::Output, e.to_string(), "");
    // Nobody learns of a server that cannot answer.
    let server = Server::new(config).map_err(cannot)?;
    let line = match format {
        Format::Json => serde_json::json!({ "address": address }).to_string(),
        Format::Text | Format::Csv => address.clone(),
    };
    emit(&(line + "\n"), None)?;
    if args.open
        && let Err(error) = open::that_detached(&address)
    {
        warn(format!("no browser can be opened ({error}): open {address} yourself"));
    }
    server.run(listener, progress::stopped).map_err(cannot)?;
    Ok(0)
}

fn unbound(at: SocketAddr, error: &std::io::Error) -> Failure {
    let (message, hint) = match error.kind() {
        ErrorKind::AddrInUse => {
            (format!("port {} is in use by another program", at.port()), "--port 0 takes any free port")
        }
        _ => (format!("cannot listen at {at}: {error}"), "--port 0 takes any free port"),
    };
    Failure::input(ProblemKind::Usage, message, hint)
}
