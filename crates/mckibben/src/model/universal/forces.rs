//! Many pulls of one muscle.

use super::Universal;
use super::coupled::{Root, Start};
use crate::model::Workspace;

/// Farthest in ε from which a point starts from the one before it.
const NEIGHBOUR: f64 = 0.02;

impl Universal {
    /// Pulls in N at pressures in MPa and contractions, each into its place of `out`; neighbours in the list that are
    /// neighbours in pressure and contraction are faster.
    ///
    /// A pull is within 1e-9 of the blocked force of what `force_n` answers, whose iteration starts elsewhere.
    /// False where the lists differ in length or a point has no answer.
    pub fn forces(&self, [pressures_mpa, contractions]: [&[f64]; 2], out: &mut [f64]) -> bool {
        if [pressures_mpa, contractions].iter().any(|list| list.len() != out.len()) {
            return false;
        }
        let mut workspace = Workspace::new();
        let mut last: Option<(f64, f64, Root)> = None;
        for ((&p, &e), place) in pressures_mpa.iter().zip(contractions).zip(out) {
            let near = last.filter(|l| (l.1 - e).abs() < NEIGHBOUR && (l.0 - p).abs() < NEIGHBOUR * p.abs());
            let from = near.map(|(_, e0, root)| root.moved((e0 - e) / root.slope));
            let root = self.coupled(p, e, from).or_else(|| from.and_then(|_| self.coupled(p, e, None)));
            let force = root.map_or_else(|| self.searched_force(&mut workspace, p, e), |root| Ok(root.force));
            let Ok(force) = force else { return false };
            *place = force;
            last = root.map(|root| (p, e, root));
        }
        true
    }
}

impl Root {
    /// A start where λ is larger.
    fn moved(&self, step: f64) -> Start {
        let by = |i: usize| self.end.stretches[i] + self.by.stretches[i] * step;
        Start { l: self.end.l + step, q: self.end.q + self.by.q * step, stretches: [by(0), by(1)] }
    }
}
