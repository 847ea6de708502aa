//! Words of version 1 that are gone, each with its successor.

use crate::Problem;
use mckibben_app::ProblemKind;

/// Words that a command line may begin with, and what to type in their place.
const GONE: [(&str, &str); 16] = [
    ("doctor", "`mckibben check MUSCLE.toml`"),
    ("muscle show", "`mckibben check MUSCLE.toml`"),
    (
        "muscle measures",
        "`mckibben schema --file muscle` has all keys of a muscle, `mckibben force --help` the \
         flags",
    ),
    ("formula show", "`mckibben check FILE.json`"),
    ("braid list", "`mckibben parts list sleeves`"),
    ("braid show", "`mckibben parts show NAME`"),
    ("rubber list", "`mckibben parts list rubbers`"),
    ("rubber show", "`mckibben parts show NAME`"),
    ("rubber fit", "`mckibben rubber TABLE.csv`"),
    ("library list", "`mckibben parts list muscles`"),
    ("library show", "`mckibben parts show NAME`"),
    (
        "library check",
        "`mckibben validate --measured DIR` holds the muscles of folders against their points",
    ),
    (
        "models",
        "`mckibben parts list models`, `mckibben parts show NAME`",
    ),
    ("report", "`mckibben build MUSCLE.toml --report FILE.html`"),
    (
        "life",
        "`mckibben simulate` has the stretches and strand tensions of a cycle",
    ),
    ("mcp", "`mckibben serve` answers programs over HTTP"),
];

/// A command line that begins with a word that is gone is an error with its successor, and so is a
/// force for `force`.
pub fn check(args: &[String]) -> Result<(), Problem> {
    let typed = args.get(1..).unwrap_or_default();
    let begins = |words: &str| {
        words
            .split(' ')
            .enumerate()
            .all(|(i, word)| typed.get(i).is_some_and(|w| w == word))
    };
    let takes_force = |word: &String| word.starts_with("-F") || word.starts_with("--force");
    if begins("force") && typed.iter().any(takes_force) {
        let hint = "`mckibben pressure` and `mckibben contraction` take a force";
        let message = "`mckibben force` gives the force at a pressure and a contraction";
        return Err(Problem::new(ProblemKind::Usage, message, hint));
    }
    match GONE.iter().find(|(words, _)| begins(words)) {
        Some((words, instead)) => {
            let message = format!("`mckibben {words}` is gone");
            Err(Problem::new(ProblemKind::Usage, message, *instead))
        }
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{cli::command, exit_code, problem::as_text};

    #[test]
    fn a_word_that_is_gone_names_its_successor_which_is_a_command() {
        for (words, instead) in GONE {
            let args: Vec<String> = format!("mckibben {words} x")
                .split(' ')
                .map(str::to_owned)
                .collect();
            let problem = check(&args).unwrap_err();
            assert_eq!(exit_code(Some(&problem)), 2);
            let text = as_text(&problem);
            assert!(text.contains(instead), "{text}");
            let new = instead
                .split_once("`mckibben ")
                .unwrap()
                .1
                .split([' ', '`'])
                .next()
                .unwrap();
            assert!(command().find_subcommand(new).is_some(), "{words}: {new}");
            assert!(check(&args[1..]).is_ok());
        }
    }
}
