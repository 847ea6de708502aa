
/// The joint @{name}.
pub static @{ID}: Joint<@{count}> = Joint {
    muscles: [@{muscles}],
    paths: @{paths},
    rope: @{rope},
    torsion: @{torsion},
    weight: @{weight},
    range_rad: @{range},
};

#[cfg(test)]
mod tests {
    use super::*;

    /// The pressures for a torque give it, and what lies outside of the range is refused.
    #[test]
    fn pressures_give_the_torque() {
        let joint = &@{ID};
        let near: Real = if Real::DIGITS < 10 { 1e-3 } else { 1e-9 };
        let [low, high] = joint.range_rad;
        for share in [0.3, 0.5, 0.7] {
            let angle_rad = low + share * (high - low);
            let [least_nm, most_nm] = joint.limits_nm(angle_rad);
            let wanted_nm = 0.5 * (least_nm + most_nm);
            let pressures_pa = nearest(joint.pressures_pa(angle_rad, wanted_nm, None));
            let torque_nm = nearest(joint.torque_nm(pressures_pa, angle_rad));
            assert!((torque_nm - wanted_nm).abs() <= near * (most_nm - least_nm), "{} {}", torque_nm, wanted_nm);
            assert!(joint.pressures_pa(angle_rad, most_nm + 1.0, None).is_err());
        }
        assert!(joint.torque_nm([0.0; @{count}], high + 1.0).is_err());
    }
}
