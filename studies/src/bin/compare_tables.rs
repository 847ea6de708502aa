//! How far two campaigns of the same muscles and questions are apart, in % of the second one's blocked force at the highest pressure.
//!
//! `cargo study compare_tables -- paper-3d.parquet paper.parquet`, after
//! `mckibben campaign plans/paper-3d.toml -o paper-3d.parquet` and `mckibben campaign plans/paper.toml -o paper.parquet`.

use mckibben_campaign::PointRow;
use mckibben_campaign::campaign::read;
use std::collections::BTreeMap;
use std::error::Error;

/// Differences of one kind.
#[derive(Default)]
struct Spread {
    count: usize,
    squares: f64,
    worst: f64,
    newton: f64,
}

impl Spread {
    fn add(&mut self, share: f64, force: f64) {
        self.count += 1;
        self.squares += share * share;
        self.worst = self.worst.max(share.abs());
        self.newton = self.newton.max(force.abs());
    }

    fn print(&self, what: &str) {
        let rms = (self.squares / self.count.max(1) as f64).sqrt();
        println!(
            "{what:<34} {:>7} {:>8.3} {:>8.3} {:>8.2}",
            self.count,
            100.0 * rms,
            100.0 * self.worst,
            self.newton
        );
    }
}

fn same(a: &PointRow, b: &PointRow) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs().max(1.0);
    near(a.outer_diameter_mm, b.outer_diameter_mm)
        && near(a.wall_mm, b.wall_mm)
        && near(a.pressure_mpa, b.pressure_mpa)
        && near(a.contraction, b.contraction)
}

fn main() -> Result<(), Box<dyn Error>> {
    let files: Vec<String> = std::env::args().skip(1).collect();
    let [first, second] = files.as_slice() else { return Err("wanted: two campaigns".into()) };
    let (first, second) = (read(first)?, read(second)?);
    if first.len() != second.len() || !first.iter().zip(&second).all(|(a, b)| same(a, b)) {
        return Err("the campaigns ask different questions".into());
    }
    let highest = second.iter().map(|r| r.pressure_mpa).fold(0.0, f64::max);
    let mut blocked: BTreeMap<u64, f64> = BTreeMap::new();
    for r in second.iter().filter(|r| r.contraction == 0.0 && r.pressure_mpa == highest) {
        blocked.extend(r.force_n.map(|f| (r.muscle, f)));
    }
    let (mut pulls, mut pushes, mut unanswered) = (Spread::default(), Spread::default(), [0, 0]);
    let mut walls: BTreeMap<String, Spread> = BTreeMap::new();
    let mut contractions: BTreeMap<String, Spread> = BTreeMap::new();
    for (a, b) in first.iter().zip(&second) {
        unanswered[0] += usize::from(a.force_n.is_none());
        unanswered[1] += usize::from(b.force_n.is_none());
        let (Some(fa), Some(fb), Some(whole)) = (a.force_n, b.force_n, blocked.get(&b.muscle)) else {
            continue;
        };
        let share = (fa - fb) / whole;
        if fb < 0.0 {
            pushes.add(share, fa - fb);
            continue;
        }
        pulls.add(share, fa - fb);
        walls.entry(format!("s {} mm", b.wall_mm)).or_default().add(share, fa - fb);
        contractions.entry(format!("contraction {:.2}", b.contraction)).or_default().add(share, fa - fb);
    }
    println!("{:<34} {:>7} {:>8} {:>8} {:>8}", "", "points", "rms %", "worst %", "worst N");
    pulls.print("where the second pulls");
    walls.iter().chain(&contractions).for_each(|(what, spread)| spread.print(&format!("  {what}")));
    pushes.print("where it would push");
    println!(
        "without an answer: {} of the first, {} of the second, of {} points",
        unanswered[0],
        unanswered[1],
        first.len()
    );
    Ok(())
}
