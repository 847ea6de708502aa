//! The figures of `docs/results.md`: `cargo run --release -p mckibben-campaign --example results`.

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let r = mckibben_campaign::fit::results::results()?;
    for f in &r.findings {
        let e = &f.errors;
        println!(
            "{:<100} {:>5} max {:.3} rms {:.3} (12) {:.2} N {:.1} n {} D {} s {} P {} e {}",
            f.comparison,
            f.at_most.map_or(String::new(), |v| format!("{}", 100.0 * v)),
            100.0 * e.max,
            100.0 * e.rms,
            100.0 * e.max_12,
            e.max_n,
            e.points,
            e.worst.outer_diameter_mm,
            e.worst.wall_mm,
            e.worst.pressure_mpa,
            e.worst.contraction
        );
    }
    println!("{:?} {} s, {} terms", r.constants, r.seconds, r.global_terms);
    Ok(())
}
