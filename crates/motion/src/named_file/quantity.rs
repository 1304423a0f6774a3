//! Accelerations, velocities, displacements or spectra: what the name of a file says.

use super::pieces::{is_parted, pieces, without_marks};

/// A `Quantity` is what a file holds, by its name.
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

/// Words of quantities, in capitals; a star stands for any end. The last in a name holds.
const WORDS: [(Quantity, &str); 4] = [
    (Quantity::Acceleration, "ACC ACCEL* ACELER* BESCHLEUN* AT2 V1A V2A"),
    (Quantity::Velocity, "VEL VELO VELOC* VITESS* GESCHWIND* VT2 V2V"),
    (
        Quantity::Displacement,
        "DIS DSP DISP DISPL DISPLAC* DESPLAZ* SPOSTAM* VERSCHIEB* DT2 V2D",
    ),
    (Quantity::Spectrum, "PSA PSV SPEC SPECTR* SPEKTR* ESPECTRO SPETTRO"),
];

/// Ends of names, in capitals: of ESM, where SA and SD are no places, and `.d` beside `.a` and `.v`.
const ENDS: [(&str, Quantity); 3] = [
    (".SA.ASC", Quantity::Spectrum),
    (".SD.ASC", Quantity::Spectrum),
    (".D", Quantity::Displacement),
];

/// Begins of words beside which a spectrum is what a record was made for: `matched_to_spectrum`.
const MADE_FOR: [&str; 8] = ["MATCH", "COMPAT", "CONSIST", "HISTOR", "SITE", "SCALE", "FIT", "ADJUST"];

impl Quantity {
    /// The quantity of the last word for one.
    ///
    /// Only the end of a name tells a spectrum: `PSA_000` is a station, `spectrum_matched_E` a record.
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
                // Codes of stations, too.
                Self::Displacement => index > 0 || n_words == 1 || !["DIS", "DSP"].contains(&&*piece),
                Self::Acceleration | Self::Velocity => true,
            };
            is_told.then_some(quantity)
        })
    }

    /// The quantity of a word, which may be counted: `vel`, `VEL2`.
    pub(crate) fn of_word(word: &str) -> Option<Self> {
        let word = word.to_ascii_uppercase();
        let is = |word: &str, known: &str| match known.strip_suffix('*') {
            Some(start) => word.starts_with(start),
            None => word == known,
        };
        let uncounted = word.trim_end_matches(|letter: char| letter.is_ascii_digit());
        // `PSA000` is an azimuth of a station.
        let is_count = word.len() - uncounted.len() <= 2;
        let known = WORDS.iter().find(|(quantity, known)| {
            let counts = is_count && *quantity != Self::Spectrum;
            let mut known = known.split(' ');
            known.any(|known| is(&word, known) || (counts && is(uncounted, known)))
        });
        known.map(|(quantity, _)| *quantity)
    }
}

/// The quantity of the end of a piece, which begins there: `quakeVel`, `AAAvel1`, `kvel`, but not `level`.
fn glued(piece: &str) -> Option<Quantity> {
    let starts = piece.char_indices().skip(1);
    let mut known = starts
        .filter(|(at, _)| *at == 1 || is_parted(piece, *at))
        .filter_map(|(at, _)| Quantity::of_word(&piece[at..]));
    known.find(|quantity| *quantity != Quantity::Spectrum)
}
