//! The muscles of a specification, one after the other: tubes × sleeves × rubbers × lengths ×
//! pulleys. An interval is a grid of round values.

use crate::{BraidChoice, Demand, Spec, TubePart};
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

/// A muscle of the list; it is built when it is needed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// The tube as sold or cast, where such are searched.
    tube: Option<usize>,
    rubber: usize,
    outer_diameter_mm: f64,
    wall_mm: f64,
    /// The sleeve of the list; without one the base muscle's braid has this angle.
    sleeve: Option<usize>,
    angle_deg: f64,
    length_mm: f64,
}

/// All muscles of a specification.
pub fn places(spec: &Spec, lengths: &[f64]) -> Vec<Place> {
    let mut places = vec![];
    for section in sections(spec) {
        let braided = braids(&spec.braid, section);
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
            places.extend(braided.iter().map(|&place| Place { length_mm, ..place }));
        }
    }
    places
}

/// The tubes of all muscles, each with the base muscle's length and angle.
fn sections(spec: &Spec) -> Vec<Place> {
    let base = Place::of(&spec.base);
    if !spec.tubes.is_empty() {
        let of_tube = |(i, tube): (usize, &TubePart)| Place {
            tube: Some(i),
            outer_diameter_mm: tube.outer_diameter_mm,
            wall_mm: tube.wall_mm,
            ..base
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
            let wide = diameters.iter().filter(|d0| has_bore(**d0, wall_mm));
            sections.extend(wide.map(|&outer_diameter_mm| Place {
                rubber,
                outer_diameter_mm,
                wall_mm,
                ..base
            }));
        }
    }
    sections
}

/// A tube with each of the braids.
fn braids(braid: &BraidChoice, tube: Place) -> Vec<Place> {
    let turn_mm = std::f64::consts::PI * tube.outer_diameter_mm;
    let angles = match braid {
        BraidChoice::Angle(angles) => grid(angles, ANGLES),
        BraidChoice::StrandLengthPerTurn(list) => {
            let angle_deg = |per_mm: &f64| (turn_mm / per_mm).min(1.0).asin().to_degrees();
            list.iter().map(angle_deg).collect()
        }
        BraidChoice::Sleeves(list) => {
            let with = |i| Place {
                sleeve: Some(i),
                ..tube
            };
            return (0..list.len()).map(with).collect();
        }
    };
    let at = |angle_deg| Place { angle_deg, ..tube };
    angles.into_iter().map(at).collect()
}

/// The lengths in mm; those of which a stroke is a share in equal ratios.
pub fn lengths(spec: &Spec) -> Vec<f64> {
    let stroke = matches!(spec.wanted, Demand::Stroke { .. });
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
    let joint = spec.wanted.joint();
    joint.map_or(vec![0.0], |joint| grid(&joint.radii_mm, RADII))
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
            tube: None,
            rubber: 0,
            outer_diameter_mm: muscle.outer_diameter_mm(),
            wall_mm: muscle.wall_mm(),
            sleeve: None,
            angle_deg: muscle.braid().angle_deg,
            length_mm: muscle.length_mm(),
        }
    }

    pub fn tube(self, spec: &Spec) -> Option<&TubePart> {
        self.tube.map(|i| &spec.tubes[i])
    }

    pub fn muscle(self, spec: &Spec) -> Result<Muscle, MuscleError> {
        let base = &spec.base;
        let braid = match (self.sleeve, &spec.braid) {
            (Some(i), BraidChoice::Sleeves(list)) => {
                list[i].clone().on_diameter(self.outer_diameter_mm)?
            }
            _ => Braid {
                angle_deg: self.angle_deg,
                ..base.braid().clone()
            },
        };
        let part = self.tube(spec);
        let rubber = match part {
            Some(part) => &part.rubber,
            None => spec.rubbers.get(self.rubber).unwrap_or(&base.tube().rubber),
        };
        let tube = Tube {
            outer_diameter_mm: self.outer_diameter_mm,
            wall_mm: self.wall_mm,
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
