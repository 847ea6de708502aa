//! From bytes to text: whatever program wrote the table.

use super::TableError;
use std::io::Read;

/// The largest table that is read, in bytes: about a million lines.
pub const MAX_BYTES: usize = 32 << 20;

/// Reads a table as text: UTF-8 or UTF-16 with or without a byte order mark, else Windows-1252 (of which Latin-1's printable
/// characters are a part).
///
/// # Errors
/// [`TableError::Refused`] above [`MAX_BYTES`], and for a spreadsheet or another file that is no text;
/// [`TableError::Io`].
pub fn read_text(input: impl Read) -> Result<String, TableError> {
    let mut bytes = Vec::new();
    input.take(MAX_BYTES as u64 + 1).read_to_end(&mut bytes)?;
    if bytes.len() > MAX_BYTES {
        return Err(TableError::Refused(format!(
            "the table is larger than {} MB; take fewer lines",
            MAX_BYTES >> 20
        )));
    }
    decode(bytes)
}

/// Beginnings of files that are no text, and what they are.
const NO_TEXT: [(&[u8], &str); 6] = [
    (b"PK\x03\x04", "a spreadsheet or another packed file"),
    (b"\xd0\xcf\x11\xe0", "a spreadsheet of an old kind"),
    (b"%PDF", "a PDF"),
    (b"PAR1", "a Parquet file"),
    (b"\x89PNG", "a picture"),
    (b"\x1f\x8b", "a packed file"),
];

fn decode(bytes: Vec<u8>) -> Result<String, TableError> {
    if let Some((_, what)) = NO_TEXT.iter().find(|n| bytes.starts_with(n.0)) {
        return Err(TableError::Refused(format!("this is not text but {what}; save the table as CSV")));
    }
    if let Some(rest) = bytes.strip_prefix(b"\xff\xfe") {
        return Ok(utf16(rest, u16::from_le_bytes));
    }
    if let Some(rest) = bytes.strip_prefix(b"\xfe\xff") {
        return Ok(utf16(rest, u16::from_be_bytes));
    }
    // Letters of headings and digits are one byte and a zero.
    let zeros = |from: usize| bytes.iter().skip(from).step_by(2).filter(|b| **b == 0).count();
    let half = bytes.len() / 2;
    match (zeros(0), zeros(1)) {
        (0, odd) if odd > 0 && 10 * odd >= 8 * half => return Ok(utf16(&bytes, u16::from_le_bytes)),
        (even, 0) if even > 0 && 10 * even >= 8 * half => return Ok(utf16(&bytes, u16::from_be_bytes)),
        (even, odd) if even + odd > 0 => {
            return Err(TableError::Refused(
                "this is not text but binary data; save the table as CSV".into(),
            ));
        }
        _ => {}
    }
    let text = String::from_utf8(bytes)
        .unwrap_or_else(|e| e.as_bytes().iter().map(|&b| windows_1252(b)).collect::<String>());
    Ok(text.strip_prefix('\u{feff}').unwrap_or(&text).chars().map(narrow).collect())
}

/// The letters, digits and brackets that Chinese and Japanese texts have in full width, as they are elsewhere.
fn narrow(c: char) -> char {
    match c {
        '\u{ff01}'..='\u{ff5e}' => char::from_u32(u32::from(c) - 0xfee0).unwrap_or(c),
        c => c,
    }
}

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> String {
    let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
    char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
}

/// What is at 0x80 to 0x9f in Windows-1252, where Latin-1 has control characters; a dot where there is nothing.
const MIDDLE: &str = "€·‚ƒ„…†‡ˆ‰Š‹Œ·Ž··‘’“”•–—˜™š›œ·žŸ";

fn windows_1252(byte: u8) -> char {
    match byte {
        0x80..=0x9f => MIDDLE.chars().nth(usize::from(byte - 0x80)).unwrap_or('·'),
        other => char::from(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "Druck [bar];Verkürzung;Winkel [°]\r\n1,5;2 µm;20\r\n";

    fn read(bytes: &[u8]) -> String {
        read_text(bytes).unwrap_or_else(|e| panic!("{e}"))
    }

    fn sixteen(order: fn(u16) -> [u8; 2]) -> Vec<u8> {
        TEXT.encode_utf16().flat_map(order).collect()
    }

    #[test]
    fn all_encodings_of_a_text_are_that_text() {
        assert_eq!(read(TEXT.as_bytes()), TEXT);
        assert_eq!(read(&[b"\xef\xbb\xbf", TEXT.as_bytes()].concat()), TEXT);
        let (little, big) = (sixteen(u16::to_le_bytes), sixteen(u16::to_be_bytes));
        assert_eq!(read(&[&b"\xff\xfe"[..], &little].concat()), TEXT);
        assert_eq!(read(&[&b"\xfe\xff"[..], &big].concat()), TEXT);
        assert_eq!(read(&little), TEXT);
        assert_eq!(read(&big), TEXT);
        let latin: Vec<u8> = TEXT.chars().map(|c| u8::try_from(c as u32).unwrap()).collect();
        assert_eq!(read(&latin), TEXT);
    }

    #[test]
    fn letters_of_full_width_are_those_of_half_width() {
        assert_eq!(read("压力（ｋＰａ）；１２，５％".as_bytes()), "压力(kPa);12,5%");
    }

    /// Unicode's table CP1252.TXT.
    #[test]
    fn the_middle_of_windows_1252_is_that_of_unicodes_table() {
        assert_eq!(MIDDLE.chars().count(), 32);
        assert_eq!(read(b"\x80 \x96 \x93a\x94 \x99 \x9f \xb2"), "€ – “a” ™ Ÿ ²");
    }

    #[test]
    fn what_is_no_text_or_too_long_is_named() {
        let refused = |bytes: &[u8]| read_text(bytes).unwrap_err().to_string();
        assert!(refused(b"PK\x03\x04....").contains("spreadsheet"));
        assert!(refused(b"a\0\0\0b\x01").contains("binary"));
        let long = std::io::repeat(b'1');
        assert!(read_text(long).unwrap_err().to_string().starts_with("the table is larger than"));
    }
}
