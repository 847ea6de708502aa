//! Files with one mistake each: the line it is found in. (What is said of each is in the messages of
//! `mckibben-app`.)

use super::{MAX_BYTES, parse_muscle, read_muscle};

/// Line, text.
const BAD: &str = include_str!("bad_files.tsv");

#[test]
fn bad_files_are_refused_with_their_line() {
    let mut wrong = Vec::new();
    for row in BAD.lines() {
        let (line, text) = row.split_once('\t').unwrap();
        let line = line.parse().ok();
        let text = text.replace("\\n", "\n");
        // A BOM in front and CRLF move nothing.
        for text in [
            text.clone(),
            format!("\u{feff}{text}"),
            text.replace('\n', "\r\n"),
        ] {
            match parse_muscle(&text) {
                Ok(_) => wrong.push(format!("{text:?} is accepted")),
                Err(e) if e.place.map(|p| p.line) == line => {}
                Err(e) => wrong.push(format!("{text:?}: {e}")),
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_column_counts_characters() {
    let error = parse_muscle("name = \"é\"\n[tube]\n  \"rubber\" = \"päper\" # ä\n").unwrap_err();
    assert_eq!(error.place.map(|p| (p.line, p.column)), Some((3, 14)));
}

/// A directory of its own for one test, removed at the end.
struct Scratch(std::path::PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("mckibben-{}-{name}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn file(&self, name: &str, bytes: &[u8]) -> std::path::PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[test]
fn what_is_no_readable_file_is_refused_by_name() {
    let dir = Scratch::new("bad-files");
    let message = |path: &std::path::Path| read_muscle(path).unwrap_err().to_string();
    let bad = dir.file("muscle.toml", b"[tube]\n\nwall_thickness = \"-3 mm\"\n");
    assert!(message(&bad).ends_with(
        "muscle.toml:3:18: tube.wall_thickness = \"-3 mm\": is -3\u{a0}mm; it must be above zero \
         and finite"
    ));
    let missing = read_muscle(dir.0.join("none.toml")).unwrap_err();
    assert!(missing.to_string().contains("none.toml: cannot be read: "));
    assert!(message(&dir.0).contains("is a directory; it must be a regular file"));
    #[cfg(unix)]
    assert!(message("/dev/null".as_ref()).contains("is a device or a pipe"));
    let latin = dir.file("latin.toml", b"[tube]\n# 28\xb0\nlength = 3\n");
    assert!(message(&latin).contains("latin.toml:2:5: the byte at offset 11 is not UTF-8"));
    let utf16 = dir.file("utf16.toml", b"\xff\xfe[\0t\0");
    assert!(
        message(&utf16)
            .contains("offset 0 is not UTF-8 text (this looks like UTF-16: save it as UTF-8)")
    );
    let long = dir.file("long.toml", &vec![b'\n'; MAX_BYTES + 1]);
    assert!(message(&long).contains("is longer than 1048576 bytes"));
    assert!(read_muscle(dir.file("full.toml", &vec![b'\n'; MAX_BYTES])).is_ok());
    let good = dir.file(
        "good.toml",
        "\u{feff}[tube]\r\nlength = \"300 mm\"\r\n".as_bytes(),
    );
    assert_eq!(read_muscle(good).unwrap().length_mm(), 300.0);
}
