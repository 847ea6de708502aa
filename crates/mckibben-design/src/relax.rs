//! Where nothing fits: which limit to relax, and by how much.

use crate::limit::{burst_margin, probe};
use crate::{Build, Demand, Limit, Limits, OperatingPoint, Spec};
use mckibben::analysis::{Evaluation, Options};
use mckibben::model::{ForceModel, ModelKind, Workspace};
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
        /// The model that says so.
        model: String,
        /// The model of the search, to which that model was scaled because it lies outside of its range.
        scaled_to: Option<String>,
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

fn fits(spec: &Spec, build: &Build<'_>, muscle: &Muscle) -> bool {
    probe(spec, build, muscle).is_ok_and(|p| p.checks.iter().all(|c| c.excess() <= ON_BOUND))
}

/// What would make one of `muscles` fit, one limit at a time, of each kind the one that the first of them needs.
pub(super) fn relaxations<'a>(
    spec: &Spec,
    build: &Build<'_>,
    muscles: impl IntoIterator<Item = &'a Muscle>,
) -> Vec<Relaxation> {
    let mut out: Vec<Relaxation> = vec![];
    for (i, muscle) in muscles.into_iter().enumerate() {
        for relaxation in of_muscle(spec, build, muscle, i == 0 && spec.tubes.is_empty()) {
            let kind = std::mem::discriminant(&relaxation);
            if out.iter().all(|known| std::mem::discriminant(known) != kind) {
                out.push(relaxation);
            }
        }
    }
    out
}

/// What would make a muscle fit. Each is tried: only what really makes it fit is returned. Wider tubes are looked for where `widen`.
fn of_muscle(spec: &Spec, build: &Build<'_>, muscle: &Muscle, widen: bool) -> Vec<Relaxation> {
    let Ok(model) = build(muscle) else { return vec![] };
    let workspace = &mut Workspace::new();
    let mut model = Evaluation::new(model.as_ref(), workspace, spec.options());
    let mut pull = |p: &OperatingPoint| model.force_n(spec.max_pressure_mpa, p.contraction).ok();
    let wanted = spec.points(muscle);
    let pulls: Vec<Option<f64>> = wanted.iter().map(&mut pull).collect();
    let mut out = vec![];
    if wanted.iter().zip(&pulls).any(|(p, pull)| falls_short(p, *pull)) {
        out.extend(pressure(spec, build, muscle));
        out.extend(
            points(spec, build, muscle, &pulls, |p, pull| {
                pull.filter(|f| f * p.force_n > 0.0).map(|force_n| OperatingPoint { force_n, ..*p })
            })
            .map(|points| Relaxation::Force { points }),
        );
        out.extend(
            points(spec, build, muscle, &pulls, |p, _| {
                let contraction = model.contraction_at(p.force_n, spec.max_pressure_mpa).ok()?;
                Some(OperatingPoint { contraction, ..*p })
            })
            .map(|points| Relaxation::Contraction { points }),
        );
        if widen {
            out.extend(wider(spec, build, muscle));
        }
    }
    let Ok(probe) = probe(spec, build, muscle) else { return out };
    // The largest of each kind, and no more than the last bit beyond it.
    let worst = |kind: Limit| {
        let missed = probe.checks.iter().filter(|c| c.limit == kind && c.excess() > 0.0);
        missed.max_by(|a, b| a.excess().total_cmp(&b.excess())).map(|c| c.value)
    };
    let mut ease =
        |value: Option<f64>, set: &dyn Fn(&mut Limits, f64), relaxation: &dyn Fn(f64) -> Relaxation| {
            let eased = value.filter(|v| limit(spec, build, muscle, |l| set(l, *v)));
            out.extend(eased.map(relaxation));
        };
    let up = 1.0 + 1e-9;
    ease(worst(Limit::BulgedDiameter), &|l, v| l.bulged_diameter_mm = Some(v * up), &|bulged_diameter_mm| {
        Relaxation::MaxBulgedDiameter { bulged_diameter_mm }
    });
    ease(worst(Limit::MaxStretch), &|l, v| l.stretch = Some(v * up), &|max_stretch| Relaxation::MaxStretch {
        max_stretch,
    });
    ease(worst(Limit::StrandStrain), &|l, v| l.strand_strain = Some(v * up), &|strand_strain| {
        Relaxation::MaxStrandStrain { strand_strain }
    });
    ease(worst(Limit::Buckling), &|l, _| l.buckling = false, &|_| Relaxation::Guided {});
    ease(worst(Limit::LiquidVolume), &|l, v| l.liquid_volume_mm3 = Some(v * up), &|liquid_volume_mm3| {
        Relaxation::MaxLiquidVolume { liquid_volume_mm3 }
    });
    let margin = worst(Limit::BurstMargin).and_then(|_| Some(burst_margin(spec, build, muscle)?.1));
    ease(margin, &|l, v| l.burst_margin = Some(v * (1.0 - 1e-9)), &|burst_margin| {
        Relaxation::MinBurstMargin { burst_margin }
    });
    out
}

/// The pressure that all points need.
fn pressure(spec: &Spec, build: &Build<'_>, muscle: &Muscle) -> Option<Relaxation> {
    let (model, workspace) = (build(muscle).ok()?, &mut Workspace::new());
    let beyond = Options { extrapolate: true, ..spec.options() };
    let mut evaluation = Evaluation::new(model.as_ref(), workspace, beyond);
    let wanted = spec.points(muscle);
    let needs = wanted.iter().map(|p| evaluation.pressure_at(p.force_n, p.contraction));
    let pressure_mpa = needs.collect::<Result<Vec<f64>, _>>().ok()?.into_iter().fold(0.0, f64::max);
    let extrapolated = pressure_mpa > model.info().range.pressure_mpa.1;
    let relaxed = Spec { max_pressure_mpa: pressure_mpa * (1.0 + 1e-9), extrapolate: true, ..spec.clone() };
    fits(&relaxed, build, muscle).then_some(Relaxation::MaxPressure { pressure_mpa, extrapolated })
}

fn falls_short(p: &OperatingPoint, pull: Option<f64>) -> bool {
    pull.is_some_and(|pull| pull / p.force_n < 1.0)
}

/// Other operating points in place of those that fall short.
fn points(
    spec: &Spec,
    build: &Build<'_>,
    muscle: &Muscle,
    pulls: &[Option<f64>],
    mut instead: impl FnMut(&OperatingPoint, Option<f64>) -> Option<OperatingPoint>,
) -> Option<Vec<OperatingPoint>> {
    let mut list = spec.points(muscle).into_owned();
    let mut changed = vec![];
    for (p, &pull) in list.iter_mut().zip(pulls) {
        if falls_short(p, pull) {
            *p = instead(p, pull)?;
            changed.push(*p);
        }
    }
    // The last bit of an inverse must not decide.
    let eased = list.iter().map(|p| OperatingPoint { force_n: p.force_n * (1.0 - 1e-9), ..*p }).collect();
    let relaxed = Spec { wanted: Demand::Points(eased), ..spec.clone() };
    fits(&relaxed, build, muscle).then_some(changed)
}

/// Whether another limit alone makes the muscle fit.
fn limit(spec: &Spec, build: &Build<'_>, muscle: &Muscle, ease: impl Fn(&mut Limits)) -> bool {
    let mut relaxed = spec.clone();
    ease(&mut relaxed.limits);
    fits(&relaxed, build, muscle)
}

/// The smallest diameter beyond the bound that fits: by the design's model or, outside of its range, by the thick-wall
/// model scaled so that both agree on `muscle`.
fn wider(spec: &Spec, build: &Build<'_>, muscle: &Muscle) -> Option<Relaxation> {
    let own = build(muscle).ok()?;
    if let Some(outer_diameter_mm) = smallest_wider(spec, build, muscle) {
        return Some(Relaxation::OuterDiameter {
            outer_diameter_mm,
            model: own.info().name.to_string(),
            scaled_to: None,
        });
    }
    let thick: &Build<'_> = &|m| ModelKind::ThickWall.build(m);
    let other = thick(muscle).ok()?;
    let workspace = &mut Workspace::new();
    let scaled = |p: &OperatingPoint| {
        let mut at = |m: &dyn ForceModel| m.force_n(workspace, spec.max_pressure_mpa, p.contraction).ok();
        let ratio = at(&*other)? / at(own.as_ref())?;
        (ratio.is_finite() && ratio > 0.0).then_some(OperatingPoint { force_n: p.force_n * ratio, ..*p })
    };
    let points = spec.points(muscle).iter().map(scaled).collect::<Option<Vec<_>>>()?;
    let spec = Spec { wanted: Demand::Points(points), ..spec.clone() };
    let outer_diameter_mm = smallest_wider(&spec, thick, muscle)?;
    let scaled_to = Some(own.info().name.to_string());
    Some(Relaxation::OuterDiameter { outer_diameter_mm, model: other.info().name.to_string(), scaled_to })
}

fn smallest_wider(spec: &Spec, build: &Build<'_>, muscle: &Muscle) -> Option<f64> {
    let (_, high) = spec.outer_diameter_mm.bounds();
    let does = |d0: f64| {
        let muscle = muscle.with_section(d0, muscle.wall_mm());
        muscle.is_ok_and(|m| fits(spec, build, &m))
    };
    let wide = |i: i32| high * (1.0 + 0.05 * f64::from(i));
    let first = (1..=40).find(|&i| does(wide(i)))?;
    let (mut low, mut top) = (wide(first - 1), wide(first));
    for _ in 0..30 {
        let mid = 0.5 * (low + top);
        if does(mid) { top = mid } else { low = mid }
    }
    Some((top * 100.0).ceil() / 100.0)
}
