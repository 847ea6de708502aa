//! Maintenance of the repository in one place: `cargo xtask` lists the tasks.
//!
//! What a task makes it makes in `target/xtask` first. It then replaces what is kept in the
//! repository, or with `--check` compares the two and fails where they differ. `MCKIBBEN=PROGRAM`
//! takes another build of the program.

use std::{
    env, fs,
    path::{Path, PathBuf},
    process::{Command, ExitCode},
};

type Done = Result<(), String>;

/// Name, what it does, and how; the flag of the function is `--check`.
type Task = (&'static str, &'static str, fn(bool) -> Done);

const TASKS: [Task; 4] = [
    (
        "figures",
        "figures of README and docs, drawn by the program; --check compares",
        figures,
    ),
    (
        "book",
        "what the commands of README and docs print, behind each of them, and the list of verified \
         cases; --check compares",
        book,
    ),
    (
        "golds",
        "tables, formulas, messages; --check compares",
        golds,
    ),
    (
        "schemas",
        "words of requests and answers in docs/contract.txt; --check compares",
        schemas,
    ),
];

/// Pages whose commands draw their figures: what they show is declared there, and nowhere else.
const DRAWN: [&str; 10] = [
    "docs/bench-hour.md",
    "docs/build.md",
    "docs/designs.md",
    "docs/elbow.md",
    "docs/finite-elements.md",
    "docs/how-it-pulls.md",
    "docs/identify.md",
    "docs/models.md",
    "docs/paper.md",
    "docs/rubber.md",
];

fn main() -> ExitCode {
    let args: Vec<String> = env::args().skip(1).collect();
    let check = args.iter().any(|a| a == "--check");
    let task = args
        .first()
        .and_then(|name| TASKS.iter().find(|(known, ..)| known == name));
    let Some((_, _, run)) = task else {
        println!("cargo xtask TASK\n");
        TASKS
            .iter()
            .for_each(|(name, about, _)| println!("  {name:<12} {about}"));
        return if args.is_empty() {
            ExitCode::SUCCESS
        } else {
            ExitCode::from(2)
        };
    };
    let done = env::set_current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
        .map_err(|e| e.to_string())
        .and_then(|()| run(check));
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("xtask: {message}");
            ExitCode::FAILURE
        }
    }
}

fn figures(check: bool) -> Done {
    let program = program()?;
    let made = made("figures")?;
    for page in DRAWN {
        let text = fs::read_to_string(page).map_err(|e| format!("{page}: {e}"))?;
        let text = text.replace("\\\n", " ");
        for line in text
            .lines()
            .filter(|line| line.starts_with("mckibben ") && writes(line))
        {
            quiet(
                Command::new(&program)
                    .args(into_folder(line, &made))
                    .arg("--overwrite"),
            )?;
        }
        for figure in text
            .split("](figures/")
            .skip(1)
            .filter_map(|rest| rest.split(')').next())
            .filter(|figure| made.join(figure).is_file())
        {
            keep(
                &made.join(figure),
                &Path::new("docs/figures").join(figure),
                check,
            )?;
        }
    }
    Ok(())
}

/// Flags with the file or folder that a command writes.
const WRITTEN: [&str; 3] = ["-o", "--plot", "--figures"];

fn writes(line: &str) -> bool {
    line.split_whitespace().any(|word| WRITTEN.contains(&word))
}

/// The words of a command, with what it and those before it write in a folder.
fn into_folder(line: &str, folder: &Path) -> Vec<PathBuf> {
    let words: Vec<&str> = line.split_whitespace().skip(1).collect();
    let before = std::iter::once("").chain(words.iter().copied());
    let placed = |(before, word): (&str, &&str)| {
        let there = WRITTEN.contains(&before) || folder.join(word).is_file();
        if there {
            folder.join(word)
        } else {
            PathBuf::from(word)
        }
    };
    before.zip(&words).map(placed).collect()
}

fn golds(check: bool) -> Done {
    let program = program()?;
    let made = made("golds")?;
    let campaign = made.join("universal.parquet");
    quiet(
        Command::new(&program)
            .args(["campaign", "plans/universal.toml", "-o"])
            .arg(&campaign),
    )?;
    let path = made.join("universal.json");
    quiet(
        Command::new(&program)
            .arg("fit")
            .arg(&campaign)
            .args(["--method", "universal", "-o"])
            .arg(&path),
    )?;
    keep(
        &path,
        Path::new("crates/mckibben-core/data/universal.json"),
        check,
    )?;
    for (name, file, folder) in [
        (
            "rubber_laws",
            "rubber-laws.json",
            "crates/mckibben-core/data",
        ),
        ("paper_campaign_csv", "paper.csv", "data/campaign"),
    ] {
        let path = made.join(file);
        save(&mut example(name)?, &path)?;
        keep(&path, &Path::new(folder).join(file), check)?;
    }
    run(&mut test("layer", "every_message_is_kept", check))
}

/// `MCKIBBEN_PAGES=tour.md,joints.md` takes some pages.
fn book(check: bool) -> Done {
    let pages = env::var("MCKIBBEN_PAGES").unwrap_or_else(|_| "1".into());
    if pages == "1" || pages.contains("verified.md") {
        cases(check)?;
    }
    run(test("all", "pages_show_what_their_commands_print", check).env("MCKIBBEN_PAGES", pages))
}

/// docs/verified-cases.txt: rows that the tests of verification write, by their source.
/// The values of a row depend on the processor in their last digits: `--check` leaves them out.
fn cases(check: bool) -> Done {
    const LIST: &str = "docs/verified-cases.txt";
    let at = |path: &Path, e: std::io::Error| format!("{}: {e}", path.display());
    let made = made("verification")?;
    let folder = fs::canonicalize(&made).map_err(|e| at(&made, e))?;
    run(test("all", "verification::", true).env("MCKIBBEN_VERIFICATION", folder))?;
    let mut rows = vec![];
    for file in fs::read_dir(&made).map_err(|e| at(&made, e))? {
        let path = file.map_err(|e| at(&made, e))?.path();
        let text = fs::read_to_string(&path).map_err(|e| at(&path, e))?;
        let of_case = text.lines().filter_map(|row| row.split_once('\t'));
        rows.extend(of_case.enumerate().map(|(i, (source, row))| {
            let (source, row) = (source.to_owned(), row.to_owned());
            (source, path.clone(), i, row)
        }));
    }
    rows.sort();
    let mut list = "      reference            ours    error  allowed  case\n".to_owned();
    let mut last = "";
    for (source, _, _, row) in &rows {
        if source != last {
            list += &format!("\n{source}\n");
            last = source;
        }
        list += &format!("{row}\n");
    }
    if !check {
        return fs::write(LIST, list).map_err(|e| at(Path::new(LIST), e));
    }
    let without_values = |list: &str| {
        let stated = |line: &str| {
            let values = if line.starts_with(' ') { 3 } else { 0 };
            line.split_whitespace()
                .skip(values)
                .collect::<Vec<_>>()
                .join(" ")
        };
        list.lines().map(stated).collect::<Vec<_>>()
    };
    let old = fs::read_to_string(LIST).map_err(|e| at(Path::new(LIST), e))?;
    let same = without_values(&old) == without_values(&list);
    same.then_some(())
        .ok_or(format!("{LIST} has not the cases of the tests"))
}

fn schemas(check: bool) -> Done {
    run(&mut test(
        "layer",
        "the_words_of_requests_and_answers",
        check,
    ))
}

/// A test that compares what is kept with what the program makes, or writes it.
fn test(suite: &str, name: &str, check: bool) -> Command {
    let mut test = cargo();
    test.args([
        "test",
        "--workspace",
        "--locked",
        "--test",
        suite,
        "--",
        name,
    ]);
    if !check {
        test.env("MCKIBBEN_WRITE", "yes");
    }
    test
}

fn cargo() -> Command {
    Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}

/// What `cargo test --workspace` builds as well: the same features and profile, so that nothing is
/// compiled twice.
fn build(what: &[&str]) -> Done {
    run(cargo()
        .args([
            "build",
            "--quiet",
            "--locked",
            "--workspace",
            "--profile",
            "test",
        ])
        .args(what))
}

fn example(name: &str) -> Result<Command, String> {
    build(&["--example", name])?;
    Ok(Command::new(
        target()
            .join("debug/examples")
            .join(format!("{name}{}", env::consts::EXE_SUFFIX)),
    ))
}

fn target() -> PathBuf {
    env::var_os("CARGO_TARGET_DIR").map_or_else(|| "target".into(), PathBuf::from)
}

/// The program that the tests of the command line run.
fn program() -> Result<PathBuf, String> {
    if let Some(given) = env::var_os("MCKIBBEN") {
        return Ok(given.into());
    }
    // With an example, so that cargo takes the features of the tests as well.
    build(&["--bin", "mckibben", "--example", "exported"])?;
    let name = format!("debug/mckibben{}", env::consts::EXE_SUFFIX);
    fs::canonicalize(target().join(name)).map_err(|e| e.to_string())
}

/// An empty folder for what a task makes.
fn made(task: &str) -> Result<PathBuf, String> {
    let folder = target().join("xtask").join(task);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    Ok(folder)
}

/// Puts what was made in the place of what is kept, or compares the two.
fn keep(made: &Path, kept: &Path, check: bool) -> Done {
    let read = |path: &Path| fs::read(path).map_err(|e| format!("{}: {e}", path.display()));
    let new = read(made)?;
    if check {
        let same = read(kept)? == new;
        let message = || {
            format!(
                "{} is not what the program makes ({})",
                kept.display(),
                made.display()
            )
        };
        return same.then_some(()).ok_or_else(message);
    }
    if let Some(folder) = kept.parent() {
        fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    }
    fs::write(kept, new).map_err(|e| format!("{}: {e}", kept.display()))
}

fn run(command: &mut Command) -> Done {
    let status = command.status().map_err(|e| format!("{command:?}: {e}"))?;
    status
        .success()
        .then_some(())
        .ok_or_else(|| format!("{command:?}: {status}"))
}

/// Runs a command without its output.
fn quiet(command: &mut Command) -> Done {
    run(command.stdout(std::process::Stdio::null()))
}

/// Runs a command with its output into a file.
fn save(command: &mut Command, path: &Path) -> Done {
    let file = fs::File::create(path).map_err(|e| format!("{}: {e}", path.display()))?;
    run(command.stdout(file))
}
