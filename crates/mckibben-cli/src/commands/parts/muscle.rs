//! Muscles of the library as text.

use crate::output::text::{or_dash, pairs, percent, percents, table};
use crate::shown;
use mckibben_app::{LibraryDetails, LibraryMuscle};
use mckibben_fit::validation::library::Agreement;

pub(super) fn list(list: &[LibraryMuscle]) -> String {
    let u = shown::units();
    let row = |m: &LibraryMuscle| {
        vec![
            m.name.clone(),
            u.length.to(m.muscle.outer_diameter_mm, 4),
            u.length.to(m.muscle.length_mm, 4),
            u.pressure.to(m.pressure_mpa, 3),
            or_dash(m.blocked_force_n, |v| u.force.to(v, 4)),
            or_dash(m.uncertainty_n, |v| u.force.half_width(v)),
            percents([m.free_contraction], 3).concat(),
            m.points.to_string(),
            m.product.clone().unwrap_or_else(|| "hand-made".into()),
            m.source.clone(),
        ]
    };
    let headings = [u.length.heading("D0"), u.length.heading("L0"), u.pressure.heading("P")];
    let forces = [u.force.heading("F blocked"), u.force.heading("±")];
    let last = ["ε free", "points", "", "source"].map(str::to_owned);
    let header = [&["muscle".to_owned()], &headings[..], &forces, &last].concat();
    table(&header, list.iter().map(row).collect())
        + "P: highest pressure of the bench. F blocked, its ± (95 %) and ε free: there, by fe.\n\
           A name stands wherever a muscle file may: mckibben force lib:dmsp-20-300 -p 5bar -e 10%\n"
}

pub(super) fn details(a: &LibraryDetails) -> String {
    let (u, m) = (shown::units(), &a.muscle);
    let force = |v: f64| u.force.show(v);
    let blocked = or_dash(m.blocked_force_n, |v| {
        let half = or_dash(m.uncertainty_n, |half| u.force.half_width(half));
        format!("{} ± {half} {} at {}", force(v), u.force.name, u.pressure.show(m.pressure_mpa))
    });
    let rows = [
        ("name", m.name.clone()),
        ("what", m.title.clone()),
        ("product", m.product.clone().unwrap_or_else(|| "none: hand-made".into())),
        ("muscle", m.muscle.line(&u)),
        ("blocked force", blocked),
        ("free contraction", or_dash(m.free_contraction, percent)),
        ("source", m.source.clone()),
        ("terms", m.terms.clone()),
        ("known", a.known.clone()),
        ("unknown", a.unknown.clone()),
        ("identified", format!("{} (fit \"{}\")", a.identified.join(", "), a.fit)),
        ("agreement", agreement(&a.agreement)),
    ];
    format!("{}\n{}", pairs(&rows), a.muscle_file.text)
}

fn agreement(a: &Agreement) -> String {
    let u = shown::units();
    let force = |v: f64| format!("{} {}", u.force.to(v, 3), u.force.name);
    let held = or_dash(a.held, |share| {
        let percent = (100.0 * share).floor();
        format!("; {percent} % of the {} points of its length within its ±", a.bench_points)
    });
    format!(
        "rms {} ({} of the blocked force), largest {}, {} points{held}",
        force(a.rms_n),
        percents([Some(a.rms_of_blocked)], 2).concat(),
        force(a.largest_n),
        a.points
    )
}
