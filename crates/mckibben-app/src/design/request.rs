//! What is wanted, and what may be varied.

use super::assumed::SUPPLY_MPA;
use super::{ModelPolicy, near_the_box};
use crate::fields::name_or_file;
use crate::flags::{self, Args};
use crate::parts::{sleeve_entries, unread, users_tubes};
use crate::{
    LiquidFields, LoadFields, MeshFields, Model, ModelFields, MuscleFields, Problem, ProblemKind,
    Result, Stiffness, TextFile, Units, above_zero, finite, given, ratio, rubber, sleeve,
};
use mckibben::muscle::measures::{LENGTH, STRAND_MODULUS};
use mckibben::muscle::{Braid, Direction, Muscle, Tube};
use mckibben::sleeve::SleeveEntry;
use mckibben::units::typed::{Angle, Choice, Force, Length, Pressure, Quantity, Ratio, Volume};
#[cfg(feature = "clap")]
use mckibben::units::{QuantityError, typed};
use mckibben::{units::Values, warning::strand_strength_n};
use mckibben_design::tubes::{self, TubePart};
use mckibben_design::{
    BraidChoice, Demand, JointDemand, Lift, Limits, SAFETY, SearchedMuscles, Spec,
    VALIDATED_STRAND_STRAIN,
};
pub use mckibben_design::{Objective as ObjectiveWord, OperatingPoint, TorqueWanted};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// A specification: required pulls at contractions with a maximum pressure. All other fields have a
/// default.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
#[command(next_help_heading = "Question")]
pub struct DesignRequest {
    /// Required pull; below zero: the push of a muscle that extends
    #[arg(short = 'F', long)]
    pub force_n: Option<Force>,
    /// Contraction ratio ΔL/L0 with that pull; below zero: an extension
    #[arg(short = 'e', long, value_parser = contraction)]
    pub contraction: Option<Ratio>,
    /// Several operating points: 700N@15%,1200N@5%
    #[arg(long = "at", value_name = "F@E,…", value_delimiter = ',', value_parser = operating_point, conflicts_with_all = ["force_n", "contraction"])]
    pub points: Vec<OperatingPoint>,
    /// A load to lift over the stroke, or to the contraction, instead of a pull.
    #[serde(flatten)]
    #[command(flatten)]
    pub load: LoadFields,
    /// Required torques of a joint: 8Nm@45deg,3Nm@60deg
    ///
    /// At angles to either side. Two equal opposed muscles on a pulley, one of them without
    /// pressure.
    #[arg(long = "joint", value_name = "T@ANGLE,…", value_delimiter = ',', value_parser = torque, conflicts_with_all = ["force_n", "contraction", "points", "load", "stroke_mm"])]
    pub torques: Vec<TorqueWanted>,
    /// Largest angle of the joint to either side of the neutral angle [the largest of `torques`]
    #[arg(long, requires = "torques", hide_short_help = true)]
    pub largest_angle_deg: Option<Angle>,
    /// Stroke. With a contraction it sets the length, with a length the contraction
    #[arg(long)]
    pub stroke_mm: Option<Length>,
    /// Pressure that the supply can give [6bar]
    ///
    /// Each muscle is used up to it or up to its own allowed pressure, whichever is lower; the
    /// answer says which pressure to set.
    #[arg(short = 'p', long, alias = "pressure")]
    pub max_pressure_mpa: Option<Pressure>,
    /// A liquid in the place of air.
    #[serde(flatten)]
    #[command(flatten)]
    pub liquid: LiquidFields,
    /// The lower end of the ± meets it [95%]
    ///
    /// The muscle whose pull less its ± meets the requirement; another share, such as --guaranteed
    /// 99%, widens the ± accordingly.
    #[arg(long, value_name = "SHARE", num_args = 0..=1, default_missing_value = "95%")]
    pub guaranteed: Option<Ratio>,
    /// Equal muscles side by side that share the requirement, 1 to 1000 [1, or as few as do]
    ///
    /// The candidates are one of them; the bundle of the best one is shown below.
    #[arg(long, alias = "bundle", value_name = "N")]
    pub count: Option<u32>,
    /// Quantity to rank by
    #[arg(long, value_parser = flags::word::<ObjectiveWord>(), default_value = "bulged-diameter")]
    pub objective: ObjectiveWord,
    /// Largest outer diameter at the operating points; of a bundle that of each of its muscles
    #[arg(long, help_heading = "Limits")]
    pub max_bulged_diameter_mm: Option<Length>,
    /// Largest diameter of the circle around all muscles at the operating points
    #[arg(long, help_heading = "Limits")]
    pub max_envelope_mm: Option<Length>,
    /// Distance between the axes of neighbours of a bundle [that of the largest envelope, or the
    /// bulged diameter]
    #[arg(
        long,
        requires = "count",
        hide_short_help = true,
        help_heading = "Limits"
    )]
    pub pitch_mm: Option<Length>,
    /// Largest liquid volume up to the operating points: what the syringe or pump gives
    ///
    /// Of a bundle to all its muscles together. It needs `liquid`.
    #[arg(long = "max-liquid", value_parser = flags::volume, help_heading = "Limits")]
    pub max_liquid_volume_mm3: Option<Volume>,
    /// Safety factor of strands and clamps: failure pressure over allowed pressure [4]
    ///
    /// 0 for none. The strength of the strands must be known.
    #[arg(
        long = "safety",
        alias = "min-burst-margin",
        value_name = "FACTOR",
        help_heading = "Limits"
    )]
    pub min_burst_margin: Option<f64>,
    /// Safety factor of the tube, which leaks where it fails [half of that of the strands]
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
    #[arg(long = "muscle", value_name = "MUSCLE.toml", value_parser = flags::muscle_file, conflicts_with = "muscle", hide_short_help = true, help_heading = "Muscle")]
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
    /// Tubes and sleeves of your own
    ///
    /// A file with [[tube]] (name, inner, outer, rubber) and [[sleeve]] (name, least_diameter,
    /// largest_diameter in mm) in place of those of the catalogue.
    #[arg(long, value_name = "FILE.toml", value_parser = flags::file, hide_short_help = true, help_heading = "Muscle")]
    pub parts: Option<TextFile>,
    /// Free sizes instead of parts as sold
    ///
    /// Diameters and walls are free, with the paper's rubber and braid, or those that are given. So
    /// they are with diameters, walls, angles, a stiffness or a muscle file.
    #[arg(long, conflicts_with_all = ["tubes", "parts"], help_heading = "Muscle")]
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
    #[arg(long = "braid", value_name = "LIST", value_delimiter = ',', value_parser = flags::sleeves(), hide_possible_values = true, conflicts_with_all = ["angle_deg", "strand_length_per_turn_mm"], help_heading = "Muscle")]
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
    /// Stiffness of one strand family, in N/mm [paper]
    ///
    /// Or `inextensible`, or `paper`.
    #[arg(long, value_name = "STIFFNESS", value_parser = flags::stiffness, help_heading = "Muscle")]
    pub stiffness: Option<Stiffness>,
    /// Sleeves on sale, by strand length per turn; the tube diameter then sets the angle
    #[arg(
        long,
        value_name = "LIST",
        conflicts_with = "angle_deg",
        hide_short_help = true,
        help_heading = "Muscle"
    )]
    pub strand_length_per_turn_mm: Option<Choice<Length>>,
    /// Radii of the pulley [searched]
    #[arg(
        long = "radius",
        requires = "torques",
        hide_short_help = true,
        help_heading = "Muscle"
    )]
    pub radius_mm: Option<Choice<Length>>,
    /// The model.
    #[serde(deserialize_with = "ModelFields::or_name")]
    #[command(flatten)]
    pub model: ModelFields,
    /// Compute outside the model's range too, with a warning
    #[arg(long, help_heading = "Advanced")]
    pub extrapolate: bool,
    /// Number of candidates to show [5]
    #[arg(long, value_name = "N", value_parser = flags::between::<1, 1000>, help_heading = "Output")]
    pub top: Option<usize>,
    /// Add a figure to the answer, in these units: `bar`, or `psi,lbf,in`.
    #[arg(skip)]
    pub figure: Option<Units>,
}

/// A specification with the models that search it.
pub(super) struct Search {
    pub(super) spec: Spec,
    pub(super) policy: ModelPolicy,
    /// Radii of a joint's pulley in mm.
    pub(super) radius_mm: Option<Values>,
}

/// Contraction that no braid reaches: that of inextensible strands at 0°, 1 − 1/√3, rounded. It
/// bounds the radii of a joint's pulley.
const LARGEST_CONTRACTION: f64 = 0.42;
/// Contraction at which a muscle of a common braid still pulls with half of its blocked force.
const USUAL_CONTRACTION: f64 = 0.15;
/// The smallest radius that is searched, as a share of the largest.
const SMALLEST_RADIUS: f64 = 0.1;

/// Braid angles in degrees that are searched for a push where none is given.
const EXTENSILE_DEG: (f64, f64) = (57.0, 72.0);

/// Diameters and walls in mm that are searched where nothing else is said.
const SECTIONS: ((f64, f64), (f64, f64)) = ((5.0, 80.0), (0.5, 10.0));

impl DesignRequest {
    pub(super) fn search(&self) -> Result<Search> {
        let (base, wanted, radius_mm) = self.demand()?;
        let count = self.count()?;
        let wanted = wanted.times(1.0 / f64::from(count));
        let extends = wanted.extends();
        let max_pressure_mpa = finite(
            "max_pressure_mpa",
            self.max_pressure_mpa.map_or(SUPPLY_MPA, f64::from),
        )?;
        let model = Model::choose(&self.model)?;
        let sections = model.sections();
        let (diameters, walls) = sections.unwrap_or(SECTIONS);
        // `universal` was not fitted for muscles that extend.
        let quick: Option<(&str, SearchedMuscles)> = match self.model.name {
            Some(_) => None,
            None if extends => Some(("thick-wall", |_| true)),
            None => Some(("universal", near_the_box)),
        };
        let named =
            |(name, good)| Ok::<_, Problem>((Model::named(name, &MeshFields::default())?, good));
        let policy = ModelPolicy {
            quick: quick.map(named).transpose()?,
            model,
        };
        let free = self.free_sizes(sections.is_some(), extends);
        let tubes = match free {
            None => self.tubes()?,
            Some(by) => {
                let named = [
                    ("tubes", !self.tubes.is_empty()),
                    ("parts", self.parts.is_some()),
                ];
                Problem::refuse_unused(&named, format!("{by} asks for free sizes"))?;
                vec![]
            }
        };
        let sleeves = self.sleeves(&base, free.is_none())?;
        let turns = self.turns_mm()?;
        let braid = match (&turns[..], &sleeves[..], &self.angle_deg) {
            ([], [], None) if extends && !base.is_extensile() => {
                BraidChoice::Angle(Values::Interval(EXTENSILE_DEG.0, EXTENSILE_DEG.1))
            }
            ([], [], None) => BraidChoice::Angle(Values::List(vec![base.braid().angle_deg])),
            ([], [], Some(angles)) => BraidChoice::Angle(values(angles, "angle_deg")?),
            (turns, [], None) => BraidChoice::StrandLengthPerTurn(turns.to_vec()),
            ([], _, None) => BraidChoice::Sleeves(sleeves),
            _ => {
                let message = "`braids`, `strand_length_per_turn_mm` and `angle_deg` each set the \
                    angle: give one of them";
                return Err(Problem::new(ProblemKind::Usage, message, ""));
            }
        };
        let between = |field, choice: &Option<Choice<Length>>, (low, high)| match choice {
            Some(choice) => values(choice, field),
            None => Ok(Values::Interval(low, high)),
        };
        let strength = match &braid {
            BraidChoice::Sleeves(list) => list.iter().find_map(|braid| braid.strands?.strength_n),
            _ => strand_strength_n(&base),
        };
        if self.min_burst_margin.is_some_and(|m| m > 0.0) && strength.is_none() {
            let message =
                "`min_burst_margin` needs the strands' strength, which this muscle does not state";
            let hint = "give [braid] strands and strand_strength in the muscle file";
            return Err(Problem::new(ProblemKind::Specification, message, hint));
        }
        let spec = Spec {
            wanted,
            count,
            direction: Direction::Contraction,
            max_pressure_mpa,
            liquid: self.liquid.named_supply()?,
            length_mm: match &self.length_mm {
                Some(Choice::One(_)) | None => None,
                Some(choice) => Some(values(choice, "length_mm")?),
            },
            base,
            tubes,
            outer_diameter_mm: between("outer_diameter_mm", &self.outer_diameter_mm, diameters)?,
            wall_mm: between("wall_mm", &self.wall_mm, walls)?,
            braid,
            rubbers: self
                .rubbers
                .iter()
                .map(|name| rubber(name))
                .collect::<Result<_, _>>()?,
            limits: Limits {
                bulged_diameter_mm: self.max_bulged_diameter_mm.map(f64::from),
                envelope_mm: self.max_envelope_mm.map(f64::from),
                burst_margin: Some(self.min_burst_margin.unwrap_or(SAFETY)).filter(|m| *m != 0.0),
                tube_margin: self.min_tube_margin,
                stretch: self.max_stretch,
                fitted_stretch: true,
                buckling: !self.guided,
                strand_strain: Some(
                    self.max_strand_strain
                        .map_or(VALIDATED_STRAND_STRAIN, f64::from),
                ),
                liquid_volume_mm3: self
                    .max_liquid_volume_mm3
                    .map(|mm3| mm3.0 / f64::from(count)),
            },
            guaranteed: self.guaranteed()?,
            objective: self.objective,
            top: self.top.unwrap_or(5).clamp(1, 1000),
            extrapolate: self.extrapolate,
        };
        Ok(Search {
            spec,
            policy,
            radius_mm,
        })
    }

    /// Where the length is assumed, the muscle on which the stroke is a usual contraction, if that
    /// is longer.
    pub(super) fn longer(&self) -> Option<Self> {
        let free = self.length_mm.is_none() && self.muscle.is_none() && self.contraction.is_none();
        let is_short = self.stroke_mm?.0 > USUAL_CONTRACTION * Muscle::prototype().length_mm();
        (free && is_short).then(|| Self {
            contraction: Some(Ratio(USUAL_CONTRACTION)),
            ..self.clone()
        })
    }

    /// The share of muscles that meet the requirement, checked.
    fn guaranteed(&self) -> Result<Option<f64>> {
        match self.guaranteed.map(f64::from) {
            Some(share) if !(0.5..=0.999).contains(&share) => {
                let message = format!(
                    "{share} is not a valid share: from 0.5 (50 %) to 0.999 (99.9 %), usually 0.95"
                );
                Err(Problem::new(ProblemKind::Range, message, "").in_field("guaranteed"))
            }
            share => Ok(share),
        }
    }

    /// Strand lengths per turn of sleeves in mm: those on sale, of which there is a list.
    fn turns_mm(&self) -> Result<Vec<f64>> {
        const FIELD: &str = "strand_length_per_turn_mm";
        let Some(choice) = &self.strand_length_per_turn_mm else {
            return Ok(vec![]);
        };
        match values(choice, FIELD)? {
            Values::List(list) => Ok(list),
            Values::Interval(..) => {
                let message = "give the sleeves that are sold as a list";
                let hint = "such as 90,110,130mm";
                Err(Problem::new(ProblemKind::Range, message, hint).in_field(FIELD))
            }
        }
    }

    /// What asks for free sizes, in place of tubes and sleeves as sold.
    fn free_sizes(&self, of_one_braid: bool, extends: bool) -> Option<&'static str> {
        let given = [
            ("`continuous`", self.continuous),
            (
                "`muscle`",
                self.muscle.is_some() || self.also_muscle.is_some(),
            ),
            ("`with`", !self.with.is_empty()),
            ("`outer_diameter_mm`", self.outer_diameter_mm.is_some()),
            ("`wall_mm`", self.wall_mm.is_some()),
            ("`angle_deg`", self.angle_deg.is_some()),
            (
                "`strand_length_per_turn_mm`",
                self.strand_length_per_turn_mm.is_some(),
            ),
            ("`stiffness`", self.stiffness.is_some()),
            // A formula for one braid and rubber has no answer for others.
            ("a formula for one braid", of_one_braid),
            ("a push", extends),
        ];
        given
            .into_iter()
            .find(|(_, given)| *given)
            .map(|(by, _)| by)
    }

    /// The tubes that are searched.
    fn tubes(&self) -> Result<Vec<TubePart>> {
        let of_user = users_tubes(self.parts.as_ref())?;
        let all = match &of_user {
            Some(tubes) => &tubes[..],
            None => tubes::catalogue().map_err(unread)?,
        };
        if of_user.is_some() && self.tubes.is_empty() && self.rubbers.is_empty() {
            return Ok(all.to_vec());
        }
        let rubbers: Vec<String> = match &self.rubbers[..] {
            [] => vec![tubes::CAST_RUBBER.into()],
            some => some.to_vec(),
        };
        if !self.tubes.is_empty() {
            let of_name = |name: &String| match tubes::of_size(name, &rubbers[0]) {
                Some(_) => rubbers
                    .iter()
                    .filter_map(|rubber| tubes::of_size(name, rubber))
                    .collect(),
                None => Ok(vec![tubes::find(all, name)?]),
            };
            let named: std::result::Result<Vec<Vec<TubePart>>, _> =
                self.tubes.iter().map(of_name).collect();
            return Ok(named.map_err(|e| unread(e).in_field("tubes"))?.concat());
        }
        let wanted = rubbers
            .iter()
            .map(|name| Ok(rubber(name)?.name))
            .collect::<Result<Vec<_>>>()?;
        let sold = all
            .iter()
            .filter(|t| !t.is_cast && (self.rubbers.is_empty() || wanted.contains(&t.rubber.name)));
        let mut found: Vec<TubePart> = sold.cloned().collect();
        if of_user.is_none() {
            for name in &rubbers {
                found.extend(tubes::cast_of(name).map_err(unread)?);
            }
        }
        Ok(found)
    }

    /// The named sleeves, all of the library where parts are searched, or the base muscle's.
    fn sleeves(&self, base: &Muscle, as_sold: bool) -> Result<Vec<Braid>> {
        let entries = sleeve_entries(self.parts.as_ref())?;
        let on_least = |entry: &SleeveEntry| Ok(entry.sleeve.on(entry.sleeve.diameters().0)?);
        if self.braids.is_empty() && as_sold {
            return entries.iter().map(on_least).collect();
        }
        if self.braids.is_empty() {
            let own = base.braid().sleeve.is_some() && self.angle_deg.is_none();
            return Ok(if own {
                vec![base.braid().clone()]
            } else {
                vec![]
            });
        }
        let braid = |name: &String| {
            if let Cow::Owned(of_user) = &entries
                && let Some(entry) = of_user.iter().find(|entry| entry.sleeve.name() == name)
            {
                return on_least(entry);
            }
            let mut fields = MuscleFields {
                braid: Some(name.clone()),
                stiffness: self.stiffness,
                strand_diameter_mm: self.strand_diameter_mm,
                ..MuscleFields::default()
            };
            let modulus = self.strand_modulus_mpa.into_iter();
            modulus.for_each(|value| fields.measures.set(&STRAND_MODULUS, value.0));
            // Laid on any tube that it fits; the search lays it on others.
            fields.braid_on(sleeve(name)?.diameters().0, base)
        };
        self.braids.iter().map(braid).collect()
    }

    /// The muscle around the search, what it must do, and the radii of a joint's pulley.
    fn demand(&self) -> Result<(Muscle, Demand, Option<Values>)> {
        let points = !self.points.is_empty() || self.force_n.is_some();
        let stated = [points, self.load.load.is_some(), !self.torques.is_empty()];
        if stated.iter().filter(|a| **a).count() > 1 {
            let message = "`force_n` or `points`, `load` and `torques` each state the requirement: \
                give only one of them";
            return Err(Problem::new(ProblemKind::Usage, message, ""));
        }
        if !self.torques.is_empty() {
            let (base, joint, radius) = self.joint()?;
            return Ok((base, Demand::Joint(joint), Some(radius)));
        }
        let of_joint = [
            ("radius_mm", self.radius_mm.is_some()),
            ("largest_angle_deg", self.largest_angle_deg.is_some()),
        ];
        Problem::refuse_unused(
            &of_joint,
            "it belongs to a joint, and no `torques` are given",
        )?;
        if self.load.load.is_some() {
            // The load sets the pull; a stroke or a contraction how far it is lifted.
            let way = match (self.contraction, self.stroke_mm) {
                (Some(e), _) => Lift::Contraction(ratio(e.0)?),
                (None, Some(stroke)) => Lift::Stroke(stroke.0),
                (None, None) => {
                    return Err(Problem::missing(
                        "stroke_mm",
                        "the lift of the load, such as 40 mm",
                    )
                    .with_hint("or give `contraction`, such as 0.15 (15 %)"));
                }
            };
            let (base, _) = self.with_stroke(vec![(1.0, self.contraction.map(f64::from))])?;
            let load = self.load.resolve(base.length_mm())?;
            let Some(load) = load else {
                return Err(Problem::missing("load", "a load, such as mass:20kg"));
            };
            return Ok((base, Demand::Load { load, way }, None));
        }
        let (base, points) = self.with_stroke(self.wanted()?)?;
        Ok((base, points.into(), None))
    }

    /// The muscle around the search, the torques, and the radii of the pulley.
    fn joint(&self) -> Result<(Muscle, JointDemand, Values)> {
        if self.stroke_mm.is_some() || self.contraction.is_some() {
            let message = "the angles and the pulley set the contraction of a joint's muscles";
            return Err(Problem::new(
                ProblemKind::Usage,
                message,
                "leave out `stroke_mm` and `contraction`",
            ));
        }
        let torques = self.torques.clone();
        let mut numbers = torques.iter().flat_map(|t| [t.torque_nm, t.angle_deg]);
        numbers.try_for_each(|v| finite("torques", v).map(drop))?;
        let largest = torques
            .iter()
            .map(|t| t.angle_deg.abs())
            .fold(0.0, f64::max);
        let largest_angle_deg = finite(
            "largest_angle_deg",
            self.largest_angle_deg.unwrap_or(Angle(largest)),
        )?;
        let (base, _) = self.with_stroke(vec![])?;
        let radius = match &self.radius_mm {
            Some(choice) => values(choice, "radius_mm")?,
            None => {
                let longest = match &self.length_mm {
                    Some(choice) => values(choice, "length_mm")?.bounds().1,
                    None => base.length_mm(),
                };
                let turn =
                    torques.iter().map(|t| t.angle_deg).fold(0.0, f64::max) + largest_angle_deg;
                let most = LARGEST_CONTRACTION * longest / turn.max(1.0).to_radians();
                Values::Interval(SMALLEST_RADIUS * most, most)
            }
        };
        let radius_mm = radius.bounds().1;
        Ok((
            base,
            JointDemand {
                torques,
                largest_angle_deg,
                radius_mm,
            },
            radius,
        ))
    }

    /// The operating points; without a contraction where a stroke is to set it.
    fn wanted(&self) -> Result<Vec<(f64, Option<f64>)>> {
        if !self.points.is_empty() {
            return self
                .points
                .iter()
                .map(|w| {
                    let contraction = ratio(w.contraction);
                    let contraction = contraction.map_err(|problem| problem.in_field("points"))?;
                    Ok((w.force_n, Some(contraction)))
                })
                .collect();
        }
        let force_n = given("force_n", self.force_n, "a force, such as 300 N")?;
        match (self.contraction, self.stroke_mm) {
            (Some(e), _) => Ok(vec![(force_n, Some(ratio(e.0)?))]),
            (None, Some(_)) => Ok(vec![(force_n, None)]),
            (None, None) => Err(
                Problem::missing("contraction", "a ratio such as 0.15 (15 %)")
                    .with_hint("or give `stroke_mm`, such as 40 mm, with `length_mm`"),
            ),
        }
    }

    /// The muscle around the search, and the points: a stroke in mm sets the length where
    /// contractions are given, and the contraction where they are not.
    fn with_stroke(
        &self,
        wanted: Vec<(f64, Option<f64>)>,
    ) -> Result<(Muscle, Vec<OperatingPoint>)> {
        let wrong =
            |message: String, hint: &str| Problem::new(ProblemKind::Specification, message, hint);
        let length_mm = match &self.length_mm {
            Some(Choice::One(length)) => Some(length.0),
            Some(_) if self.stroke_mm.is_some() => {
                let message =
                    "`stroke_mm` sets the length, or needs one: give one `length_mm`, or none";
                return Err(wrong(message.into(), "").in_field("length_mm"));
            }
            _ => None,
        };
        let mut fields = MuscleFields {
            file: self.muscle.clone().or(self.also_muscle.clone()),
            stiffness: self.stiffness,
            with: self.with.clone(),
            ..MuscleFields::default()
        };
        length_mm
            .into_iter()
            .for_each(|length| fields.measures.set(&LENGTH, length));
        let base = fields.resolve()?;
        let length = base.length_mm();
        let stroke = self.stroke_mm.map(f64::from);
        stroke
            .map(|mm| above_zero(ProblemKind::Specification, "stroke_mm", mm))
            .transpose()?;
        let point = |(force_n, contraction): &(f64, Option<f64>)| {
            let way = force_n.signum();
            let contraction = contraction
                .or(stroke.map(|s| way * s / length))
                .unwrap_or(0.0);
            OperatingPoint {
                force_n: *force_n,
                contraction,
            }
        };
        let points: Vec<OperatingPoint> = wanted.iter().map(point).collect();
        let (Some(stroke), true) = (stroke, wanted.iter().all(|w| w.1.is_some())) else {
            return Ok((base, points));
        };
        let largest = points
            .iter()
            .map(|q| q.contraction.abs())
            .fold(0.0, f64::max);
        if self.length_mm.is_some() {
            let have = largest * length;
            let message = format!(
                "{stroke}\u{a0}mm, `length_mm` {length}\u{a0}mm and a contraction are too many \
                 data: with that length the largest contraction gives {have:.2}\u{a0}mm"
            );
            let hint = "leave out `stroke_mm`, `length_mm` or the contraction";
            return Err(wrong(message, hint).in_field("stroke_mm"));
        }
        if largest <= 0.0 {
            return Err(wrong("a stroke needs a contraction above zero".into(), ""));
        }
        let tube = Tube {
            length_mm: stroke / largest,
            ..base.tube().clone()
        };
        Ok((base.with_tube(tube)?, points))
    }
}

/// The values of a choice, checked.
fn values<Q: Quantity>(choice: &Choice<Q>, field: &str) -> Result<Values> {
    Ok(match choice {
        Choice::One(value) => Values::List(vec![finite(field, *value)?]),
        Choice::Several(list) if list.is_empty() => {
            return Err(Problem::new(ProblemKind::Range, "the list is empty", "").in_field(field));
        }
        Choice::Several(list) => {
            let list = list.iter().map(|&value| finite(field, value));
            Values::List(list.collect::<Result<_>>()?)
        }
        Choice::Between { low, high } => {
            let (low, high) = (finite(field, *low)?, finite(field, *high)?);
            if low > high {
                let message = format!(
                    "the interval from {low} to {high} is reversed: write the smaller value first"
                );
                return Err(Problem::new(ProblemKind::Range, message, "").in_field(field));
            }
            Values::Interval(low, high)
        }
    })
}

/// A contraction ratio; a shortening in mm is a stroke.
#[cfg(feature = "clap")]
fn contraction(text: &str) -> Result<Ratio> {
    text.parse().map_err(|error: QuantityError| {
        let hint = match text.parse::<Length>() {
            Ok(_) => "give a ratio such as 15%, or a stroke with `stroke_mm`",
            Err(_) => "",
        };
        Problem::new(ProblemKind::Quantity, error.to_string(), hint)
    })
}

/// A required pull at a contraction: `700N@15%`.
#[cfg(feature = "clap")]
fn operating_point(text: &str) -> Result<OperatingPoint> {
    let expected = "operating point; expected a pull at a contraction such as 700N@15%";
    let (Force(force_n), Ratio(contraction)) = at(text, expected)?;
    Ok(OperatingPoint {
        force_n,
        contraction,
    })
}

/// A required torque at an angle to either side: `8Nm@45deg`.
#[cfg(feature = "clap")]
fn torque(text: &str) -> Result<TorqueWanted> {
    let expected = "torque at an angle; expected one such as 8Nm@45deg";
    let (typed::Torque(torque_nm), Angle(angle_deg)) = at(text, expected)?;
    Ok(TorqueWanted {
        torque_nm,
        angle_deg,
    })
}

#[cfg(feature = "clap")]
fn at<A, B>(text: &str, expected: &str) -> Result<(A, B)>
where
    A: std::str::FromStr<Err = QuantityError>,
    B: std::str::FromStr<Err = QuantityError>,
{
    let wrong = |message| Problem::new(ProblemKind::Quantity, message, "");
    let (first, second) = text
        .split_once('@')
        .ok_or_else(|| wrong(format!("\"{text}\" is not a valid {expected}")))?;
    // The joint is symmetric.
    let second = second.trim().trim_start_matches(['±', '+']);
    let first = first
        .parse()
        .map_err(|e: QuantityError| wrong(e.to_string()))?;
    let second = second
        .parse()
        .map_err(|e: QuantityError| wrong(e.to_string()))?;
    Ok((first, second))
}
