//! Where a table comes from: key and value in the metadata of its file.

use super::layout::Layout;
use crate::{
    campaign::{
        error::{CampaignError, Result},
        plan::Plan,
    },
    hash,
};
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
    /// Name of the model.
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

/// Which share of the table a file holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Which {
    Whole,
    Part(u64),
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
    part: Option<u64>,
}

impl Provenance {
    /// Of the table of a plan.
    pub(crate) fn for_plan(plan: &Plan) -> Self {
        Self {
            version: VERSION.into(),
            plan_sha256: plan.hash(),
            plan: plan.text.clone(),
            model: plan.testing.elements.name().into(),
            sampling: plan.sampling().name().into(),
            seed: plan.sampling().seed(),
            muscles: plan.muscles(),
            points_per_muscle: plan.points_per_muscle() as u64,
            block: plan.block(),
            layout: Layout::for_plan(plan),
        }
    }

    /// Whether a file has these metadata.
    pub(crate) fn check_same(&self, theirs: &Self, file: &Path) -> Result<()> {
        self.check_plan(&theirs.version, &theirs.plan_sha256, file)?;
        if theirs == self {
            return Ok(());
        }
        let why = "its metadata are not those of this plan";
        Err(CampaignError::damaged(file, why))
    }

    /// Whether a file is of this plan and this version of the program.
    pub(crate) fn check_plan(&self, version: &str, plan_sha256: &str, file: &Path) -> Result<()> {
        let name = file.display();
        let ours = &self.plan_sha256;
        let our_version = &self.version;
        let other = if plan_sha256 != ours {
            format!(
                "{name} contains a campaign of another plan (sha256 {plan_sha256:.12}, this plan \
                 has {ours:.12})"
            )
        } else if version != our_version {
            format!("{name} was written by mckibben {version}, and this is version {our_version}")
        } else {
            return Ok(());
        };
        Err(CampaignError::OtherPlan(other))
    }

    pub fn parts(&self) -> u64 {
        self.muscles.div_ceil(self.block.max(1))
    }

    pub fn points(&self) -> u64 {
        self.muscles.saturating_mul(self.points_per_muscle)
    }

    pub(crate) fn muscles_of(&self, part: u64) -> std::ops::Range<u64> {
        let from = part.saturating_mul(self.block).min(self.muscles);
        from..from.saturating_add(self.block).min(self.muscles)
    }

    /// Rows of a file.
    pub(crate) fn rows_of(&self, which: Which) -> u64 {
        match which {
            Which::Whole => self.points(),
            Which::Part(part) => {
                let muscles = self.muscles_of(part);
                (muscles.end - muscles.start).saturating_mul(self.points_per_muscle)
            }
        }
    }

    /// All of it as JSON.
    pub(crate) fn to_json(&self, which: Which) -> serde_json::Result<String> {
        let part = match which {
            Which::Whole => None,
            Which::Part(part) => Some(part),
        };
        serde_json::to_string(&Stored {
            provenance: self.clone(),
            muscles_per_part: self.block,
            layout: self.layout.clone(),
            part,
        })
    }

    pub(crate) fn from_json(text: &[u8]) -> Result<(Self, Which), String> {
        let stored: Stored = serde_json::from_slice(text).map_err(|e| format!("{STORED}: {e}"))?;
        let provenance = Self {
            block: stored.muscles_per_part.max(1),
            layout: stored.layout,
            ..stored.provenance
        };
        if hash::hex(provenance.plan.as_bytes()) != provenance.plan_sha256 {
            return Err("the plan in its metadata does not match its hash".into());
        }
        Ok((provenance, stored.part.map_or(Which::Whole, Which::Part)))
    }

    /// Keys and values in the metadata of a file.
    pub(crate) fn write(&self, which: Which) -> serde_json::Result<Vec<(String, String)>> {
        let mut pairs = vec![
            (STORED, self.to_json(which)?),
            ("mckibben.version", self.version.clone()),
            ("mckibben.plan", self.plan.clone()),
            ("mckibben.plan_sha256", self.plan_sha256.clone()),
        ];
        pairs.extend(self.seed.map(|seed| ("mckibben.seed", seed.to_string())));
        Ok(pairs.into_iter().map(|(k, v)| (k.into(), v)).collect())
    }

    pub(crate) fn read(pairs: &[(String, String)]) -> Result<(Self, Which), String> {
        let stored = pairs.iter().find(|(key, _)| key == STORED);
        let (_, text) = stored.ok_or_else(|| format!("its metadata have no {STORED}"))?;
        Self::from_json(text.as_bytes())
    }
}
