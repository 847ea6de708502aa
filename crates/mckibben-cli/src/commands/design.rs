//! `design`: the main job.

use crate::output::ShownUnits;
use crate::typed::in_flags;
use crate::{
    Bar, Format, NO_ANSWER, Plot, Problem, Units, burst_first, check_ending, each, emit, headed,
    listed, number, pairs, place, print_text, said, save, tabled, value,
};
use mckibben::units::rounded;
use mckibben_app::{CandidateAnswer, ClosestAnswer, DesignAnswer, DesignRequest, RejectedAnswer};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// The main job.
#[derive(Debug, clap::Args)]
#[command(after_long_help = "Examples:
  mckibben design --force 700N --contraction 15% --max-pressure 2.5bar
  mckibben design --at 700N@15%,1200N@5% --max-pressure 2.5bar \\
    --max-bulged-diameter 80mm --plot muscle.svg
  mckibben design -F 300N --stroke 40mm --length 285 --max-pressure 3bar \\
    -D 20..40:5 -s 1,1.5,2 --rubber dragon-skin-30
  mckibben design --force 700N --contraction 15% --max-pressure 2.5bar \\
    -o winner.toml
  mckibben design --load mass:20kg --stroke 40mm --length 285 \\
    --max-pressure 3bar
  mckibben design --force 700N --contraction 15% --max-pressure 2.5bar \\
    --count 7 --max-envelope 80mm
  mckibben design -F 50N -e 15% --max-pressure 2.5bar --length 200 \\
    --liquid water --max-liquid 20mL
  mckibben design --joint 8Nm@45deg,3Nm@60deg --max-pressure 6bar \\
    --length 250 --max-bulged-diameter 40mm --rubber dragon-skin-30")]
pub struct Design {
    #[command(flatten)]
    request: DesignRequest,
    /// Everything that is known of them, and the near misses
    #[arg(long, help_heading = "Output")]
    all: bool,
    #[command(flatten)]
    units: ShownUnits,
    #[command(flatten)]
    plot: Plot,
    /// Write the best muscle as a muscle file
    #[arg(short, long, value_name = "FILE.toml", help_heading = "Output")]
    output: Option<PathBuf>,
}

impl Design {
    pub fn run(mut self, format: Format) -> Result<u8, Problem> {
        let target = self.output.as_deref();
        check_ending(target, &["toml"])?;
        self.request.load.read_tables()?;
        self.request.figure = self.plot.wanted();
        let mut answer = mckibben_app::design(&self.request, &Bar::new("muscles"))?;
        let winner = answer.muscle_files.first();
        if let Some(winner) = winner {
            save(target, winner.text.as_bytes())?;
        }
        let text = |answer: &DesignAnswer, u: &Units| {
            burst_first(&answer.warnings) + &as_text(answer, target, self.all, u)
        };
        print_text(format, &answer, "candidates", text)?;
        if let (Some(path), Some(_), Format::Text) = (target, winner, format) {
            emit(format!("\nThe winner is in {}.\n", place(path)), None)?;
        }
        self.plot.save(&mut answer.figure)?;
        Ok(if answer.candidates.is_empty() {
            NO_ANSWER
        } else {
            0
        })
    }
}

const HEAD: &str =
    "Required[ of each of {each} muscles]: {what} with at most {max_pressure_mpa}[ of {liquid.name}][ with {gas:%} of gas][, guaranteed: the lower end of the ± ({searched.guaranteed:%}) meets it]
Model {model}[, searched with {other}]; {looked_at} muscles examined, {fitting} fit; [L0 {searched.length_mm:5}, ]{searched.rubber}, {searched.braid}
Safety: [strands stretched by at most {searched.max_strand_strain:%}; ][allowed pressure: that at which strands or clamps fail over {checked}, that of the tube over {searched.min_tube_margin}][burst not checked (safety factor {unchecked}), because the strength of the strands is not stated][{unlimited}]
";

/// The design for people: the decision, the candidates, what is assumed; with `all` everything that
/// is known.
fn as_text(answer: &DesignAnswer, file: Option<&Path>, all: bool, u: &Units) -> String {
    let (searched, mut row) = (&answer.searched, value(answer));
    let line = |line: &String| {
        let line = in_flags(&u.sentence(line));
        let (verb, rest) = line.split_once(' ').unwrap_or_default();
        (verb.to_owned(), rest.to_owned())
    };
    let mut out = pairs(&answer.decision.iter().map(line).collect::<Vec<_>>());
    let near = answer
        .rejected
        .iter()
        .skip(usize::from(answer.closest.is_some()));
    let near: String = near
        .map(|r| format!("  {}\n", missed(r, "[ (misses by {by:%} in all)]", u)))
        .collect();
    if let Some(closest) = &answer.closest {
        out += &nothing_fits(closest, u);
        out.extend(closest.hint.as_ref().map(|hint| in_flags(hint) + "\n"));
    }
    let words = answer.uncertainty_words.as_ref();
    if answer.closest.is_none() {
        out += &format!(
            "\n{}",
            candidates(&answer.candidates, searched.length_mm.is_none(), all, u)
        );
        let words = words.filter(|_| all);
        out.extend(
            words
                .and_then(|w| w.text_in(u))
                .map(|text| format!("± of the first: {text}.\n")),
        );
        out.extend(
            words
                .and_then(|w| w.bench_in(u))
                .map(|text| format!("{text}.\n")),
        );
        let parts = [bundle(answer, u), joint(answer, file, u)];
        out.extend(parts);
    }
    row["each"] = answer
        .candidates
        .first()
        .map(|c| c.count)
        .filter(|n| *n > 1)
        .into();
    if all {
        row["what"] = wanted(&row, u).into();
        row["gas"] = answer
            .liquid
            .as_ref()
            .map(|l| l.gas_share)
            .filter(|share| *share > 0.0)
            .into();
        row["other"] = Some(&*answer.searched_with)
            .filter(|with| **with != *answer.model)
            .into();
        let margin = searched.min_burst_margin;
        row["checked"] = margin.filter(|_| searched.burst_checked).into();
        row["unchecked"] = margin.filter(|_| !searched.burst_checked).into();
        row["unlimited"] = margin.is_none().then_some("no limit on burst").into();
        out += &format!("\n{}", said(&row, HEAD, u));
    }
    out.push('\n');
    let assumed = answer
        .assumptions
        .iter()
        .map(|sentence| format!("Assumed: {}.\n", in_flags(sentence)));
    out.extend(assumed);
    out.push_str(&bought(answer, &row, u));
    match &answer.closest {
        _ if near.is_empty() => out,
        Some(_) => out + "\nNext closest\n" + &near,
        None if all => out + "\nNear misses\n" + &near,
        None => out,
    }
}

/// What the muscles of a bundle do together.
fn bundle(answer: &DesignAnswer, u: &Units) -> String {
    let Some(b) = &answer.bundle else {
        return String::new();
    };
    let mut row = value(b);
    if b.muscles < 2 {
        row["pitch_mm"] = Value::Null;
    } else if b.touch_contraction.is_none() {
        row["touch_contraction"] = "do not touch".into();
    }
    let keys = "rest_envelope_mm=circle_around_them_at_rest:3 envelope_mm=at_the_bulge:3 \
        row_mm=width_in_one_flat_row:3 pitch_mm=distance_of_their_axes:3 \
        touch_contraction=neighbours_touch_at:%";
    let points = "force_n=required contraction=at:% force_at_max_pressure_n+uncertainty_n=F \
        air_normal_litres=air:3 liquid_volume_mm3=liquid:3";
    let (sizes, points) = (pairs(&listed(&row, keys, u)), tabled(&b.points, points, u));
    format!(
        "\nBundle of {} of the first muscle, at the maximum pressure\n{sizes}{points}",
        b.muscles
    )
}

/// The muscles as sold that would do.
fn bought(answer: &DesignAnswer, row: &Value, u: &Units) -> String {
    let keys = "product name outer_diameter_mm=D0 length_mm=L0 force_n+uncertainty_n=F \
        wanted.contraction=at:% pressure_mpa=P wanted.force_n=required";
    headed(
        &said(row, "As sold these would do[, {each} of one]", u),
        &answer.bought,
        keys,
        u,
    )
}

/// What the muscle must do.
fn wanted(row: &Value, u: &Units) -> String {
    let pulls = each(
        &row["wanted"]["points"],
        "{force_n:5} at {contraction:%}",
        u,
    );
    let torques = each(
        &row["wanted"]["torques"],
        "{torque_nm} at ±{angle_deg:#}°",
        u,
    );
    let lifted = "[{load} lifted by {wanted.stroke_mm:5}][{load} lifted to {wanted.contraction:%}]";
    said(row, lifted, u) + &pulls.join(", ") + &torques.join(", ")
}

/// The pulley between the muscles, and the joint file that goes with them.
fn joint(answer: &DesignAnswer, file: Option<&Path>, u: &Units) -> String {
    let Some((j, count)) = answer
        .candidates
        .first()
        .and_then(|c| Some((c.joint?, c.count)))
    else {
        return String::new();
    };
    let share = if count > 1 {
        format!(" (its torque is that of one of {count})")
    } else {
        String::new()
    };
    let angle = number(j.largest_angle_deg, 4);
    // Not below its length at rest at the largest angle.
    let neutral = number(rounded(100.0 * j.contraction_at_neutral, 5, f64::ceil), 5);
    // A joint file names its muscles relative to itself: it goes beside them.
    let name = file.and_then(Path::file_name).map(Path::new);
    let (name, where_to) = match name {
        Some(name) => (place(name), "beside the muscle file"),
        None => (
            "winner.toml".into(),
            "with the muscle in winner.toml (-o winner.toml)",
        ),
    };
    let written = name.replace('\\', "\\\\").replace('"', "\\\"");
    let muscle = |i: u8| {
        format!("[muscle_{i}]\nfile = \"{written}\"\ncontraction_at_neutral = \"{neutral}%\"\n")
    };
    format!(
        "\nThe first muscle on a pulley of radius {}, both muscles contracted by {neutral} % at \
         the neutral angle. As a joint file{share}, {where_to}:\n\n[joint]\nradius = \"{} \
         mm\"\nrange = \"-{angle}..{angle} deg\"\n\n{}\n{}",
        u.length.show(j.radius_mm),
        number(j.radius_mm, 5),
        muscle(1),
        muscle(2)
    )
}

const MEASURES: &str = "D0 {outer_diameter_mm:4#}, s {wall_mm:3#}[ in {sleeve}]";

/// A muscle with the limit that it misses, and what else is said of it.
fn missed(rejected: &RejectedAnswer, more: &str, u: &Units) -> String {
    let mut row = value(rejected);
    row["reason"] = u.sentence(&rejected.reason).into();
    let thousandths = rejected
        .muscle
        .misses_by
        .filter(|share| *share < 1.0)
        .map(|share| (1e3 * share).ceil());
    row["by"] = thousandths.map(|by| by / 1e3).into();
    said(&row, &format!("{MEASURES}: {{reason}}{more}"), u)
}

fn candidates(list: &[CandidateAnswer], lengths: bool, all: bool, u: &Units) -> String {
    let rows = list.iter().enumerate().map(|(i, c)| {
        let mut row = value(c);
        let needs: Vec<String> = c
            .candidate
            .points
            .iter()
            .map(|q| u.pressure.to(q.response.pressure_mpa, 3))
            .collect();
        row["rank"] = format!("{}.", i + 1).into();
        row["needs"] = needs.join(", ").into();
        row
    });
    let rows: Vec<Value> = rows.collect();
    let any = |key: &str| rows.iter().any(|row| !row[key].is_null());
    let several = |key: &str| rows.windows(2).any(|w| w[0][key] != w[1][key]);
    let [strands, liquid, tubes, mass] =
        ["strand_tension_n", "liquid_volume_mm3", "tube", "mass_g"].map(any);
    let required = format!("needs={}", u.pressure.heading("P_required"));
    let required = required.replace(' ', "_");
    let keys = [
        (true, "rank=_ tube sleeve"),
        (
            all || !tubes,
            "outer_diameter_mm=D0 wall_mm=s:3 angle_deg=θ0",
        ),
        (lengths || several("length_mm"), "length_mm=L0"),
        (
            all && several("family_stiffness_n_per_mm"),
            "family_stiffness_n_per_mm=k:3",
        ),
        (true, &*required),
        (any("sure_pressure_mpa"), "sure_pressure_mpa=P_sure:3"),
        (
            several("highest_pressure_mpa"),
            "highest_pressure_mpa=P_max:3",
        ),
        (
            all,
            "margin:3% blocked_force_n=F_blocked free_contraction=ε_free:3%",
        ),
        (true, "bulged_diameter_mm=bulged_D:3"),
        (!all, "uncertainty_n=±:~"),
        (all, "stiffness_n_per_mm=stiffness:3"),
        (
            all,
            if liquid {
                "liquid_volume_mm3=liquid:3"
            } else {
                "air_normal_litres=air:3"
            },
        ),
        (
            all,
            if strands {
                "strand_tension_n=strand:3"
            } else {
                "braid_tension_n=braid:3"
            },
        ),
        (all, "uncertainty_n=±:~ burst_pressure_mpa=P_burst:3"),
        (
            true,
            if mass {
                "mass_g=mass:3"
            } else {
                "rubber_mass_g=rubber:3"
            },
        ),
        (!tubes && several("rubber"), "rubber"),
    ];
    let keys: Vec<&str> = keys
        .into_iter()
        .filter(|key| key.0)
        .map(|key| key.1)
        .collect();
    let mut out = tabled(&rows, &keys.join(" "), u);
    out += "P required: the pressure of each point.";
    out += if any("sure_pressure_mpa") {
        " P sure: that at which the lower end of the ± meets it."
    } else {
        ""
    };
    out += if several("highest_pressure_mpa") {
        " P max: what supply and muscle allow.\n"
    } else {
        "\n"
    };
    if all {
        out += "margin: pull above the required pull, F blocked and ε free: at P max. stiffness: \
            at the first point. bulged D, air or liquid, strand or braid, ±: the largest of the \
            points.\n\
            air (normal litres: at 0 °C and 1.01325 bar) and liquid: from rest to the point. k: \
            stiffness of one strand family. strand: tension of one strand; braid: of all \
            together.\n\
            ±: 95 % half-width of the pull, against a measured muscle.\n";
    }
    if let Some(first) = list
        .first()
        .map(|c| &c.candidate)
        .filter(|c| all && !c.from_thick_wall.is_empty())
    {
        out.push_str(&format!(
            "From the thick-wall model: {}.\n",
            first.from_thick_wall.join(", ")
        ));
    }
    out
}

fn nothing_fits(closest: &ClosestAnswer, u: &Units) -> String {
    let mut out = format!(
        "Nothing fits. Closest: {}\n",
        missed(&closest.rejected, "", u)
    );
    out += match closest.relaxations.len() {
        0 => "No change of what is required or limited makes a muscle of this search fit.\n",
        1 => "A muscle fits with this change:\n",
        _ => "A muscle fits with any of these changes, the smallest first:\n",
    };
    let changes = closest
        .relaxations
        .iter()
        .map(|change| format!("  - {}\n", in_flags(&u.sentence(&change.text))));
    out + &changes.collect::<String>()
}
