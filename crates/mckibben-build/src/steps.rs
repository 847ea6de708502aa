//! Cut list, bill of materials and steps, in Markdown.

use crate::text::{fixed, mm, percent, significant};
use crate::{Clamps, Fitting, Plan, SleeveLength};
use mckibben_io::clean;
use mckibben_io::files::File;
use std::fmt::Write as _;

/// The whole page, with links to the other files.
pub(crate) fn markdown(plan: &Plan, files: &[File]) -> String {
    let (muscle, found) = (&plan.muscle, &plan.operating);
    let mut out = format!(
        "# McKibben muscle {} × {} mm\n\n![Drawing of the muscle](drawing.svg)\n\n",
        mm(muscle.outer_diameter_mm()),
        mm(muscle.length_mm())
    );
    let _ = writeln!(
        out,
        "At {} it pulls {} N when it is held at its length, and contracts by {} ({} mm) without load (model {}).\n",
        found.pressure(found.pressure_mpa),
        significant(found.blocked_force_n, 3),
        percent(found.free_contraction),
        fixed(found.free_contraction * muscle.length_mm(), 1),
        clean::markdown(&found.model)
    );
    if found.allowed_mpa.is_some_and(|allowed| found.pressure_mpa > allowed * (1.0 + 1e-9)) {
        out.push_str("**Warning:** the working pressure is above the largest allowed one (see the tests below). Lower it, or build another muscle.\n\n");
    }
    for warning in plan.warnings() {
        let _ = writeln!(out, "**Warning:** {}.\n", clean::markdown(&warning.to_string()));
    }
    out.push_str("| file | |\n|---|---|\n");
    for file in files {
        let _ = writeln!(out, "| [{0}]({0}) | {1} |", file.name, file.about);
    }
    cut_list(plan, &mut out);
    bill(plan, &mut out);
    plugs(plan, &mut out);
    assembly(plan, &mut out);
    tests(plan, &mut out);
    bench(plan, &mut out);
    out
}

fn cut_list(plan: &Plan, out: &mut String) {
    let (cut, sleeve) = (&plan.cut, &plan.cut.sleeve);
    let clamped = mm(plan.muscle.terminals().insertion_mm());
    out.push_str("\n## Cut list\n\n| part | length | |\n|---|---|---|\n");
    let stretch = plan.muscle.tube().prestretch;
    let how = if stretch == 1.0 {
        format!("free length {} mm and {clamped} mm on each plug", mm(plan.muscle.length_mm()))
    } else {
        format!(
            "before it is stretched: {} mm / {} and {clamped} mm on each plug",
            mm(plan.muscle.length_mm()),
            significant(stretch, 4)
        )
    };
    let _ = writeln!(out, "| tube | {} mm | {how} |", mm(cut.tube_mm));
    let first = match (sleeve.relaxed_mm, sleeve.relaxed_diameter_mm) {
        (Some(length), Some(diameter)) => {
            format!("{} mm | relaxed, at its diameter of {} mm |", fixed(length, 1), mm(diameter))
        }
        _ => format!("{} mm | on the tube, at the braid angle |", mm(sleeve.mounted_mm)),
    };
    let _ = writeln!(out, "| sleeve | {first}");
    out.push('\n');
    let strands = sleeve.strands.map_or_else(String::new, |n| format!(" It has {n} strands."));
    let _ = writeln!(
        out,
        "The strands of the sleeve keep their length: {} mm each over the whole cut, so that a wide sleeve is short and a narrow one is long.{strands}\n\
         Measure the diameter of the sleeve where you cut it, and take the length from this table (in mm):\n",
        fixed(sleeve.strand_mm, 1)
    );
    let row = |out: &mut String, head: &str, of: &dyn Fn(&SleeveLength) -> String| {
        let cells: Vec<String> = sleeve.by_diameter.iter().map(of).collect();
        let _ = writeln!(out, "| {head} | {} |", cells.join(" | "));
    };
    row(out, "diameter of the sleeve", &|r| mm(r.diameter_mm));
    let _ = writeln!(out, "|---{}|", "|---".repeat(sleeve.by_diameter.len()));
    row(out, "length to cut", &|r| fixed(r.length_mm, 0));
}

fn bill(plan: &Plan, out: &mut String) {
    out.push_str("\n## Bill of materials\n\n| no. | part | amount | sold as | mass | price |\n|---|---|---|---|---|---|\n");
    let dash = || "–".to_owned();
    for part in &plan.parts {
        let _ = writeln!(
            out,
            "| {} | {} | {} | {} | {} | {} |",
            part.number,
            clean::markdown(&part.part),
            clean::markdown(&part.amount),
            part.sold_as.as_ref().map_or_else(dash, |name| format!("`{}`", clean::markdown(name))),
            part.mass_g.map_or_else(dash, |mass| format!("{} g", significant(mass, 3))),
            part.price.as_ref().map_or_else(dash, |price| clean::markdown(price))
        );
    }
    let _ = writeln!(out, "\nThe parts with a mass weigh {} g together.", significant(plan.mass_g(), 3));
    let sources: Vec<&String> = plan.parts.iter().filter_map(|p| p.source.as_ref()).collect();
    if !sources.is_empty() {
        out.push_str("Names and prices are those of these sources; `mckibben parts show NAME` prints all that is known of a part.\n\n");
        sources.iter().for_each(|source| {
            let _ = writeln!(out, "- {}", clean::markdown(source));
        });
    }
}

fn plugs(plan: &Plan, out: &mut String) {
    let (air, eye) = (&plan.air_plug, &plan.eye_plug);
    let stem = &air.stem;
    let (make, scale, seal) = if plan.is_printed() {
        (
            "Print `air-plug.stl` and `eye-plug.stl` solid (100 % infill, at least 4 walls): the air plug with its fitting on the bed, the eye plug with a support below its eye.",
            "scale the plug in the printer's program, across its axis",
            " A printed surface leaks along its layers: coat it with epoxy resin or thin cyanoacrylate.",
        )
    } else {
        (
            "Turn both plugs from metal, by `plugs.pdf`: printed ones would break. `air-plug.stl` and `eye-plug.stl` show their shape.",
            "change the diameter of the stem",
            "",
        )
    };
    let fit = if plan.muscle.terminals().plug_diameter_mm.is_some() {
        format!("what the muscle file states. The bore of the tube has {} mm.", mm(stem.bore_mm()))
    } else {
        format!(
            "the bore of the tube and {} mm. How tight it sits is a choice; sellers of barbs say only that a barb is a little larger than the bore. If the tube does not go on or slides off, {scale}.",
            mm(stem.interference_mm)
        )
    };
    let _ = writeln!(
        out,
        "\n## 1. Plugs\n\n\
         1. {make}\n\
         2. The stem has {} mm: {fit}\n\
         3. Smooth the stem.{seal}",
        mm(stem.diameter_mm)
    );
    let fitting = match (air.fitting, air.fitting.thread_mm()) {
        (Fitting::Barb { bore_mm }, _) => {
            format!("Push the hose (bore {} mm) over the barb, and clamp it.", mm(bore_mm))
        }
        (thread, Some((drill, depth, _))) => format!(
            "Cut the thread {thread} into the hole of {} mm, {} mm deep, and screw in the fitting with its seal: by hand, then at most one turn. Clear the passage of {} mm.",
            mm(drill),
            mm(depth),
            mm(air.passage_mm)
        ),
        // Every fitting without a thread is a barb.
        _ => String::new(),
    };
    let _ = writeln!(
        out,
        "4. {fitting}\n5. The eye has a hole of {} mm for the bolt M{}, and is {} mm thick; at the load of an end ({} N) the bolt presses on it with {} MPa.",
        mm(eye.hole_mm),
        mm(eye.bolt_mm),
        mm(eye.thickness_mm),
        significant(plan.end_load_n, 2),
        significant(plan.end_load_n / (eye.bolt_mm * eye.thickness_mm), 2)
    );
}

fn assembly(plan: &Plan, out: &mut String) {
    let (muscle, cut) = (&plan.muscle, &plan.cut);
    let inserted = mm(plan.air_plug.stem.length_mm);
    let _ = writeln!(
        out,
        "\n## 2. Assembly\n\n\
         1. Cut the tube to {} mm, square to its axis. Cut the sleeve as the cut list says, and melt its ends so that they do not fray.",
        mm(cut.tube_mm)
    );
    if muscle.tube().prestretch != 1.0 {
        let _ = writeln!(
            out,
            "   The tube is mounted with a stretch of {}: its outer diameter is {} mm before, {} mm after.",
            significant(muscle.tube().prestretch, 4),
            mm(cut.tube_outer_diameter_mm),
            mm(muscle.outer_diameter_mm())
        );
    }
    let _ = writeln!(
        out,
        "2. Push the air plug {inserted} mm into the tube, up to its collar. A little isopropyl alcohol helps, and dries. Do not use oil: it attacks latex and natural rubber.\n\
         3. Pull the sleeve over the tube and up to the collar. Mark both clamps' inner edges on it.\n\
         4. {}\n\
         5. Pull the sleeve along the tube until it lies on it everywhere, without folds. Push in the eye plug, and clamp it the same way.\n\
         6. Measure: {} mm ± 0.5 mm from clamp to clamp; the strands at {}° ± 1° to the axis. One turn of a strand is {} mm long along the tube. If it is longer, the sleeve is \
         pulled too much: open one end, push the sleeve together, clamp again.\n\
         7. If you measure the force at which an end lets go, state it as `pull_off` in [terminals] of the muscle file.",
        clamping(plan),
        mm(muscle.length_mm()),
        mm(muscle.braid().angle_deg),
        fixed(muscle.length_mm() / muscle.turns(), 1)
    );
}

fn clamping(plan: &Plan) -> String {
    let load = significant(plan.end_load_n, 2);
    let outer = mm(plan.clamped_diameter_mm);
    match plan.clamps {
        Clamps::Ties { width_mm, at_each_end } => format!(
            "Tighten one cable tie of {} mm over each of the {at_each_end} grooves, on the sleeve ({outer} mm wide there), and cut off its end. The end must hold {load} N: the \
             blocked force, and the pressure on the bore. A tie holds about {} N by estimate (friction 0.3, a third of its least strength of QB/T 4494); no measured \
             pull-off of a tie on a muscle is known.",
            mm(width_mm),
            significant(plan.tie_holds_n, 2)
        ),
        Clamps::Crimped => format!(
            "Slide a ferrule over the sleeve ({outer} mm wide on the plug), and crimp it to an inner diameter of about {} mm: the wall of the tube is then pressed to three quarters of \
             its thickness, which is a choice. Or take a hose clamp whose range has its mean slightly above {outer} mm. The end must hold {load} N: the blocked force, and the \
             pressure on the bore. Cable ties hold too little (about {} N each, by estimate); no measured pull-off of a clamp on a muscle is known.",
            mm(plan.crimp_diameter_mm),
            significant(plan.tie_holds_n, 2)
        ),
    }
}

fn tests(plan: &Plan, out: &mut String) {
    let safety = &plan.safety;
    let found = &plan.operating;
    let burst = found.burst.map_or_else(
        || "not known: no number for it is stated".into(),
        |(burst_mpa, by)| format!("{}: {by}", found.pressure(burst_mpa)),
    );
    let allowed = found.allowed_mpa.map_or_else(|| "not known".into(), |mpa| found.pressure(mpa));
    let _ = writeln!(
        out,
        "\n## 3. Leak test and proof test\n\n\
         | | |\n|---|---|\n\
         | working pressure | {} |\n| burst pressure by the model | {} |\n| largest allowed pressure | {} |\n\
         | proof pressure | {} |\n| energy of the air at the working pressure | {} J |\n| energy of air at the proof pressure | {} J |\n\n\
         Hoses for compressed air burst at 4 times their working pressure or above (RMA IP-2, Hose Handbook). The allowed pressure is a \
         quarter of that at which strands or clamps fail, half of that at which the tube does, which then leaks, and at most that of the fittings. The proof is at twice the working \
         pressure, and at most at three quarters of the burst pressure, so that it does not destroy a good muscle (rules of thumb, no source). The burst pressure is that of new parts; hand-made ends may fail far below it. The energy is that of an isothermal expansion, \
         p V ln(p/p₀) with the absolute pressure p: an upper bound.",
        found.pressure(safety.pressure_mpa),
        burst,
        allowed,
        found.pressure(safety.proof_pressure_mpa),
        significant(safety.air_energy_j, 2),
        significant(safety.air_energy_at_proof_j, 2)
    );
    let _ = writeln!(
        out,
        "\n1. **Proof test with water, never with air.** Hold the muscle with the air plug upwards, and fill it with water until no air is left. Put on safety glasses, and put the muscle into a box or \
         behind a screen. Raise the pressure with a hand pump in four steps to {}, and hold it for one minute. It passes if the pressure stays, no end moves \
         (watch the marks on the sleeve), and the tube does not bulge through the mesh.\n\
         2. Let the water out, and dry the muscle.\n\
         3. **Leak test with air**: raise the pressure to {}, put the muscle under water behind the screen, and watch for one minute. No bubble may grow. Then shut the valve: \
         the pressure may fall by 5 % in five minutes (a choice).\n\
         4. After the first 50 strokes, repeat the leak test, and compare the marks at the clamps. Replace latex when it turns dull or sticky.",
        found.pressure(safety.proof_pressure_mpa),
        found.pressure(safety.leak_pressure_mpa)
    );
}

fn bench(plan: &Plan, out: &mut String) {
    let _ = writeln!(
        out,
        "\n## 4. First test\n\n\
         `test.csv` has {} points, in the order in which they are measured. Fix the clamps at the distance that a row states, raise the pressure from row to row, then lower it, and \
         write the force in N into `force_n`. Then\n\n\
         ```sh\nmckibben identify muscle.toml --data test.csv -o found.toml\n```\n\n\
         writes the muscle as it was built. All commands then take `found.toml`.",
        plan.test.len()
    );
}
