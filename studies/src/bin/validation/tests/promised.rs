//! What a measurement was promised to leave of a ±, beside what it left when it was made: measured
//! muscles, each by the families to which it does not belong.

use super::muscles;
use crate::{
    elements,
    families::{Series, experience, known, prior_of, series},
    left_out_families::{after, judged},
};
use mckibben_core::{
    built::{Experience, Measurement, Predictor, Prior},
    by_number::ByNumber,
    extremes::peak,
    muscle::Direction,
};
use mckibben_fit::measured::DataPoint;

/// The measured point nearest to a state, if there is one so near that it can stand for it.
fn nearest<'a>(
    points: impl Iterator<Item = &'a DataPoint>,
    pressure_mpa: f64,
    contraction: f64,
) -> Option<&'a DataPoint> {
    const NEAR: f64 = 0.06;
    let away = |p: &DataPoint| {
        let by_pressure = (p.at.pressure_mpa - pressure_mpa) / pressure_mpa;
        by_pressure.abs() + (p.at.contraction - contraction).abs()
    };
    points.min_by_number(|p| away(p)).filter(|p| away(p) < NEAR)
}

/// The points that a measurement for a pull would have given; none where they were not measured.
fn points_of(
    measurement: Measurement,
    job: &DataPoint,
    series: &Series,
    predictor: &Predictor,
) -> Vec<DataPoint> {
    let p = job.at.pressure_mpa;
    let points = || series.points.iter();
    match measurement {
        Measurement::HungLoad => vec![*job],
        Measurement::OnePull => {
            let own = points().filter(|p| p.at.branch == job.at.branch);
            Vec::from_iter(nearest(own, p, 0.05).copied())
        }
        Measurement::TenPulls => {
            let free = predictor.free_contraction(p);
            let mut list: Vec<DataPoint> = vec![];
            for i in 0..10 {
                let pressure_mpa = if i < 5 { p } else { 0.5 * p };
                let contraction = 0.03 + (0.8 * free - 0.03) * f64::from(i % 5) / 4.0;
                let other = [Direction::Elongation, Direction::Contraction][i as usize % 2];
                let own = points().filter(|p| p.at.branch != Some(other));
                let point = nearest(own, pressure_mpa, contraction);
                list.extend(point.filter(|p| !list.contains(p)));
            }
            if list.len() < 8 { vec![] } else { list }
        }
        _ => vec![],
    }
}

/// For each measurement that was made: the ± of a pull afterwards over that which was promised.
fn kept(
    series: &Series,
    job: &DataPoint,
    known_before: (&Experience, &Prior),
) -> Vec<(Measurement, f64)> {
    let (_, prior) = known_before;
    let predictor = Predictor::about(&series.muscle, prior.centre, prior.covariance()).unwrap();
    let highest_mpa = peak(series.points.iter().map(|p| p.at.pressure_mpa));
    let largest_n = predictor.at(highest_mpa, 0.0, 0.0).unwrap().force_n;
    let (p, e) = (job.at.pressure_mpa, job.at.contraction);
    let mut out = vec![];
    for promised in predictor.measurements(p, e, job.at.direction().sign()) {
        let points = points_of(promised.measurement, job, series, &predictor);
        if !points.is_empty() {
            let (muscle, predictor) = after(series, &points, known_before, &elements).unwrap();
            let left = judged(series, &muscle, &predictor, &[*job], &elements).unwrap()[0];
            let ratio = left.half * largest_n / promised.uncertainty_n;
            out.push((promised.measurement, ratio));
        }
    }
    out
}

/// Each of three measurements leaves what was promised within 25 % in the median of all muscles and
/// pulls that were measured.
#[test]
fn identity_a_measurement_leaves_of_the_interval_what_was_promised() {
    const JOBS: usize = 3;
    let all = series(&muscles());
    let known = known(&all, &elements);
    let mut rows = vec![];
    for series in &all {
        let others: Vec<_> = known
            .iter()
            .filter(|k| k.series.family != series.family)
            .collect();
        let experience = experience(&others);
        let prior = prior_of(series, &experience);
        let largest_n = peak(series.points.iter().map(|p| p.at.force_n));
        let jobs: Vec<&DataPoint> = series
            .points
            .iter()
            .filter(|p| p.at.contraction >= 0.03 && p.at.force_n > 0.1 * largest_n)
            .collect();
        for job in jobs.iter().step_by(jobs.len().div_ceil(JOBS).max(1)) {
            rows.extend(kept(series, job, (&experience, &prior)));
        }
    }
    for (measurement, least) in [
        (Measurement::TenPulls, 6),
        (Measurement::HungLoad, 30),
        (Measurement::OnePull, 25),
    ] {
        let list = rows.iter().filter(|r| r.0 == measurement).map(|r| r.1);
        let mut list: Vec<f64> = list.collect();
        list.sort_by(f64::total_cmp);
        let ratio = list[list.len() / 2];
        assert!(list.len() >= least, "{measurement:?}: {} pulls", list.len());
        assert!(
            (ratio - 1.0).abs() < 0.25,
            "{measurement:?}: {ratio} of {list:?}"
        );
    }
}
