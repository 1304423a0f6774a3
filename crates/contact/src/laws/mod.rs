//! The list of laws. The choices of scene files and the names of the literature follow from it, one line per law.

use strum::EnumCount;

use crate::law::About;
use crate::{Form, FreePair, Law, Parameter};

mod hertz;
mod hertz_damp;
mod kelvin_voigt;
mod kuwabara_kono;
mod linear_spring;
mod modified_kelvin;
mod modified_linear_viscoelastic;
mod nonlinear_viscoelastic;
mod pant_wijeyewickrema;
mod stereomechanical;
mod two_slopes;

pub use nonlinear_viscoelastic::ViscoelasticPair;

macro_rules! laws {
    ($($file:ident::$Law:ident $({ $($Other:ident),+ })?,)+) => {
        $(pub use $file::$Law;)+

        /// A contact law with its parameters, as a scene names it.
        ///
        /// The solver matches it only while a pair touches.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub enum ContactLaw {
            $(
                #[doc = concat!("See [`", stringify!($Law), "`].")]
                $Law($Law),
            )+
        }

        /// The laws of the literature by name: a force, and a formula that chooses its damping for an e.
        ///
        /// Four names share the force of [`HertzDamp`] and differ in the formula.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, EnumCount)]
        pub enum LawName {
            $(
                #[doc = concat!("See [`", stringify!($Law), "`].")]
                $Law,
                $($(
                    #[doc = concat!("[`", stringify!($Law), "`] by another formula.")]
                    $Other,
                )+)?
            )+
        }

        impl ContactLaw {
            /// Names of all laws in scene files.
            pub(crate) const NAMES: &[&str] = &[$(<$Law as Law>::ABOUT.names[0].name),+];

            /// Facts about the law.
            pub const fn about(&self) -> &'static About {
                match self { $(Self::$Law(_) => &<$Law as Law>::ABOUT),+ }
            }

            /// The parameters with their values.
            pub fn parameters(&mut self) -> Vec<(&'static Parameter, &mut f64)> {
                match self { $(Self::$Law(law) => law.parameters()),+ }
            }

            /// The force of a compliant law as a form, for a reduced mass \[kg\] and an approach speed \[m/s\]; `None` if
            /// the law is impulsive.
            pub fn form(&self, reduced_mass: f64, approach_speed: f64) -> Option<Form> {
                match self { $(Self::$Law(law) => law.form(reduced_mass, approach_speed)),+ }
            }

            /// Coefficient of restitution \[–\] that the law delivers to a free pair, exactly; `None` if it depends on the pair.
            ///
            /// Laws with δ̇/v₀ deliver this e at approach speeds of at least [`crate::SLOWEST_APPROACH`], and a larger e below. For a law
            /// such as [`KuwabaraKono`], whose e depends on the pair, [`crate::FreeImpact`] finds it.
            pub fn restitution(&self) -> Option<f64> {
                match self { $(Self::$Law(law) => law.restitution()),+ }
            }

            pub(crate) fn stored(&self) -> Option<f64> {
                match self { $(Self::$Law(law) => law.stored()),+ }
            }

            /// Largest force \[N\] in the collision of a free pair, if a closed form exists.
            pub fn peak_force(&self, pair: &FreePair) -> Option<f64> {
                match self { $(Self::$Law(law) => law.peak_force(pair)),+ }
            }
        }

        impl LawName {
            /// All laws, in the order in which lists print them.
            pub const ALL: [Self; Self::COUNT] = [$(Self::$Law $($(, Self::$Other)+)?),+];

            /// The force with all parameters 0.
            pub(crate) fn blank(self) -> ContactLaw {
                match self {
                    $(Self::$Law $($(| Self::$Other)+)? => ContactLaw::$Law($Law::default())),+
                }
            }

            /// Index among the names that share its force.
            pub(crate) const fn place(self) -> usize {
                match self {
                    $(Self::$Law $($(| Self::$Other)+)? => self as usize - Self::$Law as usize),+
                }
            }
        }
    };
}

// One line per law: its file, its type, and other names in the literature with this force. Add new laws at the end: the order numbers the
// laws of `extremes`.
laws! {
    stereomechanical::Stereomechanical,
    linear_spring::LinearSpring,
    hertz::Hertz,
    kelvin_voigt::KelvinVoigt,
    modified_linear_viscoelastic::ModifiedLinearViscoelastic,
    nonlinear_viscoelastic::NonlinearViscoelastic,
    hertz_damp::HertzDamp { CorrectedHertzDamp, HuntCrossley, Gonthier },
    modified_kelvin::ModifiedKelvin,
    pant_wijeyewickrema::PantWijeyewickrema,
    kuwabara_kono::KuwabaraKono,
    two_slopes::TwoSlopes,
}
