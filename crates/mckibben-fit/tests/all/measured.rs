//! The measured muscles and rubbers that the crate carries are those of the repository.

use mckibben::analysis::force_on;
use mckibben::model::{ForceModel, ModelError, Workspace};
use mckibben::muscle::{Direction, Muscle};
use mckibben::uncertainty::uncertainty;
use mckibben_fem::axisymmetric::MeshSpec;
use mckibben_fem::elements::Elements;
use mckibben_fit::identify::{Request, identify};
use mckibben_fit::least_squares::Loss;
use mckibben_fit::validation::case::{built_in, muscles};
use std::path::Path;

fn elements(muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
    Ok(Elements::Axisymmetric(MeshSpec::default()).build(muscle)?)
}

#[test]
fn the_crates_copies_are_the_files_in_data() {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    for (name, original) in [
        ("tondu2012", "tondu2012/static_force_20deg"),
        ("dmsp-20-300", "martens_boblan_2017/DMSP-20-300"),
        ("dmsp-10-250", "martens_boblan_2017/DMSP-10-250"),
        ("dmsp-10-hose", "festo_dmsp10/force_map"),
        ("rubber-treloar", "treloar/tension"),
        ("rubber-kawabata", "rubber_biaxial/kawabata_1981"),
        ("rubber-jones", "rubber_biaxial/jones_1975"),
        ("rubber-james", "rubber_biaxial/james_1975"),
        ("rubber-kawamura", "rubber_biaxial/kawamura_2001"),
        ("rubber-meunier", "rubber_biaxial/meunier_2008"),
        ("rubber-dragon-skin-30", "silicones/dragon_skin_30"),
        ("rubber-ecoflex-00-50", "silicones/ecoflex_00-50"),
        ("rubber-mold-star-20t", "silicones/mold_star_20t"),
        ("rubber-rtv615", "silicones/rtv615"),
        ("rubber-soloplast-150318", "silicones/soloplast_150318"),
        ("rubber-hnbr50", "hnbr50/stepwise_relaxation"),
    ] {
        let original = std::fs::read_to_string(repository.join(format!("{original}.csv"))).unwrap();
        assert!(built_in().iter().any(|f| f.name == name && f.points == original), "{name}");
    }
}

/// The share of measured single branches that the ± holds of a muscle whose friction was identified from both: with no branch asked for, and on
/// the branch of each point. Of Tondu's 20° muscle the loops are ± 37 N.
#[test]
fn the_uncertainty_holds_single_branches_of_muscles_that_state_their_friction() {
    for (name, fit) in [
        ("tondu2012", "Gent, friction; both branches"),
        ("dmsp-10-hose", "modulus, angle, slip, friction; both branches"),
    ] {
        let set = muscles().unwrap().into_iter().find(|c| c.facts.name == name).unwrap();
        let fit = set.fits.iter().find(|f| f.name == fit).unwrap();
        let branch = |p: &&mckibben_fit::measured::DataPoint| !p.at.branch.is_mean();
        // Every third: quick, and of all pressures and contractions.
        let points: Vec<_> = set.points.iter().filter(branch).step_by(3).copied().collect();
        let request = Request {
            muscle: &fit.muscle,
            free: &fit.free,
            fixed: &[],
            points: &points,
            loss: Loss::Squares,
            two_sided: false,
        };
        let found = identify(&request, elements).unwrap();
        assert!(found.muscle.friction().is_some());
        let (mut held, mut judged) = ([0, 0], 0);
        let mut models: Vec<(mckibben_fit::measured::Section, _, Workspace)> = vec![];
        for p in &points {
            if !models.iter().any(|m| m.0 == p.section) {
                let muscle = found.candidate.of_section(&p.section).unwrap();
                models.push((p.section, elements(&muscle).unwrap(), Workspace::new()));
            }
            let (_, model, w) = models.iter_mut().find(|m| m.0 == p.section).unwrap();
            let at = (p.at.pressure_mpa, p.at.contraction);
            judged += 1;
            for (held, direction) in held.iter_mut().zip([Direction::Mean, p.at.branch]) {
                let force_n = force_on(&**model, w, at.0, at.1, direction).unwrap();
                let half = uncertainty(&**model, w, at, force_n, direction).unwrap().total();
                *held += usize::from((p.at.force_n - force_n.max(0.0)).abs() <= half);
            }
        }
        let shares = held.map(|h| h as f64 / f64::from(judged));
        println!("{name}: {shares:?} of {judged}");
        assert!(shares.iter().all(|s| *s >= 0.94), "{name}: {shares:?} of {judged}");
    }
}

#[test]
fn explore() {
    use mckibben::progress::Silent;
    use mckibben_fit::validation::held_out::*;
    let thick = |m: &Muscle| -> Result<Box<dyn ForceModel>, ModelError> {
        Ok(Box::new(mckibben::model::ThickWall::new(m)))
    };
    let slow = std::env::var("SLOW").is_ok();
    for set in muscles().unwrap() {
        for (k, fit) in set.fits.iter().filter(|f| f.split.is_none()).enumerate() {
            for which in ["fe", "thick"] {
                if which == "fe" && !slow && k > 0 && !fit.both_branches {
                    continue;
                }
                if which == "fe" && fit.name.contains("slip") {
                    continue;
                }
                let t = std::time::Instant::now();
                let points = points_of(set, fit);
                let judge = |a: &[mckibben_fit::measured::DataPoint],
                             b: &[mckibben_fit::measured::DataPoint]| {
                    if which == "fe" {
                        judged(fit, a, b, &elements, &Silent)
                    } else {
                        judged(fit, a, b, &thick, &Silent)
                    }
                };
                let mut all = vec![];
                for part in 0..5 {
                    let of = |wanted: bool| -> Vec<_> {
                        points
                            .iter()
                            .enumerate()
                            .filter(|(i, _)| (i % 5 == part) == wanted)
                            .map(|(_, p)| *p)
                            .collect()
                    };
                    match judge(&of(false), &of(true)) {
                        Ok(r) => all.extend(r),
                        Err(e) => println!("  {e}"),
                    }
                }
                let stats = |all: &[HeldOut]| {
                    let rms = (all.iter().map(|h| h.left_n * h.left_n).sum::<f64>()
                        / all.len().max(1) as f64)
                        .sqrt();
                    let mean = all.iter().map(|h| h.half_width_n).sum::<f64>() / all.len().max(1) as f64;
                    let mut left: Vec<f64> = all.iter().map(|h| h.left_n.abs()).collect();
                    left.sort_by(f64::total_cmp);
                    let q = left.get((0.95 * left.len() as f64) as usize).copied().unwrap_or(0.0);
                    let top = all.iter().map(|h| h.blocked_n).fold(0.0, f64::max);
                    format!(
                        "{} points, share {:.3}, rms {rms:.1} N, mean ± {mean:.1}, 95 % of |left| {q:.1}; of largest F0 {top:.0}: ± {:.3}, 95 % {:.3}",
                        all.len(),
                        share(all).unwrap_or(0.0),
                        mean / top,
                        q / top
                    )
                };
                println!(
                    "{} | {} | {which}: of {} | {}; {:.1} s",
                    set.facts.name,
                    fit.name,
                    points.len(),
                    stats(&all),
                    t.elapsed().as_secs_f64()
                );
                // Ten points at two pressures.
                let mut own: Vec<_> = points.clone();
                let main = fit.muscle.length_mm();
                own.retain(|p| p.section.length_mm.is_none_or(|l| (l - main).abs() < 1e-6));
                let top = own.iter().map(|p| p.at.pressure_mpa).fold(0.0, f64::max);
                let chosen = |p: f64, count: usize| {
                    let mut l: Vec<_> =
                        own.iter().filter(|q| (q.at.pressure_mpa / p - 1.0).abs() < 0.08).copied().collect();
                    l.sort_by(|a, b| a.at.contraction.total_cmp(&b.at.contraction));
                    let n = l.len();
                    (0..count.min(n))
                        .map(|i| l[if count > 1 { i * (n - 1) / (count.min(n) - 1).max(1) } else { 0 }])
                        .collect::<Vec<_>>()
                };
                let mut ten = chosen(top, 5);
                ten.extend(chosen(0.4 * top, 5));
                let rest: Vec<_> = own
                    .iter()
                    .filter(|p| !ten.iter().any(|q| q.line == p.line && q.at == p.at))
                    .copied()
                    .collect();
                match judge(&ten, &rest) {
                    Ok(r) => println!("    ten ({}): {}", ten.len(), stats(&r)),
                    Err(e) => println!("    ten: {e}"),
                }
            }
        }
    }
}
