//! The checksum of a file, in its own metadata: the SHA-256 of all its other bytes. Parquet has
//! checksums of pages, which the library does not write, and none of the metadata.

use hmac_sha256::Hash;
use mckibben_core::hash::digits;
use std::io::{BufRead, BufReader, Read, Result, Seek, SeekFrom, Write};

/// The key of the checksum; its pair is the last of the metadata.
pub const KEY: &str = "mckibben.sha256";
/// What stands before its digits.
const MARK: &str = "mckibben:";
/// How many digits it has.
const DIGITS: usize = 64;
/// Bytes at the end of a file in which the checksum stands.
const END: u64 = 1 << 14;

/// What holds its place while the file is written.
pub fn blank() -> String {
    MARK.to_owned() + &"0".repeat(DIGITS)
}

/// Where the digits of a file's checksum stand, what they should be, and whether they are.
pub fn checksum(file: &mut (impl Read + Seek)) -> Result<Option<(u64, String, bool)>> {
    let from = file.seek(SeekFrom::End(0))?.saturating_sub(END);
    file.seek(SeekFrom::Start(from))?;
    let mut end = vec![];
    file.read_to_end(&mut end)?;
    let mut windows = end.windows(MARK.len() + DIGITS);
    let Some(at) = windows.rposition(|bytes| bytes.starts_with(MARK.as_bytes())) else {
        return Ok(None);
    };
    let (before, rest) = end.split_at(at + MARK.len());
    let (written, behind) = rest.split_at(DIGITS);
    let mut hash = Hash::new();
    file.rewind()?;
    let mut first = BufReader::new(file.take(from));
    while let bytes @ [_, ..] = first.fill_buf()? {
        hash.update(bytes);
        let read = bytes.len();
        first.consume(read);
    }
    hash.update(before);
    hash.update(behind);
    let right = digits(hash);
    let is_right = written == right.as_bytes();
    Ok(Some((from + before.len() as u64, right, is_right)))
}

/// Writes the checksum into a file that holds its place.
pub fn seal(file: &mut (impl Read + Write + Seek)) -> Result<()> {
    if let Some((at, right, _)) = checksum(file)? {
        file.seek(SeekFrom::Start(at))?;
        file.write_all(right.as_bytes())?;
    }
    Ok(())
}
