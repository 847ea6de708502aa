//! How much memory a request in JSON takes, known before it is read.

use crate::problem::{Problem, ProblemKind};
use mckibben::budget::{Exceeded, Resource};

/// Deepest nesting; no request has more than six levels.
const DEEPEST: usize = 16;
const MOST_VALUES: usize = 500_000;
/// Bytes of a value in the list that holds it, which may be twice as long as it is filled.
const OF_A_VALUE: usize = 160;
/// Bytes of a list or an object beside that.
const OF_A_CONTAINER: usize = 400;

/// What was counted in a text that may be JSON.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct JsonSize {
    /// Length of the text.
    pub text_bytes: usize,
    /// Numbers, texts, lists and objects.
    pub values: usize,
    pub containers: usize,
}

impl JsonSize {
    /// Counts what is in a text, in one pass and without memory. That it is JSON is not looked at.
    pub fn of(text: &str) -> Result<Self, Problem> {
        let mut size = Self { text_bytes: text.len(), values: 1, containers: 0 };
        let (mut depth, mut quoted, mut escaped) = (0_usize, false, false);
        for byte in text.bytes() {
            match byte {
                _ if escaped => escaped = false,
                b'\\' if quoted => escaped = true,
                b'"' => quoted = !quoted,
                _ if quoted => {}
                b'[' | b'{' => {
                    depth += 1;
                    size.containers += 1;
                    size.values += 1;
                }
                b']' | b'}' => depth = depth.saturating_sub(1),
                b',' => size.values += 1,
                _ => {}
            }
            if depth > DEEPEST {
                let message = format!("the request is nested deeper than {DEEPEST} levels");
                return Err(Problem::new(ProblemKind::Usage, message, "no request needs that"));
            }
        }
        if size.values > MOST_VALUES {
            let (resource, limit) = (Resource::Points, MOST_VALUES as f64);
            let exceeded = Exceeded::Estimate { resource, estimate: size.values as f64, limit };
            let hint = "hand long tables over as text, or ask for less at once";
            return Err(Problem::new(ProblemKind::Budget, exceeded.to_string(), hint));
        }
        Ok(size)
    }

    /// About the memory that the text and its values take, in bytes.
    pub fn bytes(&self) -> f64 {
        (2 * self.text_bytes + OF_A_VALUE * self.values + OF_A_CONTAINER * self.containers) as f64
    }
}
