//! `help COMMAND` and `man`: the flags of the commands as text and as manual pages.

use crate::failure::Failure;
use crate::output::{emit, save};
use clap::{Args, Command};
use clap_mangen::Man;
use mckibben_app::ProblemKind;
use std::path::PathBuf;

pub const EXAMPLES: &str = "Examples:
  mckibben help force
  mckibben help parts show";

pub const MAN_EXAMPLES: &str = "Examples:
  mckibben man -o man/man1
  mckibben man force

Read the pages of a folder with: man -M man mckibben-force
Where `man` finds them by itself: mckibben man -o ~/.local/share/man/man1";

/// `help`.
#[derive(Debug, Args)]
pub struct HelpArgs {
    /// Command, such as `force` or `parts show` [mckibben]
    #[arg(value_name = "COMMAND")]
    pub command: Vec<String>,
}

/// `man`.
#[derive(Debug, Args)]
pub struct ManArgs {
    /// Command whose page is printed [mckibben]
    #[arg(value_name = "COMMAND", conflicts_with = "output")]
    pub command: Vec<String>,
    /// Write the pages of all commands into a folder
    #[arg(short, long, value_name = "DIR", help_heading = "Output")]
    pub output: Option<PathBuf>,
}

/// Prints the help of a command.
pub fn run(args: &HelpArgs, root: Command) -> Result<u8, Failure> {
    let (mut root, words) = (built(root), &args.command);
    let mut found = &mut root;
    for word in words {
        found = found.find_subcommand_mut(word).ok_or_else(|| unknown(words))?;
    }
    found.print_long_help().map_err(|e| Failure::stdout(&e))?;
    Ok(0)
}

/// Prints one manual page, or writes all.
pub fn man(args: &ManArgs, root: Command) -> Result<u8, Failure> {
    let root = built(root);
    let Some(folder) = &args.output else {
        let found = args.command.iter().try_fold(&root, |found, word| found.find_subcommand(word));
        emit(page(found.ok_or_else(|| unknown(&args.command))?)?, None)?;
        return Ok(0);
    };
    std::fs::create_dir_all(folder).map_err(|e| Failure::unwritable(folder, &e))?;
    let mut left = vec![&root];
    while let Some(command) = left.pop() {
        let path = folder.join(Man::new(command.clone()).get_filename());
        save(Some(&path), &page(command)?)?;
        left.extend(command.get_subcommands());
    }
    Ok(0)
}

/// The command line with all that it inherits.
fn built(mut root: Command) -> Command {
    root.build();
    root
}

/// The manual page of a command.
fn page(command: &Command) -> Result<Vec<u8>, Failure> {
    let mut out = vec![];
    // A page has what the short help has not.
    let whole = command.clone().mut_args(|arg| match (arg.get_long_help(), arg.get_help()) {
        (None, Some(help)) => {
            let help = help.clone();
            arg.long_help(help)
        }
        _ => arg,
    });
    let page = Man::new(whole).manual("mckibben").source(concat!("mckibben ", env!("CARGO_PKG_VERSION")));
    page.render(&mut out).map_err(|e| Failure::stdout(&e))?;
    let end = command.get_after_help().map(ToString::to_string).unwrap_or_default();
    let heading = if end.starts_with("Example") { ".SH EXAMPLES" } else { ".SH \"EXIT STATUS\"" };
    Ok(String::from_utf8_lossy(&out).replace(".SH EXTRA", heading).into_bytes())
}

fn unknown(words: &[String]) -> Failure {
    let message = format!("there is no command `{}`", words.join(" "));
    Failure::input(ProblemKind::Usage, message, "`mckibben help` lists the commands")
}
