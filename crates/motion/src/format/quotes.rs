//! Texts with quotes around their numbers, as sheets of data write them: `"0.01","0.25"`.
//!
//! Quotes become blanks, so that every line and column keeps its place.

use std::borrow::Cow;

use crate::line::{lines, number};

/// Number of bytes in which the first quoted row of numbers is searched.
const SEARCHED: usize = 1 << 16;

/// The text without quotes if some row has numbers in quotes; else unchanged.
pub(super) fn without(bytes: &[u8]) -> Cow<'_, [u8]> {
    let head = &bytes[..bytes.len().min(SEARCHED)];
    // Quotes of JSON are no quotes of cells.
    let is_json = head.trim_ascii_start().starts_with(b"{") || head.trim_ascii_start().starts_with(b"[");
    if is_json || memchr::memchr(b'"', head).is_none() {
        return Cow::Borrowed(bytes);
    }
    let is_quoted = lines(head).is_ok_and(|lines| lines.iter().any(|line| is_row(line.bytes)));
    if !is_quoted {
        return Cow::Borrowed(bytes);
    }
    let mut text = bytes.to_vec();
    for line in text.split_mut(|byte| matches!(byte, b'\n' | b'\r')) {
        unquote(line);
    }
    Cow::Owned(text)
}

/// Whether a line has quotes, and without them numbers alone.
fn is_row(line: &[u8]) -> bool {
    let mut line = line.to_vec();
    if memchr::memchr(b'"', &line).is_none() {
        return false;
    }
    unquote(&mut line);
    let mut fields = line.split(|byte| matches!(byte, b',' | b';' | b'\t')).map(<[u8]>::trim_ascii);
    fields.all(|field| {
        let point: Vec<u8> = field.iter().map(|byte| if *byte == b',' { b'.' } else { *byte }).collect();
        number(&point).is_some()
    })
}

/// Makes blanks of quotes. Within them a comma between digits becomes a point, and any other separator a blank.
fn unquote(line: &mut [u8]) {
    let mut within = false;
    for at in 0..line.len() {
        let is_digit = |at: Option<usize>| at.and_then(|at| line.get(at)).is_some_and(u8::is_ascii_digit);
        line[at] = match line[at] {
            b'"' => {
                within = !within;
                b' '
            }
            b',' if within && is_digit(at.checked_sub(1)) && is_digit(Some(at + 1)) => b'.',
            b',' | b';' if within => b' ',
            byte => byte,
        };
    }
}

#[cfg(test)]
mod tests {
    use super::without;

    fn changed(text: &str) -> String {
        String::from_utf8_lossy(&without(text.as_bytes())).into_owned()
    }

    #[test]
    fn reference_numbers_in_quotes() {
        assert_eq!(
            changed("\"t (s)\",\"a, NS (g)\"\n\"0.00\",\"0.25\"\n"),
            " t (s) , a  NS (g) \n 0.00 , 0.25 \n"
        );
        assert_eq!(
            changed("\"t\";\"a\"\r\n\"0,01\";\"-1,5e-3\"\r\n"),
            " t ; a \r\n 0.01 ; -1.5e-3 \r\n"
        );
        assert_eq!(changed("0.01,\"0.25\"\n"), "0.01, 0.25 \n");
    }

    #[test]
    fn limit_other_quotes_stay() {
        for text in [
            "# the \"best\" record\n0.1\n",
            "{\"a\": [\n\"0.1\"\n]}\n",
            "\"t\",\"a\"\n0.01,0.25\n",
            "",
            "\"\n",
        ] {
            assert_eq!(changed(text), text);
        }
    }
}
