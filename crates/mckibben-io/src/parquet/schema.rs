//! The size of a schema, before the library builds it: groups in groups are built and dropped by
//! recursion, which a hundred thousand of them do not survive.

use super::error::TableError;
use std::io::{Read, Result, Seek, SeekFrom};

/// Most columns and groups of a table.
const MOST: u64 = 1000;
/// Version, then schema: the headers of the first two fields in Thrift's compact protocol.
const VERSION: u8 = 0x15;
const LIST: u8 = 0x19;
/// Structs in a list; its length stands in the upper half, or behind it where that is full.
const STRUCT: u8 = 0xc;

/// The first bytes of the footer; `None` where the file does not end as one.
fn footer(file: &mut (impl Read + Seek)) -> Result<Option<Vec<u8>>> {
    let length = file.seek(SeekFrom::End(0))?;
    let Some(at) = length.checked_sub(8) else {
        return Ok(None);
    };
    file.seek(SeekFrom::Start(at))?;
    let mut end = [0; 8];
    file.read_exact(&mut end)?;
    let [a, b, c, d, mark @ ..] = end;
    let footer = at.checked_sub(u32::from_le_bytes([a, b, c, d]).into());
    let Some(from) = footer.filter(|_| mark == *b"PAR1") else {
        return Ok(None);
    };
    file.seek(SeekFrom::Start(from))?;
    let mut bytes = vec![];
    file.take(32).read_to_end(&mut bytes)?;
    Ok(Some(bytes))
}

/// A number of seven bits a byte.
fn number(bytes: &mut impl Iterator<Item = u8>) -> Option<u64> {
    let mut value = 0;
    for shift in (0..63).step_by(7) {
        let byte = bytes.next()?;
        value |= u64::from(byte & 0x7f) << shift;
        if byte < 0x80 {
            return Some(value);
        }
    }
    None
}

/// Columns and groups of a schema; `None` where the footer does not begin with it.
fn nodes(mut bytes: impl Iterator<Item = u8>) -> Option<u64> {
    bytes.next().filter(|byte| *byte == VERSION)?;
    number(&mut bytes)?;
    bytes.next().filter(|byte| *byte == LIST)?;
    let list = bytes.next().filter(|byte| byte & 0xf == STRUCT)?;
    match list >> 4 {
        15 => number(&mut bytes),
        length => Some(length.into()),
    }
}

/// Refuses the schema of something else. What is no Parquet file passes: the library names it.
pub fn check(file: &mut (impl Read + Seek)) -> std::result::Result<(), TableError> {
    let Some(bytes) = footer(file).map_err(TableError::Io)? else {
        return Ok(());
    };
    match nodes(bytes.into_iter()) {
        Some(0..=MOST) => Ok(()),
        Some(nodes) => Err(TableError::Foreign(format!(
            "it has {nodes} columns and groups, more than {MOST}"
        ))),
        None => Err(TableError::Foreign(
            "its metadata do not begin with a schema".into(),
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::super::Reader;
    use std::io::Write;

    /// A table of one column in so many groups, one in the other.
    fn nested(groups: usize) -> tempfile::NamedTempFile {
        let [low, middle, high] = [0, 7, 14].map(|shift| ((groups + 2) >> shift) as u8 & 0x7f);
        let mut footer = vec![0x15, 2, 0x19, 0xfc, low | 0x80, middle | 0x80, high];
        footer.extend(*b"\x48\x01m\x15\x02\x00");
        footer.extend(b"\x35\x00\x18\x01g\x15\x02\x00".repeat(groups));
        footer.extend(*b"\x15\x02\x25\x00\x18\x01x\x00\x16\x00\x19\x0c\x00");
        let length = (footer.len() as u32).to_le_bytes();
        let mut file = tempfile::NamedTempFile::new().unwrap();
        let all = [b"PAR1".as_slice(), &footer, &length, b"PAR1"].concat();
        file.write_all(&all).unwrap();
        file
    }

    /// A schema is built by recursion: its depth is at most its number of groups.
    #[test]
    fn a_hundred_thousand_groups_in_groups_are_refused() {
        let reader = Reader::new(nested(20).reopen().unwrap()).unwrap();
        assert_eq!(reader.names(), ["x"]);
        let refused = Reader::new(nested(100_000).reopen().unwrap())
            .err()
            .unwrap();
        assert_eq!(
            refused.to_string(),
            "it has 100002 columns and groups, more than 1000"
        );
    }
}
