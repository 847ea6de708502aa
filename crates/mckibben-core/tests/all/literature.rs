//! `literature.bib` at the root of the repository holds every source that code, data and documents
//! cite as `[key]`.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Fields of each entry by its key.
fn entries() -> BTreeMap<String, BTreeMap<String, String>> {
    let text = fs::read_to_string(root().join("literature.bib")).unwrap();
    let mut all = BTreeMap::new();
    for entry in text.split("\n@").skip(1) {
        let (head, body) = entry.split_once(",\n").unwrap();
        let key = head.split_once('{').unwrap().1.to_owned();
        let fields = body
            .lines()
            .filter_map(|line| line.trim().split_once(" = {"));
        let fields = fields
            .map(|(name, value)| (name.to_owned(), value.trim_end_matches("},").to_owned()))
            .collect();
        assert!(
            all.insert(key.clone(), fields).is_none(),
            "{key} is there twice"
        );
    }
    all
}

/// The texts `[key]` and `\[key\]` of a file, a key being letters and a year.
fn cited(text: &str) -> Vec<&str> {
    let inside = text
        .split('[')
        .skip(1)
        .filter_map(|rest| rest.split_once(']'))
        .map(|(inside, _)| inside);
    let is_key = |word: &&str| {
        let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
        let lower = !letters.is_empty() && letters.chars().all(|c| c.is_ascii_lowercase());
        lower && word.len() == letters.len() + 4
    };
    inside
        .map(|word| word.trim_end_matches('\\'))
        .filter(is_key)
        .collect()
}

/// Sources and documents of the repository.
fn files(folder: &Path, paths: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() && name != "target" && !name.starts_with('.') {
            files(&path, paths);
        } else if ["rs", "md", "toml"]
            .iter()
            .any(|e| path.extension().is_some_and(|x| x == *e))
        {
            paths.push(path);
        }
    }
}

#[test]
fn every_source_that_is_cited_stands_in_the_bibliography() {
    let known = entries();
    let mut all = Vec::new();
    files(&root(), &mut all);
    let mut count = 0;
    for path in all {
        let text = fs::read_to_string(&path).unwrap();
        for key in cited(&text) {
            assert!(known.contains_key(key), "{} cites [{key}]", path.display());
            count += 1;
        }
    }
    assert!(count > 60, "only {count} citations found");
}

#[test]
fn an_entry_is_complete_and_its_key_is_author_and_year() {
    for (key, fields) in entries() {
        let author = fields["author"].split(',').next().unwrap();
        let plain = author
            .replace("{\\'a}", "a")
            .replace("von ", "")
            .to_lowercase();
        let name = plain.split(' ').next().unwrap();
        // A letter tells works of one author and year apart.
        let plain = key
            .strip_suffix(|c: char| c.is_ascii_lowercase())
            .unwrap_or(&key);
        assert_eq!(plain, format!("{name}{}", fields["year"]), "{key}");
        assert!(fields["title"].len() > 10, "{key}");
        let place = ["journal", "booktitle", "publisher", "howpublished", "url"];
        assert!(
            place.iter().any(|p| fields.contains_key(*p)),
            "{key} does not say where it appeared"
        );
        assert!(
            fields.get("doi").is_none_or(|doi| doi.starts_with("10.")),
            "{key}"
        );
    }
}

#[test]
fn every_named_rubber_cites_its_source() {
    let library =
        fs::read_to_string(root().join("crates/mckibben-core/data/rubbers.toml")).unwrap();
    let citations: Vec<_> = library
        .lines()
        .filter(|l| l.starts_with("citation = "))
        .collect();
    assert!(citations.len() >= 3);
    for line in citations {
        let address = line.contains("https://");
        assert!(
            line.contains("identified with") || address || !cited(line).is_empty(),
            "{line}"
        );
    }
}

#[test]
fn every_named_sleeve_and_material_says_where_its_figures_stand() {
    let library = fs::read_to_string(root().join("crates/mckibben-core/data/braids.toml")).unwrap();
    let citations: Vec<_> = library
        .lines()
        .filter(|l| l.starts_with("citation = "))
        .collect();
    assert!(citations.len() >= 5);
    for line in citations {
        assert!(line.contains("http") || !cited(line).is_empty(), "{line}");
    }
}
