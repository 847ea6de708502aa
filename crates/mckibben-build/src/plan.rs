//! All numbers of a build.

use crate::{
    AirPlug, BuildPart, Clamps, Cut, EyePlug, Fitting, Operating, Safety, Stem, TestPoint,
    clamps::Tie, material, plug, test_points,
};
use mckibben_core::{
    analysis::{BUCKLING, burst::ends::clamp_load_n},
    model::Response,
    muscle::Muscle,
    refused::Refused,
    sleeve::library,
    warning::buckling_load_n,
};
use std::f64::consts::PI;

/// Choices of the builder.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Wishes {
    /// The connection of the hose.
    pub fitting: Option<Fitting>,
    /// Bolt of the eye in mm.
    pub bolt_mm: Option<f64>,
    /// Diameter in mm of the sleeve as it comes off the roll.
    pub sleeve_diameter_mm: Option<f64>,
}

/// All numbers of a build.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    pub muscle: Muscle,
    /// Its results by a model.
    pub operating: Operating,
    pub cut: Cut,
    /// Diameter over the sleeve in mm: two strands cross on each side.
    pub over_sleeve_mm: f64,
    /// Diameter over tube and sleeve on a plug in mm, on which a clamp closes.
    pub clamped_diameter_mm: f64,
    /// Inner diameter in mm of a crimped ferrule: the wall is pressed to three quarters of its
    /// thickness (a choice).
    pub crimp_diameter_mm: f64,
    /// The load of an end in N: the blocked force and the pressure on the bore.
    pub end_load_n: f64,
    /// The holding force of one tie in N, by estimate.
    pub tie_holds_n: f64,
    pub clamps: Clamps,
    /// The plug with the air passage.
    pub air_plug: AirPlug,
    pub eye_plug: EyePlug,
    /// Pressures of the tests.
    pub safety: Safety,
    /// The bill of materials.
    pub parts: Vec<BuildPart>,
    /// The points of the first test.
    pub test: Vec<TestPoint>,
}

impl Plan {
    /// Least length in mm on a plug.
    const LEAST_INSERTION_MM: f64 = 3.0;

    pub fn new(muscle: Muscle, operating: Operating, wishes: &Wishes) -> Result<Self, Refused> {
        let length_mm = muscle.insertion_mm();
        let least_mm = Self::LEAST_INSERTION_MM;
        Refused::unless(length_mm >= least_mm, ["insertion_mm"], || {
            format!(
                "a length of {length_mm}\u{a0}mm on each plug holds no clamp; state `insertion_mm` \
                 of at least {least_mm}\u{a0}mm ([terminals] of the muscle file)"
            )
        })?;
        let bolt_fits = wishes
            .bolt_mm
            .is_none_or(|bolt_mm| (2.0..=64.0).contains(&bolt_mm));
        Refused::unless(bolt_fits, ["bolt_mm"], || {
            let bolt_mm = wishes.bolt_mm.unwrap_or_default();
            format!("a bolt of {bolt_mm} mm does not fit; give a diameter from 2 to 64 mm")
        })?;
        let cut = Cut::new(&muscle, wishes.sleeve_diameter_mm);
        let diameter_mm = wishes.sleeve_diameter_mm.or(cut.sleeve.relaxed_diameter_mm);
        Refused::unless(
            cut.sleeve.relaxed_diameter_mm == diameter_mm,
            ["sleeve_diameter_mm"],
            || {
                format!(
                    "a sleeve of {}\u{a0}mm cannot be pulled over this tube: its strands allow \
                     diameters up to {:.1}\u{a0}mm",
                    diameter_mm.unwrap_or_default(),
                    muscle.strand_length_per_turn_mm() / PI
                )
            },
        )?;
        let strand_mm = cut
            .sleeve
            .strand_area_mm2
            .map(|area| (4.0 * area / PI).sqrt());
        let sleeve_mm = if muscle.braid().thickness_mm > 0.0 {
            muscle.braid().thickness_mm
        } else {
            2.0 * strand_mm.unwrap_or(0.25)
        };
        let over_sleeve_mm = muscle.outer_diameter_mm() + 2.0 * sleeve_mm;
        let bore_mm = cut.tube_outer_diameter_mm - 2.0 * cut.tube_wall_mm;
        let end_load_n = clamp_load_n(
            &muscle,
            operating.blocked_force_n.max(0.0),
            operating.pressure_mpa,
        );
        let bolt_mm = wishes.bolt_mm.unwrap_or_else(|| plug::bolt_mm(end_load_n));
        let tie = Tie::around(bore_mm);
        let foot_mm = plug::foot_mm(bolt_mm);
        let stem = Stem::new(
            muscle.terminals(),
            bore_mm,
            over_sleeve_mm,
            tie.width_mm,
            foot_mm,
        );
        let fitting = wishes
            .fitting
            .unwrap_or_else(|| Fitting::usual(muscle.outer_diameter_mm()));
        let mut plan = Self {
            clamped_diameter_mm: stem.diameter_mm + 2.0 * (cut.tube_wall_mm + sleeve_mm),
            crimp_diameter_mm: stem.diameter_mm + 2.0 * (0.75 * cut.tube_wall_mm + sleeve_mm),
            over_sleeve_mm,
            cut,
            end_load_n,
            tie_holds_n: tie.holds_n(),
            clamps: Clamps::for_load(tie, stem.grooves, end_load_n),
            air_plug: AirPlug::new(stem, fitting),
            eye_plug: EyePlug::new(stem, bolt_mm),
            safety: Safety::new(&operating),
            parts: vec![],
            test: test_points::points(&operating),
            muscle,
            operating,
        };
        plan.parts = material::bill(&plan);
        Ok(plan)
    }

    /// Whether a printed air plug bears the load of its end; else both plugs are turned from metal.
    pub fn is_printed(&self) -> bool {
        self.air_plug.is_printed(self.end_load_n)
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

    /// Warnings, in sentences.
    pub fn warnings(&self) -> Vec<String> {
        let mut out = vec![];
        let bore_mm = self.air_plug.stem.bore_mm();
        if bore_mm < 4.0 {
            out.push(format!(
                "a plug for a bore of {}\u{a0}mm is too thin for most printers; a turned plug, or \
                 a needle with a knot of thread, takes its place",
                crate::text::mm(bore_mm)
            ));
        }
        if !self.is_printed() {
            out.push(format!(
                "the stem of the air plug carries {} MPa; printed layers are taken to bear {} MPa \
                 across: turn both plugs from metal, or take wider ones",
                crate::text::significant(self.air_plug.stress_mpa(self.end_load_n), 2),
                crate::plug::PRINTED_MPA
            ));
        }
        if let Some(bears_n) = self.buckling_n() {
            let [push, bears, allowed] =
                [-self.operating.blocked_force_n, bears_n, bears_n / BUCKLING]
                    .map(|n| crate::text::significant(n.max(0.0), 2));
            out.push(format!(
                "the muscle pushes with up to {push}\u{a0}N, and its wall alone buckles at \
                 {bears}\u{a0}N: guide it in a tube, or keep the push below {allowed}\u{a0}N"
            ));
        }
        if self.clamps == Clamps::Crimped {
            out.push(format!(
                "each end must hold about {}\u{a0}N, more than cable ties do by estimate: crimp a \
                 ferrule, or clamp with a hose clamp",
                crate::text::significant(self.end_load_n, 2)
            ));
        }
        out
    }
}
