//! Campaigns as people read them.

use crate::{
    Units,
    print::{Csv, Page, Rows, Show, Table},
    units::NUMBER,
    words::{in_a_row, number, path_on_one_line},
};
use humantime::format_duration;
use mckibben_campaign::campaign::{
    CampaignStatus, Forecast, Merged, ShardState, ShardStatus, Summary, Warned,
};
use std::time::Duration;

/// How often each warning stands.
fn table_of(warnings: &[Warned]) -> Table<'_, Warned> {
    Table::of(warnings)
        .text("", |w| &w.name)
        .text("muscles", |w| w.muscles)
        .text("points", |w| w.points)
        .text("not known", |w| w.points_unknown)
}

/// A time as people read it, to a second.
fn duration(seconds: f64) -> String {
    format_duration(Duration::from_secs(seconds as u64 + 1)).to_string()
}

impl Show for Forecast {
    fn page(&self, _: &Units) -> Page {
        let megabytes = number(self.bytes as f64 / 1e6, 2);
        let time = duration(self.time_s);
        let mut rows = Rows::default()
            .text("shard", self.shard.as_ref())
            .text("muscles", self.muscles)
            .text("points per muscle", self.points_per_muscle)
            .text("points", self.points)
            .text("time", format!("{time} with {} threads", self.threads))
            .text("size", format!("{megabytes} MB"))
            .text("from so many muscles", self.muscles_tried)
            .text("of their points failed", self.points_failed);
        for rubber in &self.rubbers {
            let constant = |(name, value): (&String, &f64)| format!("{name} {}", number(*value, 4));
            let constants = in_a_row(rubber.constants.iter().map(constant));
            let name = rubber.name.as_deref().unwrap_or("without a name");
            rows = rows.text("rubber", format!("{name}: {} ({constants})", rubber.law));
        }
        let mut page = Page::from(rows);
        let (checked, impossible) = (self.muscles_checked, self.muscles_impossible);
        page.paragraph(format!(
            "Warnings at the highest pressure, by the thick-wall model of {checked} muscles, of \
             which {impossible} have impossible sizes:"
        ));
        page.table(table_of(&self.warnings));
        page
    }
}

impl Show for Summary {
    fn page(&self, _: &Units) -> Page {
        let of = &self.provenance;
        let failed = self.failed.iter();
        let failed = failed.map(|(status, f)| format!("{status} {}", f.points));
        let mut page = Page::from(
            Rows::default()
                .text("muscles", self.muscles)
                .text("points", self.points)
                .text("points wanted", self.points_wanted)
                .text("points per muscle", of.points_per_muscle)
                .text("answered", self.answered)
                .text("failed", in_a_row(failed))
                .text("model", &of.model)
                .text("sampling", &of.sampling)
                .text("seed", of.seed)
                .text("mckibben", &of.version)
                .text("plan sha256", &of.plan_sha256),
        );
        page.gap();
        let value = NUMBER.digits(6);
        page.table(
            Table::of(&self.ranges)
                .text("", |r| &r.name)
                .unaligned("smallest", &value, |r| r.smallest)
                .unaligned("largest", &value, |r| r.largest),
        );
        page.gap();
        page.table(table_of(&self.warnings));
        for (status, f) in &self.failed {
            let muscle = f.first_muscle;
            let cause = &f.first_cause;
            page.paragraph(format!("The first {status} is of muscle {muscle}: {cause}"));
        }
        if self.missing_parts > 0 {
            let all = of.parts();
            let present = all - self.missing_parts;
            page.paragraph(format!(
                "Incomplete: {present} of {all} parts are present; run the campaign again to \
                 continue."
            ));
        }
        page.lines(self.damaged.iter().map(|file| format!("Damaged: {file}")));
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(&self.ranges)
    }
}

impl Show for Merged {
    fn page(&self, _: &Units) -> Page {
        let points = self.points;
        let muscles = self.muscles;
        let out = path_on_one_line(&self.output);
        let mut page = Page::default();
        page.line(format!("{points} points of {muscles} muscles are in {out}"));
        page
    }
}

impl Show for CampaignStatus {
    fn page(&self, _: &Units) -> Page {
        let parts = self.parts;
        let wanted = self.parts_wanted;
        let out = path_on_one_line(&self.output);
        let mut page = Page::default();
        page.line(format!("{parts} of {wanted} parts are in {out}"));
        page.rows(
            Rows::default()
                .text("shards", self.shards_wanted)
                .text("done", self.shards_done)
                .text("running", self.shards_running)
                .text("missing", self.shards_missing)
                .text(
                    "points a second",
                    self.points_per_s.map(|rate| number(rate, 3)),
                )
                .text("left", self.left_s.map(duration)),
        );
        let open = self.shards.iter().filter(|s| s.state != ShardState::Done);
        let open: Vec<&ShardStatus> = open.collect();
        if !open.is_empty() {
            page.gap();
        }
        page.table(
            Table::of(&open)
                .text("shard", |s| &s.shard)
                .text("state", |s| s.state.to_string())
                .text("parts", |s| s.parts)
                .text("of", |s| s.parts_wanted),
        );
        let damaged = self.damaged.iter();
        page.lines(
            damaged.map(|part| format!("Damaged, or of another plan: {}", path_on_one_line(part))),
        );
        if self.shards_missing > 0 {
            page.paragraph("Something is missing that nothing computes: run the shards again.");
        }
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(&self.shards)
    }
}
