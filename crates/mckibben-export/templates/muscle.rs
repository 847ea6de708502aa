
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
