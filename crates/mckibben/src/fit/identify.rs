//! Constants of a muscle from points in memory.

use crate::Model;
use mckibben_core::muscle::Muscle;
use mckibben_fit::{
    identify::{Identification, IdentificationRequest, IdentifyError, Target, identify},
    measured::DataPoint,
};

/// What is to be identified of a muscle: begun by [`Model::identify`], answered by
/// [`solve`](Self::solve).
#[derive(Debug, Clone)]
pub struct Identify<'a> {
    model: &'a Model,
    muscle: &'a Muscle,
    free: Vec<Target>,
    points: Vec<DataPoint>,
}

impl Model {
    /// The constants of a muscle with which this model comes nearest to measured points: without
    /// names each has its interval from the points and from what measured muscles tell, as the
    /// command `identify` gives it.
    ///
    /// ```
    /// use mckibben::{fit::*, prelude::*};
    ///
    /// let muscle: Muscle = "[tube]\nouter_diameter = '16 mm'\nrubber = 'dragon-skin-30'".parse()?;
    /// let points = [(0.1, 0.0, 130.0), (0.2, 0.05, 230.0)].map(|(pressure_mpa, contraction, force_n)| {
    ///     let branch = Some(Direction::Mean);
    ///     DataPoint::new(MeasuredPoint { pressure_mpa, contraction, force_n, branch })
    /// });
    /// let found = Model::UNIVERSAL.identify(&muscle).free([Target::Modulus]).points(points).solve()?;
    /// assert_eq!(found.parameters.len(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn identify<'a>(&'a self, muscle: &'a Muscle) -> Identify<'a> {
        Identify {
            model: self,
            muscle,
            free: vec![],
            points: vec![],
        }
    }
}

impl Identify<'_> {
    /// These constants alone; all others are held.
    #[must_use]
    pub fn free(mut self, constants: impl IntoIterator<Item = Target>) -> Self {
        self.free.extend(constants);
        self
    }

    /// Measured points, counted from 1 where they have no line of a file; messages call that a line.
    #[must_use]
    pub fn points(mut self, points: impl IntoIterator<Item = DataPoint>) -> Self {
        self.points.extend(points);
        self
    }

    /// Their values, with their intervals.
    ///
    /// # Errors
    /// [`IdentifyError`] for points that are too few, or that no such muscle gives.
    pub fn solve(mut self) -> Result<Identification, IdentifyError> {
        for (number, point) in (1..).zip(&mut self.points) {
            if point.line == 0 {
                point.line = number;
            }
        }
        let build = |muscle: &Muscle| self.model.build(muscle);
        identify(&IdentificationRequest::new(
            self.muscle,
            &self.free,
            &self.points,
            &build,
        ))
    }
}
