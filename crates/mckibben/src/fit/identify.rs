//! Constants of a muscle from points in memory.

use crate::Model;
use mckibben_core::muscle::Muscle;
use mckibben_fit::{
    identify::{Identification, IdentificationRequest, IdentifyError, identify},
    measured::DataPoint,
};

impl Model {
    /// The constants of a muscle with which this model comes nearest to measured points: nothing is
    /// named as free, so each has its interval from the points and from what measured muscles tell.
    ///
    /// Points are counted from 1 where they have no line of a file; messages call that a line. For
    /// free and fixed constants, and weights, take [`IdentificationRequest`].
    ///
    /// # Errors
    /// [`IdentifyError`] for points that are too few, or that no such muscle gives.
    pub fn identify(
        &self,
        muscle: &Muscle,
        points: &[DataPoint],
    ) -> Result<Identification, IdentifyError> {
        let counted = |(number, point): (u64, &DataPoint)| DataPoint {
            line: if point.line == 0 { number } else { point.line },
            ..*point
        };
        let points: Vec<DataPoint> = (1..).zip(points).map(counted).collect();
        let build = |muscle: &Muscle| self.bound(muscle);
        identify(&IdentificationRequest::new(muscle, &[], &points, &build))
    }
}
