//! Meaning of names of files: directions, quantities, and files of a common record.

use pounding_motion::{Direction, NamedFile, Quantity};
use proptest::prelude::*;

/// Record numbers of some names, from 0 in their order.
fn records(names: &[&str]) -> Vec<usize> {
    numbered(&NamedFile::of_all(names).iter().collect::<Vec<_>>())
}

pub(crate) fn numbered(files: &[&NamedFile]) -> Vec<usize> {
    let mut numbers: Vec<usize> = Vec::new();
    for (index, file) in files.iter().enumerate() {
        let known = files[..index].iter().position(|other| other.same_record(file));
        let next = numbers.iter().max().map_or(0, |most| most + 1);
        numbers.push(known.map_or(next, |known| numbers[known]));
    }
    numbers
}

/// Two components counted as two events: 16 of 30 kinds of names were not known.
#[test]
fn issue_components_of_one_record() {
    for pair in [
        ["RSN1244_CHICHI_CHY101-E.AT2", "RSN1244_CHICHI_CHY101-N.AT2"],
        ["CHY101-E.AT2", "CHY101-N.AT2"],
        ["TCU065-W.AT2", "TCU065-V.AT2"],
        ["CHY080E.AT2", "CHY080N.AT2"],
        ["ABBAR--L.AT2", "ABBAR--T.AT2"],
        ["FER-L1.AT2", "FER-T1.AT2"],
        ["H-E06140.AT2", "H-E06230.AT2"],
        ["E06140.AT2", "E06230.AT2"],
        ["2009A090.AT2", "2009B360.AT2"],
        ["FAIGO-90.AT2", "FAIGO-360.AT2"],
        ["A-ELC180.AT2", "A-ELC270.AT2"],
        ["A-ELC180.AT2", "A-ELC-UP.AT2"],
        ["LCN260.AT2", "LCN345.AT2"],
        ["MUL009.AT2", "MUL279.AT2"],
        ["CLW-LN.AT2", "CLW-TR.AT2"],
        ["FA030XTE.AT2", "FA030YLN.AT2"],
        ["NIGH11NS.AT2", "NIGH11EW.AT2"],
        ["Oak_2_50_5_FN.AT2", "Oak_2_50_5_FP.AT2"],
        [
            "HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC",
            "HI.ARS1..HNN.D.20190728.160908.C.ACC.ASC",
        ],
        ["CI.CLC..HNE.--.V1c", "CI.CLC..HNN.--.V1c"],
        ["AKBMR--n.1000hyfh.BNE.--.acc.V2c", "AKBMR--n.1000hyfh.BNZ.--.acc.V2c"],
        ["20190706.CJ.T001230.HNE.sac", "20190706.CJ.T001230.HNN.sac"],
        ["20200101_4614_E.asc", "20200101_4614_N.asc"],
        ["20200101_4614_E.asc", "20200101_4614_U.asc"],
        ["quake_H1.txt", "quake_H2.txt"],
        ["quake_x.txt", "quake_y.txt"],
        ["quake_E_acc.txt", "quake_N_acc.txt"],
        ["1895a.smc", "1895c.smc"],
        ["017m30bt.s0a", "017m30bt.s0b"],
        ["LPCC_20.000", "LPCC_20.090"],
        ["LPCC_20.000", "LPCC_20.ver"],
        ["ABC0010102030405.EW", "ABC0010102030405.NS"],
        ["NGNH351106302345.EW1", "NGNH351106302345.NS2"],
        ["T045.00E", "T045.00N"],
        ["RSN6_IMPVALL.I_I-ELC180.AT2", "RSN6_IMPVALL.I_I-ELC270.AT2"],
        ["RSN6_IMPVALL.I_I-ELC180.AT2", "RSN6_IMPVALL.I_I-ELC-UP.AT2"],
        ["NGA_no_169_H-DLT262.AT2", "NGA_no_169_H-DLT352.AT2"],
    ] {
        assert_eq!(records(&pair), [0, 0], "{pair:?}: {:?}", NamedFile::of_all(&pair));
    }
}

/// Record numbers are not azimuths, and names with one direction belong to two records.
#[test]
fn limit_files_of_other_records() {
    for names in [
        &["RSN001.AT2", "RSN002.AT2"][..],
        &["r001.txt", "r002.txt", "r091.txt"],
        &["elCentro.AT2", "A-ELC180.AT2"],
        &["A-ELC180.AT2", "A-ELC000.AT2"],
        &["A-ELC180.AT2", "B-ELC270.AT2"],
        &["CHY080E.AT2", "CHY081N.AT2"],
        &["quake1_E.txt", "quake2_N.txt"],
        &["a-r1.txt", "a-r2.txt"],
        &["FER-L1.AT2", "FER-T2.AT2"],
        &["up.csv", "down.csv"],
        &["RSN6_A-ELC180.AT2", "RSN7_A-ELC270.AT2"],
        &["1895a.txt", "1895c.txt"],
        &["rec_10.txt", "rec_20.txt", "rec_100.txt", "rec_110.txt"],
        &[
            "HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC",
            "HI.ARS2..HNN.D.20190728.160908.C.ACC.ASC",
        ],
        &["a.txt", "b.txt", "c.txt"],
        &["quake.txt", "quake (1).txt"],
    ] {
        let expected: Vec<usize> = (0..names.len()).collect();
        assert_eq!(records(names), expected, "{:?}", NamedFile::of_all(names));
    }
}

#[test]
fn reference_directions() {
    let direction = |name: &str| NamedFile::of(name).direction;
    for name in [
        "RSN6_IMPVALL.I_I-ELC-UP.AT2",
        "RSN1244_CHICHI_CHY101-V.AT2",
        "quake_z.txt",
        "A-ELC-DWN.AT2",
        "I-VERT.AT2",
        "ABC0010102030405.UD",
        "ABCH010102030405.UD2",
        "RSN4228_NIIGATA_NIGH11UD.AT2",
        "20190706.CJ.T001230.HNZ.sac",
        "RSN10590_ComalTX_IU.CCM.BHZ.00.AT2",
        "3528839_LPCC_HN_20.ver",
        "T045.00U",
        "quake_UP_acc.txt",
        "FA030ZUP.AT2",
    ] {
        assert_eq!(direction(name), Some(Direction::Vertical), "{name}");
    }
    for name in [
        "20190706.CJ.T001230.HNE.sac",
        "ABC0010102030405.EW",
        "RSN4228_NIIGATA_NIGH11NS.AT2",
        "ABBAR--L.AT2",
        "a_E.asc",
        "Oak_2_50_5_FN.AT2",
        "T045.00N",
        "quake_H1.txt",
        "FER-T1.AT2",
    ] {
        assert_eq!(direction(name), Some(Direction::Horizontal), "{name}");
    }
    for name in [
        "RSN6_IMPVALL.I_I-ELC180.AT2",
        "group.txt",
        "cloud.txt",
        "v2.txt",
        "quake_u.txt",
        "a-biz.txt",
        "a-20.txt",
        "ACAC8903.101",
        "CHY080E.AT2",
        "1895a.smc",
        "",
        ".",
        "ß.ü",
        "V2",
    ] {
        assert_eq!(direction(name), None, "{name}");
    }
}

#[test]
fn reference_directions_that_names_tell_together() {
    let files = NamedFile::of_all(&["CHY080E.AT2", "CHY080N.AT2", "CHY080V.AT2", "a_U.asc", "b_U.asc", "b_N.asc"]);
    let told: Vec<Option<Direction>> = files.iter().map(|file| file.direction).collect();
    let (level, upright) = (Some(Direction::Horizontal), Some(Direction::Vertical));
    assert_eq!(told, [level, level, upright, None, upright, level]);
    let azimuths: Vec<Option<u16>> = NamedFile::of_all(&["A-ELC180.AT2", "A-ELC270.AT2", "r001.txt"])
        .iter()
        .map(|file| file.azimuth)
        .collect();
    assert_eq!(azimuths, [Some(180), Some(270), None]);
}

/// Velocities and displacements became accelerations once a unit was declared for their folder.
#[test]
fn issue_quantities() {
    use Quantity::{Acceleration, Displacement, Spectrum, Velocity};
    let quantity = |name: &str| NamedFile::of(name).quantity;
    for (expected, names) in [
        (
            Acceleration,
            &[
                "a.acc",
                "RSN6_A-ELC180.AT2",
                "x_acc.txt",
                "DIS-090.AT2",
                "s.acc.bbp",
                "velocity-pulse_acc.txt",
            ][..],
        ),
        (
            Velocity,
            &[
                "a.vel",
                "A-ELC180.VT2",
                "x_vel.txt",
                "x-vel.txt",
                "s.vel.bbp",
                "HI.ARS1..HNE.D.20190728.160908.C.VEL.ASC",
                "a.velocity",
            ],
        ),
        (
            Displacement,
            &[
                "a.disp",
                "A-ELC180.DT2",
                "x_disp.txt",
                "x.d",
                "HI.ARS1..HNE.D.20190728.160908.C.DIS.ASC",
            ],
        ),
        (
            Spectrum,
            &["HI.ARS1..HNE.D.20190728.160908.C.SA.ASC", "target_spectrum.csv", "x_psa.txt"],
        ),
    ] {
        for name in names {
            assert_eq!(quantity(name), Some(expected), "{name}");
        }
    }
    for name in ["quake.txt", "Velbert.txt", "a.v", "display.csv", ""] {
        assert_eq!(quantity(name), None, "{name}");
    }
    assert_eq!(NamedFile::of("RSN6_A.AT2").rsn, Some(6));
    assert_eq!(NamedFile::of("NGA_no_1234_A.AT2").rsn, Some(1234));
    assert_eq!(NamedFile::of("RSNA.AT2").rsn, None);
    let pair = NamedFile::of_all(&["A-ELC180.AT2", "A-ELC270.AT2"]);
    assert_eq!(pair[0].stem, "A-ELC*.AT2");
}

/// Words such as SA, RESPONSE or SPECTRUM excluded good records, and `velocidad` and `kvel` counted as accelerations.
#[test]
fn issue_words_for_quantities_by_their_place() {
    use Quantity::{Acceleration, Displacement, Spectrum, Velocity};
    for (expected, names) in [
        (
            None,
            "RSN1_spectrum_matched_E.txt|RSN2_spectrum-compatible.txt|site_response_E.txt|SA_EW.txt|SD_NS.txt|SA01_H1.txt|IU.SA.00.HNE.txt|response_history_1.txt|disaggregation.txt|matched_to_spectrum.txt|spec1_E.txt|dis_record.txt|SanDiego_SD_090.txt|PSA_airport_000.txt|PSA_000.txt|Kobe_scaled_to_spectrum.txt|quake.txt|Velbert.txt|a.v|display.csv|level.csv|gravel1.txt|novel.txt|travel_E.txt|ground_level.csv|ABC_SA.csv|response.csv|Marvel.csv|Paradis.txt|PSA000.csv|DIS_090.txt|Addis_E.csv",
        ),
        (
            Some(Acceleration),
            "a.acc|RSN6_A-ELC180.AT2|x_acc.txt|DIS-090.AT2|s.acc.bbp|velocity-pulse_acc.txt|x.V2A|kacc.txt|n_aceleracion.txt",
        ),
        (
            Some(Velocity),
            "a.vel|b-vel.txt|g_velocidad.txt|kvel.txt|AAAvel1.txt|p-velocity-100.txt|vel_o.txt|t.V2V|vVEL.txt|w_vitesse.txt|y.vel (1)|y.vel.bak|z.velo|aa_Vel.csv|quakeVel.csv|VEL01.txt|HI.ARS1..HNE.D.20190728.160908.C.VEL.ASC|site_vel_E.txt|x_vel copy.txt|eq1vel.csv",
        ),
        (
            Some(Displacement),
            "b.disp|c_disp.txt|e.DT2|h_desplazamiento.txt|m.d|displ_q.txt|s_dis.txt|x_dis_E.txt|kdisp.txt|HI.ARS1..HNE.D.20190728.160908.C.DIS.ASC|dis.txt|quakeDisp2.txt|t.V2D",
        ),
        (
            Some(Spectrum),
            "HI.ARS1..HNE.D.20190728.160908.C.SA.ASC|target_spectrum.csv|x_psa.txt|PSA.csv|spectrum.csv|x.spectrum|target_spectrum (1).csv|spectra.txt",
        ),
    ] {
        for name in names.split('|') {
            assert_eq!(NamedFile::of(name).quantity, expected, "{name}");
        }
    }
}

proptest! {
    #[test]
    fn extreme_any_names(names in prop::collection::vec("[a-zA-Zß0-9_. -]{0,12}", 0..6)) {
        let files = NamedFile::of_all(&names);
        prop_assert_eq!(files.len(), names.len());
        for (one, name) in files.iter().zip(&names) {
            prop_assert!(!one.same_record(one) || one.rsn.is_some());
            prop_assert!(one.word.is_some() || one.stem == *name, "{:?}", one);
        }
    }
}

#[test]
fn reference_ends_of_file_names() {
    for (name, end) in [
        ("RSN6_IMPVALL.I_I-ELC-UP.AT2", "UP"),
        ("RSN1244_CHICHI_CHY101-V.AT2", "V"),
        ("quake_z.txt", "Z"),
        ("A-ELC-DWN.AT2", "DWN"),
        ("I-VERT.AT2", "VERT"),
        ("ABC0010102030405.UD", "UD"),
        ("ABCH010102030405.UD2", "UD2"),
        ("RSN4228_NIIGATA_NIGH11UD.AT2", "UD"),
        ("20190706.CJ.T001230.HNZ.sac", "HNZ"),
        ("RSN10590_ComalTX_IU.CCM.BHZ.00.AT2", "BHZ"),
        ("3528839_LPCC_HN_20.ver", "VER"),
    ] {
        let found = NamedFile::of(name);
        assert_eq!(found.direction, Some(Direction::Vertical), "{name}");
        assert_eq!(found.word.as_deref(), Some(end), "{name}");
    }
    for (name, end) in [
        ("20190706.CJ.T001230.HNE.sac", "HNE"),
        ("ABC0010102030405.EW", "EW"),
        ("RSN4228_NIIGATA_NIGH11NS.AT2", "NS"),
    ] {
        let found = NamedFile::of(name);
        assert_eq!(found.direction, Some(Direction::Horizontal), "{name}");
        assert_eq!(found.word.as_deref(), Some(end), "{name}");
    }
    for name in [
        "RSN6_IMPVALL.I_I-ELC180.AT2",
        "group.txt",
        "cloud.txt",
        "v2.txt",
        "quake_u.txt",
        "a-biz.txt",
        "a-20.txt",
        // A number at the end counts files as often as it is an azimuth.
        "ACAC8903.101",
        "",
        ".",
    ] {
        assert_eq!(NamedFile::of(name).direction, None, "{name}");
    }
}
