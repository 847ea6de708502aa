//! Where a table comes from: key and value in the metadata of its file.

use super::{layout::Layout, seal};
use crate::{
    campaign::{
        error::{CampaignError, Result},
        plan::Plan,
    },
    columns::descriptions,
};
use mckibben_core::muscle::file::to_toml;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// This version of the program.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Where a table comes from. No time and no host: the same plan gives the same bytes.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Provenance {
    /// Version of the program.
    pub version: String,
    /// SHA-256 of the plan's text.
    pub plan_sha256: String,
    /// The plan's text.
    pub plan: String,
    /// The muscle that is varied with all that the plan leaves to defaults, as a muscle file.
    pub muscle: String,
    /// The model.
    pub model: String,
    /// How the plan is sampled.
    pub sampling: String,
    /// Seed of the sampling, where it has one.
    pub seed: Option<u64>,
    /// Number of muscles of the whole plan.
    #[serde(rename = "muscles_wanted")]
    pub muscles: u64,
    /// Points of each muscle.
    pub points_per_muscle: u64,
    /// Muscles of one part.
    #[serde(skip)]
    pub block: u64,
    #[serde(skip)]
    pub(crate) layout: Layout,
}

/// The key that holds all of it as JSON; some of it has keys of its own, for people.
const STORED: &str = "mckibben.campaign";

/// What [`STORED`] holds.
#[derive(Serialize, Deserialize)]
struct Stored {
    #[serde(flatten)]
    provenance: Provenance,
    muscles_per_part: u64,
    #[serde(flatten)]
    layout: Layout,
    /// The part that the file holds; nothing of the whole table.
    part: Option<u64>,
}

impl Provenance {
    /// Of the table of a plan.
    pub(crate) fn for_plan(plan: &Plan) -> Self {
        Self {
            version: VERSION.into(),
            plan_sha256: plan.hash(),
            plan: plan.text.clone(),
            muscle: plan.base().as_ref().map(to_toml).unwrap_or_default(),
            model: plan.testing.elements.name().into(),
            sampling: plan.sampling().method.to_string(),
            seed: plan.sampling().seed.map(u64::from),
            muscles: plan.muscles(),
            points_per_muscle: plan.points_per_muscle() as u64,
            block: plan.block(),
            layout: Layout::for_plan(plan),
        }
    }

    /// Whether a file has these metadata: is of this plan and this version of the program.
    pub(crate) fn check_same(&self, theirs: &Self, file: &Path) -> Result<()> {
        let name = file.display();
        let other = if theirs.plan_sha256 != self.plan_sha256 {
            format!(
                "{name} contains a campaign of another plan (sha256 {:.12}, this plan has {:.12})",
                theirs.plan_sha256, self.plan_sha256
            )
        } else if theirs.version != self.version {
            format!(
                "{name} was written by mckibben {}, and this is version {}",
                theirs.version, self.version
            )
        } else if theirs == self {
            return Ok(());
        } else {
            return Err(CampaignError::damaged(
                file,
                "its metadata are not those of this plan",
            ));
        };
        Err(CampaignError::OtherPlan(other))
    }

    /// The number of parts of the store: blocks of muscles.
    pub fn parts(&self) -> u64 {
        self.muscles.div_ceil(self.block.max(1))
    }

    /// The number of rows of all muscles.
    pub fn points(&self) -> u64 {
        self.rows_of(None)
    }

    pub(crate) fn muscles_of(&self, part: u64) -> std::ops::Range<u64> {
        let from = part.saturating_mul(self.block).min(self.muscles);
        from..from.saturating_add(self.block).min(self.muscles)
    }

    /// How many muscles are in some parts.
    pub(crate) fn muscles_in(&self, parts: impl Iterator<Item = u64>) -> u64 {
        parts.map(|part| self.muscles_of(part).count() as u64).sum()
    }

    /// Rows of the file of a part, or of the whole table.
    pub(crate) fn rows_of(&self, part: Option<u64>) -> u64 {
        let muscles = part.map_or(0..self.muscles, |part| self.muscles_of(part));
        (muscles.end - muscles.start).saturating_mul(self.points_per_muscle)
    }

    /// All of it as JSON.
    pub(crate) fn to_json(&self, part: Option<u64>) -> serde_json::Result<String> {
        serde_json::to_string(&Stored {
            provenance: self.clone(),
            muscles_per_part: self.block,
            layout: self.layout.clone(),
            part,
        })
    }

    pub(crate) fn from_json(text: &[u8]) -> Result<(Self, Option<u64>), String> {
        let stored: Stored = serde_json::from_slice(text).map_err(|e| format!("{STORED}: {e}"))?;
        let provenance = Self {
            block: stored.muscles_per_part.max(1),
            layout: stored.layout,
            ..stored.provenance
        };
        if mckibben_core::hash::hex(&provenance.plan) != provenance.plan_sha256 {
            return Err("the plan in its metadata does not match its hash".into());
        }
        Ok((provenance, stored.part))
    }

    /// Keys and values in the metadata of a file.
    pub(crate) fn write(&self, part: Option<u64>) -> serde_json::Result<Vec<(String, String)>> {
        let mut pairs = vec![
            (STORED, self.to_json(part)?),
            ("mckibben.version", self.version.clone()),
            ("mckibben.plan", self.plan.clone()),
            ("mckibben.plan_sha256", self.plan_sha256.clone()),
        ];
        let fields = self.layout.fields();
        let columns = fields.iter().map(|f| (f.name.as_str(), f.column));
        pairs.push(("mckibben.columns", descriptions(columns).to_string()));
        pairs.push(("mckibben.muscle", self.muscle.clone()));
        pairs.extend(self.seed.map(|seed| ("mckibben.seed", seed.to_string())));
        pairs.push((seal::KEY, seal::blank()));
        Ok(pairs.into_iter().map(|(k, v)| (k.into(), v)).collect())
    }

    pub(crate) fn read(pairs: &[(String, String)]) -> Result<(Self, Option<u64>), String> {
        let (_, text) = pairs
            .iter()
            .find(|(key, _)| key == STORED)
            .ok_or_else(|| format!("its metadata have no {STORED}"))?;
        Self::from_json(text.as_bytes())
    }
}
