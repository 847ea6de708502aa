//! How a request becomes a specification, and what it leaves open.

use super::{assumed::SUPPLY_MPA, design_ends, request::DesignRequest};
use crate::{
    Model, MuscleFields, Problem, ProblemKind, Result, TextFile, above_zero, check_branch, finite,
    given,
    parts::{sleeve_entries, unread, users_tubes},
    problem::stated,
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
    rubber::{Rubber, library::stiffness_factor},
    sleeve::SleeveEntry,
    units::{
        Values, tidy,
        typed::{Choice, Force, Quantity, Ratio},
    },
};
use mckibben_design::{
    BraidChoice, CERTAINTY, Demand, JointDemand, LARGEST_BUNDLE, OperatingPoint, Product,
    SUPPLY_SHARE, Spec,
    tubes::{self, TubePart},
};
use mckibben_fit::library::{PREFIX, library};
use std::borrow::Cow;

/// What is asked, what is searched for it, and by which models.
pub struct Search<'a> {
    pub request: &'a DesignRequest,
    pub spec: Spec,
    pub policy: Deciding,
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
const EXTENSILE_DEG: Values = Values::Interval(57.0, 72.0);

/// Diameters and walls in mm that are searched where nothing else is said.
const SECTIONS: [(f64, f64); 2] = [(5.0, 80.0), (0.5, 10.0)];

impl DesignRequest {
    /// The search that a request describes.
    pub fn search(&self) -> Result<Search<'_>> {
        self.validate()?;
        let (base, wanted) = self.demand()?;
        let count = self.count.map(|count| count.0 as u32);
        let extends = wanted.extends();
        let model = self.model.choose()?;
        let is_named = self.model.name.is_some();
        let quick = Deciding::usual(extends).quick.filter(|_| !is_named);
        let policy = Deciding { quick, model };
        let range = policy.model.range();
        let free = self.free_sizes(range.is_some(), extends);
        let tubes = self.tubes_but(free.as_deref())?;
        let braid = self.braid_choice(&base, free.is_none(), extends)?;
        let [diameters, walls] = range
            .map_or(SECTIONS, |r| [r.outer_diameter_mm, r.wall_mm])
            .map(|(low, high)| Values::Interval(low, high));
        let outer_diameter_mm = values(&self.outer_diameter_mm, "outer_diameter_mm")?;
        let rubbers = self.rubbers.iter().map(|name| rubber(name));
        let usual_mpa = range.map_or(SUPPLY_MPA, |r| r.pressure_mpa.1.min(SUPPLY_MPA));
        let supply_mpa = self.max_pressure_mpa.map_or(usual_mpa, f64::from);
        let is_built = !is_named && !extends;
        let stroke_mm = self.searched_stroke_mm();
        let spec = Spec {
            wanted,
            count: count.unwrap_or(1),
            most_side_by_side: count.unwrap_or(LARGEST_BUNDLE),
            ends: Some(design_ends),
            products: if extends { vec![] } else { products() },
            pitch_mm: self.pitch_mm.map(f64::from),
            built: is_built,
            // A model by name answers for itself, a muscle that is built lifts against friction.
            direction: self.direction.unwrap_or(match is_named {
                true => Direction::Mean,
                false => Direction::Contraction,
            }),
            max_pressure_mpa: finite("max_pressure_mpa", supply_mpa)?,
            // A closed form or a formula is a method that takes the pressure as it is given.
            supply_share: match policy.model {
                Model::Elements(_) => SUPPLY_SHARE,
                _ => 1.0,
            },
            liquid: self.liquid.named_supply()?,
            length_mm: self.lengths(free.is_none())?,
            longer_mm: stroke_mm.map_or(vec![], |mm| LONGER.map(|e| tidy(mm / e, 2)).to_vec()),
            least_slenderness: stroke_mm.map_or(0.0, |_| LEAST_SLENDERNESS),
            limits: self.limits(&braid, &base)?,
            base,
            tubes,
            outer_diameter_mm: outer_diameter_mm.unwrap_or(diameters),
            wall_mm: values(&self.wall_mm, "wall_mm")?.unwrap_or(walls),
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
        if let Some(direction) = self.direction {
            let options = Options {
                direction,
                ..spec.options()
            };
            check_branch(options, &spec.base)?;
        }
        Ok(Search {
            request: self,
            spec,
            policy,
        })
    }

    /// The lengths that are searched: those that are given, or those of which a stroke is a share
    /// that a muscle contracts by.
    fn lengths(&self, as_sold: bool) -> Result<Option<Values>> {
        let Some(stroke_mm) = self.searched_stroke_mm() else {
            return Ok(match self.length_mm {
                Some(Choice::One(_)) => None,
                _ => values(&self.length_mm, "length_mm")?,
            });
        };
        let (low, high) = CONTRACTIONS;
        let [low, high] = [high, low].map(|share| tidy(stroke_mm / share, 2));
        // Of free sizes no tube says which length its ends allow.
        let usual = if as_sold {
            high
        } else {
            Muscle::prototype().length_mm()
        };
        Ok(Some(Values::Interval(low, high.max(usual))))
    }

    /// The stroke in mm that sets the lengths of the search.
    fn searched_stroke_mm(&self) -> Option<f64> {
        let is_free = self.length_mm.is_none() && self.length_is_searched();
        self.stroke_mm.filter(|_| is_free).map(f64::from)
    }

    /// Whether a stroke sets the contraction of muscles whose length is searched.
    pub fn length_is_searched(&self) -> bool {
        let has_range = |model: Model| model.range().is_some();
        let is_free = match &self.length_mm {
            Some(choice) => !matches!(choice, Choice::One(_)),
            None => self.file().is_none() && !self.model.choose().is_ok_and(has_range),
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
        const TURNS: &str = "strand_length_per_turn_mm";
        let sleeves = self.sleeves(base, as_sold)?;
        Ok(match values(&self.strand_length_per_turn_mm, TURNS)? {
            Some(Values::List(list)) => BraidChoice::StrandLengthPerTurn(list),
            // Of those on sale there is a list.
            Some(Values::Interval(..)) => {
                return Err(Problem::new(
                    ProblemKind::Range,
                    "give the sleeves that are sold as a list",
                    "such as 90,110,130mm",
                )
                .in_field(TURNS));
            }
            None if !sleeves.is_empty() && self.angle_deg.is_none() => {
                BraidChoice::Sleeves(sleeves)
            }
            None => {
                let usual = match extends && !base.is_extensile() {
                    true => EXTENSILE_DEG,
                    false => Values::List(vec![base.braid().angle_deg]),
                };
                BraidChoice::Angle(values(&self.angle_deg, "angle_deg")?.unwrap_or(usual))
            }
        })
    }

    /// What asks for free sizes, in place of tubes and sleeves as sold.
    fn free_sizes(&self, of_one_braid: bool, extends: bool) -> Option<String> {
        let stated = stated!(self; continuous, muscle, also_muscle, with, outer_diameter_mm, wall_mm,
            angle_deg, strand_length_per_turn_mm, stiffness);
        // A tube by its size takes an angle as `force` does.
        let is_of_tube = |name: &str| name == "angle_deg" && !self.tubes.is_empty();
        let asks = |field: &(&str, bool)| field.1 && !is_of_tube(field.0);
        if let Some((name, _)) = stated.into_iter().find(asks) {
            return Some(format!("`{}`", name.trim_start_matches("also_")));
        }
        // A formula for one braid and rubber has no answer for others.
        let by = of_one_braid.then_some("a formula for one braid");
        by.or(extends.then_some("a push")).map(String::from)
    }

    /// The tubes that are searched, of the make that is asked; none where something asks for free
    /// sizes.
    fn tubes_but(&self, free: Option<&str>) -> Result<Vec<TubePart>> {
        if let Some(by) = free {
            let named = stated!(self; sold, cast, tubes, parts);
            Problem::refuse_unused(&named, format!("{by} asks for free sizes"))?;
            return Ok(vec![]);
        }
        let mut tubes = self.tubes()?;
        tubes.retain(|tube| !(self.sold && tube.is_cast || self.cast && !tube.is_cast));
        if tubes.is_empty() {
            let field = if self.sold { "sold" } else { "cast" };
            let why = format!("`{field}` leaves none of the tubes that are named");
            return Err(Problem::usage(why, "").in_field(field));
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
        let wanted: Vec<Rubber> = rubbers
            .iter()
            .map(|name| rubber(name))
            .collect::<Result<_>>()?;
        let is_wanted = |tube: &&TubePart| {
            let is_of = |rubber: &Rubber| rubber.name == tube.rubber.name;
            !tube.is_cast && (self.rubbers.is_empty() || wanted.iter().any(is_of))
        };
        let mut found = Vec::from_iter(all.iter().filter(is_wanted).cloned());
        for (name, rubber) in rubbers.iter().zip(&wanted) {
            // A stand-in for tubes as they are sold is no silicone that one casts.
            if of_user.is_none() && stiffness_factor(rubber) <= 1.0 {
                found.extend(tubes::cast_of(name).map_err(unread)?);
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
            let own = Some(base.braid()).filter(|braid| braid.sleeve.is_some());
            return Ok(own.into_iter().cloned().collect());
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
            if let Some(modulus) = self.strand_modulus_mpa {
                fields.measures.set(&STRAND_MODULUS, modulus.0);
            }
            // Laid on any tube that it fits; the search lays it on others.
            fields.braid_on(sleeve(name)?.diameters().0, base)
        };
        self.braids.iter().map(braid).collect()
    }

    /// The muscle around the search, and what it must do. A stroke in mm sets the length where
    /// contractions are given, and the contraction where they are not.
    fn demand(&self) -> Result<(Muscle, Demand)> {
        if !self.torques.is_empty() {
            return self.joint();
        }
        let mut points = self.points_or_load()?;
        let mut base = self.base()?;
        let stroke_mm = self
            .stroke_mm
            .map(|mm| above_zero(ProblemKind::Specification, "stroke_mm", mm))
            .transpose()?;
        if let Some(stroke_mm) = stroke_mm {
            if self.contraction.is_some() || !self.points.is_empty() {
                let length_mm = self.length_of(stroke_mm, &points, &base)?;
                base = base.with_tube(Tube {
                    length_mm,
                    ..base.tube().clone()
                })?;
            } else {
                for q in &mut points {
                    q.contraction = q.force_n.signum() * stroke_mm / base.length_mm();
                }
            }
        }
        // The load sets the pull; a stroke or a contraction how far it is lifted.
        let load = match (self.load.resolve(base.length_mm())?, self.force_n) {
            (None, Some(Force(force_n))) if self.length_is_searched() => {
                Some(Load::Force { force_n })
            }
            (load, _) => load,
        };
        let demand = match (load, self.contraction, stroke_mm) {
            (Some(load), Some(Ratio(contraction)), _) => Demand::Contraction { load, contraction },
            (Some(load), None, Some(stroke_mm)) => Demand::Stroke { load, stroke_mm },
            _ => Demand::Points { points },
        };
        Ok((base, demand))
    }

    /// The torques, and the radii of the pulley.
    fn joint(&self) -> Result<(Muscle, Demand)> {
        let torques = self.torques.clone();
        for t in &torques {
            finite("torques", t.torque_nm)?;
            finite("torques", t.angle_deg)?;
        }
        let farthest_deg = peak(torques.iter().map(|t| t.angle_deg.abs()));
        let largest_deg = self.largest_angle_deg.map_or(farthest_deg, f64::from);
        let largest_angle_deg = finite("largest_angle_deg", largest_deg)?;
        let base = self.base()?;
        let radii_mm = match values(&self.radius_mm, "radius_mm")? {
            Some(radii_mm) => radii_mm,
            None => {
                let lengths = values(&self.length_mm, "length_mm")?;
                let longest_mm = lengths.map_or(base.length_mm(), |mm| mm.bounds().1);
                let turn = peak(torques.iter().map(|t| t.angle_deg)) + largest_angle_deg;
                let most = LARGEST_CONTRACTION * longest_mm / turn.max(1.0).to_radians();
                Values::Interval(SMALLEST_RADIUS * most, most)
            }
        };
        let joint = JointDemand {
            torques,
            largest_angle_deg,
            radii_mm,
            // Who gives a radius knows where the muscles lie.
            beside: self.radius_mm.is_none(),
        };
        Ok((base, Demand::Joint(joint)))
    }

    /// The operating points, of a load that of 1 N in its place; without a contraction where a
    /// stroke is to set it.
    fn points_or_load(&self) -> Result<Vec<OperatingPoint>> {
        for q in &self.points {
            ratio(q.contraction).map_err(|problem| problem.in_field("points"))?;
        }
        if !self.points.is_empty() {
            return Ok(self.points.clone());
        }
        let is_load = self.load.load.is_some();
        let force_n = match is_load {
            true => 1.0,
            false => {
                given("force_n", self.force_n, "a force, such as 300 N").map_err(|problem| {
                    problem.with_hint("or give what it lifts (`load`), or turns (`torques`)")
                })?
            }
        };
        let contraction = match (self.contraction, self.stroke_mm) {
            (Some(e), _) => ratio(e.0)?,
            (None, Some(_)) => 0.0,
            (None, None) => {
                let (field, expected, other) = match is_load {
                    true => (
                        "stroke_mm",
                        "the lift of the load, such as 40 mm",
                        "or give `contraction`, such as 0.15 (15 %)",
                    ),
                    false => (
                        "contraction",
                        "a ratio such as 0.15 (15 %)",
                        "or give `stroke_mm`, such as 40 mm",
                    ),
                };
                return Err(Problem::missing(field, expected).with_hint(other));
            }
        };
        Ok(vec![OperatingPoint {
            force_n,
            contraction,
        }])
    }

    /// The muscle around the search.
    fn base(&self) -> Result<Muscle> {
        let mut fields = MuscleFields {
            file: self.file().cloned(),
            stiffness: self.stiffness,
            with: self.with.clone(),
            ..MuscleFields::default()
        };
        match &self.length_mm {
            Some(Choice::One(length)) => fields.measures.set(&LENGTH, length.0),
            Some(_) if self.stroke_mm.is_some() && !self.length_is_searched() => {
                let why =
                    "`stroke_mm` and a contraction set the length: give one of the three less";
                let problem = ProblemKind::Specification.problem(why);
                return Err(problem.in_field("length_mm"));
            }
            _ => {}
        }
        fields.resolve_for(&self.model.choose()?)
    }

    /// The length in mm that a stroke and the largest contraction set.
    fn length_of(&self, stroke_mm: f64, points: &[OperatingPoint], base: &Muscle) -> Result<f64> {
        let largest = peak(points.iter().map(|q| q.contraction.abs()));
        if self.length_mm.is_some() {
            let length = base.length_mm();
            let have = largest * length;
            return Err(Problem::new(
                ProblemKind::Specification,
                format!(
                    "{stroke_mm}\u{a0}mm, `length_mm` {length}\u{a0}mm and a contraction are too \
                     many data: with that length the largest contraction gives {have:.2}\u{a0}mm"
                ),
                "leave out `stroke_mm`, `length_mm` or the contraction",
            )
            .in_field("stroke_mm"));
        }
        if largest <= 0.0 {
            let why = "a stroke needs a contraction above zero";
            return Err(ProblemKind::Specification.problem(why));
        }
        Ok(stroke_mm / largest)
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
fn values<Q: Quantity>(choice: &Option<Choice<Q>>, field: &str) -> Result<Option<Values>> {
    let wrong = |why: String| Err(ProblemKind::Range.problem(why).in_field(field));
    let list = match choice {
        None => return Ok(None),
        Some(Choice::One(value)) => std::slice::from_ref(value),
        Some(Choice::Several(list)) if list.is_empty() => return wrong("the list is empty".into()),
        Some(Choice::Several(list)) => list,
        Some(Choice::Between { low, high }) => {
            let [low, high] = [finite(field, *low)?, finite(field, *high)?];
            if low > high {
                return wrong(format!(
                    "the interval from {low} to {high} is reversed: write the smaller value first"
                ));
            }
            return Ok(Some(Values::Interval(low, high)));
        }
    };
    let list = list.iter().map(|&value| finite(field, value));
    Ok(Some(Values::List(list.collect::<Result<_>>()?)))
}
