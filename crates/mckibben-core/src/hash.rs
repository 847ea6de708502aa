//! SHA-256, the one hash of muscles, files and tables.

use hmac_sha256::Hash;

/// The hash of what was added, in hexadecimal digits.
pub fn digits(hash: Hash) -> String {
    hash.finalize().iter().map(|b| format!("{b:02x}")).collect()
}

/// The hash of some bytes, in hexadecimal digits.
pub fn hex(bytes: impl AsRef<[u8]>) -> String {
    let mut hash = Hash::new();
    hash.update(bytes);
    digits(hash)
}

/// The first 16 digits of the hash of a text, which tell two texts apart.
pub fn short(text: &str) -> String {
    hex(text).chars().take(16).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// FIPS 180-4, the message "abc".
    #[test]
    fn the_published_digest_of_abc() {
        let published = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(hex("abc"), published);
        assert_eq!(short("abc"), published[..16]);
    }
}
