//! A table does not depend on threads, shards and interruptions.

use super::*;
use std::sync::atomic::{AtomicBool, Ordering};

#[test]
fn any_number_of_threads_gives_the_same_bytes() {
    let dir = folder();
    let expected = reference(&dir);
    for threads in [1, 2, 3, 8] {
        let path = dir.path().join(format!("{threads}.parquet"));
        let options = RunOptions {
            threads: Some(threads),
            ..RunOptions::default()
        };
        let outcome = run(&plan(), &path, &options, &Silent).unwrap();
        assert_eq!((outcome.counts.points, outcome.complete), (72, true));
        assert!(bytes(&path) == expected, "{threads} threads");
    }
    let left: Vec<_> = std::fs::read_dir(dir.path()).unwrap().collect();
    assert_eq!(left.len(), 5, "only the files: {left:?}");
}

#[test]
fn shards_in_one_folder_or_many_merge_to_the_same_bytes() {
    let dir = folder();
    let expected = reference(&dir);
    for (count, apart) in [(1, false), (2, false), (3, true), (7, true), (20, false)] {
        let place = |i: u64| {
            dir.path()
                .join(format!("{count}-{}", if apart { i } else { 0 }))
        };
        let mut muscles = 0;
        for i in 1..=count {
            let outcome =
                run(&plan(), &place(i), &share(&format!("{i}/{count}")), &Silent).unwrap();
            assert!(outcome.complete);
            muscles += outcome.counts.of;
        }
        assert_eq!(muscles, 12, "each muscle is in one share");
        let mut folders: Vec<PathBuf> = (1..=count).map(place).collect();
        folders.dedup();
        let out = dir.path().join(format!("{count}.parquet"));
        merge(&folders, &out, false).unwrap();
        assert!(bytes(&out) == expected, "{count} shards");
        if !apart {
            // A folder is read as the file is.
            assert_eq!(read(&folders[0]).unwrap(), read(&out).unwrap());
            assert_eq!(
                summary(&folders[0]).unwrap().ranges,
                summary(&out).unwrap().ranges
            );
        }
    }
}

/// Wants the end once so many muscles are there.
struct StopsAfter {
    muscles: usize,
    reached: AtomicBool,
}

impl StopsAfter {
    fn new(muscles: usize) -> Self {
        Self {
            muscles,
            reached: AtomicBool::new(false),
        }
    }
}

impl Progress for StopsAfter {
    fn report(&self, done: usize, _: usize) {
        self.reached.store(done >= self.muscles, Ordering::Relaxed);
    }

    fn cancelled(&self) -> bool {
        self.reached.load(Ordering::Relaxed)
    }
}

#[test]
fn rows_in_memory_are_those_of_the_file_and_a_wish_to_stop_ends_them() {
    let dir = folder();
    let path = dir.path().join("c.parquet");
    run_to(&path);
    assert_eq!(compute(&plan(), &Silent).unwrap(), read(&path).unwrap());
    assert!(matches!(
        compute(&plan(), &StopsAfter::new(1)),
        Err(CampaignError::Cancelled(_))
    ));
}

#[test]
fn a_run_that_was_stopped_goes_on_and_computes_only_what_is_missing() {
    let dir = folder();
    let expected = reference(&dir);
    for (name, after) in [("a.parquet", 1), ("b.parquet", 5), ("c.parquet", 11)] {
        let path = dir.path().join(name);
        let options = RunOptions {
            threads: Some(1),
            ..RunOptions::default()
        };
        let first = run(&plan(), &path, &options, &StopsAfter::new(after)).unwrap();
        assert!(!path.exists() || first.complete);
        let second = run_to(&path);
        assert!(second.complete);
        assert_eq!(second.counts.resumed, first.counts.muscles);
        assert_eq!(second.counts.points + first.counts.points, 72);
        assert!(bytes(&path) == expected);
        // A third time there is nothing to do.
        assert_eq!(run_to(&path).counts.points, 0);
        assert!(bytes(&path) == expected);
    }
}

#[test]
fn parts_that_were_computed_twice_are_the_same_bytes() {
    let dir = folder();
    let expected = reference(&dir);
    let one = dir.path().join("one");
    let other = dir.path().join("other");
    run_to(&one);
    run(&plan(), &other, &share("2/3"), &Silent).unwrap();
    assert_eq!(bytes(&part(&one, 4)), bytes(&part(&other, 4)));
    let out = dir.path().join("merged.parquet");
    merge(&[other, one], &out, false).unwrap();
    assert!(bytes(&out) == expected);
}

#[test]
fn one_process_writes_to_a_store_or_several_with_different_shards() {
    use crate::campaign::store::folder::Folder;
    let dir = folder();
    let path = dir.path().join("store");
    let shard = |text: &str| Some(text.parse::<Shard>().unwrap());
    let locked = |r: Result<Folder, CampaignError>| matches!(r, Err(CampaignError::Locked { .. }));
    {
        let _whole = Folder::for_writing(&path, None).unwrap();
        assert!(locked(Folder::for_writing(&path, None)));
        assert!(locked(Folder::for_writing(&path, shard("1/2"))));
        let error = run(&plan(), &path, &RunOptions::default(), &Silent).unwrap_err();
        assert!(
            error
                .to_string()
                .starts_with("another process is writing to"),
            "{error}"
        );
    }
    let _first = Folder::for_writing(&path, shard("1/2")).unwrap();
    assert!(locked(Folder::for_writing(&path, shard("1/2"))));
    assert!(locked(Folder::for_writing(&path, None)));
    let _second = Folder::for_writing(&path, shard("2/2")).unwrap();
}

#[test]
fn a_shard_is_one_of_a_number() {
    for text in [
        "0/2",
        "3/2",
        "1",
        "1/0",
        "a/b",
        "-1/2",
        "1/2/3",
        "1/1000000",
        "",
    ] {
        assert!(text.parse::<Shard>().is_err(), "{text}");
    }
    let shards: Vec<Shard> = (1..=5).map(|i| format!("{i}/5").parse().unwrap()).collect();
    for block in 0..50 {
        assert_eq!(shards.iter().filter(|s| s.holds(block)).count(), 1);
    }
    let file = Path::new("x.parquet");
    let error = run(&plan(), file, &share("1/2"), &Silent).unwrap_err();
    assert!(matches!(error, CampaignError::Refused(..)));
}
