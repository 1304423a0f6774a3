//! miniSEED as another program writes it.

use insta::assert_snapshot;
use miniseed_rs::{EncodingFormat, MseedRecord, NanoTime, Samples, encode};
use pounding_motion::{AccelerationUnit, Declared, Format, components};
use proptest::prelude::*;

use super::{accelerogram, component, readings, refusal};

const COUNTS: [i32; 9] = [3, -70, 500, -40_000, 900_000, -8_000_000, 12, 13, 13];

fn in_milli_g() -> Declared {
    Declared {
        unit: Some(AccelerationUnit::MilliG),
        per_count: Some(0.5),
        ..Declared::default()
    }
}

/// A record at 100 samples per second that starts at this hundredth of a second.
fn record(version: u8, channel: &str, start: u32, encoding: EncodingFormat, samples: Samples) -> Vec<u8> {
    let record = if version == 2 { MseedRecord::new() } else { MseedRecord::new_v3() };
    let time = NanoTime {
        year: 2001,
        day: 34,
        hour: 23,
        minute: 59,
        second: 59,
        nanosecond: start * 10_000_000,
    };
    let record = record
        .with_nslc("ZZ", "STA", "00", channel)
        .with_start_time(time)
        .with_sample_rate(100.0)
        .with_encoding(encoding)
        .with_samples(samples);
    encode(&record).expect("a record that can be written")
}

fn counts(version: u8, start: u32, encoding: EncodingFormat) -> Vec<u8> {
    record(version, "HNE", start, encoding, Samples::Int(COUNTS.to_vec()))
}

#[test]
fn reference_every_encoding_of_counts_in_both_versions() {
    let expected: Vec<f64> = COUNTS.iter().map(|count| f64::from(*count) * 0.5).collect();
    for version in [2, 3] {
        for encoding in [EncodingFormat::Int32, EncodingFormat::Steim1, EncodingFormat::Steim2] {
            let found = accelerogram(counts(version, 0, encoding), &in_milli_g());
            assert_eq!(found.format(), Format::MiniSeed);
            assert_eq!(found.values(), expected, "version {version}, {encoding}");
            assert_eq!(found.time_step().to_string(), "0.01");
        }
        let short = Samples::Int(vec![1, -2, 300]);
        let found = accelerogram(record(version, "HNE", 0, EncodingFormat::Int16, short), &in_milli_g());
        assert_eq!(found.values(), [0.5, -1.0, 150.0]);
    }
}

#[test]
fn reference_floats_need_their_unit_alone() {
    let declared = Declared {
        per_count: None,
        acceleration: false,
        ..in_milli_g()
    };
    for version in [2, 3] {
        let single = Samples::Float(vec![0.5, -0.25]);
        let bytes = record(version, "HNE", 0, EncodingFormat::Float32, single);
        assert_eq!(accelerogram(bytes, &declared).values(), [0.5, -0.25]);
        let double = Samples::Double(vec![0.1, -0.2]);
        let bytes = record(version, "HNE", 0, EncodingFormat::Float64, double);
        assert_eq!(accelerogram(bytes, &declared).values(), [0.1, -0.2]);
    }
}

#[test]
fn reference_records_of_several_streams() {
    let mut bytes = counts(2, 0, EncodingFormat::Steim2);
    bytes.extend(record(2, "HNZ", 0, EncodingFormat::Int32, Samples::Int(vec![7, 8])));
    bytes.extend(counts(2, 9, EncodingFormat::Steim2));
    assert_eq!(components(&bytes).unwrap(), ["ZZ.STA.00.HNE", "ZZ.STA.00.HNZ"]);
    let declared = Declared {
        component: Some("1".to_owned()),
        ..in_milli_g()
    };
    let found = accelerogram(&bytes, &declared);
    assert_eq!(found.values().len(), 18);
    assert_snapshot!(readings(&found), @r"
    format: miniSEED
    component: ZZ.STA.00.HNE
    number of samples: 18
    time step: 0.01 s
    unit: mg (declared)
    worth of a count: 0.5 (declared)
    encoding: Steim 2
    ");
    assert_snapshot!(refusal(&bytes, &in_milli_g()), @r#"the file holds 2 components: 1 = "ZZ.STA.00.HNE", 2 = "ZZ.STA.00.HNZ"; choose one by its name or its number as `component`"#);
}

#[test]
fn extreme_records() {
    let steim = counts(2, 0, EncodingFormat::Steim2);
    assert_snapshot!(refusal(&steim, &Declared::default()), @r#"byte 1 reads "whole numbers": the values are counts of a digitiser; declare what one is worth as `per_count`, and in which `unit`"#);
    assert_snapshot!(refusal(&steim[..500], &in_milli_g()), @"the file ends at byte 500, before the end of its last record; fetch it again");
    // The last value, which the first frame repeats.
    let mut damaged = steim.clone();
    damaged[64 + 11] ^= 1;
    assert_snapshot!(refusal(&damaged, &in_milli_g()), @r#"byte 1 reads "packed differences that do not lead to the last value", but the last value that the first frame repeats should stand there; fetch the file again"#);
    let mut gap = steim.clone();
    gap.extend(counts(2, 12, EncodingFormat::Steim2));
    assert_snapshot!(refusal(&gap, &in_milli_g()), @r#"byte 513 reads "a start 0.0300 s late", but a start one step after the record before should stand there; fetch the file again"#);
    let mut tail = steim.clone();
    tail.extend(b"something else");
    assert_snapshot!(refusal(&tail, &in_milli_g()), @r#"byte 513 reads "somethin", but a record of miniSEED should stand there; fetch the file again"#);
    let velocity = record(2, "HHE", 0, EncodingFormat::Int32, Samples::Int(vec![7, 8]));
    assert_snapshot!(refusal(velocity, &in_milli_g()), @r#"byte 1 reads "ZZ.STA.00.HHE", which speaks for velocities, and only histories of acceleration are read; take the record of accelerations, such as channel HNE of an accelerometer, or declare `acceleration` if the values were turned into accelerations"#);
    let not_finite = record(3, "HNE", 0, EncodingFormat::Float64, Samples::Double(vec![0.1, f64::NAN]));
    assert_snapshot!(refusal(not_finite, &in_milli_g()), @r#"byte 1 reads "a value that is not finite", but finite values should stand there; fetch the file again"#);
    assert_snapshot!(refusal(counts(3, 0, EncodingFormat::Int32), &component("HNX")), @r#""HNX" is declared as `component`, but the file holds 1 = "ZZ.STA.00.HNE"; choose one of them by its name, a part of it, or its number"#);
}

proptest! {
    #[test]
    fn reference_what_steim_packed_comes_back(samples in prop::collection::vec(-200_000_000..200_000_000_i32, 1..90), small in 0..24_u32) {
        // Small differences are packed differently from large ones.
        let samples: Vec<i32> = samples.into_iter().map(|sample| sample >> small).collect();
        let expected: Vec<f64> = samples.iter().map(|sample| f64::from(*sample) * 0.5).collect();
        for encoding in [EncodingFormat::Steim1, EncodingFormat::Steim2] {
            let bytes = record(3, "HNE", 0, encoding, Samples::Int(samples.clone()));
            let found = accelerogram(bytes, &in_milli_g());
            prop_assert_eq!(found.values(), &expected[..]);
        }
    }
}

/// Records without a blockette 1000 were refused: their packing is Steim 1, and they end where the next one begins.
#[test]
fn issue_records_without_a_blockette_1000() {
    let bare = |start: u32| {
        let mut bytes = counts(2, start, EncodingFormat::Steim1);
        bytes[39] = 0;
        bytes[46..48].fill(0);
        bytes
    };
    let expected = accelerogram(counts(2, 0, EncodingFormat::Steim1), &in_milli_g());
    let found = accelerogram(bare(0), &in_milli_g());
    assert_eq!(found.values(), expected.values());
    let two = [bare(0), bare(9)].concat();
    assert_eq!(accelerogram(two, &in_milli_g()).values().len(), 2 * expected.values().len());
    assert_snapshot!(refusal(&bare(0)[..400], &in_milli_g()), @r#"byte 1 reads "000001D ", but a record with a blockette 1000 that tells its length, or another record behind it should stand there; fetch the file again"#);
}

/// The record of version 2 with its packed words in the other byte order. Differences of one byte stay, those of two bytes are swapped
/// separately, and all other data are swapped as four bytes.
fn turned(mut bytes: Vec<u8>, encoding: EncodingFormat) -> Vec<u8> {
    let blockette = usize::from(u16::from_be_bytes([bytes[46], bytes[47]]));
    bytes[blockette + 5] = 0;
    let data = usize::from(u16::from_be_bytes([bytes[44], bytes[45]]));
    for (number, frame) in bytes[data..].chunks_exact_mut(64).enumerate() {
        let control = u32::from_be_bytes([frame[0], frame[1], frame[2], frame[3]]);
        for (index, word) in frame.chunks_exact_mut(4).enumerate() {
            let is_packed = index > 0 && !(number == 0 && index < 3);
            match control >> (30 - 2 * index) & 3 {
                1 if is_packed => {}
                2 if is_packed && encoding == EncodingFormat::Steim1 => {
                    word[..2].reverse();
                    word[2..].reverse();
                }
                _ => word.reverse(),
            }
        }
    }
    bytes
}

/// Differences of one and two bytes came out in reversed order, silently or as damage, in files of Kelunji and SEISAN loggers.
#[test]
fn issue_steim_in_the_other_order_of_bytes() {
    let small: Vec<i32> = vec![0, 1, 3, 6, 10, 15, 21, 28];
    let mixed: Vec<i32> = vec![5, 300, -400, 20_000, 19_999, 20_001, 20_004, 20_000, -500, 90_000];
    for samples in [small, mixed] {
        let expected: Vec<f64> = samples.iter().map(|one| f64::from(*one) * 0.5).collect();
        for encoding in [EncodingFormat::Steim1, EncodingFormat::Steim2] {
            let bytes = record(2, "HNE", 0, encoding, Samples::Int(samples.clone()));
            let found = accelerogram(turned(bytes, encoding), &in_milli_g());
            assert_eq!(found.values(), expected, "{encoding}");
        }
    }
}

proptest! {
    #[test]
    fn reference_both_orders_of_bytes_hold_the_same(samples in prop::collection::vec(-200_000_000..200_000_000_i32, 1..90), small in 0..24_u32) {
        let samples: Vec<i32> = samples.into_iter().map(|sample| sample >> small).collect();
        for encoding in [EncodingFormat::Steim1, EncodingFormat::Steim2] {
            let bytes = record(2, "HNE", 0, encoding, Samples::Int(samples.clone()));
            let big = accelerogram(&bytes, &in_milli_g());
            let little = accelerogram(turned(bytes, encoding), &in_milli_g());
            prop_assert_eq!(big.values(), little.values());
        }
    }
}
