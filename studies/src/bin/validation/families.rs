//! What families of measured muscles tell of one that nobody measured.
//!
//! A family is what one maker, or one workshop, made; a series of it is one muscle of one length. The
//! points of a series tell of its constants beside a wide prior ([`known`]); what the families tell
//! together is a population (`population.rs`).

use crate::{
    case::MuscleCase,
    fit::posterior,
    population::{Population, Told},
};
use mckibben_core::{
    built::{Belief, Experience, Prior},
    muscle::{Constant, Constants, EndsMade, Muscle},
    threads,
};
use mckibben_fit::{
    identify::{Build, Posterior, Section},
    measured::DataPoint,
};
use nalgebra::{SMatrix, SVector};
use std::f64::consts::SQRT_2;

/// One measured muscle of one length.
pub struct Series {
    pub family: String,
    pub name: String,
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
                muscle,
                angle_deviation_deg: set.facts.angle_deviation_deg,
                points: own.copied().collect(),
            });
        }
    }
    out
}

/// The prior of a measured muscle whose rubber nobody stated.
pub fn prior_of(series: &Series, experience: &Experience) -> Prior {
    let mut prior = Prior::of(&series.muscle, experience);
    let angle = &mut prior.deviation[Constant::Angle as usize];
    *angle = series.angle_deviation_deg.unwrap_or(*angle);
    prior.deviation[Constant::Modulus as usize] = GUESSED_RUBBER;
    prior
}

/// A series with what all of its points tell.
pub struct Known<'a> {
    pub series: &'a Series,
    /// What its points tell.
    told: Told,
}

/// The constants of every series, with a wide prior.
pub fn known<'a>(all: &'a [Series], build: &Build<'_>) -> Vec<Known<'a>> {
    let wide = without_families();
    let one = |series: &&'a Series| {
        let mut prior = prior_of(series, &wide);
        prior.deviation[Constant::Friction as usize] *= 2.0;
        let before = (&wide, &prior);
        let posterior = posterior(&series.muscle, &series.points, before, build)?;
        Some(Known {
            series,
            told: told(&posterior),
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
        variance_factor,
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
    // Points that are noisier than is assumed tell less.
    Told {
        precision: precision / *variance_factor,
        weighted: weighted / *variance_factor,
    }
}

/// What one would say of each constant without any measured muscle: m0 and s0, a judgement. Ends that
/// are crimped give way less than those that are clamped by hand.
fn without_families() -> Experience {
    let belief = |centre, deviation| Belief { centre, deviation };
    Experience {
        pull_factor: belief(0.0, 0.055),
        seating: belief(0.05, 0.035),
        compliance_crimped: belief(0.02, 0.02),
        compliance_clamped: belief(0.04, 0.02),
        compliance_unknown: belief(0.03, 0.02),
        take_up: belief(0.02, 0.014),
        modulus: belief(0.0, 0.2),
        friction: belief(0.08, 0.04),
        friction_in_rubber: belief(0.02, 0.02),
        specimen: [
            0.055,
            0.035,
            0.02,
            0.014,
            0.2,
            ANGLE_OF_SPECIMENS_DEG,
            0.1,
            0.02,
        ],
        length: [0.04, 0.03, 0.02, 0.014, 0.2, 0.0, 0.0, 0.0],
    }
}

/// Standard deviation of the angle between specimens of a product.
const ANGLE_OF_SPECIMENS_DEG: f64 = 0.4;
/// Standard deviation of ln of the modulus of a rubber that is guessed.
const GUESSED_RUBBER: f64 = 0.35;

/// Another specimen of a product is made by another family, of the same rubber and braid.
fn specimen(population: &Population, wide: &Experience) -> Constants {
    Constant::ALL.map(|constant| {
        let i = constant as usize;
        match constant {
            Constant::PullFactor | Constant::Seating | Constant::Compliance | Constant::TakeUp => {
                population.families[i].hypot(population.series[i])
            }
            Constant::Modulus => SQRT_2 * population.series[i],
            _ => wide.specimen[i],
        }
    })
}

/// What some series tell of a muscle that nobody measured.
pub fn experience(known: &[&Known<'_>]) -> Experience {
    let wide = without_families();
    // One population for all; c and η have a centre for each way in which muscles are made.
    let by = |made: Belief, friction: Belief, keep: &dyn Fn(&Muscle) -> bool| {
        let beliefs = [
            wide.pull_factor,
            wide.seating,
            made,
            wide.take_up,
            Belief {
                centre: 0.0,
                deviation: GUESSED_RUBBER,
            },
            Belief {
                centre: 0.0,
                deviation: 0.8,
            },
            Belief {
                centre: 0.0,
                deviation: 0.1,
            },
            friction,
        ];
        let without = Population {
            centre: beliefs.map(|b| b.centre),
            families: beliefs.map(|b| b.deviation),
            series: wide.length,
            count: 0,
        };
        let mut families: Vec<(&str, Vec<&Told>)> = vec![];
        for one in known.iter().filter(|k| keep(&k.series.muscle)) {
            let name = one.series.family.as_str();
            match families.iter_mut().find(|f| f.0 == name) {
                Some(family) => family.1.push(&one.told),
                None => families.push((name, vec![&one.told])),
            }
        }
        let families: Vec<Vec<&Told>> = families.into_iter().map(|f| f.1).collect();
        Population::of(&families, &without)
    };
    let made = |made: EndsMade| move |m: &Muscle| m.terminals().made == Some(made);
    let all = by(wide.compliance_unknown, wide.friction, &|_| true);
    let of = |population: &Population, constant: Constant| Belief {
        centre: population.centre[constant as usize],
        deviation: population.deviation()[constant as usize],
    };
    let crimped = by(
        wide.compliance_crimped,
        wide.friction,
        &made(EndsMade::Crimped),
    );
    let clamped = by(
        wide.compliance_clamped,
        wide.friction,
        &made(EndsMade::Clamped),
    );
    let bare = by(wide.compliance_unknown, wide.friction, &|m| {
        !m.braid().in_rubber
    });
    let hoses = by(wide.compliance_unknown, wide.friction_in_rubber, &|m| {
        m.braid().in_rubber
    });
    Experience {
        pull_factor: of(&all, Constant::PullFactor),
        seating: of(&all, Constant::Seating),
        compliance_crimped: of(&crimped, Constant::Compliance),
        compliance_clamped: of(&clamped, Constant::Compliance),
        compliance_unknown: of(&all, Constant::Compliance),
        take_up: of(&all, Constant::TakeUp),
        friction: of(&bare, Constant::Friction),
        friction_in_rubber: of(&hoses, Constant::Friction),
        modulus: wide.modulus,
        specimen: specimen(&all, &wide),
        length: Constant::ALL.map(|c| match c {
            // The angle, strands and friction of a hose do not change where it is cut.
            Constant::Angle | Constant::Strands | Constant::Friction => 0.0,
            _ => all.series[c as usize],
        }),
    }
}
