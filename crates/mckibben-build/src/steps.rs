//! Cut list, bill of materials and steps, in Markdown.

use crate::{
    BuildPart, Clamps, Fitting, Plan, SleeveLength,
    safety::relief_mpa,
    text::{mm, percent, significant, trimmed},
};
use mckibben_core::{clean, joined};
use mckibben_io::{files::File, template::render};

type Values = Vec<(&'static str, String)>;

/// The whole page, with links to the other files.
pub fn markdown(plan: &Plan, files: &[File]) -> String {
    let muscle = &plan.muscle;
    let operating = &plan.operating;
    let link = |file: &File| format!("| [{0}]({0}) | {1} |", file.name, file.about);
    let files: Vec<String> = files.iter().map(link).collect();
    let mut values: Values = vec![
        ("outer", mm(muscle.outer_diameter_mm())),
        ("length", mm(muscle.length_mm())),
        ("angle", mm(muscle.braid().angle_deg)),
        ("turn", trimmed(muscle.length_mm() / muscle.turns(), 1)),
        ("pressure", operating.pressure(operating.pressure_mpa)),
        ("blocked", significant(operating.blocked_force_n, 3)),
        ("percent", percent(operating.free_contraction)),
        (
            "stroke",
            trimmed(operating.free_contraction * muscle.length_mm(), 1),
        ),
        ("points", plan.test.len().to_string()),
        ("files", files.join("\n")),
    ];
    if operating
        .allowed_mpa
        .is_some_and(|allowed| operating.pressure_mpa > allowed * (1.0 + 1e-9))
    {
        values.push(("above", String::new()));
    }
    values.extend(cut_list(plan));
    values.extend(plugs(plan));
    values.extend(clamping(plan));
    values.extend(tests(plan));
    // Texts of others come last: they have no places.
    let warnings: Vec<String> = plan
        .warnings()
        .iter()
        .map(|w| format!("**Warning:** {}.", clean::markdown(w)))
        .collect();
    values.extend((!warnings.is_empty()).then(|| ("warned", warnings.join("\n\n"))));
    values.extend(bill(plan));
    values.push(("model", clean::markdown(&operating.model)));
    render(include_str!("../templates/readme.md"), &[], &values)
}

fn cut_list(plan: &Plan) -> Values {
    let (cut, sleeve) = (&plan.cut, &plan.cut.sleeve);
    let row =
        |cell: &dyn Fn(&SleeveLength) -> String| joined(sleeve.by_diameter.iter().map(cell), " | ");
    let stretch = plan.muscle.tube().prestretch;
    let mut values = vec![
        ("tube", mm(cut.tube_mm)),
        (
            if plan.is_aramid() { "tapes" } else { "melts" },
            String::new(),
        ),
        ("cut_outer", mm(cut.tube_outer_diameter_mm)),
        ("insertion", mm(plan.muscle.insertion_mm())),
        if stretch == 1.0 {
            ("slack", String::new())
        } else {
            ("stretch", significant(stretch, 4))
        },
        ("strand", trimmed(sleeve.strand_mm, 1)),
        (
            "strands",
            sleeve
                .strands
                .map_or_else(String::new, |n| format!(" It has {n} strands.")),
        ),
        ("diameters", row(&|r| mm(r.diameter_mm))),
        ("columns", "|---".repeat(sleeve.by_diameter.len())),
        ("lengths", row(&|r| trimmed(r.length_mm, 0))),
    ];
    values.extend(match (sleeve.relaxed_mm, sleeve.relaxed_diameter_mm) {
        (Some(length), Some(diameter)) => {
            vec![
                ("relaxed", trimmed(length, 1)),
                ("relaxed_diameter", mm(diameter)),
            ]
        }
        _ => vec![("mounted", mm(sleeve.mounted_mm))],
    });
    values
}

fn bill(plan: &Plan) -> Values {
    let dash = || "–".to_owned();
    let row = |part: &BuildPart| {
        format!(
            "| {} | {} | {} | {} | {} | {} |",
            part.number,
            clean::markdown(&part.part),
            clean::markdown(&part.amount),
            part.sold_as
                .as_ref()
                .map_or_else(dash, |name| format!("`{}`", clean::markdown(name))),
            part.mass_g
                .map_or_else(dash, |mass| format!("{} g", significant(mass, 3))),
            part.price
                .as_ref()
                .map_or_else(dash, |price| clean::markdown(price))
        )
    };
    let sources: Vec<String> = plan
        .parts
        .iter()
        .filter_map(|p| p.source.as_ref())
        .map(|source| format!("- {}", clean::markdown(source)))
        .collect();
    let mut values = vec![
        ("mass", significant(plan.mass_g(), 3)),
        ("parts", joined(plan.parts.iter().map(row), "\n")),
    ];
    values.extend((!sources.is_empty()).then(|| ("sources", sources.join("\n"))));
    values
}

fn plugs(plan: &Plan) -> Values {
    let air = &plan.air_plug;
    let eye = &plan.eye_plug;
    let stem = &air.stem;
    let (made, change) = if plan.is_printed() {
        (
            "printed",
            "scale the plug in the printer's program, across its axis",
        )
    } else {
        ("turned", "change the diameter of the stem")
    };
    let is_stated = plan.muscle.terminals().plug_diameter_mm.is_some();
    let mut values = vec![
        (made, String::new()),
        if is_stated {
            ("stated", String::new())
        } else {
            ("chosen", change.into())
        },
        ("stem", mm(stem.diameter_mm)),
        ("stem_length", mm(stem.length_mm)),
        ("bore", mm(stem.bore_mm())),
        ("interference", mm(stem.interference_mm)),
        ("passage", mm(air.passage_mm)),
        ("hole", mm(eye.hole_mm)),
        ("bolt", mm(eye.bolt_mm)),
        ("thickness", mm(eye.thickness_mm)),
        ("load", significant(plan.end_load_n, 2)),
        (
            "bearing",
            significant(plan.end_load_n / (eye.bolt_mm * eye.thickness_mm), 2),
        ),
    ];
    match (air.fitting, air.fitting.thread_mm()) {
        (Fitting::Barb { bore_mm }, _) => values.push(("hose", mm(bore_mm))),
        (thread, Some((drill, depth, _))) => {
            values.extend([
                ("thread", thread.to_string()),
                ("drill", mm(drill)),
                ("depth", mm(depth)),
            ]);
        }
        // Every fitting without a thread is a barb.
        _ => {}
    }
    values
}

fn clamping(plan: &Plan) -> Values {
    let mut values = vec![
        ("clamped", mm(plan.clamped_diameter_mm)),
        ("tie_holds", significant(plan.tie_holds_n, 2)),
    ];
    values.extend(match plan.clamps {
        Clamps::Ties {
            width_mm,
            at_each_end,
        } => {
            vec![("tie", mm(width_mm)), ("grooves", at_each_end.to_string())]
        }
        Clamps::Crimped => vec![("crimp", mm(plan.crimp_diameter_mm))],
    });
    values
}

fn tests(plan: &Plan) -> Values {
    let (safety, operating, allowed) = (&plan.safety, &plan.operating, plan.operating.allowed_mpa);
    let burst = operating.burst.map_or_else(
        || "not known: no number for it is stated".into(),
        |(burst_mpa, by)| format!("{}: {by}", operating.pressure(burst_mpa)),
    );
    vec![
        ("working", operating.pressure(safety.pressure_mpa)),
        ("burst", burst),
        (
            "allowed",
            allowed.map_or_else(|| "not known".into(), |mpa| operating.pressure(mpa)),
        ),
        (
            "relief",
            operating.pressure(relief_mpa(
                safety.pressure_mpa,
                allowed.unwrap_or(f64::INFINITY),
            )),
        ),
        ("proof", operating.pressure(safety.proof_pressure_mpa)),
        ("leak", operating.pressure(safety.leak_pressure_mpa)),
        ("energy", significant(safety.air_energy_j, 2)),
        (
            "energy_at_proof",
            significant(safety.air_energy_at_proof_j, 2),
        ),
    ]
}
