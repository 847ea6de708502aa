//! `force`, `pressure`, `contraction` as rows.

use super::check::limit_rows;
use super::{Row, estimated};
use crate::{PointAnswer, PointQuantity, Units, number, percent, words::half_width, words::within};
use mckibben::answer::Answer;

fn of(asked: PointQuantity, answer: &Answer) -> f64 {
    match asked {
        PointQuantity::Force => answer.response.force_n,
        PointQuantity::Pressure => answer.response.pressure_mpa,
        PointQuantity::Contraction => answer.response.contraction,
    }
}

fn show(asked: PointQuantity, value: f64, u: &Units) -> String {
    match asked {
        PointQuantity::Force => u.force.show(value),
        PointQuantity::Pressure => u.pressure.show(value),
        PointQuantity::Contraction => percent(value),
    }
}

/// A point of a muscle. The ± belongs to what was asked.
pub fn point_rows(answer: &PointAnswer, asked: PointQuantity, u: &Units) -> Vec<Row> {
    let (a, r) = (&answer.point, &answer.point.response);
    let unknown = || "unknown".to_owned();
    let pull = match asked {
        _ if a.slack => format!("{} (slack: the muscle would have to push)", u.force.show(0.0)),
        PointQuantity::Force => {
            let half = a.uncertainty_n.map_or_else(unknown, |e| u.force.half_width(e));
            format!("{} ± {half} {}", u.force.within(r.force_n, a.uncertainty_n), u.force.name)
        }
        _ => u.force.show(r.force_n),
    };
    let pressure = match asked {
        PointQuantity::Pressure => {
            let half = a.pressure_uncertainty_mpa;
            let value = u.pressure.within(r.pressure_mpa, half);
            format!(
                "{value} ± {} {}",
                half.map_or_else(unknown, |v| u.pressure.half_width(v)),
                u.pressure.name
            )
        }
        _ => u.pressure.show(r.pressure_mpa),
    };
    let ratio = match (asked, a.contraction_uncertainty) {
        (PointQuantity::Contraction, Some(half)) => {
            format!("{} ± {} %", within(100.0 * r.contraction, 100.0 * half), half_width(100.0 * half))
        }
        (PointQuantity::Contraction, None) => format!("{} ± {}", percent(r.contraction), unknown()),
        _ => percent(r.contraction),
    };
    let shortening = u.length.to(r.contraction * answer.muscle.length_mm, 4);
    let mut list = vec![
        ("muscle", answer.muscle.line(u)),
        ("model", format!("{} ({})", a.model, answer.about.source)),
        ("pressure", pressure),
        ("contraction", format!("{ratio}  ({shortening} {})", u.length.name)),
        ("pull", pull),
    ];
    if let [shortening, lengthening] = &answer.branches[..] {
        let shown = |branch: &Answer| match asked {
            PointQuantity::Force if branch.slack => "slack".to_owned(),
            _ => show(asked, of(asked, branch), u),
        };
        let band = (of(asked, lengthening) - of(asked, shortening)).abs();
        list.push(("while shortening", shown(shortening)));
        list.push(("while lengthening", shown(lengthening)));
        list.push(("friction's band", show(asked, band, u)));
    }
    let mut add = |name, value: Option<f64>, show: &dyn Fn(f64) -> String| {
        list.extend(value.map(|v| (name, show(v))));
    };
    let (stiffness, slope) = (u.stiffness(), u.slope());
    add("stiffness", r.stiffness_n_per_mm, &|v| stiffness.show(v));
    add("pull per pressure", r.force_per_pressure_mm2, &|v| slope.show(v));
    add("starts to pull at", a.start_pressure_mpa, &|v| u.pressure.show(v));
    add("free contraction", a.free_contraction, &percent);
    add("buckles at a push of", a.buckling_load_n, &|v| u.force.show(v));
    add("bulged diameter", r.bulged_diameter_mm, &|v| format!("{} {}", u.length.to(v, 4), u.length.name));
    add("volume", r.volume_mm3, &|v| u.volume.show(v));
    let tension = |v| format!("{} {}", u.force.to(v, 4), u.force.name);
    add("tension of one strand", r.strand_tension_n, &tension);
    add("tension of all strands", r.braid_tension_n, &tension);
    let estimate = estimated(&answer.muscle);
    list.extend(limit_rows(&answer.limits, estimate, u));
    let mut add = |name, value: Option<f64>, show: &dyn Fn(f64) -> String| {
        list.extend(value.map(|v| (name, show(v))));
    };
    add("stretch at mid-length, inside", r.middle_stretch, &|v| number(v, 3));
    add("stretch of 99 % of the rubber", r.max_stretch, &|v| format!("below {}", number(v, 3)));
    let words = &answer.uncertainty_words;
    let of = if asked == PointQuantity::Force { "" } else { "of the pull " };
    list.extend(words.text_in(u).map(|text| ("uncertainty", format!("{of}{text}"))));
    list.extend(words.bench_in(u).map(|text| ("smallest bench", text)));
    list
}
