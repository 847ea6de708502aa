//! What is wanted, and what may be varied.

use crate::{
    Count, LiquidFields, LoadFields, ModelFields, Problem, ProblemKind, Result, Stiffness,
    TextFile, Units,
    fields::name_or_file,
    flags::{self, Args},
    number,
    problem::stated,
};
use mckibben_core::units::{QuantityError, typed};
use mckibben_core::{
    muscle::{Direction, Muscle},
    units::typed::{Angle, Choice, Force, Frequency, Length, Mass, Pressure, Ratio, Volume},
    warning::strand_strength_n,
};
use mckibben_design::{BraidChoice, Limits, SAFETY, VALIDATED_STRAND_STRAIN, bundle};
pub use mckibben_design::{Objective as ObjectiveWord, OperatingPoint, TorqueWanted};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A specification: required pulls at contractions with a maximum pressure. All other fields have a
/// default.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct DesignRequest {
    /// Required pull; below zero: the push of a muscle that extends
    #[arg(short = 'F', long)]
    pub force_n: Option<Force>,
    /// Contraction ratio ΔL/L0 with that pull; below zero: an extension
    #[arg(short = 'e', long, value_parser = contraction)]
    pub contraction: Option<Ratio>,
    /// Several operating points: 700N@15%,1200N@5%
    #[arg(long = "at", value_name = "F@E,…", value_delimiter = ',', value_parser = operating_point)]
    pub points: Vec<OperatingPoint>,
    /// A load to lift over the stroke, or to the contraction, instead of a pull.
    #[serde(flatten)]
    #[command(flatten)]
    pub load: LoadFields,
    /// Required torques of a joint: 8Nm@45deg,3Nm@60deg
    ///
    /// At angles to either side. Two equal opposed muscles on a pulley, one of them without
    /// pressure.
    #[arg(long = "joint", value_name = "T@ANGLE,…", value_delimiter = ',', value_parser = torque)]
    pub torques: Vec<TorqueWanted>,
    /// Largest angle of the joint to either side of the neutral angle [the largest of `torques`]
    #[arg(long, hide_short_help = true)]
    pub largest_angle_deg: Option<Angle>,
    /// Stroke. With a contraction it sets the length, with a length the contraction
    #[arg(long)]
    pub stroke_mm: Option<Length>,
    /// Strokes a second: the air a minute and the valve that they need are said
    #[arg(long = "cycle", value_name = "FREQUENCY")]
    pub cycle_hz: Option<Frequency>,
    /// Pressure that the supply can give [6bar]
    ///
    /// Each muscle is used up to it or up to its own allowed pressure, whichever is lower; the
    /// answer says which pressure to set.
    #[arg(short = 'p', long, alias = "pressure", value_parser = supply)]
    pub max_pressure_mpa: Option<Pressure>,
    /// A liquid in the place of air.
    #[serde(flatten)]
    #[command(flatten)]
    pub liquid: LiquidFields,
    /// Chance that a built muscle meets every point at some allowed pressure [90%]
    ///
    /// From 50 to 99.9 %. The smallest muscle that reaches it is taken. A model that is named meets
    /// the points by its own pull, unless a certainty is given.
    #[arg(long, value_name = "CHANCE")]
    pub certainty: Option<Ratio>,
    /// Gone: `certainty`
    #[arg(long, hide = true, num_args = 0..=1, default_missing_value = "95%")]
    pub guaranteed: Option<Ratio>,
    /// Equal muscles side by side that share the requirement, 1 to 1000 [1; up to 7 where they are
    /// smaller by a third, or no single one does]
    ///
    /// The numbers of a candidate are those of one of them; the bundle of the best one is shown
    /// below.
    #[arg(long, value_name = "N")]
    pub count: Option<Count<1, { bundle::MOST as usize }>>,
    /// Quantity to rank by
    ///
    /// A tube on sale comes before one that is cast, unless the muscle is half as large again.
    #[arg(long, value_parser = flags::word::<ObjectiveWord>(), default_value = "bulged-diameter")]
    pub objective: ObjectiveWord,
    /// Largest outer diameter at the operating points; of a bundle that of each of its muscles
    #[arg(long, help_heading = "Limits")]
    pub max_bulged_diameter_mm: Option<Length>,
    /// Largest diameter of the circle around all muscles and their ends at the operating points
    #[arg(long, help_heading = "Limits")]
    pub max_envelope_mm: Option<Length>,
    /// Largest mass of all muscles with their ends, such as 200g
    #[arg(long, help_heading = "Limits")]
    pub max_mass_kg: Option<Mass>,
    /// Distance between the axes of neighbours of a bundle [the width of one with its ends]
    #[arg(long, hide_short_help = true, help_heading = "Limits")]
    pub pitch_mm: Option<Length>,
    /// Largest liquid volume up to the operating points: what the syringe or pump gives
    ///
    /// Of a bundle to all its muscles together. It needs `liquid`.
    #[arg(long = "max-liquid", value_parser = flags::volume, help_heading = "Limits")]
    pub max_liquid_volume_mm3: Option<Volume>,
    /// Safety factor of strands and clamps: failure pressure over allowed pressure [4]
    ///
    /// 2 or more, or 0 for none. The strength of the strands must be known.
    #[arg(long = "safety", value_name = "FACTOR", help_heading = "Limits")]
    pub min_burst_margin: Option<f64>,
    /// Safety factor of the tube, which leaks where it fails [half of that of the strands,
    /// at least 1.5]
    #[arg(
        long = "safety-tube",
        value_name = "FACTOR",
        hide_short_help = true,
        help_heading = "Limits"
    )]
    pub min_tube_margin: Option<f64>,
    /// Largest stretch of the rubber at the operating points (2 means twice its length) [the
    /// largest stretch of the data behind the rubber's law]
    #[arg(
        long,
        value_name = "STRETCH",
        hide_short_help = true,
        help_heading = "Limits"
    )]
    pub max_stretch: Option<f64>,
    /// Largest strain of the strands at the operating points; it bounds the pressure [6%, the
    /// validated range]
    #[arg(
        long,
        value_name = "STRAIN",
        hide_short_help = true,
        help_heading = "Limits"
    )]
    pub max_strand_strain: Option<Ratio>,
    /// The muscle is guided on its way, so that it cannot buckle under its push
    #[arg(long, hide_short_help = true, help_heading = "Limits")]
    pub guided: bool,
    /// Muscle file, for what is not searched; flags override it
    ///
    /// `paper` is the muscle of the paper, lib:NAME one of the library. With it diameters and walls
    /// are free.
    #[serde(deserialize_with = "name_or_file")]
    #[arg(value_name = "MUSCLE.toml", value_parser = flags::muscle_file, help_heading = "Muscle")]
    pub muscle: Option<TextFile>,
    /// Muscle file, same as [MUSCLE.toml]
    #[serde(skip)]
    #[arg(long = "muscle", value_name = "MUSCLE.toml", value_parser = flags::muscle_file, hide_short_help = true, help_heading = "Muscle")]
    pub also_muscle: Option<TextFile>,
    /// Any key of a muscle file, such as terminals.seating=1.6mm; may be repeated
    #[arg(
        long,
        value_name = "KEY=VALUE",
        hide_short_help = true,
        help_heading = "Muscle"
    )]
    pub with: Vec<String>,
    /// Tubes as sold or cast (`mckibben parts list tubes`), or BORExOUTER, such as 8x12mm [all]
    #[arg(
        long = "tube",
        value_name = "LIST",
        value_delimiter = ',',
        help_heading = "Muscle"
    )]
    pub tubes: Vec<String>,
    /// Only tubes on sale
    #[arg(long, help_heading = "Muscle")]
    pub sold: bool,
    /// Only tubes that one casts
    #[arg(long, help_heading = "Muscle")]
    pub cast: bool,
    /// Tubes and sleeves of your own
    ///
    /// A file with `[[tube]]` (name, inner, outer, rubber) and `[[sleeve]]` (name, least_diameter,
    /// largest_diameter in mm) in place of those of the catalogue.
    #[arg(long, value_name = "FILE.toml", value_parser = flags::file, hide_short_help = true, help_heading = "Muscle")]
    pub parts: Option<TextFile>,
    /// Free sizes instead of parts as sold
    ///
    /// Diameters and walls are free, with the paper's rubber and braid, or those that are given. So
    /// they are with diameters, walls, angles, a stiffness or a muscle file.
    #[arg(long, help_heading = "Muscle")]
    pub continuous: bool,
    /// Outer diameters: a value, list or range [parts]
    ///
    /// At rest; also a stepped range, 20..40:5.
    #[arg(short = 'D', long, value_name = "RANGE", help_heading = "Muscle")]
    pub outer_diameter_mm: Option<Choice<Length>>,
    /// Wall thicknesses at rest [parts]
    #[arg(short = 's', long, value_name = "RANGE", help_heading = "Muscle")]
    pub wall_mm: Option<Choice<Length>>,
    /// Lengths between the terminals at rest [285mm]
    #[arg(short = 'L', long, value_name = "RANGE", help_heading = "Muscle")]
    pub length_mm: Option<Choice<Length>>,
    /// Braid angles to the axis at rest [those of the sleeves]
    #[arg(long, value_name = "RANGE", help_heading = "Muscle")]
    pub angle_deg: Option<Choice<Angle>>,
    /// Rubbers, by name [those of the tubes]
    #[arg(long = "rubber", value_name = "LIST", value_delimiter = ',', value_parser = flags::rubbers(), hide_possible_values = true, help_heading = "Muscle")]
    pub rubbers: Vec<String>,
    /// Sleeves, by name (`mckibben parts list sleeves`) [all]
    ///
    /// The diameter of the tube then sets angle and stiffness.
    #[arg(long = "braid", value_name = "LIST", value_delimiter = ',', value_parser = flags::sleeves(), hide_possible_values = true, help_heading = "Muscle")]
    pub braids: Vec<String>,
    /// Diameter of a strand of the named sleeves, where they do not state it
    #[arg(
        long,
        value_name = "DIAMETER",
        hide_short_help = true,
        help_heading = "Muscle"
    )]
    pub strand_diameter_mm: Option<Length>,
    /// Young's modulus of their strands, likewise
    #[arg(
        long = "strand-modulus",
        value_name = "MODULUS",
        hide_short_help = true,
        help_heading = "Muscle"
    )]
    pub strand_modulus_mpa: Option<Pressure>,
    /// Stiffness of one strand family, in N/mm [antonelli2018]
    ///
    /// Or `inextensible`, or `antonelli2018`.
    #[arg(long, value_name = "STIFFNESS", value_parser = flags::stiffness, help_heading = "Muscle")]
    pub stiffness: Option<Stiffness>,
    /// Sleeves on sale, by strand length per turn; the tube diameter then sets the angle
    #[arg(
        long,
        value_name = "LIST",
        hide_short_help = true,
        help_heading = "Muscle"
    )]
    pub strand_length_per_turn_mm: Option<Choice<Length>>,
    /// Radii of the pulley [searched]
    #[arg(long = "radius", hide_short_help = true, help_heading = "Muscle")]
    pub radius_mm: Option<Choice<Length>>,
    /// The model.
    #[serde(deserialize_with = "ModelFields::or_name")]
    #[command(flatten)]
    pub model: ModelFields,
    /// Branch of the friction hysteresis on which it must pull [contraction; mean with a model by
    /// name]
    ///
    /// A model that is named meets the requirement by its own pull; without one, a muscle that is
    /// built does, which shortens against its friction.
    #[arg(long = "branch", value_name = "BRANCH", value_parser = flags::word::<Direction>(), hide_short_help = true, help_heading = "Advanced")]
    pub direction: Option<Direction>,
    /// Compute outside the model's range too, with a warning
    #[arg(long, help_heading = "Advanced")]
    pub extrapolate: bool,
    /// Number of candidates to show [5]
    #[arg(long, value_name = "N", help_heading = "Output")]
    pub top: Option<Count<1, 1000>>,
    /// Add a figure to the answer, in these units: `bar`, or `psi,lbf,in`.
    #[arg(skip)]
    pub figure: Option<Units>,
}

impl DesignRequest {
    /// Which fields exclude each other, and which ones need others.
    pub fn validate(&self) -> Result<()> {
        if let Some(share) = self.guaranteed {
            // X of two sides is (1 + X)/2 of one.
            let percent = number(50.0 * (1.0 + share.0), 4);
            return Err(Problem::usage(
                "`guaranteed` is gone: a share of two sides is a larger one of one side",
                format!("give `certainty` {percent}%"),
            )
            .in_field("guaranteed"));
        }
        let [force, points, torques] = stated!(self; force_n, points, torques);
        let load = ("load", self.load.load.is_some());
        Problem::refuse_several(&[force, points, load, torques], "state the requirement")?;
        let unused = [
            (
                points.1,
                &stated!(self; contraction)[..],
                "each of `points` has its own",
            ),
            (
                torques.1,
                &stated!(self; contraction, stroke_mm),
                "the angles and the pulley set the contraction of a joint's muscles",
            ),
            (
                !torques.1,
                &stated!(self; radius_mm, largest_angle_deg),
                "it belongs to a joint, and no `torques` are given",
            ),
            (
                self.count.is_none_or(|count| count.0 == 1),
                &stated!(self; pitch_mm),
                "it is the distance of neighbours in a `count` of two muscles or more",
            ),
        ];
        for (_, fields, why) in unused.into_iter().filter(|rule| rule.0) {
            Problem::refuse_unused(fields, why)?;
        }
        Problem::refuse_several(&stated!(self; sold, cast), "say which tubes are searched")?;
        if self.muscle.is_some() {
            let again = stated!(self; also_muscle);
            Problem::refuse_unused(&again, "a muscle file is given already")?;
        }
        let angle = stated!(self; braids, strand_length_per_turn_mm, angle_deg);
        Problem::refuse_several(&angle, "set the angle")
    }

    /// The limits, as far as the strands' strength is known.
    pub fn limits(&self, braid: &BraidChoice, base: &Muscle) -> Result<Limits> {
        let strength = match braid {
            BraidChoice::Sleeves(list) => list.iter().find_map(|braid| braid.strands?.strength_n),
            _ => strand_strength_n(base),
        };
        if self.min_burst_margin.is_some_and(|m| m > 0.0) && strength.is_none() {
            return Err(Problem::new(
                ProblemKind::Specification,
                "`min_burst_margin` needs the strands' strength, which this muscle does not state",
                "give braid.strands and braid.strand_strength in the muscle file",
            ));
        }
        Ok(Limits {
            bulged_diameter_mm: self.max_bulged_diameter_mm.map(f64::from),
            envelope_mm: self.max_envelope_mm.map(f64::from),
            mass_g: self.max_mass_kg.map(|kg| 1e3 * kg.0),
            burst_margin: Some(self.min_burst_margin.unwrap_or(SAFETY)).filter(|m| *m != 0.0),
            tube_margin: self.min_tube_margin,
            stretch: self.max_stretch,
            fitted_stretch: true,
            buckling: !self.guided,
            strand_strain: self
                .max_strand_strain
                .map(f64::from)
                .or(Some(VALIDATED_STRAND_STRAIN)),
            liquid_volume_mm3: self.max_liquid_volume_mm3.map(f64::from),
        })
    }
}

/// A contraction ratio; a shortening in mm is a stroke.
fn contraction(text: &str) -> Result<Ratio> {
    text.parse().map_err(|error: QuantityError| {
        let is_length = text.parse::<Length>().is_ok();
        let hint = "give a ratio such as 15%, or a stroke with `stroke_mm`";
        Problem::from(error).with_hint(if is_length { hint } else { "" })
    })
}

/// A pressure of a supply; a bare number above that of any workshop means bar.
fn supply(text: &str) -> Result<Pressure> {
    const MOST_MPA: f64 = 1.6;
    let pressure: Pressure = text.parse()?;
    let text = text.trim();
    if text.parse::<f64>().is_ok() && pressure.0 > MOST_MPA {
        let bar = 10.0 * pressure.0;
        return Err(Problem::new(
            ProblemKind::Quantity,
            format!("{text} is {text}\u{a0}MPa, {bar}\u{a0}bar: write the unit"),
            format!("write {text}bar, or {bar}bar"),
        ));
    }
    Ok(pressure)
}

/// A required pull at a contraction: `700N@15%`.
fn operating_point(text: &str) -> Result<OperatingPoint> {
    let expected = "operating point; expected a pull at a contraction such as 700N@15%";
    let (Force(force_n), Ratio(contraction)) = pair_at_sign(text, expected)?;
    Ok(OperatingPoint {
        force_n,
        contraction,
    })
}

/// A required torque at an angle to either side: `8Nm@45deg`.
fn torque(text: &str) -> Result<TorqueWanted> {
    let expected = "torque at an angle; expected one such as 8Nm@45deg";
    let (typed::Torque(torque_nm), Angle(angle_deg)) = pair_at_sign(text, expected)?;
    Ok(TorqueWanted {
        torque_nm,
        angle_deg,
    })
}

fn pair_at_sign<A, B>(text: &str, expected: &str) -> Result<(A, B)>
where
    A: std::str::FromStr<Err = QuantityError>,
    B: std::str::FromStr<Err = QuantityError>,
{
    let Some((first, second)) = text.split_once('@') else {
        let why = format!("\"{text}\" is not a valid {expected}");
        return Err(ProblemKind::Quantity.problem(why));
    };
    // The joint is symmetric.
    let second = second.trim().trim_start_matches(['±', '+']);
    Ok((first.parse()?, second.parse()?))
}
