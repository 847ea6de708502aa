//! Where nothing fits: which limit to relax, and by how much.

use crate::limit::{Probe, probe};
use crate::trial::{Below, Trial};
use crate::{Build, Demand, Limit, Limits, OperatingPoint, Spec};
use mckibben::analysis::{Evaluation, FailureMode, FailurePressure, Options};
use mckibben::muscle::Muscle;
use serde::Serialize;

/// A way to make the closest muscle fit.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "RelaxationAnswer")]
#[serde(tag = "relax", rename_all = "snake_case")]
pub enum Relaxation {
    /// Supply this pressure.
    MaxPressure {
        /// MPa.
        pressure_mpa: f64,
        /// The model had to be asked outside of its range.
        extrapolated: bool,
    },
    /// Accept these pulls.
    Force {
        /// The points that fall short, as they could be.
        points: Vec<OperatingPoint>,
    },
    /// Accept these contractions.
    Contraction {
        /// The points that fall short, as they could be.
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
}

/// By which share a muscle that stands on a bound may miss it: the root that put it there is not known better.
const ON_BOUND: f64 = 1e-6;

/// What would make one of `muscles` fit, one limit at a time, of each kind the one that the first of them needs.
pub(super) fn relaxations<'a>(
    spec: &Spec,
    build: &Build<'_>,
    muscles: impl IntoIterator<Item = &'a Muscle>,
) -> Vec<Relaxation> {
    let mut out: Vec<Relaxation> = vec![];
    for (i, muscle) in muscles.into_iter().enumerate() {
        let miss = Miss { spec, build, muscle };
        for relaxation in miss.relaxations(i == 0 && spec.tubes.is_empty()) {
            let kind = std::mem::discriminant(&relaxation);
            if out.iter().all(|known| std::mem::discriminant(known) != kind) {
                out.push(relaxation);
            }
        }
    }
    out
}

/// A muscle that does not fit.
struct Miss<'a> {
    spec: &'a Spec,
    build: &'a Build<'a>,
    muscle: &'a Muscle,
}

impl Miss<'_> {
    /// What would make it fit. Each is tried: only what really makes it fit is returned. Wider tubes are looked for where `widen`.
    fn relaxations(&self, widen: bool) -> Vec<Relaxation> {
        let (spec, muscle) = (self.spec, self.muscle);
        let Ok(mut trial) = Trial::new(spec, self.build, muscle) else { return vec![] };
        let Ok(probe) = probe(spec, self.build, muscle) else { return vec![] };
        let wanted = spec.points(muscle);
        let pulls: Vec<f64> = probe.checks.iter().take(wanted.len()).map(|c| c.value).collect();
        let mut out = vec![];
        if wanted.iter().zip(&pulls).any(|(p, pull)| pull / p.force_n < 1.0) {
            out.extend(self.pressure(&mut trial));
            let forces = self.points(&pulls, |p, pull| {
                (pull * p.force_n > 0.0).then_some(OperatingPoint { force_n: pull, ..*p })
            });
            out.extend(forces.map(|points| Relaxation::Force { points }));
            let contractions = self.points(&pulls, |p, _| {
                let max = trial.highest_mpa;
                let contraction = trial.evaluation().contraction_at(p.force_n, max).ok()?;
                Some(OperatingPoint { contraction, ..*p })
            });
            out.extend(contractions.map(|points| Relaxation::Contraction { points }));
            if widen {
                out.extend(self.wider());
            }
        }
        // The largest of each kind, and no more than the last bit beyond it.
        let worst = |kind: Limit| {
            let missed = probe.checks.iter().filter(|c| c.limit == kind && c.excess() > 0.0);
            missed.max_by(|a, b| a.excess().total_cmp(&b.excess())).map(|c| c.value)
        };
        let mut ease = |value: Option<f64>, set: fn(&mut Limits, f64), relaxation: fn(f64) -> Relaxation| {
            let eased = value.filter(|v| self.fits(|spec| set(&mut spec.limits, *v)));
            out.extend(eased.map(relaxation));
        };
        const UP: f64 = 1.0 + 1e-9;
        let set: fn(&mut Limits, f64) = |l, v| l.bulged_diameter_mm = Some(v * UP);
        ease(worst(Limit::BulgedDiameter), set, |v| Relaxation::MaxBulgedDiameter { bulged_diameter_mm: v });
        let set: fn(&mut Limits, f64) = |l, v| l.stretch = Some(v * UP);
        ease(worst(Limit::MaxStretch), set, |v| Relaxation::MaxStretch { max_stretch: v });
        ease(worst(Limit::Buckling), |l, _| l.buckling = false, |_| Relaxation::Guided {});
        let set: fn(&mut Limits, f64) = |l, v| l.liquid_volume_mm3 = Some(v * UP);
        ease(worst(Limit::LiquidVolume), set, |v| Relaxation::MaxLiquidVolume { liquid_volume_mm3: v });
        out
    }

    /// Whether it fits a specification that is changed.
    fn fits(&self, change: impl FnOnce(&mut Spec)) -> bool {
        let mut relaxed = self.spec.clone();
        change(&mut relaxed);
        probe(&relaxed, self.build, self.muscle).is_ok_and(is_on_bound)
    }

    /// The pressure that all points need, from the supply or by what keeps the muscle below it.
    fn pressure(&self, trial: &mut Trial<'_>) -> Option<Relaxation> {
        let beyond = Options { extrapolate: true, ..self.spec.options() };
        let mut model = Evaluation::new(&*trial.model, &mut trial.workspace, beyond);
        let wanted = self.spec.points(self.muscle);
        let needs = wanted.iter().map(|p| model.pressure_at(p.force_n, p.contraction));
        let pressure_mpa = needs.collect::<Result<Vec<f64>, _>>().ok()?.into_iter().fold(0.0, f64::max);
        let up = pressure_mpa * (1.0 + 1e-9);
        match trial.below {
            None => {
                let extrapolated = pressure_mpa > trial.model.info().range.pressure_mpa.1;
                let fits = self.fits(|spec| (spec.max_pressure_mpa, spec.extrapolate) = (up, true));
                fits.then_some(Relaxation::MaxPressure { pressure_mpa, extrapolated })
            }
            Some(Below::Failure(..)) => {
                let failures = trial.burst.modes();
                let margin =
                    |(mode, at): &(FailureMode, FailurePressure)| Some(at.mpa()? / mode.share() / up);
                let burst_margin = failures.iter().filter_map(margin).reduce(f64::min)?;
                let fits = self.fits(|spec| spec.limits.burst_margin = Some(burst_margin));
                fits.then_some(Relaxation::MinBurstMargin { burst_margin })
            }
            Some(Below::Strained) => {
                let places = std::iter::once(0.0).chain(wanted.iter().map(|q| q.contraction));
                let strains = places.filter_map(|e| trial.strand_strain(up, e).ok()?);
                let strand_strain = strains.reduce(f64::max)? * (1.0 + 1e-9);
                let fits = self.fits(|spec| spec.limits.strand_strain = Some(strand_strain));
                fits.then_some(Relaxation::MaxStrandStrain { strand_strain })
            }
            Some(Below::Rated | Below::Unanswered(_)) => None,
        }
    }

    /// Other operating points in place of those that fall short.
    fn points(
        &self,
        pulls: &[f64],
        mut instead: impl FnMut(&OperatingPoint, f64) -> Option<OperatingPoint>,
    ) -> Option<Vec<OperatingPoint>> {
        let mut list = self.spec.points(self.muscle).into_owned();
        let mut changed = vec![];
        for (p, &pull) in list.iter_mut().zip(pulls) {
            if pull / p.force_n < 1.0 {
                *p = instead(p, pull)?;
                changed.push(*p);
            }
        }
        // The last bit of an inverse must not decide.
        list.iter_mut().for_each(|p| p.force_n *= 1.0 - 1e-9);
        self.fits(|spec| spec.wanted = Demand::Points(list)).then_some(changed)
    }

    /// The smallest diameter beyond the bound that fits.
    fn wider(&self) -> Option<Relaxation> {
        let (_, high) = self.spec.outer_diameter_mm.bounds();
        let does = |d0: f64| {
            let muscle = self.muscle.with_section(d0, self.muscle.wall_mm());
            muscle.is_ok_and(|m| probe(self.spec, self.build, &m).is_ok_and(is_on_bound))
        };
        let wide = |i: i32| high * (1.0 + 0.05 * f64::from(i));
        let first = (1..=40).find(|&i| does(wide(i)))?;
        let (mut low, mut top) = (wide(first - 1), wide(first));
        for _ in 0..30 {
            let mid = 0.5 * (low + top);
            if does(mid) { top = mid } else { low = mid }
        }
        Some(Relaxation::OuterDiameter { outer_diameter_mm: (top * 100.0).ceil() / 100.0 })
    }
}

fn is_on_bound(probe: Probe) -> bool {
    probe.checks.iter().all(|c| c.excess() <= ON_BOUND)
}
