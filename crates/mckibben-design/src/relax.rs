//! Where nothing fits: what to change, of each kind the smallest change that makes a muscle fit.

use crate::limit::{Probe, probe_with};
use crate::search::{Pick, Search};
use crate::trial::{Below, Trial};
use crate::{Build, Check, Limit, OperatingPoint, Spec, fits};
use mckibben::analysis::{Evaluation, Options, bisect, find_root};
use mckibben::model::ModelError;
use mckibben::muscle::Muscle;
use mckibben::threads;
use mckibben::units::{Values, rounded};
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
        /// Outside of the model's range.
        extrapolated: bool,
    },
    /// Accept these pulls.
    Force {
        /// The share of what is wanted: of the pulls, of the load, or of the torques.
        share: f64,
        /// The operating points as they could be.
        points: Vec<OperatingPoint>,
    },
    /// Accept these contractions.
    Contraction {
        /// The share of what is wanted: of the contractions, or of the stroke.
        share: f64,
        /// The operating points as they could be.
        points: Vec<OperatingPoint>,
    },
    /// Take a wider tube with the same wall.
    OuterDiameter {
        /// mm.
        outer_diameter_mm: f64,
    },
    /// Allow this diameter when bulged.
    MaxBulgedDiameter { bulged_diameter_mm: f64 },
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
    /// Take another sleeve.
    Sleeve {
        /// Its name.
        sleeve: String,
        /// The tube that goes with it.
        tube: Option<String>,
    },
    /// Cast a tube of another rubber.
    Rubber {
        /// Its name.
        rubber: String,
        /// The tube, by name.
        tube: String,
    },
    /// Take strands that are stiffer.
    Stiffness {
        /// Stiffness k of one strand family, N/mm.
        family_stiffness_n_per_mm: f64,
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
            Self::MaxPressure { pressure_mpa, .. } => {
                (spec.max_pressure_mpa, spec.extrapolate) = (*pressure_mpa, true);
            }
            Self::Force { share, .. } => spec.wanted = spec.wanted.times(*share),
            Self::Contraction { share, .. } => spec.wanted = spec.wanted.shorter(*share),
            Self::OuterDiameter { outer_diameter_mm } => {
                spec.outer_diameter_mm = Values::List(vec![*outer_diameter_mm]);
            }
            Self::MaxBulgedDiameter { bulged_diameter_mm } => {
                limits.bulged_diameter_mm = Some(*bulged_diameter_mm)
            }
            Self::MaxStretch { max_stretch } => limits.stretch = Some(*max_stretch),
            Self::MaxStrandStrain { strand_strain } => limits.strand_strain = Some(*strand_strain),
            Self::MinBurstMargin { burst_margin } => limits.burst_margin = Some(*burst_margin),
            Self::Guided {} => limits.buckling = false,
            Self::MaxLiquidVolume { liquid_volume_mm3 } => {
                limits.liquid_volume_mm3 = Some(*liquid_volume_mm3)
            }
            Self::Together { changes } => changes.iter().for_each(|change| change.apply(spec)),
            // Other parts, with which a muscle was found.
            Self::Sleeve { .. } | Self::Rubber { .. } | Self::Stiffness { .. } => {}
        }
    }
}

/// A kind of change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Kind {
    Pull,
    Contraction,
    Supply,
    Safety,
    StrandStrain,
    Limit(Limit),
}

/// A change, and how much it asks: the logarithm of its number over that of the specification.
pub(super) type Change = (f64, Relaxation);

/// Changes of one kind that are proven, at most, and by how much more than the best one they may
/// ask for.
const MOST: usize = 12;
const WINDOW: f64 = 0.06;
/// A change is larger by this share than it has to be, so that it holds with three digits and the
/// last bit of an inverse.
const EASED: f64 = 1e-5;
/// Where several limits are missed, the share of the way is known to this; it is looked for on so
/// many of the closest muscles.
const ROUGH: f64 = 1e-3;
const NEAREST: usize = 200;
/// Shares of the way that are looked at together with a share of the pull; muscles that the model
/// of the search is not good for come last.
const WAYS: [f64; 6] = [1.0, 0.85, 0.7, 0.55, 0.4, 0.25];
const UNSURE: f64 = 100.0;

/// The muscles of a search that do not fit, by the model that decides.
pub(super) struct Misses<'a> {
    pub(super) search: &'a Search<'a>,
    pub(super) build: &'a Build<'a>,
    pub(super) picks: &'a [Pick],
    pub(super) spec: Spec,
}

impl<'a> Misses<'a> {
    pub(super) fn new(search: &'a Search<'a>, build: &'a Build<'a>, picks: &'a [Pick]) -> Self {
        Self {
            search,
            build,
            picks,
            spec: search.spec.without_parts(),
        }
    }

    /// The smallest change of each kind with which one of the muscles fits, those that ask for
    /// least first; where there is none, two or more together of the closest ones.
    pub(super) fn relaxations(&self) -> Vec<Relaxation> {
        let mut out = self.least(|_| true);
        if let Some(first) = self
            .picks
            .first()
            .filter(|_| self.search.spec.tubes.is_empty())
        {
            out.extend(self.proven(first, |miss, _, _| miss.wider()));
        }
        if out.is_empty() {
            out.extend(self.together());
        }
        out.sort_by(|a, b| a.0.total_cmp(&b.0));
        out.into_iter().map(|change| change.1).collect()
    }

    /// Where no change of one kind does: less of the way and of the pull, and all other limits that
    /// are missed then, of those that ask for least by a quick model.
    fn together(&self) -> Option<Change> {
        let change = |&(pick, share): &(Pick, f64), proven: bool| {
            let muscle = self.search.muscle(pick).ok()?;
            let (build, unsure) = if proven {
                (self.build, 0.0)
            } else {
                self.search.ranks(&muscle)
            };
            let spec = Spec {
                wanted: self.spec.wanted.shorter(share),
                ..self.spec.clone()
            };
            let miss = Miss {
                spec: &spec,
                build,
                muscle: &muscle,
                proven,
            };
            let (mut trial, probe) = miss.held()?;
            let (ask, mut changes) = miss.together(&mut trial, &probe)?;
            if share < 1.0 {
                let points = spec.points(&muscle).into_owned();
                changes.insert(0, Relaxation::Contraction { share, points });
            }
            Some((
                ask - share.ln() + UNSURE * unsure,
                Relaxation::Together { changes },
            ))
        };
        let all: Vec<(Pick, f64)> = self
            .picks
            .iter()
            .flat_map(|pick| WAYS.map(|share| (*pick, share)))
            .collect();
        let asks = threads::map(&all, |one| Some((change(one, false)?.0, *one)));
        let mut least: Vec<_> = asks.into_iter().flatten().collect();
        least.sort_by(|a, b| a.0.total_cmp(&b.0));
        least.truncate(MOST);
        let proven = threads::map(&least, |(_, one)| change(one, true));
        proven
            .into_iter()
            .flatten()
            .min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// The smallest change of each kind that is wanted: by a quick model of all muscles, proven of
    /// those that ask for least.
    pub(super) fn least(&self, wants: impl Fn(Kind) -> bool + Sync) -> Vec<Change> {
        let rough = |(place, pick): &(usize, Pick)| -> Option<Vec<(f64, Kind, Pick)>> {
            let muscle = self.search.muscle(*pick).ok()?;
            let (build, unsure) = self.search.ranks(&muscle);
            let miss = Miss {
                spec: &self.spec,
                build,
                muscle: &muscle,
                proven: false,
            };
            let (mut trial, probe) = miss.held()?;
            let kinds = miss
                .kinds(&trial, &probe, *place < NEAREST)
                .into_iter()
                .filter(|kind| wants(*kind));
            // What fits by the quick model may miss by little.
            let asks = kinds.map(|kind| {
                let fits = probe.fits();
                let ask = if fits {
                    0.0
                } else {
                    miss.change(kind, &mut trial, &probe)?.0
                };
                Some((ask + unsure, kind, *pick))
            });
            Some(asks.flatten().collect())
        };
        let places: Vec<(usize, Pick)> = self.picks.iter().copied().enumerate().collect();
        let mut rough: Vec<_> = threads::map(&places, rough)
            .into_iter()
            .flatten()
            .flatten()
            .collect();
        rough.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut known = HashSet::new();
        let kinds: Vec<Kind> = rough
            .iter()
            .map(|r| r.1)
            .filter(|kind| known.insert(*kind))
            .collect();
        let least = |kind: &Kind| {
            let mut best: Option<Change> = None;
            for (ask, _, pick) in rough
                .iter()
                .filter(|(_, other, _)| other == kind)
                .take(MOST)
            {
                if best.as_ref().is_some_and(|best| *ask > best.0 + WINDOW)
                    || self.search.progress.cancelled()
                {
                    break;
                }
                let change =
                    self.proven(pick, |miss, trial, probe| miss.change(*kind, trial, probe));
                best = [best, change]
                    .into_iter()
                    .flatten()
                    .min_by(|a, b| a.0.total_cmp(&b.0));
            }
            best
        };
        threads::map(&kinds, least).into_iter().flatten().collect()
    }

    /// A change of a muscle that is held against the changed specification.
    fn proven(
        &self,
        pick: &Pick,
        change: impl Fn(&Miss<'_>, &mut Trial<'_>, &Probe) -> Option<Change>,
    ) -> Option<Change> {
        let muscle = self.search.muscle(*pick).ok()?;
        let miss = Miss {
            spec: &self.spec,
            build: self.build,
            muscle: &muscle,
            proven: true,
        };
        let (mut trial, probe) = miss.held()?;
        change(&miss, &mut trial, &probe)
    }
}

/// A number with three digits, not below or not above it.
fn three_digits(value: f64, up: bool) -> f64 {
    if up {
        rounded(value * (1.0 + EASED), 3, f64::ceil)
    } else {
        rounded(value * (1.0 - EASED), 3, f64::floor)
    }
}

/// A muscle that does not fit.
struct Miss<'a> {
    spec: &'a Spec,
    build: &'a Build<'a>,
    muscle: &'a Muscle,
    /// Whether a change is held against the changed specification, and left out where the muscle
    /// still does not fit.
    proven: bool,
}

impl Miss<'_> {
    fn held(&self) -> Option<(Trial<'_>, Probe)> {
        let mut trial = Trial::new(self.spec, self.build, self.muscle).ok()?;
        let probe = probe_with(&mut trial, false).ok()?;
        Some((trial, probe))
    }

    /// The kinds of change that may do alone: where one kind of limit is missed, and of a muscle
    /// that is `near` a shorter way where several are.
    fn kinds(&self, trial: &Trial<'_>, probe: &Probe, near: bool) -> Vec<Kind> {
        // What fits by a quick model may miss any of them by little.
        let fits = probe.fits();
        let missed: Vec<Limit> = probe
            .checks
            .iter()
            .filter(|c| fits || c.excess() > 0.0)
            .map(|c| c.limit)
            .collect();
        let alone = fits || missed.iter().all(|limit| *limit == missed[0]);
        let by_pressure = match trial.below {
            None => Some(Kind::Supply),
            Some(Below::Failure(..)) => Some(Kind::Safety),
            Some(Below::Strained) => Some(Kind::StrandStrain),
            Some(Below::Rated | Below::Unanswered(_)) => None,
        };
        let weak = alone && missed.contains(&Limit::Force);
        let mut kinds: Vec<Kind> = (near || weak)
            .then_some(Kind::Contraction)
            .into_iter()
            .collect();
        if weak {
            kinds.extend([Kind::Pull].into_iter().chain(by_pressure));
        }
        let own = [
            Limit::BulgedDiameter,
            Limit::MaxStretch,
            Limit::Buckling,
            Limit::LiquidVolume,
        ];
        kinds.extend(
            own.into_iter()
                .filter(|limit| alone && missed.contains(limit))
                .map(Kind::Limit),
        );
        kinds
    }

    /// The change of a kind.
    fn change(&self, kind: Kind, trial: &mut Trial<'_>, probe: &Probe) -> Option<Change> {
        let (wanted, limits, supply_mpa) = (
            &self.spec.wanted,
            &self.spec.limits,
            self.spec.max_pressure_mpa,
        );
        let points = self.spec.points(self.muscle);
        let (ask, change) = match kind {
            Kind::Pull => {
                let shares = points
                    .iter()
                    .zip(&probe.checks)
                    .map(|(q, check)| check.value / q.force_n);
                let share = shares.reduce(f64::min).filter(|share| *share > 0.0)?;
                let share = three_digits(share * wanted.size(), false) / wanted.size();
                let points = wanted
                    .times(share)
                    .points(self.muscle.length_mm())
                    .into_owned();
                (-share.ln(), Relaxation::Force { share, points })
            }
            Kind::Contraction => {
                let (max, length_mm, way) =
                    (trial.highest_mpa, self.muscle.length_mm(), wanted.way()?);
                let weak = probe
                    .checks
                    .iter()
                    .all(|c| c.limit == Limit::Force || c.excess() <= 0.0);
                // By how much the muscle misses a share of the way: the pull alone, or all limits.
                let missed = |share: f64| {
                    let nearer = wanted.shorter(share);
                    if !weak {
                        let spec = Spec {
                            wanted: nearer,
                            ..self.spec.clone()
                        };
                        let probe =
                            probe_with(&mut Trial::new(&spec, self.build, self.muscle)?, false)?;
                        return Ok(probe.worst().map_or(0.0, Check::excess));
                    }
                    let mut least = f64::INFINITY;
                    for q in nearer.points(length_mm).iter() {
                        let pull_n = trial.evaluation().force_n(max, q.contraction)?;
                        least = least.min(trial.sure_n(max, q.contraction, pull_n) / q.force_n);
                    }
                    Ok::<f64, ModelError>(1.0 - least)
                };
                let share = find_root(missed, 0.0, 1.0, if weak { EASED } else { ROUGH }).ok()?;
                let share = share.or(probe.fits().then_some(1.0))?;
                let share = if weak { share } else { share - ROUGH };
                let share = three_digits(share * way, false) / way;
                let points = wanted.shorter(share).points(length_mm).into_owned();
                (-share.ln(), Relaxation::Contraction { share, points })
            }
            Kind::Supply => {
                let pressure_mpa = three_digits(self.needed_mpa(trial)?, true);
                let extrapolated = pressure_mpa > trial.model.info().range.pressure_mpa.1;
                (
                    (pressure_mpa / supply_mpa).ln(),
                    Relaxation::MaxPressure {
                        pressure_mpa,
                        extrapolated,
                    },
                )
            }
            Kind::Safety => {
                let needed_mpa = self.needed_mpa(trial).filter(|p| *p <= supply_mpa)?;
                let failures = trial.burst.modes();
                let margins = failures
                    .iter()
                    .filter_map(|(by, at)| Some(at.mpa()? / by.share() / needed_mpa));
                let burst_margin = three_digits(margins.reduce(f64::min)?, false);
                (
                    (limits.burst_margin? / burst_margin).ln(),
                    Relaxation::MinBurstMargin { burst_margin },
                )
            }
            Kind::StrandStrain => {
                let needed_mpa = self.needed_mpa(trial).filter(|p| *p <= supply_mpa)?;
                let places = std::iter::once(0.0).chain(points.iter().map(|q| q.contraction));
                let strains = places.filter_map(|e| trial.strand_strain(needed_mpa, e).ok()?);
                let strand_strain = three_digits(strains.reduce(f64::max)?, true);
                (
                    (strand_strain / limits.strand_strain?).ln(),
                    Relaxation::MaxStrandStrain { strand_strain },
                )
            }
            Kind::Limit(limit) => {
                let missed = probe.checks.iter().filter(|c| c.limit == limit);
                let worst = missed.max_by(|a, b| a.excess().total_cmp(&b.excess()))?;
                let value = three_digits(worst.value, true);
                let change = match limit {
                    Limit::BulgedDiameter => Relaxation::MaxBulgedDiameter {
                        bulged_diameter_mm: value,
                    },
                    Limit::MaxStretch => Relaxation::MaxStretch { max_stretch: value },
                    Limit::LiquidVolume => Relaxation::MaxLiquidVolume {
                        liquid_volume_mm3: value,
                    },
                    Limit::Buckling => Relaxation::Guided {},
                    Limit::Force => return None,
                };
                (worst.excess().ln_1p(), change)
            }
        };
        self.fits(std::slice::from_ref(&change))
            .then_some((ask, change))
    }

    /// All limits that are missed, changed together.
    fn together(&self, trial: &mut Trial<'_>, probe: &Probe) -> Option<(f64, Vec<Relaxation>)> {
        let mut known = HashSet::new();
        let missed = probe
            .checks
            .iter()
            .filter(|c| c.excess() > 0.0 && known.insert(c.limit));
        let kinds = missed.map(|c| {
            if c.limit == Limit::Force {
                Kind::Pull
            } else {
                Kind::Limit(c.limit)
            }
        });
        let alone = Miss {
            proven: false,
            ..*self
        };
        let changes = kinds.map(|kind| alone.change(kind, trial, probe));
        let (asks, changes): (Vec<f64>, Vec<Relaxation>) = changes
            .collect::<Option<Vec<Change>>>()?
            .into_iter()
            .unzip();
        self.fits(&changes)
            .then(|| (asks.into_iter().sum(), changes))
    }

    /// Whether it fits a specification that is changed.
    fn fits(&self, changes: &[Relaxation]) -> bool {
        if !self.proven {
            return true;
        }
        let mut changed = self.spec.clone();
        changes.iter().for_each(|change| change.apply(&mut changed));
        fits(&changed, self.build, self.muscle)
    }

    /// The pressure that all points need, where nothing bounds it.
    fn needed_mpa(&self, trial: &mut Trial<'_>) -> Option<f64> {
        let beyond = Options {
            extrapolate: true,
            ..self.spec.options()
        };
        // Where a pull is out of reach, other models search long for its pressure.
        let model = if self.proven {
            &*trial.model
        } else {
            &*trial.thick_wall
        };
        let mut model = Evaluation::new(model, &mut trial.workspace, beyond);
        let points = self.spec.points(self.muscle);
        let needs = points
            .iter()
            .map(|q| model.pressure_at(q.force_n, q.contraction).ok());
        needs
            .collect::<Option<Vec<f64>>>()?
            .into_iter()
            .reduce(f64::max)
    }

    /// The smallest diameter beyond the bound that fits.
    fn wider(&self) -> Option<Change> {
        let (_, high) = self.spec.outer_diameter_mm.bounds();
        let does = |d0: f64| {
            let muscle = self.muscle.with_section(d0, self.muscle.wall_mm());
            muscle.is_ok_and(|m| fits(self.spec, self.build, &m))
        };
        let wide = |i: i32| high * (1.0 + 0.05 * f64::from(i));
        let first = (1..=40).find(|&i| does(wide(i)))?;
        let (_, top) = bisect(wide(first - 1), wide(first), 30, |d0| !does(d0));
        let outer_diameter_mm = three_digits(top, true);
        Some((
            (outer_diameter_mm / high).ln(),
            Relaxation::OuterDiameter { outer_diameter_mm },
        ))
    }
}
