//! A law of your own.

use super::{Biaxial, Law, LawConstants, LawKind, Principal, RubberLaw};
use std::{fmt, sync::Arc};

/// A law that is not one of the list, by its own type behind a pointer. Two are the same where
/// their names and constants are.
#[derive(Clone)]
pub struct CustomLaw(pub(super) Arc<dyn AnyLaw>);

impl Law {
    /// A law of your own as the law of a rubber.
    ///
    /// The type has its energy ([`InvariantLaw`](super::InvariantLaw) in I1 and I2, or [`RubberLaw`]
    /// in the principal stretches) and its constants ([`LawConstants`]), as the laws of this library
    /// have. Every model, design and identification then takes it; the name must be that of no other
    /// law. A muscle file can write it, but nothing reads it back.
    ///
    /// [`check_law`](super::check_law) finds an energy whose derivatives are wrong.
    ///
    /// ```
    /// use mckibben_core::{model::*, muscle::{Muscle, Rubber}, rubber::*};
    ///
    /// /// W = μ/2 (I1 − 3) + b (I1 − 3)⁴
    /// #[derive(Debug)]
    /// struct Stiffening { mu_mpa: f64, b_mpa: f64 }
    ///
    /// impl InvariantLaw for Stiffening {
    ///     fn invariant(&self, i1: f64, _i2: f64) -> InvariantDerivatives {
    ///         let x = i1 - 3.0;
    ///         InvariantDerivatives {
    ///             w: 0.5 * self.mu_mpa * x + self.b_mpa * x.powi(4),
    ///             w1: 0.5 * self.mu_mpa + 4.0 * self.b_mpa * x.powi(3),
    ///             w11: 12.0 * self.b_mpa * x.powi(2),
    ///             ..Default::default()
    ///         }
    ///     }
    /// }
    ///
    /// impl LawConstants for Stiffening {
    ///     const NAME: &'static str = "stiffening";
    ///     const CONSTANTS: &'static [Constant] = &[
    ///         Constant::modulus("mu", "the shear modulus"),
    ///         Constant::modulus("b", "the fourth-order modulus"),
    ///     ];
    ///     const EXAMPLE: &'static [f64] = &[0.2, 0.001];
    ///     fn from_values(values: &[f64]) -> Option<Self> {
    ///         let &[mu_mpa, b_mpa] = values else { return None };
    ///         Some(Self { mu_mpa, b_mpa })
    ///     }
    ///     fn values(&self) -> Vec<f64> {
    ///         vec![self.mu_mpa, self.b_mpa]
    ///     }
    /// }
    ///
    /// let law = Law::custom(Stiffening { mu_mpa: 0.2, b_mpa: 0.001 });
    /// check_law(&law)?;
    /// let muscle = Muscle::prototype().with_rubber(Rubber::new(law))?;
    /// let model = ModelKind::ThickWall.build(&muscle)?;
    /// assert!(model.force_n(&mut Workspace::new(), 0.25, 0.1)? > 400.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn custom<L>(law: L) -> Self
    where
        L: LawConstants + fmt::Debug + Send + 'static,
    {
        Self::Custom(CustomLaw(Arc::new(law)))
    }
}

/// [`LawConstants`] of a value whose type is not known.
pub(super) trait AnyLaw: RubberLaw + fmt::Debug + Send {
    fn kind(&self) -> &'static LawKind;
    fn values(&self) -> Vec<f64>;
    fn locks_at(&self) -> Option<f64>;
}

impl<L: LawConstants + fmt::Debug + Send + 'static> AnyLaw for L {
    fn kind(&self) -> &'static LawKind {
        const { &LawKind::custom::<L>() }
    }

    fn values(&self) -> Vec<f64> {
        LawConstants::values(self)
    }

    fn locks_at(&self) -> Option<f64> {
        LawConstants::locks_at(self)
    }
}

impl fmt::Debug for CustomLaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl PartialEq for CustomLaw {
    fn eq(&self, other: &Self) -> bool {
        self.0.kind() == other.0.kind() && self.0.values() == other.0.values()
    }
}

impl RubberLaw for CustomLaw {
    fn shear_modulus_mpa(&self) -> f64 {
        self.0.shear_modulus_mpa()
    }

    fn principal(&self, stretches: [f64; 3]) -> Principal {
        self.0.principal(stretches)
    }

    fn biaxial(&self, u: f64, v: f64) -> Biaxial {
        self.0.biaxial(u, v)
    }
}
