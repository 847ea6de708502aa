//! `campaign show`.

use crate::asked::Asked;
use crate::failure::Failure;
use crate::output::text::{number, pairs, table};
use mckibben_app::campaign_show;
use mckibben_campaign::campaign::Summary;

pub const SHOW: &str =
    "campaign show: Summary of a campaign: muscles, points, failures by cause, ranges, origin
:campaign<FILE.parquet_or_DIR>! | A campaign: one file, or a folder of parts
@output
Example:
  mckibben campaign plans/paper.toml -o campaign.parquet
  mckibben campaign show campaign.parquet";

pub fn show(asked: &Asked) -> Result<u8, Failure> {
    let summary = campaign_show(&asked.request()?)?;
    asked.show(&summary, "ranges", || as_text(&summary))
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
