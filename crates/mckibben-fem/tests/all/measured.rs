//! The measured muscles that the crate carries are those of the repository.

use std::fs;
use std::path::Path;

#[test]
fn the_crates_copies_are_the_files_in_data() {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("data");
    let repository = own.join("../../../data");
    let mut compared = 0;
    for folder in fs::read_dir(&own).unwrap().flatten().filter(|f| f.path().is_dir()) {
        for file in fs::read_dir(folder.path()).unwrap().flatten() {
            let path = file.path();
            let theirs = repository.join(path.strip_prefix(&own).unwrap());
            assert_eq!(fs::read(&path).unwrap(), fs::read(&theirs).unwrap(), "{}", theirs.display());
            compared += 1;
        }
    }
    assert_eq!(compared, 4);
}
