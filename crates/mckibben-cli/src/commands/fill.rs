//! `fill`: a volume of liquid pushed into a muscle.

use crate::asked::Asked;
use crate::failure::Failure;
use crate::output::text::{Units, half_width, number, pairs, percent, within};
use crate::output::{FLAT, burst_first};
use crate::progress::Bar;
use crate::shown;
use mckibben::load::FillState;
use mckibben_app::FillAnswer;
use mckibben_app::rows::{Row, estimated, limit_rows};

pub const TEXT: &str = "fill: Pressure, stroke and energy of a muscle that a volume of liquid is pushed into
Question: volume_mm3
@load e/contraction liquid gas_share=gas<SHARE> dead_volume_mm3 liquid_bulk_modulus_mpa=bulk-modulus<MODULUS>*
@muscle @model @output
Examples:
  mckibben fill -D 30 -s 2 -L 200 --volume 20mL --load mass:10kg
  mckibben fill examples/festo-dmsp-20.toml --volume 30mL -e 10% --liquid oil --gas 1% --dead-volume 15mL";

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    let answer = mckibben_app::fill(&asked.request()?, &Bar::hidden())?;
    let text = || burst_first(&answer.fill.answer.warnings) + &pairs(&rows(&answer, &shown::units()));
    asked.show(&answer, FLAT, text)
}

fn rows(answer: &FillAnswer, u: &Units) -> Vec<Row> {
    let (f, a, liquid) = (&answer.fill, &answer.fill.answer, &answer.liquid);
    let r = &a.response;
    let stroke = format!("{} {}", u.length.to(f.stroke_mm, 4), u.length.name);
    let state = match f.state {
        FillState::NotLifted => "the load is not lifted".to_owned(),
        FillState::Balanced => match a.contraction_uncertainty {
            Some(half) => {
                let (value, half) = (100.0 * r.contraction, 100.0 * half);
                format!("contraction {} ± {} %", within(value, half), half_width(half))
            }
            None => format!("contraction {}", percent(r.contraction)),
        },
        FillState::Held => format!("held at a contraction of {}", percent(r.contraction)),
    };
    let pull = u.force.within(r.force_n, a.uncertainty_n);
    let half = a.uncertainty_n.map_or_else(|| "unknown".to_owned(), |n| u.force.half_width(n));
    let joule = |v: f64| format!("{} J", number(v, 4));
    let modulus = |v: f64| format!("{} GPa", number(1e-3 * v, 3));
    let mut list = vec![
        ("muscle", answer.muscle.line(u)),
        ("model", format!("{} ({})", a.model, answer.about.source)),
        (
            "liquid",
            format!(
                "{}, {} of gas, bulk modulus {}; with its gas at this pressure {}",
                liquid.name,
                percent(liquid.gas_share),
                modulus(liquid.bulk_modulus_mpa),
                modulus(f.effective_bulk_modulus_mpa)
            ),
        ),
        (
            "pushed in",
            format!(
                "{}, of which its compression takes {}",
                u.volume.show(f.pushed_volume_mm3),
                u.volume.show(f.compressed_volume_mm3)
            ),
        ),
        ("pressure", u.pressure.show(r.pressure_mpa)),
        ("stroke", format!("{stroke} ({state})")),
        ("pull", format!("{pull} ± {half} {}", u.force.name)),
        ("stiffness, liquid shut in", u.stiffness().show(f.shut_stiffness_n_per_mm)),
    ];
    list.extend(r.stiffness_n_per_mm.map(|k| ("at constant pressure", u.stiffness().show(k))));
    list.push(("work of the pump", joule(f.pump_work_j)));
    list.push(("stored in the muscle", joule(f.muscle_energy_j)));
    list.push(("stored in the liquid", joule(f.liquid_energy_j)));
    list.push(("work on the load", joule(f.load_work_j)));
    list.extend(f.friction_work_j.map(|v| ("taken by friction", joule(v))));
    let cavity = r.volume_mm3.map_or_else(|| "unknown".to_owned(), |v| u.volume.show(v));
    list.push(("cavity", format!("{cavity}, {} at the start", u.volume.show(f.rest_volume_mm3))));
    list.extend(limit_rows(&answer.limits, estimated(&answer.muscle), u));
    list.extend(
        answer.uncertainty_words.text_in(u).map(|text| ("uncertainty", format!("of the pull {text}"))),
    );
    list
}
