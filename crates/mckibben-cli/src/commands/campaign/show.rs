//! `campaign show`.

use crate::cli::CampaignShowArgs;
use crate::failure::Failure;
use crate::flags::Format;
use crate::output::text::{number, pairs, table};
use crate::output::{csv, emit, json};
use mckibben_campaign::campaign::{self, Summary};
use serde_json::{Map, Value, json};

/// Runs the command.
pub fn run(args: &CampaignShowArgs) -> Result<u8, Failure> {
    let s = campaign::summary(&args.campaign)?;
    let text = match args.output.format {
        Format::Json => json::print(&as_json(&s)),
        Format::Csv => csv::rows(&ranges(&s))?,
        Format::Text => as_text(&s),
    };
    emit(&text, args.output.output.as_deref())?;
    Ok(0)
}

fn ranges(s: &Summary) -> Vec<Value> {
    s.ranges
        .iter()
        .map(|(name, low, high)| json!({ "name": name, "smallest": low, "largest": high }))
        .collect()
}

fn as_json(s: &Summary) -> Value {
    let p = &s.provenance;
    let failed = s.failed.iter().map(|(status, f)| {
        let value =
            json!({ "points": f.points, "first_muscle": f.first_muscle, "first_cause": f.first_cause });
        (status.clone(), value)
    });
    let failed: Map<String, Value> = failed.collect();
    json!({
        "muscles": s.muscles, "muscles_wanted": p.muscles, "points": s.points, "points_wanted": p.points(),
        "complete": s.points == p.points(), "answered": s.answered, "failed": failed, "iterations": s.iterations,
        "ranges": ranges(s), "bytes": s.bytes, "missing_parts": s.missing_parts, "damaged": s.damaged,
        "version": p.version, "model": p.model, "sampling": p.sampling, "seed": p.seed,
        "plan_sha256": p.plan_sha256, "plan": p.plan,
    })
}

fn as_text(s: &Summary) -> String {
    let p = &s.provenance;
    let of = |n: u64, all: u64| if n == all { n.to_string() } else { format!("{n} of {all}") };
    let mut head = vec![
        ("muscles", of(s.muscles, p.muscles)),
        ("points", format!("{} ({} a muscle)", of(s.points, p.points()), p.points_per_muscle)),
        ("answered", s.answered.to_string()),
    ];
    head.extend(s.failed.iter().map(|(status, f)| (status.as_str(), f.points.to_string())));
    head.extend([
        ("iterations", format!("{} a point", number(s.iterations as f64 / s.points.max(1) as f64, 3))),
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
    let rows = s.ranges.iter().map(|(n, low, high)| vec![n.clone(), number(*low, 6), number(*high, 6)]);
    out.push_str(&format!("\n{}", table(&["", "smallest", "largest"], rows.collect())));
    for (status, f) in &s.failed {
        out.push_str(&format!("\nThe first {status} is of muscle {}: {}\n", f.first_muscle, f.first_cause));
    }
    if s.missing_parts > 0 {
        let parts = of(p.parts() - s.missing_parts, p.parts());
        out.push_str(&format!("\nIncomplete: {parts} parts are there; run the campaign again to go on.\n"));
    }
    for damaged in &s.damaged {
        out.push_str(&format!("Damaged: {damaged}\n"));
    }
    out
}
