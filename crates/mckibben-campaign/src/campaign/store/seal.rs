//! The checksum of a file, in its own metadata: the SHA-256 of all its other bytes. Parquet has
//! checksums of pages, which the library does not write, and none of the metadata.

use crate::hash::Running;
use std::io::{Read, Result, Seek, SeekFrom, Write};

/// The key of the checksum; its pair is the last of the metadata.
pub const KEY: &str = "mckibben.sha256";
/// What holds its place while the file is written.
pub const BLANK: &str = "0000000000000000000000000000000000000000000000000000000000000000";
/// Behind the key: a text of 64 bytes, in Thrift's compact protocol.
const TEXT: [u8; 2] = [0x18, 64];
/// Bytes at the end of a file in which the checksum stands.
const END: u64 = 1 << 14;

/// Where the checksum of a file stands, what stands there, and what should.
fn checksum(file: &mut (impl Read + Seek)) -> Result<Option<(u64, Vec<u8>, String)>> {
    let from = file.seek(SeekFrom::End(0))?.saturating_sub(END);
    file.seek(SeekFrom::Start(from))?;
    let mut end = vec![];
    file.read_to_end(&mut end)?;
    let mark = [KEY.as_bytes(), &TEXT].concat();
    let found = end.windows(mark.len()).rposition(|bytes| bytes == mark);
    let Some((before, rest)) = found.and_then(|at| end.split_at_checked(at + mark.len())) else {
        return Ok(None);
    };
    let Some((digits, behind)) = rest.split_at_checked(BLANK.len()) else {
        return Ok(None);
    };
    let mut hash = Running::default();
    file.rewind()?;
    std::io::copy(&mut file.take(from), &mut hash)?;
    hash.write_all(before)?;
    hash.write_all(behind)?;
    let at = from + before.len() as u64;
    Ok(Some((at, digits.to_vec(), hash.digits())))
}

/// Writes the checksum into a file that holds its place.
pub fn seal(file: &mut (impl Read + Write + Seek)) -> Result<()> {
    if let Some((at, _, right)) = checksum(file)? {
        file.seek(SeekFrom::Start(at))?;
        file.write_all(right.as_bytes())?;
    }
    Ok(())
}

/// Whether a file is as it was sealed; `None` of one without a checksum.
pub fn is_whole(file: &mut (impl Read + Seek)) -> Result<Option<bool>> {
    let found = checksum(file)?;
    Ok(found.map(|(_, digits, right)| right.as_bytes() == digits))
}
