//! The checksum of a file, in its own metadata: the SHA-256 of all its other bytes. The format has
//! checksums of pages, which the library does not write, and none of the metadata.

use sha2::{Digest, Sha256};
use std::io::{Read, Result, Seek, SeekFrom, Write};

/// The key of the checksum.
pub const KEY: &str = "mckibben.sha256";
/// What holds its place while the file is written.
pub const BLANK: &str = "0000000000000000000000000000000000000000000000000000000000000000";
/// Behind the key: a text of 64 bytes, in Thrift's compact protocol.
const TEXT: [u8; 2] = [0x18, 64];
/// Bytes at the end of a file that hold the last of its metadata.
const END: u64 = 1 << 14;

/// Where the digits of a file's checksum begin, and the digits.
fn digits(file: &mut (impl Read + Seek)) -> Result<Option<(u64, Vec<u8>)>> {
    let from = file.seek(SeekFrom::End(0))?.saturating_sub(END);
    file.seek(SeekFrom::Start(from))?;
    let mut end = vec![];
    file.take(END).read_to_end(&mut end)?;
    let mark = [KEY.as_bytes(), &TEXT].concat();
    let at = end.windows(mark.len()).rposition(|bytes| bytes == mark);
    let place = |at: usize| {
        let digits = end.get(at + mark.len()..)?.get(..BLANK.len())?;
        Some((from + (at + mark.len()) as u64, digits.to_vec()))
    };
    Ok(at.and_then(place))
}

/// The checksum of all bytes save the digits that begin at a place.
fn checksum(file: &mut (impl Read + Seek), digits: u64) -> Result<String> {
    let mut hash = Sha256::new();
    let mut buffer = vec![0; 1 << 16];
    let mut add = |from: u64, to: u64| {
        file.seek(SeekFrom::Start(from))?;
        let mut rest = file.by_ref().take(to - from);
        loop {
            match rest.read(&mut buffer)? {
                0 => return Ok::<_, std::io::Error>(()),
                read => hash.update(&buffer[..read]),
            }
        }
    };
    add(0, digits)?;
    add(digits + BLANK.len() as u64, u64::MAX)?;
    let digits = hash.finalize();
    Ok(digits.iter().map(|byte| format!("{byte:02x}")).collect())
}

/// Writes the checksum into a file that a [`super::Writer`] wrote.
pub fn seal(file: &mut (impl Read + Write + Seek)) -> Result<()> {
    if let Some((at, _)) = digits(file)? {
        let checksum = checksum(file, at)?;
        file.seek(SeekFrom::Start(at))?;
        file.write_all(checksum.as_bytes())?;
    }
    Ok(())
}

/// Whether a file is as it was sealed; `None` of one without a checksum.
pub fn is_whole(file: &mut (impl Read + Seek)) -> Result<Option<bool>> {
    let Some((at, digits)) = digits(file)? else {
        return Ok(None);
    };
    Ok(Some(checksum(file, at)?.as_bytes() == digits))
}
