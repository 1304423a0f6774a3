//! The quantity in a file according to its name: accelerations, velocities, displacements or spectra.

use super::pieces::{is_parted, pieces, without_marks};

/// A `Quantity` is the kind of values in a file, according to its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Accelerations.
    Acceleration,
    /// Velocities.
    Velocity,
    /// Displacements.
    Displacement,
    /// A response spectrum.
    Spectrum,
}

/// Words of quantities, in capitals; a star is any end. The last one in a name counts.
const WORDS: [(Quantity, &str); 4] = [
    (Quantity::Acceleration, "ACC ACCEL* ACELER* BESCHLEUN* AT2 V1A V2A"),
    (Quantity::Velocity, "VEL VELO VELOC* VITESS* GESCHWIND* VT2 V2V"),
    (
        Quantity::Displacement,
        "DIS DSP DISP DISPL DISPLAC* DESPLAZ* SPOSTAM* VERSCHIEB* DT2 V2D",
    ),
    (Quantity::Spectrum, "PSA PSV SPEC SPECTR* SPEKTR* ESPECTRO SPETTRO"),
];

/// Extensions of quantities, in capitals: of ESM, where SA and SD are not places, and `.d` next to `.a` and `.v`.
const ENDS: [(&str, Quantity); 3] = [
    (".SA.ASC", Quantity::Spectrum),
    (".SD.ASC", Quantity::Spectrum),
    (".D", Quantity::Displacement),
];

/// Beginnings of words next to which "spectrum" names the purpose of a record: `matched_to_spectrum`.
const MADE_FOR: [&str; 8] = ["MATCH", "COMPAT", "CONSIST", "HISTOR", "SITE", "SCALE", "FIT", "ADJUST"];

impl Quantity {
    /// The quantity of the last word that names one.
    ///
    /// A spectrum counts only at the end of a name: `PSA_000` is a station, `spectrum_matched_E` a record.
    pub(crate) fn of_name(name: &str) -> Option<Self> {
        let name = without_marks(name);
        let capitals = name.to_ascii_uppercase();
        let mut ends = ENDS.iter().filter(|(end, _)| capitals.ends_with(end));
        if let Some((_, quantity)) = ends.next() {
            return Some(*quantity);
        }
        let is_made_for = |(_, piece): (usize, &str)| piece == "TO" || MADE_FOR.iter().any(|word| piece.starts_with(word));
        let pieces: Vec<&str> = pieces(&name).map(|(_, piece)| piece).collect();
        let n_words = pieces.len() - usize::from(name.contains('.'));
        (0..pieces.len()).rev().find_map(|index| {
            let piece = pieces[index].to_ascii_uppercase();
            let quantity = Self::of_word(&piece).or_else(|| glued(pieces[index]))?;
            let is_told = match quantity {
                Self::Spectrum => index + 1 >= n_words && !self::pieces(&capitals).any(is_made_for),
                // These words are codes of stations too.
                Self::Displacement => index > 0 || n_words == 1 || !["DIS", "DSP"].contains(&&*piece),
                Self::Acceleration | Self::Velocity => true,
            };
            is_told.then_some(quantity)
        })
    }

    /// The quantity of a word, which may have a number: `vel`, `VEL2`.
    pub(crate) fn of_word(word: &str) -> Option<Self> {
        let word = word.to_ascii_uppercase();
        let is = |word: &str, known: &str| match known.strip_suffix('*') {
            Some(start) => word.starts_with(start),
            None => word == known,
        };
        let uncounted = word.trim_end_matches(|letter: char| letter.is_ascii_digit());
        // `PSA000` is a station with an azimuth.
        let is_count = word.len() - uncounted.len() <= 2;
        let known = WORDS.iter().find(|(quantity, known)| {
            let counts = is_count && *quantity != Self::Spectrum;
            let mut known = known.split(' ');
            known.any(|known| is(&word, known) || (counts && is(uncounted, known)))
        });
        known.map(|(quantity, _)| *quantity)
    }
}

/// The quantity at the end of a piece: `quakeVel`, `AAAvel1`, `kvel`, but not `level`.
fn glued(piece: &str) -> Option<Quantity> {
    let starts = piece.char_indices().skip(1);
    let mut known = starts
        .filter(|(at, _)| *at == 1 || is_parted(piece, *at))
        .filter_map(|(at, _)| Quantity::of_word(&piece[at..]));
    known.find(|quantity| *quantity != Quantity::Spectrum)
}
