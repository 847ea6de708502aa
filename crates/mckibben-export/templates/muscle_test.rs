
#[cfg(test)]
mod tests {
    use super::*;

    /// Pressure and length; pull, its slopes, and volume of the form in double precision.
    const POINTS: [[Real; 6]; @{tested}] = @{points};

    #[test]
    fn answers_are_those_of_the_form() {
        let muscle = &@{ID};
        let near: Real = if Real::DIGITS < 10 { 1e-4 } else { 1e-12 };
        let [_, _, scales @ ..] = POINTS[0];
        for [pressure_pa, length_m, wanted @ ..] in POINTS {
            let found = [
                muscle.force_n(pressure_pa, length_m),
                muscle.stiffness_n_per_m(pressure_pa, length_m),
                muscle.force_per_pressure_m2(pressure_pa, length_m),
                muscle.volume_m3(pressure_pa, length_m),
            ];
            for ((found, wanted), scale) in found.iter().zip(&wanted).zip(&scales) {
                assert!((nearest(*found) - wanted).abs() <= near * scale.abs(), "{:?} {}", found, wanted);
            }
            let again = nearest(muscle.pressure_pa(wanted[0], length_m));
            let force_n = nearest(muscle.force_n(again, length_m));
            assert!((force_n - wanted[0]).abs() <= 10.0 * near * scales[0], "{} {}", again, pressure_pa);
        }
        assert!(muscle.force_n(-1.0, muscle.length_m).is_err());
    }
}
