//! The commands: their texts (`commands.txt`), and what runs them.

use crate::commands::{
    build, campaign, check, compare, curve, design, export, fill, fit, help, identify, joint,
    motion, parts, point, rubber, schema, serve, simulate, validate,
};
use crate::{Args, Format, Problem, spec::flags, spec::text_of};
use clap::{ArgAction, ArgMatches, Command, CommandFactory, Parser};
use serde_json::Value;

const ABOUT: &str = "Design McKibben pneumatic muscles: from a specification to a muscle that you \
    can build.

Quantities carry a unit (30mm, 2.5bar, 0.25MPa, 36psi, 28deg, 300N, 10%); a bare number is mm, \
MPa, N, degrees, \
or a ratio. Ranges are low..high:step (0..2.5:0.1bar), lists are 1,2,3.";

const EXIT_CODES: &str = "Exit codes: 0 done; 1 no answer exists; 2 the input is wrong; 3 the \
    computation did not converge; 130 ended by a signal.";

/// What every command takes.
#[derive(Debug, Parser)]
#[command(name = "mckibben", version, about = ABOUT, disable_help_subcommand = true, disable_help_flag = true, max_term_width = 110, after_help = EXIT_CODES)]
pub struct Cli {
    /// Output format: text, json or csv [text]
    ///
    /// Text for reading: aligned, with units. For programs json, one object, or csv, one row per
    /// point; keys and columns carry their unit.
    #[arg(long, value_enum, global = true, default_value_t = Format::Text, hide_default_value = true, hide_possible_values = true, display_order = 900, help_heading = "Output")]
    pub format: Format,
    /// Overwrite existing files
    #[arg(
        long,
        global = true,
        hide_short_help = true,
        display_order = 901,
        help_heading = "Output"
    )]
    pub overwrite: bool,
    /// Help: -h in short, --help with all flags
    #[arg(short, long, global = true, action = ArgAction::Help, display_order = 902, help_heading = "Output")]
    // clap answers it.
    #[allow(dead_code)]
    help: Option<bool>,
}

/// Runs a command; the exit code where it ends well.
type Run = fn(&Args) -> Result<u8, Problem>;

/// Every command, in the order of the help.
const COMMANDS: [(&str, Run); 28] = [
    ("design", design::run),
    ("force", point::force),
    ("pressure", point::pressure),
    ("contraction", point::contraction),
    ("fill", fill::run),
    ("curve", curve::run),
    ("joint", joint::run),
    ("motion", motion::run),
    ("simulate", simulate::run),
    ("check", check::run),
    ("build", build::run),
    ("export", export::run),
    ("campaign", campaign::run),
    ("campaign show", campaign::show),
    ("campaign merge", campaign::merge),
    ("campaign status", campaign::status),
    ("validate", validate::run),
    ("compare", compare::run),
    ("identify", identify::run),
    ("fit", fit::run),
    ("parts list", parts::list),
    ("parts show", parts::show),
    ("rubber", rubber::run),
    ("serve", serve::run),
    ("schema", schema::run),
    ("help", help::run),
    ("man", help::man),
    ("completions", help::completions),
];

/// Commands that only hold others.
const GROUPS: [(&str, &str); 1] = [(
    "parts",
    "Everything with a name: tubes, sleeves, rubbers, muscles, models",
)];

/// The command line: `-h` shows the first example and where the other flags are, `--help` all.
pub fn command() -> Command {
    let mut root = Cli::command()
        .subcommand_required(true)
        .arg_required_else_help(true);
    for (name, _) in COMMANDS {
        let about = text_of(name)
            .0
            .strip_prefix(name)
            .unwrap_or_default()
            .trim_start_matches(": ");
        let (group, last) = name.split_once(' ').unwrap_or(("", name));
        let one = Command::new(last)
            .about(about)
            .after_help(name)
            .defer(with_flags);
        root = match GROUPS
            .iter()
            .find(|g| g.0 == group && root.find_subcommand(group).is_none())
        {
            Some((group, about)) => {
                let holds = Command::new(*group).about(*about).subcommand_required(true);
                root.subcommand(holds.arg_required_else_help(true).subcommand(one))
            }
            None if group.is_empty() => root.subcommand(one),
            None => root.mut_subcommand(group, |holds| holds.subcommand(one)),
        };
    }
    root
}

/// The schema of a command's request.
fn request(name: &str) -> Value {
    let command = mckibben_app::find(&name.replace(' ', "-"));
    command.map_or(Value::Null, |command| command.schema()["request"].take())
}

/// Adds the flags and examples of a command, whose name is in the place of its examples.
fn with_flags(command: Command) -> Command {
    let name = command
        .get_after_help()
        .map(ToString::to_string)
        .unwrap_or_default();
    let text = text_of(&name).1;
    let all = text.find("\nExample").map_or("", |at| &text[at + 1..]);
    let args: Vec<clap::Arg> = flags(text, &request(&name))
        .iter()
        .map(|flag| flag.arg())
        .collect();
    let hides = args.iter().any(clap::Arg::is_hide_short_help_set);
    let short = if hides {
        format!(
            "{}\n\nAll flags, with details: mckibben {name} --help",
            first_example(all)
        )
    } else {
        all.to_owned()
    };
    let command = command.args(args).after_help(short).after_long_help(all);
    // What every command takes comes last, with its heading.
    let every = ["format", "overwrite", "help"]
        .into_iter()
        .filter(|id| has(&command, id))
        .collect::<Vec<_>>();
    let command = every
        .into_iter()
        .fold(command, |command, id| command.mut_arg(id, |arg| arg));
    if command.has_subcommands() {
        return command
            .args_conflicts_with_subcommands(true)
            .subcommand_negates_reqs(true);
    }
    command
}

fn has(command: &Command, id: &str) -> bool {
    command.get_arguments().any(|arg| arg.get_id() == id)
}

/// Examples up to the second one.
fn first_example(all: &str) -> String {
    let starts = |line: &&str| line.starts_with("  mckibben ");
    if all.lines().filter(starts).count() < 2 {
        return all.to_owned();
    }
    let mut seen = 0;
    let lines = all.lines().take_while(|line| {
        seen += usize::from(starts(line));
        seen < 2
    });
    lines
        .collect::<Vec<_>>()
        .join("\n")
        .replacen("Examples:", "Example:", 1)
}

/// The command that was typed: its name, its flags, and what runs it.
pub fn typed_command(matches: &ArgMatches, format: Format) -> Option<(String, Args, Run)> {
    let (mut leaf, mut path) = (matches, vec![]);
    while let Some((name, inner)) = leaf.subcommand() {
        path.push(name);
        leaf = inner;
    }
    let name = path.join(" ");
    let (_, run) = COMMANDS.iter().find(|(known, _)| *known == name)?;
    let request = request(&name);
    let mut flags = flags(text_of(&name).1, &request);
    let args = std::env::args_os().map(|arg| arg.to_string_lossy().into_owned());
    let name_of = |arg: String| Some(arg.strip_prefix("--")?.split('=').next()?.to_owned());
    let typed: Vec<String> = args.filter_map(name_of).collect();
    flags.iter_mut().for_each(|flag| flag.called(&typed));
    Some((
        name,
        Args {
            format,
            flags,
            matches: leaf.clone(),
            request,
        },
        *run,
    ))
}
