//! An engine that takes jobs, and its commands.

use crate::campaign::CampaignError;
use serde::{Deserialize, Serialize};
use std::process::{Command, Stdio};
use std::str::FromStr;

/// An engine that takes jobs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum SubmitEngine {
    /// Slurm: `sbatch`, `squeue`, `scancel`.
    #[default]
    Slurm,
}

impl FromStr for SubmitEngine {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "slurm" => Ok(Self::Slurm),
            _ => Err(format!("\"{text}\" is not an engine that campaigns are submitted to; expected slurm")),
        }
    }
}

/// A text as one word of a shell.
pub(super) fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./=:,%+@".contains(c);
    if !text.is_empty() && text.chars().all(plain) {
        text.to_owned()
    } else {
        format!("'{}'", text.replace('\'', r"'\''"))
    }
}

/// Output of an engine's command.
pub(super) fn ask(program: &str, arguments: &[String]) -> Result<String, CampaignError> {
    let failed = |why: String| CampaignError::Engine { command: command(program, arguments), why };
    let output = Command::new(program)
        .args(arguments)
        .stdin(Stdio::null())
        .output()
        .map_err(|e| failed(e.to_string()))?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).trim().to_owned());
    }
    let why = String::from_utf8_lossy(&output.stderr).trim().to_owned();
    Err(failed(if why.is_empty() { output.status.to_string() } else { why }))
}

/// A command with its arguments, as one writes it in a shell.
pub(super) fn command(program: &str, arguments: &[String]) -> String {
    let words = std::iter::once(program).chain(arguments.iter().map(String::as_str));
    words.map(quoted).collect::<Vec<_>>().join(" ")
}
