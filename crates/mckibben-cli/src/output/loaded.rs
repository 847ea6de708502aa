//! Equilibria with a load, as text.

use super::text::{Units, air, half_width, number, or_dash, pairs, percent, table, within};
use mckibben::load::LoadError;
use mckibben_app::LoadAnswer;

/// A table of the equilibria, and the stroke between the lowest and the highest pressure.
pub fn loaded(answer: &LoadAnswer, u: &Units) -> String {
    let header = [
        u.pressure.heading("P"),
        "ε".into(),
        "±".into(),
        u.length.heading("x"),
        u.force.heading("F"),
        format!("muscle and load [{}]", u.stiffness().name),
        "balance".into(),
        "f [Hz]".into(),
    ];
    let mut rows = vec![];
    for at in &answer.at {
        let pressure = u.pressure.bare(at.pressure_mpa);
        for e in &at.equilibria {
            let r = &e.answer.response;
            let half = e.answer.contraction_uncertainty;
            rows.push(vec![
                pressure.clone(),
                half.map_or_else(
                    || percent(r.contraction),
                    |h| format!("{} %", within(100.0 * r.contraction, 100.0 * h)),
                ),
                or_dash(half, |h| format!("{} %", half_width(100.0 * h))),
                u.length.to(e.shortening_mm, 4),
                u.force.within(r.force_n, e.answer.uncertainty_n),
                u.stiffness().to(e.stiffness_n_per_mm, 4),
                if e.stable { "stable" } else { "unstable" }.into(),
                or_dash(e.frequency_hz, |f| number(f, 3)),
            ]);
        }
        if let (true, Some(error)) = (at.equilibria.is_empty(), &at.error) {
            let not_lifted = if matches!(error, LoadError::NotLifted { .. }) { "not lifted" } else { "none" };
            let dash = || "–".to_owned();
            rows.push(vec![pressure, dash(), dash(), dash(), dash(), dash(), not_lifted.into(), dash()]);
        }
    }
    let mut text = format!("\nload {}\n{}", answer.load, table(&header, rows));
    if let Some(c) = &answer.cycle {
        let (stroke, unit) = (u.length.to(c.stroke_mm, 4), &u.length.name);
        let [from, to] = [c.from_pressure_mpa, c.to_pressure_mpa].map(|p| u.pressure.show(p));
        let stroke = format!("{stroke} {unit} from {from} to {to}");
        let mut list = vec![("stroke", stroke), ("work on the load", format!("{} J", number(c.work_j, 4)))];
        let filling = c.air_normal_litres.zip(c.air_exergy_j);
        list.extend(filling.map(|(litres, exergy)| {
            let text = format!("{}, exergy {} J", air(litres), number(exergy, 4));
            ("air of a filling", text)
        }));
        list.extend(c.efficiency.map(|e| ("work over exergy", percent(e))));
        text += &format!("\n{}", pairs(&list));
    }
    text
}
