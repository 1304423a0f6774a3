//! SAC in both byte orders.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Declared, Format, components};

use super::{accelerogram, readings, refusal};

/// A usual file with one word of its header replaced, by index from 0.
struct Sac {
    big_endian: bool,
    words: Vec<(usize, u32)>,
    values: Vec<f32>,
}

impl Sac {
    fn new(values: &[f32]) -> Self {
        let n_values = u32::try_from(values.len()).expect("a small file");
        let largest = values.iter().fold(f32::MIN, |largest, value| largest.max(*value));
        let smallest = values.iter().fold(f32::MAX, |smallest, value| smallest.min(*value));
        let words = vec![
            (0, 0.02_f32.to_bits()),
            (1, smallest.to_bits()),
            (2, largest.to_bits()),
            (76, 6),
            (79, n_values),
            (85, 1),
            (86, 8),
            (105, 1),
        ];
        Self {
            big_endian: false,
            words,
            values: values.to_vec(),
        }
    }

    fn set(mut self, word: usize, value: u32) -> Self {
        self.words.push((word, value));
        self
    }

    fn bytes(&self) -> Vec<u8> {
        let mut words = vec![(-12345.0_f32).to_bits(); 70];
        words.extend([(-12345_i32).cast_unsigned(); 40]);
        for (word, value) in &self.words {
            words[*word] = *value;
        }
        let order = |word: u32| {
            if self.big_endian { word.to_be_bytes() } else { word.to_le_bytes() }
        };
        let mut bytes: Vec<u8> = words.into_iter().flat_map(order).collect();
        bytes.extend(b"-12345  ".repeat(20));
        bytes.extend(b"HNE\0    ZZ      -12345  -12345  ");
        assert_eq!(bytes.len(), 632, "length of the header");
        bytes.extend(self.values.iter().flat_map(|value| order(value.to_bits())));
        bytes
    }
}

const VALUES: [f32; 4] = [0.5, -1.25, 0.1, 0.0];

const IN_SI: Declared = Declared {
    unit: Some(AccelerationUnit::MetrePerSecondSquared),
    time_step: None,
    component: None,
    per_count: None,
    acceleration: false,
    in_rows: false,
};

#[test]
fn reference_both_byte_orders_are_one() {
    let little = Sac::new(&VALUES);
    let big = Sac {
        big_endian: true,
        ..Sac::new(&VALUES)
    };
    let found = accelerogram(little.bytes(), &IN_SI);
    assert_eq!(found.format(), Format::Sac);
    // The step is the intended decimal, not the nearest single-precision number.
    assert_eq!(found.time_step().to_string(), "0.02");
    let expected: Vec<f64> = VALUES.iter().map(|value| f64::from(*value)).collect();
    assert_eq!(found.values(), expected);
    assert_eq!(components(&little.bytes()).unwrap(), ["HNE"]);
    assert_eq!(found.provenance(), "ZZ");
    assert_snapshot!(readings(&found), @r"
    format: SAC
    component: HNE
    number of samples: 4
    time step: 0.02 s
    unit: m/s² (declared)
    peak in the header: -1.25 to 0.5
    quantity: acceleration
    ");
    assert_eq!(accelerogram(big.bytes(), &IN_SI), found);
}

#[test]
fn extreme_header_and_values() {
    assert_snapshot!(refusal(Sac::new(&VALUES).bytes(), &Declared::default()), @"the file does not say in which unit its values are; declare it as `unit`, one of g, m_per_s2, cm_per_s2, mm_per_s2, mg, g_per_10");
    let refused = |word, value| refusal(Sac::new(&VALUES).set(word, value).bytes(), &IN_SI);
    assert_snapshot!(refused(86, 7), @r#"byte 345 reads "IDEP 7", but only histories of acceleration are read; take the file of accelerations (IDEP 8)"#);
    assert_snapshot!(refused(85, 2), @r#"byte 341 reads "2", but 1, a time series should stand there; fetch the file again"#);
    assert_snapshot!(refused(105, 0), @r#"byte 421 reads "0", but 1, values at equal steps should stand there; fetch the file again"#);
    assert_snapshot!(refused(79, 5), @"the values end at byte 645 after 4 of them, but the header declares 5; fetch the file again, or correct the header if the values are complete");
    assert_snapshot!(refused(79, u32::MAX), @r#"byte 317 reads "-1", but a number of samples above 0 should stand there; fetch the file again"#);
    assert_snapshot!(refused(0, 0), @"byte 1: the time step is 0 s, and must be finite and above 0 s; correct it there");
    assert_snapshot!(refused(1, (-2.5_f32).to_bits()), @r#"byte 5 states a peak of "-2.5 to 0.5", but the largest value read is 1.25 m/s²; one of them is damaged or in another unit: fetch the file again"#);
    assert_snapshot!(refusal(Sac::new(&[0.5, f32::NAN]).bytes(), &IN_SI), @r#"byte 637 reads "NaN", but a finite value should stand there; fetch the file again"#);
    let mut cut = Sac::new(&VALUES).bytes();
    cut.truncate(640);
    assert_snapshot!(refusal(&cut, &IN_SI), @"the values end at byte 637 after 2 of them, but the header declares 4; fetch the file again, or correct the header if the values are complete");
}

#[test]
fn limit_peak_and_quantity_may_be_unset() {
    let unset = (-12345.0_f32).to_bits();
    let sac = Sac::new(&VALUES).set(1, unset).set(2, unset).set(86, (-12345_i32).cast_unsigned());
    assert_eq!(accelerogram(sac.bytes(), &IN_SI).values().len(), 4);
}

/// A file without a channel name had no direction although the header has the angle of the sensor.
#[test]
fn issue_upright_by_the_angle_of_the_sensor() {
    let names = |channel: &[u8; 8], angle: f32| {
        let mut bytes = Sac::new(&VALUES).set(58, angle.to_bits()).bytes();
        bytes[600..608].copy_from_slice(channel);
        components(&bytes).unwrap()
    };
    let unset = b"-12345  ";
    assert_eq!(names(unset, 0.0), ["UP"]);
    assert!(names(unset, 90.0).is_empty());
    assert_eq!(names(b"chan    ", 180.0), ["chan UP"]);
    assert_eq!(names(b"HNE     ", 0.0), ["HNE"]);
}

/// Channels of seismometers became accelerations once their unit was declared.
#[test]
fn issue_velocities_by_the_code_of_the_channel() {
    let with_channel = |code: &[u8; 3], quantity: u32| {
        let mut bytes = Sac::new(&VALUES).set(86, quantity).bytes();
        bytes[600..608].copy_from_slice(&[&code[..], b"     "].concat());
        bytes
    };
    let (unknown, acceleration) = (5, 8);
    assert_snapshot!(refusal(with_channel(b"BHE", unknown), &IN_SI), @r#"byte 601 reads "BHE", which speaks for velocities, and only histories of acceleration are read; take the record of accelerations, such as channel HNE of an accelerometer, or declare `acceleration` if the values were turned into accelerations"#);
    let turned = Declared {
        acceleration: true,
        ..IN_SI
    };
    let found = accelerogram(with_channel(b"BHE", unknown), &turned);
    let said: Vec<String> = found.unusual().iter().map(ToString::to_string).collect();
    assert_snapshot!(said.join("\n"), @r#"found "BHE" in the file, which speaks for velocities, declared to be accelerations, usual is the record of an accelerometer, such as channel HNE"#);
    // The header counts more than the code, and accelerometers have different codes.
    for (code, quantity) in [(b"BHE", acceleration), (b"HNE", unknown), (b"ENZ", unknown)] {
        let found = accelerogram(with_channel(code, quantity), &IN_SI);
        assert!(found.unusual().is_empty(), "{code:?}");
    }
}
