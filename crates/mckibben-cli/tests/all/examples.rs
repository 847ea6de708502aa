//! Every command that is shown to users works as shown.

use crate::common::{command, folder, json, mckibben, number, ran, root};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// A folder that looks like the repository to a command, but where figures may land.
fn copy() -> tempfile::TempDir {
    let dir = folder();
    for name in ["examples", "data", "plans"] {
        let from = root().join(name);
        if from.exists() {
            copy_tree(&from, &dir.path().join(name));
        }
    }
    dir
}

fn copy_tree(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            copy_tree(&entry.path(), &target);
        } else {
            std::fs::copy(entry.path(), target).unwrap();
        }
    }
}

/// The words of a shell line, with quotes; pipes, comments and redirections end it.
fn words(line: &str) -> Vec<String> {
    let mut out: Vec<String> = vec![];
    let mut word: Option<String> = None;
    let mut quote: Option<char> = None;
    for c in line.chars() {
        match (quote, c) {
            (Some(q), c) if c == q => quote = None,
            (Some(_), c) => word.get_or_insert_default().push(c),
            (None, '"' | '\'') => {
                quote = Some(c);
                word.get_or_insert_default();
            }
            (None, '|' | '>' | '<' | ';' | '&') => break,
            (None, '#') if word.is_none() => break,
            (None, c) if c.is_whitespace() => out.extend(word.take()),
            (None, c) => word.get_or_insert_default().push(c),
        }
    }
    out.extend(word);
    out
}

/// Runs a command as shown, `mckibben` and what follows.
fn works(folder: &Path, place: &str, line: &str) {
    let words = words(line);
    let mut words: Vec<&str> = words.iter().skip(1).map(String::as_str).collect();
    if let ["serve", more @ ..] = &words[..] {
        return crate::serve::works(folder, more);
    }
    // Examples of help texts are run in one folder.
    words.extend((place == "help").then_some("--overwrite"));
    let result = ran(command(folder).args(words).output().unwrap());
    assert_eq!(result.code, 0, "{place}: {line}\n{}", result.err);
}

/// The help of a command and of all commands below it.
fn helps(path: &[String], out: &mut Vec<(String, String)>) {
    // As on a terminal of the usual width: an example must not be wrapped there.
    let mut command = command(&root());
    let help = ran(command.args(path).arg("--help").env("COLUMNS", "80").output().unwrap()).ok();
    let help = help.text().to_owned();
    if let Some((_, list)) = help.split_once("\nCommands:\n") {
        let names = list.lines().take_while(|l| l.starts_with("  "));
        for name in names.filter(|l| !l.starts_with("   ")).filter_map(|l| l.split_whitespace().next()) {
            helps(&[path, &[name.to_owned()]].concat(), out);
        }
    }
    out.push((path.join(" "), help));
}

/// The examples of every command's help.
fn shown_by_help() -> Vec<String> {
    let mut list = vec![];
    helps(&[], &mut list);
    let mut out = vec![];
    for (name, help) in list {
        let text = help.replace("\\\n", "");
        let shown = text.lines().filter(|l| l.starts_with("  mckibben ")).map(|l| l.trim().to_owned());
        let before = out.len();
        out.extend(shown);
        let parent = help.contains("\nCommands:\n");
        assert!(parent || out.len() > before, "the help of `{name}` shows no example");
    }
    out
}

/// The commands of the fenced shell blocks of a page; a backslash at the end joins lines.
fn shown(text: &str) -> Vec<String> {
    let mut out = vec![];
    let mut shell = false;
    let mut open = false;
    let mut joined = String::new();
    for line in text.lines() {
        if let Some(language) = line.trim_start().strip_prefix("```") {
            shell = !open && ["sh", "console", "bash", "shell"].contains(&language.trim());
            open = !open;
            continue;
        }
        if !shell {
            continue;
        }
        joined.push_str(line.trim().trim_start_matches("$ "));
        if joined.ends_with('\\') {
            joined.pop();
            continue;
        }
        let line = std::mem::take(&mut joined);
        if line.starts_with("mckibben ") {
            out.push(line);
        } else if let Some(rest) = line.strip_prefix("cargo run --release -- ") {
            out.push(format!("mckibben {rest}"));
        }
    }
    out
}

/// The pages, each with its commands.
fn pages() -> Vec<(String, Vec<String>)> {
    let mut pages: Vec<PathBuf> = vec![];
    let readme = root().join("README.md");
    if readme.is_file() {
        pages.push(readme);
    } else {
        eprintln!("skipped: there is no README.md");
    }
    let mut folders = vec![root().join("docs")];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            match path.extension() {
                Some(ending) if ending == "md" => pages.push(path),
                _ if path.is_dir() => folders.push(path),
                _ => {}
            }
        }
    }
    pages.sort();
    let of = |page: PathBuf| {
        let name = page.file_name().unwrap().to_string_lossy().into_owned();
        (name, shown(&std::fs::read_to_string(&page).unwrap()))
    };
    pages.into_iter().map(of).collect()
}

/// The files of a folder and of all folders in it.
fn files_of(folder: &Path) -> BTreeSet<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries.flat_map(|path| if path.is_dir() { files_of(&path) } else { BTreeSet::from([path]) }).collect()
}

/// A command and the files that it wrote, by their paths in the folder of its page.
type Written = Vec<(PathBuf, Vec<u8>)>;

/// The commands of a page may build on each other, those of two pages may not. A command that reads no file of its page runs once: another page that
/// shows it gets the files that it wrote.
#[test]
fn the_commands_in_help_texts_and_pages_run() {
    let help = shown_by_help();
    assert!(help.len() >= 14, "{} examples", help.len());
    let mut all = pages();
    // The longest lists have some of the same long commands: one of them is not begun beside the others.
    all.insert(all.len() / 2, ("help".to_owned(), help));
    let known: Mutex<BTreeMap<String, Written>> =
        Mutex::new(BTreeMap::from([(format!("mckibben {}", crate::widths::VALIDATE), vec![])]));
    side_by_side(all, |(name, lines)| {
        let dir = copy();
        let mut before = files_of(dir.path());
        for line in lines {
            let own = |path: &Path| dir.path().join(path).exists() && !root().join(path).exists();
            let words = words(&line);
            let alone = !words.iter().any(|word| own(Path::new(word)));
            if let Some(written) = known.lock().unwrap().get(&line).filter(|_| alone) {
                for (path, content) in written {
                    std::fs::write(dir.path().join(path), content).unwrap();
                }
                before = files_of(dir.path());
                continue;
            }
            works(dir.path(), &name, &line);
            let after = files_of(dir.path());
            let inside = |path: &PathBuf| path.strip_prefix(dir.path()).unwrap().to_owned();
            if alone {
                let made: BTreeSet<PathBuf> = after.difference(&before).map(inside).collect();
                let flat = made.iter().all(|path| path.components().count() == 1);
                let read = |path: PathBuf| (std::fs::read(dir.path().join(&path)).unwrap(), path);
                let written = made.into_iter().map(read).map(|(content, path)| (path, content)).collect();
                if flat {
                    known.lock().unwrap().insert(line, written);
                }
            }
            before = after;
        }
        for written in ["f.svg", "muscle.svg", "winner.toml"] {
            assert!(name != "help" || dir.path().join(written).is_file(), "{written} is written");
        }
    });
}

/// Each of a list, on as many threads as there are processors; a failure of one is a failure of all.
fn side_by_side<T: Send>(list: Vec<T>, each: impl Fn(T) + Sync) {
    let left = Mutex::new(list);
    let next = || left.lock().unwrap().pop();
    let count = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..count {
            scope.spawn(|| std::iter::from_fn(&next).for_each(&each));
        }
    });
}

#[test]
fn shell_blocks_are_understood() {
    let page = "```sh\n$ mckibben force \\\n  -p 0.2 # why\ncargo run --release -- models | head\n```\n\
                mckibben no\n```toml\nmckibben neither\n```\n";
    assert_eq!(shown(page), ["mckibben force -p 0.2 # why", "mckibben models | head"]);
    assert_eq!(words("mckibben force -p 0.2 # why"), ["mckibben", "force", "-p", "0.2"]);
    assert_eq!(words("mckibben x \"a b\" '' | head"), ["mckibben", "x", "a b", ""]);
}

#[test]
fn the_example_muscles_are_muscles() {
    let mut count = 0;
    for entry in std::fs::read_dir(root().join("examples")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|e| e == "toml") {
            let text = std::fs::read_to_string(&path).unwrap();
            if text.contains("[joint]") {
                let pressures = if text.contains("[muscle_2]") { "2bar,1bar" } else { "2bar" };
                mckibben(&format!("joint {} -p {pressures} --model thick-wall", path.display())).ok();
                continue;
            }
            if text.contains("[command]") {
                mckibben(&format!("motion {} --model thick-wall", path.display())).ok();
                continue;
            }
            mckibben(&format!("check {}", path.display())).ok();
            mckibben(&format!("force --muscle {} -p 1bar -e 5%", path.display())).ok();
            count += 1;
        }
    }
    assert!(count >= 2);
}

/// B. Tondu (2012), Fig. 3: the ideal model is off by 92–95 N, the thick wall with two fitted constants by about 6 N.
#[test]
fn the_thick_wall_meets_the_20_degree_muscle() {
    let found = json(
        "compare --models ideal,thick-wall --muscle examples/tondu2012.toml \
         --data data/tondu2012/static_force_20deg.csv --fit modulus,end-factor",
    );
    let (ideal, thick) = (&found["models"][0], &found["models"][1]);
    assert_eq!((&ideal["model"], &thick["model"]), (&"ideal".into(), &"thick-wall".into()));
    assert!((number(ideal, "rms_n") - 95.2).abs() < 0.5, "{ideal}");
    assert!((number(thick, "rms_n") - 5.95).abs() < 0.1, "{thick}");
    assert!((number(thick, "fitted_end_factor") - 1.118).abs() < 0.003, "{thick}");
    assert!(ideal.get("fitted_end_factor").is_none(), "the ideal model has no such constant");
    assert_eq!(number(thick, "unanswered"), 0.0);
}

/// The friction of the example is the fit of the measured half-widths that its comment states.
#[test]
fn the_friction_of_the_example_is_the_fit_of_its_half_widths() {
    let points = [(0.1, 19.6), (0.2, 29.1), (0.3, 37.6), (0.4, 41.0), (0.5, 49.2)];
    let logs: Vec<(f64, f64)> = points.iter().map(|&(p, f): &(f64, f64)| (p.ln(), f.ln())).collect();
    let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / 5.0;
    let (x, y) = (mean(|q| q.0), mean(|q| q.1));
    let slope = logs.iter().map(|q| (q.0 - x) * (q.1 - y)).sum::<f64>()
        / logs.iter().map(|q| (q.0 - x).powi(2)).sum::<f64>();
    let text = std::fs::read_to_string(root().join("examples/tondu2012.toml")).unwrap();
    assert!(text.contains(&format!("\nexponent = {slope:.3}\n")), "β {slope}");
    assert!(
        text.contains(&format!("\ncoefficient = {:.2}\n", (y - slope * x).exp())),
        "C {}",
        (y - slope * x).exp()
    );
}
