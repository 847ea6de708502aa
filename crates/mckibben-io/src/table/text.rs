//! From the bytes of a file to the text of a table: whatever program wrote it.

use super::{error::TableError, heading::plain, vocabulary::is_known, workbook};
use chardetng::{EncodingDetector, Iso2022JpDetection, Utf8Detection};
use encoding_rs::{EUC_JP, Encoding, GBK, SHIFT_JIS, UTF_8, UTF_16BE, UTF_16LE, WINDOWS_1252};
use mckibben_units::Dimension;

/// The text of a table, and what it was read from where that is not UTF-8: `GBK`, `sheet Data`. Of
/// a workbook it is the sheet of this name, else the first with numbers.
///
/// # Errors
/// [`TableError::Refused`] for a file that is no table.
pub fn read_text(
    bytes: &[u8],
    sheet: Option<&str>,
) -> Result<(String, Option<String>), TableError> {
    if WORKBOOKS
        .iter()
        .any(|beginning| bytes.starts_with(beginning))
    {
        let (text, name) = workbook::read(bytes, sheet)?;
        return Ok((text, Some(format!("sheet {name}"))));
    }
    #[cfg(feature = "parquet")]
    if bytes.starts_with(b"PAR1") {
        let text = crate::parquet::text(bytes)
            .map_err(|e| TableError::Refused(format!("{e}; save the table as CSV")))?;
        return Ok((text, Some("Parquet".into())));
    }
    if let Some((_, what)) = NO_TEXT.iter().find(|n| bytes.starts_with(n.0)) {
        return Err(TableError::Refused(format!(
            "this is not text but {what}; save the table as CSV"
        )));
    }
    let (encoding, text) = match Encoding::for_bom(bytes) {
        Some((encoding, mark)) => (encoding, &bytes[mark..]),
        None => (encoding(bytes)?, bytes),
    };
    let (text, _) = encoding.decode_without_bom_handling(text);
    Ok((
        text.into_owned(),
        (encoding != UTF_8).then(|| encoding.name().to_owned()),
    ))
}

/// Beginnings of workbooks: packed ones (.xlsx, .ods), and the old kind (.xls).
const WORKBOOKS: [&[u8]; 2] = [b"PK\x03\x04", b"\xd0\xcf\x11\xe0"];

/// Beginnings of files that are no text, and what they are.
const NO_TEXT: [(&[u8], &str); 4] = [
    (b"%PDF", "a PDF"),
    (b"PAR1", "a Parquet file"),
    (b"\x89PNG", "a picture"),
    (b"\x1f\x8b", "a packed file"),
];

/// The encoding of a text without a byte order mark.
fn encoding(bytes: &[u8]) -> Result<&'static Encoding, TableError> {
    // Letters of headings and digits are one byte and a zero.
    let zeros = |from: usize| {
        bytes
            .iter()
            .skip(from)
            .step_by(2)
            .filter(|b| **b == 0)
            .count()
    };
    let half = bytes.len() / 2;
    match (zeros(0), zeros(1)) {
        (0, odd) if odd > 0 && 10 * odd >= 8 * half => Ok(UTF_16LE),
        (even, 0) if even > 0 && 10 * even >= 8 * half => Ok(UTF_16BE),
        (0, 0) if std::str::from_utf8(bytes).is_ok() => Ok(UTF_8),
        (0, 0) => Ok(of_words(bytes)),
        _ => Err(TableError::Refused(
            "this is not text but binary data; save the table as CSV".into(),
        )),
    }
}

/// The encoding in which most words are known ones, else the likeliest: a few letters alone decide
/// little.
fn of_words(bytes: &[u8]) -> &'static Encoding {
    const HEAD: usize = 4096;
    let mut detector = EncodingDetector::new(Iso2022JpDetection::Deny);
    detector.feed(bytes, true);
    let likely = detector.guess(None, Utf8Detection::Deny);
    let is_unit = |word: &str| Dimension::all().any(|d| d.unit(word).is_some());
    let known = |encoding: &&'static Encoding| {
        let (text, _) = encoding.decode_without_bom_handling(&bytes[..bytes.len().min(HEAD)]);
        text.split(|c: char| c.is_whitespace() || "[](){}<>;,|/\"".contains(c))
            .filter(|w| !w.is_ascii() && (is_known(&plain(w)) || is_unit(w)))
            .count()
    };
    [WINDOWS_1252, GBK, SHIFT_JIS, EUC_JP]
        .into_iter()
        .chain([likely])
        .max_by_key(known)
        .unwrap_or(likely)
}

#[cfg(test)]
mod tests {
    use super::*;
    use encoding_rs::{BIG5, WINDOWS_1250, WINDOWS_1254};

    const TEXT: &str = "Druck [bar];Verkürzung;Winkel [°]\r\n1,5;2 µm;20\r\n";

    fn read(bytes: &[u8]) -> (String, Option<String>) {
        read_text(bytes, None).unwrap_or_else(|e| panic!("{e}"))
    }

    fn sixteen(order: fn(u16) -> [u8; 2]) -> Vec<u8> {
        TEXT.encode_utf16().flat_map(order).collect()
    }

    #[test]
    fn text_of_unicode_is_that_text() {
        let named = |name: Option<&str>| (TEXT.to_owned(), name.map(str::to_owned));
        assert_eq!(read(TEXT.as_bytes()), named(None));
        assert_eq!(
            read(&[b"\xef\xbb\xbf", TEXT.as_bytes()].concat()),
            named(None)
        );
        let (little, big) = (sixteen(u16::to_le_bytes), sixteen(u16::to_be_bytes));
        assert_eq!(
            read(&[&b"\xff\xfe"[..], &little].concat()),
            named(Some("UTF-16LE"))
        );
        assert_eq!(
            read(&[&b"\xfe\xff"[..], &big].concat()),
            named(Some("UTF-16BE"))
        );
        assert_eq!(read(&little), named(Some("UTF-16LE")));
        assert_eq!(read(&big), named(Some("UTF-16BE")));
    }

    /// What spreadsheets and benches write in China, Japan, Western and Central Europe and Turkey,
    /// down to a heading of one letter.
    #[test]
    fn encodings_are_recognised() {
        for (encoding, text) in [
            (GBK, "压力(kPa),收缩率(%),拉力(N)\n100,5,20\n200,10,30\n"),
            (GBK, "时间;压力 [bar];位移 [mm];力 [N]\r\n0,5;1,0;2,0;3\r\n"),
            (GBK, "力,e\n1,2\n"),
            (BIG5, "壓力(kPa),力(N)\n1,2\n"),
            (SHIFT_JIS, "圧力[kPa],収縮量[mm],張力[N]\n100,5,20\n"),
            (SHIFT_JIS, "力,ひずみ\n1,2\n"),
            (EUC_JP, "圧力[kPa],収縮量[mm],張力[N]\n100,5,20\n"),
            (WINDOWS_1252, TEXT),
            (WINDOWS_1252, "p [N/mm²];x [mm]\r\n1,5;2\r\n"),
            (WINDOWS_1252, "x [µm];Kraft [N]\n1;2\n"),
            (
                WINDOWS_1252,
                "Pressão [bar];Contração [%];Força [N]\n1;2;3\n",
            ),
            (WINDOWS_1252, "pression [bar] – déplacement [mm]\n1;2;3\n"),
            (
                WINDOWS_1250,
                "Ciśnienie [bar];Skrócenie [mm];Siła [N]\n1;2;3\n",
            ),
            (
                WINDOWS_1254,
                "Basınç [bar];Kısalma [mm];Kuvvet [N]\n1;2;3\n",
            ),
        ] {
            let (bytes, ..) = encoding.encode(text);
            assert_eq!(
                read(&bytes),
                (text.to_owned(), Some(encoding.name().to_owned()))
            );
        }
    }

    #[test]
    fn what_is_no_text_is_named() {
        let refused = |bytes: &[u8]| read_text(bytes, None).unwrap_err().to_string();
        assert!(refused(b"PK\x03\x04....").contains("the spreadsheet cannot be read"));
        assert!(refused(b"%PDF-1.7").contains("not text but a PDF"));
        assert!(refused(b"a\0\0\0b\x01").contains("binary"));
    }
}
