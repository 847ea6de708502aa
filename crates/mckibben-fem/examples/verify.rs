//! The table of exact cases: `cargo run --release -p mckibben-fem --example verify`.

use mckibben::progress::Silent;
use mckibben_fem::verification::cases;

fn main() {
    let Ok(rows) = cases(&Silent) else { return };
    for r in &rows {
        println!(
            "{} {:<80} {:>18.10} {:>18.10} {:>10.2e} ({:.0e})  {}",
            if r.ok { "ok  " } else { "FAIL" },
            r.name,
            r.reference,
            r.ours.unwrap_or(f64::NAN),
            r.error.unwrap_or(f64::NAN),
            r.tolerance,
            r.source
        );
    }
    println!("{} of {} hold", rows.iter().filter(|r| r.ok).count(), rows.len());
}
