//! Relations between the measures of a muscle, which the bounds of each alone do not give.

use super::{MuscleError, Parts, Terminals};
use std::f64::consts::PI;

/// Thinner than one fibre of carbon or glass, in mm.
const THINNEST_STRAND_MM: f64 = 0.003;

impl Parts {
    /// Checks each part, and the parts against each other.
    pub fn check_together(&self) -> Result<(), MuscleError> {
        let (tube, braid) = (&self.tube, &self.braid);
        self.check("tube")?;
        tube.check()?;
        braid.check()?;
        self.check("braid")?;
        braid.check_crimp()?;
        self.check("terminals")?;
        self.terminals.check()?;
        let length_mm = tube.length_mm;
        if let Some(strand) = braid.measured {
            let strand_mm = strand.strand_length_mm;
            MuscleError::unless(strand_mm > length_mm, ["braid.strand_length"], || {
                format!(
                    "braid.strand_length is {strand_mm}\u{a0}mm, not above the muscle's length of \
                     {length_mm}\u{a0}mm, which it must span slantwise"
                )
            })?;
        }
        self.check("friction")?;
        let without = self
            .friction
            .is_some_and(|f| f.presliding_mm.is_some() && f.is_zero());
        MuscleError::unless(!without, ["friction.presliding"], || {
            "friction.presliding needs the friction itself: friction.lever, or \
             friction.coefficient and friction.exponent"
                .into()
        })?;
        braid.check_on(tube)?;
        self.check_ends()?;
        self.check_strand_section()
    }

    /// Seating and grip leave a free length; the plugs close the bore, and the braid widens to the
    /// tube on them.
    fn check_ends(&self) -> Result<(), MuscleError> {
        let length_mm = self.tube.length_mm;
        let seating_mm = self.terminals.seating_mm.unwrap_or(0.0);
        let grip_mm = self.terminals.grip_mm.unwrap_or(0.0);
        MuscleError::unless(
            seating_mm < length_mm,
            ["terminals.seating", "tube.length"],
            || {
                format!(
                    "terminals.seating is {seating_mm}\u{a0}mm; it must be below the muscle's \
                     length of {length_mm}\u{a0}mm"
                )
            },
        )?;
        MuscleError::unless(
            seating_mm + 2.0 * grip_mm < length_mm,
            ["terminals.grip", "tube.length"],
            || {
                format!(
                    "terminals.grip is {grip_mm}\u{a0}mm at each end; twice that, with a seating \
                     of {seating_mm}\u{a0}mm, must be below the muscle's length of \
                     {length_mm}\u{a0}mm"
                )
            },
        )?;
        let plug_mm = 2.0 * self.plug_radius_mm();
        let bore_mm = 2.0 * self.tube.inner_radius_mm();
        let (least, largest) = Terminals::PLUG_OF_BORE;
        MuscleError::unless(
            (least * bore_mm..=largest * bore_mm).contains(&plug_mm),
            ["terminals.plug_diameter", "tube.outer_diameter"],
            || {
                format!(
                    "terminals.plug_diameter is {plug_mm}\u{a0}mm, and the bore of the tube \
                     {bore_mm}\u{a0}mm: a plug has between half of the bore and twice the bore"
                )
            },
        )?;
        let braid = &self.braid;
        let clamped_mm = self.clamped_radius_mm();
        MuscleError::unless(
            braid.angle_rad().sin() * clamped_mm / self.tube.outer_radius_mm() < 1.0,
            ["terminals.plug_diameter", "braid.angle"],
            || {
                format!(
                    "terminals.plug_diameter is {plug_mm}\u{a0}mm; a braid with an angle of {} \
                     degrees does not widen to the tube on it, with an outer diameter of \
                     {:.1}\u{a0}mm: take a narrower plug",
                    braid.angle_deg,
                    2.0 * clamped_mm
                )
            },
        )
    }

    /// A strand is thicker than a fibre, and thinner than the tube.
    fn check_strand_section(&self) -> Result<(), MuscleError> {
        const FIELDS: [&str; 2] = ["braid.strand_diameter", "braid.strand_area"];
        let strand_mm = self
            .braid
            .strands
            .and_then(|s| s.area_mm2)
            .map_or(0.0, |area| (4.0 * area / PI).sqrt());
        let outer_mm = self.tube.outer_diameter_mm;
        MuscleError::unless(
            strand_mm == 0.0 || strand_mm >= THINNEST_STRAND_MM,
            FIELDS,
            || {
                format!(
                    "braid: a strand of {strand_mm:.2e} mm is thinner than a single fibre; is its \
                     unit mm (or mm2)?"
                )
            },
        )?;
        MuscleError::unless(strand_mm <= outer_mm, FIELDS, || {
            format!(
                "braid: a strand of {strand_mm:.4} mm is thicker than the tube, which has \
                 {outer_mm} mm; is its unit mm (or mm2)?"
            )
        })
    }
}
