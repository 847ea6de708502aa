//! The connection of the hose.

use std::{fmt, str::FromStr};
use thiserror::Error;

/// The connection of the hose: a push-in fitting, or a bought barb, in a thread.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fitting {
    pub thread: Thread,
    /// Bore of the hose of a barb in mm.
    pub hose_mm: Option<f64>,
}

/// A thread for fittings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Thread {
    /// M3 × 0.5.
    M3,
    /// M5 × 0.8.
    M5,
    /// G1/8 (ISO 228-1).
    G18,
    /// G1/4 (ISO 228-1).
    G14,
}

impl Thread {
    const ALL: [Self; 4] = [Self::M3, Self::M5, Self::G18, Self::G14];

    fn name(self) -> &'static str {
        match self {
            Self::M3 => "M3",
            Self::M5 => "M5",
            Self::G18 => "G1/8",
            Self::G14 => "G1/4",
        }
    }

    /// Hole for the tap (ISO 2306), length of the thread, and diameter of the flat on which the
    /// seal lies, in mm. Lengths and flats are choices: about those of fittings on sale.
    pub(crate) fn sizes_mm(self) -> (f64, f64, f64) {
        match self {
            Self::M3 => (2.5, 4.0, 6.5),
            Self::M5 => (4.2, 6.0, 10.0),
            Self::G18 => (8.8, 9.0, 15.0),
            Self::G14 => (11.8, 12.0, 19.0),
        }
    }
}

/// A word that names no fitting.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error(
    "\"{0}\" is not a fitting; expected m3, m5, g1/8 or g1/4 (a thread), or barb:4 (a bought barb \
     for a hose with a bore of 4 mm, from 1 to 13)"
)]
pub struct UnknownFitting(String);

impl Fitting {
    /// Hoses for which barbs with one of the threads are sold, in mm: up to each of these.
    const HOSES_MM: [(f64, Thread); 4] = [
        (2.5, Thread::M3),
        (4.0, Thread::M5),
        (8.0, Thread::G18),
        (13.0, Thread::G14),
    ];

    /// The default for a tube of an outer diameter in mm. A choice: the head is then about as wide
    /// as the muscle.
    pub(crate) fn usual(outer_diameter_mm: f64) -> Self {
        let thread = match outer_diameter_mm {
            ..8.0 => Thread::M3,
            ..15.0 => Thread::M5,
            _ => Thread::G18,
        };
        Self {
            thread,
            hose_mm: None,
        }
    }

    /// What is bought.
    pub(crate) fn part(self) -> String {
        match self.hose_mm {
            Some(mm) => format!("barb for a hose with a bore of {mm} mm, thread {self}"),
            None => {
                let mm = self.tube_mm();
                format!("push-in fitting for a tube of {mm} mm, thread {self}, with its seal")
            }
        }
    }

    /// Outer diameter in mm of the tube of a push-in fitting, as they are sold with its thread.
    fn tube_mm(self) -> u32 {
        match self.thread {
            Thread::M3 | Thread::M5 => 4,
            Thread::G18 => 6,
            Thread::G14 => 8,
        }
    }

    /// What is pushed on or in.
    pub(crate) fn hose(self) -> String {
        match self.hose_mm {
            Some(mm) => format!("hose with a bore of {mm} mm"),
            None => format!("tube of polyurethane or polyamide, {} mm", self.tube_mm()),
        }
    }
}

impl fmt::Display for Fitting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.thread.name())
    }
}

impl FromStr for Fitting {
    type Err = UnknownFitting;

    fn from_str(text: &str) -> Result<Self, UnknownFitting> {
        let word: String = text.chars().take(40).collect();
        let plain = word.trim().to_lowercase();
        let mut threads = Thread::ALL.into_iter();
        if let Some(thread) = threads.find(|t| t.name().eq_ignore_ascii_case(&plain)) {
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
        let thread = Self::HOSES_MM.iter().find(|(most, _)| hose_mm <= *most);
        Ok(Self {
            thread: thread.ok_or(UnknownFitting(word))?.1,
            hose_mm: Some(hose_mm),
        })
    }
}
