//! A share of a sweep.

use std::ops::Range;
use std::str::FromStr;

use pounding_text::Refused;

/// Share `index` of `count`, from 1 to `count`: a range of parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    index: u64,
    count: u64,
}

impl Shard {
    /// The whole sweep.
    pub const WHOLE: Self = Self { index: 1, count: 1 };

    /// Share `index` of `count`, counted from 1.
    ///
    /// # Errors
    /// Refuses an index that is none of 1 to `count`.
    pub fn new(index: u64, count: u64) -> Result<Self, Refused> {
        if (1..=count).contains(&index) {
            Ok(Self { index, count })
        } else {
            {
                let found = Refused::default().found(format!("the shard {index} of {count}"));
                Err(found.allowed_are(format!("1 to {count}, such as 1/{count}")))
            }
        }
    }

    /// Whether it is the whole sweep.
    pub fn is_whole(self) -> bool {
        self.count == 1
    }

    /// Its parts, out of `n_parts`.
    pub(super) fn of(self, n_parts: u64) -> Range<u64> {
        let start = |index: u64| {
            let start = u128::from(n_parts) * u128::from(index) / u128::from(self.count);
            u64::try_from(start).expect("at most the number of parts")
        };
        start(self.index - 1)..start(self.index)
    }
}

impl std::fmt::Display for Shard {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{}/{}", self.index, self.count)
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split_once('/');
        let number = |text: &str| text.trim().parse::<u64>().ok();
        let numbers = numbers.and_then(|(index, count)| Some((number(index)?, number(count)?)));
        let (index, count) = numbers.ok_or("allowed is the number of a shard and how many there are, such as 2/8")?;
        Self::new(index, count).map_err(|error| error.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::Shard;

    #[test]
    fn limit_shards_are_all_parts_once() {
        for n_parts in [0, 1, 2, 7, 100, 977] {
            for count in [1, 2, 3, 8, 1000] {
                let shards = (1..=count).map(|index| Shard::new(index, count).expect("a shard"));
                let parts: Vec<u64> = shards.flat_map(|shard| shard.of(n_parts)).collect();
                assert!(parts.into_iter().eq(0..n_parts), "{n_parts} {count}");
            }
        }
        for text in ["0/3", "4/3", "1/0", "1", "a/b", "-1/2"] {
            assert!(text.parse::<Shard>().is_err(), "{text}");
        }
    }
}
