//! What somebody states of a muscle, in a file or in a request, in place of what another muscle
//! has.

use super::{
    Braid, BraidStiffness, EndFactor, EndsMade, Measure, Muscle, Parts, Rubber, Strands, Terminals,
    braid::NEEDS_STRANDS,
    error::{MuscleError, positive},
    measures::{
        ANGLE, MeasureValues, SECTIONS, SLEEVE_DIAMETER, STIFFNESS_FACTOR, STRAND_AREA,
        STRAND_MODULUS, STRAND_STRENGTH, STRANDS, STRANDS_FACTOR, STRANDS_PER_CARRIER,
        STRENGTH_FACTOR,
    },
};
use crate::sleeve::Sleeve;
use std::f64::consts::PI;

/// What is stated of a muscle.
#[derive(Debug, Clone, Default)]
pub struct Stated {
    /// Its measures, but for the stiffness.
    pub measures: MeasureValues,
    /// The rubber.
    pub rubber: Option<Rubber>,
    /// The sleeve that its braid is cut from.
    pub sleeve: Option<Sleeve>,
    /// Stiffness of one strand family.
    pub stiffness: Option<BraidStiffness>,
    /// Diameter of a round strand in mm, in place of its cross-section.
    pub strand_diameter_mm: Option<f64>,
    /// Whether the strands carry compression.
    pub compression: Option<bool>,
    /// Whether they lie inside of the rubber.
    pub in_rubber: Option<bool>,
    /// How the ends hold the braid.
    pub ends: Option<EndsMade>,
    /// End factor of the model tondu-lopez.
    pub end_factor: Option<EndFactor>,
}

impl Stated {
    /// The parts of a muscle with these in place of its own.
    ///
    /// # Errors
    /// [`MuscleError`] of the first that is invalid by itself, or lacks what belongs to it.
    pub fn over(&self, base: &Muscle) -> Result<Parts, MuscleError> {
        let mut parts = base.parts().clone();
        for section in SECTIONS.into_iter().filter(|section| *section != "braid") {
            self.put(section, &mut parts)?;
        }
        parts.tube.rubber = self.rubber.clone().unwrap_or(parts.tube.rubber);
        parts.braid = self.braid_on(parts.tube.outer_diameter_mm, base)?;
        let Terminals {
            made, end_factor, ..
        } = &mut parts.terminals;
        *made = self.ends.or(*made);
        *end_factor = self.end_factor.or(*end_factor);
        Ok(parts)
    }

    /// The same where they make no muscle, as far as they are known: a sleeve that does not fit has
    /// its angle on the nearest diameter that it fits.
    pub fn written_over(&self, base: &Muscle) -> Parts {
        let mut parts = base.parts().clone();
        for (measure, value) in self.measures.iter() {
            (measure.set)(&mut parts, value);
        }
        parts.tube.rubber = self.rubber.clone().unwrap_or(parts.tube.rubber);
        parts.braid.stiffness = self.stiffness.unwrap_or(parts.braid.stiffness);
        if let Some(Sleeve { shape, .. }) = &self.sleeve {
            let (least, largest) = (shape.least_mm, shape.largest_mm);
            let angle = shape.angle_deg_on(parts.tube.outer_diameter_mm.max(least).min(largest));
            parts.braid.angle_deg = angle.unwrap_or(parts.braid.angle_deg);
        }
        parts
    }

    /// Puts the measures of a table of the muscle file into the parts; the angle follows from the
    /// whole braid.
    fn put(&self, section: &str, parts: &mut Parts) -> Result<(), MuscleError> {
        for (measure, value) in self
            .measures
            .iter()
            .filter(|v| v.0.section() == section && *v.0 != ANGLE)
        {
            let lacks = |m: &Measure| self.measures.get(m).is_none() && (m.get)(parts).is_none();
            if let Some((other, needs)) = measure.beside
                && lacks(other)
            {
                return Err(MuscleError::new(
                    [other.key, measure.key],
                    format!("{} is missing; {needs}", other.key),
                ));
            }
            // A count cannot hold every number.
            measure.check(value)?;
            (measure.set)(parts, value);
        }
        Ok(())
    }

    /// The braid on a tube of a diameter: the named sleeve, or the muscle's own braid, with the
    /// angle and stiffness that are stated.
    ///
    /// # Errors
    /// As [`Stated::over`].
    pub fn braid_on(&self, outer_diameter_mm: f64, base: &Muscle) -> Result<Braid, MuscleError> {
        let mut parts = base.parts().clone();
        self.put("braid", &mut parts)?;
        // What is counted or measured is no estimate.
        for (number, factor) in [
            (&STRANDS, &STRANDS_FACTOR),
            (&STRAND_STRENGTH, &STRENGTH_FACTOR),
        ] {
            let is_known = self.measures.get(number).is_some();
            if is_known && self.measures.get(factor).is_none() {
                (factor.set)(&mut parts, 1.0);
            }
        }
        let area = self.strand_area_mm2()?;
        let has_modulus = self.measures.get(&STRAND_MODULUS).is_some();
        if has_modulus && self.stiffness.is_some() {
            return Err(MuscleError::new(
                ["braid.stiffness"],
                "give either `stiffness`, or `strands`, `strand_area` (or \
                `strand_diameter`) and `strand_modulus`; both are given",
            ));
        }
        parts.braid.compression = self.compression.unwrap_or(parts.braid.compression);
        parts.braid.in_rubber = self.in_rubber.unwrap_or(parts.braid.in_rubber);
        // Beside a stiffness the area says what openings the strands leave.
        let is_described = has_modulus || area.is_some() && self.stiffness.is_none();
        let braid = parts.braid;
        let mut braid = if let Some(sleeve) = &self.sleeve {
            self.of_sleeve(sleeve.clone(), area, braid)?
                .on_diameter(outer_diameter_mm)?
        } else {
            let braid = self.of_strands(area, is_described, braid)?;
            // An angle that was stated for this diameter stays.
            let same = outer_diameter_mm == base.outer_diameter_mm()
                && self.measures.get(&SLEEVE_DIAMETER).is_none();
            if same {
                braid
            } else {
                braid.on_diameter(outer_diameter_mm)?
            }
        };
        if let Some(angle_deg) = self.measures.get(&ANGLE) {
            braid = braid.with_stated_angle(angle_deg, outer_diameter_mm)?;
        }
        if let Some(stiffness) = self.stiffness {
            braid.stiffness = stiffness;
            braid.stiffness_factor = self.measures.get(&STIFFNESS_FACTOR).unwrap_or(1.0);
            // What it takes the place of is no longer stated.
            braid.strands = braid.strands.map(|strands| Strands {
                modulus_mpa: None,
                ..strands
            });
        }
        Ok(braid)
    }

    /// The cross-section of a strand, as an area or as the diameter of a round one.
    fn strand_area_mm2(&self) -> Result<Option<f64>, MuscleError> {
        match (self.measures.get(&STRAND_AREA), self.strand_diameter_mm) {
            (Some(_), Some(_)) => Err(MuscleError::new(
                ["braid.strand_diameter"],
                "give either `strand_area` or `strand_diameter`; both are given",
            )),
            (None, Some(d)) => {
                positive("braid.strand_diameter", d, "mm").map(|()| Some(PI * d * d / 4.0))
            }
            (area, None) => Ok(area),
        }
    }

    /// A braid with a named sleeve, whose strands are completed. Beside a stated stiffness they
    /// only inform.
    fn of_sleeve(
        &self,
        sleeve: Sleeve,
        area: Option<f64>,
        braid: Braid,
    ) -> Result<Braid, MuscleError> {
        // An area is that of one round filament, as wide as it.
        let diameter = self
            .strand_diameter_mm
            .or(area.map(|a| 2.0 * (a / PI).sqrt()));
        let count = self.measures.get(&STRANDS).map(|count| count as u32);
        let [modulus, strength] = [&STRAND_MODULUS, &STRAND_STRENGTH].map(|m| self.measures.get(m));
        let sleeve = sleeve.with_measured(count, diameter, modulus, strength);
        let (stiffness, mut strands, factor) = match self.stiffness {
            Some(stiffness) => (stiffness, sleeve.strands_beside_stiffness(), 1.0),
            None => (
                BraidStiffness::OfStrands,
                Some(sleeve.of_strands()?),
                sleeve.stiffness_factor(),
            ),
        };
        let stiffness_factor = self.measures.get(&STIFFNESS_FACTOR).unwrap_or(factor);
        if let Some(strands) = &mut strands {
            let stated = |factor: &Measure, of_sleeve: &mut f64| {
                *of_sleeve = self.measures.get(factor).unwrap_or(*of_sleeve);
            };
            stated(&STRANDS_FACTOR, &mut strands.count_factor);
            stated(&STRENGTH_FACTOR, &mut strands.strength_factor);
        }
        if let Some(strands) = &mut strands {
            // To the last bit, not by way of the diameter.
            strands.area_mm2 = area.or(strands.area_mm2);
        }
        let strands_per_carrier = self
            .measures
            .get(&STRANDS_PER_CARRIER)
            .or(sleeve.strands_per_carrier);
        Ok(Braid {
            stiffness,
            strands,
            stiffness_factor,
            strands_per_carrier,
            sleeve: Some(sleeve.shape),
            ..braid
        })
    }

    /// A braid whose strands may be stated: all that a stiffness needs, or none of it.
    fn of_strands(
        &self,
        area: Option<f64>,
        is_described: bool,
        mut braid: Braid,
    ) -> Result<Braid, MuscleError> {
        if let (Some(area), Some(strands)) = (area, &mut braid.strands) {
            strands.area_mm2 = Some(area);
        }
        let strands = braid.strands.unwrap_or(Strands::new(0, None, None));
        let needs = [
            ("braid.strands", strands.count == 0),
            ("braid.strand_modulus", strands.modulus_mpa.is_none()),
            ("braid.strand_area", strands.area_mm2.or(area).is_none()),
        ];
        if let Some((missing, _)) = needs.into_iter().find(|need| is_described && need.1) {
            let written = [
                missing,
                "braid.strand_area",
                "braid.strand_diameter",
                "braid.strand_modulus",
            ];
            return Err(MuscleError::new(
                written,
                format!("{missing} is missing; {NEEDS_STRANDS}"),
            ));
        }
        let of_each = area.or(self.measures.get(&STRAND_STRENGTH));
        if of_each.is_some() && strands.count == 0 {
            let fields = [
                "braid.strands",
                "braid.strand_strength",
                "braid.strand_area",
            ];
            return Err(MuscleError::new(
                fields,
                "braid.strands is missing; the load is shared among them",
            ));
        }
        if is_described {
            braid.stiffness = BraidStiffness::OfStrands;
        }
        Ok(braid)
    }
}
