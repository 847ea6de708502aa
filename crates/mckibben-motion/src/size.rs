//! The smallest valve that is quick enough.

use crate::{
    Actuator, Commanded, Drive, Motion, MotionError, Result, equilibrium,
    metrics::{changes, rise_time},
    run,
};
use mckibben_core::progress::Progress;

/// A valve that is large enough.
#[derive(Debug, Clone, PartialEq)]
pub struct SizedValve {
    /// C of the supply path of the first valve in L/(s bar); all conductances were changed by the
    /// same factor.
    pub conductance_l_per_s_bar: f64,
    /// Rise time with it in s.
    pub rise_time_s: f64,
    /// The motion with it.
    pub motion: Motion,
}

/// The largest conductance that is tried, in L/(s bar): a valve of 24,000 l/min.
const LARGEST: f64 = 100.0;

/// The smallest conductance with which the first step of a pressure's command rises (10–90 % of its
/// way: [`Motion::rise_time_s`]) within a time. A larger valve is quicker: the root is
/// bracketed by factors of four, and halved to 0.1 %.
///
/// # Errors
/// [`MotionError::NoAnswer`] where even 100 L/(s bar) is too slow; [`MotionError::Refused`] without
/// a step that moves it; those of [`run`].
pub fn size(drive: &Drive, rise_time_s: f64, progress: &dyn Progress) -> Result<SizedValve> {
    let no_rise = || {
        MotionError::Refused("the command has no rise, so that no valve can be sized by it".into())
    };
    MotionError::positive("the rise time in s", rise_time_s)?;
    drive.check()?;
    let valve = drive.muscles.iter().find_map(|m| match m.actuator {
        Actuator::Valve(v) => Some(v.supply.conductance_l_per_s_bar),
        _ => None,
    });
    MotionError::require(!drive.muscles.iter().any(|m| m.fluid.is_liquid()), || {
        "only valves of air are sized by a rise time; leave it out, and try flows of the valve or \
         pump"
            .into()
    })?;
    let (Some(given), Commanded::Pressure(commands)) = (valve, &drive.target) else {
        return Err(no_rise());
    };
    let changes = changes(drive);
    let begin = changes.first().copied().ok_or_else(no_rise)?;
    let end = changes.get(1).copied().unwrap_or(drive.until_s);
    let still = |within: f64| {
        let pressures = Vec::from_iter(commands.iter().map(|c| c.value(within)));
        equilibrium(drive, &pressures).map(|e| e.coordinate)
    };
    let from = still(0.5 * begin)?;
    let to = still(0.5 * (begin + end))?;
    if from == to {
        return Err(no_rise());
    }
    let rise = |c: f64| -> Result<(Option<f64>, Motion)> {
        let mut drive = drive.clone();
        for muscle in &mut drive.muscles {
            if let Actuator::Valve(v) = &mut muscle.actuator {
                (v.supply, v.exhaust) = (v.supply.scaled(c / given), v.exhaust.scaled(c / given));
            }
        }
        match run(&drive, progress) {
            Ok(motion) => {
                // With friction it comes to rest beside the equilibrium: the rise time is that of
                // the motion, once it has arrived at the one or settled beside it.
                let is_there = motion.settling_time_s.is_some()
                    || rise_time(&motion, from, to, (begin, end)).is_some();
                Ok((motion.rise_time_s.filter(|_| is_there), motion))
            }
            // With a small valve the load may not be lifted in time.
            Err(MotionError::NeverLifted(_)) => Ok((None, Motion::default())),
            Err(error) => Err(error),
        }
    };
    smallest(rise_time_s, given, rise)?.ok_or_else(no_rise)
}

/// The smallest conductance whose rise time is short enough, from one that is given.
fn smallest(
    rise_time_s: f64,
    given: f64,
    rise: impl Fn(f64) -> Result<(Option<f64>, Motion)>,
) -> Result<Option<SizedValve>> {
    let met = |rise: Option<f64>| rise.is_some_and(|r| r <= rise_time_s);
    let mut c = given.min(LARGEST);
    let mut best = None;
    loop {
        let (reached_s, motion) = rise(c)?;
        if met(reached_s) {
            best = Some((c, motion));
            c /= 4.0;
            if c < 1e-6 {
                break;
            }
        } else if best.is_some() {
            break;
        } else if c >= LARGEST {
            let reached = reached_s.map_or_else(
                || "the load does not reach 90 % of its stroke".to_owned(),
                |reached_s| format!("it is {reached_s} s"),
            );
            return Err(MotionError::NoAnswer(format!(
                "a rise time of {rise_time_s} s is not met by any valve: with {c} L/(s bar) \
                 {reached}; raise the supply or lower the mass"
            )));
        } else {
            c = (4.0 * c).min(LARGEST);
        }
    }
    let Some((mut high, mut motion)) = best else {
        return Ok(None);
    };
    let mut low = c;
    while high / low > 1.001 {
        let mid = (high * low).sqrt();
        let (r, m) = rise(mid)?;
        if met(r) {
            (high, motion) = (mid, m);
        } else {
            low = mid;
        }
    }
    Ok(Some(SizedValve {
        conductance_l_per_s_bar: high,
        rise_time_s: motion.rise_time_s.unwrap_or(rise_time_s),
        motion,
    }))
}
