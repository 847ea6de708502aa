//! `curve isometric|isotonic|isobaric`.

use crate::cli::{CurveArgs, TestWord};
use crate::failure::{Failure, NO_ANSWER, NOT_CONVERGED, WRONG_INPUT};
use crate::figure;
use crate::flags::{Format, PressureUnit};
use crate::output::text::{Pressures, muscle_line, number, percent, table};
use crate::output::{csv, emit, json, warn};
use crate::resolve;
use mckibben::curve::{Curve, Test, curves};
use mckibben::model::Workspace;
use mckibben::units::Dimension;

/// Runs the command.
pub fn run(args: &CurveArgs) -> Result<u8, Failure> {
    figure::check(args.plot.plot.as_deref())?;
    let test = match args.test {
        Some(TestWord::Isotonic) => Test::Isotonic,
        Some(TestWord::Isobaric) => Test::Isobaric,
        _ => Test::Isometric,
    };
    let muscle = resolve::muscle(&args.muscle)?;
    let default_p = if test == Test::Isobaric { "0.05..0.25:0.05" } else { "0..0.25:0.01" };
    let default_e = if test == Test::Isobaric { "0..0.2:0.01" } else { "0..0.2:0.05" };
    let p = resolve::points("--pressure", args.pressure.as_deref(), Dimension::Pressure, default_p, 25)?;
    let e = resolve::contractions(args.contraction.as_deref(), default_e)?;
    let f = resolve::points("--force", args.force.as_deref(), Dimension::Force, "20,80,150N", 5)?;
    f.iter().try_for_each(|&f| resolve::pull("--force", f, &args.model.asking))?;
    let ends = (p.iter().copied().fold(f64::INFINITY, f64::min), p.iter().copied().fold(0.0, f64::max));
    let model = resolve::model(&args.model, &muscle, ends)?;
    let (fixed, along) = match test {
        Test::Isometric => (&e, &p),
        Test::Isotonic => (&f, &p),
        Test::Isobaric => (&p, &e),
    };
    if fixed.len().saturating_mul(along.len()) > mckibben::units::MAX_POINTS {
        let points = fixed.len() * along.len();
        let message = format!("{points} points are more than {}", mckibben::units::MAX_POINTS);
        return Err(Failure::input("range", message, "take larger steps"));
    }
    let list = curves(
        model.as_ref(),
        &mut Workspace::new(),
        test,
        fixed,
        along,
        resolve::options(&args.model.asking),
    );
    let failed = all_failed(&list);
    let typed = PressureUnit::typed(args.pressure.as_deref());
    let pressures = Pressures(args.output.units.or(typed).unwrap_or(PressureUnit::Mpa));
    if let (Some(path), None) = (&args.plot.plot, &failed) {
        figure::curves(model.as_ref(), test, &list, pressures).save(path)?;
    }
    let value = json::curves(model.name(), test, &list, &muscle);
    let text = match args.output.format {
        Format::Json => json::print(&value),
        Format::Csv => csv::rows(value["points"].as_array().map_or(&[][..], |v| v))?,
        Format::Text => {
            if let Some(failure) = failed {
                return Err(failure);
            }
            warnings(&list);
            let head = format!("{} test, model {}\n{}\n\n", test.name(), model.name(), muscle_line(&muscle));
            format!("{head}{}", as_table(test, &list, pressures))
        }
    };
    emit(&text, args.output.output.as_deref())?;
    Ok(failed.map_or(0, |f| f.exit))
}

/// Where every point fails, the first reason with the exit code it deserves.
fn all_failed(list: &[Curve]) -> Option<Failure> {
    let mut errors = list.iter().flat_map(|c| c.points.iter().map(|p| p.answer.as_ref().err()));
    if !errors.clone().all(|e| e.is_some()) {
        return None;
    }
    let mut worst: Option<Failure> = None;
    for error in errors.by_ref().flatten() {
        let failure = Failure::from(error.clone());
        let rank = |f: &Failure| match f.exit {
            NOT_CONVERGED => 2,
            WRONG_INPUT => 1,
            NO_ANSWER => 0,
            _ => 0,
        };
        if worst.as_ref().is_none_or(|w| rank(&failure) > rank(w)) {
            worst = Some(failure);
        }
    }
    worst
}

fn warnings(list: &[Curve]) {
    let mut seen: Vec<&str> = vec![];
    let answers = list.iter().flat_map(|c| &c.points).filter_map(|p| p.answer.as_ref().ok());
    for warning in answers.flat_map(|a| &a.warnings) {
        if !seen.contains(&warning.as_str()) {
            if seen.len() < 5 {
                warn(warning);
            }
            seen.push(warning);
        }
    }
    if seen.len() > 5 {
        warn(format!("and {} more like these (--format json shows them with their points)", seen.len() - 5));
    }
    let failed = list.iter().flat_map(|c| &c.points).filter_map(|p| p.answer.as_ref().err());
    let failed: Vec<_> = failed.collect();
    if let Some(first) = failed.first() {
        warn(format!("{} points have no answer (–); the first: {first}", failed.len()));
    }
}

/// One row per value along the curves, one column per curve.
fn as_table(test: Test, list: &[Curve], p: Pressures) -> String {
    let along = if test == Test::Isobaric { "ε".to_owned() } else { format!("P [{}]", p.unit()) };
    let fixed = |c: &Curve| match test {
        Test::Isometric => format!("F [N] at ε {}", percent(c.fixed)),
        Test::Isotonic => format!("ε at {} N", number(c.fixed, 5)),
        Test::Isobaric => format!("F [N] at {}", p.show(c.fixed)),
    };
    let header: Vec<String> = std::iter::once(along).chain(list.iter().map(fixed)).collect();
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let count = list.first().map_or(0, |c| c.points.len());
    let rows = (0..count).map(|i| {
        let first = list.first().map(|c| &c.points[i]);
        let x = first.map_or_else(String::new, |q| match test {
            Test::Isobaric => percent(q.contraction.unwrap_or(0.0)),
            _ => number(p.value(q.pressure_mpa), 4),
        });
        std::iter::once(x)
            .chain(list.iter().map(|c| match &c.points[i].answer {
                Err(_) => "–".into(),
                Ok(a) if test == Test::Isotonic => percent(a.response.contraction),
                Ok(a) if a.slack => "slack".into(),
                Ok(a) => number(a.response.force_n, 5),
            }))
            .collect()
    });
    table(&header, rows.collect())
}
