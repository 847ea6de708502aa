//! Where nothing fits: the list again with one requirement freed, the smallest change of each kind.

use crate::{
    Demand, Lift, Limit, Spec, assess::Assessed, held::Held, limits::Show, search::Search,
};
use mckibben_core::{
    analysis::{
        FailureMode::{self, Bladder, Ends, Mesh, Strands},
        LEAST_SAFETY, PROVED, RELIEF, find_root,
    },
    by_number::{ByNumber, SortByNumber},
    joined, threads,
    units::{Dimension, rounded, tidy},
};
use serde::Serialize;

/// A change of the specification with which a muscle fits.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(tag = "relax", rename_all = "snake_case")]
pub enum Relaxation {
    /// Supply this pressure.
    MaxPressure {
        /// MPa.
        pressure_mpa: f64,
    },
    /// Accept these pulls.
    Force {
        /// The share of what is wanted: of the pulls, of the load, or of the torques.
        share: f64,
    },
    /// Accept these contractions.
    Contraction {
        /// The share of what is wanted: of the contractions, or of the stroke.
        share: f64,
    },
    /// Accept this chance.
    Certainty {
        /// From 0.5.
        certainty: f64,
    },
    /// Allow this diameter when bulged.
    MaxBulgedDiameter { bulged_diameter_mm: f64 },
    /// Allow this circle around all muscles with their ends.
    MaxEnvelope { envelope_mm: f64 },
    /// Place the axes of neighbours so far apart.
    Pitch { pitch_mm: f64 },
    /// Allow this mass.
    MaxMass { mass_g: f64 },
    /// Allow this stretch of the rubber.
    MaxStretch { max_stretch: f64 },
    /// Allow this strain of the strands.
    MaxStrandStrain {
        /// Largest strain at the maximum pressure.
        strand_strain: f64,
    },
    /// Accept this burst margin.
    MinBurstMargin {
        /// Burst pressure over maximum pressure.
        burst_margin: f64,
    },
    /// Guide the muscle on its way, so that it cannot buckle.
    Guided {},
    /// Provide this liquid volume.
    MaxLiquidVolume {
        /// mm³.
        liquid_volume_mm3: f64,
    },
    /// All of these together.
    Together {
        /// Each of them.
        changes: Vec<Relaxation>,
    },
}

impl Relaxation {
    /// Changes a specification.
    pub fn apply(&self, spec: &mut Spec) {
        let limits = &mut spec.limits;
        match self {
            Self::MaxPressure { pressure_mpa } => {
                (spec.max_pressure_mpa, spec.extrapolate) = (*pressure_mpa, true);
            }
            Self::Force { share } => spec.wanted = spec.wanted.times(*share),
            Self::Contraction { share } => spec.wanted = spec.wanted.shorter(*share),
            Self::Certainty { certainty } => spec.certainty = Some(*certainty),
            Self::MaxBulgedDiameter { bulged_diameter_mm } => {
                limits.bulged_diameter_mm = Some(*bulged_diameter_mm);
            }
            Self::MaxEnvelope { envelope_mm } => limits.envelope_mm = Some(*envelope_mm),
            Self::Pitch { pitch_mm } => spec.pitch_mm = Some(*pitch_mm),
            Self::MaxMass { mass_g } => limits.mass_g = Some(*mass_g),
            Self::MaxStretch { max_stretch } => limits.stretch = Some(*max_stretch),
            Self::MaxStrandStrain { strand_strain } => limits.strand_strain = Some(*strand_strain),
            Self::MinBurstMargin { burst_margin } => limits.burst_margin = Some(*burst_margin),
            Self::Guided {} => limits.buckling = false,
            Self::MaxLiquidVolume { liquid_volume_mm3 } => {
                limits.liquid_volume_mm3 = Some(*liquid_volume_mm3)
            }
            Self::Together { changes } => changes.iter().for_each(|change| change.apply(spec)),
        }
    }

    /// The sentence, with pressures, forces and lengths written by `show`. `spec` is the one that
    /// it changes.
    pub fn describe(&self, spec: &Spec, show: Show<'_>) -> String {
        let mm = |mm: f64| show(Dimension::Length, mm);
        match self {
            Self::MaxPressure { pressure_mpa } => {
                format!(
                    "raise the supply to {}",
                    show(Dimension::Pressure, *pressure_mpa)
                )
            }
            Self::Force { share } => match &spec.wanted {
                Demand::Points(_) => {
                    format!(
                        "reduce the pull to {}",
                        listed(&spec.wanted.times(*share), show)
                    )
                }
                Demand::Load { .. } => format!("reduce the load to {} of it", percent(*share)),
                Demand::Joint(joint) => {
                    let torques = joint.torques.iter().map(|t| {
                        let torque = tidy(share * t.torque_nm, 5);
                        format!("{torque} N m at ±{}°", tidy(t.angle_deg, 4))
                    });
                    format!("reduce the torque to {}", joined(torques, " and "))
                }
            },
            Self::Contraction { share } => match spec.wanted {
                Demand::Load {
                    way: Lift::Stroke(stroke_mm),
                    ..
                } => format!("reduce the stroke to {}", mm(share * stroke_mm)),
                _ => format!(
                    "reduce the contraction: {}",
                    listed(&spec.wanted.shorter(*share), show)
                ),
            },
            Self::Certainty { certainty } => {
                format!("accept a chance of {} (`certainty`)", percent(*certainty))
            }
            Self::MaxBulgedDiameter { bulged_diameter_mm } => {
                format!("allow a bulged diameter of {}", mm(*bulged_diameter_mm))
            }
            Self::MaxEnvelope { envelope_mm } => format!("allow a circle of {}", mm(*envelope_mm)),
            Self::Pitch { pitch_mm } => {
                format!("set the axes of neighbours {} apart", mm(*pitch_mm))
            }
            Self::MaxMass { mass_g } => format!("allow a mass of {mass_g} g"),
            Self::MaxStretch { max_stretch } => format!("allow a stretch of {max_stretch}"),
            Self::MaxStrandStrain { strand_strain } => {
                format!("allow a strand strain of {}", percent(*strand_strain))
            }
            Self::MinBurstMargin { burst_margin } => {
                format!("reduce the safety factor to {burst_margin}")
            }
            Self::Guided {} => "guide the muscle, so that it cannot buckle (`guided`)".into(),
            Self::MaxLiquidVolume { liquid_volume_mm3 } => {
                format!("provide {} mL of liquid", tidy(1e-3 * liquid_volume_mm3, 3))
            }
            Self::Together { changes } => joined(
                changes.iter().map(|change| change.describe(spec, show)),
                ", and together with that ",
            ),
        }
    }
}

/// Operating points with the pull of all muscles together.
fn listed(wanted: &Demand, show: Show<'_>) -> String {
    let points = wanted.points(1.0);
    let points = points.iter().map(|q| {
        let force = show(Dimension::Force, q.force_n);
        format!("{force} at {}", percent(q.contraction))
    });
    joined(points, " and ")
}

fn percent(ratio: f64) -> String {
    format!("{} %", tidy(100.0 * ratio, 4))
}

/// A change, and how much it asks: the logarithm of its number over that of the specification.
type Change = (f64, Relaxation);

/// A change is larger by this share than it has to be, so that it holds with three digits and the
/// last bit of an inverse.
const EASED: f64 = 1e-5;
/// Muscles of each kind of change that are looked at by the model that decides, the closest first;
/// and so many of which all limits are moved together.
const NEAREST: usize = 12;

/// A number with three digits, not below or not above it.
fn three_digits(value: f64, up: bool) -> f64 {
    if up {
        rounded(value * (1.0 + EASED), 3, f64::ceil)
    } else {
        rounded(value * (1.0 - EASED), 3, f64::floor)
    }
}

/// A requirement that is freed.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Freed {
    Pull,
    Way,
    Pressure,
    Certainty,
    Limit(Limit),
}

/// The smallest change of each kind with which a muscle of the list fits, each held against the
/// changed specification; those that ask for least first.
pub fn relaxations(search: &Search<'_>) -> Vec<Relaxation> {
    let limits = crate::limits::LIMITS
        .iter()
        .map(|entry| Freed::Limit(entry.limit));
    let mut changes = Vec::from_iter(
        [Freed::Pull, Freed::Way, Freed::Pressure, Freed::Certainty]
            .into_iter()
            .chain(limits)
            .filter_map(|freed| least(search, freed)),
    );
    if changes.is_empty() {
        changes.extend(together(search));
    }
    changes.sort_by_number(|change| change.0);
    changes.into_iter().map(|change| change.1).collect()
}

/// The closest muscles of the list of which nothing else misses than what is freed.
fn nearest<'a>(search: &'a Search<'_>, freed: Freed) -> Vec<&'a Held> {
    let is_freed = |limit: Limit| match freed {
        Freed::Limit(freed) => limit == freed,
        Freed::Way => true,
        _ => limit == Limit::Force,
    };
    let missed = |held: &&Held| {
        let mut missed = held.checks.iter().filter(|c| c.excess() > 0.0);
        missed.all(|c| is_freed(c.limit))
    };
    let mut near = Vec::from_iter(search.screened.iter().filter(missed));
    near.sort_by_number(|held| held.miss());
    near.truncate(NEAREST);
    near
}

/// The smallest change that frees a requirement.
fn least(search: &Search<'_>, freed: Freed) -> Option<Change> {
    threads::map(&nearest(search, freed), |held| {
        let exact = search.exact(search.spec, held.job())?;
        proven(search, &exact, change(search, &exact, freed)?)
    })
    .into_iter()
    .flatten()
    .min_by_number(|change| change.0)
}

/// All limits that are missed, moved together, of the closest muscles.
fn together(search: &Search<'_>) -> Option<Change> {
    let mut near = Vec::from_iter(search.screened.iter());
    near.sort_by_number(|held| held.miss());
    near.truncate(NEAREST);
    let changes = threads::map(&near, |held| {
        let exact = search.exact(search.spec, held.job())?;
        let mut kinds = vec![];
        for check in exact.checks.iter().filter(|c| c.excess() > 0.0) {
            let freed = match check.limit {
                Limit::Force => Freed::Pull,
                limit => Freed::Limit(limit),
            };
            if !kinds.contains(&freed) {
                kinds.push(freed);
            }
        }
        let all: Option<Vec<Change>> = kinds
            .into_iter()
            .map(|freed| change(search, &exact, freed))
            .collect();
        let (asks, changes): (Vec<f64>, Vec<Relaxation>) = all?.into_iter().unzip();
        proven(
            search,
            &exact,
            (asks.into_iter().sum(), Relaxation::Together { changes }),
        )
    });
    changes
        .into_iter()
        .flatten()
        .min_by_number(|change| change.0)
}

/// A change with which the muscle fits.
fn proven(search: &Search<'_>, held: &Held, change: Change) -> Option<Change> {
    let mut changed = search.spec.clone();
    change.1.apply(&mut changed);
    search.exact(&changed, held.job())?.fits().then_some(change)
}

/// The change of a kind that a muscle asks for.
fn change(search: &Search<'_>, held: &Held, freed: Freed) -> Option<Change> {
    let spec = search.spec;
    let of = |limit: Limit| {
        held.checks
            .iter()
            .filter(move |c| c.limit == limit)
            .max_by_number(|c| c.excess())
    };
    let wanted = spec.wanted.on_radius(held.radius_mm);
    match freed {
        Freed::Pull => {
            let pull = of(Limit::Force)?;
            let share = Some(pull.value / pull.bound).filter(|share| *share > 0.0)?;
            let share = three_digits(share * wanted.size(), false) / wanted.size();
            Some((-share.ln(), Relaxation::Force { share }))
        }
        Freed::Way => {
            let share = shorter(search, held, wanted.way()?)?;
            Some((-share.ln(), Relaxation::Contraction { share }))
        }
        Freed::Certainty => {
            let certainty = (100.0 * held.chance?).floor() / 100.0;
            let is_less = certainty >= 0.5 && certainty < spec.certainty?;
            is_less.then_some((0.0, Relaxation::Certainty { certainty }))
        }
        Freed::Pressure => higher(search, held),
        Freed::Limit(limit) => {
            let worst = of(limit).filter(|c| c.excess() > 0.0)?;
            let allow = limit.entry()?.allow;
            Some((
                worst.excess().ln_1p(),
                allow(three_digits(worst.value, true)),
            ))
        }
    }
}

/// The share of the way on which a muscle meets every limit.
fn shorter(search: &Search<'_>, held: &Held, way: f64) -> Option<f64> {
    let missed = |share: f64| {
        let spec = Spec {
            wanted: search.spec.wanted.shorter(share),
            ..search.spec.clone()
        };
        let held = search.exact(&spec, held.job()).ok_or(())?;
        Ok::<f64, ()>(held.worst().map_or(0.0, |check| check.excess()))
    };
    let share = find_root(missed, 0.0, 1.0, 1e-4).ok()??;
    Some(three_digits((share - 1e-4) * way, false) / way).filter(|share| *share > 0.0)
}

/// What allows the pressure that a muscle needs.
fn higher(search: &Search<'_>, held: &Held) -> Option<Change> {
    let spec = Spec {
        extrapolate: true,
        ..search.spec.clone()
    };
    let muscle = held.place.muscle(&spec).ok()?;
    let mut assessed = Assessed::new(&spec, search.models.decides(), &muscle).ok()?;
    let points = spec
        .wanted
        .on_radius(held.radius_mm)
        .times(1.0 / f64::from(held.count))
        .points(muscle.length_mm())
        .into_owned();
    assessed.keep_strands(&points).ok()?;
    let mut needed_mpa = 0.0_f64;
    for q in &points {
        needed_mpa = needed_mpa.max(assessed.need_beyond(q, spec.deviations())?);
    }
    let is_within = needed_mpa <= spec.supply_share * spec.max_pressure_mpa;
    match assessed.below.map(|below| below.by) {
        None => {
            let pressure_mpa = three_digits(needed_mpa / spec.supply_share, true);
            Some((
                (pressure_mpa / spec.max_pressure_mpa).ln(),
                Relaxation::MaxPressure { pressure_mpa },
            ))
        }
        Some(Strands | Mesh | Bladder | Ends) if is_within => {
            let burst_margin = margin_at(&assessed, RELIEF * needed_mpa)?;
            let burst_margin = three_digits(burst_margin, false);
            let ask = (spec.limits.burst_margin? / burst_margin).ln();
            let change = Relaxation::MinBurstMargin { burst_margin };
            (burst_margin >= LEAST_SAFETY).then_some((ask, change))
        }
        Some(FailureMode::StrandStrain) if is_within => {
            let mut strain = 0.0_f64;
            for contraction in std::iter::once(0.0).chain(points.iter().map(|q| q.contraction)) {
                strain = strain.max(
                    assessed
                        .strand_strain(needed_mpa, contraction)
                        .ok()?
                        .unwrap_or_default(),
                );
            }
            let strand_strain = three_digits(strain, true);
            Some((
                (strand_strain / spec.limits.strand_strain?).ln(),
                Relaxation::MaxStrandStrain { strand_strain },
            ))
        }
        _ => None,
    }
}

/// The safety factor with which a pressure is allowed, as far as the failures are known.
fn margin_at(assessed: &Assessed<'_>, most_mpa: f64) -> Option<f64> {
    let margins = assessed.burst.modes().into_iter().filter_map(|(by, at)| {
        let least = Some(at.least_mpa()?).filter(|p| *p < PROVED * most_mpa);
        Some(
            at.mpa()
                .unwrap_or(f64::INFINITY)
                .min(least.unwrap_or(f64::INFINITY))
                / by.share()
                / most_mpa,
        )
    });
    margins.reduce(f64::min)
}
