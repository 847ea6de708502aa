//! `force`, `pressure`, `contraction`: one value.

use crate::cli::{ContractionArgs, ForceArgs, PressureArgs};
use crate::failure::Failure;
use crate::flags::{Format, OutputFlags, PressureUnit};
use crate::output::text::{Pressures, muscle_line, number, pairs, percent, plus_minus};
use crate::output::{csv, emit, json, warn};
use crate::resolve;
use mckibben::answer::{self, Answer};
use mckibben::model::{ForceModel, Workspace};
use mckibben::units::Dimension;

/// F(P, ε).
pub fn force(args: &ForceArgs) -> Result<u8, Failure> {
    let muscle = resolve::muscle(&args.muscle)?;
    let p = resolve::required("--pressure", args.pressure.as_deref(), Dimension::Pressure)?;
    let e = resolve::contraction("--contraction", args.contraction.as_deref())?.unwrap_or(0.0);
    let model = resolve::model(&args.model, &muscle, (p, p))?;
    let answer =
        answer::force(model.as_ref(), &mut Workspace::new(), p, e, resolve::options(&args.model.asking))?;
    print(model.as_ref(), &answer, &args.output, args.pressure.as_deref())
}

/// P(F, ε).
pub fn pressure(args: &PressureArgs) -> Result<u8, Failure> {
    let muscle = resolve::muscle(&args.muscle)?;
    let f = resolve::required("--force", args.force.as_deref(), Dimension::Force)?;
    resolve::pull("--force", f, &args.model.asking)?;
    let e = resolve::contraction("--contraction", args.contraction.as_deref())?.unwrap_or(0.0);
    let model = resolve::model(&args.model, &muscle, (0.0, 0.0))?;
    let answer =
        answer::pressure(model.as_ref(), &mut Workspace::new(), f, e, resolve::options(&args.model.asking))?;
    print(model.as_ref(), &answer, &args.output, None)
}

/// ε(F, P).
pub fn contraction(args: &ContractionArgs) -> Result<u8, Failure> {
    let muscle = resolve::muscle(&args.muscle)?;
    let p = resolve::required("--pressure", args.pressure.as_deref(), Dimension::Pressure)?;
    let f = resolve::quantity("--force", args.force.as_deref(), Dimension::Force)?.unwrap_or(0.0);
    resolve::pull("--force", f, &args.model.asking)?;
    let model = resolve::model(&args.model, &muscle, (p, p))?;
    let answer = answer::contraction(
        model.as_ref(),
        &mut Workspace::new(),
        f,
        p,
        resolve::options(&args.model.asking),
    )?;
    print(model.as_ref(), &answer, &args.output, args.pressure.as_deref())
}

fn print(
    model: &dyn ForceModel,
    answer: &Answer,
    output: &OutputFlags,
    typed: Option<&str>,
) -> Result<u8, Failure> {
    let value = json::answer(answer);
    let text = match output.format {
        Format::Json => json::print(&value),
        Format::Csv => csv::rows(&[value])?,
        Format::Text => {
            let unit = output.units.or(PressureUnit::typed(typed)).unwrap_or(PressureUnit::Mpa);
            for warning in &answer.warnings {
                warn(warning);
            }
            text(model, answer, Pressures(unit))
        }
    };
    emit(&text, output.output.as_deref())?;
    Ok(0)
}

fn text(model: &dyn ForceModel, a: &Answer, p: Pressures) -> String {
    let r = &a.response;
    let pull = if a.slack {
        "0 N (slack: the muscle would have to push)".to_owned()
    } else {
        format!("{} N  {}", number(r.force_n, 5), plus_minus(a.uncertainty_n))
    };
    let mut list = vec![
        ("muscle", muscle_line(model.muscle())),
        ("model", format!("{} ({})", a.model, model.source())),
        ("pressure", p.show(r.pressure_mpa)),
        (
            "contraction",
            format!(
                "{}  ({} mm)",
                percent(r.contraction),
                number(r.contraction * model.muscle().length_mm(), 4)
            ),
        ),
        ("pull", pull),
    ];
    let mut add = |name, value: Option<f64>, unit: &str, digits| {
        if let Some(v) = value {
            list.push((name, format!("{} {unit}", number(v, digits)).trim_end().to_owned()));
        }
    };
    add("stiffness", r.stiffness_n_per_mm, "N/mm", 4);
    add(
        "pull per pressure",
        r.force_per_pressure_mm2.map(|v| v / p.value(1.0)),
        &format!("N/{}", p.unit()),
        4,
    );
    add("starts to pull at", a.start_pressure_mpa.map(|v| p.value(v)), p.unit(), 4);
    add("free contraction", a.free_contraction.map(|v| 100.0 * v), "%", 4);
    add("bulged diameter", r.bulged_diameter_mm, "mm", 4);
    add("volume", r.volume_mm3.map(|v| v * 1e-3), "cm³", 4);
    add("tension of one strand", r.strand_tension_n, "N", 4);
    add("tension of all strands", r.braid_tension_n, "N", 4);
    add("largest stretch of the rubber", r.max_stretch, "", 3);
    if a.uncertainty_n.is_some() {
        list.push(("the ± is", format!("a 95 % half-width; {}", model.accuracy().basis)));
    }
    pairs(&list)
}
