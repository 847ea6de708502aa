//! Help and manual pages that the program prints and writes; their content is in `src/cli/tests.rs`.

use crate::common::{folder, mckibben, names, run_in};

#[test]
fn help_and_manual_pages_are_those_of_the_commands() {
    for name in ["force", "parts show", "rubber"] {
        let long = mckibben(&format!("{name} --help")).ok();
        assert_eq!(mckibben(&format!("help {name}")).ok(), long, "{name}");
    }
    assert_eq!(mckibben("help").ok(), mckibben("--help").ok());
    let dir = folder();
    run_in(dir.path(), "man -o man1").ok();
    let names = names(&dir.path().join("man1"));
    assert!(names.len() > 20, "{names:?}");
    for name in ["mckibben.1", "mckibben-parts-show.1"] {
        assert!(names.iter().any(|n| n == name), "{names:?}");
    }
    let page = std::fs::read_to_string(dir.path().join("man1/mckibben-force.1")).unwrap();
    for part in [
        ".SH QUESTION",
        ".SH MUSCLE",
        ".SH ADVANCED",
        ".SH EXAMPLES",
        "mckibben force \\-D 50",
        "Any key of a muscle file",
        "Muscle file, same as",
    ] {
        assert!(page.contains(part), "{part}: {page}");
    }
    assert_eq!(mckibben("man force").ok().text(), page);
    // Not over an older one.
    assert_eq!(run_in(dir.path(), "man -o man1").code, 2);
}
