//! All numbers of a build.

use crate::{
    BuildPart, Cut, EndLoads, Fitting, Operating, PullAt, Safety, TestPoint,
    ends::{Clamped, Ends, SQUEEZE},
    material,
    plug::{ALUMINIUM, PETG, Plug},
    shown::Shown,
    stem::Stem,
    test_points,
    text::{percent, significant},
};
use mckibben_core::{
    analysis::{BUCKLING, PROOF_TO_BURST, PROOF_TO_WORKING, STRETCH},
    liquid::LIQUIDS,
    model::Response,
    muscle::{EndsMade, Muscle, Terminals},
    refused::Refused,
    rubber::RubberLaw,
    sleeve::library,
    warning::buckling_load_n,
};
use std::f64::consts::PI;

/// Choices of the builder.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Wishes {
    /// The connection of the hose.
    pub fitting: Option<Fitting>,
    /// Bolts of the heads in mm.
    pub bolt_mm: Option<f64>,
    /// Diameter in mm of the sleeve as it comes off the roll.
    pub sleeve_diameter_mm: Option<f64>,
    /// The muscle is filled with a liquid, as it also is where its job names one.
    pub liquid: bool,
    /// The units of all files.
    pub shown: Shown,
    /// Title block of all sheets: names of fields and texts.
    pub title_block: Vec<(String, String)>,
}

/// All numbers of a build.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// With the length on its plugs stated.
    pub muscle: Muscle,
    /// Its results by a model.
    pub operating: Operating,
    /// Whether it is filled with a liquid, else with air.
    pub liquid: bool,
    /// Units of all texts.
    pub shown: Shown,
    /// Names and texts of the fields of each drawing.
    pub title_block: Vec<(String, String)>,
    /// Lengths of tube and sleeve.
    pub cut: Cut,
    /// Diameter over the sleeve in mm: two strands cross on each side.
    pub over_sleeve_mm: f64,
    /// Diameter in mm over tube and sleeve on a plug, on which a clamp closes; that over the sleeve
    /// on a shoulder is the same.
    pub clamped_diameter_mm: f64,
    /// What pulls on the ends in use and in the proof test.
    pub loads: EndLoads,
    /// How tube and sleeve are held.
    pub ends: Ends,
    /// The plug with the passage.
    pub air_plug: Plug,
    /// The plug without a passage.
    pub eye_plug: Plug,
    /// Pressures of the tests.
    pub safety: Safety,
    /// The bill of materials.
    pub parts: Vec<BuildPart>,
    /// The points of the first test.
    pub test: Vec<TestPoint>,
    /// What is expected at each of them.
    pub expected: Vec<PullAt>,
}

/// Least length in mm on a plug.
const LEAST_INSERTION_MM: f64 = 3.0;
/// Largest load in N of a printed plug in the proof test, and its least bore in mm (choices).
const PRINTED_TO_N: f64 = 600.0;
const PRINTED_FROM_MM: f64 = 4.0;
/// The load of an end in the proof test over that in use at least, where burst pressure or strands
/// limit the proof (a choice).
const LEAST_PROOF: f64 = 1.2;
/// The same of every other (a choice).
pub const USUAL_PROOF: f64 = 1.5;

impl Plan {
    /// All numbers of a muscle with results by a model.
    ///
    /// # Errors
    /// [`Refused`] where no plug, bolt or clamp bears the proof test, with what would have to give.
    pub fn new(muscle: Muscle, operating: Operating, wishes: &Wishes) -> Result<Self, Refused> {
        let job = muscle.job();
        let wishes = &Wishes {
            liquid: wishes.liquid || job.is_some_and(|job| job.liquid.is_some()),
            ..wishes.clone()
        };
        let loads = EndLoads::new(&muscle, &operating);
        if let Some(message) = unproved(&operating, &loads, LEAST_PROOF, &wishes.shown) {
            return Err(Refused::new(["pressure_mpa"], message));
        }
        let EndParts {
            muscle,
            cut,
            ends,
            air_plug,
            eye_plug,
            over_sleeve_mm,
            clamped_diameter_mm,
        } = EndParts::new(&muscle, loads.proof_n(), wishes)?;
        refuse_narrow(&muscle, &cut, wishes)?;
        let mut plan = Self {
            clamped_diameter_mm,
            over_sleeve_mm,
            cut,
            loads,
            ends,
            eye_plug,
            air_plug,
            safety: Safety::new(&operating, muscle.rest_volume_mm3(), wishes.liquid),
            parts: vec![],
            test: test_points::points(&operating),
            expected: vec![],
            muscle,
            operating,
            liquid: wishes.liquid,
            shown: wishes.shown,
            title_block: wishes.title_block.clone(),
        };
        plan.parts = material::bill(&plan);
        Ok(plan)
    }

    /// Distance in mm between the inner faces of both heads at a contraction: what a ruler reaches.
    pub fn faces_mm(&self, contraction: f64) -> f64 {
        self.muscle.length_mm() * (1.0 - contraction) + 2.0 * self.muscle.insertion_mm()
    }

    /// Diameter in mm to which a clamp squeezes the end.
    pub fn squeezed_mm(&self) -> f64 {
        self.clamped_diameter_mm - 2.0 * SQUEEZE * self.cut.tube_wall_mm
    }

    /// Whether its tube is one that people cast.
    pub(crate) fn is_cast(&self) -> bool {
        material::tube_of(&self.muscle, &self.cut).is_some_and(|tube| tube.is_cast)
    }

    /// Radius in mm of the pulley of its joint, and the contraction with which it is mounted there.
    pub(crate) fn of_joint(&self) -> Option<(f64, f64)> {
        let job = self.muscle.job()?;
        Some((job.pulley?.into(), job.contraction_at_neutral?.into()))
    }

    /// Equal muscles that are built: a joint has them on both sides.
    pub(crate) fn count(&self) -> u32 {
        let side_by_side = self.muscle.job().and_then(|job| job.count).unwrap_or(1);
        self.of_joint().map_or(1, |_| 2) * side_by_side
    }

    /// What fills it, in a word.
    pub fn fluid(&self) -> &'static str {
        let named = self.muscle.job().and_then(|job| job.liquid.as_deref());
        let known = LIQUIDS.iter().find(|known| Some(known.name) == named);
        match self.liquid {
            true => known.map_or("liquid", |known| known.name),
            false => "air",
        }
    }

    /// Whether the strands are known to be of aramid.
    pub fn is_aramid(&self) -> bool {
        let shape = self.muscle.braid().sleeve.as_ref();
        shape.is_some_and(|shape| {
            let entry = library::entry(&shape.name).ok();
            entry
                .map_or(&*shape.name, |e| &e.material)
                .contains("aramid")
        })
    }

    /// What stands behind numbers of strands that are estimated.
    pub fn estimate(&self) -> &'static str {
        if self.muscle.braid().stiffness_factor > 1.0 {
            " (estimate)"
        } else {
            ""
        }
    }

    /// Mass in g of the parts whose mass is known.
    pub fn mass_g(&self) -> f64 {
        self.parts.iter().filter_map(|p| p.mass_g).sum()
    }

    /// Pressures in MPa for the test sheet: shares of the working pressure, to 0.01 MPa where they
    /// then differ.
    pub fn test_pressures_mpa(working_mpa: f64) -> [f64; 5] {
        let step = if working_mpa >= 0.1 {
            0.01
        } else {
            working_mpa / 100.0
        };
        [0.3, 0.5, 0.7, 0.85, 1.0].map(|share| match share {
            1.0 => working_mpa,
            share => (share * working_mpa / step).round() * step,
        })
    }

    /// Of a muscle that extends, without a guide: the push in N at which it buckles at its length at
    /// rest; over [`BUCKLING`] it is the allowed push.
    fn buckling_n(&self) -> Option<f64> {
        let at_rest = Response {
            pressure_mpa: self.operating.pressure_mpa,
            ..Response::default()
        };
        buckling_load_n(&self.muscle, &at_rest)
    }

    /// What each end carries in the proof test, with the range as built.
    pub(crate) fn proof_load(&self) -> String {
        let loads = &self.loads;
        let [low, proof, high] = [
            loads.proof_end_load_low_n,
            loads.proof_end_load_n,
            loads.proof_end_load_high_n,
        ]
        .map(|n| self.shown.force(n));
        match low == high {
            true => proof,
            false => format!("{proof} ({low} to {high} as built)"),
        }
    }

    /// What each end carries, in words.
    pub fn ends_carry(&self) -> String {
        let (loads, use_, shown) = (&self.loads, &self.operating.in_use, &self.shown);
        format!(
            "each carries up to {} in use (at {}, {}, while it lengthens) and {} in the proof test: {} \
             times as much, and {} times what it carries stretched by {} at that pressure",
            shown.force(loads.end_load_n),
            shown.pressure(use_.pressure_mpa),
            percent(use_.contraction),
            self.proof_load(),
            significant(loads.proof_to_use, 3),
            significant(loads.proof_to_stretched, 3),
            percent(STRETCH)
        )
    }

    /// What the ends hold, in words.
    pub fn ends_hold(&self) -> String {
        let [low, high] = self.ends.holds_n.map(|n| self.shown.force(n));
        if low == high {
            return format!("by estimate they hold {low}");
        }
        let [worst, best] = match self.ends.press {
            Some(_) => ["the friction is 0.15", "it is 0.3"],
            None => ["the rubber flows out under the clamp", "it does not"],
        };
        format!("by estimate they hold {low} if {worst}, and {high} if {best}")
    }

    /// Warnings, in sentences.
    pub fn warnings(&self) -> Vec<String> {
        let mut out = vec![];
        let [load_n, most_n] = self.loads.proof_n();
        if self.muscle.terminals().pull_off_n.is_none() {
            out.push(format!(
                "burst and allowed pressure do NOT INCLUDE the ends: {}; {}; prove both",
                self.ends_carry(),
                self.ends_hold()
            ));
        }
        out.extend(unproved(
            &self.operating,
            &self.loads,
            USUAL_PROOF,
            &self.shown,
        ));
        if !self.ends.bear(load_n) {
            out.push(match self.ends.made {
                EndsMade::Tied => {
                    "the ties hold less than twice the load of the proof test; clamp or crimp them \
                     (`made` in [terminals] of the muscle file)"
                }
                _ => {
                    "by estimate the ends do not hold the proof test even at best; crimp them \
                     (`made` in [terminals] of the muscle file), or lower the pressure"
                }
            }
            .into());
        }
        let stresses = self.air_plug.stresses(most_n);
        out.extend(stresses.iter().filter(|s| !s.is_borne()).map(|stress| {
            format!(
                "{}: {} MPa in the proof test, of {} MPa at which it yields: take a wider tube, a \
                 thicker bolt, or lower the pressure",
                stress.what,
                significant(stress.mpa, 2),
                significant(stress.yields_mpa, 3)
            )
        }));
        if let Some(bears_n) = self.buckling_n() {
            let [push, bears, allowed] =
                [-self.operating.blocked_force_n, bears_n, bears_n / BUCKLING]
                    .map(|n| self.shown.force(n.max(0.0)));
            out.push(format!(
                "the muscle pushes with up to {push}, and its wall alone buckles at {bears}: guide \
                 it in a tube, or keep the push below {allowed}"
            ));
        }
        out
    }
}

/// The ends of a muscle for a load, and what they hold.
#[derive(Debug, Clone, PartialEq)]
pub struct EndParts {
    /// The muscle with the length on its plugs stated.
    pub muscle: Muscle,
    /// Lengths of tube and sleeve.
    pub cut: Cut,
    /// How tube and sleeve are held.
    pub ends: Ends,
    /// The plug with the passage.
    pub air_plug: Plug,
    /// The plug without a passage.
    pub eye_plug: Plug,
    /// Diameter over the sleeve on the tube, and on a plug, in mm.
    pub over_sleeve_mm: f64,
    /// Diameter over tube and sleeve on a plug, in mm.
    pub clamped_diameter_mm: f64,
}

impl EndParts {
    /// The ends for a load in N of each in the proof test, and the most that it may be as built.
    pub fn new(muscle: &Muscle, loads_n: [f64; 2], wishes: &Wishes) -> Result<Self, Refused> {
        let [_, load_n] = loads_n;
        checked(muscle, wishes)?;
        let cut = Cut::new(muscle, wishes.sleeve_diameter_mm, 0.0);
        let sleeve_mm = sleeve_mm(muscle, &cut);
        let wall_mm = cut.tube_wall_mm;
        let bore_mm = cut.bore_mm();
        let over_sleeve_mm = muscle.outer_diameter_mm() + 2.0 * sleeve_mm;
        let plug_mm = muscle.terminals().plug_diameter_mm;
        let stem_mm = plug_mm.unwrap_or_else(|| Stem::usual_mm(bore_mm));
        let clamped_diameter_mm = stem_mm + 2.0 * (wall_mm + sleeve_mm);
        let tube = Clamped {
            bore_mm,
            wall_mm,
            sleeve_mm,
            mu_mpa: muscle.tube().rubber.law.shear_modulus_mpa(),
            diameter_mm: clamped_diameter_mm,
        };
        let ends = Ends::new(loads_n, tube, muscle.terminals().made);
        let muscle = inserted(muscle, &ends)?;
        let stem = Stem::new(&ends, stem_mm, [bore_mm, wall_mm], muscle.insertion_mm());
        let usual = Fitting::usual(muscle.outer_diameter_mm());
        let fitting = wishes.fitting.unwrap_or(usual);
        let outer_mm = clamped_diameter_mm.max(over_sleeve_mm);
        let air_plug = |material| {
            let sizes = (outer_mm, load_n);
            Plug::new((&stem, material), sizes, Some(fitting), wishes.bolt_mm)
        };
        let may_be_printed = ends.made != EndsMade::Crimped
            && load_n <= PRINTED_TO_N
            && bore_mm >= PRINTED_FROM_MM
            && air_plug(PETG).bears(load_n);
        let material = if may_be_printed { PETG } else { ALUMINIUM };
        let air_plug = air_plug(material);
        Ok(Self {
            cut: Cut::new(&muscle, wishes.sleeve_diameter_mm, stem.tube_mm()),
            ends,
            // A liquid leaves no air behind: a second port bleeds it.
            eye_plug: Plug::with_bolt(
                (&stem, material),
                outer_mm,
                wishes.liquid.then_some(fitting),
                air_plug.bolt,
            ),
            air_plug,
            over_sleeve_mm,
            clamped_diameter_mm,
            muscle,
        })
    }

    /// Largest diameter in mm, of plugs and clamps.
    pub fn widest_mm(&self) -> f64 {
        let clamp_mm = self.clamped_diameter_mm + 2.0 * Ends::CLAMP_MM;
        self.air_plug.widest_mm().max(clamp_mm)
    }
}

/// What limits the pressure of the proof test, in words.
fn proof_limit(operating: &Operating) -> String {
    let limits = &operating.limits;
    let is_limit = |mpa: f64| operating.proof.pressure_mpa >= mpa * (1.0 - 1e-9);
    let burst = limits.burst_pressure_mpa.zip(limits.burst_by);
    match burst.filter(|(mpa, _)| is_limit(PROOF_TO_BURST * mpa)) {
        Some((_, by)) => format!("three quarters of the least burst pressure, at which {by},"),
        None if operating.strained_mpa.is_some_and(is_limit) => {
            "strands that are stretched to their limit".into()
        }
        None => format!(
            "three quarters of what strands and ends bear, stretched by {},",
            percent(STRETCH)
        ),
    }
}

/// What a proof test that is below twice the working pressure leaves to be desired: less than so many
/// times what the ends carry in use.
fn unproved(operating: &Operating, loads: &EndLoads, times: f64, shown: &Shown) -> Option<String> {
    let proof_mpa = operating.proof.pressure_mpa;
    let is_lowered = proof_mpa < PROOF_TO_WORKING * operating.highest_mpa * (1.0 - 1e-9);
    let is_proved = loads.proof_to_use >= times && loads.proof_to_stretched >= 1.0;
    (is_lowered && !is_proved).then(|| {
        format!(
            "{} allow a proof test of {}, which loads the ends with {} times what use does: less than \
             {times}; work at {} or less, or take a sleeve with more or stronger strands, or a \
             thicker wall",
            proof_limit(operating),
            shown.pressure(proof_mpa),
            significant(loads.proof_to_use, 3),
            shown.pressure(loads.proved_mpa(operating, times))
        )
    })
}

fn checked(muscle: &Muscle, wishes: &Wishes) -> Result<(), Refused> {
    let length_mm = muscle.insertion_mm();
    Refused::unless(length_mm >= LEAST_INSERTION_MM, ["insertion_mm"], || {
        format!(
            "a length of {length_mm}\u{a0}mm on each plug holds no clamp; state `insertion_mm` of \
             at least {LEAST_INSERTION_MM}\u{a0}mm ([terminals] of the muscle file)"
        )
    })?;
    let bolt_mm = wishes.bolt_mm.unwrap_or(6.0);
    Refused::unless((2.0..=64.0).contains(&bolt_mm), ["bolt_mm"], || {
        format!("a bolt of {bolt_mm} mm does not fit; give a diameter from 2 to 64 mm")
    })
}

/// The muscle with the length on its plugs that its ends need, stated, so that every file says the
/// same.
fn inserted(muscle: &Muscle, ends: &Ends) -> Result<Muscle, Refused> {
    let (least_mm, stated) = (ends.least_mm(), muscle.terminals().insertion_mm);
    let length_mm = muscle.insertion_mm();
    Refused::unless(
        stated.is_none() || length_mm >= least_mm,
        ["insertion_mm"],
        || {
            format!(
                "a length of {length_mm}\u{a0}mm on each plug has no room for {} ends; state \
                 `insertion_mm` of at least {least_mm}\u{a0}mm ([terminals] of the muscle file)",
                ends.made
            )
        },
    )?;
    let terminals = Terminals {
        insertion_mm: Some(length_mm.max(least_mm.ceil())),
        ..muscle.terminals().clone()
    };
    muscle
        .with_terminals(terminals)
        .map_err(|error| Refused::new(["insertion_mm"], error.to_string()))
}

/// A sleeve must go over the tube at its diameter.
fn refuse_narrow(muscle: &Muscle, cut: &Cut, wishes: &Wishes) -> Result<(), Refused> {
    let relaxed_mm = cut.sleeve.relaxed_diameter_mm;
    let diameter_mm = wishes.sleeve_diameter_mm.or(relaxed_mm);
    Refused::unless(relaxed_mm == diameter_mm, ["sleeve_diameter_mm"], || {
        format!(
            "a sleeve of {}\u{a0}mm cannot be pulled over this tube: its strands allow diameters up \
             to {:.1}\u{a0}mm",
            diameter_mm.unwrap_or_default(),
            muscle.strand_length_per_turn_mm() / PI
        )
    })
}

/// Thickness in mm of the sleeve where two strands cross.
fn sleeve_mm(muscle: &Muscle, cut: &Cut) -> f64 {
    let strand_mm = cut
        .sleeve
        .strand_area_mm2
        .map(|area| (4.0 * area / PI).sqrt());
    let stated = muscle.braid().thickness_mm;
    if stated > 0.0 {
        stated
    } else {
        2.0 * strand_mm.unwrap_or(0.25)
    }
}
