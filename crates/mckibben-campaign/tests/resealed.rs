//! Files with a valid seal and wrong insides: an error or the table, never a panic, and no more memory than the bytes that are
//! there can hold.
//!
//! The same bytes are changed in every run. `MCKIBBEN_ROUNDS=1000000` tries more of them, `MCKIBBEN_SEED=2` others.

#![allow(clippy::unwrap_used)]

use mckibben::progress::Silent;
use mckibben_campaign::campaign::{Plan, RunOptions, read, run, summary};
use sha2::{Digest, Sha256};
use std::alloc::{GlobalAlloc, Layout, System};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// The system's memory, counted.
struct Counting;

static NOW: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);

// Safety: all is the system's.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        MOST.fetch_max(NOW.fetch_add(layout.size(), Relaxed) + layout.size(), Relaxed);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        NOW.fetch_sub(layout.size(), Relaxed);
        unsafe { System.dealloc(at, layout) }
    }
}

#[global_allocator]
static MEMORY: Counting = Counting;

/// The most that a file of a few kilobytes may take: a group of as many rows as the encoder writes, in every column.
const MEMORY_BYTES: usize = 256 << 20;

const PLAN: &str = "[sampling]\nmethod = \"latin-hypercube\"\nsamples = 4\nseed = 2\n\
    [vary]\ntube.outer_diameter = \"20..50 mm\"\ntube.wall_ratio = \"4..12%\"\n\
    [test]\ncontractions = \"0,10%\"\npressures = \"0.1,0.2,0.3\"\nmesh = \"3\"\n";

/// Splitmix64.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, end: usize) -> usize {
        (self.roll() % end as u64) as usize
    }
}

/// Puts the seal of what a file holds now.
fn reseal(bytes: &mut [u8]) {
    let seal = Sha256::new().chain_update(&bytes[..4]).chain_update(&bytes[36..]).finalize();
    bytes[4..36].copy_from_slice(&seal);
}

/// Some bytes behind the seal, every other time of the metadata.
fn change(whole: &[u8], dice: &mut Dice) -> Vec<u8> {
    let mut bytes = whole.to_vec();
    let end = bytes.len();
    let metadata = end - 8 - u32::from_le_bytes(bytes[end - 8..end - 4].try_into().unwrap()) as usize;
    for _ in 0..=dice.below(4) {
        let from = if dice.below(2) == 0 { metadata } else { 36 };
        let at = from + dice.below(end - 4 - from);
        bytes[at] = match dice.below(4) {
            0 => bytes[at] ^ 1 << dice.below(8),
            1 => [0, 1, 0x7f, 0x80, 0xff][dice.below(5)],
            2 => bytes[36 + dice.below(end - 40)],
            _ => dice.roll() as u8,
        };
    }
    reseal(&mut bytes);
    bytes
}

fn number(name: &str, usual: u64) -> u64 {
    std::env::var(name).map_or(usual, |text| text.parse().unwrap())
}

fn holds_to_its_word(path: &Path, rows: usize, round: u64) -> bool {
    MOST.store(NOW.load(Relaxed), Relaxed);
    let before = NOW.load(Relaxed);
    let found = read(path).map(|found| found.len());
    let shown = summary(path);
    let most = MOST.load(Relaxed) - before;
    assert!(most < MEMORY_BYTES, "round {round}: {most} bytes");
    if let Ok(found) = found {
        assert_eq!(found, rows, "round {round}");
        assert!(shown.is_ok(), "round {round}");
    }
    found.is_ok()
}

#[test]
fn a_resealed_file_is_refused_or_read_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("c.parquet");
    run(&Plan::parse(PLAN).unwrap(), &path, &RunOptions::default(), &Silent).unwrap();
    let whole = std::fs::read(&path).unwrap();
    let mut same = whole.clone();
    reseal(&mut same);
    assert_eq!(same, whole, "the seal is what it is said to be");
    let rounds = number("MCKIBBEN_ROUNDS", 4000);
    let mut dice = Dice(number("MCKIBBEN_SEED", 1));
    let (mut read, mut most) = (0, 0);
    for round in 0..rounds {
        // A new file each time: some file systems bring one that is written over to the disk at once.
        std::fs::remove_file(&path).unwrap();
        std::fs::write(&path, change(&whole, &mut dice)).unwrap();
        read += u64::from(holds_to_its_word(&path, 24, round));
        most = most.max(MOST.load(Relaxed));
    }
    println!("{read} of {rounds} were read; at most {most} bytes");
    // Both ends of the border were met.
    assert!(read > 0 && read < rounds, "{read} of {rounds} were read");
}
