//! How files of this crate are known: by their first bytes.

/// A text chunk of PNG: the program that wrote it (length, type, keyword and text, checksum).
#[cfg(any(feature = "png", test))]
pub(crate) const PNG_TEXT: &[u8] = b"\0\0\0\x11tEXtSoftware\0mckibben\x47\xe5\x26\x9b";
/// The program that wrote a PDF, as a string of it.
#[cfg(feature = "png")]
pub(crate) const PDF_PRODUCER: &str = "(mckibben figure)";
/// What the root of every drawing has.
const DRAWING: &str = "font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" role=\"img\" aria-label=\"";
/// What the head of every page has.
const PAGE: &str = "content=\"default-src 'none'; style-src 'unsafe-inline'";

/// Whether a file with these first bytes is a figure as this crate draws it: SVG, PNG, PDF or a page of HTML.
pub fn is_figure(head: &[u8]) -> bool {
    let text = String::from_utf8_lossy(head);
    let svg = text.starts_with("<svg ") && text.contains(DRAWING);
    let png = head.starts_with(b"\x89PNG") && head.windows(8).any(|bytes| bytes == b"mckibben");
    let pdf = text.starts_with("%PDF-") && text.contains("/Producer (mckibben figure)");
    svg || png || pdf || is_page(head)
}

/// Whether a file with these first bytes is a page as this crate writes it: a figure's or a report's.
pub fn is_page(head: &[u8]) -> bool {
    let text = String::from_utf8_lossy(head);
    text.starts_with("<!DOCTYPE html>") && text.contains(PAGE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::font::FAMILY;

    #[test]
    fn drawings_carry_their_mark_and_others_do_not() {
        assert!(DRAWING.contains(FAMILY));
        for other in [
            &b"notes of mine"[..],
            b"<svg xmlns=\"x\"></svg>",
            b"\x89PNG\r\n\x1a\n",
            b"%PDF-1.7\n<</Producer (Skia/PDF)>>",
            b"<!DOCTYPE html>\n<p>mine",
        ] {
            assert!(!is_figure(other) && !is_page(other));
        }
    }

    /// The checksum of a chunk (CRC-32 of type and data) as the standard defines it, bit by bit.
    #[test]
    fn the_chunk_is_as_long_as_it_says_and_has_its_checksum() {
        let (data, sum) = PNG_TEXT[4..].split_at(PNG_TEXT.len() - 8);
        assert_eq!(PNG_TEXT[..4], (data.len() as u32 - 4).to_be_bytes());
        let crc = data.iter().fold(!0_u32, |crc, byte| {
            let shift = |c: u32, _| if c & 1 == 1 { 0xedb8_8320 ^ (c >> 1) } else { c >> 1 };
            (0..8).fold(crc ^ u32::from(*byte), shift)
        });
        assert_eq!(sum, (!crc).to_be_bytes());
    }
}
