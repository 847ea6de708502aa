//! The integrator: its constants, its order and a stiff reaction.

use mckibben_motion::integrate::{ERROR, Equations, GAMMA, STAGES, Stepper, cubic, weights};
use nalgebra::Matrix3;

/// Exact: b = ((16 − √6)/36, (16 + √6)/36, 1/9) over the whole step, and monomials up to the
/// second power over a part of it.
#[test]
fn weights_are_those_of_the_collocation() {
    let root = 6.0_f64.sqrt();
    let b = [(16.0 - root) / 36.0, (16.0 + root) / 36.0, 1.0 / 9.0];
    assert!(
        weights(1.0)
            .iter()
            .zip(b)
            .all(|(w, b)| (w - b).abs() < 1e-15)
    );
    for share in [0.2_f64, 0.5, 0.9] {
        for power in 0..3 {
            let sum: f64 = weights(share)
                .iter()
                .zip(STAGES)
                .map(|(w, c)| w * c.powi(power))
                .sum();
            assert!((sum - share.powi(power + 1) / f64::from(power + 1)).abs() < 1e-15);
        }
    }
}

/// ẍ = −x with the quadratures ∫ x² dt and ∫ x dt: at t they are (t + sin t cos t)/2 and sin t.
struct Swing;

impl Equations for Swing {
    fn core(&self) -> usize {
        2
    }

    fn implicit(&self) -> usize {
        2
    }

    fn scales(&self) -> &[f64] {
        &[1.0; 4]
    }

    fn rates(&self, _: f64, y: &[f64], rates: &mut [f64]) {
        rates.copy_from_slice(&[y[1], -y[0], y[0] * y[0], y[0]]);
    }

    fn differences(&self, _: Option<&[f64]>) {}

    fn near(&self, _: bool) {}
}

#[test]
fn quadratures_are_the_integrals_at_the_end_and_within_a_step() {
    let mut at = Stepper::new(&Swing, (0.0, 3.0), &[1.0, 0.0, 0.0, 0.0], 1e-9, None);
    let exact = |t: f64| [t.cos(), -t.sin(), 0.5 * (t + t.sin() * t.cos()), t.sin()];
    let near = |y: &[f64], t: f64, most: f64| {
        let off = y
            .iter()
            .zip(exact(t))
            .map(|(y, e)| (y - e).abs())
            .fold(0.0, f64::max);
        assert!(off < most, "{t}: {off:e}");
    };
    while at.time() < 3.0 {
        let from = at.time();
        if at.step(&Swing, 3.0) {
            let middle = 0.5 * (from + at.time());
            near(at.state(), at.time(), 1e-7);
            near(&at.within(middle).unwrap(), middle, 1e-6);
        }
    }
}

/// The pendulum ẍ = −sin x, which is released at rest.
struct Pendulum;

impl Equations for Pendulum {
    fn core(&self) -> usize {
        2
    }

    fn implicit(&self) -> usize {
        2
    }

    fn scales(&self) -> &[f64] {
        &[1.0; 2]
    }

    fn rates(&self, _: f64, y: &[f64], rates: &mut [f64]) {
        rates.copy_from_slice(&[y[1], -y[0].sin()]);
    }

    fn differences(&self, _: Option<&[f64]>) {}

    fn near(&self, _: bool) {}
}

/// A rate of convergence: with steps of half the length the error is 2⁻⁵ of that before.
#[test]
fn steps_of_half_the_length_err_by_a_thirty_second() {
    let end_with = |steps: u32| {
        let h = 2.0 / f64::from(steps);
        let mut y = vec![2.0, 0.0];
        for i in 0..steps {
            let from = h * f64::from(i);
            let mut one = Stepper::new(&Pendulum, (from, from + h), &y, 1.0, Some(h));
            one.newton = 1e-11;
            assert!(one.step(&Pendulum, from + h));
            y = one.state().to_vec();
        }
        y[0]
    };
    let exact = end_with(256);
    let errors: Vec<f64> = [8, 16, 32]
        .map(|steps| (end_with(steps) - exact).abs())
        .into();
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((4.7..5.6).contains(&order), "{errors:?}: order {order}");
    }
}

/// Robertson's reaction, whose rates differ by nine orders of magnitude.
struct Reaction;

impl Equations for Reaction {
    fn core(&self) -> usize {
        3
    }

    fn implicit(&self) -> usize {
        3
    }

    fn scales(&self) -> &[f64] {
        &[1e-2, 1e-6, 1e-2]
    }

    fn rates(&self, _: f64, y: &[f64], rates: &mut [f64]) {
        let forth = 0.04 * y[0] - 1e4 * y[1] * y[2];
        let on = 3e7 * y[1] * y[1];
        rates.copy_from_slice(&[-forth, forth - on, on]);
    }

    fn differences(&self, _: Option<&[f64]>) {}

    fn near(&self, _: bool) {}
}

/// Reference: Hindmarsh 1980, y(40) of Robertson's problem; the sum of the three is kept.
#[test]
fn robertsons_stiff_reaction_is_that_of_the_literature_in_few_steps() {
    let mut at = Stepper::new(&Reaction, (0.0, 40.0), &[1.0, 0.0, 0.0], 1e-9, None);
    let mut steps = 0;
    while at.time() < 40.0 {
        at.step(&Reaction, 40.0);
        steps += 1;
    }
    let expected = [7.158_271e-1, 9.185_5e-6, 2.841_637e-1];
    for (y, expected) in at.state().iter().zip(expected) {
        assert!((y / expected - 1.0).abs() < 1e-5, "{:?}", at.state());
    }
    assert!((at.state().iter().sum::<f64>() - 1.0).abs() < 1e-13);
    assert!(steps < 200, "{steps} steps");
}

/// Identities: A⁻¹ of the tableau has the eigenvalue 1/γ0, and the polynomial through the
/// stages has the values it is made of.
#[test]
fn the_constants_are_those_of_the_collocation() {
    let inverse = Matrix3::from_fn(|i, j| cubic(j, STAGES[i]).1);
    let root = 6.0_f64.sqrt();
    let tableau = Matrix3::new(
        (88.0 - 7.0 * root) / 360.0,
        (296.0 - 169.0 * root) / 1800.0,
        (-2.0 + 3.0 * root) / 225.0,
        (296.0 + 169.0 * root) / 1800.0,
        (88.0 + 7.0 * root) / 360.0,
        (-2.0 - 3.0 * root) / 225.0,
        (16.0 - root) / 36.0,
        (16.0 + root) / 36.0,
        1.0 / 9.0,
    );
    assert!((inverse * tableau - Matrix3::identity()).norm() < 1e-13);
    let shifted = inverse - Matrix3::identity() / GAMMA;
    assert!(shifted.determinant().abs() < 1e-10);
    assert!((ERROR[0] + (13.0 + 7.0 * root) / 3.0).abs() < 1e-14);
    assert!((ERROR[1] + (13.0 - 7.0 * root) / 3.0).abs() < 1e-14);
}
