//! How a request becomes a specification, and what it leaves open.

use super::{
    assumed::{SUPPLY_MPA, Stated},
    design_ends,
    request::DesignRequest,
};
use crate::{
    Model, MuscleFields, Problem, ProblemKind, Result, TextFile, above_zero, check_branch, finite,
    given,
    parts::{sleeve_entries, unread, users_tubes},
    ratio, rubber, sleeve,
};
use mckibben::Deciding;
use mckibben_core::{
    answer::Options,
    extremes::peak,
    load::Load,
    muscle::{
        Braid, Direction, Muscle, Tube,
        measures::{LENGTH, STRAND_MODULUS},
    },
    rubber::library::stiffness_factor,
    sleeve::SleeveEntry,
    units::{
        Values, tidy,
        typed::{Angle, Choice, Length, Quantity},
    },
};
use mckibben_design::{
    BraidChoice, CERTAINTY, Demand, JointDemand, LARGEST_BUNDLE, Lift, OperatingPoint, Product,
    SUPPLY_SHARE, Spec,
    tubes::{self, TubePart},
};
use mckibben_fit::library::{PREFIX, library};
use std::borrow::Cow;

/// What is searched, by which models, and what of it was assumed.
pub struct Search {
    pub spec: Spec,
    pub policy: Deciding,
    pub stated: Stated,
}

/// Contraction that no braid reaches: that of inextensible strands at 0°, 1 − 1/√3, rounded. It
/// bounds the radii of a joint's pulley.
const LARGEST_CONTRACTION: f64 = 0.42;
/// Contractions that a stroke may be, where the length is searched: a quarter of the free one of a
/// usual sleeve, and nearly all of it; and where no single muscle does, the least.
const CONTRACTIONS: (f64, f64) = (0.065, 0.24);
const LONGER: [f64; 2] = [0.05, 0.04];
/// Least length over the outer diameter there: no muscle was measured that is shorter.
const LEAST_SLENDERNESS: f64 = 4.0;
/// The smallest radius that is searched, as a share of the largest.
const SMALLEST_RADIUS: f64 = 0.1;

/// Braid angles in degrees that are searched for a push where none is given.
const EXTENSILE_DEG: (f64, f64) = (57.0, 72.0);

/// Diameters and walls in mm that are searched where nothing else is said.
const SECTIONS: ((f64, f64), (f64, f64)) = ((5.0, 80.0), (0.5, 10.0));

impl DesignRequest {
    pub fn search(&self) -> Result<Search> {
        self.validate()?;
        let (base, wanted, radius_mm) = self.demand()?;
        let count = self.count.map_or(1, |count| count.0 as u32);
        let extends = wanted.extends();
        let model = self.model.choose()?;
        let policy = match self.model.name {
            Some(_) => Deciding::by(model),
            None => Deciding {
                model,
                ..Deciding::usual(extends)
            },
        };
        let range = policy.model.range();
        let tubes = match self.free_sizes(range.is_some(), extends) {
            None => Some(self.tubes_of_make()?),
            Some(by) => {
                self.refuse_tubes(by)?;
                None
            }
        };
        let braid = self.braid_choice(&base, tubes.is_some(), extends)?;
        let (diameters, walls) = range.map_or(SECTIONS, |r| (r.outer_diameter_mm, r.wall_mm));
        let between = |field, choice: &Option<Choice<Length>>, (low, high)| {
            choice.as_ref().map_or_else(
                || Ok(Values::Interval(low, high)),
                |choice| values(choice, field),
            )
        };
        let rubbers = self.rubbers.iter().map(|name| rubber(name));
        let usual_mpa = range.map_or(SUPPLY_MPA, |r| r.pressure_mpa.1.min(SUPPLY_MPA));
        let supply_mpa = self.max_pressure_mpa.map_or(usual_mpa, f64::from);
        let is_built = self.model.name.is_none() && !extends;
        let by_length = self.length_is_searched() && self.length_mm.is_none();
        let spec = Spec {
            wanted,
            count,
            most_side_by_side: self.count.map_or(LARGEST_BUNDLE, |_| count),
            radius_mm,
            ends: Some(design_ends),
            products: if extends { vec![] } else { products() },
            pitch_mm: self.pitch_mm.map(f64::from),
            built: is_built,
            direction: self.branch(),
            max_pressure_mpa: finite("max_pressure_mpa", supply_mpa)?,
            // A closed form or a formula is a method that takes the pressure as it is given.
            supply_share: match policy.model {
                Model::Elements(_) => SUPPLY_SHARE,
                _ => 1.0,
            },
            liquid: self.liquid.named_supply()?,
            length_mm: self.lengths(tubes.is_some())?,
            longer_mm: match self.stroke_mm.filter(|_| by_length) {
                Some(stroke) => LONGER.map(|share| tidy(stroke.0 / share, 2)).to_vec(),
                None => vec![],
            },
            least_slenderness: if by_length { LEAST_SLENDERNESS } else { 0.0 },
            limits: self.limits(&braid, &base)?,
            base,
            tubes: tubes.unwrap_or_default(),
            outer_diameter_mm: between("outer_diameter_mm", &self.outer_diameter_mm, diameters)?,
            wall_mm: between("wall_mm", &self.wall_mm, walls)?,
            braid,
            rubbers: rubbers.collect::<Result<_>>()?,
            certainty: self
                .certainty
                .map(f64::from)
                .or(is_built.then_some(CERTAINTY)),
            objective: self.objective,
            top: self.top.map_or(5, |top| top.0),
            extrapolate: self.extrapolate,
        };
        self.check_branch(&spec)?;
        Ok(Search {
            stated: Stated::new(self, &policy.model),
            spec,
            policy,
        })
    }

    /// Of free sizes no tube is named.
    fn refuse_tubes(&self, by: impl std::fmt::Display) -> Result<()> {
        Problem::refuse_unused(
            &[
                ("sold", self.sold),
                ("cast", self.cast),
                ("tubes", !self.tubes.is_empty()),
                ("parts", self.parts.is_some()),
            ],
            format!("{by} asks for free sizes"),
        )
    }

    /// The branch on which it must pull: a model by name answers for itself, a muscle that is built
    /// lifts against friction.
    fn branch(&self) -> Direction {
        self.direction.unwrap_or(match self.model.name {
            Some(_) => Direction::Mean,
            None => Direction::Contraction,
        })
    }

    /// Refuses a branch that is asked for, of muscles whose friction is not known.
    fn check_branch(&self, spec: &Spec) -> Result<()> {
        let options = spec.options();
        match self.direction {
            Some(direction) if direction != options.direction => check_branch(
                Options {
                    direction,
                    ..options
                },
                &spec.base,
            ),
            _ => Ok(()),
        }
    }

    /// The lengths that are searched: those that are given, or those of which a stroke is a share
    /// that a muscle contracts by.
    fn lengths(&self, as_sold: bool) -> Result<Option<Values>> {
        let stroke = self.stroke_mm.filter(|_| self.length_is_searched());
        Ok(match (&self.length_mm, stroke) {
            (None | Some(Choice::One(_)), None) => None,
            (Some(choice), _) => Some(values(choice, "length_mm")?),
            (None, Some(stroke)) => {
                let (low, high) = CONTRACTIONS;
                let [low, high] = [high, low].map(|share| tidy(stroke.0 / share, 2));
                Some(Values::Interval(
                    low,
                    if as_sold {
                        high
                    } else {
                        // Of free sizes no tube says which length its ends allow.
                        high.max(Muscle::prototype().length_mm())
                    },
                ))
            }
        })
    }

    /// Whether a stroke sets the contraction of muscles whose length is searched.
    pub fn length_is_searched(&self) -> bool {
        let is_free = match &self.length_mm {
            Some(choice) => !matches!(choice, Choice::One(_)),
            None => {
                self.file().is_none()
                    && !self
                        .model
                        .choose()
                        .is_ok_and(|model: Model| model.range().is_some())
            }
        };
        let pushes = self.force_n.is_some_and(|force_n| force_n.0 < 0.0);
        is_free && self.stroke_mm.is_some() && self.contraction.is_none() && !pushes
    }

    /// The muscle file.
    pub fn file(&self) -> Option<&TextFile> {
        self.muscle.as_ref().or(self.also_muscle.as_ref())
    }

    /// The sleeves, or the angles.
    fn braid_choice(&self, base: &Muscle, as_sold: bool, extends: bool) -> Result<BraidChoice> {
        let sleeves = self.sleeves(base, as_sold)?;
        let turns = self.turns_mm()?;
        Ok(match &self.angle_deg {
            Some(angles) => BraidChoice::Angle(values(angles, "angle_deg")?),
            None if !turns.is_empty() => BraidChoice::StrandLengthPerTurn(turns),
            None if !sleeves.is_empty() => BraidChoice::Sleeves(sleeves),
            None if extends && !base.is_extensile() => {
                BraidChoice::Angle(Values::Interval(EXTENSILE_DEG.0, EXTENSILE_DEG.1))
            }
            None => BraidChoice::Angle(Values::List(vec![base.braid().angle_deg])),
        })
    }

    /// Strand lengths per turn of sleeves in mm: those on sale, of which there is a list.
    fn turns_mm(&self) -> Result<Vec<f64>> {
        const FIELD: &str = "strand_length_per_turn_mm";
        let Some(choice) = &self.strand_length_per_turn_mm else {
            return Ok(vec![]);
        };
        match values(choice, FIELD)? {
            Values::List(list) => Ok(list),
            Values::Interval(..) => Err(Problem::new(
                ProblemKind::Range,
                "give the sleeves that are sold as a list",
                "such as 90,110,130mm",
            )
            .in_field(FIELD)),
        }
    }

    /// What asks for free sizes, in place of tubes and sleeves as sold.
    fn free_sizes(&self, of_one_braid: bool, extends: bool) -> Option<&'static str> {
        let given = [
            ("`continuous`", self.continuous),
            ("`muscle`", self.file().is_some()),
            ("`with`", !self.with.is_empty()),
            ("`outer_diameter_mm`", self.outer_diameter_mm.is_some()),
            ("`wall_mm`", self.wall_mm.is_some()),
            // A tube by its size takes an angle as `force` does.
            (
                "`angle_deg`",
                self.angle_deg.is_some() && self.tubes.is_empty(),
            ),
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

    /// The tubes that are searched, of the make that is asked.
    fn tubes_of_make(&self) -> Result<Vec<TubePart>> {
        let mut tubes = self.tubes()?;
        tubes.retain(|tube| !(self.sold && tube.is_cast || self.cast && !tube.is_cast));
        if tubes.is_empty() {
            let field = if self.sold { "sold" } else { "cast" };
            return Err(Problem::usage(
                format!("`{field}` leaves none of the tubes that are named"),
                "",
            )
            .in_field(field));
        }
        Ok(tubes)
    }

    /// The tubes that are named, or all.
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
            let named: Result<Vec<Vec<TubePart>>, _> = self.tubes.iter().map(of_name).collect();
            return Ok(named.map_err(|e| unread(e).in_field("tubes"))?.concat());
        }
        let wanted = rubbers
            .iter()
            .map(|name| Ok(rubber(name)?.name))
            .collect::<Result<Vec<_>>>()?;
        let mut found: Vec<TubePart> = all
            .iter()
            .filter(|t| !t.is_cast && (self.rubbers.is_empty() || wanted.contains(&t.rubber.name)))
            .cloned()
            .collect();
        if of_user.is_none() {
            // A stand-in for tubes as they are sold is no silicone that one casts.
            for name in &rubbers {
                if stiffness_factor(&rubber(name)?) <= 1.0 {
                    found.extend(tubes::cast_of(name).map_err(unread)?);
                }
            }
        }
        if found.is_empty() {
            return Err(Problem::usage(
                format!(
                    "no tube of {} is in the catalogue, and it is not cast",
                    rubbers.join(", ")
                ),
                "give its size (`tubes`, such as 8x12mm), or sizes to search \
                (`outer_diameter_mm` and `wall_mm`)",
            )
            .in_field("rubbers"));
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
            self.strand_modulus_mpa
                .into_iter()
                .for_each(|value| fields.measures.set(&STRAND_MODULUS, value.0));
            // Laid on any tube that it fits; the search lays it on others.
            fields.braid_on(sleeve(name)?.diameters().0, base)
        };
        self.braids.iter().map(braid).collect()
    }

    /// The muscle around the search, what it must do, and the radii of a joint's pulley.
    fn demand(&self) -> Result<(Muscle, Demand, Option<Values>)> {
        if !self.torques.is_empty() {
            let (base, joint, radius) = self.joint()?;
            return Ok((base, Demand::Joint(joint), Some(radius)));
        }
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
            let load = self
                .load
                .resolve(base.length_mm())?
                .ok_or_else(|| Problem::missing("load", "a load, such as 20 kg"))?;
            return Ok((base, Demand::Load { load, way }, None));
        }
        let (base, points) = self.with_stroke(self.wanted()?)?;
        if let (Some(stroke), Some(force_n)) = (self.stroke_mm, self.force_n)
            && self.length_is_searched()
        {
            return Ok((
                base,
                Demand::Load {
                    load: Load::Force { force_n: force_n.0 },
                    way: Lift::Stroke(stroke.0),
                },
                None,
            ));
        }
        Ok((base, points.into(), None))
    }

    /// The muscle around the search, the torques, and the radii of the pulley.
    fn joint(&self) -> Result<(Muscle, JointDemand, Values)> {
        let torques = self.torques.clone();
        torques
            .iter()
            .flat_map(|t| [t.torque_nm, t.angle_deg])
            .try_for_each(|v| finite("torques", v).map(drop))?;
        let largest_angle_deg = finite(
            "largest_angle_deg",
            self.largest_angle_deg
                .unwrap_or(Angle(peak(torques.iter().map(|t| t.angle_deg.abs())))),
        )?;
        let (base, _) = self.with_stroke(vec![])?;
        let radius = if let Some(choice) = &self.radius_mm {
            values(choice, "radius_mm")?
        } else {
            let longest = match &self.length_mm {
                Some(choice) => values(choice, "length_mm")?.bounds().1,
                None => base.length_mm(),
            };
            let turn = peak(torques.iter().map(|t| t.angle_deg)) + largest_angle_deg;
            let most = LARGEST_CONTRACTION * longest / turn.max(1.0).to_radians();
            Values::Interval(SMALLEST_RADIUS * most, most)
        };
        Ok((
            base,
            JointDemand {
                torques,
                largest_angle_deg,
                radius_mm: radius.bounds().1,
                // Who gives a radius knows where the muscles lie.
                beside: self.radius_mm.is_none(),
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
                    let contraction =
                        ratio(w.contraction).map_err(|problem| problem.in_field("points"))?;
                    Ok((w.force_n, Some(contraction)))
                })
                .collect();
        }
        let force_n =
            given("force_n", self.force_n, "a force, such as 300 N").map_err(|problem| {
                problem.with_hint("or give what it lifts (`load`), or turns (`torques`)")
            })?;
        match (self.contraction, self.stroke_mm) {
            (Some(e), _) => Ok(vec![(force_n, Some(ratio(e.0)?))]),
            (None, Some(_)) => Ok(vec![(force_n, None)]),
            (None, None) => Err(
                Problem::missing("contraction", "a ratio such as 0.15 (15 %)")
                    .with_hint("or give `stroke_mm`, such as 40 mm"),
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
            Some(_) if self.stroke_mm.is_some() && !self.length_is_searched() => {
                return Err(wrong(
                    "`stroke_mm` and a contraction set the length: give one of the three less"
                        .into(),
                    "",
                )
                .in_field("length_mm"));
            }
            _ => None,
        };
        let mut fields = MuscleFields {
            file: self.file().cloned(),
            stiffness: self.stiffness,
            with: self.with.clone(),
            ..MuscleFields::default()
        };
        length_mm
            .into_iter()
            .for_each(|length| fields.measures.set(&LENGTH, length));
        let base = fields.resolve_for(&self.model.choose()?)?;
        let length = base.length_mm();
        let stroke = self.stroke_mm.map(f64::from);
        stroke
            .map(|mm| above_zero(ProblemKind::Specification, "stroke_mm", mm))
            .transpose()?;
        let point = |(force_n, contraction): &(f64, Option<f64>)| {
            let way = force_n.signum();
            OperatingPoint {
                force_n: *force_n,
                contraction: contraction
                    .or(stroke.map(|s| way * s / length))
                    .unwrap_or_default(),
            }
        };
        let points = Vec::from_iter(wanted.iter().map(point));
        let (Some(stroke), true) = (stroke, wanted.iter().all(|w| w.1.is_some())) else {
            return Ok((base, points));
        };
        let largest = peak(points.iter().map(|q| q.contraction.abs()));
        if self.length_mm.is_some() {
            let have = largest * length;
            return Err(wrong(
                format!(
                    "{stroke}\u{a0}mm, `length_mm` {length}\u{a0}mm and a contraction are too many \
                 data: with that length the largest contraction gives {have:.2}\u{a0}mm"
                ),
                "leave out `stroke_mm`, `length_mm` or the contraction",
            )
            .in_field("stroke_mm"));
        }
        if largest <= 0.0 {
            return Err(wrong("a stroke needs a contraction above zero".into(), ""));
        }
        Ok((
            base.with_tube(Tube {
                length_mm: stroke / largest,
                ..base.tube().clone()
            })?,
            points,
        ))
    }
}

/// The muscles of the library that have a product.
fn products() -> Vec<Product> {
    library()
        .into_iter()
        .filter_map(|(of, muscle)| {
            let product = of.facts.product.as_deref()?;
            Some(Product {
                name: format!("{product} ({PREFIX}{})", of.facts.name),
                muscle: muscle.clone(),
            })
        })
        .collect()
}

/// The values of a choice, checked.
fn values<Q: Quantity>(choice: &Choice<Q>, field: &str) -> Result<Values> {
    Ok(match choice {
        Choice::One(value) => Values::List(vec![finite(field, *value)?]),
        Choice::Several(list) if list.is_empty() => {
            return Err(ProblemKind::Range
                .problem("the list is empty")
                .in_field(field));
        }
        Choice::Several(list) => Values::List(
            list.iter()
                .map(|&value| finite(field, value))
                .collect::<Result<_>>()?,
        ),
        Choice::Between { low, high } => {
            let low = finite(field, *low)?;
            let high = finite(field, *high)?;
            if low > high {
                return Err(ProblemKind::Range.problem(format!(
                    "the interval from {low} to {high} is reversed: write the smaller value first"
                )).in_field(field));
            }
            Values::Interval(low, high)
        }
    })
}
