//! The list of laws. A law is one file in this folder and one line in the list below.

use super::{Biaxial, CustomLaw, LawKind, LawVisitor, Principal, RubberLaw, custom::AnyLaw};

/// The constants of a law are its fields, in this order.
macro_rules! constants_are_fields {
    ($($field:ident),+) => {
        fn from_values(values: &[f64]) -> Option<Self> {
            let &[$($field),+] = values else {
                return None;
            };
            Some(Self { $($field),+ })
        }

        fn values(&self) -> Vec<f64> {
            vec![$(self.$field),+]
        }
    };
}

/// From `file::Type` of every law: the modules, the enum [`Law`] and what goes to the law that it
/// holds.
macro_rules! laws {
    ($($file:ident::$law:ident),* $(,)?) => {
        $(
            mod $file;
            pub use $file::$law;
        )*

        /// Any of the laws, for data that is read at run time. Kernels are generic over
        /// [`RubberLaw`]: take the law apart once, outside the quadrature loop
        /// ([`RubberLaw::visit`]).
        #[derive(Debug, Clone, PartialEq)]
        #[non_exhaustive]
        pub enum Law {
            $(#[doc(hidden)] $law($law),)*
            /// A law of your own ([`Law::custom`]).
            #[doc(hidden)]
            Custom(CustomLaw),
        }

        $(
            impl From<$law> for Law {
                fn from(law: $law) -> Law {
                    Law::$law(law)
                }
            }
        )*

        impl Law {
            /// All laws, without the values of their constants.
            #[doc(hidden)]
            pub const KINDS: &'static [LawKind] = &[$(LawKind::new::<$law>()),*];

            /// The law without the values of its constants.
            #[doc(hidden)]
            pub fn kind(&self) -> &'static LawKind {
                match self {
                    $(Law::$law(_) => const { &LawKind::new::<$law>() },)*
                    Law::Custom(law) => law.0.kind(),
                }
            }

            fn any(&self) -> &dyn AnyLaw {
                match self {
                    $(Law::$law(law) => law,)*
                    Law::Custom(law) => &*law.0,
                }
            }

            /// The values of the constants, in the order of [`Law::constants`].
            pub fn values(&self) -> Vec<f64> {
                self.any().values()
            }

            /// See [`locks_at`](crate::rubber::LawConstants::locks_at).
            pub fn locks_at(&self) -> Option<f64> {
                self.any().locks_at()
            }
        }

        impl RubberLaw for Law {
            fn shear_modulus_mpa(&self) -> f64 {
                self.any().shear_modulus_mpa()
            }

            fn principal(&self, stretches: [f64; 3]) -> Principal {
                self.any().principal(stretches)
            }

            fn biaxial(&self, u: f64, v: f64) -> Biaxial {
                self.any().biaxial(u, v)
            }

            /// Hands `visitor` the law that it holds.
            fn visit<V: LawVisitor>(&self, visitor: V) -> V::Output {
                match self {
                    $(Law::$law(law) => law.visit(visitor),)*
                    Law::Custom(law) => law.visit(visitor),
                }
            }
        }
    };
}

laws! {
    mooney_rivlin::MooneyRivlin,
    neo_hookean::NeoHookean,
    yeoh::Yeoh,
    ogden::Ogden,
    gent::Gent,
    arruda_boyce::ArrudaBoyce,
    extended_tube::ExtendedTube,
}
