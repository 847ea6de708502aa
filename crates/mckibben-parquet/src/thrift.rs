//! Just enough of Thrift's compact protocol to see, before Parquet's decoder does, what it would make room for or descend into.

/// Kinds of values that are asked for by name here.
const I32: u8 = 5;
const LIST: u8 = 9;
const STRUCT: u8 = 12;
/// As deep as Parquet's own structs go, and some more.
const DEPTH: u8 = 16;

/// Bytes that are left to be read.
struct Compact<'a>(&'a [u8]);

impl Compact<'_> {
    fn take(&mut self, count: usize) -> Option<()> {
        self.0 = self.0.get(count..)?;
        Some(())
    }

    fn byte(&mut self) -> Option<u8> {
        let (&byte, rest) = self.0.split_first()?;
        self.0 = rest;
        Some(byte)
    }

    fn varint(&mut self) -> Option<u64> {
        let mut value = 0;
        for shift in (0..64).step_by(7) {
            let byte = self.byte()?;
            value |= u64::from(byte & 0x7f) << shift;
            if byte & 0x80 == 0 {
                return Some(value);
            }
        }
        None
    }

    fn number(&mut self) -> Option<i64> {
        let zigzag = self.varint()?;
        Some((zigzag >> 1) as i64 ^ -((zigzag & 1) as i64))
    }

    /// Number and kind of the elements that follow.
    fn list(&mut self) -> Option<(u64, u8)> {
        let head = self.byte()?;
        let count = if head >> 4 == 15 { self.varint()? } else { u64::from(head >> 4) };
        Some((count, head & 15))
    }

    /// Goes through the fields of a struct; those that `field` does not read (it says so) are passed over.
    fn fields(&mut self, depth: u8, field: &mut dyn FnMut(&mut Self, i64, u8) -> Option<bool>) -> Option<()> {
        let mut id = 0_i64;
        loop {
            let head = self.byte()?;
            if head == 0 {
                return Some(());
            }
            id = if head >> 4 == 0 { self.number()? } else { id.checked_add(i64::from(head >> 4))? };
            let kind = head & 15;
            if !field(self, id, kind)? {
                self.pass(kind, depth)?;
            }
        }
    }

    fn pass(&mut self, kind: u8, depth: u8) -> Option<()> {
        let depth = depth.checked_sub(1)?;
        // True and false are the kind itself; among the elements of a list they are bytes.
        let element = |t: &mut Self, kind| if kind < 3 { t.take(1) } else { t.pass(kind, depth) };
        match kind {
            1 | 2 => Some(()),
            3 => self.take(1),
            4..=6 => self.varint().map(drop),
            7 => self.take(8),
            8 => {
                let length = self.varint()?;
                self.take(usize::try_from(length).ok()?)
            }
            LIST | 10 => {
                let (count, kind) = self.list()?;
                (0..count).try_for_each(|_| element(self, kind))
            }
            11 => match self.varint()? {
                0 => Some(()),
                count => {
                    let kinds = self.byte()?;
                    (0..count).try_for_each(|_| {
                        element(self, kinds >> 4)?;
                        element(self, kinds & 15)
                    })
                }
            },
            STRUCT => self.fields(depth, &mut |_, _, _| Some(false)),
            _ => None,
        }
    }
}

/// Uncompressed and compressed size in the header of a page, of which the first bytes are enough.
pub(crate) fn page_sizes(header: &[u8]) -> Option<(u64, u64)> {
    let (mut uncompressed, mut compressed) = (None, None);
    // It may end after the sizes.
    let _ = Compact(header).fields(DEPTH, &mut |t, id, kind| {
        match (id, kind) {
            (2, I32) => uncompressed = Some(t.number()?),
            (3, I32) => compressed = Some(t.number()?),
            _ => return Some(false),
        }
        Some(true)
    });
    Some((u64::try_from(uncompressed?).ok()?, u64::try_from(compressed?).ok()?))
}

/// Whether the schema in a file's metadata is a list of columns: a decoder descends into groups of columns as deep as they
/// go, and makes room for as many as a group says that it has.
pub(crate) fn is_flat(metadata: &[u8]) -> bool {
    let mut flat = false;
    let read = Compact(metadata).fields(DEPTH, &mut |t, id, kind| {
        if (id, kind) != (2, LIST) {
            return Some(false);
        }
        let (count, kind) = t.list()?;
        let mut groups = 0;
        for i in 0..count {
            let mut children = 0;
            (kind == STRUCT).then_some(())?;
            t.fields(DEPTH, &mut |t, id, kind| {
                let said = (id, kind) == (5, I32);
                if said {
                    children = t.number()?;
                }
                Some(said)
            })?;
            let columns = if i == 0 { i64::try_from(count - 1).ok()? } else { 0 };
            groups += u64::from(children != columns);
        }
        flat = count > 0 && groups == 0;
        Some(true)
    });
    read.is_some() && flat
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sizes_of_a_page_are_read() {
        // Kind 1, 300 bytes of 20: zigzag 0x02, 0xd8 0x04, 0x28.
        assert_eq!(page_sizes(&[0x15, 0x02, 0x15, 0xd8, 0x04, 0x15, 0x28, 0x2c]), Some((300, 20)));
        assert_eq!(page_sizes(&[0x15, 0x02, 0x15]), None);
        assert_eq!(page_sizes(&[0x15, 2, 0x15, 1, 0x15, 2]), None, "below zero");
        assert_eq!(page_sizes(&[0x15, 2, 0x15, 0xff, 0xff, 0xff]), None);
    }

    /// Version 1, and a schema: of each element the name "a" and how many it has below it.
    fn metadata(children: &[u32]) -> Vec<u8> {
        let mut out = vec![0x15, 0x02, 0x19, 0xfc];
        out.extend((children.len() as u32).to_varint());
        for &n in children {
            out.extend([0x48, 1, b'a', 0x15]);
            out.extend((2 * n).to_varint());
            out.push(0);
        }
        out.push(0);
        out
    }

    trait Varint {
        fn to_varint(self) -> Vec<u8>;
    }

    impl Varint for u32 {
        fn to_varint(mut self) -> Vec<u8> {
            let mut out = vec![];
            while self >= 0x80 {
                out.push(self as u8 | 0x80);
                self >>= 7;
            }
            out.push(self as u8);
            out
        }
    }

    #[test]
    fn a_schema_of_groups_in_groups_is_not_descended_into() {
        assert!(is_flat(&metadata(&[2, 0, 0])));
        assert!(!is_flat(&metadata(&[1, 1, 0])), "a group in a group");
        assert!(!is_flat(&metadata(&[1 << 30, 0])), "a billion columns");
        assert!(!is_flat(&metadata(&vec![1; 100_000])), "a hundred thousand groups in one another");
        assert!(!is_flat(&[]) && !is_flat(&[0]) && !is_flat(&metadata(&[2, 0, 0])[..9]));
        // A struct in a struct in a struct …
        assert!(!is_flat(&vec![0x1c; 100_000]));
    }
}
