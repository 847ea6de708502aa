
/// The muscle @{name}: pressures from 0 to @{supply} Pa, contractions from @{low} to @{high}.
pub static @{ID}: Muscle = Muscle {
    length_m: @{length},
    cord_m: @{cord},
    supply_pa: @{supply},
    nodes: &[
@{nodes}
    ],
    volume_m3: @{volume},
    friction_n: @{friction},
    presliding_m: @{presliding},
    beyond: false,
};
