//! A law as elements take it: those in the invariants take the short way, others the way through
//! principal stretches.

use super::{
    plane::{AnyPlaneLaw, ByInvariants},
    spatial::SpatialLaw,
    stretches::ByStretches,
};
use mckibben_core::rubber::{InvariantLaw, Law, LawVisitor, RubberLaw};

/// A law in both states of deformation.
pub struct ElementLaw<'a> {
    /// In an axisymmetric state.
    pub plane: &'a dyn AnyPlaneLaw,
    /// In any state.
    pub space: SpatialLaw<'a>,
}

/// Gives `work` the law.
pub fn with_law<T>(law: &Law, work: impl FnOnce(ElementLaw<'_>) -> T) -> T {
    law.visit(Visitor(work))
}

struct Visitor<W>(W);

impl<T, W: FnOnce(ElementLaw<'_>) -> T> LawVisitor for Visitor<W> {
    type Output = T;

    fn law<L: RubberLaw>(self, law: &L) -> T {
        self.0(ElementLaw {
            plane: &ByStretches(law),
            space: SpatialLaw::Stretches(law),
        })
    }

    fn invariant_law<L: InvariantLaw>(self, law: &L) -> T {
        self.0(ElementLaw {
            plane: &ByInvariants(law),
            space: SpatialLaw::Invariants(law),
        })
    }
}
