//! Loading, unloading and rupture, from the order of the points.

use super::{Mode, TensionPoint};
use crate::measured::runs;
use mckibben_core::by_number::*;

/// A turn back by more than this share of the range of stretches ends a run.
const TURN: f64 = 0.05;
/// Stress after the largest one, as a share of it, below which a specimen has failed.
const FAILED: f64 = 0.8;

/// Points as one test after another gave them.
#[derive(Default)]
pub struct Sorted {
    /// Those that can be fitted.
    pub kept: Vec<TensionPoint>,
    /// How many lie behind a rupture, by mode.
    pub after_rupture: Vec<(Mode, usize)>,
    /// Times a specimen was unloaded.
    pub unloadings: usize,
}

/// Leaves out the points behind a rupture, and counts the loops.
pub fn sort(points: &[TensionPoint]) -> Sorted {
    let mut out = Sorted::default();
    // Sheets are held at one state after another: there is no run to be followed.
    out.kept
        .extend(points.iter().filter(|p| p.mode == Mode::General));
    for mode in Mode::OF_ONE_STRETCH {
        let (mut pulled, pressed): (Vec<_>, Vec<_>) = points
            .iter()
            .filter(|p| p.mode == mode)
            .copied()
            .partition(|p| p.stretch >= 1.0);
        out.kept.extend(pressed);
        let stretches: Vec<f64> = pulled.iter().map(|p| p.stretch).collect();
        let mut ends: Vec<usize> = runs(&stretches, TURN)
            .into_iter()
            .map(|run| run.0)
            .collect();
        // One run may be listed from its end; points in no order, as collected from several
        // sources, are one run too.
        if ends.len() == 1 || (ends.len() > 2 && ends.len() > pulled.len() / 3) {
            pulled.sort_by_number(|a| a.stretch);
            ends = vec![pulled.len()];
        }
        let mut from = 0;
        let mut lost = 0;
        let mut broken = false;
        for end in ends {
            let run = &pulled[from..end];
            from = end;
            let up = run.last().map(|p| p.stretch) >= run.first().map(|p| p.stretch);
            if !up {
                // An unloading after a rupture has no stress.
                if broken {
                    lost += run.len();
                } else {
                    out.unloadings += 1;
                    out.kept.extend(run);
                }
                continue;
            }
            let good = before_rupture(run);
            broken = good < run.len();
            lost += run.len() - good;
            out.kept.extend(&run[..good]);
        }
        if lost > 0 {
            out.after_rupture.push((mode, lost));
        }
    }
    out
}

/// How many points of a loading lie before its rupture.
fn before_rupture(run: &[TensionPoint]) -> usize {
    let top = run
        .iter()
        .enumerate()
        .max_by_number(|a| a.1.nominal_stress_mpa);
    let Some((at, top)) = top.filter(|t| t.1.nominal_stress_mpa > 0.0 && t.1.stretch > 1.0) else {
        return run.len();
    };
    let falls = run[at..]
        .iter()
        .any(|p| p.nominal_stress_mpa < FAILED * top.nominal_stress_mpa);
    if falls { at + 1 } else { run.len() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(list: &[(f64, f64)]) -> Vec<TensionPoint> {
        let one =
            |&(stretch, stress): &(f64, f64)| TensionPoint::new(Mode::Uniaxial, stretch, stress);
        list.iter().map(one).collect()
    }

    #[test]
    fn what_comes_after_a_rupture_is_left_out_and_the_next_specimen_is_not() {
        let one = [
            (1.0, 0.0),
            (1.5, 0.2),
            (2.0, 0.4),
            (2.1, 0.39),
            (2.2, 0.02),
            (2.3, 0.0),
        ];
        let sorted = sort(&points(&one));
        assert_eq!((sorted.kept.len(), sorted.unloadings), (3, 0));
        assert_eq!(sorted.after_rupture, [(Mode::Uniaxial, 3)]);
        let two = [&one[..], &[(1.0, 0.0), (1.4, 0.2), (1.9, 0.4)]].concat();
        assert_eq!(sort(&points(&two)).kept.len(), 6);
    }

    #[test]
    fn loops_are_counted_and_kept() {
        let up = [
            (1.0, 0.0),
            (1.2, 0.1),
            (1.4, 0.2),
            (1.6, 0.3),
            (1.8, 0.35),
            (2.0, 0.4),
        ];
        let down: Vec<_> = up
            .iter()
            .rev()
            .skip(1)
            .map(|&(l, s)| (l, 0.8 * s))
            .collect();
        let both = [&up[..], &down, &up[1..], &down].concat();
        let sorted = sort(&points(&both));
        assert_eq!((sorted.kept.len(), sorted.unloadings), (both.len(), 2));
        assert!(sorted.after_rupture.is_empty());
    }

    #[test]
    fn points_in_no_order_are_one_loading() {
        let list = [
            (1.5, 0.2),
            (1.0, 0.0),
            (2.0, 0.4),
            (1.2, 0.1),
            (1.8, 0.3),
            (1.1, 0.05),
        ];
        let sorted = sort(&points(&list));
        assert_eq!((sorted.kept.len(), sorted.unloadings), (6, 0));
    }
}
