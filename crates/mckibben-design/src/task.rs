//! The main job as a whole: a specification that leaves some things open, and what is chosen.

use crate::{
    Bundle, Candidate, Models, Outcome, Relaxation, Several, Spec, SpecError, bundle, design_joint,
    design_with, other_parts::other_parts,
};
use mckibben_core::{
    progress::{CancelOnly, Progress},
    units::Values,
};

/// What a specification leaves open, so that another one may be tried where nothing fits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Open {
    /// The number of muscles: where no single one does, as few as do share what is required.
    pub count: bool,
    pub sleeves: bool,
    /// The rubbers of tubes that are cast.
    pub rubbers: bool,
}

/// A specification, and what may be tried where nothing meets it.
#[derive(Debug, Clone)]
pub struct Task {
    /// What is required, of one muscle where the number is open.
    pub spec: Spec,
    /// Radii in mm of the pulley of a joint.
    pub radius_mm: Option<Values>,
    /// What else is open.
    pub open: Open,
}

/// What a task found.
#[derive(Debug, Clone)]
pub struct Design {
    /// The specification that it meets, with the number of muscles and the pulley that were chosen.
    pub spec: Spec,
    /// The muscles.
    pub outcome: Outcome,
    /// Whether several muscles share what no single one gives.
    pub is_shared: bool,
    /// In place of one muscle: the slimmest bundle, where it is slimmer.
    pub slimmest_bundle: Option<Several>,
    /// Where no candidate is sure: what is.
    pub to_be_sure: Option<Several>,
    /// What the muscles of a bundle do together, where their number is given or chosen.
    pub bundle: Option<Bundle>,
    /// Where nothing fits: what to change, what asks for least first.
    pub relaxations: Vec<Relaxation>,
}

/// Numbers of muscles that are tried, as multiples of the least.
const COUNTS: [f64; 4] = [1.0, 1.01, 1.5, 2.0];

impl Task {
    /// Searches, and decides.
    ///
    /// # Errors
    /// [`SpecError`] where the specification cannot be searched, or the caller ended it.
    pub fn solve(&self, models: Models<'_>, progress: &dyn Progress) -> Result<Design, SpecError> {
        let quiet = &CancelOnly(progress);
        let first = self.search(&self.spec, models, progress)?;
        let shared = self.shared(&self.spec, &first, models, quiet)?;
        let is_shared = shared.is_some();
        let (spec, outcome) = shared.as_ref().unwrap_or(&first);
        let winner = outcome.candidates.first();
        let is_sure = |c: &Candidate| c.sure_pressure_mpa.is_some();
        let mut to_be_sure = None;
        if spec.guaranteed.is_none() && !outcome.candidates.iter().any(is_sure) {
            let sure = &first.1.sharing.sure;
            to_be_sure = sure.settled(&first.0.to_be_sure(), models, quiet);
            if to_be_sure.is_none() && self.radius_mm.is_none() && winner.is_some() {
                to_be_sure = self.guaranteed(models, quiet);
            }
        }
        let slimmest_bundle = winner.filter(|_| !is_shared).and_then(|winner| {
            let one = Several {
                count: 1,
                candidate: winner.clone(),
            };
            let bundle = outcome.sharing.bundles.settled(spec, models, quiet)?;
            (bundle.size() < one.size()).then_some(bundle)
        });
        progress.check()?;
        let bundle = winner
            .filter(|_| is_shared || !self.open.count)
            .map(|winner| bundle::of_winner(spec, models.decides(), winner));
        let mut relaxations = vec![];
        if let Some(closest) = &outcome.closest {
            relaxations = closest.relaxations(spec, models, quiet);
            relaxations.extend(other_parts(spec, self.open, models, closest, quiet));
        }
        let (spec, outcome) = shared.unwrap_or(first);
        Ok(Design {
            is_shared,
            slimmest_bundle,
            to_be_sure,
            bundle,
            relaxations,
            spec,
            outcome,
        })
    }

    /// What is chosen where the pull is guaranteed.
    fn guaranteed(&self, models: Models<'_>, progress: &dyn Progress) -> Option<Several> {
        let one = self.spec.to_be_sure();
        let first = self.search(&one, models, progress).ok()?;
        let shared = self.shared(&one, &first, models, progress).ok()?;
        let (spec, outcome) = shared.unwrap_or(first);
        Some(Several {
            count: spec.count,
            candidate: outcome.candidates.into_iter().next()?,
        })
    }

    fn search(
        &self,
        spec: &Spec,
        models: Models<'_>,
        progress: &dyn Progress,
    ) -> Result<(Spec, Outcome), SpecError> {
        match &self.radius_mm {
            Some(radius_mm) => design_joint(spec, radius_mm, models, progress),
            None => Ok((spec.clone(), design_with(spec, models, progress)?)),
        }
    }

    /// Where no single muscle meets what is required and their number is open: as few side by side
    /// as do, and as the envelope has room for.
    fn shared(
        &self,
        one: &Spec,
        (searched, outcome): &(Spec, Outcome),
        models: Models<'_>,
        progress: &dyn Progress,
    ) -> Result<Option<(Spec, Outcome)>, SpecError> {
        let Some(closest) = outcome.closest.as_ref().filter(|_| self.open.count) else {
            return Ok(None);
        };
        let bundles = &outcome.sharing.bundles;
        if let Some(bundle) = bundles.settled(searched, models, progress) {
            return self
                .search(&one.shared_by(bundle.count), models, progress)
                .map(Some);
        }
        let share = closest.largest_share(searched, models, progress);
        let counts = COUNTS.map(|multiple| (multiple / share.unwrap_or(0.0)).ceil());
        let most = f64::from(bundle::MOST);
        for count in counts.into_iter().take_while(|count| *count <= most) {
            let found = self.search(&one.shared_by(count as u32), models, progress)?;
            if !found.1.candidates.is_empty() {
                return Ok(Some(found));
            }
        }
        Ok(None)
    }
}
