//! What holds for the whole process, and is tested in one of its own.
#![cfg(feature = "write")]
#![allow(clippy::unwrap_used)]

use mckibben_io::files::Unfinished;

/// Row C6 of the trials: hidden files were left where a signal ended the program while it wrote.
#[test]
fn unfinished_files_of_a_process_that_ends_are_removed_and_none_is_begun() {
    let folder = tempfile::tempdir().unwrap();
    let names = || std::fs::read_dir(folder.path()).unwrap().count();
    let begin = |name: &str| Unfinished::inside(&folder.path().join(name), false).unwrap();
    begin("done").put(false).unwrap();
    let files = ["a", "b"].map(begin);
    assert_eq!(names(), 3);
    let held = Unfinished::abandon();
    assert_eq!(names(), 1, "the finished one stays");
    std::thread::scope(|scope| {
        let late = scope.spawn(|| begin("late"));
        std::thread::sleep(std::time::Duration::from_millis(50));
        assert_eq!(names(), 1);
        drop(held);
        late.join().unwrap();
    });
    for file in files {
        assert!(file.put(false).is_err());
    }
}
