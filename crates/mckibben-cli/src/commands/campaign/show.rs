//! `campaign show`.

use crate::failure::Failure;
use crate::flags::OutputFlags;
use crate::format::Format;
use crate::output::show;
use crate::output::text::{number, pairs, table};
use clap::Args;
use mckibben_app::{CampaignShowRequest, campaign_show};
use mckibben_campaign::campaign::Summary;
use std::path::PathBuf;

/// `campaign show`.
#[derive(Debug, Args)]
pub struct CampaignShowArgs {
    /// A campaign: one file, or a folder of parts
    #[arg(value_name = "FILE.parquet or DIR")]
    pub campaign: PathBuf,
    #[command(flatten)]
    pub output: OutputFlags,
}

pub fn run(args: &CampaignShowArgs, format: Format) -> Result<u8, Failure> {
    let summary = campaign_show(&CampaignShowRequest { campaign: args.campaign.clone() })?;
    show(&summary, format, "ranges", || as_text(&summary), args.output.target())?;
    Ok(0)
}

fn as_text(s: &Summary) -> String {
    let p = &s.provenance;
    let of = |n: u64, all: u64| if n == all { n.to_string() } else { format!("{n} of {all}") };
    let mut head = vec![
        ("muscles", of(s.muscles, p.muscles)),
        ("points", format!("{} ({} a muscle)", of(s.points, p.points()), p.points_per_muscle)),
        ("answered", s.answered.to_string()),
    ];
    let failed: Vec<(String, String)> =
        s.failed.iter().map(|(status, f)| (status.to_string(), f.points.to_string())).collect();
    head.extend(failed.iter().map(|(status, points)| (status.as_str(), points.clone())));
    head.extend([
        ("size", format!("{} kB", number(1e-3 * s.bytes as f64, 3))),
        ("model", p.model.clone()),
        (
            "sampling",
            p.seed.map_or_else(|| p.sampling.clone(), |seed| format!("{}, seed {seed}", p.sampling)),
        ),
        ("made by", format!("mckibben {}", p.version)),
        ("plan sha256", p.plan_sha256.clone()),
    ]);
    let mut out = pairs(&head);
    let rows = s.ranges.iter().map(|r| vec![r.name.clone(), number(r.smallest, 6), number(r.largest, 6)]);
    out.push_str(&format!("\n{}", table(&["", "smallest", "largest"], rows.collect())));
    for (status, f) in &s.failed {
        out.push_str(&format!("\nThe first {status} is of muscle {}: {}\n", f.first_muscle, f.first_cause));
    }
    if s.missing_parts > 0 {
        let parts = of(p.parts() - s.missing_parts, p.parts());
        out.push_str(&format!(
            "\nIncomplete: {parts} parts are present; run the campaign again to continue.\n"
        ));
    }
    for damaged in &s.damaged {
        out.push_str(&format!("Damaged: {damaged}\n"));
    }
    out
}
