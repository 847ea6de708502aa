//! `campaign show`.

use crate::{Asked, Failure, listed, pairs, shown, tabled, value};
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
    let u = shown::units();
    let keys = "muscles points points_wanted points_per_muscle answered failed model sampling seed version=mckibben plan_sha256";
    let mut out = pairs(&listed(&value(s), keys, &u)) + "\n";
    out += &tabled(&s.ranges, "name=_ smallest:6~ largest:6~", &u);
    for (status, f) in &s.failed {
        out.push_str(&format!("\nThe first {status} is of muscle {}: {}\n", f.first_muscle, f.first_cause));
    }
    if s.missing_parts > 0 {
        let all = s.provenance.parts();
        out.push_str(&format!(
            "\nIncomplete: {} of {all} parts are present; run the campaign again to continue.\n",
            all - s.missing_parts
        ));
    }
    for damaged in &s.damaged {
        out.push_str(&format!("Damaged: {damaged}\n"));
    }
    out
}
