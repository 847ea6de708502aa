//! Points by their muscles.

use crate::measured::{DataPoint, Section};
use mckibben_core::threads;

/// A value of every point, in their order, where `compute` gives those at some places of a section.
pub fn by_section<T: Send>(
    points: &[DataPoint],
    compute: impl Fn(&Section, &[usize]) -> Option<Vec<T>> + Sync,
) -> Option<Vec<T>> {
    let mut groups: Vec<(Section, Vec<usize>)> = vec![];
    for (i, point) in points.iter().enumerate() {
        match groups.iter_mut().find(|g| g.0 == point.section) {
            Some(group) => group.1.push(i),
            None => groups.push((point.section, vec![i])),
        }
    }
    let lists = threads::map(&groups, |(section, places)| compute(section, places));
    let mut out: Vec<Option<T>> = points.iter().map(|_| None).collect();
    for ((_, places), list) in groups.iter().zip(lists) {
        for (&i, value) in places.iter().zip(list?) {
            out[i] = Some(value);
        }
    }
    out.into_iter().collect()
}
