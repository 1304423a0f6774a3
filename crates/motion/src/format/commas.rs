//! Texts with decimal commas, as programs write them in many countries: `0,01;0,25`, or `0,01 0,25`.
//!
//! If semicolons or blanks separate the numbers, commas are clearly decimal. They become points, byte for byte, so every line and column
//! keeps its place. If there are only commas, the text is ambiguous: see [`Rows::check_commas`](super::plain).

use std::borrow::Cow;

use crate::line::{Line, lines, number};

/// Number of bytes in which the first row of numbers is searched.
const SEARCHED: usize = 1 << 16;

/// Separator of the numbers of a row with decimal commas.
#[derive(Clone, Copy, PartialEq)]
enum Parted {
    BySemicolons,
    ByBlanks,
}

/// The text with decimal points, and the number of its first row with commas; unchanged if it has none.
pub(super) fn with_points(bytes: &[u8]) -> (Cow<'_, [u8]>, Option<usize>) {
    let head = &bytes[..bytes.len().min(SEARCHED)];
    let first = lines(head).ok().and_then(|lines| {
        let mut rows = lines.iter().filter(|line| !line.is_blank() && !line.is_comment());
        rows.find_map(|line| {
            let parted = parted(line.bytes);
            let is_row = parted.is_some() || line.fields().all(|field| number(field).is_some());
            is_row.then_some((line.number, parted))
        })
    });
    let Some((line, Some(parted))) = first else {
        return (Cow::Borrowed(bytes), None);
    };
    let mut text = bytes.to_vec();
    for line in text.split_mut(|byte| matches!(byte, b'\n' | b'\r')) {
        let is_row = self::parted(line) == Some(parted);
        set_points(line, is_row, parted);
    }
    (Cow::Owned(text), Some(line))
}

/// Separator of the numbers of a line, if it is a row with decimal commas or semicolons.
fn parted(line: &[u8]) -> Option<Parted> {
    let has = |byte: u8| memchr::memchr(byte, line).is_some();
    let is_number = |field: &[u8]| {
        let field = field.trim_ascii();
        let point = |byte: &u8| if *byte == b',' { b'.' } else { *byte };
        let with_point: Vec<u8> = field.iter().map(point).collect();
        let is_bare = field == b"," || field.ends_with(b",");
        let n_commas = memchr::memchr_iter(b',', field).count();
        n_commas < 2 && !is_bare && number(&with_point).is_some()
    };
    if has(b';') {
        let line = line.trim_ascii();
        let mut fields = line.strip_suffix(b";").unwrap_or(line).split(|byte| *byte == b';');
        return (line.len() < SEARCHED && fields.all(is_number)).then_some(Parted::BySemicolons);
    }
    if !has(b',') || has(b'.') {
        return None;
    }
    let pieces = Line { number: 0, bytes: line }.pieces();
    let is_several = pieces.clone().nth(1).is_some();
    (is_several && pieces.into_iter().all(is_number)).then_some(Parted::ByBlanks)
}

/// Replaces decimal commas by points, and semicolons by commas.
fn set_points(line: &mut [u8], is_row: bool, parted: Parted) {
    let is_digit = |byte: Option<&u8>| byte.is_some_and(u8::is_ascii_digit);
    for at in 0..line.len() {
        let before = at.checked_sub(1).and_then(|before| line.get(before));
        let is_decimal = is_row || (is_digit(before) && is_digit(line.get(at + 1)));
        line[at] = match (line[at], parted) {
            (b',', _) if is_decimal => b'.',
            // A comma in a title does not separate columns here.
            (b',', Parted::BySemicolons) => b' ',
            (b';', Parted::BySemicolons) => b',',
            (byte, _) => byte,
        };
    }
}

#[cfg(test)]
mod tests {
    use super::with_points;

    fn changed(text: &str) -> String {
        let (text, _) = with_points(text.as_bytes());
        String::from_utf8_lossy(&text).into_owned()
    }

    #[test]
    fn reference_points_for_commas() {
        assert_eq!(
            changed("t (s);a, NS (g)\n0,00;0,25\n0,01;-1,5e-3\n"),
            "t (s),a  NS (g)\n0.00,0.25\n0.01,-1.5e-3\n"
        );
        assert_eq!(
            changed("# dt = 0,01\n0,5 0,25\n0 -1,5\n"),
            "# dt = 0.01\n0.5 0.25\n0 -1,5\n".replace("-1,5", "-1.5")
        );
        assert_eq!(changed("0.5;0.25\n"), "0.5,0.25\n");
    }

    #[test]
    fn limit_other_commas_stay() {
        for text in [
            "0,00123\n0,00145\n",
            "0.01, 0.25\n",
            "0.01,0.25\n",
            "a;b\n1 2\n",
            "0,4 .5 .6\n",
            "1,2,3\n",
        ] {
            assert_eq!(changed(text), text);
        }
    }
}
