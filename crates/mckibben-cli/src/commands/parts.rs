//! `parts list|show`.

use crate::{
    Format, Output, Problem, Units, listed, output::text::law_text, pairs, tabled, value, warn,
};
use clap::Subcommand;
use mckibben_app::{
    PartKind, PartShowAnswer, PartShowRequest, PartsListAnswer, PartsListRequest, RubberDetails,
    part_show, parts_list,
};

/// The lists, their columns, and what these are.
const LISTS: [(&str, &str, &str); 5] = [
    (
        "tubes",
        "name=tube inner_diameter_mm=bore outer_diameter_mm=D0 wall_mm=wall rubber is_cast=cast",
        "",
    ),
    (
        "sleeves",
        "name=sleeve least_diameter_mm=D0_from largest_diameter_mm=to least_angle_deg=θ0_from:3 \
         strands stiffness_factor=k_within title",
        "D0: tubes on which a muscle of it contracts. k within: factor within which the stiffness \
         is known; above 1 where its seller does not state all of its strands.\n",
    ),
    (
        "rubbers",
        "name=rubber shear_modulus_mpa=μ:3~ law curve max_strain=breaks_at:3% title",
        "μ: shear modulus at rest of the law that the name means in the prototype. curve: fitted \
         to its curve, up to the stretches in the prototype: another muscle may use another law; \
         NAME:LAW selects one.\n",
    ),
    (
        "muscles",
        "name=muscle outer_diameter_mm=D0 length_mm=L0 pressure_mpa=P:3~ \
         blocked_force_n+uncertainty_n=F_blocked free_contraction=ε_free:3% points product source",
        "P: highest pressure of the bench. F blocked, its ± (95 %) and ε free: there, by fe.\nA \
         name replaces a muscle file: mckibben force lib:dmsp-20-300 -p 5bar -e 10%\n",
    ),
    ("models", "name=model description", ""),
];

/// What is shown of a part of each kind.
const DETAILS: [(&str, &str); 5] = [
    (
        "tube",
        "name=tube inner_diameter_mm=bore outer_diameter_mm wall_mm rubber density_kg_per_m3 \
         is_cast=cast_by_hand price pressure_mpa=largest_pressure_named source note",
    ),
    (
        "sleeve",
        "name title nominal_diameter_mm least_diameter_mm:5 largest_diameter_mm:5 \
         neutral_diameter_mm=contracts_below:5 strand_length_per_turn_mm:5 helix_from=found_from \
         material strands strands_stated strand_diameter_mm strand_modulus_mpa \
         modulus_source=modulus_from filaments strand_strength_n estimated \
         stiffness_factor=stiffness_known_within_a_factor_of estimate=estimates_from price \
         missing=for_a_stiffness_give source terms note",
    ),
    (
        "rubber",
        "name title max_strain=breaks_at_a_strain_of:3% max_stress_mpa=at_a_stress_of:3 \
         data=curve_in_data/ laws source terms note",
    ),
    (
        "muscle",
        "name title product outer_diameter_mm wall_mm length_mm angle_deg rubber braid \
         pressure_mpa=highest_pressure blocked_force_n+uncertainty_n free_contraction:3% source \
         terms known unknown fit identified points agreement.rms_n=rms_difference:3 \
         agreement.rms_of_blocked=of_the_blocked_force:2% agreement.largest_n=largest_difference:3 \
         agreement.bench_points=points_of_its_length agreement.held=within_the_±:3%",
    ),
    (
        "model",
        "name description needs source uncertainty_basis=basis_of_the_±",
    ),
];

/// What has a name.
#[derive(Debug, Subcommand)]
pub enum Parts {
    /// All of them, or those of one kind
    #[command(after_long_help = "Example:
  mckibben parts list tubes")]
    List {
        #[command(flatten)]
        request: PartsListRequest,
        #[command(flatten)]
        output: Output,
    },
    /// What has a name: its data, source and terms
    #[command(after_long_help = "Examples:
  mckibben parts show latex-1/4x3/8in
  mckibben parts show dragon-skin-30
  mckibben design -F 60N -e 15% -p 4bar --tube latex-1/4x3/8in")]
    Show {
        #[command(flatten)]
        request: PartShowRequest,
        #[command(flatten)]
        output: Output,
    },
}

impl Parts {
    pub fn run(self, format: Format) -> Result<u8, Problem> {
        match self {
            Self::List { request, output } => {
                let rows = match request.kind {
                    None | Some(PartKind::Tubes) => "tubes",
                    Some(PartKind::Sleeves) => "sleeves",
                    Some(PartKind::Rubbers) => "rubbers",
                    Some(PartKind::Muscles) => "muscles",
                    Some(PartKind::Models) => "models",
                };
                output.show(format, &parts_list(&request)?, rows, list_text)
            }
            Self::Show { request, output } => {
                output.show(format, &part_show(&request)?, "", show_text)
            }
        }
    }
}

fn list_text(answer: &PartsListAnswer, u: &Units) -> String {
    let all = value(answer);
    let one = |(name, keys, about): (&str, &str, &str)| {
        let list = all[name].as_array().filter(|list| !list.is_empty())?;
        Some(tabled(list, keys, u) + about + "\n")
    };
    let lists: String = LISTS.into_iter().filter_map(one).collect();
    lists + "`mckibben parts show NAME` shows source, price and use.\n"
}

fn show_text(answer: &PartShowAnswer, u: &Units) -> String {
    let all = value(answer);
    let named = DETAILS
        .into_iter()
        .filter(|(name, _)| all[*name].is_object());
    let parts = named.map(|(name, keys)| pairs(&listed(&all[name], keys, u)) + "\n");
    let mut out: String = parts.collect();
    if let Some(rubber) = &answer.rubber {
        rubber.warnings.iter().for_each(warn);
        out += &fits_text(rubber, u);
    }
    if all["sleeve"].is_object() {
        let points = all["sleeve"]["points"].as_array().into_iter().flatten();
        let keys = "outer_diameter_mm=D0 angle_deg=θ0 stiffness_n_per_mm=k \
            largest_contraction=contracts_by:%";
        out += &tabled(points, keys, u);
    }
    out + answer
        .muscle
        .as_ref()
        .map_or("", |muscle| &muscle.muscle_file.text)
}

/// The laws of a rubber, without those that the data refuse.
fn fits_text(rubber: &RubberDetails, u: &Units) -> String {
    let rows = rubber.fits.iter().map(|fit| {
        let mut row = value(fit);
        row["constants"] = law_text(&fit.fit).into();
        row["taken"] = if fit.by_reach { "→" } else { "" }.into();
        row
    });
    let rows = rows.filter(|row| row["standing"] != "behind");
    let keys = "taken=_ reach_up_to=reach:3~ up_to_strain=data_to:3% points \
        constants=law_and_constants shear_modulus_mpa=μ:3~ r_squared=R²:5~ standing \
        planar_difference=differs:2%~";
    tabled(rows, keys, u)
        + &format!(
            "→: --rubber {} means it, for a muscle that stretches its rubber up to the reach \
             (`mckibben check`); between two reaches it means constants between theirs, beyond the \
             last those of the last.\nstanding: equal where the data do not distinguish a law from \
             the recommended one. differs: at most so much from it in planar tension. Laws that \
             fit less well: --format json.\n",
            rubber.rubber
        )
}
