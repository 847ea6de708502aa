//! The report of `build` as a document for the file: title block, margins, test sheet, size.

use crate::common::run_in;
use std::path::Path;

const EXAMPLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/bench.toml");

fn page(dir: &Path, more: &[&str]) -> String {
    let words = [&["build", EXAMPLE, "-p", "2bar", "--report", "r.html", "--overwrite"], more].concat();
    let ran = run_in(dir, &words);
    assert_eq!(ran.code, 0, "{}", ran.err);
    std::fs::read_to_string(dir.join("r.html")).unwrap()
}

#[test]
fn the_title_block_has_what_is_stated_and_room_for_the_rest() {
    let dir = tempfile::tempdir().unwrap();
    let html = page(dir.path(), &["--number", "MK-012", "--revision", "B", "--project", "Arm <2>"]);
    for field in [
        "<dt>document no.</dt><dd>MK-012</dd>",
        "<dt>revision</dt><dd>B</dd>",
        "<dt>project</dt><dd>Arm &lt;2&gt;</dd>",
        "<dt>date</dt><dd></dd>",
        "<dt>checked</dt><dd></dd>",
    ] {
        assert!(html.contains(field), "{field}");
    }
}

/// The data of the view that a reader can rotate are not counted.
#[test]
fn without_its_view_a_report_has_at_most_300_kb() {
    let dir = tempfile::tempdir().unwrap();
    let html = page(dir.path(), &[]);
    let begin = html.find("<script type=\"application/json\">").unwrap();
    let end = begin + html[begin..].find("</script>").unwrap();
    assert!(html.len() - (end - begin) < 300_000, "{}", html.len());
    assert!(html.contains("counter(pages)") && html.contains("class=\"drawing\""));
}

#[test]
fn the_bench_test_has_the_rows_of_the_sheet_beside_it() {
    let dir = tempfile::tempdir().unwrap();
    run_in(dir.path(), &["build", EXAMPLE, "-p", "2bar", "-o", "build"]).ok();
    let html = std::fs::read_to_string(dir.path().join("build/report.html")).unwrap();
    let sheet = std::fs::read_to_string(dir.path().join("build/test.csv")).unwrap();
    let rows = sheet.lines().filter(|l| l.starts_with("0.")).count();
    let bench = html.split("<h2>Bench test</h2>").nth(1).unwrap().split("</table>").next().unwrap();
    assert!(rows > 8);
    assert_eq!(bench.matches("<td></td>").count(), rows);
}
