//! The muscles of a specification, one after the other: tubes × sleeves × rubbers × lengths ×
//! pulleys. An interval is a grid of round values.

use crate::{BraidChoice, Demand, Lift, Spec, TubePart};
use mckibben_core::{
    muscle::{Braid, Muscle, MuscleError, Parts, Tube},
    units::{Values, tidy},
};

/// Steps of an interval, at most about so many.
const DIAMETERS: usize = 80;
const WALLS: usize = 20;
const ANGLES: usize = 8;
const LENGTHS: usize = 8;
const RADII: usize = 30;
/// Lengths of which a stroke is a share: in equal ratios.
const STROKE_STEPS: i32 = 6;
/// Least bore over the outer diameter of a free section: half of that of the thickest tube that is
/// sold.
const LEAST_BORE: f64 = 0.25;

/// Which braid a muscle has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BraidRule {
    /// An angle in degrees.
    Angle(f64),
    /// A length of strand per turn in mm.
    PerTurn(f64),
    /// A sleeve of the list.
    Sleeve(usize),
}

/// The section of a tube.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// The tube as sold or cast, where such are searched.
    tube: Option<usize>,
    rubber: usize,
    outer_diameter_mm: f64,
    wall_mm: f64,
}

/// A muscle of the list; it is built when it is needed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    pub section: Section,
    pub braid: BraidRule,
    pub length_mm: f64,
}

/// All muscles of a specification.
pub fn places(spec: &Spec, lengths: &[f64]) -> Vec<Place> {
    let braids = braids(&spec.braid);
    let mut places = vec![];
    for section in sections(spec) {
        let mut last_mm = 0.0;
        for &length_mm in lengths {
            // In place of lengths that its ends do not allow a tube has the shortest that they do.
            let least_mm = spec.least_slenderness * section.outer_diameter_mm;
            let is_longest = lengths.last() == Some(&length_mm);
            let length_mm = match length_mm < least_mm {
                true if spec.tubes.is_empty() || is_longest => continue,
                true => least_mm,
                false => length_mm,
            };
            if length_mm == last_mm {
                continue;
            }
            last_mm = length_mm;
            let place = |&braid: &BraidRule| Place {
                section,
                braid,
                length_mm,
            };
            places.extend(braids.iter().map(place));
        }
    }
    places
}

fn sections(spec: &Spec) -> Vec<Section> {
    if !spec.tubes.is_empty() {
        let of_tube = |(i, tube): (usize, &TubePart)| Section {
            tube: Some(i),
            rubber: 0,
            outer_diameter_mm: tube.outer_diameter_mm,
            wall_mm: tube.wall_mm,
        };
        return spec.tubes.iter().enumerate().map(of_tube).collect();
    }
    let diameters = grid(&spec.outer_diameter_mm, DIAMETERS);
    let walls = grid(&spec.wall_mm, WALLS);
    let is_free = matches!(spec.outer_diameter_mm, Values::Interval(..));
    let has_bore = |d0: f64, s: f64| !is_free || 2.0 * s <= (1.0 - LEAST_BORE) * d0 * (1.0 + 1e-9);
    let mut sections = vec![];
    for rubber in 0..spec.rubbers.len().max(1) {
        for &wall_mm in &walls {
            sections.extend(diameters.iter().filter(|d0| has_bore(**d0, wall_mm)).map(
                |&outer_diameter_mm| Section {
                    tube: None,
                    rubber,
                    outer_diameter_mm,
                    wall_mm,
                },
            ));
        }
    }
    sections
}

fn braids(braid: &BraidChoice) -> Vec<BraidRule> {
    match braid {
        BraidChoice::Angle(angles) => grid(angles, ANGLES)
            .into_iter()
            .map(BraidRule::Angle)
            .collect(),
        BraidChoice::StrandLengthPerTurn(list) => {
            list.iter().copied().map(BraidRule::PerTurn).collect()
        }
        BraidChoice::Sleeves(list) => (0..list.len()).map(BraidRule::Sleeve).collect(),
    }
}

/// The lengths in mm; those of which a stroke is a share in equal ratios.
pub fn lengths(spec: &Spec) -> Vec<f64> {
    let stroke = Lift::is_stroke(&spec.wanted);
    match &spec.length_mm {
        Some(Values::Interval(low, high)) if stroke && low < high => {
            let ratio = (high / low).powf(1.0 / f64::from(STROKE_STEPS));
            let mut list = Vec::from_iter((0..=STROKE_STEPS).map(|i| tidy(low * ratio.powi(i), 2)));
            list.dedup();
            list
        }
        Some(values) => grid(values, LENGTHS),
        None => vec![spec.base.length_mm()],
    }
}

/// The radii of the pulley in mm; one that means nothing without a joint.
pub fn radii(spec: &Spec) -> Vec<f64> {
    match (&spec.radius_mm, &spec.wanted) {
        (Some(radii), Demand::Joint(_)) => grid(radii, RADII),
        (None, Demand::Joint(joint)) => vec![joint.radius_mm],
        _ => vec![0.0],
    }
}

/// The values of an axis: round ones within an interval, both ends in, in about `most` steps.
fn grid(values: &Values, most: usize) -> Vec<f64> {
    let (low, high) = match values {
        Values::List(list) => return list.clone(),
        Values::Interval(low, high) => (*low, *high),
    };
    let wide = (high - low) / most as f64;
    let step = [0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|step| *step >= wide)
        .unwrap_or(wide);
    let first = (low / step).floor() as i64 + 1;
    let between = (first..).map(|i| tidy(i as f64 * step, 6));
    let mut list = vec![low];
    list.extend(between.take_while(|v| *v < high - 1e-9).take(most + 2));
    list.extend((high > low).then_some(high));
    list
}

impl Place {
    /// That of a muscle which is on no list.
    pub fn of(muscle: &Muscle) -> Self {
        Self {
            section: Section {
                tube: None,
                rubber: 0,
                outer_diameter_mm: muscle.outer_diameter_mm(),
                wall_mm: muscle.wall_mm(),
            },
            braid: BraidRule::Angle(muscle.braid().angle_deg),
            length_mm: muscle.length_mm(),
        }
    }

    pub fn tube(self, spec: &Spec) -> Option<&TubePart> {
        self.section.tube.map(|i| &spec.tubes[i])
    }

    pub fn muscle(self, spec: &Spec) -> Result<Muscle, MuscleError> {
        let base = &spec.base;
        let d0 = self.section.outer_diameter_mm;
        let angled = |angle_deg: f64| Braid {
            angle_deg,
            ..base.braid().clone()
        };
        let braid = match (self.braid, &spec.braid) {
            (BraidRule::Angle(angle_deg), _) => angled(angle_deg),
            (BraidRule::PerTurn(length_mm), _) => angled(
                (std::f64::consts::PI * d0 / length_mm)
                    .min(1.0)
                    .asin()
                    .to_degrees(),
            ),
            (BraidRule::Sleeve(i), BraidChoice::Sleeves(list)) => {
                list[i].clone().on_diameter(d0)?
            }
            (BraidRule::Sleeve(_), _) => base.braid().clone(),
        };
        let part = self.tube(spec);
        let rubber = match part {
            Some(part) => &part.rubber,
            None => spec
                .rubbers
                .get(self.section.rubber)
                .unwrap_or(&base.tube().rubber),
        };
        let tube = Tube {
            outer_diameter_mm: d0,
            wall_mm: self.section.wall_mm,
            length_mm: self.length_mm,
            rubber: rubber.clone(),
            density_kg_per_m3: match part {
                Some(part) => part.density_kg_per_m3,
                None => base.tube().density_kg_per_m3,
            },
            ..base.tube().clone()
        };
        let muscle = Muscle::from_parts(Parts {
            tube,
            braid,
            ..base.parts().clone()
        })?
        .with_bench_of(base);
        if spec.wanted.extends() {
            muscle.check_extends()?;
        } else {
            muscle.check_contracts()?;
        }
        Ok(muscle)
    }
}
