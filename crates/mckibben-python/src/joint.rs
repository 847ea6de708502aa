//! A joint: how its angle shortens its muscles, and what turns it besides.

use crate::{error::Wrong, request, run};
use mckibben_app::{JointFields, understood};
use mckibben_core::joint::{Joint as Held, JointError};
use pyo3::prelude::*;

/// A joint.
#[pyclass(frozen, module = "mckibben._native")]
pub struct Joint {
    held: Held,
}

#[pymethods]
impl Joint {
    /// The joint of its file and those of its muscles.
    #[new]
    #[pyo3(signature = (request: "dict[str, typing.Any]"))]
    fn new(py: Python<'_>, request: &Bound<'_, PyAny>) -> PyResult<Self> {
        let request = request::given(py, "joint", request)?;
        run::quick(py, |_| {
            Ok(Self {
                held: understood::<JointFields>(&request)?.resolve()?,
            })
        })
    }

    /// Moment of inertia in kg m², and damping in N m s/rad.
    #[getter]
    fn link(&self) -> (f64, f64) {
        let link = self.held.link();
        (link.whole_inertia_kg_m2(), link.damping_nm_s_per_rad)
    }

    /// At an angle in degrees: torque of spring and weight in N m and its slope in N m/rad, then of
    /// each muscle its contraction, its moment arm in mm and the slope of that in mm. Beyond the
    /// range an error, or NaN.
    fn levers(&self, angle_deg: f64, nan: bool) -> PyResult<Vec<f64>> {
        let (low_deg, high_deg) = self.held.range_deg();
        let mut angle = angle_deg.to_radians();
        if !(low_deg..=high_deg).contains(&angle_deg) {
            if !nan {
                let outside = JointError::Angle {
                    angle_deg,
                    low_deg,
                    high_deg,
                };
                return Err(Wrong::Problem(outside.into(), None).into());
            }
            angle = f64::NAN;
        }
        let (torque, slope) = self.held.passive_nm(angle);
        let of_muscle = |i| self.held.contraction(i, angle);
        let levers = (0..)
            .map_while(of_muscle)
            .flat_map(|(e, s)| [e, s.arm_mm, s.arm_by_angle_mm]);
        Ok([torque, slope].into_iter().chain(levers).collect())
    }
}
