//! Dates with a time of day, as files print them: `2020-01-01T00:00:00.005`, `2011/03/11 14:46:00`, `20190728_160908`.

/// A date with a time of day, exact to the printed digits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Stamp {
    /// Year, month and day.
    date: [u16; 3],
    /// Hour, minute and second.
    clock: [u16; 3],
    /// Decimals of the second.
    decimals: String,
}

impl Stamp {
    /// Reads a text that contains only a date and a time of day, and possibly a mark such as `Z` or `(GMT)`.
    pub(super) fn new(text: &str) -> Option<Self> {
        let text = text.trim().trim_matches('"');
        let mut rest = text;
        let year = digits(&mut rest, 4)?;
        skip(&mut rest, &['-', '/', '.']);
        let month = digits(&mut rest, 2)?;
        skip(&mut rest, &['-', '/', '.']);
        let day = digits(&mut rest, 2)?;
        if rest.starts_with(|letter: char| letter.is_ascii_digit()) {
            return None;
        }
        rest = rest.trim_start_matches(['T', 't', ' ', '-', '_', ',']);
        let hour = digits(&mut rest, 2)?;
        skip(&mut rest, &[':']);
        let minute = digits(&mut rest, 2)?;
        skip(&mut rest, &[':']);
        let second = digits(&mut rest, 2).unwrap_or(0);
        let mut decimals = "";
        if let Some(behind) = rest.strip_prefix('.') {
            let is_other = |letter: char| !letter.is_ascii_digit();
            let end = behind.find(is_other).unwrap_or(behind.len());
            (decimals, rest) = behind.split_at(end);
        }
        let mark = rest.trim().trim_matches(['(', ')']);
        let known = ["", "Z", "UT", "UTC", "GMT", "JST", "+00:00"];
        let is_moment = (1000..=2999).contains(&year)
            && (1..=12).contains(&month)
            && (1..=31).contains(&day)
            && hour < 24
            && minute < 60
            && second <= 60
            && decimals.len() <= 12
            && known.contains(&mark);
        is_moment.then(|| Self {
            date: [year, month, day],
            clock: [hour, minute, second],
            decimals: decimals.to_owned(),
        })
    }

    /// A moment from a year, a day of the year from 1, an hour, a minute and a second in a binary header.
    pub(super) fn of_day([year, day, hour, minute, second]: [i32; 5]) -> Self {
        let is_leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
        let february = if is_leap { 29 } else { 28 };
        let lengths = [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
        let (mut month, mut rest) = (0, day.max(1));
        while month < 11 && rest > lengths[month] {
            rest -= lengths[month];
            month += 1;
        }
        let small = |number: i32| u16::try_from(number).unwrap_or(0);
        Self {
            date: [small(year), u16::try_from(month + 1).unwrap_or(0), small(rest)],
            clock: [hour, minute, second].map(small),
            decimals: String::new(),
        }
    }

    /// Number of decimals of the second.
    pub(super) fn n_decimals(&self) -> usize {
        self.decimals.len()
    }

    /// Time between another moment and this one \[s\].
    pub(super) fn since(&self, other: &Self) -> f64 {
        let whole = self.seconds() - other.seconds();
        let fraction = |stamp: &Self| {
            let printed = format!("0.{}0", stamp.decimals);
            printed.parse::<f64>().expect("a number that was printed")
        };
        whole as f64 + (fraction(self) - fraction(other))
    }

    /// Whole seconds after a fixed day in the past.
    fn seconds(&self) -> i64 {
        let [year, month, day] = self.date.map(i64::from);
        let [hour, minute, second] = self.clock.map(i64::from);
        // Years begin in March, so a leap day is the last one.
        let (year, month) = if month > 2 { (year, month - 3) } else { (year - 1, month + 9) };
        let days = 365 * year + year / 4 - year / 100 + year / 400 + (153 * month + 2) / 5 + day;
        (days * 24 + hour) * 3600 + minute * 60 + second
    }
}

impl std::fmt::Display for Stamp {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let ([year, month, day], [hour, minute, second]) = (self.date, self.clock);
        write!(out, "{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}")
    }
}

/// A date and a time of day in one spelling; another text in capitals with single blanks between words.
pub(super) fn normal(text: &str) -> String {
    Stamp::new(text).map_or_else(|| super::title::words(text).to_ascii_uppercase(), |stamp| stamp.to_string())
}

/// Takes a number of at most `most` digits off a text.
fn digits(rest: &mut &str, most: usize) -> Option<u16> {
    let is_other = |letter: char| !letter.is_ascii_digit();
    let end = rest.find(is_other).unwrap_or(rest.len()).min(most);
    let (number, behind) = rest.split_at(end);
    *rest = behind;
    number.parse().ok()
}

/// Takes a letter off a text if it is in a list.
fn skip(rest: &mut &str, letters: &[char]) {
    *rest = rest.strip_prefix(letters).unwrap_or(rest);
}

#[cfg(test)]
mod tests {
    use super::{Stamp, normal};

    #[test]
    fn reference_one_moment_in_several_spellings() {
        for text in [
            "1999-09-20T17:47:15",
            "1999/09/20 17:47:15",
            "1999/9/20-17:47:15",
            "19990920_174715.250",
            "1999-09-20T17:47:15.000000Z",
            "1999/09/20 17:47:15 (GMT)",
        ] {
            assert_eq!(normal(text), "1999-09-20T17:47:15", "{text}");
        }
    }

    #[test]
    fn reference_seconds_between_moments() {
        let since = |first: &str, second: &str| {
            let [first, second] = [first, second].map(|text| Stamp::new(text).expect("a moment"));
            second.since(&first)
        };
        for (first, second, expected) in [
            ("2020-01-01T00:00:00.000", "2020-01-01T00:00:00.005", "0.005"),
            ("2020-02-28T23:59:59", "2020-03-01T00:00:00.5", "86401.5"),
            ("2019-12-31T23:59:59", "2020-01-01T00:00:00", "1"),
            ("1900-02-28T00:00:00", "1900-03-01T00:00:00", "86400"),
        ] {
            assert_eq!(since(first, second).to_string(), expected, "{first} to {second}");
        }
    }

    #[test]
    fn reference_days_of_the_year() {
        let day = |year, day| Stamp::of_day([year, day, 1, 2, 3]).to_string();
        assert_eq!(day(2019, 1), "2019-01-01T01:02:03");
        assert_eq!(day(2019, 59), "2019-02-28T01:02:03");
        assert_eq!(day(2019, 60), "2019-03-01T01:02:03");
        assert_eq!(day(2020, 60), "2020-02-29T01:02:03");
        assert_eq!(day(2019, 365), "2019-12-31T01:02:03");
        assert_eq!(day(2020, 366), "2020-12-31T01:02:03");
    }

    #[test]
    fn extreme_texts_that_are_no_moment() {
        for text in [
            "",
            "0.005",
            "2020",
            "2020-13-01T00:00:00",
            "2020-01-01",
            "20200101123",
            "1577836800.5",
            "2020-01-01T25:00:00",
            "2020-01-01T00:00:00 east",
        ] {
            assert_eq!(Stamp::new(text), None, "{text}");
        }
    }
}
