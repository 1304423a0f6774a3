//! Damaged numbers and files of other kinds: the message names the text found, its place and the remedy.

use insta::assert_snapshot;
use pounding_motion::{Format, read, recognised};

/// An AT2 file of nine values in which the fourth, at the start of a line, is replaced.
fn at2(damaged: &str) -> String {
    format!(
        "PEER STRONG MOTION\nSOMEWHERE\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 9, DT= .0100 SEC\n\
         .1 .2 .3\n{damaged} .5 .6\n.7 .8 .9\n"
    )
}

fn refusal(bytes: &[u8]) -> String {
    read(bytes).expect_err("a file that is refused").to_string()
}

/// A damaged number at the start of a line ended the values, and the message blamed the header.
#[test]
fn issue_damaged_numbers_of_an_at2_file_are_named() {
    let refused = |damaged: &str| refusal(at2(damaged).as_bytes());
    assert_snapshot!(refused("********"), @r#"line 6, field 1: "********" is not a number; a program writes asterisks for a number that did not fit: fetch the file again, or print it with wider columns"#);
    assert_snapshot!(refused("NaN"), @r#"line 6, field 1: "NaN" is not finite, and every number must be; put a measured value there or cut the record before it"#);
    assert_snapshot!(refused("0,4"), @r#"line 6, field 1: "0,4" is not a number; write a decimal point for the comma, as in -0.00640"#);
    assert_snapshot!(refused(",4"), @r#"line 6, field 1: ",4" is not a number; write a decimal point for the comma, as in -0.00640"#);
    assert_snapshot!(refused("N/A"), @r#"line 6, field 1: "N/A" is not a number; write it like -0.00640 or -.6403182E-02"#);
    assert_snapshot!(refused("#VALUE!"), @r##"line 6, field 1: "#VALUE!" is not a number; write it like -0.00640 or -.6403182E-02"##);
    assert_snapshot!(refused(".4 ****"), @r#"line 6, field 2: "****" is not a number; a program writes asterisks for a number that did not fit: fetch the file again, or print it with wider columns"#);
    assert_snapshot!(refused(".4e"), @r#"line 6, field 1: ".4e" is not a number; write it like -0.00640 or -.6403182E-02"#);
    // A text that is not a number is quoted, and the header may be wrong.
    assert_snapshot!(refused("see overleaf"), @r#"the values end at line 5 after 3 of them (line 6 reads "see overleaf .5 .6"), but the header declares 9; fetch the file again, or correct the header if the values are complete"#);
    let short = at2(".4").replace(".7 .8 .9\n", "");
    assert_snapshot!(refusal(short.as_bytes()), @"the values end at line 6 after 6 of them, but the header declares 9; fetch the file again, or correct the header if the values are complete");
}

/// A file of the readers with one number replaced.
fn damaged(name: &str, number: &str, by: &str) -> String {
    let path = format!("{}/tests/files/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("the file is there");
    assert!(text.contains(number), "{name} holds {number}");
    text.replacen(number, by, 1)
}

/// In formats that are cut by columns a comma ended the numbers.
#[test]
fn issue_damaged_numbers_of_other_formats_are_named() {
    let refused = |name: &str, number: &str, by: &str| refusal(damaged(name, number, by).as_bytes());
    assert_snapshot!(refused("esm.asc", "-3.634899", "0,25"), @r#"line 16, field 1: "0,25" is not a number; write a decimal point for the comma, as in -0.00640"#);
    assert_snapshot!(refused("esm.asc", "-3.634899", "*****"), @r#"line 16, field 1: "*****" is not a number; a program writes asterisks for a number that did not fit: fetch the file again, or print it with wider columns"#);
    assert_snapshot!(refused("esm.asc", "-3.634899", "NULL"), @r#"line 16, field 1: "NULL" is not a number; write it like -0.00640 or -.6403182E-02"#);
    assert_snapshot!(refused("usgs.smc", "-4.1299E+1", "-4,1299E+1"), @r#"line 31, field 1: "-4,1299E+1" is not a number; write a decimal point for the comma, as in -0.00640"#);
    assert_snapshot!(refused("usgs.smc", "-4.6694E+0", "**********"), @r#"line 31, field 3: "**********" is not a number; a program writes asterisks for a number that did not fit: fetch the file again, or print it with wider columns"#);
}

#[test]
fn issue_files_of_other_kinds_are_named() {
    let refused = |bytes: &[u8]| read(bytes).expect_err("no record").to_string();
    assert_snapshot!(refused(b"\x1f\x8b\x08\x00\x01\x02"), @"the file is packed by gzip, allowed is a record as text, SAC or miniSEED; unpack it first (`gunzip FILE.gz`)");
    assert_snapshot!(refused(b"PK\x03\x04abc"), @"the file is a ZIP archive, or a sheet of a program such as Excel, allowed is a record as text, SAC or miniSEED; unpack it and give a file in it, or save the sheet as CSV");
    assert_snapshot!(refused(b"\n<!DOCTYPE HTML>\n<html>1.0\n2.0\n"), @"the file is a web page, allowed is a record as text, SAC or miniSEED; fetch the record again; a site that wants a log-in sends such pages instead");
    assert_snapshot!(refused(b"\x7fELF\x02\x01\x01\x00"), @"the file is binary (byte 5 is 0x02) and neither SAC nor miniSEED, the binary formats that are read; fetch the record as text or in one of them");
    let text = at2(".4");
    let pairs = |order: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(order).collect::<Vec<u8>>();
    let little = pairs(u16::to_le_bytes);
    let said = refused(&little);
    assert_snapshot!(said, @r#"the file is text in UTF-16, allowed is a record as text, SAC or miniSEED; save it again as UTF-8 (an editor's "Save as", or `iconv -f UTF-16 -t UTF-8`)"#);
    assert_eq!(refused(&pairs(u16::to_be_bytes)), said);
    assert_eq!(refused(&[b"\xff\xfe", &little[..]].concat()), said);
}

#[test]
fn reference_formats_are_recognised_by_their_content() {
    assert_eq!(recognised(at2("****").as_bytes()), Some(Format::PeerAt2));
    assert_eq!(recognised(b"0.1\n0.2\n"), Some(Format::Plain));
    assert_eq!(recognised(b"name = \"two buildings\"\n[record]\n"), None);
    assert_eq!(recognised(b""), None);
}
