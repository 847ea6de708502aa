//! Errors of the fits that decide, each with a bound: regressions, but for those that somebody else
//! has derived.
//!
//! The 20° muscle of B. Tondu, *Modelling of the McKibben artificial muscle: a review*, J. Intell.
//! Mater. Syst. Struct. 23 (2012) 225–253, Fig. 3: outer diameter 14 mm, wall about 0.49 mm, length
//! 300 mm, rayon; the rubber is not stated, so that its modulus is fitted. Models are compared with
//! the mean of the two hysteresis branches.

use crate::{
    Result,
    case::MuscleCase,
    chosen::{ChosenFit, Parameter},
    fit::first_fit_residuals,
    left_out::Coverage,
    pulses,
};
use mckibben_core::{
    analysis::{Evaluation, Options},
    extremes::peak,
    joined,
    model::{Ideal, ThickWall, Workspace},
    muscle::{Muscle, measures::END_FACTOR},
    threads,
};
use mckibben_fit::{
    compare::compare,
    identify::{Build, Target},
    library::residual::ForceErrors,
    measured::{DataPoint, MeasuredPoint, mean_of_branches},
};

/// The share of the points of each way that the ± must cover.
const COVERAGE: f64 = 0.95;

/// A number with the largest error that passes.
#[derive(Debug)]
pub struct Row {
    pub name: String,
    pub reference: f64,
    pub computed: f64,
    pub error: f64,
    pub allowed: f64,
}

impl Row {
    pub fn holds(&self) -> bool {
        self.error <= self.allowed
    }
}

/// The bounds of the cases that the program carries.
pub fn rows(cases: &[&MuscleCase], build: &Build<'_>) -> Result<Vec<Row>> {
    let tondu = cases.iter().find(|case| case.name == "tondu2012");
    let mut rows = hand_made(tondu.ok_or("no muscle of Tondu")?, build)?;
    let bounded = cases
        .iter()
        .filter(|case| case.facts.rms_of_blocked.is_some());
    let bounded: Vec<&MuscleCase> = bounded.copied().collect();
    for row in threads::map(&bounded, |case| first_fit(case, build)) {
        rows.push(row?);
    }
    rows.extend(pulses::rows(cases, build)?);
    Ok(rows)
}

/// The share of the points inside of each way, beside 95 %.
pub fn coverage(all: &[Coverage]) -> impl Iterator<Item = Row> {
    all.iter().map(|coverage| {
        let share = coverage.all().share;
        Row {
            name: format!("left out, {}", coverage.way),
            reference: COVERAGE,
            computed: share,
            error: COVERAGE - share,
            allowed: 0.0,
        }
    })
}

/// The rms error of an identified muscle at the means of the branches, beside its largest blocked
/// force.
fn first_fit(case: &MuscleCase, build: &Build<'_>) -> Result<Row> {
    let all = first_fit_residuals(case, case.friction_share(), build)?;
    let errors = ForceErrors::new(all.iter().filter(|r| r.branch.is_mean()));
    let fit = case.fits.first();
    let free = fit.into_iter().flat_map(|fit| {
        let name = |free: &Parameter| free.target.name(&fit.muscle);
        fit.free.iter().map(name)
    });
    let free = joined(free, " and ");
    Ok(Row {
        name: format!("{}: fe, {} points, {free}", case.facts.title, errors.points),
        reference: errors.blocked_n,
        computed: errors.rms_n,
        error: errors.rms_of_blocked,
        allowed: case.facts.rms_of_blocked.unwrap_or_default(),
    })
}

/// Name, model, what is fitted, and the rms over the largest force that passes.
type Comparison<'a> = (&'a str, &'a Build<'a>, &'a [Target], f64);

/// Models beside the 20° muscle, over the largest measured force.
pub fn hand_made(case: &MuscleCase, elements: &Build<'_>) -> Result<Vec<Row>> {
    let thick: &Build<'_> = &|m| Ok(Box::new(ThickWall::between_ends(m)));
    let ideal: &Build<'_> = &|m| Ok(Box::new(Ideal::between_ends(m)));
    let modulus = Target::Modulus;
    let both = [modulus, Target::Measure(&END_FACTOR)];
    let comparisons: [Comparison<'_>; 4] = [
        ("ideal, nothing fitted", ideal, &[], 0.10),
        ("thick-wall, modulus", thick, &[modulus], 0.03),
        ("thick-wall, modulus and end factor", thick, &both, 0.01),
        ("fe, modulus, no end factor", elements, &[modulus], 0.02),
    ];
    let start = &case.fits.first().ok_or("no fit")?.muscle;
    let points: Vec<MeasuredPoint> = case.points.iter().map(|p| p.at).collect();
    let points = mean_of_branches(&points);
    let largest = peak(points.iter().map(|p| p.force_n));
    let row = |&(name, build, free, allowed): &Comparison<'_>| {
        let model = build(&with_constants(start, build, free, &points)?)?;
        let workspace = &mut Workspace::new();
        let mut model = Evaluation::new(&*model, workspace, Options::default());
        let rms = compare(&mut model, &points, &[])?
            .rms_n
            .ok_or("no answer")?;
        Ok(Row {
            name: format!("hand-made, 20°: {name}"),
            reference: largest,
            computed: rms,
            error: rms / largest,
            allowed,
        })
    };
    comparisons.iter().map(row).collect()
}

/// The 20° muscle with what is fitted of it.
pub fn with_constants(
    muscle: &Muscle,
    build: &Build<'_>,
    free: &[Target],
    points: &[MeasuredPoint],
) -> Result<Muscle> {
    if free.is_empty() {
        return Ok(muscle.clone());
    }
    let free: Vec<Parameter> = free.iter().copied().map(Parameter::free).collect();
    let data: Vec<DataPoint> = points.iter().copied().map(DataPoint::new).collect();
    let fit = ChosenFit {
        two_sided: true,
        ..ChosenFit::new(muscle, &free, &data, build)
    };
    Ok(fit.found()?.muscle)
}
