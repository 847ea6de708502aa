//! Work in progress.
fn main() {
    let t = std::time::Instant::now();
    for r in mckibben_fem::verification::bricks() {
        println!(
            "{} {:<90} ref {:<14} ours {:<22?} err {:<12?} tol {:e}",
            if r.ok { "ok  " } else { "FAIL" },
            r.name,
            r.reference,
            r.ours,
            r.error.map(|e| (e * 1e15).round() / 1e15),
            r.tolerance
        );
    }
    println!("{:?}", t.elapsed());
}
