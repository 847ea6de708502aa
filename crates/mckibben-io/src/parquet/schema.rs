//! The size of a schema, before the library builds it: groups in groups are built and dropped by
//! recursion, which a hundred thousand of them do not survive.

use super::error::TableError;
use std::io::{Read, Seek, SeekFrom};

/// Refuses the schema of something else. What does not end as a Parquet file passes: the library
/// names it.
pub fn check(file: &mut (impl Read + Seek)) -> Result<(), TableError> {
    let mut end = [0; 8];
    let at = file.seek(SeekFrom::End(-8)).unwrap_or_default();
    let _ = file.read_exact(&mut end);
    let [a, b, c, d, b'P', b'A', b'R', b'1'] = end else {
        return Ok(());
    };
    let footer = at.saturating_sub(u32::from_le_bytes([a, b, c, d]).into());
    let mut start = [0; 6];
    file.seek(SeekFrom::Start(footer))
        .and_then(|_| file.read_exact(&mut start))
        .map_err(TableError::Io)?;
    // Thrift's compact protocol: a version; the schema, a list. Its length stands
    // in the upper half, or, where that is full, behind it: seven bits a byte, the lowest first.
    match start {
        [0x15, ..0x80, 0x19, list, low, high] if list < 0xf0 || low < 0x80 || high < 2 => Ok(()),
        _ => Err(TableError::Foreign(
            "it has more than 255 columns and groups".into(),
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::super::Reader;
    use std::io::Write;

    /// A table of one column in so many groups, one in the other.
    fn nested(groups: usize) -> tempfile::NamedTempFile {
        let mut footer = vec![0x15, 2, 0x19, 0xfc];
        let mut nodes = groups + 2;
        while nodes >= 0x80 {
            footer.push(nodes as u8 | 0x80);
            nodes >>= 7;
        }
        footer.push(nodes as u8);
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
        for groups in [20, 126, 250] {
            let reader = Reader::new(nested(groups).reopen().unwrap()).unwrap();
            assert_eq!(reader.rows(), 0);
        }
        assert!(Reader::new(nested(254).reopen().unwrap()).is_err());
        let refused = Reader::new(nested(100_000).reopen().unwrap())
            .err()
            .unwrap();
        assert_eq!(
            refused.to_string(),
            "it has more than 255 columns and groups"
        );
    }
}
