//! What names of files tell: directions, quantities, and which files are of one record.

use pounding_motion::{Direction, NamedFile, Quantity};
use proptest::prelude::*;

/// Numbers of the records of some names, from 0 in their order.
fn records(names: &[&str]) -> Vec<usize> {
    numbered(&NamedFile::of_all(names).iter().collect::<Vec<_>>())
}

fn numbered(files: &[&NamedFile]) -> Vec<usize> {
    let mut numbers: Vec<usize> = Vec::new();
    for (index, file) in files.iter().enumerate() {
        let known = files[..index]
            .iter()
            .position(|other| other.same_record(file));
        let next = numbers.iter().max().map_or(0, |most| most + 1);
        numbers.push(known.map_or(next, |known| numbers[known]));
    }
    numbers
}

/// What the names of a folder tell, a word each: `V` is vertical, `B` in a borehole; others have the number of their record.
fn told(names: &[&str]) -> String {
    let files = NamedFile::of_all(names);
    let is_left_out =
        |file: &&NamedFile| file.direction == Some(Direction::Vertical) || file.in_borehole;
    let shaking: Vec<&NamedFile> = files.iter().filter(|file| !is_left_out(file)).collect();
    let mut numbers = numbered(&shaking).into_iter();
    let word = |file: &NamedFile| match file.direction {
        Some(Direction::Vertical) => "V".to_owned(),
        _ if file.in_borehole => "B".to_owned(),
        _ => numbers.next().expect("a number for each").to_string(),
    };
    files.iter().map(word).collect::<Vec<_>>().join(" ")
}

/// Cases: names of files = what each counts as, by line.
fn check(cases: &str) {
    for case in cases.lines() {
        let (names, expected) = case.split_once(" = ").expect("names = what they count as");
        let names: Vec<_> = names.split(", ").collect();
        let files = NamedFile::of_all(&names);
        assert_eq!(told(&names), expected, "{names:?}: {files:#?}");
    }
}

/// Words for directions at all places.
const WHEREVER: &str = "E.csv, N.csv, Z.csv = 0 0 V
UD.csv = V
UP.csv, a.csv = V 0
V.csv = V
Vertical.csv = V
UD.NGNH35, NS.NGNH35, EW.NGNH35 = V 0 0
UD.NGNH35.csv = V
Z-quake.csv = V
EW_ABC.csv, NS_ABC.csv = 0 0
comp_Z_sta1.csv, comp_E_sta1.csv, comp_N_sta1.csv, comp_N_sta2.csv = V 0 0 1
comp_Z_sta1.csv = V
ABC_UD_corrected.csv, ABC_NS_corrected.csv, ABC_EW_corrected.csv = V 0 0
A_UP_filtered.csv = V
A_UP_100Hz.csv = V
ABC_HNZ_2010.csv, ABC_HNE_2010.csv, ABC_HNN_2010.csv, ABC_HNN_2011.csv = V 0 0 1
K-UP (1).csv, K_UD copy.csv, K_V(1).csv, K_UD - Copy.csv, K_UD - Copy (2).csv = V V V V V
EQ1x.csv, EQ1y.csv, EQ1z.csv, EQ2x.csv = 0 0 V 1
GM1H1.csv, GM1H2.csv, GM2H1.csv, GM2H2.csv = 0 0 1 1
quakeUP.csv, quakeVert.csv, setup.csv, BackUp.csv, group.csv = V V 0 1 2
ELC-S00E.csv, ELC-S90W.csv = 0 0
ELCS00E.csv, ELCS90W.csv = 0 0
TAF-N21E.csv, TAF-S69E.csv, ELC-S00E.csv = 0 0 1
Northridge_360deg.csv, Northridge_090deg.csv = 0 0
P_fault-normal.csv, P_fault-parallel.csv = 0 0
ABC.radial.csv, ABC.transverse.csv = 0 0
q_Comp1.csv, q_Comp2.csv, q_Comp3.csv = 0 0 0
1_comp1.csv, 1_comp2.csv, 2_comp1.csv = 0 0 1
q comp 1.csv, q comp 2.csv = 0 0
q_ch1.csv, q_ch2.csv = 0 0
Comp1.csv, Comp2.csv = 0 0
KOBE-N-S.csv, KOBE-E-W.csv, KOBE-U-D.csv = 0 0 V
KOBE_N-S.csv, KOBE_E-W.csv, KOBE_U-D.csv = 0 0 V
KOBENS.csv, KOBEEW.csv, KOBEUD.csv = 0 0 V
quakeNS.csv, quakeEW.csv, quakeUD.csv = 0 0 V
elcentrox.csv, elcentroy.csv, elcentroz.csv = 0 0 V
NS (1).csv, EW (1).csv, NS (2).csv, EW (2).csv = 0 0 1 1
K_NS.csv, K_EW (1).csv = 0 0
X1.csv, Y1.csv, X2.csv, Y2.csv = 0 0 1 1
A_T1.csv, A_L1.csv, B_L.csv, B_T.csv = 0 0 1 1
foo_E.csv, foo_N.csv, foo_U.csv = 0 0 V
foo_U.csv = 0
site_long.csv, site_tran.csv, site_vert.csv = 0 0 V
Kobe_0.csv, Kobe_90.csv = 0 0
Kobe0.csv, Kobe90.csv = 0 0
az000.csv, az090.csv = 0 0
gm_000.csv, gm_090.csv = 0 0
Kobe_1995_000.csv, Kobe_1995_090.csv = 0 0
1895a.smc, 1895b.smc, 1895c.smc = 0 0 0
1895a.txt, 1895c.txt = 0 1
2009A090.AT2, 2009B360.AT2 = 0 0
TCU052-E.csv, TCU052-N.csv, TCU068-E.csv, TCU068-N.csv, TCU052-V.csv = 0 0 1 1 V
TCU052E.csv, TCU052N.csv, TCU052V.csv, TCU065W.csv = 0 0 V 1
ABC_East.csv, ABC_North.csv, ABC_Vertical.csv = 0 0 V
K_EW_acc.csv, K_NS_acc.csv, K_UD_acc.csv = 0 0 V
K-UP-1.csv, quake_vertical_acc.csv, quake.UP.acc.csv, ABC.V.corrected.csv, hnz_abc.csv, ABC_HNZ_acc.csv, ABC_Ver.csv, ABC_vertic.csv = V V V V V V V V
E.csv, N.csv, quake.csv = 0 0 1
ABC010.csv, ABC100.csv, ABC.csv = 0 0 1
ARL090.csv, ARL360.csv, ARL-UP.csv, ORR090.csv, ORR360.csv = 0 0 V 1 1
K_X_1.csv, K_Y_1.csv, K_X_2.csv, K_Y_2.csv = 0 0 1 1
K_V.csv, K_H.csv = V 0
K_v.csv, K_a.csv, K_d.csv = 0 1 2
20200101E.csv, 20200101N.csv = 0 0
Parkfield.FN.csv, Parkfield.FP.csv = 0 0
quakeE_1.csv, quakeN_1.csv, quakeZ_1.csv = 0 0 V
fault-normal_ABC.csv, fault-parallel_ABC.csv = 0 0
LONG_ABC.csv, TRAN_ABC.csv, VERT_ABC.csv = 0 0 V
ABC_North_corrected.csv, ABC_East_corrected.csv = 0 0
north_ABC.csv, east_ABC.csv = 0 0
017m30bt.s0a, 017m30bt.s0b = 0 0
T045.00E, T045.00N, T045.00U = 0 0 V
T045.00U = V
FA030XTE.AT2, FA030YLN.AT2, FA030ZUP.AT2 = 0 0 V
FAIGO-90.AT2, FAIGO-360.AT2 = 0 0
H-E06140.AT2, H-E06230.AT2 = 0 0
x_HN1.csv, x_HN2.csv, x_HNZ.csv = 0 0 V
K_V1.csv, K_L1.csv, K_T1.csv = V 0 0
IWTH25_NS1.csv, IWTH25_NS2.csv, IWTH25_EW1.csv, IWTH25_EW2.csv = B 0 B 0
Kobe 000.csv, Kobe 090.csv, Kobe up.csv = 0 0 V
kobe_ew_filt.csv, kobe_ns_filt.csv, kobe_ud_filt.csv = 0 0 V
acc_x.csv, acc_y.csv, acc_z.csv = 0 0 V
x_acc.csv, y_acc.csv, z_acc.csv = 0 0 V
A_E_1.csv, A_N_1.csv, A_E_2.csv, A_N_2.csv = 0 0 1 1";

/// Verticals shook rows, and components were events of their own, unless the word stood at the end of the name.
#[test]
fn issue_words_for_directions_wherever_they_stand() {
    check(WHEREVER);
}

/// Stations in the east and in the west of a place were two components of one record.
#[test]
fn issue_opposite_points_of_the_compass_are_no_pair() {
    check(
        "IV_E.csv, IV_W.csv, IV_N.csv, IV_S.csv = 0 1 2 3
X-E.csv, X-W.csv = 0 1
X-North.csv, X-South.csv = 0 1
IV_E.csv, IV_W.csv, IV_N.csv = 0 1 2
A_000.csv, A_180.csv = 0 1
A_000.csv, A_180.csv, A_090.csv, A_270.csv = 0 1 2 3",
    );
}

/// Sensors in boreholes of KiK-net shook rows as files with names such as `IWTH25.EW1.csv`.
#[test]
fn issue_boreholes_of_kiknet() {
    check(
        "IWTH25.EW1.csv, IWTH25.NS1.csv, IWTH25.UD1.csv, IWTH25.EW2.csv, IWTH25.NS2.csv, IWTH25.UD2.csv = B B V 0 0 V
K-NS1.csv, K-EW2.csv = B 0
K-NS1.csv, K-EW1.csv, K-UD1.csv = 0 0 V
K_NS1.csv, K_EW1.csv, K_NS2.csv, K_EW2.csv, K_NS3.csv, K_EW3.csv = 0 0 1 1 2 2
IWTH25.EW1.csv = B
FKS013.EW1.csv, x.csv = 0 1
NGNH351106302345.EW1, NGNH351106302345.NS2 = B 0",
    );
}

#[test]
fn limit_words_that_tell_no_direction() {
    check(
        "RSN1_E_2010.csv, RSN2_N_2010.csv = 0 1
RSN1_E_2010.csv, RSN1_N_2010.csv = 0 0
Nord.csv, Upland.csv, Vernon.csv, Ost.csv, Zurich.csv, Downey.csv = 0 1 2 3 4 5
N.KMMH16.csv, N.KMMH17.csv = 0 1
N.KMMH16.E.csv, N.KMMH16.N.csv, N.KMMH16.U.csv, N.KMMH17.E.csv = 0 0 V 1
North_Hollywood.csv, West_Hollywood.csv, East_LA.csv = 0 1 2
North_ABC.csv, East_ABC.csv, Vertical_ABC.csv = 0 0 V
2010-01-01.csv, 2010-01-11.csv, 2010-04-01.csv, 2010-10-30.csv = 0 1 2 3
gm20100111.csv, gm20100201.csv = 0 1
rec010.csv, rec100.csv = 0 1
rec_10.csv, rec_100.csv = 0 1
r001.csv, r091.csv = 0 1
A_1.csv, A_10.csv, A_100.csv, A_1000.csv = 0 1 2 3
GM_I.csv, GM_II.csv, GM_III.csv, GM_IV.csv, GM_V.csv, GM_X.csv = 0 1 2 3 4 5
site_A.csv, site_B.csv, site_E.csv, site_N.csv, site_Z.csv, site_V.csv = 0 1 2 3 4 5
a.csv, b.csv, e.csv, n.csv, z.csv = 0 1 2 3 4
EQ1a.csv, EQ1b.csv, EQ1x.csv, EQ1y.csv, EQ1z.csv = 0 1 2 3 4
2010UTC.csv, 20100101T000000Z.csv, 20100101T000500Z.csv = 0 1 2
quake_20100101_U.csv, other_20100101_U.csv = 0 1
scaled_up.csv, scaled_down.csv = 0 1
v2.txt, V2 = 0 1
quake_v_2.csv, quake_ver2.csv, quake_ver_3.csv = 0 1 2
ABCE.csv, ABCN.csv = 0 1
Site_V_E.csv, Site_V_N.csv, Site_IV_E.csv, Site_IV_N.csv = 0 0 1 1
LA01.csv, LA02.csv, LA03.csv = 0 1 2
cloud.csv, Saud.csv, one.csv, two.csv = 0 1 2 3
site_D_N.csv, site_D_E.csv = 0 0
K_5Hz.csv, K_kHz.csv = 0 1
N1.csv, N2.csv, N3.csv, N4.csv = 0 1 2 3
x.csv, KOBE_NS.csv, KOBE_EW.csv = 0 1 1",
    );
}

/// Two components counted as two events: of 30 kinds of names 16 were not known.
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
        [
            "AKBMR--n.1000hyfh.BNE.--.acc.V2c",
            "AKBMR--n.1000hyfh.BNZ.--.acc.V2c",
        ],
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
        assert_eq!(
            records(&pair),
            [0, 0],
            "{pair:?}: {:?}",
            NamedFile::of_all(&pair)
        );
    }
}

/// Numbers of records are no azimuths, and names that share their direction are of two records.
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
    let files = NamedFile::of_all(&[
        "CHY080E.AT2",
        "CHY080N.AT2",
        "CHY080V.AT2",
        "a_U.asc",
        "b_U.asc",
        "b_N.asc",
    ]);
    let told: Vec<Option<Direction>> = files.iter().map(|file| file.direction).collect();
    let (level, upright) = (Some(Direction::Horizontal), Some(Direction::Vertical));
    assert_eq!(told, [level, level, upright, None, upright, level]);
    let azimuths: Vec<Option<u16>> =
        NamedFile::of_all(&["A-ELC180.AT2", "A-ELC270.AT2", "r001.txt"])
            .iter()
            .map(|file| file.azimuth)
            .collect();
    assert_eq!(azimuths, [Some(180), Some(270), None]);
}

/// Velocities and displacements were accelerations once a unit was declared for their folder.
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
            &[
                "HI.ARS1..HNE.D.20190728.160908.C.SA.ASC",
                "target_spectrum.csv",
                "x_psa.txt",
            ],
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

/// A word such as SA, RESPONSE or SPECTRUM threw good records out, and `velocidad` and `kvel` were accelerations.
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
