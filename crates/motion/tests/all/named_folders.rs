//! Facts from the file names of a folder together.

use pounding_motion::{Direction, NamedFile};

use crate::named_files::numbered;

/// Meaning of the names of a folder, one word each: `V` is vertical, `B` in a borehole; others have the number of their record.
fn told(names: &[&str]) -> String {
    let files = NamedFile::of_all(names);
    let is_left_out = |file: &&NamedFile| file.direction == Some(Direction::Vertical) || file.in_borehole;
    let shaking: Vec<&NamedFile> = files.iter().filter(|file| !is_left_out(file)).collect();
    let mut numbers = numbered(&shaking).into_iter();
    let word = |file: &NamedFile| match file.direction {
        Some(Direction::Vertical) => "V".to_owned(),
        _ if file.in_borehole => "B".to_owned(),
        _ => numbers.next().expect("a number for each").to_string(),
    };
    files.iter().map(word).collect::<Vec<_>>().join(" ")
}

/// Compares lines of names with their expected meanings: `a | b => 0 1`.
fn check(cases: &str) {
    for case in cases.lines().filter(|case| !case.is_empty()) {
        let (names, expected) = case.split_once(" => ").expect("names and what they tell");
        let names: Vec<&str> = names.split(" | ").collect();
        assert_eq!(told(&names), expected, "{names:?}: {:#?}", NamedFile::of_all(&names));
    }
}

/// Words at the beginning, in the middle, at the end, attached, and in pairs.
const WHEREVER: &str = "
E.csv | N.csv | Z.csv => 0 0 V
UD.csv => V
UP.csv | a.csv => V 0
V.csv => V
Vertical.csv => V
UD.NGNH35 | NS.NGNH35 | EW.NGNH35 => V 0 0
UD.NGNH35.csv => V
Z-quake.csv => V
EW_ABC.csv | NS_ABC.csv => 0 0
comp_Z_sta1.csv | comp_E_sta1.csv | comp_N_sta1.csv | comp_N_sta2.csv => V 0 0 1
comp_Z_sta1.csv => V
ABC_UD_corrected.csv | ABC_NS_corrected.csv | ABC_EW_corrected.csv => V 0 0
A_UP_filtered.csv => V
A_UP_100Hz.csv => V
ABC_HNZ_2010.csv | ABC_HNE_2010.csv | ABC_HNN_2010.csv | ABC_HNN_2011.csv => V 0 0 1
K-UP (1).csv | K_UD copy.csv | K_V(1).csv | K_UD - Copy.csv | K_UD - Copy (2).csv => V V V V V
EQ1x.csv | EQ1y.csv | EQ1z.csv | EQ2x.csv => 0 0 V 1
GM1H1.csv | GM1H2.csv | GM2H1.csv | GM2H2.csv => 0 0 1 1
quakeUP.csv | quakeVert.csv | setup.csv | BackUp.csv | group.csv => V V 0 1 2
ELC-S00E.csv | ELC-S90W.csv => 0 0
ELCS00E.csv | ELCS90W.csv => 0 0
TAF-N21E.csv | TAF-S69E.csv | ELC-S00E.csv => 0 0 1
Northridge_360deg.csv | Northridge_090deg.csv => 0 0
P_fault-normal.csv | P_fault-parallel.csv => 0 0
ABC.radial.csv | ABC.transverse.csv => 0 0
q_Comp1.csv | q_Comp2.csv | q_Comp3.csv => 0 0 0
1_comp1.csv | 1_comp2.csv | 2_comp1.csv => 0 0 1
q comp 1.csv | q comp 2.csv => 0 0
q_ch1.csv | q_ch2.csv => 0 0
Comp1.csv | Comp2.csv => 0 0
KOBE-N-S.csv | KOBE-E-W.csv | KOBE-U-D.csv => 0 0 V
KOBE_N-S.csv | KOBE_E-W.csv | KOBE_U-D.csv => 0 0 V
KOBENS.csv | KOBEEW.csv | KOBEUD.csv => 0 0 V
quakeNS.csv | quakeEW.csv | quakeUD.csv => 0 0 V
elcentrox.csv | elcentroy.csv | elcentroz.csv => 0 0 V
NS (1).csv | EW (1).csv | NS (2).csv | EW (2).csv => 0 0 1 1
K_NS.csv | K_EW (1).csv => 0 0
X1.csv | Y1.csv | X2.csv | Y2.csv => 0 0 1 1
A_T1.csv | A_L1.csv | B_L.csv | B_T.csv => 0 0 1 1
foo_E.csv | foo_N.csv | foo_U.csv => 0 0 V
foo_U.csv => 0
site_long.csv | site_tran.csv | site_vert.csv => 0 0 V
Kobe_0.csv | Kobe_90.csv => 0 0
Kobe0.csv | Kobe90.csv => 0 0
az000.csv | az090.csv => 0 0
gm_000.csv | gm_090.csv => 0 0
Kobe_1995_000.csv | Kobe_1995_090.csv => 0 0
1895a.smc | 1895b.smc | 1895c.smc => 0 0 0
1895a.txt | 1895c.txt => 0 1
2009A090.AT2 | 2009B360.AT2 => 0 0
TCU052-E.csv | TCU052-N.csv | TCU068-E.csv | TCU068-N.csv | TCU052-V.csv => 0 0 1 1 V
TCU052E.csv | TCU052N.csv | TCU052V.csv | TCU065W.csv => 0 0 V 1
ABC_East.csv | ABC_North.csv | ABC_Vertical.csv => 0 0 V
K_EW_acc.csv | K_NS_acc.csv | K_UD_acc.csv => 0 0 V
K-UP-1.csv | quake_vertical_acc.csv | quake.UP.acc.csv | ABC.V.corrected.csv | hnz_abc.csv | ABC_HNZ_acc.csv | ABC_Ver.csv | ABC_vertic.csv => V V V V V V V V
E.csv | N.csv | quake.csv => 0 0 1
ABC010.csv | ABC100.csv | ABC.csv => 0 0 1
ARL090.csv | ARL360.csv | ARL-UP.csv | ORR090.csv | ORR360.csv => 0 0 V 1 1
K_X_1.csv | K_Y_1.csv | K_X_2.csv | K_Y_2.csv => 0 0 1 1
K_V.csv | K_H.csv => V 0
K_v.csv | K_a.csv | K_d.csv => 0 1 2
20200101E.csv | 20200101N.csv => 0 0
Parkfield.FN.csv | Parkfield.FP.csv => 0 0
quakeE_1.csv | quakeN_1.csv | quakeZ_1.csv => 0 0 V
fault-normal_ABC.csv | fault-parallel_ABC.csv => 0 0
LONG_ABC.csv | TRAN_ABC.csv | VERT_ABC.csv => 0 0 V
ABC_North_corrected.csv | ABC_East_corrected.csv => 0 0
north_ABC.csv | east_ABC.csv => 0 0
017m30bt.s0a | 017m30bt.s0b => 0 0
T045.00E | T045.00N | T045.00U => 0 0 V
T045.00U => V
FA030XTE.AT2 | FA030YLN.AT2 | FA030ZUP.AT2 => 0 0 V
FAIGO-90.AT2 | FAIGO-360.AT2 => 0 0
H-E06140.AT2 | H-E06230.AT2 => 0 0
x_HN1.csv | x_HN2.csv | x_HNZ.csv => 0 0 V
K_V1.csv | K_L1.csv | K_T1.csv => V 0 0
IWTH25_NS1.csv | IWTH25_NS2.csv | IWTH25_EW1.csv | IWTH25_EW2.csv => B 0 B 0
Kobe 000.csv | Kobe 090.csv | Kobe up.csv => 0 0 V
kobe_ew_filt.csv | kobe_ns_filt.csv | kobe_ud_filt.csv => 0 0 V
acc_x.csv | acc_y.csv | acc_z.csv => 0 0 V
x_acc.csv | y_acc.csv | z_acc.csv => 0 0 V
A_E_1.csv | A_N_1.csv | A_E_2.csv | A_N_2.csv => 0 0 1 1
";

/// Vertical components shook rows, and components were separate events, unless the word was at the end of the name.
#[test]
fn issue_words_for_directions_wherever_they_stand() {
    check(WHEREVER);
}

/// Opposite compass points and azimuths.
const OPPOSITE: &str = "
IV_E.csv | IV_W.csv | IV_N.csv | IV_S.csv => 0 1 2 3
X-E.csv | X-W.csv => 0 1
X-North.csv | X-South.csv => 0 1
IV_E.csv | IV_W.csv | IV_N.csv => 0 1 2
A_000.csv | A_180.csv => 0 1
A_000.csv | A_180.csv | A_090.csv | A_270.csv => 0 1 2 3
";

/// Stations in the east and in the west of a place counted as two components of one record.
#[test]
fn issue_opposite_points_of_the_compass_are_no_pair() {
    check(OPPOSITE);
}

/// Names with the digits of a station's two sensors.
const KIKNET: &str = "
IWTH25.EW1.csv | IWTH25.NS1.csv | IWTH25.UD1.csv | IWTH25.EW2.csv | IWTH25.NS2.csv | IWTH25.UD2.csv => B B V 0 0 V
K-NS1.csv | K-EW2.csv => B 0
K-NS1.csv | K-EW1.csv | K-UD1.csv => 0 0 V
K_NS1.csv | K_EW1.csv | K_NS2.csv | K_EW2.csv | K_NS3.csv | K_EW3.csv => 0 0 1 1 2 2
IWTH25.EW1.csv => B
FKS013.EW1.csv | x.csv => 0 1
NGNH351106302345.EW1 | NGNH351106302345.NS2 => B 0
";

/// Sensors in boreholes of KiK-net shook rows as files with names such as `IWTH25.EW1.csv`.
#[test]
fn issue_boreholes_of_kiknet() {
    check(KIKNET);
}

/// Names of towns, dates, numbers of records, letters that count, versions.
const OTHERWISE: &str = "
RSN1_E_2010.csv | RSN2_N_2010.csv => 0 1
RSN1_E_2010.csv | RSN1_N_2010.csv => 0 0
Nord.csv | Upland.csv | Vernon.csv | Ost.csv | Zurich.csv | Downey.csv => 0 1 2 3 4 5
N.KMMH16.csv | N.KMMH17.csv => 0 1
N.KMMH16.E.csv | N.KMMH16.N.csv | N.KMMH16.U.csv | N.KMMH17.E.csv => 0 0 V 1
North_Hollywood.csv | West_Hollywood.csv | East_LA.csv => 0 1 2
North_ABC.csv | East_ABC.csv | Vertical_ABC.csv => 0 0 V
2010-01-01.csv | 2010-01-11.csv | 2010-04-01.csv | 2010-10-30.csv => 0 1 2 3
gm20100111.csv | gm20100201.csv => 0 1
rec010.csv | rec100.csv => 0 1
rec_10.csv | rec_100.csv => 0 1
10.csv | 100.csv => 0 1
T1.csv | T2.csv | T3.csv => 0 1 2
Newport_Beach.csv | Long_Beach.csv => 0 1
run_0.csv | run_1.csv | run_90.csv => 0 1 2
r001.csv | r091.csv => 0 1
A_1.csv | A_10.csv | A_100.csv | A_1000.csv => 0 1 2 3
GM_I.csv | GM_II.csv | GM_III.csv | GM_IV.csv | GM_V.csv | GM_X.csv => 0 1 2 3 4 5
site_A.csv | site_B.csv | site_E.csv | site_N.csv | site_Z.csv | site_V.csv => 0 1 2 3 4 5
a.csv | b.csv | e.csv | n.csv | z.csv => 0 1 2 3 4
EQ1a.csv | EQ1b.csv | EQ1x.csv | EQ1y.csv | EQ1z.csv => 0 1 2 3 4
2010UTC.csv | 20100101T000000Z.csv | 20100101T000500Z.csv => 0 1 2
quake_20100101_U.csv | other_20100101_U.csv => 0 1
scaled_up.csv | scaled_down.csv => 0 1
v2.txt | V2 => 0 1
quake_v_2.csv | quake_ver2.csv | quake_ver_3.csv => 0 1 2
ABCE.csv | ABCN.csv => 0 1
Site_V_E.csv | Site_V_N.csv | Site_IV_E.csv | Site_IV_N.csv => 0 0 1 1
LA01.csv | LA02.csv | LA03.csv => 0 1 2
cloud.csv | Saud.csv | one.csv | two.csv => 0 1 2 3
site_D_N.csv | site_D_E.csv => 0 0
K_5Hz.csv | K_kHz.csv => 0 1
N1.csv | N2.csv | N3.csv | N4.csv => 0 1 2 3
x.csv | KOBE_NS.csv | KOBE_EW.csv => 0 1 1
";

#[test]
fn limit_words_that_tell_no_direction() {
    check(OTHERWISE);
}
