//! Where nothing fits: what to change, of each kind the smallest change that makes a muscle fit.

use crate::{
    Build, Check, Limit, Relaxation, Spec, fits,
    limits::{
        AT_POINTS,
        check::{Probe, probe_with},
        pressure::PressureLimit,
    },
    relaxation::{Change, EASED, three_digits},
    search::{Pick, Search},
    trial::Trial,
};
use mckibben_core::{
    analysis::{Evaluation, Options, bisect, find_root},
    by_number::*,
    model::ModelError,
    muscle::Muscle,
    threads,
};
use std::collections::HashSet;

/// A kind of change.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    Pull,
    Contraction,
    Pressure(PressureLimit),
    Limit(Limit),
}

/// Changes of one kind that are proven, at most: where one of them holds, and where none does; and by
/// how much more than the best one they may ask for.
const MOST: usize = 12;
const FAILED: usize = 48;
const WINDOW: f64 = 0.06;
/// Where several limits are missed, the share of the way is known to this; it is looked for on so
/// many of the closest muscles.
const ROUGH: f64 = 1e-3;
const NEAREST: usize = 200;
/// Shares of the way that are looked at together with a share of the pull; muscles that the model
/// of the search is not good for come last.
const WAYS: [f64; 6] = [1.0, 0.85, 0.7, 0.55, 0.4, 0.25];
const UNSURE: f64 = 100.0;

/// The muscles of a search that do not fit, by the model that decides.
pub struct Misses<'a> {
    pub search: &'a Search<'a>,
    pub build: &'a Build<'a>,
    pub picks: &'a [Pick],
    pub spec: Spec,
}

impl<'a> Misses<'a> {
    pub fn new(search: &'a Search<'a>, build: &'a Build<'a>, picks: &'a [Pick]) -> Self {
        Self {
            search,
            build,
            picks,
            spec: search.spec.without_parts(),
        }
    }

    /// The smallest change of each kind with which one of the muscles fits, those that ask for
    /// least first; where there is none, two or more together of the closest ones.
    pub fn relaxations(&self) -> Vec<Relaxation> {
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
        out.sort_by_number(|a| a.0);
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
            let (mut trial, probe) = miss.probed()?;
            let (ask, mut changes) = miss.together(&mut trial, &probe)?;
            if share < 1.0 {
                changes.insert(
                    0,
                    Relaxation::Contraction {
                        share,
                        points: spec.points(&muscle).into_owned(),
                    },
                );
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
        least.sort_by_number(|a| a.0);
        least.truncate(MOST);
        let proven = threads::map(&least, |(_, one)| change(one, true));
        proven.into_iter().flatten().min_by_number(|a| a.0)
    }

    /// The smallest change of each kind that is wanted: by a quick model of all muscles, proven of
    /// those that ask for least.
    pub fn least(&self, wants: impl Fn(Kind) -> bool + Sync) -> Vec<Change> {
        let rough = |(place, pick): &(usize, Pick)| -> Option<Vec<(f64, Kind, Pick)>> {
            let muscle = self.search.muscle(*pick).ok()?;
            let (build, unsure) = self.search.ranks(&muscle);
            let miss = Miss {
                spec: &self.spec,
                build,
                muscle: &muscle,
                proven: false,
            };
            let (mut trial, probe) = miss.probed()?;
            let kinds = miss
                .kinds(&trial, &probe, *place < NEAREST)
                .into_iter()
                .filter(|kind| wants(*kind));
            // What fits by the quick model may miss by little.
            let asks = kinds.map(|kind| {
                let ask = if probe.fits() {
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
        rough.sort_by_number(|a| a.0);
        let mut known = HashSet::new();
        let kinds: Vec<Kind> = rough
            .iter()
            .map(|r| r.1)
            .filter(|kind| known.insert(*kind))
            .collect();
        let least = |kind: &Kind| {
            let mut best: Option<Change> = None;
            let of_kind = rough.iter().filter(|(_, other, _)| other == kind);
            for (i, (ask, _, pick)) in of_kind.take(FAILED).enumerate() {
                let is_enough = |best: &Change| i >= MOST || *ask > best.0 + WINDOW;
                if best.as_ref().is_some_and(is_enough) || self.search.progress.cancelled() {
                    break;
                }
                let change =
                    self.proven(pick, |miss, trial, probe| miss.change(*kind, trial, probe));
                best = [best, change].into_iter().flatten().min_by_number(|a| a.0);
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
        let (mut trial, probe) = miss.probed()?;
        change(&miss, &mut trial, &probe)
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
    fn probed(&self) -> Option<(Trial<'_>, Probe)> {
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
        let weak = alone && missed.contains(&Limit::Force);
        let mut kinds: Vec<Kind> = (near || weak)
            .then_some(Kind::Contraction)
            .into_iter()
            .collect();
        if weak {
            kinds.push(Kind::Pull);
            kinds.extend(PressureLimit::of(trial).map(Kind::Pressure));
        }
        let own = AT_POINTS.iter().map(|entry| entry.limit);
        kinds.extend(
            own.filter(|limit| alone && missed.contains(limit))
                .map(Kind::Limit),
        );
        kinds
    }

    /// The change of a kind.
    fn change(&self, kind: Kind, trial: &mut Trial<'_>, probe: &Probe) -> Option<Change> {
        let wanted = &self.spec.wanted;
        let (ask, change) = match kind {
            Kind::Pull => {
                let share = Some(probe.share()).filter(|share| *share > 0.0)?;
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
                        least = least.min(trial.sure_n(max, q.contraction)? / q.force_n);
                    }
                    Ok::<f64, ModelError>(1.0 - least)
                };
                let share = find_root(missed, 0.0, 1.0, if weak { EASED } else { ROUGH }).ok()?;
                let share = share.or(probe.fits().then_some(1.0))?;
                let share = if weak { share } else { share - ROUGH };
                let share = three_digits(share * way, false) / way;
                (
                    -share.ln(),
                    Relaxation::Contraction {
                        share,
                        points: wanted.shorter(share).points(length_mm).into_owned(),
                    },
                )
            }
            Kind::Pressure(limit) => limit.allow(self.needed_mpa(trial)?, trial)?,
            Kind::Limit(limit) => {
                let missed = probe.checks.iter().filter(|c| c.limit == limit);
                let worst = missed.max_by_number(|a| a.excess())?;
                let change = (limit.at_points()?.allow)(three_digits(worst.value, true));
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
        let alone: Option<Vec<f64>> = points
            .iter()
            .map(|q| model.pressure_at(q.force_n, q.contraction).ok())
            .collect();
        let needs = alone?.into_iter().zip(points.iter());
        needs
            .map(|(alone_mpa, q)| trial.need_from(q, alone_mpa).ok()?)
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
