//! The bill of materials.

use crate::{
    Cut, Plan, SleeveCut,
    ends::{BOLT_BAND_MM, BOLT_MM, Press},
    frame::Frame,
    mould::Mould,
    paper,
    plug::Plug,
    text::{mm, significant},
};
use mckibben_core::{
    clean, muscle::Muscle, rubber::library as rubbers, sleeve::library as sleeves,
};
use mckibben_design::tubes::{self, TubePart};

/// Tolerance of equal diameters of part and muscle, in mm.
const SAME_MM: f64 = 0.011;
/// Ranges of hose clamps as they are sold (DIN 3017-1), in mm.
const RANGES_MM: [[u16; 2]; 16] = [
    [8, 12],
    [10, 16],
    [12, 22],
    [16, 27],
    [20, 32],
    [25, 40],
    [32, 50],
    [40, 60],
    [50, 70],
    [60, 80],
    [70, 90],
    [80, 100],
    [90, 110],
    [100, 120],
    [120, 140],
    [140, 160],
];
/// A line of the bill.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Default, serde::Serialize, schemars::JsonSchema)]
pub struct BuildPart {
    /// What it is.
    pub part: String,
    /// Its size and standard.
    pub size: String,
    /// How much of it.
    pub amount: String,
    /// How much more to have at hand.
    pub spare: String,
    /// Name as sold, where it is of the catalogue.
    pub sold_as: Option<String>,
    /// Mass in g, where it is known.
    pub mass_g: Option<f64>,
    /// Price as its source states it.
    pub price: Option<String>,
    /// Where name and price come from.
    pub source: Option<String>,
}

/// The tube of the catalogue that has the muscle's diameters and rubber.
pub fn tube_of(muscle: &Muscle, cut: &Cut) -> Option<&'static TubePart> {
    let name = muscle.tube().rubber.name.as_deref()?;
    let same = |a: f64, b: f64| (a - b).abs() < SAME_MM;
    tubes::catalogue().ok()?.iter().find(|t| {
        same(t.outer_diameter_mm, cut.tube_outer_diameter_mm)
            && same(t.wall_mm, cut.tube_wall_mm)
            && t.rubber.name.as_deref() == Some(name)
    })
}

/// Density of the rubber in kg/m³, where it is known.
pub fn density_kg_per_m3(muscle: &Muscle) -> Option<f64> {
    let of_rubber = || {
        let name = muscle.tube().rubber.name.as_deref()?;
        rubbers::entry(name).ok()?.density_kg_per_m3
    };
    muscle.tube().density_kg_per_m3.or_else(of_rubber)
}

/// A part that is bought by its size.
fn bought(part: &str, size: String, count: usize) -> BuildPart {
    BuildPart {
        part: part.into(),
        size,
        amount: count.to_string(),
        spare: "1".into(),
        ..BuildPart::default()
    }
}

/// A part that all muscles share, or that is used up.
fn shared(part: &str, size: impl Into<String>, amount: impl Into<String>) -> BuildPart {
    BuildPart {
        amount: amount.into(),
        spare: "–".into(),
        ..bought(part, size.into(), 1)
    }
}

/// What presses the sleeve on the shoulders.
fn pressed(plan: &Plan, press: Press) -> BuildPart {
    match press {
        Press::BoltClamps(count) => {
            let on = significant(plan.clamped_diameter_mm, 3);
            let [band, bolt] = [BOLT_BAND_MM, BOLT_MM].map(mm);
            let size = format!("DIN 3017-3, ⌀{on} mm, band {band} mm, bolt M{bolt}");
            bought("clamp with a T-bolt", size, 2 * count)
        }
        Press::Ferrule(ferrule) => {
            let [outer, wall, long] =
                [ferrule.outer_mm, ferrule.wall_mm, ferrule.length_mm].map(mm);
            let size =
                format!("steel tube EN 10305-1, E235+N, {outer} × {wall} mm, {long} mm long");
            bought("ferrule", size, 2)
        }
    }
}

/// What is ordered: of each of equal muscles side by side, then what all of them share.
pub fn bill(plan: &Plan) -> Vec<BuildPart> {
    let mut parts = of_a_muscle(plan);
    for part in &mut parts {
        let count = plan.count();
        part.amount = match part.amount.parse::<u32>() {
            Ok(each) => (count * each).to_string(),
            Err(_) if count > 1 => format!("{count} × {}", part.amount),
            Err(_) => continue,
        };
    }
    if plan.is_cast() {
        let mould = Mould::new(&plan.cut);
        let [rod, rod_length, bore, pipe] = [
            mould.rod_mm,
            mould.rod_length_mm,
            mould.bore_mm,
            mould.pipe_mm,
        ]
        .map(mm);
        let size = format!(
            "rod {rod} mm, {rod_length} mm long; smooth pipe with a bore of {bore} mm, {pipe} mm \
             long; release agent, syringe of 60 mL, scale"
        );
        parts.push(shared("mould for the tube", size, "1"));
    }
    let frame = Frame::new(plan);
    let long = |mm: f64| plan.shown.length(mm.ceil());
    let flat = |what: &str, [length, width, thick]: [f64; 3]| {
        let size = format!("EN 10058, S235JR, {width} × {thick} mm");
        shared(what, size, format!("4 × {}", long(length)))
    };
    let bar = frame.bar;
    let rod = format!("DIN 976-1, class 8.8, M{}, with 8 nuts", mm(frame.rod_mm));
    parts.extend([
        flat(
            "bars of the frame",
            [frame.bar_length_mm, bar.width_mm, bar.thick_mm],
        ),
        flat("bridges of the frame", frame.bridge_mm),
        shared(
            "threaded rods of the frame",
            rod,
            format!("2 × {}", long(frame.rod_length_mm)),
        ),
    ]);
    parts.extend(used(plan));
    parts
}

/// What is used up, and what measures.
fn used(plan: &Plan) -> impl Iterator<Item = BuildPart> {
    let shown = &plan.shown;
    let [relief, proof] =
        [plan.highest_mpa(), plan.safety.proof_pressure_mpa].map(|mpa| shown.pressure(mpa));
    let supply = if plan.liquid {
        "pump, shut-off valve, relief valve"
    } else {
        "regulator, shut-off valve, relief valve"
    };
    let pull = shown.force(plan.operating.stretched.range_n()[2]);
    let hose = plan.air_plug.port.map(|port| port.fitting.hose());
    let hose = hose.map(|hose| shared(&hose, format!("for {proof}"), "2 m"));
    let resin = "epoxy resin or thin cyanoacrylate";
    let resin = shared(resin, "to seal the printed plugs", "a little");
    let all = [
        shared(supply, format!("relief at {relief}"), "1 each"),
        shared(
            "hand pump with gauge",
            format!("for water, to {proof}"),
            "1",
        ),
        shared("safety glasses, screen", "for the proof test", "1 each"),
        shared(
            "load cell or spring scale",
            format!("for at least {pull}"),
            "1",
        ),
        shared(
            "isopropyl alcohol",
            "to push the tube on; it dries",
            "a little",
        ),
        shared(
            "adhesive tape",
            "to mark, and to cut a sleeve that does not melt",
            "0.5 m",
        ),
        shared(
            "thread seal tape",
            "for a thread without a seal of its own",
            "0.2 m",
        ),
    ];
    let resin = plan.air_plug.is_printed().then_some(resin);
    all.into_iter().chain(hose).chain(resin)
}

fn of_a_muscle(plan: &Plan) -> Vec<BuildPart> {
    let plug = |name: &str, plug: &Plug| BuildPart {
        mass_g: Some(plug.mass_g()),
        spare: "–".into(),
        ..bought(name, plug.bought(), 1)
    };
    let bolt = |plug: &Plug| {
        let [diameter, length] = [plug.bolt.mm, plug.bolt_length_mm()].map(mm);
        let size = format!("M{diameter} × {length} mm, class {}", plug.bolt.class);
        bought("bolt with nut", size, 1)
    };
    let mut bolts = vec![bolt(&plan.air_plug), bolt(&plan.eye_plug)];
    if bolts[0] == bolts[1] {
        bolts.truncate(1);
        bolts[0].amount = "2".into();
    }
    let ends = &plan.ends;
    let clamps = 2 * ends.at_each_end;
    let band = mm(ends.band_mm);
    let size = if ends.has_ties {
        format!("{band} mm wide, PA 66")
    } else {
        let [from, to] = [plan.squeezed_mm(), plan.clamped_diameter_mm];
        let mut sold = RANGES_MM.map(|range| range.map(f64::from)).into_iter();
        let sold = sold.find(|[low, high]| *low <= from && to <= *high);
        let [from, to] = sold.unwrap_or([from, to]).map(|mm| significant(mm, 3));
        format!("DIN 3017-1, {from} to {to} mm, band {band} mm")
    };
    let clamp = BuildPart {
        spare: if ends.has_ties { clamps } else { 1 }.to_string(),
        ..bought(ends.band(), size, clamps)
    };
    let proof = plan.shown.pressure(plan.safety.proof_pressure_mpa);
    let for_proof = format!("for {proof} at least: it is in the proof test too");
    let mut parts = vec![
        tube(plan),
        sleeve(plan, &plan.cut.sleeve),
        plug(&format!("{} plug", plan.fluid()), &plan.air_plug),
        plug("eye plug", &plan.eye_plug),
        clamp,
    ];
    if plan.is_cast() {
        parts.insert(
            0,
            BuildPart {
                amount: format!("{} mL", paper::mixed_ml(plan)),
                spare: "–".into(),
                ..bought("silicone for the tube", "parts A and B".into(), 1)
            },
        );
    }
    let fitting = plan.air_plug.port.map(|port| port.fitting);
    parts.extend(fitting.map(|fitting| bought(&fitting.part(), for_proof, 1)));
    parts.extend(bolts);
    parts.extend(ends.press.map(|press| pressed(plan, press)));
    let bleed = fitting.filter(|_| plan.liquid);
    parts.extend(bleed.map(|fitting| bought("bleed screw with seal", fitting.to_string(), 1)));
    parts
}

fn tube(plan: &Plan) -> BuildPart {
    let (muscle, cut) = (&plan.muscle, &plan.cut);
    let tube = tube_of(muscle, cut);
    let rubber = muscle.tube().rubber.name.as_deref();
    let what = if plan.is_cast() { "cast tube" } else { "tube" };
    let shown = |mm: f64| plan.shown.length(mm);
    let (bore, outer) = (cut.bore_mm(), cut.tube_outer_diameter_mm);
    BuildPart {
        part: rubber.map_or_else(|| what.into(), |name| format!("{what} of {name}")),
        size: format!("bore {}, outer diameter {}", shown(bore), shown(outer)),
        amount: plan.shown.length(cut.tube_mm),
        spare: plan.shown.length(cut.tube_mm),
        sold_as: tube.map(|t| t.name.clone()),
        mass_g: density_kg_per_m3(muscle).map(|d| 1e-6 * d * cut.rubber_mm3),
        price: tube.and_then(|t| t.price.clone()),
        source: tube.map(|t| t.source.clone()),
    }
}

fn sleeve(plan: &Plan, cut: &SleeveCut) -> BuildPart {
    let muscle = &plan.muscle;
    let shape = muscle.braid().sleeve.as_ref();
    let entry = shape.and_then(|s| sleeves::entry(&s.name).ok());
    let density = entry
        .and_then(|e| e.modulus_of)
        .and_then(|material| material.density_kg_per_m3);
    let volume = cut
        .strands
        .zip(cut.strand_area_mm2)
        .map(|(n, area)| f64::from(n) * area * cut.strand_mm);
    let shown = |mm: f64| plan.shown.length(mm);
    let amount = match (cut.relaxed_mm, cut.relaxed_diameter_mm) {
        (Some(length), Some(diameter)) => {
            format!("{} at a diameter of {}", shown(length), shown(diameter))
        }
        _ => format!("{} on the tube", shown(cut.mounted_mm)),
    };
    let strands = cut
        .strands
        .map_or_else(String::new, |n| format!(", {n} strands{}", plan.estimate()));
    let angle = mm(muscle.braid().angle_deg);
    let on = mm(muscle.outer_diameter_mm());
    BuildPart {
        part: entry.map_or_else(|| "braided sleeve".into(), |entry| entry.title.clone()),
        size: format!("{angle}° on {on} mm{strands}"),
        spare: shown(cut.relaxed_mm.unwrap_or(cut.mounted_mm)),
        amount,
        sold_as: shape.map(|s| s.name.clone()),
        mass_g: volume.zip(density).map(|(v, d)| 1e-6 * d * v),
        price: entry.and_then(|e| e.price.clone()),
        source: entry.map(|e| e.source.clone()),
    }
}

/// The bill as a table for spreadsheets.
pub fn csv(plan: &Plan) -> Result<String, csv::Error> {
    let mut out = csv::Writer::from_writer(vec![]);
    out.write_record([
        "part", "size", "amount", "spare", "sold as", "mass (g)", "price", "source",
    ])?;
    for part in &plan.parts {
        let (sold_as, price, source) = (&part.sold_as, &part.price, &part.source);
        let texts = [
            &part.part,
            &part.size,
            &part.amount,
            &part.spare,
            sold_as.as_deref().unwrap_or("by dimension"),
            &part.mass_g.map_or_else(String::new, |g| significant(g, 3)),
            price.as_deref().unwrap_or_default(),
            source.as_deref().unwrap_or_default(),
        ];
        let cells = texts.map(|text| clean::cell(&clean::line(text)).into_owned());
        out.write_record(&cells)?;
    }
    let bytes = out.into_inner().map_err(|e| e.into_error())?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
