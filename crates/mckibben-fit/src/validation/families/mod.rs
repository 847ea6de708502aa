//! What families of measured muscles tell of one that nobody measured (`experience`), and what the ±
//! covers where a whole family is left out (`left_out`).
//!
//! A family is what one maker, or one workshop, made; a series of it is one muscle of one length.
//! The points of a series tell of its constants beside a wide prior ([`known`]); what the families
//! tell together is a population (`validation::population`).

mod experience;
mod left_out;
#[cfg(test)]
mod promised;

pub use experience::experience;
pub use left_out::left_out;

use super::{case::MuscleCase, population::Told, residual::Fitter};
use crate::{
    identify::{Posterior, PosteriorRequest},
    measured::{DataPoint, Section},
};
use experience::{GUESSED_RUBBER, without_families};
use mckibben_core::{
    built::{Experience, Prior},
    muscle::{Constant, Muscle},
    threads,
};
use nalgebra::{SMatrix, SVector};

/// One measured muscle of one length.
pub struct Series {
    pub family: String,
    pub name: String,
    pub source: String,
    pub muscle: Muscle,
    pub angle_deviation_deg: Option<f64>,
    pub points: Vec<DataPoint>,
}

/// The series of the measured muscles that belong to a family.
pub fn series(sets: &[&MuscleCase]) -> Vec<Series> {
    let mut out = vec![];
    for set in sets {
        let (Some(family), Some(fit)) = (&set.facts.family, set.fits.first()) else {
            continue;
        };
        let mut sections: Vec<Section> = vec![];
        for point in &set.points {
            if !sections.contains(&point.section) {
                sections.push(point.section);
            }
        }
        for section in sections {
            let Ok(muscle) = section.apply(&fit.muscle) else {
                continue;
            };
            let own = set.points.iter().filter(|p| p.section == section);
            let length = section
                .length_mm
                .map_or_else(String::new, |l| format!(", {l} mm"));
            out.push(Series {
                family: family.clone(),
                name: format!("{}{length}", set.facts.title),
                source: set.facts.source.clone(),
                muscle,
                angle_deviation_deg: set.facts.angle_deviation_deg,
                points: own.copied().collect(),
            });
        }
    }
    out
}

/// The prior of a measured muscle whose rubber nobody stated.
fn prior_of(series: &Series, experience: &Experience) -> Prior {
    let mut prior = Prior::of(&series.muscle, experience);
    let angle = &mut prior.deviation[Constant::Angle as usize];
    *angle = series.angle_deviation_deg.unwrap_or(*angle);
    prior.deviation[Constant::Modulus as usize] = GUESSED_RUBBER;
    prior
}

/// A series with the constants of all of its points.
pub struct Known<'a> {
    pub series: &'a Series,
    /// What its points tell, with a wide prior.
    pub posterior: Posterior,
    told: Told,
}

fn posterior(
    series: &Series,
    points: &[DataPoint],
    (experience, prior): (&Experience, &Prior),
    by: Fitter<'_>,
) -> Option<Posterior> {
    PosteriorRequest {
        muscle: &series.muscle,
        points,
        build: by.build,
        experience,
        prior,
        progress: by.progress,
        bounds: &[],
        search: true,
    }
    .posterior()
    .ok()
    .flatten()
}

/// The constants of every series, with a wide prior.
pub fn known<'a>(all: &'a [Series], by: Fitter<'_>) -> Vec<Known<'a>> {
    let wide = without_families();
    let one = |series: &&'a Series| {
        let mut prior = prior_of(series, &wide);
        prior.deviation[Constant::Friction as usize] *= 2.0;
        let posterior = posterior(series, &series.points, (&wide, &prior), by)?;
        Some(Known {
            series,
            told: told(&posterior),
            posterior,
        })
    };
    let list: Vec<&Series> = all.iter().collect();
    threads::map(&list, one).into_iter().flatten().collect()
}

/// What the points of a series tell beside the prior: Λ = C⁻¹ − Σ0⁻¹, Λ x̂ = C⁻¹ x − Σ0⁻¹ x0.
fn told(posterior: &Posterior) -> Told {
    let Posterior {
        constants,
        covariance,
        prior,
        ..
    } = posterior;
    const N: usize = Constant::ALL.len();
    let c = SMatrix::<f64, N, N>::from_fn(|i, k| covariance[i][k]);
    let mut precision = c.try_inverse().unwrap_or_else(SMatrix::zeros);
    let mut weighted = precision * SVector::<f64, N>::from_iterator(constants.iter().copied());
    for i in 0..N {
        let variance = prior.deviation[i].powi(2).max(1e-12);
        precision[(i, i)] -= 1.0 / variance;
        weighted[i] -= prior.centre[i] / variance;
        // A constant that no series has is told by none.
        if prior.deviation[i] == 0.0 {
            precision.row_mut(i).fill(0.0);
            precision.column_mut(i).fill(0.0);
            weighted[i] = 0.0;
        }
    }
    Told {
        precision,
        weighted,
    }
}
