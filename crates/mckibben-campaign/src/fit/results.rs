//! The results of the paper's campaign: the table of `docs/results.md`, which
//! `mckibben fit --report` prints.
//!
//! Errors are shares of the finite elements' blocked force of the same muscle at .25 MPa, over
//! points where they pull.

use super::constants::{fit_constants, table_1};
use super::data::{FitPoint, Grid, pressure_steps, same};
use super::errors::{Errors, compared, errors};
use super::universal::{HeldOutRow, held_out, held_out_samples};
use super::{FitError, Method, Result, Rules, SlackRule, ThinRule, fitted};
use mckibben::muscle::Muscle;
use mckibben::progress::Progress;
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
    /// The comparisons.
    pub findings: Vec<Finding>,
    /// Models on random muscles that no fit has seen.
    pub random_muscles: Vec<HeldOutRow>,
}

/// Steps that are reported.
const STEPS: usize = 6;
/// Random muscles of the last table, and their seed.
const RANDOM: (usize, u64) = (500, 7);

/// Points with their errors, and the share that was set as a goal.
fn add<'a>(
    out: &mut Vec<Finding>,
    comparison: impl Into<String>,
    at_most: Option<f64>,
    points: impl IntoIterator<Item = &'a FitPoint>,
    difference_n: impl Fn(&FitPoint) -> f64,
) -> Result<()> {
    let points: Vec<FitPoint> = points.into_iter().copied().collect();
    let errors = errors(&compared(&points, difference_n)?, |_| true);
    let errors = errors.ok_or_else(|| FitError::empty(" to compare"))?;
    let ok = at_most.is_none_or(|most| errors.summary.max <= most);
    out.push(Finding {
        comparison: comparison.into(),
        at_most,
        ok,
        errors,
    });
    Ok(())
}

/// Computes everything anew.
pub fn results(progress: &dyn Progress) -> Result<Results> {
    let base = Muscle::prototype();
    let campaign = &Grid::PAPER.points(&base);
    let step = |done: usize| {
        progress.report(done, STEPS);
        progress.check()
    };
    step(0)?;
    let out = &mut vec![];
    let is_table = |p: &&FitPoint| same(p.outer_diameter_mm, 50.0) && same(p.wall_mm, 1.0);
    let to_table = |p: &FitPoint| {
        table_1(p.pressure_mpa, p.contraction).map_or(0.0, |force| force - p.force_n)
    };
    let constants = fit_constants()?;
    step(1)?;
    let good = Grid::PAPER.compute(|d, s| constants.muscle(d, s));
    let name = "FE with fitted constants vs Table 1 (D0 50, s 1)";
    add(
        out,
        name,
        Some(0.015),
        good.iter().filter(is_table),
        to_table,
    )?;
    add(
        out,
        "FE as shipped vs Table 1",
        None,
        campaign.iter().filter(is_table),
        to_table,
    )?;

    let held = Grid::HELD_OUT.points(&base);
    let all = [campaign.clone(), held.clone()].concat();
    step(2)?;
    let wide = |p: &&FitPoint| p.outer_diameter_mm > 34.0 && p.wall_mm < 4.5;
    let slim = |p: &&FitPoint| p.outer_diameter_mm < 34.0;
    let variants = [
        ("", Rules::default()),
        (
            " (.05 MPa curves of thick walls: straight line)",
            Rules {
                thin: ThinRule::Line,
                ..Rules::default()
            },
        ),
        (
            " (.05 MPa curves of thick walls: whole)",
            Rules {
                thin: ThinRule::Whole,
                ..Rules::default()
            },
        ),
        (
            " (points that pull only)",
            Rules {
                slack: SlackRule::PullOnly,
                ..Rules::default()
            },
        ),
        (
            " (zero where it would push)",
            Rules {
                slack: SlackRule::Zero,
                ..Rules::default()
            },
        ),
    ];
    for (i, (text, rules)) in variants.into_iter().enumerate() {
        let f = fitted(campaign, Method::Paper(rules), &[])?;
        let difference = |p: &FitPoint| p.formula_n(&f) - p.published_n();
        let goal = |v| (i == 0).then_some(v);
        let name = format!("paper's method on our FE vs published, D0 35-50, s 1-4{text}");
        add(out, name, goal(0.025), all.iter().filter(wide), difference)?;
        add(
            out,
            format!("the same, D0 30, s 1-5{text}"),
            goal(0.09),
            all.iter().filter(slim),
            difference,
        )?;
    }

    // With the constants of the first line, so that one set of constants answers both questions.
    let f = fitted(&good, Method::Paper(Rules::default()), &[])?;
    let difference = |p: &FitPoint| p.formula_n(&f) - p.published_n();
    let name = "paper's method on our FE with fitted constants vs published, D0 35-50, s 1-4";
    let all_good = [
        good.clone(),
        Grid::HELD_OUT.compute(|d, s| constants.muscle(d, s)),
    ]
    .concat();
    add(
        out,
        name,
        Some(0.025),
        all_good.iter().filter(wide),
        difference,
    )?;
    add(
        out,
        "the same, D0 30, s 1-5",
        Some(0.09),
        all_good.iter().filter(slim),
        difference,
    )?;

    step(3)?;
    let steps = pressure_steps(1);
    let full = Grid {
        pressures: &steps,
        ..Grid::PAPER
    }
    .points(&base);
    let global = fitted(&full, Method::Global, &[])?;
    let held_by_steps = Grid {
        pressures: &steps,
        ..Grid::HELD_OUT
    }
    .points(&base);
    let by_global = |p: &FitPoint| p.difference_n(&global);
    add(
        out,
        "global vs FE, all of the range (P by .01 MPa)",
        Some(0.004),
        &full,
        by_global,
    )?;
    add(
        out,
        "global vs FE, D0 35 held out",
        Some(0.004),
        &held_by_steps,
        by_global,
    )?;

    step(4)?;
    // Between the points: half steps of D0, s and ε.
    let half = |low: f64, step: f64, n: u32| {
        (0..=n)
            .map(|i| low + step * f64::from(i))
            .collect::<Vec<f64>>()
    };
    let (diameters, walls, contractions) =
        (half(30.0, 2.5, 8), half(1.0, 0.5, 8), half(0.0, 0.025, 8));
    let finer = Grid {
        contractions: &contractions,
        pressures: &steps,
        ..Grid::PAPER
    };
    let between = Grid {
        diameters: &diameters,
        walls: &walls,
        ..finer
    }
    .points(&base);
    add(
        out,
        "global vs FE between the points too (half steps)",
        None,
        &between,
        by_global,
    )?;
    let of_finer = fitted(&finer.points(&base), Method::Global, &[])?;
    let name = "global of a campaign with ε by 2.5 % vs FE, between the points too";
    add(out, name, Some(0.004), &between, |p| {
        p.difference_n(&of_finer)
    })?;

    let published = |p: &FitPoint| p.published_n() - p.force_n;
    add(
        out,
        "published formula vs FE, the campaign",
        None,
        campaign,
        published,
    )?;
    let in_range = between.iter().filter(|p| p.pressure_mpa > 0.045);
    add(
        out,
        "published formula vs FE, between the points too",
        None,
        in_range,
        published,
    )?;
    add(
        out,
        "published formula vs FE, D0 35",
        None,
        &held,
        published,
    )?;
    let ours = fitted(campaign, Method::Paper(Rules::default()), &[])?;
    add(
        out,
        "paper's method on our FE vs FE, the campaign",
        None,
        campaign,
        |p| p.difference_n(&ours),
    )?;
    add(
        out,
        "paper's method on our FE vs FE, D0 35",
        None,
        &held,
        |p| p.difference_n(&ours),
    )?;
    step(5)?;
    let random_muscles = held_out(&held_out_samples(RANDOM.0, RANDOM.1));
    step(STEPS)?;
    Ok(Results {
        findings: std::mem::take(out),
        random_muscles,
    })
}
