//! The results of the paper's campaign: the table of `docs/results.md`, which
//! `mckibben fit --report` prints.
//!
//! Errors are shares of the finite elements' blocked force of the same muscle at .25 MPa, over
//! points where they pull.

use super::{
    constants::{fit_constants, table_1},
    data::{FitPoint, Grid, pressure_steps, same},
    error::{FitError, Result},
    errors::{Errors, ForceScales, errors},
    make::{Method, fitted},
    paper_method::{Rules, SlackRule, ThinRule},
    universal::{HeldOutRow, held_out, held_out_samples},
};
use mckibben_core::{formula::Formula, muscle::Muscle, progress::Progress};
use serde::Serialize;

/// One comparison.
#[derive(Debug, Clone, Serialize, schemars::JsonSchema)]
pub struct Finding {
    /// What is compared with what.
    pub comparison: String,
    /// The largest share that was set as a goal, where there is one.
    #[serde(rename = "at_most_of_blocked")]
    pub at_most: Option<f64>,
    /// Whether the goal is met.
    pub ok: bool,
    /// The errors.
    #[serde(flatten)]
    pub errors: Errors,
}

/// All results.
#[derive(Debug, Clone, Serialize, schemars::JsonSchema)]
pub struct Results {
    /// Comparisons in % of the blocked force of finite elements at 0.25 MPa where they pull.
    pub findings: Vec<Finding>,
    /// Models on random muscles that no fit has seen.
    pub random_muscles: Vec<HeldOutRow>,
}

/// Steps that are reported.
const STEPS: usize = 6;
/// Random muscles of the last table, and their seed.
const RANDOM: (usize, u64) = (500, 7);

/// Computes everything anew.
pub fn results(progress: &dyn Progress) -> Result<Results> {
    let step = |done: usize| {
        progress.report(done, STEPS);
        progress.check()
    };
    step(0)?;
    let mut findings = Findings::default();
    let base = Muscle::prototype();
    let campaign = Grid::PAPER.points(&base);
    let constants = fit_constants()?;
    step(1)?;
    let tuned = |grid: Grid<'_>| grid.compute(|d, s| constants.muscle(d, s));
    let good = tuned(Grid::PAPER);
    findings.table_1(
        "FE with fitted constants vs Table 1 (D0 50, s 1)",
        Some(0.015),
        &good,
    )?;
    findings.table_1("FE as shipped vs Table 1", None, &campaign)?;
    let held = Grid::HELD_OUT.points(&base);
    step(2)?;
    let all = [campaign.clone(), held.clone()].concat();
    for (reading, rules) in readings() {
        findings.published("", reading, rules, &campaign, &all)?;
    }
    // With the constants of the first line, so that one set of constants answers both questions.
    let all = [good.clone(), tuned(Grid::HELD_OUT)].concat();
    findings.published(" with fitted constants", "", Rules::default(), &good, &all)?;
    step(3)?;
    let pressures = pressure_steps(1);
    let full = Grid {
        pressures: &pressures,
        ..Grid::PAPER
    };
    let global = findings.global(full, &base)?;
    step(4)?;
    let between = findings.global_between(full, &base, &global)?;
    let published = |p: &FitPoint| p.published_n() - p.force_n;
    findings.add(
        "published formula vs FE, the campaign",
        None,
        &campaign,
        published,
    )?;
    let in_range = between.iter().filter(|p| p.pressure_mpa > 0.045);
    let name = "published formula vs FE, between the points too";
    findings.add(name, None, in_range, published)?;
    findings.add("published formula vs FE, D0 35", None, &held, published)?;
    let ours = fitted(&campaign, Method::Paper(Rules::default()), &[])?.formula;
    let by_ours = |p: &FitPoint| p.difference_n(&ours);
    let name = "paper's method on our FE vs FE, the campaign";
    findings.add(name, None, &campaign, by_ours)?;
    findings.add(
        "paper's method on our FE vs FE, D0 35",
        None,
        &held,
        by_ours,
    )?;
    step(5)?;
    let random_muscles = held_out(&held_out_samples(RANDOM.0, RANDOM.1));
    step(STEPS)?;
    Ok(Results {
        findings: findings.0,
        random_muscles,
    })
}

/// Readings of what the paper leaves open, the default first.
fn readings() -> [(&'static str, Rules); 5] {
    let default = Rules::default();
    let thin = |thin| Rules { thin, ..default };
    let slack = |slack| Rules { slack, ..default };
    [
        ("", default),
        (
            " (.05 MPa curves of thick walls: straight line)",
            thin(ThinRule::Line),
        ),
        (
            " (.05 MPa curves of thick walls: whole)",
            thin(ThinRule::Whole),
        ),
        (" (points that pull only)", slack(SlackRule::PullOnly)),
        (" (zero where it would push)", slack(SlackRule::Zero)),
    ]
}

/// The comparisons one after another.
#[derive(Default)]
struct Findings(Vec<Finding>);

impl Findings {
    /// Points with their errors, and the share that was set as a goal.
    fn add<'a>(
        &mut self,
        comparison: impl Into<String>,
        at_most: Option<f64>,
        points: impl IntoIterator<Item = &'a FitPoint>,
        difference_n: impl Fn(&FitPoint) -> f64,
    ) -> Result<()> {
        let points: Vec<FitPoint> = points.into_iter().copied().collect();
        let forces = ForceScales::new(&points)?;
        let compared = points.iter().map(|p| forces.compared(*p, difference_n(p)));
        let errors = errors(compared).ok_or_else(|| FitError::empty(" to compare"))?;
        self.0.push(Finding {
            comparison: comparison.into(),
            at_most,
            ok: at_most.is_none_or(|most| errors.summary.max <= most),
            errors,
        });
        Ok(())
    }

    /// Finite elements against the paper's Table 1.
    fn table_1(&mut self, name: &str, at_most: Option<f64>, points: &[FitPoint]) -> Result<()> {
        let of_table = |p: &&FitPoint| same(p.outer_diameter_mm, 50.0) && same(p.wall_mm, 1.0);
        self.add(name, at_most, points.iter().filter(of_table), |p| {
            table_1(p.pressure_mpa, p.contraction).map_or(0.0, |force| force - p.force_n)
        })
    }

    /// The paper's method on a campaign against the published formula; its default reading has
    /// goals.
    fn published(
        &mut self,
        elements: &str,
        reading: &str,
        rules: Rules,
        campaign: &[FitPoint],
        all: &[FitPoint],
    ) -> Result<()> {
        let formula = fitted(campaign, Method::Paper(rules), &[])?.formula;
        let difference = |p: &FitPoint| p.formula_n(&formula) - p.published_n();
        let goal = |share| reading.is_empty().then_some(share);
        let name =
            format!("paper's method on our FE{elements} vs published, D0 35-50, s 1-4{reading}");
        let wide = |p: &&FitPoint| p.outer_diameter_mm > 34.0 && p.wall_mm < 4.5;
        self.add(name, goal(0.025), all.iter().filter(wide), difference)?;
        let name = format!("the same, D0 30, s 1-5{reading}");
        let slim = |p: &&FitPoint| p.outer_diameter_mm < 34.0;
        self.add(name, goal(0.09), all.iter().filter(slim), difference)
    }

    /// The global method against the finite elements it is fitted to, and on the diameter held out.
    fn global(&mut self, full: Grid<'_>, base: &Muscle) -> Result<Formula> {
        let points = full.points(base);
        let global = fitted(&points, Method::Global, &[])?.formula;
        let by_global = |p: &FitPoint| p.difference_n(&global);
        let name = "global vs FE, all of the range (P by .01 MPa)";
        self.add(name, Some(0.004), &points, by_global)?;
        let held = Grid {
            diameters: Grid::HELD_OUT.diameters,
            ..full
        };
        let name = "global vs FE, D0 35 held out";
        self.add(name, Some(0.004), &held.points(base), by_global)?;
        Ok(global)
    }

    /// The global method between the points: half steps of D0, s and ε, which are the answer.
    fn global_between(
        &mut self,
        full: Grid<'_>,
        base: &Muscle,
        global: &Formula,
    ) -> Result<Vec<FitPoint>> {
        let halves = |low: f64, step: f64| (0..=8).map(|i| low + step * f64::from(i)).collect();
        let [diameters, walls, contractions]: [Vec<f64>; 3] =
            [halves(30.0, 2.5), halves(1.0, 0.5), halves(0.0, 0.025)];
        let finer = Grid {
            contractions: &contractions,
            ..full
        };
        let between = Grid {
            diameters: &diameters,
            walls: &walls,
            ..finer
        };
        let between = between.points(base);
        let name = "global vs FE between the points too (half steps)";
        self.add(name, None, &between, |p| p.difference_n(global))?;
        let of_finer = fitted(&finer.points(base), Method::Global, &[])?.formula;
        let name = "global of a campaign with ε by 2.5 % vs FE, between the points too";
        self.add(name, Some(0.004), &between, |p| p.difference_n(&of_finer))?;
        Ok(between)
    }
}
