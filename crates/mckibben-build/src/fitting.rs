//! The connection of the hose.

use crate::sold::first;
use std::{fmt, str::FromStr};
use thiserror::Error;

/// The connection of the hose: a push-in fitting, or a bought barb, in a thread.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fitting {
    /// Of the port that takes it.
    pub thread: Thread,
    /// Bore of the hose of a barb in mm.
    pub hose_mm: Option<f64>,
}

/// A thread for fittings; lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thread {
    name: &'static str,
    /// Hole for the tap (ISO 2306), length of the thread, and diameter of the flat on which the
    /// seal lies. Lengths and flats are choices: about those of fittings on sale.
    pub(crate) sizes_mm: [f64; 3],
    /// Outer diameter of the tube of a push-in fitting, as they are sold with it.
    tube_mm: u32,
    /// Largest bore of the hose of a barb, as they are sold with it.
    hose_mm: f64,
    /// The default for a muscle whose tube is below this. A choice: the head is then about as wide as
    /// the muscle.
    muscle_mm: f64,
}

impl Thread {
    const fn new(
        name: &'static str,
        sizes_mm: [f64; 3],
        tube_mm: u32,
        [hose_mm, muscle_mm]: [f64; 2],
    ) -> Self {
        Self {
            name,
            sizes_mm,
            tube_mm,
            hose_mm,
            muscle_mm,
        }
    }
}

/// Metric threads, and those of ISO 228-1.
const THREADS: [Thread; 4] = [
    Thread::new("M3", [2.5, 4.0, 6.5], 4, [2.5, 8.0]),
    Thread::new("M5", [4.2, 6.0, 10.0], 4, [4.0, 15.0]),
    Thread::new("G1/8", [8.8, 9.0, 15.0], 6, [8.0, f64::INFINITY]),
    Thread::new("G1/4", [11.8, 12.0, 19.0], 8, [13.0, f64::INFINITY]),
];

/// A word that names no fitting.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error(
    "\"{0}\" is not a fitting; expected m3, m5, g1/8 or g1/4 (a thread), or barb:4 (a bought barb \
     for a hose with a bore of 4 mm, from 1 to 13)"
)]
pub struct UnknownFitting(String);

impl Fitting {
    /// The default for a tube of an outer diameter in mm.
    pub(crate) fn usual(outer_diameter_mm: f64) -> Self {
        Self {
            thread: first(&THREADS, |thread| outer_diameter_mm < thread.muscle_mm),
            hose_mm: None,
        }
    }

    /// What is bought.
    pub(crate) fn part(self) -> String {
        match self.hose_mm {
            Some(mm) => format!("barb for a hose with a bore of {mm} mm, thread {self}"),
            None => {
                let mm = self.thread.tube_mm;
                format!("push-in fitting for a tube of {mm} mm, thread {self}, with its seal")
            }
        }
    }

    /// What is pushed on or in.
    pub(crate) fn hose(self) -> String {
        match self.hose_mm {
            Some(mm) => format!("hose with a bore of {mm} mm"),
            None => format!(
                "tube of polyurethane or polyamide, {} mm",
                self.thread.tube_mm
            ),
        }
    }
}

impl fmt::Display for Fitting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.thread.name)
    }
}

impl FromStr for Fitting {
    type Err = UnknownFitting;

    fn from_str(text: &str) -> Result<Self, UnknownFitting> {
        let word: String = text.chars().take(40).collect();
        let plain = word.trim().to_lowercase();
        let mut threads = THREADS.into_iter();
        if let Some(thread) = threads.find(|t| t.name.eq_ignore_ascii_case(&plain)) {
            return Ok(Self {
                thread,
                hose_mm: None,
            });
        }
        let bore = plain.strip_prefix("barb:");
        let bore = bore.and_then(|bore| bore.trim_end_matches("mm").trim().parse().ok());
        let hose_mm = bore
            .filter(|mm| *mm >= 1.0)
            .ok_or(UnknownFitting(word.clone()))?;
        let thread = THREADS.into_iter().find(|t| hose_mm <= t.hose_mm);
        Ok(Self {
            thread: thread.ok_or(UnknownFitting(word))?,
            hose_mm: Some(hose_mm),
        })
    }
}
