use mckibben_fem::axisymmetric::sweep::sweep;
fn main() {
    for seed in [1, 2] {
    let mut rows = sweep(2000, seed).rows;
    for req in [true, false] {
        let mut f: Vec<usize> = rows.iter().filter(|r| r.required == req).map(|r| r.factorisations).collect();
        f.sort();
        println!("req {req}: median {} p90 {} p95 {} p99 {} max {} mean {:.1} ok {}", f[f.len() / 2], f[f.len() * 9 / 10], f[f.len() * 95 / 100], f[f.len() * 99 / 100], f[f.len() - 1], f.iter().sum::<usize>() as f64 / f.len() as f64, rows.iter().filter(|r| r.required == req && r.answer.is_ok()).count());
    }
    rows.sort_by(|a, b| b.factorisations.cmp(&a.factorisations));
    if std::env::args().nth(1).is_some() {
    for r in rows.iter().filter(|r| r.required).take(12) {
        println!("{} its {} req {} stable {} {} e {:.3} e/emax {:.2} P/mu {:.3} s/D {:.3} L/D {:.1} th {:.1} k/D {:?} endless {:?} {:?}", r.seconds * 1e6, r.factorisations, r.required, r.stable, mckibben::rubber::RubberLaw::name(&r.case.muscle.tube().rubber.law), r.case.contraction, r.case.contraction / r.case.muscle.max_ideal_contraction(), r.case.pressure_mpa / mckibben::rubber::RubberLaw::shear_modulus_mpa(&r.case.muscle.tube().rubber.law), r.case.muscle.wall_mm() / r.case.muscle.outer_diameter_mm(), r.case.muscle.length_mm() / r.case.muscle.outer_diameter_mm(), r.case.muscle.braid().angle_deg, r.case.muscle.family_stiffness_n_per_mm().map(|k| k / r.case.muscle.outer_diameter_mm()), r.endless_n, r.answer.as_ref().map_err(|e| e.split("found").last().unwrap().chars().skip(20).take(110).collect::<String>()));
    } }
    }
}
