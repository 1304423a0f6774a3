//! A compliant contact of a scene.

use pounding_contact::Form;

/// First step in s \[s^¼\]: a thousandth of the time of a stiff contact.
pub(super) const FIRST_STEP: f64 = 0.02;

/// A compliant contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Contact {
    pub(super) form: Form,
    /// Approach rate at the touch \[m/s\].
    pub(super) speed: f64,
    /// Fourth root of the time since the touch \[s^¼\], and the next step in it.
    pub(super) s: f64,
    pub(super) step: f64,
    /// Rate of its force \[N/s\]; NaN just after a touch or a bend.
    pub(super) climb: f64,
    /// Impulse so far \[N·s\].
    pub(super) impulse: f64,
}

impl Contact {
    pub(super) fn new(form: Form, speed: f64) -> Self {
        Self {
            form,
            speed,
            s: 0.0,
            step: FIRST_STEP,
            climb: f64::NAN,
            impulse: 0.0,
        }
    }
}
