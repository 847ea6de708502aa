//! Finite elements of a muscle with ends that yield: equilibria and tests with contraction, pull
//! and volume of the whole muscle.

use crate::{
    FemError, Result,
    results::{Sensitivity, Solution},
    simulation::{Detail, ElementModel, Given},
    solver::curve::{Curve, CurvePoint, falling},
};
use mckibben_core::{
    cancel::{self, Cancelled},
    model::{Response, Seated, Workspace},
    muscle::{EndState, Ends, Muscle},
};

/// The elements themselves where `muscle` does not describe its ends, else the whole muscle;
/// `model` is of [`Muscle::between_ends`].
pub fn with_ends(muscle: &Muscle, model: Box<dyn ElementModel>) -> Box<dyn ElementModel> {
    if muscle.ends().give() {
        Box::new(Seated::new(model, muscle))
    } else {
        model
    }
}

type Whole = Seated<dyn ElementModel>;

/// An error of the muscle between its ends, which are displaced by `displacement_mm`, with
/// contractions of the whole muscle.
fn for_whole_muscle(muscle: &Whole, displacement_mm: f64, mut error: FemError) -> FemError {
    let whole = |x: f64| muscle.ends.whole(x, displacement_mm);
    match &mut error {
        FemError::Path {
            contraction, last, ..
        } => {
            *contraction = whole(*contraction);
            last.contraction = whole(last.contraction);
        }
        FemError::Question { contraction, .. } | FemError::OutOfReach { contraction, .. } => {
            *contraction = whole(*contraction);
        }
        _ => {}
    }
    error
}

/// One equilibrium of the muscle between its ends.
fn inner(muscle: &Whole, w: &mut Workspace, p: f64, x: f64, detail: Detail) -> Result<CurvePoint> {
    muscle
        .inner
        .isometric(w, x, &[p], detail)
        .into_iter()
        .next()
        .unwrap_or(Err(FemError::Question {
            pressure_mpa: p,
            contraction: x,
        }))
}

/// x of the ends at a pressure and a contraction of the whole.
fn between(muscle: &Whole, w: &mut Workspace, p: f64, e: f64) -> Result<f64> {
    let ends = &muscle.ends;
    if ends.slip_mm_per_n == 0.0 {
        return Ok(ends.between(e, ends.seating_mm));
    }
    let state = muscle.solve_ends(w, p, e, |w, x| {
        let point = inner(muscle, w, p, x, Detail::Tangent);
        let point =
            point.map_err(|e2| for_whole_muscle(muscle, ends.displacement_between_mm(e, x), e2))?;
        Ok::<_, FemError>(point.response.unwrap_or_default())
    })?;
    state.map(|state| state.between).ok_or(FemError::Ends {
        pressure_mpa: p,
        contraction: e,
    })
}

/// x at which a pull is reached: pressure and load of the ends are solved together, by secants.
fn between_at_pull(muscle: &Whole, w: &mut Workspace, force_n: f64, e: f64) -> Result<f64> {
    let ends = &muscle.ends;
    let at = |p: f64| ends.between(e, ends.end_displacement_mm(p, force_n));
    if ends.slip_mm_per_n == 0.0 {
        return Ok(at(0.0));
    }
    let mut miss = |p: f64| {
        let x = at(p);
        muscle
            .inner
            .reach(
                w,
                Given::ContractionAndPull {
                    contraction: x,
                    force_n,
                },
            )
            .map(|point| point.pressure_mpa - p)
            .map_err(|error| for_whole_muscle(muscle, ends.displacement_between_mm(e, x), error))
    };
    let mut low = 0.0;
    let mut low_miss = miss(0.0)?;
    let mut p = low_miss;
    for _ in 0..Ends::STEPS {
        let here = miss(p)?;
        if here.abs() <= 1e-10 * (1.0 + p) {
            return Ok(at(p));
        }
        let slope = (here - low_miss) / (p - low);
        (low, low_miss) = (p, here);
        p -= if slope < 0.0 { here / slope } else { -here };
    }
    Err(FemError::Ends {
        pressure_mpa: p,
        contraction: e,
    })
}

/// What is given of the muscle between its ends, their displacement in mm, and the contraction of
/// the whole where it is given. Pressures are active ones.
fn given_between(
    muscle: &Whole,
    w: &mut Workspace,
    given: Given,
) -> Result<(Given, f64, Option<f64>)> {
    let ends = &muscle.ends;
    Ok(match given {
        Given::PressureAndContraction {
            pressure_mpa,
            contraction: e,
        } => {
            let active_mpa = ends.active_mpa(pressure_mpa);
            let x = between(muscle, w, active_mpa, e)?;
            (
                Given::at(active_mpa, x),
                ends.displacement_between_mm(e, x),
                Some(e),
            )
        }
        Given::PressureAndPull {
            pressure_mpa,
            force_n,
        } => {
            let pressure_mpa = ends.active_mpa(pressure_mpa);
            let given = Given::PressureAndPull {
                pressure_mpa,
                force_n,
            };
            (given, ends.end_displacement_mm(pressure_mpa, force_n), None)
        }
        Given::ContractionAndPull {
            contraction: e,
            force_n,
        } => {
            let x = between_at_pull(muscle, w, force_n, e)?;
            let given = Given::ContractionAndPull {
                contraction: x,
                force_n,
            };
            (given, ends.displacement_between_mm(e, x), Some(e))
        }
    })
}

/// A response of the muscle between its ends, and its sensitivities, as those of the whole at a
/// contraction, which follows where it is not given.
fn whole(muscle: &Whole, given: Option<f64>, r: Response, list: &mut [Sensitivity]) -> Response {
    let ends = &muscle.ends;
    let displacement = ends.end_displacement_mm(r.pressure_mpa, r.force_n);
    let state = EndState {
        pressure_mpa: r.pressure_mpa,
        whole: given.unwrap_or_else(|| ends.whole(r.contraction, displacement)),
        between: r.contraction,
        load_n: ends.load_n(r.pressure_mpa, r.force_n),
        stiffness_n_per_mm: r.stiffness_n_per_mm.unwrap_or(0.0),
        load_per_pressure_mm2: None,
    };
    for slope in list {
        slope.force_n_per_unit = ends.slope(&state, &slope.name, slope.force_n_per_unit);
    }
    Response {
        pressure_mpa: ends.whole_mpa(r.pressure_mpa),
        ..muscle.whole(&state, r)
    }
}

/// A point of the muscle between its ends as one of the whole.
fn whole_point(muscle: &Whole, given: Option<f64>, mut point: CurvePoint) -> CurvePoint {
    let ends = &muscle.ends;
    let slip_mm = ends.slip_mm_per_n * ends.load_n(point.pressure_mpa, point.force_n);
    let contraction =
        given.unwrap_or_else(|| ends.whole(point.contraction, ends.seating_mm + slip_mm));
    point.response = point
        .response
        .map(|r| whole(muscle, given, r, &mut point.sensitivities));
    CurvePoint {
        pressure_mpa: ends.whole_mpa(point.pressure_mpa),
        contraction,
        volume_mm3: point.volume_mm3 + ends.bore_mm2() * slip_mm,
        ..point
    }
}

/// A point with the pressure that was given: below the take-up pressure the active one is zero.
fn at_pressure(mut point: CurvePoint, given_mpa: Option<f64>) -> CurvePoint {
    point.pressure_mpa = given_mpa.unwrap_or(point.pressure_mpa);
    if let Some(response) = &mut point.response {
        response.pressure_mpa = point.pressure_mpa;
    }
    point
}

impl ElementModel for Whole {
    fn solve(&self, workspace: &mut Workspace, given: Given) -> Result<Solution> {
        let stated_mpa = given.pressure_mpa();
        let (given, displacement, e) = given_between(self, workspace, given)?;
        let mut solution = self
            .inner
            .solve(workspace, given)
            .map_err(|error| for_whole_muscle(self, displacement, error))?;
        let ends = &self.ends;
        let active_mpa = solution.response.pressure_mpa;
        let load_n = ends.load_n(active_mpa, solution.response.force_n);
        let slip_mm = ends.slip_mm_per_n * load_n;
        solution.energies.ends_n_mm = 0.5 * slip_mm * load_n;
        solution.energies.pressure_n_mm += active_mpa * ends.bore_mm2() * slip_mm;
        let r = whole(self, e, solution.response, &mut solution.sensitivities);
        solution.response = Response {
            pressure_mpa: stated_mpa.unwrap_or(r.pressure_mpa),
            ..r
        };
        Ok(solution)
    }

    fn reach(&self, workspace: &mut Workspace, given: Given) -> Result<CurvePoint> {
        let stated_mpa = given.pressure_mpa();
        let (given, displacement, e) = given_between(self, workspace, given)?;
        let point = self
            .inner
            .reach(workspace, given)
            .map_err(|error| for_whole_muscle(self, displacement, error))?;
        let e = e.unwrap_or_else(|| self.ends.whole(point.contraction, displacement));
        Ok(at_pressure(whole_point(self, Some(e), point), stated_mpa))
    }

    fn isometric(
        &self,
        workspace: &mut Workspace,
        e: f64,
        pressures_mpa: &[f64],
        detail: Detail,
    ) -> Curve {
        let ends = &self.ends;
        if ends.slip_mm_per_n == 0.0 {
            let active: Vec<f64> = pressures_mpa.iter().map(|p| ends.active_mpa(*p)).collect();
            let points =
                self.inner
                    .isometric(workspace, ends.between(e, ends.seating_mm), &active, detail);
            return points
                .into_iter()
                .zip(pressures_mpa)
                .map(|(point, p): (Result<CurvePoint>, &f64)| {
                    let point =
                        point.map_err(|error| for_whole_muscle(self, ends.seating_mm, error))?;
                    Ok(at_pressure(whole_point(self, Some(e), point), Some(*p)))
                })
                .collect();
        }
        // Each with its end state: in the order of the test, as the elements go from one to the
        // next.
        let mut out: Curve = vec![Err(Cancelled.into()); pressures_mpa.len()];
        for i in falling(pressures_mpa) {
            if cancel::check().is_err() {
                break;
            }
            let p = ends.active_mpa(pressures_mpa[i]);
            let point =
                between(self, workspace, p, e).and_then(|x| inner(self, workspace, p, x, detail));
            out[i] = point.map(|point| {
                at_pressure(whole_point(self, Some(e), point), Some(pressures_mpa[i]))
            });
        }
        out
    }
}
