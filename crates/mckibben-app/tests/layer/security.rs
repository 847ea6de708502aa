//! What `SECURITY.md` says of the code.

use super::{root, sources};
use std::collections::BTreeSet;

/// Whether code holds the word `unsafe`, outside of comments, texts and the names of attributes.
fn holds_unsafe(text: &str) -> bool {
    text.lines().any(|line| {
        let code = line.split("//").next().unwrap_or_default();
        let words = || code.split(|c: char| !(c.is_alphanumeric() || "_-\'".contains(c)));
        words().any(|word| word == "unsafe") && !code.contains("unsafe(")
    })
}

/// Every file of the program and its libraries with `unsafe` code is named, and no other.
#[test]
fn the_list_of_unsafe_code_is_complete() {
    let root = root();
    let mut files = vec![];
    for entry in std::fs::read_dir(root.join("crates")).unwrap() {
        sources(&entry.unwrap().path().join("src"), &mut files);
    }
    let present: BTreeSet<String> = files
        .into_iter()
        .filter(|path| holds_unsafe(&std::fs::read_to_string(path).unwrap()))
        .map(|path| {
            path.strip_prefix(&root)
                .unwrap()
                .to_string_lossy()
                .replace('\\', "/")
        })
        .collect();
    let text = std::fs::read_to_string(root.join("SECURITY.md")).unwrap();
    let named: BTreeSet<String> = text
        .split('`')
        .skip(1)
        .step_by(2)
        .filter(|name| name.ends_with(".rs"))
        .map(Into::into)
        .collect();
    assert_eq!(named, present);
}
