//! The filtering of white noise by the ground: the spectrum of Kanai and Tajimi as modified by Clough and Penzien.

use crate::Refused;
use crate::record::within;

/// Two filters for white noise on its way up from the rock. The layers of the ground are the first one (K. Kanai 1957, H. Tajimi 1960). A
/// high-pass filter, the second one, keeps the variance of velocity and displacement finite (R. W. Clough and J. Penzien, *Dynamics of
/// Structures*, 1975).
#[derive(Debug, Clone, PartialEq)]
pub struct GroundFilter {
    /// Natural circular frequency of the ground `ω_g` \[rad/s\], > 0.
    pub angular_frequency: f64,
    /// Damping ratio of the ground `ζ_g` \[–\], > 0.
    pub damping_ratio: f64,
    /// Natural circular frequency of the high-pass filter `ω_f` \[rad/s\], > 0.
    pub high_pass_angular_frequency: f64,
    /// Damping ratio of the high-pass filter `ζ_f` \[–\], > 0.
    pub high_pass_damping_ratio: f64,
}

impl GroundFilter {
    /// Firm ground. Source of this and the next two: A. Der Kiureghian and A. Neuenhofer, *Earthquake Engng Struct. Dyn.* 21 (1992) 713.
    pub const FIRM: Self = Self {
        angular_frequency: 15.0,
        damping_ratio: 0.6,
        high_pass_angular_frequency: 1.5,
        high_pass_damping_ratio: 0.6,
    };

    /// Medium ground.
    pub const MEDIUM: Self = Self {
        angular_frequency: 10.0,
        damping_ratio: 0.4,
        high_pass_angular_frequency: 1.0,
        high_pass_damping_ratio: 0.6,
    };

    /// Soft ground.
    pub const SOFT: Self = Self {
        angular_frequency: 5.0,
        damping_ratio: 0.2,
        high_pass_angular_frequency: 0.5,
        high_pass_damping_ratio: 0.6,
    };

    /// Checks the settings.
    ///
    /// # Errors
    /// [`Refused`] with the setting, the value found and the values allowed.
    pub fn check(&self) -> Result<(), Refused> {
        let settings = [
            ("ground.angular_frequency", self.angular_frequency),
            ("ground.damping_ratio", self.damping_ratio),
            ("ground.high_pass_angular_frequency", self.high_pass_angular_frequency),
            ("ground.high_pass_damping_ratio", self.high_pass_damping_ratio),
        ];
        settings
            .into_iter()
            .try_for_each(|(setting, found)| within(setting, found, found > 0.0, "a finite number > 0"))
    }

    /// Returns the share S(ω)/S₀ \[–\] of the density of white noise that passes the filters at a circular frequency \[rad/s\].
    pub fn passes(&self, angular_frequency: f64) -> f64 {
        // Frequencies are relative to the natural ones, so no power of them overflows.
        let ground = angular_frequency / self.angular_frequency;
        let high_pass = angular_frequency / self.high_pass_angular_frequency;
        let damper = 4.0 * (self.damping_ratio * ground) * (self.damping_ratio * ground);
        let stiff = 1.0 - ground * ground;
        let kanai_tajimi = (1.0 + damper) / (stiff * stiff + damper);
        let damper = 2.0 * self.high_pass_damping_ratio * high_pass;
        let stiff = 1.0 - high_pass * high_pass;
        let square = high_pass * high_pass;
        kanai_tajimi * square * square / (stiff * stiff + damper * damper)
    }
}
