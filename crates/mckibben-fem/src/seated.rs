//! Finite elements of a muscle whose ends give way: tests and searches with the contraction of the whole muscle.

use crate::FemError;
use crate::results::{Sensitivity, Solution, TangentPoint};
use crate::simulation::Simulation;
use crate::solver::curve::{Curve, CurvePoint};
use crate::solver::newton::Effort;
use mckibben::budget::Exceeded;
use mckibben::model::{Response, Seated, Workspace};
use mckibben::muscle::{Ends, Met, Muscle};
use mckibben::progress::{Progress, Silent};

/// The elements themselves where nothing is said of the ends of `muscle`, else the whole muscle; `model` is of [`Muscle::between_ends`].
pub fn seated(model: Box<dyn Simulation>, muscle: &Muscle) -> Box<dyn Simulation> {
    if muscle.ends().give() { Box::new(Seated::new(model, muscle)) } else { model }
}

type Whole = Seated<dyn Simulation>;

/// An error of the muscle between its ends, which give way by `way_mm`, with contractions of the whole muscle.
fn told(of: &Whole, way_mm: f64, mut error: FemError) -> FemError {
    let whole = |x: f64| of.ends().whole(x, way_mm);
    match &mut error {
        FemError::Path { contraction, last, .. } => {
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

fn slips(of: &Whole) -> bool {
    of.ends().slip_mm_per_n > 0.0
}

/// One equilibrium of the muscle between its ends.
fn inner(
    of: &Whole,
    w: &mut Workspace,
    p: f64,
    x: f64,
    sensitivities: bool,
) -> Result<TangentPoint, FemError> {
    let points = of.inner().isometric_with_tangents(w, x, &[p], sensitivities, &Silent);
    points.into_iter().next().unwrap_or(Err(FemError::Question { pressure_mpa: p, contraction: x }))
}

/// Where the ends stand.
fn met(of: &Whole, w: &mut Workspace, p: f64, e: f64) -> Result<Met, FemError> {
    let ends = of.ends();
    let found = ends.meet(p, e, |x| {
        let way = ends.way_between_mm(e, x);
        let found = inner(of, w, p, x, false).map_err(|error| told(of, way, error))?;
        Ok::<_, FemError>((found.response.force_n, found.response.stiffness_n_per_mm.unwrap_or(0.0)))
    })?;
    found.ok_or(FemError::Ends { pressure_mpa: p, contraction: e, steps: Ends::STEPS })
}

/// Where the ends stand at an equilibrium that was found.
fn met_at(of: &Whole, r: &Response) -> Met {
    let ends = of.ends();
    let way = ends.way_mm(r.pressure_mpa, r.force_n);
    Met {
        pressure_mpa: r.pressure_mpa,
        whole: ends.whole(r.contraction, way),
        between: r.contraction,
        load_n: ends.load_n(r.pressure_mpa, r.force_n),
        stiffness_n_per_mm: r.stiffness_n_per_mm.unwrap_or(0.0),
    }
}

fn sensitivities(of: &Whole, at: &Met, list: &mut [Sensitivity]) {
    for slope in list {
        slope.force_n_per_unit = of.ends().slope(at, &slope.name, slope.force_n_per_unit);
    }
}

/// A solution of the muscle between its ends as one of the whole, at a contraction that was asked for or is found.
fn solution(of: &Whole, asked: Option<f64>, mut found: Solution) -> Solution {
    let mut at = met_at(of, &found.response);
    at.whole = asked.unwrap_or(at.whole);
    sensitivities(of, &at, &mut found.sensitivities);
    found.response = of.whole(&at, found.response);
    found
}

/// A point of the muscle between its ends as one of the whole.
fn point(of: &Whole, point: CurvePoint) -> CurvePoint {
    let ends = of.ends();
    let slip_mm = ends.slip_mm_per_n * ends.load_n(point.pressure_mpa, point.force_n);
    CurvePoint {
        contraction: ends.whole(point.contraction, ends.seating_mm + slip_mm),
        volume_mm3: point.volume_mm3 + ends.bore_mm2() * slip_mm,
        ..point
    }
}

/// A curve of the muscle between its ends, with the contractions that were asked for to the last bit.
fn curve(of: &Whole, points: Curve, asked: impl Fn(usize) -> Option<f64>) -> Curve {
    let way = of.ends().seating_mm;
    let one = |(i, found): (usize, Result<CurvePoint, FemError>)| {
        let found = point(of, found.map_err(|error| told(of, way, error))?);
        Ok(CurvePoint { contraction: asked(i).unwrap_or(found.contraction), ..found })
    };
    points.into_iter().enumerate().map(one).collect()
}

/// Points of ends that slip, each where its own ends stand: in the order of `before`, as the elements go from one to the next.
fn points<T>(
    list: &[f64],
    before: impl Fn(&f64, &f64) -> std::cmp::Ordering,
    progress: &dyn Progress,
    mut one: impl FnMut(f64) -> Result<T, FemError>,
) -> Vec<Result<T, FemError>> {
    let mut order: Vec<usize> = (0..list.len()).collect();
    order.sort_by(|&a, &b| before(&list[a], &list[b]));
    let mut found: Vec<(usize, Result<T, FemError>)> = vec![];
    for i in order {
        progress.report(found.len(), list.len());
        let ended = if progress.cancelled() { Err(Exceeded::Cancelled) } else { progress.budget().check() };
        found.push((i, ended.map_err(FemError::from).and_then(|()| one(list[i]))));
    }
    found.sort_by_key(|f| f.0);
    found.into_iter().map(|f| f.1).collect()
}

/// A point of a curve of ends that slip.
fn slipped(of: &Whole, w: &mut Workspace, p: f64, e: f64) -> Result<CurvePoint, FemError> {
    let before = of.inner().effort(w);
    let met = met(of, w, p, e)?;
    let found = of.inner().isobaric(w, p, &[met.between], &Silent).into_iter().next();
    let missing = FemError::Question { pressure_mpa: p, contraction: e };
    let after = of.inner().effort(w);
    let found = point(of, found.unwrap_or(Err(missing))?);
    Ok(CurvePoint {
        contraction: e,
        iterations: after.iterations - before.iterations,
        factorisations: after.factorisations - before.factorisations,
        ..found
    })
}

/// x at which a pull is reached: the pressure and the load of the ends are found together, by secants.
fn between_at_force(of: &Whole, w: &mut Workspace, force_n: f64, e: f64) -> Result<f64, FemError> {
    let ends = of.ends();
    let at = |p: f64| ends.between(e, ends.way_mm(p, force_n));
    if !slips(of) {
        return Ok(at(0.0));
    }
    let mut miss = |p: f64| {
        let x = at(p);
        let found = of.inner().pressure_at_force_mpa(w, force_n, x);
        found.map(|found| found - p).map_err(|error| told(of, ends.way_between_mm(e, x), error))
    };
    let (mut low, mut low_miss) = (0.0, miss(0.0)?);
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
    Err(FemError::Ends { pressure_mpa: p, contraction: e, steps: Ends::STEPS })
}

impl Simulation for Whole {
    fn solve(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<Solution, FemError> {
        let x = if slips(self) {
            met(self, workspace, p, e)?.between
        } else {
            self.ends().between(e, self.ends().seating_mm)
        };
        let way = self.ends().way_between_mm(e, x);
        let found = self.inner().solve(workspace, p, x).map_err(|error| told(self, way, error))?;
        Ok(solution(self, Some(e), found))
    }

    fn at_force(&self, workspace: &mut Workspace, force_n: f64, p: f64) -> Result<Solution, FemError> {
        let way = self.ends().way_mm(p, force_n);
        let found = self.inner().at_force(workspace, force_n, p).map_err(|error| told(self, way, error))?;
        Ok(solution(self, None, found))
    }

    fn at_pressure_for(&self, workspace: &mut Workspace, force_n: f64, e: f64) -> Result<Solution, FemError> {
        let x = between_at_force(self, workspace, force_n, e)?;
        let way = self.ends().way_between_mm(e, x);
        let found = self.inner().at_pressure_for(workspace, force_n, x);
        Ok(solution(self, Some(e), found.map_err(|error| told(self, way, error))?))
    }

    fn contraction_at_force(&self, workspace: &mut Workspace, force_n: f64, p: f64) -> Result<f64, FemError> {
        let way = self.ends().way_mm(p, force_n);
        let found = self.inner().contraction_at_force(workspace, force_n, p);
        found.map(|x| self.ends().whole(x, way)).map_err(|error| told(self, way, error))
    }

    fn pressure_at_force_mpa(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        e: f64,
    ) -> Result<f64, FemError> {
        let x = between_at_force(self, workspace, force_n, e)?;
        let found = self.inner().pressure_at_force_mpa(workspace, force_n, x);
        found.map_err(|error| told(self, self.ends().way_between_mm(e, x), error))
    }

    fn isometric(
        &self,
        workspace: &mut Workspace,
        e: f64,
        pressures_mpa: &[f64],
        progress: &dyn Progress,
    ) -> Curve {
        if slips(self) {
            return points(
                pressures_mpa,
                |a, b| b.total_cmp(a),
                progress,
                |p| slipped(self, workspace, p, e),
            );
        }
        let x = self.ends().between(e, self.ends().seating_mm);
        curve(self, self.inner().isometric(workspace, x, pressures_mpa, progress), |_| Some(e))
    }

    fn isometric_with_tangents(
        &self,
        workspace: &mut Workspace,
        e: f64,
        pressures_mpa: &[f64],
        wanted: bool,
        progress: &dyn Progress,
    ) -> Vec<Result<TangentPoint, FemError>> {
        let whole = |mut found: TangentPoint| {
            let at = Met { whole: e, ..met_at(self, &found.response) };
            sensitivities(self, &at, &mut found.sensitivities);
            found.response = self.whole(&at, found.response);
            found
        };
        if slips(self) {
            return points(
                pressures_mpa,
                |a, b| b.total_cmp(a),
                progress,
                |p| {
                    let x = met(self, workspace, p, e)?.between;
                    inner(self, workspace, p, x, wanted).map(whole)
                },
            );
        }
        let x = self.ends().between(e, self.ends().seating_mm);
        let points = self.inner().isometric_with_tangents(workspace, x, pressures_mpa, wanted, progress);
        let way = self.ends().seating_mm;
        points.into_iter().map(|point| point.map(whole).map_err(|error| told(self, way, error))).collect()
    }

    fn isobaric(
        &self,
        workspace: &mut Workspace,
        p: f64,
        contractions: &[f64],
        progress: &dyn Progress,
    ) -> Curve {
        if slips(self) {
            return points(contractions, f64::total_cmp, progress, |e| slipped(self, workspace, p, e));
        }
        let way = self.ends().seating_mm;
        let between: Vec<f64> = contractions.iter().map(|e| self.ends().between(*e, way)).collect();
        let points = self.inner().isobaric(workspace, p, &between, progress);
        curve(self, points, |i| contractions.get(i).copied())
    }

    fn isotonic(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressures_mpa: &[f64],
        progress: &dyn Progress,
    ) -> Curve {
        curve(self, self.inner().isotonic(workspace, force_n, pressures_mpa, progress), |_| None)
    }

    fn effort(&self, workspace: &Workspace) -> Effort {
        self.inner().effort(workspace)
    }
}

#[cfg(test)]
mod tests;
