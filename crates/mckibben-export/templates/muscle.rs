
/// Allowed and least burst pressure, Pa: no pressure in use is above the first; the second 0 where it is not known.
pub const @{ID}_LIMITS_PA: [Real; 2] = [@{allowed}, @{burst}];
/// The muscle @{name}: pressures from 0 to @{supply} Pa, contractions from @{low} to @{high}.
pub static @{ID}: Muscle<'static> = Muscle {
    length_m: @{length},
    cord_m: @{cord},
    supply_pa: @{supply},
    nodes: &[
@{lines}
    ],
    volume_m3: @{v},
    friction: @{friction},
    beyond: false,
};
