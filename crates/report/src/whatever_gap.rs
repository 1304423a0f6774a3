//! What no width of a gap helps against: buildings that exceed a capacity of the scene, collapse, or would hardly stand even alone.

use std::collections::BTreeSet;

use pounding_assess::{Case, says_believed};
use pounding_scene::{Excess, ExcessKind, Floors, Often, RowWords};

/// Every building that exceeds a capacity of the scene even alone, by the drift or force that is farthest above it, with the number of `of`
/// samples. `all` has such responses, each with its case.
pub(crate) fn over_capacity(floors: &Floors, all: &[(Case, &Excess)], of: usize, sample: &'static str) -> Vec<Excess> {
    let of_building = |structure: usize| {
        let own = all.iter().filter(|(_, one)| floors.all()[one.floor].structure == structure);
        let (_, worst) = own.clone().max_by(|one, other| one.1.share().total_cmp(&other.1.share()))?;
        let cases: BTreeSet<Case> = own.map(|(case, _)| *case).collect();
        let often = Often {
            n: cases.len(),
            of,
            sample,
        };
        Some(Excess {
            often: Some(often),
            ..(*worst).clone()
        })
    };
    (0..floors.structures().len()).filter_map(of_building).collect()
}

/// The buildings that exceed a capacity even alone, in a sentence; `None` if none does. `widths` tells whether widths of gaps follow.
pub(crate) fn says_over_capacity(over: &[Excess], words: RowWords, widths: bool) -> Option<String> {
    let building = words.building;
    let exceed = match over.len() {
        0 => return None,
        1 => format!("the {building} exceeds its capacity"),
        _ => format!("{building}s exceed their capacity"),
    };
    let brief = |one: &Excess| {
        let often = one.often.map_or_else(String::new, |Often { n, of, sample }| {
            let s = if of == 1 { "" } else { "s" };
            let any = if words.storey == "storey" {
                ", counting all its storeys"
            } else {
                ""
            };
            format!("; so in {n} of {of} {sample}{s}{any}")
        });
        let worst = Excess {
            often: None,
            ..one.clone()
        };
        format!("{}{often}", worst.brief())
    };
    let over: Vec<String> = over.iter().map(brief).collect();
    let below = if widths {
        " The widths below keep floors apart, and do no more."
    } else {
        ""
    };
    Some(format!(
        "Whatever the gap, {exceed} even {} ({}).{below}",
        words.alone,
        over.join("; ")
    ))
}

/// Isolators that move farther than they bear, in a sentence; `widths` tells whether widths of gaps follow.
pub(crate) fn says_isolators(over: &Excess, widths: bool) -> String {
    let below = if widths {
        " The widths below keep floors apart, and do no more: a wall that stops them first hits the building."
    } else {
        ""
    };
    format!("Isolators move farther than they bear ({}).{below}", over.brief())
}

/// The isolators that move farthest beyond their capacity, of gathered responses.
pub(crate) fn isolators_over(all: Vec<Excess>) -> Option<Excess> {
    let over = |one: &Excess| one.kind == ExcessKind::Displacement && one.capacity.is_some();
    let all = all.into_iter().filter(over);
    all.max_by(|one, other| one.share().total_cmp(&other.share()))
}

/// What forbids to call a width enough.
pub(crate) struct Standing {
    /// Buildings that exceed a capacity alone.
    pub(crate) over: Vec<Excess>,
    /// Isolators that move farther than they bear.
    pub(crate) isolators: Option<Excess>,
    /// Whether decks may leave seats that were not judged.
    pub(crate) may_fall: bool,
    /// Number of samples in which a general limit is exceeded alone.
    pub(crate) strained: usize,
    /// Samples that are not believed.
    pub(crate) fallen: Fallen,
}

impl Standing {
    /// Whether a width may be called enough: nothing above, and a general limit is exceeded in less than half of the samples.
    pub(crate) fn may_be_enough(&self) -> bool {
        let stands = self.over.is_empty() && self.isolators.is_none() && self.fallen.doubted == 0;
        stands && !self.may_fall && 2 * self.strained < self.fallen.of
    }
}

/// Says of a bridge without seats that nobody judged them.
pub(crate) const NO_SEATS: &str =
    "No seats are told (seat_width_m): whether decks stay on theirs is not judged, and at wider gaps they move farther.";

/// A response beyond belief and its limit: "a, storey 2: drift of 6.1 %, above 5 %, the most that is believed".
pub(crate) fn says_beyond(worst: &Excess) -> String {
    format!("{}: {}{}", worst.name, worst.kind.brief(worst.found), says_believed(worst.kind))
}

/// How many samples are not believed: a building would not stand in them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fallen {
    /// Number of samples.
    pub(crate) of: usize,
    /// Number of those that are not believed.
    pub(crate) doubted: usize,
    /// Number of those in which a storey collapses.
    pub(crate) collapsed: usize,
    /// The word for a sample.
    pub(crate) sample: &'static str,
    /// Words for the structures of the row.
    pub(crate) words: RowWords,
}

impl Fallen {
    /// The subject and the verb of a sentence about the samples that are not believed.
    pub(crate) fn says(&self) -> String {
        let falls = match self.collapsed {
            0 => "would hardly stand",
            n if n == self.doubted => "collapses",
            _ => "collapses or would hardly stand",
        };
        format!("a {} {falls}", self.words.building)
    }

    /// "the 6 events without a collapse".
    pub(crate) fn others(&self) -> String {
        let others = match self.of - self.doubted {
            1 => format!("the one {}", self.sample),
            n => format!("the {n} {}s", self.sample),
        };
        let which = match (self.collapsed == self.doubted, self.of - self.doubted) {
            (true, _) => "without a collapse",
            (false, 1) => "that counts",
            (false, _) => "that count",
        };
        format!("{others} {which}")
    }

    /// The end of a sentence about a width: "; in 3 of 9 a building collapses whatever the gap". Empty if none does.
    pub(crate) fn whatever(&self) -> String {
        match self.doubted {
            0 => String::new(),
            n => format!("; in {n} of {} {} whatever the gap", self.of, self.says()),
        }
    }
}
