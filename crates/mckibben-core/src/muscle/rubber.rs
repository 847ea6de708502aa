//! What the rubber of a muscle must be.

use super::error::{MuscleError, positive};
use crate::{
    refused::Refused,
    rubber::{Bulk, Conditioned, Rubber},
};

impl Rubber {
    /// Whether its constants, its history and its bulk modulus are valid.
    ///
    /// # Errors
    /// [`MuscleError`] of the first that is not.
    pub(crate) fn check(&self) -> Result<(), MuscleError> {
        self.law
            .clone()
            .validated()
            .map_err(|e| e.within("tube.material"))?;
        if let Some(strain) = self.elongation_at_break {
            positive("tube.material.elongation_at_break", strain, "")?;
        }
        if let Some(softening) = self.softening {
            softening
                .validated()
                .map_err(|e| e.within("tube.material.softening"))?;
        }
        match self.conditioned {
            Some(Conditioned::Pressure(p)) => positive("tube.material.conditioned", p, "MPa")?,
            Some(Conditioned::Strain { strain }) => {
                positive("tube.material.conditioned", strain, "")?;
                // Beyond a stretch at which the law locks it has no energy.
                let energy = self.tension_energy_mpa(strain);
                let stretched = 1.0 + strain;
                let first_invariant = stretched * stretched + 2.0 / stretched - 3.0;
                let locked = self.law.locks_at().is_some_and(|j| first_invariant >= j);
                Refused::unless(
                    energy.is_finite() && !locked,
                    ["tube.material.conditioned"],
                    || {
                        format!(
                            "tube.material.conditioned is a strain of {strain}, at which the \
                             rubber's law has locked: state less, or the pressure of the cycles"
                        )
                    },
                )?;
            }
            None => {}
        }
        let softens = self.conditioned.is_none() || self.softening.is_some();
        Refused::unless(softens, ["tube.material.conditioned"], || {
            "tube.material.conditioned is stated, but the rubber has no tube.material.softening: \
             give its r, m and beta, or leave it out"
                .into()
        })?;
        if let Some(prony) = self.prony.clone() {
            prony
                .validated()
                .map_err(|e| e.within("tube.material.prony"))?;
        }
        match self.bulk {
            Bulk::Incompressible => Ok(()),
            Bulk::Modulus(k) => positive("tube.material.bulk_modulus", k, "MPa"),
        }
    }
}
