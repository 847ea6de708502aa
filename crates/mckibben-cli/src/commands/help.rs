//! `help COMMAND` and `man`: the flags of the commands as text and as manual pages.

use crate::{Context, Problem, Result, examples::examples, unprinted};
use clap::{Args, Command};
use clap_complete::Shell;
use clap_mangen::Man;
use std::path::PathBuf;

/// Prints the help of a command.
#[derive(Args)]
#[command(next_help_heading = "Options", after_long_help = examples(&[
    "help force",
    "help parts show"
]))]
pub struct Help {
    /// Command, such as `force` or `parts show` [mckibben]
    command: Vec<String>,
}

impl Help {
    pub fn run(self, root: Command) -> Result<u8> {
        let mut root = built(root);
        let words = self.command;
        let mut command = &mut root;
        for word in &words {
            command = command
                .find_subcommand_mut(word)
                .ok_or_else(|| unknown(&words))?;
        }
        command.print_long_help().map_err(|e| unprinted(&e))?;
        Ok(0)
    }
}

/// Prints one manual page, or writes all.
#[derive(Args)]
#[command(
    next_help_heading = "Options",
    after_long_help = "Examples:
  mckibben man -o man/man1
  mckibben man force

Read the pages of a folder with: man -M man mckibben-force
Where `man` finds them by itself: mckibben man -o ~/.local/share/man/man1"
)]
pub struct ManPages {
    /// Command whose page is printed [mckibben]
    #[arg(conflicts_with = "output")]
    command: Vec<String>,
    /// Write the pages of all commands into a folder
    #[arg(short, long, value_name = "DIR", help_heading = "Output")]
    output: Option<PathBuf>,
}

impl ManPages {
    pub fn run(self, root: Command, context: &Context) -> Result<u8> {
        let root = built(root);
        let words = self.command;
        let Some(folder) = self.output else {
            context.emit(
                page(
                    words
                        .iter()
                        .try_fold(&root, |command, word| command.find_subcommand(word))
                        .ok_or_else(|| unknown(&words))?,
                )?,
                None,
            )?;
            return Ok(0);
        };
        let mut left = vec![&root];
        let mut pages = vec![];
        while let Some(command) = left.pop() {
            pages.push((Man::new(command.clone()).get_filename(), page(command)?));
            left.extend(command.get_subcommands());
        }
        context.save_inside(&folder, pages).map(|()| 0)
    }
}

/// Prints the completions of a shell.
#[derive(Args)]
#[command(next_help_heading = "Options", after_long_help = examples(&[
    "completions bash"
]))]
pub struct Completions {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

impl Completions {
    pub fn run(self, mut root: Command, context: &Context) -> Result<u8> {
        // Into memory first: clap_complete panics where it cannot write.
        let mut script = vec![];
        clap_complete::generate(self.shell, &mut root, "mckibben", &mut script);
        context.emit(&script, None)?;
        Ok(0)
    }
}

/// The command line with all that it inherits.
fn built(mut root: Command) -> Command {
    root.build();
    root
}

/// The manual page of a command.
fn page(command: &Command) -> Result<Vec<u8>> {
    let mut out = vec![];
    // A page has what the short help has not.
    let whole = command
        .clone()
        .mut_args(|arg| match (arg.get_long_help(), arg.get_help()) {
            (None, Some(help)) => {
                let help = help.clone();
                arg.long_help(help)
            }
            _ => arg,
        });
    Man::new(whole)
        .manual("mckibben")
        .source(concat!("mckibben ", env!("CARGO_PKG_VERSION")))
        .render(&mut out)
        .map_err(|e| unprinted(&e))?;
    let end = command
        .get_after_help()
        .map(ToString::to_string)
        .unwrap_or_default();
    let heading = if end.starts_with("Example") {
        ".SH EXAMPLES"
    } else {
        ".SH \"EXIT STATUS\""
    };
    Ok(String::from_utf8_lossy(&out)
        .replace(".SH EXTRA", heading)
        .into_bytes())
}

fn unknown(words: &[String]) -> Problem {
    Problem::usage(
        format!("there is no command `{}`", words.join(" ")),
        "`mckibben help` lists the commands",
    )
}
