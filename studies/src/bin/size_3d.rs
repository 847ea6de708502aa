//! Time and memory of one Newton iteration of the three-dimensional muscle against the size of its mesh, the exponents,
//! and how far the factorisation is from what the processor can do.
//!
//! `cargo study size_3d` goes up to 310 000 unknowns and takes two minutes.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};
use mckibben::muscle::Muscle;
use mckibben_fem::three_dimensional::{Body, Brick, BrickMesh, BrickSpec, Discretisation, Problem};
use std::error::Error;
use std::time::Instant;

/// Time in s: that of this thread on the processor, where the system tells it, so that other work on the machine counts little.
fn clock(start: Instant) -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let spent = text.and_then(|t| t.split_whitespace().next()?.parse::<f64>().ok());
    spent.map_or_else(|| start.elapsed().as_secs_f64(), |nanoseconds| 1e-9 * nanoseconds)
}

/// Mean time in s of as many runs as take 0.2 s: the processor's clock may count in ticks of 4 ms.
fn mean<E>(mut work: impl FnMut() -> Result<(), E>) -> Result<f64, E> {
    work()?;
    let begin = Instant::now();
    let (start, mut runs) = (clock(begin), 0);
    loop {
        work()?;
        runs += 1;
        let spent = clock(begin) - start;
        if spent > 0.2 || begin.elapsed().as_secs_f64() > 10.0 {
            return Ok(spent / f64::from(runs));
        }
    }
}

/// Floating-point operations a second of a product of large matrices on one thread.
fn peak() -> f64 {
    const N: usize = 1200;
    let a = Mat::<f64>::from_fn(N, N, |i, j| ((i * 7 + j) % 13) as f64);
    let mut c = Mat::<f64>::zeros(N, N);
    let seconds = mean(|| {
        matmul(c.as_mut(), Accum::Replace, a.as_ref(), a.as_ref(), 1.0, Par::Seq);
        Ok::<(), ()>(())
    });
    2.0 * (N as f64).powi(3) / seconds.unwrap_or(f64::INFINITY)
}

/// Resident memory in MB, where the system tells it.
fn memory() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find(|l| l.starts_with("VmRSS:"))?;
    Some(line.split_whitespace().nth(1)?.parse::<f64>().ok()? / 1024.0)
}

fn main() -> Result<(), Box<dyn Error>> {
    let muscle = Muscle::prototype();
    let peak = peak();
    println!("processor time of one thread; matrix product: {:.1} GFlop/s\n", peak * 1e-9);
    println!("brick  mesh          unknowns  assembly  factorise  solve      GFlop  of peak  memory  setup");
    for (brick, meshes) in [
        (Brick::Linear, &[[1, 8], [2, 12], [2, 24], [3, 30], [3, 48], [4, 72], [4, 80]][..]),
        (Brick::Quadratic, &[[1, 4], [1, 8], [1, 16], [1, 32]][..]),
    ] {
        let mut rows: Vec<[f64; 3]> = vec![];
        for &[through, around] in meshes {
            let start = Instant::now();
            let spec =
                BrickSpec { brick, through: Some(through), around: Some(around), ..BrickSpec::default() };
            let mesh = BrickMesh::new(12.0, 15.0, 142.5, muscle.braid().angle_rad(), &spec)?;
            let mut body = Body::new(Discretisation::new(Problem::of(&muscle, &mesh))?)?;
            let setup = start.elapsed().as_secs_f64();
            body.state.pressure = 0.01;
            let assembly = mean(|| body.assemble().map(|_| ()))?;
            let factorise = mean(|| body.factorise_assembled())?;
            let solve = mean(|| {
                body.force_per_pressure();
                Ok::<(), ()>(())
            });
            let n = body.discretisation.free as f64;
            let [a, b, c] = mesh.elements();
            println!(
                "{:<6} {:<13} {:>8} {:>7.1} ms {:>7.1} ms {:>6.1} ms {:>8.2} {:>6.0} % {:>5.0} MB {:>5.0} ms",
                if brick == Brick::Linear { "8" } else { "27" },
                format!("{a}x{b}x{c}"),
                n,
                1e3 * assembly,
                1e3 * factorise,
                1e3 * solve.unwrap_or(0.0),
                1e-9 * body.cholesky().operations(),
                100.0 * body.cholesky().operations() / factorise / peak,
                memory().unwrap_or(f64::NAN),
                1e3 * setup
            );
            rows.push([n, assembly, factorise]);
        }
        // Slopes of the last three.
        if let [.., first, _, last] = rows.as_slice() {
            let slope = |i: usize| (last[i] / first[i]).ln() / (last[0] / first[0]).ln();
            println!("       exponents: assembly {:.2}, factorisation {:.2}\n", slope(1), slope(2));
        }
    }
    Ok(())
}
