//! Names of fields, and the units that they carry: a quantity has its unit at the end of its name
//! (`pressure_mpa`).
//!
//! This is the one table of it. Schemas, documentation and the Python package have their units from
//! here.

use super::dimension::Dimension;

/// Ends of names of what is answered only, in no unit that a user types.
const ANSWERED: &[(&str, &str)] = &[
    ("n_per_mpa", "N/MPa"),
    ("mm3_per_mpa", "mm³/MPa"),
    ("n_per_unit", "N per unit"),
    ("mm_per_s", "mm/s"),
    ("deg_per_s", "°/s"),
    ("j", "J"),
    ("w", "W"),
    ("g", "g"),
    ("normal_litres", "normal L"),
    ("normal_litres_per_cycle", "normal L"),
    ("normal_litres_per_min", "normal L/min"),
];

/// Names without a unit at their end that are a quantity all the same, as whole names or as the
/// last word of one.
const RATIOS: [&str; 4] = ["contraction", "contractions", "strain", "uncertainty"];
/// A number in N/mm, or a name.
const STIFFNESS: &str = "stiffness";

/// The unit of a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NamedUnit {
    /// The unit's usual spelling; empty for a plain ratio.
    pub unit: &'static str,
    /// What it measures, where a text with another unit is accepted too.
    pub dimension: Option<Dimension>,
}

impl NamedUnit {
    fn inside(dimension: Dimension) -> Self {
        Self {
            unit: dimension.unit_inside().name,
            dimension: Some(dimension),
        }
    }

    /// The unit that a field has by its name; none where it is a plain number, or no number.
    pub fn of_field(name: &str) -> Option<Self> {
        let typed = Dimension::all().filter_map(|d| Some((d.end_of_name()?, Self::inside(d))));
        let answered = ANSWERED.iter().map(|&(end, unit)| {
            (
                end,
                Self {
                    unit,
                    dimension: None,
                },
            )
        });
        let ends = |end: &str| {
            name.strip_suffix(end)
                .is_some_and(|rest| rest.ends_with('_'))
        };
        // The longest: `_n_per_mm` ends with `_mm` too.
        typed
            .chain(answered)
            .filter(|(end, _)| ends(end))
            .max_by_key(|(end, _)| end.len())
            .map(|(_, unit)| unit)
            .or_else(|| {
                let last = name
                    .rsplit('_')
                    .find(|word| word.parse::<u32>().is_err())
                    .unwrap_or_default();
                match last {
                    _ if name == STIFFNESS => Some(Self::inside(Dimension::Stiffness)),
                    last if RATIOS.contains(&last) => Some(Self::inside(Dimension::Ratio)),
                    _ => None,
                }
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse_quantity;

    /// An identity: the end of a name is the unit inside, in which a bare number and one with the
    /// unit are the same.
    #[test]
    fn every_kind_of_quantity_is_found_by_the_end_of_a_name() {
        for dimension in Dimension::all() {
            let name = dimension
                .end_of_name()
                .map_or("contraction".to_owned(), |end| format!("some_{end}"));
            let named = NamedUnit::of_field(&name).unwrap();
            assert_eq!(named.dimension, Some(dimension), "{name}");
            assert_eq!(
                parse_quantity(&format!("1.5 {}", named.unit), dimension),
                Ok(1.5),
                "{name}"
            );
        }
    }

    #[test]
    fn the_longest_end_counts_and_a_whole_word_is_needed() {
        let unit = |name| NamedUnit::of_field(name).map(|u| u.unit);
        for (name, expected) in [
            ("slip_mm_per_n", "mm/N"),
            ("stiffness_n_per_mm", "N/mm"),
            ("force_per_pressure_n_per_mpa", "N/MPa"),
            ("volume_per_pressure_mm3_per_mpa", "mm³/MPa"),
            ("volume_per_contraction_mm3", "mm3"),
            ("stiffness_nm_per_rad", "N m/rad"),
            ("damping_n_s_per_m", "N s/m"),
            ("torque_turning_minus_nm", "N m"),
            ("strand_length_per_turn_mm", "mm"),
            ("sonic_conductance_l_per_s_bar", "L/(s bar)"),
            ("velocity_deg_per_s", "°/s"),
            ("contraction_2", ""),
            ("max_strand_strain", ""),
            ("stiffness", "N/mm"),
        ] {
            assert_eq!(unit(name), Some(expected), "{name}");
        }
        for name in [
            "turns",
            "columns",
            "n",
            "mm",
            "summ",
            "is_open",
            "at_neutral",
            "length_um",
            "1",
            "",
        ] {
            assert_eq!(unit(name), None, "{name}");
        }
    }
}
