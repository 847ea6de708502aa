//! `braid list|show`.

use crate::failure::Failure;
use crate::flags::OutputFlags;
use crate::format::Format;
use crate::names::SLEEVES;
use crate::output::show as print;
use crate::output::text::{number, or_dash, pairs, percent, table};
use crate::quantities::quantity;
use clap::Args;
use mckibben::units::Dimension;
use mckibben_app::{
    BraidListAnswer, BraidListRequest, BraidPoint, BraidShowAnswer, BraidShowRequest, BraidSummary,
    MaterialSummary, braid_list, braid_show,
};

pub const EXAMPLES: &str = "Examples:
  mckibben braid show nfl-19
  mckibben braid show flexo-overexpanded-0.38in --strand-diameter 0.25mm
  mckibben force -D 20 -s 1 -p 2bar -e 10% --braid nfl-19 \\
    --stiffness inextensible";

/// `braid list`.
#[derive(Debug, Args)]
pub struct BraidListArgs {
    #[command(flatten)]
    pub output: OutputFlags,
}

/// `braid show`.
#[derive(Debug, Args)]
pub struct BraidShowArgs {
    /// Name
    #[arg(value_parser = SLEEVES, hide_possible_values = true)]
    pub name: String,
    /// Show it only on a tube of this outer diameter
    #[arg(short = 'D', long, value_name = "DIAMETER", allow_hyphen_values = true)]
    pub outer_diameter: Option<String>,
    /// Diameter of one strand, if the source does not state it
    #[arg(long, value_name = "DIAMETER", allow_hyphen_values = true)]
    pub strand_diameter: Option<String>,
    /// Young's modulus of a strand, if the source does not state it
    #[arg(long, value_name = "MODULUS", allow_hyphen_values = true)]
    pub strand_modulus: Option<String>,
    #[command(flatten)]
    pub output: OutputFlags,
}

pub fn list(args: &BraidListArgs, format: Format) -> Result<u8, Failure> {
    let answer = braid_list(&BraidListRequest {})?;
    print(&answer, format, "braids", || list_text(&answer), args.output.target())?;
    Ok(0)
}

/// Sleeves, a line each.
pub(super) fn sleeves(list: &[BraidSummary]) -> String {
    let row = |b: &BraidSummary| {
        vec![
            b.name.clone(),
            format!("{} … {}", number(b.least_diameter_mm, 4), number(b.largest_diameter_mm, 4)),
            format!("{}°", number(b.least_angle_deg, 3)),
            or_dash(b.strands, |n| n.to_string()),
            if b.stiffness_factor > 1.0 {
                format!("× {}", number(b.stiffness_factor, 3))
            } else {
                "stated".into()
            },
            b.title.clone(),
        ]
    };
    let header = ["sleeve", "D0 [mm]", "θ0 from", "strands", "k within", "title"];
    table(&header, list.iter().map(row).collect())
}

fn list_text(answer: &BraidListAnswer) -> String {
    let sleeves = sleeves(&answer.braids);
    let row = |m: &MaterialSummary| vec![m.name.clone(), number(m.modulus_mpa * 1e-3, 4), m.title.clone()];
    let materials = table(&["strands of", "E [GPa]", ""], answer.materials.iter().map(row).collect());
    format!(
        "{sleeves}\n{materials}\nD0: tubes on which a muscle of it contracts. k within: factor within which the stiffness is known, because its seller does not state all of its strands. `mckibben braid show NAME` shows the details.\n"
    )
}

pub fn show(args: &BraidShowArgs, format: Format) -> Result<u8, Failure> {
    let length = |flag, text: &Option<String>| quantity(flag, text.as_deref(), Dimension::Length);
    let answer = braid_show(&BraidShowRequest {
        name: args.name.clone(),
        outer_diameter_mm: length("--outer-diameter", &args.outer_diameter)?,
        strand_diameter_mm: length("--strand-diameter", &args.strand_diameter)?,
        strand_modulus_mpa: quantity(
            "--strand-modulus",
            args.strand_modulus.as_deref(),
            Dimension::Pressure,
        )?,
    })?;
    print(&answer, format, "points", || show_text(&answer), args.output.target())?;
    Ok(0)
}

fn strands(answer: &BraidShowAnswer) -> String {
    let bound = if answer.strands_stated { "" } else { " at most (as many as touch each other at its ends)" };
    or_dash(answer.strands, |n| format!("{n}{bound}"))
}

pub(super) fn show_text(answer: &BraidShowAnswer) -> String {
    let mm = |v: f64| format!("{} mm", number(v, 5));
    let range = format!(
        "{} … {}; a muscle of it contracts below {}",
        mm(answer.least_diameter_mm),
        mm(answer.largest_diameter_mm),
        mm(answer.neutral_diameter_mm)
    );
    let mut head = vec![("name", answer.name.clone()), ("title", answer.title.clone())];
    if let Some(nominal) = answer.nominal_diameter_mm {
        head.push(("nominal diameter", mm(nominal)));
    }
    head.extend([
        ("diameters", range),
        ("strand per turn", mm(answer.strand_length_per_turn_mm)),
        ("found from", answer.helix_from.clone()),
        ("material", answer.material.clone()),
        ("strands", strands(answer)),
        ("strand diameter", or_dash(answer.strand_diameter_mm, mm)),
        ("strand modulus", or_dash(answer.strand_modulus_mpa, |e| format!("{} GPa", number(e * 1e-3, 4)))),
    ]);
    if let Some(source) = &answer.modulus_source {
        head.push(("modulus from", source.clone()));
    }
    if answer.filaments > 1 {
        head.push(("filaments", answer.filaments.to_string()));
    }
    if let Some(strength) = answer.strand_strength_n {
        head.push(("strand strength", format!("{} N", number(strength, 4))));
    }
    if !answer.estimated.is_empty() {
        head.push(("estimated", answer.estimated.join(", ")));
    }
    if answer.stiffness_factor > 1.0 {
        head.push(("stiffness known within", format!("a factor of {}", number(answer.stiffness_factor, 3))));
    }
    if let Some(estimate) = &answer.estimate {
        head.push(("estimates from", estimate.clone()));
    }
    if let Some(price) = &answer.price {
        head.push(("price", price.clone()));
    }
    if !answer.missing.is_empty() {
        head.push(("for a stiffness give", answer.missing.join(", ")));
    }
    head.extend([("source", answer.source.clone()), ("terms", answer.terms.clone())]);
    if let Some(note) = &answer.note {
        head.push(("note", note.clone()));
    }
    let row = |p: &BraidPoint| {
        vec![
            number(p.outer_diameter_mm, 5),
            number(p.angle_deg, 4),
            or_dash(p.stiffness_n_per_mm, |k| number(k, 4)),
            percent(p.largest_contraction),
        ]
    };
    let header = ["D0 [mm]", "θ0 [°]", "k [N/mm]", "contracts by"];
    format!("{}\n{}", pairs(&head), table(&header, answer.points.iter().map(row).collect()))
}
