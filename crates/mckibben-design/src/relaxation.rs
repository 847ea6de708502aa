//! Where nothing fits: the list again with one requirement freed, the smallest change of each kind.

use crate::{
    Demand, JointDemand, Limit, OperatingPoint, Spec,
    assess::Assessed,
    held::Held,
    limits::{LIMITS, Show},
    search::Search,
};
use mckibben_core::{
    analysis::{
        FailureMode::{Bladder, Ends, Mesh, StrandStrain, Strands},
        LEAST_SAFETY, PROVED, RELIEF, find_root,
    },
    by_number::{ByNumber, SortByNumber},
    joined, threads,
    units::{Dimension, rounded, tidy},
};
use serde::Serialize;
use std::collections::HashSet;

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
    MaxBulgedDiameter {
        /// Largest diameter in mm.
        bulged_diameter_mm: f64,
    },
    /// Allow this circle around all muscles with their ends.
    MaxEnvelope {
        /// Diameter of the circle in mm.
        envelope_mm: f64,
    },
    /// Place the axes of neighbours so far apart.
    Pitch {
        /// Distance of the axes in mm.
        pitch_mm: f64,
    },
    /// Allow this mass.
    MaxMass {
        /// Mass in g.
        mass_g: f64,
    },
    /// Allow this stretch of the rubber.
    MaxStretch {
        /// Largest principal stretch.
        max_stretch: f64,
    },
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
        self.change(spec, &|_, _| String::new());
    }

    /// The sentence, with pressures, forces and lengths written by `show`. `spec` is the one that
    /// it changes.
    pub fn describe(&self, spec: &Spec, show: Show<'_>) -> String {
        self.change(&mut spec.clone(), show)
    }

    /// Changes a specification, and says what was changed.
    fn change(&self, spec: &mut Spec, show: Show<'_>) -> String {
        let mm = |mm: f64| show(Dimension::Length, mm);
        let limits = &mut spec.limits;
        match *self {
            Self::MaxPressure { pressure_mpa } => {
                (spec.max_pressure_mpa, spec.extrapolate) = (pressure_mpa, true);
                let pressure = show(Dimension::Pressure, pressure_mpa);
                format!("raise the supply to {pressure}")
            }
            Self::Force { share } => {
                spec.wanted = spec.wanted.scaled(share, 1.0);
                match &spec.wanted {
                    Demand::Points { points } => {
                        format!("reduce the pull to {}", listed(points, show))
                    }
                    Demand::Joint(joint) => format!("reduce the torque to {}", torques(joint)),
                    _ => format!("reduce the load to {} of it", percent(share)),
                }
            }
            Self::Contraction { share } => {
                spec.wanted = spec.wanted.scaled(1.0, share);
                match spec.wanted {
                    Demand::Stroke { stroke_mm, .. } => {
                        format!("reduce the stroke to {}", mm(stroke_mm))
                    }
                    _ => {
                        let points = listed(&spec.wanted.points(1.0, 1.0), show);
                        format!("reduce the contraction: {points}")
                    }
                }
            }
            Self::Certainty { certainty } => {
                spec.certainty = Some(certainty);
                format!("accept a chance of {} (`certainty`)", percent(certainty))
            }
            Self::MaxBulgedDiameter { bulged_diameter_mm } => {
                limits.bulged_diameter_mm = Some(bulged_diameter_mm);
                format!("allow a bulged diameter of {}", mm(bulged_diameter_mm))
            }
            Self::MaxEnvelope { envelope_mm } => {
                limits.envelope_mm = Some(envelope_mm);
                format!("allow a circle of {}", mm(envelope_mm))
            }
            Self::Pitch { pitch_mm } => {
                spec.pitch_mm = Some(pitch_mm);
                format!("set the axes of neighbours {} apart", mm(pitch_mm))
            }
            Self::MaxMass { mass_g } => {
                limits.mass_g = Some(mass_g);
                format!("allow a mass of {mass_g} g")
            }
            Self::MaxStretch { max_stretch } => {
                limits.stretch = Some(max_stretch);
                format!("allow a stretch of {max_stretch}")
            }
            Self::MaxStrandStrain { strand_strain } => {
                limits.strand_strain = Some(strand_strain);
                format!("allow a strand strain of {}", percent(strand_strain))
            }
            Self::MinBurstMargin { burst_margin } => {
                limits.burst_margin = Some(burst_margin);
                format!("reduce the safety factor to {burst_margin}")
            }
            Self::Guided {} => {
                limits.buckling = false;
                "guide the muscle, so that it cannot buckle (`guided`)".into()
            }
            Self::MaxLiquidVolume { liquid_volume_mm3 } => {
                limits.liquid_volume_mm3 = Some(liquid_volume_mm3);
                format!("provide {} mL of liquid", tidy(1e-3 * liquid_volume_mm3, 3))
            }
            Self::Together { ref changes } => {
                let said = changes.iter().map(|change| change.change(spec, show));
                joined(said, ", and together with that ")
            }
        }
    }
}

fn torques(joint: &JointDemand) -> String {
    let torques = joint.torques.iter().map(|t| {
        let (torque, angle) = (tidy(t.torque_nm, 5), tidy(t.angle_deg, 4));
        format!("{torque} N m at ±{angle}°")
    });
    joined(torques, " and ")
}

/// Operating points with the pull of all muscles together.
fn listed(points: &[OperatingPoint], show: Show<'_>) -> String {
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
#[derive(Clone, Copy)]
enum Freed {
    Way,
    Pressure,
    Certainty,
    /// A limit, or the pull.
    Limit(Limit),
}

/// The smallest change of each kind with which a muscle of the list fits, each held against the
/// changed specification; those that ask for least first.
pub fn relaxations(search: &Search<'_>) -> Vec<Relaxation> {
    let pull = [Freed::Limit(Limit::Force), Freed::Way];
    let chance = [Freed::Pressure, Freed::Certainty];
    let limits = LIMITS.iter().map(|entry| Freed::Limit(entry.limit));
    let least_of = |freed: Freed| {
        let is_freed = |limit: Limit| match freed {
            Freed::Limit(freed) => limit == freed,
            Freed::Way => true,
            _ => limit == Limit::Force,
        };
        least(search, is_freed, |held| change(search, held, freed))
    };
    let kinds = pull.into_iter().chain(chance).chain(limits);
    let mut changes = Vec::from_iter(kinds.filter_map(least_of));
    if changes.is_empty() {
        changes.extend(least(search, |_| true, |held| together(search, held)));
    }
    changes.sort_by_number(|change| change.0);
    changes.into_iter().map(|change| change.1).collect()
}

/// The smallest change with which one of the closest muscles fits that miss nothing else than what
/// is freed.
fn least(
    search: &Search<'_>,
    is_freed: impl Fn(Limit) -> bool,
    change: impl Fn(&Held) -> Option<Change> + Sync,
) -> Option<Change> {
    let near = search.nearest(NEAREST, |held| held.missed().all(|c| is_freed(c.limit)));
    let proven = threads::map(&near, |held| {
        let change = change(&search.exact(search.spec, held.job)?)?;
        let mut changed = search.spec.clone();
        change.1.apply(&mut changed);
        search.exact(&changed, held.job)?.fits().then_some(change)
    });
    proven
        .into_iter()
        .flatten()
        .min_by_number(|change| change.0)
}

/// All limits that are missed, moved together.
fn together(search: &Search<'_>, held: &Held) -> Option<Change> {
    let mut missed = Vec::from_iter(held.missed().map(|check| check.limit));
    let mut known = HashSet::new();
    missed.retain(|limit| known.insert(*limit));
    let (mut ask, mut changes) = (0.0, vec![]);
    for limit in missed {
        let one = change(search, held, Freed::Limit(limit))?;
        ask += one.0;
        changes.push(one.1);
    }
    Some((ask, Relaxation::Together { changes }))
}

/// The change of a kind that a muscle asks for.
fn change(search: &Search<'_>, held: &Held, freed: Freed) -> Option<Change> {
    let spec = search.spec;
    let worst = |limit: Limit| {
        let of = held.checks.iter().filter(|c| c.limit == limit);
        of.max_by_number(|c| c.excess())
    };
    match freed {
        Freed::Limit(Limit::Force) => {
            let pull = worst(Limit::Force)?;
            let share = Some(pull.value / pull.bound).filter(|share| *share > 0.0)?;
            let size = spec.wanted.size();
            let share = three_digits(share * size, false) / size;
            Some((-share.ln(), Relaxation::Force { share }))
        }
        Freed::Way => {
            let share = shorter(search, held, spec.wanted.way()?)?;
            Some((-share.ln(), Relaxation::Contraction { share }))
        }
        Freed::Certainty => {
            let certainty = (100.0 * held.chance?).floor() / 100.0;
            let is_less = certainty >= 0.5 && certainty < spec.certainty?;
            is_less.then_some((0.0, Relaxation::Certainty { certainty }))
        }
        Freed::Pressure => {
            let mut spec = spec.clone();
            spec.extrapolate = true;
            search.decided(&spec, held.job.place, |assessed| higher(assessed, held))
        }
        Freed::Limit(limit) => {
            let worst = worst(limit).filter(|c| c.excess() > 0.0)?;
            let change = (limit.entry()?.allow)(three_digits(worst.value, true));
            Some((worst.excess().ln_1p(), change))
        }
    }
}

/// The share of the way on which a muscle meets every limit.
fn shorter(search: &Search<'_>, held: &Held, way: f64) -> Option<f64> {
    let missed = |share: f64| {
        let mut spec = search.spec.clone();
        Relaxation::Contraction { share }.apply(&mut spec);
        let held = search.exact(&spec, held.job).ok_or(())?;
        let excesses = held.checks.iter().map(|check| check.excess());
        Ok::<f64, ()>(excesses.max_by_number(|excess| *excess).unwrap_or_default())
    };
    let share = find_root(missed, 0.0, 1.0, 1e-4).ok()??;
    Some(three_digits((share - 1e-4) * way, false) / way).filter(|share| *share > 0.0)
}

/// What allows the pressure that a muscle needs, assessed outside of its model's range as well.
fn higher(assessed: &mut Assessed<'_>, held: &Held) -> Option<Change> {
    let spec = assessed.spec;
    let points = held.points();
    assessed.keep_strands(&points).ok()?;
    let z = spec.deviations();
    let mut needs = points.iter().map(|q| assessed.need_beyond(q, z));
    let needed_mpa = needs.try_fold(0.0, |most: f64, mpa| Some(most.max(mpa?)))?;
    let Some(below) = assessed.below else {
        let pressure_mpa = three_digits(needed_mpa / spec.supply_share, true);
        let ask = (pressure_mpa / spec.max_pressure_mpa).ln();
        return Some((ask, Relaxation::MaxPressure { pressure_mpa }));
    };
    if needed_mpa > spec.supply_share * spec.max_pressure_mpa {
        return None;
    }
    match below.by {
        Strands | Mesh | Bladder | Ends => {
            let burst_margin = margin_at(assessed, RELIEF * needed_mpa)?;
            let burst_margin = three_digits(burst_margin, false);
            let ask = (spec.limits.burst_margin? / burst_margin).ln();
            (burst_margin >= LEAST_SAFETY)
                .then_some((ask, Relaxation::MinBurstMargin { burst_margin }))
        }
        StrandStrain => {
            let contractions = points.iter().map(|q| q.contraction);
            let mut strains = std::iter::once(0.0)
                .chain(contractions)
                .map(|contraction| assessed.strand_strain(needed_mpa, contraction));
            let strain = strains.try_fold(0.0, |most: f64, strain| {
                Some(most.max(strain.ok()?.unwrap_or_default()))
            });
            let strand_strain = three_digits(strain?, true);
            let ask = (strand_strain / spec.limits.strand_strain?).ln();
            Some((ask, Relaxation::MaxStrandStrain { strand_strain }))
        }
        _ => None,
    }
}

/// The safety factor with which a pressure is allowed, as far as the failures are known.
fn margin_at(assessed: &Assessed<'_>, most_mpa: f64) -> Option<f64> {
    let margins = assessed.burst.modes().into_iter().filter_map(|(by, at)| {
        let least = at.least_mpa()?;
        let tested = Some(least).filter(|p| *p < PROVED * most_mpa);
        let mpa = [at.mpa(), tested].into_iter().flatten();
        Some(mpa.fold(f64::INFINITY, f64::min) / by.share() / most_mpa)
    });
    margins.reduce(f64::min)
}
