//! The paper of a build, in the order of work: what to heed, what to order, cut list, plugs, steps to
//! tick, and the record to sign.

use crate::{
    BuildPart, Plan, SleeveLength,
    cut::TRIM_MM,
    drawing::drawing,
    ends::{BOLT_MM, BOLT_NM, FERRULE_ROOM_MM, Press},
    frame::Frame,
    material::density_kg_per_m3,
    mould::{self, Mould},
    plug::Stress,
    sheets,
    text::{mm, percent, significant},
};
use mckibben_core::{
    analysis::STRETCH,
    muscle::EndsMade::{Clamped, Crimped, Tied},
    units::rounded,
};
use mckibben_report::{
    Document,
    Part::{self, Break, Drawing, Steps, Stop, Text},
};

/// How exact the distance of the heads is, in mm: what a ruler reads.
const FACES_MM: f64 = 0.5;

impl Plan {
    /// The title of all papers.
    pub fn title(&self) -> String {
        format!(
            "McKibben muscle {} × {}",
            self.shown.bare(self.muscle.outer_diameter_mm()),
            self.shown.length(self.muscle.length_mm())
        )
    }

    /// The highest pressure in MPa that a relief valve may let through.
    pub(crate) fn highest_mpa(&self) -> f64 {
        rounded(self.operating.in_use.pressure_mpa, 3, f64::floor)
    }
}

/// The paper: what to heed, what to order, drawings, steps, and the record.
pub fn paper(plan: &Plan) -> Document {
    let heading = Part::heading;
    let mut parts = vec![Stop(plan.stops()), limits(plan), heading("Order")];
    let part = |p: &BuildPart| {
        [&p.part, &p.size, &p.amount, &p.spare]
            .map(String::clone)
            .to_vec()
    };
    let head = ["part", "size", "amount", "spare"];
    parts.push(Part::table(&head, plan.parts.iter().map(part).collect()));
    parts.push(heading("Cut list"));
    parts.extend(cut_list(plan));
    parts.push(Drawing(drawing(plan)));
    parts.push(heading("Plugs"));
    let port = format!("{} plug", plan.fluid());
    for (what, plug) in [(&*port, &plan.air_plug), ("eye plug", &plan.eye_plug)] {
        parts.extend(sheets::plug(plan, what, plug));
    }
    parts.extend([strength(plan), Steps(plugs(plan))]);
    if plan.is_cast() {
        parts.extend([heading("Casting the tube"), Steps(casting(plan))]);
    }
    parts.extend([
        heading("Assembly"),
        Steps(assembly(plan)),
        heading("Proof and leak test"),
        Drawing(Frame::new(plan).drawing(plan)),
        Steps(tests(plan)),
        Break,
        heading("Record"),
        record(plan),
    ]);
    Document {
        title: plan.title(),
        title_block: plan.title_block.clone(),
        lead: plan.verdict().join(" "),
        parts,
        footer: "Sources are in bom.csv and in the documentation.".into(),
    }
}

fn limits(plan: &Plan) -> Part {
    let (shown, limits) = (&plan.shown, &plan.operating.limits);
    let unknown = || "not known".to_owned();
    let burst = limits.burst_pressure_mpa.zip(limits.burst_by);
    let burst = burst.map(|(mpa, by)| {
        let nominal = limits.nominal_burst_pressure_mpa;
        let nominal =
            nominal.map(|p| format!(" at least, {} by nominal numbers", shown.pressure(p)));
        format!(
            "{}{}: {by}",
            shown.pressure(mpa),
            nominal.unwrap_or_default()
        )
    });
    let allowed = limits.allowed_pressure_mpa.map(|mpa| shown.pressure(mpa));
    Part::pairs([
        (
            "working pressure",
            shown.pressure(plan.operating.pressure_mpa),
        ),
        ("relief valve", shown.pressure(plan.highest_mpa())),
        ("allowed pressure", allowed.unwrap_or_else(unknown)),
        (
            "burst pressure, without the ends",
            burst.unwrap_or_else(unknown),
        ),
    ])
}

fn cut_list(plan: &Plan) -> [Part; 3] {
    let (cut, shown) = (&plan.cut, &plan.shown);
    let sleeve = &cut.sleeve;
    let length = |mm: f64| shown.length(mm.round());
    let on_plug = plan.air_plug.stem.tube_mm();
    let stretch = plan.muscle.tube().prestretch;
    let stretched = if stretch == 1.0 {
        String::new()
    } else {
        format!(
            " / {} (it is mounted with that stretch)",
            significant(stretch, 4)
        )
    };
    let [free, plugged] = [plan.muscle.length_mm(), on_plug].map(|mm| shown.length(mm));
    let (of, at) = match (sleeve.relaxed_mm, sleeve.relaxed_diameter_mm) {
        (Some(long), Some(diameter)) => (
            length(long),
            format!("relaxed, at a diameter of {}", shown.length(diameter)),
        ),
        _ => (length(sleeve.mounted_mm), "on the tube".to_owned()),
    };
    let trim = shown.length(TRIM_MM);
    let rows = vec![
        vec![
            "tube".into(),
            shown.length(cut.tube_mm),
            format!("{free}{stretched} and {plugged} on each plug"),
        ],
        vec![
            "sleeve".into(),
            of,
            format!("{at}; {trim} are trimmed before the second end is closed"),
        ],
    ];
    let row = |name: &str, mm: fn(&SleeveLength) -> f64| {
        let cells = sleeve.by_diameter.iter().map(|row| shown.bare(mm(row)));
        [name.to_owned()].into_iter().chain(cells).collect()
    };
    let by_diameter = vec![
        row("sleeve is wide", |row| row.diameter_mm),
        row("cut to", |row| row.length_mm.round()),
    ];
    let (strand, unit) = (shown.length(sleeve.strand_mm.round()), shown.length.name);
    let strands = sleeve.strands.map_or_else(String::new, |n| {
        format!(" It has {n} strands{}.", plan.estimate())
    });
    [
        Part::table(&["part", "length", ""], rows),
        Text(format!(
            "The strands of the sleeve keep their length, {strand} each: a wide sleeve is short.{strands} Measure its diameter where you cut it, and \
             take the length from this table ({unit}):"
        )),
        Part::table(&[], by_diameter),
    ]
}

fn plugs(plan: &Plan) -> Vec<String> {
    let (plug, shown) = (&plan.air_plug, &plan.shown);
    let stem = shown.toleranced(plug.stem.diameter_mm, plug.tolerance_mm());
    let mut steps = if plug.is_printed() {
        vec![
            "Print both STL files of plugs as they lie in the file, on the end of their heads: \
             PETG, layers of 0.2 mm, six walls, 100 % infill, seam on a corner of the head, no \
             support."
                .to_owned(),
            format!(
                "Measure both stems: {stem}. Smooth the stem, and coat it with \
                 epoxy resin or thin cyanoacrylate: printed layers leak."
            ),
            format!("Drill the holes for the bolts to {} mm.", mm(plug.hole_mm)),
        ]
    } else {
        vec![format!(
            "Have both plugs turned and milled by their sheets and STEP files; printed ones would break. \
             Check the stems: {stem}, no burr."
        )]
    };
    steps.push(
        "Cut the thread into the flat of the head. Screw in the fitting by hand until its seal \
         touches, then a quarter of a turn. Blow through the passage."
            .into(),
    );
    steps
}

/// How far the loaded parts of the air plug stay below their yield in the proof test.
fn strength(plan: &Plan) -> Part {
    let load_n = plan.loads.proof_end_load_high_n;
    let mut stresses = plan.air_plug.stresses(load_n);
    stresses.push(Frame::new(plan).stress(load_n));
    let row = |s: &Stress| {
        let factor = significant(s.yields_mpa / s.mpa, 2);
        vec![s.what.into(), factor, mm(s.factor)]
    };
    let head = ["in the proof test", "yield over stress", "at least"];
    Part::table(&head, stresses.iter().map(row).collect())
}

fn casting(plan: &Plan) -> Vec<String> {
    let mould = Mould::new(&plan.cut);
    let name = plan.muscle.tube().rubber.name.as_deref();
    let name = name.unwrap_or("the rubber");
    let density = density_kg_per_m3(&plan.muscle);
    let half_g = density.map_or_else(
        || "?".into(),
        |density| significant(0.5e-6 * density * mould.mixed_mm3, 3),
    );
    let stated = mould::castable(name);
    let flows = stated.as_ref().map_or_else(
        || format!("The pot life of {name} is not in the catalogue: read its can."),
        |rubber| {
            format!(
                "It flows for {} min from mixing on.",
                mm(rubber.pot_life_min)
            )
        },
    );
    let cure = stated.map_or_else(
        || "as long as its maker states".into(),
        |rubber| format!("for {} h at 23 °C", mm(rubber.cure_h)),
    );
    vec![
        format!(
            "Print bodies/mould-cap.stl twice. Drill a hole of 4 mm into the pipe {} mm above its lower \
             end, for the syringe, and two vents of 2 mm, one opposite the other, {} mm above it.",
            mm(mould::HOLE_MM),
            mm(mould.vents_mm)
        ),
        "Clean rod and pipe, spray them with release agent, let it dry. Put a cap on each end of the \
         pipe, and the rod through both."
            .into(),
        format!(
            "Mix {} mL of {name}: parts A and B by what its maker states (1 : 1 by mass: {half_g} g \
             of each). Degas it under vacuum until it \
             has risen and fallen.",
            mixed_ml(plan)
        ),
        format!(
            "Press it in from below with a syringe of 60 mL, {} fillings, slowly, until it shows in \
             both vents of the upright pipe. {flows}",
            mm(mould.syringes())
        ),
        format!(
            "Close the hole with tape, also between two fillings of the syringe; leave the vents \
             open. Let it cure upright {cure}."
        ),
        format!(
            "Take off the caps. Blow isopropyl alcohol or air between rod and tube, and draw the \
             rod; then push the tube out. Look for bubbles against the light: none in the wall. Cut \
             {} from the middle.",
            plan.shown.length(plan.cut.tube_mm)
        ),
    ]
}

/// Volume of the rubber to mix, in mL.
pub fn mixed_ml(plan: &Plan) -> String {
    significant(1e-3 * Mould::new(&plan.cut).mixed_mm3, 3)
}

/// How long a quarter of a turn of a strand is along the tube.
fn quarter_turn(plan: &Plan) -> String {
    let quarter_mm = 0.25 * plan.muscle.length_mm() / plan.muscle.turns();
    plan.shown.length(quarter_mm)
}

/// How an end is closed.
fn closing(plan: &Plan) -> String {
    let (shown, ends) = (&plan.shown, &plan.ends);
    let around = shown.length(plan.clamped_diameter_mm);
    let squeezed = shown.length(plan.squeezed_mm());
    let holds = plan.ends_hold();
    match ends.made {
        Tied => format!(
            "Tighten a cable tie of {} mm over each of the {} grooves, on the sleeve ({around} wide \
             there). Each end: {holds}.",
            mm(ends.band_mm),
            ends.at_each_end
        ),
        Clamped => format!(
            "Tighten each hose clamp behind its barb, on the sleeve ({around} wide there), to about \
             {squeezed}: the wall of the tube is then squeezed by a quarter (a choice). Each end: \
             {holds}."
        ),
        Crimped => {
            let seal = format!(
                "the {} over sleeve and tube behind the barb, to about {squeezed}: it seals. Each end: \
                 {holds}.",
                ends.band()
            );
            match ends.press {
                Some(Press::Ferrule(ferrule)) => format!(
                    "Pull the ferrule over the sleeve on the ribbed shoulder beyond the tube ({around} \
                     wide), {} from the head. Press it to a diameter of {}: it carries the load. The dies \
                     may stand out over the tube, with the {} pushed back. Tighten {seal}",
                    shown.length(FERRULE_ROOM_MM[1]),
                    shown.length(ferrule.pressed_mm),
                    ends.band()
                ),
                _ => format!(
                    "Pull the {} over the sleeve on the ribbed shoulder beyond the tube ({around} wide). \
                     Tighten the bolts (M{}) to {} N·m, twice, an hour apart: they carry the load. \
                     Tighten {seal}",
                    ends.pressed_by(),
                    mm(BOLT_MM),
                    mm(BOLT_NM)
                ),
            }
        }
    }
}

fn assembly(plan: &Plan) -> Vec<String> {
    let (shown, ends) = (&plan.shown, &plan.ends);
    let fray = if plan.is_aramid() {
        "aramid does not melt: wrap tape around it first, and cut through the tape"
    } else {
        "melt the ends of the sleeve, so that they do not fray"
    };
    let stem = &plan.air_plug.stem;
    let pressed = &*format!(
        "clamps ({0}, {1}, {1}, {0})",
        ends.pressed_by(),
        ends.band()
    );
    vec![
        format!("Cut tube and sleeve as the cut list says, square; {fray}."),
        format!(
            "Push the {} plug into the tube, until {} of the tube lie behind the barb or the first \
             groove, up to the {}. Isopropyl alcohol helps; oil attacks latex and natural rubber.",
            plan.fluid(),
            shown.length(stem.tube_mm()),
            if stem.shoulder_mm.is_some() { "shoulder" } else { "head" }
        ),
        format!(
            "Put the {} of both ends over the sleeve now. Push the sleeve together, so that it is \
             wide; work it along the tube like an inchworm, until its end meets the head.",
            match ends.made {
                Tied => "ties",
                Clamped => "clamps",
                Crimped => pressed,
            }
        ),
        closing(plan),
        "Push in the eye plug, with its bolt hole parallel to the other one. Straighten the sleeve along \
         the tube until it lies on it everywhere, without folds or twist. Mark it where it meets the \
         head; push it back, and cut it there like the other end."
            .into(),
        format!(
            "Before the second end is closed: {} ± {} between the inner faces of both heads; \
             strands at {}° ± 1° to the axis; a quarter of a turn of a strand is {} long along the tube. If it is \
             longer, push the sleeve together.",
            shown.length(plan.faces_mm(0.0)),
            shown.tolerance(FACES_MM),
            angle(plan),
            quarter_turn(plan)
        ),
        "Close the second end likewise. Mark the sleeve at the inner edge of both clamps.".into(),
    ]
}

fn tests(plan: &Plan) -> Vec<String> {
    let (shown, safety) = (&plan.shown, &plan.safety);
    let [proof, leak] =
        [safety.proof_pressure_mpa, safety.leak_pressure_mpa].map(|p| shown.pressure(p));
    let fill = if plan.liquid {
        "Screw the bleed screw with its seal into the eye plug, two turns. Hold the eye plug upwards; \
         press water in from below until no bubble comes, and close the screw."
    } else {
        "Fill it with water by a syringe on the fitting, held upwards: draw the air out, let water \
         in, and repeat until no bubble comes."
    };
    let mut steps = vec![
        fill.to_owned(),
        format!(
            "Bolt it into the frame, {} between the heads: the bolt of each end lies in a pair of bars with \
             holes {}.",
            shown.length(plan.faces_mm(0.0)),
            mm(plan.air_plug.hole_mm)
        ),
        "The nuts of both rods lie on the bridges, and press the pairs apart. Safety glasses, a screen, \
         nobody in line with the muscle."
            .into(),
        format!(
            "Raise the pressure with a hand pump in four steps to {proof}. Then stretch the muscle by the \
             nuts to {} between the heads, and hold both for one minute.",
            shown.length(plan.faces_mm(-STRETCH))
        ),
        "It passes if the pressure stays, no mark on the sleeve moves, and the tube does not bulge \
         through the mesh. If a mark moves, let the pressure off: the end does not hold."
            .into(),
    ];
    if plan.liquid {
        steps.extend([
            "Let the pressure off, and take it out of the frame. Fill it with its liquid as with water."
                .into(),
            format!(
                "Leak test with {}: {leak} for five minutes, dry paper around both ends. No \
                 spot may show.",
                plan.fluid()
            ),
        ]);
    } else {
        steps.extend([
            "Let the pressure off, then the water out; take the muscle out of the frame, and dry it."
                .into(),
            format!(
                "Leak test with air: {leak}, free to contract, under water, behind the screen, for one minute. No \
                 bubble may grow. Then shut the valve: the pressure may fall by {} in five minutes (a \
                 choice).",
                percent(0.05)
            ),
        ]);
    }
    steps.push(
        "After the first 50 strokes repeat the leak test, and compare the marks. Replace the tube when it turns \
         dull or sticky."
            .into(),
    );
    steps
}

fn record(plan: &Plan) -> Part {
    let (shown, safety) = (&plan.shown, &plan.safety);
    let plug = &plan.air_plug;
    let [proof, leak] =
        [safety.proof_pressure_mpa, safety.leak_pressure_mpa].map(|p| shown.pressure(p));
    let [rest, stretched] = [0.0, -STRETCH].map(|e| shown.length(plan.faces_mm(e)));
    let lost = match plan.liquid {
        true => "no spot",
        false => "5 % of the pressure at most",
    };
    let none = String::new;
    let rows = [
        ("serial number", none()),
        (
            "stems",
            shown.toleranced(plug.stem.diameter_mm, plug.tolerance_mm()),
        ),
        (
            "between the heads, at rest",
            format!("{rest} ± {}", shown.tolerance(FACES_MM)),
        ),
        ("angle of the strands", format!("{}° ± 1°", angle(plan))),
        ("a quarter of a turn of a strand", quarter_turn(plan)),
        ("strands counted", none()),
        (
            "mass",
            format!("{} g (known parts)", significant(plan.mass_g(), 3)),
        ),
        ("built by, date", none()),
        ("proof with water", proof),
        ("stretched to, one minute", stretched),
        ("load of an end", plan.proof_load()),
        ("marks moved", "0 mm".into()),
        ("leak test", format!("{leak}, {}", plan.fluid())),
        ("lost in five minutes", lost.into()),
        ("passed: tested by, date", none()),
    ];
    let row = |(name, text): (&str, String)| vec![name.to_owned(), text, none()];
    Part::table(&["", "required", "measured"], rows.map(row).into())
}

fn angle(plan: &Plan) -> String {
    mm((10.0 * plan.muscle.braid().angle_deg).round() / 10.0)
}
