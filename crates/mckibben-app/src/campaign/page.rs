//! Campaigns as people read them.

use crate::{
    Units,
    print::{Csv, Page, Rows, Show, Table},
    units::NUMBER,
    words::{in_a_row, path_on_one_line},
};
use mckibben_campaign::campaign::{CampaignStatus, Merged, ShardState, ShardStatus, Summary};

impl Show for Summary {
    fn page(&self, _: &Units) -> Page {
        let of = &self.provenance;
        let failed = self.failed.iter().map(|(status, f)| {
            let points = f.points;
            let muscle = f.first_muscle;
            let cause = &f.first_cause;
            format!("{status} points {points}, first_muscle {muscle}, first_cause {cause}")
        });
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
                .text("missing", self.shards_missing),
        );
        let open = self.shards.iter().filter(|s| s.state != ShardState::Done);
        let open: Vec<&ShardStatus> = open.collect();
        if !open.is_empty() {
            page.gap();
        }
        page.table(
            Table::of(&open)
                .text("shard", |s| &s.shard)
                .text("state", |s| match s.state {
                    ShardState::Done => "done",
                    ShardState::Running => "running",
                    ShardState::Missing => "missing",
                })
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
