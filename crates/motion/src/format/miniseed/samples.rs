//! Unpacking the values of a record.
//!
//! Steim 1 and 2 store differences in frames of 16 words. The first word of a frame has two bits for each word, which define its division.
//! In the first frame the next two words are the first and the last value. Source: SEED manual 2.4, appendix B.
//!
//! Some loggers write words in the other byte order. Differences of one byte are then in the order of the file, and those of two bytes are
//! swapped separately. All other data are swapped as words of four bytes.

/// Bytes of a frame.
const FRAME: usize = 64;

/// The values of a record, at most `n_samples`. `None` if the encoding is unknown, or if the last packed value differs from that of the
/// first frame.
pub(super) fn unpack(encoding: u8, big_endian: bool, data: &[u8], n_samples: usize) -> Option<Vec<f64>> {
    match encoding {
        1 => Some(plain(data, big_endian, n_samples, |bytes| f64::from(i16::from_be_bytes(bytes)))),
        3 => Some(plain(data, big_endian, n_samples, |bytes| f64::from(i32::from_be_bytes(bytes)))),
        4 => Some(plain(data, big_endian, n_samples, |bytes| f64::from(f32::from_be_bytes(bytes)))),
        5 => Some(plain(data, big_endian, n_samples, f64::from_be_bytes)),
        10 => steim(data, big_endian, n_samples, |control, _| Some(steim_1(control))),
        11 => steim(data, big_endian, n_samples, steim_2),
        _ => None,
    }
}

/// Values of `N` bytes each.
fn plain<const N: usize>(data: &[u8], big_endian: bool, n_samples: usize, value: impl Fn([u8; N]) -> f64) -> Vec<f64> {
    let values = data.chunks_exact(N).take(n_samples).map(|chunk| {
        let mut bytes = [0; N];
        bytes.copy_from_slice(chunk);
        if !big_endian {
            bytes.reverse();
        }
        value(bytes)
    });
    values.collect()
}

/// Values from differences; `parts` gives the number of differences in a word and their bits.
fn steim(data: &[u8], big_endian: bool, n_samples: usize, parts: impl Fn(u32, u32) -> Option<(u32, u32)>) -> Option<Vec<f64>> {
    let word = |bytes: &[u8]| whole_word(bytes, big_endian);
    let (mut first, mut last) = (0, 0);
    let mut values = Vec::new();
    let mut value = 0_i32;
    'frames: for (frame_number, frame) in data.chunks_exact(FRAME).enumerate() {
        let control = word(frame);
        for (index, bytes) in (1_u32..).zip(frame[4..].chunks_exact(4)) {
            let whole = word(bytes);
            match (frame_number, index) {
                (0, 1) => first = whole.cast_signed(),
                (0, 2) => last = whole.cast_signed(),
                _ => {
                    let (n_parts, bits) = parts(control >> (30 - 2 * index) & 3, whole)?;
                    let word = match bits {
                        8 => whole_word(bytes, true),
                        // The first difference is in the higher half.
                        16 if !big_endian => whole.rotate_left(16),
                        _ => whole,
                    };
                    for part in (0..n_parts).rev() {
                        if values.len() == n_samples {
                            break 'frames;
                        }
                        let difference = signed(word >> (part * bits), bits);
                        // The first difference leads here from the previous record.
                        value = if values.is_empty() { first } else { value.wrapping_add(difference) };
                        values.push(f64::from(value));
                    }
                }
            }
        }
    }
    (values.is_empty() || value == last).then_some(values)
}

/// Four bytes as a number.
fn whole_word(bytes: &[u8], big_endian: bool) -> u32 {
    let bytes = [bytes[0], bytes[1], bytes[2], bytes[3]];
    if big_endian {
        u32::from_be_bytes(bytes)
    } else {
        u32::from_le_bytes(bytes)
    }
}

/// The lowest bits of a word as a signed number.
fn signed(word: u32, bits: u32) -> i32 {
    let shift = 32 - bits;
    (word << shift).cast_signed() >> shift
}

fn steim_1(control: u32) -> (u32, u32) {
    match control {
        0 => (0, 32),
        1 => (4, 8),
        2 => (2, 16),
        _ => (1, 32),
    }
}

fn steim_2(control: u32, word: u32) -> Option<(u32, u32)> {
    match (control, word >> 30) {
        (0, _) => Some((0, 32)),
        (1, _) => Some((4, 8)),
        (2, 1) => Some((1, 30)),
        (2, 2) => Some((2, 15)),
        (2, 3) => Some((3, 10)),
        (3, 0) => Some((5, 6)),
        (3, 1) => Some((6, 5)),
        (3, 2) => Some((7, 4)),
        _ => None,
    }
}
