//! A rubber law of your own: its energy and its constants, checked, then in every model.
//!
//! `cargo run --release -p mckibben --example own_law`

use mckibben::{Constant, InvariantDerivatives, InvariantLaw, LawConstants, check_law, prelude::*};
use std::error::Error;

/// Davidson and Goulbourne's energy without its entanglements: W = μ/2 (I1 − 3) + b (I1 − 3)⁴.
#[derive(Debug)]
struct Stiffening {
    mu_mpa: f64,
    b_mpa: f64,
}

impl InvariantLaw for Stiffening {
    fn invariant(&self, i1: f64, _i2: f64) -> InvariantDerivatives {
        let x = i1 - 3.0;
        InvariantDerivatives {
            w: 0.5 * self.mu_mpa * x + self.b_mpa * x.powi(4),
            w1: 0.5 * self.mu_mpa + 4.0 * self.b_mpa * x.powi(3),
            w11: 12.0 * self.b_mpa * x.powi(2),
            ..Default::default()
        }
    }
}

impl LawConstants for Stiffening {
    const NAME: &'static str = "stiffening";
    const CONSTANTS: &'static [Constant] = &[
        Constant::modulus("mu", "the shear modulus"),
        Constant::modulus("b", "the modulus of large stretches"),
    ];
    const EXAMPLE: &'static [f64] = &[0.2, 0.001];

    fn from_values(values: &[f64]) -> Option<Self> {
        let &[mu_mpa, b_mpa] = values else {
            return None;
        };
        Some(Self { mu_mpa, b_mpa })
    }

    fn values(&self) -> Vec<f64> {
        vec![self.mu_mpa, self.b_mpa]
    }
}

/// The prototype of such a rubber.
fn muscle_of(b_mpa: f64) -> Result<Muscle, Box<dyn Error>> {
    let law = Law::custom(Stiffening {
        mu_mpa: 0.224,
        b_mpa,
    });
    check_law(&law)?;
    Ok(Muscle::prototype().with_rubber(Rubber::new(law))?)
}

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    for name in ["fe", "thick-wall"] {
        let model: Model = name.parse()?;
        let stiff = model.of(&muscle_of(0.01)?)?.force_n(0.25, 0.10)?;
        let paper = model.of(&Muscle::prototype())?.force_n(0.25, 0.10)?;
        println!("{name}: {stiff:.1} N, of the paper's rubber {paper:.1} N");
        assert!(stiff < paper);
    }
    // Without its last term it is the paper's rubber: neo-Hookean with C10 = μ/2.
    let same = Model::FE.of(&muscle_of(0.0)?)?.force_n(0.25, 0.10)?;
    let paper = Model::FE.of(&Muscle::prototype())?.force_n(0.25, 0.10)?;
    assert!((same / paper - 1.0).abs() < 1e-8, "{same} {paper}");
    // Its constants have derivatives.
    let mut model = Model::FE.of(&muscle_of(0.01)?)?;
    let by = model
        .gradient(0.25, 0.10, &["tube.material.b"])?
        .by_parameters[0];
    assert!(by < 0.0, "{by}");
    Ok(())
}
