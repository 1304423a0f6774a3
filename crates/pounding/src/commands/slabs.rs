//! Options that tell the impact stiffness by the slabs that meet.

use pounding::contact::Slab;
use pounding::text::Refused;

use super::positive;

/// The slabs that meet: one value for both, or one for each from the left.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Impact stiffness from the slabs that meet, k = 1/(L₁/EA₁ + L₂/EA₂)")]
pub(crate) struct Arguments {
    /// Section of the slab that is struck [m²]; one value, or left and right.
    #[arg(long, value_name = "A", num_args = 1..=2, allow_negative_numbers = true, value_parser = positive)]
    slab_area: Vec<f64>,
    /// Length of the slab along the row [m]; one value, or left and right.
    #[arg(long, value_name = "L", num_args = 1..=2, allow_negative_numbers = true, value_parser = positive)]
    slab_length: Vec<f64>,
    /// Young's modulus of the slab [Pa]; one value, or left and right.
    #[arg(long, value_name = "E", num_args = 1..=2, default_values = ["30e9"], allow_negative_numbers = true, value_parser = positive)]
    modulus: Vec<f64>,
}

impl Arguments {
    /// The slabs, from the left; `None` if none are told.
    ///
    /// # Errors
    /// Refuses an area without a length, and a length without an area.
    pub(crate) fn slabs(&self) -> Result<Option<[Slab; 2]>, Refused> {
        let missing = match (self.slab_area.is_empty(), self.slab_length.is_empty()) {
            (true, true) => return Ok(None),
            (true, false) => "--slab-area",
            (false, true) => "--slab-length",
            (false, false) => {
                let of = |values: &[f64], side: usize| values[side.min(values.len() - 1)];
                return Ok(Some([0, 1].map(|side| Slab {
                    area: of(&self.slab_area, side),
                    length: of(&self.slab_length, side),
                    modulus: of(&self.modulus, side),
                })));
            }
        };
        let refused = Refused::at(missing)
            .found("none")
            .allowed_are("both `--slab-area` and `--slab-length`");
        Err(refused.help("a stiffness E A/L needs the section and the length"))
    }
}
