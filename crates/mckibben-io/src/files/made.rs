//! Files that a crate makes: what each is, and what is in it. Where they go is decided elsewhere.

/// A file that was made, and not yet written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct File {
    /// Its name, in the folder of all that were made with it.
    pub name: String,
    /// What it is, in a few words.
    pub about: &'static str,
    /// What is in it.
    pub content: Content,
}

impl File {
    /// A file of text.
    pub fn text(name: impl Into<String>, about: &'static str, text: String) -> Self {
        Self {
            name: name.into(),
            about,
            content: Content::Text(text),
        }
    }

    /// A file of bytes.
    pub fn bytes(name: impl Into<String>, about: &'static str, bytes: Vec<u8>) -> Self {
        Self {
            name: name.into(),
            about,
            content: Content::Bytes(bytes),
        }
    }
}

/// What is in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Content {
    /// UTF-8.
    Text(String),
    /// Anything else.
    Bytes(Vec<u8>),
}

impl Content {
    /// The bytes of the file.
    pub fn bytes(&self) -> &[u8] {
        match self {
            Self::Text(text) => text.as_bytes(),
            Self::Bytes(bytes) => bytes,
        }
    }
}
